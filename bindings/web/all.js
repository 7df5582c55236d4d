// Everything: all patches, laws, launches and contacts.

import { loader, syncLoader } from "./js/wasm.js";

export * from "./js/everything.js";

export const init = loader("all", () => new URL("./dist/all.wasm", import.meta.url));
export const initSync = syncLoader("all");
