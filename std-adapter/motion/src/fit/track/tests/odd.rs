//! Films as people bring them: hands, gaps, outliers, wrapped angles, and what cannot be fitted.

use super::filmed::{DISK, Filmed, RATE};
use super::*;
use crate::fit::Uncertainty;

pub const PUCK: Filmed = Filmed {
    mu: 0.2,
    radius: 0.04,
    speed: 1.5,
    direction: 0.5,
    spin: 25.0,
    noise: [1e-3, 0.02],
};

pub fn film(body: &Filmed, has_angle: bool) -> Track {
    DISK.film(body, &mut Random::new(3, 0), has_angle)
}

/// The same film with other columns.
fn changed(track: &Track, change: impl Fn(usize, [f64; 4]) -> [f64; 4]) -> Track {
    let angle = track.angle().unwrap_or_default();
    let rows = (0..track.times().len()).map(|i| {
        let angle = angle.get(i).copied().unwrap_or(0.0);
        change(i, [track.times()[i], track.x()[i], track.y()[i], angle])
    });
    let rows: Vec<[f64; 4]> = rows.collect();
    let column = |k: usize| rows.iter().map(|row| row[k]).collect::<Vec<f64>>();
    let angle = track.angle().map(|_| column(3));
    Track::new(column(0), column(1), column(2), angle).unwrap()
}

pub fn fitted(track: &Track) -> TrackFit {
    fit_track(track, &TrackOptions::default()).unwrap()
}

pub fn assert_near(fit: &TrackFit, name: &str, truth: f64) {
    let estimate = fit.estimate(name).unwrap();
    let Uncertainty::StandardError(error) = estimate.known else {
        panic!("{name}: {estimate:?}");
    };
    assert!(
        (estimate.value - truth).abs() < 4.0 * error,
        "{name}: {} ± {error}",
        estimate.value
    );
    assert!(
        error < 0.1 * truth.abs(),
        "{name}: {} ± {error}",
        estimate.value
    );
}

pub fn assert_said(fit: &TrackFit, part: &str) {
    assert!(
        fit.warnings.iter().any(|said| said.contains(part)),
        "{part}: {:#?}",
        fit.warnings
    );
}

/// What a film says of its columns, every fit of it says as well.
fn assert_noted(track: &Track, part: &str) {
    let notes = track.notes();
    assert!(notes.iter().any(|note| note.contains(part)), "{notes:?}");
}

#[test]
fn outliers_of_centimetres_are_left_out_and_named() {
    let clean = film(&PUCK, true);
    let wrong = [7, 30];
    let track = changed(&clean, |i, [t, x, y, angle]| {
        let jump = if wrong.contains(&i) { 0.03 } else { 0.0 };
        [t, x + jump, y - jump, angle]
    });
    let [clean, found] = [&clean, &track].map(fitted);
    assert_eq!(found.dropped, wrong);
    assert_said(&found, "2 of ");
    for name in ["mu", "R", "vx", "vy", "spin"] {
        let estimate = clean.estimate(name).unwrap();
        let Uncertainty::StandardError(error) = estimate.known else {
            panic!("{name}")
        };
        assert!(
            (found.value(name).unwrap() - estimate.value).abs() < error,
            "{name}"
        );
    }
    // A tenth of the frames is too many to be left out.
    let track = changed(&track, |i, [t, x, y, angle]| {
        [t, if i % 10 == 0 { x + 0.05 } else { x }, y, angle]
    });
    let found = fitted(&track);
    assert!(found.dropped.is_empty());
    assert_said(&found, "more than 5 %");
}

#[test]
fn angles_of_one_turn_are_counted_on_and_degrees_are_suspected() {
    let body = PUCK;
    let track = film(&body, true);
    let turn = std::f64::consts::TAU;
    let wrapped = |angle: f64| angle - turn * (angle / turn).round();
    let one_turn = changed(&track, |_, [t, x, y, angle]| [t, x, y, wrapped(angle)]);
    let found = fitted(&one_turn);
    assert_said(&found, "jumps by a turn");
    assert_near(&found, "R", body.radius);
    assert_near(&found, "spin", body.spin);
    let degrees = changed(&track, |_, [t, x, y, angle]| {
        [t, x, y, wrapped(angle).to_degrees()]
    });
    assert_noted(&degrees, "give --units angle=deg");
}

#[test]
fn gaps_and_rest_are_no_trouble() {
    let track = film(&PUCK, true);
    let kept: Vec<usize> = (0..track.times().len())
        .filter(|i| !(12..25).contains(i))
        .collect();
    let of = |column: &[f64]| kept.iter().map(|&i| column[i]).collect::<Vec<f64>>();
    let gap = Track::new(
        of(track.times()),
        of(track.x()),
        of(track.y()),
        track.angle().map(of),
    );
    let found = fitted(&gap.unwrap());
    assert_near(&found, "mu", PUCK.mu);
    assert_near(&found, "R", PUCK.radius);
}

#[test]
fn a_hand_that_still_pushes_is_noticed() {
    let track = film(&PUCK, true);
    // Ten frames at rest and ten that get up to speed, before the launch.
    let before = 20;
    let first = [track.times()[0], track.x()[0], track.y()[0]];
    let way = |k: usize| {
        let left = (before - k) as f64 / RATE;
        let slow = 1.0 / RATE * 10.0;
        if left > slow {
            -0.5 * slow * 1.5
        } else {
            -1.5 * (left - 0.5 * left * left / slow)
        }
    };
    let hand = (0..before).map(|k| {
        let s = way(k);
        [
            first[0] - (before - k) as f64 / RATE,
            first[1] + 0.878 * s,
            first[2] + 0.479 * s,
            0.7,
        ]
    });
    let film = (0..track.times().len()).map(|i| {
        [
            track.times()[i],
            track.x()[i],
            track.y()[i],
            track.angle().unwrap()[i],
        ]
    });
    let rows: Vec<[f64; 4]> = hand.chain(film).collect();
    let column = |k: usize| rows.iter().map(|row| row[k]).collect::<Vec<f64>>();
    let all = Track::new(column(0), column(1), column(2), Some(column(3))).unwrap();
    assert_said(&fitted(&all), "a hand may still hold it");
    let options = TrackOptions {
        from: Some(first[0]),
        ..TrackOptions::default()
    };
    let found = fit_track(&all, &options).unwrap();
    assert_eq!(found.parameters, fitted(&track).parameters);
}

#[test]
fn what_the_film_does_not_tell_is_said() {
    let still = Filmed { spin: 0.0, ..PUCK };
    let one_start = TrackOptions {
        starts: 1,
        ..TrackOptions::default()
    };
    let found = fit_track(&film(&still, true), &one_start).unwrap();
    assert_said(&found, "hardly spins tells nothing");
    let track = film(&PUCK, true);
    let options = TrackOptions {
        to: Some(track.times()[25]),
        ..TrackOptions::default()
    };
    assert_said(&fit_track(&track, &options).unwrap(), "the film ends while");
    let bent = changed(&track, |i, [t, x, y, angle]| {
        let share = (i as f64 / 35.0).min(1.0);
        let aside = 0.02 * share * share;
        [t, x - 0.479 * aside, y + 0.878 * aside, angle]
    });
    assert_said(&fitted(&bent), "bends to the left");
    let counted = changed(&track, |i, [_, x, y, angle]| [i as f64, x, y, angle]);
    assert_noted(&counted, "--frame-rate");
}

#[test]
fn films_that_tell_nothing_are_refused_with_their_cure() {
    let track = film(&PUCK, true);
    let few = |frames: usize| {
        let of = |column: &[f64]| column[..frames].to_vec();
        Track::new(
            of(track.times()),
            of(track.x()),
            of(track.y()),
            track.angle().map(of),
        )
        .unwrap()
    };
    let refused = |track: &Track, options: &TrackOptions| match fit_track(track, options) {
        Err(error) => error.to_string(),
        Ok(fit) => panic!("{fit:?}"),
    };
    let usual = TrackOptions::default();
    assert!(refused(&few(2), &usual).contains("more points"));
    let late = TrackOptions {
        from: Some(1e3),
        ..usual.clone()
    };
    assert!(refused(&track, &late).contains("no frames are left"));
    let rest = TrackOptions {
        skip: track.times().len() - 8,
        ..usual.clone()
    };
    assert!(refused(&track, &rest).contains("rests"));
    assert!(refused(&film(&PUCK, false), &rest).contains("rests"));
    let edges = TrackOptions {
        patch: "box:0.1x0.06".parse().unwrap(),
        ..usual.clone()
    };
    assert!(refused(&film(&PUCK, false), &edges).contains("column angle"));
    let slick = TrackOptions {
        law: TrackLaw::Viscous,
        ..edges
    };
    assert!(refused(&track, &slick).contains("coulomb"));
    let back = Track::new(vec![0.0, 0.1, 0.1], vec![0.0; 3], vec![0.0; 3], None);
    assert!(matches!(back, Err(FitError::Point { point: 2, .. })));
}
