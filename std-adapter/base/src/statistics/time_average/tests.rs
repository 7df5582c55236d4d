//! Means of synthetic records, whose means and correlation are known.

use super::*;
use crate::random::Random;

/// Noise of unit variance with the correlation ρ from line to line.
fn noise(random: &mut Random, count: usize, rho: f64) -> Vec<f64> {
    let mut normal = || {
        let radius = (-2.0 * (1.0 - random.unit()).ln()).sqrt();
        radius * (std::f64::consts::TAU * random.unit()).cos()
    };
    let mut x = normal();
    let one = |_| {
        x = rho * x + (1.0 - rho * rho).sqrt() * normal();
        x
    };
    (0..count).map(one).collect()
}

/// The mean of values at the times 0, 1, 2, …
fn mean_of(values: &[f64]) -> TimeAverage {
    let times: Vec<f64> = (0..values.len()).map(|i| i as f64).collect();
    TimeAverage::of(&times, values, None)
}

#[test]
fn errors_of_correlated_noise_hold_the_mean_as_often_as_they_say() {
    const RECORDS: usize = 1000;
    let mut random = Random::new(1, 0);
    for (rho, count) in [(0.0, 300), (0.5, 1000), (0.9, 2000)] {
        let (mut held, mut effective) = ([0_usize; 2], 0.0);
        for _ in 0..RECORDS {
            let found = mean_of(&noise(&mut random, count, rho));
            for (held, errors) in held.iter_mut().zip([1.0, 1.96]) {
                *held += usize::from(found.mean.abs() < errors * found.error);
            }
            effective += found.effective / RECORDS as f64;
        }
        // Four standard deviations of a binomial number.
        for (held, share) in held.into_iter().zip([0.6827, 0.95]) {
            let spread = 4.0 * (RECORDS as f64 * share * (1.0 - share)).sqrt();
            let off = held as f64 - RECORDS as f64 * share;
            assert!(off.abs() < spread, "{rho}: {held} of {RECORDS}, {share}");
        }
        // 2τ = (1 + ρ)/(1 − ρ).
        let wanted = count as f64 * (1.0 - rho) / (1.0 + rho);
        assert!(
            (effective / wanted - 1.0).abs() < 0.15,
            "{rho}: {effective} {wanted}"
        );
    }
}

#[test]
fn a_constant_has_its_own_bits_and_no_error() {
    for constant in [0.0, 0.1, -3e-200] {
        let found = mean_of(&[constant; 100]);
        assert_eq!((found.mean, found.error, found.from), (constant, 0.0, 0.0));
        assert!(found.settled && found.effective == 99.0);
    }
}

#[test]
fn a_start_that_dies_away_is_left_out() {
    const DECAY: f64 = 50.0;
    let mut random = Random::new(2, 0);
    let (mut missed, mut settled) = (0, 0);
    for _ in 0..200 {
        let mut values = noise(&mut random, 1000, 0.5);
        for (i, x) in values.iter_mut().enumerate() {
            *x += 5.0 + 20.0 * (-(i as f64) / DECAY).exp();
        }
        let found = mean_of(&values);
        assert!(
            found.from > 1.5 * DECAY && found.from < 10.0 * DECAY,
            "{found:?}"
        );
        missed += usize::from((found.mean - 5.0).abs() > 3.0 * found.error);
        settled += usize::from(found.settled);
    }
    // The rule keeps what is as small as the noise: 50 lines of it in 800 shift the mean by an error, and normal numbers of
    // mean 1 are beyond 3 in 2.3 %.
    assert!(missed < 14, "{missed}");
    assert!(settled > 180, "{settled}");
}

#[test]
fn a_drift_is_told_and_the_error_covers_it() {
    let mut random = Random::new(3, 0);
    for rise in [1.0, -100.0] {
        let mut values = noise(&mut random, 2000, 0.5);
        for (i, x) in values.iter_mut().enumerate() {
            *x += rise * i as f64 * 0.01;
        }
        let found = mean_of(&values);
        // At most half is left out: the halves of the rest differ by a quarter of the rise.
        assert!(
            !found.settled && found.error > 0.12 * 20.0 * rise.abs(),
            "{found:?}"
        );
    }
}

#[test]
fn lines_count_by_their_time_and_from_when_they_are_asked_for() {
    // 1 for three seconds, 0 for one, again and again.
    let (mut times, mut values) = (vec![0.0], vec![7.0]);
    for i in 0..200 {
        let is_long = i % 2 == 0;
        times.push(times[i] + if is_long { 3.0 } else { 1.0 });
        values.push(f64::from(u8::from(is_long)));
    }
    let found = TimeAverage::of(&times, &values, Some(0.0));
    assert!((found.mean - 0.75).abs() < 1e-15, "{found:?}");
    // The last long line and the last short one.
    let late = TimeAverage::of(&times, &values, Some(397.0));
    assert_eq!((late.mean, late.from), (0.75, 396.0));
    assert!(TimeAverage::of(&times, &values, Some(400.0)).mean.is_nan());
    // At the start alone nothing is known of the error.
    let start = TimeAverage::of(&[0.0], &[2.0], None);
    assert!(start.mean == 2.0 && start.error.is_nan() && !start.settled);
}

#[test]
fn a_ratio_is_that_of_the_means_with_its_error() {
    // τ = 0.4 P + noise, under a pressure that comes and goes: the mean of τ/P is none, that of τ over that of P is 0.4.
    const RECORDS: usize = 500;
    let mut random = Random::new(5, 0);
    let mut held = 0;
    for _ in 0..RECORDS {
        let pressure: Vec<f64> = (0..400).map(|_| -(1.0 - random.unit()).ln()).collect();
        let shear = noise(&mut random, 400, 0.0);
        let ratio = pressure
            .iter()
            .zip(&shear)
            .map(|(p, noise)| 0.4 + 0.1 * noise / p);
        let ratio: Vec<f64> = ratio.collect();
        let times: Vec<f64> = (0..400).map(f64::from).collect();
        let found = TimeAverage::weighted(&times, &ratio, &pressure, Some(0.0));
        // 0.1/√399 over a mean pressure of 1.
        assert!((found.error / 0.005 - 1.0).abs() < 0.4, "{found:?}");
        held += usize::from((found.mean - 0.4).abs() < found.error);
    }
    let off = held as f64 / RECORDS as f64 - 0.6827;
    assert!(off.abs() < 4.0 * (0.22 / RECORDS as f64).sqrt(), "{held}");
}

#[test]
fn columns_of_a_series_have_their_names() {
    let rows: Vec<[f64; 3]> = (0..20)
        .map(|i| [f64::from(i), f64::from(10 * i), 4.0])
        .collect();
    let all = Averages::of(["time", "step", "height"], &rows, None);
    assert_eq!(all.0.len(), 1);
    assert_eq!(all.get("height").map(|height| height.mean), Some(4.0));
    let told = all.recorded().unwrap_or_default();
    assert_eq!(
        (&told["height"]["mean"], &told["height"]["settled"]),
        (&4.0.into(), &true.into())
    );
}
