// The limit surface of a patch: a closed convex body that can be turned and read.

const LABELS = ["force x [N]", "force y [N]", "torque [N m]"];

class LimitSurface {
  constructor(stage, reading, data) {
    Object.assign(this, { stage, reading, data });
    this.canvas = stage.querySelector("canvas");
    this.ink = this.canvas.getContext("2d");
    // In units of the limits the surface fits into a cube.
    this.points = data.points.map(([fx, fy, t]) => this.reduced([fx, fy, t]));
    this.pushes = data.pushes.map((push) => this.reduced(push));
    this.camera = new Camera([[-1.1, -1.1, -1.1], [1.1, 1.1, 1.1]]);
    this.camera.elevation = 0.4;
    this.listen();
    new ResizeObserver(() => this.draw()).observe(stage);
  }

  reduced([fx, fy, t]) {
    const { force, torque } = this.data.limits;
    return [fx / force, fy / force, t / torque];
  }

  /** A place of the picture, and how near it is to the eye. */
  seen(point) {
    const { right, up, toward } = this.axes;
    const { shift } = this.camera;
    return [
      this.middle[0] + shift[0] + this.scale * dot(right, point),
      this.middle[1] - shift[1] - this.scale * dot(up, point),
      dot(toward, point),
    ];
  }

  draw() {
    const box = this.stage.getBoundingClientRect();
    const ratio = window.devicePixelRatio || 1;
    [this.canvas.width, this.canvas.height] = [box.width * ratio, box.height * ratio];
    this.ink.setTransform(ratio, 0, 0, ratio, 0, 0);
    this.ink.clearRect(0, 0, box.width, box.height);
    this.middle = [0.5 * box.width, 0.5 * box.height];
    this.axes = this.camera.axes();
    this.scale = this.camera.scale(box.width, box.height);
    this.places = this.points.map((point) => this.seen(point));
    this.drawAxes(-1);
    this.drawFaces();
    this.drawAxes(1);
    this.drawLabels();
    this.drawPushes();
    this.drawChosen();
  }

  /** The halves of the axes behind the body (side -1) or in front of it (1). */
  drawAxes(side) {
    const { ink } = this;
    ink.lineWidth = 1;
    ink.strokeStyle = "#4a525b";
    for (let k = 0; k < 3; k += 1) {
      for (const sign of [-1, 1]) {
        const at = (length) => this.seen([0, 1, 2].map((i) => (i === k ? sign * length : 0)));
        const [from, to] = [at(1), at(1.25)];
        if (Math.sign(to[2]) !== side && to[2] !== 0) continue;
        ink.beginPath();
        ink.moveTo(from[0], from[1]);
        ink.lineTo(to[0], to[1]);
        ink.stroke();
      }
    }
  }

  drawLabels() {
    LABELS.forEach((label, k) => {
      const [x, y] = this.seen([0, 1, 2].map((i) => (i === k ? 1.25 : 0)));
      this.ink.fillStyle = "#22262b";
      this.ink.font = "13px system-ui, sans-serif";
      this.ink.fillText(label, x + 4, y - 4);
    });
  }

  /** The body is convex: faces turned to the eye hide nothing of each other. */
  drawFaces() {
    const { ink, places } = this;
    const { rows, columns, ramp } = this.data;
    for (let i = 0; i + 1 < rows; i += 1) {
      for (let j = 0; j < columns; j += 1) {
        const next = (j + 1) % columns;
        const corners = [i * columns + j, i * columns + next, (i + 1) * columns + next, (i + 1) * columns + j];
        const face = corners.map((corner) => places[corner]);
        const area = face.reduce((sum, [x, y], k) => {
          const [u, v] = face[(k + 1) % 4];
          return sum + x * v - y * u;
        }, 0);
        if (area >= 0) continue;
        ink.beginPath();
        face.forEach(([x, y], k) => (k ? ink.lineTo(x, y) : ink.moveTo(x, y)));
        ink.closePath();
        const share = Math.abs(2 * (i + 0.5) / (rows - 1) - 1);
        ink.fillStyle = ink.strokeStyle = ramp[Math.min(ramp.length - 1, Math.floor(share * ramp.length))];
        ink.fill();
        ink.stroke();
      }
    }
  }

  drawPushes() {
    const { ink } = this;
    for (const push of this.pushes) {
      const [x, y, depth] = this.seen(push);
      ink.globalAlpha = depth < 0 ? 0.25 : 1;
      ink.fillStyle = "#c8321e";
      ink.beginPath();
      ink.arc(x, y, 3, 0, 2 * Math.PI);
      ink.fill();
    }
    ink.globalAlpha = 1;
  }

  drawChosen() {
    if (this.chosen === undefined) return;
    const [x, y] = this.places[this.chosen];
    this.ink.strokeStyle = "#c8321e";
    this.ink.lineWidth = 2;
    this.ink.beginPath();
    this.ink.arc(x, y, 6, 0, 2 * Math.PI);
    this.ink.stroke();
  }

  /** The point of the surface under the pointer. */
  choose(x, y) {
    let nearest = Infinity;
    this.places.forEach(([u, v, depth], i) => {
      const away = (u - x) ** 2 + (v - y) ** 2;
      if (depth > 0 && away < nearest) [nearest, this.chosen] = [away, i];
    });
    this.read();
    this.draw();
  }

  read() {
    const [fx, fy, t, vx, vy, spin] = this.data.points[this.chosen].map((x) => x || 0);
    const show = (x) => String(Number(x.toPrecision(4)));
    const turn = Math.abs(spin) > 1e-9 ? `turns about (${show(-vy / spin)}, ${show(vx / spin)}) m` : "slides without turning";
    this.reading.textContent =
      `Push (${show(fx)}, ${show(fy)}) N, ${show(t)} N m: the body ${turn}; ` +
      `motion (${show(vx)}, ${show(vy)}) m/s, ${show(spin)} rad/s in proportion.`;
  }

  listen() {
    const { stage, camera } = this;
    let last;
    stage.addEventListener("pointerdown", (event) => {
      last = [event.clientX, event.clientY];
      stage.setPointerCapture(event.pointerId);
    });
    stage.addEventListener("pointerup", () => (last = undefined));
    stage.addEventListener("pointercancel", () => (last = undefined));
    stage.addEventListener("pointermove", (event) => {
      const box = stage.getBoundingClientRect();
      if (last) {
        camera.turn(event.clientX - last[0], event.clientY - last[1]);
        last = [event.clientX, event.clientY];
        this.draw();
      } else {
        this.choose(event.clientX - box.left, event.clientY - box.top);
      }
    });
    stage.addEventListener("wheel", (event) => {
      event.preventDefault();
      camera.zoomBy(Math.exp(-0.0015 * event.deltaY));
      this.draw();
    }, { passive: false });
    stage.addEventListener("keydown", (event) => {
      const turns = { ArrowLeft: [-20, 0], ArrowRight: [20, 0], ArrowUp: [0, -20], ArrowDown: [0, 20] };
      if (event.key in turns) camera.turn(...turns[event.key]);
      else if (event.key === "+") camera.zoomBy(1.2);
      else if (event.key === "-") camera.zoomBy(1 / 1.2);
      else if (event.key === "0") camera.reset();
      else return;
      event.preventDefault();
      this.draw();
    });
  }
}

const stage = document.querySelector(".stage");
const data = JSON.parse(document.querySelector(".data").textContent);
new LimitSurface(stage, document.querySelector(".read"), data);
