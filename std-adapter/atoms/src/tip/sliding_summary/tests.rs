//! Loops whose friction is known.

use super::*;
use crate::tip::scene::DriveKind;
use tribos_base::results::Summary;

const SPACING: f64 = 1.2;
const STROKE: f64 = 6.0;

fn scene(stroke: Option<f64>, drive_time: f64) -> TipScene {
    TipScene {
        drive: DriveKind::Slide,
        spacing: SPACING,
        speed: Some(0.5),
        stroke,
        time_step: 0.01,
        drive_time,
        ..TipScene::default()
    }
}

/// A force along the path that turns its sign with the motion, at 0.05 of time.
fn looks(time: f64, force: impl Fn(f64) -> f64) -> Vec<SlidingSample> {
    let count = (time / 0.05).round() as i32;
    (-20..=count)
        .map(|k| {
            let time = 0.05 * f64::from(k);
            let path = 0.5 * time.max(0.0);
            let number = (path / STROKE).floor();
            let part = path - STROKE * number;
            let (support, sign) = if number % 2.0 == 0.0 {
                (part, 1.0)
            } else {
                (STROKE - part, -1.0)
            };
            SlidingSample {
                time,
                support,
                force: sign * force(part),
                normal: 40.0,
            }
        })
        .collect()
}

/// A saw-tooth between 1 and 3 whose teeth are a spacing long.
fn saw(x: f64) -> f64 {
    1.0 + 2.0 * (x / SPACING).fract()
}

#[test]
fn a_saw_tooth_has_its_mean_its_period_and_its_slips() {
    for sign in [1.0, -1.0] {
        let scene = scene(Some(STROKE), 36.0);
        let slid = SlidingSummary::of(
            &scene,
            &looks(36.0, |x| sign * saw(x)),
            &LoopWork::default(),
        );
        assert_eq!(slid.strokes, 3);
        // Half a stroke is two teeth and a half: means of 2 for four halves, of 2.5 for the last.
        let expected = sign * 2.1;
        assert!((slid.friction_forth - expected).abs() < 0.05, "{slid:?}");
        assert!((slid.friction_back - expected).abs() < 0.05, "{slid:?}");
        assert!((slid.period / SPACING - 1.0).abs() < 0.05, "{slid:?}");
        // The first harmonic of a saw-tooth has 6/π² of its variance.
        assert!((slid.period_share - 0.61).abs() < 0.08, "{slid:?}");
        assert_eq!(slid.normal_force, 40.0);
        if sign > 0.0 {
            // Drops at 2.4, 3.6 and 4.8 of each stroke; the one at 6 is its end.
            assert_eq!(slid.slips, 9);
            assert!((slid.peak_force - 2.96).abs() < 0.05, "{slid:?}");
        }
    }
}

#[test]
fn a_loop_is_what_the_support_did_between_every_second_turning_point() {
    let ends = [(1.0, 10.0, -7.0), (21.0, 25.0, -4.0)];
    let loops = LoopWork {
        ends: ends
            .map(|(work, heat, energy)| Totals { work, heat, energy })
            .to_vec(),
        turns: vec![3.0, 5.0, 11.0, 14.0, 20.0],
    };
    let slid = SlidingSummary::of(&scene(Some(STROKE), 60.0), &looks(60.0, saw), &loops);
    assert_eq!((slid.strokes, slid.loops), (5, 2));
    assert_eq!(slid.loop_work, 0.5 * (8.0 + 9.0));
    assert_eq!(slid.friction, 8.5 / 12.0);
    assert_eq!((slid.work, slid.heat, slid.stored), (20.0, 15.0, 3.0));
    assert_eq!(slid.imbalance, 0.1);
}

#[test]
fn what_a_run_has_not_is_no_number() {
    let none = SlidingSummary::of(
        &scene(Some(STROKE), 5.0),
        &looks(5.0, saw),
        &LoopWork::default(),
    );
    assert_eq!((none.strokes, none.loops, none.slips), (0, 0, 0));
    assert!(none.friction.is_nan() && none.period.is_nan() && none.work.is_nan());
    assert!(none.entries()["friction"].as_f64().is_none());
    // Without turning points the whole way is one stroke.
    let far = SlidingSummary::of(&scene(None, 12.0), &looks(12.0, saw), &LoopWork::default());
    assert_eq!((far.strokes, far.loops), (1, 0));
    assert!(far.friction_back.is_nan() && far.friction_forth > 1.0);
}
