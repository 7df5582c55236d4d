// Every panel in both languages, light and dark, wide and on a phone.

import assert from "node:assert/strict";
import { readFileSync, statSync } from "node:fs";
import { test } from "node:test";
import "../../test/built.mjs";
import { PAGE, PHONE, WIDE, checkerPath, inBrowser, open, setValue } from "./browser.mjs";
import de from "../text/de.js";
import en from "../text/en.js";
import { rowOf } from "../src/modes-row.js";
import * as kernel from "../../all.js";

await kernel.init();

const PANELS = ["throw", "surface", "modes", "curling", "powder", "worksheet"];
const TEXTS = { de, en };
const VIEWS = { wide: WIDE, phone: PHONE };
const SCHEMES = ["light", "dark"];
/** Colours of letters on the canvases. */
const LETTERS = ["soft", "exact", "ellipsoid", "separate", "accent", "target", "ink"];
/** Least contrast of letters, WCAG 2 AA. */
const LEAST_CONTRAST = 4.5;

/** A canvas has been drawn on. */
const isDrawn = (canvas) => {
  const { data } = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
  return data.some((value) => value !== 0);
};

/** Shows a panel and waits for its pictures. */
async function show(page, panel) {
  await page.evaluate((hash) => (location.hash = hash), panel);
  const title = await page.waitForSelector(`#${panel}-title`, { visible: true });
  for (const canvas of await page.$$(`#panel-${panel} canvas`)) {
    await page.waitForFunction(isDrawn, { timeout: 20_000 }, canvas);
  }
  return title.evaluate((heading) => heading.textContent);
}

/** Shows all panels in a look, and runs a check on each. */
async function inEveryPanel(browser, look, check) {
  const { page, errors } = await open(browser, { ...look, motion: "reduce" });
  for (const panel of PANELS) {
    assert.equal(await show(page, panel), TEXTS[look.language][`${panel}Title`]);
    await check(page, panel);
  }
  assert.deepEqual(errors, []);
  await page.close();
}

for (const [name, view] of Object.entries(VIEWS)) {
  for (const language of Object.keys(TEXTS)) {
    inBrowser(`panels open without errors and fit: ${language}, ${name}`, async (browser) => {
      for (const scheme of SCHEMES) {
        await inEveryPanel(browser, { language, scheme, view }, async (page, panel) => {
          assert.equal(await page.$eval("html", (root) => root.lang), language);
          const width = await page.evaluate(() => document.documentElement.scrollWidth);
          assert.ok(width <= view.width, `${panel} is ${width} pixels wide, the window ${view.width}`);
        });
      }
    });
  }
  // The checker takes most of the time of these tests: one language for each view.
  const language = name === "wide" ? "en" : "de";
  for (const scheme of SCHEMES) {
    inBrowser(`panels are accessible: ${language}, ${name}, ${scheme}`, async (browser) => {
      await inEveryPanel(browser, { language, scheme, view }, accessible);
    });
  }
}

inBrowser("letters on the canvases have contrast, light and dark", async (browser) => {
  for (const scheme of SCHEMES) {
    const { page } = await open(browser, { scheme, motion: "reduce" });
    const colors = await page.evaluate(
      (names) => {
        const style = getComputedStyle(document.documentElement);
        return names.map((name) => style.getPropertyValue(`--${name}`).trim());
      },
      ["panel", ...LETTERS],
    );
    const [panel, ...letters] = colors.map(luminanceOf);
    letters.forEach((letter, index) => {
      const contrast = (Math.max(letter, panel) + 0.05) / (Math.min(letter, panel) + 0.05);
      assert.ok(contrast >= LEAST_CONTRAST, `${scheme}: ${LETTERS[index]} has ${contrast.toFixed(2)}`);
    });
    await page.close();
  }
});

/** Relative luminance of a colour "#rrggbb", as WCAG 2 defines it. */
function luminanceOf(color) {
  assert.match(color, /^#[\da-f]{6}$/);
  const [red, green, blue] = [1, 3, 5].map((at) => {
    const value = parseInt(color.slice(at, at + 2), 16) / 255;
    return value <= 0.04045 ? value / 12.92 : ((value + 0.055) / 1.055) ** 2.4;
  });
  return 0.2126 * red + 0.7152 * green + 0.0722 * blue;
}

/** No violations of WCAG 2 A and AA that axe knows of. */
async function accessible(page, panel) {
  if (!(await page.evaluate(() => "axe" in window))) await page.addScriptTag({ path: checkerPath });
  const violations = await page.evaluate(async () => {
    const options = { runOnly: { type: "tag", values: ["wcag2a", "wcag2aa"] } };
    const { violations: found } = await globalThis.axe.run(document, options);
    return found.map(({ id, nodes }) => `${id}: ${nodes.map(({ html }) => html).join(" ")}`);
  });
  assert.deepEqual(violations, [], panel);
}

inBrowser("the language switches without a reload, numbers included", async (browser) => {
  const { page } = await open(browser, { motion: "reduce" });
  const distance = () => page.$eval("#row-exact td", (cell) => cell.textContent);
  assert.match(await distance(), /^0\.661$/);
  const kept = () => page.evaluate(() => localStorage.getItem("tribos-language"));
  assert.equal(await kept(), null);
  await page.click("#language-de");
  assert.equal(await kept(), "de");
  assert.match(await distance(), /^0,661$/);
  assert.equal(await page.title(), de.title);
  assert.equal(await page.$eval("html", (root) => root.lang), "de");
});

inBrowser(
  "a push on a box, a body of the diagram, and the end of the powder have their numbers",
  async (browser) => {
    const { page, errors } = await open(browser, { motion: "reduce" });
    const text = (id) => page.$eval(`#${id}`, (element) => element.textContent);
    await show(page, "surface");
    const before = await text("surface-say");
    await page.click("#surface-canvas");
    assert.notEqual(await text("surface-say"), before);
    await show(page, "modes");
    assert.match(await text("modes-say"), /0\.653/);
    await page.focus("#modes-map");
    await page.keyboard.press("ArrowRight");
    assert.doesNotMatch(await text("modes-say"), /0\.653/);
    await setValue(page, "modes-inertia", "0.5");
    await setValue(page, "modes-alpha", "1");
    assert.match(await text("modes-say"), /^Every ratio stays as thrown/);
    await show(page, "powder");
    assert.match(await text("powder-say"), /66\.3\s%.*73\.8\s%.*82\.7\s%.*89\.4\s%/);
    assert.deepEqual(errors, []);
  },
);

test("the diagram has the ratios and limits of the kernel", () => {
  for (const make of [kernel.disk, kernel.ring, kernel.hertz, kernel.paraboloid, kernel.punch]) {
    for (const alpha of [-0.88, -0.3, 0.4, 0.95, 1.5]) {
      const friction = make({ radius: 1, mu: 1, alpha });
      const { low, high, stops } = rowOf(friction);
      assert.deepEqual([low, high], friction.modes(0.5).inertiaInterval);
      assert.equal(stops.length > 0, alpha < 1);
      for (const [inertia, ratio] of stops) {
        assert.ok(inertia > low && inertia < high, `${friction.kind}, exponent ${alpha}, ratio ${ratio}`);
        const found = friction.modes(inertia).finalRatio;
        assert.ok(
          Math.abs(found / ratio - 1) < 1e-6,
          `${friction.kind}, exponent ${alpha}: ${found}, ${ratio}`,
        );
      }
      const middle = friction.modes((low + high) / 2).finalRatio;
      assert.equal(middle === null, alpha > 1);
      friction.free();
    }
  }
});

inBrowser("while an outline is drawn, nothing of the former body is shown", async (browser) => {
  const { page, errors } = await open(browser, { motion: "reduce" });
  await show(page, "surface");
  const cells = () => page.$$eval("#panel-surface td", (found) => found.map((cell) => cell.textContent));
  const choose = (shape) =>
    page.$eval(
      "#surface-shape",
      (input, wanted) => {
        input.value = wanted;
        input.dispatchEvent(new Event("change"));
      },
      shape,
    );
  await choose("drawn");
  assert.ok((await cells()).every((text) => text === "–"));
  assert.equal(await page.$eval("#surface-say", (line) => line.textContent), en.drawInBox);
  for (const id of ["surface-canvas", "section-canvas"]) {
    assert.equal(await page.$eval(`#${id}`, isDrawn), false, id);
  }
  // Another choice gives up the drawing.
  await choose("box");
  assert.ok((await cells()).every((text) => text !== "–"));
  await choose("drawn");
  const { x, y } = await (await page.$("#plan-canvas")).boundingBox();
  await page.mouse.move(x + 80, y + 60);
  await page.mouse.down();
  for (const [right, down] of [
    [200, 60],
    [200, 160],
    [80, 160],
    [80, 90],
  ]) {
    await page.mouse.move(x + right, y + down, { steps: 6 });
  }
  await page.mouse.up();
  assert.ok((await cells()).every((text) => text !== "–"));
  assert.deepEqual(errors, []);
});

inBrowser("the worksheet has five experiments, and prints its answers apart", async (browser) => {
  const { page } = await open(browser);
  await show(page, "worksheet");
  assert.equal((await page.$$("#sheet article")).length, 5);
  const shown = (selector) => page.$eval(selector, (element) => element.offsetHeight > 0);
  assert.equal(await shown("#sheet-answers"), false);
  await page.emulateMediaType("print");
  assert.equal(await shown("#sheet-answers"), true);
  assert.equal(await shown("#sheet details"), false);
});

inBrowser("paper has dark letters, also where the screen has light ones", async (browser) => {
  const { page } = await open(browser, { scheme: "dark", motion: "reduce" });
  const blue = () =>
    page.evaluate(() => getComputedStyle(document.documentElement).getPropertyValue("--exact").trim());
  const canvas = await page.$("#throw-canvas");
  const [screen, before] = [await blue(), await canvas.evaluate((drawn) => drawn.toDataURL())];
  await page.emulateMediaType("print");
  await page.waitForFunction((drawn, old) => drawn.toDataURL() !== old, {}, canvas, before);
  assert.ok(luminanceOf(await blue()) < luminanceOf(screen));
  // Nothing has the dark ground of the screen.
  const share = await canvas.evaluate((drawn) => {
    const { data } = drawn.getContext("2d").getImageData(0, 0, drawn.width, drawn.height);
    let dark = 0;
    for (let at = 0; at < data.length; at += 4)
      dark += data[at + 3] > 200 && data[at] < 60 && data[at + 2] < 60;
    return (4 * dark) / data.length;
  });
  assert.ok(share < 0.01, `${100 * share} % of the canvas is dark`);
});

inBrowser("the commands of the page that no slider changes are printed in the book, where a test runs them", async (browser) => {
  const { page } = await open(browser);
  const commands = await page.$$eval(":not(.programs) > pre code", (codes) => codes.map((code) => code.textContent));
  const book = ["teaching", "pushing", "runs"].map((name) =>
    readFileSync(new URL(`../../../../docs/${name}.md`, import.meta.url), "utf8"),
  );
  const words = book.join("\n").replace(/\\\n\s*/g, "");
  assert.equal(commands.length, 6);
  for (const command of commands) assert.ok(words.includes(command), command);
});

inBrowser("programs follow the sliders and are copied, with the clipboard or without", async (browser) => {
  const { page, errors } = await open(browser, { motion: "reduce" });
  await page.evaluate(() => {
    globalThis.copied = [];
    const keep = (text) => globalThis.copied.push(text);
    Object.defineProperty(navigator, "clipboard", { value: { writeText: keep }, configurable: true });
    addEventListener("copy", (event) => setTimeout(keep, 0, event.clipboardData.getData("text/plain")));
  });
  await setValue(page, "throw-spin", 42);
  const programs = await page.$$eval("#panel-throw .programs code", (codes) =>
    codes.map((code) => code.textContent),
  );
  for (const program of programs) assert.match(program, /\b42\b/);
  const buttons = await page.$$("#panel-throw .programs button");
  for (const button of buttons) await button.click();
  await page.evaluate(() => Object.defineProperty(navigator, "clipboard", { value: undefined }));
  for (const button of buttons) await button.click();
  await page.waitForFunction(() => globalThis.copied.length === 4);
  assert.deepEqual(await page.evaluate(() => globalThis.copied), [...programs, ...programs]);
  const said = await page.$$eval("#panel-throw .programs [role=status]", (spans) =>
    spans.map((span) => span.textContent),
  );
  assert.deepEqual(said, [en.copied, en.copied]);
  assert.deepEqual(errors, []);
});

inBrowser("the page says its size in both languages", async (browser) => {
  const { size } = statSync(new URL(PAGE));
  for (const [language, point] of Object.entries({ en: ".", de: "," })) {
    const { page } = await open(browser, { language });
    const said = await page.$eval("footer", (footer) => footer.textContent);
    assert.ok(said.includes(`${(size / 1e6).toFixed(2).replace(".", point)}\u00a0MB`), said);
    await page.close();
  }
});
