// The page: languages, panels, and the first throw.

import { find } from "./controls.js";
import { disksReady } from "./kernel.js";
import { firstLanguage, onLanguage, setLanguage, language } from "./language.js";
import { completeThrow, startThrow } from "./throw.js";

/** What starts a panel when it is first shown. */
const STARTS = {
  throw: () => {},
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

/** Panels come after the first draw: the browser paints between. */
const painted = () => new Promise((done) => requestAnimationFrame(() => setTimeout(done)));

async function start() {
  for (const name of ["en", "de"]) find(`language-${name}`).addEventListener("click", () => setLanguage(name));
  setLanguage(firstLanguage());
  onLanguage(() => {
    for (const name of ["en", "de"]) find(`language-${name}`).setAttribute("aria-pressed", language() === name);
  });
  for (const name of Object.keys(STARTS)) find(`panel-${name}`).hidden = name !== "throw";
  await disksReady();
  startThrow();
  performance.mark("first-draw");
  await painted();
  addEventListener("hashchange", showPanel);
  showPanel();
  await completeThrow();
  performance.mark("complete");
}

start();
