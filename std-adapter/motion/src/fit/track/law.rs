//! Laws of the local speed that a film can show.

use super::super::parameter::{FitParameter, Range};
use std::fmt;
use std::str::FromStr;
use tribos_core::law::PowerLaw;
use tribos_friction::{FrictionError, Law};

/// A law under which a filmed body is followed.
///
/// ```
/// use tribos::fit::track::TrackLaw;
/// assert_eq!("viscous".parse(), Ok(TrackLaw::Viscous));
/// assert!("dahl".parse::<TrackLaw>().is_err());
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum TrackLaw {
    /// μ
    #[default]
    Coulomb,
    /// μ + k v
    Viscous,
    /// Boundary, then hydrodynamic lubrication.
    Stribeck,
    /// γ v^α
    Power,
}

const fn positive(name: &'static str, unit: &'static str, meaning: &'static str) -> FitParameter {
    FitParameter {
        name,
        unit,
        meaning,
        range: Range::Positive,
    }
}

const COULOMB: [FitParameter; 1] = [positive("mu", "-", "coefficient")];
const VISCOUS: [FitParameter; 2] = [
    positive("mu", "-", "coefficient at rest"),
    FitParameter {
        range: Range::NotNegative,
        ..positive("k", "s/m", "viscous coefficient")
    },
];
const STRIBECK: [FitParameter; 5] = [
    positive("mu_s", "-", "coefficient at rest"),
    positive("mu_d", "-", "coefficient of the boundary branch"),
    positive("vs", "m/s", "Stribeck speed"),
    positive("delta", "-", "exponent"),
    FitParameter {
        range: Range::NotNegative,
        ..positive("k", "s/m", "viscous coefficient")
    },
];
/// Places of what keeps its usual value unless it is fixed: delta and k.
const USUAL: [(usize, f64); 2] = [(3, 2.0), (4, 0.0)];
const POWER: [FitParameter; 2] = [
    positive("gamma", "(s/m)^alpha", "coefficient"),
    FitParameter {
        range: Range::Between {
            above: -1.0,
            up_to: PowerLaw::<f64>::MAX_EXPONENT,
        },
        ..positive("alpha", "-", "exponent")
    },
];

impl TrackLaw {
    /// All laws with their names.
    pub const ALL: [(Self, &'static str); 4] = [
        (Self::Coulomb, "coulomb"),
        (Self::Viscous, "viscous"),
        (Self::Stribeck, "stribeck"),
        (Self::Power, "power"),
    ];

    /// Its parameters.
    pub(super) fn parameters(self) -> &'static [FitParameter] {
        match self {
            Self::Coulomb => &COULOMB,
            Self::Viscous => &VISCOUS,
            Self::Stribeck => &STRIBECK,
            Self::Power => &POWER,
        }
    }

    /// The value of a parameter that is not sought unless it is asked for.
    pub(super) fn usual(self, parameter: usize) -> Option<f64> {
        let mut usual = USUAL.iter().filter(|_| self == Self::Stribeck);
        usual
            .find(|(place, _)| *place == parameter)
            .map(|(_, value)| *value)
    }

    /// Values that give about the same friction as `mu` at speeds about `speed`; `share` from 0 to 1 varies them.
    pub(super) fn like(self, mu: f64, speed: f64, share: f64) -> Vec<f64> {
        match self {
            Self::Coulomb => vec![mu],
            Self::Viscous => vec![mu * (1.0 - 0.5 * share), 0.5 * share * mu / speed],
            Self::Stribeck => {
                let rise = 0.5 * share * mu;
                vec![mu + rise, mu - 0.5 * rise, 0.5 * speed, 2.0, 0.0]
            }
            Self::Power => {
                let alpha = share - 0.5;
                vec![mu / libm::pow(speed, alpha), alpha]
            }
        }
    }

    /// The law with these values as other commands write it.
    pub fn spec(self, values: &[f64]) -> String {
        match (self, values) {
            (Self::Coulomb, [mu, ..]) => format!("coulomb:mu={mu:?}"),
            (Self::Viscous, [mu, k, ..]) => {
                format!("stribeck:mu_s={mu:?},mu_d={mu:?},vs=1.0,k={k:?}")
            }
            (Self::Stribeck, [mu_s, mu_d, vs, delta, k, ..]) => {
                format!("stribeck:mu_s={mu_s:?},mu_d={mu_d:?},vs={vs:?},delta={delta:?},k={k:?}")
            }
            (Self::Power, [gamma, alpha, ..]) => format!("power:gamma={gamma:?},alpha={alpha:?}"),
            _ => String::new(),
        }
    }

    /// The law with these values; none outside of its domain.
    pub(super) fn at(self, values: &[f64]) -> Option<Law> {
        self.spec(values).parse().ok()
    }
}

impl fmt::Display for TrackLaw {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let found = Self::ALL.iter().find(|(law, _)| law == self);
        f.write_str(found.map_or("", |(_, name)| name))
    }
}

impl FromStr for TrackLaw {
    type Err = FrictionError;

    fn from_str(text: &str) -> Result<Self, FrictionError> {
        let found = Self::ALL.into_iter().find(|(_, name)| *name == text);
        found.map(|(law, _)| law).ok_or_else(|| {
            let names = Self::ALL.map(|(_, name)| name);
            let list = format!("a filmed body is followed under {}", names.join(", "));
            FrictionError::unknown("law of a track", text, names, list)
        })
    }
}
