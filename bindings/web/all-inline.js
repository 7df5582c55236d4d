// Everything, with the module inside.

import { bytes } from "./dist/all.inline.js";
import { loader, syncLoader } from "./js/wasm.js";

export * from "./js/everything.js";

export const init = loader("all", bytes);
export const initSync = syncLoader("all", bytes);
