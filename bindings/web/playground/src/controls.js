// Sliders, buttons and tables.

import { digits } from "./language.js";

/** Elements of the page by id. */
export const find = (id) => document.getElementById(id);

/**
 * Binds a slider to a number of `state`: `read` makes the number of the slider's, `write` the reverse. Returns
 * a function that shows the number of the state.
 */
export function slider(
  id,
  state,
  key,
  { decimals = 2, unit = "", read = (x) => x, write = (x) => x, changed },
) {
  const input = find(id);
  const output = document.querySelector(`output[for="${id}"]`);
  const show = () => {
    const text = `${digits(write(state[key]), decimals)}${spaced(unit)}`;
    input.value = write(state[key]);
    output.textContent = text;
    input.setAttribute("aria-valuetext", text);
  };
  input.addEventListener("input", () => {
    state[key] = read(Number(input.value));
    show();
    changed(key);
  });
  return show;
}

/** A unit as it follows a number. Fonts without the narrow space would make the browser look for another font. */
const spaced = (unit) => (unit === "" || unit === "°" ? unit : `\u00a0${unit}`);

/** Binds a list of choices to a word of `state`. */
export function choice(id, state, key, changed) {
  const input = find(id);
  input.addEventListener("change", () => {
    state[key] = input.value;
    changed(key);
  });
  return () => {
    input.value = state[key];
  };
}

/** Limits of a slider. */
export function range(id, min, max, step) {
  Object.assign(find(id), { min, max, step });
}

/** The 64 bits of a number, as 16 hexadecimal digits. */
export function bitsOf(value) {
  const view = new DataView(new ArrayBuffer(8));
  view.setFloat64(0, value);
  return view.getBigUint64(0).toString(16).padStart(16, "0");
}

/** Shows a number in a cell: the text for people, all of its bits for programs. */
export function put(cell, text, value) {
  cell.textContent = text;
  if (value === undefined) delete cell.dataset.bits;
  else cell.dataset.bits = bitsOf(value);
}
