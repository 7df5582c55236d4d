// Every export with its types: compiled, not run.

import * as small from "tribos";
import * as inline from "tribos/inline";
import * as all from "tribos/all";
import * as allInline from "tribos/all/inline";
import type {
  Body, BodyOptions, DiskOptions, FixedPoint, Friction, LimitSurface, Model, Modes, Motion, Pose, Projection,
  Rest, RolloutOptions, Rows, Source, Step, Twist, Wrench,
} from "tribos";
import type {
  AnyFriction, AnyPressure, Collision, ContactLaw, ContactOptions, Floor, FloorStep, Foot, Launch, LaunchOptions, Law, LawEntry,
  LawOptions, Plate, PolygonOptions, RoundBody, RoundFriction, RoundOptions, Sphere, SteadyMotion, Surface, Vector,
} from "tribos/all";

const source: Source = new URL("https://example.org/tribos.wasm");
await small.init(source);
await inline.init();
await all.init(fetch("all.wasm"));
allInline.initSync();
small.initSync(new Uint8Array(8));

const options: DiskOptions = { radius: 0.04, mu: 0.3 };
const puck: Friction = small.disk(options);
const twist: Twist = { vx: 1, vy: 0, spin: 20 };
const wrench: Wrench = puck.wrench(twist, 1.7);
const jacobian: Float64Array = puck.jacobian(twist, 1.7);
const rows: Rows = [1, 0, 20];
const batch: Float64Array = puck.wrenches(rows, jacobian, new Float64Array(3));
puck.jacobians(batch, 1);
const model: Model = "exact";
const surface: LimitSurface = puck.limitSurface(1);
const nearest: Projection = surface.project(wrench, 0.02);
const normal: Twist = nearest.slides ? nearest.normal : surface.normal(wrench);
const bounds: number = surface.gauge(surface.scaleToSurface(wrench)) + surface.support(normal);
surface.contains(surface.wrench(twist));
surface.meridian(9, bounds).set(surface.gauges(surface.wrenches(rows)));
surface.ellipsoid().separate();
const given: BodyOptions = { mass: 1, inertia: 1, load: 2, gravity: 9.81, model, muStatic: 0.4 };
const body: Body = puck.body(given);
const step: Step = body.step(twist, null, 0.01, 0.1);
const pose: Pose = { x: 0, y: 0, angle: 0 };
const rollout: RolloutOptions = { dt: 0.01, steps: 5, push: wrench, pose };
const motion: Motion = body.advance(step, 1);
const rest: Rest = body.slide(motion);
body.rollout(body.friction.wrench(twist, 1) && twist, rollout).set(body.slidePath(twist, 5));
const column: "angle" = small.PATH_COLUMNS[3];
const modes: Modes = puck.modes(0.5, 1);
const points: readonly FixedPoint[] = modes.fixedPoints;
puck[Symbol.dispose]();
const version: string = small.version;
console.log(rest.ratio, column, points, version);

const round: RoundOptions = { radius: 0.1, mu: 0.3, alpha: 0.5 };
const line: LawOptions = { law: "dry:mu_s=0.4,mu_d=0.3" };
const law: Law = all.law("stribeck", { mu_s: 0.4, mu_d: 0.2, vs: 0.05 });
law.frictions([law.friction(1), law.slope(1)]);
const entries: LawEntry[] = all.laws();
const ring: RoundFriction = all.ring(round);
for (const friction of [
  all.disk({ radius: 0.1, ...line }), all.annulus({ ...round, inner: 0.05 }), all.hertz(round), all.punch(round),
  all.paraboloid(round), all.power({ ...round, order: 0.25 }),
  all.polynomial({ ...round, coefficients: [1, -0.5] }),
]) {
  friction.free();
}
const outline: PolygonOptions = { corners: [[0, 0], [1, 0], [0, 1]], holes: [rows], centre: [0.3, 0.3], mu: 1 };
for (const friction of [all.polygon(outline), all.box({ a: 1, b: 2, mu: 1 }), all.bar({ length: 1, mu: 1 }), all.wornAnnulus({ ...options, inner: 0.01 })]) {
  friction.limitSurface(1);
}
all.points({ points: [[0, 0, 1], [1, 0, 1]], law });
all.mesh({ vertices: [[0, 0, 1], [1, 0, 1], [0, 1, 2]], triangles: [[0, 1, 2]], mu: 1 });
const belt: Surface = { corners: [[0, 0], [1, 0]], twist };
const tread: AnyFriction = all.ellipse({ a: 1, b: 2, mu: [0.5, 0.9], axis: 0.1 });
tread.wrench(twist, 1, { surface: [belt] });
const steady: SteadyMotion = tread.steadyMotion(1, [belt, { corners: rows }], wrench);
const floor: Floor = all.hertzEllipse({ a: 1, b: 2, mu: 1 }).onSurfaces(1, [belt]);
const foot: Foot = { friction: all.bolts({ count: 6, radius: 1, mu: 1 }), load: 1, place: [0, 0], surface: steady.twist };
all.feet([foot, { ...foot, degrees: 30 }]).steadyMotion(floor.wrench(steady.twist)).carriedBy?.toFixed();
const after: FloorStep = floor.step(body, twist, null, 0.01 + body.muStatic);
floor.patch.limitSurface(after.imbalance).gauge(floor.limitSurface().project(after.friction));
const thrown: RoundBody = ring.body(given);
const wanted: LaunchOptions = { ...pose, maxSpeed: 3, maxSpin: 20, turns: "exact", symmetry: 2, most: 3 };
const launches: Launch[] = thrown.launches(wanted);
const support: AnyPressure = all.anyPressure({ corners: rows, centre: [0, 0], forceLimit: 1 });
const carried: readonly [number, number] | undefined = support.torqueLimits(1, 0)?.carried;
const vector: Vector = [0, 0, 1];
const sphere: Sphere = { velocity: vector, spin: vector, mass: 1, radius: 1, inertia: 1 };
const plate: Plate = { velocity: vector, mass: 1 };
const resists: ContactOptions = { mu: 0.3, patch: { kind: "annulus", radius: 0.1, inner: 0.05 } };
const contact: ContactLaw = all.contactLaw(resists);
const hit: Collision = contact.collide(sphere, plate, { normal: vector, gap: 0, dt: 1e-3 });
contact.collide(sphere, sphere, { normal: hit.second.velocity });
console.log(entries, launches, carried, hit.torsion, all.version, all.PATH_COLUMNS, allInline.disk, inline.disk);

// What must not compile.
// @ts-expect-error a disk needs a radius
small.disk({ mu: 0.3 });
// @ts-expect-error polygons slide, but no launch is known for them
all.polygon(outline).body(given).launches(wanted);
// @ts-expect-error a foot stands somewhere
all.feet([{ friction: puck, load: 1 }]);
