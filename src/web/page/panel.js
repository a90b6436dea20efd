// A panel over the map, such as the sheet of what is chosen. Whatever comes from a map is set as text, never as markup.

function element(name, properties = {}, ...children) {
  const made = Object.assign(document.createElement(name), properties);
  made.append(...children);
  return made;
}

// Letters of a cell from which it may be broken between words; numbers and keys of lanes stay whole.
const LONG = 28;

class Panel {
  // `go` is called with a link that is followed.
  constructor(root, go, close) {
    Object.assign(this, { root, go, close });
  }

  open(title, ...parts) {
    const close = element("button", { className: "close", textContent: "×", title: "Close (Esc)", onclick: () => this.close() });
    this.root.replaceChildren(element("h1", { textContent: title }), close, ...parts);
    this.root.hidden = false;
  }

  hide() {
    this.root.replaceChildren();
    this.root.hidden = true;
  }

  words({ text, link }) {
    if (!link) return document.createTextNode(text);
    return element("a", { textContent: text, href: `#${link.kind}=${link.row}`, onclick: event => { event.preventDefault(); this.go(link); } });
  }

  // Everything known of a thing; `also` are other things at the same place.
  sheet(sheet, also, name) {
    const list = element("dl");
    for (const fact of sheet.facts) {
      const values = fact.values.map(value => element("div", {}, this.words(value)));
      const shown = element("dd", {}, ...values.slice(0, 12));
      if (values.length > 12) {
        shown.append(element("details", {}, element("summary", { textContent: `${values.length - 12} more` }), ...values.slice(12)));
      }
      list.append(element("dt", { textContent: fact.name }), shown);
    }
    const others = also.filter(link => link.kind !== sheet.about.kind || link.row !== sheet.about.row);
    const buttons = others.slice(0, 8).map(link => element("button", { textContent: name(link), onclick: () => this.go(link) }));
    const tools = element("div", { className: "tools" },
      element("button", { textContent: "Show", title: "Show the whole of it", onclick: () => this.go(sheet.about, true) }),
      element("button", { textContent: "Copy name", onclick: () => navigator.clipboard?.writeText(sheet.title.replace(/^\S+ /, "")) }));
    const here = buttons.length ? [element("div", { className: "also" }, element("span", { className: "soft", textContent: "also here" }), ...buttons)] : [];
    this.open(sheet.title, tools, ...here, element("div", { className: "body" }, list));
  }

  table(heads, rows) {
    const head = element("tr", {}, ...heads.map(text => element("th", { textContent: text })));
    const body = rows.map(row => element("tr", {}, ...row.map(cell => {
      const isLong = typeof cell === "string" && cell.length > LONG;
      const of = element("td", { className: typeof cell === "number" ? "number" : isLong ? "words" : "" });
      of.append(typeof cell === "number" ? cell.toFixed(1) : typeof cell === "string" ? cell : this.words(cell));
      return of;
    })));
    return element("table", {}, element("thead", {}, head), element("tbody", {}, ...body));
  }

  way(way) {
    const span = time => time >= 90 ? `${(time / 60).toFixed(1)} min` : `${time.toFixed(1)} s`;
    const time = span(way.time);
    const assumed = way.assumed_time > 0 ? `, ${span(way.assumed_time)} of it at assumed speeds where none is recorded` : "";
    const changes = `${way.lane_changes} ${way.lane_changes === 1 ? "change" : "changes"} of lane`;
    const steps = this.table(["lane", "entered", "s from [m]", "to [m]"], way.steps.map(step => [step.lane, step.enter, ...step.s]));
    const meets = this.table(["from [m]", "to [m]", "meets", "who waits", "why"],
      way.conflicts.map(one => [...one.along, one.other, one.yields, one.reason]));
    const told = way.today.length ? [this.table(["from [m]", "to [m]", "today"], way.today.map(one => [...one.along, one.entry]))] : [];
    const title = (text, count) => element("p", { className: "soft", textContent: `${text} (${count})` });
    this.open(`Route ${way.length.toFixed(1)} m, ${time}`, element("div", { className: "body" },
      element("p", { textContent: `Shortest time of a passenger car at recorded speed limits and those of today${assumed}; ${changes}.` }),
      ...told, title("Lanes", way.steps.length), steps, title("Lanes that it meets", way.conflicts.length), meets));
  }

  help(lines) {
    const list = element("dl");
    for (const [key, text] of lines) list.append(element("dt", { textContent: key }), element("dd", { textContent: text }));
    this.open("Keys", element("div", { className: "body" }, list));
  }
}
