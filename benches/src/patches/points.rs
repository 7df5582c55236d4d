//! Contacts at points: a tripod, and 100 nodes that represent a continuous pressure.

use super::area::Pressure;
use super::laws::{self, ForLaw, Friction};
use super::round::{SLOW_STRIDE, area_cases, rounded, timed};
use super::tables::POLYNOMIAL;
use super::{Case, Entry, Label, Refused, SEED};
use crate::mix;
use crate::reference::Wide;
use tribos_core::coupling::nodes::NodeFriction;
use tribos_core::law::LocalLaw;
use tribos_core::patch::nodes::{Node, NodeList, NodePatch, Nodes};
use tribos_core::patch::polar::PolarQuadrature;
use tribos_core::real::Real;
use tribos_core::twist::Twist;

/// Nodes of every rule.
pub const NODES: usize = 100;
const RINGS: u32 = 5;
const ANGLES: u32 = 20;
/// Positions of the stool's feet, in m, and of the point above which its weight acts.
const FEET: [[f64; 2]; 3] = [[1.0, 0.125], [-0.5, 0.75], [-0.625, -0.875]];
const CENTRE: [f64; 2] = [0.0625, 0.0];

type List<R> = NodeList<R, NODES>;

/// Nodes, and the pressure that they stand for.
struct Rule<R: Real> {
    patch: &'static str,
    pressure: Pressure,
    nodes: List<R>,
}

/// The rules that stand for continuous pressures.
fn rules<R: Real>() -> Result<Vec<Rule<R>>, Refused> {
    let disk = PolarQuadrature::new(R::ONE, RINGS, ANGLES)?;
    let mut all = vec![Rule {
        patch: "ring",
        pressure: Pressure::Ring,
        nodes: NodeList::ring(R::ONE, NODES as u32)?,
    }];
    for (patch, q) in [
        ("disk", 0.0),
        ("punch", -0.5),
        ("Hertz", 0.5),
        ("paraboloid", 1.0),
    ] {
        all.push(Rule {
            patch,
            pressure: Pressure::Power(q),
            nodes: disk.with_rim_exponent(R::from_f64(q))?.nodes()?,
        });
    }
    let [a, b, c] = POLYNOMIAL.map(R::from_f64);
    let nodes = disk.nodes_shaped(|x, y| {
        let r_sq = x * x + y * y;
        a + r_sq * (b + r_sq * c)
    })?;
    all.push(Rule {
        patch: "polynomial",
        pressure: Pressure::Polynomial(POLYNOMIAL),
        nodes,
    });
    Ok(all)
}

struct Points<R: Real> {
    frictions: Vec<(&'static str, Friction)>,
    rules: Vec<Rule<R>>,
    rows: Vec<Entry>,
}

/// A patch of nodes under a law as a row; x is the direction of sliding.
fn row<R: Real, L, P>(label: Label, cases: &[Case], law: L, patch: P) -> Entry
where
    L: LocalLaw<R> + 'static,
    P: NodePatch<R> + 'static,
{
    let friction = NodeFriction::new(law, patch);
    let bytes = size_of_val(&friction);
    let timed = timed(SLOW_STRIDE);
    Entry::new(label, bytes, cases, &timed, move |slide, rim| {
        let wrench = friction.wrench(R::ONE, &Twist::new(slide, R::ZERO, rim));
        [-wrench.force.x, -wrench.torque]
    })
}

impl<R: Real> ForLaw<R> for Points<R> {
    fn with<L: LocalLaw<R> + Copy + 'static>(&mut self, name: &'static str, law: L) {
        let Some((_, friction)) = self.frictions.iter().find(|(known, _)| *known == name) else {
            return;
        };
        for Rule {
            patch,
            pressure,
            nodes,
        } in &self.rules
        {
            let label = Label {
                patch,
                law: name,
                tier: "100 nodes",
                judge: "area",
            };
            let cases = area_cases::<R>(*pressure, friction);
            let row = row::<R, _, _>(label, &cases, law, nodes.clone());
            self.rows.push(row);
        }
    }
}

/// All laws on 100 nodes that stand for continuous pressures.
pub fn rules_for_pressures<R: Real>() -> Result<Vec<Entry>, Refused> {
    let mut all = Points::<R> {
        frictions: laws::frictions()?,
        rules: rules()?,
        rows: Vec::new(),
    };
    laws::each(&mut all)?;
    Ok(all.rows)
}

/// Power laws on given points, judged by the same sum with 30 digits.
struct PatchInput<R> {
    rows: Vec<Entry>,
    feet: [[R; 2]; 3],
}

impl<R: Real> ForLaw<R> for PatchInput<R> {
    fn with<L: LocalLaw<R> + Copy + 'static>(&mut self, name: &'static str, law: L) {
        let alpha = laws::POWERS.iter().find(|(_, known)| *known == name);
        let Some(&(alpha, _)) = alpha else {
            return;
        };
        let label = |patch| Label {
            patch,
            law: name,
            tier: "sum",
            judge: "sum",
        };
        // The constants are in the domain.
        if let Ok(stool) = Nodes::tripod(self.feet, CENTRE.map(R::from_f64)) {
            let cases = sum_cases(&stool, alpha);
            let row = row::<R, _, _>(label("tripod"), &cases, law, stool);
            self.rows.push(row);
        }
        if let Ok(nodes) = PolarQuadrature::new(R::ONE, RINGS, ANGLES).and_then(|rule| {
            let nodes: List<R> = rule.nodes()?;
            Ok(nodes)
        }) {
            let cases = sum_cases(&nodes, alpha);
            let row = row::<R, _, _>(label("100 nodes"), &cases, law, nodes);
            self.rows.push(row);
        }
    }
}

/// Power laws on the tripod and on 100 nodes that stand for nothing but themselves.
pub fn given<R: Real>() -> Result<Vec<Entry>, Refused> {
    let mut all = PatchInput::<R> {
        rows: Vec::new(),
        feet: FEET.map(|foot| foot.map(R::from_f64)),
    };
    laws::each(&mut all)?;
    Ok(all.rows)
}

fn sum_cases<R: Real>(patch: &impl NodePatch<R>, alpha: f64) -> Vec<Case> {
    let case = |pair| {
        let speeds = rounded::<R>(pair);
        let exact = exact_sum(patch.nodes(), alpha, speeds);
        Case { speeds, exact }
    };
    mix::pairs(SEED).into_iter().map(case).collect()
}

/// Σ pᵢ |uᵢ|^(α−1) uᵢ and its torque over Σ pᵢ; 2α is an integer.
fn exact_sum<R: Real>(nodes: &[Node<R>], alpha: f64, speeds: [f64; 2]) -> [Wide; 2] {
    let [slide, rim] = speeds.map(Wide::new);
    let zero = Wide::new(0.0);
    let [mut force, mut torque, mut total] = [zero; 3];
    for node in nodes {
        let [x, y, weight] = [node.x, node.y, node.weight].map(|a| Wide::new(a.to_f64()));
        total = total + weight;
        let [along, across] = [slide - rim * y, rim * x];
        let root = (along * along + across * across).sqrt().sqrt();
        if root.high == 0.0 {
            continue;
        }
        // |u|^(α−1) is a whole power of √|u|.
        let exponent = 2.0 * (alpha - 1.0);
        let mut power = weight;
        for _ in 0..exponent.abs() as u32 {
            power = if exponent > 0.0 {
                power * root
            } else {
                power / root
            };
        }
        force = force + power * along;
        torque = torque + power * (x * across - y * along);
    }
    [force / total, torque / total]
}
