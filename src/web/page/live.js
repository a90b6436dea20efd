// How often it is asked who reads a map [ms].
const ASK = 5000;

// A page that `mapd view` serves: its maps are fetched, and live ones followed.
class Live {
  constructor(names, code) {
    Object.assign(this, { names, code, number: 0 });
    this.number = this.wanted = this.named();
  }

  // The number of the map that the address names; that of the map that is shown if it names none.
  named() {
    const at = this.names.indexOf(new URLSearchParams(location.hash.slice(1)).get("map"));
    return at < 0 ? this.number : at;
  }

  // The queries of a map as it is served now.
  async load(number) {
    const answer = await fetch(`map/${number}`);
    if (!answer.ok) throw new Error(`mapd view says ${answer.status} ${answer.statusText}`);
    const generation = Number(answer.headers.get("Mapd-Generation"));
    const queries = await Queries.open(this.code, new Uint8Array(await answer.arrayBuffer()), generation);
    await this.lay(number, queries);
    const found = await fetch(`findings/${number}`);
    if (found.ok) queries.know(new Uint8Array(await found.arrayBuffer()));
    return queries;
  }

  // Lays over a map what is laid over it now. If it belongs to another generation already, that one is told next.
  async lay(number, queries) {
    const answer = await fetch(`overlay/${number}`);
    if (answer.ok) queries.lay(new Uint8Array(await answer.arrayBuffer()), Number(answer.headers.get("Mapd-Revision")));
  }

  // Follows the map that is shown, and lets the user choose among several.
  show(viewer) {
    this.viewer = viewer;
    const choice = $("maps");
    choice.replaceChildren(...this.names.map((name, i) => element("option", { value: i, textContent: name })));
    choice.value = this.number;
    choice.hidden = this.names.length < 2;
    choice.onchange = () => this.choose(Number(choice.value), () => viewer.fit());
    document.title = this.names.join(", ");
    this.follow(this.number);
  }

  // Shows another map, and what of it `look` brings into view. Of several that are chosen one after the other, the last is shown.
  async choose(number, look) {
    this.wanted = number;
    try {
      const queries = await this.load(number);
      if (number !== this.wanted) return;
      this.number = number;
      this.viewer.open(queries);
      look();
      this.follow(number);
    } catch (error) {
      if (number !== this.wanted) return;
      this.viewer.note(error.message);
      this.wanted = this.number;
    }
    $("maps").value = this.number;
  }

  // Shows who serves a live map, and how many subscribe to it; observers cannot be counted.
  async clients(number) {
    const answer = await fetch(`status/${number}`).catch(() => null), status = answer?.ok && await answer.json();
    if (number !== this.number) return;
    const { alive, pid, subscribers } = status || {}, isLive = answer?.ok && this.viewer.map.generation;
    const said = alive ? `daemon ${pid}` + (subscribers === null ? "" : ` · ${subscribers} ${subscribers === 1 ? "subscriber" : "subscribers"}`) : "no daemon";
    $("clients").textContent = isLive ? said : "";
  }

  follow(number) {
    const { viewer } = this;
    this.events?.close();
    clearInterval(this.asking);
    this.asking = setInterval(() => this.clients(number), ASK);
    this.clients(number);
    const events = this.events = new EventSource(`events/${number}`);
    // One after the other, so that what is older never comes last.
    let before = Promise.resolve();
    events.onmessage = ({ data }) => { before = before.then(() => this.heed(number, events, ...data.split(" ").map(Number))).catch(() => {}); };
    events.onerror = () => viewer.note("mapd view does not answer; trying again …");
  }

  // Shows what an event tells: another generation of the map, or another overlay of the same. Another map may be chosen meanwhile.
  async heed(number, events, generation, revision) {
    const { viewer } = this, { queries } = viewer;
    if (events !== this.events || generation === viewer.map.generation && revision === queries.revision) return;
    if (generation !== viewer.map.generation) {
      const next = await this.load(number);
      if (events !== this.events) return;
      viewer.swap(next);
      return viewer.note(`Generation ${next.map.generation} is served now.`);
    }
    await this.lay(number, queries);
    if (queries !== viewer.queries) return;
    viewer.today();
    viewer.note("What is laid over the map has changed.");
  }
}
