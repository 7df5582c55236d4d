// Disks under Coulomb friction, with the module inside.

import { bytes } from "./dist/tribos.inline.js";
import { loader, syncLoader } from "./js/wasm.js";

export { disk, PATH_COLUMNS, version } from "./js/disk.js";

export const init = loader("small", bytes);
export const initSync = syncLoader("small", bytes);
