// Numbers of a throw, as a table and as a sentence.

import { MODELS } from "./bodies.js";
import { find, put } from "./controls.js";
import { plainDistance } from "./game.js";
import { digits, signed, t } from "./language.js";

const TURN = 2 * Math.PI;

/** Fills the table; dashes where a model did not run, or where nothing was thrown. */
export function showNumbers(result, setup) {
  const exact = result?.runs[0].rest;
  for (const model of MODELS) {
    const cells = find(`row-${model}`).querySelectorAll("td");
    const rest = result?.runs.find((run) => run.model === model)?.rest;
    const error = (key) => (rest === exact || !rest ? undefined : 100 * (rest[key] / exact[key] - 1));
    const values = [rest?.distance, error("distance"), rest?.time, rest && rest.angle / TURN, error("angle")];
    const texts = [
      digits(values[0], 3),
      model === "exact" && rest ? "0" : signed(values[1], 1),
      digits(values[2], 2),
      digits(values[3], 2),
      model === "exact" && rest ? "0" : signed(values[4], 1),
    ];
    cells.forEach((cell, index) => put(cell, texts[index], index === 3 ? rest?.angle : values[index]));
  }
  const farther = exact && setup.alpha === 0 ? 100 * (exact.distance / plainDistance(setup) - 1) : NaN;
  const words = { percent: digits(farther, 0) };
  const carried = farther >= 0.5 ? t("farther", words) : "";
  find("throw-farther").textContent = setup.alpha === 0 ? carried : t("onlyDry");
}

/** The end of a throw in words. */
export function spoken({ runs }, setup) {
  const [{ rest }, ...others] = runs;
  const words = [
    t("rested", {
      distance: digits(rest.distance, 3),
      time: digits(rest.time, 2),
      turns: digits(rest.angle / TURN, 2),
    }),
  ];
  for (const { model, rest: other } of others) {
    const error = signed(100 * (other.distance / rest.distance - 1), 1);
    if (setup.speed > 0) words.push(t("differs", { model: t(model), error }));
  }
  return words.join(" ");
}

/** The end of a game in words, with the answer of the inverse problem. */
export function spokenGame({ miss, off, isHit, points, count, best }) {
  return t(isHit ? "hit" : "missed", {
    miss: digits(100 * miss, 1),
    off: digits((off * 360) / TURN, 0),
    points: digits(points, 0),
    count: digits(count, 0),
    speed: digits(best.speed, 3),
    direction: digits((best.direction * 360) / TURN, 1),
    spin: digits(best.spin, 1),
  });
}
