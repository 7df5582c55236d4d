// A body that slides in the plane: the whole path, and the body close up, followed.

const VELOCITY = "#1b7f4d";
const FORCE = "#a3246c";
const TORQUE = "#7a5c00";

class PlaneView {
  constructor(meta, canvas) {
    Object.assign(this, { meta, canvas, options: {} });
    this.context = canvas.getContext("2d");
    this.camera = new PlaneCamera();
  }

  presets() {
    return {};
  }

  choices() {
    return [];
  }

  help() {
    return "Above the path, below the body from above; its line shows how it turns, the straight arrows how fast it slides and the force of friction on it, the bent arrow the torque. Wheel or pinch to zoom. Space plays, arrow keys step, home and end.";
  }

  draw(frame) {
    const { canvas, context: pen } = this;
    const ratio = canvas.width / Math.max(1, canvas.clientWidth);
    const [width, height] = [canvas.width / ratio, canvas.height / ratio];
    pen.setTransform(ratio, 0, 0, ratio, 0, 0);
    pen.fillStyle = "#fff";
    pen.fillRect(0, 0, width, height);
    const split = Math.round(0.42 * height);
    this.path(pen, frame, [16, 12, width - 16, split - 12]);
    this.closeUp(pen, frame, [0, split, width, height]);
  }

  at(frame) {
    const [time, x, y, angle, speed, spin, vx, vy, fx, fy, torque] = this.meta.frames[frame].row;
    return { time, x, y, angle, speed, spin, vx, vy, fx, fy, torque, force: Math.hypot(fx, fy) };
  }

  /** The largest value of the film. */
  largest(key) {
    this.most ??= {};
    this.most[key] ??= this.meta.frames.reduce((most, _, k) => Math.max(most, Math.abs(this.at(k)[key])), 0);
    return this.most[key];
  }

  /** The whole path with the body's place on it; the scales of both axes may differ. */
  path(pen, frame, [left, top, right, bottom]) {
    const { meta } = this;
    const points = meta.frames.map((_, k) => this.at(k));
    const span = (key) => {
      const values = points.map((point) => point[key]);
      return [Math.min(...values), Math.max(...values)];
    };
    const [[x0, x1], [y0, y1]] = [span("x"), span("y")];
    const [wide, high] = [right - left - 80, bottom - top - 52];
    const fit = Math.min(wide / (x1 - x0 || 1), y1 > y0 ? high / (y1 - y0) : Infinity);
    const equal = (y1 - y0) * fit > 0.25 * high || y1 - y0 < 1e-9 * (x1 - x0);
    const [sx, sy] = equal ? [fit, fit] : [wide / (x1 - x0 || 1), high / (y1 - y0)];
    const place = ({ x, y }) => [left + 60 + (x - x0) * sx, (top + bottom) / 2 + 4 - (y - (y0 + y1) / 2) * sy];
    pen.lineWidth = 2;
    for (const [from, to, color] of [[0, points.length - 1, "#c9cfd5"], [0, frame, "#0072b2"]]) {
      pen.strokeStyle = color;
      pen.beginPath();
      points.slice(from, to + 1).forEach((point) => pen.lineTo(...place(point)));
      pen.stroke();
    }
    font(pen, 12);
    pen.textBaseline = "middle";
    this.ends(pen, points, place, meta.units.length, equal);
    const [x, y] = place(points[frame]);
    pen.fillStyle = "#d55e00";
    pen.beginPath();
    pen.arc(x, y, 5, 0, 7);
    pen.fill();
  }

  /** Where the path begins and ends; the text stands away from the path. */
  ends(pen, points, place, unit, equal) {
    pen.fillStyle = SOFT;
    const last = points.length - 1;
    const middle = points[last >> 1];
    for (const [k, align] of [[0, "left"], [last, "right"]]) {
      const point = points[k];
      const [x, y] = place(point);
      pen.beginPath();
      pen.arc(x, y, 3, 0, 7);
      pen.fill();
      pen.textAlign = align;
      pen.fillText(`${digits(point.x)}, ${digits(point.y)} ${unit}`, x + 6, y + (point.y > middle.y ? -16 : 16));
    }
    if (equal) return;
    // In the corner that the path leaves free.
    const rises = points[last].y > points[0].y;
    pen.textAlign = "left";
    pen.fillText("scales differ", place(points[0])[0], place(points[last])[1] + (rises ? -16 : 16));
  }

  /** The body over a floor that moves past. */
  closeUp(pen, frame, [left, top, right, bottom]) {
    const { meta, camera } = this;
    const here = this.at(frame);
    const [x, y] = [(left + right) / 2, (top + bottom) / 2];
    // The velocity at the launch is as long as a diameter and has room on a narrow page too.
    const radius = Math.min(0.3 * (bottom - top), 0.22 * (right - left)) * camera.zoom;
    const scale = radius / meta.radius;
    pen.save();
    pen.beginPath();
    pen.rect(left, top, right - left, bottom - top);
    pen.clip();
    pen.fillStyle = "#f3f5f6";
    pen.fillRect(left, top, right - left, bottom - top);
    this.floor(pen, here, [left, top, right, bottom], [x, y], scale);
    const before = meta.frames.slice(0, frame + 1).map((_, k) => this.at(k));
    pen.strokeStyle = "#0072b2";
    pen.lineWidth = 2;
    pen.beginPath();
    for (const point of before) pen.lineTo(x + (point.x - here.x) * scale, y - (point.y - here.y) * scale);
    pen.stroke();
    this.body(pen, here, [x, y], radius);
    this.arrow(pen, VELOCITY, [x, y], [here.vx, here.vy], (2 * radius) / (this.at(0).speed || 1));
    this.arrow(pen, FORCE, [x, y], [here.fx, here.fy], (1.4 * radius) / (this.largest("force") || 1));
    this.twist(pen, here, [x, y], radius);
    pen.restore();
  }

  /** Lines of a floor, a radius apart. */
  floor(pen, here, [left, top, right, bottom], [x, y], scale) {
    const apart = this.meta.radius;
    pen.strokeStyle = "#dde2e6";
    pen.lineWidth = 1;
    pen.beginPath();
    const lines = (middle, from, to, draw) => {
      for (let k = Math.ceil(middle + from / scale / apart); k <= middle + to / scale / apart; k += 1) draw((k - middle) * apart * scale);
    };
    lines(here.x / apart, left - x, right - x, (dx) => { pen.moveTo(x + dx, top); pen.lineTo(x + dx, bottom); });
    lines(here.y / apart, y - bottom, y - top, (dy) => { pen.moveTo(left, y - dy); pen.lineTo(right, y - dy); });
    pen.stroke();
  }

  body(pen, { angle }, [x, y], radius) {
    const ring = this.meta.outline === "ring";
    pen.fillStyle = ring ? "rgba(255,255,255,0.6)" : "rgba(190,205,222,0.92)";
    pen.strokeStyle = "#22405f";
    pen.lineWidth = ring ? Math.max(5, 0.12 * radius) : 3;
    pen.beginPath();
    if (this.meta.corners?.length) this.corners(pen, angle, [x, y], radius / this.meta.radius);
    else pen.arc(x, y, radius - pen.lineWidth / 2, 0, 7);
    pen.fill("evenodd");
    pen.stroke();
    const tip = [x + Math.cos(angle) * radius * 0.92, y - Math.sin(angle) * radius * 0.92];
    pen.strokeStyle = "#d55e00";
    pen.lineWidth = 4;
    pen.beginPath();
    pen.moveTo(x, y);
    pen.lineTo(...tip);
    pen.stroke();
    pen.fillStyle = "#d55e00";
    pen.beginPath();
    pen.arc(...tip, 7, 0, 7);
    pen.fill();
  }

  /** The outline of a body that is not round. */
  corners(pen, angle, [x, y], scale) {
    const [sin, cos] = [Math.sin(angle), Math.cos(angle)];
    for (const loop of this.meta.corners) {
      loop.forEach(([along, left], k) => {
        const place = [x + scale * (cos * along - sin * left), y - scale * (sin * along + cos * left)];
        if (k) pen.lineTo(...place);
        else pen.moveTo(...place);
      });
      pen.closePath();
    }
  }

  /** A vector of the plane from the centre: the velocity as long as a diameter at the launch, the force 1.4 radii where it is largest. */
  arrow(pen, color, [x, y], [along, left], scale) {
    const size = Math.hypot(along, left);
    const length = size * scale;
    if (!(length > 4)) return;
    const [ux, uy] = [along / size, -left / size];
    const [tx, ty] = [x + ux * length, y + uy * length];
    pen.strokeStyle = pen.fillStyle = color;
    pen.lineWidth = 3;
    pen.beginPath();
    pen.moveTo(x, y);
    pen.lineTo(tx, ty);
    pen.stroke();
    this.head(pen, [tx, ty], [ux, uy]);
  }

  head(pen, [x, y], [ux, uy]) {
    pen.beginPath();
    for (const [along, aside] of [[12, 0], [-2, 6], [-2, -6]]) pen.lineTo(x + ux * along - uy * aside, y + uy * along + ux * aside);
    pen.fill();
  }

  /** The torque, an arc about the body from its lowest point, half a turn where it is largest. */
  twist(pen, { torque }, [x, y], radius) {
    const angle = (Math.PI * torque) / (this.largest("torque") || 1);
    const reach = 1.13 * radius;
    if (!(Math.abs(angle) * reach > 4)) return;
    const begin = Math.PI / 2;
    // Counterclockwise on the floor is against the angles of the screen.
    const end = begin - angle;
    pen.strokeStyle = pen.fillStyle = TORQUE;
    pen.lineWidth = 3;
    pen.beginPath();
    pen.arc(x, y, reach, begin, end, angle > 0);
    pen.stroke();
    const turn = Math.sign(angle);
    this.head(pen, [x + reach * Math.cos(end), y + reach * Math.sin(end)], [turn * Math.sin(end), -turn * Math.cos(end)]);
  }

  readout(frame) {
    const { units } = this.meta;
    const { time, x, y, angle, speed, spin, force, torque } = this.at(frame);
    const lines = [`time ${digits(time)} ${units.time}`, `forward ${digits(x)} ${units.length}`, `sliding ${digits(speed)} ${units.speed}`, `spinning ${digits(spin)} ${units.spin}`, `turned ${((180 * angle) / Math.PI).toFixed(1)}°`, `force ${digits(force)} ${units.force}`, `torque ${digits(torque)} ${units.torque}`];
    if (this.meta.curves) lines.splice(2, 0, `to the left ${digits(y)} ${units.length}`);
    return lines;
  }

  legends() {
    const kinds = [["velocity", VELOCITY], ["force on the body", FORCE], ["torque on the body", TORQUE], ["mark on the body", "#d55e00"], ["path of the centre", "#0072b2"]];
    return [{ kinds: kinds.map(([name, color]) => ({ name, color })), label: "close-up from above", marked: [] }];
  }

  ink(pen, frame, [width, height]) {
    pen.clearRect(0, 0, width, height);
    pen.textBaseline = "middle";
    if (width < NARROW) return;
    const top = Math.round(0.42 * height) + 12;
    panel(pen, this.readout(frame), 12, top);
    drawLegends(pen, this.legends(), [width - LEGEND - 12, top]);
    font(pen, 12);
    pen.fillStyle = SOFT;
    pen.textAlign = "right";
    pen.fillText(`floor lines ${digits(this.meta.radius)} ${this.meta.units.length} apart`, width - 14, height - 14);
  }
}

/** The close-up can be zoomed only. */
class PlaneCamera {
  constructor() {
    this.reset();
  }
  reset() {
    this.zoom = 1;
  }
  turn() {}
  move() {}
  zoomBy(factor) {
    this.zoom = Math.max(0.1, Math.min(3, this.zoom * factor));
  }
}
