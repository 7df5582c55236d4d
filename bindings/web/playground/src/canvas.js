// Canvases with the pixels of the screen and the colours of the theme.

const dark = matchMedia("(prefers-color-scheme: dark)");
const paper = matchMedia("print");
const still = matchMedia("(prefers-reduced-motion: reduce)");
const NAMES = [
  "ink",
  "soft",
  "line",
  "ground",
  "panel",
  "exact",
  "ellipsoid",
  "separate",
  "accent",
  "target",
];
let colors;

/** Whether the reader asked for little motion. */
export const wantsStillness = () => still.matches;

/** Colours of the theme by name. */
export function palette() {
  if (colors === undefined) {
    const style = getComputedStyle(document.documentElement);
    colors = Object.fromEntries(NAMES.map((name) => [name, style.getPropertyValue(`--${name}`).trim()]));
  }
  return colors;
}

/**
 * Draws on a canvas: `draw(context, width, height)` in CSS pixels, again when size or theme change. Returns a
 * function that draws now.
 */
export function painter(canvas, draw) {
  const context = canvas.getContext("2d");
  const paint = () => {
    const { clientWidth: width, clientHeight: height } = canvas;
    if (width === 0) return;
    const ratio = Math.min(devicePixelRatio || 1, 2);
    const [across, down] = [Math.round(width * ratio), Math.round(height * ratio)];
    if (canvas.width !== across || canvas.height !== down) {
      canvas.width = across;
      canvas.height = down;
    }
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    context.clearRect(0, 0, width, height);
    context.lineJoin = context.lineCap = "round";
    draw(context, width, height);
  };
  new ResizeObserver(paint).observe(canvas);
  for (const theme of [dark, paper]) {
    theme.addEventListener("change", () => {
      colors = undefined;
      paint();
    });
  }
  return paint;
}

/** Place of a pointer on a canvas, in CSS pixels. */
export function pointOf(canvas, event) {
  const box = canvas.getBoundingClientRect();
  return [event.clientX - box.left, event.clientY - box.top];
}

/** Calls `down`, `move` and `up` with the place of a pointer that is pressed on a canvas. */
export function onDrag(canvas, { down, move, up }) {
  let pressed;
  canvas.addEventListener("pointerdown", (event) => {
    if (event.button !== 0) return;
    pressed = event.pointerId;
    canvas.setPointerCapture(pressed);
    down(pointOf(canvas, event));
  });
  canvas.addEventListener("pointermove", (event) => {
    if (event.pointerId === pressed) move(pointOf(canvas, event));
  });
  const end = (event) => {
    if (event.pointerId !== pressed) return;
    pressed = undefined;
    up?.(pointOf(canvas, event));
  };
  canvas.addEventListener("pointerup", end);
  canvas.addEventListener("pointercancel", end);
}

/** A line through points [[x, y], …]. */
export function polyline(context, points, { color, width = 2, dash = [], isClosed = false }) {
  context.beginPath();
  for (const [x, y] of points) context.lineTo(x, y);
  if (isClosed) context.closePath();
  context.setLineDash(dash);
  context.strokeStyle = color;
  context.lineWidth = width;
  context.stroke();
  context.setLineDash([]);
}

/** An arrow from a place along (dx, dy), in pixels. */
export function arrow(context, [x, y], [dx, dy], color, width = 3) {
  const length = Math.hypot(dx, dy);
  if (length < 2) return;
  const head = Math.min(11, 0.6 * length);
  const [ux, uy] = [dx / length, dy / length];
  const neck = [x + dx - head * ux, y + dy - head * uy];
  polyline(context, [[x, y], neck], { color, width });
  context.beginPath();
  context.moveTo(x + dx, y + dy);
  context.lineTo(neck[0] - 0.5 * head * uy, neck[1] + 0.5 * head * ux);
  context.lineTo(neck[0] + 0.5 * head * uy, neck[1] - 0.5 * head * ux);
  context.fillStyle = color;
  context.fill();
}

/** An arrow along an arc about a place, from an angle by a turn, in rad, counterclockwise on the screen. */
export function turnArrow(context, [x, y], radius, from, turn, color, width = 3) {
  if (Math.abs(turn) * radius < 4) return;
  const to = from + turn;
  const short = Math.sign(turn) * Math.min(10 / radius, Math.abs(turn) / 2);
  context.beginPath();
  context.arc(x, y, radius, -from, -(to - short), turn > 0);
  context.strokeStyle = color;
  context.lineWidth = width;
  context.stroke();
  const at = (angle, r) => [x + r * Math.cos(angle), y - r * Math.sin(angle)];
  context.beginPath();
  for (const [angle, r] of [
    [to, radius],
    [to - short, radius + 6],
    [to - short, radius - 6],
  ]) {
    context.lineTo(...at(angle, r));
  }
  context.fillStyle = color;
  context.fill();
}
