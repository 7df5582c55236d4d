// What tests share.

import { readFileSync } from "node:fs";
import "./built.mjs";

/** A file of the package. */
export const file = (path) => new URL(`../${path}`, import.meta.url);

/** The text of a file of the package. */
export const text = (path) => readFileSync(file(path), "utf8");

/** Deterministic numbers from 0 to 1: Mulberry32 (Tommy Ettinger), to the bits of `tests/bits.rs`. */
export function stream(seed) {
  let state = seed | 0;
  return () => {
    state = (state + 0x6d2b79f5) | 0;
    let t = Math.imul(state ^ (state >>> 15), 1 | state);
    t = (t + Math.imul(t ^ (t >>> 7), 61 | t)) ^ t;
    return ((t ^ (t >>> 14)) >>> 0) / 2 ** 32;
  };
}

/** Digests that the kernel computed natively, a line each; undefined if there are none. */
export function expected() {
  try {
    return text("dist/bits.txt").trim().split("\n");
  } catch {
    return undefined;
  }
}
