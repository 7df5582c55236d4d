// One row of the diagram of final motions: one law under every inertia ratio.

/** Ratios v/(ωR) at which the colour is known: evenly spaced decades from 1/20 to 20. */
const LARGEST = 20;
const STOPS = 21;
const RATIOS = Array.from({ length: STOPS }, (_, index) => LARGEST ** (1 - (2 * index) / (STOPS - 1)));

/**
 * The motion that is last under the friction of a patch of radius 1. Below the inertia ratio `low` it is
 * sliding, above `high` spinning. Between them both end together, at the ratios of `stops` (pairs of inertia
 * ratio and v/(ωR), the inertia ratio rising), or the launch decides, and there are no stops.
 */
export function rowOf(friction) {
  const [low, high] = friction.modes(1).inertiaInterval;
  // Above the exponent 1 the ratio that stays repels its neighbours.
  const stops = friction.alpha < 1 ? RATIOS.map((ratio) => [inertiaOf(friction, ratio), ratio]) : [];
  return { low, high, stops };
}

/** The inertia ratio under which a ratio v/(ωR) stays: C = ε T/F. */
function inertiaOf(friction, ratio) {
  const { fx, torque } = friction.wrench({ vx: ratio, vy: 0, spin: 1 }, 1);
  return (ratio * torque) / fx;
}
