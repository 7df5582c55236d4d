//! The standard normal distribution.

use std::f64::consts::{PI, SQRT_2};

/// Newton steps of the quantile; from the middle at most ten are needed within ±3 deviations.
const MOST_STEPS: usize = 40;
/// A step below this size is rounding.
const SMALL: f64 = 1e-15;

/// Share of the distribution below z, Φ(z).
pub(super) fn share(z: f64) -> f64 {
    0.5 * libm::erfc(-z / SQRT_2)
}

/// Density φ(z).
pub(super) fn density(z: f64) -> f64 {
    libm::exp(-0.5 * z * z) / (2.0 * PI).sqrt()
}

/// The z below which a share of the distribution lies. *Domain*: shares of z from −4 to 4. *Accuracy*:
/// 1e-14.
pub(super) fn quantile(share_below: f64) -> f64 {
    // The lower half, where Φ is convex, so that Newton's steps from the middle never overshoot.
    if share_below > 0.5 {
        return -quantile(1.0 - share_below);
    }
    let mut z = 0.0;
    for _ in 0..MOST_STEPS {
        let step = (share(z) - share_below) / density(z);
        z -= step;
        if step.abs() < SMALL {
            break;
        }
    }
    z
}
