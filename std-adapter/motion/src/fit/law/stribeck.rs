//! The Stribeck law μ_d + (μₛ − μ_d) exp(−(v/vₛ)^δ) + k v.

use super::super::parameter::{FitParameter, Model, Range};
use super::{DataRange, between, log_between, order, picked, steady};
use std::borrow::Cow;
use tribos_core::law::{DryFriction, Stribeck, StribeckParameters};

const PARAMETERS: [FitParameter; 5] = [
    FitParameter {
        name: "mu_s",
        unit: "-",
        meaning: "coefficient at rest",
        range: Range::NotNegative,
    },
    FitParameter {
        name: "mu_d",
        unit: "-",
        meaning: "coefficient of the boundary branch",
        range: Range::NotNegative,
    },
    FitParameter {
        name: "vs",
        unit: "m/s",
        meaning: "Stribeck speed",
        range: Range::Positive,
    },
    FitParameter {
        name: "delta",
        unit: "-",
        meaning: "exponent",
        range: Range::Positive,
    },
    FitParameter {
        name: "k",
        unit: "s/m",
        meaning: "viscous coefficient",
        range: Range::NotNegative,
    },
];
/// Exponents to start from.
const EXPONENTS: [f64; 2] = [0.5, 3.0];

/// Steady friction.
pub(super) struct Steady<'a> {
    pub speeds: Cow<'a, [f64]>,
    pub scales: DataRange,
}

impl Model for Steady<'_> {
    fn parameters(&self) -> &[FitParameter] {
        &PARAMETERS
    }

    fn reference(&self, _: usize) -> Option<f64> {
        None
    }

    fn predict(&self, values: &[f64]) -> Option<Vec<f64>> {
        let &[mu_s, mu_d, speed, exponent, viscous] = values else {
            return None;
        };
        let dry = DryFriction::new(mu_s, mu_d).ok()?;
        let law = Stribeck::new(StribeckParameters {
            dry,
            speed,
            exponent,
            viscous,
        })
        .ok()?;
        Some(steady(&law, &self.speeds))
    }

    fn start(&self, unit: &[f64]) -> Vec<f64> {
        let DataRange {
            speeds,
            forces: [low, high],
        } = self.scales;
        let mu_d = between(unit[1], [0.3 * low, low]);
        vec![
            between(unit[0], [0.5 * (low + high), 1.5 * high]),
            mu_d,
            log_between(unit[2], speeds),
            log_between(unit[3], EXPONENTS),
            unit[4] * high / speeds[1],
        ]
    }

    fn project_to_valid(&self, values: &mut [f64], is_free: &[bool]) {
        order(values, is_free, [1, 0]);
    }

    fn subsample(&self, points: &[usize]) -> Option<Box<dyn Model>> {
        Some(Box::new(Steady {
            speeds: Cow::Owned(picked(&self.speeds, points)),
            scales: self.scales,
        }))
    }
}
