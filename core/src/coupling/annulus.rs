//! A uniform annulus: the whole disk less its middle.

use super::lateral::{Lateral, LateralJacobian};
use super::profile::Profile;
use super::speeds::Speeds;
use super::wide::{Wide, is_ordinary};
use super::{Coupling, DryCoupling, ReducedJacobian, ReducedWrench};
use crate::patch::PatchError;
use crate::real::Real;

/// Uniform pressure between `inner_ratio` and 1 radii, from any tier of the uniform disk.
///
/// With k the inner over the outer radius, F = (F₁(v, w) − k² F₁(v, kw))/(1−k²) and the torque
/// likewise with k³. *Accuracy*: that of the disk times 2/(1−k). *Special values*: as [`Coupling`];
/// infinite where one of the disks leaves the number range, rounded where k w is below it.
///
/// ```
/// use tribos_core::coupling::{Annulus, Coupling, table};
/// let band = Annulus::new(table::Coulomb, 0.5_f64)?;
/// let torque = band.reduced_wrench(0.0, 1.0).torque;
/// assert!((torque - (2.0 / 3.0) * (1.0 - 0.125) / (1.0 - 0.25)).abs() < 1e-15);
/// # Ok::<(), tribos_core::patch::PatchError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Annulus<R, C> {
    disk: C,
    inner: R,
}

impl<R: Real, C> Annulus<R, C> {
    /// Thinnest annulus: beyond, three digits are lost, and a ring is the better model.
    ///
    /// ```
    /// use tribos_core::coupling::{Annulus, table::Coulomb};
    /// use tribos_core::patch::PatchError;
    /// let max = Annulus::<f64, Coulomb>::MAX_INNER_RATIO;
    /// let refused = Annulus::new(Coulomb, 0.9999_f64);
    /// assert_eq!(refused, Err(PatchError::InnerRatio { given: 0.9999, max }));
    /// ```
    pub const MAX_INNER_RATIO: f64 = 0.999;

    /// *Domain*: 0 ≤ `inner_ratio` ≤ [`Annulus::MAX_INNER_RATIO`]; `disk` is a coupling of the
    /// uniform disk.
    pub fn new(disk: C, inner_ratio: R) -> Result<Self, PatchError> {
        let max = Self::MAX_INNER_RATIO;
        if inner_ratio >= R::ZERO && inner_ratio <= R::from_f64(max) {
            Ok(Self {
                disk,
                inner: inner_ratio,
            })
        } else {
            Err(PatchError::InnerRatio {
                given: inner_ratio.to_f64(),
                max,
            })
        }
    }

    /// (`whole` − k^`power` `middle`)/(1 − k²), the power as a product.
    #[inline]
    fn less(&self, whole: R, middle: R, factor: R) -> R {
        // Where one disk leaves the number range the annulus does, or is next to it.
        if self.inner == R::ZERO || whole.abs() == R::INFINITY {
            return whole;
        }
        if middle.abs() == R::INFINITY {
            return R::INFINITY.copysign(whole) + R::ZERO * whole;
        }
        (whole - factor * middle) / ((R::ONE - self.inner) * (R::ONE + self.inner))
    }

    /// k², k³, k⁴.
    #[inline]
    fn powers(&self) -> [R; 3] {
        let square = self.inner * self.inner;
        [square, square * self.inner, square * square]
    }
}

impl<R: Real, C: Coupling<R>> Coupling<R> for Annulus<R, C> {
    #[inline]
    fn reduced_wrench(&self, slide: R, rim: R) -> ReducedWrench<R> {
        let [k2, k3, _] = self.powers();
        let whole = self.disk.reduced_wrench(slide, rim);
        let middle = self.disk.reduced_wrench(slide, self.inner * rim);
        ReducedWrench {
            force: self.less(whole.force, middle.force, k2),
            torque: self.less(whole.torque, middle.torque, k3),
        }
    }

    fn reduced_jacobian(&self, slide: R, rim: R) -> ReducedJacobian<R> {
        let [k2, k3, k4] = self.powers();
        let whole = self.disk.reduced_jacobian(slide, rim);
        if self.inner == R::ZERO {
            return whole;
        }
        if slide == R::ZERO && rim == R::ZERO {
            // Damping at rest: the torque's scales with ⟨r²⟩.
            return ReducedJacobian {
                torque_rim: whole.torque_rim * (R::ONE + k2),
                ..whole
            };
        }
        let middle = self.disk.reduced_jacobian(slide, self.inner * rim);
        ReducedJacobian {
            force_per_slide: self.less(whole.force_per_slide, middle.force_per_slide, k2),
            force_slide: self.less(whole.force_slide, middle.force_slide, k2),
            mixed: self.less(whole.mixed, middle.mixed, k3),
            torque_rim: self.less(whole.torque_rim, middle.torque_rim, k4),
        }
    }
}

impl<R: Real, C: DryCoupling<R>> DryCoupling<R> for Annulus<R, C> {}

impl<R: Real, P: Profile<R>> Profile<R> for Annulus<R, P> {
    fn exponent(&self) -> R {
        self.disk.exponent()
    }

    /// F/v and T/w at max(v, w) = 1.
    fn factors(&self, at: &Speeds<R>) -> [R; 2] {
        let [k2, _, k4] = self.powers();
        let [phi, chi] = self.disk.factors(at);
        let inside = Speeds::new(at.slide, self.inner * at.rim);
        if inside.at_rest() {
            return [self.less(phi, R::ZERO, k2), self.less(chi, R::ZERO, k4)];
        }
        let scale = self.disk.rate_scale(inside.major);
        let [phi_middle, chi_middle] = self.disk.factors(&inside);
        if is_ordinary(scale) && is_ordinary(k4) {
            return [
                self.less(phi, scale * phi_middle, k2),
                self.less(chi, scale * chi_middle, k4),
            ];
        }
        // A hole so small that its weight and its speed leave the number range.
        let inner = Wide::new(self.inner);
        let square = inner.times(inner);
        let exponent = self.disk.exponent() - R::ONE;
        let scale = Wide::power(inside.major, exponent).times(square);
        let force = scale.times(Wide::new(phi_middle));
        let torque = scale.times(square).times(Wide::new(chi_middle));
        [
            self.less(phi, force.value(), R::ONE),
            self.less(chi, torque.value(), R::ONE),
        ]
    }
}

impl<R: Real, C: Lateral<R>> Lateral<R> for Annulus<R, C> {
    fn lateral(&self, slide: R, rim: R) -> R {
        let [_, k3, _] = self.powers();
        let middle = self.disk.lateral(slide, self.inner * rim);
        self.less(self.disk.lateral(slide, rim), middle, k3)
    }

    fn lateral_jacobian(&self, slide: R, rim: R) -> LateralJacobian<R> {
        let [_, k3, k4] = self.powers();
        let whole = self.disk.lateral_jacobian(slide, rim);
        let middle = self.disk.lateral_jacobian(slide, self.inner * rim);
        LateralJacobian {
            slide: self.less(whole.slide, middle.slide, k3),
            rim: self.less(whole.rim, middle.rim, k4),
        }
    }

    fn mean_square_radius(&self) -> R {
        let [k2, ..] = self.powers();
        self.disk.mean_square_radius() * (R::ONE + k2)
    }
}
