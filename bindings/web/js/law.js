// Laws of the local speed.

import { number, output, pair, rowsOf, shown } from "./checks.js";
import { FREED, disposable, forget, remember } from "./friction.js";
import { answer, check, place, room, said, texts, wasm } from "./wasm.js";

/** A law of the local speed: friction per load as a function of the speed. */
export class Law {
  #handle;

  /** Not for users: `law` makes it. */
  constructor(handle, { name, parameters, text }) {
    this.#handle = handle;
    this.name = name;
    this.parameters = Object.freeze(parameters);
    this.text = text;
    Object.freeze(this);
  }

  friction(speed) {
    check(wasm.law_at(this.#handle, number("speed", speed)));
    return answer()[0];
  }

  slope(speed) {
    check(wasm.law_at(this.#handle, number("speed", speed)));
    return answer()[1];
  }

  frictions(speeds, out) {
    const count = rowsOf("speeds", speeds, 1);
    const result = output(out, count);
    room(count).set(speeds);
    check(wasm.law_frictions(this.#handle, place(), count));
    result.set(room(0).subarray(0, count));
    return result;
  }

  free() {
    if (this.#handle === FREED) return;
    forget(this, this.#handle);
    this.#handle = FREED;
  }
}
disposable(Law);

export function law(name, parameters = {}) {
  if (typeof name !== "string") {
    throw new TypeError(`a law has a name such as "coulomb", not ${shown(name)}`);
  }
  const given = Object.entries(parameters).map(([key, value]) => `${key}=${number(key, value)}`);
  const glue = given.length === 0 ? "" : name.includes(":") ? "," : ":";
  const [at, length] = texts(0, `${name}${glue}${given.join(",")}`);
  check(wasm.make_law(at, length));
  const [handle] = answer();
  return remember(new Law(handle, JSON.parse(said())), handle);
}

export function laws() {
  check(wasm.laws());
  return JSON.parse(said());
}

/** The line of the law that options ask for. */
export function lawLine({ mu, alpha, axis, law: other, ...unknown }) {
  const [name] = Object.keys(unknown);
  if (name !== undefined) throw new TypeError(`there is no option "${name}"`);
  if ((mu === undefined) === (other === undefined)) {
    throw new TypeError("give either mu, the coefficient of friction, or law");
  }
  if (axis !== undefined && !Array.isArray(mu)) {
    throw new TypeError("axis goes with two coefficients, mu: [along, across]");
  }
  if (other !== undefined) {
    if (alpha !== undefined) throw new TypeError("alpha goes with mu: friction is mu |v|^alpha");
    if (other instanceof Law) return other.text;
    if (typeof other === "string") return other;
    throw new TypeError(`law must be a Law or its line, not ${shown(other)}`);
  }
  if (typeof mu !== "number") return `coulomb:mu=${largest(mu, alpha)}`;
  if (alpha === undefined || alpha === 0) return `coulomb:mu=${mu}`;
  return `power:gamma=${mu},alpha=${number("alpha", alpha)}`;
}

/** The larger one of two coefficients. */
function largest(mu, alpha) {
  if (!Array.isArray(mu)) number("mu", mu);
  if (alpha !== undefined && alpha !== 0) throw new TypeError("two coefficients are those of dry friction, without alpha");
  return Math.max(...pair("mu", mu));
}
