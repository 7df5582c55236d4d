// The game: a target to be hit with place and angle, and the throws that hit it.

import { GRAVITY, isRound } from "./bodies.js";
import { isComplete } from "./kernel.js";
import { twistOf } from "./race.js";

/** Most launches that are listed. */
const LISTED = 200;
/** A hit is within half a radius and this angle in rad. */
const CLOSE = 0.5;
const ALIGNED = (15 * Math.PI) / 180;

/** Whether a body can play: the answer is known for round patches that rest. */
export const canPlay = (setup) => isComplete && isRound(setup);

/** A target that some throw with much spin hits. */
export function newTarget(setup, body) {
  const spin = (0.5 + 0.35 * Math.random()) * setup.maxSpin * (Math.random() < 0.5 ? -1 : 1);
  const speed = (0.35 + 0.4 * Math.random()) * setup.maxSpeed;
  const direction = (Math.random() - 0.5) * 0.5;
  const { x, y, angle } = body.slide(twistOf({ speed, direction, spin }));
  return { x, y, angle: wrapped(angle) };
}

/** How far a throw missed, and of all throws that hit the one of least energy and the one of most spin. */
export function judged(setup, body, target, rest) {
  const { x, y, angle } = target;
  const { maxSpeed, maxSpin } = setup;
  const miss = Math.hypot(rest.x - x, rest.y - y);
  const off = Math.abs(wrapped(rest.angle - angle));
  const isHit = miss <= CLOSE * setup.radius && off <= ALIGNED;
  const launches = body.launches({ x, y, angle, maxSpeed, maxSpin, most: LISTED });
  const points = Math.round(100 * Math.exp(-miss / (4 * setup.radius)) * (1 - off / (2 * Math.PI)));
  const gentle = least(launches, ({ energyPerMass }) => energyPerMass);
  const spinning = least(launches, ({ spin: turn }) => -Math.abs(turn));
  // Under separate limits the slide does not notice the spin.
  const short = Math.hypot(x, y) - plainDistance({ ...setup, speed: spinning.speed });
  return { miss, off, isHit, points, count: launches.length, gentle, spinning, short };
}

/** The element with the least value. */
const least = (list, value) => list.reduce((best, each) => (value(each) < value(best) ? each : best));

/** An angle from −π to π. */
function wrapped(angle) {
  return angle - 2 * Math.PI * Math.round(angle / (2 * Math.PI));
}

/** Distance of a throw without spin, in m. */
export const plainDistance = ({ mu, speed }) => (speed * speed) / (2 * mu * GRAVITY);
