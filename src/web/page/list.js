// The list of what was found in the file: a pane of its own, so that it stays while the sheet shows one thing after the other.

// Rows that are listed at a time.
const PAGE = 200;
const SEVERITIES = [["error", "Errors"], ["warning", "Warnings"], ["info", "Information"]];

class List extends Panel {
  // Shows parts that are left out, as many as there are in all, and the file's findings, null where they are not known.
  show(parts, leftOut, found) {
    const findings = found?.findings ?? [], of = severity => findings.filter(one => one.severity === severity);
    const all = findings.length + (found?.not_kept ?? 0);
    const views = [["left out", `Left out (${leftOut})`, parts], ...SEVERITIES.map(([name, title]) => [name, `${title} (${of(name).length})`, of(name)]), ["all", `All findings (${all})`, findings]];
    this.views = views.filter(([, , rows]) => rows.length);
    const choice = element("select", { ariaLabel: "Which" }, ...this.views.map(([value, textContent]) => element("option", { value, textContent })));
    const words = element("input", { type: "search", placeholder: "words, rules, places", ariaLabel: "Only rows with these words" });
    const form = element("form", { onsubmit: event => event.preventDefault() }, choice, words);
    choice.onchange = words.oninput = () => this.fill(choice.value, words.value);
    this.notes = { "left out": leftOut > parts.length ? `The first ${parts.length} of ${leftOut}.` : "These parts of the file have errors and are not in the map." };
    const more = found?.not_kept ? `${found.not_kept} more were found than were kept.` : "";
    for (const name of ["all", ...SEVERITIES.map(([severity]) => severity)]) this.notes[name] = more;
    if (!found) this.notes["left out"] += " Other findings are known only of an OpenDRIVE file.";
    this.body = element("div", { className: "body" });
    this.open([leftOut && `Left out: ${leftOut}`, all && `Findings: ${all}`].filter(Boolean).join(", "), form, this.body);
    this.fill(choice.value, "");
  }

  // Lists the rows of one view that contain some words, the first of them at once.
  fill(view, words) {
    const [, , all] = this.views.find(([name]) => name === view), wanted = words.toLowerCase().split(/\s+/).filter(Boolean);
    const text = one => [this.about(one).text, one.path, one.severity, one.rule, one.message, one.hint].join(" ").toLowerCase();
    const rows = wanted.length ? all.filter(one => { const own = text(one); return wanted.every(word => own.includes(word)); }) : all;
    const heads = ["part", ...(view === "left out" ? [] : ["severity"]), "rule", "why", "line:column"];
    const table = this.table(heads, []), [body] = table.tBodies;
    const note = element("p", { className: "soft", textContent: [this.notes[view], wanted.length ? `${rows.length} rows have these words.` : ""].join(" ").trim() });
    const more = element("button", { onclick: () => add() });
    this.rows = [];
    const add = () => {
      const next = rows.slice(this.rows.length, this.rows.length + PAGE);
      const cells = one => [this.about(one), ...(view === "left out" ? [] : [one.severity]), one.rule, one.hint ? `${one.message}. Hint: ${one.hint}` : one.message, `${one.file ? `${one.file}:` : ""}${one.line}:${one.column}`];
      const made = [...this.table(heads, next.map(cells)).tBodies[0].rows];
      made.forEach((row, i) => {
        row.title = next[i].path ?? "";
        this.rows.push([this.about(next[i]).link, row]);
      });
      body.append(...made);
      more.hidden = this.rows.length === rows.length;
      more.textContent = `${rows.length - this.rows.length} more`;
      this.mark(this.marked);
    };
    this.body.replaceChildren(note, table, more);
    add();
  }

  // What a row is about; of a finding about nothing that the map has, its place in the file.
  about(one) { return one.name ?? one.about ?? { text: one.path }; }

  // Marks the rows of what the sheet shows.
  mark(link) {
    this.marked = link;
    for (const [one, row] of this.rows ?? []) row.ariaCurrent = one && one.kind === link?.kind && one.row === link.row ? "true" : null;
  }

  hide() {
    super.hide();
    this.rows = [];
  }
}
