//! The launch for a wanted rest pose is found, all of them and no other.

use std::f64::consts::{FRAC_PI_2, PI, TAU};
use std::num::NonZeroU32;
use tribos::slide::inverse::{InverseError, Launch, Limits, Pose, RestMap, Solution, Turns};
use tribos_core::coupling::closed::{FlatPunch, Hertz, Ring};
use tribos_core::coupling::round::RoundTable64;
use tribos_core::coupling::table::{Coulomb, Table64};
use tribos_core::coupling::{Annulus, Coupling, Profile};
use tribos_core::patch::PowerPressure;
use tribos_core::slider::{Motion, Slider};
use tribos_tests::pucks::{MU_G, RADIUS};
use tribos_tests::sweep::Lcg;
use tribos_tests::tolerance;
use tribos_tests::worst::Worst;

/// Any law and pressure.
trait Law: Profile<f64> + Coupling<f64> {}
impl<P: Profile<f64> + Coupling<f64>> Law for P {}

type Bodies = Vec<(String, Box<dyn Law>)>;

const PRESSURES: [(&str, PowerPressure); 4] = [
    ("ring", PowerPressure::RING),
    ("punch", PowerPressure::FLAT_PUNCH),
    ("Hertz", PowerPressure::HERTZ),
    ("paraboloid", PowerPressure::PARABOLOID),
];

/// Ratios of inertia whose final mode is spinning, both or sliding.
const INERTIAS: [f64; 3] = [0.15, 0.6, 2.4];

/// Every pressure under |v|^`alpha`.
fn bodies(alpha: f64) -> Bodies {
    let disk = Table64::new(alpha).unwrap();
    let mut all: Bodies = vec![
        ("disk".into(), Box::new(disk)),
        ("annulus".into(), Box::new(Annulus::new(disk, 0.6).unwrap())),
    ];
    for (name, pressure) in PRESSURES {
        all.push((
            name.into(),
            Box::new(RoundTable64::new(alpha, pressure).unwrap()),
        ));
    }
    if alpha == 0.0 {
        all.push(("closed ring".into(), Box::new(Ring)));
        all.push(("closed punch".into(), Box::new(FlatPunch)));
        all.push(("closed Hertz".into(), Box::new(Hertz)));
    }
    all
}

fn disk() -> RestMap<Coulomb> {
    RestMap::new(Coulomb, MU_G, RADIUS, 0.5).unwrap()
}

fn modulo(symmetry: u32) -> Turns {
    Turns::Modulo {
        symmetry: NonZeroU32::new(symmetry).unwrap(),
    }
}

/// Distance of two poses, in m and rad.
fn miss(got: &Pose, wanted: &Pose) -> f64 {
    let place = (got.x - wanted.x).hypot(got.y - wanted.y);
    place.max((got.angle - wanted.angle).abs())
}

#[test]
fn random_launches_are_found_again() {
    let mut rng = Lcg::new(71);
    let names = ["pose of a solution", "its time", "launch found again"];
    let [mut pose, mut time, mut launch_error] = names.map(Worst::of);
    for alpha in [-0.5, 0.0, 0.5, 0.9] {
        for (name, law) in bodies(alpha) {
            for inertia in INERTIAS {
                let map = RestMap::new(law.as_ref(), MU_G, RADIUS, inertia).unwrap();
                for launch in 0..13 {
                    let speed = rng.log_between(0.05, 3.0);
                    let spin =
                        rng.log_between(0.5, 60.0) * if rng.unit() < 0.5 { -1.0 } else { 1.0 };
                    let course = rng.between(-PI, PI);
                    let thrown = Launch {
                        velocity: [speed * course.cos(), speed * course.sin()],
                        spin,
                    };
                    let target = map.rest(&thrown).pose;
                    let limits = Limits::new(1.01 * speed, 1.01 * spin.abs()).unwrap();
                    // Most by their total angle, some with every number of turns.
                    let turns = if launch < 2 { modulo(1) } else { Turns::Exact };
                    let solutions = map.launches(&target, turns, &limits).unwrap();
                    let place = || format!("{name}, alpha {alpha}, C {inertia}, {thrown:?}");
                    for solution in &solutions {
                        let end = map.rest(&solution.launch);
                        let wanted = Pose {
                            angle: solution.angle,
                            ..target
                        };
                        let turns = (solution.angle - target.angle) / TAU;
                        assert!((turns - turns.round()).abs() < 1e-12);
                        pose.see(miss(&end.pose, &wanted), place);
                        time.see((end.time / solution.time - 1.0).abs(), place);
                    }
                    let distance = |found: &Solution| {
                        let [x, y] = found.launch.velocity;
                        let slide = (x - thrown.velocity[0]).hypot(y - thrown.velocity[1]);
                        slide.max((found.launch.spin - spin).abs() * RADIUS)
                            / speed.hypot(spin * RADIUS)
                    };
                    let nearest = solutions.iter().map(distance).fold(f64::INFINITY, f64::min);
                    launch_error.see(nearest, place);
                }
            }
        }
    }
    time.assert_within(&tolerance::INVERSE_POSE);
    pose.assert_within(&tolerance::INVERSE_POSE);
    launch_error.assert_within(&tolerance::INVERSE_LAUNCH);
}

#[test]
fn the_map_is_the_slider_s_own() {
    let puck = Slider::new(Coulomb, MU_G, RADIUS, 0.5).unwrap();
    for (speed, spin) in [(1.0, 5.0), (0.2, -40.0), (0.0, 7.0), (2.0, 0.0)] {
        let rest = puck.to_rest(&Motion::launched(speed, spin)).unwrap().motion;
        let landing = disk().rest(&Launch {
            velocity: [-speed, 0.0],
            spin,
        });
        assert!((landing.pose.x + rest.distance).abs() <= 1e-14 * rest.distance);
        assert!((landing.pose.angle - rest.angle).abs() <= 1e-14 * rest.angle.abs());
        assert!((landing.time - rest.time).abs() <= 1e-14 * rest.time);
    }
}

/// ∂(x, y, angle)/∂ component by central differences extrapolated twice (order 6).
fn richardson(map: &RestMap<&dyn Law>, at: &Launch, component: usize, step: f64) -> [f64; 3] {
    let pose = |h: f64| {
        let mut launch = *at;
        match component {
            2 => launch.spin += h / RADIUS,
            _ => launch.velocity[component] += h,
        }
        let Pose { x, y, angle } = map.rest(&launch).pose;
        [x, y, angle]
    };
    let unit = if component == 2 { RADIUS } else { 1.0 };
    let central = |h: f64| {
        let (ahead, behind) = (pose(h), pose(-h));
        [0, 1, 2].map(|i| (ahead[i] - behind[i]) / (2.0 * h) * unit)
    };
    let [coarse, middle, fine] = [step, step / 2.0, step / 4.0].map(central);
    [0, 1, 2].map(|i| {
        let first = (4.0 * middle[i] - coarse[i]) / 3.0;
        let second = (4.0 * fine[i] - middle[i]) / 3.0;
        (16.0 * second - first) / 15.0
    })
}

#[test]
fn the_jacobian_is_that_of_extrapolated_differences() {
    let mut rng = Lcg::new(5);
    let mut worst = Worst::of("Jacobian of the rest pose");
    let mut equal = Worst::of("Jacobian of the rest pose at equal speeds");
    for alpha in [-0.5, 0.0, 0.5, 0.9] {
        for (name, law) in bodies(alpha) {
            for inertia in INERTIAS {
                let map = RestMap::new(law.as_ref(), 1.0, RADIUS, inertia).unwrap();
                let fixed = tribos_core::modes::Modes::new(law.as_ref(), inertia).unwrap();
                let mut ratios: Vec<f64> = (0..3).map(|_| rng.log_between(0.02, 50.0)).collect();
                if let Some(ratio) = fixed.finite_fixed_point() {
                    ratios.extend([1.0, 1.0 + 1e-9, 1.0 - 1e-5, 1.003, 0.96].map(|f| f * ratio));
                }
                for ratio in ratios {
                    let (sin, cos) = rng.between(-PI, PI).sin_cos();
                    let s = ratio.hypot(1.0);
                    let at = Launch {
                        velocity: [ratio / s * cos, ratio / s * sin],
                        spin: -1.0 / s / RADIUS,
                    };
                    let jacobian = map.jacobian(&at);
                    let step = 4e-3 * ratio.min(1.0) / s;
                    for component in 0..3 {
                        let wanted = richardson(&map, &at, component, step);
                        // Angles in units of the rim's path.
                        let unit = if component == 2 { RADIUS } else { 1.0 };
                        for row in 0..3 {
                            let length = if row == 2 { RADIUS } else { 1.0 };
                            let error = (jacobian[row][component] - wanted[row]) * length / unit;
                            let place = || {
                                format!(
                                    "{name}, alpha {alpha}, C {inertia}, v/(wR) {ratio}, {row} by {component}: {} {}",
                                    jacobian[row][component], wanted[row]
                                )
                            };
                            if (ratio - 1.0).abs() > 0.05 {
                                if error.abs() > 1e-9 {
                                    println!("{:.1e} {}", error.abs(), place());
                                }
                                worst.see(error.abs(), place)
                            } else {
                                equal.see(error.abs(), place)
                            }
                        }
                    }
                }
            }
        }
    }
    equal.assert_within(&tolerance::INVERSE_JACOBIAN_EQUAL);
    worst.assert_within(&tolerance::INVERSE_JACOBIAN);
}
