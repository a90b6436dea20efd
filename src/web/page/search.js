// The search box. Two numbers are a place.
class Search {
  constructor(viewer) {
    Object.assign(this, { viewer, found: [] });
    $("text").addEventListener("input", () => this.look());
    $("search").addEventListener("submit", event => { event.preventDefault(); this.take(Math.max(this.at, 0)); });
    $("text").addEventListener("keydown", event => {
      const step = { ArrowDown: 1, ArrowUp: -1 }[event.key];
      if (step) this.select(this.at + step);
      if (event.key === "Escape") { this.show([]); $("text").blur(); }
      if (step || event.key === "Escape") event.preventDefault();
    });
    this.at = -1;
  }

  look() {
    const text = $("text").value, numbers = text.match(/^\s*(-?\d+(?:\.\d+)?)[\s,;]+(-?\d+(?:\.\d+)?)\s*$/);
    const place = numbers ? [{ text: `place x ${numbers[1]} m, y ${numbers[2]} m`, place: [Number(numbers[1]), Number(numbers[2])] }] : [];
    // Two numbers may be a latitude and longitude, too, if there is such a place on the map.
    const there = numbers && this.viewer.queries.geodetic(Number(numbers[1]), Number(numbers[2])), [low, high] = this.viewer.map.bounds;
    const isOnMap = there && !there.error && there.x >= low[0] && there.x <= high[0] && there.y >= low[1] && there.y <= high[1];
    const onEarth = isOnMap ? [{ text: `place at latitude ${numbers[1]}°, longitude ${numbers[2]}°`, place: [there.x, there.y] }] : [];
    this.show([...onEarth, ...place, ...this.viewer.queries.find(text)]);
  }

  show(found) {
    Object.assign(this, { found, at: -1 });
    $("found").hidden = !found.length;
    $("found").replaceChildren(...found.map((one, i) => element("li", { textContent: one.text, onmousedown: event => { event.preventDefault(); this.take(i); } })));
  }

  select(at) {
    if (!this.found.length) return;
    this.at = (at + this.found.length) % this.found.length;
    [...$("found").children].forEach((item, i) => item.setAttribute("aria-selected", i === this.at));
    $("found").children[this.at].scrollIntoView({ block: "nearest" });
  }

  take(at) {
    const one = this.found[at], { viewer } = this;
    if (!one) return viewer.note("Nothing has this name.");
    this.show([]);
    $("text").blur();
    if (one.link) return viewer.choose(one.link, { isFollowed: true, isWhole: true });
    const [x, y] = viewer.near(...one.place);
    viewer.clear();
    viewer.labels.mark = [x, y];
    viewer.show([x - 40, y - 40, x + 40, y + 40]);
  }
}
