//! Which tier serves which law on which patch: the one domain of α.

use super::{FrictionError, Law, Patch, Precision};
use std::fmt;
use std::str::FromStr;
use tribos_core::coupling::table;
use tribos_core::law::PowerLaw;

/// Largest exponent α of the power law that any tier serves; the smallest is just above −1.
pub const LARGEST_EXPONENT: f64 = PowerLaw::<f64>::MAX_EXPONENT;

/// `alpha` if some tier serves it: −1 < α ≤ [`LARGEST_EXPONENT`].
///
/// ```
/// use tribos::friction::{LARGEST_EXPONENT, valid_exponent};
/// assert_eq!(valid_exponent(LARGEST_EXPONENT), Ok(LARGEST_EXPONENT));
/// assert!(valid_exponent(-1.0).is_err() && valid_exponent(f64::NAN).is_err());
/// ```
pub fn valid_exponent(alpha: f64) -> Result<f64, FrictionError> {
    if alpha > -1.0 && alpha <= LARGEST_EXPONENT {
        Ok(alpha)
    } else {
        Err(FrictionError::Exponent { given: alpha })
    }
}

/// How force and torque are evaluated.
///
/// ```
/// use tribos::friction::{Evaluation, Law, Patch, FrictionError, Tier};
/// let choose = |law: &str| Tier::choose::<f64>(&Patch::Disk, &law.parse()?, None);
/// assert_eq!(choose("coulomb:mu=0.3")?, Tier::Exact);
/// assert_eq!(choose("dry:mu_s=0.3,mu_d=0.2")?, Tier::Quadrature);
/// assert_eq!(Tier::ALL.map(|tier| tier.to_string()), ["exact", "quadrature"]);
/// assert_eq!("compact".parse(), Ok(Tier::Exact)); // and "table": names of older programs
/// let evaluation: Evaluation = Tier::Exact.evaluation(&Patch::Disk, &Law::coulomb(0.3)?);
/// assert_eq!(evaluation.to_string(), "fitted form, to a few ulp; no quadrature");
/// # Ok::<(), FrictionError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Tier {
    /// To rounding, for powers of the speed: a fitted form for Coulomb's law, a table up to α = 10, a series beyond.
    Exact,
    /// Quadrature on fixed nodes, for any local law.
    Quadrature,
}

/// Names of [`Tier::Exact`] in programs that told tables from what needs none.
const OLDER_NAMES: [&str; 2] = ["table", "compact"];

/// Largest exponent that tables serve.
const MOST_IN_TABLES: f64 = table::DiskTable64::MAX_EXPONENT;

impl Tier {
    /// All tiers, the quickest first.
    pub const ALL: [Self; 2] = [Self::Exact, Self::Quadrature];

    /// The tier that serves `law` on `patch`: the one asked for, if it does, or the quickest.
    pub fn choose<R: Precision>(
        patch: &Patch,
        law: &Law,
        asked: Option<Self>,
    ) -> Result<Self, FrictionError> {
        if !patch.has_axis() {
            return Err(FrictionError::NoAxis);
        }
        law.build::<R>()?;
        match asked {
            Some(tier) => tier.serves::<R>(patch, law).map(|()| tier),
            None => {
                let mut tiers = Self::ALL.into_iter();
                let serving = tiers.find(|tier| tier.serves::<R>(patch, law).is_ok());
                Ok(serving.unwrap_or(Self::Quadrature))
            }
        }
    }

    /// Whether it serves a valid law on a round patch; if not, why.
    fn serves<R: Precision>(self, patch: &Patch, law: &Law) -> Result<(), FrictionError> {
        let refused = |reason: String, cure| {
            let tier = self;
            Err(FrictionError::Tier { tier, reason, cure })
        };
        let is_polynomial = matches!(patch, Patch::Polynomial(_));
        if self == Self::Exact && matches!(patch, Patch::WornAnnulus(_)) {
            return refused(
                "has no final motion of a worn annulus".into(),
                Some(Self::Quadrature),
            );
        }
        match (self, law.power_of_speed()) {
            (Self::Quadrature, _) => Ok(()),
            (Self::Exact, None) => refused(
                "serves coefficient * |v|^alpha alone; other laws are served by quadrature".into(),
                None,
            ),
            (Self::Exact, Some([_, alpha])) if is_polynomial && alpha > MOST_IN_TABLES => refused(
                format!(
                    "serves polynomial pressures for -1 < alpha <= {MOST_IN_TABLES}, not {alpha}"
                ),
                Some(Self::Quadrature),
            ),
            (Self::Exact, _) if is_polynomial && !R::HAS_POLYNOMIALS => {
                Err(FrictionError::SinglePrecision)
            }
            _ => Ok(()),
        }
    }

    /// What an evaluation in this tier consists of.
    pub fn evaluation(self, patch: &Patch, law: &Law) -> Evaluation {
        let alpha = law.exponent();
        let is_annulus = matches!(patch, Patch::Annulus(_));
        let one_or_two = |one, two| if is_annulus { two } else { one };
        match self {
            Self::Quadrature if is_annulus || *patch == Patch::Disk => Evaluation::Quadrature,
            Self::Quadrature => Evaluation::Nodes,
            Self::Exact if alpha == 0.0 && (is_annulus || patch.has_form()) => {
                one_or_two(Evaluation::Form, Evaluation::TwoForms)
            }
            Self::Exact if alpha <= MOST_IN_TABLES => {
                one_or_two(Evaluation::TableMade, Evaluation::TwoTables)
            }
            Self::Exact => one_or_two(Evaluation::Series, Evaluation::TwoSeries),
        }
    }
}

/// What an evaluation of force and torque consists of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Evaluation {
    /// One fitted form of Coulomb friction.
    Form,
    /// Two of them, because an annulus is the difference of two disks.
    TwoForms,
    /// One look-up in a table that is made at the start.
    TableMade,
    /// Two look-ups, for an annulus.
    TwoTables,
    /// One series.
    Series,
    /// Two series, for an annulus.
    TwoSeries,
    /// Quadrature over the rim and the inside of a disk.
    Quadrature,
    /// Closed forms along the edges of a patch.
    Edges,
    /// A sum over nodes that stand for the pressure.
    Nodes,
    /// A sum over points evenly around a ring.
    RingRule {
        /// Number of points.
        points: usize,
    },
}

impl fmt::Display for Evaluation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Form => "fitted form, to a few ulp; no quadrature",
            Self::TwoForms => "two disks by a fitted form, to a few ulp; no quadrature",
            Self::TableMade => "table made at the start, to a few ulp; no quadrature",
            Self::TwoTables => "two disks from a table, to a few ulp; no quadrature",
            Self::Series => "series without a table, to tens of ulp; no quadrature",
            Self::TwoSeries => "two disks by series, to tens of ulp; no quadrature",
            Self::Quadrature => "quadrature of the law, to 1e-8",
            Self::Edges => "closed forms along the edges, to rounding; no quadrature",
            Self::Nodes => "sum over nodes that stand for the pressure, to 1e-3 of the load",
            Self::RingRule { points } => {
                return write!(f, "quadrature over {points} points of the ring");
            }
        })
    }
}

impl fmt::Display for Tier {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Exact => "exact",
            Self::Quadrature => "quadrature",
        })
    }
}

impl FromStr for Tier {
    type Err = FrictionError;

    fn from_str(text: &str) -> Result<Self, FrictionError> {
        let text = text.trim();
        let mut named = Self::ALL.into_iter();
        let found = named.find(|tier| tier.to_string() == text);
        let older = OLDER_NAMES.contains(&text).then_some(Self::Exact);
        found.or(older).ok_or_else(|| {
            let names = ["exact", "quadrature"];
            FrictionError::unknown("tier", text, names, "the tiers are exact, quadrature")
        })
    }
}
