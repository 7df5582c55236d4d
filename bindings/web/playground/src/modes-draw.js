// Pictures of the final motion.

import { palette, polyline } from "./canvas.js";
import { digits, t } from "./language.js";

/** What the diagram shows. */
export const RANGES = { inertia: [0.02, 1.2], alpha: [-0.9, 2] };
const EDGE = { left: 54, right: 14, top: 12, bottom: 42 };
/** Ratios from 1/LARGEST to LARGEST have a colour between the ends. */
const LARGEST = 20;
/** Colours of what is last, and of both at equal speeds. */
const COLORS = {
  Spinning: [143, 29, 107],
  both: [240, 238, 230],
  Sliding: [11, 90, 148],
  Depends: [112, 116, 124],
};
const RATIOS = [0.01, 100];
/** Regions that are a smaller part of the diagram have no name in them. */
const SMALLEST = 0.02;

/** Place and scale of the diagram. */
export function mapPlace(width, height) {
  return placed(width, height, RANGES.inertia, RANGES.alpha);
}

function placed(width, height, [x0, x1], [y0, y1]) {
  const [w, h] = [width - EDGE.left - EDGE.right, height - EDGE.top - EDGE.bottom];
  const toScreen = ([x, y]) => [
    EDGE.left + (w * (x - x0)) / (x1 - x0),
    EDGE.top + (h * (y1 - y)) / (y1 - y0),
  ];
  const toWorld = ([x, y]) => [x0 + ((x - EDGE.left) / w) * (x1 - x0), y1 - ((y - EDGE.top) / h) * (y1 - y0)];
  return { w, h, toScreen, toWorld };
}

/** The colour of a final ratio. */
function colorOf(ratio) {
  const part = Math.min(Math.max(Math.log(ratio) / Math.log(LARGEST), -1), 1);
  const end = part < 0 ? COLORS.Spinning : COLORS.Sliding;
  return css(COLORS.both.map((value, index) => value + Math.abs(part) * (end[index] - value)));
}

const css = (color) => `rgb(${color.map(Math.round)})`;

export function drawMap(context, width, height, { map, state, count }) {
  const { w, h, toScreen } = mapPlace(width, height);
  const rows = map?.rows ?? [];
  rows.forEach((row, index) => {
    const [y, thickness] = [EDGE.top + h - (h * (index + 1)) / count, h / count + 0.7];
    for (const { name, from, to } of partsOf(row)) {
      const [left, right] = [from, to].map((inertia) => toScreen([inertia, 0])[0]);
      context.fillStyle = name === "Together" ? shadeOf(context, row, toScreen) : css(COLORS[name]);
      context.fillRect(left, y, right - left, thickness);
    }
  });
  const xs = [0.2, 0.4, 0.6, 0.8, 1, 1.2].map((x) => [x, digits(x, 1)]);
  const ys = [-0.5, 0, 0.5, 1, 1.5, 2].map((y) => [y, digits(y, 1)]);
  axes(context, width, height, toScreen, { xs, ys, x: t("axisInertia"), y: "α" });
  if (rows.length === count) nameRegions(context, rows, w, h);
  const [x, y] = toScreen([state.inertia, state.alpha]);
  context.beginPath();
  context.arc(x, y, 8, 0, 2 * Math.PI);
  context.lineWidth = 5;
  context.strokeStyle = "#fff";
  context.stroke();
  context.lineWidth = 2.5;
  context.strokeStyle = "#000";
  context.stroke();
}

/** The parts of a row that the diagram shows: what is last there, from which inertia ratio to which. */
function partsOf({ low, high, stops }) {
  const [least, most] = RANGES.inertia;
  const ends = [least, low, high, most].map((inertia) => Math.min(Math.max(inertia, least), most));
  const names = ["Sliding", stops.length > 0 ? "Together" : "Depends", "Spinning"];
  const parts = names.map((name, index) => ({ name, from: ends[index], to: ends[index + 1] }));
  return parts.filter(({ from, to }) => to > from);
}

/** Colours between the inertia ratios `low` and `high`. */
function shadeOf(context, { low, high, stops }, toScreen) {
  const [[left], [right]] = [toScreen([low, 0]), toScreen([high, 0])];
  const shade = context.createLinearGradient(left, 0, right, 0);
  shade.addColorStop(0, css(COLORS.Sliding));
  for (const [inertia, ratio] of stops) {
    const part = Math.min(Math.max((inertia - low) / (high - low), 0), 1);
    shade.addColorStop(part, colorOf(ratio));
  }
  shade.addColorStop(1, css(COLORS.Spinning));
  return shade;
}

/** Writes into each region what is last there. */
function nameRegions(context, rows, w, h) {
  const [least, most] = RANGES.inertia;
  const regions = {};
  rows.forEach((row, index) => {
    for (const { name, from, to } of partsOf(row)) {
      const region = (regions[name] ??= { area: 0, x: 0, y: 0, widest: 0 });
      const area = (to - from) / (most - least) / rows.length;
      region.widest = Math.max(region.widest, (w * (to - from)) / (most - least));
      region.area += area;
      region.x += (area * ((from + to) / 2 - least)) / (most - least);
      region.y += area * (1 - (index + 0.5) / rows.length);
    }
  });
  context.font = "600 13px system-ui, sans-serif";
  context.textAlign = "center";
  for (const [name, { area, x, y, widest }] of Object.entries(regions)) {
    const text = t(`region${name}`);
    const half = context.measureText(text).width / 2 + 4;
    if (area < SMALLEST || 2 * half > widest) continue;
    context.fillStyle = name === "Together" ? "#000" : "#fff";
    const at = Math.min(Math.max((w * x) / area, half), w - half);
    context.fillText(text, EDGE.left + at, EDGE.top + (h * y) / area);
  }
}

export function drawRuns(context, width, height, { runs, modes }) {
  const logs = RATIOS.map(Math.log10);
  const { toScreen } = placed(width, height, [0, 1], logs);
  const log = (ratio) => Math.min(Math.max(Math.log10(ratio), logs[0]), logs[1]);
  const { accent, target } = palette();
  const share = (index) => `${digits(100 * (1 - 10 ** -index), Math.max(0, index - 2))} %`;
  const xs = [0, 1, 2, 3].map((index) => [
    index / 3,
    modes.restsInFiniteTime ? share(index) : digits(10 ** index - 1, 0),
  ]);
  const ys = [-2, -1, 0, 1, 2].map((y) => [y, digits(10 ** y, Math.max(0, -y))]);
  const x = t(modes.restsInFiniteTime ? "axisShare" : "axisTime");
  axes(context, width, height, toScreen, { xs, ys, x, y: "v/(ωR)" });
  for (const { ratio, stability } of modes.fixedPoints) {
    if (ratio === 0 || ratio === Infinity) continue;
    const points = [
      [0, log(ratio)],
      [1, log(ratio)],
    ].map(toScreen);
    polyline(context, points, { color: target, width: 3, dash: stability === "stable" ? [8, 5] : [2, 6] });
  }
  for (const run of runs) {
    polyline(
      context,
      run.map(([part, ratio]) => toScreen([part, log(ratio)])),
      { color: accent, width: 2 },
    );
  }
}

/** Lines, numbers and names of two axes. */
export function axes(context, width, height, toScreen, { xs, ys, x, y, right = EDGE.right }) {
  const { soft, line } = palette();
  context.font = "12px system-ui, sans-serif";
  context.fillStyle = soft;
  const [bottom, top] = [height - EDGE.bottom, EDGE.top];
  for (const [value, text] of xs) {
    const [at] = toScreen([value, 0]);
    polyline(
      context,
      [
        [at, top],
        [at, bottom],
      ],
      { color: line, width: 1 },
    );
    context.textAlign = at > width - 40 ? "right" : "center";
    context.fillText(text, at > width - 40 ? width - 4 : at, bottom + 16);
  }
  for (const [value, text] of ys) {
    const [, at] = toScreen([0, value]);
    polyline(
      context,
      [
        [EDGE.left, at],
        [width - right, at],
      ],
      { color: line, width: 1 },
    );
    context.textAlign = "right";
    context.fillText(text, EDGE.left - 6, at + 4);
  }
  context.textAlign = "center";
  context.fillText(x, (EDGE.left + width - right) / 2, height - 8);
  context.save();
  context.translate(13, (top + bottom) / 2);
  context.rotate(-Math.PI / 2);
  context.fillText(y, 0, 0);
  context.restore();
}
