// Frames that are drawn piece by piece, so that a large map on a slow machine still moves at once: a picture is drawn out of sight, as far as
// time allows in each frame, and what is seen is the last picture that is complete, moved and turned to where the map is now.

// What drawing may take of each frame [ms], while the view moves and once it rests, and corners that are drawn between two looks at the clock.
const BUDGET = 12, RESTING = 80, LOOK = 6000;
// A picture that takes longer [ms] shows that there is no graphics card: the next ones have no smoothed edges.
const SLOW = 100;
// Samples of a pixel, for smooth edges.
const SAMPLES = 4;

const SEEN_VERTEX = `#version 300 es
uniform vec2 corners[4];
out vec2 at;
void main() {
  at = vec2(gl_VertexID & 1, gl_VertexID >> 1);
  gl_Position = vec4(corners[gl_VertexID], 0.0, 1.0);
}`;
const SEEN_FRAGMENT = `#version 300 es
precision highp float;
in vec2 at;
uniform sampler2D seen;
out vec4 result;
void main() { result = texture(seen, at); }`;

class Frames {
  constructor(gl, program) {
    Object.assign(this, { gl, program, samples: SAMPLES, front: null, back: null, job: null, size: [0, 0] });
  }

  // A picture's memory: what is drawn on, and what is shown of it.
  room([width, height]) {
    const { gl, samples } = this, made = { texture: gl.createTexture(), shown: gl.createFramebuffer(), drawn: gl.createFramebuffer(), parts: [] };
    gl.bindTexture(gl.TEXTURE_2D, made.texture);
    gl.texStorage2D(gl.TEXTURE_2D, 1, gl.RGBA8, width, height);
    for (const name of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) gl.texParameteri(gl.TEXTURE_2D, name, gl.LINEAR);
    for (const name of [gl.TEXTURE_WRAP_S, gl.TEXTURE_WRAP_T]) gl.texParameteri(gl.TEXTURE_2D, name, gl.CLAMP_TO_EDGE);
    gl.bindFramebuffer(gl.FRAMEBUFFER, made.shown);
    gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, made.texture, 0);
    // Without smooth edges both are one.
    if (!samples) {
      gl.deleteFramebuffer(made.drawn);
      made.drawn = made.shown;
    }
    gl.bindFramebuffer(gl.FRAMEBUFFER, made.drawn);
    const parts = [[gl.RGBA8, gl.COLOR_ATTACHMENT0], [gl.DEPTH_COMPONENT24, gl.DEPTH_ATTACHMENT]].slice(samples ? 0 : 1);
    for (const [format, place] of parts) {
      const part = gl.createRenderbuffer();
      gl.bindRenderbuffer(gl.RENDERBUFFER, part);
      gl.renderbufferStorageMultisample(gl.RENDERBUFFER, samples, format, width, height);
      gl.framebufferRenderbuffer(gl.FRAMEBUFFER, place, gl.RENDERBUFFER, part);
      made.parts.push(part);
    }
    return made;
  }

  free(made) {
    if (!made) return;
    const { gl } = this;
    gl.deleteTexture(made.texture);
    for (const part of made.parts) gl.deleteRenderbuffer(part);
    for (const buffer of new Set([made.shown, made.drawn])) gl.deleteFramebuffer(buffer);
  }

  // Shows a view. `what` names all that a picture depends on besides the view; `pieces` draws it: each piece prepares and draws, and
  // says how many corners it has. Returns whether the picture that is seen is not yet the one that is wanted.
  show(view, what, pieces, back, all = false) {
    const { gl } = this, { width, height } = gl.canvas, wanted = JSON.stringify([what, view, width, height]);
    if (this.size[0] !== width || this.size[1] !== height || this.back?.samples !== this.samples) {
      this.free(this.back);
      Object.assign(this, { back: null, job: null, size: [width, height] });
    }
    if (this.job && (this.job.what !== what || all && this.job.wanted !== wanted)) this.job = null;
    if (!this.job && this.front?.wanted !== wanted) {
      this.back ??= Object.assign(this.room(this.size), { samples: this.samples });
      this.job = { wanted, what, view, pieces: pieces(view), prepared: null, took: 0 };
    }
    const { front, last } = this;
    if (this.job) this.draw(all ? Infinity : last === wanted ? RESTING : BUDGET);
    // What is on the screen stays there: where nothing else is to be seen, all the time is the picture's.
    if (all || last !== wanted || front !== this.front) this.present(view, back);
    this.last = wanted;
    return this.front?.wanted !== wanted;
  }

  // Goes on with the picture, so long [ms].
  draw(longest) {
    const { gl, job, back } = this, begun = performance.now();
    const passed = () => {
      // Until all of it is drawn: the clock alone would tell when it was asked for.
      gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
      return performance.now() - begun;
    };
    const done = () => { gl.bindFramebuffer(gl.FRAMEBUFFER, back.shown); const time = passed(); gl.bindFramebuffer(gl.FRAMEBUFFER, back.drawn); return time; };
    gl.bindFramebuffer(gl.FRAMEBUFFER, back.drawn);
    gl.viewport(0, 0, ...this.size);
    job.prepared = null;
    let corners = 0;
    for (;;) {
      const { value: piece, done: isLast } = job.pieces.next();
      if (isLast) break;
      if (job.prepared !== piece.prepare) (job.prepared = piece.prepare)();
      piece.draw();
      corners += piece.corners;
      if (corners < LOOK) continue;
      corners = 0;
      this.resolve();
      const time = done();
      if (time > longest) {
        job.took += time;
        return gl.bindFramebuffer(gl.FRAMEBUFFER, null);
      }
    }
    this.resolve();
    job.took += done();
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    if (job.took > SLOW) this.samples = 0;
    [this.front, this.back] = [Object.assign(back, { view: job.view, wanted: job.wanted, what: job.what, extent: this.size }), this.front];
    this.job = null;
    if (this.back && (this.back.extent[0] !== this.size[0] || this.back.extent[1] !== this.size[1])) {
      this.free(this.back);
      this.back = null;
    }
  }

  // What is drawn becomes what can be shown.
  resolve() {
    const { gl, back, size } = this;
    if (back.drawn === back.shown) return;
    gl.bindFramebuffer(gl.READ_FRAMEBUFFER, back.drawn);
    gl.bindFramebuffer(gl.DRAW_FRAMEBUFFER, back.shown);
    gl.blitFramebuffer(0, 0, ...size, 0, 0, ...size, gl.COLOR_BUFFER_BIT, gl.NEAREST);
    gl.bindFramebuffer(gl.FRAMEBUFFER, back.drawn);
  }

  // Puts the last picture where its ground lies in a view.
  present(view, back) {
    const { gl, front, program } = this, { width, height } = gl.canvas;
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    gl.viewport(0, 0, width, height);
    gl.clearColor(...back, 1);
    gl.depthMask(true);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    if (!front) return;
    const { view: from, extent } = front, turn = view.turn - from.turn, grow = view.scale / from.scale;
    const [c, s] = [Math.cos(turn) * grow, Math.sin(turn) * grow];
    const [dx, dy] = [from.x - view.x, from.y - view.y].map(value => value * view.scale);
    const [mx, my] = [Math.cos(view.turn) * dx - Math.sin(view.turn) * dy, Math.sin(view.turn) * dx + Math.cos(view.turn) * dy];
    if (!turn && grow === 1 && extent[0] === width && extent[1] === height) {
      // Only moved: copied, which is fastest.
      const [x, y] = [Math.round(mx), Math.round(my)];
      gl.bindFramebuffer(gl.READ_FRAMEBUFFER, front.shown);
      const [fromX, fromY, toX, toY] = [Math.max(0, -x), Math.max(0, -y), Math.min(width, width - x), Math.min(height, height - y)];
      if (toX > fromX && toY > fromY) gl.blitFramebuffer(fromX, fromY, toX, toY, fromX + x, fromY + y, toX + x, toY + y, gl.COLOR_BUFFER_BIT, gl.NEAREST);
      return gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    }
    const corners = [[-1, -1], [1, -1], [-1, 1], [1, 1]].flatMap(([x, y]) => {
      const [px, py] = [x * extent[0] / 2, y * extent[1] / 2];
      return [(c * px - s * py + mx) / (width / 2), (s * px + c * py + my) / (height / 2)];
    });
    gl.useProgram(program.program);
    gl.uniform2fv(program.places.corners, corners);
    gl.bindTexture(gl.TEXTURE_2D, front.texture);
    gl.bindVertexArray(null);
    gl.disable(gl.DEPTH_TEST);
    gl.disable(gl.BLEND);
    gl.drawArrays(gl.TRIANGLE_STRIP, 0, 4);
    gl.enable(gl.BLEND);
    gl.enable(gl.DEPTH_TEST);
  }
}
