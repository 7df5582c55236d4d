// Contacts of spheres and plates.

import { fields, flat, number, numberOr, word } from "./checks.js";
import { FREED, disposable, forget, remember } from "./friction.js";
import { answer, check, place, room, texts, wasm } from "./wasm.js";

/** Numbers of a body, and of both with normal and gap. */
const FIELDS = 9;
const GIVEN = 22;
/** The error of a normal whose length counts as 1. */
const UNIT = 1e-9;

/** Laws of a contact. */
class ContactLaw {
  #handle;

  constructor(handle) {
    this.#handle = handle;
    Object.freeze(this);
  }

  collide(first, second, options) {
    const { normal, gap = 0, dt = 1 } = fields("options", options);
    const row = [...sphereNumbers("first", first)];
    const isSphere = fields("second", second).radius !== undefined;
    row.push(...(isSphere ? sphereNumbers("second", second) : plateNumbers("second", second)));
    row.push(...unit("normal", normal), number("gap", gap));
    room(GIVEN).set(row);
    number("dt", dt);
    const solve = isSphere ? wasm.collide_spheres : wasm.collide_plate;
    check(solve(this.#handle, dt, place()));
    const r = Array.from(answer());
    return {
      first: { velocity: r.slice(0, 3), spin: r.slice(3, 6) },
      second: { velocity: r.slice(6, 9), spin: r.slice(9, 12) },
      sliding: r.slice(12, 15),
      rolling: r.slice(15, 18),
      normal: r[18],
      torsion: r[19],
    };
  }

  free() {
    if (this.#handle === FREED) return;
    forget(this, this.#handle);
    this.#handle = FREED;
  }
}
disposable(ContactLaw);

export function contactLaw(options) {
  const given = fields("the contact", options);
  const { patch, muTorsion, attraction = "pull" } = given;
  word("attraction", attraction, ["pull", "resistance"]);
  if (patch !== undefined && muTorsion !== undefined) {
    throw new TypeError("give either muTorsion or patch, which has a torsion of its own");
  }
  const value = (key) => numberOr(key, given[key], 0);
  const [at, length] = texts(0, patch === undefined ? "" : patchName(patch));
  // prettier-ignore
  const status = wasm.make_contact_law(
    value("mu"), value("muRolling"), value("muTorsion"), at, length, patch?.radius ?? 1,
    value("restitution"), value("cohesion"), value("cohesionRange"), attraction === "pull" ? 0 : 1,
  );
  check(status);
  const [handle] = answer();
  return remember(new ContactLaw(handle), handle);
}

function patchName({ kind, radius, inner, order, coefficients }) {
  word("patch.kind", kind, ["disk", "ring", "annulus", "hertz", "punch", "paraboloid", "power", "polynomial"]);
  number("patch.radius", radius);
  if (kind === "annulus") return `annulus:${number("patch.inner", inner) / radius}`;
  if (kind === "power") return `power:${number("patch.order", order)}`;
  if (kind === "polynomial") return `polynomial:${flat("patch.coefficients", coefficients, 1)}`;
  return kind;
}

function vector(name, value) {
  const three = flat(name, value, 3);
  if (three.length !== 3) throw new TypeError(`${name} must be three numbers`);
  return three;
}

/** A direction of length 1. */
function unit(name, value) {
  const [x, y, z] = vector(name, value);
  if (!(Math.abs(x * x + y * y + z * z - 1) < UNIT)) {
    throw new RangeError(`${name} must have length 1, not ${Math.sqrt(x * x + y * y + z * z)}`);
  }
  return [x, y, z];
}

function positive(name, value) {
  if (!(number(name, value) > 0)) throw new RangeError(`${name} must be > 0, not ${value}`);
  return value;
}

function sphereNumbers(name, sphere) {
  const { velocity, spin = [0, 0, 0], mass, radius, inertia } = fields(name, sphere);
  positive(`${name}.mass`, mass);
  positive(`${name}.radius`, radius);
  const turn = inertia === undefined ? 0.4 * mass * radius * radius : inertia;
  return [
    ...vector(`${name}.velocity`, velocity),
    ...vector(`${name}.spin`, spin),
    1 / mass,
    1 / positive(`${name}.inertia`, turn),
    radius,
  ];
}

function plateNumbers(name, { velocity = [0, 0, 0], mass = Infinity }) {
  const still = [0, 0, 0];
  const inverse = 1 / positive(`${name}.mass`, mass);
  return [...vector(`${name}.velocity`, velocity), ...still, inverse, 0, 1].slice(0, FIELDS);
}
