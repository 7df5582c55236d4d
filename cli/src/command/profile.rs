//! The profile of a named patch: what final motion and launches are computed from.

use super::patch::PatchName;
use super::tier::polynomial;
use crate::failure::Failure;
use tribos_core::coupling::compact::CompactPower;
use tribos_core::coupling::round::{LateralPolynomialTable, RoundTable64};
use tribos_core::coupling::table::{self, Coulomb, Table64};
use tribos_core::coupling::{Annulus, Coupling, Dry, DryCoupling, Lateral, Profile, closed};
use tribos_core::internals::{LeanProfile, SmoothProfile};
use tribos_core::patch::PowerPressure;

/// A law on a round patch, whatever its type.
pub trait Law: Profile<f64> + Coupling<f64> {}

impl<P: Profile<f64> + Coupling<f64>> Law for P {}

/// |v|^`alpha` on `patch`: closed forms where there are, else tables, else series.
pub fn upright(patch: &PatchName, alpha: f64) -> Result<Box<dyn Law>, Failure> {
    let dry = alpha == 0.0;
    let tabulated = alpha <= table::Table64::MAX_EXPONENT;
    Ok(match patch {
        PatchName::Disk if dry => Box::new(Coulomb),
        PatchName::Disk if tabulated => Box::new(disk(alpha)?),
        PatchName::Ring if dry => Box::new(closed::Ring),
        PatchName::Hertz if dry => Box::new(closed::Hertz),
        PatchName::Punch if dry => Box::new(closed::FlatPunch),
        PatchName::Annulus(inner) if dry => Box::new(annulus(Coulomb, *inner)?),
        PatchName::Annulus(inner) if tabulated => Box::new(annulus(disk(alpha)?, *inner)?),
        PatchName::Annulus(inner) => {
            Box::new(annulus(power(PowerPressure::UNIFORM, alpha)?, *inner)?)
        }
        PatchName::Polynomial(a) => Box::new(sum(a, alpha)?),
        PatchName::Points(_) => return Err(without_axis()),
        _ => {
            let pressure = patch.pressure().unwrap_or(PowerPressure::UNIFORM);
            if tabulated {
                Box::new(RoundTable64::new(alpha, pressure).map_err(Failure::input)?)
            } else {
                Box::new(power(pressure, alpha)?)
            }
        }
    })
}

/// Dry friction on the foot of a body that leans by `lean`.
pub fn leaning(patch: &PatchName, lean: f64) -> Result<Box<dyn Profile<f64>>, Failure> {
    Ok(match patch {
        PatchName::Disk => Box::new(leaned(Coulomb, lean)?),
        PatchName::Ring => Box::new(leaned(closed::Ring, lean)?),
        PatchName::Hertz => Box::new(leaned(closed::Hertz, lean)?),
        PatchName::Punch => Box::new(leaned(closed::FlatPunch, lean)?),
        PatchName::Annulus(inner) => Box::new(leaned(annulus(Coulomb, *inner)?, lean)?),
        PatchName::Polynomial(a) => Box::new(leaned(dry(sum(a, 0.0)?)?, lean)?),
        PatchName::Paraboloid => {
            let table =
                RoundTable64::new(0.0, PowerPressure::PARABOLOID).map_err(Failure::input)?;
            Box::new(leaned(dry(table)?, lean)?)
        }
        PatchName::Points(_) => return Err(without_axis()),
    })
}

fn without_axis() -> Failure {
    Failure::input("points have no axis of symmetry: name a round patch")
}

fn disk(alpha: f64) -> Result<Table64, Failure> {
    Table64::new(alpha).map_err(Failure::input)
}

fn power(pressure: PowerPressure, alpha: f64) -> Result<CompactPower<f64>, Failure> {
    CompactPower::with_pressure(alpha, pressure).map_err(Failure::input)
}

fn sum(coefficients: &[f64], alpha: f64) -> Result<LateralPolynomialTable, Failure> {
    LateralPolynomialTable::new(alpha, &polynomial(coefficients)?).map_err(Failure::input)
}

fn annulus<P>(disk: P, inner: f64) -> Result<Annulus<f64, P>, Failure> {
    Annulus::new(disk, inner).map_err(Failure::input)
}

fn dry<P: SmoothProfile<f64>>(profile: P) -> Result<Dry<P>, Failure> {
    Dry::new(profile).map_err(Failure::input)
}

fn leaned<P>(foot: P, lean: f64) -> Result<LeanProfile<f64, P>, Failure>
where
    P: Profile<f64> + DryCoupling<f64> + Lateral<f64>,
{
    LeanProfile::new(foot, lean).map_err(Failure::input)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_round_patch_serves_every_law() {
        for name in [
            "disk",
            "ring",
            "annulus:0.5",
            "hertz",
            "punch",
            "paraboloid",
            "polynomial:1,1",
        ] {
            let patch: PatchName = name.parse().expect("a patch");
            for alpha in [0.0, 0.5] {
                // A pure slide feels the speed's power on every patch.
                let force = upright(&patch, alpha)
                    .expect("a law")
                    .reduced_wrench(4.0, 0.0)
                    .force;
                assert!((force - 4.0_f64.powf(alpha)).abs() < 1e-13, "{name}");
            }
            assert!(leaning(&patch, 0.5).is_ok(), "{name}");
        }
    }
}
