// Bodies that can be thrown: their outline, friction and inertia.

import { kernel } from "./kernel.js";

export const MODELS = ["exact", "ellipsoid", "separate"];
export const GRAVITY = 9.81;

/** Coefficient, radius in m, mass in kg, width of the view in m, largest speed in m/s, usual spin in rad/s. */
export const GROUNDS = {
  carrom: { mu: 0.12, radius: 0.0206, mass: 0.015, view: 0.8, maxSpeed: 1.2, speed: 0.75, spin: 110 },
  ice: { mu: 0.03, radius: 0.0381, mass: 0.17, view: 2.6, maxSpeed: 1.5, speed: 1, spin: 80 },
  floor: { mu: 0.35, radius: 0.1, mass: 0.5, view: 1.6, maxSpeed: 4, speed: 2.6, spin: 70 },
};

const SIDES = [0.8, 0.6];
const OUTLINES = {
  box: [[-SIDES[0], -SIDES[1]], [SIDES[0], -SIDES[1]], SIDES, [-SIDES[0], SIDES[1]]],
  triangle: [
    [0, 0],
    [1, 0],
    [0.5, Math.sqrt(3) / 2],
  ],
  ell: [
    [0, 0],
    [3, 0],
    [3, 1],
    [1, 1],
    [1, 3],
    [0, 3],
  ],
};
/** Inner radius of round bodies with a hole, in radii. */
export const HOLES = { annulus: 0.5, ring: 1 };

export const isRound = ({ shape }) => shape === "puck" || shape in HOLES;

/** Corners about the centroid, the farthest at the radius; null for round bodies. */
export function outline({ shape, radius, drawn }) {
  const corners = shape === "drawn" ? drawn : OUTLINES[shape];
  return corners === undefined ? null : centred(corners, radius);
}

/** Corners moved and scaled. */
export function centred(corners, radius) {
  const { x, y } = momentsOf(corners);
  const moved = corners.map(([a, b]) => [a - x, b - y]);
  const scale = radius / Math.max(...moved.map(([a, b]) => Math.hypot(a, b)));
  return moved.map(([a, b]) => [a * scale, b * scale]);
}

/** Area, centroid, and second moment about the origin over the area, of a polygon. */
export function momentsOf(corners) {
  let [area, x, y, second] = [0, 0, 0, 0];
  corners.forEach(([ax, ay], index) => {
    const [bx, by] = corners[(index + 1) % corners.length];
    const cross = (ax * by - bx * ay) / 2;
    area += cross;
    x += (cross * (ax + bx)) / 3;
    y += (cross * (ay + by)) / 3;
    second += (cross * (ax * ax + ax * bx + bx * bx + ay * ay + ay * by + by * by)) / 6;
  });
  return { area, x: x / area, y: y / area, second: second / area };
}

/** Friction of the patch of a body. */
export function frictionOf(body) {
  const { shape, pressure, mu, radius } = body;
  const corners = outline(body);
  if (corners !== null) return kernel.polygon({ corners, mu });
  const alpha = body.alpha === 0 ? {} : { alpha: body.alpha };
  if (shape === "ring") return kernel.ring({ radius, mu, ...alpha });
  if (shape === "annulus") return kernel.annulus({ radius, inner: HOLES.annulus * radius, mu, ...alpha });
  const make = pressure === "uniform" ? kernel.disk : kernel[pressure];
  return make({ radius, mu, ...alpha });
}

/** Moment of inertia about the normal, in kg m², of a body that is as heavy everywhere as its patch. */
export function inertiaOf(body) {
  const { shape, mass, radius } = body;
  const corners = outline(body);
  const hole = HOLES[shape] ?? 0;
  const ratio = 0.5 * (1 + hole * hole);
  return mass * (corners === null ? ratio * radius * radius : momentsOf(corners).second);
}
