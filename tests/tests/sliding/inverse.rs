//! The launch for a wanted rest pose is found, all of them and no other.

use std::f64::consts::{PI, TAU};
use std::num::NonZeroU32;
use tribos::slide::inverse::{
    Launch, LaunchLimits, LaunchSolution, MotionError, Pose, RestMap, Turns,
};
use tribos_core::coupling::coulomb::{CoulombDisk, CoulombHertz, CoulombPunch, CoulombRing};
use tribos_core::coupling::round::RoundTable64;
use tribos_core::coupling::table::DiskTable64;
use tribos_core::coupling::{Annulus, PowerLawFriction, ReducedFriction};
use tribos_core::patch::PowerPressure;
use tribos_core::slider::{Slider, SliderParameters, SliderState};
use tribos_tests::pucks::{MU_G, RADIUS};
use tribos_tests::sweep::Lcg;
use tribos_tests::tolerance;
use tribos_tests::worst::Worst;

/// Any law and pressure.
trait Law: PowerLawFriction<f64> + ReducedFriction<f64> {}
impl<P: PowerLawFriction<f64> + ReducedFriction<f64>> Law for P {}

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
    let disk = DiskTable64::new(alpha).unwrap();
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
        all.push(("form ring".into(), Box::new(CoulombRing)));
        all.push(("form punch".into(), Box::new(CoulombPunch)));
        all.push(("form Hertz".into(), Box::new(CoulombHertz)));
    }
    all
}

fn disk() -> RestMap<CoulombDisk> {
    RestMap::new(CoulombDisk, MU_G, RADIUS, 0.5).unwrap()
}

fn modulo(symmetry: u32) -> Turns {
    Turns::Modulo {
        symmetry: NonZeroU32::new(symmetry).unwrap(),
    }
}

/// Distance of two poses, of the distance covered and of the angle turned.
fn miss(got: &Pose, wanted: &Pose) -> f64 {
    let place = (got.x - wanted.x).hypot(got.y - wanted.y);
    let turn = (got.angle - wanted.angle).abs();
    assert!(place <= 1e-9 && turn <= 1e-9, "{got:?} {wanted:?}");
    let share = |error: f64, of: f64| if error == 0.0 { 0.0 } else { error / of };
    share(place, wanted.x.hypot(wanted.y)).max(share(turn, wanted.angle.abs()))
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
                    let limits = LaunchLimits::new(1.01 * speed, 1.01 * spin.abs()).unwrap();
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
                    let distance = |found: &LaunchSolution| {
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
fn paths_that_differ_by_decades_are_both_met() {
    let mut pose = Worst::of("pose of a solution, paths decades apart");
    let limits = LaunchLimits::new(1e60, 1e60).unwrap();
    for alpha in [-0.5, 0.0, 0.5] {
        for (name, law) in bodies(alpha) {
            for inertia in INERTIAS {
                let map = RestMap::new(law.as_ref(), MU_G, RADIUS, inertia).unwrap();
                for decade in -49..=49 {
                    let target = Pose {
                        x: 0.3 * 10.0_f64.powi(decade),
                        y: 0.0,
                        angle: 0.7 * 10.0_f64.powi(-decade),
                    };
                    for solution in map.launches(&target, Turns::Exact, &limits).unwrap() {
                        let end = map.rest(&solution.launch).pose;
                        let misses = (end.x / target.x - 1.0).abs();
                        let turned = (end.angle / target.angle - 1.0).abs();
                        pose.see(misses.max(turned), || {
                            format!("{name}, alpha {alpha}, C {inertia}, 1e{decade}")
                        });
                    }
                }
            }
        }
    }
    pose.assert_within(&tolerance::INVERSE_FAR);
}

#[test]
fn the_map_is_the_slider_s_own() {
    let puck = Slider::new(
        CoulombDisk,
        SliderParameters {
            deceleration: MU_G,
            radius: RADIUS,
            inertia_ratio: 0.5,
        },
    )
    .unwrap();
    for (speed, spin) in [(1.0, 5.0), (0.2, -40.0), (0.0, 7.0), (2.0, 0.0)] {
        let rest = puck
            .to_rest(&SliderState::launched(speed, spin))
            .unwrap()
            .motion;
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
                let fixed = tribos_core::modes::TerminalMotion::new(law.as_ref(), inertia).unwrap();
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
                    // Angles in units of the rim's path.
                    for (component, unit) in [1.0, 1.0, RADIUS].into_iter().enumerate() {
                        let wanted = richardson(&map, &at, component, step);
                        for (row, length) in [1.0, 1.0, RADIUS].into_iter().enumerate() {
                            let error = (jacobian[row][component] - wanted[row]) * length / unit;
                            let place =
                                || format!("{name}, alpha {alpha}, C {inertia}, v/(wR) {ratio}");
                            // Next to equal speeds the differences, not the derivatives, lose their order.
                            let worst = if (ratio - 1.0_f64).abs() > 0.05 {
                                &mut worst
                            } else {
                                &mut equal
                            };
                            worst.see(error.abs(), place);
                        }
                    }
                }
            }
        }
    }
    equal.assert_within(&tolerance::INVERSE_JACOBIAN_EQUAL);
    worst.assert_within(&tolerance::INVERSE_JACOBIAN);
}

#[test]
fn the_jacobian_is_smooth_through_pure_motions() {
    for alpha in [-0.5, 0.0, 0.5] {
        for (name, law) in bodies(alpha) {
            for inertia in INERTIAS {
                let map = RestMap::new(law.as_ref(), MU_G, RADIUS, inertia).unwrap();
                // Spin in place: the first push goes the same way in every direction.
                let spun = map.jacobian(&Launch {
                    velocity: [0.0, 0.0],
                    spin: 9.0,
                });
                let push = 1e-7;
                let nudged = map.rest(&Launch {
                    velocity: [0.6 * push, 0.8 * push],
                    spin: 9.0,
                });
                let got = [nudged.pose.x / push, nudged.pose.y / push];
                assert!(
                    (spun[0][0] / got[0] * 0.6 - 1.0).abs() < 1e-3,
                    "{name} {alpha} {inertia}"
                );
                assert_eq!(spun[0][0], spun[1][1]);
                assert_eq!([spun[0][1], spun[0][2], spun[2][0]], [0.0; 3]);
                // Without spin: closed form of the path, and the angle of a first twist.
                let slid = map.jacobian(&Launch {
                    velocity: [2.0, 0.0],
                    spin: 0.0,
                });
                let expected = 2.0_f64.powf(1.0 - alpha) / MU_G;
                assert!((slid[0][0] / expected - 1.0).abs() < 1e-13);
                let twisted = map.rest(&Launch {
                    velocity: [2.0, 0.0],
                    spin: 1e-5,
                });
                assert!(
                    (slid[2][2] / (twisted.pose.angle / 1e-5) - 1.0).abs() < 1e-3,
                    "{name}"
                );
                assert_eq!([slid[2][0], slid[0][2]], [0.0; 2]);
            }
        }
    }
    let rest = disk().jacobian(&Launch::default());
    assert_eq!(rest, [[0.0; 3]; 3]);
    let lost = disk().jacobian(&Launch {
        velocity: [f64::NAN, 0.0],
        spin: 1.0,
    });
    assert!(lost.iter().flatten().all(|x| x.is_nan()));
}

#[test]
fn pure_motions_are_inverted_in_closed_form() {
    let limits = LaunchLimits::new(5.0, 500.0).unwrap();
    // Without turning: d = v^2/(2 mu g).
    let target = Pose {
        x: -0.3,
        y: 0.4,
        angle: 0.0,
    };
    let slid = disk().launches(&target, Turns::Exact, &limits).unwrap();
    assert_eq!(slid.len(), 1);
    assert!((slid[0].speed - (2.0 * MU_G * 0.5).sqrt()).abs() < 1e-14);
    assert_eq!(slid[0].launch.spin, 0.0);
    // Without moving: torque 2/3 mu m g R, hence angle = 3 w^2 R/(8 mu g) for C = 1/2.
    let target = Pose {
        x: 0.0,
        y: 0.0,
        angle: -3.0,
    };
    let spun = disk().launches(&target, Turns::Exact, &limits).unwrap();
    let spin = (3.0 * 8.0 * MU_G / (3.0 * RADIUS)).sqrt();
    assert!((spun[0].launch.spin + spin).abs() < 1e-13 * spin);
    assert_eq!(spun[0].launch.velocity, [0.0, 0.0]);
    // There already: nothing to do is the cheapest way, whole turns are others.
    let here = disk()
        .launches(&Pose::default(), modulo(1), &limits)
        .unwrap();
    assert_eq!((here[0].energy_per_mass, here[0].time), (0.0, 0.0));
    assert!(here.len() > 1 && here.len() % 2 == 1);
}

#[test]
fn every_number_of_turns_is_listed_once() {
    let limits = LaunchLimits::new(2.5, 60.0).unwrap();
    let target = Pose {
        x: 0.2,
        y: -0.5,
        angle: 1.0,
    };
    let launches = |symmetry| disk().launches(&target, modulo(symmetry), &limits).unwrap();
    for symmetry in [1, 2, 3] {
        let found = launches(symmetry);
        let period = TAU / f64::from(symmetry);
        let mut angles: Vec<f64> = found.iter().map(|solution| solution.angle).collect();
        angles.sort_by(f64::total_cmp);
        for pair in angles.windows(2) {
            assert!((pair[1] - pair[0] - period).abs() < 1e-12);
        }
        // The next turns on both ends need more spin than allowed.
        for beyond in [angles[0] - period, angles[angles.len() - 1] + period] {
            let next = Pose {
                angle: beyond,
                ..target
            };
            let refused = disk().launches(&next, Turns::Exact, &limits);
            assert!(matches!(refused, Err(MotionError::OutOfReach(_))));
        }
        let by_energy =
            |pair: &[LaunchSolution]| pair[0].energy_per_mass <= pair[1].energy_per_mass;
        assert!(found.windows(2).all(by_energy));
    }
    assert!(launches(3).len() > 2 * launches(1).len());
}

#[test]
fn mirrored_and_turned_targets_have_mirrored_and_turned_launches() {
    let limits = LaunchLimits::new(3.0, 80.0).unwrap();
    let target = Pose {
        x: 0.6,
        y: 0.25,
        angle: 2.0,
    };
    let mirrored = Pose {
        y: -0.25,
        angle: -2.0,
        ..target
    };
    let turned = Pose {
        x: -0.25,
        y: 0.6,
        angle: 2.0,
    };
    let solve = |target| disk().launches(&target, Turns::Exact, &limits).unwrap()[0].launch;
    let (plain, mirrored, turned) = (solve(target), solve(mirrored), solve(turned));
    let [x, y] = plain.velocity;
    assert_eq!((mirrored.velocity, mirrored.spin), ([x, -y], -plain.spin));
    assert_eq!((turned.velocity, turned.spin), ([-y, x], plain.spin));
}

#[test]
fn what_is_out_of_reach_is_refused_with_the_reach() {
    let map = disk();
    let limits = LaunchLimits::new(2.0, 50.0).unwrap();
    let refuse = |target: Pose, turns| match map.launches(&target, turns, &limits) {
        Err(MotionError::OutOfReach(reach)) => *reach,
        other => panic!("{other:?}"),
    };
    let far = refuse(
        Pose {
            x: 0.0,
            y: 2.0,
            angle: 1.0,
        },
        Turns::Exact,
    );
    // The launch named does lead there.
    let end = map.rest(&far.needed.launch).pose;
    assert!((end.y - 2.0).abs() < 1e-12 && (end.angle - 1.0).abs() < 1e-12);
    assert!(far.needed.speed > 2.0);
    // Just inside the distances named there is a launch, just outside there is none.
    for angle in [0.0, 1.0, 12.0, 27.0] {
        let Some([near, far]) = map.distances(angle, &limits) else {
            panic!("{angle}");
        };
        let at = |x: f64| map.launches(&Pose { x, y: 0.0, angle }, Turns::Exact, &limits);
        assert!(
            at(far * (1.0 - 1e-9)).is_ok() && at(far * (1.0 + 1e-9)).is_err(),
            "{angle}"
        );
        if near > 0.0 {
            assert!(at(near * (1.0 + 1e-9)).is_ok() && at(near * (1.0 - 1e-9)).is_err());
        }
    }
    // The limits count to the bit.
    let target = map
        .rest(&Launch {
            velocity: [1.3, 0.0],
            spin: 31.0,
        })
        .pose;
    let found = map.launches(&target, Turns::Exact, &limits).unwrap()[0];
    let exact = LaunchLimits::new(found.speed, found.launch.spin).unwrap();
    assert!(map.launches(&target, Turns::Exact, &exact).is_ok());
    let short = LaunchLimits::new(found.speed.next_down(), found.launch.spin).unwrap();
    assert!(map.launches(&target, Turns::Exact, &short).is_err());
    // Any number of turns: too far in every way, and no spin at all.
    refuse(
        Pose {
            x: 9.0,
            y: 0.0,
            angle: 1.0,
        },
        modulo(1),
    );
    let still = LaunchLimits::new(2.0, 0.0).unwrap();
    assert!(
        map.launches(
            &Pose {
                x: 0.1,
                y: 0.0,
                angle: 1.0
            },
            modulo(1),
            &still
        )
        .is_err()
    );
    assert!(
        map.launches(
            &Pose {
                x: 0.1,
                y: 0.0,
                angle: 0.0
            },
            modulo(1),
            &still
        )
        .is_ok()
    );
}

#[test]
fn bad_requests_are_refused() {
    let linear = RestMap::new(DiskTable64::new(1.0).unwrap(), 1.0, 1.0, 0.5);
    assert!(matches!(linear, Err(MotionError::NeverRests { .. })));
    assert!(matches!(
        RestMap::new(CoulombDisk, -1.0, 1.0, 0.5),
        Err(MotionError::Body(_))
    ));
    assert!(LaunchLimits::new(-1.0, 1.0).is_err() && LaunchLimits::new(1.0, f64::NAN).is_err());
    let limits = LaunchLimits::new(1.0, 1.0).unwrap();
    let nowhere = Pose {
        x: f64::NAN,
        y: 0.0,
        angle: 0.0,
    };
    let refused = disk().launches(&nowhere, Turns::Exact, &limits);
    assert!(matches!(refused, Err(MotionError::Target { .. })));
    let dizzy = LaunchLimits::new(1.0, 1e5).unwrap();
    let target = Pose {
        x: 0.1,
        y: 0.0,
        angle: 0.0,
    };
    let refused = disk().launches(&target, modulo(1), &dizzy);
    assert!(matches!(refused, Err(MotionError::TooMany { .. })));
}

/// The direction of the rest, atan(R angle/d), rises with that of the launch, and neither path
/// falls if either speed grows: what makes every solution the only one.
#[test]
fn paths_to_rest_are_ordered_like_their_launches() {
    const DIRECTIONS: usize = 24;
    let mut least = f64::INFINITY;
    for alpha in [-0.9, -0.5, 0.0, 0.5, 0.9, 0.99] {
        for (name, law) in bodies(alpha) {
            for inertia in [0.055, 0.62, 4.9] {
                let map = RestMap::new(law.as_ref(), 1.0, 1.0, inertia).unwrap();
                let mut before = 0.0;
                for i in 1..DIRECTIONS {
                    let phi = i as f64 / DIRECTIONS as f64 * 0.5 * PI;
                    let (n, c) = phi.sin_cos();
                    let [d, turned] = map.reach(c, n);
                    let ahead = turned.atan2(d);
                    let place = || format!("{name}, alpha {alpha}, C {inertia}, {phi}");
                    least = least.min(ahead - before);
                    assert!(ahead > before, "{}", place());
                    before = ahead;
                    let rows = map.jacobian(&Launch {
                        velocity: [c, 0.0],
                        spin: n,
                    });
                    let entries = [rows[0][0], rows[0][2], rows[2][0], rows[2][2]];
                    assert!(
                        entries.iter().all(|&x| x > -1e-9),
                        "{}: {entries:?}",
                        place()
                    );
                    let determinant = entries[0] * entries[3] - entries[1] * entries[2];
                    assert!(determinant > 0.0, "{}", place());
                }
            }
        }
    }
    println!(
        "least rise of the rest's direction over 1/{DIRECTIONS} of a right angle: {least:.2e}"
    );
}

/// The angles of the fewest turns are those of modest limits, however large the limits are.
#[test]
fn limits_that_do_not_limit_leave_the_fewest_turns() {
    let disk = disk();
    let target = Pose {
        x: 1.2,
        y: 0.3,
        angle: PI / 2.0,
    };
    let few = |symmetry, speed: f64, spin: f64| {
        let limits = LaunchLimits::new(speed, spin).unwrap();
        let all = disk.fewest_turns(&target, modulo(symmetry), &limits, 5);
        let all = all.unwrap_or_else(|error| panic!("{symmetry} {speed:e} {spin:e}: {error}"));
        (all.count, all.solutions)
    };
    let (_, wanted) = few(1, 100.0, 1e3);
    for [speed, spin] in [
        [1e6, 1e9],
        [1e9, 1e10],
        [1e9, 1e12],
        [1e12, 1e12],
        [3.0, 1e150],
        [1e300, 1e300],
        [f64::MAX, f64::MAX],
    ] {
        let (count, found) = few(1, speed, spin);
        assert_eq!(found, wanted, "{speed:e} {spin:e}");
        // In place the angle is 3/8 ω² R/(mu g), in either sense.
        let turns = 2.0 * (0.375 * RADIUS / MU_G * spin * spin) / TAU;
        if turns < 1e18 {
            assert!((count as f64 / turns - 1.0).abs() < 1e-2, "{count} {turns}");
        } else {
            assert!(count as f64 >= 1e18, "{count}");
        }
    }
    let (_, wanted) = few(4_000_000_000, 100.0, 100.0);
    let (count, found) = few(4_000_000_000, 1e6, 1e9);
    assert_eq!(found, wanted);
    assert_eq!(count, u64::MAX);
}

/// A slow launch reaches far if it spins fast enough: then no few turns are enough.
#[test]
fn far_targets_of_slow_launches_take_many_turns() {
    let disk = disk();
    let target = Pose {
        x: 1e12,
        y: 0.0,
        angle: 0.5,
    };
    let limits = LaunchLimits::new(1.0, 1e300).unwrap();
    let found = disk.fewest_turns(&target, modulo(1), &limits, 4).unwrap();
    assert_eq!(found.solutions.len(), 4);
    for one in &found.solutions {
        assert!(one.speed <= 1.0 && one.speed > 1.0 - 1e-9, "{one:?}");
        let end = disk.rest(&one.launch).pose;
        assert!((end.x / target.x - 1.0).abs() < 1e-12);
        assert!((end.angle / one.angle - 1.0).abs() < 1e-12);
    }
    // Without speed it goes nowhere, however fast it spins.
    let still = LaunchLimits::new(0.0, 1e300).unwrap();
    let refused = disk.fewest_turns(&target, modulo(1), &still, 4);
    assert!(matches!(refused, Err(MotionError::OutOfReach(_))));
    // A limit of the spin that is missed by far is told with the turns that miss it least.
    let near = LaunchLimits::new(1.0, 1.0).unwrap();
    let Err(MotionError::OutOfReach(why)) = disk.launches(&target, modulo(1), &near) else {
        panic!("it does not reach that far");
    };
    let balance = why.needed.speed / (why.needed.launch.spin.abs());
    assert!((balance - 1.0).abs() < 1e-3, "{balance}");
}

#[test]
fn distances_are_told_for_limits_that_do_not_limit() {
    let disk = disk();
    let limits = LaunchLimits::new(1e100, 1e300).unwrap();
    let [nearest, farthest] = disk.distances(1.0, &limits).unwrap();
    assert_eq!(nearest, 0.0);
    assert!(
        (farthest / (1e200 / (2.0 * MU_G)) - 1.0).abs() < 1e-12,
        "{farthest}"
    );
}
