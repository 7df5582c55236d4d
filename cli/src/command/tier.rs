//! Accuracy tiers by name.

use super::patch::PatchName;
use crate::failure::Failure;
use tribos_core::Real;
use tribos_core::coupling::round::{LateralPolynomialTable, RoundTable32, RoundTable64};
use tribos_core::coupling::table::{self, Table32, Table64};
use tribos_core::coupling::{
    Annulus, Coupling, Lateral, ReducedJacobian, ReducedWrench, closed, compact,
};
use tribos_core::internals::LateralJacobian;
use tribos_core::law::LawError;
use tribos_core::patch::{PolynomialPressure, PowerPressure};

/// How friction is evaluated.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub enum Tier {
    /// Polynomial tables: a few ulp, quickest (alpha <= 10).
    Table,
    /// Series without tables: tens of ulp (alpha <= 128).
    Compact,
    /// Quadrature on fixed nodes: about 1e-8 on disk and annulus; elsewhere 1e-3 of the load, for
    /// alpha < 0 far less (1e-2 at -0.2, a third of the load at -0.5).
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
    /// True if polynomial pressures have tables in this precision.
    const HAS_POLYNOMIALS: bool;
    /// The table of the uniform disk under |v|^`alpha`.
    fn disk(alpha: Self) -> Result<Box<dyn Lateral<Self>>, LawError>;
    /// The table of another pressure.
    fn round(alpha: Self, pressure: PowerPressure) -> Result<Box<dyn Lateral<Self>>, LawError>;
    /// The table of a polynomial pressure, if there is one in this precision.
    fn polynomial(alpha: Self, coefficients: &[f64]) -> Result<Box<dyn Lateral<Self>>, Failure>;
}

impl Tabulated for f64 {
    const HAS_POLYNOMIALS: bool = true;
    fn disk(alpha: f64) -> Result<Box<dyn Lateral<f64>>, LawError> {
        Ok(Box::new(Table64::new(alpha)?))
    }
    fn round(alpha: f64, pressure: PowerPressure) -> Result<Box<dyn Lateral<f64>>, LawError> {
        Ok(Box::new(RoundTable64::new(alpha, pressure)?))
    }
    fn polynomial(alpha: f64, coefficients: &[f64]) -> Result<Box<dyn Lateral<f64>>, Failure> {
        let pressure = polynomial(coefficients)?;
        LateralPolynomialTable::new(alpha, &pressure)
            .map(|table| Box::new(table) as _)
            .map_err(Failure::input)
    }
}

impl Tabulated for f32 {
    const HAS_POLYNOMIALS: bool = false;
    fn disk(alpha: f32) -> Result<Box<dyn Lateral<f32>>, LawError> {
        Ok(Box::new(Table32::new(alpha)?))
    }
    fn round(alpha: f32, pressure: PowerPressure) -> Result<Box<dyn Lateral<f32>>, LawError> {
        Ok(Box::new(RoundTable32::new(alpha, pressure)?))
    }
    fn polynomial(_: f32, _: &[f64]) -> Result<Box<dyn Lateral<f32>>, Failure> {
        Err(Failure::input(
            "polynomial patches need --precision f64, or --tier quadrature",
        ))
    }
}

/// Most coefficients of a polynomial pressure.
const MOST_COEFFICIENTS: usize = PowerPressure::MAX_ORDER as usize + 1;

/// The polynomial pressure of these coefficients, at most [`MOST_COEFFICIENTS`] of them.
pub fn polynomial(coefficients: &[f64]) -> Result<PolynomialPressure<MOST_COEFFICIENTS>, Failure> {
    let mut padded = [0.0; MOST_COEFFICIENTS];
    for (slot, a) in padded.iter_mut().zip(coefficients) {
        *slot = *a;
    }
    PolynomialPressure::new(padded).map_err(Failure::input)
}

/// True if a tier other than quadrature serves |v|^alpha on a patch.
pub fn is_served<R: Tabulated>(patch: &PatchName, alpha: f64) -> bool {
    match patch {
        PatchName::Polynomial(_) => R::HAS_POLYNOMIALS && alpha <= table::Table64::MAX_EXPONENT,
        PatchName::Points(_) => false,
        _ => true,
    }
}

/// The coupling of |v|^alpha on a round patch in the tier asked for, else in the quickest that
/// serves alpha. `None` for patches and tiers that only quadrature serves.
pub fn coupling<R: Tabulated>(
    patch: &PatchName,
    alpha: f64,
    tier: Option<Tier>,
) -> Result<Option<AnyRound<R>>, Failure> {
    let served = alpha <= table::Table64::MAX_EXPONENT;
    let tier = tier.unwrap_or(if served { Tier::Table } else { Tier::Compact });
    if tier == Tier::Quadrature || matches!(patch, PatchName::Points(_)) {
        return Ok(None);
    }
    let explained = |error: LawError| match tier {
        Tier::Table if !served => {
            Failure::input(format!("{error} for --tier table; use --tier compact"))
        }
        _ => Failure::input(error),
    };
    let narrow = R::from_f64(alpha);
    let built = match (patch, tier) {
        (PatchName::Annulus(inner), _) => {
            let disk = disk::<R>(alpha, tier).map_err(explained)?;
            let annulus = Annulus::new(AnyRound(disk), R::from_f64(*inner));
            Box::new(annulus.map_err(Failure::input)?)
        }
        (PatchName::Polynomial(coefficients), Tier::Table) => R::polynomial(narrow, coefficients)?,
        (PatchName::Polynomial(_), _) => {
            return Err(Failure::input(
                "polynomial patches are served by --tier table (alpha <= 10) and quadrature",
            ));
        }
        _ => round::<R>(patch, alpha, tier).map_err(explained)?,
    };
    Ok(Some(AnyRound(built)))
}

/// The uniform disk in the table or compact tier.
fn disk<R: Tabulated>(alpha: f64, tier: Tier) -> Result<Box<dyn Lateral<R>>, LawError> {
    let narrow = R::from_f64(alpha);
    Ok(match tier {
        Tier::Table if alpha == 0.0 => Box::new(table::Coulomb),
        Tier::Table => R::disk(narrow)?,
        _ if alpha == 0.0 => Box::new(compact::CompactCoulomb),
        _ => Box::new(compact::CompactPower::new(narrow)?),
    })
}

/// A pressure (1−r²)^q in the table or compact tier; the latter in closed form where there is one.
fn round<R: Tabulated>(
    patch: &PatchName,
    alpha: f64,
    tier: Tier,
) -> Result<Box<dyn Lateral<R>>, LawError> {
    let narrow = R::from_f64(alpha);
    let pressure = patch.pressure().unwrap_or(PowerPressure::UNIFORM);
    Ok(match (patch, tier) {
        (PatchName::Disk, _) => disk(alpha, tier)?,
        (_, Tier::Table) => R::round(narrow, pressure)?,
        (PatchName::Ring, _) if alpha == 0.0 => Box::new(closed::Ring),
        (PatchName::Hertz, _) if alpha == 0.0 => Box::new(closed::Hertz),
        (PatchName::Punch, _) if alpha == 0.0 => Box::new(closed::FlatPunch),
        _ => Box::new(compact::CompactPower::with_pressure(narrow, pressure)?),
    })
}

/// Any coupling with a lateral function.
pub struct AnyRound<R>(pub Box<dyn Lateral<R>>);

impl<R: Real> Coupling<R> for AnyRound<R> {
    fn reduced_wrench(&self, slide: R, rim: R) -> ReducedWrench<R> {
        self.0.reduced_wrench(slide, rim)
    }
    fn reduced_jacobian(&self, slide: R, rim: R) -> ReducedJacobian<R> {
        self.0.reduced_jacobian(slide, rim)
    }
}

impl<R: Real> Lateral<R> for AnyRound<R> {
    fn lateral(&self, slide: R, rim: R) -> R {
        self.0.lateral(slide, rim)
    }
    fn lateral_jacobian(&self, slide: R, rim: R) -> LateralJacobian<R> {
        self.0.lateral_jacobian(slide, rim)
    }
    fn mean_square_radius(&self) -> R {
        self.0.mean_square_radius()
    }
}

/// Any coupling.
pub struct AnyCoupling<R>(pub Box<dyn Coupling<R>>);

impl<R: Real> Coupling<R> for AnyCoupling<R> {
    fn reduced_wrench(&self, slide: R, rim: R) -> ReducedWrench<R> {
        self.0.reduced_wrench(slide, rim)
    }
    fn reduced_jacobian(&self, slide: R, rim: R) -> ReducedJacobian<R> {
        self.0.reduced_jacobian(slide, rim)
    }
}
