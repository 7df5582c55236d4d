// What the build needs besides Node, and how to install it.

import { spawnSync } from "node:child_process";
import { existsSync } from "node:fs";

const TARGET = "wasm32-unknown-unknown";

/** What is missing to build the WebAssembly in a folder, and how to install it; undefined if nothing is. */
export function missingTool(folder) {
  const run = (program, ...args) => spawnSync(program, args, { cwd: folder, encoding: "utf8" });
  const cargo = run("cargo", "--version");
  if (cargo.error || cargo.status !== 0) {
    return `cargo does not start (${reasonOf(cargo)}). Install Rust: https://rustup.rs`;
  }
  const compiler = process.env.RUSTC || "rustc";
  const library = run(compiler, "--print", "target-libdir", "--target", TARGET);
  if (library.error || library.status !== 0) {
    return `${compiler} does not start (${reasonOf(library)}). Install Rust: https://rustup.rs`;
  }
  if (!existsSync(library.stdout.trim())) {
    return [
      `${compiler} has no standard library for the target ${TARGET}. Install it:`,
      `    rustup target add ${TARGET}`,
      `A Rust without rustup has it in a package of its own, on Debian libstd-rust-dev-wasm32.`,
    ].join("\n");
  }
  return undefined;
}

const reasonOf = ({ error, stderr, status }) => error?.message ?? (stderr.trim() || `exit status ${status}`);
