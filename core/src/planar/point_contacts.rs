//! Dry friction of many points at once, as a set to project on.
//!
//! A wrench that the foot carries is a sum of forces fᵢ at the points rᵢ, each within its own disc
//! |fᵢ| ≤ μ Nᵢ. [`super::balance`] finds the sum nearest to a given wrench. The force of every point
//! is kept: as long as the next wrench is that sum nothing needs to be found.

use super::balance::{Balance, Remainder, norm};
use crate::error::Error;
use crate::law::{LawError, validated_not_negative};
use crate::patch::PatchError;
use crate::patch::nodes::NodePatch;
use crate::real::Real;
use crate::twist::Wrench;
use nalgebra::{Vector2, Vector3};

/// Contact points that share a load under Coulomb friction, with the friction force of each.
///
/// *Size*: two numbers a point beside the patch.
///
/// ```
/// use tribos_core::patch::nodes::{Node, Nodes};
/// use tribos_core::planar::PointContacts;
/// use tribos_core::twist::Wrench;
/// use nalgebra::Vector2;
///
/// let feet = Nodes::new([[-0.1, 0.0], [0.1, 0.0]].map(|[x, y]| Node { x, y, weight: 0.5_f64 }))?;
/// let mut table: PointContacts<f64, _, 2> = PointContacts::new(feet, 10.0)?; // μN = 10 N
/// let push = Wrench::new(0.0, 3.0, 0.2);
/// assert_eq!(table.nearest(&push, 0.1), push); // held
/// assert!(PointContacts::<f64, _, 1>::new(feet, 10.0).is_err()); // two points, room for one
/// # Ok::<(), tribos_core::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct PointContacts<R: Real, P, const CAPACITY: usize> {
    patch: P,
    force_limit: R,
    forces: heapless::Vec<Vector2<R>, CAPACITY>,
}

/// What kept forces may leave of a wrench that they carry, in rounding errors of it.
const KEPT_ULPS: f64 = 64.0;
/// Rounding of a force on the rim of its disc.
const COLLAR_ULPS: f64 = 8.0;
/// Passes over all points that spread a rest.
const PASSES: usize = 8;

impl<R: Real, P: NodePatch<R>, const CAPACITY: usize> PointContacts<R, P, CAPACITY> {
    /// *Domain*: 0 ≤ `force_limit` < ∞ (μN, in units of force); at most `CAPACITY` points.
    pub fn new(patch: P, force_limit: R) -> Result<Self, Error> {
        let mut forces = heapless::Vec::new();
        let zero = Vector2::new(R::ZERO, R::ZERO);
        if forces.resize(patch.nodes().len(), zero).is_err() {
            return Err(PatchError::Full { capacity: CAPACITY }.into());
        }
        let mut foot = Self {
            patch,
            force_limit: R::ZERO,
            forces,
        };
        foot.set_force_limit(force_limit)?;
        Ok(foot)
    }

    /// Another load on the same points. *Domain*: as in [`PointContacts::new`].
    ///
    /// ```
    /// use tribos_core::patch::nodes::{Node, Nodes};
    /// use tribos_core::planar::PointContacts;
    /// use tribos_core::twist::Wrench;
    /// use nalgebra::Vector2;
    /// let feet = Nodes::new([-0.1, 0.1].map(|x| Node { x, y: 0.0, weight: 0.5_f64 }))?; // m
    /// let mut table: PointContacts<f64, _, 2> = PointContacts::new(feet, 10.0)?; // N
    /// let push = Wrench::new(0.0, 3.0, 0.0);
    /// assert_eq!(table.nearest(&push, 0.1), push); // held
    /// table.set_force_limit(2.0)?; // someone lifts it a little
    /// table.release();
    /// let resisted = table.nearest(&push, 0.1);
    /// assert!((resisted.force.y - table.force_limit()).abs() < 1e-11);
    /// # Ok::<(), tribos_core::Error>(())
    /// ```
    pub fn set_force_limit(&mut self, force_limit: R) -> Result<(), LawError> {
        self.force_limit = validated_not_negative("force limit", force_limit)?;
        Ok(())
    }

    /// The largest force, μN.
    pub fn force_limit(&self) -> R {
        self.force_limit
    }

    /// The points.
    pub fn patch(&self) -> &P {
        &self.patch
    }

    /// Sets the stored forces of all points to zero.
    pub fn release(&mut self) {
        for force in &mut self.forces {
            *force = Vector2::new(R::ZERO, R::ZERO);
        }
    }

    /// The wrench of the foot's friction nearest to `wrench`, by √(|Δforce|² + (Δtorque/`length`)²).
    ///
    /// *Domain*: 0 < `length` < ∞. *Special values*: `wrench` itself, to the bit, where forces within their discs
    /// were found that carry it but for 64 rounding errors; NaN for NaN and infinities. Any other answer is
    /// the sum of forces within their discs, wherever the search ends. *Accuracy*: for the given points 1e-14 of
    /// the wrench or of the force limit, whichever is less, also where the foot turns about one of them or next to
    /// one; 1e-8 where a wrench that is carried is within 1e-7 of the limit. f32: 1e-6, and 1e-4 within 1e-5. Both
    /// precisions compute in f64.
    /// *Cost*: one pass over the points where the forces of the last call carry the wrench, else 20
    /// to 150 passes of four roots a point, up to 400 where it turns next to a point.
    pub fn nearest(&mut self, wrench: &Wrench<R>, length: R) -> Wrench<R> {
        let inv_length = R::ONE / length;
        let wanted = Vector3::new(wrench.force.x, wrench.force.y, wrench.torque * inv_length);
        let size = norm(&wanted);
        if !(size.is_finite() && inv_length > R::ZERO && inv_length.is_finite()) {
            return Wrench::new(R::NAN, R::NAN, R::NAN);
        }
        if self.stored_forces_balance(wrench, inv_length, size) {
            return *wrench;
        }
        let torque = wrench.torque.to_f64() / length.to_f64();
        let wanted = Vector3::new(wrench.force.x.to_f64(), wrench.force.y.to_f64(), torque);
        let scale = unit_of(norm(&wanted), self.force_limit.to_f64());
        let balance = Balance {
            nodes: self.patch.nodes(),
            inv_length: 1.0 / length.to_f64(),
            unit: self.force_limit.to_f64() * scale / self.patch.total_weight().to_f64(),
            wanted: wanted * scale,
        };
        let Remainder { motion, is_held } = balance.solve(norm(&balance.wanted));
        // What the points carry, each within its own disc: no difference of two large wrenches.
        let forces = &mut self.forces;
        let carried = balance.carried(&motion, |point, own| {
            if let Some(force) = forces.get_mut(point) {
                *force = own.map(|part| R::from_f64(part / scale)).into();
                // Squares of places over the length are out of range: no force is certain.
                if !force.x.hypot(force.y).is_finite() {
                    *force = Vector2::new(R::ZERO, R::ZERO);
                }
            }
        });
        if !is_held {
            return Wrench::new(
                R::from_f64(carried.x / scale),
                R::from_f64(carried.y / scale),
                R::from_f64(carried.z / scale * length.to_f64()),
            );
        }
        for _ in 0..=PASSES {
            if self.stored_forces_balance(wrench, inv_length, size) {
                return *wrench;
            }
            self.distribute_rounding(wrench, inv_length);
        }
        // No motion was found, and no forces either: what they carry is in the set.
        -self.left(&Wrench::ZERO)
    }

    /// μN/(sum of weights)
    fn unit(&self) -> R {
        self.force_limit / self.patch.total_weight()
    }

    /// True if the kept forces lie in their discs and add up to `wrench`.
    fn stored_forces_balance(&self, wrench: &Wrench<R>, inv_length: R, size: R) -> bool {
        let unit = self.unit() * (R::ONE + R::from_f64(COLLAR_ULPS) * R::EPSILON);
        let mut points = self.patch.nodes().iter().zip(&self.forces);
        let within = points.all(|(node, force)| force.x.hypot(force.y) <= unit * node.weight);
        let left = self.left(wrench);
        let left = Vector3::new(left.force.x, left.force.y, left.torque * inv_length);
        within && norm(&left) <= R::from_f64(KEPT_ULPS) * R::EPSILON * size
    }

    /// Spreads what rounding and σ leave of a carried wrench over points that can take it: each
    /// takes what it would stop by itself, with 1 + |r|²/length² for the mass in its way.
    fn distribute_rounding(&mut self, wrench: &Wrench<R>, inv_length: R) {
        let unit = self.unit();
        let arm = inv_length * inv_length;
        let mut left = self.left(wrench);
        for (node, force) in self.patch.nodes().iter().zip(&mut self.forces) {
            let turn = left.torque * arm;
            let slowness = R::ONE + (node.x * node.x + node.y * node.y) * arm;
            let wanted = Vector2::new(
                force.x + (left.force.x - turn * node.y) / slowness,
                force.y + (left.force.y + turn * node.x) / slowness,
            );
            if !wanted.x.hypot(wanted.y).is_finite() {
                continue;
            }
            let after = project_on_disc(&wanted, unit * node.weight);
            let change = after - *force;
            left.force -= change;
            left.torque -= node.x * change.y - node.y * change.x;
            *force = after;
        }
    }

    /// `wrench` without what the points carry.
    fn left(&self, wrench: &Wrench<R>) -> Wrench<R> {
        let mut left = *wrench;
        for (node, force) in self.patch.nodes().iter().zip(&self.forces) {
            left.force -= *force;
            left.torque -= node.x * force.y - node.y * force.x;
        }
        left
    }
}

/// The power of two that makes the larger of two sizes one of order 1: no digit is lost.
fn unit_of<R: Real>(wrench: R, limit: R) -> R {
    let larger = if wrench > limit { wrench } else { limit };
    let size = if larger > R::MIN_POSITIVE {
        larger
    } else {
        R::MIN_POSITIVE
    };
    R::power_of_two(-size.octaves_above(R::ONE))
}

/// The point of the disc |f| ≤ `bound` nearest to `wanted`.
fn project_on_disc<R: Real>(wanted: &Vector2<R>, bound: R) -> Vector2<R> {
    let size = wanted.x.hypot(wanted.y);
    if size <= bound {
        return *wanted;
    }
    let scale = bound / size;
    Vector2::new(wanted.x * scale, wanted.y * scale)
}
