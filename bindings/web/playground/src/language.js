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

/** Calls a function now and whenever the language changes. */
export function onLanguage(call) {
  listeners.push(call);
  call();
}

/** Writes the page in a language. */
export function setLanguage(name) {
  current = name;
  document.documentElement.lang = name;
  document.title = t("title");
  fill(document);
  for (const call of listeners) call();
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

/** Puts texts into all elements that name one. */
export function fill(root) {
  for (const element of root.querySelectorAll("[data-t]")) element.innerHTML = t(element.dataset.t);
  for (const element of root.querySelectorAll("[data-label]")) {
    element.setAttribute("aria-label", t(element.dataset.label));
  }
}
