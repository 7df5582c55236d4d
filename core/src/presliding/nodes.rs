//! Presliding of many points: each holds for itself, and they let go one after the other.

use super::pose::{Axes, Pose};
use crate::error::Error;
use crate::law::{LawError, validated_not_negative, validated_positive};
use crate::patch::PatchError;
use crate::patch::nodes::{Node, NodePatch};
use crate::real::Real;
use crate::twist::Wrench;
use nalgebra::Vector2;

/// Points that are bound to the floor one by one, each elastic up to its share of dry friction.
///
/// Point i at x_i = x + R(θ) r_i pulls with k_i (x_i − a_i), |force| ≤ μN w_i, and its anchor a_i
/// follows where that is too little. Under a torque the outer points slip first: the wrench bends off
/// gradually, as a sum of elastic, perfectly plastic elements does (Iwan, Masing), and closed cycles
/// leave loops of heat. The number of numbers is 2 a point; [`super::Presliding`] has 3 for the whole patch
/// and none of this micro-slip.
///
/// *Size*: two numbers a point beside the patch.
/// *Source*: W. D. Iwan, J. Appl. Mech. 33 (1966) 893; G. Masing, Proc. 2nd Int. Congr. Appl. Mech. (1926) 332.
///
/// ```
/// use tribos_core::patch::nodes::{Node, Nodes};
/// use tribos_core::presliding::{PointPresliding, Pose};
/// // Two feet, the nearer one at a tenth of the lever of the other.
/// let feet = Nodes::new([0.01, 0.1].map(|x| Node { x, y: 0.0, weight: 1.0_f64 }))?; // m
/// let (stiffness, limit, pose) = (1e4, 10.0, Pose::new(0.0, 0.0, 0.0)); // N/m, N
/// let mut bound: PointPresliding<f64, _, 2> = PointPresliding::new(feet, stiffness, limit, &pose)?;
/// assert_eq!(bound.reach(), 1e-3); // m: every point lets go there
/// // Turned by 0.02 rad the outer foot has gone 2 mm and slips, the inner one 0.2 mm and holds.
/// let turned = bound.step(&Pose::new(0.0, 0.0, 0.02));
/// assert_eq!(turned.slipping, 1);
/// assert!((turned.friction.torque + 0.5 + 0.01).abs() < 1e-4); // N m
/// # Ok::<(), tribos_core::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct PointPresliding<R: Real, P, const CAPACITY: usize> {
    patch: P,
    /// k_t
    stiffness: R,
    /// μN
    force_limit: R,
    anchors: heapless::Vec<Vector2<R>, CAPACITY>,
}

/// Presliding of many points at a new pose, in the axes of the floor.
///
/// ```
/// use tribos_core::patch::nodes::{Node, Nodes};
/// use tribos_core::presliding::{PointPresliding, PointPreslidingStep, Pose};
/// let foot = Nodes::new([Node { x: 0.0, y: 0.0, weight: 1.0_f64 }])?;
/// let (stiffness, limit, pose) = (1e4, 10.0, Pose::new(0.0, 0.0, 0.0)); // N/m, N
/// let mut bound: PointPresliding<f64, _, 1> = PointPresliding::new(foot, stiffness, limit, &pose)?;
/// let PointPreslidingStep { friction, dissipated, .. } = bound.step(&Pose::new(3e-3, 0.0, 0.0));
/// assert!((friction.force.x + 10.0).abs() < 1e-12);
/// assert!((dissipated - 10.0 * 2e-3).abs() < 1e-14); // J: 3 mm, of which 1 mm is elastic
/// # Ok::<(), tribos_core::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PointPreslidingStep<R: Real> {
    /// Friction on the patch, about its centre. *Units*: force, force × length.
    pub friction: Wrench<R>,
    /// Energy that became heat. *Units*: force × length. Not negative.
    pub dissipated: R,
    /// How many points slipped.
    pub slipping: usize,
}

impl<R: Real, P: NodePatch<R>, const CAPACITY: usize> PointPresliding<R, P, CAPACITY> {
    /// Bonds that are unstrained in `pose`, with the stiffness k_t in sliding and the largest force μN of all
    /// points together.
    ///
    /// *Units*: force/length; force. *Domain*: 0 < `stiffness` < ∞, 0 ≤ `force_limit` < ∞; at most `CAPACITY`
    /// points.
    pub fn new(patch: P, stiffness: R, force_limit: R, pose: &Pose<R>) -> Result<Self, Error> {
        let stiffness = validated_positive("stiffness", stiffness)?;
        let mut anchors = heapless::Vec::new();
        if anchors.resize(patch.nodes().len(), pose.position).is_err() {
            return Err(PatchError::Full { capacity: CAPACITY }.into());
        }
        let mut bound = Self {
            patch,
            stiffness,
            force_limit: R::ZERO,
            anchors,
        };
        bound.set_force_limit(force_limit)?;
        bound.anchor_at(pose);
        Ok(bound)
    }

    /// Another load, or age, on the same points: bonds that it cannot hold slip in the next step.
    ///
    /// *Domain*: 0 ≤ `force_limit` < ∞.
    pub fn set_force_limit(&mut self, force_limit: R) -> Result<(), LawError> {
        self.force_limit = validated_not_negative("force limit", force_limit)?;
        Ok(())
    }

    /// Takes all bonds off and binds the points anew, unstrained in `pose`.
    pub fn anchor_at(&mut self, pose: &Pose<R>) {
        let axes = Axes::at(pose.angle);
        for (node, anchor) in self.patch.nodes().iter().zip(&mut self.anchors) {
            *anchor = pose.position + axes.lever(node);
        }
    }

    /// The points.
    pub fn patch(&self) -> &P {
        &self.patch
    }

    /// Stiffness k_t of all bonds in sliding. *Units*: force/length.
    pub fn stiffness(&self) -> R {
        self.stiffness
    }

    /// The largest force μN of all bonds.
    pub fn force_limit(&self) -> R {
        self.force_limit
    }

    /// Displacement at which a bond slips, μN/k_t. *Units*: length.
    pub fn reach(&self) -> R {
        self.force_limit / self.stiffness
    }

    /// Energy that the bonds of a patch in `pose` store.
    ///
    /// *Units*: force × length.
    pub fn stored_energy(&self, pose: &Pose<R>) -> R {
        let axes = Axes::at(pose.angle);
        let mut sum = R::ZERO;
        for (node, anchor) in self.patch.nodes().iter().zip(&self.anchors) {
            let strain = pose.position + axes.lever(node) - *anchor;
            sum += node.weight * (strain.x * strain.x + strain.y * strain.y);
        }
        R::HALF * self.stiffness * sum / self.patch.total_weight()
    }

    /// Friction on the patch, which is now in `pose`; the anchors of points that slip follow.
    ///
    /// *Accuracy*: a few ε of the force limit, and k_t ε max(|x|, |a|) from the rounding of positions.
    /// *Cost*: a root a point, a sine and a cosine. *Special values*: NaN for NaN and infinities.
    pub fn step(&mut self, pose: &Pose<R>) -> PointPreslidingStep<R> {
        let axes = Axes::at(pose.angle);
        let unit = self.stiffness / self.patch.total_weight();
        let reach = self.reach();
        let mut step = PointPreslidingStep {
            friction: Wrench::ZERO,
            dissipated: R::ZERO,
            slipping: 0,
        };
        for (node, anchor) in self.patch.nodes().iter().zip(&mut self.anchors) {
            let lever = axes.lever(node);
            let place = pose.position + lever;
            let mut strain = place - *anchor;
            let stretched = strain.x.hypot(strain.y);
            let stiffness = unit * node.weight;
            // NaN slips, and stays.
            let holds = stretched <= reach;
            if !holds {
                strain *= reach / stretched;
                *anchor = place - strain;
                step.slipping = step.slipping.saturating_add(1);
                step.dissipated += stiffness * reach * (stretched - reach);
            }
            let pull = strain * stiffness;
            step.friction.force -= pull;
            step.friction.torque -= lever.x * pull.y - lever.y * pull.x;
        }
        step
    }
}

impl<R: Real> Axes<R> {
    /// The place of a point from the centre, in the axes of the floor.
    #[inline]
    fn lever(self, node: &Node<R>) -> Vector2<R> {
        self.to_floor(&Vector2::new(node.x, node.y))
    }
}
