// The picture of a throw: the field seen from above, and a lane for each model.

import { drawBase, placeOfBase } from "./base.js";
import { HOLES, outline } from "./bodies.js";
import { arrow, palette, polyline, turnArrow } from "./canvas.js";
import { digits, t } from "./language.js";
import { at, frictionAt, pathUntil } from "./race.js";

const LANE = 30;
const DASHES = { exact: [], ellipsoid: [9, 6], separate: [2, 6] };
/** Length of the arrow of the largest friction, in pixels, and turn of the one of the largest torque. */
const FORCE_ARROW = 64;
const TORQUE_ARROW = 4.2;
/** Least radius of a drawn body, in pixels. */
const LEAST = 7;
/** Largest drawn hole, in radii: a ring has some width to be seen. */
const LARGEST_HOLE = 0.75;
/** Part of the view beside the start. */
const BEHIND = 0.1;

/** Place and scale of the field on a canvas so that all given points are seen. */
export function fitted(width, height, view, points, margin) {
  const room = height - 3 * LANE - 10;
  let [left, right] = [-BEHIND * view, (1 - BEHIND) * view];
  let [low, high] = [-0.12 * view, 0.12 * view];
  for (const [x, y] of points) {
    left = Math.min(left, x - margin);
    right = Math.max(right, x + margin);
    low = Math.min(low, y - margin);
    high = Math.max(high, y + margin);
  }
  const scale = Math.min(width / (right - left), room / (high - low));
  const x0 = width / 2 - (scale * (left + right)) / 2;
  const y0 = room / 2 + (scale * (low + high)) / 2;
  const toScreen = ([x, y]) => [x0 + scale * x, y0 - scale * y];
  const toWorld = ([x, y]) => [(x - x0) / scale, (y0 - y) / scale];
  return { width, height, scale, room, toScreen, toWorld };
}

/** Everything: field, bodies at a time, target, aim, and lanes. */
export function drawStage(context, width, height, scene) {
  const { view, result, time, aim, isHidden } = scene;
  drawGrid(context, width, view);
  if (scene.target) drawTarget(context, scene);
  if (scene.answer) drawAnswer(context, scene);
  if (!isHidden) drawRuns(context, scene);
  const [exact] = result.runs;
  const pose = isHidden ? { x: 0, y: 0, angle: 0 } : at(exact, time);
  drawBody(context, scene, pose, palette().exact, true);
  if (aim) arrow(context, view.toScreen([0, 0]), aim, palette().ink, 4);
  else if (!isHidden) drawFriction(context, scene, pose);
  const size = width < 500 ? 34 : 52;
  if (!isHidden) drawBase(context, placeOfBase(width, view.room, size, endsOf(scene)), size, scene);
  context.clearRect(0, view.room + 1, width, height);
  drawLanes(context, width, view.room + 8, scene);
}

/** Places on the canvas that have to be seen: where bodies rest, and the target. */
function endsOf({ view, result, target }) {
  const ends = result.runs.map(({ rest }) => rest);
  return (target ? [...ends, target] : ends).map(({ x, y }) => view.toScreen([x, y]));
}

/** A line every round length, and the length. */
function drawGrid(context, width, { scale, room, toScreen, toWorld }) {
  const rough = 90 / scale;
  const power = 10 ** Math.floor(Math.log10(rough));
  const step = [1, 2, 5, 10].map((factor) => factor * power).find((length) => length >= rough);
  const [left, top] = toWorld([0, 0]);
  const [right, bottom] = toWorld([width, room]);
  const { line, soft } = palette();
  for (let x = Math.ceil(left / step) * step; x <= right; x += step) {
    const [at] = toScreen([x, 0]);
    polyline(
      context,
      [
        [at, 0],
        [at, room],
      ],
      { color: line, width: 1 },
    );
  }
  for (let y = Math.ceil(bottom / step) * step; y <= top; y += step) {
    const [, at] = toScreen([0, y]);
    polyline(
      context,
      [
        [0, at],
        [width, at],
      ],
      { color: line, width: 1 },
    );
  }
  const bar = [
    [12, room - 12],
    [12 + step * scale, room - 12],
  ];
  polyline(context, bar, { color: soft, width: 3 });
  const decimals = Math.max(0, -Math.floor(Math.log10(step)));
  write(context, `${digits(step, decimals)} m`, [12, room - 20], soft);
}

function write(context, text, [x, y], color, align = "left") {
  context.font = "13px system-ui, sans-serif";
  context.textAlign = align;
  context.fillStyle = color;
  context.fillText(text, x, y);
}

function drawRuns(context, scene) {
  const { view, result, time } = scene;
  for (const run of [...result.runs].reverse()) {
    const color = palette()[run.model];
    const points = pathUntil(run, time).map(view.toScreen);
    const width = run.model === "exact" ? 3 : 2.5;
    polyline(context, points, { color, width, dash: DASHES[run.model] });
    if (run.model !== "exact") drawBody(context, scene, at(run, time), color, false);
    if (time >= run.rest.time) drawRest(context, view.toScreen([run.rest.x, run.rest.y]), color);
  }
}

/** A cross where the body rests. */
function drawRest(context, [x, y], color) {
  for (const sign of [1, -1]) {
    polyline(
      context,
      [
        [x - 5, y - 5 * sign],
        [x + 5, y + 5 * sign],
      ],
      { color, width: 2.5 },
    );
  }
}

function drawBody(context, { view, setup }, { x, y, angle }, color, isFilled) {
  const center = view.toScreen([x, y]);
  const radius = Math.max(setup.radius * view.scale, LEAST);
  const corners = outline(setup);
  shape(context, center, radius, angle, corners && { corners, size: setup.radius }, HOLES[setup.shape]);
  if (isFilled) {
    context.globalAlpha = 0.22;
    context.fillStyle = color;
    context.fill("evenodd");
    context.globalAlpha = 1;
  }
  context.strokeStyle = color;
  context.lineWidth = isFilled ? 2.5 : 1.5;
  context.stroke();
  const tip = [center[0] + radius * Math.cos(angle), center[1] - radius * Math.sin(angle)];
  polyline(context, [center, tip], { color, width: isFilled ? 2.5 : 1.5 });
}

/** The outline of a body as the path of the context. */
function shape(context, [x, y], radius, angle, polygon, hole = 0) {
  context.beginPath();
  if (!polygon) {
    context.arc(x, y, radius, 0, 2 * Math.PI);
    const inner = radius * Math.min(hole, LARGEST_HOLE);
    if (inner > 0) {
      context.moveTo(x + inner, y);
      context.arc(x, y, inner, 0, 2 * Math.PI);
    }
    return;
  }
  const scale = radius / polygon.size;
  const [c, s] = [scale * Math.cos(angle), scale * Math.sin(angle)];
  for (const [a, b] of polygon.corners) context.lineTo(x + c * a - s * b, y - s * a - c * b);
  context.closePath();
}

/** Force and torque of friction on the body. */
function drawFriction(context, { view, result, setup, time }, pose) {
  const [exact] = result.runs;
  if (time >= exact.rest.time) return;
  const motion = at(exact, time);
  const load = result.body.load;
  const { fx, fy, torque } = frictionAt(result.friction, motion, load, result.isRound);
  const spinning = result.friction.wrench({ vx: 0, vy: 0, spin: 1 }, load);
  const sliding = result.friction.wrench({ vx: 1, vy: 0, spin: 0 }, load);
  const force = FORCE_ARROW / Math.abs(sliding.fx);
  const center = view.toScreen([pose.x, pose.y]);
  const { ink } = palette();
  arrow(context, center, [force * fx, -force * fy], ink, 4);
  const turn = (TORQUE_ARROW * torque) / Math.abs(spinning.torque);
  const radius = Math.max(setup.radius * view.scale, LEAST) + 9;
  turnArrow(context, center, radius, Math.PI / 2, turn, ink, 3);
}

function drawTarget(context, { view, target, setup }) {
  const center = view.toScreen([target.x, target.y]);
  const radius = Math.max(setup.radius * view.scale, LEAST);
  const color = palette().target;
  context.beginPath();
  context.arc(...center, radius + 3, 0, 2 * Math.PI);
  context.setLineDash([5, 4]);
  context.strokeStyle = color;
  context.lineWidth = 3;
  context.stroke();
  context.setLineDash([]);
  const [c, s] = [Math.cos(target.angle), Math.sin(target.angle)];
  polyline(context, [center, [center[0] + (radius + 14) * c, center[1] - (radius + 14) * s]], {
    color,
    width: 3,
  });
}

/** The throw that would have hit, as a dashed line and its launch. */
function drawAnswer(context, { view, target, answer }) {
  const color = palette().target;
  const [from, to] = [view.toScreen([0, 0]), view.toScreen([target.x, target.y])];
  polyline(context, [from, to], { color, width: 1.5, dash: [4, 6] });
  const { speed, direction } = answer;
  const length = 40 * speed;
  arrow(context, from, [length * Math.cos(direction), -length * Math.sin(direction)], color, 2);
}

/** How far each model has come, one below the other. */
function drawLanes(context, width, top, { result, setup, time, isHidden }) {
  const { soft, line } = palette();
  const left = width < 500 ? 74 : 150;
  const farthest = Math.max(...result.runs.map(({ rest }) => rest.distance), 1e-9);
  const scale = (width - left - 84) / farthest;
  result.runs.forEach((run, index) => {
    const y = top + LANE * (index + 0.5);
    const color = palette()[run.model];
    write(context, t(width < 500 ? `${run.model}Short` : run.model), [4, y + 4], color);
    polyline(
      context,
      [
        [left, y],
        [left + farthest * scale, y],
      ],
      { color: line, width: 1 },
    );
    if (isHidden) return;
    const { x, y: side, angle } = at(run, time);
    const share = Math.hypot(x, side) / Math.max(Math.hypot(run.rest.x, run.rest.y), 1e-12);
    const end = left + Math.min(share, 1) * run.rest.distance * scale;
    polyline(
      context,
      [
        [left, y],
        [end, y],
      ],
      { color, width: 3, dash: DASHES[run.model] },
    );
    context.beginPath();
    context.arc(end, y, 9, 0, 2 * Math.PI);
    context.fillStyle = color;
    context.fill();
    const tip = [end + 9 * Math.cos(angle), y - 9 * Math.sin(angle)];
    polyline(context, [[end, y], tip], { color: palette().panel, width: 2 });
    if (time < run.rest.time) return;
    write(context, lengthText(run.rest.distance, setup.view), [end + 14, y + 4], soft);
  });
}

/** A length with the digits that its view shows. */
export function lengthText(value, view) {
  return `${digits(value, view < 5 ? 3 : 2)} m`;
}
