/**
 * Solid friction of bodies that slide and spin at once, exact, as WebAssembly.
 *
 * ```js
 * import { init, disk } from "tribos";
 * await init();
 * const puck = disk({ radius: 0.04, mu: 0.3 });                  // m
 * puck.wrench({ vx: 1, vy: 0, spin: 20 }, 1.7);                  // m/s, m/s, rad/s; N
 * // { fx: -0.46497…, fy: 0, torque: -0.00435… }                   N, N, N m
 * ```
 *
 * This entry, `tribos`, has disks under Coulomb friction. The entry `tribos/all` has everything that
 * this one has, and all other patches, laws, launches and contacts: a program needs one of the two.
 * `tribos/inline` and `tribos/all/inline` are the same two with the WebAssembly inside.
 *
 * Units are SI in this documentation; any consistent set serves. A positive spin turns x towards y.
 * Every function is synchronous after `init`. Numbers that describe a body, a patch or a law are
 * validated: a `RangeError` says which domain they have to be in, a `TypeError` that something is no
 * number. Motions and pushes may be any numbers: NaN gives NaN, infinity what the kernel documents.
 * The same arguments give the same bits in every browser, in Node, and in Rust, C and Python.
 */

/** Where the WebAssembly comes from: its address, its bytes, a response, or a compiled module. */
export type Source =
  | URL
  | string
  | BufferSource
  | Response
  | PromiseLike<Response>
  | WebAssembly.Module;

/**
 * Loads the WebAssembly; once is enough, and further calls wait for the first.
 *
 * Without a source the file next to this module is loaded: by `fetch`, or from the disk where the
 * module itself comes from there (Node, Deno, Bun). In the entries `/inline` there is nothing to load.
 */
export function init(source?: Source): Promise<void>;

/** The same at once, from bytes or a compiled module; in the entries `/inline` from nothing. */
export function initSync(source?: BufferSource | WebAssembly.Module): void;

/** The version of the package. */
export const version: string;

/** A motion in the plane. */
export interface Twist {
  /** Velocity of the origin of the patch along x, in m/s. */
  readonly vx: number;
  /** Along y, in m/s. */
  readonly vy: number;
  /** Angular velocity, in rad/s. */
  readonly spin: number;
}

/** A force with a torque about the origin of the patch. */
export interface Wrench {
  /** Force along x, in N. */
  readonly fx: number;
  /** Along y, in N. */
  readonly fy: number;
  /** Torque, in N m. */
  readonly torque: number;
}

/** A place and an angle. */
export interface Pose {
  /** In m. */
  readonly x: number;
  /** In m. */
  readonly y: number;
  /** Angle turned, in rad, not reduced to one turn. */
  readonly angle: number;
}

/** Rows of numbers one after another; `Float64Array` is the quickest. */
export type Rows = Float64Array | Float32Array | readonly number[];

/** A disk under uniform pressure and Coulomb friction. */
export interface DiskOptions {
  /** Its radius, in m, above 0. */
  radius: number;
  /** Coefficient of friction, at least 0. */
  mu: number;
}

/** Friction of a disk. Plain numbers: there is nothing to be freed. */
export function disk(options: DiskOptions): Friction;

/** Friction of a patch: force and torque against its motion. Immutable. */
export interface Friction {
  /** Name of the patch: "disk", "ring", "polygon", …. */
  readonly kind: string;
  /** Whether the patch has an axis. */
  readonly isRound: boolean;
  /** Coefficient μ of dry friction, or γ of γ |v|^α in (s/m)^α; NaN for other laws. */
  readonly mu: number;
  /** Exponent α of the speed: 0 for dry friction; NaN for laws that are no power. */
  readonly alpha: number;
  /** Distance of the farthest point from the centre of pressure, in m. */
  readonly radius: number;
  /** Centre of pressure in m, in the coordinates that twist and wrench refer to. */
  readonly centre: readonly [number, number];

  /**
   * Friction on a patch that moves, under a load in N, at least 0. Zero at rest.
   *
   * Accuracy: a few units in the last place on round patches, 2e-14 of the largest friction on
   * polygons.
   */
  wrench(twist: Twist, load: number): Wrench;

  /**
   * Derivatives of force x, force y and torque (rows) with respect to velocity x, velocity y and spin
   * (columns): nine numbers row by row, symmetric. At rest dry friction has none: infinite on round
   * patches, 0 on straight edges and points.
   */
  jacobian(twist: Twist, load: number): Float64Array;

  /**
   * Friction of many motions, to the bits of single calls.
   *
   * @param twists vx, vy, spin of each.
   * @param load one for all, or one for each.
   * @param out memory for the result; a new array if it is left out.
   * @returns fx, fy, torque of each.
   */
  wrenches(twists: Rows, load: number | Rows, out?: Float64Array): Float64Array;

  /** Their Jacobians, nine numbers each, as `jacobian` has them. */
  jacobians(twists: Rows, load: number | Rows, out?: Float64Array): Float64Array;

  /** All wrenches that dry friction carries under a load in N, at least 0; RangeError for other laws. */
  limitSurface(load: number): LimitSurface;

  /** A body that lies on this patch. */
  body(options: BodyOptions): Body;

  /**
   * The final motion of a body that nothing but friction acts on; on round patches under a power of
   * the speed.
   *
   * @param inertiaRatio I/(m radius²), above 0: 1/2 for a solid disk on its own face.
   * @param initialRatio speed/(|spin| radius) at the launch, from 0 to Infinity: it decides between
   *   two stable ends, which there are for α > 1.
   */
  modes(inertiaRatio: number, initialRatio?: number): Modes;

  /** Frees the memory of a prepared patch or law now, rather than with this object. A disk has none. */
  free(): void;
  /** The same, for `using`. */
  [Symbol.dispose](): void;
}

/** A ratio of sliding to spinning that a body keeps. */
export interface FixedPoint {
  /** speed/(|spin| radius): 0 for pure spinning, Infinity for pure sliding. */
  readonly ratio: number;
  /** Whether ratios nearby come to it. */
  readonly stability: "stable" | "semistable" | "unstable";
}

/** The final motion of a body. */
export interface Modes {
  /**
   * What dominates just before rest; "together" where both fade in a fixed ratio. Null where it
   * depends on an initial ratio that was not given.
   */
  readonly finalMode: "sliding" | "spinning" | "together" | null;
  /** The ratio speed/(|spin| radius) in the limit of rest; null with `finalMode`. */
  readonly finalRatio: number | null;
  /** All fixed points in rising order; the first is 0, the last Infinity. */
  readonly fixedPoints: readonly FixedPoint[];
  /** The open interval of I/(m radius²) in which there is a fixed point between them. */
  readonly inertiaInterval: readonly [number, number];
  /** True for α < 1. */
  readonly restsInFiniteTime: boolean;
}

/** The wrench of a set that is nearest to a given one. */
export interface Projection extends Wrench {
  /** True if the given wrench is outside or on the surface: the contact slides. */
  readonly slides: boolean;
  /** Outward normal, |velocity|² + (spin radius)² = 1: the motion. Zero if the contact sticks. */
  readonly normal: Twist;
}

/**
 * All wrenches that dry friction carries: a closed convex set. A push is the wrench that moves the
 * patch against friction; the set is the same for friction and pushes.
 */
export interface LimitSurface {
  /** Largest force μ load, in N. */
  readonly forceLimit: number;
  /** Largest torque about the origin, in N m. */
  readonly torqueLimit: number;
  /** The lever that makes a speed of a spin, in m: the radius of the patch about the origin. */
  readonly radius: number;
  /** The model: exact, or an approximation from the literature to compare with. */
  readonly model: Model;

  /** Whether friction can carry the wrench, up to rounding: gauge ≤ 1. */
  contains(wrench: Wrench): boolean;
  /** The least factor by which the set must grow to hold the wrench: below 1 it holds. */
  gauge(wrench: Wrench): number;
  /** The motion that a push causes, |velocity|² + (spin radius)² = 1; zero for no push. */
  normal(push: Wrench): Twist;
  /** The wrench along the same ray on the surface, wrench/gauge. */
  scaleToSurface(wrench: Wrench): Wrench;
  /**
   * The nearest wrench by √(|Δforce|² + (Δtorque/length)²); a wrench of the set stays as it is, to the
   * last bit.
   *
   * @param length in m; the radius if it is left out. With the radius of gyration √(I/m) the distance
   *   is that of kinetic energy.
   */
  project(wrench: Wrench, length?: number): Projection;
  /** The power in W that friction takes from a motion: the largest wrench · twist of the set. */
  support(twist: Twist): number;
  /** Friction at a motion: the surface point with the outward normal −twist. Zero at rest. */
  wrench(twist: Twist): Wrench;

  /** Gauges of many wrenches (fx, fy, torque of each). */
  gauges(wrenches: Rows, out?: Float64Array): Float64Array;
  /** Friction at many motions (vx, vy, spin of each), as fx, fy, torque of each. */
  wrenches(twists: Rows, out?: Float64Array): Float64Array;
  /**
   * A curve on the surface, to be drawn: the pushes that keep the patch in motion while it slides along
   * a direction and spins, from pure spin in the negative sense (φ = −π/2) over pure sliding (φ = 0) to
   * pure spin in the positive one (φ = π/2), with the twist (cos φ along the direction, sin φ/radius).
   * Two meridians with opposite directions make a closed curve.
   *
   * @param count number of points, at least 2.
   * @param direction of sliding, in rad from x; it matters where the patch has no axis.
   * @returns fx, fy, torque of each.
   */
  meridian(count: number, direction?: number): Float64Array;

  /**
   * The ellipsoid with the same largest force, and the same largest torque about the origin: the usual
   * approximation, to compare. In `tribos/all`; RangeError in `tribos`.
   */
  ellipsoid(): LimitSurface;
  /**
   * Force and torque limited each by itself, as in engines with a separate torsional friction: a
   * cylinder, which holds the exact set. In `tribos/all`; RangeError in `tribos`.
   */
  separate(): LimitSurface;
}

/** What limits force and torque together. */
export type Model = "exact" | "ellipsoid" | "separate";

/** A body that lies on a patch; the origin of the patch is below its centre of mass. */
export interface BodyOptions {
  /** Mass in kg, above 0. */
  mass: number;
  /** Moment of inertia about the normal through the centre of mass, in kg m², above 0. */
  inertia: number;
  /** Normal force in N, at least 0; mass · gravity if it is left out. */
  load?: number;
  /** In m/s²; 9.81 if it is left out. */
  gravity?: number;
  /** Friction of the time steps, exact if it is left out. The approximations are in `tribos/all`. */
  model?: Model;
  /**
   * Coefficient at rest, at least that of the friction: in `step` and `rollout` a body at rest stays until the push
   * exceeds it, and then slides under the friction in the same step. The same coefficient if it is left out. In
   * `tribos/all`; RangeError in `tribos`.
   */
  muStatic?: number;
}

/** The end of a time step. */
export interface Step extends Twist, Wrench {
  /** Motion after the step; zero to the last bit at rest. In m/s and rad/s. */
  readonly vx: number;
  readonly vy: number;
  readonly spin: number;
  /** Mean friction over the step, in N and N m. */
  readonly fx: number;
  readonly fy: number;
  readonly torque: number;
  /** Whether friction holds the body. */
  readonly isAtRest: boolean;
}

/** A motion with the way covered since its start. */
export interface Motion extends Twist, Pose {
  /** Time since the start, in s. */
  readonly time: number;
  /** Whether the body has come to rest. */
  readonly isAtRest: boolean;
}

/** Where and when a body comes to rest. */
export interface Rest extends Pose {
  /** In s. */
  readonly time: number;
  /** Distance covered, in m. */
  readonly distance: number;
  /** speed/(|spin| radius) in the limit of rest: 0 if only spin is left, Infinity if only sliding. */
  readonly ratio: number;
}

/** What a rollout repeats. */
export interface RolloutOptions {
  /** Length of a step in s, above 0. */
  dt: number;
  /** Number of steps, at least 1. */
  steps: number;
  /** Force and torque of all but friction, in N and N m, in axes that do not turn; none if left out. */
  push?: Wrench;
  /** Where the body starts; at the origin if it is left out. */
  pose?: Pose;
}

/** Numbers of each row of a path: time, x, y, angle, vx, vy, spin in s, m, rad, m/s and rad/s. */
export const PATH_COLUMNS: readonly ["time", "x", "y", "angle", "vx", "vy", "spin"];

/** A body that is pushed, turned and slides on its patch. Immutable: motions go in and come out. */
export interface Body {
  readonly friction: Friction;
  /** In kg. */
  readonly mass: number;
  /** In kg m². */
  readonly inertia: number;
  /** In N. */
  readonly load: number;
  readonly model: Model;
  /** Coefficient at rest. */
  readonly muStatic: number;

  /**
   * The motion after one time step under a constant push: implicit, so that a body that friction holds
   * rests exactly, and no step gains energy, however long. Dry friction on any patch; RangeError for
   * other laws, which `advance` follows.
   *
   * Accuracy: of second order in dt while the body slides, of first order in the step in which it
   * starts, stops or turns about.
   *
   * @param push force and torque of all but friction, in N and N m; none for null.
   * @param dt length of the step in s, above 0.
   * @param angle by which the patch is turned against the axes of twist and push, in rad; 0 if it is
   *   left out. It does not matter to a round patch.
   */
  step(twist: Twist, push: Wrench | null, dt: number, angle?: number): Step;

  /**
   * Many such steps, to the bits of single ones: a row of PATH_COLUMNS for the start, and one for each
   * step. Places advance by the mean of the motions before and after a step; a patch that is not round
   * turns with the body and is taken at its angle at half time. Without a push the rows end with the
   * first one at rest.
   */
  rollout(twist: Twist, options: RolloutOptions): Float64Array;

  /**
   * A free motion after a time in s, at least 0, also past rest: exact to rounding for every length of
   * time, under any power of the speed, on round patches.
   */
  advance(twist: Twist, duration: number): Motion;

  /**
   * Where and when a free motion comes to rest.
   *
   * On round patches under α < 1: exact, 1e-13 of time, distance and angle. On other patches under dry
   * friction: by a rollout of about 2000 steps; `ratio` is then that of the last step.
   */
  slide(twist: Twist): Rest;

  /**
   * The free motion from the launch to rest, to be drawn: rows of PATH_COLUMNS at even times.
   *
   * @param count number of rows, at least 2; 100 if it is left out. On patches that are not round the
   *   rows are those of a rollout, and the number is approximate.
   */
  slidePath(twist: Twist, count?: number): Float64Array;
}
