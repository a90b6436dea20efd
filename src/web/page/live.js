// How often it is asked who reads a map [ms].
const ASK = 5000;

// A page that `mapd view` serves: its maps are fetched, and live ones followed.
class Live {
  constructor(names, code) {
    Object.assign(this, { names, code });
  }

  // The queries of a map as it is served now.
  async load(number) {
    const answer = await fetch(`map/${number}`);
    if (!answer.ok) throw new Error(`mapd view says ${answer.status} ${answer.statusText}`);
    const generation = Number(answer.headers.get("Mapd-Generation"));
    const queries = await Queries.open(this.code, new Uint8Array(await answer.arrayBuffer()), generation);
    await this.lay(number, queries);
    return queries;
  }

  // Lays over a map what is laid over it now. If it belongs to another generation already, that one is told next.
  async lay(number, queries) {
    const answer = await fetch(`overlay/${number}`);
    if (answer.ok) queries.lay(new Uint8Array(await answer.arrayBuffer()), Number(answer.headers.get("Mapd-Revision")));
  }

  // Follows the first map, and lets the user choose among several.
  show(viewer) {
    this.viewer = viewer;
    const choice = $("maps");
    choice.replaceChildren(...this.names.map((name, i) => element("option", { value: i, textContent: name })));
    choice.hidden = this.names.length < 2;
    choice.onchange = async () => {
      viewer.open(await this.load(Number(choice.value)));
      viewer.fit();
      this.follow(Number(choice.value));
    };
    document.title = this.names.join(", ");
    this.follow(0);
  }

  // Shows who serves a live map, and how many subscribe to it; observers cannot be counted.
  async clients(number) {
    const answer = await fetch(`status/${number}`).catch(() => null), status = answer?.ok ? await answer.json() : null;
    if (!status) return $("clients").textContent = "";
    const { alive, pid, subscribers } = status;
    $("clients").textContent = alive ? `daemon ${pid} · ${subscribers} ${subscribers === 1 ? "subscriber" : "subscribers"}` : "no daemon";
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
