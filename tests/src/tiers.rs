//! Every accuracy tier of one exponent, by name.

use tribos_core::coupling::quadrature::DiskQuadrature;
use tribos_core::coupling::table::{self, DiskTable32, DiskTable64};
use tribos_core::coupling::{ReducedFriction, compact};
use tribos_core::law::PowerLaw;
use tribos_core::real::Real;

/// A tier's name and the tier.
pub type Tier<R> = (&'static str, Box<dyn ReducedFriction<R>>);

/// A scalar whose tables can be built at run time.
pub trait Tabulated: Real {
    /// The table of exponent `alpha`, if it reaches that far.
    fn table(alpha: f64) -> Option<Box<dyn ReducedFriction<Self>>>;
}

impl Tabulated for f64 {
    fn table(alpha: f64) -> Option<Box<dyn ReducedFriction<f64>>> {
        Some(Box::new(DiskTable64::new(alpha).ok()?))
    }
}

impl Tabulated for f32 {
    fn table(alpha: f64) -> Option<Box<dyn ReducedFriction<f32>>> {
        Some(Box::new(DiskTable32::new(alpha as f32).ok()?))
    }
}

/// The tiers with rounding accuracy: tables up to their largest exponent, compact forms.
///
/// # Panics
/// If the exponent is refused.
pub fn exact<R: Tabulated>(alpha: f64) -> Vec<Tier<R>> {
    let mut tiers: Vec<Tier<R>> = Vec::new();
    if alpha == 0.0 {
        tiers.push(("coulomb table", Box::new(table::CoulombDisk)));
        tiers.push(("coulomb compact", Box::new(compact::CompactCoulombDisk)));
    }
    if alpha <= DiskTable64::MAX_EXPONENT {
        tiers.push(("table", R::table(alpha).expect("an exponent in range")));
    }
    let power = compact::CompactPower::new(R::from_f64(alpha)).expect("an exponent in range");
    tiers.push(("compact", Box::new(power)));
    tiers
}

/// All tiers: those of [`exact`] and the quadrature.
///
/// # Panics
/// If the exponent is refused.
pub fn all<R: Tabulated>(alpha: f64) -> Vec<Tier<R>> {
    let mut tiers = exact(alpha);
    let law = PowerLaw::new(R::from_f64(alpha), R::ONE).expect("an exponent in range");
    tiers.push(("quadrature", Box::new(DiskQuadrature::new(law))));
    tiers
}
