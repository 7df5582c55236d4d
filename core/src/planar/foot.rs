//! Dry friction of many points at once, as a set to project on.
//!
//! A wrench that the foot carries is a sum of forces fᵢ at the points rᵢ, each within its own disc
//! |fᵢ| ≤ μ Nᵢ. The nearest such sum to a wrench q, by the distance with `length` ρ, is found one
//! point after the other: with the remainder e = q − Σ (fᵢ, rᵢ × fᵢ) the point would move with
//! uᵢ = e_force + (e_torque/ρ²) × rᵢ, and its force becomes the point of its disc nearest to
//! fᵢ + uᵢ/(1 + |rᵢ|²/ρ²). Each such step lessens the distance (a proximal step with the largest
//! eigenvalue of the point's own block), and where none moves all points are in balance.

use crate::patch::nodes::NodePatch;
use crate::real::Real;
use crate::twist::Wrench;
use nalgebra::Vector2;

/// A foot: points that share a load under Coulomb friction, with the force that each carries.
///
/// *Size*: two numbers a point beside the patch.
///
/// ```
/// use tribos_core::patch::nodes::{Node, Nodes};
/// use tribos_core::planar::Foot;
/// use tribos_core::twist::Wrench;
/// use nalgebra::Vector2;
///
/// let feet = Nodes::new([[-0.1, 0.0], [0.1, 0.0]].map(|[x, y]| Node { x, y, weight: 0.5_f64 }))?;
/// let mut table: Foot<f64, _, 2> = Foot::new(feet, 10.0)?; // μN = 10 N
/// let push = Wrench { force: Vector2::new(0.0, 3.0), torque: 0.2 };
/// assert_eq!(table.nearest(&push, 0.1), push); // held
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Foot<R: Real, P, const CAPACITY: usize> {
    patch: P,
    force_limit: R,
    forces: heapless::Vec<Vector2<R>, CAPACITY>,
}

/// Why a foot was refused.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum FootError {
    /// The force limit μN is negative, infinite or NaN.
    ForceLimit {
        /// What was given.
        given: f64,
    },
    /// The patch has more points than the foot has room for.
    Full {
        /// How many points there is room for.
        capacity: usize,
    },
}

/// Sweeps over all points at most.
const MOST_SWEEPS: usize = 200;
/// A sweep that corrects less than this many rounding errors of the wrench is the last.
const SETTLED_ULPS: f64 = 4.0;
/// What is left of a wrench that the foot carries, in rounding errors of it.
const HELD_ULPS: f64 = 64.0;

impl<R: Real, P: NodePatch<R>, const CAPACITY: usize> Foot<R, P, CAPACITY> {
    /// *Domain*: 0 ≤ `force_limit` < ∞ (μN, in units of force); at most `CAPACITY` points.
    pub fn new(patch: P, force_limit: R) -> Result<Self, FootError> {
        let mut forces = heapless::Vec::new();
        let zero = Vector2::new(R::ZERO, R::ZERO);
        if forces.resize(patch.nodes().len(), zero).is_err() {
            return Err(FootError::Full { capacity: CAPACITY });
        }
        let mut foot = Self {
            patch,
            force_limit: R::ZERO,
            forces,
        };
        foot.set_force_limit(force_limit)?;
        Ok(foot)
    }

    /// Another load on the same points. *Domain*: as in [`Foot::new`].
    pub fn set_force_limit(&mut self, force_limit: R) -> Result<(), FootError> {
        if force_limit >= R::ZERO && force_limit.is_finite() {
            self.force_limit = force_limit;
            Ok(())
        } else {
            let given = force_limit.to_f64();
            Err(FootError::ForceLimit { given })
        }
    }

    /// The largest force, μN.
    pub fn force_limit(&self) -> R {
        self.force_limit
    }

    /// The points.
    pub fn patch(&self) -> &P {
        &self.patch
    }

    /// Forgets the forces of all points.
    pub fn release(&mut self) {
        for force in &mut self.forces {
            *force = Vector2::new(R::ZERO, R::ZERO);
        }
    }

    /// The wrench of the foot's friction nearest to `wrench`, by √(|Δforce|² + (Δtorque/`length`)²).
    ///
    /// *Domain*: 0 < `length` < ∞. *Special values*: `wrench` itself, to the bit, where the foot
    /// carries it; NaN for NaN and infinities. *Accuracy*: 64 rounding errors of the wrench decide
    /// whether it is carried; else to where a sweep corrects less than 4 of them, or 200 sweeps.
    /// *Cost*: a root a point and sweep; few sweeps where the forces of the last call serve.
    pub fn nearest(&mut self, wrench: &Wrench<R>, length: R) -> Wrench<R> {
        let arm = R::ONE / (length * length);
        let size = norm(wrench, length);
        if !(size.is_finite() && arm.is_finite()) {
            return Wrench {
                force: Vector2::new(R::NAN, R::NAN),
                torque: R::NAN,
            };
        }
        let settled = R::from_f64(SETTLED_ULPS) * R::EPSILON * size;
        for _ in 0..MOST_SWEEPS {
            // Read anew each time, so that rounding does not gather.
            let mut left = self.left(wrench);
            if norm(&left, length) <= R::from_f64(HELD_ULPS) * R::EPSILON * size {
                return *wrench;
            }
            if self.sweep(&mut left, arm) <= settled {
                break;
            }
        }
        let left = self.left(wrench);
        Wrench {
            force: wrench.force - left.force,
            torque: wrench.torque - left.torque,
        }
    }

    /// One correction of every point; returns the largest.
    fn sweep(&mut self, left: &mut Wrench<R>, arm: R) -> R {
        let unit = self.force_limit / self.patch.total_weight();
        let mut largest = R::ZERO;
        for (node, force) in self.patch.nodes().iter().zip(&mut self.forces) {
            let turn = left.torque * arm;
            let slowness = R::ONE + (node.x * node.x + node.y * node.y) * arm;
            let wanted = Vector2::new(
                force.x + (left.force.x - turn * node.y) / slowness,
                force.y + (left.force.y + turn * node.x) / slowness,
            );
            let after = within(&wanted, unit * node.weight);
            let change = after - *force;
            left.force -= change;
            left.torque -= node.x * change.y - node.y * change.x;
            *force = after;
            let size = change.x.hypot(change.y);
            largest = if size > largest { size } else { largest };
        }
        largest
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

/// √(|force|² + (torque/length)²)
fn norm<R: Real>(wrench: &Wrench<R>, length: R) -> R {
    let force = wrench.force.x.hypot(wrench.force.y);
    force.hypot(wrench.torque / length)
}

/// The point of the disc |f| ≤ `bound` nearest to `wanted`.
fn within<R: Real>(wanted: &Vector2<R>, bound: R) -> Vector2<R> {
    let size = wanted.x.hypot(wanted.y);
    if size <= bound {
        return *wanted;
    }
    let scale = bound / size;
    Vector2::new(wanted.x * scale, wanted.y * scale)
}

impl core::fmt::Display for FootError {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        match self {
            Self::ForceLimit { given } => write!(
                f,
                "the force limit must be finite and not negative, not {given}"
            ),
            Self::Full { capacity } => write!(f, "there is room for {capacity} points, not more"),
        }
    }
}

impl core::error::Error for FootError {}
