//! Fitted laws by their formulas.

use super::spec::dahl;
use super::{FittedLaw, UsageError};
use tribos_core::law::{
    AgeingLaw, CoulombLaw, DryFriction, LawError, LuGre, LuGreParameters, PowerLaw, RateState,
    RateStateParameters, RisingLaw, RisingLawParameters, Stribeck, StribeckParameters, TanhLaw,
};

/// Names of the laws.
pub(super) const NAMES: [&str; 15] = [
    "coulomb",
    "viscous",
    "stribeck",
    "tanh",
    "arctan",
    "rising",
    "power",
    "amontons",
    "elastic-plastic",
    "dahl",
    "elasto-plastic",
    "lugre",
    "maxwell",
    "rate-state",
    "rate-state-slip",
];

/// A fitted law by its formula.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Shape {
    /// mu
    Coulomb { mu: f64 },
    /// mu + k v
    Viscous { mu: f64, k: f64 },
    /// mu_d + (mu_s − mu_d) exp(−(v/vs)^delta) + k v
    Stribeck {
        mu_s: f64,
        mu_d: f64,
        vs: f64,
        delta: f64,
        k: f64,
    },
    /// mu tanh(v/vt)
    Tanh { mu: f64, vt: f64 },
    /// mu (2/π) atan(v/vt)
    Arctan { mu: f64, vt: f64 },
    /// mu_f − (mu_f − mu_s) exp(−v/vr)
    Rising { mu_s: f64, mu_f: f64, vr: f64 },
    /// gamma v^alpha
    Power { gamma: f64, alpha: f64 },
    /// mu N + adhesion, a force under the load N
    Amontons { mu: f64, adhesion: f64 },
    /// Springs that slip at a force, side by side: stiffness and force of each.
    Sliders(Vec<[f64; 2]>),
    /// dF/dt = s0 v (1 − F sgn v/fc)
    Dahl { fc: f64, s0: f64 },
    /// LuGre whose bristles do not creep below the share `zba` of their deflection in steady sliding.
    ElastoPlastic {
        joint: LuGreParameters<f64>,
        zba: f64,
    },
    /// Bristles.
    LuGre(LuGreParameters<f64>),
    /// Steady sliding over bristles of which nothing is known.
    SteadyLuGre(LuGreParameters<f64>),
    /// Rate and state; by the slip law or by the ageing law.
    RateState {
        rock: RateStateParameters<f64>,
        by_slip: bool,
    },
    /// Steady rate and state, of which the memory length is not known.
    SteadyRateState(RateStateParameters<f64>),
}

impl FittedLaw<'_> {
    /// A value that was given.
    pub(super) fn given(&self, name: &str) -> Option<f64> {
        let found = self.parameters.iter().find(|(known, _)| *known == name);
        found.map(|(_, value)| *value)
    }

    fn needed(&self, parameter: &'static str) -> Result<f64, UsageError> {
        let law = self.law.to_owned();
        self.given(parameter)
            .ok_or(UsageError::Missing { law, parameter })
    }

    /// The law by its formula, checked.
    pub(super) fn shape(&self) -> Result<Shape, UsageError> {
        let shape = self.read()?;
        let law = || self.law.to_owned();
        let refused = |error| UsageError::Refused { law: law(), error };
        shape.check().map_err(refused)?;
        Ok(shape)
    }

    fn read(&self) -> Result<Shape, UsageError> {
        let needed = |name| self.needed(name);
        let or_zero = |name| self.given(name).unwrap_or(0.0);
        Ok(match self.law {
            "coulomb" => Shape::Coulomb { mu: needed("mu")? },
            "viscous" => Shape::Viscous {
                mu: needed("mu")?,
                k: needed("k")?,
            },
            "stribeck" => Shape::Stribeck {
                mu_s: needed("mu_s")?,
                mu_d: needed("mu_d")?,
                vs: needed("vs")?,
                delta: self.given("delta").unwrap_or(USUAL_DELTA),
                k: or_zero("k"),
            },
            "tanh" => Shape::Tanh {
                mu: needed("mu")?,
                vt: needed("vt")?,
            },
            "arctan" => Shape::Arctan {
                mu: needed("mu")?,
                vt: needed("vt")?,
            },
            "rising" => Shape::Rising {
                mu_s: needed("mu_s")?,
                mu_f: needed("mu_f")?,
                vr: needed("vr")?,
            },
            "power" => Shape::Power {
                gamma: needed("gamma")?,
                alpha: needed("alpha")?,
            },
            "amontons" => Shape::Amontons {
                mu: needed("mu")?,
                adhesion: needed("adhesion")?,
            },
            _ => return self.read_with_state(),
        })
    }

    /// Laws with a state.
    fn read_with_state(&self) -> Result<Shape, UsageError> {
        let needed = |name| self.needed(name);
        Ok(match self.law {
            "elastic-plastic" => Shape::Sliders(vec![[needed("s0")?, needed("fc")?]]),
            "dahl" => Shape::Dahl {
                fc: needed("fc")?,
                s0: needed("s0")?,
            },
            "elasto-plastic" => Shape::ElastoPlastic {
                joint: self.joint(needed("s0")?)?,
                zba: needed("zba")?,
            },
            "lugre" => match self.given("s0") {
                Some(stiffness) => Shape::LuGre(self.joint(stiffness)?),
                None => Shape::SteadyLuGre(self.joint(1.0)?),
            },
            "maxwell" => Shape::Sliders(self.elements()?),
            "rate-state" | "rate-state-slip" => {
                let by_slip = self.law == "rate-state-slip";
                let rock = |slip_distance| self.rock(slip_distance);
                match self.given("dc") {
                    Some(dc) => Shape::RateState {
                        rock: rock(dc)?,
                        by_slip,
                    },
                    None => Shape::SteadyRateState(rock(1.0)?),
                }
            }
            unknown => {
                return Err(UsageError::Unknown {
                    name: unknown.to_owned(),
                });
            }
        })
    }

    fn joint(&self, stiffness: f64) -> Result<LuGreParameters<f64>, UsageError> {
        let or_zero = |name| self.given(name).unwrap_or(0.0);
        Ok(LuGreParameters {
            coulomb_force: self.needed("fc")?,
            static_force: self.needed("fs")?,
            stribeck_speed: self.needed("vs")?,
            stiffness,
            bristle_damping: or_zero("s1"),
            viscous_damping: or_zero("s2"),
        })
    }

    fn rock(&self, slip_distance: f64) -> Result<RateStateParameters<f64>, UsageError> {
        Ok(RateStateParameters {
            mu: self.needed("mu0")?,
            a: self.needed("a")?,
            b: self.needed("b")?,
            reference_speed: self.needed("v0")?,
            slip_distance,
            viscous: self.given("eta").unwrap_or(0.0),
        })
    }

    /// k1, f1, k2, f2 and so on.
    fn elements(&self) -> Result<Vec<[f64; 2]>, UsageError> {
        let pair = |number: usize| {
            let stiffness = self.given(&format!("k{number}"))?;
            Some([stiffness, self.given(&format!("f{number}"))?])
        };
        let elements: Vec<[f64; 2]> = (1..).map_while(pair).collect();
        if elements.is_empty() {
            let law = self.law.to_owned();
            let parameter = "k1";
            return Err(UsageError::Missing { law, parameter });
        }
        Ok(elements)
    }
}

/// Stribeck's exponent where none was fitted.
const USUAL_DELTA: f64 = 2.0;

impl Shape {
    /// Refuses what the kernel refuses; laws that it does not have are checked as their likes.
    fn check(&self) -> Result<(), LawError> {
        match self {
            Self::Coulomb { mu } => CoulombLaw::new(*mu).map(drop),
            Self::Tanh { mu, vt } | Self::Arctan { mu, vt } => TanhLaw::new(*mu, *vt).map(drop),
            Self::Rising { mu_s, mu_f, vr } => RisingLaw::new(RisingLawParameters {
                mu_rest: *mu_s,
                mu_fast: *mu_f,
                speed: *vr,
            })
            .map(drop),
            Self::Power { gamma, alpha } => PowerLaw::new(*alpha, *gamma).map(drop),
            // A force that adhesion makes negative at small loads is for the caller to judge.
            Self::Amontons { mu, adhesion } => {
                CoulombLaw::new(*mu)?;
                CoulombLaw::new(adhesion.abs()).map(drop)
            }
            Self::Viscous { mu, k } => stribeck([*mu, *mu, 1.0, 1.0, *k]).map(drop),
            Self::Stribeck {
                mu_s,
                mu_d,
                vs,
                delta,
                k,
            } => stribeck([*mu_s, *mu_d, *vs, *delta, *k]).map(drop),
            Self::Sliders(elements) => {
                let mut checked = elements.iter().map(|&[k, f]| LuGre::new(dahl(f, k)));
                checked.try_for_each(|one| one.map(drop))
            }
            Self::Dahl { fc, s0 } => LuGre::new(dahl(*fc, *s0)).map(drop),
            Self::ElastoPlastic { joint, zba } => {
                LuGre::new(*joint)?;
                CoulombLaw::new(*zba).map(drop)
            }
            Self::LuGre(joint) | Self::SteadyLuGre(joint) => LuGre::new(*joint).map(drop),
            Self::RateState { rock, .. } | Self::SteadyRateState(rock) => {
                RateState::<f64, AgeingLaw>::new(*rock).map(drop)
            }
        }
    }
}

/// A Stribeck curve of mu_s, mu_d, vs, delta, k.
fn stribeck([mu_s, mu_d, vs, delta, k]: [f64; 5]) -> Result<Stribeck<f64>, LawError> {
    Stribeck::new(StribeckParameters {
        dry: DryFriction::new(mu_s, mu_d)?,
        speed: vs,
        exponent: delta,
        viscous: k,
    })
}
