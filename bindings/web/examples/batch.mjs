// What a call and a batch cost: node examples/batch.mjs

import * as tribos from "../all.js"; // in a project of yours: "tribos/all"

await tribos.init();
const ROUNDS = 30;

/** Nanoseconds of one of `count` calls, the least of some rounds. */
function time(count, run) {
  let least = Infinity;
  for (let round = 0; round < ROUNDS; round++) {
    const start = performance.now();
    run(count);
    least = Math.min(least, performance.now() - start);
  }
  return ((1e6 * least) / count).toFixed(0);
}

const notch = [0, 0, 0.4, 0, 0.4, 0.3, 0.2, 0.1, 0, 0.3];
const patches = {
  disk: tribos.disk({ radius: 0.04, mu: 0.3 }),
  "disk, |v|^0.5": tribos.disk({ radius: 0.04, mu: 0.3, alpha: 0.5 }),
  ring: tribos.ring({ radius: 0.04, mu: 0.3 }),
  hertz: tribos.hertz({ radius: 0.04, mu: 0.3 }),
  "polygon of 5 corners": tribos.polygon({ corners: notch, mu: 0.3 }),
};
const twists = Float64Array.from({ length: 3 * 4096 }, (_, index) => Math.sin(index));
const out = new Float64Array(twists.length);
const jacobians = new Float64Array(3 * twists.length);
for (const [name, friction] of Object.entries(patches)) {
  const one = { vx: 0, vy: 0, spin: 0 };
  const single = time(4096, (count) => {
    for (let call = 0; call < count; call++) {
      one.vx = twists[3 * call];
      one.vy = twists[3 * call + 1];
      one.spin = twists[3 * call + 2];
      friction.wrench(one, 1.7);
    }
  });
  const batch = time(4096, () => friction.wrenches(twists, 1.7, out));
  const slopes = time(4096, () => friction.jacobians(twists, 1.7, jacobians));
  console.log(`${name}: ${single} ns a wrench, ${batch} in a batch, ${slopes} a Jacobian in a batch`);
  if (friction.alpha !== 0) continue;
  const surface = friction.limitSurface(1.7);
  const body = friction.body({ mass: 0.17, inertia: 1.36e-4 });
  const projection = time(500, (count) => {
    for (let call = 0; call < count; call++) surface.project({ fx: 0.6, fy: 1e-4 * call, torque: 0.01 });
  });
  const twist = { vx: 1, vy: 0.2, spin: 0 };
  const step = time(500, (count) => {
    for (let call = 0; call < count; call++) {
      twist.spin = 0.1 * call;
      body.step(twist, null, 1e-3);
    }
  });
  const slide = time(4, (count) => {
    for (let call = 0; call < count; call++) body.slide(twist);
  });
  console.log(`  ${projection} ns a projection, ${step} a step, ${(slide / 1000).toFixed(0)} µs a slide to rest`);
}
