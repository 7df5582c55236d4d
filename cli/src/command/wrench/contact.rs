//! A contact as the command line describes it, ready to be evaluated.

use super::product::Product;
use crate::command::columns;
use crate::command::laws::{AnyLaw, LawSpec};
use crate::command::number::in_range;
use crate::command::patch::PatchName;
use crate::command::tier::{self, AnyCoupling, AnyRound, Tabulated, Tier};
use crate::failure::Failure;
use std::path::Path;
use tribos_core::Real;
use tribos_core::coupling::nodes::NodeFriction;
use tribos_core::coupling::quadrature::DiskQuadrature;
use tribos_core::coupling::{Annulus, Coupling, PatchFriction};
use tribos_core::internals::leaning_wrench;
use tribos_core::law::PowerLaw;
use tribos_core::patch::nodes::{Node, NodePatch};
use tribos_core::patch::polar::{self, PolarRule};
use tribos_core::twist::Twist;

/// Rings and angles of the rules that stand for a pressure.
const RINGS: u32 = 32;
const ANGLES: u32 = 64;
const NODES: usize = (RINGS * ANGLES) as usize;

/// What is wanted, checked but for what only the kernel can judge.
pub struct Request<'a> {
    pub patch: &'a PatchName,
    pub law: Option<&'a LawSpec>,
    pub alpha: f64,
    pub tier: Option<Tier>,
    pub coefficient: f64,
    pub radius: f64,
    /// Pressure gradient K along the velocity, in 1/radius.
    pub tilt: Option<f64>,
}

/// What the body does to the ground, the opposite of what friction does to the body: force along x,
/// force to the left of x, torque counterclockwise.
///
/// With x the way of a positive speed, force and torque have the signs of the motion, and
/// force·speed + torque·spin is the power that friction takes.
pub struct Resistance<T> {
    pub force: T,
    pub lateral: T,
    pub torque: T,
}

impl<T> Resistance<T> {
    /// The same of every entry.
    pub fn map<U>(self, mut each: impl FnMut(T) -> U) -> Resistance<U> {
        Resistance {
            force: each(self.force),
            lateral: each(self.lateral),
            torque: each(self.torque),
        }
    }
}

impl Resistance<f64> {
    /// That of a round patch at speeds of either sign from that at their magnitudes; a pressure that
    /// leans does so along the velocity.
    pub fn signed(self, [speed, spin]: [f64; 2]) -> Self {
        let signed = |x: f64, negative: bool| if negative { 0.0 - x } else { x };
        let (back, clockwise) = (speed < 0.0, spin < 0.0);
        Self {
            force: signed(self.force, back),
            // Turned by half a turn with the velocity, mirrored with the spin.
            lateral: signed(self.lateral, back != clockwise),
            torque: signed(self.torque, clockwise),
        }
    }
}

/// A contact that can be evaluated.
pub struct Contact<R: Real> {
    pub(super) kind: Kind<R>,
    /// The exponent, if the law is a power of the speed.
    pub(super) alpha: Option<f64>,
    pub(super) coefficient: R,
    /// The unit of lengths: the radius, or 1 for points.
    pub(super) radius: R,
    is_round: bool,
}

/// One of three ways to evaluate.
pub(super) enum Kind<R: Real> {
    /// A round patch in closed form or from a table.
    Round {
        friction: PatchFriction<R, AnyRound<R>>,
        tilt: R,
    },
    /// A round patch by the rim integrals, upright.
    Upright(PatchFriction<R, AnyCoupling<R>>),
    /// Nodes, in units of the radius.
    Nodes(NodeFriction<AnyLaw<R>, Points<R>>),
}

/// Nodes in a list.
pub struct Points<R> {
    nodes: Vec<Node<R>>,
    total: R,
}

impl<R: Real> NodePatch<R> for Points<R> {
    fn nodes(&self) -> &[Node<R>] {
        &self.nodes
    }
    fn total_weight(&self) -> R {
        self.total
    }
}

impl<R: Tabulated> Contact<R> {
    pub fn new(request: &Request<'_>) -> Result<Self, Failure> {
        let radius = in_range::<R>("radius", request.radius)?;
        let is_round = !matches!(request.patch, PatchName::Points(_));
        let tilt = request.tilt.map(R::from_f64);
        let power = match request.law {
            Some(law) => law.power(),
            None => Some([request.coefficient, request.alpha]),
        };
        // A law is checked by its own constructor.
        let law = || match request.law {
            Some(spec) => spec.law::<R>(),
            None => match PowerLaw::new(R::from_f64(request.alpha), R::ONE) {
                Ok(law) => Ok(AnyLaw(Box::new(law))),
                Err(error) => Err(Failure::input(error)),
            },
        };
        if let Some([coefficient, alpha]) = power {
            if request.law.is_some() {
                law()?;
            }
            // What has no exact tier is left to quadrature, unless a tier was asked for.
            let fallback = (request.law.is_some()
                && request.tier.is_none()
                && !tier::is_served::<R>(request.patch, alpha))
            .then_some(Tier::Quadrature);
            let chosen = request.tier.or(fallback);
            if let Some(coupling) = tier::coupling::<R>(request.patch, alpha, chosen)? {
                let coefficient = in_range::<R>("coefficient", coefficient)?;
                let friction =
                    PatchFriction::new(coupling, coefficient, radius).map_err(Failure::input)?;
                return Ok(Self {
                    kind: Kind::Round {
                        friction,
                        tilt: tilt.unwrap_or(R::ZERO),
                    },
                    alpha: Some(alpha),
                    coefficient,
                    radius,
                    is_round,
                });
            }
        } else if is_round && matches!(request.tier, Some(Tier::Table | Tier::Compact)) {
            return Err(Failure::input(
                "--tier table and compact serve coefficient * |v|^alpha alone; other laws are \
                 served by quadrature: leave out --tier",
            ));
        }
        // A law has its own coefficient; the option's is 1 beside it.
        let coefficient = in_range::<R>("coefficient", request.coefficient)?;
        let upright: Option<Box<dyn Coupling<R>>> = match (request.patch, tilt) {
            (PatchName::Disk, None) => Some(Box::new(DiskQuadrature::new(law()?))),
            (PatchName::Annulus(inner), None) => {
                let disk = DiskQuadrature::new(law()?);
                let annulus = Annulus::new(disk, R::from_f64(*inner)).map_err(Failure::input)?;
                Some(Box::new(annulus))
            }
            _ => None,
        };
        let lean = tilt.unwrap_or(R::ZERO);
        let (kind, radius) = if let Some(coupling) = upright {
            let coupling = AnyCoupling(coupling);
            let friction =
                PatchFriction::new(coupling, coefficient, radius).map_err(Failure::input)?;
            (Kind::Upright(friction), radius)
        } else {
            let nodes = nodes(request.patch, radius, lean)?;
            let total = nodes.iter().fold(R::ZERO, |sum, node| sum + node.weight);
            let friction = NodeFriction::new(law()?, Points { nodes, total });
            let unit = if is_round { radius } else { R::ONE };
            (Kind::Nodes(friction), unit)
        };
        Ok(Self {
            kind,
            alpha: power.map(|[_, alpha]| alpha),
            coefficient,
            radius,
            is_round,
        })
    }
}

/// The error of nodes that stand for a pressure, if the law falls with the speed.
const NODES_AND_FALLING_LAWS: &str = "nodes stand for the pressure: one of them close to the centre \
    of rotation counts too much under a law that falls with the speed (errors up to 1e-2 of the load \
    at alpha = -0.2, a third of it at alpha = -0.5); --tier table or compact are exact";

impl<R: Real> Contact<R> {
    /// What is to be known of the answers.
    pub fn caveat(&self) -> Option<&'static str> {
        let stands_for_pressure = self.is_round && matches!(self.kind, Kind::Nodes(_));
        let falls = self.alpha.is_some_and(|alpha| alpha < 0.0);
        (stands_for_pressure && falls).then_some(NODES_AND_FALLING_LAWS)
    }

    /// Resistance at sliding speed along the first axis and spin; of round patches at their
    /// magnitudes.
    pub fn resistance(&self, load: R, speed: R, spin: R) -> Resistance<R> {
        match &self.kind {
            Kind::Upright(friction) => {
                let m = friction.magnitudes(load, speed, spin);
                Resistance {
                    force: m.force,
                    lateral: R::ZERO,
                    torque: m.torque,
                }
            }
            Kind::Round { friction, tilt } => {
                let rim = (spin * friction.radius()).abs();
                let speeds = [speed.abs(), rim];
                let w = leaning_wrench(friction.coupling(), speeds, [*tilt, R::ZERO]);
                let strength = friction.coefficient() * load;
                Resistance {
                    force: strength * w.force,
                    lateral: strength * w.lateral,
                    torque: strength * friction.radius() * w.torque,
                }
            }
            Kind::Nodes(friction) => {
                let rim = spin * self.radius;
                let w = friction.wrench(load, &Twist::new(speed, R::ZERO, rim));
                // The opposite of what the body feels; no zero is negative.
                let opposite = |x: R| R::ZERO - self.coefficient * x;
                Resistance {
                    force: opposite(w.force.x),
                    lateral: opposite(w.force.y),
                    torque: opposite(w.torque * self.radius),
                }
            }
        }
    }

    /// ∂F/∂v, ∂F/∂ω and ∂T/∂ω at speed ≥ 0 and spin ≥ 0, where the patch is round and upright.
    pub fn jacobian(&self, load: R, speed: R, spin: R) -> Option<[R; 3]> {
        let j = match &self.kind {
            Kind::Round { friction, .. } => friction.magnitudes_jacobian(load, speed, spin),
            Kind::Upright(friction) => friction.magnitudes_jacobian(load, speed, spin),
            Kind::Nodes(_) => return None,
        };
        Some([j.force_speed, j.force_spin, j.torque_spin])
    }
}

/// Nodes of any patch with pressure gradient `tilt` along the first axis, in units of the radius;
/// points where they are.
fn nodes<R: Real>(patch: &PatchName, radius: R, tilt: R) -> Result<Vec<Node<R>>, Failure> {
    let rule = PolarRule::new(R::ONE, RINGS, ANGLES).map_err(Failure::input)?;
    let lean = |x: R| R::ONE + tilt * x;
    let list = |nodes: Result<tribos_core::patch::nodes::NodeList<R, NODES>, _>| {
        let nodes = nodes.map_err(|error| Failure::input(format!("{error}")))?;
        Ok(nodes.nodes().to_vec())
    };
    match patch {
        PatchName::Points(path) => points(path, &|x| lean(x / radius)),
        PatchName::Ring => {
            let ring = polar::ring::<R, NODES>(R::ONE, NODES as u32 / 2).map_err(Failure::input)?;
            let mut nodes = ring.nodes().to_vec();
            for node in &mut nodes {
                node.weight *= lean(node.x);
            }
            Ok(nodes)
        }
        PatchName::Annulus(inner) => annulus(*inner, &lean),
        PatchName::Polynomial(coefficients) => {
            // Refuses what is negative anywhere.
            tier::polynomial(coefficients)?;
            list(rule.nodes_shaped(|x, y| {
                let r_sq = x * x + y * y;
                let pressure = coefficients
                    .iter()
                    .rev()
                    .fold(R::ZERO, |sum, &a| sum * r_sq + R::from_f64(a));
                pressure * lean(x)
            }))
        }
        _ => {
            let order = patch.pressure().map_or(0.0, |p| p.order());
            let rule = rule.with_rim_exponent(R::from_f64(order));
            list(rule.map_err(Failure::input)?.nodes_tilted(tilt, R::ZERO))
        }
    }
}

/// Rings between the inner and the outer radius, equal shares of the area.
fn annulus<R: Real>(inner: f64, lean: &impl Fn(R) -> R) -> Result<Vec<Node<R>>, Failure> {
    let mut nodes = Vec::new();
    for i in 0..RINGS {
        let share = (f64::from(i) + 0.5) / f64::from(RINGS);
        let r_sq = inner * inner + share * (1.0 - inner * inner);
        let ring = R::from_f64(r_sq).sqrt();
        let ring = polar::ring::<R, { ANGLES as usize }>(ring, ANGLES).map_err(Failure::input)?;
        nodes.extend(ring.nodes().iter().map(|node| Node {
            weight: node.weight * lean(node.x),
            ..*node
        }));
    }
    Ok(nodes)
}

/// Points of a file with columns x, y [m] and weight.
fn points<R: Real>(path: &Path, lean: &impl Fn(R) -> R) -> Result<Vec<Node<R>>, Failure> {
    let rows = columns::read(path, &["x", "y", "weight"])?;
    let name = path.display();
    // Only ratios of the weights count: the largest one is brought to order 1, to the bit.
    let heaviest = rows.iter().fold(0.0, |most: f64, row| most.max(row[2]));
    let unit = Product::new(heaviest).exponent();
    let nodes = rows.iter().enumerate().map(|(i, &[x, y, weight])| {
        let place = |name: &str, x: f64| {
            in_range::<R>(&format!("{}: {name} of point {}", path.display(), i + 1), x)
        };
        let x = place("x", x)?;
        let weight = R::from_f64(Product::new(weight).shifted(-unit).value());
        Ok(Node {
            x,
            y: place("y", y)?,
            weight: weight * lean(x),
        })
    });
    let nodes: Vec<Node<R>> = nodes.collect::<Result<_, Failure>>()?;
    if let Some(i) = nodes.iter().position(|node| node.weight < R::ZERO) {
        return Err(Failure::input(format!(
            "{name}: point {} has negative weight (or --tilt lifts it); weights are >= 0",
            i + 1
        )));
    }
    if nodes.iter().all(|node| node.weight == R::ZERO) {
        return Err(Failure::input(format!("{name}: no point carries load")));
    }
    Ok(nodes)
}
