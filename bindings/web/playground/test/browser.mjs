// Debian's Chromium with the page open. Tests are skipped where something is missing, and fail there if
// TRIBOS_REQUIRE_TARGETS is set.

import { existsSync } from "node:fs";
import { delimiter, join } from "node:path";
import { test } from "node:test";
import { fileURLToPath } from "node:url";

const NAMES = ["chromium", "chromium-browser", "google-chrome"];
const OPTIONS = [
  "--no-sandbox",
  "--disable-background-networking",
  "--disable-component-update",
  "--hide-scrollbars",
];
export const PAGE = new URL("../../../../docs/playground.html", import.meta.url).href;
export const WIDE = { width: 1280, height: 800 };
export const PHONE = { width: 360, height: 740, isMobile: true, hasTouch: true };

const browserPath = (process.env.PATH ?? "")
  .split(delimiter)
  .flatMap((folder) => NAMES.map((name) => join(folder, name)))
  .find(existsSync);
const puppeteer = await import("puppeteer-core").then(
  (module) => module.default,
  () => undefined,
);
const checker = new URL("../../node_modules/axe-core/axe.min.js", import.meta.url);

/** The accessibility checker axe, to be loaded into a page. */
export const checkerPath = fileURLToPath(checker);

/** What is missing, or false. */
export const missing =
  (browserPath === undefined && "missing Chromium: apt-get install -y chromium") ||
  (puppeteer === undefined && "missing puppeteer-core: npm ci --prefix bindings/web") ||
  (!existsSync(checker) && "missing axe-core: npm ci --prefix bindings/web") ||
  false;

/** Starts the browser. */
export function launch() {
  if (missing) throw new Error(missing);
  return puppeteer.launch({ executablePath: browserPath, args: OPTIONS });
}

/** A test that needs the browser, and perhaps something else that may be missing. */
export function inBrowser(name, run, lacks = false) {
  const skip = lacks || (process.env.TRIBOS_REQUIRE_TARGETS === undefined && missing);
  test(name, { skip }, async () => {
    const browser = await launch();
    try {
      await run(browser);
    } finally {
      await browser.close();
    }
  });
}

/** Sets a control; returns what it then has. */
export const setValue = (page, id, value) =>
  page.$eval(
    `#${id}`,
    (input, wanted) => {
      input.value = wanted;
      input.dispatchEvent(new Event(input.tagName === "SELECT" ? "change" : "input"));
      return input.value;
    },
    String(value),
  );

/** The page at an address, complete; `errors` collects what goes wrong in it. */
export async function open(
  browser,
  { hash = "#throw", language = "en", scheme = "light", view = WIDE, motion = "no-preference" } = {},
) {
  const page = await browser.newPage();
  const errors = [];
  page.on("console", (message) => message.type() === "error" && errors.push(message.text()));
  page.on("pageerror", (error) => errors.push(String(error)));
  page.on("request", (request) => /^https?:/.test(request.url()) && errors.push(`loads ${request.url()}`));
  await page.setViewport(view);
  await page.emulateMediaFeatures([
    { name: "prefers-color-scheme", value: scheme },
    { name: "prefers-reduced-motion", value: motion },
  ]);
  await page.evaluateOnNewDocument((chosen) => {
    Object.defineProperty(navigator, "language", { get: () => chosen });
  }, language);
  await page.goto(PAGE + hash);
  await page.waitForFunction(() => performance.getEntriesByName("complete").length > 0, { timeout: 60_000 });
  return { page, errors };
}
