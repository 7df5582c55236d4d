// What is published.

import assert from "node:assert/strict";
import { execFileSync, spawnSync } from "node:child_process";
import { existsSync, mkdtempSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { test } from "node:test";
import { fileURLToPath } from "node:url";
import { gzipSync } from "node:zlib";
import { file, text } from "./setup.mjs";

const here = fileURLToPath(file(""));
const installed = (name) => existsSync(file(`node_modules/${name}/package.json`));

test("the package has what is needed and nothing else", (context) => {
  const npm = spawnSync("npm", ["pack", "--dry-run", "--json", "--offline"], { cwd: here, encoding: "utf8" });
  if (npm.error) return context.skip("npm is not installed");
  assert.equal(npm.status, 0, npm.stderr);
  const [{ files }] = JSON.parse(npm.stdout);
  const paths = files.map(({ path }) => path).sort();
  const scripts = "any-pressure body checks contact disk everything floor friction law patches surface version wasm";
  assert.deepEqual(paths, [
    ...["LICENSE-APACHE", "LICENSE-MIT", "README.md"],
    ...["all-inline.js", "all.d.ts", "all.js"],
    ...["all.inline.js", "all.wasm", "tribos.inline.js", "tribos.wasm"].map((name) => `dist/${name}`),
    ...["index.d.ts", "index.js", "inline.js"],
    ...scripts.split(" ").map((name) => `js/${name}.js`),
    "package.json",
  ].sort());
});

test("disks take at most 60 kB, packed with their scripts", () => {
  const scripts = ["wasm", "checks", "surface", "body", "friction", "disk", "version"];
  const paths = ["index.js", ...scripts.map((name) => `js/${name}.js`)];
  const packed = (bytes) => gzipSync(bytes, { level: 9 }).length;
  const together = Buffer.concat(paths.map((path) => readFileSync(file(path))));
  const size = packed(readFileSync(file("dist/tribos.wasm"))) + packed(together);
  assert.ok(size <= 60_000, `${size} bytes`);
});

test("version and licences are those of the repository", () => {
  const { version, license } = JSON.parse(text("package.json"));
  const workspace = text("../../Cargo.toml");
  assert.match(workspace, new RegExp(`^version = "${version}"`, "m"));
  assert.match(workspace, new RegExp(`^license = "${license}"`, "m"));
  assert.match(text("js/version.js"), new RegExp(`"${version}"`));
  for (const name of ["LICENSE-APACHE", "LICENSE-MIT"]) assert.equal(text(name), text(`../../${name}`));
});

test("entries with the module inside need no file", () => {
  const run = (code) =>
    execFileSync(process.execPath, ["--input-type=module", "-e", code], { cwd: here, encoding: "utf8" });
  const call = "console.log(disk({ radius: 0.04, mu: 0.3 }).limitSurface(10).torqueLimit)";
  const small = `import { init, disk } from "./inline.js"; await init(); ${call}`;
  assert.ok(Math.abs(Number(run(small)) - 0.08) < 1e-15);
  const all = `import { initSync, ring } from "./all-inline.js"; initSync(); const disk = ring; ${call}`;
  assert.ok(Math.abs(Number(run(all)) - 0.12) < 1e-15);
});

test("examples run", () => {
  const run = (name) => execFileSync(process.execPath, [join(here, "examples", name)], { encoding: "utf8" });
  assert.match(run("throw.mjs"), /slides 0\.1699 m without spin, 0\.\d+ m with it/);
  assert.match(run("batch.mjs"), /ns a wrench/);
});

test("examples of the pages run", () => {
  const pages = [text("README.md"), text("../../docs/web.md")].join("\n");
  const blocks = [...pages.matchAll(/^```js\n(.*?)^```/gms)];
  assert.equal(blocks.length, 4);
  for (const [, code] of blocks) {
    // By its own name the package is found from its folder.
    execFileSync(process.execPath, ["--input-type=module", "-e", code], { cwd: here });
  }
});

test("types are those of the scripts", (context) => {
  if (!installed("typescript")) return context.skip("npm ci installs typescript");
  const compiler = fileURLToPath(file("node_modules/typescript/bin/tsc"));
  const { status, stdout } = spawnSync(process.execPath, [compiler, "--project", "test"], { cwd: here, encoding: "utf8" });
  assert.equal(status, 0, stdout);
});

test("every export has a type, and every type is used by the test of types", async () => {
  const types = text("test/types.ts");
  for (const entry of ["index", "all"]) {
    const exported = Object.keys(await import(`../${entry}.js`));
    const declared = text(`${entry}.d.ts`);
    for (const name of exported) {
      assert.match(declared, new RegExp(`\\b${name}\\b`), name);
      assert.match(types, new RegExp(`\\b${name}\\b`), name);
    }
    const named = declared.matchAll(/^export (?:type|interface) (\w+)/gm);
    for (const [, name] of named) assert.match(types, new RegExp(`\\b${name}\\b`), name);
  }
});

test("a bundler makes one file of it", (context) => {
  if (!installed("esbuild")) return context.skip("npm ci installs esbuild");
  const folder = mkdtempSync(join(tmpdir(), "tribos-"));
  try {
    const bundle = join(folder, "bundle.mjs");
    const script = join(here, "examples", "bundle", "build.mjs");
    execFileSync(process.execPath, [script, bundle], { cwd: here });
    assert.match(execFileSync(process.execPath, [bundle], { cwd: folder, encoding: "utf8" }), /0\.0136 N m/);
  } finally {
    rmSync(folder, { recursive: true });
  }
});
