//! Section 4.2: what a larger load and what shaking does to a packing, with and without cohesion.

use crate::exhibit::Exhibit;
use crate::runs::{Effort, Runs, System};
use crate::text::Text;
use anyhow::{Result, anyhow};
use nalgebra::Vector3;
use std::f64::consts::PI;
use std::num::NonZero;
use std::thread::available_parallelism;
use tribos::cd::{
    ContactSolver, SolverMethod, StepLimits, Wall, World, WorldMaterials, WorldSetup, solid,
};
use tribos::powder::deposit::{Ballistic, DepositTarget};
use tribos::run::in_order;
use tribos_core::contact::{Attraction, Cohesion, IndependentFriction, NormalLaw, SlidingOnly};
use tribos_report::claim::Claim;
use tribos_report::figure::{Axis, Figure, ReferenceLine, Series};

const TEXT: Text = Text(include_str!("section-4.2.md"));

type Friction = IndependentFriction<f64, SlidingOnly>;

/// Sliding friction and capture radius of the thesis' powders.
const SLIDING: f64 = 0.3;
const CAPTURE_RADIUS: f64 = 3.0;
/// Range of cohesion, in R.
const RANGE: f64 = 1e-2;
/// Pressures on one packing after another, the first in F_coh/R²: over three decades.
const FIRST: f64 = 1.0 / 400.0;
const FACTORS: [f64; 4] = [1.0, 10.0, 100.0, 1000.0];
/// Change of a sweep, relative to P, at which sweeps stop.
const TOLERANCE: f64 = 1e-4;
/// A bound for the steps in which a piston of this mass falls on the deposit.
const MOST_SWEEPS: usize = 100;
/// Steps in which a piston without resistance falls by R from rest, over √2.
const STEPS: f64 = 25.0;
/// Largest motion of a step, in R.
const MOTION: f64 = 0.05;
/// Steps of a window, the motion of the piston in it that counts as rest, in R, and the most windows.
const WINDOW: usize = 100;
const AT_REST: f64 = 1e-3;
const MOST_WINDOWS: usize = 40;
/// Shaking: half periods, steps of each, and the inertial force of all spheres over the load.
const STROKES: usize = 40;
const STROKE_STEPS: usize = 20;
const STRENGTH: f64 = 1.0;

/// A packing under a piston.
struct Packing {
    world: World<Friction>,
    solid: f64,
    area: f64,
}

impl Packing {
    /// The deposit of a seed, with cohesion or without it.
    fn new(system: System, cohesion: f64, seed: u64) -> Result<Self> {
        let [width, height] = system.size();
        let deposit =
            Ballistic::new(width, 1.0, CAPTURE_RADIUS)?.grow(DepositTarget::Cut(height), seed)?;
        let cohesion = if cohesion > 0.0 {
            Cohesion::new(cohesion, RANGE, Attraction::Pull)?
        } else {
            Cohesion::NONE
        };
        let laws = WorldMaterials::uniform(
            NormalLaw::new(cohesion, 0.0)?,
            IndependentFriction::sliding(SLIDING)?,
        );
        let (up, area) = (Vector3::z(), width * width);
        let count = deposit.positions.len();
        // The spheres', of density 1; the piston is as heavy.
        let mass = 4.0 / 3.0 * PI * count as f64;
        let setup = WorldSetup {
            space: deposit.space,
            radii: deposit.radii,
            spheres: vec![solid(1.0, 1.0); count],
            walls: vec![
                Wall::fixed(up, 0.0),
                Wall::piston(-up, -deposit.height, mass, 0.0),
            ],
            positions: deposit.positions,
            solver: ContactSolver {
                method: SolverMethod::Accelerated {
                    tolerance: TOLERANCE,
                },
                most_sweeps: MOST_SWEEPS,
                warm_start: 1.0,
            },
            ..WorldSetup::new(laws)
        };
        Ok(Self {
            world: World::new(setup)?,
            solid: mass,
            area,
        })
    }

    fn height(&self) -> f64 {
        -self.world.state().walls[1].place
    }

    fn porosity(&self) -> f64 {
        1.0 - self.solid / (self.area * self.height())
    }

    /// Sets the load, and steps that follow its pace.
    fn load(&mut self, load: f64) {
        let (setup, mut state) = (self.world.setup().clone(), self.world.state().clone());
        state.walls[1].force = load;
        let step_limits = StepLimits {
            longest: (self.solid / load).sqrt() / STEPS,
            motion: MOTION,
        };
        self.world = World::resume(
            WorldSetup {
                step_limits,
                ..setup
            },
            state,
        );
    }

    /// Steps until the piston is at rest; whether it is.
    fn settle(&mut self) -> Result<bool> {
        for _ in 0..MOST_WINDOWS {
            let before = self.height();
            for _ in 0..WINDOW {
                self.world.step()?;
            }
            if (self.height() - before).abs() < AT_REST {
                return Ok(true);
            }
        }
        Ok(false)
    }

    /// Shakes the box from side to side along x and y by turns, and lets it settle.
    fn shake(&mut self) -> Result<bool> {
        let strength = STRENGTH * self.world.state().walls[1].force / self.solid;
        let ways = [Vector3::x(), -Vector3::x(), Vector3::y(), -Vector3::y()];
        for stroke in 0..STROKES {
            self.push(ways[stroke % ways.len()] * strength);
            for _ in 0..STROKE_STEPS {
                self.world.step()?;
            }
        }
        self.push(Vector3::zeros());
        self.settle()
    }

    /// An acceleration of all spheres from now on.
    fn push(&mut self, gravity: Vector3<f64>) {
        let (setup, state) = (self.world.setup().clone(), self.world.state().clone());
        self.world = World::resume(setup.gravity(gravity), state);
    }
}

/// A deposit's porosities: under each load, and shaken under the last.
struct PorosityHistory {
    cohesion: f64,
    seed: u64,
    loaded: [f64; FACTORS.len()],
    shaken: f64,
    at_rest: bool,
}

impl PorosityHistory {
    fn run(system: System, cohesion: f64, seed: u64) -> Result<Self> {
        let mut packing = Packing::new(system, cohesion, seed)?;
        let (first, mut at_rest) = (FIRST * packing.area, true);
        let mut loaded = [0.0; FACTORS.len()];
        for (porosity, factor) in loaded.iter_mut().zip(FACTORS) {
            packing.load(first * factor);
            at_rest &= packing.settle()?;
            *porosity = packing.porosity();
        }
        at_rest &= packing.shake()?;
        Ok(Self {
            cohesion,
            seed,
            loaded,
            shaken: packing.porosity(),
            at_rest,
        })
    }

    /// How much three decades of load take off the porosity.
    fn by_load(&self) -> f64 {
        let [first, .., last] = self.loaded;
        first - last
    }

    /// How much shaking takes off it.
    fn by_shaking(&self) -> f64 {
        let [.., last] = self.loaded;
        last - self.shaken
    }
}

/// Porosity over the load.
pub fn section_4_2(runs: &Runs) -> Result<Exhibit> {
    let (system, seeds) = match runs.effort() {
        Effort::Quick => (System::Tiny, 1),
        Effort::Full => (System::Small, 3),
    };
    let cases: Vec<(f64, u64)> = [0.0, 1.0]
        .into_iter()
        .flat_map(|cohesion| (1..=seeds).map(move |seed| (cohesion, seed)))
        .collect();
    let threads = available_parallelism().map_or(1, NonZero::get);
    let courses = in_order(cases.len(), threads, |index| {
        let (cohesion, seed) = cases[index];
        PorosityHistory::run(system, cohesion, seed)
    });
    let courses: Vec<PorosityHistory> = courses
        .into_iter()
        .map(|course| course.ok_or_else(|| anyhow!("a course was lost"))?)
        .collect::<Result<_>>()?;
    let rows = courses.iter().flat_map(|course| {
        let line = |(factor, porosity): (f64, f64)| {
            vec![
                course.cohesion,
                course.seed as f64,
                factor * FIRST,
                porosity,
                course.shaken,
            ]
        };
        FACTORS
            .into_iter()
            .zip(course.loaded)
            .map(line)
            .collect::<Vec<_>>()
    });
    let rows = rows.collect();
    let (dry, sticky) = courses.split_at(seeds as usize);
    Ok(Exhibit::new(
        TEXT.prose_of(runs.effort()).with("system", system.name()),
        figure(&courses),
        &[
            "cohesion",
            "seed",
            "pressure",
            "porosity",
            "porosity_shaken",
        ],
        rows,
        claims(dry, sticky),
    )
    .seeded(1..=seeds))
}

fn figure(courses: &[PorosityHistory]) -> Figure {
    let y = Axis::linear("porosity");
    let figure = Figure::new("", Axis::log10("pressure [F_coh/R²]"), y);
    let figure = courses
        .iter()
        .filter(|course| course.seed == 1)
        .fold(figure, |figure, course| {
            let name = if course.cohesion > 0.0 {
                "cohesion"
            } else {
                "no cohesion"
            };
            let curve = FACTORS
                .iter()
                .map(|factor| factor * FIRST)
                .zip(course.loaded);
            let last = FACTORS[FACTORS.len() - 1] * FIRST;
            figure
                .series(Series::line_points(name, curve.collect()))
                .series(Series::points(
                    format!("{name}, shaken"),
                    vec![(last, course.shaken)],
                ))
        });
    figure.guide(ReferenceLine::vertical(1.0, ""))
}

/// Most of some numbers, and least.
fn range(values: impl Iterator<Item = f64> + Clone) -> [f64; 2] {
    [
        values.clone().fold(f64::INFINITY, f64::min),
        values.fold(f64::NEG_INFINITY, f64::max),
    ]
}

/// "0.1 points", "1.2 to 1.4 points".
fn points([least, most]: [f64; 2]) -> String {
    let (least, most) = (
        format!("{:.1}", 100.0 * least),
        format!("{:.1}", 100.0 * most),
    );
    if least == most {
        format!("{most} points")
    } else {
        format!("{least} to {most} points")
    }
}

fn claims(dry: &[PorosityHistory], sticky: &[PorosityHistory]) -> Vec<Claim> {
    let load = |courses: &[PorosityHistory]| range(courses.iter().map(PorosityHistory::by_load));
    let shaken = range(dry.iter().map(PorosityHistory::by_shaking));
    let (free, bound) = (load(dry), load(sticky));
    let all = dry.iter().chain(sticky);
    let resting = all.clone().filter(|course| course.at_rest).count();
    let first = |courses: &[PorosityHistory]| range(courses.iter().map(|course| course.loaded[0]));
    let (loose, dense) = (first(sticky), first(dry));
    vec![
        Claim::trend(
            TEXT.said("load"),
            format!("falls by {}", points(free)),
            free[1] < 0.01 && free[0] > -0.01,
        ),
        Claim::trend(
            TEXT.said("shaking"),
            format!("falls by {}", points(shaken)),
            shaken[0] > 0.01 && shaken[0] > free[1],
        ),
        Claim::trend(
            TEXT.said("cohesion"),
            format!(
                "{:.1} % against {:.1} % without",
                100.0 * loose[0],
                100.0 * dense[1]
            ),
            loose[0] > dense[1] + 0.1,
        ),
        Claim::trend(
            TEXT.said("threshold"),
            format!("falls by {}", points(bound)),
            bound[0] > 0.1,
        ),
        Claim::own_statement(
            TEXT.said("rest"),
            format!("{resting} of {}", all.count()),
            resting == dry.len() + sticky.len(),
        ),
    ]
}
