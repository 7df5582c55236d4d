// Tests need the WebAssembly: imported before it is loaded, this says how to build it.

import { existsSync } from "node:fs";

for (const name of ["tribos.wasm", "all.wasm"]) {
  if (!existsSync(new URL(`../dist/${name}`, import.meta.url))) {
    throw new Error(`bindings/web/dist/${name} is missing. Build it: node bindings/web/build.mjs`);
  }
}
