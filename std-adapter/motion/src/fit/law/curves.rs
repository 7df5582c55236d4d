//! Laws of steady sliding.

use super::super::parameter::Range;
use super::form::{Form, around, between, log_between, parameter};
use super::steady::Curve;
use tribos_core::law::{
    DryFriction, LocalLaw, LuGre, LuGreParameters, PowerLaw, Stribeck, StribeckParameters,
};

/// A constant coefficient.
pub(super) struct Coulomb(f64);

impl Curve for Coulomb {
    const FORM: Form = Form {
        parameters: &[parameter("mu", "-", "coefficient", Range::NotNegative)],
        linear: &["mu"],
        ordered: None,
        reference: None,
        start: |guess, unit| vec![guess.coulomb * around(unit[0], 2.0)],
    };

    fn new(values: &[f64]) -> Option<Self> {
        values.first().copied().map(Self)
    }

    fn friction(&self, _: f64, _: f64) -> f64 {
        self.0
    }
}

/// Coulomb friction with a viscous term, μ + k v.
pub(super) struct Viscous([f64; 2]);

impl Curve for Viscous {
    const FORM: Form = Form {
        parameters: &[
            parameter("mu", "-", "coefficient of dry friction", Range::NotNegative),
            parameter("k", "s/m", "viscous coefficient", Range::NotNegative),
        ],
        linear: &["mu", "k"],
        ordered: None,
        reference: None,
        start: |guess, unit| {
            vec![
                guess.coulomb * around(unit[0], 2.0),
                guess.viscous + unit[1] * guess.forces[1] / guess.speeds[1],
            ]
        },
    };

    fn new(values: &[f64]) -> Option<Self> {
        values.try_into().ok().map(Self)
    }

    fn friction(&self, speed: f64, _: f64) -> f64 {
        self.0[0] + self.0[1] * speed
    }
}

/// Boundary, then hydrodynamic lubrication.
pub(super) struct StribeckCurve(Stribeck<f64>);

impl Curve for StribeckCurve {
    const FORM: Form = Form {
        parameters: &[
            parameter("mu_s", "-", "coefficient at rest", Range::NotNegative),
            parameter(
                "mu_d",
                "-",
                "coefficient of the boundary branch",
                Range::NotNegative,
            ),
            parameter("vs", "m/s", "Stribeck speed", Range::Positive),
            parameter("delta", "-", "exponent", Range::Positive),
            parameter("k", "s/m", "viscous coefficient", Range::NotNegative),
        ],
        linear: &["mu_s", "mu_d", "k"],
        ordered: Some(["mu_d", "mu_s"]),
        reference: None,
        start: |guess, unit| {
            /// Exponents to start from, the usual one in the middle of the interval.
            const EXPONENTS: [f64; 2] = [0.5, 3.0];
            let mu_d = guess.coulomb * around(unit[1], 2.0);
            vec![
                mu_d + (guess.excess + 0.1 * guess.forces[1]) * 2.0 * unit[0],
                mu_d,
                speed(guess, unit[2]),
                log_between(unit[3], EXPONENTS),
                (guess.viscous + 0.1 * guess.forces[1] / guess.speeds[1]) * 2.0 * unit[4],
            ]
        },
    };

    fn new(values: &[f64]) -> Option<Self> {
        let &[mu_s, mu_d, speed, exponent, viscous] = values else {
            return None;
        };
        let dry = DryFriction::new(mu_s, mu_d).ok()?;
        let parameters = StribeckParameters {
            dry,
            speed,
            exponent,
            viscous,
        };
        Stribeck::new(parameters).ok().map(Self)
    }

    fn friction(&self, speed: f64, _: f64) -> f64 {
        self.0.friction(speed)
    }
}

/// A speed: the guess in the middle, a tenth of the slowest at 0, the fastest at 1.
fn speed(guess: &super::guess::Guess, share: f64) -> f64 {
    let middle = guess.stribeck_speed;
    let [slow, fast] = guess.speeds;
    if share < 0.5 {
        log_between(2.0 * share, [slow.min(middle), middle])
    } else {
        log_between(2.0 * share - 1.0, [middle, fast.max(middle)])
    }
}

/// μ tanh(v/v_t): friction without a jump at rest, as simulators have it.
pub(super) struct Tanh([f64; 2]);

/// Parameters and starts of friction that vanishes at rest.
const SMOOTHED: Form = Form {
    parameters: &[
        parameter("mu", "-", "coefficient of fast sliding", Range::NotNegative),
        parameter("vt", "m/s", "speed of the transition", Range::Positive),
    ],
    linear: &["mu"],
    ordered: None,
    reference: None,
    start: |guess, unit| {
        let spread = [guess.speeds[0], guess.speeds[1]];
        vec![
            guess.forces[1] * around(unit[0], 1.5),
            log_between(unit[1], spread),
        ]
    },
};

impl Curve for Tanh {
    const FORM: Form = SMOOTHED;

    fn new(values: &[f64]) -> Option<Self> {
        values.try_into().ok().map(Self)
    }

    fn friction(&self, speed: f64, _: f64) -> f64 {
        self.0[0] * libm::tanh(speed / self.0[1])
    }
}

/// (2/π) μ atan(v/v_t).
pub(super) struct Arctan([f64; 2]);

impl Curve for Arctan {
    const FORM: Form = SMOOTHED;

    fn new(values: &[f64]) -> Option<Self> {
        values.try_into().ok().map(Self)
    }

    fn friction(&self, speed: f64, _: f64) -> f64 {
        self.0[0] * std::f64::consts::FRAC_2_PI * libm::atan(speed / self.0[1])
    }
}

/// Friction that rises and levels off, as of PTFE: μ_f − (μ_f − μ_s) e^(−v/v_r).
pub(super) struct Rising([f64; 3]);

impl Curve for Rising {
    const FORM: Form = Form {
        parameters: &[
            parameter("mu_s", "-", "coefficient at rest", Range::NotNegative),
            parameter(
                "mu_f",
                "-",
                "coefficient of fast sliding",
                Range::NotNegative,
            ),
            parameter("vr", "m/s", "speed of the rise", Range::Positive),
        ],
        linear: &["mu_s", "mu_f"],
        ordered: Some(["mu_s", "mu_f"]),
        reference: None,
        start: |guess, unit| {
            let [low, high] = guess.forces;
            let mu_s = low * (0.5 + unit[0]);
            vec![
                mu_s,
                mu_s + (high - low) * (0.5 + unit[1]),
                log_between(unit[2], guess.speeds),
            ]
        },
    };

    fn new(values: &[f64]) -> Option<Self> {
        values.try_into().ok().map(Self)
    }

    fn friction(&self, speed: f64, _: f64) -> f64 {
        let [mu_s, mu_f, rise] = self.0;
        mu_f - (mu_f - mu_s) * libm::exp(-speed / rise)
    }
}

/// γ v^α.
pub(super) struct Power(PowerLaw<f64>);

impl Curve for Power {
    const FORM: Form = Form {
        parameters: &[
            parameter("gamma", "(s/m)^alpha", "coefficient", Range::Positive),
            parameter(
                "alpha",
                "-",
                "exponent",
                Range::Between {
                    above: -1.0,
                    up_to: PowerLaw::<f64>::MAX_EXPONENT,
                },
            ),
        ],
        linear: &["gamma"],
        ordered: None,
        reference: None,
        // Curves through the middle of the data.
        start: |guess, unit| {
            /// Exponents to start from.
            const EXPONENTS: [f64; 2] = [-0.9, 3.0];
            let alpha = between(unit[1], EXPONENTS);
            let [low, high] = guess.forces;
            let gamma = low.sqrt() * high.sqrt() / libm::pow(guess.middle_speed(), alpha);
            vec![gamma * (0.5 + unit[0]), alpha]
        },
    };

    fn new(values: &[f64]) -> Option<Self> {
        PowerLaw::new(*values.get(1)?, *values.first()?)
            .ok()
            .map(Self)
    }

    fn friction(&self, speed: f64, _: f64) -> f64 {
        self.0.friction(speed)
    }
}

/// Amontons' law with an intercept, F = μ N + A; here per load.
pub(super) struct Amontons([f64; 2]);

impl Curve for Amontons {
    const FORM: Form = Form {
        parameters: &[
            parameter(
                "mu",
                "-",
                "coefficient: friction over load",
                Range::NotNegative,
            ),
            parameter("adhesion", "N", "friction without load", Range::Any),
        ],
        linear: &["mu", "adhesion"],
        ordered: None,
        reference: None,
        start: |guess, unit| vec![guess.coulomb * around(unit[0], 2.0), 0.0],
    };

    fn new(values: &[f64]) -> Option<Self> {
        values.try_into().ok().map(Self)
    }

    fn friction(&self, _: f64, load: f64) -> f64 {
        self.0[0] + self.0[1] / load
    }
}

/// The steady curve of LuGre's bristles.
pub(super) struct SteadyLuGre(LuGre<f64>);

impl Curve for SteadyLuGre {
    const FORM: Form = Form {
        parameters: &[
            super::bristles::COULOMB_FORCE,
            super::bristles::STATIC_FORCE,
            super::bristles::STRIBECK_SPEED,
            super::bristles::VISCOUS_DAMPING,
        ],
        linear: &["fc", "fs", "s2"],
        ordered: Some(["fc", "fs"]),
        reference: None,
        start: |guess, unit| {
            let fc = guess.coulomb * around(unit[0], 2.0);
            vec![
                fc,
                fc + (guess.excess + 0.1 * guess.forces[1]) * 2.0 * unit[1],
                speed(guess, unit[2]),
                (guess.viscous + 0.1 * guess.forces[1] / guess.speeds[1]) * 2.0 * unit[3],
            ]
        },
    };

    fn new(values: &[f64]) -> Option<Self> {
        let &[coulomb_force, static_force, stribeck_speed, viscous_damping] = values else {
            return None;
        };
        // Steady sliding does not depend on the bristles.
        LuGre::new(LuGreParameters {
            coulomb_force,
            static_force,
            stribeck_speed,
            viscous_damping,
            stiffness: 1.0,
            bristle_damping: 0.0,
        })
        .ok()
        .map(Self)
    }

    fn friction(&self, speed: f64, _: f64) -> f64 {
        self.0.steady_force(speed)
    }
}
