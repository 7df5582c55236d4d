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
/// let choose = |alpha| Tier::choose::<f64>(&Patch::Disk, &Law::power(0.3, alpha)?, None);
/// assert_eq!([choose(0.5)?, choose(20.0)?], [Tier::Table, Tier::Compact]);
/// assert_eq!(Tier::ALL.map(|tier| tier.to_string()), ["table", "compact", "quadrature"]);
/// assert_eq!("compact".parse(), Ok(Tier::Compact));
/// let evaluation: Evaluation = Tier::Table.evaluation(&Patch::Disk, &Law::coulomb(0.3)?);
/// assert_eq!(evaluation.to_string(), "table in the program, to a few ulp; no quadrature");
/// # Ok::<(), FrictionError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Tier {
    /// Polynomial tables: a few ulp, the quickest.
    Table,
    /// Closed forms and series without tables: tens of ulp.
    Compact,
    /// Quadrature on fixed nodes, for any local law.
    Quadrature,
}

impl Tier {
    /// All tiers, the quickest first.
    pub const ALL: [Self; 3] = [Self::Table, Self::Compact, Self::Quadrature];

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
        match (self, law.power_of_speed()) {
            (Self::Quadrature, _) => Ok(()),
            (_, None) => refused(
                "serves coefficient * |v|^alpha alone; other laws are served by quadrature".into(),
                None,
            ),
            (Self::Table, Some([_, alpha])) if alpha > table::DiskTable64::MAX_EXPONENT => refused(
                format!(
                    "serves -1 < alpha <= {}, not {alpha}",
                    table::DiskTable64::MAX_EXPONENT
                ),
                Some(if is_polynomial {
                    Self::Quadrature
                } else {
                    Self::Compact
                }),
            ),
            (Self::Table, _) if is_polynomial && !R::HAS_POLYNOMIALS => {
                Err(FrictionError::SinglePrecision)
            }
            (Self::Compact, Some([_, alpha])) if is_polynomial => refused(
                "does not serve polynomial pressures".into(),
                Some(if alpha > table::DiskTable64::MAX_EXPONENT {
                    Self::Quadrature
                } else {
                    Self::Table
                }),
            ),
            _ => Ok(()),
        }
    }

    /// What an evaluation in this tier consists of.
    pub fn evaluation(self, patch: &Patch, law: &Law) -> Evaluation {
        let is_dry = law.exponent() == 0.0;
        match (self, patch) {
            (Self::Table, Patch::Disk) if is_dry => Evaluation::TableInProgram,
            (Self::Table, Patch::Annulus(_)) => Evaluation::TwoTables,
            (Self::Table, _) => Evaluation::TableMade,
            (Self::Compact, Patch::Annulus(_)) => Evaluation::TwoSeries,
            (Self::Compact, _) => Evaluation::Series,
            (Self::Quadrature, Patch::Disk | Patch::Annulus(_)) => Evaluation::Quadrature,
            (Self::Quadrature, _) => Evaluation::Nodes,
        }
    }
}

/// What an evaluation of force and torque consists of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Evaluation {
    /// One look-up in a table that is part of the program.
    TableInProgram,
    /// One look-up in a table that is made at the start.
    TableMade,
    /// Two look-ups, because an annulus is the difference of two disks.
    TwoTables,
    /// One closed form or series.
    Series,
    /// Two closed forms or series, for an annulus.
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
            Self::TableInProgram => "table in the program, to a few ulp; no quadrature",
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
            Self::Table => "table",
            Self::Compact => "compact",
            Self::Quadrature => "quadrature",
        })
    }
}

impl FromStr for Tier {
    type Err = FrictionError;

    fn from_str(text: &str) -> Result<Self, FrictionError> {
        let found = Self::ALL
            .into_iter()
            .find(|tier| tier.to_string() == text.trim());
        found.ok_or_else(|| {
            let names = ["table", "compact", "quadrature"];
            FrictionError::unknown(
                "tier",
                text,
                names,
                "the tiers are table, compact, quadrature",
            )
        })
    }
}
