//! Friction of a contact at points, or of any pressure represented by the nodes of a quadrature rule,
//! under any local law.
//!
//! Node i at rᵢ carries the share pᵢ of the load N and moves with uᵢ = v + ω × rᵢ, so that
//!
//! ```text
//! force = −N Σ pᵢ g(|uᵢ|) uᵢ/|uᵢ|,    torque = −N Σ pᵢ (rᵢ × uᵢ) g(|uᵢ|)/|uᵢ|
//! ```
//!
//! is minus the gradient of the dissipation potential, and with the unit vector e along uᵢ and the
//! one across it, c, its Hessian is N Σ pᵢ [ g' a aᵀ + (g/|uᵢ|) b bᵀ ]. Here a = (e, rᵢ × e) and
//! b = (c, rᵢ × c) carry the moment arms. Both terms are positive semidefinite for a law that never
//! weakens, and nothing cancels.

use crate::law::LocalLaw;
use crate::patch::nodes::{Node, NodePatch};
use crate::real::Real;
use crate::twist::{Twist, Wrench, WrenchJacobian};
use nalgebra::{Matrix3, Vector2};

/// A local law on a patch of nodes.
///
/// *Units*: any consistent set; twist and wrench refer to the origin of the nodes' coordinates.
/// *Accuracy*: for the given nodes a few ulp of the largest term; the accuracy for a
/// continuous pressure is that of the quadrature rule. *Cost*: one square root, one division and one
/// evaluation of the law a node.
/// *Special values*: a node that does not move carries nothing (dry friction there may be anything
/// up to its limit; the patch as a whole sticks only if all nodes rest). An empty list resists
/// nothing. NaN for infinite or NaN twists.
///
/// ```
/// use tribos_core::coupling::nodes::NodeFriction;
/// use tribos_core::law::CoulombLaw;
/// use tribos_core::patch::nodes::{Node, Nodes};
/// use tribos_core::twist::Twist;
///
/// let [left, right] = [-0.1, 0.1].map(|x| Node { x, y: 0.0, weight: 0.5 });
/// let feet = NodeFriction::new(CoulombLaw::new(0.5)?, Nodes::new([left, right])?);
/// let wrench = feet.wrench(10.0, &Twist::new(0.0, 0.0, 3.0)); // N; m/s, m/s, rad/s
/// assert!((wrench.torque + 0.5_f64 * 10.0 * 0.1).abs() < 1e-15);
/// # Ok::<(), tribos_core::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct NodeFriction<L, P> {
    law: L,
    patch: P,
}

/// What one node adds to the Jacobian, per load.
struct Stiffness<R> {
    /// p g', along the node's velocity.
    tangent: R,
    /// p g/|u|, across it.
    secant: R,
    /// Direction of the velocity.
    along: Vector2<R>,
}

/// The node's velocity v + ω × r.
#[inline]
fn velocity<R: Real>(node: &Node<R>, twist: &Twist<R>) -> Vector2<R> {
    Vector2::new(
        twist.velocity.x - twist.spin * node.y,
        twist.velocity.y + twist.spin * node.x,
    )
}

/// |u| without care for the ends of the range; `None` if the square is too near to them.
#[inline]
fn speed_unchecked<R: Real>(u: &Vector2<R>) -> Option<R> {
    let sq = u.x * u.x + u.y * u.y;
    // Below, the square of the smaller component loses digits that count. False for NaN.
    let is_ordinary = sq > R::MIN_POSITIVE / R::EPSILON && sq < R::INFINITY;
    is_ordinary.then(|| sq.sqrt())
}

impl<L, P> NodeFriction<L, P> {
    /// Couples `law` with the nodes of `patch`.
    pub fn new(law: L, patch: P) -> Self {
        Self { law, patch }
    }

    /// The local law.
    pub fn law(&self) -> &L {
        &self.law
    }

    /// The nodes.
    pub fn patch(&self) -> &P {
        &self.patch
    }

    /// The wrench on the patch, against its twist.
    ///
    /// `load` is taken as it is, so that a negative load (a contact that pulls) is the caller's to
    /// exclude.
    pub fn wrench<R: Real>(&self, load: R, twist: &Twist<R>) -> Wrench<R>
    where
        L: LocalLaw<R>,
        P: NodePatch<R>,
    {
        let [mut x, mut y, mut torque] = [R::ZERO; 3];
        for node in self.patch.nodes() {
            let [fx, fy] = self.drag(node, twist);
            x += fx;
            y += fy;
            torque += node.x * fy - node.y * fx;
        }
        let [x, y, torque] = [x, y, torque].map(|sum| -(load * self.mean(sum, twist)));
        Wrench::new(x, y, torque)
    }

    /// ∂wrench/∂twist: symmetric, and negative semidefinite for a law that never weakens.
    ///
    /// *Special values*: a node at rest counts with the law's slope at rest where this is not
    /// negative: viscous damping stays, dry friction (whose limit is infinite) is left out.
    ///
    /// ```
    /// use nalgebra::Vector3;
    /// use tribos_core::coupling::nodes::NodeFriction;
    /// use tribos_core::law::PowerLaw;
    /// use tribos_core::patch::nodes::{Node, Nodes};
    /// use tribos_core::twist::Twist;
    /// let feet = [[0.0, 0.1], [0.1, -0.1], [-0.1, -0.1]]; // m
    /// let feet = Nodes::new(feet.map(|[x, y]| Node { x, y, weight: 1.0_f64 }))?;
    /// let oiled = NodeFriction::new(PowerLaw::new(1.0, 0.2)?, feet); // 0.2 s/m
    /// // Viscous friction is linear: the Jacobian gives the wrench itself.
    /// let (jacobian, wrench) = {
    ///     let twist = Twist::new(0.3, 0.0, 2.0); // m/s, rad/s
    ///     (oiled.wrench_jacobian(10.0, &twist), oiled.wrench(10.0, &twist))
    /// };
    /// let drag = jacobian * Vector3::new(0.3, 0.0, 2.0);
    /// let wrench = Vector3::new(wrench.force.x, wrench.force.y, wrench.torque);
    /// assert!((drag - wrench).amax() < 1e-14);
    /// # Ok::<(), tribos_core::Error>(())
    /// ```
    pub fn wrench_jacobian<R: Real>(&self, load: R, twist: &Twist<R>) -> WrenchJacobian<R>
    where
        L: LocalLaw<R>,
        P: NodePatch<R>,
    {
        let mut sums = [R::ZERO; 6];
        for node in self.patch.nodes() {
            let Stiffness {
                tangent,
                secant,
                along,
            } = self.stiffness(node, twist);
            let across = Vector2::new(-along.y, along.x);
            for (rate, arm) in [(tangent, along), (secant, across)] {
                let n = node.x * arm.y - node.y * arm.x;
                let [x, y] = [rate * arm.x, rate * arm.y];
                let entries = [x * arm.x, x * arm.y, y * arm.y, x * n, y * n, rate * n * n];
                for (sum, entry) in sums.iter_mut().zip(entries) {
                    *sum += entry;
                }
            }
        }
        let [xx, xy, yy, xn, yn, nn] = sums.map(|sum| -(load * self.mean(sum, twist)));
        Matrix3::new(xx, xy, xn, xy, yy, yn, xn, yn, nn)
    }
    /// p g(|u|) u/|u| of one node.
    #[inline]
    fn drag<R: Real>(&self, node: &Node<R>, twist: &Twist<R>) -> [R; 2]
    where
        L: LocalLaw<R>,
    {
        let u = velocity(node, twist);
        match speed_unchecked(&u) {
            Some(speed) => {
                let rate = node.weight * self.law.friction(speed) / speed;
                [rate * u.x, rate * u.y]
            }
            None => self.drag_edge_cases(node.weight, u),
        }
    }

    /// [`NodeFriction::drag`] at rest, at the ends of the range, and for NaN.
    #[cold]
    fn drag_edge_cases<R: Real>(&self, weight: R, u: Vector2<R>) -> [R; 2]
    where
        L: LocalLaw<R>,
    {
        let speed = u.x.hypot(u.y);
        if speed == R::ZERO {
            return [R::ZERO; 2];
        }
        if !speed.is_finite() {
            return [R::NAN; 2];
        }
        let friction = weight * self.law.friction(speed);
        [friction * (u.x / speed), friction * (u.y / speed)]
    }

    /// The two rates of one node and the direction between them.
    fn stiffness<R: Real>(&self, node: &Node<R>, twist: &Twist<R>) -> Stiffness<R>
    where
        L: LocalLaw<R>,
    {
        let u = velocity(node, twist);
        let speed = speed_unchecked(&u).unwrap_or_else(|| u.x.hypot(u.y));
        if speed == R::ZERO {
            // Any two perpendicular directions do.
            let slope = self.law.slope(R::MIN_POSITIVE);
            let rate = if slope < R::ZERO { R::ZERO } else { slope };
            return Stiffness {
                tangent: node.weight * rate,
                secant: node.weight * rate,
                along: Vector2::new(R::ONE, R::ZERO),
            };
        }
        Stiffness {
            tangent: node.weight * self.law.slope(speed),
            secant: node.weight * self.law.friction(speed) / speed,
            along: Vector2::new(u.x / speed, u.y / speed),
        }
    }

    /// A weighted sum over the total weight; zero for a patch that carries nothing.
    #[inline]
    fn mean<R: Real>(&self, sum: R, twist: &Twist<R>) -> R
    where
        P: NodePatch<R>,
    {
        let total = self.patch.total_weight();
        if total == R::ZERO {
            // Zeros that keep a NaN.
            let [x, y] = [twist.velocity.x, twist.velocity.y];
            return R::ZERO * x + R::ZERO * y + R::ZERO * twist.spin;
        }
        sum / total
    }
}
