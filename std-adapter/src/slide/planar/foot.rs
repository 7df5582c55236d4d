//! What a body stands on.

use crate::slide::SlideError;
use std::fmt;
use tribos_core::coupling::round::RoundTable64;
use tribos_core::coupling::table::{Coulomb, Table64};
use tribos_core::coupling::{Annulus, Coupling, Lateral, ReducedJacobian, ReducedWrench};
use tribos_core::internals::LateralJacobian;
use tribos_core::patch::PowerPressure;

/// A round foot, or a band, under the power law: the kernel's coupling for it, chosen at run time.
///
/// ```
/// use tribos::kernel::coupling::Coupling;
/// use tribos::kernel::patch::PowerPressure;
/// use tribos::slide::planar::Foot;
/// // Torque of a spin in place over mu N R: the mean radius under the pressure.
/// let torque = |foot: Foot| foot.reduced_wrench(0.0, 1.0).torque;
/// assert!((torque(Foot::round(0.0, PowerPressure::UNIFORM)?) - 2.0 / 3.0).abs() < 1e-14);
/// let hertz = Foot::round(0.0, PowerPressure::HERTZ)?;
/// assert!((torque(hertz) - 3.0 * std::f64::consts::PI / 16.0).abs() < 1e-14);
/// let band = Foot::band(0.0, 0.5)?;
/// assert_eq!(band.exponent(), 0.0);
/// assert!((torque(band) - 2.0 / 3.0 * (1.0 - 0.125) / (1.0 - 0.25)).abs() < 1e-14);
/// # Ok::<(), tribos::slide::SlideError>(())
/// ```
pub struct Foot {
    coupling: Box<dyn Lateral<f64>>,
    exponent: f64,
}

impl Foot {
    /// A disk under the pressure (1−r²)^q, or a thin ring.
    pub fn round(alpha: f64, pressure: PowerPressure) -> Result<Self, SlideError> {
        let coupling: Box<dyn Lateral<f64>> = if pressure != PowerPressure::UNIFORM {
            Box::new(RoundTable64::new(alpha, pressure)?)
        } else if alpha == 0.0 {
            Box::new(Coulomb)
        } else {
            Box::new(Table64::new(alpha)?)
        };
        Ok(Self {
            coupling,
            exponent: alpha,
        })
    }

    /// A band from `inner_ratio` to 1 radii under uniform pressure; a ring if it is too thin.
    pub fn band(alpha: f64, inner_ratio: f64) -> Result<Self, SlideError> {
        if inner_ratio > Annulus::<f64, Coulomb>::MAX_INNER_RATIO {
            return Self::round(alpha, PowerPressure::RING);
        }
        let coupling: Box<dyn Lateral<f64>> = if alpha == 0.0 {
            Box::new(Annulus::new(Coulomb, inner_ratio)?)
        } else {
            Box::new(Annulus::new(Table64::new(alpha)?, inner_ratio)?)
        };
        Ok(Self {
            coupling,
            exponent: alpha,
        })
    }

    /// α
    pub fn exponent(&self) -> f64 {
        self.exponent
    }
}

impl fmt::Debug for Foot {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Foot")
            .field("exponent", &self.exponent)
            .finish_non_exhaustive()
    }
}

impl Coupling<f64> for Foot {
    fn reduced_wrench(&self, slide: f64, rim: f64) -> ReducedWrench<f64> {
        self.coupling.reduced_wrench(slide, rim)
    }
    fn reduced_jacobian(&self, slide: f64, rim: f64) -> ReducedJacobian<f64> {
        self.coupling.reduced_jacobian(slide, rim)
    }
}

impl Lateral<f64> for Foot {
    fn lateral(&self, slide: f64, rim: f64) -> f64 {
        self.coupling.lateral(slide, rim)
    }
    fn lateral_jacobian(&self, slide: f64, rim: f64) -> LateralJacobian<f64> {
        self.coupling.lateral_jacobian(slide, rim)
    }
    fn mean_square_radius(&self) -> f64 {
        self.coupling.mean_square_radius()
    }
}
