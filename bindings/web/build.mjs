// Builds the package: `node bindings/web/build.mjs [--quick]`. Needs cargo with the target wasm32-unknown-unknown.
// With `--quick` the larger module is not optimised as one piece: the same bits, in a third of the time, for tests.
//
// One crate is built twice. The small module has disks under Coulomb friction, no standard library and no
// heap; the other has everything, the small one's functions included, so that one memory and one set of
// objects serve a program, whichever entry it imports. Two crates would share less: a page that uses both
// would hold two memories, and every object would have to know its own.
//
// The kernel is optimised for time: for size (opt-level "s") the small module is 2 kB smaller, the other one
// 16 kB of 391; wrenches, projections and steps take 1.3 to 3 times as long, and batches of the other one five
// times. The library around the kernel is optimised for size. Vectors
// of 128 bits, which every browser has since 2023, cost 5 kB in the small module and make a batch three times as
// quick: 17 ns a wrench instead of 54. `wasm-opt` is not needed.

import { spawnSync } from "node:child_process";
import { copyFileSync, mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { gzipSync } from "node:zlib";
import { missingTool } from "./toolchain.mjs";

const here = fileURLToPath(new URL(".", import.meta.url));
const root = join(here, "..", "..");
const target = process.env.CARGO_TARGET_DIR ?? join(root, "target");
const quick = process.argv.includes("--quick");
const MODULES = [
  { name: "tribos", features: ["--no-default-features"], whole: true },
  { name: "all", features: [], whole: !quick },
];

// What is built around the kernel.
const LIBRARY = ["tribos-base", "tribos-friction", "tribos-motion", "serde_json"];

const missing = missingTool(root);
if (missing !== undefined) stop(missing);

const dist = join(here, "dist");
mkdirSync(dist, { recursive: true });
for (const { name, features, whole } of MODULES) {
  // A folder each, so that a second run has nothing to do.
  const folder = join(target, "web", whole ? name : `${name}-quick`);
  const settings = [
    ...["opt-level=2", 'panic="abort"', "strip=true", "codegen-units=1"],
    ...(whole ? ['lto="fat"'] : []),
    ...LIBRARY.map((name) => `package.${name}.opt-level="s"`),
  ];
  const cargo = [
    ["build", "--release", "--package", "tribos-web", "--lib"],
    ["--target", "wasm32-unknown-unknown", "--target-dir", folder],
    features,
    settings.flatMap((setting) => ["--config", `profile.release.${setting}`]),
  ].flat();
  // The environment must not change the result.
  const { RUSTFLAGS: _, CARGO_ENCODED_RUSTFLAGS: __, ...env } = process.env;
  env.CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_RUSTFLAGS = "-Ctarget-feature=+simd128";
  const { status } = spawnSync("cargo", cargo, { cwd: root, stdio: "inherit", env });
  if (status !== 0) stop(`dist/${name}.wasm is not built: cargo failed, its messages are above`);
  const built = join(folder, "wasm32-unknown-unknown", "release", "tribos_web.wasm");
  copyFileSync(built, join(dist, `${name}.wasm`));
  const bytes = readFileSync(built);
  writeFileSync(join(dist, `${name}.inline.js`), inline(bytes));
  report(`dist/${name}.wasm`, bytes);
}
for (const [entry, files] of Object.entries(scripts())) {
  report(entry, Buffer.concat(files.map((file) => readFileSync(join(here, file)))));
}

/** A module that has the bytes inside. */
function inline(bytes) {
  return `// Made by build.mjs.
const text = "${bytes.toString("base64")}";
export const bytes = () => Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
`;
}

/** The scripts that an entry loads. */
function scripts() {
  const small = ["wasm", "checks", "surface", "body", "friction", "disk", "version"];
  const others = ["law", "patches", "floor", "any-pressure", "contact", "everything"];
  const paths = (names) => names.map((name) => join("js", `${name}.js`));
  return {
    "scripts of tribos": ["index.js", ...paths(small)],
    "scripts of tribos/all": ["all.js", ...paths(small), ...paths(others)],
  };
}

function report(what, bytes) {
  const size = (count) => `${(count / 1000).toFixed(1)} kB`.padStart(10);
  const packed = gzipSync(bytes, { level: 9 }).length;
  console.log(`${what.padEnd(24)}${size(bytes.length)}${size(packed)} gzipped`);
}

function stop(reason) {
  console.error(reason);
  process.exit(1);
}
