//! Figure 3.16: a sliding, spinning cylinder leans forward and drifts to the side.

use crate::exhibit::{Exhibit, at, geometric, linear, points, table};
use crate::text::Text;
use anyhow::Result;
use tribos::slide::planar::{Launch, PlanarSimulation, TallCylinder};
use tribos_core::coupling::load_transfer::{
    FullGradient, LoadTransferFriction, LoadTransferWrench, LongitudinalGradient, PressureGradient,
};
use tribos_core::coupling::nodes::NodeFriction;
use tribos_core::coupling::{LateralFriction, RoundFriction, table::DiskTable64};
use tribos_core::law::CoulombLaw;
use tribos_core::patch::nodes::{NodeList, NodePatch};
use tribos_core::patch::polar::PolarQuadrature;
use tribos_core::twist::{Twist, Wrench};
use tribos_report::claim::Claim;
use tribos_report::figure::{Axis, Figure, Legend, Series};
use tribos_report::verdict::Allowance;

const TEXT: Text = Text(include_str!("figure-3.16.md"));

/// Nodes of the direct integration, and the error they leave in reduced force and torque.
const RINGS: u32 = 64;
const ANGLES: u32 = 128;
const NODES: usize = (RINGS * ANGLES) as usize;
const NODE_ERROR: f64 = 3e-4;
/// λ = 2 μ H/R of the body whose sideways lean is shown.
const LEAN: f64 = 0.8;

/// 2G at ε with ωR = 1: the lateral function of the thesis.
fn lateral(table: &DiskTable64, ratio: f64) -> f64 {
    2.0 * table.lateral(ratio, 1.0)
}

/// F, T, the lateral function and its product with F.
pub fn figure_3_16() -> Result<Exhibit> {
    let dry = table(0.0)?;
    let rows: Vec<Vec<f64>> = geometric(1e-2, 1e2, 400)
        .into_iter()
        .map(|ratio| {
            let ([force, torque], side) = (at(&dry, ratio), lateral(&dry, ratio));
            vec![ratio, force, torque, side, force * side]
        })
        .collect();
    let figure = Figure::new(
        "Cylinder under dry friction, pressure of 3.37",
        Axis::log10("velocity ratio ε = v/(ωR)"),
        Axis::linear("").range(0.0, 1.05),
    )
    .series(Series::line("force F", points(&rows, 0, 1)))
    .series(Series::line("torque T", points(&rows, 0, 2)))
    .series(Series::line("lateral F⊥ = 2G", points(&rows, 0, 3)))
    .series(Series::line("product F F⊥", points(&rows, 0, 4)))
    .legend(Legend::Below);
    let mut claims = limits(&dry);
    claims.extend(product(&dry));
    claims.extend(direct_integration(&dry)?);
    claims.extend(cylinder(&dry)?);
    claims.extend(sideways(&dry)?);
    claims.push(other_exponents()?);
    claims.push(flat_disk()?);
    Ok(Exhibit::new(
        TEXT.prose(),
        figure,
        &["ratio", "force", "torque", "lateral", "product"],
        rows,
        claims,
    ))
}

/// F⊥ at the ends.
fn limits(dry: &DiskTable64) -> Vec<Claim> {
    let rounding = 4.0 * f64::EPSILON;
    let far = 1e9;
    vec![
        Claim::stated(
            TEXT.said("side-at-zero"),
            ("2/3", 2.0 / 3.0),
            lateral(dry, 0.0),
            Allowance::Exact(rounding),
        ),
        Claim::stated(
            TEXT.said("side-at-infinity"),
            ("0", 0.0),
            2.0 * dry.lateral(1.0, 0.0),
            Allowance::Exact(0.0),
        ),
        Claim::own(TEXT.said("tail"), far * lateral(dry, far), 0.5, rounding),
    ]
}

/// The red curve.
fn product(dry: &DiskTable64) -> Vec<Claim> {
    let height = |ratio: f64| at(dry, ratio)[0] * lateral(dry, ratio);
    let peak = linear(0.5, 1.5, 100_000)
        .into_iter()
        .map(|ratio| (height(ratio), ratio))
        .fold((0.0, 0.0), |a, b| if b.0 > a.0 { b } else { a });
    let (slow, fast) = (height(1e-9), height(1e9));
    vec![
        Claim::trend(
            TEXT.said("vanishes"),
            format!("F F⊥ = {slow:.1e} at 1e-9, {fast:.1e} at 1e9"),
            slow < 1e-9 && fast < 1e-9,
        ),
        Claim::own(TEXT.said("largest"), peak.0, 0.387_763_697_824_766_9, 1e-10),
        Claim::own(
            TEXT.said("place-of-largest"),
            peak.1,
            0.921_964_425_271_233_1,
            1e-5,
        ),
    ]
}

/// Pressure 1 + l·r on a unit disk at unit load and coefficient, integrated over its points.
fn integrated(ratio: f64, lean: [f64; 2]) -> Result<Wrench<f64>> {
    let foot = foot(lean)?;
    let friction = NodeFriction::new(CoulombLaw::new(1.0)?, &foot);
    Ok(friction.wrench(1.0, &Twist::new(ratio, 0.0, 1.0)))
}

fn foot(lean: [f64; 2]) -> Result<NodeList<f64, NODES>> {
    let rule = PolarQuadrature::new(1.0, RINGS, ANGLES)?;
    Ok(rule.nodes_tilted(lean[0], lean[1])?)
}

/// 3.37 integrated over the contact.
fn direct_integration(dry: &DiskTable64) -> Result<Vec<Claim>> {
    let [mut force, mut torque, mut side] = [0.0_f64; 3];
    for ratio in geometric(0.05, 20.0, 24) {
        let wrench = integrated(ratio, [LEAN, 0.0])?;
        let [f, t] = at(dry, ratio);
        force = force.max((-wrench.force.x - f).abs());
        torque = torque.max((-wrench.torque - t).abs());
        // The lean counts the pressure's gradient: l G is the lateral force.
        let lateral = LEAN * dry.lateral(ratio, 1.0);
        side = side.max((-wrench.force.y - lateral).abs());
    }
    let moment: f64 = {
        let foot = foot([LEAN, 0.0])?;
        let sum: f64 = foot.nodes().iter().map(|node| node.weight * node.x).sum();
        sum / foot.total_weight()
    };
    Ok(vec![
        Claim::formula(TEXT.said("same-force"), force, NODE_ERROR),
        Claim::formula(TEXT.said("same-torque"), torque, NODE_ERROR),
        Claim::own_statement(
            TEXT.said("closed-form"),
            format!("deviation {side:.1e} at most, 0.05 ≤ ε ≤ 20"),
            side <= NODE_ERROR,
        ),
        Claim::formula(TEXT.said("moment"), (moment - LEAN / 4.0).abs(), 1e-14),
    ])
}

/// μ, R and H of a cylinder, and its wrench under unit load.
fn tall<L: PressureGradient>(
    dry: &DiskTable64,
    [mu, radius, height]: [f64; 3],
    twist: &Twist<f64>,
) -> Result<LoadTransferWrench<f64>> {
    let foot = RoundFriction::new(dry, mu, radius)?;
    let body = LoadTransferFriction::<_, _, L>::new(foot, height / 2.0)?;
    Ok(body.wrench(1.0, twist))
}

/// 3.38 with dimensions, and its sign.
fn cylinder(dry: &DiskTable64) -> Result<Vec<Claim>> {
    let [mu, radius, height] = [0.2, 0.04, 0.06];
    let wrench = |spin: f64| {
        let twist = Twist::new(1.0, 0.0, spin);
        tall::<LongitudinalGradient>(dry, [mu, radius, height], &twist)
    };
    let (left, right) = (wrench(25.0)?.wrench, wrench(-25.0)?.wrench);
    let printed = mu * mu * height / radius * at(dry, 1.0)[0] * lateral(dry, 1.0);
    let lifts = |mu: f64| -> Result<bool> {
        // Without spin F = 1, and 2 μ H/R = 1 is the border.
        let twist = Twist::new(1.0, 0.0, 0.0);
        Ok(tall::<LongitudinalGradient>(dry, [mu, 1.0, 1.0], &twist)?.is_lifting)
    };
    let border = (lifts(0.499)?, lifts(0.501)?);
    Ok(vec![
        Claim::formula(
            TEXT.said("magnitude"),
            (-left.force.y / printed - 1.0).abs(),
            1e-14,
        ),
        Claim::trend(
            TEXT.said("side"),
            format!("{:.4} and {:.4} to the left", left.force.y, right.force.y),
            left.force.y < 0.0 && right.force.y == -left.force.y,
        ),
        Claim::own_statement(
            TEXT.said("lifting"),
            "loaded everywhere at 0.998, lifts at 1.002",
            border == (false, true),
        ),
    ])
}

/// What 3.37 leaves out.
fn sideways(dry: &DiskTable64) -> Result<Vec<Claim>> {
    let (mut largest, mut deviation) = ([(0.0_f64, 0.0); 2], 0.0_f64);
    for ratio in geometric(0.05, 20.0, 24) {
        let (wrench, lean) = FullGradient::balance(dry, [ratio, 1.0], LEAN);
        let changes = [
            wrench.force / at(dry, ratio)[0] - 1.0,
            wrench.torque / at(dry, ratio)[1] - 1.0,
        ];
        for (most, change) in largest.iter_mut().zip(changes) {
            if change.abs() > most.0.abs() {
                *most = (change, ratio);
            }
        }
        let direct = integrated(ratio, lean)?;
        let [force, side] = [-direct.force.x, -direct.force.y];
        // The pressure that the balance names makes the forces that call for it.
        for (ours, theirs) in [
            (wrench.force, force),
            (wrench.lateral, side),
            (wrench.torque, -direct.torque),
            (lean[0], LEAN * force),
            (lean[1], LEAN * side),
        ] {
            deviation = deviation.max((ours - theirs).abs());
        }
    }
    let [force, torque] = largest;
    Ok(vec![Claim::own_statement(
        TEXT.said("sideways"),
        format!(
            "F {:+.1} % at ε = {:.2}, T {:+.1} % at ε = {:.2}; deviation {deviation:.1e}",
            100.0 * force.0,
            force.1,
            100.0 * torque.0,
            torque.1
        ),
        deviation < NODE_ERROR,
    )])
}

/// The plastic disk of section 3.2.2, on its way to rest.
fn flat_disk() -> Result<Claim> {
    /// Coefficient and the share of the way that is small: ours; radius and height in m.
    const MU: f64 = 0.3;
    const SMALL: f64 = 0.03;
    const SIZE: [f64; 2] = [0.08, 0.02];
    let [radius, height] = SIZE;
    let disk = TallCylinder {
        height,
        ..TallCylinder::solid(MU, radius)
    };
    let body = disk.body(9.81)?;
    let mut most = 0.0_f64;
    for speed in [0.5, 1.0, 1.5] {
        for share in [0.25, 1.0, 4.0] {
            let launch = Launch {
                velocity: [speed, 0.0],
                spin: share * speed / radius,
            };
            let rest = PlanarSimulation::new(&body, &launch, 1e-6)?.to_end()?.point;
            most = most.max((rest.position[1] / rest.position[0]).abs());
        }
    }
    Ok(Claim::trend(
        TEXT.said("disk").with("mu", MU),
        format!("{:.1} % of the way at most", 100.0 * most),
        most < SMALL,
    ))
}

/// "For other friction than α = 0".
fn other_exponents() -> Result<Claim> {
    let exponents = [-0.5, 0.5, 1.0, 2.0, 3.0];
    let mut holds = true;
    for alpha in exponents {
        let table = table(alpha)?;
        holds &= (lateral(&table, 0.0) / at(&table, 0.0)[1] - 1.0).abs() < 1e-14;
        holds &= geometric(1e-3, 1e3, 100)
            .into_iter()
            .all(|ratio| lateral(&table, ratio) > 0.0);
    }
    Ok(Claim::trend(
        TEXT.said("other-exponents"),
        "positive, and F⊥(0) = T(0), for α = 0.5, 1, 2, 3 and for −0.5",
        holds,
    ))
}
