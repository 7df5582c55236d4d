// Limit surfaces.

import { allNumbers, number, output, rowsOf, whole } from "./checks.js";
import { answer, check, place, room, wasm } from "./wasm.js";

const MODELS = ["exact", "ellipsoid", "separate"];
const TWIST = ["vx", "vy", "spin"];
const WRENCH = ["fx", "fy", "torque"];
/** Most points of a curve. */
const MOST = 1e6;

/** All wrenches that dry friction of a patch carries. */
export class LimitSurface {
  #friction;
  #numbers;

  /** Not for users: `limitSurface`, `ellipsoid` and `separate` make it. */
  constructor(friction, forceLimit, model) {
    if (!(friction.alpha === 0)) {
      throw new RangeError("a limit surface needs dry friction: that of this law depends on the speed");
    }
    this.#friction = friction;
    this.#numbers = surfaceNumbers(friction, model);
    this.model = model;
    this.forceLimit = forceLimit;
    check(wasm.surface(...this.#at()));
    [this.radius, this.torqueLimit] = answer();
    Object.freeze(this);
  }

  /** What the kernel makes the surface of. */
  #at() {
    const [model, lever, spinTorque] = this.#numbers;
    const { handle, radius } = this.#friction;
    return [handle, radius, this.forceLimit, model, lever, spinTorque];
  }

  #call(name, x, y, turn, length) {
    const [model, lever, spinTorque] = this.#numbers;
    const { handle, radius } = this.#friction;
    const { forceLimit } = this;
    check(wasm[name](handle, radius, forceLimit, model, lever, spinTorque, x, y, turn, length));
    return answer();
  }

  contains(wrench) {
    const { fx, fy, torque } = wrench;
    const holds = this.#call("contains", fx, fy, torque)[0] === 1;
    if (!holds) allNumbers("wrench", wrench, WRENCH);
    return holds;
  }

  gauge(wrench) {
    const { fx, fy, torque } = wrench;
    const gauge = this.#call("gauge", fx, fy, torque)[0];
    if (Number.isNaN(gauge)) allNumbers("wrench", wrench, WRENCH);
    return gauge;
  }

  normal(push) {
    const { fx, fy, torque } = push;
    const r = this.#call("normal", fx, fy, torque);
    if (Number.isNaN(r[2])) allNumbers("push", push, WRENCH);
    return { vx: r[0], vy: r[1], spin: r[2] };
  }

  scaleToSurface(wrench) {
    const { fx, fy, torque } = wrench;
    const r = this.#call("scale_to_surface", fx, fy, torque);
    if (Number.isNaN(r[2])) allNumbers("wrench", wrench, WRENCH);
    return { fx: r[0], fy: r[1], torque: r[2] };
  }

  project(wrench, length = 0) {
    const { fx, fy, torque } = wrench;
    const r = this.#call("project", fx, fy, torque, length);
    if (Number.isNaN(r[2])) allNumbers("wrench", wrench, WRENCH), number("length", length);
    const normal = { vx: r[3], vy: r[4], spin: r[5] };
    return { fx: r[0], fy: r[1], torque: r[2], slides: r[6] === 1, normal };
  }

  support(twist) {
    const { vx, vy, spin } = twist;
    const power = this.#call("support", vx, vy, spin)[0];
    if (Number.isNaN(power)) allNumbers("twist", twist, TWIST);
    return power;
  }

  wrench(twist) {
    const { vx, vy, spin } = twist;
    const r = this.#call("surface_wrench", vx, vy, spin);
    if (Number.isNaN(r[2])) allNumbers("twist", twist, TWIST);
    return { fx: r[0], fy: r[1], torque: r[2] };
  }

  gauges(wrenches, out) {
    const count = rowsOf("wrenches", wrenches, 3);
    const result = output(out, count);
    room(4 * count).set(wrenches);
    check(wasm.gauges(...this.#at(), place(), place(3 * count), count));
    result.set(room(0).subarray(3 * count, 4 * count));
    return result;
  }

  wrenches(twists, out) {
    const count = rowsOf("twists", twists, 3);
    const result = output(out, 3 * count);
    room(3 * count).set(twists);
    check(wasm.surface_wrenches(...this.#at(), place(), count));
    result.set(room(0).subarray(0, 3 * count));
    return result;
  }

  meridian(count, direction = 0) {
    whole("count", count, 2, MOST);
    number("direction", direction);
    room(3 * count);
    check(wasm.meridian(...this.#at(), direction, place(), count));
    return room(0).slice(0, 3 * count);
  }

  ellipsoid() {
    return new LimitSurface(this.#friction, this.forceLimit, "ellipsoid");
  }

  separate() {
    return new LimitSurface(this.#friction, this.forceLimit, "separate");
  }
}

/** Number of the model, lever and reduced torque of an approximation. */
export function surfaceNumbers(friction, model) {
  const index = MODELS.indexOf(model);
  if (index < 0) throw new RangeError(`model must be ${MODELS.join(" or ")}, not ${model}`);
  if (index === 0) return [0, 1, 1];
  if (wasm.release === undefined) {
    throw new RangeError(`the model "${model}" is in tribos/all, not in tribos`);
  }
  check(wasm.surface_shape(friction.handle, friction.radius));
  const [lever, spinTorque] = answer();
  return [index, lever, spinTorque];
}
