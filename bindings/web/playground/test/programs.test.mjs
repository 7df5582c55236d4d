// The commands and programs of the panels give the numbers that the page shows. They are run where there are
// `tribos` on the PATH, or the program that TRIBOS names, and a Python with the package, which TRIBOS_PYTHON names.
// TRIBOS_SLOW also runs the powders.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import "../../test/built.mjs";
import { inBrowser, open, setValue } from "./browser.mjs";

const TRIBOS = process.env.TRIBOS ?? "tribos";
const PYTHON = process.env.TRIBOS_PYTHON ?? "python3";

/** Settings of the controls of a panel, one run each. */
const THROWS = [
  {},
  { speed: 0.35, spin: -60, mu: 0.31 },
  { alpha: -0.5, radius: 3.5 },
  { alpha: 0.6, spin: 30 },
  { pressure: "hertz", spin: 70 },
  { pressure: "paraboloid", alpha: 0.3 },
  { pressure: "punch" },
  { shape: "annulus" },
  { shape: "ring", alpha: -0.2 },
  { ground: "floor", shape: "box", direction: 25 },
  { ground: "ice", shape: "triangle", direction: -110 },
  { shape: "ell", spin: -90 },
];
const PUSHES = [
  {},
  { part: 80, angle: 30 },
  { shape: "puck", angle: 20 },
  { shape: "puck", angle: 60 },
  { shape: "annulus", angle: -40 },
  { shape: "ring", angle: 33 },
  { shape: "hertz", angle: 50 },
  { shape: "punch", angle: -12 },
  { shape: "triangle", part: 10 },
  { shape: "triangle", part: 57, angle: -45 },
  { shape: "ell", part: 31 },
  { shape: "ell", part: 66, angle: 15 },
];
const BODIES = [
  {},
  { inertia: 0.1 },
  { inertia: 1.1 },
  { alpha: 0.5, inertia: 0.3 },
  { alpha: 1 },
  { alpha: 1.6, inertia: 0.5 },
  { alpha: -0.4, pressure: "ring", inertia: 1.2 },
  { pressure: "hertz", alpha: 0.2, inertia: 0.4 },
  { pressure: "hertz", inertia: 0.2 },
  { pressure: "paraboloid", inertia: 0.33 },
  { pressure: "punch", inertia: 0.6 },
  { pressure: "punch", alpha: -0.7, inertia: 0.9 },
];

const folder = mkdtempSync(join(tmpdir(), "tribos-programs-"));
process.on("exit", () => rmSync(folder, { recursive: true }));
const run = (program, ...words) =>
  execFileSync(program, words, { cwd: folder, encoding: "utf8", stdio: ["ignore", "pipe", "pipe"] });

const missing = [
  [TRIBOS, "--version"],
  [PYTHON, "-c", "import tribos"],
].flatMap((words) => {
  try {
    run(...words);
    return [];
  } catch {
    return `missing: ${words.join(" ")}`;
  }
})[0];

/** What the command and the program of a panel print. */
async function printed(page, panel) {
  const [shell, python] = await page.$$eval(`#panel-${panel} .programs code`, (codes) =>
    codes.map((code) => code.textContent),
  );
  const answer = run(PYTHON, "-c", python).trim();
  return {
    shell: run("sh", "-c", `tribos() { '${TRIBOS}' --quiet "$@"; }\n${shell}`),
    python: answer,
    words: answer.split(/[\s(),]+/),
  };
}

/** The page writes this number so. */
function shows(text, value, what) {
  const number = text === "∞" ? Infinity : Number(text.replace("−", "-"));
  const decimals = text.split(".")[1]?.length ?? 0;
  const isSame = number === value || Math.abs(number - value) <= 0.501 * 10 ** -decimals;
  assert.ok(isSame || (text === "∞" && value > 1e6), `${what}: ${value} where the page has ${text}`);
}

const cellsOf = (page, row) => page.$$eval(`#${row} td`, (cells) => cells.map((cell) => cell.textContent));
const numberAfter = (text, ...names) =>
  Number(text.match(new RegExp(`^(?:${names.join("|")})\\s+(\\S+)`, "m"))[1]);
/** Of each run of a sweep, a column of its table and the last word of a line in Python. */
function rowsOf(sweep, name, python) {
  const [head, ...lines] = readFileSync(join(folder, sweep, "runs.csv"), "utf8").trim().split("\n");
  const column = head.split(",").indexOf(name);
  const words = python.split("\n").map((line) => line.split(" ").at(-1));
  assert.equal(words.length, lines.length);
  return lines.map((line, index) => [line.split(",")[column], words[index]].map(Number));
}

/** Runs a panel under settings. */
function compared(panel, settings, compare) {
  const run = async (browser) => {
    const { page } = await open(browser, { motion: "reduce", hash: `#${panel}` });
    for (const setting of settings) {
      await page.reload();
      await page.waitForFunction(() => performance.getEntriesByName("complete").length > 0);
      const isFilled = (name) => document.querySelector(`#panel-${name} code.python`)?.textContent;
      await page.waitForFunction(isFilled, {}, panel);
      for (const [id, value] of Object.entries(setting)) await setValue(page, `${panel}-${id}`, value);
      await compare(page, await printed(page, panel), JSON.stringify(setting));
    }
  };
  inBrowser(`the programs of the panel ${panel} give its numbers`, run, missing);
}

compared("throw", THROWS, async (page, { shell, words }, what) => {
  const [distance, , time, turns] = await cellsOf(page, "row-exact");
  for (const [text, command, program] of [
    [distance, numberAfter(shell, "distance", "forward"), words[0]],
    [time, numberAfter(shell, "time"), words[1]],
    [turns, numberAfter(shell, "angle") / (2 * Math.PI), words[2] / (2 * Math.PI)],
  ]) {
    shows(text, command, what);
    shows(text, Number(program), what);
  }
});

compared("surface", PUSHES, async (page, { shell, words }, what) => {
  const [fx, fy, torque, gauge, vx, vy, spin] = shell.trim().split("\n").at(-1).split(",").map(Number);
  const speed = Math.hypot(vx, vy);
  const commands = [Math.hypot(fx, fy) / gauge, torque / gauge, spin / speed, speed / Math.abs(spin)];
  (await cellsOf(page, "surface-exact")).forEach((text, index) => {
    shows(text, commands[index], what);
    shows(text, Number(words[index]), what);
  });
});

compared("modes", BODIES, async (page, { shell, python, words }, what) => {
  const said = await page.$eval("#modes-say", (line) => line.textContent);
  const numbers = said.match(/[\d.]*\d/g);
  const ratio = said.match(/v\/\(ωR\) = ([\d.]*\d)/)?.[1];
  const [low, high] = shell.match(/([\d.]+) < C < ([\d.]+)/)?.slice(1) ?? [];
  if (ratio !== undefined) {
    shows(ratio, Number(shell.match(/at ratio (\S+)/)[1]), what);
    shows(ratio, Number(words[1]), what);
  }
  const interval = python.match(/\(([\d.]+), ([\d.]+)\)$/);
  for (const [at, command] of Object.entries({ "-2": low, "-1": high })) {
    if (command !== undefined) shows(numbers.at(at), Number(command), what);
    shows(numbers.at(at), Number(interval.at(at)), what);
  }
});

const curling = async (browser) => {
  const { page } = await open(browser, { hash: "#curling" });
  await page.waitForSelector("#curling-rows button");
  const rows = await page.$$("#curling-rows tr");
  for (const chosen of [rows, [0], [3], [5]]) {
    const shown = chosen === rows ? rows : chosen.map((index) => rows[index]);
    if (chosen !== rows) await (await shown[0].$("button")).click();
    const cells = (row) => row.$$eval("td:not(.words)", (found) => found.map((cell) => cell.textContent));
    const texts = (await Promise.all(shown.map(cells))).flat();
    const ran = rowsOf("out/curling", "curl", (await printed(page, "curling")).python);
    assert.equal(ran.length, texts.length);
    texts.forEach((text, index) => ran[index].forEach((value) => shows(text, value, "curling")));
  }
};
inBrowser("the programs of the panel curling give its numbers", curling, missing);

const powder = async (browser) => {
  const { page } = await open(browser, { hash: "#powder", motion: "reduce" });
  await page.waitForFunction(() => document.querySelector("#powder-say").textContent);
  for (const share of [1000, 300]) {
    await setValue(page, "powder-time", share);
    await page.$eval("#powder-time", (input) => input.dispatchEvent(new Event("change")));
    const texts = await page.$$eval(".films strong", (found) => found.map((one) => parseFloat(one.textContent)));
    const ran = rowsOf("out/powder", "porosity_final", (await printed(page, "powder")).python);
    texts.forEach((text, index) =>
      ran[index].forEach((value) => shows(text.toFixed(1), 100 * value, `powder at ${share}`)),
    );
  }
};
const slow = process.env.TRIBOS_SLOW === undefined && "takes minutes: TRIBOS_SLOW=1";
inBrowser("the programs of the panel powder give its numbers", powder, missing ?? slow);
