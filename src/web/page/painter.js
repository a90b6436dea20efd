// Draws layers with WebGL 2. Every layer lies on the graphics card from the start; a frame is a few calls for each.

// Layers in the order in which they are drawn, and pixels a metre from which they are seen.
const ORDER = [
  ["lanes", 0], ["crosswalks", 0.5], ["borders", 1.5], ["reference lines", 0], ["marks", 0.7], ["stop lines", 0.5],
  ["directions", 1.6], ["today", 0], ["conflicts", 0.2], ["objects", 0.4], ["index boxes", 0], ["left out", 0], ["signals", 0.1],
];
// Pixels a metre below which roads are drawn as lines, because their lanes are too thin to be seen.
const FAR = 0.5;
// Pixels a metre below which only these lines are drawn, of pieces as long as that [m]: a lane is thinner than a pixel.
const FARTHEST = 0.3, FAR_PIECE = 12;
// Corners that are drawn at a time at most: a multiple of 3 and of 4.
const PIECE = 6000;
// Radius of a signal [m], and its least and largest radius on the screen [pixels]; the least one shrinks where roads are but lines.
const SIGN = [0.8, 3.4, 12];

// A drawing of lines with fewer pieces: those that go on where the last one ended are one with it, up to a length.
function coarse({ strokes, chunks, ranges }) {
  const places = new Float32Array(strokes.buffer, strokes.byteOffset, strokes.length), kept = new Uint32Array(strokes.length), own = ranges.slice();
  let count = 0;
  for (let i = 0; i < ranges.length; i += 8) {
    const [from, of] = ranges.subarray(i + 6, i + 8);
    own[i + 6] = count;
    let length = Infinity;
    for (let at = 9 * from; at < 9 * (from + of); at += 9) {
      const [x, y, toX, toY] = places.subarray(at, at + 4), end = 9 * (count - 1), kind = strokes[at + 8];
      const isNext = count > own[i + 6] && kept[end + 2] === strokes[at] && kept[end + 3] === strokes[at + 1] && kept[end + 8] === kind;
      length = (isNext ? length : 0) + Math.hypot(toX - x, toY - y);
      if (isNext && length <= FAR_PIECE) {
        kept.set(strokes.subarray(at + 2, at + 4), end + 2);
        continue;
      }
      length = Math.hypot(toX - x, toY - y);
      kept.set(strokes.subarray(at, at + 9), 9 * count++);
    }
    own[i + 7] = count - own[i + 6];
  }
  return { corners: [], triangles: [], strokes: kept.slice(0, 9 * count), chunks, ranges: own };
}

class Painter {
  // `restored` is called when all layers have to be set again.
  constructor(canvas, restored) {
    const gl = canvas.getContext("webgl2", { antialias: false, alpha: false, powerPreference: "high-performance" });
    if (!gl) throw new Error("This browser has no WebGL 2, which the map is drawn with.");
    Object.assign(this, { canvas, gl, lowest: 0, changes: 0, chosen: null });
    this.begin();
    // A browser takes the graphics card from pages, such as those in the background of a phone, and gives it back only to those that ask for it.
    canvas.addEventListener("webglcontextlost", event => event.preventDefault());
    canvas.addEventListener("webglcontextrestored", () => {
      this.begin();
      this.setOverlay(this.chosen);
      restored();
    });
  }

  // Prepares a graphics card that holds nothing yet.
  begin() {
    const { gl } = this;
    Object.assign(this, { layers: new Map(), overlay: null });
    // Texels of a texture's side. Read once: a lost context does not tell.
    this.most = Math.min(gl.getParameter(gl.MAX_TEXTURE_SIZE), 8192);
    this.row = Math.floor(this.most / 3);
    this.area = this.program(AREA_VERTEX, AREA_FRAGMENT);
    this.stroke = this.program(STROKE_VERTEX, STROKE_FRAGMENT);
    this.sign = this.program(SIGN_VERTEX, SIGN_FRAGMENT);
    // What is known of this machine's speed stays.
    const { samples } = this.frames ?? {};
    this.frames = new Frames(gl, this.program(SEEN_VERTEX, SEEN_FRAGMENT));
    this.frames.samples = samples ?? this.frames.samples;
    const quads = new Uint16Array(PIECE / 4 * 6);
    for (let i = 0; i < PIECE / 4; i++) quads.set([0, 1, 2, 2, 1, 3].map(corner => 4 * i + corner), 6 * i);
    this.quads = gl.createVertexArray();
    gl.bindVertexArray(this.quads);
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, gl.createBuffer());
    gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, quads, gl.STATIC_DRAW);
    gl.bindVertexArray(null);
    gl.enable(gl.BLEND);
    gl.blendFunc(gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
    gl.enable(gl.DEPTH_TEST);
    gl.depthFunc(gl.LEQUAL);
  }

  program(vertex, fragment) {
    const gl = this.gl, program = gl.createProgram();
    for (const [type, source] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]]) {
      const shader = gl.createShader(type);
      gl.shaderSource(shader, source);
      gl.compileShader(shader);
      if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS)) throw new Error(gl.getShaderInfoLog(shader));
      gl.attachShader(program, shader);
    }
    gl.linkProgram(program);
    const count = gl.getProgramParameter(program, gl.ACTIVE_UNIFORMS), places = {};
    for (let i = 0; i < count; i++) {
      const name = gl.getActiveUniform(program, i).name;
      places[name.replace("[0]", "")] = gl.getUniformLocation(program, name);
    }
    return { program, places };
  }

  // Hands a drawing to the graphics card.
  load(drawing) {
    const gl = this.gl;
    const buffer = (target, data) => {
      const made = gl.createBuffer();
      gl.bindBuffer(target, made);
      gl.bufferData(target, data, gl.STATIC_DRAW);
      return made;
    };
    const { chunks, ranges } = drawing, made = { chunks, ranges, areas: null, strokes: null };
    if (drawing.triangles.length) {
      made.areas = gl.createVertexArray();
      gl.bindVertexArray(made.areas);
      made.corners = buffer(gl.ARRAY_BUFFER, drawing.corners);
      made.triangles = buffer(gl.ELEMENT_ARRAY_BUFFER, drawing.triangles);
      gl.enableVertexAttribArray(0);
      gl.vertexAttribPointer(0, 3, gl.FLOAT, false, 16, 0);
      gl.enableVertexAttribArray(1);
      gl.vertexAttribIPointer(1, 1, gl.UNSIGNED_INT, 16, 12);
    }
    if (drawing.strokes.length) made.strokes = this.table(drawing.strokes);
    gl.bindVertexArray(null);
    return made;
  }

  // Pieces of lines as a texture, three texels each, for the corners to look up: instances would take less, but where there is no graphics card,
  // each of them is a drawing of its own.
  table(strokes) {
    const gl = this.gl, count = strokes.length / 9, rows = Math.ceil(count / this.row);
    if (rows > this.most) throw new Error("This map has more lines than this browser's graphics can hold.");
    const data = new Uint32Array(12 * this.row * rows);
    for (let from = 0, to = 0; from < strokes.length; to += 3) for (let i = 0; i < 9; i++) data[to++] = strokes[from++];
    const made = gl.createTexture();
    gl.bindTexture(gl.TEXTURE_2D, made);
    gl.texStorage2D(gl.TEXTURE_2D, 1, gl.RGBA32UI, 3 * this.row, rows);
    gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, 3 * this.row, rows, gl.RGBA_INTEGER, gl.UNSIGNED_INT, data);
    for (const name of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) gl.texParameteri(gl.TEXTURE_2D, name, gl.NEAREST);
    return made;
  }

  unload(made) {
    for (const buffer of [made?.corners, made?.triangles]) if (buffer) this.gl.deleteBuffer(buffer);
    if (made?.areas) this.gl.deleteVertexArray(made.areas);
    if (made?.strokes) this.gl.deleteTexture(made.strokes);
  }

  set(name, drawing) {
    this.changes++;
    this.unload(this.layers.get(name));
    this.layers.set(name, this.load(drawing));
    if (name === "reference lines") this.set("far lines", coarse(drawing));
  }

  // Lays the drawing of what is chosen over all layers, or none. It is kept, to be laid over them again.
  setOverlay(drawing) {
    this.changes++;
    this.unload(this.overlay);
    this.chosen = drawing && Object.fromEntries(Object.entries(drawing).map(([name, part]) => [name, part.slice()]));
    this.overlay = drawing && this.load(drawing);
  }

  // Lowest level of the lanes, from which depth counts.
  setLowest(corners) {
    let lowest = 0xffffff;
    for (let i = 3; i < corners.length; i += 4) lowest = Math.min(lowest, corners[i] >>> 8);
    this.lowest = lowest;
  }

  setColors(names, dark, back) {
    this.changes++;
    this.colors = new Float32Array(64 * 4);
    names.forEach((name, i) => this.colors.set(rgba(name, dark), 4 * i));
    Object.assign(this, { names, dark, back });
  }

  // Ranges of what is seen: of triangles (2, 4 of a chunk) or strokes (6), those side by side as one, up to so many each.
  *runs(made, which, [x0, y0, x1, y1], most) {
    const cut = function* (first, count) {
      for (let at = 0; at < count; at += most) yield [first + at, Math.min(most, count - at)];
    };
    let first = 0, count = 0;
    for (let i = 0; i < made.ranges.length; i += 8) {
      const [a, b, c, d] = made.chunks.subarray(i, i + 4);
      const [from, of] = made.ranges.subarray(i + which, i + which + 2);
      if (!of || a > x1 || c < x0 || b > y1 || d < y0) continue;
      if (count && first + count === from) { count += of; continue; }
      yield* cut(first, count);
      [first, count] = [from, of];
    }
    yield* cut(first, count);
  }

  use({ program, places }, camera, ratio) {
    const gl = this.gl, scale = camera.scale * ratio;
    gl.useProgram(program);
    gl.uniform4f(places.view, camera.x, camera.y, Math.cos(camera.turn) * scale, Math.sin(camera.turn) * scale);
    gl.uniform2f(places.screen, this.canvas.width / 2, this.canvas.height / 2);
    gl.uniform1f(places.lowest, this.lowest);
    if (places.colors) gl.uniform4fv(places.colors, this.colors);
    return places;
  }

  *areas(made, camera, ratio, seen, { alpha = 1, heights = [0, 0] } = {}) {
    if (!made?.areas) return;
    const gl = this.gl;
    const prepare = () => {
      const places = this.use(this.area, camera, ratio);
      gl.uniform2f(places.heights, ...heights);
      gl.uniform1f(places.alpha, alpha);
      gl.uniform1ui(places.hatched, this.names.indexOf("left out"));
      gl.uniform1f(places.metre, camera.scale);
      gl.depthMask(alpha === 1);
      gl.bindVertexArray(made.areas);
    };
    for (const [first, count] of this.runs(made, 4, seen, PIECE)) {
      yield { prepare, corners: count, draw: () => gl.drawElements(gl.TRIANGLES, count, gl.UNSIGNED_INT, 4 * first) };
    }
  }

  *strokes(made, camera, ratio, seen, kind = this.stroke, { thinnest = 1.2, tint = [0, 0, 0, 0], radius = 0 } = {}) {
    if (!made?.strokes) return;
    const gl = this.gl;
    let first = null;
    const prepare = () => {
      const places = this.use(kind, camera, ratio);
      gl.uniform1f(places.thinnest, thinnest * ratio);
      gl.uniform4f(places.tint, ...tint);
      gl.uniform1f(places.radius, radius * ratio);
      gl.depthMask(false);
      gl.uniform1i(places.row, this.row);
      gl.bindTexture(gl.TEXTURE_2D, made.strokes);
      gl.bindVertexArray(this.quads);
      first = places.first;
    };
    for (const [from, count] of this.runs(made, 6, seen, PIECE / 4)) {
      const draw = () => {
        gl.uniform1i(first, from);
        gl.drawElements(gl.TRIANGLES, 6 * count, gl.UNSIGNED_SHORT, 0);
      };
      yield { prepare, corners: 4 * count, draw };
    }
  }

  // One frame. `shown` are the names of layers; `heights` colours lanes by height; with `all` it is complete, else it may be what was seen
  // before, moved. Returns whether more frames are needed.
  paint(camera, shown, heights, all) {
    if (this.gl.isContextLost()) return false;
    const ratio = Math.min(devicePixelRatio || 1, 2);
    const [width, height] = [Math.round(camera.width * ratio), Math.round(camera.height * ratio)];
    if (this.canvas.width !== width || this.canvas.height !== height) Object.assign(this.canvas, { width, height });
    const view = { x: camera.x, y: camera.y, scale: camera.scale * ratio, turn: camera.turn };
    const still = Object.assign(Object.create(Camera.prototype), { ...camera });
    return this.frames.show(view, JSON.stringify([this.changes, [...shown], heights]), () => this.pieces(still, ratio, shown, heights), this.back, all);
  }

  // All that is seen, piece by piece.
  *pieces(camera, ratio, shown, heights) {
    const gl = this.gl;
    const clear = () => {
      gl.depthMask(true);
      gl.clearColor(...this.back, 1);
      gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    };
    yield { prepare: clear, corners: 0, draw() {} };
    const [x0, y0, x1, y1] = camera.bounds(), room = 20 / camera.scale, seen = [x0 - room, y0 - room, x1 + room, y1 + room];
    for (const [name, from] of ORDER) {
      const made = this.layers.get(name);
      if (name === "lanes" && shown.has("lanes") && camera.scale >= FARTHEST) yield* this.areas(made, camera, ratio, seen, { heights });
      const isFar = name === "reference lines" && camera.scale < FAR && shown.has("lanes");
      if (isFar) yield* this.strokes(camera.scale < FARTHEST ? this.layers.get("far lines") : made, camera, ratio, seen, this.stroke, { thinnest: 1.6, tint: rgba("driving", this.dark) });
      if (name === "lanes" || !made || !shown.has(name) || camera.scale < from) continue;
      if (name === "signals") {
        const least = SIGN[1] * Math.sqrt(Math.min(1, camera.scale / FAR));
        const radius = Math.min(SIGN[2], Math.max(least, SIGN[0] * camera.scale));
        yield* this.strokes(made, camera, ratio, seen, this.sign, { radius });
        continue;
      }
      yield* this.areas(made, camera, ratio, seen, { alpha: 0.5 });
      const thinnest = ["left out", "conflicts", "today"].includes(name) ? 2 : name === "borders" ? 1 : 1.2;
      yield* this.strokes(made, camera, ratio, seen, this.stroke, { thinnest });
    }
    if (this.overlay) {
      const clear = () => { gl.depthMask(true); gl.clear(gl.DEPTH_BUFFER_BIT); };
      yield { prepare: clear, corners: 0, draw() {} };
      yield* this.areas(this.overlay, camera, ratio, seen, { alpha: 0.5 });
      yield* this.strokes(this.overlay, camera, ratio, seen, this.stroke, { thinnest: 2.5 });
    }
  }

  // How many pixels differ from the background: for tests.
  painted() {
    const gl = this.gl, pixels = new Uint8Array(4 * this.canvas.width * this.canvas.height);
    gl.readPixels(0, 0, this.canvas.width, this.canvas.height, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
    const back = this.back.map(value => Math.round(value * 255));
    let count = 0;
    for (let i = 0; i < pixels.length; i += 4) {
      if (back.some((value, k) => Math.abs(pixels[i + k] - value) > 2)) count++;
    }
    return count;
  }
}
