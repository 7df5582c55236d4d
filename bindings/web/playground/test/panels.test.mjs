// Every panel in both languages, light and dark, wide and on a phone.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { PHONE, WIDE, checkerPath, inBrowser, open } from "./browser.mjs";
import de from "../text/de.js";
import en from "../text/en.js";

const PANELS = ["throw", "surface", "modes", "curling", "powder", "worksheet"];
const LOOKS = [
  { language: "en", scheme: "light", view: WIDE },
  { language: "en", scheme: "dark", view: PHONE },
  { language: "de", scheme: "dark", view: WIDE },
  { language: "de", scheme: "light", view: PHONE },
];

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

for (const look of LOOKS) {
  const { language, scheme, view } = look;
  inBrowser(
    `panels open without errors: ${language}, ${scheme}, ${view.width} pixels wide`,
    async (browser) => {
      const { page, errors } = await open(browser, { ...look, motion: "reduce" });
      const texts = { de, en }[language];
      assert.equal(await page.$eval("html", (root) => root.lang), language);
      for (const panel of PANELS) {
        assert.equal(await show(page, panel), texts[`${panel}Title`]);
        const [width, room] = await page.evaluate(() => [document.documentElement.scrollWidth, innerWidth]);
        assert.ok(width <= room, `${panel} is ${width} pixels wide, the window ${room}`);
        await accessible(page, panel);
      }
      assert.deepEqual(errors, []);
    },
  );
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
  await page.click("#language-de");
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
    const set = (id, value) =>
      page.$eval(
        `#${id}`,
        (input, wanted) => {
          input.value = wanted;
          input.dispatchEvent(new Event("input"));
        },
        value,
      );
    await set("modes-inertia", "0.5");
    await set("modes-alpha", "1");
    assert.match(await text("modes-say"), /^Every ratio stays as thrown/);
    await show(page, "powder");
    assert.match(await text("powder-say"), /66\.3 %.*73\.8 %.*82\.7 %.*89\.4 %/);
    assert.deepEqual(errors, []);
  },
);

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

inBrowser("every command of the page is printed in the book, where a test runs it", async (browser) => {
  const { page } = await open(browser);
  const commands = await page.$$eval("pre code", (codes) => codes.map((code) => code.textContent));
  const book = ["teaching", "inverse", "pushing", "view"].map((name) =>
    readFileSync(new URL(`../../../../docs/${name}.md`, import.meta.url), "utf8"),
  );
  const words = book.join("\n").replace(/\\\n\s*/g, "");
  assert.ok(commands.length >= 9);
  for (const command of commands) assert.ok(words.includes(command), command);
});
