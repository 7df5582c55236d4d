// Numbers of a throw, as a table and as a sentence.

import { MODELS } from "./bodies.js";
import { find, put } from "./controls.js";
import { plainDistance } from "./game.js";
import { digits, signed, t } from "./language.js";
import { moves } from "./race.js";

const TURN = 2 * Math.PI;
/** Percent from which "so many times as far" is easier to read. */
const MANY = 300;

/** Fills the table; dashes where a model did not run, is not yet at rest, or where nothing was thrown. */
export function showNumbers(result, setup, time = Infinity) {
  const restOf = (name) =>
    result?.runs.find(({ model, rest }) => model === name && rest.time <= time)?.rest;
  const exact = restOf("exact");
  for (const model of MODELS) {
    const cells = find(`row-${model}`).querySelectorAll("td");
    const rest = restOf(model);
    const error = (key) => (rest === exact || !rest || !exact ? undefined : 100 * (rest[key] / exact[key] - 1));
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
  find("throw-farther").textContent = setup.alpha === 0 ? carried(exact, setup) : t("onlyDry");
}

/** How much farther than without spin, in words. */
function carried(exact, setup) {
  const times = exact ? exact.distance / plainDistance(setup) : NaN;
  const percent = 100 * (times - 1);
  if (percent > MANY) return t("timesAsFar", { times: digits(times, 0) });
  return percent >= 0.5 ? t("farther", { percent: digits(percent, 0) }) : "";
}

/** The end of a throw in words. */
export function spoken({ runs }, setup) {
  if (!moves(setup)) return t("noMotion");
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

/** The end of a game in words, with two answers of the inverse problem. */
export function spokenGame({ miss, off, isHit, points, count, gentle, spinning, short }) {
  return t(isHit ? "hit" : "missed", {
    miss: digits(100 * miss, 1),
    off: digits((off * 360) / TURN, 0),
    points: digits(points, 0),
    count: digits(count, 0),
    direction: digits((gentle.direction * 360) / TURN, 1),
    speed: digits(gentle.speed, 3),
    spin: digits(gentle.spin, 1),
    speed2: digits(spinning.speed, 3),
    spin2: digits(spinning.spin, 1),
    short: digits(100 * short, 1),
  });
}
