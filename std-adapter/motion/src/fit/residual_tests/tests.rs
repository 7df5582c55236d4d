//! Golden values of statsmodels and scipy, and rates over many seeded series.

use super::*;
use tribos_base::random::Random;
use tribos_base::statistics::correlation::{MOST_LAGS, WINDOWS};

/// Normal numbers by Box and Muller.
pub(in crate::fit) fn normal(random: &mut Random) -> f64 {
    let radius = (-2.0 * (1.0 - random.unit()).ln()).sqrt();
    radius * (std::f64::consts::TAU * random.unit()).cos()
}

/// yᵢ = ρ yᵢ₋₁ + noise of unit variance.
fn autoregressive(random: &mut Random, count: usize, rho: f64) -> Vec<f64> {
    let mut y = normal(random) / (1.0 - rho * rho).sqrt();
    let one = |_| {
        y = rho * y + normal(random);
        y
    };
    (0..count).map(one).collect()
}

/// The series of the golden values: a congruential generator of 31 bits, summed with the weight ρ.
fn golden_series(count: usize, rho: f64) -> Vec<f64> {
    let (mut state, mut y) = (12_345_u64, 0.0);
    let one = |_| {
        state = (state * 1_103_515_245 + 12_345) % (1 << 31);
        y = rho * y + (state as f64 / (1_u64 << 31) as f64 - 0.5);
        y
    };
    (0..count).map(one).collect()
}

/// Rows, ρ; and statsmodels 0.14 `runstest_1samp(cutoff=0, correction=False)` (z, p) and `acf` (lag 1 and, summed
/// to Sokal's window, τ), scipy 1.17 `linregress` (slope, and z with the τ of what it leaves) and
/// `median_abs_deviation(scale="normal")`.
const GOLDEN: [(usize, f64, [f64; 7]); 4] = [
    (
        61,
        0.0,
        [
            1.7433543651461532,
            0.08127173443742157,
            -0.08734294605402312,
            0.5504602884728919,
            -0.0010985965522361738,
            -0.5447444572000102,
            0.2632294149932789,
        ],
    ),
    (
        201,
        0.6,
        [
            -5.159933075803045,
            2.470381347344519e-07,
            0.5815728889686459,
            1.521248997995404,
            0.0004031540712969181,
            0.5297769027617812,
            0.4005976102785177,
        ],
    ),
    (
        5001,
        0.9,
        [
            -46.25892557252797,
            0.0,
            0.8841582744638491,
            7.622628302519034,
            8.24054645663778e-06,
            0.34991202504378244,
            0.6221541920171368,
        ],
    ),
    (
        401,
        -0.5,
        [
            6.363333049964229,
            1.9742196276916342e-10,
            -0.5249150884961319,
            0.0,
            -6.289746455444334e-05,
            -0.42860722533566487,
            0.37920199907841995,
        ],
    ),
];

#[test]
fn statistics_are_those_of_other_programs() {
    for (count, rho, wanted) in GOLDEN {
        let found = residual_tests(&golden_series(count, rho), None).unwrap();
        let told = [
            found.runs_z,
            found.runs_p,
            found.lag_one,
            found.correlation_time,
            found.drift,
            found.drift_z,
            found.robust_deviation,
        ];
        for (k, (told, wanted)) in told.into_iter().zip(wanted).enumerate() {
            let off = (told - wanted).abs();
            assert!(
                off <= 1e-11 * wanted.abs().max(1e-3),
                "{count} {k}: {told} {wanted}"
            );
        }
    }
}

#[test]
fn one_of_twenty_series_of_noise_is_suspected() {
    let mut random = Random::new(1, 0);
    let (mut runs, mut drifts) = (0, 0);
    const SERIES: usize = 2000;
    for _ in 0..SERIES {
        let found = residual_tests(&autoregressive(&mut random, 400, 0.0), None).unwrap();
        runs += usize::from(found.runs_p < 0.05);
        drifts += usize::from(found.drift_p < 0.05);
    }
    // 5 % with a standard deviation of 0.5 %; runs are whole numbers, which takes off a little.
    assert!((70..=130).contains(&runs), "{runs}");
    assert!((70..=130).contains(&drifts), "{drifts}");
}

#[test]
fn correlated_series_have_their_correlation_time_and_no_drift() {
    let mut random = Random::new(2, 0);
    for rho in [0.0, 0.5, 0.9, 0.99] {
        let wanted: f64 = 0.5 * (1.0 + rho) / (1.0 - rho);
        let count = 200_000;
        let found = residual_tests(&autoregressive(&mut random, count, rho), None).unwrap();
        // Sokal 1989, (3.19): the variance of τ is 2 (2 W + 1)/n τ². The window leaves a bias of e⁻⁵.
        let spread = (2.0 * (10.0 * wanted + 1.0) / count as f64).sqrt();
        let off = found.correlation_time / wanted - 1.0;
        assert!(off.abs() < 4.0 * spread + 0.01, "{rho}: {off}");
        assert_eq!(found.notes().is_empty(), rho == 0.0, "{:?}", found.notes());
        assert!((found.error_factor - (2.0 * found.correlation_time).sqrt()).abs() < 1e-12);
    }
    // Means of pairs give the sum over lags of the rows.
    let left = autoregressive(&mut random, 40_000, 0.99);
    let rows = Autocorrelation::of(left.clone()).unwrap();
    let (mut direct, mut lag) = (0.5, 0);
    while (lag as f64) < WINDOWS * direct {
        lag += 1;
        direct += rows.at(lag);
    }
    let off = correlation_time(left) / direct - 1.0;
    assert!(lag > 4 * MOST_LAGS && off.abs() < 0.02, "{lag} {off}");
    // Slopes of correlated noise are no drift: 5 % and a little for τ from short series.
    let mut drifts = 0;
    for _ in 0..500 {
        let found = residual_tests(&autoregressive(&mut random, 2000, 0.9), None).unwrap();
        drifts += usize::from(found.drift_p < 0.05);
    }
    assert!((12..=50).contains(&drifts), "{drifts}");
}

#[test]
fn a_drift_and_wild_rows_are_seen_whatever_the_unit() {
    let mut random = Random::new(3, 0);
    let mut left = autoregressive(&mut random, 1000, 0.0);
    for (i, r) in left.iter_mut().enumerate() {
        *r += 1e-3 * i as f64;
    }
    for i in [10, 500, 900] {
        left[i] += 15.0;
    }
    let plain = residual_tests(&left, None).unwrap();
    assert!((plain.drift - 1e-3).abs() < 4e-4 && plain.drift_z > 5.0);
    assert_eq!(plain.outliers, 3);
    let notes = plain.notes().join("; ");
    assert!(
        notes.contains("drift by") && notes.contains("3 residuals"),
        "{notes}"
    );
    for unit in [2.0_f64.powi(-800), 2.0_f64.powi(800)] {
        let scaled: Vec<f64> = left.iter().map(|r| r * unit).collect();
        let told = residual_tests(&scaled, None).unwrap();
        assert_eq!(
            (told.runs_z, told.drift_z, told.outliers),
            (plain.runs_z, plain.drift_z, 3)
        );
        assert_eq!(told.drift, plain.drift * unit);
        // Divided by their deviations they are those of the unit 1.
        let sigma = vec![unit; left.len()];
        assert_eq!(residual_tests(&scaled, Some(&sigma)), Some(plain));
    }
}

#[test]
fn what_cannot_be_tested_gives_nothing() {
    assert_eq!(residual_tests(&[0.0; 100], None), None);
    assert_eq!(residual_tests(&[1.0, -1.0, 1.0], None), None);
    let mut wild = golden_series(20, 0.0);
    assert_eq!(residual_tests(&wild, Some(&[1.0])), None);
    wild[3] = f64::NAN;
    assert_eq!(residual_tests(&wild, None), None);
    // One sign: no runs to count.
    let positive: Vec<f64> = (0..20).map(|i| 1.0 + f64::from(i % 3)).collect();
    let told = residual_tests(&positive, None).unwrap();
    assert_eq!((told.runs_z, told.runs_p), (0.0, 1.0));
}

#[test]
fn a_million_residuals_take_a_moment() {
    /// In the optimised build of tests, with room for a busy machine; 0.3 s when it is idle.
    const MOST: f64 = 1.5;
    for rho in [0.0, 0.9, 0.9999] {
        let left = autoregressive(&mut Random::new(4, 0), 1_000_000, rho);
        let start = std::time::Instant::now();
        assert!(residual_tests(&left, None).is_some());
        let took = start.elapsed().as_secs_f64();
        println!("rho {rho}: {took:.3} s");
        assert!(took < MOST, "{rho}: {took} s");
    }
}
