// The command and the Python program that compute the numbers of a panel from its settings.

import { HOLES, inertiaOf, isRound, outline } from "./bodies.js";

/** Digits of the numbers in them: more than the page shows. */
const DIGITS = 7;
/** Pressures under a puck that the scene of a cylinder names otherwise. */
const PRESSURES = { punch: "flat-punch" };
/** Less is a rounding error of a place that is zero. */
const NOTHING = 1e-12;
const CORNERS = "0,1";

const short = (value) => String(Math.abs(value) < NOTHING ? 0 : Number(value.toPrecision(DIGITS)));
const lines = (...given) => given.join("\n");
const sets = (settings) =>
  Object.entries(settings)
    .map(([key, value]) => ` --set ${key}=${value}`)
    .join("");
const printed = (rows) => `printf '%s\\n' ${rows.join(" ")}`;
const keywords = (settings) =>
  Object.entries(settings)
    .map(([key, value]) => `${key}=${value}`)
    .join(", ");

/** The patch of a body as the command and Python name it, and what makes the file that the command reads. */
function patchOf(body) {
  const { shape, pressure } = body;
  const radius = short(body.radius);
  const corners = outline(body);
  if (shape === "box") {
    const [a, b] = corners[2].map((half) => short(2 * half));
    return { name: `box:${a}x${b}`, python: `tribos.box(${a}, ${b})`, file: "", rows: null };
  }
  if (corners !== null) {
    const rows = corners.map((corner) => corner.map(short).join(","));
    const file = `${printed(["x,y", ...rows])} > outline.csv\n`;
    const python = `tribos.polygon([(${rows.join("), (")})])`;
    return { name: "polygon:outline.csv", python, file, rows };
  }
  if (shape === "annulus") {
    const inner = short(HOLES.annulus * body.radius);
    return { name: `annulus:${HOLES.annulus}`, python: `tribos.annulus(${inner}, ${radius})`, file: "" };
  }
  const name = shape === "ring" ? shape : pressure === "uniform" ? "disk" : pressure;
  return { name, python: `tribos.${name}(${radius})`, file: "" };
}

/** Friction in Python. */
const frictionOf = ({ python }, mu, alpha) =>
  `friction = tribos.Friction(${python}, mu=${mu}${alpha === 0 ? "" : `, alpha=${short(alpha)}`})`;

/** The exact law's throw of a body until it rests. */
export function throwPrograms(setup) {
  const [speed, spin, mu] = [setup.speed, setup.spin, setup.mu].map(short);
  return isRound(setup) ? roundThrow(setup, { speed, spin }, mu) : plateThrow(setup, { speed, spin }, mu);
}

function roundThrow(setup, motion, mu) {
  const { shape, pressure, alpha, radius, mass } = setup;
  const settings = { ...motion, gamma: mu, radius: short(radius) };
  if (alpha !== 0) settings.alpha = short(alpha);
  const hole = HOLES[shape];
  let scene = "disk";
  if (hole !== undefined) {
    scene = "pipe-a";
    Object.assign(settings, { inner_radius: short(hole * radius), height: 0 });
  } else if (pressure !== "uniform") {
    scene = "cylinder";
    Object.assign(settings, { pressure: PRESSURES[pressure] ?? pressure, height: 0 });
  }
  const ratio = short(inertiaOf(setup) / (mass * radius * radius));
  return {
    shell: `tribos run ${scene} --out out/throw${sets(settings)}`,
    python: lines(
      "import tribos",
      frictionOf(patchOf(setup), mu, alpha),
      `rest = tribos.slide(friction, ${motion.speed}, ${motion.spin}, inertia_ratio=${ratio})`,
      "print(rest.distance, rest.time, rest.angle)",
    ),
  };
}

function plateThrow(setup, { speed, spin }, mu) {
  const { name, file, rows } = patchOf(setup);
  const settings = { speed, spin, orientation: short(-setup.direction), mu };
  const written = [
    "from pathlib import Path",
    "import tribos",
    `rows = ["${["x,y", ...(rows ?? [])].join('", "')}"]`,
    'Path("outline.csv").write_text("\\n".join(rows))',
  ];
  return {
    shell: `${file}tribos run plate --out out/throw${sets({ patch: name, ...settings })}`,
    python: lines(
      ...(rows ? written : ["import tribos"]),
      `plate = tribos.scene("plate", patch="${name}", ${keywords(settings)})`,
      "rest = tribos.run(plate).summary",
      'print(rest["path_length"], rest["stop_time"], rest["angle"])',
    ),
  };
}

/** The motion under a push on the limit surface of a body of radius 1, under the load 1. */
export function surfacePrograms(body, push) {
  const patch = patchOf(body);
  const numbers = [push.fx, push.fy, push.torque].map(short);
  const pushes = printed(["force_x,force_y,torque", numbers]);
  return {
    shell: `${patch.file}${pushes} | tribos surface --patch ${patch.name} --pushes -`,
    python: lines(
      "import numpy as np",
      "import tribos",
      frictionOf(patch, 1, 0),
      "surface = friction.limit_surface(load=1)",
      `push = [${numbers.join(", ")}]`,
      "fx, fy, torque = surface.scale_to_surface(push)",
      "vx, vy, spin = surface.normal(push)",
      "speed = np.hypot(vx, vy)",
      "print(np.hypot(fx, fy), torque, spin / speed, speed / abs(spin))",
    ),
  };
}

/** The final motion of a body of radius 1. */
export function modesPrograms({ pressure, inertia, alpha }) {
  const ratio = short(inertia);
  return {
    shell: `tribos modes --alpha ${short(alpha)} --inertia-ratio ${ratio} --patch ${pressure} --diagram diagram.svg`,
    python: lines(
      "import tribos",
      frictionOf({ python: `tribos.${pressure}(1)` }, 1, alpha),
      `last = tribos.modes(friction, ${ratio})`,
      "print(last.final_mode, last.final_ratio, last.inertia_interval)",
    ),
  };
}

/** Curl of some models at some spins. */
export function curlingPrograms(models, spins) {
  return {
    shell: `tribos sweep curling-draw --out out/curling${sets({ model: models, spin: spins })}`,
    python: sweptIn("curling-draw", {
      keys: { model: `"${models.join('", "')}"`, spin: spins.join(", ") },
      columns: ["model", "spin", "curl"],
    }),
  };
}

/** Porosities of the four powders after a time, or at the end. */
export function powderPrograms(time) {
  const duration = time === undefined ? {} : { duration: short(time) };
  const keys = { mu_rolling: CORNERS, mu_torsion: CORNERS, ...duration };
  return {
    shell: `tribos sweep compaction-small --out out/powder${sets(keys)}`,
    python: sweptIn("compaction-small", { keys, columns: ["mu_rolling", "mu_torsion", "porosity_final"] }),
  };
}

/** A sweep in Python that prints some columns. */
function sweptIn(scene, { keys, columns }) {
  const given = Object.entries(keys).map(([key, values]) => `"${key}": [${values}]`);
  return lines(
    "import tribos",
    `for row in tribos.sweep("${scene}", {${given.join(", ")}}):`,
    `    print(${columns.map((column) => `row["${column}"]`).join(", ")})`,
  );
}
