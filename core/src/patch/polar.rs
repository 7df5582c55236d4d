//! Rings of nodes for pressures on a disk.

use super::gauss_jacobi::GaussJacobi;
use super::nodes::{Node, NodeList, NodeSink};
use super::{PatchError, validated_radius};
use crate::real::Real;

/// Rings × angles on a disk with pressure p ∝ (1 − r²/R²)^q · shape(x, y).
///
/// | q | pressure |
/// |---|---|
/// | 0 | uniform |
/// | 1/2 | Hertz: a ball on a plane |
/// | 1 | parabolic |
/// | −1/2 | a rigid flat punch on an elastic half space |
///
/// The radii are Gauss–Jacobi in r², the angles equidistant, every other ring turned by half a
/// step. Which error that leaves depends on where the instantaneous centre of rotation lies,
/// ε = v/(|ω|R) radii from the centre of the disk:
///
/// - *inside* (ε < 1) friction u |u|^(α−1) is singular there, and the error falls as h^(2+α) with
///   the distance h of the nodes, that is as (number of nodes)^(−1−α/2);
/// - *outside* it falls geometrically, the faster the farther the centre;
/// - for odd α ≥ 1 and enough nodes the rule is exact, wherever the centre.
///
/// *Accuracy*: error of force and torque, uniform pressure, unit load, radius and spin. Inside:
/// root mean square over 2000 centres; the largest error is two to three times that for α ≥ 0, and
/// without bound for α < 0, where a node next to the centre resists without bound. Outside: the
/// largest error.
///
/// | rings × angles | inside, α = −1/2 | α = 0 | α = 1/2 | α = 3 | ε = 1.25, α = 0 | ε = 2, α = 0 |
/// |---|---|---|---|---|---|---|
/// | 8 × 16 | 2.8e-2 | 3.7e-3 | 4.2e-4 | 3e-15 | 6e-5 | 4e-8 |
/// | 16 × 32 | 9.4e-3 | 9.4e-4 | 7.5e-5 | 3e-15 | 5e-7 | 1e-13 |
/// | 32 × 64 | 3.3e-3 | 2.3e-4 | 1.3e-5 | 3e-15 | 3e-10 | 1e-14 |
/// | order in h | 1.5 | 2.0 | 2.5 | exact | | |
///
/// ```
/// use tribos_core::patch::nodes::{NodeList, NodePatch};
/// use tribos_core::patch::polar::PolarQuadrature;
/// let rule = PolarQuadrature::new(0.04_f64, 8, 16)?.with_rim_exponent(0.5)?; // Hertz; radius in m
/// let ball: NodeList<f64, 128> = rule.nodes_tilted(0.2, 0.0)?;
/// // A tilt lx moves the load by lx R/(2q + 4).
/// let moment: f64 = ball.nodes().iter().map(|node| node.weight * node.x).sum();
/// assert!((moment / ball.total_weight() - 0.2 * 0.04 / 5.0).abs() < 1e-16);
/// # Ok::<(), tribos_core::patch::PatchError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct PolarQuadrature<R> {
    radius: R,
    rings: u32,
    angles: u32,
    rim_exponent: f64,
}

impl<R: Real> PolarQuadrature<R> {
    /// Most rings, and most angles on a ring.
    pub const MAX_ORDER: u32 = 1024;
    /// Largest exponent q: beyond it the disk is all rim and a smaller disk is meant.
    pub const MAX_RIM_EXPONENT: f64 = 64.0;
    /// Nodes of the [`PolarQuadrature::standard`] rule.
    pub const STANDARD_NODES: usize = 16 * 32;

    /// A uniform pressure on a disk of radius `radius` around the origin.
    ///
    /// *Domain*: 0 < `radius` < ∞; `rings` and `angles` from 1 to [`PolarQuadrature::MAX_ORDER`].
    pub fn new(radius: R, rings: u32, angles: u32) -> Result<Self, PatchError> {
        let radius = validated_radius(radius)?;
        for given in [rings, angles] {
            if given == 0 || given > Self::MAX_ORDER {
                return Err(PatchError::RuleOrder { given });
            }
        }
        Ok(Self {
            radius,
            rings,
            angles,
            rim_exponent: 0.0,
        })
    }

    /// 16 rings × 32 angles of a uniform pressure.
    ///
    /// *Accuracy*: for Coulomb friction at most 5e-3 of load and load × radius for any twist
    /// (q = −1/2, 0, 1/2); if ε ≥ 1.5, at most 1e-7 of them times v^α (α = −1/2, 0, 1/2, 3 and
    /// q = −1/2, 1/2, 1).
    /// *Domain*: 0 < `radius` < ∞.
    ///
    /// ```
    /// use tribos_core::patch::nodes::{NodeList, NodePatch};
    /// use tribos_core::patch::polar::PolarQuadrature;
    /// const NODES: usize = PolarQuadrature::<f64>::STANDARD_NODES;
    /// let puck: NodeList<f64, NODES> = PolarQuadrature::standard(0.04)?.nodes()?; // radius in m
    /// let second = puck.nodes().iter().map(|n| n.weight * (n.x * n.x + n.y * n.y));
    /// let mean_square = second.sum::<f64>() / puck.total_weight();
    /// assert!((mean_square - 0.04 * 0.04 / 2.0).abs() < 1e-16); // that of a uniform disk
    /// # Ok::<(), tribos_core::patch::PatchError>(())
    /// ```
    pub fn standard(radius: R) -> Result<Self, PatchError> {
        Self::new(radius, 16, 32)
    }

    /// As many nodes for a pressure that goes as (1 − r²/R²)^q.
    ///
    /// *Domain*: −1 < `q` ≤ [`PolarQuadrature::MAX_RIM_EXPONENT`].
    pub fn with_rim_exponent(self, q: R) -> Result<Self, PatchError> {
        let rim_exponent = q.to_f64();
        if rim_exponent > -1.0 && rim_exponent <= Self::MAX_RIM_EXPONENT {
            Ok(Self {
                rim_exponent,
                ..self
            })
        } else {
            Err(PatchError::RimExponent {
                given: rim_exponent,
            })
        }
    }

    /// The nodes of the axisymmetric pressure.
    pub fn nodes<const CAPACITY: usize>(&self) -> Result<NodeList<R, CAPACITY>, PatchError> {
        self.nodes_shaped(|_, _| R::ONE)
    }

    /// The nodes of the pressure times 1 + `lx` x/R + `ly` y/R: the contact of a body that brakes.
    ///
    /// *Domain*: lx² + ly² ≤ 1, else the pressure is negative somewhere; refused where a node lies
    /// there.
    pub fn nodes_tilted<const CAPACITY: usize>(
        &self,
        lx: R,
        ly: R,
    ) -> Result<NodeList<R, CAPACITY>, PatchError> {
        self.nodes_shaped(|x, y| R::ONE + (lx * x + ly * y) / self.radius)
    }

    /// The nodes of the pressure times `shape(x, y)`, with x and y in units of length.
    ///
    /// With q = 0 the shape is the pressure itself; a singularity at the rim belongs into q.
    /// *Domain*: `shape` ≥ 0 and finite at all nodes; rings × angles ≤ `CAPACITY`.
    ///
    /// ```
    /// use tribos_core::patch::nodes::{NodeList, NodePatch};
    /// use tribos_core::patch::polar::PolarQuadrature;
    /// // A foot worn hollow along x: the pressure goes as y^2.
    /// let foot: NodeList<f64, 128> = PolarQuadrature::new(0.04, 8, 16)?.nodes_shaped(|_, y| y * y)?;
    /// let second: f64 = foot.nodes().iter().map(|n| n.weight * n.y * n.y).sum();
    /// // The mean of y^2 is that of y^4 over that of y^2 of the uniform disk, R^2/2.
    /// assert!((second / foot.total_weight() - 0.04 * 0.04 / 2.0).abs() < 1e-16);
    /// # Ok::<(), tribos_core::patch::PatchError>(())
    /// ```
    pub fn nodes_shaped<const CAPACITY: usize>(
        &self,
        shape: impl Fn(R, R) -> R,
    ) -> Result<NodeList<R, CAPACITY>, PatchError> {
        let mut list = NodeList::new();
        self.nodes_into(&mut list, shape)?;
        Ok(list)
    }

    /// [`PolarQuadrature::nodes_shaped`] into memory of the caller's choice, behind the nodes that are
    /// there already.
    ///
    /// *Special values*: what was added before an error stays.
    ///
    /// ```
    /// use tribos_core::patch::PatchError;
    /// use tribos_core::patch::nodes::{Node, NodeBuffer, NodePatch};
    /// use tribos_core::patch::polar::PolarQuadrature;
    /// let mut memory = [Node::default(); 30];
    /// let mut feet = NodeBuffer::new(&mut memory);
    /// let pad = PolarQuadrature::new(0.01_f64, 3, 8)?; // 24 nodes
    /// pad.nodes_into(&mut feet, |_, _| 1.0)?;
    /// assert_eq!(feet.nodes().len(), 24);
    /// let second = pad.nodes_into(&mut feet, |_, _| 1.0);
    /// assert_eq!(second, Err(PatchError::Full { capacity: 30 }));
    /// assert_eq!(feet.nodes().len(), 30);
    /// # Ok::<(), PatchError>(())
    /// ```
    pub fn nodes_into(
        &self,
        list: &mut impl NodeSink<R>,
        shape: impl Fn(R, R) -> R,
    ) -> Result<(), PatchError> {
        let rule = GaussJacobi::new(self.rings, self.rim_exponent);
        for (ring, node) in rule.nodes().enumerate() {
            let radius = self.radius * R::from_f64(Real::sqrt(node.s));
            let weight = R::from_f64(node.weight);
            let start = if ring % 2 == 0 { 0.0 } else { 0.5 };
            push_ring(list, self.angles, start, radius, weight, &shape)?;
        }
        if list.total_weight() > R::ZERO {
            Ok(())
        } else {
            Err(PatchError::Unloaded)
        }
    }
}

impl<R: Real, const CAPACITY: usize> NodeList<R, CAPACITY> {
    /// `angles` equidistant nodes on a circle: the limit q → −1, all load at the rim.
    ///
    /// *Domain*: 0 < `radius` < ∞; 1 ≤ `angles` ≤ `CAPACITY`.
    ///
    /// ```
    /// use tribos_core::patch::nodes::{NodeList, NodePatch};
    /// let cup: NodeList<f64, 32> = NodeList::ring(0.03, 32)?; // m
    /// assert!(cup.nodes().iter().all(|node| (node.x.hypot(node.y) - 0.03).abs() < 1e-16));
    /// assert_eq!(cup.total_weight(), 32.0);
    /// # Ok::<(), tribos_core::patch::PatchError>(())
    /// ```
    pub fn ring(radius: R, angles: u32) -> Result<Self, PatchError> {
        PolarQuadrature::new(radius, 1, angles)?;
        let mut list = Self::new();
        push_ring(&mut list, angles, 0.0, radius, R::ONE, &|_, _| R::ONE)?;
        Ok(list)
    }
}

/// One ring; `start` in steps of the angle.
fn push_ring<R: Real>(
    list: &mut impl NodeSink<R>,
    angles: u32,
    start: f64,
    radius: R,
    weight: R,
    shape: &impl Fn(R, R) -> R,
) -> Result<(), PatchError> {
    let step = core::f64::consts::TAU / f64::from(angles);
    for n in 0..angles {
        let angle = (f64::from(n) + start) * step;
        let x = radius * R::from_f64(Real::cos(angle));
        let y = radius * R::from_f64(Real::sin(angle));
        let weight = weight * shape(x, y);
        list.push(Node { x, y, weight })?;
    }
    Ok(())
}
