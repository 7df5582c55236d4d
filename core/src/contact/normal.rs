//! Volume exclusion, cohesion and restitution along the normal.
//!
//! Signorini's condition with cohesion (thesis, section 4.3.1, fig. 4.2): at zero gap any push and
//! any pull up to the cohesion strength; within the range d_c a pull up to that strength; beyond it
//! nothing. Drawing a contact apart costs the work E_c = F_coh d_c. What the pull does at a gap
//! that does not grow is open in the source; [`Attraction`] names both readings.

use crate::law::LawError;
use crate::real::Real;

/// What cohesion does within its range.
///
/// ```
/// use nalgebra::Vector3;
/// use tribos_core::contact::*;
/// # let still = Vector3::new(0.0, 0.0, 0.0);
/// # let up = Vector3::new(0.0, 0.0, 1.0);
/// // A ball of 1 kg let go 0.5 mm off a wall that attracts by 2 N up to 1 mm; a millisecond later.
/// let speed = |attraction| -> Result<f64, tribos_core::Error> {
///     let mut ball = SphereBody { velocity: still, spin: still, inv_mass: 1.0, inv_inertia: 1000.0 };
///     let mut wall = WallBody { velocity: still, inv_mass: 0.0 };
///     let law = NormalLaw::new(Cohesion::new(2.0, 1e-3, attraction)?, 0.0)?;
///     let touch = ContactGeometry::plate(0.0505, &up, 0.05)?;
///     let mut contact = Contact::new(&touch, &law, &ball, &wall, 1e-3);
///     contact.update(&IndependentFriction::none(), &mut ball, &mut wall);
///     Ok(ball.velocity.z)
/// };
/// assert_eq!(speed(Attraction::Pull)?, -2.0 * 1e-3);
/// assert_eq!(speed(Attraction::Resistance)?, 0.0);
/// # Ok::<(), tribos_core::Error>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Attraction {
    /// A constant pull F_coh: it derives from the energy F_coh·gap, so a pair that is let go
    /// closes again. With `P = R + F_coh dt ≥ 0` the law is Signorini's for `P`.
    #[default]
    Pull,
    /// A resistance of at most F_coh against opening: a pair that is let go stays where it is.
    Resistance,
}

/// Cohesion of a contact. *Units*: force, length.
///
/// ```
/// use tribos_core::contact::{Attraction, Cohesion};
/// use tribos_core::law::LawError;
/// // Fine powder: 2 µN within 10 nm.
/// let sticky = Cohesion::new(2e-6_f64, 1e-8, Attraction::Pull)?;
/// assert!((sticky.energy() - 2e-14).abs() < 1e-29); // J to break a contact
/// assert_eq!([sticky.strength(), sticky.range()], [2e-6, 1e-8]);
/// assert_eq!(sticky.attraction(), Attraction::default());
/// let parameter = "cohesion strength";
/// let refused = Cohesion::new(-1.0, 0.0, Attraction::Pull);
/// assert_eq!(refused, Err(LawError::Negative { parameter, given: -1.0 }));
/// # Ok::<(), LawError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Cohesion<R> {
    strength: R,
    range: R,
    attraction: Attraction,
}

impl<R: Real> Cohesion<R> {
    /// No cohesion.
    pub const NONE: Self = Self {
        strength: R::ZERO,
        range: R::ZERO,
        attraction: Attraction::Pull,
    };

    /// Strength F_coh ≥ 0 within the range d_c ≥ 0.
    pub fn new(strength: R, range: R, attraction: Attraction) -> Result<Self, LawError> {
        Ok(Self {
            strength: crate::law::validated_not_negative("cohesion strength", strength)?,
            range: crate::law::validated_not_negative("cohesion range", range)?,
            attraction,
        })
    }

    /// F_coh
    pub fn strength(&self) -> R {
        self.strength
    }

    /// d_c
    pub fn range(&self) -> R {
        self.range
    }

    /// What it does within its range.
    pub fn attraction(&self) -> Attraction {
        self.attraction
    }

    /// E_c = F_coh d_c, the work that breaks a contact.
    pub fn energy(&self) -> R {
        self.strength * self.range
    }
}

/// The law along the normal.
///
/// ```
/// use nalgebra::Vector3;
/// use tribos_core::contact::*;
/// let law = NormalLaw::new(Cohesion::NONE, 0.5_f64)?;
/// assert_eq!(law.cohesion().strength(), 0.0);
/// // A ball hits a floor with 2 m/s, and leaves it with half of that.
/// let (still, down) = (Vector3::new(0.0, 0.0, 0.0), Vector3::new(0.0, 0.0, -2.0));
/// let mut ball = SphereBody { velocity: down, spin: still, inv_mass: 4.0, inv_inertia: 1000.0 };
/// let mut floor = WallBody { velocity: still, inv_mass: 0.0 };
/// let touch = ContactGeometry::plate(0.05, &Vector3::new(0.0, 0.0, 1.0), 0.05)?;
/// let mut contact = Contact::new(&touch, &law, &ball, &floor, 1e-3);
/// contact.update(&IndependentFriction::none(), &mut ball, &mut floor);
/// assert!((ball.velocity.z - law.restitution() * 2.0).abs() < 1e-15);
/// assert!(NormalLaw::new(Cohesion::NONE, 1.5).is_err()); // no ball gains energy
/// # Ok::<(), tribos_core::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct NormalLaw<R> {
    cohesion: Cohesion<R>,
    restitution: R,
}

impl<R: Real> NormalLaw<R> {
    /// Cohesion, and the coefficient of restitution in [0, 1].
    ///
    /// A [`Contact`](super::Contact) rebounds by Newton's law: with `restitution` times the speed at
    /// which it closes at the start of its step. For two spheres, or a sphere and a plate, friction
    /// does not meet it, and energy is lost or kept. Several contacts that rebound while they are
    /// swept together can gain energy (Kane's example); a [`Manifold`](crate::manifold::ContactSystem)
    /// therefore takes impacts one after the other.
    pub fn new(cohesion: Cohesion<R>, restitution: R) -> Result<Self, LawError> {
        Ok(Self {
            cohesion,
            restitution: crate::law::validated_fraction("restitution", restitution)?,
        })
    }

    /// Cohesion of the contact.
    pub fn cohesion(&self) -> &Cohesion<R> {
        &self.cohesion
    }

    /// Speed after an impact over speed before.
    pub fn restitution(&self) -> R {
        self.restitution
    }

    /// The law of a contact that lasts.
    pub(crate) fn without_restitution(&self) -> Self {
        Self {
            restitution: R::ZERO,
            ..*self
        }
    }

    /// The law of an impact: finite forces take no part in it.
    pub(crate) fn without_cohesion(&self) -> Self {
        Self {
            cohesion: Cohesion::NONE,
            ..*self
        }
    }
}

/// The normal law of one contact for one time step, in impulses.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct NormalStep<R> {
    /// F_coh dt, or 0 beyond the range.
    pub cohesion: R,
    /// max(gap, 0)/dt: the speed of approach that closes the gap in this step. Negative for a
    /// rebound: minus the speed at which the bodies part.
    pub allowance: R,
    /// True if a gap stays open without a pull.
    pub rests_open: bool,
}

impl<R: Real> NormalStep<R> {
    /// Prepares a step of length `dt` from gap and normal velocity at its start.
    pub fn new(law: &NormalLaw<R>, gap: R, velocity: R, dt: R) -> Self {
        let cohesion = &law.cohesion;
        // Time runs forwards or not at all.
        let dt = if dt > R::ZERO { dt } else { R::NAN };
        // An old overlap is not pushed out: that would create energy (Unger and Kertész 2003,
        // eq. 33).
        let open = if gap < R::ZERO { R::ZERO } else { gap };
        let closing = open / dt;
        let rebounds = law.restitution > R::ZERO && velocity + closing < R::ZERO;
        let resists = cohesion.attraction == Attraction::Resistance;
        Self {
            cohesion: if gap <= cohesion.range {
                cohesion.strength * dt
            } else {
                R::ZERO
            },
            allowance: if rebounds {
                law.restitution * velocity
            } else {
                closing
            },
            rests_open: resists && open > R::ZERO && !rebounds,
        }
    }

    /// The impulse that obeys the law; `trial` is the one that would stop the relative motion.
    ///
    /// NaN stays NaN.
    #[inline(always)]
    pub fn impulse(&self, trial: R, effective_mass: R) -> R {
        let closed = trial - effective_mass * self.allowance;
        let wanted = if self.rests_open && closed < R::ZERO {
            // Short of closing the gap, a resistance pulls as far as something pulls it open.
            if trial < R::ZERO { trial } else { R::ZERO }
        } else {
            closed
        };
        if wanted < -self.cohesion {
            -self.cohesion
        } else {
            wanted
        }
    }
}
