// Bundles a program into one file: node examples/bundle/build.mjs FILE

import { build } from "esbuild";
import { fileURLToPath } from "node:url";

await build({
  entryPoints: [fileURLToPath(new URL("main.js", import.meta.url))],
  outfile: process.argv[2] ?? "bundle.js",
  bundle: true,
  minify: true,
  format: "esm",
  target: "es2022",
});
