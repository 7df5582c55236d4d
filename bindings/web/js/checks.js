// What arguments have to be.

/** A number; TypeError for anything else. */
export function number(name, value) {
  if (typeof value !== "number") {
    throw new TypeError(`${name} must be a number, not ${shown(value)}`);
  }
  return value;
}

/** A number, or what stands for it where it is left out. */
export function numberOr(name, value, otherwise) {
  return value === undefined ? otherwise : number(name, value);
}

/** A number from 0 on; NaN passes, and gives NaN. */
export function load(value) {
  if (value < 0) throw new RangeError(`load must be >= 0, not ${value}`);
  return value;
}

/** A whole number of a range. */
export function whole(name, value, least, most) {
  if (!(Number.isInteger(number(name, value)) && value >= least && value <= most)) {
    throw new RangeError(`${name} must be a whole number from ${least} to ${most}, not ${value}`);
  }
  return value;
}

/** One of some words. */
export function word(name, value, words) {
  if (!words.includes(value)) {
    throw new RangeError(`${name} must be ${words.join(" or ")}, not ${shown(value)}`);
  }
  return value;
}

/** An object with fields. */
export function fields(name, value) {
  if (typeof value !== "object" || value === null) {
    throw new TypeError(`${name} must be an object, not ${shown(value)}`);
  }
  return value;
}

/** Says which field of an object is no number; for results that are none. */
export function allNumbers(name, value, keys) {
  fields(name, value);
  for (const key of keys) number(`${name}.${key}`, value[key]);
}

/** The number of rows of `width` numbers. */
export function rowsOf(name, rows, width) {
  const count = rows?.length / width;
  if (!Number.isInteger(count)) {
    throw new TypeError(`${name} must be numbers in rows of ${width}, not ${shown(rows)}`);
  }
  return count;
}

/** Memory for a result. */
export function output(out, length) {
  if (out === undefined) return new Float64Array(length);
  if (!(out instanceof Float64Array) || out.length !== length) {
    throw new TypeError(`out must be a Float64Array of ${length} numbers, not ${shown(out)}`);
  }
  return out;
}

/** A value in a message. */
export function shown(value) {
  if (ArrayBuffer.isView(value) || Array.isArray(value)) {
    return `${value.constructor.name} of ${value.length}`;
  }
  return typeof value === "object" && value !== null ? "an object" : String(value);
}

/** Numbers in rows of `width`, flat or nested, as one array. */
export function flat(name, rows, width) {
  if (rows === undefined || typeof rows[Symbol.iterator] !== "function") {
    throw new TypeError(`${name} must be an array, not ${shown(rows)}`);
  }
  const all = Array.from(rows, (row) => (typeof row === "number" ? row : Array.from(row ?? [NaN])));
  for (const row of all) {
    if (typeof row !== "number" && row.length !== width) {
      throw new TypeError(`${name} must have rows of ${width} numbers`);
    }
  }
  const flattened = all.flat();
  rowsOf(name, flattened, width);
  for (const value of flattened) number(name, value);
  return flattened;
}

/** Two numbers. */
export function pair(name, value) {
  const [x, y] = flat(name, value, 2);
  return [x, y];
}
