//! Penner's pipe.

use super::{Gradient, TallBody};
use crate::slide::MotionError;
use tribos_friction::{AnyFriction, Law, Patch};

/// A hollow cylinder that stands and slides on its end.
///
/// *Units*: SI. *Source*: A. R. Penner, Am. J. Phys. 69 (2001) 332, who compared paths of such
/// pipes with experiments; the equations are those of [`super::TallCylinder`] on a band.
///
/// ```
/// use tribos::slide::planar::{Gradient, Pipe, Resistance};
/// let thin = Pipe {
///     coefficient: 0.3,
///     alpha: 0.0,
///     radius: 0.05,
///     inner_ratio: 1.0,
///     height: 0.15,
///     gradient: Gradient::AllRound,
/// };
/// assert_eq!(thin.inertia_ratio(), 1.0); // all mass at R
/// assert_eq!(Pipe { inner_ratio: 0.0, ..thin }.inertia_ratio(), 0.5); // solid
/// // All friction acts at R, too: the rim of a spinning ring slows down with mu g.
/// let [_, _, rim] = thin.body(9.81)?.deceleration([0.0, 0.0, 0.5]);
/// assert!((rim - 0.3 * 9.81).abs() < 1e-14);
/// # Ok::<(), tribos::slide::MotionError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pipe {
    /// γ, in (s/m)^α; μ for α = 0.
    pub coefficient: f64,
    /// α of the local law.
    pub alpha: f64,
    /// Outer radius, in m.
    pub radius: f64,
    /// Inner radius over the outer one, from 0 to 1; 1 is a thin ring.
    pub inner_ratio: f64,
    /// Height of the pipe, in m.
    pub height: f64,
    /// Components of the pressure gradient that are included.
    pub gradient: Gradient,
}

impl Pipe {
    /// Inertia ratio C = (1 + k²)/2 about its own axis.
    pub fn inertia_ratio(&self) -> f64 {
        0.5 * (1.0 + self.inner_ratio * self.inner_ratio)
    }

    /// Its resistance under `gravity`, in m/s².
    pub fn body(&self, gravity: f64) -> Result<TallBody, MotionError> {
        self.body_under(&Law::power(self.coefficient, self.alpha)?, gravity)
    }

    /// Its resistance under `gravity`, in m/s², and another law than its own.
    pub(crate) fn body_under(&self, law: &Law, gravity: f64) -> Result<TallBody, MotionError> {
        let foot = AnyFriction::new(&Patch::band(self.inner_ratio), law, None)?;
        let foot = foot.with_radius(self.radius)?;
        let rest = [gravity, self.inertia_ratio()];
        TallBody::new(foot, 0.5 * self.height, self.gradient, rest)
    }
}
