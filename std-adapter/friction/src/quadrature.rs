//! Any local law on a round patch: the kernel's quadratures, with the lateral force.

use super::patch::MOST_COEFFICIENTS;
use super::{AnyLaw, FrictionError, Law, OwnedNodes, Patch, Precision};
use tribos_core::coupling::nodes::NodeFriction;
use tribos_core::coupling::quadrature::DiskQuadrature;
use tribos_core::coupling::{LateralFriction, ReducedFriction, ReducedJacobian, ReducedWrench};
use tribos_core::internals::LateralJacobian;
use tribos_core::law::LocalLaw;
use tribos_core::patch::PolynomialPressure;
use tribos_core::patch::nodes::{Node, NodeList, NodePatch};
use tribos_core::patch::polar::PolarQuadrature;
use tribos_core::real::Real;
use tribos_core::twist::Twist;

/// Relative accuracy of the quadrature on disk and annulus for laws as smooth as those of the kernel.
pub(super) const DISK_ACCURACY: f64 = 1e-8;
/// Accuracy of the sum over nodes, relative to the largest friction on the patch.
pub(super) const NODES_ACCURACY: f64 = 1e-3;

/// Rings and angles of the nodes that stand for a pressure.
const RINGS: u32 = 32;
const ANGLES: u32 = 2 * RINGS;
const NODES: usize = (RINGS * ANGLES) as usize;

/// The polynomial pressure of these coefficients, refused if it is negative anywhere or carries no
/// load.
///
/// ```
/// use tribos::friction::polynomial;
/// assert_eq!(polynomial(&[1.0, -1.0])?.mean_square_radius(), 1.0 / 3.0); // a paraboloid
/// assert!(polynomial(&[1.0, -2.0]).is_err()); // negative at the rim
/// # Ok::<(), tribos::friction::FrictionError>(())
/// ```
pub fn polynomial(
    coefficients: &[f64],
) -> Result<PolynomialPressure<MOST_COEFFICIENTS>, FrictionError> {
    let mut padded = [0.0; MOST_COEFFICIENTS];
    for (slot, a) in padded.iter_mut().zip(coefficients) {
        *slot = *a;
    }
    Ok(PolynomialPressure::new(padded)?)
}

/// The uniform disk under any law.
///
/// *Derivation* of the lateral force G: the kernel's F = v⟨2 sin²θ g(ρ)/ρ⟩ is a mean over the rim, and
/// G = w⟨x² g/ρ⟩ over the disk is, ring by ring, w r² of the same mean, so that
///
/// ```text
/// G = w ∫ r³ F(v, r w)/v dr,    r from 0 to 1
/// ```
///
/// The integrand is smooth but at r = v/w, where nodes are crowded from both sides by r = v/w ± t².
#[derive(Debug)]
pub(super) struct DiskOfAnyLaw<R> {
    disk: DiskQuadrature<AnyLaw<R>>,
}

/// Nodes and weights of the 12-point Gauss–Legendre rule on [0, 1],
/// by Newton's method on the Legendre polynomial, to 1e-16.
const GAUSS: [[f64; 2]; 12] = [
    [0.009_219_682_876_640_378, 0.023_587_668_193_255_917],
    [0.047_941_371_814_762_6, 0.053_469_662_997_659_09],
    [0.115_048_662_902_847_65, 0.080_039_164_271_673_17],
    [0.206_341_022_856_691_26, 0.101_583_713_361_532_92],
    [0.316_084_250_500_909_94, 0.116_746_268_269_177_39],
    [0.437_383_295_744_265_54, 0.124_573_522_906_701_44],
    [0.562_616_704_255_734_4, 0.124_573_522_906_701_44],
    [0.683_915_749_499_090_1, 0.116_746_268_269_177_39],
    [0.793_658_977_143_308_7, 0.101_583_713_361_532_92],
    [0.884_951_337_097_152_3, 0.080_039_164_271_673_17],
    [0.952_058_628_185_237_5, 0.053_469_662_997_659_09],
    [0.990_780_317_123_359_6, 0.023_587_668_193_255_917],
];

impl<R: Real> DiskOfAnyLaw<R> {
    pub fn new(law: AnyLaw<R>) -> Self {
        let disk = DiskQuadrature::new(law);
        Self { disk }
    }

    /// ∫ r³ f(r) dr over [0, 1] with a weak singularity at r = `slide`/`rim`.
    fn over_radius<const N: usize>(slide: R, rim: R, f: impl Fn(R) -> [R; N]) -> [R; N] {
        let kink = if slide < rim { slide / rim } else { R::ONE };
        let mut sums = [R::ZERO; N];
        for [t, weight] in GAUSS {
            let (t, weight) = (R::from_f64(t), R::from_f64(2.0 * t * weight));
            for [from, width] in [[kink, -kink], [kink, R::ONE - kink]] {
                if width != R::ZERO {
                    let r = from + width * t * t;
                    let share = weight * width.abs() * r * r * r;
                    for (sum, term) in sums.iter_mut().zip(f(r)) {
                        *sum += share * term;
                    }
                }
            }
        }
        sums
    }
}

impl<R: Real> ReducedFriction<R> for DiskOfAnyLaw<R> {
    fn reduced_wrench(&self, slide: R, rim: R) -> ReducedWrench<R> {
        self.disk.reduced_wrench(slide, rim)
    }
    fn reduced_jacobian(&self, slide: R, rim: R) -> ReducedJacobian<R> {
        self.disk.reduced_jacobian(slide, rim)
    }
}

impl<R: Real> LateralFriction<R> for DiskOfAnyLaw<R> {
    fn lateral(&self, slide: R, rim: R) -> R {
        let (slide, rim) = (slide.abs(), rim.abs());
        if rim == R::ZERO {
            return R::ZERO * slide;
        }
        let [drag] = Self::over_radius(slide, rim, |r| {
            [if slide == R::ZERO {
                self.disk.reduced_jacobian(slide, r * rim).force_per_slide
            } else {
                self.disk.reduced_wrench(slide, r * rim).force / slide
            }]
        });
        rim * drag
    }

    fn lateral_jacobian(&self, slide: R, rim: R) -> LateralJacobian<R> {
        let (slide, rim) = (slide.abs(), rim.abs());
        if rim == R::ZERO {
            return LateralJacobian::default();
        }
        // ∂(vG)/∂v = w ∫r³ ∂F/∂v dr and ∂(vG)/∂w = ∫r³ (F + r w ∂F/∂w) dr.
        let [along, across] = Self::over_radius(slide, rim, |r| {
            let slopes = self.disk.reduced_jacobian(slide, r * rim);
            let force = slopes.force_per_slide * slide;
            [slopes.force_slide, force + r * rim * slopes.mixed]
        });
        LateralJacobian {
            slide: rim * along,
            rim: across,
        }
    }

    fn mean_square_radius(&self) -> R {
        R::HALF
    }
}

/// A round patch by nodes in units of its radius.
#[derive(Debug)]
pub(super) struct NodeQuadrature<R> {
    friction: NodeFriction<AnyLaw<R>, OwnedNodes<R>>,
}

impl<R: Precision> NodeQuadrature<R> {
    pub fn new(patch: &Patch, law: &Law) -> Result<Self, FrictionError> {
        let nodes = OwnedNodes::new(pressure_nodes(patch, R::ZERO)?)?;
        let friction = NodeFriction::new(law.build()?, nodes);
        Ok(Self { friction })
    }
}

impl<R: Real> NodeQuadrature<R> {
    /// The mean over the nodes of a function of the place and of the stress g u/|u| there, for a
    /// velocity `slide` along x.
    fn mean(&self, slide: R, rim: R, of: impl Fn(&Node<R>, [R; 2]) -> R) -> R {
        let sum = self
            .friction
            .patch()
            .nodes()
            .iter()
            .fold(R::ZERO, |sum, node| {
                let u = [slide - rim * node.y, rim * node.x];
                let speed = u[0].hypot(u[1]);
                if speed == R::ZERO {
                    return sum;
                }
                let friction = self.friction.law().friction(speed);
                sum + node.weight * of(node, u.map(|part| friction * (part / speed)))
            });
        sum / self.friction.patch().total_weight()
    }
}

impl<R: Real> ReducedFriction<R> for NodeQuadrature<R> {
    fn reduced_wrench(&self, slide: R, rim: R) -> ReducedWrench<R> {
        let twist = Twist::new(slide.abs(), R::ZERO, rim.abs());
        let wrench = self.friction.wrench(R::ONE, &twist);
        ReducedWrench {
            force: R::ZERO - wrench.force.x,
            torque: R::ZERO - wrench.torque,
        }
    }

    fn reduced_jacobian(&self, slide: R, rim: R) -> ReducedJacobian<R> {
        let twist = Twist::new(slide.abs(), R::ZERO, rim.abs());
        let j = self.friction.wrench_jacobian(R::ONE, &twist);
        ReducedJacobian {
            force_per_slide: -j[(1, 1)],
            force_slide: -j[(0, 0)],
            mixed: -j[(0, 2)],
            torque_rim: -j[(2, 2)],
        }
    }
}

impl<R: Real> LateralFriction<R> for NodeQuadrature<R> {
    fn lateral(&self, slide: R, rim: R) -> R {
        self.mean(slide.abs(), rim.abs(), |node, [_, y]| node.x * y)
    }

    fn lateral_jacobian(&self, slide: R, rim: R) -> LateralJacobian<R> {
        let (slide, rim) = (slide.abs(), rim.abs());
        // Minus what force and torque gain from the weight y.
        LateralJacobian {
            slide: -self.mean(slide, rim, |node, [x, _]| node.y * x),
            rim: -self.mean(slide, rim, |node, [x, y]| {
                node.y * (node.x * y - node.y * x)
            }),
        }
    }

    fn mean_square_radius(&self) -> R {
        let weighted =
            |sum, node: &Node<R>| sum + node.weight * (node.x * node.x + node.y * node.y);
        let patch = self.friction.patch();
        patch.nodes().iter().fold(R::ZERO, weighted) / patch.total_weight()
    }
}

/// Nodes that stand for the pressure of a round patch, in units of its radius, with a gradient `tilt`
/// along the first axis.
///
/// *Accuracy*: friction within about 1e-3 of the load for laws that do not fall steeply with the speed.
///
/// ```
/// use tribos::friction::{Patch, pressure_nodes};
/// let nodes = pressure_nodes(&Patch::Hertz, 0.0_f64)?;
/// let total: f64 = nodes.iter().map(|node| node.weight).sum();
/// let square: f64 = nodes.iter().map(|n| n.weight * (n.x * n.x + n.y * n.y)).sum();
/// assert!((square / total - 0.4).abs() < 1e-6); // <r²> of Hertz' pressure
/// # Ok::<(), tribos::friction::FrictionError>(())
/// ```
pub fn pressure_nodes<R: Real>(patch: &Patch, tilt: R) -> Result<Vec<Node<R>>, FrictionError> {
    round_nodes(patch, R::ONE, RINGS, tilt)
}

/// [`pressure_nodes`] of a radius, on so many rings, at most 32, with twice as many angles; a ring carries as
/// many as lie on half of these.
pub fn round_nodes<R: Real>(
    patch: &Patch,
    radius: R,
    rings: u32,
    tilt: R,
) -> Result<Vec<Node<R>>, FrictionError> {
    let angles = 2 * rings;
    let lean = |x: R| R::ONE + tilt * x / radius;
    let rule = || PolarQuadrature::new(radius, rings, angles);
    match patch {
        Patch::Points(_) | Patch::Flat(_) => Err(FrictionError::NoAxis),
        Patch::Ring => {
            let ring = NodeList::<R, NODES>::ring(radius, rings * rings)?;
            Ok(leaned(ring.nodes(), lean).collect())
        }
        Patch::Annulus(inner) | Patch::WornAnnulus(inner) => {
            // Rings between the inner and the outer radius, with equal shares of the area, or of the width.
            let mut nodes = Vec::new();
            for i in 0..rings {
                let share = (f64::from(i) + 0.5) / f64::from(rings);
                let at = match patch {
                    Patch::WornAnnulus(_) => R::from_f64(inner + share * (1.0 - inner)),
                    _ => R::from_f64(inner * inner + share * (1.0 - inner * inner)).sqrt(),
                };
                let at = radius * at;
                let ring = NodeList::<R, { ANGLES as usize }>::ring(at, angles)?;
                nodes.extend(leaned(ring.nodes(), lean));
            }
            Ok(nodes)
        }
        Patch::Polynomial(coefficients) => {
            // Refuses what is negative anywhere.
            polynomial(coefficients)?;
            let pressure = |r_sq: R| {
                let terms = coefficients.iter().rev();
                terms.fold(R::ZERO, |sum, &a| sum * r_sq + R::from_f64(a))
            };
            let shaped = |x: R, y: R| pressure((x * x + y * y) / (radius * radius)) * lean(x);
            let nodes: NodeList<R, NODES> = rule()?.nodes_shaped(shaped)?;
            Ok(nodes.nodes().to_vec())
        }
        _ => {
            let order = patch.pressure().map_or(0.0, |pressure| pressure.order());
            let rule = rule()?.with_rim_exponent(R::from_f64(order))?;
            let nodes: NodeList<R, NODES> = rule.nodes_tilted(tilt, R::ZERO)?;
            Ok(nodes.nodes().to_vec())
        }
    }
}

/// Nodes whose weights lean.
fn leaned<R: Real>(nodes: &[Node<R>], lean: impl Fn(R) -> R) -> impl Iterator<Item = Node<R>> {
    nodes.iter().map(move |node| Node {
        weight: node.weight * lean(node.x),
        ..*node
    })
}
