//! The fitted forms of Coulomb friction in lanes.

use super::speeds::LaneSpeeds;
use super::{LaneProfile, Lanes};
use crate::coupling::SmoothProfile;
use crate::coupling::coulomb::{Fitted, form};
use crate::lanes::{Eight as _, Lanes as _, Numbers};
use crate::real::Real;

impl<R: Real, F: Fitted + SmoothProfile<R>> LaneProfile<R> for F {
    #[inline(always)]
    fn drags(&self, slide_sq: Lanes<R>, rim: Lanes<R>) -> Option<[Lanes<R>; 2]> {
        Some(form::drag::<F, _>(slide_sq, rim))
    }

    #[inline(always)]
    fn drags_and_torques(&self, at: &LaneSpeeds<R>) -> Option<[Lanes<R>; 2]> {
        let [phi, chi] = form::force_and_torque::<F, _>(at.sliding_leads(), at.complement());
        Some([phi, at.rim() * chi])
    }

    #[inline(always)]
    fn factors_and_slopes(&self, at: &LaneSpeeds<R>) -> Option<[Lanes<R>; 3]> {
        let z = at.complement();
        // Infinite slopes of a ring are left to the scalar, and so is the sign of ∞ − ∞.
        if F::IS_ENDLESS && !Lanes::<R>::all(z.above(Numbers::repeat(R::ZERO))) {
            return None;
        }
        let x = at.ratio * at.ratio;
        Some(form::factors_and_slope::<F, _>(at.sliding_leads(), [x, z]))
    }

    #[inline(always)]
    fn speed_scales(&self, _: Lanes<R>) -> Option<Lanes<R>> {
        Some(Numbers::repeat(R::ONE))
    }

    #[inline(always)]
    fn rate_scales(&self, speed: Lanes<R>) -> Option<Lanes<R>> {
        Some(Lanes::<R>::repeat(R::ONE) / speed)
    }
}
