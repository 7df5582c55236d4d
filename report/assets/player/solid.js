// A frame of a film in space: balls, rods for forces, plates and edges of the box.

const PUSH = bytesOf("#d5301a");
const PULL = bytesOf("#1a66d5");
/** Marked atoms, where parts have their colours and where a scale has. */
const MARKS = { part: "#ffd21f", scale: "#e0281e" };
/** Half the thickness of the rod of a full force, in radii of the largest ball, and of the largest. */
const FULL_ROD = 0.3;
const LARGEST_ROD = 1.5;
/** Thinner rods are left out. */
const UNSEEN_ROD = 0.012;

const EDGE = [150, 150, 150];
/** Pistons and the plates of hoppers and drums. */
const GLASS = [105, 118, 145, 120];
/** Number of the piston as a partner; the substrate has the one above. */
const PISTON = 0xfffffffe;

/** Rods gathered for one drawing. */
class Pile {
  constructor(most) {
    [this.from, this.to] = [new Float32Array(4 * most), new Float32Array(4 * most)];
    this.color = new Uint8Array(4 * most);
    this.count = 0;
  }

  add(x, y, z, u, v, w, thick, color, bands) {
    const at = 4 * this.count;
    const { from, to } = this;
    [from[at], from[at + 1], from[at + 2], from[at + 3]] = [x, y, z, thick];
    [to[at], to[at + 1], to[at + 2]] = [u, v, w];
    for (let k = 0; k < 3; k += 1) this.color[at + k] = color[k];
    this.color[at + 3] = bands;
    this.count += 1;
  }
}

class SolidView {
  constructor(film, canvas) {
    Object.assign(this, { film, canvas, ...SolidView.start(canvas) });
    this.meta = film.meta;
    this.paints = paintsOf(film);
    this.whole = this.bounds();
    this.camera = new Camera(this.whole);
    this.largest = film.radii.reduce((most, radius) => Math.max(most, radius), 0);
    this.full = quantile(film.forces.map(Math.abs).filter((force) => force > 0), 0.98) || 1;
    this.options = { color: Object.keys(this.paints)[0], balls: "solid", forces: "off", thickness: 1, fit: "film" };
    const most = film.starts.reduce((largest, start, k) => Math.max(largest, start - (film.starts[k - 1] || 0)), 0);
    this.pile = new Pile(2 * most + 4);
    this.bytes = new Uint8Array(4 * film.n).fill(255);
    for (const kind of [this.solid, this.glass]) kind.set("radius", this.radii());
  }

  static start(canvas) {
    const gl = canvas.getContext("webgl2", { antialias: false, alpha: false, preserveDrawingBuffer: true });
    if (!gl) throw new Error("this page needs WebGL 2, which this browser does not offer");
    return { gl, ...shapes(gl) };
  }

  /** The box of all frames and of the balls in it. */
  bounds() {
    const [low, high] = this.meta.box;
    const room = this.film.radii[0] || 0;
    return [low.map((x) => x - room), high.map((x) => x + room)];
  }

  /** What the camera fits into the picture: the box of the whole film, or of this frame. */
  frameBox(frame) {
    const [low, high] = this.whole;
    const { height } = this.meta.frames[frame];
    if (this.options.fit !== "frame" || this.meta.body !== "powder") return this.whole;
    return [low, [high[0], high[1], height + this.largest]];
  }

  /** Marked balls are a little larger. */
  radii() {
    const radii = this.film.radii.slice();
    for (const body of this.meta.marked) radii[body] *= 1.12;
    return radii;
  }

  mark() {
    return this.options.color === "part" ? MARKS.part : MARKS.scale;
  }

  /** The presets of a film, the first for the start. */
  presets() {
    const look = (color, balls, forces, fit = "film") => ({ color, balls, forces, fit });
    if (this.meta.body === "tip") {
      return { "Parts and marked atoms": look("part", "solid", "off"), "Layers": look("layer", "solid", "off"), "Speeds": look("speed", "solid", "off") };
    }
    const all = { "Spheres": look("layer", "solid", "off") };
    if (this.paints.force) {
      all["Forces"] = look("layer", "glass", "on", "frame");
      all["Forces and dots"] = look("force", "dots", "on", "frame");
      all["What contacts do"] = look("mode", "solid", "off", "frame");
    }
    return all;
  }

  /** What all shaders know: the directions and the scale of the picture. */
  sight() {
    const { camera, canvas } = this;
    const axes = camera.axes();
    const scale = camera.scale(canvas.width, canvas.height);
    const ratio = canvas.width / Math.max(1, canvas.clientWidth || canvas.width);
    const depth = camera.depth();
    const near = camera.box[0].reduce((sum, low, k) => sum + 0.5 * (camera.box[1][k] - low) * Math.abs(axes.toward[k]), 0) / depth;
    const [x, y] = [2 / canvas.width, 2 / canvas.height];
    return {
      ...axes,
      frame: [scale * x, scale * y, camera.shift[0] * ratio * x, camera.shift[1] * ratio * y],
      depth,
      hazeNear: -near,
      hazeFar: near,
      pixel: 1 / scale,
    };
  }

  draw(frame) {
    const { gl, canvas, options } = this;
    this.camera.box = this.frameBox(frame);
    const sight = this.sight();
    gl.viewport(0, 0, canvas.width, canvas.height);
    gl.clearColor(1, 1, 1, 1);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    gl.enable(gl.DEPTH_TEST);
    gl.disable(gl.BLEND);
    if (this.meta.floor) this.drawPlates([this.substrate()], sight);
    this.drawRods(frame, sight);
    if (options.balls === "solid" || options.balls === "dots") {
      this.drawBalls(this.solid, frame, sight, options.balls === "dots" ? 0.28 : 1);
    }
    gl.enable(gl.BLEND);
    gl.blendFunc(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA);
    gl.depthMask(false);
    if (options.balls === "glass") this.drawBalls(this.glass, frame, sight, 1);
    const glass = (this.meta.plates || []).map(([from, first, second]) => ({ from, first, second, color: GLASS }));
    if (this.meta.lid) glass.push(this.piston(frame));
    if (glass.length) this.drawPlates(glass, sight);
    gl.depthMask(true);
  }

  drawBalls(kind, frame, sight, size) {
    const { film, meta } = this;
    const { n } = film;
    const color = this.paints[this.options.color].colors(frame);
    const { bytes } = this;
    for (let k = 0; k < n; k += 1) {
      const rgb = color(k);
      for (let part = 0; part < 3; part += 1) bytes[4 * k + part] = rgb[part];
    }
    const mark = bytesOf(this.mark());
    for (const body of meta.marked) bytes.set(mark, 4 * body);
    kind.set("place", film.places.subarray(3 * n * frame, 3 * n * (frame + 1)));
    kind.set("color", bytes);
    kind.draw(n, sight, { low: meta.box[0], high: meta.box[1], size });
  }

  drawRods(frame, sight) {
    const rods = this.pile;
    rods.count = 0;
    if (this.meta.floor) this.edges(frame, sight, rods);
    if (this.options.forces === "on") this.forces(frame, rods);
    for (const [name, width] of [["from", 4], ["to", 4], ["color", 4]]) this.rods.set(name, rods[name].subarray(0, width * rods.count));
    this.rods.draw(rods.count, sight, { band: 0.8 * this.largest });
  }

  /** Low and high corner of the box: its sides, of grains that of the whole film; up to the lid. */
  hall(frame) {
    const { meta } = this;
    const top = meta.lid ? meta.frames[frame].height : meta.box[1][2];
    if (meta.body === "powder") return [[0, 0, 0], [...meta.periods, top]];
    return [[meta.box[0][0], meta.box[0][1], 0], [meta.box[1][0], meta.box[1][1], top]];
  }

  /** The upright edges of the box. */
  edges(frame, sight, rods) {
    const [[x, y, z], [u, v, top]] = this.hall(frame);
    const thick = 0.7 * sight.pixel;
    for (const [a, b] of [[x, y], [u, y], [x, v], [u, v]]) rods.add(a, b, z, a, b, top, thick, EDGE, 255);
  }

  /** Rods of normal forces; one across a border of the periodic box is two halves. */
  forces(frame, rods) {
    const { film, meta, largest } = this;
    const { n, a, b, radii, places } = film;
    const unit = (FULL_ROD * largest * this.options.thickness) / this.full;
    const [low, high] = meta.box;
    const step = low.map((x, axis) => (high[axis] - x) / 65535);
    const [sideX, sideY] = meta.periods;
    const top = meta.frames[frame].height;
    const at = (particle, axis) => low[axis] + step[axis] * places[3 * (frame * n + particle) + axis];
    for (let k = film.starts[frame]; k < film.starts[frame + 1]; k += 1) {
      const force = film.forces[k];
      const thick = Math.min(unit * Math.abs(force), LARGEST_ROD * FULL_ROD * largest);
      if (!(thick >= UNSEEN_ROD * largest)) continue;
      const [color, bands] = force > 0 ? [PUSH, 255] : [PULL, 128];
      const [x, y, z] = [at(a[k], 0), at(a[k], 1), at(a[k], 2)];
      if (b[k] >= n) {
        const lid = meta.lid && b[k] === PISTON;
        if (lid || (meta.floor && b[k] === PISTON + 1)) rods.add(x, y, z, x, y, lid ? top : 0, thick, color, bands);
        continue;
      }
      const [u, v, w] = [at(b[k], 0), at(b[k], 1), at(b[k], 2)];
      const dx = u - x - sideX * Math.round((u - x) / sideX);
      const dy = v - y - sideY * Math.round((v - y) / sideY);
      if (Math.abs(u - x - dx) + Math.abs(v - y - dy) < 0.1 * largest) {
        rods.add(x, y, z, u, v, w, thick, color, bands);
      } else {
        const share = radii[a[k]] / (radii[a[k]] + radii[b[k]]);
        const rest = share - 1;
        rods.add(x, y, z, x + share * dx, y + share * dy, z + share * (w - z), thick, color, bands);
        rods.add(u + rest * dx, v + rest * dy, w + rest * (w - z), u, v, w, thick, color, bands);
      }
    }
  }

  drawPlates(plates, sight) {
    const all = (name) => new Float32Array(plates.flatMap((plate) => [...plate[name], 0]));
    for (const name of ["from", "first", "second"]) this.plates.set(name, all(name));
    this.plates.set("color", new Uint8Array(plates.flatMap((plate) => plate.color)));
    this.plates.draw(plates.length, sight);
  }

  /** A plate over the whole box at a height. */
  level([low, high], z, color) {
    return { from: [low[0], low[1], z], first: [high[0] - low[0], 0, 0], second: [0, high[1] - low[1], 0], color };
  }

  substrate() {
    return this.level(this.hall(0), 0, [196, 198, 206, 255]);
  }

  piston(frame) {
    return this.level(this.hall(frame), this.meta.frames[frame].height, GLASS);
  }

  /** Lines of text about a frame. */
  readout(frame) {
    const { meta } = this;
    const { step, time, height, measure } = meta.frames[frame];
    const lines = [`step ${step}`, `time ${digits(time)} ${meta.units.time}`];
    if (meta.body === "gas") {
      if (measure !== null) lines.push(`temperature ${digits(measure)} T₀`);
      return lines;
    }
    if (measure !== null) lines.push(meta.body === "tip" ? `angle ${measure.toFixed(2)}°` : `porosity ${(100 * measure).toFixed(2)} %`);
    const what = { tip: "driven layers", powder: "piston" }[meta.body] || (meta.lid ? "plate" : "level bed");
    if (height !== null) lines.push(`${what} at ${digits(height)} ${meta.units.length}`);
    return lines;
  }

  /** What the colours and the rods mean. */
  legends() {
    const { options, paints, meta } = this;
    const legends = [];
    if (options.balls !== "none") {
      const marked = meta.marked.length ? [{ name: "marked atoms", color: this.mark() }] : [];
      legends.push({ ...paints[options.color], marked, ramp: meta.ramp });
    }
    if (options.forces === "on") legends.push({ rods: true, full: this.full, thickness: this.options.thickness, radius: FULL_ROD * this.largest, unit: meta.units.force });
    return legends;
  }
}

/** "1.6·10⁻⁵": three digits, fewer where they are zeros. */
function scientific(value) {
  const [digits, power] = value.toExponential(2).split("e");
  const raised = [...power.replace("+", "")].map((c) => (c === "-" ? "⁻" : "⁰¹²³⁴⁵⁶⁷⁸⁹"[c]));
  return `${Number(digits)}·10${raised.join("")}`;
}

/** Four significant digits. */
function digits(value) {
  const size = Math.abs(value);
  if (size !== 0 && (size < 1e-3 || size >= 1e6)) return scientific(value);
  return String(Number(value.toPrecision(4)));
}

Object.assign(SolidView.prototype, {
  /** What can be chosen: name of the option, label, values with their names. */
  choices() {
    const colors = Object.entries(this.paints).map(([name, { label }]) => [name, label]);
    const choices = [["color", "Colour", colors]];
    const balls = [["solid", "solid"], ["glass", "glass"], ["dots", "dots"], ["none", "none"]];
    choices.push(["balls", this.meta.body === "tip" ? "Atoms" : "Spheres", balls]);
    if (this.paints.force) choices.push(["forces", "Forces", [["off", "off"], ["on", "on"]]], ["thickness", "Rods", [[0.5, "thin"], [1, "usual"], [2, "thick"]]]);
    if (this.meta.body === "powder") choices.push(["fit", "Fit", [["film", "whole film"], ["frame", "this frame"]]]);
    return choices;
  },

  ink(context, frame, size) {
    drawInk(context, this, frame, size);
  },

  help() {
    return "Drag to turn, wheel or pinch to zoom, shift-drag or two fingers to move. Space plays, arrow keys step, up and down tilt, + and − zoom, home and end.";
  },
});
