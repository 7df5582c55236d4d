// A puck that is thrown without and with spin: node examples/throw.mjs

import { init, disk } from "../index.js"; // in a project of yours: "tribos"

await init();
const puck = disk({ radius: 0.04, mu: 0.3 }).body({ mass: 0.17, inertia: 1.36e-4 }); // m; kg, kg m²
const [still, spun] = [0, 40].map((spin) => puck.slide({ vx: 1, vy: 0, spin })); // m/s, rad/s
console.log(`slides ${still.distance.toFixed(4)} m without spin, ${spun.distance.toFixed(4)} m with it`);

// The way there, to be drawn: rows of time, x, y, angle, vx, vy, spin.
const rows = puck.slidePath({ vx: 1, vy: 0, spin: 40 }, 6);
for (let at = 0; at < rows.length; at += 7) {
  const [time, x, , angle] = rows.subarray(at);
  console.log(`${time.toFixed(3)} s  ${x.toFixed(4)} m  ${angle.toFixed(2)} rad`);
}
