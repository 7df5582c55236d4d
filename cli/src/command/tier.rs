//! Accuracy tiers by name.

use crate::failure::Failure;
use tribos_core::Real;
use tribos_core::coupling::quadrature::DiskQuadrature;
use tribos_core::coupling::table::{self, Table32, Table64};
use tribos_core::coupling::{Coupling, compact};
use tribos_core::law::{LawError, PowerLaw};

/// How friction is evaluated.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub enum Tier {
    /// Polynomial tables: a few ulp, quickest (alpha <= 10).
    Table,
    /// Series without tables: tens of ulp (alpha <= 128).
    Compact,
    /// Quadrature on fixed nodes: about 1e-8.
    Quadrature,
}

/// Floating-point type of the evaluation.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub enum Precision {
    /// 64 bit.
    F64,
    /// 32 bit.
    F32,
}

/// A scalar whose tables the kernel can build.
pub trait Tabulated: Real + table::CoulombTable {
    /// The table tier of exponent `alpha` ≠ 0.
    fn table(alpha: Self) -> Result<Box<dyn Coupling<Self>>, LawError>;
}

impl Tabulated for f64 {
    fn table(alpha: f64) -> Result<Box<dyn Coupling<f64>>, LawError> {
        Ok(Box::new(Table64::new(alpha)?))
    }
}

impl Tabulated for f32 {
    fn table(alpha: f32) -> Result<Box<dyn Coupling<f32>>, LawError> {
        Ok(Box::new(Table32::new(alpha)?))
    }
}

/// The coupling of |v|^alpha in the tier asked for, else in the quickest that serves alpha.
pub fn coupling<R: Tabulated>(
    alpha: f64,
    tier: Option<Tier>,
) -> Result<Box<dyn Coupling<R>>, Failure> {
    let narrow = R::from_f64(alpha);
    let served = alpha <= table::MAX_EXPONENT;
    let tier = tier.unwrap_or(if served { Tier::Table } else { Tier::Compact });
    let built: Result<Box<dyn Coupling<R>>, LawError> = match tier {
        Tier::Table if alpha == 0.0 => Ok(Box::new(table::Coulomb)),
        Tier::Table => R::table(narrow),
        Tier::Compact if alpha == 0.0 => Ok(Box::new(compact::Coulomb)),
        Tier::Compact => compact::Power::new(narrow).map(|x| Box::new(x) as _),
        Tier::Quadrature => {
            PowerLaw::new(narrow, R::ONE).map(|law| Box::new(DiskQuadrature::new(law)) as _)
        }
    };
    built.map_err(|error| match tier {
        Tier::Table if !served => {
            Failure::input(format!("{error} for --tier table; use --tier compact"))
        }
        _ => Failure::input(error),
    })
}
