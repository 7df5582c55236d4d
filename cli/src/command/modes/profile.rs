//! The profile of a patch, handed to whoever asks: profiles have many types.

use crate::command::patch::PatchName;
use crate::command::tier::polynomial;
use crate::failure::Failure;
use tribos_core::coupling::compact::Power;
use tribos_core::coupling::round::LateralPolynomialTable;
use tribos_core::coupling::table::{self, Table64};
use tribos_core::coupling::{
    Annulus, Dry, DryCoupling, Lateral, LeanProfile, Profile, SmoothProfile, closed,
};

/// What to do with a profile.
pub trait Visitor {
    /// What comes out.
    type Output;
    /// Does it.
    fn visit<P: Profile<f64>>(self, profile: P) -> Result<Self::Output, Failure>;
}

/// Finds the profile of `patch` under |v|^`alpha`, for a body that leans by `lean`.
pub fn with<V: Visitor>(
    patch: &PatchName,
    alpha: f64,
    lean: f64,
    visitor: V,
) -> Result<V::Output, Failure> {
    if lean != 0.0 {
        return leaning(patch, alpha, lean, visitor);
    }
    let tabulated = alpha <= table::MAX_EXPONENT;
    match patch {
        PatchName::Points(_) => Err(Failure::input(
            "points have no axis of symmetry: their velocity ratio obeys no equation of its own; \
             name a round patch",
        )),
        PatchName::Polynomial(a) => {
            let table = LateralPolynomialTable::new(alpha, &polynomial(a)?);
            visitor.visit(table.map_err(Failure::input)?)
        }
        PatchName::Annulus(inner) if alpha == 0.0 => {
            visitor.visit(annulus(table::Coulomb, *inner)?)
        }
        PatchName::Annulus(inner) if tabulated => {
            let disk = Table64::new(alpha).map_err(Failure::input)?;
            visitor.visit(annulus(disk, *inner)?)
        }
        PatchName::Annulus(inner) => visitor.visit(annulus(power(patch, alpha)?, *inner)?),
        PatchName::Disk if alpha == 0.0 => visitor.visit(table::Coulomb),
        PatchName::Disk if tabulated => visitor.visit(Table64::new(alpha).map_err(Failure::input)?),
        _ => visitor.visit(power(patch, alpha)?),
    }
}

/// The same for a tall body.
fn leaning<V: Visitor>(
    patch: &PatchName,
    alpha: f64,
    lean: f64,
    visitor: V,
) -> Result<V::Output, Failure> {
    if alpha != 0.0 {
        return Err(Failure::input(
            "--lean needs --alpha 0: under other laws the lean changes with the speed, and the \
             velocity ratio obeys no equation of its own",
        ));
    }
    match patch {
        PatchName::Disk => visitor.visit(lean_profile(table::Coulomb, lean)?),
        PatchName::Ring => visitor.visit(lean_profile(closed::Ring, lean)?),
        PatchName::Hertz => visitor.visit(lean_profile(closed::Hertz, lean)?),
        PatchName::Punch => visitor.visit(lean_profile(closed::FlatPunch, lean)?),
        PatchName::Paraboloid => visitor.visit(lean_profile(dry(power(patch, alpha)?)?, lean)?),
        PatchName::Annulus(inner) => {
            visitor.visit(lean_profile(annulus(table::Coulomb, *inner)?, lean)?)
        }
        PatchName::Polynomial(a) => {
            let table = LateralPolynomialTable::new(alpha, &polynomial(a)?);
            visitor.visit(lean_profile(dry(table.map_err(Failure::input)?)?, lean)?)
        }
        PatchName::Points(_) => Err(Failure::input("points have no axis of symmetry")),
    }
}

fn lean_profile<P>(foot: P, lean: f64) -> Result<LeanProfile<f64, P>, Failure>
where
    P: Profile<f64> + DryCoupling<f64> + Lateral<f64>,
{
    LeanProfile::new(foot, lean).map_err(Failure::input)
}

fn annulus<P>(disk: P, inner: f64) -> Result<Annulus<f64, P>, Failure> {
    Annulus::new(disk, inner).map_err(Failure::input)
}

fn dry<P: SmoothProfile<f64>>(profile: P) -> Result<Dry<P>, Failure> {
    Dry::new(profile).map_err(Failure::input)
}

fn power(patch: &PatchName, alpha: f64) -> Result<Power<f64>, Failure> {
    let pressure = patch
        .pressure()
        .unwrap_or(tribos_core::patch::PowerPressure::UNIFORM);
    Power::with_pressure(alpha, pressure).map_err(Failure::input)
}
