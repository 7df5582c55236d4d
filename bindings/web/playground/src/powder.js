// The panel of powder: four recorded compactions with one time.

import { painter, palette, polyline, wantsStillness } from "./canvas.js";
import { find } from "./controls.js";
import { unpackedJson } from "./kernel.js";
import { digits, onLanguage, t } from "./language.js";
import { programBox } from "./program-box.js";
import { powderPrograms } from "./programs.js";

/** Width of the cell, and height of the view, in radii. */
const WIDTH = 20;
const HEIGHT = 63;
/** Duration of the film in s. */
const FILM = 8;
/** A run lasts longer than no time. */
const EARLIEST = 1e-3;
/** The picture looks down by this slope: depth raises what is behind. */
const SLOPE = 0.22;

/** Steps of depth, and how pale the farthest sphere is. */
const SHADES = 10;
const PALEST = 0.75;

let kept = {};
let corners = [];
let share = 0;
let playing = 0;
let paints = [];
let showPrograms;

/** Positions of all frames, in radii. */
function decoded({ fine, corners: packed }) {
  return packed.map(({ frames, ...rest }) => {
    let before;
    const read = frames.map(({ places, ...frame }) => {
      const sums = places.map((change, index) => change + (before?.[index] ?? 0));
      before = sums;
      return { ...frame, places: sums.map((place) => place / fine) };
    });
    return { ...rest, frames: read };
  });
}

const duration = () => Math.max(...corners.map(({ frames }) => frames.at(-1).time));

/** The state of a corner at a time, between two frames. */
function stateAt({ frames }, time) {
  const next = frames.findIndex((frame) => frame.time > time);
  if (next < 0) return frames.at(-1);
  const [a, b] = [frames[Math.max(next - 1, 0)], frames[next]];
  const part = b.time > a.time ? (time - a.time) / (b.time - a.time) : 0;
  const mixed = (x, y) => x + part * (y - x);
  // Spheres leave the periodic cell on one side and enter on the other.
  const places = a.places.map((x, index) =>
    Math.abs(b.places[index] - x) > WIDTH / 2 ? x : mixed(x, b.places[index]),
  );
  return { height: mixed(a.height, b.height), porosity: mixed(a.porosity, b.porosity), places };
}

/** Pictures of a sphere, paler with depth: quicker to draw than circles. */
function spheresOf(scale) {
  const { exact, panel } = palette();
  const name = `${scale} ${exact}`;
  if (kept.name === name) return kept.pictures;
  const fine = 2;
  const pictures = Array.from({ length: SHADES }, (_, shade) => {
    const picture = document.createElement("canvas");
    picture.width = picture.height = Math.ceil(fine * (2 * scale + 2));
    const context = picture.getContext("2d");
    context.arc(picture.width / 2, picture.height / 2, fine * scale, 0, 2 * Math.PI);
    context.fillStyle = exact;
    context.fill();
    context.globalAlpha = (PALEST * shade) / (SHADES - 1);
    context.fillStyle = panel;
    context.fill();
    context.globalAlpha = 1;
    context.strokeStyle = panel;
    context.stroke();
    return picture;
  });
  kept = { name, pictures };
  return pictures;
}

function drawCorner(context, width, height, corner) {
  const { places, height: piston } = stateAt(corner, share * duration());
  const scale = Math.min(width / (WIDTH + 3), height / (HEIGHT + SLOPE * WIDTH + 2));
  const left = (width - scale * WIDTH) / 2;
  const toScreen = (x, y, z) => [left + scale * x, height - 6 - scale * (z + SLOPE * y)];
  const spheres = Array.from({ length: places.length / 3 }, (_, index) => 3 * index);
  spheres.sort((a, b) => places[b + 1] - places[a + 1]);
  const { ink } = palette();
  const drawPlate = (z) => {
    const plate = [
      toScreen(0, 0, z),
      toScreen(WIDTH, 0, z),
      toScreen(WIDTH, WIDTH, z),
      toScreen(0, WIDTH, z),
    ];
    polyline(context, plate, { color: ink, width: 1.5, isClosed: true });
  };
  drawPlate(0);
  const pictures = spheresOf(scale);
  for (const at of spheres) {
    const [x, y, z] = [places[at], places[at + 1], places[at + 2]];
    const [a, b] = toScreen(x, y, z);
    const shade = Math.min(Math.max(Math.floor((SHADES * y) / WIDTH), 0), SHADES - 1);
    context.drawImage(pictures[shade], a - scale - 1, b - scale - 1, 2 * scale + 2, 2 * scale + 2);
  }
  drawPlate(piston);
}

function show() {
  const input = find("powder-time");
  input.value = 1000 * share;
  const words = { percent: digits(100 * share, 0) };
  input.setAttribute("aria-valuetext", t("powderTime", words));
  corners.forEach((corner, index) => {
    const { porosity } = stateAt(corner, share * duration());
    find(`porosity-${index}`).textContent = t("emptySpace", { percent: digits(100 * porosity, 1) });
    paints[index]();
  });
  tell("off");
}

/** Time to be run to: nothing for the end. */
const shownTime = () => (share < 1 ? Math.max(share * duration(), EARLIEST) : undefined);

/** The time shown in words; read aloud ("polite") once the film is over or the slider is let go. */
function tell(aloud) {
  find("powder-say").setAttribute("aria-live", aloud);
  if (aloud !== "off") showPrograms(powderPrograms(shownTime()));
  const names = Object.fromEntries(
    corners.map((corner, index) => [
      `p${index}`,
      digits(100 * stateAt(corner, share * duration()).porosity, 1),
    ]),
  );
  find("powder-say").textContent = t("powderSay", names);
}

function play() {
  cancelAnimationFrame(playing);
  if (wantsStillness()) {
    share = 1;
    show();
    return tell("polite");
  }
  if (share >= 1) share = 0;
  const [start, from] = [performance.now(), share];
  const frame = (now) => {
    share = Math.min(from + Math.max(now - start, 0) / 1000 / FILM, 1);
    show();
    if (share < 1) playing = requestAnimationFrame(frame);
    else stopped();
  };
  playing = requestAnimationFrame(frame);
  find("powder-play").textContent = t("pause");
}

function stopped() {
  cancelAnimationFrame(playing);
  playing = 0;
  find("powder-play").textContent = t("play");
  tell("polite");
}

export async function startPowder() {
  corners = decoded(await unpackedJson("powder-data"));
  share = 1;
  showPrograms = programBox("powder");
  showPrograms(powderPrograms());
  paints = corners.map((corner, index) =>
    painter(find(`powder-${index}`), (context, width, height) => drawCorner(context, width, height, corner)),
  );
  find("powder-play").addEventListener("click", () => (playing ? stopped() : play()));
  find("powder-time").addEventListener("input", ({ target }) => {
    if (playing) stopped();
    share = target.value / 1000;
    show();
  });
  find("powder-time").addEventListener("change", () => tell("polite"));
  onLanguage(() => {
    show();
    find("powder-play").textContent = t(playing ? "pause" : "play");
  });
}
