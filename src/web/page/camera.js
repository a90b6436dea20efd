// What of the map is seen: its middle [m, relative to the drawing's middle], pixels a metre, and turn [rad].
const CLOSEST = 400, MARGIN = 0.94;
// What a key or a button zooms by.
const ZOOM = 1.4;

class Camera {
  constructor(canvas, changed) {
    Object.assign(this, { canvas, changed, x: 0, y: 0, scale: 1, turn: 0, width: 1, height: 1 });
    this.farthest = 1e-3;
  }

  resize() {
    this.width = Math.max(1, innerWidth);
    this.height = Math.max(1, innerHeight);
  }

  // From pixels of the page to metres and back.
  toGround(px, py) {
    const [dx, dy] = [(px - this.width / 2) / this.scale, (this.height / 2 - py) / this.scale];
    const [c, s] = [Math.cos(this.turn), Math.sin(this.turn)];
    return [this.x + c * dx + s * dy, this.y - s * dx + c * dy];
  }

  toPage(x, y) {
    const [dx, dy] = [x - this.x, y - this.y];
    const [c, s] = [Math.cos(this.turn) * this.scale, Math.sin(this.turn) * this.scale];
    return [this.width / 2 + c * dx - s * dy, this.height / 2 - (s * dx + c * dy)];
  }

  // The box on the ground around what is seen.
  bounds() {
    const corners = [[0, 0], [this.width, 0], [0, this.height], [this.width, this.height]].map(p => this.toGround(...p));
    const xs = corners.map(c => c[0]), ys = corners.map(c => c[1]);
    return [Math.min(...xs), Math.min(...ys), Math.max(...xs), Math.max(...ys)];
  }

  // So that a box is seen in what the panels leave free (pixels at the left, top, right and bottom), but no closer than `closest`
  // pixels a metre.
  fit([x0, y0, x1, y1], [left, top, right, bottom], closest = CLOSEST) {
    const [width, height] = [Math.max(this.width - left - right, 50), Math.max(this.height - top - bottom, 50)];
    const scale = MARGIN * Math.min(width / Math.max(x1 - x0, 1e-3), height / Math.max(y1 - y0, 1e-3));
    Object.assign(this, { x: (x0 + x1) / 2, y: (y0 + y1) / 2, scale: Math.min(scale, closest), turn: 0 });
    this.hold(this.x, this.y, left + width / 2, top + height / 2);
  }

  // Zooms so that what lies under a pixel stays there.
  zoom(factor, px = this.width / 2, py = this.height / 2) {
    const [x, y] = this.toGround(px, py);
    this.scale = Math.min(CLOSEST, Math.max(this.farthest, this.scale * factor));
    this.hold(x, y, px, py);
  }

  rotate(angle, px = this.width / 2, py = this.height / 2) {
    const [x, y] = this.toGround(px, py);
    this.turn += angle;
    this.hold(x, y, px, py);
  }

  // Moves so that a place on the ground lies under a pixel.
  hold(x, y, px, py) {
    const [nowX, nowY] = this.toGround(px, py);
    this.x += x - nowX;
    this.y += y - nowY;
    this.changed();
  }

  // Mouse, touch and pen: one pointer moves, with Shift or the right button it turns; two zoom and turn. A press that does not
  // move is a click.
  listen(click, hover) {
    const pointers = new Map();
    let moved = 0;
    const both = () => {
      const [a, b] = [...pointers.values()];
      return { x: (a[0] + b[0]) / 2, y: (a[1] + b[1]) / 2, span: Math.hypot(b[0] - a[0], b[1] - a[1]), angle: Math.atan2(b[1] - a[1], b[0] - a[0]) };
    };
    this.canvas.addEventListener("pointerdown", event => {
      this.canvas.setPointerCapture(event.pointerId);
      pointers.set(event.pointerId, [event.clientX, event.clientY]);
      if (pointers.size === 1) moved = 0;
    });
    this.canvas.addEventListener("pointermove", event => {
      const last = pointers.get(event.pointerId);
      if (!last) return hover(event.clientX, event.clientY);
      const now = [event.clientX, event.clientY];
      moved += Math.hypot(now[0] - last[0], now[1] - last[1]);
      if (pointers.size === 2) {
        const before = both();
        const [x, y] = this.toGround(before.x, before.y);
        pointers.set(event.pointerId, now);
        const after = both();
        this.scale = Math.min(CLOSEST, Math.max(this.farthest, this.scale * after.span / Math.max(before.span, 1)));
        this.turn -= after.angle - before.angle;
        this.hold(x, y, after.x, after.y);
      } else if (event.shiftKey || event.buttons === 2) {
        const around = p => Math.atan2(p[1] - this.height / 2, p[0] - this.width / 2);
        this.rotate(around(last) - around(now));
      } else if (moved > 3) {
        this.hold(...this.toGround(...last), ...now);
      }
      pointers.set(event.pointerId, now);
    });
    const end = event => {
      const is_click = event.type === "pointerup" && pointers.size === 1 && moved <= 3 && event.button === 0;
      pointers.delete(event.pointerId);
      if (is_click) click(event.clientX, event.clientY, event.pointerType);
    };
    this.canvas.addEventListener("pointerup", end);
    this.canvas.addEventListener("pointercancel", end);
    this.canvas.addEventListener("contextmenu", event => event.preventDefault());
    this.canvas.addEventListener("wheel", event => {
      event.preventDefault();
      const lines = event.deltaMode === 1 ? 16 : 1;
      if (event.shiftKey) this.rotate((event.deltaY || event.deltaX) * lines * 2e-3, event.clientX, event.clientY);
      else this.zoom(Math.exp(-event.deltaY * lines * (event.ctrlKey ? 0.01 : 0.0018)), event.clientX, event.clientY);
    }, { passive: false });
  }

  // Arrows move, + and - zoom, , and . turn, n is north up. Whether the key was one of them.
  key(key) {
    const step = 60 / this.scale, [c, s] = [Math.cos(this.turn), Math.sin(this.turn)];
    const move = (dx, dy) => { this.x += step * (c * dx + s * dy); this.y += step * (c * dy - s * dx); this.changed(); };
    const keys = {
      ArrowLeft: () => move(-1, 0), ArrowRight: () => move(1, 0), ArrowUp: () => move(0, 1), ArrowDown: () => move(0, -1),
      "+": () => this.zoom(ZOOM), "=": () => this.zoom(ZOOM), "-": () => this.zoom(1 / ZOOM),
      ",": () => this.rotate(0.1), ".": () => this.rotate(-0.1), n: () => this.rotate(-this.turn),
    };
    keys[key]?.();
    return key in keys;
  }
}
