// Floors of several surfaces that move, and bodies on several feet.

import { allNumbers, fields, flat, load as checked, number, numberOr, pair, shown } from "./checks.js";
import { FREED, Friction, disposable, forget, remember } from "./friction.js";
import { answer, check, place, room, wasm } from "./wasm.js";

const TWIST = ["vx", "vy", "spin"];
const WRENCH = ["fx", "fy", "torque"];
const STILL = { vx: 0, vy: 0, spin: 0 };
const NOTHING = { fx: 0, fy: 0, torque: 0 };
/** Numbers of a foot. */
const FOOT = 10;

/** A body on surfaces, each of which moves by itself. */
class Floor {
  #handle;
  #patch;

  constructor(handle, forceLimit, count) {
    this.#handle = handle;
    this.forceLimit = forceLimit;
    this.count = count;
    Object.freeze(this);
  }

  wrench(twist) {
    check(wasm.floor_wrench(this.#handle, ...numbers("twist", twist, TWIST)));
    const [fx, fy, torque] = answer();
    return { fx, fy, torque };
  }

  jacobian(twist) {
    check(wasm.floor_jacobian(this.#handle, ...numbers("twist", twist, TWIST)));
    return answer().slice(0, 9);
  }

  steadyMotion(push = NOTHING) {
    check(wasm.floor_steady_motion(this.#handle, ...numbers("push", push, WRENCH)));
    return ended("evaluations");
  }

  step(body, twist, push, dt) {
    const { mass, inertia } = fields("the body", body);
    const given = [number("mass", mass), number("inertia", inertia), number("dt", dt)];
    const motion = [...numbers("twist", twist, TWIST), ...numbers("push", push ?? NOTHING, WRENCH)];
    check(wasm.floor_step(this.#handle, ...given, ...motion));
    return ended("imbalance");
  }

  get patch() {
    if (this.#patch === undefined) {
      check(wasm.floor_patch(this.#handle));
      const [handle, radius, x, y, mu, alpha] = answer();
      const parts = { handle, kind: "feet", isRound: false, mu, alpha, radius, centre: [x, y] };
      this.#patch = Object.freeze(remember(new Friction(parts), handle));
    }
    return this.#patch;
  }

  limitSurface() {
    return this.patch.limitSurface(this.forceLimit);
  }

  free() {
    if (this.#handle === FREED) return;
    this.#patch?.free();
    forget(this, this.#handle);
    this.#handle = FREED;
  }
}
disposable(Floor);

/** A motion with its friction, and what the last number of the answer is. */
function ended(last) {
  const [vx, vy, spin, fx, fy, torque, carriedBy, value] = answer();
  return {
    twist: { vx, vy, spin },
    friction: { fx, fy, torque },
    carriedBy: carriedBy < 0 ? null : carriedBy,
    [last]: value,
  };
}

function numbers(name, value, keys) {
  allNumbers(name, value, keys);
  return keys.map((key) => value[key]);
}

function made(status) {
  check(status);
  const [handle, forceLimit, count] = answer();
  return remember(new Floor(handle, forceLimit, count), handle);
}

/** A patch on surfaces. */
export function floorUnder({ handle, radius, mu }, load, surface) {
  const parts = Array.from(surface, (one) => fields("a surface", one));
  const corners = parts.map((one) => flat("corners", one.corners, 2));
  const twists = parts.map((one) => numbers("twist", one.twist ?? STILL, TWIST));
  const all = corners.flat();
  const memory = room(all.length + 4 * parts.length);
  const [counts, moves] = [all.length, all.length + parts.length];
  memory.set(all);
  memory.set(corners.map((one) => one.length / 2), counts);
  memory.set(twists.flat(), moves);
  // prettier-ignore
  return made(wasm.make_floor(
    handle, radius, mu, checked(number("load", load)),
    place(), all.length / 2, place(counts), place(moves), parts.length,
  ));
}

export function feet(given) {
  const rows = Array.from(given, (foot) => {
    const { friction, load, place: at, degrees, surface = STILL } = fields("a foot", foot);
    if (!(friction instanceof Friction)) {
      throw new TypeError(`friction of a foot must be that of a patch, not ${shown(friction)}`);
    }
    const { handle, radius, mu } = friction;
    const stands = [...pair("place", at), numberOr("degrees", degrees, 0)];
    const moves = numbers("surface", surface, TWIST);
    return [handle, radius, mu, checked(number("load", load)), ...stands, ...moves];
  });
  room(FOOT * rows.length).set(rows.flat());
  return made(wasm.make_feet(place(), rows.length));
}
