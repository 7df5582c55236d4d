//! Bodies on springs against closed forms and independent integrations.

use super::*;
use crate::stick::MotionError;
use crate::stick::scene::{SpringFriction, SpringScene};
use std::f64::consts::PI;

/// ΔF, ω and the closed form of the period: rest 2ΔF/(kV), slip (2/ω)(π − atan(ωΔF/(kV))).
fn closed_form(scene: &SpringScene) -> [f64; 3] {
    let drop = (scene.mu_static - scene.mu_dynamic) * scene.load;
    let omega = (scene.stiffness / scene.mass).sqrt();
    let rise = drop / (scene.stiffness * scene.pull_speed);
    let period = 2.0 * rise + 2.0 * (PI - (omega * rise).atan()) / omega;
    [drop, omega, period]
}

fn dry_blocks() -> impl Iterator<Item = SpringScene> {
    let values = [
        [1.0, 100.0, 0.05, 0.5, 0.3],
        [0.02, 3e4, 1e-3, 0.6, 0.2],
        [250.0, 2e3, 0.2, 0.31, 0.29],
        [1.0, 100.0, 2.0, 0.5, 0.45],
        [1e-6, 1e-2, 1e-5, 0.9, 0.1],
    ];
    values
        .into_iter()
        .map(|[mass, stiffness, pull_speed, mu_static, mu_dynamic]| {
            let scene = SpringScene {
                mass,
                load: 9.81 * mass,
                stiffness,
                pull_speed,
                mu_static,
                mu_dynamic,
                ..SpringScene::default()
            };
            let [_, _, period] = closed_form(&scene);
            let onset = mu_static * scene.load / (stiffness * pull_speed);
            SpringScene {
                pull_time: 2.0 * onset + 40.3 * period,
                ..scene
            }
        })
}

#[test]
fn coulombs_stick_slip_has_the_period_and_the_forces_of_its_closed_form() {
    for scene in dry_blocks() {
        let [drop, omega, period] = closed_form(&scene);
        let outcome = scene.run().unwrap().outcome;
        assert_eq!(outcome.regime, StickSlipRegime::StickSlip);
        let found = outcome.period.unwrap();
        assert!(
            (found / period - 1.0).abs() < 1e-10,
            "{scene:?}: {found} {period}"
        );
        // u' = 0 at the distance R from the centre: F = mu_d N ± k R.
        let lever = drop.hypot(scene.stiffness * scene.pull_speed / omega);
        let kinetic = scene.mu_dynamic * scene.load;
        assert!((outcome.most_force - kinetic - lever).abs() < 1e-10 * kinetic);
        assert!((outcome.least_force - kinetic + lever).abs() < 1e-10 * kinetic);
    }
}

#[test]
fn a_body_that_sticks_keeps_its_place_to_the_bit_and_work_becomes_heat_and_tension() {
    let mut stuck = 0;
    for scene in dry_blocks() {
        let samples = 4000;
        let result = SpringScene { samples, ..scene }.run().unwrap();
        for pair in result.rows.windows(2) {
            let [[_, _, before, .., rested, slipped], row] = [pair[0], pair[1]];
            let [
                _,
                _,
                position,
                velocity,
                spring_force,
                friction,
                rests,
                slips,
            ] = row;
            if slipped + slips == 0.0 && rests > rested {
                assert_eq!(before.to_bits(), position.to_bits());
                assert_eq!((velocity, friction), (0.0, spring_force));
                stuck += 1;
            }
        }
        let work = result.outcome.work;
        let [_, _, _, velocity, spring_force, ..] = result.rows[result.rows.len() - 1];
        let stored = 0.5 * spring_force * spring_force / scene.stiffness
            + 0.5 * scene.mass * velocity * velocity;
        // All motion is forward: heat is friction times distance.
        let heat = scene.mu_dynamic * scene.load * result.outcome.distance;
        assert!(
            (work - stored - heat).abs() < 1e-9 * work,
            "{work} {stored} {heat}"
        );
    }
    assert!(stuck > 1000, "{stuck}");
}

/// Without a difference of the coefficients the body stops for an instant at most.
#[test]
fn equal_coefficients_leave_an_oscillation_about_the_dynamic_friction() {
    let scene = SpringScene {
        mu_static: 0.3,
        ..SpringScene::default()
    };
    let outcome = scene.run().unwrap().outcome;
    let swing = scene.pull_speed * (scene.stiffness * scene.mass).sqrt();
    assert_eq!(outcome.regime, StickSlipRegime::Oscillates);
    assert!(
        (outcome.most_force - 0.3 * 9.81 - swing).abs() < 1e-9,
        "{outcome:?}"
    );
    assert!((outcome.least_force - 0.3 * 9.81 + swing).abs() < 1e-9);
    assert!((outcome.most_speed / scene.pull_speed - 2.0).abs() < 0.01);
}

#[test]
fn without_friction_in_motion_the_series_does_not_decide_whether_a_body_holds() {
    // It stops where the spring presses with what friction holds, and stays: ΔF is all of it.
    for samples in [10, 50, 100, 333, 500, 2000, 20_000] {
        let scene = SpringScene {
            mu_dynamic: 0.0,
            samples,
            ..SpringScene::default()
        };
        let [_, _, period] = closed_form(&scene);
        let outcome = scene.run().unwrap().outcome;
        assert_eq!(outcome.regime, StickSlipRegime::StickSlip, "{samples}");
        let found = outcome.period.unwrap();
        assert!(
            (found / period - 1.0).abs() < 1e-9,
            "{samples}: {found} {period}"
        );
    }
}

#[test]
fn a_body_stops_however_slowly_it_is_pulled() {
    // The spring force is extremal within 1e-9 of an oscillation before the body stops.
    for pull_speed in [1e-9, 1e-10, 1e-12] {
        let scene = SpringScene {
            pull_speed,
            pull_time: 0.4 / pull_speed,
            ..SpringScene::default()
        };
        let [_, _, period] = closed_form(&scene);
        let outcome = scene.run().unwrap().outcome;
        assert_eq!(outcome.regime, StickSlipRegime::StickSlip, "{pull_speed}");
        let found = outcome.period.unwrap();
        assert!(
            (found / period - 1.0).abs() < 1e-9,
            "{pull_speed}: {found} {period}"
        );
    }
}

#[test]
fn a_pull_too_weak_moves_nothing() {
    let scene = SpringScene {
        pull_time: 0.9,
        ..SpringScene::default()
    };
    let SpringSummary {
        regime,
        distance,
        slips,
        ..
    } = scene.run().unwrap().outcome;
    assert_eq!((regime, distance, slips), (StickSlipRegime::Rests, 0.0, 0));
}

#[test]
fn contacts_that_age_let_go_where_the_force_meets_the_age() {
    for (growth, cut_off, speed) in [(0.02, 0.1, 0.05), (0.1, 3.0, 0.01), (0.05, 1e-3, 1e-3)] {
        let scene = SpringScene {
            ageing_rate: growth,
            ageing_cutoff_time: cut_off,
            pull_speed: speed,
            pull_time: 20.0 / speed,
            samples: 20_000,
            ..SpringScene::default()
        };
        let outcome = scene.run().unwrap().outcome;
        // The onset by bisection: k V t = N (mu_s + growth ln(t/cut_off)).
        let strength = |age: f64| {
            let grown = if age > cut_off {
                growth * (age / cut_off).ln()
            } else {
                0.0
            };
            scene.load * (scene.mu_static + grown)
        };
        let period = |drop: f64| {
            let rise = drop / (scene.stiffness * speed);
            let omega = (scene.stiffness / scene.mass).sqrt();
            [2.0 * rise, 2.0 * (PI - (omega * rise).atan()) / omega]
        };
        // In the cycle the rest lasts 2ΔF/(kV) and ΔF is that of its own age.
        let (mut low, mut high) = (0.0, 1e4);
        for _ in 0..200 {
            let rest = 0.5 * (low + high);
            let drop = strength(rest) - scene.mu_dynamic * scene.load;
            if period(drop)[0] > rest {
                low = rest;
            } else {
                high = rest;
            }
        }
        let slip = period(0.5 * low * scene.stiffness * speed)[1];
        let found = outcome.period.unwrap();
        assert!(
            (found / (low + slip) - 1.0).abs() < 1e-9,
            "{found} {}",
            low + slip
        );
    }
}

#[test]
fn static_friction_grows_with_the_logarithm_of_the_hold() {
    let scene = SpringScene {
        ageing_rate: 0.03,
        ageing_cutoff_time: 0.01,
        pull_speed: 1e-3,
        pull_time: 30.0,
        hold_time: Some(1000.0),
        hold_count: 5,
        stiffness: 1000.0,
        ..SpringScene::default()
    };
    let outcome = scene.run().unwrap().outcome;
    assert_eq!(outcome.holds.len(), 5);
    let healing = outcome.healing.unwrap();
    // The reload adds some seconds to ages of 1000 s and more.
    assert!((healing / 0.03 - 1.0).abs() < 1e-3, "{healing}");
}

fn paper() -> SpringScene {
    SpringScene {
        friction_law: SpringFriction::RateState,
        mass: 0.0,
        load: 10.0,
        stiffness: 1e5,
        pull_speed: 1e-6,
        pull_time: 200.0,
        ..SpringScene::default()
    }
}

/// The stiffness at which a small disturbance neither grows nor fades, by bisection of runs.
fn bisected(scene: &SpringScene, expected: f64) -> f64 {
    let (mut low, mut high) = (0.8 * expected, 1.25 * expected);
    while high / low > 1.002 {
        let stiffness = 0.5 * (low + high);
        let trial = SpringScene {
            stiffness,
            ..*scene
        };
        let outcome = trial.run().unwrap().outcome;
        if outcome.ran_away || outcome.swing_ratio > 1.0 {
            low = stiffness;
        } else {
            high = stiffness;
        }
    }
    0.5 * (low + high)
}

#[test]
fn the_critical_stiffness_is_that_of_ruina_with_and_without_mass() {
    for (a, b, evolution, mass) in [
        (0.01, 0.03, StateEvolutionKind::Ageing, 0.0),
        (0.01, 0.015, StateEvolutionKind::Slip, 0.0),
        (0.008, 0.012, StateEvolutionKind::Ageing, 0.0),
        // m V²/(N a D_c) = 0.5.
        (0.01, 0.02, StateEvolutionKind::Ageing, 5e4),
        (0.01, 0.02, StateEvolutionKind::Slip, 5e4),
    ] {
        let scene = SpringScene {
            a,
            b,
            evolution,
            mass,
            pull_time: 160.0,
            start_speed: Some(0.999e-6),
            ..paper()
        };
        let inertia = mass * 1e-12 / (scene.load * a * 1e-6);
        let expected = scene.load * (b - a) / 1e-6 * (1.0 + inertia);
        let found = bisected(&scene, expected);
        assert!(
            (found / expected - 1.0).abs() < 0.01,
            "{a} {b} {mass}: {found} {expected}"
        );
        let told = scene.critical_stiffness().unwrap();
        assert!((told / expected - 1.0).abs() < 1e-12);
    }
}

#[test]
fn without_mass_and_viscous_term_a_soft_spring_ends_in_a_run_that_says_so() {
    let outcome = paper().run().unwrap().outcome;
    assert!(outcome.ran_away && outcome.end_time < 200.0, "{outcome:?}");
    let stiff = SpringScene {
        stiffness: 4e5,
        ..paper()
    };
    let outcome = stiff.run().unwrap().outcome;
    assert_eq!(outcome.regime, StickSlipRegime::Creeps);
    // mu_0 at V_0.
    assert!((outcome.mean_force / 3.5 - 1.0).abs() < 1e-5, "{outcome:?}");
}

#[test]
fn a_direct_effect_too_small_to_follow_is_told() {
    for a in [1e-4, 1e-10, 1e-30] {
        let scene = SpringScene {
            a,
            radiation_damping: 20.0,
            ..paper()
        };
        let ended = scene.run();
        assert!(
            matches!(ended, Err(MotionError::TooSlow { .. })),
            "{a}: {ended:?}"
        );
    }
}

#[test]
fn contacts_under_rate_and_state_heal_by_b_for_each_e_fold_of_the_hold() {
    let scene = SpringScene {
        stiffness: 1e7,
        pull_speed: 1e-5,
        pull_time: 10.0,
        hold_time: Some(100.0),
        hold_count: 4,
        radiation_damping: 1.0,
        ..paper()
    };
    let healing = scene.run().unwrap().outcome.healing.unwrap();
    assert!((healing / scene.b - 1.0).abs() < 0.02, "{healing}");
}

/// Periods, forces and speeds by scipy: DOP853 with rtol 1e-12 and steps of 2e-5 s at most while it slips, the
/// stick phase by hand.
#[test]
fn stick_slip_under_stribecks_law_is_that_of_another_integrator() {
    for (law, [mass, stiffness, pull_speed], [period, least, most, fastest]) in [
        (
            "stribeck:mu_s=0.5,mu_d=0.3,vs=0.05",
            [1.0, 100.0, 0.05],
            [1.296_448_746, 0.581_235_670, 5.312_771_598, 0.286_537_390],
        ),
        (
            "stribeck:mu_s=0.5,mu_d=0.3,vs=0.03,delta=1,k=0.5",
            [2.0, 300.0, 0.02],
            [0.872_129_197, 1.754_013_328, 5.247_296_016, 0.091_205_936],
        ),
    ] {
        let scene = SpringScene {
            law: Some(law.parse().unwrap()),
            mass,
            stiffness,
            pull_speed,
            tolerance: 1e-11,
            ..SpringScene::default()
        };
        let outcome = scene.run().unwrap().outcome;
        assert_eq!(outcome.regime, StickSlipRegime::StickSlip);
        let found = outcome.period.unwrap();
        assert!((found / period - 1.0).abs() < 1e-8, "{law}: {found}");
        assert!(
            (outcome.most_force / most - 1.0).abs() < 1e-4,
            "{outcome:?}"
        );
        assert!(
            (outcome.least_force / least - 1.0).abs() < 1e-4,
            "{outcome:?}"
        );
        assert!(
            (outcome.most_speed / fastest - 1.0).abs() < 1e-3,
            "{outcome:?}"
        );
    }
}

/// scipy 1.x, Radau with rtol 1e-11 in the logarithms of speed and age; the unregularised law.
#[test]
fn the_cycle_without_mass_is_that_of_another_integrator() {
    for (evolution, [period, least, most, fastest]) in [
        (
            StateEvolutionKind::Ageing,
            [
                22.746_913_827_7,
                2.087_124_045_1,
                4.254_392_398_5,
                6.030_646_434_8e-3,
            ],
        ),
        (
            StateEvolutionKind::Slip,
            [
                19.993_621_543_2,
                2.019_248_876_6,
                3.717_403_967_5,
                7.316_235_491_2e-3,
            ],
        ),
    ] {
        let scene = SpringScene {
            evolution,
            radiation_damping: 20.0,
            ..paper()
        };
        let outcome = scene.run().unwrap().outcome;
        assert_eq!(outcome.regime, StickSlipRegime::StickSlip);
        assert!(
            (outcome.period.unwrap() / period - 1.0).abs() < 1e-5,
            "{outcome:?}"
        );
        assert!(
            (outcome.least_force / least - 1.0).abs() < 1e-5,
            "{outcome:?}"
        );
        assert!(
            (outcome.most_force / most - 1.0).abs() < 1e-5,
            "{outcome:?}"
        );
        assert!(
            (outcome.most_speed / fastest - 1.0).abs() < 1e-4,
            "{outcome:?}"
        );
    }
}

/// The same integrator of scipy, three unknowns, rtol 1e-10.
#[test]
fn the_cycle_with_mass_is_that_of_another_integrator() {
    for (evolution, forces, period) in [
        (
            StateEvolutionKind::Ageing,
            [4.925_027_393_7, 6.403_709_050_6],
            None,
        ),
        (
            StateEvolutionKind::Slip,
            [5.120_488_594_8, 6.158_583_234_5],
            Some(56.449_186_061_6),
        ),
    ] {
        let scene = SpringScene {
            evolution,
            mass: 1.0,
            mu_reference: 0.6,
            b: 0.015,
            stiffness: 2e4,
            ..paper()
        };
        let outcome = scene.run().unwrap().outcome;
        assert_eq!(outcome.regime, StickSlipRegime::StickSlip);
        assert!(
            (outcome.least_force / forces[0] - 1.0).abs() < 1e-4,
            "{outcome:?}"
        );
        assert!(
            (outcome.most_force / forces[1] - 1.0).abs() < 1e-4,
            "{outcome:?}"
        );
        if let (Some(period), Some(found)) = (period, outcome.period) {
            assert!((found / period - 1.0).abs() < 1e-5, "{outcome:?}");
        }
    }
}

/// scipy, Radau with rtol 1e-10.
#[test]
fn stick_slip_on_bristles_is_that_of_another_integrator() {
    let scene = SpringScene {
        friction_law: SpringFriction::Bristles,
        coulomb_force: 3.0,
        static_force: 5.0,
        ..SpringScene::default()
    };
    let outcome = scene.run().unwrap().outcome;
    assert_eq!(outcome.regime, StickSlipRegime::StickSlip);
    assert!(
        (outcome.period.unwrap() / 1.154_266_908_4 - 1.0).abs() < 1e-4,
        "{outcome:?}"
    );
    assert!(
        (outcome.least_force / 1.057_633_018_6 - 1.0).abs() < 1e-4,
        "{outcome:?}"
    );
    assert!(
        (outcome.most_force / 5.109_645_642_9 - 1.0).abs() < 1e-4,
        "{outcome:?}"
    );
    // Fast enough, it slides steadily on what the bristles carry.
    let fast = SpringScene {
        pull_speed: 0.5,
        viscous_damping: 20.0,
        ..scene
    };
    let outcome = fast.run().unwrap().outcome;
    assert_eq!(outcome.regime, StickSlipRegime::Steady);
    assert!(
        (outcome.mean_force - 3.0 - 10.0).abs() < 1e-4,
        "{outcome:?}"
    );
}
