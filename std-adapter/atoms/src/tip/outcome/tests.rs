//! Series whose outcome is known.

use super::*;
use crate::tip::scene::TipScene;

/// Lines with the angles of layers from column 7 on, and a work of 60.
fn seen(scene: &TipScene, lines: &[Vec<f64>]) -> TipSummary {
    let measured = Measured {
        lines,
        layers: 7,
        loops: &LoopWork::default(),
        work: 60.0,
        samples: lines.len(),
    };
    TipSummary::of(scene, &measured)
}

/// A drive from 0 to 100 and a rest to 160, four layers, a line each τ from −10 on.
fn outcome(angles: impl Fn(f64) -> [f64; 5], until: i32) -> TipSummary {
    let text = "body = \"tip\"\nlambda = 1\ntip_layers = 4\nequilibration = 10\ndrive_time = 100\n\
                rest_time = 60\ntime_step = 0.01";
    let scene = TipScene::parse("tip.toml", text, &[]).unwrap();
    let line = |time: i32| {
        let time = f64::from(time);
        let [driven, layers @ ..] = angles(time);
        // Time, angle, torque, height, two temperatures, energy.
        let mut line = vec![time, driven, 0.0, 0.0, 0.1, 0.2, -1.0];
        line.extend(layers);
        line
    };
    let series: Vec<Vec<f64>> = (-10..=until).map(line).collect();
    seen(&scene, &series)
}

/// Turned by so much while driven and so much after it, all layers alike.
fn alike(driven: f64, after: f64) -> TipSummary {
    let angle = move |time: f64| {
        if time <= 100.0 {
            driven * time / 100.0
        } else {
            after
        }
    };
    outcome(move |time| [angle(time); 5], 160)
}

#[test]
fn the_last_angle_tells_whether_the_tip_turned_back() {
    assert_eq!(alike(5.0, 0.9).verdict, Reversal::Reversible);
    assert_eq!(alike(-5.0, -0.9).verdict, Reversal::Reversible);
    assert_eq!(alike(5.0, 1.1).verdict, Reversal::Irreversible);
    assert_eq!(alike(-5.0, -1.1).verdict, Reversal::Irreversible);
    assert_eq!(outcome(|_| [0.0; 5], 159).verdict, Reversal::Open);
}

#[test]
fn without_a_rest_nothing_is_known() {
    let text = "body = \"tip\"\nlambda = 1\nequilibration = 0\ndrive_time = 1\nrest_time = 0";
    let scene = TipScene::parse("tip.toml", text, &[]).unwrap();
    let series = [vec![0.0; 13], [vec![1.0], vec![0.0; 12]].concat()];
    assert_eq!(seen(&scene, &series).verdict, Reversal::Open);
}

#[test]
fn angles_are_means_over_the_last_twenty_of_each_stage() {
    let ramp = alike(-50.0, -7.0);
    // The mean of 80, 81 … 100 hundredths.
    assert!((ramp.driven_angle_degrees + 45.0).abs() < 1e-12);
    assert!((ramp.final_angle_degrees + 7.0).abs() < 1e-12);
    assert_eq!(ramp.largest_angle_degrees, -50.0);
    assert!((ramp.tip_temperature - 0.2).abs() < 1e-12);
    assert_eq!(ramp.samples, 171);
    let early = outcome(|time| [if time < 140.0 { 9.0 } else { 0.0 }; 5], 160);
    assert_eq!(
        (early.verdict, early.final_angle_degrees),
        (Reversal::Reversible, 0.0)
    );
}

#[test]
fn layers_that_slipped_are_those_whose_angles_differ() {
    // The contact and the upper interface; the third differs too little.
    let end = [9.0, 3.0, 3.0, 9.0, 9.75];
    let run = outcome(
        |time| {
            if time > 100.0 {
                end
            } else {
                [0.0, 0.0, 5.0, 5.0, 5.0]
            }
        },
        160,
    );
    assert_eq!(run.layer_angles_degrees, [3.0, 3.0, 9.0, 9.75]);
    assert_eq!(run.slipped_interfaces, [0, 2]);
    assert_eq!(run.slipped_interfaces_while_driven, [1]);
}

#[test]
fn plateaus_are_where_the_angle_stands_while_driven() {
    let stairs = |time: f64| match time {
        // Before the drive, and a stand too short to count.
        t if t < 0.0 => 0.3,
        t if t < 10.0 => 5.0 * t,
        t if t <= 40.0 => 60.0 + 0.4 * (t % 2.0),
        t if t < 50.0 => 70.0 + 5.0 * (t - 40.0),
        t if t <= 60.0 => 120.0,
        t if t < 70.0 => 130.0 + 5.0 * (t - 60.0),
        _ => 180.0,
    };
    let run = outcome(|time| [stairs(time); 5], 160);
    let times: Vec<[f64; 2]> = run.plateaus.iter().map(|p| [p.from, p.to]).collect();
    assert_eq!(times, [[10.0, 40.0], [70.0, 100.0]]);
    // 16 lines at 60 and 15 at 60.4.
    assert!((run.plateaus[0].angle_degrees - (60.0 + 0.4 * 15.0 / 31.0)).abs() < 1e-12);
    assert_eq!(run.plateaus[1].angle_degrees, 180.0);
    assert_eq!(alike(500.0, 0.0).plateaus, []);
}

#[test]
fn work_is_moment_times_angle_and_what_is_not_stored_is_heat() {
    let text = "body = \"tip\"\nlambda = 1\ntip_layers = 4\nequilibration = 30\ndrive_time = 100\n\
                rest_time = 60\ntime_step = 0.01";
    let scene = TipScene::parse("tip.toml", text, &[]).unwrap();
    // An angle of 2 rad and a rise by 40, of which 25 come back.
    let line = |time: i32| {
        let (angle, potential) = match time {
            ..=0 => (0.5, -100.0),
            1..=100 => (2.5, -60.0),
            _ => (0.5, -85.0),
        };
        [
            f64::to_degrees(angle),
            0.0,
            0.0,
            0.1,
            0.2,
            potential,
            0.0,
            0.0,
            0.0,
            0.0,
        ]
        .iter()
        .fold(vec![f64::from(time)], |line, &x| [line, vec![x]].concat())
    };
    // The last lines of a stage belong to it.
    let series: Vec<Vec<f64>> = (-30..=160).map(line).collect();
    let energy = seen(&scene, &series).drive_energy;
    assert_eq!(energy.work, 60.0);
    assert!((energy.stored - 40.0).abs() < 1e-12, "{energy:?}");
    assert!((energy.heat - 20.0).abs() < 1e-12, "{energy:?}");
    assert!((energy.released - 25.0).abs() < 1e-12, "{energy:?}");
    assert_eq!(energy.uncertainty, 0.0);
}

#[test]
fn a_summary_is_json_whatever_is_missing() {
    let text = "body = \"tip\"\nlambda = 1";
    let scene = TipScene::parse("tip.toml", text, &[]).unwrap();
    let one = seen(&scene, &[[vec![-50.0], vec![0.0; 12]].concat()]);
    let json = one.json(&scene);
    assert_eq!(json["verdict"], "open");
    assert!(json["final_angle_degrees"].as_f64().is_none());
    assert_eq!(json["samples"], 1);
}
