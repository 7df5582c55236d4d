//! Bonds on a patch: wrench and stiffness at a displacement.

use super::BondLaw;
use crate::coupling::nodes::NodeFriction;
use crate::patch::nodes::NodePatch;
use crate::patch::{PatchError, validated_radius};
use crate::real::Real;
use crate::twist::{Twist, Wrench};
use nalgebra::Matrix3;

/// A law of bonds on a patch of nodes: disk, ring or any other round pressure ([`crate::patch::polar`]),
/// polygon ([`crate::patch::polygon`]), points.
///
/// A displacement is a [`Twist`] in units of length and angle. Where the bond that is strained most
/// decides, the patch must say how far it reaches: nodes of no weight mark its corners, and
/// [`Bonds::with_rim`] the radius of a round one.
///
/// *Units*: any consistent set; displacement and wrench refer to the origin of the nodes' coordinates.
/// *Accuracy*: a few ulp for the nodes; for a continuous pressure that of their rule, the better the smoother
/// the law: 16 × 32 nodes of a uniform disk have onsets to 1e-5, and of [`super::BrittleBond`] exact to rounding.
///
/// ```
/// use tribos_core::bond::{Bonds, ExponentialBond};
/// use tribos_core::patch::nodes::Nodes;
/// use tribos_core::twist::Twist;
/// let stool = Nodes::tripod([[0.0, 0.0], [0.3, 0.0], [0.0, 0.3]], [0.1, 0.1])?; // m
/// let bonds = Bonds::new(ExponentialBond::new(5e4_f64, 1e-5)?, stool)?; // 1/m, m
/// let pushed = bonds.wrench(60.0, &Twist::new(1e-6, 0.0, 0.0)); // N; m, m, rad
/// assert!((pushed.force.x + 60.0 * 0.05 * (-0.1_f64).exp()).abs() < 1e-12); // against the displacement
/// # Ok::<(), tribos_core::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Bonds<R, L, P> {
    friction: NodeFriction<L, P>,
    /// 0 if the nodes are all there is.
    rim: R,
}

impl<R: Real, L: BondLaw<R>, P: NodePatch<R>> Bonds<R, L, P> {
    /// Puts bonds of `law` under the nodes of `patch`.
    ///
    /// *Domain*: at least two places carry load; one place holds no torque.
    pub fn new(law: L, patch: P) -> Result<Self, PatchError> {
        let is_loaded = patch.total_weight() > R::ZERO;
        if !is_loaded {
            return Err(PatchError::Unloaded);
        }
        let bonds = Self {
            friction: NodeFriction::new(law, patch),
            rim: R::ZERO,
        };
        let mut loaded = bonds.patch().nodes().iter().filter(|n| n.weight > R::ZERO);
        let first = loaded.next();
        let are_apart = loaded.any(|n| first.is_some_and(|f| (f.x, f.y) != (n.x, n.y)));
        if are_apart {
            Ok(bonds)
        } else {
            Err(PatchError::OnePlace)
        }
    }

    /// The same for a patch that reaches to `radius` around the origin in all directions.
    ///
    /// *Domain*: 0 < `radius` < ∞.
    pub fn with_rim(self, radius: R) -> Result<Self, PatchError> {
        let rim = validated_radius(radius)?;
        Ok(Self { rim, ..self })
    }

    /// The law.
    pub fn law(&self) -> &L {
        self.friction.law()
    }

    /// The nodes.
    pub fn patch(&self) -> &P {
        self.friction.patch()
    }

    /// Force and torque of the bonds on the displaced body, against its displacement.
    ///
    /// *Special values*: those of [`NodeFriction::wrench`].
    pub fn wrench(&self, load: R, displacement: &Twist<R>) -> Wrench<R> {
        self.friction.wrench(load, displacement)
    }

    /// −∂wrench/∂displacement: symmetric, and positive definite until the body lets go.
    ///
    /// *Special values*: NaN for a NaN displacement.
    ///
    /// ```
    /// use tribos_core::bond::{Bonds, BrittleBond};
    /// use tribos_core::patch::nodes::{Node, Nodes};
    /// use tribos_core::twist::Twist;
    /// let feet = [-0.1, 0.1].map(|x| Node { x, y: 0.0, weight: 0.5 }); // m
    /// let bonds = Bonds::new(BrittleBond::new(5e4_f64, 1e-5)?, Nodes::new(feet)?)?; // 1/m, m
    /// let stiffness = bonds.stiffness(60.0, &Twist::ZERO); // N
    /// assert_eq!(stiffness[(0, 0)], 60.0 * 5e4); // N/m
    /// assert!((stiffness[(2, 2)] - 60.0 * 5e4 * 0.01).abs() < 1e-9); // N m
    /// # Ok::<(), tribos_core::Error>(())
    /// ```
    pub fn stiffness(&self, load: R, displacement: &Twist<R>) -> Matrix3<R> {
        let mut sums = [R::ZERO; 6];
        for node in self.patch().nodes() {
            let (x, y) = strain(displacement, node.x, node.y);
            let length = x.hypot(y);
            let [along, across, cos, sin] = if length == R::ZERO {
                // An unstrained bond resists alike in all directions.
                let rate = self.law().stiffness();
                [rate, rate, R::ONE, R::ZERO]
            } else {
                let (slope, across) = (
                    self.law().slope(length),
                    self.law().transverse_stiffness(length),
                );
                [slope, across, x / length, y / length]
            };
            for (rate, a, b) in [(along, cos, sin), (across, -sin, cos)] {
                let rate = rate * node.weight;
                let n = node.x * b - node.y * a;
                let entries = [a * a, a * b, b * b, a * n, b * n, n * n];
                for (sum, entry) in sums.iter_mut().zip(entries) {
                    *sum += rate * entry;
                }
            }
        }
        let share = load / self.patch().total_weight();
        let [xx, xy, yy, xn, yn, nn] = sums.map(|sum| share * sum);
        Matrix3::new(xx, xy, xn, xy, yy, yn, xn, yn, nn)
    }

    /// The largest strain of a bond at a displacement.
    pub(super) fn largest_strain(&self, displacement: &Twist<R>) -> R {
        let u = displacement.speed();
        let mut largest = u + displacement.spin.abs() * self.rim;
        for node in self.patch().nodes() {
            let (x, y) = strain(displacement, node.x, node.y);
            let length = x.hypot(y);
            if length > largest {
                largest = length;
            }
        }
        largest
    }
}

/// Displacement u + θ z × x of a bond at x.
#[inline]
fn strain<R: Real>(displacement: &Twist<R>, x: R, y: R) -> (R, R) {
    (
        displacement.velocity.x - displacement.spin * y,
        displacement.velocity.y + displacement.spin * x,
    )
}
