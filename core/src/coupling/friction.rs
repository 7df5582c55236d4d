//! A round contact with its dimensions: radius, coefficient, load.

use super::batch;
use super::extended_range::is_in_normal_range;
use super::{ReducedFriction, ReducedWrench};
use crate::error::Error;
use crate::law::validated_coefficient;
use crate::patch::validated_radius;
use crate::real::Real;
use crate::twist::{Twist, Wrench, WrenchJacobian};
use nalgebra::Matrix3;

/// Friction of a round patch: a coupling (pressure, law and accuracy tier), a coefficient and a
/// radius.
///
/// *Units*: any consistent set. With N the load, γ the coefficient and R the radius,
/// force = γ N F(v, ωR) and torque = γ N R T(v, ωR).
///
/// *Domain*: γ N, γ N R, ωR and the reduced F and T (for the Jacobian γ N R² and the slopes) are
/// each zero or a normal number. Beyond, a product that overflows is infinite, one that underflows
/// zero or short of digits, and zero times infinity NaN, even where the whole would be a number.
///
/// ```
/// use tribos_core::coupling::{RoundFriction, coulomb::CoulombDisk};
/// use tribos_core::twist::Twist;
///
/// let puck = RoundFriction::new(CoulombDisk, 0.3_f32, 0.04)?;
/// let wrench = puck.wrench(1.7, &Twist::new(1.0, 0.0, 20.0)); // N, m/s, rad/s
/// assert!(wrench.force.x < 0.0 && wrench.torque < 0.0);
/// # Ok::<(), tribos_core::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct RoundFriction<R, C> {
    coupling: C,
    coefficient: R,
    radius: R,
}

/// Force and torque that oppose the motion, as magnitudes.
///
/// ```
/// use tribos_core::coupling::{Magnitudes, RoundFriction, coulomb::CoulombDisk};
/// let puck = RoundFriction::new(CoulombDisk, 0.3_f64, 0.04)?; // mu, m
/// // Under 1.7 N, spinning in place at 20 rad/s: 2/3 of μ N R.
/// let Magnitudes { force, torque } = puck.magnitudes(1.7, 0.0, 20.0); // N, N m
/// let most = puck.coefficient() * 1.7 * puck.radius();
/// assert!(force == 0.0 && (torque - most * 2.0 / 3.0).abs() < 1e-16);
/// # Ok::<(), tribos_core::Error>(())
/// ```
#[doc(hidden)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Magnitudes<R> {
    /// Friction force.
    pub force: R,
    /// Friction torque.
    pub torque: R,
}

/// Derivatives of [`Magnitudes`] with respect to sliding speed and spin.
#[doc(hidden)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct MagnitudesJacobian<R> {
    /// ∂force/∂speed
    pub force_speed: R,
    /// ∂force/∂spin
    pub force_spin: R,
    /// ∂torque/∂speed, equal to ∂force/∂spin
    pub torque_speed: R,
    /// ∂torque/∂spin
    pub torque_spin: R,
}

/// `force` along the velocity, whose length is `speed`, where their quotient leaves the range.
#[cold]
fn along<R: Real>(force: R, speed: R, twist: &Twist<R>) -> [R; 2] {
    [twist.velocity.x, twist.velocity.y].map(|u| force * (u / speed))
}

impl<R: Real, C: ReducedFriction<R>> RoundFriction<R, C> {
    /// *Domain*: 0 ≤ `coefficient` < ∞, 0 < `radius` < ∞. The coefficient multiplies the
    /// coupling's own (1 for the power-law tiers).
    pub fn new(coupling: C, coefficient: R, radius: R) -> Result<Self, Error> {
        Ok(Self {
            coupling,
            coefficient: validated_coefficient(coefficient)?,
            radius: validated_radius(radius)?,
        })
    }

    /// Force and torque magnitudes at sliding speed and spin; signs of both are ignored.
    ///
    /// *Domain*: any; zero at rest, see [`ReducedFriction`] for infinite and NaN arguments. `load` is
    /// taken as it is, so that a negative load (a contact that pulls) is the caller's to exclude.
    #[doc(hidden)]
    #[inline]
    pub fn magnitudes(&self, load: R, speed: R, spin: R) -> Magnitudes<R> {
        let ReducedWrench { force, torque } =
            self.coupling.reduced_wrench(speed, spin * self.radius);
        let strength = self.coefficient * load;
        Magnitudes {
            force: strength * force,
            torque: strength * self.radius * torque,
        }
    }

    /// Derivatives of [`RoundFriction::magnitudes`] for speed ≥ 0 and spin ≥ 0.
    #[doc(hidden)]
    #[inline]
    pub fn magnitudes_jacobian(&self, load: R, speed: R, spin: R) -> MagnitudesJacobian<R> {
        let j = self.coupling.reduced_jacobian(speed, spin * self.radius);
        let strength = self.coefficient * load;
        let mixed = strength * self.radius * j.mixed;
        MagnitudesJacobian {
            force_speed: strength * j.force_slide,
            force_spin: mixed,
            torque_speed: mixed,
            torque_spin: strength * self.radius * self.radius * j.torque_rim,
        }
    }

    /// The wrench on the patch, against its twist.
    ///
    /// *Accuracy*: 3 ulp more than that of the coupling at speeds right to 2 ulp. *Cost*: for speeds from 1e-140 to 1e140
    /// (f32: 1e-15 to 1e15) that of the coupling from v² and w, without another root or division.
    #[inline]
    pub fn wrench(&self, load: R, twist: &Twist<R>) -> Wrench<R> {
        let [x, y] = [twist.velocity.x, twist.velocity.y];
        let rim = (twist.spin * self.radius).abs();
        let square = x * x + y * y;
        let (least, most) = (R::LEAST_SPEED, R::ONE / R::LEAST_SPEED);
        let moves = square > least * least && square < most * most;
        if moves && (rim == R::ZERO || rim > least && rim < most) {
            let strength = self.coefficient * load;
            let [drag, torque] = self.coupling.reduced_drag(square, rim);
            let drag = strength * drag;
            if is_in_normal_range(drag) {
                let torque = strength * self.radius * torque;
                return Wrench::new(-(drag * x), -(drag * y), -torque.copysign(twist.spin));
            }
        }
        self.wide_wrench(load, twist)
    }

    /// [`RoundFriction::wrench`] without sliding, at rest and where a product may leave the number
    /// range.
    #[cold]
    #[inline(never)]
    fn wide_wrench(&self, load: R, twist: &Twist<R>) -> Wrench<R> {
        let speed = twist.speed();
        let Magnitudes { force, torque } = self.magnitudes(load, speed, twist.spin);
        if speed == R::ZERO {
            // Zero, unless the spin is not a number.
            let none = if force.is_nan() { force } else { R::ZERO };
            return Wrench::new(none, none, -torque.copysign(twist.spin));
        }
        let drag = force / speed;
        let [x, y] = if is_in_normal_range(drag) {
            [drag * twist.velocity.x, drag * twist.velocity.y]
        } else {
            along(force, speed, twist)
        };
        Wrench::new(-x, -y, -torque.copysign(twist.spin))
    }

    /// ∂wrench/∂twist, symmetric, and negative semidefinite for a law that never weakens.
    ///
    /// *Special values*: at rest the diagonal is that of [`ReducedFriction::reduced_jacobian`], negated.
    ///
    /// ```
    /// use nalgebra::Vector3;
    /// use tribos_core::coupling::{RoundFriction, coulomb::CoulombDisk};
    /// use tribos_core::twist::Twist;
    /// let puck = RoundFriction::new(CoulombDisk, 0.3_f64, 0.04)?;
    /// let jacobian = puck.wrench_jacobian(1.7, &Twist::new(1.0, -0.5, 20.0)); // N; m/s, rad/s
    /// assert_eq!(jacobian, jacobian.transpose());
    /// // Dry friction stays when the whole motion becomes faster.
    /// assert!((jacobian * Vector3::new(1.0, -0.5, 20.0)).amax() < 1e-12);
    /// # Ok::<(), tribos_core::Error>(())
    /// ```
    pub fn wrench_jacobian(&self, load: R, twist: &Twist<R>) -> WrenchJacobian<R> {
        let speed = twist.speed();
        let j = self
            .coupling
            .reduced_jacobian(speed, twist.spin * self.radius);
        let strength = self.coefficient * load;
        let (cos, sin) = if speed == R::ZERO {
            (R::ONE, R::ZERO)
        } else {
            (twist.velocity.x / speed, twist.velocity.y / speed)
        };
        // Along the velocity ∂F/∂v resists, across it the drag F/v; alike at rest.
        let (along, across) = (strength * j.force_slide, strength * j.force_per_slide);
        let (xx, xy, yy) = if along == across {
            (along, R::ZERO, along)
        } else {
            let (cc, ss) = (cos * cos, sin * sin);
            (
                along * cc + across * ss,
                (along - across) * cos * sin,
                along * ss + across * cc,
            )
        };
        let mixed = strength * self.radius * j.mixed * R::ONE.copysign(twist.spin);
        let (xn, yn) = (mixed * cos, mixed * sin);
        let nn = strength * self.radius * self.radius * j.torque_rim;
        Matrix3::new(-xx, -xy, -xn, -xy, -yy, -yn, -xn, -yn, -nn)
    }

    /// Wrenches of many twists under one load, to the bits of single calls. Elements beyond the
    /// shorter slice are not changed.
    ///
    /// *Cost*: tables take about half the time of single calls where the processor has vectors: they
    /// compute eight twists side by side.
    ///
    /// ```
    /// use tribos_core::coupling::{RoundFriction, coulomb::CoulombDisk};
    /// use tribos_core::twist::{Twist, Wrench};
    /// let puck = RoundFriction::new(CoulombDisk, 0.3_f64, 0.04)?;
    /// let twists = [1.0, -1.0].map(|sign| Twist::new(sign * 0.2, 0.0, sign * 5.0)); // m/s, rad/s
    /// let mut wrenches = [Wrench::ZERO; 2];
    /// puck.wrench_batch(1.7, &twists, &mut wrenches);
    /// assert_eq!(wrenches[0].force, -wrenches[1].force); // a motion and its reverse
    /// assert_eq!(wrenches[0].torque, -wrenches[1].torque);
    /// # Ok::<(), tribos_core::Error>(())
    /// ```
    #[inline]
    pub fn wrench_batch(&self, load: R, twists: &[Twist<R>], wrenches: &mut [Wrench<R>]) {
        let sizes = [self.coefficient * load, self.radius];
        let all = |twists: [&_; 3]| batch::patch_wrenches(&self.coupling, sizes, twists);
        batch::twist_wrenches(twists, wrenches, all, |twist| self.wrench(load, twist));
    }

    /// [`RoundFriction::wrench_batch`] for a structure of arrays: velocities along x and y and spins of the
    /// twists, forces along x and y and torques of the wrenches, to the same bits. Elements beyond the
    /// shortest slice are not changed.
    ///
    /// ```
    /// use tribos_core::coupling::{RoundFriction, coulomb::CoulombDisk};
    /// use tribos_core::twist::Twist;
    /// let puck = RoundFriction::new(CoulombDisk, 0.3_f64, 0.04)?;
    /// let (vx, vy, spins) = ([0.2, -0.1], [0.0, 0.3], [5.0, -2.0]); // m/s, m/s, rad/s
    /// let ([mut fx, mut fy], mut torques) = ([[0.0; 2]; 2], [0.0; 2]);
    /// puck.wrench_columns(1.7, [&vx, &vy, &spins], [&mut fx, &mut fy, &mut torques]);
    /// let second = puck.wrench(1.7, &Twist::new(vx[1], vy[1], spins[1]));
    /// assert_eq!([fx[1], fy[1], torques[1]], [second.force.x, second.force.y, second.torque]);
    /// # Ok::<(), tribos_core::Error>(())
    /// ```
    #[inline]
    pub fn wrench_columns(&self, load: R, twists: [&[R]; 3], wrenches: [&mut [R]; 3]) {
        let sizes = [self.coefficient * load, self.radius];
        let all = |twists: [&_; 3]| batch::patch_wrenches(&self.coupling, sizes, twists);
        batch::component_wrenches(twists, wrenches, all, |twist| self.wrench(load, twist));
    }

    /// Jacobians of many twists under one load, to the bits of single calls. Elements beyond the
    /// shorter slice are not changed.
    ///
    /// ```
    /// use tribos_core::coupling::{RoundFriction, coulomb::CoulombDisk};
    /// use tribos_core::twist::{Twist, WrenchJacobian};
    /// let puck = RoundFriction::new(CoulombDisk, 0.3_f64, 0.04)?;
    /// let twists = [1.0, 2.0].map(|scale| Twist::new(scale * 0.2, 0.0, scale * 5.0)); // m/s, rad/s
    /// let mut jacobians = [WrenchJacobian::zeros(); 2];
    /// puck.jacobian_batch(1.7, &twists, &mut jacobians);
    /// assert_eq!(jacobians[1] * 2.0, jacobians[0]); // dry friction forgets the speed
    /// # Ok::<(), tribos_core::Error>(())
    /// ```
    #[inline]
    pub fn jacobian_batch(
        &self,
        load: R,
        twists: &[Twist<R>],
        jacobians: &mut [WrenchJacobian<R>],
    ) {
        let sizes = [self.coefficient * load, self.radius];
        let all = |twists: &_| batch::patch_jacobians(&self.coupling, sizes, twists);
        let one = |twist: &_| self.wrench_jacobian(load, twist);
        batch::each(twists, jacobians, all, one);
    }

    /// The coupling.
    pub fn coupling(&self) -> &C {
        &self.coupling
    }

    /// The radius of the patch.
    pub fn radius(&self) -> R {
        self.radius
    }

    /// The coefficient γ (μ for Coulomb).
    pub fn coefficient(&self) -> R {
        self.coefficient
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::coupling::coulomb::CoulombDisk;
    use crate::coupling::round::RoundTable64;
    use crate::coupling::table::{DiskTable32, DiskTable64};
    use crate::patch::PowerPressure;

    /// Speeds of all sizes, also zero, and a few that are no numbers.
    fn numbers<R: Real>(count: u64, infinite: bool) -> impl Iterator<Item = [R; 3]> {
        let mut state = 7_u64;
        let mut next = move || {
            state = state
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1_442_695_040_888_963_407);
            let unit = (state >> 11) as f64 / (1_u64 << 53) as f64;
            let (kind, sign) = ((state >> 3) % 41, if state & 4 == 0 { 1.0 } else { -1.0 });
            let size = match kind {
                0 => 0.0,
                1 if infinite => f64::INFINITY,
                2 if infinite => f64::NAN,
                3 => libm::pow(10.0, 500.0 * unit - 250.0),
                4 => 1.0,
                5..=9 => libm::pow(10.0, 40.0 * unit - 20.0),
                _ => libm::pow(10.0, 6.0 * unit - 3.0),
            };
            R::from_f64(sign * size)
        };
        (0..count).map(move |_| [next(), next(), next()])
    }

    /// Largest error in units of [`Real::EPSILON`] against the careful way.
    fn compare<R: Real, C: ReducedFriction<R>>(coupling: C, most: f64) {
        let patch = RoundFriction::new(coupling, R::from_f64(0.3), R::from_f64(0.08)).unwrap();
        let load = R::from_f64(1.7);
        let normal = |x: R| x.is_finite() && x.abs() > R::MIN_POSITIVE / R::EPSILON;
        for [x, y, spin] in numbers(100_000, true) {
            let twist = Twist::new(x, y, spin);
            let [quick, careful] = [patch.wrench(load, &twist), patch.wide_wrench(load, &twist)];
            for (a, b) in [
                (quick.force.x, careful.force.x),
                (quick.force.y, careful.force.y),
                (quick.torque, careful.torque),
            ] {
                let apart = ((a - b) / b).to_f64().abs() / R::EPSILON.to_f64();
                let same = a == b || a.is_nan() && b.is_nan();
                let near = apart <= most || !normal(b) && !normal(a);
                assert!(same || near, "{x:?} {y:?} {spin:?}: {a:?} {b:?} {apart}");
            }
        }
    }

    #[test]
    fn one_root_and_one_division_are_as_good_as_many() {
        compare::<f64, _>(CoulombDisk, 8.0);
        compare::<f32, _>(CoulombDisk, 8.0);
        for alpha in [0.0, 0.37, 1.0, 3.0] {
            compare(DiskTable64::new(alpha).unwrap(), 10.0);
            compare(DiskTable32::new(alpha as f32).unwrap(), 10.0);
        }
        // Near equal speeds a torque that is small grows by many digits of theirs.
        compare(DiskTable64::new(-0.7).unwrap(), 20.0);
        compare(DiskTable64::new(-0.9).unwrap(), 60.0);
        compare(RoundTable64::new(0.37, PowerPressure::HERTZ).unwrap(), 10.0);
    }

    /// Largest errors of the quick and the careful way in units of [`Real::EPSILON`], by f64.
    fn errors(alpha: f32) -> [f64; 2] {
        let single = RoundFriction::new(DiskTable32::new(alpha).unwrap(), 0.3_f32, 0.08).unwrap();
        let table = DiskTable64::new(f64::from(alpha)).unwrap();
        let double = RoundFriction::new(table, f64::from(0.3_f32), f64::from(0.08_f32)).unwrap();
        let mut worst = [0.0_f64; 2];
        for [x, y, spin] in numbers::<f32>(100_000, false) {
            let twist = Twist::new(x, y, spin);
            let wide = Twist::new(f64::from(x), f64::from(y), f64::from(spin));
            let exact = double.wrench(f64::from(1.7_f32), &wide);
            let ways = [single.wrench(1.7, &twist), single.wide_wrench(1.7, &twist)];
            for (worst, found) in worst.iter_mut().zip(ways) {
                for (a, b) in [
                    (found.force.x, exact.force.x),
                    (found.force.y, exact.force.y),
                    (found.torque, exact.torque),
                ] {
                    if b.abs() > 1e-30 && b.abs() < 1e30 {
                        let error = ((f64::from(a) - b) / b).abs() / f64::from(f32::EPSILON);
                        *worst = if error > *worst { error } else { *worst };
                    }
                }
            }
        }
        worst
    }

    #[test]
    fn the_quick_way_errs_like_the_careful_one() {
        for alpha in [-0.9, -0.7, 0.0, 0.37, 1.0, 3.0] {
            let [quick, careful] = errors(alpha);
            // Half a unit: the power over the speed is two roundings where it was one.
            assert!(quick <= careful + 0.5, "{alpha}: {quick} {careful}");
        }
    }
}
