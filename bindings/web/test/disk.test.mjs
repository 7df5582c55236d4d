// Disks under Coulomb friction, as the entry `tribos` has them.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { digests, small } from "./bits.mjs";
import { expected, file } from "./setup.mjs";
import * as tribos from "../index.js";

test("before init every call says what is missing", () => {
  assert.throws(() => tribos.disk({ radius: 0.04, mu: 0.3 }), /await init\(\) first/);
});

test("init refuses what is no module, and can be tried again", async () => {
  await assert.rejects(tribos.init(7), TypeError);
  await assert.rejects(tribos.init(new Uint8Array([1, 2, 3])), WebAssembly.CompileError);
  await assert.rejects(tribos.init(file("dist/nothing.wasm")), /ENOENT/);
  await tribos.init();
  await tribos.init();
});

const near = (a, b, most = 1e-12) => assert.ok(Math.abs(a - b) <= most, `${a} is not ${b}`);
const made = () => tribos.disk({ radius: 0.04, mu: 0.3 });

test("friction is mu N against sliding, 2/3 mu N R against spinning, less for both at once", () => {
  const puck = made();
  assert.deepEqual(puck.wrench({ vx: 2, vy: 0, spin: 0 }, 10), { fx: -3, fy: -0, torque: -0 });
  near(puck.wrench({ vx: 0, vy: 0, spin: -1 }, 10).torque, (2 / 3) * 3 * 0.04);
  const both = puck.wrench({ vx: 1, vy: 0, spin: 20 }, 10);
  assert.ok(both.fx > -3 && both.torque > -0.08 && both.fx < 0 && both.torque < 0);
  assert.deepEqual([puck.kind, puck.isRound, puck.alpha], ["disk", true, 0]);
});

test("the Jacobian is the derivative of the wrench", () => {
  const puck = made();
  const at = { vx: 0.5, vy: -0.2, spin: 9 };
  const jacobian = puck.jacobian(at, 10);
  const step = 1e-6;
  for (const [column, key] of ["vx", "vy", "spin"].entries()) {
    const [more, less] = [1, -1].map((sign) => puck.wrench({ ...at, [key]: at[key] + sign * step }, 10));
    for (const [row, force] of ["fx", "fy", "torque"].entries()) {
      near(jacobian[3 * row + column], (more[force] - less[force]) / (2 * step), 1e-6);
    }
  }
});

test("a batch has the bits of single calls, also after the memory has grown", () => {
  const puck = made();
  const count = 30_000; // 240,000 numbers: several pages more
  const twists = Float64Array.from({ length: 3 * count }, (_, index) => Math.sin(index));
  const before = puck.wrenches(twists.subarray(0, 30), 2);
  const kept = before.slice();
  const all = puck.wrenches(twists, 2);
  const jacobians = puck.jacobians(twists, 2);
  assert.deepEqual(before, kept);
  for (const index of [0, 7, count - 1]) {
    const [vx, vy, spin] = twists.subarray(3 * index);
    const { fx, fy, torque } = puck.wrench({ vx, vy, spin }, 2);
    assert.deepEqual([...all.subarray(3 * index, 3 * index + 3)], [fx, fy, torque]);
    const single = puck.jacobian({ vx, vy, spin }, 2);
    assert.deepEqual(jacobians.slice(9 * index, 9 * index + 9), single);
  }
  const loads = Array.from({ length: count }, (_, index) => index % 7);
  const under = puck.wrenches(twists, loads);
  assert.deepEqual(under.slice(6, 9), all.slice(6, 9));
  assert.ok(under[0] === 0 && under[2] === 0);
  const out = new Float64Array(3 * count);
  assert.equal(puck.wrenches(twists, 2, out), out);
  assert.deepEqual(out, all);
});

test("a push that the surface holds stays as it is, others are carried by the surface", () => {
  const surface = made().limitSurface(10);
  const held = { fx: 1, fy: 0.5, torque: 0.01 };
  assert.ok(surface.contains(held));
  const kept = surface.project(held);
  assert.deepEqual([kept.fx, kept.fy, kept.torque, kept.slides], [1, 0.5, 0.01, false]);
  const carried = surface.project({ fx: 3, fy: 0, torque: 0.2 });
  near(surface.gauge(carried), 1);
  assert.ok(carried.slides);
  const { vx, vy, spin } = carried.normal;
  near(vx * vx + vy * vy + (spin * surface.radius) ** 2, 1);
  const friction = surface.wrench(carried.normal);
  near(friction.fx, -carried.fx, 1e-9);
  near(surface.support({ vx: 2, vy: 0, spin: 0 }), 6);
  const curve = surface.meridian(9);
  near(curve[2], -surface.torqueLimit);
  near(curve[3 * 4], surface.forceLimit);
  const gauges = surface.gauges(curve);
  gauges.forEach((gauge) => near(gauge, 1));
});

test("a body that friction holds rests, one that is pushed harder moves", () => {
  const body = made().body({ mass: 0.17, inertia: 1.36e-4 });
  const still = { vx: 0, vy: 0, spin: 0 };
  const held = body.step(still, { fx: 0.4, fy: 0, torque: 0 }, 0.01);
  assert.deepEqual([held.vx, held.fx, held.isAtRest], [0, -0.4, true]);
  const moved = body.step(still, { fx: 0.6, fy: 0, torque: 0 }, 0.01);
  near(moved.vx, ((0.6 - 0.3 * 0.17 * 9.81) / 0.17) * 0.01);
  assert.equal(moved.isAtRest, false);
});

test("a puck comes to rest where time steps bring it, spinning carries it farther", () => {
  const body = made().body({ mass: 0.17, inertia: 1.36e-4 });
  const twist = { vx: 0.6, vy: 0.8, spin: 20 };
  const rest = body.slide(twist);
  const plain = body.slide({ ...twist, spin: 0 });
  near(plain.distance, 1 / (2 * 0.3 * 9.81));
  assert.ok(rest.distance > 1.1 * plain.distance);
  near(rest.ratio, 0.653001789, 1e-8);
  const rows = body.rollout(twist, { dt: 1e-4, steps: 10_000 });
  const last = rows.subarray(rows.length - 7);
  near(last[1], rest.x, 1e-6);
  near(last[3], rest.angle, 1e-4);
  assert.deepEqual([...last.subarray(4)], [0, 0, 0]);
  const path = body.slidePath(twist, 11);
  assert.equal(path.length, 77);
  near(path[70], rest.time);
  near(path[71], rest.x);
  const half = body.advance(twist, path[35]);
  near(half.x, path[36]);
  assert.equal(half.isAtRest, false);
  const after = body.advance(twist, 10);
  assert.deepEqual([after.x, after.vx, after.isAtRest], [rest.x, 0, true]);
});

test("the final motion is that of the theory", () => {
  const modes = made().modes(0.5);
  near(modes.finalRatio, 0.653001789205598, 1e-12);
  assert.equal(modes.finalMode, "together");
  assert.deepEqual(modes.inertiaInterval, [0.25, 2 / 3]);
  assert.equal(made().modes(1).finalMode, "spinning");
  assert.equal(made().modes(0.1).finalMode, "sliding");
});

test("wrong numbers are refused in the kernel's words, motions never", () => {
  const puck = made();
  const body = { mass: 1, inertia: 1 };
  const still = { vx: 0, vy: 0, spin: 0 };
  const refusals = [
    [() => tribos.disk({ radius: -1, mu: 0.3 }), RangeError, /contact radius must be positive.*not -1/],
    [() => tribos.disk({ radius: 1, mu: -0.3 }), RangeError, /coefficient must be finite.*not -0.3/],
    [() => tribos.disk({ radius: "1", mu: 0.3 }), TypeError, /radius must be a number/],
    [() => tribos.disk(), TypeError, /disk must be an object/],
    [() => puck.body({ ...body, mass: 0 }), RangeError, /the mass must be positive.*not 0/],
    [() => puck.body({ ...body, load: -1 }), RangeError, /load must be >= 0/],
    [() => puck.body(body).step(still, null, 0), RangeError, /time step must be positive.*not 0/],
    [() => puck.body({ ...body, mu: 1, load: 0 }).slide(still), RangeError, /deceleration/],
    [() => puck.wrench(still, -1), RangeError, /load must be >= 0, not -1/],
    [() => puck.wrench({ x: 1 }, 1), TypeError, /twist.vx must be a number/],
    [() => puck.wrenches([1, 2], 1), TypeError, /rows of 3/],
    [() => puck.wrenches([1, 2, 3], [1, 2]), RangeError, /1 twists and 2 loads/],
    [() => puck.wrenches([1, 2, 3], 1, []), TypeError, /Float64Array of 3/],
    [() => puck.limitSurface(NaN), RangeError, /force limit/],
    [() => puck.limitSurface(1).ellipsoid(), RangeError, /tribos\/all/],
    [() => puck.body({ mass: 1, inertia: 1, muStatic: 0.4 }), RangeError, /tribos\/all/],
    [() => puck.limitSurface(1).meridian(1), RangeError, /count must be a whole number/],
    [() => puck.modes(-1), RangeError, /inertia ratio/],
  ];
  for (const [call, kind, words] of refusals) assert.throws(call, { name: kind.name, message: words });
  assert.ok(Number.isNaN(puck.wrench({ vx: NaN, vy: 0, spin: 1 }, 1).torque));
  assert.ok(Number.isNaN(puck.body(body).slide({ vx: NaN, vy: 0, spin: 1 }).time));
  const { fx, fy, torque } = puck.wrench(still, 1);
  assert.ok(fx === 0 && fy === 0 && torque === 0);
});

test("it has the bits of the kernel", (context) => {
  const lines = expected();
  if (lines === undefined) return context.skip("dist/bits.txt is made by cargo test -p tribos-web");
  const own = digests(tribos, small);
  assert.deepEqual(own, lines.slice(0, own.length));
});

test("the small module has no heap and no panic", () => {
  const bytes = readFileSync(file("dist/tribos.wasm"));
  for (const word of ["panicked", "alloc"]) assert.ok(!bytes.includes(word), word);
});
