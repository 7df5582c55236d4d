// Disks under Coulomb friction.

import { loader, syncLoader } from "./js/wasm.js";

export { disk, PATH_COLUMNS, version } from "./js/disk.js";

export const init = loader("small", () => new URL("./dist/tribos.wasm", import.meta.url));
export const initSync = syncLoader("small");
