// Bodies in motion.

import { allNumbers, fields, load as checked, number, numberOr, whole } from "./checks.js";
import { surfaceNumbers } from "./surface.js";
import { answer, check, place, room, wasm } from "./wasm.js";

export const PATH_COLUMNS = Object.freeze(["time", "x", "y", "angle", "vx", "vy", "spin"]);

const GRAVITY = 9.81;
const TWIST = ["vx", "vy", "spin"];
const WRENCH = ["fx", "fy", "torque"];
/** Most rows of a path. */
const MOST = 1e6;
/** Steps of a rollout to rest, about, and how many times as many there may be. */
const STEPS = 2000;
const MOST_TIMES = 8;
const NOTHING = Object.freeze({ fx: 0, fy: 0, torque: 0 });
const ORIGIN = Object.freeze({ x: 0, y: 0, angle: 0 });

/** Static over kinetic friction. */
function strength(still, mu) {
  if (wasm.release === undefined) throw new RangeError("muStatic is in tribos/all, not in tribos");
  if (!(still >= mu && still < Infinity)) {
    throw new RangeError(`muStatic must be finite and at least mu, ${mu}, not ${still}`);
  }
  return mu > 0 ? still / mu : 1;
}

/** A body that is pushed, turned and slides on its patch. */
export class Body {
  #surface;
  #deceleration;
  #inertiaRatio;
  #strength;

  /** Not for users: `body` makes it. */
  constructor(friction, { mass, inertia, load, gravity, model = "exact", muStatic }) {
    this.friction = friction;
    this.mass = number("mass", mass);
    this.inertia = number("inertia", inertia);
    this.load = checked(numberOr("load", load, mass * numberOr("gravity", gravity, GRAVITY)));
    this.model = model;
    this.muStatic = numberOr("muStatic", muStatic, friction.mu);
    this.#strength = muStatic === undefined ? 1 : strength(muStatic, friction.mu);
    check(wasm.check_body(mass, inertia));
    // Without dry friction there is no surface, and no step.
    if (friction.alpha === 0) this.#surface = surfaceNumbers(friction, model);
    this.#deceleration = (friction.mu * this.load) / mass;
    this.#inertiaRatio = inertia / (mass * friction.radius * friction.radius);
    Object.freeze(this);
  }

  #dry() {
    if (this.#surface === undefined) {
      throw new RangeError(
        "time steps need dry friction: that of this law depends on the speed; advance follows it",
      );
    }
    return this.#surface;
  }

  /** What free motion on a round patch depends on. */
  get freeMotion() {
    if (this.model !== "exact") {
      throw new RangeError(`free motion is exact; rollout follows the model "${this.model}"`);
    }
    return [this.friction.handle, this.#deceleration, this.friction.radius, this.#inertiaRatio];
  }

  step(twist, push, dt, angle = 0) {
    const [model, lever, spinTorque] = this.#dry();
    const { handle, radius, mu, isRound } = this.friction;
    const limit = mu * this.load;
    const { vx, vy, spin } = twist;
    const { fx, fy, torque } = push ?? NOTHING;
    const { mass, inertia } = this;
    const turned = isRound ? 0 : angle;
    check(
      // prettier-ignore
      wasm.step(
        handle, radius, limit, model, lever, spinTorque, mass, inertia, this.#strength, dt, turned,
        vx, vy, spin, fx, fy, torque,
      ),
    );
    const r = answer();
    if (Number.isNaN(r[2])) {
      allNumbers("twist", twist, TWIST);
      allNumbers("push", push ?? NOTHING, WRENCH);
      number("angle", angle);
    }
    return {
      vx: r[0],
      vy: r[1],
      spin: r[2],
      fx: r[3],
      fy: r[4],
      torque: r[5],
      isAtRest: r[6] === 1,
    };
  }

  rollout(twist, options) {
    const [model, lever, spinTorque] = this.#dry();
    const { dt, steps, push = NOTHING, pose = ORIGIN } = fields("the rollout", options);
    const { handle, radius, mu } = this.friction;
    const limit = mu * this.load;
    allNumbers("twist", twist, TWIST);
    const count = whole("steps", steps, 1, MOST) + 1;
    room(7 * count);
    const { vx, vy, spin } = twist;
    const { fx, fy, torque } = push;
    const { x, y, angle } = pose;
    check(
      // prettier-ignore
      wasm.rollout(
        handle, radius, limit, model, lever, spinTorque, this.mass, this.inertia, this.#strength,
        number("dt", dt),
        vx, vy, spin, fx, fy, torque, x, y, angle, place(), count,
      ),
    );
    return room(0).slice(0, 7 * answer()[0]);
  }

  /** Rows of a free motion to rest on a patch that need not be round. */
  #rolled(twist, steps) {
    const [model, lever, spinTorque] = this.#dry();
    const { handle, radius, mu } = this.friction;
    const limit = mu * this.load;
    const count = MOST_TIMES * steps;
    room(7 * count);
    const { vx, vy, spin } = twist;
    check(
      // prettier-ignore
      wasm.rollout_to_rest(
        handle, radius, limit, model, lever, spinTorque, this.mass, this.inertia,
        vx, vy, spin, steps, place(), count,
      ),
    );
    return room(0).subarray(0, 7 * answer()[0]);
  }

  /** Whether the closed motion of round patches serves. */
  get #isClosed() {
    return this.friction.isRound && this.model === "exact";
  }

  advance(twist, duration) {
    allNumbers("twist", twist, TWIST);
    if (number("duration", duration) < 0) {
      throw new RangeError(`duration must be >= 0, not ${duration}`);
    }
    const { vx, vy, spin } = twist;
    check(wasm.advance(...this.freeMotion, vx, vy, spin, duration));
    const r = answer();
    return {
      time: r[0],
      x: r[1],
      y: r[2],
      angle: r[3],
      vx: r[4],
      vy: r[5],
      spin: r[6],
      isAtRest: r[7] === 1,
    };
  }

  slide(twist) {
    allNumbers("twist", twist, TWIST);
    const { vx, vy, spin } = twist;
    if (this.#isClosed) {
      check(wasm.slide_to_rest(...this.freeMotion, vx, vy, spin));
      const r = answer();
      return { time: r[0], distance: r[1], x: r[2], y: r[3], angle: r[4], ratio: r[5] };
    }
    const rows = this.#rolled(twist, STEPS);
    let distance = 0;
    for (let at = 7; at < rows.length; at += 7) {
      const [dx, dy] = [rows[at + 1] - rows[at - 6], rows[at + 2] - rows[at - 5]];
      distance += Math.sqrt(dx * dx + dy * dy);
    }
    const [time, x, y, angle] = rows.subarray(rows.length - 7);
    const [wx, wy, turn] = rows.subarray(Math.max(rows.length - 10, 4));
    const ratio = Math.sqrt(wx * wx + wy * wy) / (Math.abs(turn) * this.friction.radius);
    return { time, distance, x, y, angle, ratio };
  }

  slidePath(twist, count = 100) {
    allNumbers("twist", twist, TWIST);
    whole("count", count, 2, MOST / MOST_TIMES);
    const { vx, vy, spin } = twist;
    if (!this.#isClosed) return this.#rolled(twist, count).slice();
    room(7 * count);
    check(wasm.slide_path(...this.freeMotion, vx, vy, spin, place(), count));
    return room(0).slice(0, 7 * count);
  }
}
