//! The mean age of a renewal process whose intervals have Erlang's distribution.
//!
//! An interval is made of n exponential stages of the rate n, so that its mean is 1. By the time t a Poisson
//! number K of stages, of the mean n t, has passed, and the place of the last renewal among them is
//! that of a uniform one. The mean age follows as a sum of positive terms,
//!
//! ```text
//! A(t) = Σ P(K) g(K)/n,   g(K) = 1 + (K − 1) mod n, g(0) = 0;      A'(t) = 1 − n Σ P(i n), i ≥ 1
//! ```
//!
//! Later the poles z = exp(2πi j/n) − 1 of its Laplace transform are quicker,
//!
//! ```text
//! A(t) = (n + 1)/(2n) − exp(−n t) − Σ exp(n t z)/(n z),      A'(t) = n exp(−n t) − Σ exp(n t z)
//! ```
//!
//! *Source*: D. R. Cox, Renewal Theory (1962), for the process; both sums are derived here.

use crate::real::Real;
use core::num::NonZeroU32;

/// From this time on the poles serve.
const POLES_FROM: f64 = 2.0;
/// A pole whose term has decayed by this many e-folds is below every rounding error.
const DECAYED: f64 = 45.0;

/// Mean age at a time, and its derivative.
pub(super) struct MeanAge<R> {
    pub age: R,
    pub rate: R,
}

/// The mean age at `time` of a process with intervals of `stages` stages and mean 1.
///
/// *Accuracy*: age 1e-14 relative, rate 1e-14 of `stages` (f32: 1e-5). *Special values*: age 0 and rate 1 at
/// time 0; the steady age (n + 1)/(2n) at infinite time.
pub(super) fn mean_age<R: Real>(stages: NonZeroU32, time: R) -> MeanAge<R> {
    if time < R::from_f64(POLES_FROM) {
        by_counts(stages, time)
    } else if time < R::INFINITY {
        by_poles(stages, time)
    } else {
        // Infinite, or NaN, which stays.
        let rest = R::ONE / time;
        MeanAge {
            age: steady_age::<R>(stages) + rest,
            rate: rest,
        }
    }
}

/// (n + 1)/(2n)
pub(super) fn steady_age<R: Real>(stages: NonZeroU32) -> R {
    let n = R::from_f64(f64::from(stages.get()));
    R::HALF * (n + R::ONE) / n
}

/// Sums over the number of stages that have passed.
struct PoissonSums<R> {
    weight: R,
    /// Σ w g
    stage: R,
    /// Weight of the counts at which a renewal has just happened.
    renewed: R,
}

impl<R: Real> PoissonSums<R> {
    fn add(&mut self, stages: NonZeroU32, count: u32, weight: R) {
        self.weight += weight;
        if count > 0 {
            let past = (count - 1) % stages;
            self.stage += weight * (R::ONE + R::from_f64(f64::from(past)));
            if past == stages.get() - 1 {
                self.renewed += weight;
            }
        }
    }
}

/// The mean age by the Poisson weights, from the likeliest count outwards.
fn by_counts<R: Real>(stages: NonZeroU32, time: R) -> MeanAge<R> {
    let n = R::from_f64(f64::from(stages.get()));
    let mean = n * time;
    let mode = mean.to_f64() as u32;
    let least = R::EPSILON * R::EPSILON;
    let mut counts = PoissonSums {
        weight: R::ZERO,
        stage: R::ZERO,
        renewed: R::ZERO,
    };
    counts.add(stages, mode, R::ONE);
    let (mut weight, mut count) = (R::ONE, mode);
    while weight > least && count < u32::MAX {
        count += 1;
        weight *= mean / R::from_f64(f64::from(count));
        counts.add(stages, count, weight);
    }
    (weight, count) = (R::ONE, mode);
    while weight > least && count > 0 {
        weight *= R::from_f64(f64::from(count)) / mean;
        count -= 1;
        counts.add(stages, count, weight);
    }
    MeanAge {
        age: counts.stage / counts.weight / n,
        rate: R::ONE - n * (counts.renewed / counts.weight),
    }
}

/// The mean age by the poles that have not decayed.
fn by_poles<R: Real>(stages: NonZeroU32, time: R) -> MeanAge<R> {
    let n = R::from_f64(f64::from(stages.get()));
    let mean = n * time;
    let gone = (-mean).exp();
    let (mut age, mut rate) = (steady_age::<R>(stages) - gone, n * gone);
    for j in 1..=stages.get() / 2 {
        let half = R::PI * R::from_f64(f64::from(j)) / n;
        let (sin, cos) = (half.sin(), half.cos());
        // z = a + i b
        let (a, b) = (-R::TWO * sin * sin, R::TWO * sin * cos);
        if -(mean * a) > R::from_f64(DECAYED) {
            break;
        }
        // The pole at −2 of an even number of stages has no partner.
        let is_single = stages.get() - j == j;
        let decay = (mean * a).exp() * if is_single { R::ONE } else { R::TWO };
        let (real, imaginary) = ((mean * b).cos(), (mean * b).sin());
        age -= decay * (a * real + b * imaginary) / (a * a + b * b) / n;
        rate -= decay * real;
    }
    MeanAge { age, rate }
}

#[cfg(test)]
mod tests {
    use super::*;

    const STAGES: [u32; 8] = [1, 2, 3, 5, 8, 16, 64, 1000];

    fn stages(n: u32) -> NonZeroU32 {
        NonZeroU32::new(n).unwrap()
    }

    #[test]
    fn counts_and_poles_agree_where_they_meet() {
        for n in STAGES.map(stages) {
            for time in [1.6, 2.0, 2.3] {
                let (counts, poles) = (by_counts::<f64>(n, time), by_poles::<f64>(n, time));
                assert!((counts.age - poles.age).abs() < 2e-14, "{n} {time}");
                let rate = (counts.rate - poles.rate).abs() / f64::from(n.get());
                assert!(rate < 2e-14, "{n} {time} {rate:e}");
            }
        }
    }

    /// A' of one stage is exp(−t), of two stages 2 exp(−2t) − exp(−4t).
    #[test]
    fn few_stages_have_elementary_ages() {
        for time in [0.0_f64, 1e-9, 0.1, 0.7, 1.99, 2.0, 3.0, 11.0, 700.0] {
            let one = mean_age(stages(1), time);
            assert!((one.age + Real::exp_m1(-time)).abs() <= 1e-15 * one.age);
            assert!((one.rate - Real::exp(-time)).abs() < 1e-15);
            let two = mean_age(stages(2), time);
            let age = 0.75 - Real::exp(-2.0 * time) + 0.25 * Real::exp(-4.0 * time);
            assert!((two.age - age).abs() < 2e-16, "{time} {} {age}", two.age);
            let rate = 2.0 * Real::exp(-2.0 * time) - Real::exp(-4.0 * time);
            assert!((two.rate - rate).abs() < 1e-15);
        }
    }

    #[test]
    fn a_young_process_is_as_old_as_the_time() {
        for n in STAGES.map(stages) {
            let young = mean_age(n, 1e-12_f64);
            let share = if n.get() == 1 { 0.5e-12 } else { 0.0 };
            assert!((young.age / 1e-12 - (1.0 - share)).abs() < 1e-15);
            assert_eq!(mean_age(n, 0.0_f64).age, 0.0);
            assert_eq!(mean_age(n, 0.0_f32).rate, 1.0);
        }
    }

    #[test]
    fn the_steady_age_comes_at_last_and_nan_stays() {
        for n in STAGES.map(stages) {
            let steady = f64::from(n.get() + 1) / f64::from(2 * n.get());
            for time in [1e6, 1e300, f64::INFINITY] {
                let late = mean_age(n, time);
                assert!((late.age - steady).abs() < 1e-15 && late.rate.abs() < 1e-13);
            }
            assert!(mean_age(n, f64::NAN).age.is_nan());
            assert!(mean_age(n, f32::NAN).rate.is_nan());
        }
    }
}
