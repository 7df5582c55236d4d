//! The scene of a cohesive powder under a piston (thesis, section 4.5).

use super::body::BODY;
use super::entries::Entries;
use super::key::{Key, Reader};
use super::planar::Taker;
use super::powder_keys::*;
use super::problem::Problem;
use crate::cd::{Method, Order, Solver, StepLimits, Stop};
use crate::powder::deposit::{Ballistic, Until};
use serde_json::{Map, Value};
use tribos_core::contact::Attraction;

/// What spheres do at substrate and piston.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum WallLaw {
    /// The law of spheres.
    Full,
    /// Cohesion without friction.
    Smooth,
    /// Neither.
    Bare,
}

/// How the thresholds of sliding and torsion depend on each other.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Coupling {
    /// Not at all (thesis, eqs. 4.1 and 4.2).
    Independent,
    /// By an ellipsoid with these thresholds for axes.
    Ellipsoid,
    /// By the limit surface of a round contact under uniform pressure with these thresholds.
    Exact,
}

/// When a packing counts as blocked.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Criterion {
    /// Forces balance and the piston stands.
    Balance,
    /// The piston stands (thesis, section 4.5).
    Piston,
}

/// A validated scene. *Units*: lengths in mean radii R of the spheres, forces in F_coh, the density
/// of the spheres is 1: times are in √(ρR⁴/F_coh).
///
/// ```
/// use tribos::scene::{Coupling, Criterion, PowderScene, Scene, WallLaw, parse_scene};
/// let text = "body = \"powder\"\nwidth = 20\nheight = 61.5\nwall = \"smooth\"\n\
///             sliding = 0.3\nrolling = 0.1\ntorsion = 0.2\ncoupling = \"exact\"";
/// let Scene::Powder(scene) = parse_scene("powder.toml", text, &[])? else { unreachable!() };
/// assert!((scene.load() - 1.0).abs() < 1e-15); // 400 R² under F_coh/400 a square radius
/// assert_eq!((scene.wall, scene.blocked), (WallLaw::Smooth, Criterion::Balance));
/// // Sliding and torsion share one limit surface; rolling keeps a threshold of its own.
/// assert_eq!((scene.coupling, scene.friction), (Coupling::Exact, [0.3, 0.1, 0.2]));
/// assert!(PowderScene::KEYS.iter().all(|key| scene.json().get(key.name).is_some()));
/// # Ok::<(), tribos::scene::SceneError>(())
/// ```
#[derive(Clone, Debug)]
pub struct PowderScene {
    /// How the deposit grows.
    pub ballistic: Ballistic,
    /// Side of the square base.
    pub width: f64,
    /// Where it ends.
    pub until: Until,
    /// Seed of the deposit.
    pub seed: u64,
    /// μ, μ_t and μ_n between spheres.
    pub friction: [f64; 3],
    /// How sliding and torsion go together.
    pub coupling: Coupling,
    /// On the piston, in F_coh/R².
    pub pressure: f64,
    /// d_c
    pub cohesion_range: f64,
    /// What cohesion does within its range.
    pub attraction: Attraction,
    /// Newton's coefficient.
    pub restitution: f64,
    /// What spheres do at the walls.
    pub wall: WallLaw,
    /// Mass of the piston, in ρR³.
    pub piston_mass: f64,
    /// How contacts are solved.
    pub solver: Solver,
    /// Bounds of the time step.
    pub pace: StepLimits,
    /// Speed below which spheres that nothing disturbs are left alone.
    pub still_speed: f64,
    /// When the packing counts as blocked.
    pub blocked: Criterion,
    /// Most steps.
    pub steps: u64,
    /// End of the run, if it is not blocked before.
    pub duration: Option<f64>,
    /// Steps from one line of the series to the next.
    pub samples: u64,
    pub(super) values: Map<String, Value>,
}

/// Distance of centres at which a sphere is captured (thesis, section 4.5).
const CAPTURE_RADIUS: f64 = 3.0;
/// Friction between spheres (thesis, section 4.6).
const SLIDING_COEFFICIENT: f64 = 0.3;
/// Pressure on the piston and its mass (thesis, section 4.5).
const THESIS_PRESSURE: f64 = 1.0 / 400.0;
const THESIS_MASS: f64 = 1000.0;
/// Van der Waals attraction, F = A R/(12 D²) beyond the closest distance D₀ = 0.165 nm
/// (Israelachvili, Intermolecular and Surface Forces), takes the work F(D₀) D₀ to break: d_c is D₀.
/// A hundredth of R belongs to spheres of 16 nm, a nano-powder.
const NANO_RANGE: f64 = 1e-2;
/// A tenfold smaller or larger tolerance leaves the final porosity as it is.
const SWEEP_TOLERANCE: f64 = 1e-4;
/// A bound for steps in which the tolerance is out of reach.
const MOST_SWEEPS: f64 = 1000.0;
/// A twentieth of a radius keeps the angle by which a normal turns in a step small.
const STEP_MOTION: f64 = 0.05;
/// Longest step: the pressure moves the piston by 10⁻⁵ R in it from rest.
const LONGEST: f64 = 0.2;
/// A speed with which a sphere would cross a hundredth of its radius in 10⁵ units of time.
const STILL_SPEED: f64 = 1e-7;
/// Runs of the thesis' systems block within some thousand steps.
const MOST_STEPS: f64 = 200_000.0;
/// Some hundred lines a run.
const SAMPLE_STEPS: f64 = 20.0;
/// Seed unless one is given.
const FIRST_SEED: f64 = 1.0;
/// Stream of random orders of sweeps: another seed than the deposit's is of no use.
pub(super) const ORDER_SEED: u64 = 1;

impl PowderScene {
    /// The vocabulary, in the order of the documentation.
    pub const KEYS: &'static [Key] = &[
        BODY,
        WIDTH,
        HEIGHT,
        COUNT,
        CAPTURE,
        SPREAD,
        SEED,
        SLIDING,
        ROLLING,
        TORSION,
        COUPLING,
        PRESSURE,
        RANGE,
        ATTRACTION,
        RESTITUTION,
        WALL,
        MASS,
        SOLVER,
        ORDER,
        STOP,
        TOLERANCE,
        SWEEPS,
        WARM_START,
        MOTION,
        TIME_STEP,
        STILL,
        BLOCKED,
        STEPS,
        DURATION,
        SAMPLES,
    ];

    pub(super) fn from_entries(
        entries: Entries,
        problems: Vec<Problem>,
    ) -> Result<Self, Vec<Problem>> {
        let mut take = Taker {
            reader: Reader::new(Self::KEYS, entries, problems),
            values: Map::new(),
        };
        take.word(BODY);
        let width = take.required(WIDTH);
        let until = until(&mut take);
        let ballistic = ballistic(&mut take, width);
        let seed = take.or(SEED, FIRST_SEED) as u64;
        let friction = [
            take.or(SLIDING, SLIDING_COEFFICIENT),
            take.or(ROLLING, 0.0),
            take.or(TORSION, 0.0),
        ];
        let shapes = [Coupling::Independent, Coupling::Ellipsoid, Coupling::Exact];
        let coupling = shapes[take.word(COUPLING).min(2)];
        let pressure = take.or(PRESSURE, THESIS_PRESSURE);
        let cohesion_range = take.or(RANGE, NANO_RANGE);
        let attraction = [Attraction::Pull, Attraction::Resistance][take.word(ATTRACTION).min(1)];
        let restitution = take.or(RESTITUTION, 0.0);
        let wall = [WallLaw::Full, WallLaw::Smooth, WallLaw::Bare][take.word(WALL).min(2)];
        let piston_mass = take.or(MASS, THESIS_MASS);
        let solver = solver(&mut take);
        let pace = StepLimits {
            motion: take.or(MOTION, STEP_MOTION),
            longest: take.or(TIME_STEP, LONGEST),
        };
        let still_speed = take.or(STILL, STILL_SPEED);
        let blocked = [Criterion::Balance, Criterion::Piston][take.word(BLOCKED).min(1)];
        let steps = take.or(STEPS, MOST_STEPS) as u64;
        let duration = take.optional(DURATION);
        let samples = take.or(SAMPLES, SAMPLE_STEPS) as u64;
        let Some(ballistic) = ballistic else {
            // A problem is noted; the scene in hand is never given out.
            return take.reader.finish(()).and(Err(Vec::new()));
        };
        take.reader.finish(Self {
            ballistic,
            width,
            until,
            seed,
            friction,
            coupling,
            pressure,
            cohesion_range,
            attraction,
            restitution,
            wall,
            piston_mass,
            solver,
            pace,
            still_speed,
            blocked,
            steps,
            duration,
            samples,
            values: take.values,
        })
    }

    /// Force on the piston.
    pub fn load(&self) -> f64 {
        self.pressure * self.width * self.width
    }
}

/// One of height and count.
fn until(take: &mut Taker) -> Until {
    let (height, count) = (take.optional(HEIGHT), take.optional(COUNT));
    let given = [HEIGHT, COUNT].map(|key| take.reader.is_given(key.name));
    match given {
        [true, true] => {
            let message = "give `height` or `count`, not both";
            take.reader.object(COUNT.name, message.into());
        }
        [false, false] => {
            let message = "`height` is missing: the cut of the deposit [R]; or give `count`";
            take.reader.object(HEIGHT.name, message.into());
        }
        _ => {}
    }
    match count {
        Some(count) => Until::Count(count as usize),
        None => Until::Cut(height.unwrap_or(f64::NAN)),
    }
}

/// The deposit's law, if width, capture radius and spread fit together.
fn ballistic(take: &mut Taker, width: f64) -> Option<Ballistic> {
    let capture = take.or(CAPTURE, CAPTURE_RADIUS);
    let spread = take.or(SPREAD, 0.0);
    if spread >= 1.0 {
        let message = format!("`radius_spread` must be less than 1, not {spread}");
        take.reader.object(SPREAD.name, message);
        return None;
    }
    if width.is_nan() {
        return None;
    }
    match Ballistic::uneven(width, [1.0 - spread, 1.0 + spread], capture) {
        Ok(ballistic) => Some(ballistic),
        Err(error) => {
            let given = [CAPTURE, WIDTH].map(|key| take.reader.is_given(key.name));
            let name = if given[0] { CAPTURE.name } else { WIDTH.name };
            take.reader.object(name, error.to_string());
            None
        }
    }
}

/// The method and its rules.
fn solver(take: &mut Taker) -> Solver {
    let is_classical = take.word(SOLVER) == 1;
    let (order, stop) = (take.word(ORDER), take.word(STOP));
    if !is_classical {
        for key in [ORDER, STOP] {
            if take.reader.is_given(key.name) {
                let message = format!(
                    "`{}` is for solver \"gauss-seidel\" only; leave it out",
                    key.name
                );
                take.reader.object(key.name, message);
            }
        }
    }
    let is_fixed = is_classical && stop == 2;
    if is_fixed && take.reader.is_given(TOLERANCE.name) {
        let message = "`tolerance` is not used with stop = \"fixed\"; leave it out";
        take.reader.object(TOLERANCE.name, message.into());
    }
    let tolerance = take.or(TOLERANCE, SWEEP_TOLERANCE);
    let method = if is_classical {
        let random = Order::Random { seed: ORDER_SEED };
        Method::GaussSeidel {
            order: [Order::Alternating, Order::Fixed, random][order.min(2)],
            stop: [Stop::Global(tolerance), Stop::Local(tolerance), Stop::Fixed][stop.min(2)],
        }
    } else {
        Method::Accelerated { tolerance }
    };
    Solver {
        method,
        most_sweeps: take.or(SWEEPS, MOST_SWEEPS) as usize,
        warm_start: take.word(WARM_START) == 0,
    }
}
