//! The tall cylinder on its flat face.

use super::{Gradient, TallBody};
use crate::slide::MotionError;
use tribos_core::patch::PowerPressure;
use tribos_friction::{AnyFriction, Law};

/// A cylinder that slides on its flat side: counterclockwise spin bends its path to the right.
///
/// *Units*: SI. *Source*: section 3.5.1 of the thesis.
///
/// ```
/// use tribos::slide::planar::{PlanarSimulation, Launch, TallCylinder};
/// let cylinder = TallCylinder { height: 0.16, ..TallCylinder::solid(0.2, 0.08) };
/// let launch = Launch { velocity: [1.0, 0.0], spin: 5.0 };
/// let body = cylinder.body(9.81)?;
/// let end = PlanarSimulation::new(&body, &launch, 1e-4)?.to_end()?;
/// assert!((end.point.position[1] + 0.014632310).abs() < 1e-9);
/// # Ok::<(), tribos::slide::MotionError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TallCylinder {
    /// γ, in (s/m)^α; μ for α = 0.
    pub coefficient: f64,
    /// α of the local law.
    pub alpha: f64,
    /// Radius, in m.
    pub radius: f64,
    /// Height of the cylinder, in m; its centre of mass is at half the height.
    pub height: f64,
    /// C = I/(M R²) about its axis.
    pub inertia_ratio: f64,
    /// Pressure under the cylinder at rest.
    pub pressure: PowerPressure,
    /// Components of the pressure gradient that are included.
    pub gradient: Gradient,
}

impl TallCylinder {
    /// A solid, uniform cylinder under Coulomb friction, with height 0 until one is set.
    pub fn solid(coefficient: f64, radius: f64) -> Self {
        Self {
            coefficient,
            alpha: 0.0,
            radius,
            height: 0.0,
            inertia_ratio: 0.5,
            pressure: PowerPressure::UNIFORM,
            gradient: Gradient::AllRound,
        }
    }

    /// Its resistance under `gravity`, in m/s².
    pub fn body(&self, gravity: f64) -> Result<TallBody, MotionError> {
        self.body_under(&Law::power(self.coefficient, self.alpha)?, gravity)
    }

    /// Its resistance under `gravity`, in m/s², and another law than its own.
    pub(crate) fn body_under(&self, law: &Law, gravity: f64) -> Result<TallBody, MotionError> {
        let foot = AnyFriction::new(&self.pressure.into(), law, None)?.with_radius(self.radius)?;
        let rest = [gravity, self.inertia_ratio];
        TallBody::new(foot, 0.5 * self.height, self.gradient, rest)
    }
}
