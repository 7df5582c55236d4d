//! A friction set that is stronger or weaker than another.

use super::{FrictionSet, Projection};
use crate::law::{LawError, validated_positive};
use crate::real::Real;
use crate::twist::{Twist, Wrench};

/// Another set times a strength s > 0: all wrenches s x with x in the set.
///
/// It carries what changes from step to step: the load, friction that grows with the time of rest
/// ([`crate::law::StaticAgeing`]) or falls with the speed ([`crate::law::Stribeck`]). Motions and
/// directions are those of the set, so nothing needs to be prepared anew.
///
/// *Accuracy*: that of the set. *Cost*: that of the set and three divisions.
///
/// ```
/// use tribos_core::coupling::coulomb::CoulombDisk;
/// use tribos_core::law::{RestTime, StaticAgeing, StickSlip};
/// use tribos_core::limit_surface::{FrictionSet, RoundLimitSurface, ScaledSet};
/// use tribos_core::twist::Wrench;
/// let puck = RoundLimitSurface::new(CoulombDisk, 2.0_f64, 0.04)?; // N under mu = 1, m
/// let wood = StaticAgeing::new(0.4, 0.03, 1.0)?; // cut-off 1 s
/// let rested = RestTime::ZERO.advance(3600.0, StickSlip::Stick); // s
/// let [young, old] = [RestTime::ZERO, rested].map(|age| ScaledSet::new(&puck, wood.mu_static(age)));
/// let push = Wrench::new(1.0, 0.0, 0.0); // N
/// assert!(!young?.contains(&push) && old?.contains(&push));
/// # Ok::<(), tribos_core::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ScaledSet<'a, R, S: ?Sized> {
    set: &'a S,
    strength: R,
}

impl<'a, R: Real, S: FrictionSet<R> + ?Sized> ScaledSet<'a, R, S> {
    /// *Domain*: 0 < `strength` < ∞.
    pub fn new(set: &'a S, strength: R) -> Result<Self, LawError> {
        let strength = validated_positive("strength", strength)?;
        Ok(Self { set, strength })
    }

    /// The factor s.
    pub fn strength(&self) -> R {
        self.strength
    }

    /// `wrench`/s
    #[inline]
    fn reduced(&self, wrench: &Wrench<R>) -> Wrench<R> {
        let s = self.strength;
        Wrench::new(wrench.force.x / s, wrench.force.y / s, wrench.torque / s)
    }
}

impl<R: Real, S: FrictionSet<R> + ?Sized> FrictionSet<R> for ScaledSet<'_, R, S> {
    #[inline]
    fn force_limit(&self) -> R {
        self.strength * self.set.force_limit()
    }
    #[inline]
    fn radius(&self) -> R {
        self.set.radius()
    }
    #[inline]
    fn support(&self, twist: &Twist<R>) -> R {
        self.strength * self.set.support(twist)
    }
    #[inline]
    fn wrench(&self, twist: &Twist<R>) -> Wrench<R> {
        self.set.wrench(twist) * self.strength
    }
    #[inline]
    fn gauge(&self, wrench: &Wrench<R>) -> R {
        // Of the wrench that is projected: both agree on what is inside.
        self.set.gauge(&self.reduced(wrench))
    }
    #[inline]
    fn contains(&self, wrench: &Wrench<R>) -> bool {
        self.set.contains(&self.reduced(wrench))
    }
    #[inline]
    fn twist_normal_to(&self, push: &Wrench<R>) -> Twist<R> {
        self.set.twist_normal_to(push)
    }
    #[inline]
    fn scale_to_surface(&self, wrench: &Wrench<R>) -> Wrench<R> {
        let scaled = self.set.scale_to_surface(&self.reduced(wrench));
        if *wrench == Wrench::ZERO {
            return *wrench;
        }
        scaled * self.strength
    }
    #[inline]
    fn project_with_length(&self, wrench: &Wrench<R>, length: R) -> Projection<R> {
        let reduced = self.reduced(wrench);
        let Projection {
            wrench: nearest,
            region,
        } = self.set.project_with_length(&reduced, length);
        // A wrench inside keeps its bits.
        let wrench = if nearest == reduced {
            *wrench
        } else {
            nearest * self.strength
        };
        Projection { wrench, region }
    }
}
