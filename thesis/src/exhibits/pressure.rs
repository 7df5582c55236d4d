//! Section 5.1: what a radial pressure does to force and torque.

use crate::exhibit::{Exhibit, geometric, points, table};
use crate::text::Text;
use anyhow::Result;
use std::f64::consts::PI;
use tribos_core::coupling::nodes::NodeFriction;
use tribos_core::coupling::{ReducedFriction, ReducedWrench, round::RoundTable64};
use tribos_core::law::PowerLaw;
use tribos_core::patch::PowerPressure;
use tribos_core::patch::nodes::NodeList;
use tribos_core::patch::polar::PolarQuadrature;
use tribos_core::twist::Twist;
use tribos_report::claim::Claim;
use tribos_report::figure::{Axis, Figure, Legend, Panels, Series};

const TEXT: Text = Text(include_str!("section-5.1.md"));

/// A name and a pressure (1−r²)^q, from the rim inwards.
pub const PRESSURES: [(&str, PowerPressure); 5] = [
    ("ring", PowerPressure::RING),
    ("flat punch", PowerPressure::FLAT_PUNCH),
    ("uniform", PowerPressure::UNIFORM),
    ("Hertz", PowerPressure::HERTZ),
    ("paraboloid", PowerPressure::PARABOLOID),
];
/// Places in [`PRESSURES`].
const RING: usize = 0;
const PUNCH: usize = 1;
const UNIFORM: usize = 2;
const HERTZ: usize = 3;
const PARABOLOID: usize = 4;

const ROUNDING: f64 = 4.0 * f64::EPSILON;

/// Force and torque of each pressure.
struct Tables([RoundTable64; 5]);

impl Tables {
    fn new() -> Result<Self> {
        let dry = |(_, pressure)| RoundTable64::new(0.0, pressure);
        let [ring, punch, uniform, hertz, paraboloid] = PRESSURES.map(dry);
        Ok(Self([ring?, punch?, uniform?, hertz?, paraboloid?]))
    }

    /// F and T at ε with ωR = 1.
    fn at(&self, pressure: usize, ratio: f64) -> [f64; 2] {
        let ReducedWrench { force, torque } = self.0[pressure].reduced_wrench(ratio, 1.0);
        [force, torque]
    }
}

/// F and T for five pressures.
pub fn section_5_1() -> Result<Exhibit> {
    let tables = Tables::new()?;
    let rows: Vec<Vec<f64>> = geometric(1e-2, 1e2, 400)
        .into_iter()
        .map(|ratio| {
            let pairs = (0..PRESSURES.len()).flat_map(|i| tables.at(i, ratio));
            std::iter::once(ratio).chain(pairs).collect()
        })
        .collect();
    let panel = |title: &str, top: f64, first: usize| {
        let empty = Figure::new(
            title,
            Axis::log10("velocity ratio ε = v/(ωR)"),
            Axis::linear("").range(0.0, top),
        )
        .legend(Legend::Below);
        PRESSURES.iter().enumerate().fold(empty, |figure, (i, p)| {
            figure.series(Series::line(p.0, points(&rows, 0, first + 2 * i)))
        })
    };
    let panels = Panels::new("", 2)
        .figure(panel("Force F, α = 0", 1.05, 1))
        .figure(panel("Torque T, α = 0", 1.05, 2))
        .cell(520, 420);
    let mut claims = force(&tables, &rows);
    claims.extend(torque(&tables));
    claims.push(lateral()?);
    claims.extend(conclusions()?);
    Ok(Exhibit::new(
        TEXT.prose(),
        panels,
        &[
            "ratio",
            "ring_force",
            "ring_torque",
            "punch_force",
            "punch_torque",
            "uniform_force",
            "uniform_torque",
            "hertz_force",
            "hertz_torque",
            "paraboloid_force",
            "paraboloid_torque",
        ],
        rows,
        claims,
    ))
}

/// What the force does.
fn force(tables: &Tables, rows: &[Vec<f64>]) -> Vec<Claim> {
    let at_one = PRESSURES.iter().enumerate();
    let shown: Vec<String> = at_one
        .map(|(i, p)| format!("{} {:.4}", p.0, tables.at(i, 1.0)[0]))
        .collect();
    let differ = (tables.at(HERTZ, 1.0)[0] - tables.at(UNIFORM, 1.0)[0]).abs() > 0.03;
    let slope = tables.0[HERTZ].reduced_jacobian(0.0, 1.0).force_slide;
    let ends = (0..PRESSURES.len()).all(|i| {
        let fast = tables.0[i].reduced_wrench(1.0, 0.0);
        tables.at(i, 0.0)[0] == 0.0 && (fast.force - 1.0).abs() <= ROUNDING && fast.torque == 0.0
    });
    let alike = rows.windows(2).all(|w| {
        (0..PRESSURES.len()).all(|i| {
            let [force, torque] = [1 + 2 * i, 2 + 2 * i];
            w[1][force] > w[0][force] && w[1][torque] < w[0][torque]
        })
    });
    vec![
        Claim::refutation(
            TEXT.said("force-unaltered"),
            format!("F(1): {}", shown.join(", ")),
            differ,
        ),
        Claim::own(
            TEXT.said("hertz-force"),
            tables.at(HERTZ, 1.0)[0],
            9.0 * PI / 32.0,
            ROUNDING,
        ),
        Claim::own(TEXT.said("hertz-slope"), slope, 3.0 * PI / 8.0, ROUNDING),
        Claim::trend(
            TEXT.said("ends"),
            "T(∞) = 0, F(0) = 0 and F(∞) = 1 for all five",
            ends,
        ),
        Claim::trend(
            TEXT.said("alike"),
            format!("F rises and T falls at {} ratios for all five", rows.len()),
            alike,
        ),
    ]
}

/// What the torque does.
fn torque(tables: &Tables) -> Vec<Claim> {
    let rest = |i: usize| tables.at(i, 0.0)[1];
    let known = [
        (RING, "1", 1.0),
        (PUNCH, "π/4", PI / 4.0),
        (UNIFORM, "2/3", 2.0 / 3.0),
        (HERTZ, "3π/16", 3.0 * PI / 16.0),
        (PARABOLOID, "8/15", 8.0 / 15.0),
    ];
    let ordered = rest(RING) > rest(PUNCH)
        && rest(PUNCH) > rest(UNIFORM)
        && rest(UNIFORM) > rest(HERTZ)
        && rest(HERTZ) > rest(PARABOLOID);
    let mut claims = vec![Claim::trend(
        TEXT.said("torque-order"),
        "ring > punch > uniform > Hertz > paraboloid",
        ordered,
    )];
    for (i, text, value) in known {
        claims.push(Claim::own(
            TEXT.said("torque-at-zero")
                .with("pressure", PRESSURES[i].0)
                .with("formula", text),
            rest(i),
            value,
            ROUNDING,
        ));
    }
    let far = 1e9;
    let tails = PRESSURES.iter().enumerate().map(|(i, (_, pressure))| {
        (2.0 * far * tables.at(i, far)[1] / pressure.mean_square_radius() - 1.0).abs()
    });
    let deviation = tails.fold(0.0, f64::max);
    claims.push(Claim::own_statement(
        TEXT.said("tails"),
        format!("deviation {deviation:.1e} at most, relative, at ε = 1e9"),
        deviation <= ROUNDING,
    ));
    claims
}

/// Sections 3.5 and 3.6: the lateral force of a symmetric pressure.
fn lateral() -> Result<Claim> {
    /// Of sums over 512 nodes, relative.
    const ROUNDING_OF_SUM: f64 = 1e-14;
    let mut largest = 0.0_f64;
    // The rule's nodes lie inside: the ring is left out.
    for (_, pressure) in PRESSURES.into_iter().skip(1) {
        let rule = PolarQuadrature::standard(1.0)
            .and_then(|rule| rule.with_rim_exponent(pressure.order()))?;
        let foot: NodeList<f64, { PolarQuadrature::<f64>::STANDARD_NODES }> = rule.nodes()?;
        for alpha in [-0.5, 0.0, 0.5, 1.0, 3.0] {
            let law = PowerLaw::new(alpha, 1.0)?;
            let friction = NodeFriction::new(law, &foot);
            for ratio in geometric(0.1, 10.0, 8) {
                let force = friction.wrench(1.0, &Twist::new(ratio, 0.0, 1.0)).force;
                largest = largest.max((force.y / force.x).abs());
            }
        }
    }
    Ok(Claim::refutation(
        TEXT.said("lateral"),
        format!(
            "at most {largest:.1e} of the force, by integration of four pressures, α = −0.5 to 3"
        ),
        largest < ROUNDING_OF_SUM,
    ))
}

/// The rest of section 5.1.
fn conclusions() -> Result<Vec<Claim>> {
    // F and T without the other motion.
    let coupled = |alpha: f64| -> Result<Vec<[f64; 2]>> {
        let table = table(alpha)?;
        let shares = geometric(1e-2, 1e2, 100).into_iter().map(|ratio| {
            let ReducedWrench { force, torque } = table.reduced_wrench(ratio, 1.0);
            let alone = [
                table.reduced_wrench(ratio, 0.0).force,
                table.reduced_wrench(0.0, 1.0).torque,
            ];
            [force / alone[0], torque / alone[1]]
        });
        Ok(shares.collect())
    };
    let (mut less, mut more) = (true, true);
    for alpha in [0.0, 0.25, 0.5, 0.75] {
        less &= coupled(alpha)?.iter().flatten().all(|&share| share < 1.0);
    }
    for alpha in [1.5, 2.0, 3.0] {
        more &= coupled(alpha)?.iter().flatten().all(|&share| share > 1.0);
    }
    let largest = |alpha: f64| -> Result<f64> {
        let shares = coupled(alpha)?;
        let changes = shares.iter().flatten().map(|share| (share - 1.0).abs());
        Ok(changes.fold(0.0, f64::max))
    };
    let mut least = f64::INFINITY;
    for alpha in [-0.5, 0.0, 0.5, 0.9, 0.99, 1.01, 1.1, 2.0, 3.0] {
        least = least.min(largest(alpha)?);
    }
    let linear = largest(1.0)?;
    let dry = table(0.0)?;
    let ReducedWrench { force, torque } = dry.reduced_wrench(1.0, 1.0);
    let power = (1.0 + 2.0 / 3.0) / (force + torque);
    Ok(vec![
        Claim::trend(
            TEXT.said("coupling"),
            "seven exponents from 0 to 3 at 101 ratios",
            less && more,
        ),
        Claim::trend(
            TEXT.said("only-linear"),
            format!("α = 1: {linear:.1e}; nine others from −0.5 to 3: {least:.1e} or more"),
            linear <= ROUNDING && least > 1e-3,
        ),
        Claim::trend(
            TEXT.said("powders"),
            format!(
                "{:.0} % of the power at ε = 1, α = 0",
                100.0 * (power - 1.0)
            ),
            (1.3..=1.5).contains(&power),
        )
        .printed("30 % – 50 %"),
    ])
}
