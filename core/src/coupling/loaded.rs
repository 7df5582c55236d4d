//! Friction of a round patch whose radius follows the load.
//!
//! With the growth g = d ln a/d ln N of the radius, the reduced force f and torque t at the sliding speed v and the rim
//! speed w = |ω| a,
//!
//! ```text
//! W = μ N [f, a t],     ∂W/∂N = μ [f + g w ∂f/∂w,  a ((1 + g) t + g w ∂t/∂w)]
//! ```
//!
//! g is a number also where da/dN is infinite, so that the slope by the load is one at the first touch.

use super::{ReducedFriction, RoundFriction};
use crate::error::Error;
use crate::law::{LawError, validated_coefficient};
use crate::patch::elastic::LoadedRadius;
use crate::real::Real;
use crate::twist::{Twist, Wrench};

/// Friction of a round patch whose radius follows the load: a coupling, a coefficient and a [`LoadedRadius`].
///
/// *Units*: those of [`RoundFriction`]. *Domain*: that of [`RoundFriction`] with the radius under the load. The friction is μ
/// times the load, also of one that pulls: its sign is the caller's.
///
/// ```
/// use tribos_core::coupling::{LoadedFriction, coulomb::CoulombHertz};
/// use tribos_core::patch::elastic::SoftFinger;
/// use tribos_core::twist::Twist;
/// let rubber = SoftFinger::new(3e-3_f64, 1.0 / 3.0)?; // m/N^(1/3)
/// let finger = LoadedFriction::new(CoulombHertz, 0.8, rubber)?; // mu
/// // Twisted in place it carries 3π/16 of μ N a, which grows with N^(4/3).
/// let twist = Twist::new(0.0, 0.0, 1.0);
/// let [one, eight] = [1.0, 8.0].map(|load| finger.wrench(load, &twist).torque);
/// assert!((eight / one - 16.0).abs() < 1e-13);
/// let slope = finger.slope_by_load(8.0, &twist).torque;
/// assert!((slope - 4.0 / 3.0 * eight / 8.0).abs() < 1e-17);
/// # Ok::<(), tribos_core::law::LawError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct LoadedFriction<R, C, A> {
    coupling: C,
    coefficient: R,
    area: A,
}

impl<R: Real, C: ReducedFriction<R>, A: LoadedRadius<R>> LoadedFriction<R, C, A> {
    /// *Domain*: 0 ≤ `coefficient` < ∞.
    pub fn new(coupling: C, coefficient: R, area: A) -> Result<Self, LawError> {
        Ok(Self {
            coupling,
            coefficient: validated_coefficient(coefficient)?,
            area,
        })
    }

    /// The patch under one load, for all that a [`RoundFriction`] has. *Errors*: without contact there is no radius.
    pub fn at(&self, load: R) -> Result<RoundFriction<R, &C>, Error> {
        RoundFriction::new(&self.coupling, self.coefficient, self.area.radius(load))
    }

    /// The radius and what it follows from.
    pub fn area(&self) -> &A {
        &self.area
    }

    /// The wrench on the patch, against its twist.
    ///
    /// *Accuracy*: 4 ulp more than coupling and radius. *Special values*: zero at rest and without contact.
    pub fn wrench(&self, load: R, twist: &Twist<R>) -> Wrench<R> {
        let (radius, speed) = (self.area.radius(load), twist.speed());
        let reduced = self
            .coupling
            .reduced_wrench(speed, twist.spin.abs() * radius);
        let strength = self.coefficient * load;
        against(
            twist,
            speed,
            [strength * reduced.force, strength * radius * reduced.torque],
        )
    }

    /// ∂wrench/∂load with the motion held.
    ///
    /// *Units*: none, and length. *Accuracy*: that of coupling, Jacobian and radius, and 8 ulp of the largest term.
    /// *Special values*: zero at rest; without load that of the first touch.
    ///
    /// ```
    /// use tribos_core::coupling::{LoadedFriction, coulomb::CoulombDisk};
    /// use tribos_core::patch::elastic::HertzSphere;
    /// use tribos_core::twist::Twist;
    /// let finger = LoadedFriction::new(CoulombDisk, 0.8, HertzSphere::new(1e6_f64, 0.01)?)?;
    /// let (twist, h) = (Twist::new(0.01, 0.0, 5.0), 1e-5); // m/s, rad/s; N
    /// let [less, more] = [2.0 - h, 2.0 + h].map(|load| finger.wrench(load, &twist));
    /// let slope = finger.slope_by_load(2.0, &twist);
    /// assert!(((more.torque - less.torque) / (2.0 * h) - slope.torque).abs() < 1e-12);
    /// # Ok::<(), tribos_core::law::LawError>(())
    /// ```
    pub fn slope_by_load(&self, load: R, twist: &Twist<R>) -> Wrench<R> {
        let (radius, growth) = (self.area.radius(load), self.area.growth(load));
        let speed = twist.speed();
        let rim = twist.spin.abs() * radius;
        let reduced = self.coupling.reduced_wrench(speed, rim);
        // What a rim that moves faster does; it does not where the patch does not turn.
        let [mut force, mut torque] = [R::ZERO; 2];
        if rim != R::ZERO && growth != R::ZERO {
            let rates = self.coupling.reduced_jacobian(speed, rim);
            force = growth * rim * rates.mixed;
            torque = growth * rim * rates.torque_rim;
        }
        let grown = (R::ONE + growth) * reduced.torque + torque;
        let mu = self.coefficient;
        against(
            twist,
            speed,
            [mu * (reduced.force + force), mu * radius * grown],
        )
    }
}

/// Magnitudes along the velocity and about the normal as a wrench against the motion.
fn against<R: Real>(twist: &Twist<R>, speed: R, [force, torque]: [R; 2]) -> Wrench<R> {
    let torque = -torque.copysign(twist.spin) * R::ONE.copysign(torque);
    if speed == R::ZERO {
        // Zero, unless the spin is not a number.
        let none = if force.is_nan() { force } else { R::ZERO };
        return Wrench::new(none, none, torque);
    }
    let [x, y] = [twist.velocity.x, twist.velocity.y].map(|part| force * (part / speed));
    Wrench::new(-x, -y, torque)
}
