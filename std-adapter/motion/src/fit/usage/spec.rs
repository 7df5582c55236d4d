//! A law in the words of the catalogue, and the fields of laws that have many.

use super::number;
use super::shape::Shape;
use tribos_core::law::{LuGreParameters, RateStateParameters};

impl Shape {
    /// The law of steady sliding as scenes and the command write it, if the catalogue has it.
    pub(super) fn spec(&self) -> Option<String> {
        let of = |name: &str, values: &[(&str, f64)]| {
            let values = values.iter().map(|(name, x)| format!("{name}={x:?}"));
            Some(format!("{name}:{}", values.collect::<Vec<_>>().join(",")))
        };
        match self {
            Self::Coulomb { mu } => of("coulomb", &[("mu", *mu)]),
            Self::Viscous { mu, k } => of(
                "stribeck",
                &[("mu_s", *mu), ("mu_d", *mu), ("vs", 1.0), ("k", *k)],
            ),
            Self::Stribeck {
                mu_s,
                mu_d,
                vs,
                delta,
                k,
            } => of(
                "stribeck",
                &[
                    ("mu_s", *mu_s),
                    ("mu_d", *mu_d),
                    ("vs", *vs),
                    ("delta", *delta),
                    ("k", *k),
                ],
            ),
            Self::Tanh { mu, vt } => of("tanh", &[("mu", *mu), ("vt", *vt)]),
            Self::Rising { mu_s, mu_f, vr } => {
                of("rising", &[("mu_s", *mu_s), ("mu_f", *mu_f), ("vr", *vr)])
            }
            Self::Power { gamma, alpha } => of("power", &[("gamma", *gamma), ("alpha", *alpha)]),
            Self::SteadyLuGre(joint) | Self::LuGre(joint) => of(
                "lugre",
                &[
                    ("fc", joint.coulomb_force),
                    ("fs", joint.static_force),
                    ("vs", joint.stribeck_speed),
                    ("s2", joint.viscous_damping),
                ],
            ),
            Self::SteadyRateState(rock) | Self::RateState { rock, .. } => of(
                "rate-state",
                &[
                    ("mu0", rock.mu),
                    ("a", rock.a),
                    ("b", rock.b),
                    ("v0", rock.reference_speed),
                    ("dc", rock.slip_distance),
                    ("eta", rock.viscous),
                ],
            ),
            _ => None,
        }
    }
}

/// Dahl's law as LuGre without Stribeck effect and damping.
pub(super) fn dahl(fc: f64, s0: f64) -> LuGreParameters<f64> {
    LuGreParameters {
        coulomb_force: fc,
        static_force: fc,
        stribeck_speed: 1.0,
        stiffness: s0,
        bristle_damping: 0.0,
        viscous_damping: 0.0,
    }
}

/// Lines `    name: value,` of the fields of LuGre's parameters, or another form of them.
pub(super) fn joint_fields(
    joint: &LuGreParameters<f64>,
    line: impl Fn(&str, String) -> String,
) -> String {
    let fields = [
        ("coulomb_force", joint.coulomb_force),
        ("static_force", joint.static_force),
        ("stribeck_speed", joint.stribeck_speed),
        ("stiffness", joint.stiffness),
        ("bristle_damping", joint.bristle_damping),
        ("viscous_damping", joint.viscous_damping),
    ];
    fields.map(|(name, x)| line(name, number(x))).concat()
}

/// The same of rate and state.
pub(super) fn rock_fields(
    rock: &RateStateParameters<f64>,
    line: impl Fn(&str, String) -> String,
) -> String {
    let fields = [
        ("mu", rock.mu),
        ("a", rock.a),
        ("b", rock.b),
        ("reference_speed", rock.reference_speed),
        ("slip_distance", rock.slip_distance),
        ("viscous", rock.viscous),
    ];
    fields.map(|(name, x)| line(name, number(x))).concat()
}
