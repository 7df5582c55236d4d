//! A uniform annulus: the disk minus its middle.

use super::extended_range::{ExtendedRange, is_in_normal_range};
use super::lateral::{LateralFriction, LateralJacobian};
use super::profile::{PowerLawFriction, SmoothProfile};
use super::rings::{Rings, ring_factors};
use super::speeds::Speeds;
use super::{DryReducedFriction, ReducedFriction, ReducedJacobian, ReducedWrench};
use crate::patch::PatchError;
use crate::real::Real;

/// Uniform pressure between `inner_ratio` and 1 radii, from any tier of the uniform disk.
///
/// With k the inner over the outer radius, F = (F₁(v, w) − k² F₁(v, kw))/(1−k²) and the torque
/// likewise with k³; for k > 15/16 both are means over rings, from the disk's wrench and Jacobian.
/// *Accuracy*: force and torque that of the disk times 2/(1−k) for k ≤ 15/16; above, for α ≥ 0, that
/// of the disk's wrench and Jacobian (6e-15 in f64, 4e-6 in f32), as long as its F/v is in the number
/// range. Jacobian and lateral function that of the disk times 2/(1−k), and as if 1−k were √ε of the
/// type where it is less. *Special values*: as [`ReducedFriction`]; infinite where one of the disks leaves
/// the number range, rounded where k w is below it. *Cost*: two of the disk; for k > 15/16 a wrench is
/// 16 wrenches and Jacobians of the disk, or 32 with the centre of rotation in the band or next to it.
///
/// ```
/// use tribos_core::coupling::{Annulus, ReducedFriction, coulomb};
/// let band = Annulus::new(coulomb::CoulombDisk, 0.5_f64)?;
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

/// Inner ratio above which the wrench is a mean over rings: the difference would lose more than five
/// bits.
const THIN: f64 = 0.9375;

impl<R: Real, C> Annulus<R, C> {
    /// Thinnest annulus: beyond, a ring is as good to six digits.
    ///
    /// ```
    /// use tribos_core::coupling::{Annulus, coulomb::CoulombDisk};
    /// use tribos_core::patch::PatchError;
    /// let max = Annulus::<f64, CoulombDisk>::MAX_INNER_RATIO;
    /// let refused = Annulus::new(CoulombDisk, 0.999_999_9_f64);
    /// assert_eq!(refused, Err(PatchError::InnerRatio { given: 0.999_999_9, max }));
    /// ```
    pub const MAX_INNER_RATIO: f64 = 0.999_999;

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

    /// The annulus whose derivatives and lateral function serve for this one: of a band narrower
    /// than √ε the difference would leave rounding alone.
    #[inline]
    fn resolved(&self) -> Annulus<R, &C> {
        let widest = R::ONE - R::EPSILON.sqrt();
        Annulus {
            inner: if self.inner < widest {
                self.inner
            } else {
                widest
            },
            disk: &self.disk,
        }
    }

    /// k², k³, k⁴.
    #[inline]
    fn powers(&self) -> [R; 3] {
        let square = self.inner * self.inner;
        [square, square * self.inner, square * square]
    }
}

impl<R: Real, C: ReducedFriction<R>> Annulus<R, C> {
    /// The whole disk less its middle.
    #[inline]
    fn difference(&self, slide: R, rim: R) -> ReducedWrench<R> {
        let [k2, k3, _] = self.powers();
        let whole = self.disk.reduced_wrench(slide, rim);
        let middle = self.disk.reduced_wrench(slide, self.inner * rim);
        ReducedWrench {
            force: self.less(whole.force, middle.force, k2),
            torque: self.less(whole.torque, middle.torque, k3),
        }
    }

    /// The mean of the rings; the difference where their slopes leave the number range.
    #[inline(never)]
    fn mean_of_rings(&self, slide: R, rim: R) -> ReducedWrench<R> {
        let (slide, rim) = (slide.abs(), rim.abs());
        let drag = self.disk.reduced_jacobian(slide, rim).force_per_slide;
        let mean = if is_in_normal_range(drag) {
            self.rings(slide, rim)
        } else {
            [R::NAN; 2]
        };
        let difference = self.difference(slide, rim);
        let resolved = Speeds::new(slide, rim).are_resolved(slide, rim);
        let [force, torque] = mean;
        // The smaller of two speeds whose ratio squared is below the range has no slopes.
        let keeps = |x: R, leads: bool| x.is_finite() && (resolved || leads);
        ReducedWrench {
            force: if keeps(force, slide > rim) {
                force
            } else {
                difference.force
            },
            torque: if keeps(torque, slide <= rim) {
                torque
            } else {
                difference.torque
            },
        }
    }

    /// Means of the rings' forces and torques.
    fn rings(&self, slide: R, rim: R) -> [R; 2] {
        Rings::new(self.inner).mean([slide, rim], |radius| {
            let within = radius * rim;
            let ReducedWrench { force, torque } = self.disk.reduced_wrench(slide, within);
            let slopes = self.disk.reduced_jacobian(slide, within);
            let half = R::HALF * within;
            let torque = (R::ONE + R::HALF) * torque + half * slopes.torque_rim;
            [force + half * slopes.mixed, radius * torque]
        })
    }
}

impl<R: Real, C: ReducedFriction<R>> ReducedFriction<R> for Annulus<R, C> {
    #[inline]
    fn reduced_wrench(&self, slide: R, rim: R) -> ReducedWrench<R> {
        if self.inner > R::from_f64(THIN) {
            self.mean_of_rings(slide, rim)
        } else {
            self.difference(slide, rim)
        }
    }

    fn reduced_jacobian(&self, slide: R, rim: R) -> ReducedJacobian<R> {
        let whole = self.disk.reduced_jacobian(slide, rim);
        if self.inner == R::ZERO {
            return whole;
        }
        if slide == R::ZERO && rim == R::ZERO {
            // Damping at rest: the torque's scales with ⟨r²⟩.
            return ReducedJacobian {
                torque_rim: whole.torque_rim * (R::ONE + self.inner * self.inner),
                ..whole
            };
        }
        let band = self.resolved();
        let [k2, k3, k4] = band.powers();
        let middle = self.disk.reduced_jacobian(slide, band.inner * rim);
        ReducedJacobian {
            force_per_slide: band.less(whole.force_per_slide, middle.force_per_slide, k2),
            force_slide: band.less(whole.force_slide, middle.force_slide, k2),
            mixed: band.less(whole.mixed, middle.mixed, k3),
            torque_rim: band.less(whole.torque_rim, middle.torque_rim, k4),
        }
    }
}

impl<R: Real, C: DryReducedFriction<R>> DryReducedFriction<R> for Annulus<R, C> {}

impl<R: Real, P: SmoothProfile<R>> PowerLawFriction<R> for Annulus<R, P> {
    fn exponent(&self) -> R {
        self.disk.exponent()
    }
    #[inline]
    fn speed_scale(&self, speed: R) -> R {
        self.disk.speed_scale(speed)
    }
    #[inline]
    fn rate_scale(&self, speed: R) -> R {
        self.disk.rate_scale(speed)
    }

    /// F/v and T/w at max(v, w) = 1.
    fn factors(&self, at: &Speeds<R>) -> [R; 2] {
        if self.inner > R::from_f64(THIN) {
            return self.mean_factors(at);
        }
        let [k2, _, k4] = self.powers();
        let [phi, chi] = self.disk.factors(at);
        let inside = Speeds::new(at.slide, self.inner * at.rim);
        if inside.at_rest() {
            return [self.less(phi, R::ZERO, k2), self.less(chi, R::ZERO, k4)];
        }
        let scale = self.disk.rate_scale(inside.major);
        let [phi_middle, chi_middle] = self.disk.factors(&inside);
        if is_in_normal_range(scale) && is_in_normal_range(k4) {
            return [
                self.less(phi, scale * phi_middle, k2),
                self.less(chi, scale * chi_middle, k4),
            ];
        }
        // A hole so small that its weight and its speed leave the number range.
        let inner = ExtendedRange::new(self.inner);
        let square = inner.times(inner);
        let exponent = self.disk.exponent() - R::ONE;
        let scale = ExtendedRange::power(inside.major, exponent).times(square);
        let force = scale.times(ExtendedRange::new(phi_middle));
        let torque = scale.times(square).times(ExtendedRange::new(chi_middle));
        [
            self.less(phi, force.value(), R::ONE),
            self.less(chi, torque.value(), R::ONE),
        ]
    }
}

impl<R: Real, P: SmoothProfile<R>> Annulus<R, P> {
    /// F/v and T/w at max(v, w) = 1 as means of the rings.
    fn mean_factors(&self, at: &Speeds<R>) -> [R; 2] {
        Rings::new(self.inner).mean([at.slide, at.rim], |radius| {
            let inside = Speeds::new(at.slide, radius * at.rim);
            let factors = self.disk.factors_and_slope(&inside);
            let scale = self.disk.rate_scale(inside.major);
            let [phi, chi] = ring_factors(self.disk.exponent(), &inside, factors);
            [scale * phi, scale * radius * radius * chi]
        })
    }
}

impl<R: Real, C: LateralFriction<R>> LateralFriction<R> for Annulus<R, C> {
    fn lateral(&self, slide: R, rim: R) -> R {
        let band = self.resolved();
        let [_, k3, _] = band.powers();
        let middle = self.disk.lateral(slide, band.inner * rim);
        band.less(self.disk.lateral(slide, rim), middle, k3)
    }

    fn lateral_jacobian(&self, slide: R, rim: R) -> LateralJacobian<R> {
        let band = self.resolved();
        let [_, k3, k4] = band.powers();
        let whole = self.disk.lateral_jacobian(slide, rim);
        let middle = self.disk.lateral_jacobian(slide, band.inner * rim);
        LateralJacobian {
            slide: band.less(whole.slide, middle.slide, k3),
            rim: band.less(whole.rim, middle.rim, k4),
        }
    }

    fn mean_square_radius(&self) -> R {
        let [k2, ..] = self.powers();
        self.disk.mean_square_radius() * (R::ONE + k2)
    }
}
