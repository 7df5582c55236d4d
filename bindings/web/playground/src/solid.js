// Limit surfaces in space, seen from a direction: force x and y in the plane, torque upwards.

import { arrow, palette, polyline } from "./canvas.js";

const MERIDIANS = 48;
const PARALLELS = 25;
const TURN = 2 * Math.PI;
/** Direction of the light, as the eye sees it. */
const LIGHT = [-0.35, 0.6, 0.72];
/** Length of the arrow of motion. */
const NORMAL = 0.55;

/** A grid of points on the exact surface: rows of meridians. */
export function meshOf(surface) {
  return Array.from({ length: MERIDIANS }, (_, index) => {
    const rows = surface.meridian(PARALLELS, (TURN * index) / MERIDIANS);
    return Array.from({ length: PARALLELS }, (_, row) => [...rows.subarray(3 * row, 3 * row + 3)]);
  });
}

/** A view of space on a canvas. */
export function viewOf(width, height, { yaw, pitch }) {
  const scale = 0.34 * Math.min(width, 1.15 * height);
  const [cy, sy, cp, sp] = [Math.cos(yaw), Math.sin(yaw), Math.cos(pitch), Math.sin(pitch)];
  const turned = ([x, y, z]) => {
    const [across, away] = [cy * x - sy * y, sy * x + cy * y];
    // Across, up, and towards the eye.
    return [across, cp * z + sp * away, sp * z - cp * away];
  };
  const toScreen = (point) => {
    const [x, y] = turned(point);
    return [width / 2 + scale * x, height / 2 - scale * y];
  };
  return { turned, toScreen };
}

/** Draws what is chosen, and the push with its motion. */
export function drawSolid(context, view, { mesh, surface, shows, push, normals }) {
  drawAxes(context, view);
  const { forceLimit, torqueLimit } = surface;
  if (shows.exact) drawMesh(context, view, mesh);
  if (shows.ellipsoid) drawWires(context, view, ellipsoidWires(forceLimit, torqueLimit), "ellipsoid", [6, 4]);
  if (shows.separate) drawWires(context, view, cylinderWires(forceLimit, torqueLimit), "separate", [2, 4]);
  for (const [model, { at, normal }] of Object.entries(normals)) {
    if (!shows[model]) continue;
    const tip = at.map((value, index) => value + NORMAL * normal[index]);
    const [from, to] = [view.toScreen(at), view.toScreen(tip)];
    arrow(context, from, [to[0] - from[0], to[1] - from[1]], palette()[model], 4);
  }
  const to = view.toScreen(push);
  polyline(context, [view.toScreen([0, 0, 0]), to], { color: palette().ink, width: 2 });
  context.beginPath();
  context.arc(...to, 6, 0, TURN);
  context.fillStyle = palette().ink;
  context.fill();
}

function drawAxes(context, view) {
  const { soft } = palette();
  context.font = "italic 15px Georgia, serif";
  context.textAlign = "center";
  for (const [name, end] of [
    ["Fx", [1.35, 0, 0]],
    ["Fy", [0, 1.35, 0]],
    ["T", [0, 0, 1.25]],
  ]) {
    const [from, to] = [view.toScreen(end.map((x) => -0.9 * x)), view.toScreen(end)];
    polyline(context, [from, to], { color: soft, width: 1 });
    context.fillStyle = soft;
    context.fillText(name, to[0], to[1] - 5);
  }
}

function drawMesh(context, view, mesh) {
  const faces = [];
  mesh.forEach((meridian, index) => {
    const next = mesh[(index + 1) % mesh.length];
    for (let row = 0; row + 1 < meridian.length; row += 1) {
      const corners = [meridian[row], next[row], next[row + 1], meridian[row + 1]];
      const seen = corners.map(view.turned);
      faces.push({ corners, depth: seen.reduce((sum, [, , z]) => sum + z, 0), light: lightOf(seen) });
    }
  });
  faces.sort((a, b) => a.depth - b.depth);
  const { exact } = palette();
  for (const { corners, light } of faces) {
    context.beginPath();
    for (const corner of corners) context.lineTo(...view.toScreen(corner));
    context.closePath();
    context.fillStyle = exact;
    context.globalAlpha = 0.1 + 0.3 * light;
    context.fill();
    context.globalAlpha = 0.16;
    context.lineWidth = 1;
    context.strokeStyle = exact;
    context.stroke();
  }
  context.globalAlpha = 1;
}

/** Brightness of a face from 0 to 1. */
function lightOf([a, b, c, d]) {
  const [u, v] = [c.map((x, index) => x - a[index]), d.map((x, index) => x - b[index])];
  const n = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
  const length = Math.hypot(...n) || 1;
  return Math.abs(n.reduce((sum, x, index) => sum + x * LIGHT[index], 0)) / length;
}

function drawWires(context, view, wires, model, dash) {
  for (const wire of wires) {
    polyline(context, wire.map(view.toScreen), { color: palette()[model], width: 1.4, dash });
  }
}

const around = (make, count = 72) =>
  Array.from({ length: count + 1 }, (_, index) => make((TURN * index) / count));

function ellipsoidWires(force, torque) {
  const parallels = [-0.75, -0.4, 0, 0.4, 0.75].map((z) => {
    const r = force * Math.sqrt(1 - z * z);
    return around((angle) => [r * Math.cos(angle), r * Math.sin(angle), z * torque]);
  });
  const meridians = [0, 1, 2, 3].map((index) => {
    const [c, s] = [Math.cos((index * Math.PI) / 4), Math.sin((index * Math.PI) / 4)];
    return around((angle) => [
      force * Math.cos(angle) * c,
      force * Math.cos(angle) * s,
      torque * Math.sin(angle),
    ]);
  });
  return [...parallels, ...meridians];
}

function cylinderWires(force, torque) {
  const rims = [-1, 1].map((z) =>
    around((angle) => [force * Math.cos(angle), force * Math.sin(angle), z * torque]),
  );
  const edges = Array.from({ length: 12 }, (_, index) => {
    const [x, y] = [force * Math.cos((index * TURN) / 12), force * Math.sin((index * TURN) / 12)];
    return [
      [x, y, -torque],
      [x, y, torque],
    ];
  });
  return [...rims, ...edges];
}

/** The point of the grid that faces the eye nearest to a place on the canvas. */
export function picked(mesh, view, [x, y]) {
  let best = { distance: Infinity };
  for (const point of mesh.flat()) {
    const [a, b] = view.toScreen(point);
    // The front of a convex set that holds the origin is where a little more is nearer to the eye.
    if (view.turned(point)[2] < -0.02) continue;
    const distance = Math.hypot(a - x, b - y);
    if (distance < best.distance) best = { distance, point };
  }
  return best.point;
}
