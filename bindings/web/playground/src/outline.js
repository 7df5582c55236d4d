// A polygon that the reader draws on a canvas.

import { palette, pointOf, polyline } from "./canvas.js";

/** Corners closer than this are left out, in pixels; at most so many are kept. */
const APART = 14;
const MOST = 24;

/**
 * Follows one stroke; calls `done` with corners [[x, y], …], y upwards, or null if they are too few. Returns a
 * function that gives up.
 */
export function startDrawing(canvas, done) {
  const corners = [];
  const context = canvas.getContext("2d");
  const cover = () => {
    const { accent, panel } = palette();
    context.fillStyle = panel;
    context.fillRect(0, 0, canvas.clientWidth, canvas.clientHeight);
    polyline(context, corners, { color: accent, width: 3, isClosed: corners.length > 2 });
  };
  const add = (event) => {
    event.stopImmediatePropagation();
    const point = pointOf(canvas, event);
    const last = corners.at(-1);
    if (last && Math.hypot(point[0] - last[0], point[1] - last[1]) < APART) return;
    corners.push(point);
    cover();
  };
  const move = (event) => event.buttons && add(event);
  const end = (event) => {
    event.stopImmediatePropagation();
    stop();
    const step = Math.ceil(corners.length / MOST);
    const kept = corners.filter((_, index) => index % step === 0).map(([x, y]) => [x, -y]);
    done(kept.length < 3 ? null : kept);
  };
  const listeners = Object.entries({
    pointerdown: add,
    pointermove: move,
    pointerup: end,
    pointercancel: end,
  });
  const stop = () => {
    for (const [name, listener] of listeners) canvas.removeEventListener(name, listener, true);
  };
  for (const [name, listener] of listeners) canvas.addEventListener(name, listener, true);
  cover();
  return stop;
}
