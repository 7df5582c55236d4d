// What the entries for everything have besides loading.

export { anyPressure } from "./any-pressure.js";
export { PATH_COLUMNS } from "./body.js";
export { contactLaw } from "./contact.js";
export { feet } from "./floor.js";
export { law, laws } from "./law.js";
export * from "./patches.js";
export { version } from "./version.js";
