//! Section 5.3: which torque turns a tip for good, over load and temperature.

use super::tip_runs::{Row, RunResult, SEEDS, all};
use crate::exhibit::Exhibit;
use crate::runs::{Effort, Runs};
use crate::text::Text;
use anyhow::Result;
use tribos::scene::{DrivenHold, TipScene};
use tribos::statistics::mean as mean_of;
use tribos::tip::Reversal;
use tribos_report::claim::Claim;
use tribos_report::figure::{Axis, Figure, Panels, Series};

const TEXT: Text = Text(include_str!("section-5.3-map.md"));

/// Loads on a driven atom, temperatures and strengths of the torque of each effort.
const LOADS: [&[f64]; 2] = [&[0.0, 2.0], &[0.0, 1.0, 2.0]];
const TEMPERATURES: [&[f64]; 2] = [&[0.02, 0.3], &[0.02, 0.1, 0.3]];
const STRENGTHS: [&[f64]; 2] = [&[0.1, 0.2, 0.3], &[0.02, 0.04, 0.06, 0.08, 0.12]];

fn scene(effort: Effort, [load, temperature, lambda]: [f64; 3]) -> TipScene {
    let small = TipScene {
        lambda,
        load: Some(load),
        temperature,
        driven_constraint: DrivenHold::Level,
        time_step: 0.01,
        substrate_columns: 8,
        substrate_rows: 10,
        substrate_layers: 4,
        tip_layers: 4,
        tip_side_atoms: 3,
        equilibration: 5.0,
        drive_time: 15.0,
        rest_time: 20.0,
        ..TipScene::default()
    };
    match effort {
        Effort::Quick => small,
        Effort::Full => TipScene {
            substrate_columns: 16,
            substrate_rows: 18,
            substrate_layers: 6,
            tip_layers: 6,
            tip_side_atoms: 6,
            equilibration: 20.0,
            drive_time: 100.0,
            rest_time: 50.0,
            ..small
        },
    }
}

/// A load and a temperature, with the runs of each strength.
struct Cell {
    load: f64,
    temperature: f64,
    /// Strength, share of the seeds that turned back, mean angle while driven.
    shares: Vec<[f64; 3]>,
}

fn share(lambda: f64, ran: &[RunResult]) -> [f64; 3] {
    let back = ran
        .iter()
        .filter(|ran| ran.outcome.verdict == Reversal::Reversible);
    let angles = ran.iter().map(|ran| ran.outcome.driven_angle_degrees.abs());
    let count = ran.len() as f64;
    [
        lambda,
        back.count() as f64 / count,
        angles.sum::<f64>() / count,
    ]
}

impl Cell {
    /// Sum of the shares: how far up the strengths the tip turns back.
    fn strength(&self) -> f64 {
        self.shares.iter().map(|[_, share, _]| share).sum()
    }
}

/// The map.
pub fn section_5_3_map(runs: &Runs) -> Result<Exhibit> {
    let which = usize::from(runs.effort() == Effort::Full);
    let (loads, heats, strengths) = (LOADS[which], TEMPERATURES[which], STRENGTHS[which]);
    let corners: Vec<[f64; 2]> = loads
        .iter()
        .flat_map(|&load| heats.iter().map(move |&heat| [load, heat]))
        .collect();
    let at = |&[load, heat]: &[f64; 2]| strengths.iter().map(move |&lambda| [load, heat, lambda]);
    let rows: Vec<Row> = corners
        .iter()
        .flat_map(at)
        .map(|at| {
            let [load, heat, lambda] = at;
            Row {
                name: format!("turned,load={load},temperature={heat},lambda={lambda}"),
                scene: scene(runs.effort(), at),
            }
        })
        .collect();
    let ran = all(runs, &rows)?;
    let cells: Vec<Cell> = corners
        .iter()
        .zip(ran.chunks(strengths.len()))
        .map(|(&[load, temperature], ran)| Cell {
            load,
            temperature,
            shares: strengths
                .iter()
                .zip(ran)
                .map(|(&lambda, ran)| share(lambda, ran))
                .collect(),
        })
        .collect();
    let line = |cell: &Cell| -> Vec<Vec<f64>> {
        let at = [cell.load, cell.temperature];
        cell.shares
            .iter()
            .map(|share| [&at[..], share].concat())
            .collect()
    };
    Ok(Exhibit::new(
        TEXT.prose_of(runs.effort()),
        figure(&cells, loads),
        &[
            "load",
            "temperature",
            "lambda",
            "share_turned_back",
            "driven_angle_degrees",
        ],
        cells.iter().flat_map(line).collect(),
        claims(&cells)
            .into_iter()
            .map(|claim| claim.uncertain(format!("{SEEDS} seeds a point")))
            .collect(),
    )
    .seeded(1..=SEEDS))
}

fn figure(cells: &[Cell], loads: &[f64]) -> Panels {
    let mut panels = Panels::new("", 2);
    for &load in loads {
        let mut figure = Figure::new(
            format!("Load {load} ε/σ a driven atom"),
            Axis::linear("λ [ε/σ²]"),
            Axis::linear("share that turned back").range(0.0, 1.0),
        );
        for cell in cells.iter().filter(|cell| cell.load == load) {
            let curve = cell.shares.iter().map(|[x, y, _]| (*x, *y)).collect();
            let label = format!("T = {}", cell.temperature);
            figure = figure.series(Series::line_points(label, curve));
        }
        panels = panels.figure(figure);
    }
    panels
}

fn claims(cells: &[Cell]) -> Vec<Claim> {
    let both = |cell: &Cell| {
        let [first, last] = [cell.shares.first(), cell.shares.last()];
        matches!((first, last), (Some([_, a, _]), Some([_, b, _])) if a > b)
    };
    let with = cells.iter().filter(|cell| both(cell)).count();
    let words = |cell: &Cell| {
        let shares: Vec<String> = cell
            .shares
            .iter()
            .map(|[lambda, share, _]| format!("{:.0} % at λ = {lambda}", 100.0 * share))
            .collect();
        format!(
            "N = {}, T = {}: {}",
            cell.load,
            cell.temperature,
            shares.join(", ")
        )
    };
    let map: Vec<String> = cells.iter().map(words).collect();
    let mean = |is_of: &dyn Fn(&&Cell) -> bool| {
        let of: Vec<f64> = cells.iter().filter(is_of).map(Cell::strength).collect();
        mean_of(&of)
    };
    let most = |number: fn(&Cell) -> f64| cells.iter().map(number).fold(0.0, f64::max);
    let (load, heat) = (most(|cell| cell.load), most(|cell| cell.temperature));
    let least = cells
        .iter()
        .map(|cell| cell.temperature)
        .fold(f64::INFINITY, f64::min);
    let effects = format!(
        "mean number of strengths that turn back: {:.2} without load, {:.2} under the largest; {:.2} when coldest, {:.2} when hottest",
        mean(&|cell| cell.load == 0.0),
        mean(&|cell| cell.load == load),
        mean(&|cell| cell.temperature == least),
        mean(&|cell| cell.temperature == heat),
    );
    vec![
        Claim::trend(
            TEXT.said("threshold"),
            format!("in {with} of {} cells of the map", cells.len()),
            with > 0,
        ),
        Claim::not_checkable(TEXT.said("load").with("map", map.join("; "))),
        Claim::not_checkable(TEXT.said("effects").with("effects", effects)),
    ]
}
