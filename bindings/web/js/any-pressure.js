// Supports of which the pressure is not known.

import { allNumbers, fields, flat, number, pair } from "./checks.js";
import { FREED, disposable, forget, remember } from "./friction.js";
import { answer, check, place, room, wasm } from "./wasm.js";

const TWIST = ["vx", "vy", "spin"];
const WRENCH = ["fx", "fy", "torque"];

/** What friction carries for certain, and at most, under every pressure with a known centre. */
class AnyPressure {
  #handle;

  constructor(handle, radius) {
    this.#handle = handle;
    this.radius = radius;
    Object.freeze(this);
  }

  #at(twist) {
    allNumbers("twist", twist, TWIST);
    check(wasm.any_pressure_at(this.#handle, twist.vx, twist.vy, twist.spin));
    return answer();
  }

  support(twist) {
    return this.#at(twist)[0];
  }

  wrench(twist) {
    const [, fx, fy, torque] = this.#at(twist);
    return { fx, fy, torque };
  }

  torqueLimits(fx, fy) {
    check(wasm.any_pressure_torques(this.#handle, number("fx", fx), number("fy", fy)));
    const [low, high, lower, higher] = answer();
    return Number.isNaN(low) ? null : { carried: [low, high], outer: [lower, higher] };
  }

  gaugeBounds(wrench) {
    allNumbers("wrench", wrench, WRENCH);
    check(wasm.any_pressure_gauge(this.#handle, wrench.fx, wrench.fy, wrench.torque));
    const [least, most] = answer();
    return [least, most];
  }

  free() {
    if (this.#handle === FREED) return;
    forget(this, this.#handle);
    this.#handle = FREED;
  }
}
disposable(AnyPressure);

export function anyPressure(options) {
  const { corners, centre, forceLimit } = fields("the support", options);
  const all = flat("corners", corners, 2);
  const [x, y] = pair("centre", centre);
  number("forceLimit", forceLimit);
  room(all.length).set(all);
  check(wasm.make_any_pressure(place(), all.length / 2, x, y, forceLimit));
  const [handle, radius] = answer();
  return remember(new AnyPressure(handle, radius), handle);
}
