// Makes docs/playground.png, a picture of the first panel: `node bindings/web/playground/picture.mjs`.
//
// Needs docs/playground.html, Chromium, and what `npm ci --prefix bindings/web` installs.

import { fileURLToPath } from "node:url";
import { launch, open } from "./test/browser.mjs";

const VIEW = { width: 1240, height: 954 };
const path = fileURLToPath(new URL("../../../docs/playground.png", import.meta.url));

const browser = await launch();
try {
  // Without motion the throw shows its end at once; a press tells it in words.
  const { page } = await open(browser, { view: VIEW, motion: "reduce" });
  await page.click("#throw-go");
  await page.evaluate(() => document.activeElement.blur());
  await page.mouse.move(0, 0);
  await page.screenshot({ path });
} finally {
  await browser.close();
}
console.log("docs/playground.png");
