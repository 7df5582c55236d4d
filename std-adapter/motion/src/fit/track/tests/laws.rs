//! Other laws and patches, from motions in closed form and from the journey in the plane.

use super::filmed::{GRAVITY, RATE, normal};
use super::*;
use crate::fit::Uncertainty;
use crate::slide::Launch;
use crate::slide::planar::{PlanarSimulation, PlanarState, Plate};

/// A body that goes straight on without spin, with noise of 0.2 mm.
fn straight(way: impl Fn(f64) -> f64, frames: u32) -> Track {
    let mut random = Random::new(5, 0);
    let times: Vec<f64> = (0..frames).map(|k| f64::from(k) / RATE).collect();
    let x = times
        .iter()
        .map(|t| way(*t) + 2e-4 * normal(&mut random))
        .collect();
    let y = times.iter().map(|_| 2e-4 * normal(&mut random)).collect();
    Track::new(times, x, y, None).unwrap()
}

fn assert_within_errors(fit: &TrackFit, truths: &[(&str, f64)]) {
    for (name, truth) in truths {
        let [low, high] = fit.estimate(name).unwrap().interval;
        let middle = fit.value(name).unwrap();
        let room = (high - low) * 0.5;
        assert!(
            (middle - truth).abs() < 2.0 * room && room < 0.2 * truth.abs(),
            "{name}: {middle} in {low}..{high}"
        );
    }
}

/// dv/dt = −g (μ + k v) has v = (v₀ + μ/k) e^(−kgt) − μ/k.
#[test]
fn a_film_of_oil_gives_its_viscous_part() {
    let (mu, k, speed) = (0.05_f64, 0.1_f64, 2.0_f64);
    let rest = (1.0 + k * speed / mu).ln() / (k * GRAVITY);
    let way = |t: f64| {
        let t = t.min(rest);
        (speed + mu / k) * (1.0 - (-k * GRAVITY * t).exp()) / (k * GRAVITY) - mu / k * t
    };
    let options = TrackOptions {
        law: TrackLaw::Viscous,
        fixed: vec![("ratio".into(), 1e3)],
        ..TrackOptions::default()
    };
    let track = straight(way, 110);
    let fit = fit_track(&track, &options).unwrap();
    assert_within_errors(&fit, &[("mu", mu), ("k", k), ("vx", speed)]);
    assert!((fit.rest_time.unwrap() - rest).abs() < 0.01);
    // Coulomb's law does not fit, and says so.
    let options = TrackOptions {
        law: TrackLaw::Coulomb,
        ..options
    };
    let fit = fit_track(&track, &options).unwrap();
    assert!(
        fit.warnings
            .iter()
            .any(|said| said.contains("follow each other")),
        "{:?}",
        fit.warnings
    );
}

/// dv/dt = −g (μ_d + (μ_s − μ_d) e^(−(v/v_s)²)) in steps of 10 µs.
#[test]
fn a_boundary_layer_gives_friction_at_rest() {
    const STEP: f64 = 1e-5;
    let (rest, boundary, knee) = (0.30_f64, 0.15_f64, 0.4_f64);
    let (mut places, mut speed, mut place) = (vec![0.0], 1.5_f64, 0.0);
    for k in 1..=150_000_u32 {
        let friction =
            |v: f64| GRAVITY * (boundary + (rest - boundary) * (-(v / knee) * (v / knee)).exp());
        let middle = speed - 0.5 * STEP * friction(speed);
        let next = (speed - STEP * friction(middle)).max(0.0);
        place += 0.5 * STEP * (speed + next);
        speed = next;
        if k % 100 == 0 {
            places.push(place);
        }
    }
    let way = |t: f64| {
        let at = (t / (100.0 * STEP)).min(places.len() as f64 - 2.0);
        let (k, share) = (at as usize, at.fract());
        places[k] + share * (places[k + 1] - places[k])
    };
    let options = TrackOptions {
        law: TrackLaw::Stribeck,
        fixed: vec![("ratio".into(), 1e3)],
        ..TrackOptions::default()
    };
    let fit = fit_track(&straight(way, 80), &options).unwrap();
    for (name, truth) in [
        ("mu_s", rest),
        ("mu_d", boundary),
        ("vs", knee),
        ("vx", 1.5),
    ] {
        let found = fit.estimate(name).unwrap();
        let [low, high] = found.interval;
        assert!(low < truth && truth < high, "{name}: {found:?}");
        let Uncertainty::StandardError(error) = found.known else {
            panic!("{name}: {found:?}");
        };
        // Nearly linear: the interval is some four errors long.
        let length = (high - low) / error;
        assert!((3.0..6.0).contains(&length), "{name}: {found:?}");
        assert!(high - low < truth, "{name}: {found:?}");
    }
}

/// dv/dt = −g γ v^α has v^(1−α) = v₀^(1−α) − (1−α) g γ t.
#[test]
fn ice_gives_its_exponent() {
    let (gamma, alpha, speed) = (0.02, -0.5, 2.0_f64);
    let beta = 1.0 - alpha;
    let rate = beta * GRAVITY * gamma;
    let start = speed.powf(beta);
    let way = |t: f64| {
        let left = (start - rate * t).max(0.0);
        (start.powf(1.0 + 1.0 / beta) - left.powf(1.0 + 1.0 / beta)) / (rate * (1.0 + 1.0 / beta))
    };
    let options = TrackOptions {
        law: TrackLaw::Power,
        fixed: vec![("ratio".into(), 1e3)],
        starts: 2,
        ..TrackOptions::default()
    };
    let fit = fit_track(&straight(way, 600), &options).unwrap();
    assert_within_errors(&fit, &[("gamma", gamma), ("alpha", alpha), ("vx", speed)]);
}

#[test]
fn a_box_gives_its_coefficient_and_spin() {
    let flat: tribos_friction::FlatPatch = "box:0.12x0.06".parse().unwrap();
    let plate = Plate::new(flat.loaded(None).unwrap(), 0.25, GRAVITY).unwrap();
    let launch = Launch {
        velocity: [1.2, 0.4],
        spin: 9.0,
    };
    let times: Vec<f64> = (0..50).map(|k| f64::from(k) / RATE).collect();
    let mut seen: Vec<PlanarState> = Vec::new();
    let plate = plate.with_orientation(0.3);
    let journey = PlanarSimulation::new(&plate, &launch, 1e-6).unwrap();
    let end = journey
        .follow(&times, |point| seen.push(*point))
        .unwrap()
        .point;
    let at = |t: &f64| {
        let same = seen.iter().find(|point| (point.time - t).abs() < 1e-12);
        *same.unwrap_or(&end)
    };
    let mut random = Random::new(6, 0);
    let mut column = |of: &dyn Fn(PlanarState) -> f64, noise: f64| -> Vec<f64> {
        times
            .iter()
            .map(|t| of(at(t)) + noise * normal(&mut random))
            .collect()
    };
    let x = column(&|point| point.position[0], 1e-3);
    let y = column(&|point| point.position[1], 1e-3);
    let angle = column(&|point| 0.3 + point.angle, 0.01);
    let track = Track::new(times.clone(), x, y, Some(angle)).unwrap();
    let options = TrackOptions {
        patch: "box:0.12x0.06".parse().unwrap(),
        starts: 2,
        ..TrackOptions::default()
    };
    let fit = fit_track(&track, &options).unwrap();
    assert_within_errors(
        &fit,
        &[
            ("mu", 0.25),
            ("vx", 1.2),
            ("vy", 0.4),
            ("spin", 9.0),
            ("angle0", 0.3),
        ],
    );
}
