// The queries: the module of WebAssembly with one map in it.

// Numbers of the module's layers, kinds of things, and parts of drawings.
const LAYERS = ["lanes", "borders", "reference lines", "marks", "directions", "crosswalks", "stop lines", "objects", "signals", "conflicts", "index boxes", "left out", "today"];
const KINDS = ["lane", "road", "junction", "signal", "object", "quarantine"];
const CORNERS = 0, TRIANGLES = 1, STROKES = 2, CHUNKS = 3;

async function unpacked(stream) {
  return new Uint8Array(await new Response(stream.pipeThrough(new DecompressionStream("gzip"))).arrayBuffer());
}

// Bytes that lie in the page, packed, as base64.
function embedded(id) {
  const text = document.getElementById(id).textContent.trim();
  let bytes;
  if (Uint8Array.fromBase64) {
    bytes = Uint8Array.fromBase64(text);
  } else {
    const plain = atob(text);
    bytes = new Uint8Array(plain.length);
    for (let i = 0; i < plain.length; i++) bytes[i] = plain.charCodeAt(i);
  }
  return unpacked(new Blob([bytes]).stream());
}

class Queries {
  static async open(code, archive, generation) {
    const { instance } = await WebAssembly.instantiate(code, {});
    const queries = new Queries(instance.exports);
    queries.put(archive);
    const isOpen = queries.module.open_archive(archive.length, generation);
    const answer = queries.text();
    if (!isOpen) throw new Error(answer);
    queries.map = JSON.parse(answer);
    return queries;
  }

  constructor(module) {
    this.module = module;
  }

  put(bytes) {
    const at = this.module.reserve(bytes.length);
    new Uint8Array(this.module.memory.buffer, at, bytes.length).set(bytes);
    return bytes.length;
  }

  // Lays an overlay over the map, in the place of the one before; without bytes nothing. One that was made for another map is none.
  lay(overlay, revision = 0) {
    this.revision = revision;
    this.isOver = Boolean(this.module.lay(this.put(overlay)));
  }

  // Takes what was found in the map's file: JSON, nothing where that is not known.
  know(findings) { this.findings = findings.length ? JSON.parse(new TextDecoder().decode(findings)) : null; }

  // The moment of what is asked from now on [s since 1970].
  setMoment(seconds) { this.module.set_moment(seconds); }

  text() {
    return new TextDecoder().decode(new Uint8Array(this.module.memory.buffer, this.module.answer(), this.module.answer_length()));
  }

  // The answer of one of the module's functions.
  ask(name, ...numbers) {
    this.module[name](...numbers);
    return JSON.parse(this.text());
  }

  place(x, y) { return this.ask("place", x, y); }
  geodetic(latitude, longitude) { return this.ask("geodetic", latitude, longitude); }
  pick(x, y, radius) { return this.ask("pick", x, y, radius); }
  sheet(link) { return this.ask("sheet", KINDS.indexOf(link.kind), link.row); }
  way(from, to) { return this.ask("way", ...from, ...to); }
  leftOut() { return this.ask("left_out"); }
  find(text) { return this.ask("find", this.put(new TextEncoder().encode(text))); }

  draw(layer) {
    this.module.draw(layer);
    return this.drawing();
  }

  // The last drawing, as it lies in the module's memory until something else is asked.
  drawing() {
    const part = (which, type, per) => {
      const count = this.module.drawn_count(which) * per;
      return new type(this.module.memory.buffer, count ? this.module.drawn(which) : 0, count);
    };
    return {
      corners: part(CORNERS, Uint32Array, 4),
      triangles: part(TRIANGLES, Uint32Array, 1),
      strokes: part(STROKES, Uint32Array, 9),
      chunks: part(CHUNKS, Float32Array, 8).slice(),
      ranges: part(CHUNKS, Uint32Array, 8).slice(),
    };
  }
}
