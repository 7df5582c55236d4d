//! A body slides and spins to rest: when, where, how, and in the steps of any clock.

use tribos_core::coupling::coulomb::CoulombDisk;
use tribos_core::coupling::round::RoundTable64;
use tribos_core::coupling::table::DiskTable64;
use tribos_core::coupling::{Annulus, PowerLawFriction, ReducedFriction};
use tribos_core::patch::PowerPressure;
use tribos_core::slider::{Slider, SliderParameters, SliderRest, SliderState};
use tribos_tests::pucks::{coulomb, power, relative};
use tribos_tests::surfaces::Counting;
use tribos_tests::sweep::Lcg;
use tribos_tests::tables::{Row, Table};
use tribos_tests::tolerance;
use tribos_tests::worst::Worst;

#[test]
fn stops_are_those_of_the_table() {
    let [mut stop, mut direction] = ["stop time, distance, angle", "final ratio"].map(Worst::of);
    for row in Table::read("stops.csv").rows() {
        let (alpha, c) = (row.number("alpha"), row.number("inertia_ratio"));
        let launched = SliderState::launched(row.number("v0"), row.number("w0"));
        let profile = DiskTable64::new(alpha).unwrap();
        let rest = unit_slider(profile, c).to_rest(&launched).unwrap();
        let place = || {
            format!(
                "alpha {alpha}, C {c}, v0 {}, w0 {}",
                launched.speed, launched.spin
            )
        };
        stop.see(row.reference("stop_time").relative(rest.motion.time), place);
        stop.see(
            row.reference("distance").relative(rest.motion.distance),
            place,
        );
        stop.see(row.reference("angle").relative(rest.motion.angle), place);
        assert!(rest.motion.is_at_rest());
        match row.number("final_ratio") {
            // Pure motions are approached, or given from the start.
            0.0 => assert!(
                rest.ratio < tolerance::STOP_PURE.limit,
                "{}: {}",
                place(),
                rest.ratio
            ),
            f64::INFINITY => assert!(
                1.0 / rest.ratio < tolerance::STOP_PURE.limit,
                "{}: {}",
                place(),
                rest.ratio
            ),
            _ => direction.see(row.reference("final_ratio").relative(rest.ratio), place),
        }
    }
    stop.assert_within(&tolerance::STOP);
    direction.assert_within(&tolerance::STOP_RATIO);
}

/// Compares the state that a row has on the way, each number over its condition.
fn see_on_the_way<P: PowerLawFriction<f64> + ReducedFriction<f64>>(
    worst: &mut Worst,
    row: &Row,
    slider: &Slider<f64, P>,
    place: impl Fn() -> String + Copy,
) {
    let number = |column: &str| row.number(column);
    let start = SliderState::launched(number("v0"), number("w0"));
    let after = slider.advance(&start, number("time")).motion;
    // A dying speed is as uncertain as what is left of its time.
    let wrench = slider.profile().reduced_wrench(after.speed, after.spin);
    let slide = 1.0 + number("time") * wrench.force / after.speed;
    let rim = 1.0 + number("time") * wrench.torque / (number("inertia_ratio") * after.spin);
    for (column, got, condition) in [
        ("speed", after.speed, slide + rim),
        ("spin", after.spin, slide + rim),
        ("distance_then", after.distance, 1.0),
        ("angle_then", after.angle, 1.0),
    ] {
        worst.see(row.reference(column).relative(got) / condition, place);
    }
}

/// With radius and deceleration 1.
fn unit_slider<C: PowerLawFriction<f64> + ReducedFriction<f64>>(
    coupling: C,
    inertia_ratio: f64,
) -> Slider<f64, C> {
    let parameters = SliderParameters {
        deceleration: 1.0,
        radius: 1.0,
        inertia_ratio,
    };
    Slider::new(coupling, parameters).unwrap()
}

#[test]
fn each_of_time_distance_and_angle_is_relative_whichever_motion_dies_first() {
    let mut stop = Worst::of("time, distance, angle to rest, launches of any ratio");
    let mut later = Worst::of("state on the way, over its condition");
    for row in Table::read("rests.csv").rows() {
        let number = |column: &str| row.number(column);
        let pressure = PowerPressure::new(number("q")).unwrap();
        let table = RoundTable64::new(number("alpha"), pressure).unwrap();
        let slider = unit_slider(&table, number("inertia_ratio"));
        let start = SliderState::launched(number("v0"), number("w0"));
        let place = || {
            ["q", "alpha", "inertia_ratio", "v0", "w0"]
                .map(|column| row.text(column))
                .join(", ")
        };
        match row.optional("stop_time") {
            None => assert!(slider.to_rest(&start).is_none()),
            Some(time) => {
                let rest = slider.to_rest(&start).unwrap();
                let SliderState {
                    distance, angle, ..
                } = rest.motion;
                stop.see(time.relative(rest.motion.time), place);
                stop.see(row.reference("distance").relative(distance), place);
                stop.see(row.reference("angle").relative(angle), place);
                assert!(rest.evaluations <= 600, "{}: {}", place(), rest.evaluations);
            }
        }
        see_on_the_way(&mut later, &row, &slider, place);
    }
    stop.assert_within(&tolerance::REST);
    later.assert_within(&tolerance::REST);
}

#[test]
fn an_annulus_comes_to_rest_to_its_own_bound() {
    let mut stop = Worst::of("time, distance, angle to rest, annuli");
    let mut later = Worst::of("state on the way of annuli, over its condition");
    for row in Table::read("annulus_rests.csv").rows() {
        let number = |column: &str| row.number(column);
        let disk = RoundTable64::new(number("alpha"), PowerPressure::new(0.0).unwrap()).unwrap();
        let band = Annulus::new(&disk, number("k")).unwrap();
        let slider = unit_slider(&band, number("inertia_ratio"));
        let start = SliderState::launched(number("v0"), number("w0"));
        let place = || {
            ["k", "alpha", "inertia_ratio", "v0", "w0"]
                .map(|column| row.text(column))
                .join(", ")
        };
        let rest = slider.to_rest(&start).unwrap();
        for (column, got) in [
            ("stop_time", rest.motion.time),
            ("distance", rest.motion.distance),
            ("angle", rest.motion.angle),
        ] {
            stop.see(row.reference(column).relative(got), place);
        }
        assert!(
            rest.evaluations <= 2_200,
            "{}: {}",
            place(),
            rest.evaluations
        );
        see_on_the_way(&mut later, &row, &slider, place);
    }
    stop.assert_within(&tolerance::ANNULUS_REST);
    later.assert_within(&tolerance::ANNULUS_REST);
}

#[test]
fn a_small_distance_under_a_heavy_spin_has_its_closed_form() {
    // As v/w → 0, v C w/(κ k (C n + 1)) with k = 2/3 and n = 3/2 (a ball on a small contact, C = 1000).
    let puck = unit_slider(CoulombDisk, 1000.0);
    for speed in [1e-8, 1e-12, 1e-100, 1e-300] {
        let distance = puck
            .to_rest(&SliderState::launched(speed, 1.0))
            .unwrap()
            .motion
            .distance;
        let wanted = speed * 1000.0 / (2.0 / 3.0 * 1501.0);
        assert!(
            relative(distance, wanted) <= tolerance::STOP.limit,
            "{speed:e}"
        );
    }
}

#[test]
fn exponents_near_one_end_at_the_fixed_point_of_the_modes() {
    for away in [1e-7, 1e-6, 1e-5, 1e-4, 1e-3, 1e-2] {
        let below = DiskTable64::new(1.0 - away).unwrap();
        let modes = tribos_core::modes::TerminalMotion::new(&below, 0.5).unwrap();
        let puck = unit_slider(&below, 0.5);
        for (speed, spin) in [(1.0, 0.4), (1.0, 1.0), (1e-9, 1.0), (1e9, 1.0)] {
            let start = SliderState::launched(speed, spin);
            let rest = puck.to_rest(&start).unwrap();
            assert_eq!(
                Some(rest.ratio),
                modes.finite_fixed_point(),
                "{away} {speed}"
            );
            // A stop on the way changes nothing.
            let half = puck.advance(&start, 1.0).motion;
            let after = puck.to_rest(&half).unwrap().motion;
            for (got, wanted) in [
                (after.time, rest.motion.time),
                (after.distance, rest.motion.distance),
                (after.angle, rest.motion.angle),
            ] {
                assert!(
                    relative(got, wanted) <= 1e-12,
                    "{away} {speed}: {got} {wanted}"
                );
            }
        }
        let above = DiskTable64::new(1.0 + away).unwrap();
        let puck = unit_slider(&above, 0.5);
        let start = SliderState::launched(1.0, 1.0);
        let whole = puck.advance(&start, 5.0).motion;
        let mut steps = start;
        for _ in 0..10 {
            steps = puck.advance(&steps, 0.5).motion;
        }
        assert!(relative(steps.speed, whole.speed) <= 1e-11);
        assert!(relative(steps.angle, whole.angle) <= 1e-11);
    }
}

#[test]
fn a_puck_of_the_experiment_stops_where_the_mathematics_says() {
    // R = 8 cm, μ = 0.3, 1 m/s: kernel-math.md, section 6.
    for (spin, time, distance) in [
        (0.0, 0.339_789_330_615_024, 0.169_894_665_307_512),
        (5.0, 0.369_017_132_104_558, 0.176_861_185_300_839),
    ] {
        let rest = coulomb()
            .to_rest(&SliderState::launched(1.0, spin))
            .unwrap();
        assert!(relative(rest.motion.time, time) <= tolerance::STOP.limit);
        assert!(relative(rest.motion.distance, distance) <= tolerance::STOP.limit);
    }
    let rest = coulomb().to_rest(&SliderState::launched(1.0, 5.0)).unwrap();
    assert!(relative(rest.ratio, 0.653_001_789_205_6) <= tolerance::STOP_RATIO.limit);
}

/// Follows a motion in steps of `dt` until it rests; checks every step's laws.
fn in_steps<P>(puck: &Slider<f64, P>, launched: SliderState<f64>, dt: f64) -> SliderRest<f64>
where
    P: PowerLawFriction<f64> + ReducedFriction<f64>,
{
    let mut motion = launched;
    for _ in 0..100_000 {
        let step = puck.advance(&motion, dt);
        let after = step.motion;
        assert!(
            after.speed >= 0.0 && after.speed <= motion.speed,
            "{after:?}"
        );
        assert!(after.spin.abs() <= motion.spin.abs() && after.spin * launched.spin >= 0.0);
        assert!(puck.energy_per_mass(&after) <= puck.energy_per_mass(&motion));
        assert!(after.distance >= motion.distance && after.angle * launched.spin >= 0.0);
        assert!(
            (after.time - motion.time - dt).abs()
                <= tolerance::ROUNDING.limit * after.time.max(1.0)
        );
        // Both motions end in the same step, which is the one that says so.
        let still = launched.speed == 0.0 || launched.spin == 0.0;
        assert_eq!(after.is_at_rest(), step.rest.is_some());
        assert!(
            still || (after.speed == 0.0) == (after.spin == 0.0),
            "{after:?}"
        );
        if let Some(rest) = step.rest {
            return rest;
        }
        motion = after;
    }
    panic!("still moving: {motion:?}");
}

#[test]
fn the_clock_does_not_change_the_stop() {
    let mut worst = Worst::of("stop in steps of 1e-4 to 0.1 s against one call");
    for alpha in [-0.5, 0.0, 0.5] {
        let puck = power(alpha);
        for (speed, spin) in [(1.0, 0.0), (1.0, 5.0), (0.3, -40.0), (0.0, 10.0)] {
            let launched = SliderState::launched(speed, spin);
            let whole = puck.to_rest(&launched).unwrap();
            for dt in [1e-4, 1e-3, 1.0 / 60.0, 0.1] {
                let rest = in_steps(&puck, launched, dt);
                let place = || format!("alpha {alpha}, v0 {speed}, spin {spin}, dt {dt}");
                worst.see(relative(rest.motion.time, whole.motion.time), place);
                worst.see(relative(rest.motion.distance, whole.motion.distance), place);
                worst.see(relative(rest.motion.angle, whole.motion.angle), place);
            }
        }
    }
    worst.assert_within(&tolerance::STEPS_AGREE);
}

#[test]
fn random_launches_stop_sliding_and_spinning_together() {
    let mut rng = Lcg::new(29);
    for alpha in [-0.5, 0.0, 0.5] {
        let puck = power(alpha);
        for _ in 0..60 {
            let (speed, spin) = (rng.log_between(1e-3, 10.0), rng.log_between(1e-2, 100.0));
            let launched = SliderState::launched(speed, spin);
            let rest = puck.to_rest(&launched).unwrap();
            let steps = rng.between(5.0, 60.0);
            let stepped = in_steps(&puck, launched, rest.motion.time / steps);
            assert!(
                relative(stepped.motion.time, rest.motion.time) <= tolerance::STEPS_AGREE.limit
            );
            let ratio = tribos_core::modes::TerminalMotion::new(puck.profile(), 0.5);
            let ratio = ratio.unwrap().finite_fixed_point().unwrap();
            assert!(
                relative(rest.ratio, ratio) <= tolerance::STOP_RATIO.limit,
                "{}",
                rest.ratio
            );
        }
    }
}

#[test]
fn energy_lost_is_the_work_of_friction() {
    let puck = coulomb();
    let launched = SliderState::launched(1.0, 30.0);
    let mut motion = launched;
    let dt = 1e-3;
    for _ in 0..300 {
        let after = puck.advance(&motion, dt).motion;
        let middle = puck.advance(&motion, 0.5 * dt).motion;
        let power = [motion, middle, after].map(|m| puck.dissipation_per_mass(&m));
        // Simpson's rule over the step.
        let work = dt / 6.0 * (power[0] + 4.0 * power[1] + power[2]);
        let lost = puck.energy_per_mass(&motion) - puck.energy_per_mass(&after);
        assert!((work - lost).abs() <= tolerance::WORK.limit * puck.energy_per_mass(&launched));
        motion = after;
    }
}

#[test]
fn motions_are_similar_in_every_unit() {
    // Speeds by s, times by s^(1−α)/k, lengths by s^(2−α)/k: powers of two to the bit at α = 0.
    let launched = SliderState::launched(1.0, 12.5);
    let one = Slider::new(
        CoulombDisk,
        SliderParameters {
            deceleration: 0.5,
            radius: 0.0625,
            inertia_ratio: 0.5,
        },
    )
    .unwrap()
    .to_rest(&launched)
    .unwrap();
    for (s, k, r) in [
        (4.0, 1.0, 1.0),
        (1.0, 8.0, 1.0),
        (0.25, 2.0, 16.0),
        (1.0, 1.0, 1024.0),
    ] {
        let puck = Slider::new(
            CoulombDisk,
            SliderParameters {
                deceleration: 0.5 * k,
                radius: 0.0625 * r,
                inertia_ratio: 0.5,
            },
        )
        .unwrap();
        let rest = puck
            .to_rest(&SliderState::launched(s, 12.5 * s / r))
            .unwrap();
        assert_eq!(rest.motion.time, one.motion.time * s / k);
        assert_eq!(rest.motion.distance, one.motion.distance * s * s / k);
        assert_eq!(rest.motion.angle, one.motion.angle * s * s / (k * r));
        assert_eq!((rest.ratio, rest.evaluations), (one.ratio, one.evaluations));
    }
    let alpha = 0.5;
    let one = power(alpha).to_rest(&launched).unwrap();
    let s = 3.7_f64;
    let rest = power(alpha)
        .to_rest(&SliderState::launched(s, 12.5 * s))
        .unwrap();
    let time = one.motion.time * s.powf(1.0 - alpha);
    let distance = one.motion.distance * s.powf(2.0 - alpha);
    assert!(relative(rest.motion.time, time) <= tolerance::STOP.limit);
    assert!(relative(rest.motion.distance, distance) <= tolerance::STOP.limit);
}

#[test]
fn zero_time_and_rest_change_nothing() {
    let puck = coulomb();
    let motion = SliderState {
        time: 3.0,
        speed: 0.4,
        spin: -2.0,
        distance: 1.0,
        angle: -7.0,
    };
    assert_eq!(puck.advance(&motion, 0.0).motion, motion);
    let rest = SliderState {
        speed: 0.0,
        spin: 0.0,
        ..motion
    };
    let after = puck.advance(&rest, 0.5);
    assert_eq!(after.motion, SliderState { time: 3.5, ..rest });
}

#[test]
fn impossible_sliders_are_refused() {
    for bad in [0.0, -1.0, f64::INFINITY, f64::NAN] {
        for [deceleration, radius, inertia_ratio] in
            [[bad, 1.0, 0.5], [1.0, bad, 0.5], [1.0, 1.0, bad]]
        {
            let parameters = SliderParameters {
                deceleration,
                radius,
                inertia_ratio,
            };
            assert!(Slider::new(CoulombDisk, parameters).is_err());
        }
    }
}

fn disk_run(keys: &[&str]) -> tribos::slide::SlideSummary {
    let text = tribos::scene::vocabulary("disk").unwrap().least_text();
    let keys: Vec<String> = keys.iter().map(|key| key.to_string()).collect();
    let scene = tribos::scene::DiskScene::parse("disk.toml", &text, &keys).unwrap();
    scene.run().unwrap().outcome
}

#[test]
fn a_fading_run_ends_where_it_has_faded_whatever_the_samples() {
    for alpha in ["alpha=1", "alpha=1.5", "alpha=3"] {
        let fine = disk_run(&[alpha, "samples=500"]);
        for samples in ["samples=1", "samples=20", "samples=200"] {
            let run = disk_run(&[alpha, samples]);
            for (got, wanted) in [
                (run.end_time, fine.end_time),
                (run.distance, fine.distance),
                (run.angle, fine.angle),
                (run.final_ratio, fine.final_ratio),
            ] {
                assert_eq!(got, wanted, "{alpha} {samples}");
            }
            assert!(
                run.energy_error < 1e-12,
                "{alpha} {samples}: {}",
                run.energy_error
            );
        }
    }
    // One speed is at the fraction, the other below.
    let text = tribos::scene::vocabulary("disk").unwrap().least_text();
    let keys = ["alpha=3".into(), "stop_fraction=0.01".into()];
    let scene = tribos::scene::DiskScene::parse("disk.toml", &text, &keys).unwrap();
    let series = scene.run().unwrap().rows;
    let [first, last] = [series.first(), series.last()].map(Option::unwrap);
    let slower = (last[1] / first[1]).max(last[2] / first[2]);
    assert!(relative(slower, 0.01) < 1e-10, "{slower}");
}

#[test]
fn the_energy_error_judges_the_motion_and_not_the_samples() {
    for alpha in [
        "-0.9",
        "0",
        "0.9",
        "0.999",
        "0.9999",
        "0.99999",
        "0.9999999",
    ] {
        for samples in ["samples=2", "samples=200"] {
            let run = disk_run(&[&format!("alpha={alpha}"), samples]);
            assert!(
                run.energy_error < 1e-12,
                "{alpha} {samples}: {}",
                run.energy_error
            );
            assert_eq!(run.final_mode, "together");
            assert_eq!(run.final_ratio, run.limit_ratio, "{alpha}");
        }
    }
}

#[test]
fn a_controller_s_step_costs_some_ten_wrenches() {
    // Mean evaluations a step, over the whole motion to rest.
    for (duration, most) in [(1e-4, 11), (1e-3, 26)] {
        for alpha in [-0.9, 0.0, 0.5] {
            for spin in [2.0, 5.0, 12.0, 30.0] {
                let law = Counting::new(DiskTable64::new(alpha).unwrap());
                let puck = Slider::new(
                    &law,
                    SliderParameters {
                        deceleration: 3.0,
                        radius: 0.08,
                        inertia_ratio: 0.5,
                    },
                )
                .unwrap();
                let start = SliderState::launched(1.0, spin);
                let wanted = puck.to_rest(&start).unwrap();
                law.take();
                let (mut motion, mut told, mut steps) = (start, 0, 0);
                let rest = loop {
                    let step = puck.advance(&motion, duration);
                    (motion, told, steps) = (step.motion, told + step.evaluations, steps + 1);
                    if let Some(rest) = step.rest {
                        break rest;
                    }
                };
                let place = format!("alpha {alpha}, {spin} rad/s, steps of {duration} s");
                assert_eq!(law.take(), told, "{place}");
                assert!(told <= most * steps, "{place}: {told} in {steps} steps");
                for (got, wanted) in [
                    (rest.motion.time, wanted.motion.time),
                    (rest.motion.distance, wanted.motion.distance),
                    (rest.motion.angle, wanted.motion.angle),
                ] {
                    assert!(relative(got, wanted) < 1e-13, "{place}");
                }
            }
        }
    }
}
