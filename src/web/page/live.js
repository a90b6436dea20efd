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
    return Queries.open(this.code, new Uint8Array(await answer.arrayBuffer()), generation);
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

  follow(number) {
    const { viewer } = this;
    this.events?.close();
    const events = this.events = new EventSource(`events/${number}`);
    events.onmessage = async ({ data }) => {
      if (Number(data) === viewer.map.generation) return;
      const queries = await this.load(number);
      // Another map may have been chosen meanwhile.
      if (events !== this.events) return;
      viewer.swap(queries);
      viewer.note(`Generation ${queries.map.generation} is served now.`);
    };
    events.onerror = () => viewer.note("mapd view does not answer; trying again …");
  }
}
