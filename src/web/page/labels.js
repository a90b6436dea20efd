// What is written over the map: a scale bar, north, the chosen place, a measure, the limits of speed signs.

const MOST_LABELS = 400;

class Labels {
  constructor(canvas) {
    Object.assign(this, { canvas, pen: canvas.getContext("2d"), mark: null, ends: [], measure: [], speeds: [] });
  }

  paint(camera, ink, paper) {
    const ratio = devicePixelRatio || 1, { canvas, pen } = this;
    const [width, height] = [Math.round(camera.width * ratio), Math.round(camera.height * ratio)];
    if (canvas.width !== width || canvas.height !== height) Object.assign(canvas, { width, height });
    pen.setTransform(ratio, 0, 0, ratio, 0, 0);
    pen.clearRect(0, 0, camera.width, camera.height);
    pen.font = "12px system-ui, sans-serif";
    Object.assign(this, { ink, paper });
    this.bar(camera);
    this.north(camera);
    if (camera.scale > 9) this.limits(camera);
    if (this.mark) this.ring(camera, this.mark, 8);
    this.ends.forEach((end, i) => this.pin(camera, end, "AB"[i]));
    if (this.measure.length) this.ruler(camera);
  }

  // Text that can be read on whatever lies below.
  text(text, x, y, align = "left") {
    const pen = this.pen;
    pen.textAlign = align;
    pen.lineWidth = 3;
    pen.strokeStyle = this.paper;
    pen.lineJoin = "round";
    pen.strokeText(text, x, y);
    pen.fillStyle = this.ink;
    pen.fillText(text, x, y);
  }

  line(points, width = 2) {
    const pen = this.pen;
    for (const [color, more] of [[this.paper, 2], [this.ink, 0]]) {
      pen.beginPath();
      points.forEach(([x, y], i) => (i ? pen.lineTo(x, y) : pen.moveTo(x, y)));
      pen.strokeStyle = color;
      pen.lineWidth = width + more;
      pen.stroke();
    }
  }

  bar(camera) {
    const most = Math.min(160, camera.width * 0.3) / camera.scale;
    const power = 10 ** Math.floor(Math.log10(most));
    const length = [5, 2, 1].map(n => n * power).find(n => n <= most);
    const [x, y] = [camera.width - 20 - length * camera.scale, camera.height - 18];
    this.line([[x, y - 5], [x, y], [camera.width - 20, y], [camera.width - 20, y - 5]]);
    const shown = length >= 1000 ? `${length / 1000} km` : length >= 1 ? `${length} m` : `${+(length * 100).toPrecision(1)} cm`;
    this.text(shown, camera.width - 20, y - 9, "right");
  }

  north(camera) {
    if (Math.abs(Math.sin(camera.turn / 2)) < 1e-3) return;
    const [x, y] = [camera.width - 34, camera.height - 70], [c, s] = [Math.cos(camera.turn), Math.sin(camera.turn)];
    const at = (right, up) => [x + c * right - s * up, y - s * right - c * up];
    this.line([at(0, -14), at(0, 14), at(-5, 6), at(0, 14), at(5, 6)]);
    const [tx, ty] = at(0, 24);
    this.text("y", tx, ty + 4, "center");
  }

  limits(camera) {
    const [x0, y0, x1, y1] = camera.bounds();
    let count = 0;
    for (const [x, y, text] of this.speeds) {
      if (x < x0 || x > x1 || y < y0 || y > y1) continue;
      if (++count > MOST_LABELS) return;
      const [px, py] = camera.toPage(x, y);
      this.text(text, px + 15, py + 4);
    }
  }

  ring(camera, place, radius) {
    const pen = this.pen, [x, y] = camera.toPage(...place);
    for (const [color, width] of [[this.paper, 5], [this.ink, 2]]) {
      pen.beginPath();
      pen.arc(x, y, radius, 0, 7);
      pen.strokeStyle = color;
      pen.lineWidth = width;
      pen.stroke();
    }
  }

  pin(camera, place, letter) {
    const pen = this.pen, [x, y] = camera.toPage(...place);
    pen.beginPath();
    pen.arc(x, y, 10, 0, 7);
    pen.fillStyle = this.ink;
    pen.fill();
    pen.fillStyle = this.paper;
    pen.textAlign = "center";
    pen.fillText(letter, x, y + 4);
  }

  ruler(camera) {
    this.line(this.measure.map(place => camera.toPage(...place)));
    let sum = 0;
    this.measure.forEach((place, i) => {
      this.ring(camera, place, 3);
      if (!i) return;
      const [x, y] = this.measure[i - 1];
      sum += Math.hypot(place[0] - x, place[1] - y);
      const [px, py] = camera.toPage(...place);
      this.text(`${sum.toFixed(2)} m`, px + 8, py - 8);
    });
  }
}
