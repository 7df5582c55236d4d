// The panel of throws.

import { GROUNDS, isRound } from "./bodies.js";
import { onDrag, painter, wantsStillness } from "./canvas.js";
import { choice, find, range, slider } from "./controls.js";
import { canPlay, judged, newTarget } from "./game.js";
import { everythingReady, isComplete } from "./kernel.js";
import { onNewLanguage, t } from "./language.js";
import { programBox } from "./program-box.js";
import { throwPrograms } from "./programs.js";
import { durationOf, moves, race } from "./race.js";
import { startDrawing } from "./outline.js";
import { drawStage, fitted } from "./stage.js";
import { showNumbers, spoken, spokenGame } from "./throw-numbers.js";

/** Pixels of an aim per m/s of the largest speed: the whole arrow is the largest speed. */
const AIM = 180;
const DEGREE = Math.PI / 180;
const USUAL_DIRECTION = 8 * DEGREE;
/** Step of the speed, in m/s. */
const FINE = 0.01;
/** Change of speed and direction by an arrow key. */
const KEYS = {
  ArrowUp: ["direction", 1],
  ArrowDown: ["direction", -1],
  ArrowRight: ["speed", 1],
  ArrowLeft: ["speed", -1],
};

const setup = {
  ground: "carrom",
  shape: "puck",
  pressure: "uniform",
  alpha: 0,
  direction: USUAL_DIRECTION,
  rate: "0.5",
};
const canvas = find("throw-canvas");
let result;
let view;
let time = Infinity;
let aim;
let game;
let isAnswer = false;
let shows = [];
let playing = 0;
let summary = () => "";
let showPrograms = () => {};

/** Chooses what the bodies slide on, with the usual throw there. */
function useGround(name) {
  Object.assign(setup, { ground: name, alpha: 0 }, GROUNDS[name]);
  setup.maxSpin = Math.round((3 * setup.maxSpeed) / setup.radius / 10) * 10;
}

/** Sliders for the ground. */
function limitSliders() {
  range("throw-speed", 0, setup.maxSpeed, FINE);
  range("throw-spin", -setup.maxSpin, setup.maxSpin, 1);
  range("throw-radius", setup.radius * 50, setup.radius * 250, setup.radius);
}

const paint = painter(canvas, (context, width, height) => {
  if (result === undefined) return;
  if (view?.width !== width || view.height !== height) view = undefined;
  view ??= fitted(width, height, setup.view, seen(), 2 * setup.radius);
  const scene = { view, result, setup, aim, time: Math.min(time, durationOf(result)) };
  const isHidden = game !== undefined && !game.isThrown;
  drawStage(context, width, height, {
    ...scene,
    isHidden,
    target: game?.target,
    answer: game?.verdict?.gentle,
  });
});

/** Points that the view has to hold. */
function seen() {
  const points = game ? [[game.target.x, game.target.y]] : [];
  if (game && !game.isThrown) return points;
  return points.concat(result.runs.map(({ rest }) => [rest.x, rest.y]));
}

/** Shows the numbers of the models that are at rest by now; in a game, of what was thrown. */
function tabulate() {
  showNumbers(game && !game.isThrown ? undefined : result, setup, time);
}

/** Computes the throw anew, and shows its end. */
function compute() {
  result?.friction.free();
  try {
    result = race(setup);
    find("throw-error").textContent = "";
  } catch (error) {
    setup.shape = "puck";
    result = race(setup);
    find("throw-error").textContent = `${t("refused")} ${error.message}`;
  }
  time = Infinity;
  if (aim === undefined) view = undefined;
  find("throw-pressure").disabled = !isComplete || setup.shape !== "puck";
  find("throw-alpha").disabled = !isComplete || !isRound(setup);
  find("game-start").disabled = !canPlay(setup);
  tabulate();
  for (const show of shows) show();
  showPrograms(throwPrograms(setup));
  paint();
}

function changed(key) {
  if (!isRound(setup)) setup.alpha = 0;
  if (["ground", "shape", "pressure", "mu", "radius", "alpha"].includes(key)) endGame();
  if (game?.isThrown) game = { target: game.target, isThrown: false };
  cancelAnimationFrame(playing);
  // What was said was of another throw.
  say(game ? () => t("gameStart") : () => "");
  compute();
}

/** Says something, in the language of the page. */
function say(words) {
  summary = words;
  find("throw-say").textContent = words();
}

function bindControls() {
  const degrees = { read: (x) => x * DEGREE, write: (x) => x / DEGREE };
  const hundredth = { read: (x) => x / 100, write: (x) => x * 100 };
  shows = [
    slider("throw-speed", setup, "speed", { unit: "m/s", changed }),
    slider("throw-direction", setup, "direction", { unit: "°", decimals: 0, ...degrees, changed }),
    slider("throw-spin", setup, "spin", { unit: "rad/s", decimals: 0, changed }),
    slider("throw-mu", setup, "mu", { changed }),
    slider("throw-alpha", setup, "alpha", { changed }),
    slider("throw-radius", setup, "radius", { unit: "cm", ...hundredth, changed }),
    choice("throw-ground", setup, "ground", (key) => {
      useGround(setup.ground);
      limitSliders();
      changed(key);
    }),
    choice("throw-shape", setup, "shape", (key) => (setup.shape === "drawn" ? drawShape() : changed(key))),
    choice("throw-pressure", setup, "pressure", changed),
    choice("throw-rate", setup, "rate", () => {}),
  ];
}

function drawShape() {
  cancelAnimationFrame(playing);
  say(() => t("drawNow"));
  showNumbers(undefined, setup);
  startDrawing(canvas, (corners) => {
    Object.assign(setup, corners ? { shape: "drawn", drawn: corners } : { shape: "puck" });
    changed("shape");
    say(() => t(corners ? "drawn" : "drawAgain"));
  });
}

/** Throws: plays the paths, then says how it ended. */
function launch() {
  cancelAnimationFrame(playing);
  aim = undefined;
  if (game) game = { ...game, isThrown: true, verdict: undefined };
  compute();
  if (wantsStillness() || !moves(setup)) return ended();
  time = 0;
  say(() => "");
  tabulate();
  const rate = Number(setup.rate);
  const start = performance.now();
  let frames = 0;
  const frame = (now) => {
    frames += 1;
    time = (Math.max(now - start, 0) / 1000) * rate;
    paint();
    tabulate();
    if (time < durationOf(result)) playing = requestAnimationFrame(frame);
    else {
      performance.measure("race", { start, end: now, detail: { frames } });
      ended();
    }
  };
  playing = requestAnimationFrame(frame);
}

function ended() {
  time = Infinity;
  tabulate();
  const thrown = result;
  if (!game) say(() => spoken(thrown, setup));
  else {
    const { target } = game;
    const verdict = judged(setup, result.body, target, result.runs[0].rest);
    game = { target, isThrown: true, verdict };
    say(() => spokenGame(verdict));
  }
  showAnswers(game !== undefined);
  paint();
}

function startGame() {
  cancelAnimationFrame(playing);
  game = { target: newTarget(setup, result.body), isThrown: false };
  showAnswers(false);
  find("game-end").hidden = false;
  say(() => t("gameStart"));
  compute();
}

/** Ends a game; what the answer had set is as usual again. */
function endGame() {
  const { speed, spin } = GROUNDS[setup.ground];
  if (isAnswer) Object.assign(setup, { speed, spin, direction: USUAL_DIRECTION });
  game = undefined;
  isAnswer = false;
  find("game-end").hidden = true;
  showAnswers(false);
}

function showAnswers(areShown) {
  for (const name of ["gentle", "spinning"]) find(`game-${name}`).hidden = !areShown;
}

/** Throws an answer of the inverse problem: "gentle" or "spinning". */
function throwAnswer(name) {
  const { speed, direction, spin } = game.verdict[name];
  Object.assign(setup, { speed, direction, spin });
  isAnswer = true;
  launch();
}

function bindThrow() {
  const point = ([x, y]) => {
    const [x0, y0] = view.toScreen([0, 0]);
    const length = Math.min(Math.hypot(x - x0, y - y0), AIM) || 1;
    const direction = Math.atan2(y0 - y, x - x0);
    aim = [length * Math.cos(direction), -length * Math.sin(direction)];
    Object.assign(setup, { direction, speed: rounded((length / AIM) * setup.maxSpeed) });
    if (game) game = { target: game.target, isThrown: false };
    compute();
  };
  onDrag(canvas, { down: (at) => (cancelAnimationFrame(playing), point(at)), move: point, up: launch });
  canvas.addEventListener("keydown", (event) => {
    const [key, sign] = KEYS[event.key] ?? [];
    if (event.key === "Enter" || event.key === " ") launch();
    else if (key === "direction") turn("direction", sign * DEGREE, Math.PI);
    else if (key === "speed") turn("speed", sign * rounded(setup.maxSpeed / 50), setup.maxSpeed, 0);
    else if (event.key === "+" || event.key === "-") {
      turn("spin", ((event.key === "+" ? 1 : -1) * setup.maxSpin) / 50, setup.maxSpin);
    } else return;
    event.preventDefault();
  });
  find("throw-go").addEventListener("click", launch);
  find("game-start").addEventListener("click", startGame);
  find("game-end").addEventListener("click", () => (endGame(), changed()));
  for (const name of ["gentle", "spinning"]) {
    find(`game-${name}`).addEventListener("click", () => throwAnswer(name));
  }
}

/** A speed that the slider can have. */
const rounded = (speed) => Math.round(speed / FINE) * FINE;

/** Changes a number of the throw within its limits. */
function turn(key, by, most, least = -most) {
  const value = setup[key] + by;
  setup[key] = Math.min(Math.max(key === "speed" ? rounded(value) : value, least), most);
  changed(key);
}

/** Draws the first throw, with the disk's kernel alone, before the rest of the page is read. */
export function drawThrow() {
  useGround("carrom");
  result = race(setup);
  paint();
}

/** Shows its numbers and controls. */
export function startThrow() {
  limitSliders();
  bindControls();
  bindThrow();
  compute();
  onNewLanguage(() => {
    for (const show of shows) show();
    tabulate();
    find("throw-say").textContent = summary();
    paint();
  });
}

/** Adds the other models once their kernel is there. */
export async function completeThrow() {
  await everythingReady();
  find("throw-shape").disabled = false;
  showPrograms = programBox("throw");
  compute();
  // A race says more than its end, to those who did not ask for stillness.
  if (!wantsStillness() && !find("panel-throw").hidden) launch();
}
