//! A contact as the command line describes it, ready to be evaluated.

use super::extended_range::ExtendedRange;
use crate::command::number::in_range;
use crate::failure::Failure;
use std::path::Path;
use tribos::friction::{
    AnyFriction, AnyLaw, Evaluation, Law, OwnedNodes, Patch, Precision, Tier, pressure_nodes,
};
use tribos::record::Rows;
use tribos_core::Real;
use tribos_core::coupling::RoundFriction;
use tribos_core::coupling::nodes::NodeFriction;
use tribos_core::internals::leaning_wrench;
use tribos_core::patch::nodes::Node;
use tribos_core::twist::Twist;

/// What is wanted, checked but for what only the kernel can judge.
pub struct Request<'a> {
    pub patch: &'a Patch,
    pub law: Option<Law>,
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
pub struct Contact<R: Precision> {
    pub(super) kind: Kind<R>,
    tier: Tier,
    /// The exponent, if the law is a power of the speed.
    pub(super) alpha: Option<f64>,
    pub(super) coefficient: R,
    /// The unit of lengths: the radius, or 1 for points.
    pub(super) radius: R,
    is_round: bool,
}

/// One of two ways to evaluate.
pub(super) enum Kind<R: Precision> {
    /// A round patch by a coupling of the kernel; a quadrature is upright.
    Round {
        friction: RoundFriction<R, AnyFriction<R>>,
        tilt: Option<R>,
    },
    /// Nodes, in units of the radius.
    Nodes(NodeFriction<AnyLaw<R>, OwnedNodes<R>>),
}

impl<R: Precision> Contact<R> {
    pub fn new(request: &Request<'_>) -> Result<Self, Failure> {
        let radius = in_range::<R>("radius", request.radius)?;
        let is_round = !matches!(request.patch, Patch::Points(_));
        // A law has its own coefficient; the option's is 1 beside it.
        let law = match request.law {
            Some(law) => law,
            None => Law::power(1.0, request.alpha)?,
        };
        for (name, x) in law.values() {
            in_range::<R>(name, x)?;
        }
        let tier = if is_round {
            Tier::choose::<R>(request.patch, &law, request.tier)?
        } else {
            Tier::Quadrature
        };
        let by_coupling = match tier.evaluation(request.patch, &law) {
            Evaluation::Nodes => false,
            Evaluation::Quadrature => request.tilt.is_none(),
            _ => true,
        };
        let tilt = request.tilt.map(R::from_f64);
        let (kind, factor, unit) = if by_coupling {
            let coupling = AnyFriction::new(request.patch, &law, Some(tier))?;
            let factor =
                in_range::<R>("coefficient", request.coefficient)? * coupling.coefficient();
            let friction = RoundFriction::new(coupling, factor, radius).map_err(Failure::input)?;
            (Kind::Round { friction, tilt }, factor, radius)
        } else {
            let factor = in_range::<R>("coefficient", request.coefficient)?;
            let lean = tilt.unwrap_or(R::ZERO);
            let nodes = match request.patch {
                Patch::Points(path) => points(path, &|x| R::ONE + lean * (x / radius))?,
                round => pressure_nodes(round, lean)?,
            };
            let nodes = OwnedNodes::new(nodes).map_err(Failure::input)?;
            let friction = NodeFriction::new(law.build()?, nodes);
            (
                Kind::Nodes(friction),
                factor,
                if is_round { radius } else { R::ONE },
            )
        };
        Ok(Self {
            kind,
            tier,
            alpha: law.power_of_speed().map(|[_, alpha]| alpha),
            coefficient: factor,
            radius: unit,
            is_round,
        })
    }

    /// The tier that evaluates it.
    pub fn tier(&self) -> Tier {
        self.tier
    }
}

/// The error of nodes that stand for a pressure, if the law falls with the speed.
const NODES_AND_FALLING_LAWS: &str = "nodes stand for the pressure: one of them close to the centre \
    of rotation counts too much under a law that falls with the speed (errors up to 1e-2 of the load \
    at alpha = -0.2, a third of it at alpha = -0.5); --tier exact has none";

impl<R: Precision> Contact<R> {
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
            Kind::Round {
                friction,
                tilt: None,
            } => {
                let m = friction.magnitudes(load, speed, spin);
                Resistance {
                    force: m.force,
                    lateral: R::ZERO,
                    torque: m.torque,
                }
            }
            Kind::Round {
                friction,
                tilt: Some(tilt),
            } => {
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
            Kind::Nodes(_) => return None,
        };
        Some([j.force_speed, j.force_spin, j.torque_spin])
    }
}

/// Points of a file with columns x, y [m] and weight.
pub(super) fn points<R: Real>(
    path: &Path,
    lean: &impl Fn(R) -> R,
) -> Result<Vec<Node<R>>, Failure> {
    let rows = Rows::asked_for(path, |_| &["x", "y", "weight"])?.all::<3>(usize::MAX)?;
    let name = path.display();
    // Only ratios of the weights count: the largest one is brought to order 1, to the bit.
    let heaviest = rows.iter().fold(0.0, |most: f64, row| most.max(row[2]));
    let unit = ExtendedRange::new(heaviest).exponent();
    let nodes = rows.iter().enumerate().map(|(i, &[x, y, weight])| {
        let place = |name: &str, x: f64| {
            in_range::<R>(&format!("{}: {name} of point {}", path.display(), i + 1), x)
        };
        let x = place("x", x)?;
        let weight = R::from_f64(ExtendedRange::new(weight).shifted(-unit).value());
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
