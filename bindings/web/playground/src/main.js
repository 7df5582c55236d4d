// The page: languages, panels, and the first throw.

import { find } from "./controls.js";
import { startCurling } from "./curling.js";
import { pageRead, startDisks } from "./kernel.js";
import { chooseLanguage, fill, firstLanguage, language, onLanguage, setLanguage } from "./language.js";
import { startModes } from "./modes.js";
import { startPowder } from "./powder.js";
import { startSurface } from "./surface.js";
import { completeThrow, drawThrow, startThrow } from "./throw.js";
import { startWorksheet } from "./worksheet.js";

/** What starts a panel when it is first shown. */
const STARTS = {
  throw: () => {},
  surface: startSurface,
  modes: startModes,
  curling: startCurling,
  powder: startPowder,
  worksheet: startWorksheet,
};
const started = new Set();

/** Shows the panel of the address. */
function showPanel() {
  const wanted = location.hash.slice(1);
  const name = wanted in STARTS ? wanted : "throw";
  for (const other of Object.keys(STARTS)) find(`panel-${other}`).hidden = other !== name;
  for (const link of document.querySelectorAll("nav a")) {
    if (link.hash === `#${name}`) link.setAttribute("aria-current", "page");
    else link.removeAttribute("aria-current");
  }
  if (started.has(name)) return;
  started.add(name);
  STARTS[name]();
}

/** Elements with texts. */
const textsOf = () => [...document.querySelectorAll("[data-t], [data-label]")];

/** What is seen around the first picture. Other texts come after it: their layout would delay it. */
const FIRST = "header, nav, #panel-throw";

/** Panels come after the first draw: the browser paints between. */
const painted = () => new Promise((done) => requestAnimationFrame(() => setTimeout(done)));

async function start() {
  for (const name of ["en", "de"])
    find(`language-${name}`).addEventListener("click", () => chooseLanguage(name));
  const first = new Set(textsOf().filter((element) => element.closest(FIRST)));
  setLanguage(firstLanguage(), first);
  onLanguage(() => {
    for (const name of ["en", "de"])
      find(`language-${name}`).setAttribute("aria-pressed", language() === name);
  });
  startDisks();
  drawThrow();
  performance.mark("first-draw");
  // The other parts follow the script.
  await pageRead();
  await painted();
  startThrow();
  fill(textsOf().filter((element) => !first.has(element)));
  addEventListener("hashchange", showPanel);
  showPanel();
  await completeThrow();
  performance.mark("complete");
}

start();
