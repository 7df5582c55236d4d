// All patches, under any law.

import { Body } from "./body.js";
import { fields, flat, number, pair, whole, word } from "./checks.js";
import { Friction, plainDisk, remember } from "./friction.js";
import { floorUnder } from "./floor.js";
import { lawLine } from "./law.js";
import { answer, check, place, room, texts, wasm } from "./wasm.js";

/** Launches that are listed if their number is left out, and the most. */
const LISTED = 100;
const MOST = 100_000;

/** Friction of a patch of any kind. */
class AnyFriction extends Friction {
  wrench(twist, load, options) {
    if (options?.surface === undefined) return super.wrench(twist, load);
    return this.#on(load, options.surface, (floor) => floor.wrench(twist));
  }

  jacobian(twist, load, options) {
    if (options?.surface === undefined) return super.jacobian(twist, load);
    return this.#on(load, options.surface, (floor) => floor.jacobian(twist));
  }

  steadyMotion(load, surface, push) {
    return this.#on(load, surface, (floor) => floor.steadyMotion(push));
  }

  onSurfaces(load, surface) {
    return floorUnder(this, load, surface);
  }

  /** What `work` makes of a floor that is needed once. */
  #on(load, surface, work) {
    const floor = floorUnder(this, load, surface);
    try {
      return work(floor);
    } finally {
      floor.free();
    }
  }

  body(options) {
    const given = fields("the body", options);
    return this.isRound ? new RoundBody(this, given) : new Body(this, given);
  }
}

/** A body on a round patch. */
class RoundBody extends Body {
  launches(options) {
    const given = fields("the launch", options);
    const { turns = "modulo", symmetry = 1, most = LISTED } = given;
    word("turns", turns, ["modulo", "exact"]);
    whole("symmetry", symmetry, 1, 2 ** 32 - 1);
    const count = whole("most", most, 1, MOST);
    const numbers = ["x", "y", "angle", "maxSpeed", "maxSpin"].map((key) => number(key, given[key]));
    room(8 * count);
    const order = turns === "exact" ? 0 : symmetry;
    check(wasm.launches(...this.freeMotion, ...numbers, order, place(), count));
    const rows = room(0).slice(0, 8 * answer()[0]);
    return Array.from({ length: rows.length / 8 }, (_, index) => {
      const [vx, vy, spin, speed, direction, angle, time, energyPerMass] = rows.subarray(8 * index);
      return { vx, vy, spin, speed, direction, angle, time, energyPerMass };
    });
  }
}

/** The object of a patch that the kernel has prepared under a law, or with two coefficients. */
function prepared(kind, isRound, status, { mu: coefficients, axis = 0 }) {
  check(status);
  let [handle, radius, x, y, mu, alpha] = answer();
  if (Array.isArray(coefficients)) {
    const [along, across] = coefficients;
    const isotropic = handle;
    try {
      check(wasm.make_two_coefficients(handle, radius, mu, along, across, number("axis", axis)));
    } finally {
      wasm.release(isotropic);
    }
    [handle, radius, x, y, mu, alpha] = answer();
    isRound &&= along === across;
  }
  const made = new AnyFriction({ handle, kind, isRound, mu, alpha, radius, centre: [x, y] });
  return Object.freeze(remember(made, handle));
}

/** A round patch by its name in radii. */
function round(kind, name, { radius, ...law }) {
  return named(kind, name, number("radius", radius), true, law);
}

/** A patch as scenes write it. */
function named(kind, name, radius, isRound, law) {
  const [at, length, lawAt, lawLength] = texts(0, name, lawLine(law));
  return prepared(kind, isRound, wasm.make_named(at, length, radius, lawAt, lawLength), law);
}

export function disk(options) {
  const { radius, mu, alpha = 0, law } = fields("the disk", options);
  if (alpha === 0 && law === undefined && !Array.isArray(mu)) {
    return plainDisk(AnyFriction, number("radius", radius), number("mu", mu));
  }
  return round("disk", "disk", options);
}

export function ring(options) {
  return round("ring", "ring", fields("the ring", options));
}

export function annulus(options) {
  const { inner, ...others } = fields("the annulus", options);
  const ratio = number("inner", inner) / number("radius", others.radius);
  return round("annulus", `annulus:${ratio}`, others);
}

export function wornAnnulus(options) {
  const { inner, radius, ...law } = fields("the annulus", options);
  const name = `worn-annulus:${number("inner", inner) / number("radius", radius)}`;
  return named("wornAnnulus", name, radius, false, law);
}

export function hertz(options) {
  return round("hertz", "hertz", fields("the patch", options));
}

export function punch(options) {
  return round("punch", "punch", fields("the patch", options));
}

export function paraboloid(options) {
  return round("paraboloid", "paraboloid", fields("the patch", options));
}

export function power(options) {
  const { order, ...others } = fields("the patch", options);
  return round("power", `power:${number("order", order)}`, others);
}

export function polynomial(options) {
  const { coefficients, ...others } = fields("the patch", options);
  return round("polynomial", `polynomial:${flat("coefficients", coefficients, 1)}`, others);
}

export function polygon(options) {
  const { corners, holes = [], centre, ...law } = fields("the polygon", options);
  return straight("polygon", [corners, ...holes], centre, law);
}

export function box(options) {
  const { a, b, centre, ...law } = fields("the box", options);
  const [x, y] = [number("a", a) / 2, number("b", b) / 2];
  return straight("box", [[-x, -y, x, -y, x, y, -x, y]], centre, law);
}

function straight(kind, loops, centre, law) {
  const flats = loops.map((corners) => flat("corners", corners, 2));
  const counts = flats.map((corners) => corners.length / 2);
  const all = flats.flat();
  const [x, y] = centre === undefined ? [NaN, NaN] : pair("centre", centre);
  const total = all.length + counts.length;
  const [lawAt, lawLength] = texts(total, lawLine(law));
  const memory = room(total);
  memory.set(all);
  memory.set(counts, all.length);
  // prettier-ignore
  const status = wasm.make_polygon(
    place(), all.length / 2, place(all.length), counts.length, x, y, lawAt, lawLength,
  );
  return prepared(kind, false, status, law);
}

export function bar(options) {
  const { length, ...law } = fields("the bar", options);
  return named("bar", `bar:${number("length", length)}`, 0, false, law);
}

export function ellipse(options) {
  return elliptic("ellipse", options);
}

export function hertzEllipse(options) {
  return elliptic("hertzEllipse", options);
}

function elliptic(kind, options) {
  const { a, b, ...law } = fields("the ellipse", options);
  const name = kind === "ellipse" ? kind : "hertz-ellipse";
  return named(kind, `${name}:${number("a", a)}x${number("b", b)}`, 0, false, law);
}

export function bolts(options) {
  const { count, radius, ...law } = fields("the bolts", options);
  return named("bolts", `bolts:${number("count", count)}x${number("radius", radius)}`, 0, false, law);
}

export function points(options) {
  const { points: given, ...law } = fields("the patch", options);
  const all = flat("points", given, 3);
  const [lawAt, lawLength] = texts(all.length, lawLine(law));
  room(all.length).set(all);
  const status = wasm.make_points(place(), all.length / 3, lawAt, lawLength);
  return prepared("points", false, status, law);
}

export function mesh(options) {
  const { vertices, triangles, ...law } = fields("the mesh", options);
  const [corners, named] = [flat("vertices", vertices, 3), flat("triangles", triangles, 3)];
  for (const vertex of named) whole("triangles", vertex, 0, corners.length / 3 - 1);
  const total = corners.length + named.length;
  const [lawAt, lawLength] = texts(total, lawLine(law));
  const memory = room(total);
  memory.set(corners);
  memory.set(named, corners.length);
  // prettier-ignore
  const status = wasm.make_mesh(
    place(), corners.length / 3, place(corners.length), named.length / 3, lawAt, lawLength,
  );
  return prepared("mesh", false, status, law);
}
