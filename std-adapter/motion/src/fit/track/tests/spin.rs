//! Films without the angle: a spin that shows, and none.

use super::filmed::Filmed;
use super::odd::{PUCK, assert_near, assert_said, film, fitted};
use super::*;
use crate::fit::Uncertainty;

/// Where the frames refuse no spin, the motion of the least sum of squares is told.
#[test]
fn without_the_angle_a_spin_that_shows_is_found() {
    for spin in [PUCK.spin, 150.0] {
        let body = Filmed { spin, ..PUCK };
        let found = fitted(&film(&body, false));
        assert_said(&found, "without the angle");
        assert!(found.estimate("R").is_none());
        assert_near(&found, "mu", body.mu);
        assert_near(&found, "ratio", body.speed / (spin * body.radius));
        let [_, most] = found.estimate("ratio").unwrap().interval;
        assert!(most < 2.0, "{most}");
        assert!(!found.warnings.iter().any(|said| said.contains("no spin")));
    }
}

/// A body without spin has x = v t − μ g t²/2. At its final ratio of 0.65 under a coefficient 1.6 times as large it would
/// slow down as uniformly, and in half of these films the least sum of squares is about there.
#[test]
fn without_the_angle_a_body_that_may_not_spin_has_the_coefficient_of_sliding() {
    let tally = Tally::of(6, 8, false, 0.0);
    assert_eq!(tally.failed, 0);
    // In one of twenty films noise looks like a spin.
    assert!(quantile(&tally.mu, 0.8) < 0.01, "{:?}", tally.mu);
}

#[test]
fn errors_and_words_of_a_body_that_may_not_spin_include_spin() {
    let still = Filmed { spin: 0.0, ..PUCK };
    let track = film(&still, false);
    let found = fitted(&track);
    assert!(
        found
            .value("mu")
            .is_some_and(|mu| (mu / still.mu - 1.0).abs() < 0.005)
    );
    assert_said(&found, "a mark on the body");
    // It may as well be one at the final ratio under a larger coefficient, and the errors say so.
    let [mu, ratio] = ["mu", "ratio"].map(|name| found.estimate(name).unwrap());
    let ([low, high], [least, most]) = (mu.interval, ratio.interval);
    assert!(low < PUCK.mu && high > 1.4 * PUCK.mu, "{low} {high}");
    assert!(least < 0.7 && most.is_infinite(), "{least} {most}");
    assert_eq!(ratio.known, Uncertainty::AtBound);
    assert!(
        matches!(mu.known, Uncertainty::StandardError(error) if (3.9..4.1).contains(&((high - low) / error)))
    );
    // The values are those of a body that is known not to spin.
    let options = TrackOptions {
        fixed: vec![("ratio".into(), 1e3)],
        ..TrackOptions::default()
    };
    let known = fit_track(&track, &options).unwrap();
    for (a, b) in found.parameters.iter().zip(&known.parameters) {
        assert!((a.value - b.value).abs() < 1e-7, "{}", a.parameter.name);
    }
    assert!(!known.warnings.iter().any(|said| said.contains("no spin")));
    // Of a radius the film tells the largest spin.
    let options = TrackOptions {
        fixed: vec![("R".into(), still.radius)],
        ..TrackOptions::default()
    };
    let spin = format!(
        "at most {:.4} rad/s",
        found.speeds[0] / (least * still.radius)
    );
    assert_said(&fit_track(&track, &options).unwrap(), &spin);
    // Of a short part of the slide the coefficient has no upper end.
    let options = TrackOptions {
        to: Some(track.times()[20]),
        ..TrackOptions::default()
    };
    let found = fit_track(&track, &options).unwrap();
    let mu = found.estimate("mu").unwrap();
    assert!(mu.interval[0] < still.mu && mu.interval[1].is_infinite());
    assert!((mu.value / still.mu - 1.0).abs() < 0.1, "{}", mu.value);
    assert_eq!(mu.known, Uncertainty::Undetermined(vec!["ratio"]));
    assert!(!found.warnings.iter().any(|said| said.contains("--fix mu")));
}
