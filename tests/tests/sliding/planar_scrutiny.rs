//! Bodies on a path in the plane: the motion that dies first, ends that are located, recording.

use tribos::scene::{CylinderScene, Scene, vocabulary};
use tribos::slide::MotionError;
use tribos::slide::planar::{
    Launch, PlanarResult, PlanarSimulation, PlanarState, Resistance, SlideStopReason,
};
use tribos::slide::planar::{TallBody, TallCylinder};
use tribos::slide::{PlanarScene, follow_path};
use tribos_core::coupling::coulomb::CoulombDisk;
use tribos_core::coupling::table::DiskTable64;
use tribos_core::coupling::{PowerLawFriction, ReducedFriction};
use tribos_core::modes::{TerminalMode, TerminalMotion};
use tribos_core::slider::{Slider, SliderParameters, SliderRest, SliderState};
use tribos_tests::tolerance;
use tribos_tests::worst::Worst;

const MU: f64 = 0.2;
const GRAVITY: f64 = 9.81;
const RADIUS: f64 = 0.08;

fn cylinder(alpha: f64, inertia_ratio: f64, height: f64) -> TallBody {
    let cylinder = TallCylinder {
        alpha,
        inertia_ratio,
        height,
        ..TallCylinder::solid(MU, RADIUS)
    };
    cylinder.body(GRAVITY).expect("in range")
}

fn end(body: &impl Resistance, speed: f64, spin: f64) -> Result<PlanarResult, MotionError> {
    let launch = Launch {
        velocity: [speed, 0.0],
        spin,
    };
    PlanarSimulation::new(body, &launch, 1e-4)?.to_end()
}

fn off(got: f64, wanted: f64) -> f64 {
    (got - wanted).abs() / wanted.abs()
}

#[test]
fn a_slow_slide_under_a_fast_spin_goes_as_its_linear_law() {
    // To first order in z' = v_x + i v_y the gradient l = -lambda f and the force f (of mu N) are
    // linear: f = -z'/w + i (lambda/3) f, the rim slows down with (2/3) mu g/C, and so
    // z' falls as w^p with p = (3 C/2)/(1 - i lambda/3).
    let mut worst = Worst::of("slow slide of a tall body - linear law");
    let spin = 12.5;
    let rim = spin * RADIUS;
    for (c, height, speed) in [
        (1000.0, 0.0, 1e-8),
        (1000.0, 0.16, 1e-8),
        (1000.0, 0.16, 1e-12),
        (100.0, 0.1, 1e-9),
        (10.0, 0.16, 1e-8),
        (1.0, 0.16, 1e-9),
    ] {
        let lean = 4.0 * MU * (0.5 * height) / RADIUS;
        let norm = 1.0 + lean * lean / 9.0;
        let [re, im] = [1.5 * c / norm, 1.5 * c * lean / 3.0 / norm];
        let reach = speed * c * rim / (2.0 / 3.0 * MU * GRAVITY);
        let size = (re + 1.0) * (re + 1.0) + im * im;
        let wanted = [
            reach * (re + 1.0) / size,
            -reach * im / size,
            reach / (re + 1.0),
            rim * rim * c / (4.0 / 3.0 * MU * GRAVITY * RADIUS),
            rim * c / (2.0 / 3.0 * MU * GRAVITY),
        ];
        let got = end(&cylinder(0.0, c, height), speed, spin)
            .expect("it rests")
            .point;
        let [x, y] = got.position;
        let got = [x, y, got.distance, got.angle, got.time];
        for (part, (got, wanted)) in got.into_iter().zip(wanted).enumerate() {
            let error = if wanted == 0.0 {
                got.abs() / reach
            } else {
                off(got, wanted)
            };
            worst.see(error, || format!("C {c}, H {height}, v {speed}: {part}"));
        }
    }
    worst.assert_within(&tolerance::MINOR_MOTION);
}

#[test]
fn a_slow_spin_under_a_fast_slide_goes_as_its_linear_law() {
    // To first order in w the torque is -(w/v)/4 (1 - lambda^2/4) mu N R, its second term from the
    // gradient across, and the force across -(lambda/4)(w/v) mu N: w falls as v^q.
    let mut worst = Worst::of("slow spin of a tall body - linear law");
    let speed = 1.0;
    for (c, height, spin) in [
        (0.001, 0.16, 1e-8),
        (0.001, 0.16, 1e-12),
        (0.01, 0.1, 1e-9),
        (0.1, 0.16, 1e-8),
        (0.5, 0.16, 1e-9),
        (0.5, 0.0, 1e-9),
    ] {
        let lean = 4.0 * MU * (0.5 * height) / RADIUS;
        let q = (1.0 - 0.25 * lean * lean) / (4.0 * c);
        let rim = spin * RADIUS;
        let wanted = [
            speed * speed / (2.0 * MU * GRAVITY),
            -lean * rim * speed / (8.0 * MU * GRAVITY * (q + 1.0)),
            spin * speed / (MU * GRAVITY * (q + 1.0)),
            speed / (MU * GRAVITY),
        ];
        let got = end(&cylinder(0.0, c, height), speed, spin)
            .expect("it rests")
            .point;
        let got = [got.position[0], got.position[1], got.angle, got.time];
        for (part, (got, wanted)) in got.into_iter().zip(wanted).enumerate() {
            let error = if wanted == 0.0 {
                got.abs()
            } else {
                off(got, wanted)
            };
            worst.see(error, || format!("C {c}, H {height}, spin {spin}: {part}"));
        }
    }
    worst.assert_within(&tolerance::MINOR_MOTION);
}

fn rest<P: PowerLawFriction<f64> + ReducedFriction<f64>>(
    profile: P,
    c: f64,
    speed: f64,
    spin: f64,
) -> (SliderRest<f64>, TerminalMode<f64>) {
    let slider = Slider::new(
        profile,
        SliderParameters {
            deceleration: MU * GRAVITY,
            radius: RADIUS,
            inertia_ratio: c,
        },
    )
    .expect("in range");
    let start = SliderState::launched(speed, spin);
    let modes = TerminalMotion::new(slider.profile(), c).expect("in range");
    let mode = modes.terminal_mode(slider.ratio(&start));
    (slider.to_rest(&start).expect("it rests"), mode)
}

fn flat(alpha: f64, c: f64, speed: f64, spin: f64) -> (SliderRest<f64>, TerminalMode<f64>) {
    if alpha == 0.0 {
        rest(CoulombDisk, c, speed, spin)
    } else {
        let table = DiskTable64::new(alpha).expect("in range");
        rest(table, c, speed, spin)
    }
}

#[test]
fn an_upright_body_ends_as_a_flat_slider_whatever_dies_first() {
    let mut worst = Worst::of("upright body - flat slider");
    for alpha in [-0.5, 0.0, 0.5, 0.9] {
        for c in [1e-3, 0.1, 0.5, 10.0, 1e3] {
            for (speed, spin) in [(1.0, 5.0), (1e-8, 12.5), (1.0, 1e-8), (1e-12, 12.5)] {
                let (wanted, _) = flat(alpha, c, speed, spin);
                let got = end(&cylinder(alpha, c, 0.0), speed, spin)
                    .expect("it rests")
                    .point;
                for (name, got, wanted) in [
                    ("time", got.time, wanted.motion.time),
                    ("distance", got.distance, wanted.motion.distance),
                    ("angle", got.angle, wanted.motion.angle),
                ] {
                    let place = || format!("alpha {alpha}, C {c}, v {speed}, spin {spin}: {name}");
                    worst.see(off(got, wanted), place);
                }
            }
        }
    }
    worst.assert_within(&tolerance::MINOR_MOTION);
}

#[test]
fn near_the_law_that_never_rests_time_and_ratio_find_their_ends() {
    for alpha in [0.99, 0.999, 0.999_999_9] {
        for c in [0.3, 0.5, 0.8] {
            let (wanted, mode) = flat(alpha, c, 1.0, 5.0);
            let got = end(&cylinder(alpha, c, 0.0), 1.0, 5.0)
                .unwrap_or_else(|error| panic!("alpha {alpha}, C {c}: {error}"));
            let place = format!("alpha {alpha}, C {c}: {got:?}, {wanted:?}, {mode:?}");
            let allowed = tolerance::MINOR_MOTION.limit / (1.0 - alpha);
            assert!(
                off(got.point.time, wanted.motion.time) < allowed.min(1e-6),
                "{place}"
            );
            match mode {
                TerminalMode::Together { ratio } => {
                    assert!(off(got.point.ratio, ratio) < allowed.min(1e-4), "{place}");
                }
                TerminalMode::Spinning => assert!(got.point.ratio < 1e-9, "{place}"),
                TerminalMode::Sliding => assert!(got.point.ratio > 1e9, "{place}"),
            }
        }
    }
}

#[test]
fn scales_that_are_far_apart_need_no_more_steps() {
    for (c, speed, spin) in [(1e5, 1e-8, 12.5), (1e6, 1.0, 5.0), (1e-6, 1.0, 5.0)] {
        let (wanted, _) = flat(0.0, c, speed, spin);
        let got = end(&cylinder(0.0, c, 0.0), speed, spin).expect("it rests");
        let worst = off(got.point.time, wanted.motion.time)
            .max(off(got.point.distance, wanted.motion.distance))
            .max(off(got.point.angle, wanted.motion.angle));
        assert!(worst < 1e-11, "C {c}: {worst:e}");
        assert!(got.steps < 20_000, "C {c}: {} steps", got.steps);
    }
}

/// A disk on oil whose spin fades with another rate.
#[derive(Debug)]
struct Oiled;

impl Resistance for Oiled {
    fn deceleration(&self, [x, y, w]: [f64; 3]) -> [f64; 3] {
        [2.0 * x, 2.0 * y, 2.5 * w]
    }
    fn exponent(&self) -> f64 {
        1.0
    }
    fn inertia_ratio(&self) -> f64 {
        0.5
    }
    fn radius(&self) -> f64 {
        RADIUS
    }
}

#[test]
fn a_fading_motion_ends_where_the_slower_one_has_faded() {
    for fraction in [0.3, 1e-2, 1e-4, 1e-9] {
        let launch = Launch {
            velocity: [1.0, 0.0],
            spin: 5.0,
        };
        let journey = PlanarSimulation::new(&Oiled, &launch, fraction).expect("in range");
        let got = journey.to_end().expect("it fades");
        assert_eq!(got.ending, SlideStopReason::Faded);
        let time = -f64::ln(fraction) / 2.0;
        assert!(off(got.point.time, time) < 1e-11, "{fraction}: {got:?}");
        let way = 0.5 * (1.0 - fraction);
        assert!(off(got.point.distance, way) < 1e-11, "{fraction}: {got:?}");
        assert!(off(got.point.velocity[0], fraction) < 1e-10);
    }
}

#[test]
fn tipping_begins_where_the_gradient_reaches_its_limit() {
    // A spinning body slides more and more against friction, and leans the more.
    let body = cylinder(0.0, 0.5, 0.4);
    let launch = Launch {
        velocity: [0.2, 0.0],
        spin: 20.0,
    };
    let journey = || PlanarSimulation::new(&body, &launch, 1e-4).expect("in range");
    let tips_at = journey().to_end().expect("held").tips_at.expect("it tips");
    let mut seen: Vec<PlanarState> = Vec::new();
    let times = [tips_at * (1.0 - 1e-9), tips_at * (1.0 + 1e-9)];
    journey()
        .follow(&times, |point| seen.push(*point))
        .expect("held");
    let lean_at = |time: f64| {
        seen.iter()
            .find(|point| (point.time - time).abs() < 1e-12 * time)
    };
    let [before, after] = times.map(|time| lean_at(time).expect("seen").lean);
    assert!(
        tips_at > 0.0 && before < 1.0 && after > 1.0,
        "{before} {after}"
    );
    assert!(after - before < 1e-6);
}

#[test]
fn what_is_recorded_leaves_the_end_as_it_is() {
    for (body, overrides) in [
        ("cylinder", &[][..]),
        ("cylinder", &["alpha=1.5"]),
        ("pipe", &["alpha=0.3"]),
        ("curling", &["model=scratch-guide"]),
        ("curling", &["model=pivot-slide"]),
        ("curling", &["model=film"]),
    ] {
        let ends = [1, 7, 300].map(|samples| {
            let text = vocabulary(body).expect("known").least_text();
            let samples = format!("samples={samples}");
            let all: Vec<String> = overrides
                .iter()
                .map(|item| (*item).to_owned())
                .chain([samples])
                .collect();
            let scene = Scene::parse("body.toml", &text, &all).expect("in range");
            let scene: &dyn PlanarScene = match &scene {
                Scene::Cylinder(scene) => scene,
                Scene::Pipe(scene) => scene,
                Scene::Curling(scene) => scene,
                other => unreachable!("{other:?}"),
            };
            let outcome = follow_path(scene, &mut |_| true).expect("it ends").outcome;
            (outcome, outcome.energy_error)
        });
        assert_eq!(ends[0], ends[1], "{body} {overrides:?}");
        assert_eq!(ends[0], ends[2], "{body} {overrides:?}");
        assert!(ends[0].1 < 1e-8, "{body} {overrides:?}: {:e}", ends[0].1);
    }
}

#[test]
fn launches_outside_the_range_of_numbers_are_refused() {
    let usual = CylinderScene {
        speed: 1.0,
        ..CylinderScene::default()
    };
    let slow = CylinderScene {
        speed: 1e-300,
        spin: 0.0,
        ..usual
    };
    let fast = CylinderScene {
        speed: 1e160,
        ..slow
    };
    let wide = CylinderScene {
        radius: 1e300,
        ..usual
    };
    for scene in [slow, fast, wide] {
        let refused = scene.run();
        assert!(
            matches!(refused, Err(MotionError::Energy { .. })),
            "{scene:?}: {refused:?}"
        );
    }
}
