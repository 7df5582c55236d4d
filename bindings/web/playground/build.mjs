// Makes docs/playground.html: `node bindings/web/playground/build.mjs`.
//
// Needs the WebAssembly that `node bindings/web/build.mjs` makes, and esbuild (`npm ci --prefix bindings/web`).
// The page is one file that opens from the disk. The script with the disk module comes first and draws at
// once; what only later panels need follows it, packed, and is read after that.

import { existsSync, readFileSync, writeFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { gzipSync } from "node:zlib";

const here = (path) => fileURLToPath(new URL(path, import.meta.url));
const PACKED = {
  "all-wasm": "../dist/all.wasm",
  "curling-data": "data/curling.json",
  "powder-data": "data/powder.json",
};

/** Stands for the size of the page until it is known; has as many digits. */
const UNKNOWN = 1000000;

let esbuild;
try {
  esbuild = await import("esbuild");
} catch (error) {
  if (error.code !== "ERR_MODULE_NOT_FOUND") throw error;
  stop("esbuild is missing. Install it: npm ci --prefix bindings/web");
}
for (const name of ["tribos.wasm", "all.wasm"]) {
  if (existsSync(here(`../dist/${name}`))) continue;
  stop(`bindings/web/dist/${name} is missing. Build it: node bindings/web/build.mjs`);
}

const bundle = await esbuild.build({
  entryPoints: [here("src/main.js")],
  bundle: true,
  minify: true,
  format: "iife",
  target: "es2022",
  // Chromium has parsed a page of ASCII alone up to the script in 23 ms of processor time, one of UTF-8 in 30.
  charset: "ascii",
  loader: { ".wasm": "base64" },
  write: false,
  // Only code for Node asks where it is; the page is one script.
  logOverride: { "empty-import-meta": "silent" },
});
const css = await esbuild.transform(readFileSync(here("style.css"), "utf8"), { loader: "css", minify: true });
const packs = Object.fromEntries(Object.entries(PACKED).map(([id, path]) => [id, packed(path)]));
const parts = {
  STYLE: css.code,
  // An end tag inside the script would end it.
  SCRIPT: bundle.outputFiles[0].text.replaceAll("</script", "<\\/script"),
  DATA: Object.entries(packs)
    .map(([id, bytes]) => `<script type="text/plain" id="${id}">${bytes.toString("base64")}</script>`)
    .join("\n"),
  SIZES: JSON.stringify({
    page: UNKNOWN,
    disks: bytesOf("../dist/tribos.wasm"),
    all: bytesOf(PACKED["all-wasm"]),
    packed: packs["all-wasm"].length,
  }),
};
const template = readFileSync(here("page.html"), "utf8");
const page = template.replace(
  /<!--(SCRIPT|DATA)-->|\/\*(STYLE|SIZES)\*\//g,
  (_, a, b) => parts[a ?? b],
);
const size = Buffer.byteLength(page);
const target = here("../../../docs/playground.html");
writeFileSync(target, page.replace(`"page":${UNKNOWN}`, `"page":${size}`));
console.log(`docs/playground.html  ${(size / 1e6).toFixed(2)} MB`);

/** A file as the page has it, before base64. */
function packed(path) {
  return gzipSync(readFileSync(here(path)), { level: 9 });
}

function bytesOf(path) {
  return readFileSync(here(path)).length;
}

function stop(reason) {
  console.error(reason);
  process.exit(1);
}
