// The panel of the limit surface. Forces are in μN, torques in μNR, lengths in radii.

import { HOLES, MODELS, centred, frictionOf, outline } from "./bodies.js";
import { onDrag, painter, palette } from "./canvas.js";
import { choice, find, slider } from "./controls.js";
import { everythingReady } from "./kernel.js";
import { digits, onLanguage, t } from "./language.js";
import { startDrawing } from "./outline.js";
import { drawPlan, drawSection, planView } from "./plan.js";
import { programBox } from "./program-box.js";
import { surfacePrograms } from "./programs.js";
import { centreOf, circleContactAt, contactAt, motionCone, rimOf, wrenchAt } from "./push.js";
import { drawSolid, meshOf, picked, viewOf } from "./solid.js";

const DEGREE = Math.PI / 180;
const STEP = 5 * DEGREE;
const ORBIT = {
  ArrowLeft: ["yaw", 1],
  ArrowRight: ["yaw", -1],
  ArrowUp: ["pitch", 1],
  ArrowDown: ["pitch", -1],
};
/** Choices of the list that are pressures under a disk. */
const PRESSURES = ["hertz", "punch"];
/** A press that moves less, in pixels, is a click. */
const CLICK = 4;

const state = {
  shape: "box",
  pressure: "uniform",
  alpha: 0,
  mu: 1,
  radius: 1,
  part: 0.23,
  angle: 0,
  cone: 0.3,
};
const eye = { yaw: 0.55, pitch: 0.42 };
const shows = { exact: true, ellipsoid: true, separate: true };
let friction;
let models;
let mesh;
let rim;
let isRound;
let free = null;
/** Gives up the drawing of an outline; while there is one, nothing else is shown. */
let stopDrawing;
let paints = [];
let controls = [];
let showPrograms;

/** The push: at the contact, or the one that was picked on the surface. */
const outlineAt = (part) => (isRound ? circleContactAt(part) : contactAt(rim, part));
const contactOf = () => (free === null ? outlineAt(state.part) : null);
const pushOf = () => free ?? wrenchAt(contactOf(), state.angle);
const row = ({ fx, fy, torque }) => [fx, fy, torque];

/** The body that is chosen: a pressure is one under a puck. */
function bodyOf() {
  const isPressure = PRESSURES.includes(state.shape);
  return isPressure ? { ...state, shape: "puck", pressure: state.shape } : state;
}

function makeSurface() {
  friction?.free();
  const body = bodyOf();
  friction = frictionOf(body);
  const exact = friction.limitSurface(1);
  models = { exact, ellipsoid: exact.ellipsoid(), separate: exact.separate() };
  mesh = meshOf(exact);
  const corners = outline(body);
  isRound = corners === null;
  rim = rimOf(corners);
}

/** Where each model carries the push, and the motion there. */
function normalsOf(push) {
  return Object.fromEntries(
    MODELS.map((model) => {
      const { vx, vy, spin } = models[model].normal(push);
      return [model, { at: row(models[model].scaleToSurface(push)), normal: [vx, vy, spin] }];
    }),
  );
}

function paintAll() {
  for (const paint of paints) paint();
}

function bindPaints() {
  const solid = painter(find("surface-canvas"), (context, width, height) => {
    if (stopDrawing) return;
    const push = pushOf();
    const scene = { mesh, surface: models.exact, shows, push: row(models.exact.scaleToSurface(push)) };
    drawSolid(context, viewOf(width, height, eye), { ...scene, normals: normalsOf(push) });
  });
  const plan = painter(find("plan-canvas"), (context, width, height) => {
    if (stopDrawing) return nameDrawing(context, width, height);
    const [contact, push] = [contactOf(), pushOf()];
    const cone = contact && motionCone(models.exact, contact, state.cone);
    const motion = models.exact.normal(push);
    drawPlan(context, planView(width, height), {
      rim,
      hole: HOLES[state.shape] ?? 0,
      push,
      contact,
      motion,
      cone,
    });
  });
  const section = painter(find("section-canvas"), (context, width, height) => {
    if (!stopDrawing) drawSection(context, width, height, { models, push: pushOf(), shows });
  });
  paints = [solid, plan, section];
}

/** Numbers of the motion under each model, and the motion in words. */
function tell() {
  const push = pushOf();
  showPrograms(surfacePrograms(bodyOf(), models.exact.scaleToSurface(push)));
  for (const model of MODELS) {
    const on = models[model].scaleToSurface(push);
    const motion = models[model].normal(push);
    const speed = Math.hypot(motion.vx, motion.vy);
    const centre = centreOf(motion);
    const values = [
      Math.hypot(on.fx, on.fy),
      on.torque,
      motion.spin / speed,
      centre ? Math.hypot(...centre) : Infinity,
    ];
    const cells = find(`surface-${model}`).querySelectorAll("td");
    cells.forEach((cell, index) => {
      cell.textContent = digits(
        Math.abs(values[index]) > 1e6 ? Math.sign(values[index]) * Infinity : values[index],
        3,
      );
    });
  }
  const { vx, vy, spin } = models.exact.normal(push);
  const degrees = (Math.atan2(vy, vx) * 180) / Math.PI;
  find("surface-say").textContent = t("surfaceSay", {
    direction: digits(Math.hypot(vx, vy) < 1e-9 ? NaN : degrees, 0),
    ratio: digits(Math.abs(spin) / Math.hypot(vx, vy), 2),
  });
}

function changed(key) {
  if (key === "part" || key === "angle") free = null;
  for (const show of controls) show();
  if (stopDrawing) {
    paintAll();
    return askForOutline();
  }
  tell();
  paintAll();
}

function changeShape() {
  stopDrawing?.();
  stopDrawing = undefined;
  free = null;
  try {
    makeSurface();
    find("surface-error").textContent = "";
  } catch (error) {
    find("surface-error").textContent = `${t("refused")} ${error.message}`;
    state.shape = "puck";
    makeSurface();
  }
  changed();
}

function drawShape() {
  stopDrawing?.();
  stopDrawing = startDrawing(find("plan-canvas"), (corners) => {
    Object.assign(state, corners ? { shape: "drawn", drawn: centred(corners, 1) } : { shape: "puck" });
    changeShape();
    if (!corners) find("surface-error").textContent = t("drawAgain");
  });
  paintAll();
  askForOutline();
  find("plan-canvas").scrollIntoView({ block: "nearest" });
}

/** Says in the empty box that it is the one to draw in. */
function nameDrawing(context, width, height) {
  context.font = "600 16px system-ui, sans-serif";
  context.textAlign = "center";
  context.fillStyle = palette().soft;
  context.fillText(t("drawHere"), width / 2, height / 2);
}

/** Says where to draw; what was shown was of another body. */
function askForOutline() {
  find("surface-error").textContent = "";
  find("surface-say").textContent = t("drawInBox");
  for (const cell of document.querySelectorAll("#panel-surface td")) cell.textContent = "–";
}

function bindOrbit(canvas) {
  let from;
  let moved;
  onDrag(canvas, {
    down: (point) => ([from, moved] = [point, 0]),
    move: ([x, y]) => {
      eye.yaw -= 0.01 * (x - from[0]);
      tilt(0.01 * (y - from[1]));
      moved += Math.hypot(x - from[0], y - from[1]);
      from = [x, y];
      paints[0]();
    },
    up: (point) => {
      if (moved > CLICK || stopDrawing) return;
      const [fx, fy, torque] = picked(mesh, viewOf(canvas.clientWidth, canvas.clientHeight, eye), point);
      free = { fx, fy, torque };
      changed();
    },
  });
  canvas.addEventListener("keydown", (event) => {
    const [key, sign] = ORBIT[event.key] ?? [];
    if (key === undefined) return;
    event.preventDefault();
    if (key === "yaw") eye.yaw += sign * STEP;
    else tilt(sign * STEP);
    paints[0]();
  });
}

function tilt(by) {
  eye.pitch = Math.min(Math.max(eye.pitch + by, -1.5), 1.5);
}

/** A press on the plan pushes at the nearest point of the outline, from there. */
function bindPlan(canvas) {
  const at = (point) => {
    const [x, y] = planView(canvas.clientWidth, canvas.clientHeight).toWorld(point);
    let best = Infinity;
    for (let index = 0; index < 200; index += 1) {
      const { place } = outlineAt(index / 200);
      const distance = Math.hypot(place[0] - x, place[1] - y);
      if (distance < best) [best, state.part] = [distance, index / 200];
    }
    changed("part");
  };
  onDrag(canvas, { down: at, move: at });
}

export async function startSurface() {
  await everythingReady();
  makeSurface();
  showPrograms = programBox("surface");
  bindPaints();
  controls = [
    slider("surface-part", state, "part", {
      unit: "%",
      decimals: 0,
      read: (x) => x / 100,
      write: (x) => 100 * x,
      changed,
    }),
    slider("surface-angle", state, "angle", {
      unit: "°",
      decimals: 0,
      read: (x) => x * DEGREE,
      write: (x) => x / DEGREE,
      changed,
    }),
    slider("surface-cone", state, "cone", { changed }),
    choice("surface-shape", state, "shape", () => (state.shape === "drawn" ? drawShape() : changeShape())),
  ];
  for (const model of MODELS) {
    find(`show-${model}`).addEventListener("change", (event) => {
      shows[model] = event.target.checked;
      paintAll();
    });
  }
  bindOrbit(find("surface-canvas"));
  bindPlan(find("plan-canvas"));
  onLanguage(changed);
}
