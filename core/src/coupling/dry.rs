//! Dry friction from a profile whose exponent is found to be 0 at run time.

use super::{DominantSpeed, SmoothProfile, Speeds};
use super::{
    DryReducedFriction, LateralFriction, LateralJacobian, PowerLawFriction, ReducedFriction,
    ReducedJacobian, ReducedWrench,
};
use crate::law::LawError;
use crate::real::Real;

/// A profile whose exponent was found to be 0 at run time: it serves where the type must be a
/// [`DryReducedFriction`], such as a limit surface.
///
/// ```
/// use tribos_core::coupling::{DryProfile, round::RoundTable64};
/// use tribos_core::limit_surface::RoundLimitSurface;
/// use tribos_core::patch::PowerPressure;
/// let table = DryProfile::new(RoundTable64::new(0.0, PowerPressure::PARABOLOID)?)?;
/// let pad = RoundLimitSurface::new(&table, 0.5_f64, 0.01)?;
/// assert!((pad.torque_limit() - 0.5 * 0.01 * 8.0 / 15.0).abs() < 1e-15);
/// # Ok::<(), tribos_core::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct DryProfile<P> {
    profile: P,
}

impl<P> DryProfile<P> {
    /// *Domain*: a profile of exponent 0.
    pub fn new<R: Real>(profile: P) -> Result<Self, LawError>
    where
        P: PowerLawFriction<R>,
    {
        let alpha = profile.exponent();
        if alpha == R::ZERO {
            Ok(Self { profile })
        } else {
            Err(LawError::NotDry {
                given: alpha.to_f64(),
            })
        }
    }
}

impl<R: Real, P: PowerLawFriction<R>> PowerLawFriction<R> for DryProfile<P> {
    #[inline]
    fn exponent(&self) -> R {
        R::ZERO
    }
    #[inline]
    fn factors(&self, at: &Speeds<R>) -> [R; 2] {
        self.profile.factors(at)
    }
    fn inertia_excess(&self, at: &Speeds<R>, inertia_ratio: R) -> R {
        self.profile.inertia_excess(at, inertia_ratio)
    }
    fn inertia_ends(&self) -> [R; 2] {
        self.profile.inertia_ends()
    }
}

impl<R: Real, P: SmoothProfile<R>> SmoothProfile<R> for DryProfile<P> {
    #[inline]
    fn factors_and_slope(&self, at: &Speeds<R>) -> [R; 3] {
        self.profile.factors_and_slope(at)
    }
    #[inline]
    fn factors_and_rough_slope(&self, at: &Speeds<R>) -> [R; 3] {
        self.profile.factors_and_rough_slope(at)
    }
}

impl<R: Real, P: SmoothProfile<R>> ReducedFriction<R> for DryProfile<P> {
    #[inline]
    fn reduced_wrench(&self, slide: R, rim: R) -> ReducedWrench<R> {
        super::profile::wrench(self, slide, rim)
    }
    #[inline]
    fn reduced_jacobian(&self, slide: R, rim: R) -> ReducedJacobian<R> {
        super::profile::jacobian(self, slide, rim)
    }
    #[inline]
    fn reduced_drag(&self, slide_sq: R, rim: R) -> [R; 2] {
        self.profile.drag(slide_sq, rim)
    }
}

impl<R: Real, P: SmoothProfile<R>> DryReducedFriction<R> for DryProfile<P> {
    #[inline]
    fn reduced_point(&self, lead: DominantSpeed, ratio: R) -> [R; 3] {
        super::profile::point(self, lead, ratio)
    }
}

impl<R: Real, P: SmoothProfile<R> + LateralFriction<R>> LateralFriction<R> for DryProfile<P> {
    #[inline]
    fn lateral(&self, slide: R, rim: R) -> R {
        self.profile.lateral(slide, rim)
    }
    #[inline]
    fn lateral_jacobian(&self, slide: R, rim: R) -> LateralJacobian<R> {
        self.profile.lateral_jacobian(slide, rim)
    }
    fn mean_square_radius(&self) -> R {
        self.profile.mean_square_radius()
    }
}
