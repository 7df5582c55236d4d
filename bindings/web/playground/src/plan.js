// The patch from above with a push and its motion, and the section of the limit surface through the push.

import { arrow, palette, polyline } from "./canvas.js";
import { t } from "./language.js";
import { centreOf, velocityAt } from "./push.js";

/** Largest displacement of the moved outline, in radii. */
const SHIFT = 0.55;
/** Lengths of the arrows of push and motion, in radii. */
const PUSH = 0.9;
const MOTION = 0.9;
/** Largest drawn hole, in radii: a ring has some width to be seen. */
const LARGEST_HOLE = 0.93;
const RAYS = 121;
const DASHES = { exact: [], ellipsoid: [7, 5], separate: [2, 5] };

/** Place and scale of the plan: its middle is the middle of the patch. */
export function planView(width, height) {
  const scale = Math.min(width, height) / 3.8;
  const toScreen = ([x, y]) => [width / 2 + scale * x, height / 2 - scale * y];
  const toWorld = ([x, y]) => [(x - width / 2) / scale, (height / 2 - y) / scale];
  return { width, height, scale, toScreen, toWorld };
}

export function drawPlan(context, view, { rim, hole, push, contact, motion, cone }) {
  const { exact, ink, soft, target } = palette();
  polyline(context, rim.map(view.toScreen), { color: ink, width: 2, isClosed: true });
  if (hole > 0) {
    const inner = Math.min(hole, LARGEST_HOLE);
    polyline(
      context,
      rim.map(([x, y]) => view.toScreen([inner * x, inner * y])),
      { color: ink, width: 1, isClosed: true },
    );
  }
  const moved = movedOutline(rim, motion);
  polyline(context, moved.map(view.toScreen), { color: exact, width: 2, dash: [5, 5], isClosed: true });
  const place = contact?.place ?? onLine(push);
  // A push beside the body acts through a lever.
  if (!contact)
    polyline(context, [[0, 0], place].map(view.toScreen), { color: soft, width: 1, dash: [2, 4] });
  if (cone) {
    for (const twist of cone) drawFrom(context, view, place, velocityAt(twist, place), target, MOTION);
  }
  drawFrom(context, view, place, velocityAt(motion, place), exact, MOTION);
  // The push ends at its place.
  const size = Math.hypot(push.fx, push.fy);
  if (size > 1e-9) {
    const from = [place[0] - (PUSH * push.fx) / size, place[1] - (PUSH * push.fy) / size];
    const [a, b] = [view.toScreen(from), view.toScreen(place)];
    arrow(context, a, [b[0] - a[0], b[1] - a[1]], ink, 4);
  }
  const centre = centreOf(motion);
  if (centre === null) return;
  drawCentre(context, view, view.toScreen(centre));
}

/** The centre of rotation; its name is at the edge of the plan, where no body is. */
function drawCentre(context, { width, height }, [x, y]) {
  if (x < 0 || x > width || y < 0 || y > height) return;
  const { exact, soft } = palette();
  context.beginPath();
  context.arc(x, y, 5, 0, 2 * Math.PI);
  context.strokeStyle = exact;
  context.lineWidth = 2;
  context.stroke();
  context.font = "13px system-ui, sans-serif";
  context.textAlign = "center";
  context.fillStyle = soft;
  const half = context.measureText(t("centre")).width / 2 + 6;
  const isLow = y > height / 2;
  const at = Math.min(Math.max(x, half), width - half);
  context.fillText(t("centre"), at, isLow ? height - 8 : 18);
  const ends = isLow
    ? [
        [x, y + 7],
        [at, height - 24],
      ]
    : [
        [x, y - 7],
        [at, 24],
      ];
  polyline(context, ends, { color: soft, width: 1 });
}

function drawFrom(context, view, place, [dx, dy], color, length) {
  const size = Math.hypot(dx, dy);
  if (size < 1e-9) return;
  const scale = (length * view.scale) / size;
  arrow(context, view.toScreen(place), [scale * dx, -scale * dy], color, 2.5);
}

/** The point of the line of a force that is nearest to the middle. */
function onLine({ fx, fy, torque }) {
  const size = fx * fx + fy * fy;
  return size < 1e-12 ? [0, 0] : [(-fy * torque) / size, (fx * torque) / size];
}

/** The outline after a while: its farthest point has moved by SHIFT. */
function movedOutline(rim, twist) {
  const fastest = Math.max(...rim.map((point) => Math.hypot(...velocityAt(twist, point))), 1e-9);
  const time = SHIFT / fastest;
  const angle = twist.spin * time;
  const [c, s] = [Math.cos(angle), Math.sin(angle)];
  return rim.map(([x, y]) => [c * x - s * y + twist.vx * time, s * x + c * y + twist.vy * time]);
}

/** Force along the push against torque, for each model. */
export function drawSection(context, width, height, { models, push, shows }) {
  const { soft, line, ink } = palette();
  const size = Math.hypot(push.fx, push.fy);
  const [dx, dy] = size < 1e-9 ? [1, 0] : [push.fx / size, push.fy / size];
  const { forceLimit, torqueLimit } = models.exact;
  const scale = Math.min((0.4 * width) / forceLimit, (0.36 * height) / torqueLimit);
  const toScreen = ([f, torque]) => [width / 2 + scale * f, height / 2 - scale * torque];
  polyline(
    context,
    [
      [8, height / 2],
      [width - 8, height / 2],
    ],
    { color: line, width: 1 },
  );
  polyline(
    context,
    [
      [width / 2, 8],
      [width / 2, height - 8],
    ],
    { color: line, width: 1 },
  );
  context.font = "italic 14px Georgia, serif";
  context.fillStyle = soft;
  context.textAlign = "right";
  context.fillText("F", width - 10, height / 2 - 6);
  context.fillText("T", width / 2 - 6, 15);
  for (const [name, surface] of Object.entries(models)) {
    if (!shows[name]) continue;
    const points = Array.from({ length: RAYS }, (_, index) => {
      const angle = (2 * Math.PI * index) / (RAYS - 1);
      const [f, torque] = [forceLimit * Math.cos(angle), torqueLimit * Math.sin(angle)];
      const on = surface.scaleToSurface({ fx: f * dx, fy: f * dy, torque });
      return toScreen([on.fx * dx + on.fy * dy, on.torque]);
    });
    polyline(context, points, { color: palette()[name], width: 2.5, dash: DASHES[name] });
  }
  const on = models.exact.scaleToSurface(push);
  const [x, y] = toScreen([Math.hypot(on.fx, on.fy), on.torque]);
  polyline(context, [toScreen([0, 0]), [x, y]], { color: ink, width: 1.5 });
  context.beginPath();
  context.arc(x, y, 5, 0, 2 * Math.PI);
  context.fillStyle = ink;
  context.fill();
}
