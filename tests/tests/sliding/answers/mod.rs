//! The reference answers for other programs, in `answers/`, are what the kernel computes, to 12 digits.

mod feet;
mod later;
mod march;
mod pinned;
mod sheet;

use feet::Standing;
use sheet::Sheet;
use std::collections::HashMap;
use tribos::cd::{Wall, World, WorldMaterials, WorldSetup, solid};
use tribos::friction::FlatPatch;
use tribos::slide::planar::{Launch, PlanarResult, PlanarSimulation, Resistance, TallCylinder};
use tribos_core::contact::{Cohesion, IndependentFriction, NormalLaw, SphereBody};
use tribos_core::coupling::coulomb::CoulombDisk;
use tribos_core::coupling::coulomb::CoulombRing;
use tribos_core::limit_surface::{FrictionSet, ShapeLimitSurface};
use tribos_core::nalgebra::Vector3;
use tribos_core::patch::bar::Bar;
use tribos_core::slider::{Slider, SliderParameters, SliderRest, SliderState};
use tribos_core::twist::Wrench;
use tribos_tests::tables::Table;

/// Digits of the answers that are promised.
const CLOSE: f64 = 1e-12;

/// Parameters of a scene.
#[derive(Clone, Debug, Default)]
struct Problem(HashMap<String, String>);

impl Problem {
    fn number(&self, parameter: &str) -> f64 {
        self.0[parameter].parse().expect("a number")
    }

    /// Numbered places: corners, ends or feet.
    fn places(&self, name: &str) -> Vec<[f64; 2]> {
        (1..)
            .map_while(|i| {
                let key = format!("{name}_{i}_x");
                self.0
                    .contains_key(&key)
                    .then(|| [self.number(&key), self.number(&format!("{name}_{i}_y"))])
            })
            .collect()
    }
}

fn problems() -> HashMap<String, Problem> {
    let mut problems = HashMap::<String, Problem>::new();
    for row in Table::read("../answers/v1/problems.csv").rows() {
        let problem = problems.entry(row.text("scene").to_owned()).or_default();
        let [parameter, value] = ["parameter", "value"].map(|column| row.text(column).to_owned());
        problem.0.insert(parameter, value);
    }
    problems
}

/// The quantities of a motion: along, left, turn, stop.
fn arrived(body: &impl Resistance, problem: &Problem, spin: f64) -> Vec<f64> {
    let velocity = [problem.number("speed"), 0.0];
    let journey = PlanarSimulation::new(body, &Launch { velocity, spin }, 1e-4).expect("a launch");
    let PlanarResult { point, .. } = journey.to_end().expect("a rest");
    let [along, left] = point.position;
    vec![along, left, point.angle, point.time]
}

fn round(problem: &Problem, spin: f64, is_ring: bool) -> Vec<f64> {
    let radius = problem.number("radius");
    let parameters = SliderParameters {
        deceleration: problem.number("mu") * problem.number("g"),
        radius,
        inertia_ratio: problem.number("gyration_sq") / (radius * radius),
    };
    let launch = SliderState::launched(problem.number("speed"), spin);
    let rest = if is_ring {
        Slider::new(CoulombRing, parameters)
            .expect("a ring")
            .to_rest(&launch)
    } else {
        Slider::new(CoulombDisk, parameters)
            .expect("a disk")
            .to_rest(&launch)
    };
    let SliderRest { motion, .. } = rest.expect("a rest");
    vec![motion.distance, 0.0, motion.angle, motion.time]
}

/// A thin body with this outline and uniform mass; the patch is a box or a bar with these half sides.
fn sheet(problem: &Problem, patch: FlatPatch, [x, y]: [f64; 2], spin: f64) -> Vec<f64> {
    let patch = patch.loaded(None).expect("a patch");
    let law = ["mu", "g"].map(|name| problem.number(name));
    let sheet = Sheet::new(patch, law, (x * x + y * y) / 3.0);
    march::to_rest(&sheet, problem.number("speed"), spin)
}

fn tall(problem: &Problem, spin: f64) -> Vec<f64> {
    let cylinder = TallCylinder {
        height: 2.0 * problem.number("height"),
        ..TallCylinder::solid(problem.number("mu"), problem.number("radius"))
    };
    let body = cylinder.body(problem.number("g")).expect("a cylinder");
    arrived(&body, problem, spin)
}

/// Speed at the end of contact dynamics; time and distance follow from momentum and energy.
fn ball(problem: &Problem, spin: f64) -> Vec<f64> {
    let [mu, g, radius, speed] = ["mu", "g", "radius", "speed"].map(|name| problem.number(name));
    let ball = SphereBody {
        velocity: Vector3::x() * speed,
        spin: Vector3::y() * spin,
        ..solid(radius, 1700.0)
    };
    let normal = NormalLaw::new(Cohesion::NONE, 0.0).expect("a law");
    let laws = WorldMaterials::uniform(
        normal,
        IndependentFriction::sliding(mu).expect("a coefficient"),
    );
    let up = Vector3::z();
    let table = WorldSetup::new(laws)
        .wall(Wall::fixed(up, 0.0))
        .gravity(up * -g);
    let mut world = World::new(table.sphere(up * radius, radius, ball)).expect("a world");
    for _ in 0..1000 {
        world.step().expect("a step");
    }
    let rolling = world.state().spheres[0].velocity.x;
    let slowing = mu * g * (speed - rolling).signum();
    let time = (speed - rolling) / slowing;
    vec![rolling, time, 0.5 * (speed + rolling) * time]
}

/// A load inside the limit surface is held without creep.
fn capsule(problem: &Problem) -> Vec<f64> {
    let half = 0.5 * problem.number("length");
    let line = Bar::new([-half, 0.0], [half, 0.0]).expect("a line");
    let limit = 2.0 * problem.number("mu") * problem.number("grip");
    let surface = ShapeLimitSurface::new(line, limit).expect("a surface");
    let weight = problem.number("mass") * problem.number("g");
    let lever = problem.number("offset");
    let [middle, off, torque] = [
        Wrench::new(0.0, -weight, 0.0),
        Wrench::new(0.0, -weight, -weight * lever),
        Wrench::new(0.0, 0.0, 1.0),
    ]
    .map(|push| 1.0 / surface.gauge(&push));
    let creep = if off > 1.0 { 0.0 } else { f64::NAN };
    vec![creep, middle, off, torque]
}

fn computed(scene: &str, problem: &Problem, spin: f64) -> Vec<f64> {
    match scene {
        "puck" | "spin_down" => round(problem, spin, false),
        "ring" => round(problem, spin, true),
        "box" | "plank" => {
            let [x, y] = problem.places("corner")[0];
            sheet(problem, FlatPatch::Box([2.0 * x, 2.0 * y]), [x, y], spin)
        }
        "bar" => {
            let [x, _] = problem.places("end")[0];
            sheet(problem, FlatPatch::Bar(2.0 * x), [x, 0.0], spin)
        }
        "tripod" | "three_ball" | "three_ball_low" => {
            march::to_rest(&standing(problem), problem.number("speed"), spin)
        }
        "tall" => tall(problem, spin),
        "ball" => ball(problem, spin),
        "capsule" => capsule(problem),
        other => panic!("no scene {other}"),
    }
}

fn standing(problem: &Problem) -> Standing {
    let feet = problem.places("foot");
    Standing {
        feet: feet.try_into().expect("three feet"),
        mu: problem.number("mu"),
        gravity: problem.number("g"),
        height: problem.number("height"),
        gyration_sq: problem.number("gyration_sq"),
    }
}

/// Relative deviation; displacements relative to the whole one.
fn deviation(wanted: &[f64], got: &[f64], place: usize) -> f64 {
    let is_motion = wanted.len() == 4 && wanted[0] != 0.0;
    let unit = if is_motion && place < 2 {
        wanted[0].hypot(wanted[1])
    } else {
        wanted[place].abs()
    };
    let off = (got[place] - wanted[place]).abs();
    // What is nothing by symmetry.
    if unit == 0.0 { off } else { off / unit }
}

#[test]
fn the_kernel_computes_the_reference_answers_to_12_digits() {
    let problems = problems();
    let table = Table::read("../answers/v1/answers.csv");
    let rows: Vec<_> = table.rows().collect();
    let launch = |row: &tribos_tests::tables::Row<'_>| {
        (
            row.text("scene").to_owned(),
            row.text("spin_rad_s").to_owned(),
        )
    };
    let mut missed = Vec::new();
    for answers in rows.chunk_by(|a, b| launch(a) == launch(b)) {
        let (scene, spin) = launch(&answers[0]);
        let wanted: Vec<_> = answers.iter().map(|row| row.number("value")).collect();
        let got = computed(&scene, &problems[&scene], spin.parse().expect("a spin"));
        assert_eq!(wanted.len(), got.len(), "{scene} at {spin}");
        for (place, row) in answers.iter().enumerate() {
            let off = deviation(&wanted, &got, place);
            let what = format!("{scene} at {spin}, {}: {off:.1e}", row.text("quantity"));
            println!("{what}");
            // NaN is no agreement.
            let agrees = off <= CLOSE;
            if !agrees {
                missed.push(what);
            }
        }
    }
    assert!(missed.is_empty(), "{missed:#?}");
    let launches: usize = problems
        .values()
        .map(|problem| problem.0["spins"].split(' ').count())
        .sum();
    assert_eq!(
        rows.chunk_by(|a, b| launch(a) == launch(b)).count(),
        launches
    );
}
