// Puts everything together: opens the map, loads the layers, and follows what the user does.

const $ = id => document.getElementById(id);

// Layers that can be shown and hidden: name, title, whether it is shown at first.
const SHOWN = [
  ["lanes", "Lanes by type", true], ["marks", "Road marks", true], ["borders", "Lane borders", true],
  ["directions", "Directions of travel", true], ["stop lines", "Stop lines", true], ["crosswalks", "Crosswalks", true],
  ["signals", "Signals", true], ["objects", "Objects", true], ["left out", "Left out", true],
  ["today", "Overlay: today's road", true],
  ["reference lines", "Reference lines", false], ["conflicts", "Conflicts", false], ["index boxes", "Index boxes", false],
];
const KEYS = [
  ["drag", "move"], ["wheel, + −", "zoom"], ["Shift drag, , .", "turn; n turns x to the right again"], ["arrows", "move"],
  ["click, Enter", "what is there, at the pointer or the middle"], ["/", "search"], ["r", "route between two clicks"],
  ["m", "measure"], ["l", "layers"], ["h", "colour lanes by height"], ["f", "findings, what is left out"], ["0", "whole map"], ["d", "dark or light"], ["Esc", "close"],
];

// How often it is looked at whether what is laid over the map begins or ends [ms].
const MOMENT = 10000;

class Viewer {
  // `live` is where the maps of a served page come from.
  constructor(queries, live) {
    this.live = live;
    this.camera = new Camera($("map"), () => this.changed());
    this.painter = new Painter($("map"), () => { this.upload(); this.changed(); });
    this.labels = new Labels($("labels"));
    this.panel = new Panel($("panel"), (link, isWhole) => this.choose(link, { isWhole, isFollowed: true }), () => this.clear());
    this.list = new List($("list"), link => this.choose(link, { isFollowed: true }), () => this.closeList());
    this.shown = new Set(SHOWN.filter(([, , isShown]) => isShown).map(([name]) => name));
    this.isByHeight = false;
    this.mode = "look";
    this.dark = matchMedia("(prefers-color-scheme: dark)").matches;
    this.open(queries);
    this.listen();
    this.camera.resize();
    this.setTheme();
    if (!this.readAddress()) this.fit();
    setInterval(() => { if (this.queries.isOver) this.today(); }, MOMENT);
  }

  // Takes a map.
  open(queries) {
    const { map } = queries;
    Object.assign(this, { queries, map });
    queries.setMoment(Date.now() / 1000);
    this.camera.farthest = 50 / Math.max(map.bounds[1][0] - map.bounds[0][0], map.bounds[1][1] - map.bounds[0][1], 1);
    this.upload();
    const count = (number, one, many) => `${number.toLocaleString("en")} ${number === 1 ? one : many}`;
    const name = map.name || (this.live ? this.live.names[this.live.number] : document.title);
    $("about").textContent = [name, map.generation ? `generation ${map.generation}` : "", count(map.lanes, "lane", "lanes"), count(map.signals, "signal", "signals"), count(map.objects, "object", "objects"),
      `${(map.road_length / 1000).toFixed(1)} km of roads`].filter(Boolean).join(" · ");
    const found = this.found();
    $("show-list").hidden = !map.left_out && !found;
    $("show-list").classList.toggle("bad", map.left_out > 0);
    $("show-list").textContent = [map.left_out && `${map.left_out} left out`, found && count(found, "finding", "findings")].filter(Boolean).join(", ");
    this.clear();
    if (!$("list").hidden) this.showList();
    this.legend();
  }

  // Hands all layers to the painter.
  upload() {
    LAYERS.forEach((name, number) => {
      const drawing = this.queries.draw(number);
      if (name === "lanes") this.painter.setLowest(drawing.corners);
      this.painter.set(name, drawing);
    });
  }

  // Draws what is laid over the map at this moment, after it has changed or time has passed.
  today() {
    this.queries.setMoment(Date.now() / 1000);
    this.painter.set("today", this.queries.draw(LAYERS.indexOf("today")));
    if (this.chosen) this.choose(this.chosen);
    this.changed();
  }

  // Shows another generation of the same map: the view stays where it is.
  swap(queries) {
    const at = this.far([this.camera.x, this.camera.y]);
    this.open(queries);
    [this.camera.x, this.camera.y] = this.near(...at);
    this.changed();
  }

  // From the map's coordinates to those of drawings and back.
  near(x, y) { return [x - this.map.middle[0], y - this.map.middle[1]]; }
  far([x, y]) { return [x + this.map.middle[0], y + this.map.middle[1]]; }

  fit() {
    const [low, high] = this.map.bounds;
    this.show([...this.near(low[0], low[1]), ...this.near(high[0], high[1])]);
  }

  // What panels and buttons cover at the left, top, right and bottom [px].
  covered() {
    const isNarrow = innerWidth <= 720, isOpen = !$("panel").hidden, list = $("list").offsetHeight;
    if (isNarrow) return [0, 92, 0, isOpen || list ? innerHeight * 0.48 : 44];
    return [isOpen ? 385 : 0, 50, $("layers").hidden ? 0 : 226, 44 + list];
  }

  // Fits a box into what is free.
  show(box, closest) {
    this.camera.fit(box, this.covered(), closest);
  }

  // Whether all of a box is in what is free.
  isSeen([x0, y0, x1, y1]) {
    const [left, top, right, bottom] = this.covered();
    const corners = [[x0, y0], [x1, y0], [x1, y1], [x0, y1]].map(corner => this.camera.toPage(...corner));
    return corners.every(([x, y]) => x >= left && y >= top && x <= this.camera.width - right && y <= this.camera.height - bottom);
  }

  changed() {
    // Also while a picture is drawn over several frames: the address is that of the last change.
    clearTimeout(this.writing);
    this.writing = setTimeout(() => this.writeAddress(), 300);
    this.asked ||= requestAnimationFrame(() => this.frame());
  }

  // Draws as far as a frame has time, and goes on in the next one.
  frame() {
    this.asked = 0;
    if (this.paint(false)) this.asked = requestAnimationFrame(() => this.frame());
  }

  // Draws all of it, or as far as a frame has time: whether there is more to draw.
  paint(all = true) {
    const [low, high] = this.map.bounds, span = high[2] - low[2];
    const heights = this.isByHeight ? [low[2] - this.map.middle[2], 1 / Math.max(span, 1e-3)] : [0, 0];
    const isMore = this.painter.paint(this.camera, this.shown, heights, all);
    this.labels.paint(this.camera, this.dark ? "#f2f5f7" : "#15191d", this.dark ? "#14181bcc" : "#ffffffdd");
    return isMore;
  }

  setTheme() {
    document.documentElement.dataset.theme = this.dark ? "dark" : "light";
    const back = getComputedStyle(document.documentElement).getPropertyValue("--back").trim();
    this.painter.setColors(this.map.paints, this.dark, [1, 3, 5].map(at => parseInt(back.slice(at, at + 2), 16) / 255));
    this.legend();
    this.changed();
  }

  legend() {
    const swatch = name => {
      const made = element("span", { className: "swatch" });
      const [r, g, b] = rgba(name, this.dark).map(value => Math.round(value * 255));
      made.style.background = `rgb(${r},${g},${b})`;
      return made;
    };
    const toggle = (title, isOn, change) => {
      const box = element("input", { type: "checkbox", checked: isOn, onchange: () => { change(box.checked); this.changed(); } });
      return element("label", {}, box, title);
    };
    const layers = SHOWN.map(([name, title]) => toggle(title, this.shown.has(name), isOn => this.shown[isOn ? "add" : "delete"](name)));
    $("layers").replaceChildren(
      element("h2", { textContent: "Layers" }), ...layers, toggle("Lanes by height", this.isByHeight, isOn => { this.isByHeight = isOn; }),
      element("h2", { textContent: "Lane types" }), ...LEGEND.map(name => element("label", {}, swatch(name), name)),
      element("h2", { textContent: "Overlay" }), ...TODAY.map(([name, title]) => element("label", {}, swatch(name), title)),
      element("h2", { textContent: "Chosen lane" }),
      ...[["chosen", "the lane"], ["next", "leads to"], ["before", "comes from"], ["other", "gives way to"]].map(([name, title]) => element("label", {}, swatch(name), title)));
  }

  name(link) {
    return this.queries.sheet(link)?.title ?? link.kind;
  }

  // Opens a thing's sheet. One that is followed is brought into view, one that is to be seen as a whole is fitted.
  choose(link, { also = [], isFollowed = false, isWhole = false } = {}) {
    const sheet = this.queries.sheet(link);
    if (!sheet) return;
    this.painter.setOverlay(this.queries.drawing());
    const named = also.slice(0, 9).map(other => [other, this.name(other)]);
    this.panel.sheet(sheet, also, other => named.find(([one]) => one === other)[1]);
    this.chosen = link;
    this.list.mark(link);
    const [x0, y0, x1, y1] = sheet.bounds ?? [];
    const isPoint = sheet.bounds && x0 === x1 && y0 === y1;
    this.labels.mark = isPoint ? this.near(x0, y0) : null;
    if (sheet.bounds && (isFollowed || isWhole)) {
      const box = [...this.near(x0, y0), ...this.near(x1, y1)];
      const room = isPoint ? 25 : 10;
      if (isWhole || !this.isSeen(box)) this.show([box[0] - room, box[1] - room, box[2] + room, box[3] + room], 20);
    }
    this.changed();
  }

  clear() {
    this.painter.setOverlay(null);
    Object.assign(this.labels, { mark: null, ends: [], measure: [] });
    this.chosen = null;
    this.panel.hide();
    this.list.mark(null);
    $("layers").hidden ||= innerWidth <= 720;
    this.changed();
  }

  click(px, py, pointer) {
    // A finger does not hover.
    this.hover(px, py);
    const place = this.camera.toGround(px, py);
    if (this.mode === "measure") {
      this.labels.measure.push(place);
      return this.changed();
    }
    if (this.mode === "route") return this.routeTo(place);
    const radius = (pointer === "touch" ? 16 : 7) / this.camera.scale;
    const found = this.queries.pick(...this.far(place), Math.min(radius, 50));
    const visible = { signal: "signals", quarantine: "left out" };
    const links = found.filter(link => !visible[link.kind] || this.shown.has(visible[link.kind]));
    if (links.length) this.choose(links[0], { also: links });
    else this.clear();
  }

  routeTo(place) {
    const ends = this.labels.ends.length === 1 ? [this.labels.ends[0], place] : [place];
    this.clear();
    this.labels.ends = ends;
    if (ends.length < 2) return this.note("Now click the destination.");
    const way = this.queries.way(this.far(ends[0]), this.far(ends[1]));
    if (way.error) return this.note(`No route: ${way.error}.`);
    this.note("");
    this.painter.setOverlay(this.queries.drawing());
    this.panel.way(way);
    this.changed();
  }

  setMode(mode) {
    this.mode = this.mode === mode ? "look" : mode;
    this.clear();
    for (const name of ["route", "measure"]) $(name).setAttribute("aria-pressed", this.mode === name);
    this.note({ route: "Click where the route begins.", measure: "Click from place to place." }[this.mode] ?? "");
  }

  note(text) {
    Object.assign($("message"), { textContent: text, className: "note" });
    clearTimeout(this.noting);
    if (text) this.noting = setTimeout(() => { $("message").textContent = ""; }, 6000);
    this.changed();
  }

  hover(px, py) {
    const [x, y] = this.far(this.camera.toGround(px, py));
    const { lane, geodetic } = this.queries.place(x, y), parts = [`x ${x.toFixed(2)}`, `y ${y.toFixed(2)}`];
    if (lane) parts.push(`z ${lane.z.toFixed(2)}`, `${lane.distance ? "beside lane" : "lane"} ${lane.key} (${lane.kind})`, `s ${lane.s.toFixed(2)}`, `t ${lane.t.toFixed(2)}`);
    if (geodetic) parts.push(`lat ${geodetic[0].toFixed(7)}°`, `lon ${geodetic[1].toFixed(7)}°`);
    $("here").textContent = parts.join("   ");
  }

  toggleLayers() {
    $("layers").hidden = !$("layers").hidden;
    $("show-layers").setAttribute("aria-pressed", !$("layers").hidden);
  }

  key(event) {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const middle = [this.camera.width / 2, this.camera.height / 2];
    const keys = {
      "/": () => $("text").focus(), "0": () => this.fit(), r: () => this.setMode("route"), m: () => this.setMode("measure"),
      l: () => this.toggleLayers(), f: () => this.toggleList(), d: () => { this.dark = !this.dark; this.setTheme(); },
      h: () => { this.isByHeight = !this.isByHeight; this.legend(); this.changed(); }, "?": () => this.panel.help(KEYS),
      Escape: () => this.close(), Enter: () => this.click(...middle),
    };
    if (event.target.tagName === "INPUT" && event.key !== "Escape") return;
    if (["BUTTON", "A", "SUMMARY"].includes(event.target.tagName) && event.key === "Enter") return;
    if (keys[event.key]) keys[event.key]();
    else if (!this.camera.key(event.key)) return;
    event.preventDefault();
  }

  // Shows the list, or closes it where it is shown; there is none without anything to list.
  toggleList() {
    if ($("list").hidden) this.showList();
    else this.closeList();
  }

  // Number of findings in the file; 0 where they are not known.
  found() {
    const { findings } = this.queries;
    return findings ? findings.findings.length + findings.not_kept : 0;
  }

  showList() {
    if (!this.map.left_out && !this.found()) return this.closeList();
    this.list.show(this.queries.leftOut(), this.map.left_out, this.queries.findings);
    this.list.mark(this.chosen);
    $("show-list").setAttribute("aria-pressed", true);
  }

  closeList() {
    this.list.hide();
    $("show-list").setAttribute("aria-pressed", false);
  }

  // Closes what is open, one thing at a time: a way of clicking first, then the sheet, the list, the layers.
  close() {
    if (this.mode !== "look") return this.setMode(this.mode);
    if ($("panel").hidden && !$("list").hidden) return this.closeList();
    if ($("panel").hidden && !$("layers").hidden) return this.toggleLayers();
    this.clear();
  }

  listen() {
    this.camera.listen((...at) => this.click(...at), (...at) => this.hover(...at));
    addEventListener("resize", () => { this.camera.resize(); this.changed(); });
    addEventListener("keydown", event => this.key(event));
    addEventListener("hashchange", () => this.goToAddress());
    $("fit").onclick = () => this.fit();
    $("zoom-in").onclick = () => this.camera.zoom(ZOOM);
    $("zoom-out").onclick = () => this.camera.zoom(1 / ZOOM);
    $("help").onclick = () => this.panel.help(KEYS);
    $("route").onclick = () => this.setMode("route");
    $("measure").onclick = () => this.setMode("measure");
    $("theme").onclick = () => { this.dark = !this.dark; this.setTheme(); };
    $("show-layers").onclick = () => this.toggleLayers();
    $("show-list").onclick = () => this.toggleList();
    new Search(this);
  }

  // The view and what was chosen stand behind the # of the address: x, y [m], pixels a metre, turn [rad]; before them the map, if there are several.
  writeAddress() {
    const { camera, chosen } = this, [x, y] = this.far([camera.x, camera.y]);
    const parts = [`at=${x.toFixed(2)},${y.toFixed(2)},${+camera.scale.toPrecision(4)},${+camera.turn.toFixed(3)}`];
    if (this.live?.names.length > 1) parts.unshift(`map=${encodeURIComponent(this.live.names[this.live.number])}`);
    if (chosen?.kind === "lane") parts.push(`lane=${encodeURIComponent(this.queries.sheet(chosen).title.replace(/^Lane /, ""))}`);
    else if (chosen) parts.push(`${chosen.kind}=${chosen.row}`);
    try { history.replaceState(null, "", `#${parts.join("&")}`); } catch { /* Some browsers forbid it to files. */ }
  }

  goToAddress() {
    const { live } = this, { hash } = location;
    // What is being loaded counts, not what it will take the place of.
    if (live && live.named() !== live.wanted) return live.choose(live.named(), () => this.readAddress(hash) || this.fit());
    this.readAddress();
  }

  readAddress(hash = location.hash) {
    const parts = new URLSearchParams(hash.slice(1)), at = (parts.get("at") ?? "").split(",").map(Number);
    const isPlace = at.length === 4 && at.every(Number.isFinite) && at[2] > 0;
    if (isPlace) {
      const [x, y] = this.near(at[0], at[1]);
      Object.assign(this.camera, { x, y, scale: Math.min(CLOSEST, at[2]), turn: at[3] });
    }
    if (parts.get("lane")) {
      const link = this.queries.find(parts.get("lane")).map(words => words.link).find(one => one.kind === "lane");
      if (link) this.choose(link, { isFollowed: !isPlace });
    }
    const kind = KINDS.find(name => name !== "lane" && parts.has(name));
    if (kind && /^\d+$/.test(parts.get(kind))) this.choose({ kind, row: Number(parts.get(kind)) }, { isFollowed: !isPlace });
    this.changed();
    return isPlace || parts.has("lane") || kind !== undefined;
  }
}

async function start() {
  const begun = performance.now();
  try {
    const code = await embedded("module"), served = JSON.parse($("served").textContent);
    const live = served && new Live(served, code);
    const queries = live ? await live.load(live.number) : await Queries.open(code, await embedded("archive"), 0);
    if (!live) queries.lay(await embedded("overlay"));
    if (!live) queries.know(await embedded("findings"));
    $("message").textContent = "";
    const viewer = globalThis.viewer = new Viewer(queries, live);
    live?.show(viewer);
    viewer.paint();
    viewer.ready = performance.now() - begun;
  } catch (error) {
    $("message").textContent = `The map cannot be shown: ${error.message}`;
  }
}

start();
