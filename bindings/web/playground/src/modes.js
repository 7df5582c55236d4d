// The panel of the final motion: a diagram of inertia ratio and exponent, and runs from several launches.

import { painter, pointOf } from "./canvas.js";
import { choice, find, slider } from "./controls.js";
import { everythingReady, kernel } from "./kernel.js";
import { digits, onLanguage, t } from "./language.js";
import { drawMap, drawRuns, mapPlace, RANGES } from "./modes-draw.js";
import { programBox } from "./program-box.js";
import { modesPrograms } from "./programs.js";
import { rowOf } from "./modes-row.js";

/** Rows of the diagram. */
const ROWS = 120;
/** Ratios v/(ωR) of the launches. */
const LAUNCHES = [0.03, 0.1, 0.3, 1, 3, 10, 30];
const POINTS = 60;
/** Decades of the time that is left, or of the time itself where nothing rests. */
const DECADES = 3;
/** Rows of the diagram that are computed before the browser may draw. */
const AT_ONCE = 20;
const KEYS = {
  ArrowLeft: ["inertia", -0.02],
  ArrowRight: ["inertia", 0.02],
  ArrowUp: ["alpha", 0.05],
  ArrowDown: ["alpha", -0.05],
};

const state = { pressure: "disk", inertia: 0.5, alpha: 0 };
let map;
let runs = [];
let modes;
let paints = [];
let controls = [];
let showPrograms;

/** A patch of radius 1 under the law |v|^α. */
function patch(alpha) {
  return kernel[state.pressure]({ radius: 1, mu: 1, ...(alpha === 0 ? {} : { alpha }) });
}

const between = ([low, high], part) => low + (high - low) * part;

/** Computes the diagram row by row; a newer diagram ends an older one. */
async function computeMap() {
  const mine = { rows: [] };
  map = mine;
  for (let row = 0; row < ROWS && map === mine; row += 1) {
    const friction = patch(between(RANGES.alpha, (row + 0.5) / ROWS));
    mine.rows.push(rowOf(friction));
    friction.free();
    if (row % AT_ONCE < AT_ONCE - 1 && row + 1 < ROWS) continue;
    paints[0]();
    await new Promise((done) => setTimeout(done));
  }
}

/** Ratios of sliding to spinning against time, for each launch. */
function computeRuns() {
  const friction = patch(state.alpha);
  modes = friction.modes(state.inertia);
  const body = friction.body({ mass: 1, inertia: state.inertia, load: 1 });
  runs = LAUNCHES.map((ratio) => {
    const size = Math.hypot(1, ratio);
    const twist = { vx: ratio / size, vy: 0, spin: 1 / size };
    const rest = modes.restsInFiniteTime ? body.slide(twist).time : Infinity;
    return Array.from({ length: POINTS }, (_, index) => {
      const part = index / (POINTS - 1);
      const decade = 10 ** (DECADES * part);
      const time = rest < Infinity ? rest * (1 - 1 / decade) : decade - 1;
      const { vx, spin } = body.advance(twist, time);
      return [part, vx / spin];
    });
  });
  friction.free();
}

function changed(key) {
  computeRuns();
  if (key === "pressure") computeMap();
  for (const show of controls) show();
  find("modes-say").textContent = `${endInWords()} ${intervalInWords()}`;
  showPrograms(modesPrograms(state));
  for (const paint of paints) paint();
}

/** Which motion is last. */
function endInWords() {
  const { finalMode, finalRatio } = modes;
  // A linear law brakes both motions at fixed rates: if the rates are equal, every ratio stays.
  const undecided = state.alpha === 1 ? "neutral" : "depends";
  return t(`mode_${finalMode ?? undecided}`, { ratio: digits(finalRatio ?? NaN, 3) });
}

/** For which inertia there is no motion that is always last. */
function intervalInWords() {
  const [low, high] = modes.inertiaInterval.map((inertia) => digits(inertia, 3));
  const name = state.alpha === 1 ? "Neutral" : state.alpha < 1 ? "Together" : "Depends";
  return t(`interval${name}`, { low, high });
}

/** Moves the point of the diagram. */
function move(inertia, alpha) {
  const limited = (value, [low, high]) => Math.min(Math.max(value, low), high);
  state.inertia = limited(inertia, RANGES.inertia);
  state.alpha = Math.round(limited(alpha, RANGES.alpha) * 100) / 100;
  changed();
}

function bindMap(canvas) {
  canvas.addEventListener("click", (event) => {
    const { toWorld } = mapPlace(canvas.clientWidth, canvas.clientHeight);
    move(...toWorld(pointOf(canvas, event)));
  });
  canvas.addEventListener("keydown", (event) => {
    const [key, by] = KEYS[event.key] ?? [];
    if (key === undefined) return;
    event.preventDefault();
    move(state.inertia + (key === "inertia" ? by : 0), state.alpha + (key === "alpha" ? by : 0));
  });
}

export async function startModes() {
  await everythingReady();
  computeRuns();
  showPrograms = programBox("modes");
  paints = [
    painter(find("modes-map"), (context, width, height) =>
      drawMap(context, width, height, { map, state, count: ROWS }),
    ),
    painter(find("modes-runs"), (context, width, height) =>
      drawRuns(context, width, height, { runs, modes }),
    ),
  ];
  controls = [
    slider("modes-inertia", state, "inertia", { changed }),
    slider("modes-alpha", state, "alpha", { changed }),
    choice("modes-pressure", state, "pressure", changed),
  ];
  bindMap(find("modes-map"));
  onLanguage(() => changed());
  await computeMap();
}
