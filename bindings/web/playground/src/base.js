// The base of the body, magnified, with friction at each spot: why spin eases the slide.

import { HOLES, outline } from "./bodies.js";
import { arrow, palette, polyline } from "./canvas.js";
import { t } from "./language.js";
import { at, frictionAt } from "./race.js";

/** Room for half of the name, in pixels. */
const HALF_NAME = 68;
const SPACING = 0.38;
const RIM = 16;
/** Length of the arrow of a spot under the mean pressure, and of the largest force, in radii. */
const SPOT = 0.26;
const FORCE = 1;
/** Most that pressure or speed lengthen an arrow. */
const LONGEST = 1.7;
/** Pressure over mean pressure at a distance from the middle, in radii. */
const PRESSURES = {
  uniform: () => 1,
  hertz: (r) => 1.5 * Math.sqrt(Math.max(1 - r * r, 0)),
  paraboloid: (r) => 2 * (1 - r * r),
  punch: (r) => 0.5 / Math.sqrt(Math.max(1 - r * r, 1e-6)),
};

/** Spots of the base in radii, each with its pressure. */
function spotsOf(setup) {
  if (setup.shape === "ring") {
    return Array.from({ length: RIM }, (_, index) => {
      const angle = (2 * Math.PI * index) / RIM;
      return [Math.cos(angle), Math.sin(angle), 1];
    });
  }
  const hole = HOLES[setup.shape] ?? 0;
  const corners = outline(setup)?.map(([x, y]) => [x / setup.radius, y / setup.radius]);
  const pressure = PRESSURES[setup.shape === "puck" ? setup.pressure : "uniform"];
  const spots = [];
  for (let row = -3; row <= 3; row += 1) {
    for (let column = -3; column <= 3; column += 1) {
      const [x, y] = [SPACING * (column + (row % 2) / 2), SPACING * row * 0.87];
      const r = Math.hypot(x, y);
      if (corners ? isInside(corners, [x, y]) : r < 0.97 && r >= hole) spots.push([x, y, pressure(r)]);
    }
  }
  return spots;
}

/** Whether a point is in a polygon: a ray from it crosses the outline an odd number of times. */
function isInside(corners, [x, y]) {
  return corners.reduce((inside, [ax, ay], index) => {
    const [bx, by] = corners[(index + 1) % corners.length];
    return ay > y !== by > y && x < ax + ((y - ay) * (bx - ax)) / (by - ay) ? !inside : inside;
  }, false);
}

/** Half width, and heights above and below the middle, of the box about a base of a radius in pixels. */
const boxOf = (size) => ({
  half: Math.max(1.45 * size, HALF_NAME),
  above: 1.3 * size,
  below: 1.3 * size + 22,
});

/** Radius of what is seen about a place, in pixels. */
const ABOUT = 24;

/** Where the base is drawn: at the right, below if none of some places is covered there, or else above. */
export function placeOfBase(width, height, size, places) {
  const { half, above, below } = boxOf(size);
  const x = width - half - 4;
  const covers = (y) =>
    places.some(([a, b]) => Math.abs(a - x) < half + ABOUT && b > y - above - ABOUT && b < y + below + ABOUT);
  const candidates = [height - below, above + 4];
  return [x, candidates.find((y) => !covers(y)) ?? candidates[0]];
}

/** Draws the base about a place with a radius in pixels; at rest as it was at the launch. */
export function drawBase(context, [x0, y0], size, { result, setup, time }) {
  const [exact] = result.runs;
  const isOver = time >= exact.rest.time;
  const motion = at(exact, isOver ? 0 : time);
  const { ink, soft, panel, exact: blue } = palette();
  context.fillStyle = panel;
  context.globalAlpha = 0.9;
  const { half, above, below } = boxOf(size);
  context.fillRect(x0 - half, y0 - above, 2 * half, above + below);
  context.globalAlpha = 1;
  const [c, s] = [Math.cos(motion.angle), Math.sin(motion.angle)];
  const turned = ([x, y]) => [c * x - s * y, s * x + c * y];
  const toScreen = ([x, y]) => [x0 + size * x, y0 - size * y];
  const rim = outline(setup)?.map(([x, y]) => [x / setup.radius, y / setup.radius]) ?? circle();
  polyline(context, rim.map(turned).map(toScreen), { color: blue, width: 1.5, isClosed: true });
  if (setup.shape === "annulus") {
    const inner = circle().map(([x, y]) => toScreen([HOLES.annulus * x, HOLES.annulus * y]));
    polyline(context, inner, { color: blue, width: 1.5, isClosed: true });
  }
  const rimSpeed = Math.hypot(motion.vx, motion.vy) + Math.abs(motion.spin) * setup.radius;
  for (const [a, b, pressure] of spotsOf(setup)) {
    const [x, y] = turned([a, b]);
    const [ux, uy] = [motion.vx - motion.spin * setup.radius * y, motion.vy + motion.spin * setup.radius * x];
    const speed = Math.hypot(ux, uy);
    if (speed === 0) continue;
    const length = (size * SPOT * Math.min(pressure * (speed / rimSpeed) ** setup.alpha, LONGEST)) / speed;
    arrow(context, toScreen([x, y]), [-length * ux, length * uy], blue, 1.5);
  }
  const load = result.body.load;
  const sliding = Math.abs(result.friction.wrench({ vx: rimSpeed, vy: 0, spin: 0 }, load).fx);
  const { fx, fy } = frictionAt(result.friction, motion, load, result.isRound);
  if (sliding > 0)
    arrow(context, [x0, y0], [(FORCE * size * fx) / sliding, (-FORCE * size * fy) / sliding], ink, 4);
  context.font = "12px system-ui, sans-serif";
  context.textAlign = "center";
  context.fillStyle = soft;
  context.fillText(t(isOver ? "baseLaunch" : "baseNow"), x0, y0 + 1.3 * size + 12);
}

const circle = () =>
  Array.from({ length: 60 }, (_, index) => [
    Math.cos((index * Math.PI) / 30),
    Math.sin((index * Math.PI) / 30),
  ]);
