// Makes curling.json and powder.json: `node bindings/web/playground/data/make.mjs`, with `tribos` on the PATH.
// Each file holds the commands that made its numbers. Takes a minute.

import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, readdirSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";

const MODELS = ["dry", "left-right", "front-back", "back-heavy", "film", "pivot-slide", "scratch-guide"];
const SPINS = "0.25:3:0.25";
const CORNERS = [
  [0, 0],
  [0, 1],
  [1, 0],
  [1, 1],
];
/** Steps of a coordinate per radius. */
const FINE = 25;
const FRAMES = 40;

const folder = mkdtempSync(join(tmpdir(), "tribos-playground-"));
try {
  save("curling.json", curling());
  save("powder.json", powder());
} finally {
  rmSync(folder, { recursive: true });
}

function save(name, data) {
  writeFileSync(new URL(name, import.meta.url), `${JSON.stringify(data)}\n`);
}

/** Runs a command, as a reader would type it, in the folder. */
function run(command) {
  console.log(command);
  const [program, ...words] = command.split(" ");
  execFileSync(program, words, { cwd: folder, stdio: ["ignore", "ignore", "inherit"] });
}

/** Curl and spin of a draw under each model: rounded to 0.01 mm, since the page rounds to 1 mm again. */
function curling() {
  const command = `tribos sweep curling-draw --set model=${MODELS} --set spin=${SPINS} --out out/curling`;
  run(command);
  const [head, ...lines] = readFileSync(join(folder, "out/curling/runs.csv"), "utf8").trim().split("\n");
  const names = head.split(",");
  const rows = lines.map((line) =>
    Object.fromEntries(line.split(",").map((value, at) => [names[at], value])),
  );
  const curves = MODELS.map((model) => {
    const points = rows.filter((row) => row.model === model);
    return { model, points: points.map(({ spin, curl }) => [Number(spin), Number(Number(curl).toFixed(5))]) };
  });
  return { command, curves };
}

/** Positions in the kept frames of the four corners, each as the change since the frame before. */
function powder() {
  const corners = CORNERS.map(([rolling, torsion]) => {
    const out = `out/powder-${rolling}${torsion}`;
    const command = `tribos run compaction-small --set mu_rolling=${rolling} --set mu_torsion=${torsion} --frames ${FRAMES} --out ${out}`;
    run(command);
    const frames = join(folder, out, "frames");
    const names = readdirSync(frames)
      .filter((name) => name.endsWith(".frame"))
      .sort();
    return { rolling, torsion, command, frames: changes(names.map((name) => frameOf(join(frames, name)))) };
  });
  return { fine: FINE, corners };
}

/** A frame file, as docs/formats.md describes it. */
function frameOf(path) {
  const bytes = readFileSync(path);
  const version = bytes.readUInt32LE(4);
  if (version !== 3) throw new Error(`${path} has version ${version}, and 3 is read`);
  const count = bytes.readUInt32LE(48);
  const corner = (at) => [0, 4, 8].map((offset) => bytes.readFloatLE(at + offset));
  const [low, high] = [corner(56), corner(68)];
  const places = Array.from({ length: 3 * count }, (_, index) => {
    const [axis, part] = [index % 3, bytes.readUInt16LE(80 + 2 * index) / 65535];
    return Math.round(FINE * (low[axis] + part * (high[axis] - low[axis])));
  });
  const [time, height, porosity] = [16, 24, 32].map((at) => Number(bytes.readDoubleLE(at).toPrecision(6)));
  return { time, height, porosity, places };
}

function changes(frames) {
  return frames.map((frame, index) => {
    const before = frames[index - 1]?.places;
    return { ...frame, places: frame.places.map((place, at) => place - (before?.[at] ?? 0)) };
  });
}
