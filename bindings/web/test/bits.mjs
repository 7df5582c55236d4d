// Digests of results of every function, computed here in JavaScript and by `tests/bits.rs` in Rust from the
// same numbers: a line a chapter. `node test/bits.mjs` prints them.

import { stream } from "./setup.mjs";

const CALLS = 1000;
/** Calls of what takes long. */
const FEW = 50;

/** Numbers of one chapter, and the digest of its results. */
class Chapter {
  constructor(seed) {
    this.next = stream(seed);
    this.hash = [0x811c9dc5, 0x9747b28c];
    this.view = new DataView(new ArrayBuffer(8));
  }

  /** A positive number up to `most`. */
  positive(most) {
    return (1 - this.next()) * most;
  }

  /** A number of either sign; zero at times. */
  signed(most) {
    const value = (2 * this.next() - 1) * most;
    return this.next() < 0.1 ? 0 : value;
  }

  twist() {
    return { vx: this.signed(2), vy: this.signed(2), spin: this.signed(50) };
  }

  push(force, torque) {
    return { fx: this.signed(force), fy: this.signed(force), torque: this.signed(torque) };
  }

  /** Takes results in. */
  add(...values) {
    for (const value of values) {
      // One NaN for all.
      this.view.setFloat64(0, Number.isNaN(value) ? NaN : value, true);
      for (const at of [0, 4]) this.word(this.view.getUint32(at, true));
    }
  }

  word(word) {
    this.hash = this.hash.map((hash, lane) => {
      const mixed = hash ^ word;
      const turned = (mixed << 13) | (mixed >>> 19);
      return Math.imul(turned, lane === 0 ? 0x01000193 : 0x5bd1e995);
    });
  }

  digest() {
    return this.hash.map((hash) => (hash >>> 0).toString(16).padStart(8, "0")).join("");
  }
}

const wrenchOf = ({ fx, fy, torque }) => [fx, fy, torque];
const twistOf = ({ vx, vy, spin }) => [vx, vy, spin];
const stabilities = ["stable", "semistable", "unstable"];

function frictionOf(chapter, friction, count = CALLS) {
  for (let call = 0; call < count; call++) {
    const twist = chapter.twist();
    const load = chapter.positive(10);
    chapter.add(...wrenchOf(friction.wrench(twist, load)), ...friction.jacobian(twist, load));
  }
}

function batchesOf(chapter, friction) {
  const twists = Array.from({ length: CALLS }, () => twistOf(chapter.twist())).flat();
  const loads = Array.from({ length: CALLS }, () => chapter.positive(10));
  chapter.add(...friction.wrenches(twists, 2), ...friction.wrenches(twists, loads));
  chapter.add(...friction.jacobians(twists, 2), ...friction.jacobians(twists, loads));
}

function surfaceOf(chapter, friction, model = "exact", count = CALLS) {
  for (let call = 0; call < count; call++) {
    let surface = friction.limitSurface(chapter.positive(10));
    if (model !== "exact") surface = surface[model]();
    const push = chapter.push(5, 0.2);
    const twist = chapter.twist();
    const nearest = surface.project(push, chapter.positive(0.1));
    chapter.add(surface.gauge(push), ...twistOf(surface.normal(push)));
    chapter.add(...wrenchOf(surface.scaleToSurface(push)), ...wrenchOf(nearest));
    chapter.add(...twistOf(nearest.normal), nearest.slides ? 1 : 0);
    chapter.add(surface.support(twist), ...wrenchOf(surface.wrench(twist)));
    chapter.add(surface.contains(push) ? 1 : 0);
  }
  const surface = friction.limitSurface(2);
  chapter.add(...surface.meridian(33, 0.7));
}

function stepsOf(chapter, friction, model = "exact", muStatic = undefined) {
  const body = friction.body({ mass: 0.5, inertia: 0.003, load: 4, model, muStatic });
  for (let call = 0; call < CALLS; call++) {
    const [twist, push] = [chapter.twist(), chapter.push(3, 0.1)];
    const [dt, angle] = [chapter.positive(0.05), chapter.signed(3)];
    const step = body.step(twist, push, dt, angle);
    chapter.add(...twistOf(step), ...wrenchOf(step), step.isAtRest ? 1 : 0);
    const still = body.step({ vx: 0, vy: 0, spin: 0 }, push, dt, angle);
    chapter.add(...twistOf(still), ...wrenchOf(still), still.isAtRest ? 1 : 0);
  }
  for (let call = 0; call < FEW; call++) {
    const [twist, push] = [chapter.twist(), chapter.push(3, 0.1)];
    const pose = { x: chapter.signed(1), y: chapter.signed(1), angle: chapter.signed(3) };
    chapter.add(...body.rollout(twist, { dt: 0.01, steps: 20, push, pose }));
    chapter.add(...body.rollout(twist, { dt: 0.01, steps: 100 }));
  }
}

function slidesOf(chapter, friction) {
  for (let call = 0; call < FEW; call++) {
    const [mass, inertia] = [chapter.positive(2), chapter.positive(0.01)];
    const body = friction.body({ mass, inertia });
    const twist = chapter.twist();
    const rest = body.slide(twist);
    chapter.add(rest.time, rest.distance, rest.x, rest.y, rest.angle, rest.ratio);
    const later = body.advance(twist, chapter.positive(0.5));
    chapter.add(later.time, later.x, later.y, later.angle, ...twistOf(later));
    chapter.add(later.isAtRest ? 1 : 0, ...body.slidePath(twist, 5));
  }
}

function modesOf(chapter, friction) {
  for (let call = 0; call < CALLS; call++) {
    const made = friction.modes(chapter.positive(1), chapter.positive(3));
    chapter.add(...made.inertiaInterval, made.finalRatio ?? NaN);
    for (const { ratio, stability } of made.fixedPoints) {
      chapter.add(ratio, stabilities.indexOf(stability));
    }
  }
}

/** Chapters of disks, which both modules have. */
export const small = {
  "disk friction": ({ disk }, chapter) => frictionOf(chapter, disk({ radius: 0.04, mu: 0.3 })),
  "disk batches": ({ disk }, chapter) => batchesOf(chapter, disk({ radius: 0.04, mu: 0.3 })),
  "disk surface": ({ disk }, chapter) => surfaceOf(chapter, disk({ radius: 0.04, mu: 0.3 })),
  "disk steps": ({ disk }, chapter) => stepsOf(chapter, disk({ radius: 0.04, mu: 0.3 })),
  "disk slides": ({ disk }, chapter) => slidesOf(chapter, disk({ radius: 0.04, mu: 0.3 })),
  "disk modes": ({ disk }, chapter) => modesOf(chapter, disk({ radius: 0.04, mu: 0.3 })),
};

const notch = [0, 0, 0.4, 0, 0.4, 0.3, 0.2, 0.1, 0, 0.3];
const hole = [0.05, 0.02, 0.1, 0.02, 0.1, 0.05, 0.05, 0.05];
const oil = "stribeck:mu_s=0.4,mu_d=0.2,vs=0.05";

/** The others. */
export const others = {
  "disk of a power": ({ disk }, chapter) => {
    const friction = disk({ radius: 0.04, mu: 0.3, alpha: 0.5 });
    frictionOf(chapter, friction);
    batchesOf(chapter, friction);
    slidesOf(chapter, friction);
    modesOf(chapter, friction);
  },
  "disk of stribeck": ({ disk }, chapter) =>
    frictionOf(chapter, disk({ radius: 0.04, law: oil }), FEW),
  "disk approximations": ({ disk }, chapter) => {
    const friction = disk({ radius: 0.04, mu: 0.3 });
    surfaceOf(chapter, friction, "ellipsoid");
    surfaceOf(chapter, friction, "separate");
    stepsOf(chapter, friction, "ellipsoid");
    stepsOf(chapter, friction, "separate");
  },
  "round patches": ({ ring, annulus, hertz, punch, paraboloid, power, polynomial }, chapter) => {
    const [radius, mu] = [0.04, 0.3];
    const all = [
      ring({ radius, mu }),
      annulus({ radius, inner: 0.03, mu }),
      hertz({ radius, mu }),
      punch({ radius, mu }),
      paraboloid({ radius, mu }),
      power({ radius, order: 0.25, mu }),
      polynomial({ radius, coefficients: [1, -0.5], mu }),
    ];
    for (const friction of all) {
      frictionOf(chapter, friction);
      surfaceOf(chapter, friction, "exact", FEW);
      slidesOf(chapter, friction);
      modesOf(chapter, friction);
    }
  },
  polygon: ({ polygon }, chapter) => {
    const friction = polygon({ corners: notch, holes: [hole], mu: 0.5 });
    chapter.add(friction.radius, ...friction.centre);
    frictionOf(chapter, friction);
    surfaceOf(chapter, friction, "exact", FEW);
    stepsOf(chapter, friction);
    stepsOf(chapter, friction, "exact", 0.8);
    const body = friction.body({ mass: 2, inertia: 0.05 });
    for (let call = 0; call < 5; call++) chapter.add(...body.slidePath(chapter.twist(), 50));
  },
  "other straight edges": ({ box, bar, mesh, polygon, points }, chapter) => {
    frictionOf(chapter, polygon({ corners: notch, mu: 0.5, alpha: 0.5 }));
    const feet = [0, 0, 1, 0.1, 0, 1, 0, 0.1, 2];
    const tile = [0, 0, 1, 0.1, 0, 2, 0.1, 0.1, 0.5, 0, 0.1, 0];
    const all = [
      box({ a: 0.3, b: 0.2, centre: [0.02, 0], mu: 0.5 }),
      bar({ length: 0.2, mu: 0.5 }),
      points({ points: feet, mu: 0.5 }),
      mesh({ vertices: tile, triangles: [[0, 1, 2], [0, 2, 3]], mu: 0.5 }),
    ];
    for (const friction of all) {
      frictionOf(chapter, friction);
      surfaceOf(chapter, friction, "exact", FEW);
    }
    frictionOf(chapter, points({ points: feet, law: oil }));
  },
  floors: ({ bolts, box, disk, ellipse, feet, hertzEllipse, polygon, wornAnnulus }, chapter) => {
    const tread = { mu: [0.5, 0.9], axis: 0.3 };
    const round = disk({ radius: 0.04, mu: 0.3 });
    const all = [
      ellipse({ a: 0.3, b: 0.2, mu: 0.5 }),
      hertzEllipse({ a: 0.2, b: 0.3, mu: 0.5 }),
      bolts({ count: 5, radius: 0.1, mu: 0.5 }),
      disk({ radius: 0.1, ...tread }),
      hertzEllipse({ a: 0.3, b: 0.2, ...tread }),
      polygon({ corners: notch, ...tread }),
      wornAnnulus({ inner: 0.03, radius: 0.04, mu: 0.3 }),
    ];
    for (const friction of all) {
      chapter.add(friction.mu, friction.radius, ...friction.centre);
      frictionOf(chapter, friction, FEW);
      surfaceOf(chapter, friction, "exact", FEW);
    }
    const floorOf = (floor) => {
      chapter.add(floor.forceLimit, floor.count);
      for (let call = 0; call < FEW; call++) {
        const twist = chapter.twist();
        chapter.add(...wrenchOf(floor.wrench(twist)), ...floor.jacobian(twist));
        const { friction, carriedBy, evaluations, ...steady } = floor.steadyMotion(chapter.push(0.5, 0.05));
        chapter.add(...twistOf(steady.twist), ...wrenchOf(friction), carriedBy ?? -1, evaluations);
        const body = { mass: chapter.positive(2), inertia: chapter.positive(0.01) };
        const [from, push] = [chapter.twist(), chapter.push(9, 0.5)];
        const end = floor.step(body, from, push, chapter.positive(0.05));
        chapter.add(...twistOf(end.twist), ...wrenchOf(end.friction), end.carriedBy ?? -1, end.imbalance);
        const surface = floor.limitSurface();
        const nearest = surface.project(push, chapter.positive(0.1));
        chapter.add(surface.gauge(push), ...twistOf(surface.normal(push)), ...wrenchOf(nearest));
      }
    };
    const plate = [0.1, 0.05, 0.3, 0.05, 0.3, 0.2, 0.1, 0.2];
    const surfaces = () => [
      { corners: [0, 0.15, 0.4, 0.12], twist: chapter.twist() },
      { corners: plate, twist: chapter.twist() },
      { corners: [0.2, 0, 0.2, 0.1] },
    ];
    for (const friction of [polygon({ corners: notch, holes: [hole], mu: 0.5 }), all[5], round]) {
      for (let call = 0; call < 5; call++) floorOf(friction.onSurfaces(20, surfaces()));
    }
    for (let call = 0; call < 10; call++) {
      const foot = (friction) => ({
        friction,
        load: chapter.positive(9),
        place: [chapter.signed(1), chapter.signed(1)],
        degrees: chapter.signed(180),
        surface: chapter.twist(),
      });
      floorOf(feet([round, all[0], all[5], all[6], box({ a: 0.3, b: 0.2, mu: 0.4 })].map(foot)));
    }
  },
  law: ({ law }, chapter) => {
    const made = law(oil);
    const speeds = Array.from({ length: CALLS }, () => chapter.signed(1));
    for (const speed of speeds) chapter.add(made.friction(speed), made.slope(speed));
    chapter.add(...made.frictions(speeds));
  },
  launches: ({ disk, ring }, chapter) => {
    for (const friction of [disk({ radius: 0.08, mu: 0.3 }), ring({ radius: 0.08, mu: 0.3 })]) {
      const body = friction.body({ mass: 0.5, inertia: 0.0016 });
      for (let call = 0; call < 10; call++) {
        const [x, y, angle] = [chapter.positive(1), chapter.signed(1), chapter.signed(3)];
        const turns = call % 2 === 0 ? "modulo" : "exact";
        const limits = { maxSpeed: 10, maxSpin: 200, most: 20 };
        for (const one of body.launches({ x, y, angle, turns, ...limits })) {
          chapter.add(...twistOf(one), one.speed, one.direction, one.angle, one.time);
          chapter.add(one.energyPerMass);
        }
      }
    }
  },
  "any pressure": ({ anyPressure }, chapter) => {
    const corners = [-0.1, -0.05, 0.2, -0.05, 0.2, 0.1, -0.1, 0.05];
    const support = anyPressure({ corners, centre: [0.03, 0.01], forceLimit: 5 });
    chapter.add(support.radius);
    for (let call = 0; call < CALLS; call++) {
      const twist = chapter.twist();
      chapter.add(support.support(twist), ...wrenchOf(support.wrench(twist)));
    }
    for (let call = 0; call < FEW; call++) {
      const limits = support.torqueLimits(chapter.signed(6), chapter.signed(6));
      chapter.add(...(limits?.carried ?? [NaN, NaN]), ...(limits?.outer ?? [NaN, NaN]));
      chapter.add(...support.gaugeBounds(chapter.push(6, 0.5)));
    }
  },
  contacts: ({ contactLaw }, chapter) => {
    const laws = [
      contactLaw({ mu: 0.3, muRolling: 0.01, muTorsion: 0.02, restitution: 0.5 }),
      contactLaw({ mu: 0.3, patch: { kind: "disk", radius: 0.1 }, cohesion: 0.1 }),
      contactLaw({ mu: 0.3, patch: { kind: "annulus", radius: 0.1, inner: 0.05 } }),
      contactLaw({ mu: 0.3, patch: { kind: "polynomial", radius: 0.1, coefficients: [1, -0.5] } }),
    ];
    const three = (most) => [chapter.signed(most), chapter.signed(most), chapter.signed(most)];
    for (const contact of laws) {
      for (let call = 0; call < CALLS; call++) {
        const sphere = () => ({
          velocity: three(2),
          spin: three(50),
          mass: chapter.positive(1),
          radius: 0.01 + chapter.positive(0.1),
        });
        const first = sphere();
        const second = call % 2 === 0 ? sphere() : { velocity: three(1) };
        const gap = chapter.signed(1e-3);
        const hit = contact.collide(first, second, { normal: [0.6, 0, -0.8], gap, dt: 1e-3 });
        chapter.add(...hit.first.velocity, ...hit.first.spin, ...hit.second.velocity);
        chapter.add(...hit.second.spin, ...hit.sliding, ...hit.rolling, hit.normal, hit.torsion);
      }
    }
  },
};

/** Lines of chapters: digest and name. */
export function digests(tribos, chapters) {
  return Object.entries(chapters).map(([name, run], index) => {
    const seed = chapters === small ? index : Object.keys(small).length + index;
    const chapter = new Chapter(seed + 1);
    run(tribos, chapter);
    return `${chapter.digest()} ${name}`;
  });
}

if (process.argv[1]?.endsWith("bits.mjs")) {
  const tribos = await import("../all.js");
  await tribos.init();
  console.log([...digests(tribos, small), ...digests(tribos, others)].join("\n"));
}
