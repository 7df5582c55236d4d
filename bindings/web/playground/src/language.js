// Texts of the page in the chosen language, and numbers as it writes them.

import de from "../text/de.js";
import en from "../text/en.js";

const LANGUAGES = { en, de };
const KEY = "tribos-language";
const listeners = [];
let current = "en";

/** The language of the page: "en" or "de". */
export const language = () => current;

/** A text by its key; {name} in it becomes the value of that name. */
export function t(key, values = {}) {
  const text = LANGUAGES[current][key] ?? key;
  return text.replace(/\{(\w+)\}/g, (_, name) => values[name] ?? "");
}

/** A number with so many decimals, as the language writes it; without Intl, whose first use is slow. */
export function digits(value, decimals) {
  if (!Number.isFinite(value)) return value === Infinity ? "∞" : value === -Infinity ? "−∞" : "–";
  const text = value.toFixed(decimals).replace("-", "−").replace(".", t("decimalPoint"));
  return /[1-9]/.test(text) ? text : text.replace("−", "");
}

/** The same with a plus where it is positive. */
export function signed(value, decimals) {
  const text = digits(value, decimals);
  return value > 0 && /[1-9]/.test(text) ? `+${text}` : text;
}

/** Calls a function whenever the language changes. */
export function onNewLanguage(call) {
  listeners.push(call);
}

/** Calls a function now and whenever the language changes. */
export function onLanguage(call) {
  onNewLanguage(call);
  call();
}

/** Writes the elements of the page in a language. */
export function setLanguage(name, elements = document.querySelectorAll("[data-t], [data-label]")) {
  current = name;
  document.documentElement.lang = name;
  document.title = t("title");
  fill(elements);
  for (const call of listeners) call();
}

/** Writes the page in the language that the reader chose, now and the next time. */
export function chooseLanguage(name) {
  setLanguage(name);
  try {
    localStorage.setItem(KEY, name);
  } catch {
    // Pages from the disk may have no storage: the choice then lasts as long as the page.
  }
}

/** The language that was chosen before, or that of the browser. */
export function firstLanguage() {
  let kept;
  try {
    kept = localStorage.getItem(KEY);
  } catch {
    kept = null;
  }
  const wanted = kept ?? navigator.language ?? "en";
  return wanted.toLowerCase().startsWith("de") ? "de" : "en";
}

/** Plain text needs no parser. */
function write(element, text) {
  if (!/[<&]/.test(text)) {
    element.textContent = text;
    return;
  }
  element.innerHTML = text;
  for (const command of element.querySelectorAll("pre code")) keepWords(command);
}

/** Lines of a command break between its words only: browsers would also break behind a hyphen. */
export function keepWords(command) {
  const words = command.textContent.split(/(\s+)/).map((word) => {
    if (/^\s/.test(word)) return word;
    const span = document.createElement("span");
    span.textContent = word;
    return span;
  });
  command.replaceChildren(...words);
}

/** Sizes in bytes, in MB as the language writes them. */
const megabytes = (sizes) =>
  Object.fromEntries(Object.entries(sizes).map(([name, bytes]) => [name, digits(bytes / 1e6, 2)]));

/** Puts the texts that elements name into them. */
export function fill(elements) {
  for (const element of elements) {
    const { t: key, label, sizes } = element.dataset;
    if (key) write(element, t(key, sizes && megabytes(JSON.parse(sizes))));
    if (label) element.setAttribute("aria-label", t(label));
  }
}
