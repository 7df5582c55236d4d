// The friction kernel: disks at once, everything else after the first draw.

import disks from "../../dist/tribos.wasm";
import { loader, syncLoader } from "../../js/wasm.js";

export * as kernel from "../../js/everything.js";

const loadDisks = syncLoader("small", () => bytesOf(disks));
const loadAll = loader("all", () => unpacked("all-wasm"));
let all;

/** Disks under Coulomb friction, at once: waiting would let the browser lay out the page in between. */
export const startDisks = () => loadDisks();

/** All patches, laws and launches. */
export function everythingReady() {
  all ??= pageRead()
    .then(() => loadAll())
    .then(() => (isComplete = true));
  return all;
}

/** Whether there is more than disks. */
export let isComplete = false;

/** Bytes that the page has packed under an id. */
export async function unpacked(id) {
  const packed = bytesOf(document.getElementById(id).textContent);
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"));
  return new Response(stream).arrayBuffer();
}

/** Bytes of base64, quickest by what browsers have since 2025. */
function bytesOf(text) {
  if (Uint8Array.fromBase64) return Uint8Array.fromBase64(text);
  const letters = atob(text);
  const bytes = new Uint8Array(letters.length);
  for (let at = 0; at < letters.length; at += 1) bytes[at] = letters.charCodeAt(at);
  return bytes;
}

/** Data that the page has packed under an id. */
export async function unpackedJson(id) {
  await pageRead();
  return JSON.parse(new TextDecoder().decode(await unpacked(id)));
}

/** The whole page is there. */
export function pageRead() {
  if (document.readyState !== "loading") return Promise.resolve();
  return new Promise((done) => document.addEventListener("DOMContentLoaded", done, { once: true }));
}
