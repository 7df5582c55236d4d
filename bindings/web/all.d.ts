/**
 * Everything of `tribos`, and all other patches, laws, launches and contacts.
 *
 * ```js
 * import { init, polygon } from "tribos/all";
 * await init();
 * const crate = polygon({ corners: [0, 0, 0.4, 0, 0.4, 0.3, 0, 0.2], mu: 0.5 });      // m
 * crate.limitSurface(80).gauge({ fx: 20, fy: 0, torque: 3 });                         // N; N, N m
 * ```
 *
 * Patches other than a dry disk, and laws, keep a table or their corners in the memory of the
 * WebAssembly. It is freed when the object is collected, or at once by `free()` or `using`.
 */

import type { Body, BodyOptions, Friction, LimitSurface, Rows, Twist, Wrench } from "./index.js";

export {
  init,
  initSync,
  version,
  PATH_COLUMNS,
  type Body,
  type BodyOptions,
  type DiskOptions,
  type FixedPoint,
  type Friction,
  type LimitSurface,
  type Model,
  type Modes,
  type Motion,
  type Pose,
  type Projection,
  type Rest,
  type RolloutOptions,
  type Rows,
  type Source,
  type Step,
  type Twist,
  type Wrench,
} from "./index.js";

/**
 * What friction follows: Coulomb's law with `mu`; μ |v|^α with `mu` and `alpha`; or any law of the
 * catalogue `laws()`.
 */
export interface LawOptions {
  /**
   * Coefficient of friction, at least 0; with `alpha` in (s/m)^α. Or two, above 0, of dry friction along an axis of
   * the patch and across it; the `mu` of the result is then the larger one, and a round patch is no longer round.
   */
  mu?: number | readonly [number, number];
  /** Direction of the axis with two coefficients, from x, in rad; x if it is left out. */
  axis?: number;
  /** Exponent of the speed, above −1: up to 128 on round patches, up to 10 on polygons. */
  alpha?: number;
  /** A law in place of `mu`. */
  law?: Law | string;
}

/** A round patch. */
export interface RoundOptions extends LawOptions {
  /** Its radius, in m, above 0. */
  radius: number;
}

/** A disk under uniform pressure. */
export function disk(options: RoundOptions): RoundFriction;
/** All load on the rim, evenly: a cup, a curling stone. */
export function ring(options: RoundOptions): RoundFriction;
/** Uniform pressure between an inner radius (in m, from 0) and the radius. */
export function annulus(options: RoundOptions & { inner: number }): RoundFriction;
/** The pressure 1/r between both radii: a clutch, a pivot or a thrust bearing that has worn in. Under Coulomb friction. */
export function wornAnnulus(options: LawOptions & { inner: number; radius: number }): AnyFriction;
/** The pressure √(1 − (r/radius)²) of elastic spheres (Hertz 1882). */
export function hertz(options: RoundOptions): RoundFriction;
/** The pressure 1/√(1 − (r/radius)²) under a rigid flat punch. */
export function punch(options: RoundOptions): RoundFriction;
/** The pressure 1 − (r/radius)². */
export function paraboloid(options: RoundOptions): RoundFriction;
/** The pressure (1 − (r/radius)²)^order, of an order above −1. */
export function power(options: RoundOptions & { order: number }): RoundFriction;
/** The pressure a0 + a1 (r/radius)² + …, nowhere negative, of these coefficients. */
export function polynomial(options: RoundOptions & { coefficients: readonly number[] }): RoundFriction;

/** A patch with straight edges. Corners are pairs of numbers, flat (x, y, x, y, …) or nested. */
export interface PolygonOptions extends LawOptions {
  /** Corners in m, in either sense; the polygon need not be convex, and must not cross itself. */
  corners: Rows | readonly (readonly [number, number])[];
  /** Corners of each hole. */
  holes?: readonly (Rows | readonly (readonly [number, number])[])[];
  /** Centre of pressure in m: the pressure is linear with this centre. Uniform if it is left out. */
  centre?: readonly [number, number];
}

/** A polygon, under uniform or linear pressure. Laws: Coulomb, and powers of the speed up to 10. */
export function polygon(options: PolygonOptions): AnyFriction;
/** A rectangle with sides a and b along x and y, in m, about the origin. */
export function box(
  options: LawOptions & { a: number; b: number; centre?: readonly [number, number] },
): AnyFriction;
/** A straight line along x about the origin, of a length in m, under Coulomb friction. */
export function bar(options: LawOptions & { length: number }): AnyFriction;
/** Points that share the load by weight (feet): x, y in m, weight of each. Any law. */
export function points(
  options: LawOptions & { points: Rows | readonly (readonly [number, number, number])[] },
): AnyFriction;
/**
 * Triangles under linear pressure, such as the contact face of a solver, under Coulomb friction: vertices
 * x, y in m and pressure, of which only the ratios count; three numbers of vertices, from 0, for each triangle.
 */
export function mesh(
  options: LawOptions & {
    vertices: Rows | readonly (readonly [number, number, number])[];
    triangles: Rows | readonly (readonly [number, number, number])[];
  },
): AnyFriction;

/**
 * An ellipse under uniform pressure with semi-axes a and b along x and y, in m, about the origin, under Coulomb
 * friction.
 */
export function ellipse(options: LawOptions & { a: number; b: number }): AnyFriction;
/** An ellipse under Hertz' pressure √(1 − (x/a)² − (y/b)²): a wheel on a rail. */
export function hertzEllipse(options: LawOptions & { a: number; b: number }): AnyFriction;
/** Points that share the load evenly on a circle of a radius in m: bolts of a flange. Any law. */
export function bolts(options: LawOptions & { count: number; radius: number }): AnyFriction;

/** A part of the floor and how it moves. */
export interface Surface {
  /** Corners of a convex polygon, or two points of a border to whose left the surface lies, in m. */
  corners: Rows | readonly (readonly [number, number])[];
  /** Motion of the surface about the origin; none if it is left out. */
  twist?: Twist;
}

/** A motion in which friction balances a push: the one that a body comes to. */
export interface SteadyMotion {
  readonly twist: Twist;
  readonly friction: Wrench;
  /** The first foot, or piece of the patch, of those that rest on their surface; null where all slide. */
  readonly carriedBy: number | null;
  /** How often friction was evaluated in the search. */
  readonly evaluations: number;
}

/** The end of a time step on feet. */
export interface FloorStep {
  readonly twist: Twist;
  /** Friction of all feet, as its mean over the step. */
  readonly friction: Wrench;
  /** As in `SteadyMotion`, at the end of the step. */
  readonly carriedBy: number | null;
  /** What the search has left of the balance of momentum, over all limits: some rounding errors. */
  readonly imbalance: number;
}

/** A body on several surfaces, or on several feet, each of which has a surface that moves by itself. */
export interface Floor {
  /** What all feet carry together, in N. */
  readonly forceLimit: number;
  /** Number of feet, or of pieces of the patch. */
  readonly count: number;
  /** Force in N and torque in N m about the origin on a body that moves with a twist. */
  wrench(twist: Twist): Wrench;
  /** Their derivatives, row by row. */
  jacobian(twist: Twist): Float64Array;
  /**
   * The motion in which friction balances a push on the body; no push if it is left out. RangeError if the push is
   * more than friction carries.
   */
  steadyMotion(push?: Wrench): SteadyMotion;
  /**
   * The motion after one implicit time step of a body whose centre of mass is the origin. Feet that come to rest on
   * their surface do so in every bit. Accuracy: of second order in dt while all feet slide.
   *
   * @param body mass in kg and moment of inertia in kg m², each above 0.
   * @param push force and torque of all but friction, in N and N m; none for null.
   * @param dt length of the step in s, above 0.
   */
  step(
    body: { readonly mass: number; readonly inertia: number },
    twist: Twist,
    push: Wrench | null,
    dt: number,
  ): FloorStep;
  /** All feet as one patch, while body and surfaces move as one: with mu = 1 under the load `forceLimit`. */
  readonly patch: Friction;
  /** All wrenches that the feet carry together then: that of `patch` under `forceLimit`. */
  limitSurface(): LimitSurface;
  free(): void;
  [Symbol.dispose](): void;
}

/** A foot of a body. */
export interface Foot {
  /** Its patch under dry friction. */
  friction: Friction;
  /** Its load in N, at least 0. */
  load: number;
  /** Where the origin of its patch lies on the body, in m. */
  place: readonly [number, number];
  /** By which it is turned on the body; 0 if it is left out. */
  degrees?: number;
  /** Motion of the surface under it, about the origin of the body; none if it is left out. */
  surface?: Twist;
}

/**
 * A body on several feet.
 *
 * ```js
 * const wheel = box({ a: 0.04, b: 0.02, mu: 0.7 });                                   // m
 * const robot = feet([-0.2, 0.2].flatMap((x) => [-0.25, 0.25].map((y) => (
 *   { friction: wheel, load: 75, place: [x, y], surface: { vx: y < 0 ? 0.2 : -0.2, vy: 0, spin: 0 } }
 * ))));
 * robot.steadyMotion().twist.spin;                                                    // 0.488 rad/s
 * ```
 */
export function feet(feet: readonly Foot[]): Floor;

/** Friction of a patch, on one surface at rest or on several that move. */
export interface AnyFriction extends Friction {
  /** With `surface`: on these surfaces, of which the first counts where two lie over each other. */
  wrench(twist: Twist, load: number, options?: { surface?: readonly Surface[] }): Wrench;
  jacobian(twist: Twist, load: number, options?: { surface?: readonly Surface[] }): Float64Array;
  /** The motion in which friction of all surfaces balances a push; see `Floor`. */
  steadyMotion(load: number, surface: readonly Surface[], push?: Wrench): SteadyMotion;
  /** The patch cut along the borders of surfaces, once for many calls; what no surface covers stands on the ground. */
  onSurfaces(load: number, surface: readonly Surface[]): Floor;
}

/** Friction of a round patch. */
export interface RoundFriction extends AnyFriction {
  body(options: BodyOptions): RoundBody;
}

/** A body on a round patch. */
export interface RoundBody extends Body {
  /**
   * Every launch after which the body comes to rest at a wanted pose, in the order of kinetic energy; at
   * least one. Under α < 1. To each distance and angle turned belongs exactly one launch; several numbers
   * of turns give several launches.
   *
   * RangeError if no launch within the limits leads there, with the launch that it would need.
   * Accuracy: the pose is met to 1e-12 of the distance and of the angle turned.
   */
  launches(options: LaunchOptions): Launch[];
}

/** Where a body is to come to rest, and how fast it may be launched. */
export interface LaunchOptions {
  /** Where it rests, in m and rad; it starts at the origin with angle 0. */
  x: number;
  y: number;
  angle: number;
  /** Largest speed in m/s, at least 0. */
  maxSpeed: number;
  /** Largest magnitude of the spin in rad/s, at least 0. */
  maxSpin: number;
  /**
   * "modulo", if it is left out: the angle is an orientation, after any number of turns in either
   * sense. "exact": it is the whole angle turned.
   */
  turns?: "modulo" | "exact";
  /** Orientations repeat after 2π/symmetry; 1 if it is left out. */
  symmetry?: number;
  /** Number of launches to be listed, those with the fewest turns; 100 if it is left out. */
  most?: number;
}

/** A launch that ends at the wanted pose. */
export interface Launch extends Twist {
  /** Magnitude of the velocity, in m/s. */
  readonly speed: number;
  /** Direction of the velocity from x, in rad; 0 for a pure spin, where it is arbitrary. */
  readonly direction: number;
  /** Angle turned in all, in rad, of either sign. */
  readonly angle: number;
  /** Time from launch to rest, in s. */
  readonly time: number;
  /** Kinetic energy at the launch per mass, in J/kg. */
  readonly energyPerMass: number;
}

/** A law of the local speed: friction per load as a function of the speed. */
export interface Law {
  /** Its name in the catalogue. */
  readonly name: string;
  /** Its parameters in SI units, defaults included. */
  readonly parameters: Readonly<Record<string, number>>;
  /** The law as one line, such as "stribeck:mu_s=0.4,mu_d=0.2,vs=0.05,delta=2,k=0". */
  readonly text: string;
  /** Friction per load at a speed in m/s, whose sign is ignored. */
  friction(speed: number): number;
  /** Its derivative with respect to the speed, in s/m. */
  slope(speed: number): number;
  /** Friction per load at many speeds. */
  frictions(speeds: Rows, out?: Float64Array): Float64Array;
  free(): void;
  [Symbol.dispose](): void;
}

/**
 * A law by its name and parameters: `law("stribeck", { mu_s: 0.4, mu_d: 0.2, vs: 0.05 })`, or by the
 * whole line.
 */
export function law(name: string, parameters?: Readonly<Record<string, number>>): Law;

/** A law of the catalogue. */
export interface LawEntry {
  readonly name: string;
  readonly summary: string;
  readonly formula: string;
  readonly source: string;
  /** Whether it is a law of the local speed, which `law` makes. */
  readonly isLocal: boolean;
  readonly parameters: readonly {
    readonly name: string;
    /** In SI, or "-" for a pure number. */
    readonly unit: string;
    readonly meaning: string;
    /** The value where it is left out; null if it must be given. */
    readonly default: number | null;
  }[];
}

/** All laws of the library. */
export function laws(): LawEntry[];

/** A foot whose pressure is not known: what it carries for certain, and what it may carry at most. */
export interface AnyPressure {
  /** Largest distance of a corner from the centre of pressure, in m. */
  readonly radius: number;
  /** Largest power in W that friction may take from a motion, over all pressures. */
  support(twist: Twist): number;
  /** Friction of a pressure that attains it. */
  wrench(twist: Twist): Wrench;
  /**
   * Torques in N m about the origin with a force: carried under every pressure, and bounds that no
   * pressure exceeds. Null if the force alone is too large.
   */
  torqueLimits(fx: number, fy: number): {
    readonly carried: readonly [number, number];
    readonly outer: readonly [number, number];
  } | null;
  /** Bounds of the gauge: above 1 in the first, it slides; below 1 in the second, it may be held. */
  gaugeBounds(wrench: Wrench): readonly [number, number];
  free(): void;
  [Symbol.dispose](): void;
}

/**
 * All pressures on the convex hull of some corners with a known centre.
 *
 * @param options corners in m; centre of pressure in m; forceLimit = μ load in N.
 */
export function anyPressure(options: {
  corners: Rows | readonly (readonly [number, number])[];
  centre: readonly [number, number];
  forceLimit: number;
}): AnyPressure;

/** Three components. */
export type Vector = readonly [number, number, number];

/** A sphere that moves. */
export interface Sphere {
  /** In m/s. */
  velocity: Vector;
  /** In rad/s; no spin if it is left out. */
  spin?: Vector;
  /** In kg, above 0; Infinity for one that nothing moves. */
  mass: number;
  /** In m, above 0. */
  radius: number;
  /** In kg m²; that of a solid sphere if it is left out. */
  inertia?: number;
}

/** A plate: a wall, or a piston that contacts move along the normal alone. */
export interface Plate {
  /** In m/s; the part across the normal is prescribed: a belt. No motion if it is left out. */
  velocity?: Vector;
  /** In kg; Infinity if it is left out. */
  mass?: number;
}

/** What a contact resists. */
export interface ContactOptions {
  /** Coefficient of sliding friction, at least 0; 0 if it is left out. */
  mu?: number;
  /** Coefficients of rolling and torsion: torque limits over force and r_eff = 1/(1/R1 + 1/R2). */
  muRolling?: number;
  muTorsion?: number;
  /**
   * A round patch, in place of muTorsion: sliding and torsion share its exact limit surface. `radius`
   * is that of the contact over r_eff, `inner` the inner one of an annulus over r_eff; `order` and
   * `coefficients` are those of the functions `power` and `polynomial`.
   */
  patch?: {
    kind: "disk" | "ring" | "annulus" | "hertz" | "punch" | "paraboloid" | "power" | "polynomial";
    radius: number;
    inner?: number;
    order?: number;
    coefficients?: readonly number[];
  };
  /** Speed after an impact over speed before, 0 to 1; 0 if it is left out. */
  restitution?: number;
  /** Force in N that holds a contact together, and the gap in m up to which it does; none if left out. */
  cohesion?: number;
  cohesionRange?: number;
  /** "pull", if it is left out: cohesion closes gaps. "resistance": it resists opening alone. */
  attraction?: "pull" | "resistance";
}

/** What a contact did in one time step. Impulses act on the second body, the first takes the opposite. */
export interface Collision {
  /** Motions after the step, in m/s and rad/s. */
  readonly first: { readonly velocity: Vector; readonly spin: Vector };
  readonly second: { readonly velocity: Vector; readonly spin: Vector };
  /** Impulse along the normal, in N s; negative where cohesion pulls. */
  readonly normal: number;
  /** Friction impulse across the normal, in N s. */
  readonly sliding: Vector;
  /** Impulse of the rolling torque, in N m s. */
  readonly rolling: Vector;
  /** Impulse of the torque about the normal, in N m s. */
  readonly torsion: number;
}

/** The law of a contact. */
export interface ContactLaw {
  /**
   * Solves a contact of two spheres, or of a sphere and a plate, for one implicit time step (Moreau,
   * Jean).
   *
   * @param options normal: unit vector from the first to the second body; gap in m, 0 if it is left
   *   out, negative for overlap; dt in s, above 0, which matters for gaps and cohesion alone: 1 if it
   *   is left out.
   */
  collide(
    first: Sphere,
    second: Sphere | Plate,
    options: { normal: Vector; gap?: number; dt?: number },
  ): Collision;
  free(): void;
  [Symbol.dispose](): void;
}

/** What contacts resist: penetration, separation, sliding, rolling and spinning. */
export function contactLaw(options: ContactOptions): ContactLaw;
