//! Laws whose memory is the deflection of bristles: LuGre, Dahl, and the elasto-plastic law of Dupont.

use super::super::parameter::{FitParameter, Range};
use super::form::{Form, around, log_between, parameter};
use super::guess::Guess;
use super::record::Memory;
use tribos_core::law::{Bristle, LuGre, LuGreParameters};

pub(super) const COULOMB_FORCE: FitParameter =
    parameter("fc", "N", "Coulomb force", Range::Positive);
pub(super) const STATIC_FORCE: FitParameter = parameter("fs", "N", "static force", Range::Positive);
pub(super) const STRIBECK_SPEED: FitParameter =
    parameter("vs", "m/s", "Stribeck speed", Range::Positive);
pub(super) const VISCOUS_DAMPING: FitParameter =
    parameter("s2", "N s/m", "viscous damping", Range::NotNegative);
pub(super) const STIFFNESS: FitParameter =
    parameter("s0", "N/m", "stiffness of the bristles", Range::Positive);
const BRISTLE_DAMPING: FitParameter =
    parameter("s1", "N s/m", "damping of the bristles", Range::NotNegative);

/// Factor about the guessed stiffness that starts cover to either side.
const STIFFNESS_FOLD: f64 = 30.0;

/// Starts of a joint: the guessed steady branch, the stiffness about the guess, some damping.
fn joint(guess: &Guess, unit: &[f64]) -> [f64; 6] {
    /// Damping of bristles at the largest speed, over the largest friction.
    const DAMPING: [f64; 2] = [1e-4, 1.0];
    let force = guess.forces[1];
    let fc = guess.coulomb * around(unit[0], 1.5);
    [
        fc,
        fc + (guess.excess + 0.02 * force) * 2.0 * unit[1],
        stribeck_speed(guess, unit[2]),
        (guess.viscous + 0.01 * force / guess.speeds[1]) * 2.0 * unit[3],
        guess.stiffness * around(unit[4], STIFFNESS_FOLD),
        log_between(unit[5], DAMPING) * force / guess.speeds[1],
    ]
}

/// Half of the starts lie about the guess, the others at all speeds: few points near rest tell little of the curve.
fn stribeck_speed(guess: &Guess, unit: f64) -> f64 {
    let [slow, fast] = guess.speeds;
    if unit < 0.5 {
        guess.stribeck_speed * around(2.0 * unit, 10.0)
    } else {
        log_between(2.0 * unit - 1.0, [slow, fast])
    }
}

/// Deflection that carries the measured friction, as far as bristles do.
fn deflection(friction: f64, stiffness: f64, limit: f64) -> f64 {
    friction.max(-limit).min(limit) / stiffness
}

impl Memory for LuGre<f64> {
    const FORM: Form = Form {
        parameters: &[
            COULOMB_FORCE,
            STATIC_FORCE,
            STRIBECK_SPEED,
            VISCOUS_DAMPING,
            STIFFNESS,
            BRISTLE_DAMPING,
        ],
        linear: &["fc", "fs", "s2"],
        ordered: Some(["fc", "fs"]),
        reference: None,
        start: |guess, unit| joint(guess, unit).to_vec(),
    };
    const FORGETS: bool = true;
    const IS_LINEAR: bool = true;
    type State = Bristle<f64>;

    fn new(values: &[f64]) -> Option<Self> {
        let &[
            coulomb_force,
            static_force,
            stribeck_speed,
            viscous_damping,
            stiffness,
            bristle_damping,
        ] = values
        else {
            return None;
        };
        LuGre::new(LuGreParameters {
            coulomb_force,
            static_force,
            stribeck_speed,
            viscous_damping,
            stiffness,
            bristle_damping,
        })
        .ok()
    }

    fn first(&self, velocity: f64, friction: f64) -> Bristle<f64> {
        let p = self.parameters();
        let carried = friction - p.viscous_damping * velocity;
        let limit = self.steady_bristle_force(velocity);
        Bristle {
            deflection: deflection(carried, p.stiffness, limit),
        }
    }

    fn shifted(&self, state: Bristle<f64>, _: usize, share: f64) -> Bristle<f64> {
        let most = self.largest_deflection();
        let deflection = (state.deflection + share * most).max(-most).min(most);
        Bristle { deflection }
    }

    fn advance(&self, state: Bristle<f64>, velocity: f64, dt: f64) -> Bristle<f64> {
        self.step(state, velocity, dt).0
    }

    fn friction(&self, state: Bristle<f64>, velocity: f64) -> f64 {
        self.force(state, velocity)
    }
}

/// Parameters and starts of what bends and then yields at the Coulomb force.
pub(super) const YIELDING: Form = Form {
    parameters: &[COULOMB_FORCE, STIFFNESS],
    linear: &["fc"],
    ordered: None,
    reference: None,
    start: |guess, unit| {
        vec![
            guess.coulomb * around(unit[0], 1.5),
            guess.stiffness * around(unit[1], STIFFNESS_FOLD),
        ]
    },
};

/// Dahl's law z' = v (1 − σ₀ z sgn v/F_c), F = σ₀ z.
///
/// *Source*: Dahl 1968.
pub(super) struct Dahl(LuGre<f64>);

impl Memory for Dahl {
    const FORM: Form = YIELDING;
    const FORGETS: bool = true;
    const IS_LINEAR: bool = true;
    type State = Bristle<f64>;

    // LuGre without damping and without a Stribeck curve.
    fn new(values: &[f64]) -> Option<Self> {
        let &[force, stiffness] = values else {
            return None;
        };
        LuGre::new(LuGreParameters {
            coulomb_force: force,
            static_force: force,
            stribeck_speed: 1.0,
            viscous_damping: 0.0,
            stiffness,
            bristle_damping: 0.0,
        })
        .ok()
        .map(Self)
    }

    fn first(&self, velocity: f64, friction: f64) -> Bristle<f64> {
        Memory::first(&self.0, velocity, friction)
    }

    fn shifted(&self, state: Bristle<f64>, part: usize, share: f64) -> Bristle<f64> {
        self.0.shifted(state, part, share)
    }

    fn advance(&self, state: Bristle<f64>, velocity: f64, dt: f64) -> Bristle<f64> {
        self.0.step(state, velocity, dt).0
    }

    fn friction(&self, state: Bristle<f64>, _: f64) -> f64 {
        self.0.parameters().stiffness * state.deflection
    }
}

/// Bristles that only bend below a break-away deflection, so that a joint under a small alternating force does
/// not creep.
///
/// z' = v (1 − α σ₀ z sgn v/g(v)): α is 0 below the break-away deflection z_ba and in unloading, rises as half a
/// wave of the sine to 1 at g/σ₀, and F = σ₀ z + σ₁ z' + σ₂ v.
///
/// *Source*: P. Dupont, V. Hayward, B. Armstrong, F. Altpeter, IEEE Trans. Automatic Control 47 (2002) 787.
pub(super) struct ElastoPlastic {
    law: LuGre<f64>,
    /// z_ba σ₀/g: share of the largest deflection.
    share: f64,
}

impl ElastoPlastic {
    /// α, of the deflection in the direction of the motion over its largest value.
    fn yielding(&self, bent: f64) -> f64 {
        if bent <= self.share {
            0.0
        } else if bent >= 1.0 {
            1.0
        } else {
            let middle = 0.5 * (1.0 + self.share);
            let angle = std::f64::consts::PI * (bent - middle) / (1.0 - self.share);
            0.5 * (1.0 + libm::sin(angle))
        }
    }

    /// The largest deflection at a velocity.
    fn most(&self, velocity: f64) -> f64 {
        self.law.steady_bristle_force(velocity) / self.law.parameters().stiffness
    }

    /// The deflection after a slide, both over the largest deflection: x' = 1 − α(x) x.
    fn slide(&self, mut bent: f64, mut left: f64) -> f64 {
        // Below the break-away deflection bristles only bend.
        let straight = (self.share - bent).max(0.0).min(left);
        (bent, left) = (bent + straight, left - straight);
        for _ in 0..MOST_STEPS {
            let short = 1.0 - bent;
            if left <= 0.0 || short.abs() <= STEADY {
                break;
            }
            // x' = 1 − x + n(x), of which only n is taken in the middle of the step.
            let n = |bent: f64| (1.0 - self.yielding(bent)) * bent;
            let (here, most) = (n(bent), bent.max(1.0));
            let longest = BEND * (1.0 - self.share) / (short + here).abs();
            let step = if bent > 1.0 { left } else { left.min(longest) };
            let after = |step: f64, n: f64| (1.0 + n - (short + n) * libm::exp(-step)).min(most);
            bent = after(step, n(after(0.5 * step, here)));
            left -= step;
        }
        bent
    }

    /// z' where the largest deflection is `most`.
    fn rate(&self, deflection: f64, velocity: f64, most: f64) -> f64 {
        let bent = deflection * velocity.signum() / most;
        velocity * (1.0 - self.yielding(bent) * bent)
    }
}

/// Largest change of the deflection in one step, over the range in which bristles begin to yield.
const BEND: f64 = 0.2;
/// Distance from the largest deflection, over it, that is steady sliding.
const STEADY: f64 = 1e-13;
/// Most steps at one velocity.
const MOST_STEPS: u32 = 400;

impl Memory for ElastoPlastic {
    const FORM: Form = Form {
        parameters: &[
            COULOMB_FORCE,
            STATIC_FORCE,
            STRIBECK_SPEED,
            VISCOUS_DAMPING,
            STIFFNESS,
            BRISTLE_DAMPING,
            parameter(
                "zba",
                "-",
                "break-away deflection over the largest",
                Range::Between {
                    above: 0.0,
                    up_to: 0.95,
                },
            ),
        ],
        linear: &["fc", "fs", "s2"],
        ordered: Some(["fc", "fs"]),
        reference: None,
        start: |guess, unit| {
            let mut start = joint(guess, unit).to_vec();
            start.push(0.1 + 0.8 * unit[6]);
            start
        },
    };
    const FORGETS: bool = true;
    type State = f64;

    fn new(values: &[f64]) -> Option<Self> {
        let (share, joint) = values.split_last()?;
        let law = <LuGre<f64> as Memory>::new(joint)?;
        Some(Self { law, share: *share })
    }

    fn first(&self, velocity: f64, friction: f64) -> f64 {
        Memory::first(&self.law, velocity, friction).deflection
    }

    fn shifted(&self, deflection: f64, part: usize, share: f64) -> f64 {
        let state = Bristle { deflection };
        self.law.shifted(state, part, share).deflection
    }

    fn advance(&self, deflection: f64, velocity: f64, dt: f64) -> f64 {
        let most = self.most(velocity);
        let bent = self.slide(
            deflection * velocity.signum() / most,
            velocity.abs() * dt / most,
        );
        (bent * velocity.signum() * most).max(-most).min(most)
    }

    fn friction(&self, deflection: f64, velocity: f64) -> f64 {
        let p = self.law.parameters();
        p.stiffness * deflection
            + p.bristle_damping * self.rate(deflection, velocity, self.most(velocity))
            + p.viscous_damping * velocity
    }
}
