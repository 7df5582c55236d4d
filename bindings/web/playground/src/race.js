// The same throw under the exact law and under two approximations.

import { MODELS, frictionOf, inertiaOf, isRound } from "./bodies.js";
import { isComplete } from "./kernel.js";

const COLUMNS = 7;
/** Rows of a path. Round bodies slide straight; other paths have more rows than a bend has pixels. */
const ROWS = { straight: 100, bent: 300 };

/** Which models can run a throw: approximations are made for dry friction. */
export function runnable(body) {
  return isComplete && body.alpha === 0 ? MODELS : ["exact"];
}

/** The throw as velocities. */
export function twistOf({ speed, direction, spin }) {
  return { vx: speed * Math.cos(direction), vy: speed * Math.sin(direction), spin };
}

/** Whether a throw has any motion. */
export const moves = ({ speed, spin }) => speed !== 0 || spin !== 0;

/** Path and rest of each model that runs; `friction` and `body` are those of the exact law. */
export function race(setup) {
  const friction = frictionOf(setup);
  const options = { mass: setup.mass, inertia: inertiaOf(setup) };
  const twist = twistOf(setup);
  const count = isRound(setup) ? ROWS.straight : ROWS.bent;
  const runs = runnable(setup).map((model) => {
    const body = friction.body({ ...options, model });
    const rest = body.slide(twist);
    // Without any motion nothing takes time.
    if (!moves(setup)) rest.time = 0;
    return { model, rest, rows: body.slidePath(twist, count) };
  });
  return { friction, body: friction.body(options), runs, twist, isRound: isRound(setup) };
}

/** Time of the last rest. */
export const durationOf = ({ runs }) => Math.max(...runs.map(({ rest }) => rest.time));

/** Pose and motion of a run at a time, between its rows. */
export function at({ rows }, time) {
  const count = rows.length / COLUMNS;
  let [low, high] = [0, count - 1];
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (rows[COLUMNS * middle] <= time) low = middle;
    else high = middle;
  }
  const [start, end] = [rows[COLUMNS * low], rows[COLUMNS * high]];
  const part = end > start ? Math.min(Math.max((time - start) / (end - start), 0), 1) : 1;
  const value = (column) => {
    const from = rows[COLUMNS * low + column];
    return from + part * (rows[COLUMNS * high + column] - from);
  };
  const [x, y, angle, vx, vy, spin] = [1, 2, 3, 4, 5, 6].map(value);
  return { x, y, angle, vx, vy, spin };
}

/** Places of a run up to a time. */
export function pathUntil(run, time) {
  const points = [];
  for (let row = 0; row < run.rows.length && run.rows[row] <= time; row += COLUMNS) {
    points.push([run.rows[row + 1], run.rows[row + 2]]);
  }
  const { x, y } = at(run, time);
  points.push([x, y]);
  return points;
}

/** Friction on the body in axes that do not turn. */
export function frictionAt(friction, { vx, vy, spin, angle }, load, isRoundPatch) {
  const turned = isRoundPatch ? 0 : angle;
  const [c, s] = [Math.cos(turned), Math.sin(turned)];
  const own = friction.wrench({ vx: c * vx + s * vy, vy: c * vy - s * vx, spin }, load);
  return { fx: c * own.fx - s * own.fy, fy: s * own.fx + c * own.fy, torque: own.torque };
}
