//! Section 5.3: tips of copper, as in the simulations of others.

use super::tip_runs::{Row, RunResult, SEEDS, STROKES, all};
use crate::exhibit::Exhibit;
use crate::runs::{Effort, Runs};
use crate::text::Text;
use anyhow::Result;
use tribos::scene::{DriveKind, DrivenHold, TipScene};
use tribos::statistics::mean_and_error;
use tribos::tip::{CrystalFace, SlidingSummary, TipPotential};
use tribos_report::claim::Claim;
use tribos_report::figure::{Axis, Figure, Panels, Series};

const TEXT: Text = Text(include_str!("section-5.3-metals.md"));

/// Faces of substrate and tip, and the angle between their close-packed rows.
const FACES: [(&str, CrystalFace, f64); 3] = [
    ("(111) in registry", CrystalFace::Fcc111, 0.0),
    ("(111) turned by 30°", CrystalFace::Fcc111, 30.0),
    ("(100) in registry", CrystalFace::Fcc100, 0.0),
];
/// 1 eV/Å in nN.
const NANONEWTON: f64 = 1.602_176_634;

fn row(
    effort: Effort,
    potential: &TipPotential,
    (_, face, orientation): (&str, CrystalFace, f64),
) -> Row {
    // Å/ps, spacings.
    let (speed, spacings) = match effort {
        Effort::Quick => (0.8, 2.0),
        Effort::Full => (0.2, 4.0),
    };
    let scene = TipScene {
        potential: potential.clone(),
        lattice_expansion: 0.005,
        face,
        tip_face: face,
        tip_orientation: orientation,
        drive: DriveKind::Slide,
        speed: Some(speed),
        stiffness: 3.0,
        driven_constraint: DrivenHold::Level,
        load: Some(0.05),
        drive_damping_rate: 2.0,
        substrate_columns: 6,
        substrate_rows: 8,
        substrate_layers: 4,
        tip_layers: 4,
        tip_side_atoms: 2,
        temperature: 300.0,
        time_step: 0.004,
        skin: 0.6,
        equilibration: 2.0,
        rest_time: 0.0,
        ..TipScene::default()
    };
    let stroke = spacings * scene.spacings()[0];
    let name = format!("copper,{},orientation={orientation}", face);
    Row {
        name,
        scene: TipScene {
            stroke: Some(stroke),
            drive_time: STROKES * stroke / speed,
            ..scene
        },
    }
}

/// Friction of copper on copper.
pub fn section_5_3_metals(runs: &Runs) -> Result<Exhibit> {
    let potential: TipPotential = "sutton-chen:Cu".parse()?;
    let rows: Vec<Row> = FACES
        .into_iter()
        .map(|faces| row(runs.effort(), &potential, faces))
        .collect();
    let ran = all(runs, &rows)?;
    let mut loops = Panels::new("", 3).cell(366, 340);
    for ((name, ..), ran) in FACES.iter().zip(&ran) {
        let force = Axis::linear("lateral force [nN]");
        let mut figure = Figure::new(*name, Axis::linear("support [Å]"), force);
        if let Some(first) = ran.first() {
            let curve = first.curve("support", "lateral_force").into_iter();
            let curve = curve.map(|(x, force)| (x, NANONEWTON * force)).collect();
            figure = figure.series(Series::line("", curve));
        }
        loops = loops.figure(figure);
    }
    let numbers = ran.iter().enumerate().map(|(number, ran)| {
        let [friction, normal, period] = [
            of(ran, |slid| NANONEWTON * slid.friction),
            of(ran, |slid| NANONEWTON * slid.normal_force),
            of(ran, |slid| slid.period),
        ];
        [&[number as f64][..], &friction, &normal, &period].concat()
    });
    Ok(Exhibit::new(
        TEXT.prose_of(runs.effort()),
        loops,
        &[
            "row",
            "friction_nN",
            "friction_error",
            "normal_force_nN",
            "normal_force_error",
            "period_angstrom",
            "period_error",
        ],
        numbers.collect(),
        claims(&ran)
            .into_iter()
            .map(|claim| claim.uncertain(format!("{SEEDS} seeds a row")))
            .collect(),
    )
    .seeded(1..=SEEDS))
}

fn slid(ran: &[RunResult]) -> Vec<SlidingSummary> {
    ran.iter().filter_map(|ran| ran.outcome.slid).collect()
}

fn of(ran: &[RunResult], number: fn(&SlidingSummary) -> f64) -> [f64; 2] {
    mean_and_error(&slid(ran).iter().map(number).collect::<Vec<_>>())
}

fn claims(ran: &[Vec<RunResult>]) -> Vec<Claim> {
    let words = |(number, ran): (usize, &Vec<RunResult>)| {
        let [friction, error] = of(ran, |slid| NANONEWTON * slid.friction);
        let [normal, _] = of(ran, |slid| NANONEWTON * slid.normal_force);
        let slips: usize = slid(ran).iter().map(|slid| slid.slips).sum();
        format!(
            "{}: {friction:.2} ± {error:.2} nN under {normal:.1} nN, {slips} slips",
            FACES[number].0
        )
    };
    let frictions: Vec<String> = ran.iter().enumerate().map(words).collect();
    let registry = [0, 2].map(|number| slid(&ran[number]));
    let with = registry
        .iter()
        .filter(|all| all.iter().any(|slid| slid.slips > 0));
    let every: Vec<SlidingSummary> = ran.iter().flat_map(|ran| slid(ran)).collect();
    let balance = every
        .iter()
        .map(|slid| slid.imbalance.abs())
        .fold(0.0, f64::max);
    let [mean, [turned, _]] = [0, 1].map(|number| of(&ran[number], |slid| slid.friction));
    vec![
        Claim::trend(
            TEXT.said("slips"),
            format!("slips on {} of 2 faces in registry", with.clone().count()),
            with.count() == 2,
        ),
        Claim::not_checkable(
            TEXT.said("frictions")
                .with("frictions", frictions.join("; ")),
        ),
        Claim::not_checkable(
            TEXT.said("registry")
                .with("ratio", format!("{:.2}", turned / mean[0])),
        ),
        Claim::own_statement(
            TEXT.said("heat"),
            format!("{:.2} % of the work at most is missing", 100.0 * balance),
            balance < 0.05,
        ),
    ]
}
