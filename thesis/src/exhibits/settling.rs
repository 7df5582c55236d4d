//! Section 4.1: powders of small grains settle to a porous filling, coarse ones to a dense one.

use crate::exhibit::{Exhibit, points};
use crate::runs::{Case, Effort, Run, Runs, System};
use crate::text::Text;
use anyhow::Result;
use std::f64::consts::PI;
use tribos::bracket::Bracket;
use tribos::powder::PowderStopReason;
use tribos::scene::BlockedCriterion;
use tribos_report::claim::Claim;
use tribos_report::figure::{Axis, Figure, Panels, ReferenceLine, Series};

const TEXT: Text = Text(include_str!("section-4.1.md"));

/// Hamaker's constant of oxides, in J, and the distance of closest approach, in m (Israelachvili,
/// Intermolecular and Surface Forces).
const HAMAKER: f64 = 1e-19;
const CLOSEST: f64 = 0.165e-9;
/// Radius of the asperities at which rough grains touch, in m.
const ASPERITY: f64 = 1e-7;
/// Density of quartz, in kg/m³, and gravity, in m/s².
const DENSITY: f64 = 2650.0;
const GRAVITY: f64 = 9.81;
/// Surface tension of water, in N/m, and the thermal energy at 20 °C, in J.
const TENSION: f64 = 0.073;
const THERMAL: f64 = 4.05e-21;

/// Diameters, in m.
const QUICK: [f64; 4] = [3e-6, 3e-5, 1e-4, 1e-3];
const FULL: [f64; 9] = [1e-6, 3e-6, 1e-5, 3e-5, 6e-5, 1e-4, 2e-4, 3e-4, 1e-3];
/// Deposits of each diameter.
const FULL_SEEDS: u64 = 3;
/// Fine powders of the thesis are below this diameter, in m.
const FINE: f64 = 1e-5;
/// Steps that a grain needs to fall by its radius from rest, over √2.
const STEPS: f64 = 50.0;
/// Rolling and torsion coefficients of rough grains.
const TORQUES: [f64; 2] = [0.3, 0.3];
/// A bound for what never comes to rest.
const MOST_STEPS: u64 = 20_000;

/// Attraction of two rough grains, in N: of an asperity to a flat, or of smooth grains if they are smaller.
pub fn attraction(diameter: f64) -> f64 {
    HAMAKER * ASPERITY.min(0.25 * diameter) / (6.0 * CLOSEST * CLOSEST)
}

/// Weight of a grain, in N.
pub fn weight(diameter: f64) -> f64 {
    PI / 6.0 * diameter.powi(3) * DENSITY * GRAVITY
}

/// Attraction over weight.
fn bond(diameter: f64) -> f64 {
    attraction(diameter) / weight(diameter)
}

/// A deposit under gravity and a lid of one grain's mass, in the units of the scene.
fn case(system: System, diameter: f64, seed: u64) -> Case {
    /// Mass of a grain of radius 1 and density 1.
    const GRAIN: f64 = 4.0 / 3.0 * PI;
    let gravity = 1.0 / (GRAIN * bond(diameter));
    let [width, _] = system.size();
    Case::new(system, TORQUES, seed).with(&format!("diameter={diameter}"), |scene| {
        scene.gravity = gravity;
        scene.blocked_criterion = BlockedCriterion::Piston;
        scene.piston_mass = GRAIN;
        scene.pressure = GRAIN * gravity / (width * width);
        scene.cohesion_range = 2.0 * CLOSEST / diameter;
        scene.max_time_step = 1.0 / (STEPS * gravity.sqrt());
        scene.max_steps = MOST_STEPS;
    })
}

/// Porosity over the size of the grains.
pub fn section_4_1(runs: &Runs) -> Result<Exhibit> {
    let (system, diameters, seeds) = match runs.effort() {
        Effort::Quick => (System::Tiny, &QUICK[..], 1),
        Effort::Full => (System::Small, &FULL[..], FULL_SEEDS),
    };
    let of = |&diameter: &f64| (1..=seeds).map(move |seed| case(system, diameter, seed));
    let done = runs.of(&diameters.iter().flat_map(of).collect::<Vec<_>>())?;
    let porosity = |run: &Run| run.outcome.porosity_final;
    let groups = done.chunks(seeds as usize);
    let rows: Vec<Vec<f64>> = diameters
        .iter()
        .zip(groups)
        .map(|(&diameter, runs)| {
            let mean = |of: &dyn Fn(&Run) -> f64| {
                runs.iter().map(|run| of(run)).sum::<f64>() / seeds as f64
            };
            vec![
                1e6 * diameter,
                bond(diameter),
                mean(&|run| run.outcome.porosity_initial),
                mean(&porosity),
            ]
        })
        .collect();
    let ends = [
        done.iter()
            .filter(|run| run.outcome.ending == Some(PowderStopReason::Blocked))
            .count(),
        done.len(),
    ];
    Ok(Exhibit::new(
        TEXT.prose_of(runs.effort()).with(
            "spheres",
            done.first().map_or(0, |run| run.outcome.particles),
        ),
        figure(&rows),
        &["diameter_um", "bond", "porosity_initial", "porosity_final"],
        rows.clone(),
        [filling_claims(&rows, ends), force_claims()].concat(),
    )
    .seeded(1..=seeds))
}

fn figure(rows: &[Vec<f64>]) -> Panels {
    let diameter = || Axis::log10("diameter [µm]");
    let filling = Figure::new(
        "Filling under gravity",
        diameter(),
        Axis::linear("porosity").range(0.3, 1.0),
    )
    .series(Series::line_points("settled", points(rows, 0, 3)))
    .series(Series::points("deposit", points(rows, 0, 2)))
    .guide(ReferenceLine::vertical(1e6 * FINE, "fine"));
    let force = Figure::new(
        "Attraction over weight",
        diameter(),
        Axis::log10("F_coh/(m g)"),
    )
    .series(Series::line_points("rough grains", points(rows, 0, 1)))
    .guide(ReferenceLine::horizontal(1.0, ""));
    Panels::new("", 2).figure(filling).figure(force)
}

/// What the fillings do.
fn filling_claims(rows: &[Vec<f64>], [blocked, all]: [usize; 2]) -> Vec<Claim> {
    let fine = rows
        .iter()
        .filter(|row| row[0] <= 1e6 * FINE)
        .map(|row| row[3]);
    let fine = fine.fold(f64::INFINITY, f64::min);
    let coarse = rows.last().map_or(f64::NAN, |row| row[3]);
    let list: Vec<String> = rows
        .iter()
        .map(|row| format!("{:.0} % at {} µm", 100.0 * row[3], row[0].round()))
        .collect();
    vec![
        Claim::trend(
            TEXT.said("size"),
            list.join(", "),
            rows.windows(2).all(|pair| pair[1][3] < pair[0][3] + 0.01) && coarse < fine - 0.2,
        ),
        Claim::trend(
            TEXT.said("fine"),
            format!("{:.1} % and more", 100.0 * fine),
            fine > 0.9,
        )
        .printed("90 %"),
        Claim::trend(
            TEXT.said("coarse"),
            format!("{:.1} %", 100.0 * coarse),
            coarse < 0.6,
        ),
        Claim::own_statement(
            TEXT.said("rest"),
            format!("{blocked} of {all}"),
            blocked == all,
        ),
    ]
}

/// Scales of forces and energies that the section names.
fn force_claims() -> Vec<Claim> {
    let sand = 1e-4;
    let mass = weight(sand) / GRAVITY;
    let orders = |energy: f64| (energy / THERMAL).log10();
    let raised = orders(weight(sand) * sand);
    let moving = orders(0.5 * mass * 1e-2_f64.powi(2));
    // Of two equal spheres that water joins: 2πγR.
    let capillary = |diameter: f64| PI * TENSION * diameter / weight(diameter);
    let reach = (TENSION * 6.0 / (100.0 * DENSITY * GRAVITY)).sqrt();
    let unity = [1e-6, 1e-2].map(f64::ln);
    let crossing = bisect(unity, |log| bond(log.exp()).ln()).exp();
    vec![
        Claim::trend(
            TEXT.said("vdw"),
            format!("{:.0} at 10 µm; 1 at {:.0} µm", bond(FINE), 1e6 * crossing),
            bond(FINE) > 1e2 && crossing > FINE,
        )
        .printed("10 µm"),
        Claim::trend(
            TEXT.said("wet"),
            format!(
                "{:.0} at 250 µm; 100 at {:.0} µm",
                capillary(2.5e-4),
                1e6 * reach
            ),
            capillary(2.5e-4) > 1e2,
        ),
        Claim::trend(
            TEXT.said("thermal-height"),
            format!("10^{raised:.1}"),
            (raised - 9.0).abs() < 0.5,
        )
        .printed("9"),
        Claim::refutation(
            TEXT.said("thermal-speed"),
            format!("10^{moving:.1}"),
            moving < 8.0 && moving > 6.0,
        )
        .printed("9"),
    ]
}

/// Zero of a function that falls.
fn bisect([low, high]: [f64; 2], of: impl Fn(f64) -> f64) -> f64 {
    let has_fallen = |x: f64| of(x) <= 0.0;
    Bracket::new(low, high).halved(60, has_fallen).middle()
}
