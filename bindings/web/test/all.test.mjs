// Everything, as the entry `tribos/all` has it.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { digests, others, small } from "./bits.mjs";
import { expected, file } from "./setup.mjs";
import { init as initSmall, disk as smallDisk } from "../index.js";
import * as tribos from "../all.js";
import { wasm } from "../js/wasm.js";

const near = (a, b, most = 1e-12) => assert.ok(Math.abs(a - b) <= most, `${a} is not ${b}`);

test("a module, bytes or a response load it, and what was there before goes on", async () => {
  await initSmall(readFileSync(file("dist/tribos.wasm")));
  const puck = smallDisk({ radius: 0.04, mu: 0.3 });
  const before = puck.wrench({ vx: 1, vy: 0, spin: 20 }, 1.7);
  const type = { headers: { "content-type": "application/octet-stream" } };
  const response = new Response(readFileSync(file("dist/all.wasm")), type);
  await tribos.init(Promise.resolve(response));
  await initSmall();
  assert.deepEqual(puck.wrench({ vx: 1, vy: 0, spin: 20 }, 1.7), before);
  assert.equal(tribos.ring({ radius: 0.04, mu: 0.3 }).kind, "ring");
});

test("a ring resists spinning by mu N R, an annulus nearly", () => {
  const spin = { vx: 0, vy: 0, spin: 3 };
  near(tribos.ring({ radius: 0.1, mu: 0.5 }).wrench(spin, 2).torque, -0.1);
  const thin = tribos.annulus({ inner: 0.0999, radius: 0.1, mu: 0.5 });
  near(thin.wrench(spin, 2).torque, -0.1, 1e-3);
});

test("under mu |v| friction of sliding and spinning is linear", () => {
  const wet = tribos.disk({ radius: 0.1, mu: 0.5, alpha: 1 });
  const { fx, torque } = wet.wrench({ vx: 3, vy: 0, spin: 4 }, 2);
  near(fx, -3);
  near(torque, -0.5 * 2 * 4 * 0.5 * 0.1 ** 2);
  assert.throws(() => wet.limitSurface(1), /needs dry friction/);
  assert.throws(() => wet.body({ mass: 1, inertia: 1 }).slide({ vx: 1, vy: 0, spin: 0 }), /never comes to rest/);
  const body = wet.body({ mass: 1, inertia: 0.01, load: 2 });
  near(body.advance({ vx: 1, vy: 0, spin: 0 }, 2).vx, Math.exp(-2));
});

test("a polygon need not be convex, has holes, and is centred where it is", () => {
  const square = [0, 0, 1, 0, 1, 1, 0, 1];
  const frame = tribos.polygon({
    corners: square,
    holes: [[[0.25, 0.25], [0.75, 0.25], [0.75, 0.75], [0.25, 0.75]]],
    mu: 0.5,
  });
  assert.deepEqual(frame.centre.map((x) => x.toFixed(12)), ["0.500000000000", "0.500000000000"]);
  assert.equal(frame.isRound, false);
  const slide = frame.wrench({ vx: 1, vy: 0, spin: 0 }, 10);
  near(slide.fx, -5);
  near(slide.torque, 2.5);
  const surface = frame.limitSurface(10);
  near(surface.gauge({ fx: 5, fy: 0, torque: -2.5 }), 1);
  const corner = tribos.polygon({ corners: [0, 0, 2, 0, 2, 1, 1, 1, 1, 2, 0, 2], mu: 1 });
  near(corner.centre[0], 5 / 6);
});

test("two coefficients, ellipses and bolts are those of their formulas", () => {
  const tread = tribos.box({ a: 0.2, b: 0.08, mu: [0.5, 0.9], axis: Math.PI / 2 });
  assert.equal(tread.mu, 0.9);
  near(tread.wrench({ vx: 0, vy: 0.1, spin: 0 }, 100).fy, -50);
  near(tread.wrench({ vx: 0.1, vy: 0, spin: 0 }, 100).fx, -90);
  near(tread.limitSurface(100).gauge({ fx: 0, fy: 50, torque: 0 }), 1);
  const round = tribos.disk({ radius: 0.1, mu: [0.5, 0.9] });
  assert.deepEqual([round.isRound, tribos.disk({ radius: 0.1, mu: [0.5, 0.5] }).isRound], [false, true]);
  const circle = tribos.ellipse({ a: 0.1, b: 0.1, mu: 0.5 });
  near(circle.wrench({ vx: 0, vy: 0, spin: 3 }, 2).torque, -0.5 * 2 * 0.1 * (2 / 3));
  // 3/8 mu N a E(e), with E of e² = 5/9.
  const wheel = tribos.hertzEllipse({ a: 0.006, b: 0.004, mu: 0.3 });
  near(wheel.wrench({ vx: 0, vy: 0, spin: 1 }, 5e4).torque, -0.375 * 0.3 * 5e4 * 0.006 * 1.3221199657742158);
  near(tribos.bolts({ count: 6, radius: 0.1, mu: 0.5 }).wrench({ vx: 0, vy: 0, spin: 3 }, 2).torque, -0.1);
  assert.throws(() => tribos.ellipse({ a: 0.1, b: 0, mu: 0.5 }), RangeError);
  assert.throws(() => tribos.box({ a: 1, b: 1, mu: [0.5, 0] }), { name: "RangeError", message: /across/ });
  assert.throws(() => tribos.box({ a: 1, b: 1, mu: 0.5, axis: 1 }), /axis goes with/);
  assert.throws(() => tribos.disk({ radius: 1, mu: [0.5, 0.9], alpha: 1 }), /without alpha/);
});

test("a parcel on two belts, and a robot that turns in place, find their steady motion", () => {
  const parcel = tribos.box({ a: 0.3, b: 0.2, mu: 0.4 });
  const belt = { corners: [0, 0, 1, 0], twist: { vx: 0.5, vy: 0, spin: 0 } };
  const still = { vx: 0, vy: 0, spin: 0 };
  // Half of the load on the belt: mu N/2 along it, at b/4.
  const held = parcel.wrench(still, 20, { surface: [belt] });
  near(held.fx, 4);
  near(held.torque, -4 * 0.05);
  assert.ok(parcel.jacobian(still, 20, { surface: [] }).every((entry) => entry === 0));
  const motion = parcel.steadyMotion(20, [belt]);
  near(motion.twist.vx, 0.25);
  assert.ok(motion.twist.spin < 0 && motion.carriedBy === null && motion.evaluations < 25);
  const floor = parcel.onSurfaces(20, [belt, { corners: [[0, -1], [1, -1], [1, 0], [0, 0]] }]);
  assert.equal(floor.count, 3);
  near(floor.forceLimit, 8);
  assert.throws(() => floor.steadyMotion({ fx: 8.1, fy: 0, torque: 0 }), /no motion is steady: the push is more than the/);
  floor.free();
  assert.throws(() => floor.wrench(still), /freed/);
  const wheel = tribos.box({ a: 0.04, b: 0.02, mu: 0.7 });
  const foot = (x, y) => ({
    ...{ friction: wheel, load: 75, place: [x, y] },
    surface: { vx: y < 0 ? 0.2 : -0.2, vy: 0, spin: 0 },
  });
  const places = [-0.2, 0.2].flatMap((x) => [-0.25, 0.25].map((y) => foot(x, y)));
  near(tribos.feet(places).steadyMotion().twist.spin, 0.488, 5e-4);
  const taken = tribos.feet([{ friction: tribos.disk({ radius: 0.1, mu: 0.3 }), load: 2, place: [1, 0], surface: { vx: 1, vy: 0, spin: 2 } }]);
  assert.deepEqual(taken.steadyMotion(), {
    ...{ twist: { vx: 1, vy: 0, spin: 2 }, friction: { fx: -0, fy: -0, torque: -0 } },
    ...{ carriedBy: 0, evaluations: 1 },
  });
  assert.throws(() => tribos.feet([{ friction: {}, load: 1, place: [0, 0] }]), /friction of a foot/);
  assert.throws(() => tribos.feet([]), RangeError);
  const oil = tribos.disk({ radius: 0.1, mu: 0.3, alpha: 1 });
  assert.throws(() => oil.onSurfaces(1, [belt]), /need dry friction/);
});

test("static friction holds a body until it is exceeded, whatever the step", () => {
  const crate = tribos.box({ a: 0.4, b: 0.3, mu: 0.5 });
  const given = { mass: 8, inertia: 0.17, load: 80 };
  const still = { vx: 0, vy: 0, spin: 0 };
  // 40 N in motion, 56 N at rest.
  const body = crate.body({ ...given, muStatic: 0.7 });
  for (const dt of [1e-5, 1e-2, 1]) {
    const [held, let_go] = [1 - 1e-9, 1 + 1e-9].map((share) => body.step(still, { fx: 56 * share, fy: 0, torque: 0 }, dt, 0.3));
    assert.deepEqual([held.isAtRest, held.vx, let_go.isAtRest], [true, 0, false]);
    near(let_go.vx, (16 / 8) * dt, 1e-7 * dt);
  }
  const push = { fx: 50, fy: 0, torque: 0 };
  const path = (muStatic) => crate.body({ ...given, muStatic }).rollout(still, { dt: 0.01, steps: 5, push });
  near(path(undefined)[7 * 5 + 4], (10 / 8) * 0.05);
  assert.equal(path(0.7)[7 * 5 + 4], 0);
  assert.deepEqual(path(0.5), path(undefined));
  assert.equal(crate.body(given).muStatic, 0.5);
  assert.throws(() => crate.body({ ...given, muStatic: 0.4 }), { name: "RangeError", message: /at least mu, 0.5, not 0.4/ });
  assert.throws(() => crate.body({ ...given, muStatic: NaN }), RangeError);
  assert.throws(() => crate.body({ ...given, muStatic: "1" }), TypeError);
});

test("feet carry together what statics says, and step on what moves", () => {
  const pad = tribos.disk({ radius: 1e-5, mu: 0.5 });
  const still = { vx: 0, vy: 0, spin: 0 };
  const foot = (x, load, vx) => ({ friction: pad, load, place: [x, 0], surface: { ...still, vx } });
  const pair = tribos.feet([foot(-0.1, 10, 0), foot(0.3, 30, 0)]);
  near(pair.patch.centre[0], 0.2);
  const surface = pair.limitSurface();
  near(surface.forceLimit, 20);
  // Pure force through the centre of friction; pure torque, in which both feet pull across their line.
  near(surface.gauge({ fx: 0, fy: 10, torque: 10 * 0.2 }), 0.5, 1e-8);
  near(surface.support({ ...still, spin: 1 }), 5 * 0.1 + 15 * 0.3, 1e-8);
  // Pushed beside the weaker foot it turns about the stronger one.
  const { vy, spin } = surface.normal({ fx: 0, fy: 10, torque: -1.5 });
  near(vy / spin, -0.3, 1e-6);
  const nearest = surface.project({ fx: 0, fy: 50, torque: 50 * 0.2 }, 1e9);
  assert.ok(nearest.slides);
  near(nearest.fy, 20, 1e-7);
  // Both belts alike take the body along: mu N dt/M until it has their speed, and then to the last bit.
  const belts = tribos.feet([foot(-0.1, 10, 2), foot(0.1, 10, 2)]);
  const body = { mass: 2, inertia: 0.1 };
  const gains = belts.step(body, still, null, 0.01);
  near(gains.twist.vx, (10 / 2) * 0.01);
  assert.equal(gains.carriedBy, null);
  assert.ok(Math.abs(gains.imbalance) < 1e-14);
  const taken = belts.step(body, { ...still, vx: 1.99 }, { fx: 1, fy: 0, torque: 0 }, 0.01);
  assert.deepEqual([taken.twist, taken.carriedBy], [{ vx: 2, vy: 0, spin: 0 }, 0]);
  assert.throws(() => belts.step({ mass: 0, inertia: 1 }, still, null, 0.01), /mass must be positive/);
  const { patch } = belts;
  belts.free();
  assert.throws(() => patch.limitSurface(1), /freed/);
  assert.throws(() => belts.limitSurface(), /freed/);
});

test("a worn annulus resists spinning at its mean radius", () => {
  const clutch = tribos.wornAnnulus({ inner: 0.06, radius: 0.1, mu: 0.35 });
  near(clutch.wrench({ ...{ vx: 0, vy: 0 }, spin: 20 }, 4000).torque, -0.35 * 4000 * 0.08, 1e-9);
  near(clutch.limitSurface(4000).torqueLimit, 112, 1e-9);
  assert.throws(() => tribos.wornAnnulus({ inner: 0.06, radius: 0.1, mu: 0.35, alpha: 1 }), /dry friction/);
});

test("a body at rest stays there, in no time", () => {
  const still = { vx: 0, vy: 0, spin: 0 };
  for (const model of ["exact", "ellipsoid", "separate"]) {
    const { time, distance } = tribos.disk({ radius: 0.1, mu: 0.3 }).body({ mass: 1, inertia: 0.01, model }).slide(still);
    assert.deepEqual([time, distance], [0, 0], model);
  }
});

test("a polygon slides to rest and turns as it goes", () => {
  const crate = tribos.box({ a: 0.4, b: 0.2, mu: 0.5 });
  const body = crate.body({ mass: 2, inertia: (2 * (0.16 + 0.04)) / 12 });
  const straight = body.slide({ vx: 1, vy: 0, spin: 0 });
  near(straight.distance, 1 / (2 * 0.5 * 9.81), 1e-6);
  const rest = body.slide({ vx: 1, vy: 0, spin: 8 });
  assert.ok(rest.distance > straight.distance && rest.angle > 0.1);
  const path = body.slidePath({ vx: 1, vy: 0, spin: 8 }, 500);
  near(path[path.length - 6], rest.x, 1e-5);
  assert.throws(() => crate.body({ mass: 1, inertia: 1, load: 0 }).slide({ vx: 1, vy: 0, spin: 0 }), /friction is 0/);
});

test("approximate models hold the exact set, and are exact for one motion alone", () => {
  const surface = tribos.disk({ radius: 0.04, mu: 0.3 }).limitSurface(10);
  const models = [surface, surface.ellipsoid(), surface.separate()];
  assert.deepEqual(models.map(({ model }) => model), ["exact", "ellipsoid", "separate"]);
  const gauges = models.map((model) => model.gauge({ fx: 2, fy: 0, torque: 0.05 }));
  assert.ok(gauges[0] > gauges[1] && gauges[1] > gauges[2]);
  for (const model of models) {
    near(model.gauge({ fx: 0, fy: 3, torque: 0 }), 1);
    near(model.torqueLimit, 0.08);
  }
  const puck = tribos.disk({ radius: 0.04, mu: 0.3 });
  const [exact, other] = ["exact", "separate"].map((model) =>
    puck.body({ mass: 1, inertia: 8e-4, model }).step({ vx: 1, vy: 0, spin: 20 }, null, 1e-3),
  );
  near(other.vx, 1 - 0.3 * 9.81e-3);
  assert.ok(exact.vx > other.vx);
});

test("launches end at the wanted pose", () => {
  const body = tribos.disk({ radius: 0.08, mu: 0.3 }).body({ mass: 1, inertia: 0.0032 });
  const wanted = { x: 1.2, y: 0.3, angle: 1.57, maxSpeed: 3, maxSpin: 100 };
  const throws = body.launches(wanted);
  assert.equal(throws.length, 33);
  for (const launch of throws) {
    const rest = body.slide(launch);
    near(rest.x, 1.2, 1e-11);
    near(Math.cos(rest.angle - 1.57), 1, 1e-11);
  }
  assert.equal(body.launches({ ...wanted, most: 2 }).length, 2);
  assert.equal(body.launches({ ...wanted, turns: "exact" }).length, 1);
  assert.throws(() => body.launches({ ...wanted, x: 50 }), { name: "RangeError", message: /out of reach/ });
  const crate = tribos.box({ a: 1, b: 1, mu: 0.5 }).body({ mass: 1, inertia: 1 });
  assert.equal(crate.launches, undefined);
});

test("fixed points over exponents", () => {
  for (const alpha of [0, 0.5, 0.9, 1.5]) {
    const { fixedPoints, restsInFiniteTime } = tribos.disk({ radius: 1, mu: 1, alpha }).modes(0.5, 1);
    assert.equal(restsInFiniteTime, alpha < 1);
    assert.equal(fixedPoints[0].ratio, 0);
    assert.equal(fixedPoints.at(-1).ratio, Infinity);
  }
});

test("laws are those of the catalogue", () => {
  const oil = tribos.law("stribeck", { mu_s: 0.4, mu_d: 0.2, vs: 0.05 });
  near(oil.friction(-0.05), 0.2 + 0.2 / Math.E);
  assert.deepEqual(oil.parameters, { mu_s: 0.4, mu_d: 0.2, vs: 0.05, delta: 2, k: 0 });
  assert.deepEqual([...oil.frictions([0, 0.05])], [0.4, oil.friction(0.05)]);
  const bearing = tribos.disk({ radius: 0.04, law: oil });
  near(bearing.wrench({ vx: 9, vy: 0, spin: 0 }, 10).fx, -2, 1e-7);
  assert.ok(Number.isNaN(bearing.alpha));
  const names = tribos.laws().map(({ name }) => name);
  assert.ok(names.includes("coulomb") && names.includes("stribeck"));
  assert.throws(() => tribos.law("stribek"), /did you mean `stribeck`/);
  assert.throws(() => tribos.law("stribeck", { mu_s: "1" }), TypeError);
});

test("a support of any pressure bounds the exact one", () => {
  const corners = [-0.2, -0.1, 0.2, -0.1, 0.2, 0.1, -0.2, 0.1];
  const any = tribos.anyPressure({ corners, centre: [0, 0], forceLimit: 5 });
  const box = tribos.box({ a: 0.4, b: 0.2, mu: 0.5 }).limitSurface(10);
  const push = { fx: 3, fy: 0, torque: 0.2 };
  const [, most] = any.gaugeBounds(push);
  assert.ok(box.gauge(push) <= 1 / 0 && most > 0);
  assert.ok(any.support({ vx: 1, vy: 0, spin: 2 }) >= box.support({ vx: 1, vy: 0, spin: 2 }));
  assert.equal(any.torqueLimits(6, 0), null);
  const { carried, outer } = any.torqueLimits(1, 0);
  assert.ok(outer[0] <= carried[0] && carried[1] <= outer[1]);
});

test("equal balls exchange their velocities, a sliding ball begins to roll", () => {
  const ball = (x) => ({ velocity: [x, 0, 0], mass: 0.17, radius: 0.0286 });
  const hit = tribos.contactLaw({ restitution: 1 }).collide(ball(2), ball(0), { normal: [1, 0, 0] });
  assert.deepEqual([hit.first.velocity[0], hit.second.velocity[0]], [0, 2]);
  near(hit.normal, 0.34);
  const cloth = tribos.contactLaw({ mu: 0.2 });
  let { velocity, spin } = { velocity: [1, 0, 0], spin: [0, 0, 0] };
  const dt = 1e-3;
  for (let step = 0; step < 400; step++) {
    velocity[2] -= 9.81 * dt;
    const falling = { velocity, spin, mass: 0.17, radius: 0.0286 };
    ({ velocity, spin } = cloth.collide(falling, {}, { normal: [0, 0, -1], dt }).first);
  }
  near(velocity[0], 5 / 7);
  assert.throws(() => cloth.collide(ball(1), {}, { normal: [0, 0, -2] }), /length 1/);
  assert.throws(() => tribos.contactLaw({ mu: -1 }), /sliding coefficient/);
});

test("wrong numbers and words are refused", () => {
  const { ring, polygon, disk, annulus } = tribos;
  const bow = [0, 0, 1, 1, 1, 0, 0, 1];
  const refusals = [
    [() => ring({ radius: 0.1 }), TypeError, /either mu.*or law/],
    [() => ring({ radius: 0, mu: 1 }), RangeError, /contact radius/],
    [() => ring({ radius: 0.1, mu: -1 }), RangeError, /coefficient/],
    [() => ring({ radius: 0.1, mu: 1, my: 2 }), TypeError, /no option "my"/],
    [() => disk({ radius: 0.1, mu: 0.3, alpha: -2 }), RangeError, /exponent alpha/],
    [() => annulus({ radius: 1, inner: 2, mu: 1 }), RangeError, /inner over the outer/],
    [() => polygon({ corners: bow, mu: 1 }), RangeError, /must not touch or cross/],
    [() => tribos.mesh({ vertices: [0, 0, 1, 1, 0, 1, 0, 1, 1], triangles: [0, 1, 3], mu: 1 }), RangeError, /from 0 to 2/],
    [() => tribos.bar({ length: 1, mu: 1, alpha: 0.5 }), RangeError, /dry friction/],
    [() => tribos.contactLaw({ mu: 1, patch: { kind: "bar", radius: 1 } }), RangeError, /disk or ring/],
    [() => polygon({ corners: [0, 0, 1], mu: 1 }), TypeError, /rows of 2/],
    [() => polygon({ corners: [[0, 0], [1, 0], [1, "1"]], mu: 1 }), TypeError, /must be a number/],
  ];
  for (const [call, kind, words] of refusals) assert.throws(call, { name: kind.name, message: words });
});

test("freed objects say so, and nothing is kept that was freed", () => {
  const before = wasm.kept();
  const made = [
    tribos.ring({ radius: 0.1, mu: 1 }),
    tribos.law("coulomb", { mu: 1 }),
    tribos.contactLaw({ mu: 1 }),
    tribos.anyPressure({ corners: [0, 0, 1, 0, 0, 1], centre: [0.3, 0.3], forceLimit: 1 }),
  ];
  assert.equal(wasm.kept(), before + 4);
  for (const object of made) {
    object.free();
    object.free();
  }
  assert.equal(wasm.kept(), before);
  assert.throws(() => made[0].wrench({ vx: 1, vy: 0, spin: 0 }, 1), /freed/);
  assert.throws(() => made[1].friction(1), /freed/);
  // A handle that is used again belongs to the new object alone.
  const next = tribos.hertz({ radius: 0.1, mu: 1 });
  assert.throws(() => made[0].wrench({ vx: 1, vy: 0, spin: 0 }, 1), /freed/);
  next.free();
  const plain = tribos.disk({ radius: 0.1, mu: 1 });
  plain.free();
  assert.equal(plain.wrench({ vx: 1, vy: 0, spin: 0 }, 1).fx, -1);
});

test("it has the bits of the kernel, also after its memory has grown", (context) => {
  const lines = expected();
  if (lines === undefined) return context.skip("dist/bits.txt is made by cargo test -p tribos-web");
  const own = [...digests(tribos, small), ...digests(tribos, others)];
  assert.deepEqual(own, lines);
});
