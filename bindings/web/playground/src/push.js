// Pushes at a point of the outline of a patch, and the motions that they cause.

const TURN = 2 * Math.PI;
const CIRCLE = 90;

/** The outline of a patch as corners, counterclockwise. */
export function rimOf(corners) {
  if (corners === null) {
    return Array.from({ length: CIRCLE }, (_, index) => {
      const angle = (TURN * index) / CIRCLE;
      return [Math.cos(angle), Math.sin(angle)];
    });
  }
  const area = corners.reduce((sum, [x, y], index) => {
    const [a, b] = corners[(index + 1) % corners.length];
    return sum + x * b - a * y;
  }, 0);
  return area > 0 ? corners : [...corners].reverse();
}

/** Place and inward normal at a part of the length of an outline. */
export function contactAt(rim, part) {
  const edges = rim.map(([x, y], index) => {
    const [a, b] = rim[(index + 1) % rim.length];
    return { x, y, dx: a - x, dy: b - y, length: Math.hypot(a - x, b - y) };
  });
  let left = (((part % 1) + 1) % 1) * edges.reduce((sum, { length }) => sum + length, 0);
  const edge = edges.find(({ length }) => (left -= length) <= 0) ?? edges.at(-1);
  const along = 1 + left / edge.length;
  const place = [edge.x + along * edge.dx, edge.y + along * edge.dy];
  return { place, normal: [-edge.dy / edge.length, edge.dx / edge.length] };
}

/** The same on the unit circle, whose normal is the radius: a push along it has no torque. */
export function circleContactAt(part) {
  const [x, y] = [Math.cos(TURN * part), Math.sin(TURN * part)];
  return { place: [x, y], normal: [-x, -y] };
}

/** The wrench of a unit force at a contact, turned from the normal by an angle. */
export function wrenchAt({ place: [x, y], normal: [nx, ny] }, angle) {
  const [c, s] = [Math.cos(angle), Math.sin(angle)];
  const [fx, fy] = [c * nx - s * ny, s * nx + c * ny];
  return { fx, fy, torque: x * fy - y * fx };
}

/** Velocity of a point of the body. */
export const velocityAt = ({ vx, vy, spin }, [x, y]) => [vx - spin * y, vy + spin * x];

/** Where nothing moves; null for pure sliding. */
export function centreOf({ vx, vy, spin }) {
  return Math.abs(spin) < 1e-9 ? null : [-vy / spin, vx / spin];
}

/** The motions at the edges of the friction cone of a contact. */
export function motionCone(surface, contact, coefficient) {
  const edge = Math.atan(coefficient);
  return [-edge, edge].map((angle) => surface.normal(wrenchAt(contact, angle)));
}
