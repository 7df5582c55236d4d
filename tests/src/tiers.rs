//! Every accuracy tier of one exponent, by name.

use tribos_core::coupling::quadrature::DiskQuadrature;
use tribos_core::coupling::table::{self, Table32, Table64};
use tribos_core::coupling::{Coupling, compact};
use tribos_core::law::PowerLaw;
use tribos_core::real::Real;

/// A tier's name and the tier.
pub type Tier<R> = (&'static str, Box<dyn Coupling<R>>);

/// A scalar whose tables can be built at run time.
pub trait Tabulated: Real {
    /// The table of exponent `alpha`, if it reaches that far.
    fn table(alpha: f64) -> Option<Box<dyn Coupling<Self>>>;
}

impl Tabulated for f64 {
    fn table(alpha: f64) -> Option<Box<dyn Coupling<f64>>> {
        Some(Box::new(Table64::new(alpha).ok()?))
    }
}

impl Tabulated for f32 {
    fn table(alpha: f64) -> Option<Box<dyn Coupling<f32>>> {
        Some(Box::new(Table32::new(alpha as f32).ok()?))
    }
}

/// The tiers with rounding accuracy: tables up to their largest exponent, compact forms.
///
/// # Panics
/// If the exponent is refused.
pub fn exact<R: Tabulated>(alpha: f64) -> Vec<Tier<R>> {
    let mut tiers: Vec<Tier<R>> = Vec::new();
    if alpha == 0.0 {
        tiers.push(("coulomb table", Box::new(table::Coulomb)));
        tiers.push(("coulomb compact", Box::new(compact::CompactCoulomb)));
    }
    if alpha <= Table64::MAX_EXPONENT {
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
