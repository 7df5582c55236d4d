// A program with the module inside, for bundlers that do not know WebAssembly.

import { initSync, disk } from "tribos/inline";

initSync();
const surface = disk({ radius: 0.04, mu: 0.3 }).limitSurface(1.7); // m; N
console.log(`it resists spinning by ${surface.torqueLimit.toFixed(4)} N m`);
