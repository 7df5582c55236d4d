// What the entries for disks have besides loading.

import { fields, number } from "./checks.js";
import { Friction, plainDisk } from "./friction.js";

export { PATH_COLUMNS } from "./body.js";
export { version } from "./version.js";

export function disk(options) {
  const { radius, mu } = fields("the disk", options);
  return plainDisk(Friction, number("radius", radius), number("mu", mu));
}
