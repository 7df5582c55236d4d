// The panel of curling: curl against spin of each model, computed beforehand.

import { painter, palette, polyline } from "./canvas.js";
import { find } from "./controls.js";
import { unpackedJson } from "./kernel.js";
import { digits, onLanguage, t } from "./language.js";
import { axes } from "./modes-draw.js";
import { programBox } from "./program-box.js";
import { curlingPrograms } from "./programs.js";

/** Limits of the picture: spin in rad/s, curl in m. */
const SPINS = [0, 3.05];
const CURLS = [-0.22, 1.4];
const EDGE = { left: 54, right: 100, top: 12, bottom: 42 };
/** Least distance of two names, in pixels. */
const APART = 15;
/** What is observed: about 1 m, from 0.3 to 1.4 rad/s. */
const OBSERVED = { spin: [0.3, 1.4], curl: [0.8, 1.2] };
const DASHES = [[], [10, 5], [2, 6], [14, 4, 3, 4], [6, 4], [1, 4], []];
const COLORS = ["soft", "soft", "ink", "ellipsoid", "separate", "accent", "target"];
/** Spins at which the table has numbers. */
const SHOWN = [0.75, 1.5, 3];

let curves = [];
let chosen = "";

function draw(context, width, height) {
  const [w, h] = [width - EDGE.left - EDGE.right, height - EDGE.top - EDGE.bottom];
  const toScreen = ([spin, curl]) => [
    EDGE.left + (w * (spin - SPINS[0])) / (SPINS[1] - SPINS[0]),
    EDGE.top + (h * (CURLS[1] - curl)) / (CURLS[1] - CURLS[0]),
  ];
  const colors = palette();
  const [a, b] = [
    toScreen([OBSERVED.spin[0], OBSERVED.curl[1]]),
    toScreen([OBSERVED.spin[1], OBSERVED.curl[0]]),
  ];
  context.globalAlpha = 0.18;
  context.fillStyle = colors.target;
  context.fillRect(a[0], a[1], b[0] - a[0], b[1] - a[1]);
  context.globalAlpha = 1;
  context.font = "13px system-ui, sans-serif";
  context.textAlign = "left";
  context.fillStyle = colors.target;
  context.fillText(t("observed"), a[0], a[1] - 6);
  const xs = [0, 1, 2, 3].map((x) => [x, digits(x, 0)]);
  const ys = [0, 0.5, 1].map((y) => [y, digits(y, 1)]);
  axes(context, width, height, toScreen, { xs, ys, x: t("axisSpin"), y: t("axisCurl"), right: EDGE.right });
  curves.forEach(({ model, points }, index) => {
    const width = model === chosen ? 5 : 2.2;
    polyline(context, points.map(toScreen), { color: colors[COLORS[index]], width, dash: DASHES[index] });
  });
  nameCurves(context, toScreen);
}

/** Writes the names at the ends of the curves, the highest first, without overlap. */
function nameCurves(context, toScreen) {
  const ends = curves.map(({ model, points }, index) => ({ model, index, at: toScreen(points.at(-1)) }));
  ends.sort((a, b) => a.at[1] - b.at[1]);
  let last = -Infinity;
  context.textAlign = "left";
  for (const { model, index, at } of ends) {
    last = Math.max(at[1] + 4, last + APART);
    context.font = `${model === chosen ? "700 " : ""}13px system-ui, sans-serif`;
    context.fillStyle = palette()[COLORS[index]];
    context.fillText(model, at[0] + 8, last);
  }
}

/** A row for each model: numbers, and what is wrong with it. */
function fillTable() {
  document.querySelectorAll("#panel-curling th.spin").forEach((head, index) => {
    head.textContent = digits(SHOWN[index], 2).replace(/[.,]?0+$/, "");
  });
  find("curling-rows").replaceChildren(
    ...curves.map(({ model, points }) => {
      // Narrow pages lay the rows out by themselves: the roles of a table have to be said.
      const row = document.createElement("tr");
      row.role = "row";
      const head = document.createElement("th");
      Object.assign(head, { scope: "row", role: "rowheader" });
      const button = document.createElement("button");
      Object.assign(button, { type: "button", textContent: model });
      button.setAttribute("aria-pressed", model === chosen);
      head.append(button);
      const cells = SHOWN.map((spin) => digits(points.find(([x]) => Math.abs(x - spin) < 1e-9)[1], 3));
      row.append(head, ...[...cells, t(`verdict_${model}`)].map(cell));
      row.lastChild.className = "words";
      return row;
    }),
  );
}

function cell(text) {
  const made = document.createElement("td");
  made.role = "cell";
  made.textContent = text;
  return made;
}

export async function startCurling() {
  ({ curves } = await unpackedJson("curling-data"));
  const paint = painter(find("curling-canvas"), draw);
  const showPrograms = programBox("curling");
  const tell = () => showPrograms(curlingPrograms(chosen ? [chosen] : curves.map(({ model }) => model), SHOWN));
  find("curling-rows").addEventListener("click", ({ target }) => {
    if (target.tagName !== "BUTTON") return;
    const name = target.textContent;
    chosen = chosen === name ? "" : name;
    for (const button of find("curling-rows").querySelectorAll("button")) {
      button.setAttribute("aria-pressed", button.textContent === chosen);
    }
    tell();
    paint();
  });
  tell();
  onLanguage(() => {
    fillTable();
    paint();
  });
}
