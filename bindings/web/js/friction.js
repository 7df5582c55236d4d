// Friction of a patch, and its final motion.

import { Body } from "./body.js";
import { allNumbers, fields, load as checked, number, output, rowsOf } from "./checks.js";
import { LimitSurface } from "./surface.js";
import { answer, check, place, room, wasm } from "./wasm.js";

const TWIST = ["vx", "vy", "spin"];
const STABILITIES = ["stable", "semistable", "unstable"];

/** Friction of a patch: a disk by its numbers, or a prepared patch by its handle. */
export class Friction {
  #handle;

  /** Not for users: `disk` and the like make it. */
  constructor({ handle, kind, isRound, mu, alpha, radius, centre }) {
    this.#handle = handle;
    this.kind = kind;
    this.isRound = isRound;
    this.mu = mu;
    this.alpha = alpha;
    this.radius = radius;
    this.centre = Object.freeze(centre);
  }

  /** The handle of the kernel. */
  get handle() {
    return this.#handle;
  }

  wrench(twist, load) {
    const { vx, vy, spin } = twist;
    check(wasm.wrench(this.#handle, this.radius, this.mu, checked(load), vx, vy, spin));
    const r = answer();
    if (Number.isNaN(r[2])) allNumbers("twist", twist, TWIST), number("load", load);
    return { fx: r[0], fy: r[1], torque: r[2] };
  }

  jacobian(twist, load) {
    const { vx, vy, spin } = twist;
    check(wasm.jacobian(this.#handle, this.radius, this.mu, checked(load), vx, vy, spin));
    const r = answer();
    if (Number.isNaN(r[8])) allNumbers("twist", twist, TWIST), number("load", load);
    return r.slice(0, 9);
  }

  wrenches(twists, load, out) {
    const count = rowsOf("twists", twists, 3);
    const result = output(out, 3 * count);
    const loads = this.#loads(load, count);
    const memory = room(4 * count);
    memory.set(twists);
    if (loads === undefined) {
      check(wasm.wrenches(this.#handle, this.radius, this.mu, load, place(), count));
    } else {
      memory.set(loads, 3 * count);
      const at = place(3 * count);
      check(wasm.wrenches_under_loads(this.#handle, this.radius, this.mu, at, place(), count));
    }
    result.set(room(0).subarray(0, 3 * count));
    return result;
  }

  jacobians(twists, load, out) {
    const count = rowsOf("twists", twists, 3);
    const result = output(out, 9 * count);
    const loads = this.#loads(load, count);
    const memory = room(13 * count);
    memory.set(twists, 9 * count);
    const [into, from] = [place(), place(9 * count)];
    if (loads === undefined) {
      check(wasm.jacobians(this.#handle, this.radius, this.mu, load, from, into, count));
    } else {
      memory.set(loads, 12 * count);
      const at = place(12 * count);
      const { radius, mu } = this;
      check(wasm.jacobians_under_loads(this.#handle, radius, mu, at, from, into, count));
    }
    result.set(room(0).subarray(0, 9 * count));
    return result;
  }

  /** Loads of a batch; undefined for one that all have. */
  #loads(load, count) {
    if (typeof load === "number") {
      checked(load);
      return undefined;
    }
    if (rowsOf("load", load, 1) !== count) {
      throw new RangeError(`there are ${count} twists and ${load.length} loads`);
    }
    load.forEach(checked);
    return load;
  }

  limitSurface(load) {
    return new LimitSurface(this, this.mu * checked(number("load", load)), "exact");
  }

  body(options) {
    return new Body(this, fields("the body", options));
  }

  modes(inertiaRatio, initialRatio = NaN) {
    number("inertiaRatio", inertiaRatio);
    if (number("initialRatio", initialRatio) < 0) {
      throw new RangeError(`initialRatio must be from 0 to Infinity, not ${initialRatio}`);
    }
    check(wasm.modes(this.#handle, inertiaRatio, initialRatio));
    const [least, most, spinning, ratio, between, sliding, last] = answer();
    const fixedPoints = [{ ratio: 0, stability: STABILITIES[spinning] }];
    if (!Number.isNaN(ratio)) fixedPoints.push({ ratio, stability: STABILITIES[between] });
    fixedPoints.push({ ratio: Infinity, stability: STABILITIES[sliding] });
    return {
      finalMode: modeOf(last),
      finalRatio: Number.isNaN(last) ? null : last,
      fixedPoints,
      inertiaInterval: [least, most],
      restsInFiniteTime: this.alpha < 1,
    };
  }

  free() {
    if (this.#handle === 0) return;
    forget(this, this.#handle);
    // No handle is that large: every call says that the object was freed.
    this.#handle = FREED;
  }
}

/** A handle that nothing has. */
export const FREED = 0xffffffff;

function modeOf(ratio) {
  if (Number.isNaN(ratio)) return null;
  if (ratio === 0) return "spinning";
  return ratio === Infinity ? "sliding" : "together";
}

const collected =
  typeof FinalizationRegistry === "undefined"
    ? undefined
    : new FinalizationRegistry((handle) => wasm.release(handle));

/** Frees what has the handle once the object is collected. */
export function remember(object, handle) {
  collected?.register(object, handle, object);
  return object;
}

/** Frees it now. */
export function forget(object, handle) {
  collected?.unregister(object);
  wasm.release(handle);
}

/** Lets `using` free it. */
export function disposable(Class) {
  if (typeof Symbol.dispose === "symbol") {
    Class.prototype[Symbol.dispose] = function dispose() {
      this.free();
    };
  }
}
disposable(Friction);

/** A disk under Coulomb friction, of a class of friction. */
export function plainDisk(Class, radius, mu) {
  check(wasm.check(0, radius, mu));
  const centre = [0, 0];
  const parts = { handle: 0, kind: "disk", isRound: true, mu, alpha: 0, radius, centre };
  return Object.freeze(new Class(parts));
}
