//! A contact as the command line describes it, ready to be evaluated.

use crate::command::columns;
use crate::command::laws::{AnyLaw, LawSpec};
use crate::command::patch::PatchName;
use crate::command::tier::{self, AnyCoupling, AnyRound, Tabulated, Tier};
use crate::failure::Failure;
use std::path::Path;
use tribos_core::Real;
use tribos_core::coupling::nodes::NodeFriction;
use tribos_core::coupling::quadrature::DiskQuadrature;
use tribos_core::coupling::tall::leaning_wrench;
use tribos_core::coupling::{Annulus, Coupling, PatchFriction};
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
pub struct Resistance<R> {
    pub force: R,
    pub lateral: R,
    pub torque: R,
}

/// One of three ways to evaluate.
pub enum Contact<R: Real> {
    /// A round patch in closed form or from a table.
    Round {
        friction: PatchFriction<R, AnyRound<R>>,
        tilt: R,
    },
    /// A round patch by the rim integrals, upright.
    Upright(PatchFriction<R, AnyCoupling<R>>),
    /// Nodes.
    Nodes {
        friction: NodeFriction<AnyLaw<R>, Points<R>>,
        coefficient: R,
    },
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
        let coefficient = in_range::<R>("coefficient", request.coefficient)?;
        let tilt = request.tilt.map(R::from_f64);
        if request.law.is_none()
            && let Some(coupling) = tier::coupling::<R>(request.patch, request.alpha, request.tier)?
        {
            let friction =
                PatchFriction::new(coupling, coefficient, radius).map_err(Failure::input)?;
            let tilt = tilt.unwrap_or(R::ZERO);
            return Ok(Self::Round { friction, tilt });
        }
        let law = || match request.law {
            Some(spec) => spec.law::<R>(),
            None => match PowerLaw::new(R::from_f64(request.alpha), R::ONE) {
                Ok(law) => Ok(AnyLaw(Box::new(law))),
                Err(error) => Err(Failure::input(error)),
            },
        };
        let upright: Option<Box<dyn Coupling<R>>> = match (request.patch, tilt) {
            (PatchName::Disk, None) => Some(Box::new(DiskQuadrature::new(law()?))),
            (PatchName::Annulus(inner), None) => {
                let disk = DiskQuadrature::new(law()?);
                let annulus = Annulus::new(disk, R::from_f64(*inner)).map_err(Failure::input)?;
                Some(Box::new(annulus))
            }
            _ => None,
        };
        if let Some(coupling) = upright {
            let friction = PatchFriction::new(AnyCoupling(coupling), coefficient, radius)
                .map_err(Failure::input)?;
            return Ok(Self::Upright(friction));
        }
        let nodes = nodes(request.patch, radius, tilt.unwrap_or(R::ZERO))?;
        let total = nodes.iter().fold(R::ZERO, |sum, node| sum + node.weight);
        let friction = NodeFriction::new(law()?, Points { nodes, total });
        Ok(Self::Nodes {
            friction,
            coefficient,
        })
    }
}

impl<R: Real> Contact<R> {
    /// Resistance of a round patch at sliding speed along the first axis and spin, of either sign;
    /// a pressure that leans does so along the velocity.
    pub fn round_resistance(&self, load: R, speed: R, spin: R) -> Resistance<R> {
        let of = self.resistance(load, speed.abs(), spin.abs());
        let signed = |x: R, negative: bool| if negative { R::ZERO - x } else { x };
        let (back, clockwise) = (speed < R::ZERO, spin < R::ZERO);
        Resistance {
            force: signed(of.force, back),
            // Turned by half a turn with the velocity, mirrored with the spin.
            lateral: signed(of.lateral, back != clockwise),
            torque: signed(of.torque, clockwise),
        }
    }

    /// Resistance at sliding speed along the first axis and spin.
    pub fn resistance(&self, load: R, speed: R, spin: R) -> Resistance<R> {
        match self {
            Self::Upright(friction) => {
                let m = friction.magnitudes(load, speed.abs(), spin.abs());
                Resistance {
                    force: m.force,
                    lateral: R::ZERO,
                    torque: m.torque,
                }
            }
            Self::Round { friction, tilt } => {
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
            Self::Nodes {
                friction,
                coefficient,
            } => {
                let w = friction.wrench(load, &Twist::new(speed, R::ZERO, spin));
                // The opposite of what the body feels; no zero is negative.
                let opposite = |x: R| R::ZERO - *coefficient * x;
                Resistance {
                    force: opposite(w.force.x),
                    lateral: opposite(w.force.y),
                    torque: opposite(w.torque),
                }
            }
        }
    }

    /// Derivatives of force and torque with their signs, where the patch is round and upright.
    pub fn jacobian(&self, load: R, speed: R, spin: R) -> Option<[R; 4]> {
        let opposed = (speed < R::ZERO) != (spin < R::ZERO);
        let mixed = |x: R| if opposed { R::ZERO - x } else { x };
        let (speed, spin) = (speed.abs(), spin.abs());
        let j = match self {
            Self::Round { friction, .. } => friction.magnitudes_jacobian(load, speed, spin),
            Self::Upright(friction) => friction.magnitudes_jacobian(load, speed, spin),
            Self::Nodes { .. } => return None,
        };
        Some([
            j.force_speed,
            mixed(j.force_spin),
            mixed(j.torque_speed),
            j.torque_spin,
        ])
    }
}

/// Nodes of any patch with pressure gradient `tilt` along the first axis.
fn nodes<R: Real>(patch: &PatchName, radius: R, tilt: R) -> Result<Vec<Node<R>>, Failure> {
    let rule = PolarRule::new(radius, RINGS, ANGLES).map_err(Failure::input)?;
    let lean = |x: R| R::ONE + tilt * x / radius;
    let list = |nodes: Result<tribos_core::patch::nodes::NodeList<R, NODES>, _>| {
        let nodes = nodes.map_err(|error| Failure::input(format!("{error}")))?;
        Ok(nodes.nodes().to_vec())
    };
    match patch {
        PatchName::Points(path) => points(path, &lean),
        PatchName::Ring => {
            let ring = polar::ring::<R, NODES>(radius, NODES as u32 / 2).map_err(Failure::input)?;
            let mut nodes = ring.nodes().to_vec();
            for node in &mut nodes {
                node.weight *= lean(node.x);
            }
            Ok(nodes)
        }
        PatchName::Annulus(inner) => annulus(radius, *inner, &lean),
        PatchName::Polynomial(coefficients) => {
            // Refuses what is negative anywhere.
            tier::polynomial(coefficients)?;
            list(rule.nodes_shaped(|x, y| {
                let r_sq = (x * x + y * y) / (radius * radius);
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
fn annulus<R: Real>(
    radius: R,
    inner: f64,
    lean: &impl Fn(R) -> R,
) -> Result<Vec<Node<R>>, Failure> {
    let mut nodes = Vec::new();
    for i in 0..RINGS {
        let share = (f64::from(i) + 0.5) / f64::from(RINGS);
        let r_sq = inner * inner + share * (1.0 - inner * inner);
        let ring = radius * R::from_f64(r_sq).sqrt();
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
    let nodes: Vec<Node<R>> = rows
        .iter()
        .map(|&[x, y, weight]| {
            let [x, y, weight] = [x, y, weight].map(R::from_f64);
            Node {
                x,
                y,
                weight: weight * lean(x),
            }
        })
        .collect();
    let name = path.display();
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

/// `x` in the precision asked for; refused if it overflows there.
pub fn in_range<R: Real>(name: &str, x: f64) -> Result<R, Failure> {
    let narrow = R::from_f64(x);
    if narrow.is_finite() {
        Ok(narrow)
    } else {
        Err(Failure::input(format!(
            "{name} {x} is too large for f32; use --precision f64"
        )))
    }
}
