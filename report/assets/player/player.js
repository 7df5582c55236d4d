// The player: buttons, keys, fingers, time.

/** A new element with attributes and children. */
function make(name, attributes = {}, ...children) {
  const element = document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) {
    if (key.startsWith("on")) element.addEventListener(key.slice(2), value);
    else element.setAttribute(key, value);
  }
  element.append(...children);
  return element;
}

class Player {
  constructor(root, meta, makeView) {
    Object.assign(this, { root, meta, frame: 0, playing: false, rate: 20, owed: 0 });
    this.canvas = make("canvas", { class: "picture" });
    this.ink = make("canvas", { class: "ink", "aria-hidden": "true" });
    this.stage = make("div", { class: "stage", tabindex: "0", role: "img" }, this.canvas, this.ink);
    this.below = make("canvas", { class: "below", "aria-hidden": "true" });
    this.view = makeView(this.canvas);
    const parameters = meta.parameters ? [make("p", { class: "parameters" }, meta.parameters)] : [];
    root.replaceChildren(make("h2", {}, meta.title), ...parameters, this.looks(), this.stage, this.below, this.transport(), this.settings(), this.help());
    this.listen();
    const looks = this.view.presets();
    const [first] = Object.values(looks);
    this.choose(looks[meta.look] || first || {});
    this.resize();
  }

  /** A button a preset, and the picture. */
  looks() {
    this.presets = Object.entries(this.view.presets()).map(([name, look]) =>
      make("button", { type: "button", class: "preset", onclick: () => this.choose(look) }, name));
    const save = make("button", { type: "button", class: "save", onclick: () => this.save() }, "Save PNG");
    return make("div", { class: "bar" }, ...this.presets, save);
  }

  /** Each option by itself, and the view. */
  settings() {
    const { view } = this;
    const bar = make("div", { class: "bar" });
    this.choices = {};
    for (const [key, label, list] of view.choices()) {
      const options = list.map(([value, name]) => make("option", { value }, name));
      this.choices[key] = make("select", { "aria-label": label, onchange: () => this.choose({ [key]: this.choices[key].value }) }, ...options);
      bar.append(make("label", {}, `${label} `, this.choices[key]));
    }
    bar.append(make("button", { type: "button", onclick: () => { view.camera.reset(); this.redraw(); } }, "Reset view"));
    return bar;
  }

  /** Play, steps, scrub, speed. */
  transport() {
    const button = (text, title, action) => make("button", { type: "button", title, "aria-label": title, onclick: action }, text);
    this.play = button("▶", "play or pause (space)", () => this.toggle());
    this.play.classList.add("play");
    this.scrub = make("input", { type: "range", class: "scrub", min: 0, max: this.meta.frames.length - 1, value: 0, "aria-label": "frame", oninput: () => { this.pause(); this.show(Number(this.scrub.value)); } });
    this.count = make("output", { class: "count" });
    const rates = [5, 10, 20, 30, 60].map((rate) => make("option", rate === this.rate ? { value: rate, selected: "" } : { value: rate }, `${rate} frames/s`));
    const speed = make("select", { class: "rate", "aria-label": "speed", onchange: () => { this.rate = Number(speed.value); } }, ...rates);
    return make("div", { class: "bar transport" }, button("|◀", "first frame (home)", () => this.step(-Infinity)), button("◀", "frame back (left arrow)", () => this.step(-1)), this.play, button("▶|", "frame on (right arrow)", () => this.step(1)), this.scrub, this.count, speed);
  }

  help() {
    return make("p", { class: "help" }, this.view.help());
  }

  listen() {
    const { stage, root } = this;
    // A page that is one film takes keys wherever they are pressed; a film among others where it has the focus.
    const alone = document.body.classList.contains("film");
    (alone ? document : root).addEventListener("keydown", (event) => this.key(event));
    new ResizeObserver(() => this.resize()).observe(stage);
    const fingers = new Map();
    const spread = () => {
      const [a, b] = [...fingers.values()];
      return b ? { x: (a[0] + b[0]) / 2, y: (a[1] + b[1]) / 2, far: Math.hypot(a[0] - b[0], a[1] - b[1]) } : null;
    };
    stage.addEventListener("pointerdown", (event) => {
      stage.setPointerCapture(event.pointerId);
      fingers.set(event.pointerId, [event.clientX, event.clientY]);
    });
    stage.addEventListener("pointermove", (event) => {
      const last = fingers.get(event.pointerId);
      if (!last) return;
      const before = spread();
      fingers.set(event.pointerId, [event.clientX, event.clientY]);
      const [dx, dy] = [event.clientX - last[0], event.clientY - last[1]];
      const after = spread();
      const { camera } = this.view;
      // Two fingers pinch and move, one finger or a mouse turns.
      if (after) {
        camera.move(after.x - before.x, after.y - before.y);
        camera.zoomBy(after.far / Math.max(1, before.far), ...this.fromMiddle(after.x, after.y));
      } else if (event.shiftKey || event.buttons === 4) camera.move(dx, dy);
      else camera.turn(dx, dy);
      this.redraw();
    });
    for (const end of ["pointerup", "pointercancel"]) stage.addEventListener(end, (event) => fingers.delete(event.pointerId));
    stage.addEventListener("wheel", (event) => {
      event.preventDefault();
      this.view.camera.zoomBy(Math.exp(-0.0015 * event.deltaY), ...this.fromMiddle(event.clientX, event.clientY));
      this.redraw();
    }, { passive: false });
    stage.addEventListener("dblclick", () => { this.view.camera.reset(); this.redraw(); });
  }

  fromMiddle(x, y) {
    const { left, top, width, height } = this.stage.getBoundingClientRect();
    return [x - left - width / 2, height / 2 - (y - top)];
  }

  key(event) {
    const inField = event.target.matches("select, input, button");
    const turn = (dx, dy) => { this.view.camera.turn(dx, dy); this.redraw(); };
    const zoom = (factor) => { this.view.camera.zoomBy(factor); this.redraw(); };
    const actions = {
      " ": () => this.toggle(),
      ArrowRight: () => (event.shiftKey ? turn(30, 0) : this.step(1)),
      ArrowLeft: () => (event.shiftKey ? turn(-30, 0) : this.step(-1)),
      ArrowUp: () => turn(0, -15),
      ArrowDown: () => turn(0, 15),
      Home: () => this.step(-Infinity),
      End: () => this.step(Infinity),
      "+": () => zoom(1.2),
      "-": () => zoom(1 / 1.2),
    };
    const action = actions[event.key];
    // Fields and buttons keep the keys that mean something to them.
    const taken = inField && (event.target.matches("select") || (event.key === " " && event.target.matches("button")));
    if (!action || taken || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    action();
  }

  /** Changes some of what is shown. */
  choose(look) {
    Object.assign(this.view.options, look);
    for (const [key, select] of Object.entries(this.choices)) select.value = String(this.view.options[key]);
    const presets = Object.values(this.view.presets());
    this.presets.forEach((button, k) => {
      const on = Object.entries(presets[k]).every(([key, value]) => String(this.view.options[key]) === String(value));
      button.setAttribute("aria-pressed", on);
    });
    this.redraw();
  }

  step(by) {
    this.pause();
    this.show(Math.max(0, Math.min(this.meta.frames.length - 1, this.frame + by)));
  }

  toggle() {
    if (this.playing) this.pause();
    else {
      if (this.frame === this.meta.frames.length - 1) this.frame = 0;
      this.playing = true;
      this.play.textContent = "❚❚";
      [this.last, this.owed] = [performance.now(), 0];
      requestAnimationFrame((now) => this.tick(now));
    }
  }

  pause() {
    this.playing = false;
    this.play.textContent = "▶";
    this.redraw();
  }

  tick(now) {
    if (!this.playing) return;
    this.owed += (Math.max(0, now - this.last) * this.rate) / 1000;
    this.last = now;
    const whole = Math.floor(this.owed);
    if (whole > 0) {
      this.owed -= whole;
      const last = this.meta.frames.length - 1;
      this.show(Math.min(last, this.frame + whole));
      if (this.frame === last) this.pause();
    }
    requestAnimationFrame((next) => this.tick(next));
  }

  /** Shows a frame at once. */
  show(frame) {
    this.frame = frame;
    this.scrub.value = frame;
    this.count.textContent = `${frame + 1} / ${this.meta.frames.length}`;
    this.draw(1);
    this.refine();
  }

  /** Draws again before the next frame of the screen. */
  redraw() {
    if (this.waits) return;
    this.waits = true;
    requestAnimationFrame(() => {
      this.waits = false;
      this.show(this.frame);
    });
  }

  /** At rest the picture is drawn finer, which smooths its edges. */
  refine() {
    clearTimeout(this.rest);
    if (!this.playing) this.rest = setTimeout(() => this.draw(2), 250);
  }

  resize() {
    const { clientWidth, clientHeight } = this.stage;
    if (clientWidth > 0 && clientHeight > 0) this.redraw();
  }

  draw(fine) {
    const { stage, canvas, ink, view } = this;
    const [width, height] = [stage.clientWidth, stage.clientHeight];
    const ratio = Math.min(3, (window.devicePixelRatio || 1) * fine);
    const sharp = Math.max(1, window.devicePixelRatio || 1);
    for (const [sheet, scale] of [[canvas, ratio], [ink, sharp]]) {
      const [w, h] = [Math.round(width * scale), Math.round(height * scale)];
      if (sheet.width !== w) sheet.width = w;
      if (sheet.height !== h) sheet.height = h;
    }
    view.draw(this.frame);
    const context = ink.getContext("2d");
    context.setTransform(sharp, 0, 0, sharp, 0, 0);
    view.ink(context, this.frame, [width, height]);
    this.drawBelow(sharp);
    stage.setAttribute("aria-label", `${this.meta.title}: ${view.readout(this.frame).join(", ")}`);
  }

  /** On a narrow page readout and legends stand below the picture, not on it. */
  drawBelow(scale) {
    const { stage, below, view, frame } = this;
    const width = stage.clientWidth;
    const narrow = width < NARROW;
    below.hidden = !narrow;
    if (!narrow) return 0;
    const height = heightBelow(view, frame);
    below.style.height = `${height}px`;
    const [w, h] = [Math.round(width * scale), Math.round(height * scale)];
    if (below.width !== w) below.width = w;
    if (below.height !== h) below.height = h;
    const context = below.getContext("2d");
    context.setTransform(scale, 0, 0, scale, 0, 0);
    drawBelow(context, view, frame, [width, height]);
    return h;
  }

  /** The picture with its legend, twice as fine as on the screen. */
  picture() {
    const { stage, canvas, below, view } = this;
    this.draw(2);
    const scale = canvas.width / stage.clientWidth;
    const more = this.drawBelow(scale);
    const sheet = make("canvas", { width: canvas.width, height: canvas.height + more });
    const context = sheet.getContext("2d");
    context.fillStyle = "#fff";
    context.fillRect(0, 0, sheet.width, sheet.height);
    context.drawImage(canvas, 0, 0);
    if (more > 0) context.drawImage(below, 0, canvas.height);
    const over = make("canvas", { width: canvas.width, height: canvas.height });
    const ink = over.getContext("2d");
    ink.setTransform(scale, 0, 0, scale, 0, 0);
    view.ink(ink, this.frame, [stage.clientWidth, stage.clientHeight]);
    context.drawImage(over, 0, 0);
    return sheet;
  }

  save() {
    const step = this.meta.frames[this.frame].step ?? this.frame;
    const link = make("a", { href: this.picture().toDataURL("image/png"), download: `${this.meta.body}-${step}.png` });
    link.click();
  }
}

/** Starts the player of an element that holds the film's data. */
async function start(root) {
  try {
    const meta = JSON.parse(root.querySelector(".meta").textContent);
    const data = root.querySelector(".data");
    const film = data ? await readFilm(meta, data.textContent.trim()) : null;
    root.player = new Player(root, meta, (canvas) => (film ? new SolidView(film, canvas) : new PlaneView(meta, canvas)));
    root.dataset.state = "ready";
  } catch (error) {
    root.dataset.state = "failed";
    root.replaceChildren(make("p", { class: "failed", role: "alert" }, `The film cannot be shown: ${error.message}`));
    throw error;
  }
}

for (const root of document.querySelectorAll(".tribos-player")) start(root);
