//! What is left of a law where a simulator has one dry coefficient or force, and one damping.

use super::shape::Shape;
use tribos_core::law::LuGreParameters;

/// Dry and viscous friction in place of a law, and what that loses.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Reduced {
    /// Coefficient of dry friction, or its force.
    pub dry: f64,
    /// The parameter that it comes from.
    pub dry_from: &'static str,
    /// Viscous friction over the speed.
    pub viscous: f64,
    /// The parameter that it comes from; empty if the law has none.
    pub viscous_from: &'static str,
    /// Speed below which friction is a ramp, if the law has one.
    pub ramp: Option<f64>,
    /// Sentences on what is lost beside a viscous term.
    pub lost: Vec<String>,
}

/// Dry friction alone.
fn dry(dry: f64, dry_from: &'static str, lost: &[String]) -> Reduced {
    Reduced {
        dry,
        dry_from,
        viscous: 0.0,
        viscous_from: "",
        ramp: None,
        lost: lost.to_vec(),
    }
}

/// The rise to break-away that a simulator with one coefficient does not have.
fn break_away((name, high): (&str, f64), (level_name, level): (&str, f64)) -> String {
    let excess = high - level;
    format!(
        "{name}: at rest friction is {level_name}, too small by {excess:.4}, and nothing sticks and slips"
    )
}

/// The bristles of a joint reduced to Coulomb force and viscous damping.
fn joint(law: &LuGreParameters<f64>, has_bristles: bool) -> Reduced {
    let mut lost = Vec::new();
    if law.static_force > law.coulomb_force {
        lost.push(break_away(
            ("fs", law.static_force),
            ("fc", law.coulomb_force),
        ));
        lost.push("vs: friction does not fall with the speed".into());
    }
    if has_bristles {
        lost.push("s0, s1: there is no spring before it slides, and no hysteresis".into());
    }
    Reduced {
        viscous: law.viscous_damping,
        viscous_from: "s2",
        ..dry(law.coulomb_force, "fc", &lost)
    }
}

/// Exponents nearer than this to 0 or 1 are taken for them.
const SAME_EXPONENT: f64 = 1e-9;
/// Speed at which a law without a level is told, in m/s.
const TOLD_SPEED: f64 = 0.1;

/// The law by dry and viscous friction; or why not, as a sentence.
pub(super) fn reduced(shape: &Shape) -> Result<Reduced, String> {
    Ok(match shape {
        Shape::Coulomb { mu } => dry(*mu, "mu", &[]),
        Shape::Viscous { mu, k } => Reduced {
            viscous: *k,
            viscous_from: "k",
            ..dry(*mu, "mu", &[])
        },
        Shape::Stribeck { mu_s, mu_d, k, .. } => {
            let rest = break_away(("mu_s", *mu_s), ("mu_d", *mu_d));
            let fall = "vs, delta: friction does not fall with the speed".to_owned();
            Reduced {
                viscous: *k,
                viscous_from: "k",
                ..dry(*mu_d, "mu_d", &[rest, fall])
            }
        }
        Shape::Tanh { mu, vt } => Reduced {
            ramp: Some(*vt),
            ..dry(*mu, "mu", &[])
        },
        // The hyperbolic tangent with the same slope at rest.
        Shape::Arctan { mu, vt } => Reduced {
            ramp: Some(std::f64::consts::FRAC_PI_2 * vt),
            ..dry(*mu, "mu", &[])
        },
        Shape::Rising { mu_s, mu_f, .. } => {
            let slow = format!(
                "mu_s, vr: friction does not rise; in slow motion take mu_s, {mu_s:?}, in its place"
            );
            dry(*mu_f, "mu_f", &[slow])
        }
        Shape::Power { gamma, alpha } => return power(*gamma, *alpha),
        Shape::Amontons { mu, adhesion } => {
            let held = format!("adhesion: friction without a load, {adhesion:?} N, is not there");
            dry(*mu, "mu", &[held])
        }
        Shape::Sliders(elements) => {
            let force = elements.iter().map(|[_, force]| force).sum();
            let spring = "stiffnesses: there is no spring before it slides, and no hysteresis";
            let from = if elements.len() == 1 {
                "fc"
            } else {
                "the sum of f1, f2 and so on"
            };
            dry(force, from, &[spring.to_owned()])
        }
        Shape::Dahl { fc, .. } => {
            let spring = "s0: there is no spring before it slides, and no hysteresis";
            dry(*fc, "fc", &[spring.to_owned()])
        }
        Shape::ElastoPlastic { joint: law, .. } | Shape::LuGre(law) => joint(law, true),
        Shape::SteadyLuGre(law) => joint(law, false),
        Shape::RateState { rock, .. } | Shape::SteadyRateState(rock) => {
            let fold = format!(
                "a, b, dc: the coefficient is that at v0, {:?} m/s; each e-fold of the speed changes steady friction by {:.3e}, and rest strengthens nothing",
                rock.reference_speed,
                rock.a - rock.b
            );
            Reduced {
                viscous: rock.viscous,
                viscous_from: "eta",
                ..dry(rock.mu, "mu0", &[fold])
            }
        }
    })
}

/// A power of the speed is dry or viscous at two exponents alone.
fn power(gamma: f64, alpha: f64) -> Result<Reduced, String> {
    if alpha.abs() < SAME_EXPONENT {
        return Ok(dry(gamma, "gamma", &[]));
    }
    if (alpha - 1.0).abs() < SAME_EXPONENT {
        return Ok(Reduced {
            viscous: gamma,
            viscous_from: "gamma",
            ..dry(0.0, "nothing", &[])
        });
    }
    let told = gamma * libm::pow(TOLD_SPEED, alpha);
    Err(format!(
        "has no power of the speed: take friction at the speed of your task as a coefficient, {told:.4} at {TOLD_SPEED} m/s."
    ))
}
