//! Runs of small tips with several seeds a row, shared by the exhibits on section 5.3.

use crate::runs::{Batch, Effort, Runs};
use anyhow::{Result, anyhow};
use std::num::NonZero;
use std::thread::available_parallelism;
use tribos::run::in_order;
use tribos::scene::TipScene;
use tribos::statistics::mean_and_error;
use tribos::tip::{SlidingSummary, TipSimulation, TipSummary};

/// Runs of each row.
pub(super) const SEEDS: u64 = 5;

/// A row of runs that differ in their seeds.
#[derive(Clone, Debug)]
pub(super) struct Row {
    /// What its folders are named by.
    pub name: String,
    /// The scene, with any seed.
    pub scene: TipScene,
}

/// What a run left.
#[derive(Debug)]
pub(super) struct RunResult {
    /// Its outcome.
    pub outcome: TipSummary,
    /// Names and lines of its series.
    pub columns: Vec<String>,
    pub series: Vec<Vec<f64>>,
}

impl RunResult {
    /// Two columns of the series.
    pub fn curve(&self, x: &str, y: &str) -> Vec<(f64, f64)> {
        let number = |name: &str| self.columns.iter().position(|column| column == name);
        match (number(x), number(y)) {
            (Some(x), Some(y)) => self.series.iter().map(|line| (line[x], line[y])).collect(),
            _ => Vec::new(),
        }
    }
}

/// A row of slid tips with what it is at.
#[derive(Debug)]
pub(super) struct Point {
    pub load: f64,
    pub speed: f64,
    pub temperature: f64,
    pub slid: Vec<Slide>,
}

/// What a slid tip left.
#[derive(Clone, Copy, Debug)]
pub(super) struct Slide {
    pub friction: f64,
    pub normal_force: f64,
    pub period: f64,
    pub imbalance: f64,
    pub loop_work: f64,
}

impl Slide {
    /// Of a run.
    pub fn of(ran: &RunResult) -> Option<Self> {
        let SlidingSummary {
            friction,
            normal_force,
            period,
            imbalance,
            loop_work,
            ..
        } = ran.outcome.slid?;
        Some(Self {
            friction,
            normal_force,
            period,
            imbalance,
            loop_work,
        })
    }
}

impl Point {
    /// Of the runs of a row.
    pub fn new([load, speed, temperature]: [f64; 3], ran: &[RunResult]) -> Self {
        Self {
            load,
            speed,
            temperature,
            slid: ran.iter().filter_map(Slide::of).collect(),
        }
    }

    /// Mean and standard error of a number of the slid tips.
    pub fn of(&self, number: fn(&Slide) -> f64) -> [f64; 2] {
        mean_and_error(&self.slid.iter().map(number).collect::<Vec<_>>())
    }

    pub fn friction(&self) -> [f64; 2] {
        self.of(|slid| slid.friction)
    }
}

/// One seed of a row, and the name of the run.
pub(super) fn one(runs: &Runs, row: &Row, seed: u64) -> Result<(String, RunResult)> {
    let name = format!("{},{},seed={seed}", row.name, runs.effort().name());
    let scene = TipScene {
        seed,
        ..row.scene.clone()
    };
    let folder = runs.kept().run(&name);
    let run: TipSimulation = runs.session(&folder).run(&scene)?;
    let ran = RunResult {
        outcome: run.outcome(),
        columns: run.columns(),
        series: run.series().to_vec(),
    };
    Ok((name, ran))
}

/// All seeds of each row, as many runs at a time as the machine has cores.
pub(super) fn all(runs: &Runs, rows: &[Row]) -> Result<Vec<Vec<RunResult>>> {
    let count = rows.len() * SEEDS as usize;
    let threads = available_parallelism().map_or(1, NonZero::get);
    let batch = Batch::new(count, runs.reader());
    let results = in_order(count, threads, |index| {
        let (name, ran) = one(
            runs,
            &rows[index / SEEDS as usize],
            1 + index as u64 % SEEDS,
        )?;
        batch.tell(&name);
        anyhow::Ok(ran)
    });
    let mut results = results.into_iter();
    let mut take = || {
        let next = results.next().flatten();
        next.ok_or_else(|| anyhow!("a run gave no result"))?
    };
    rows.iter()
        .map(|_| (0..SEEDS).map(|_| take()).collect())
        .collect()
}

/// A straight line by least squares.
#[derive(Clone, Copy, Debug)]
pub(super) struct Line {
    pub slope: f64,
    /// Standard error of the slope, from the scatter about the line.
    pub error: f64,
    pub intercept: f64,
}

impl Line {
    /// Through points, all of the same weight.
    pub fn through(points: &[(f64, f64)]) -> Self {
        let count = points.len() as f64;
        let x0 = points.iter().map(|(x, _)| x).sum::<f64>() / count;
        let y0 = points.iter().map(|(_, y)| y).sum::<f64>() / count;
        let square: f64 = points.iter().map(|(x, _)| (x - x0) * (x - x0)).sum();
        let cross: f64 = points.iter().map(|(x, y)| (x - x0) * (y - y0)).sum();
        let slope = cross / square;
        let intercept = y0 - slope * x0;
        let rest: f64 = points
            .iter()
            .map(|(x, y)| (y - intercept - slope * x).powi(2))
            .sum();
        Self {
            slope,
            error: (rest / ((count - 2.0) * square)).sqrt(),
            intercept,
        }
    }
}

/// As many strokes as give one whole loop after the first loading of the spring.
pub(super) const STROKES: f64 = 3.0;

/// A small tip that is slid along the close-packed rows, in units of σ, ε and m.
pub(super) fn slid(effort: Effort, speed: f64, load: f64, temperature: f64) -> Row {
    let spacing = TipScene::default().spacing;
    let (spacings, time_step) = match effort {
        Effort::Quick => (4.0, 0.01),
        Effort::Full => (8.0, 0.01),
    };
    let stroke = spacings * spacing;
    let scene = TipScene {
        drive: tribos::scene::DriveKind::Slide,
        speed: Some(speed),
        stroke: Some(stroke),
        stiffness: 40.0,
        drive_damping_rate: 2.0,
        driven_constraint: tribos::scene::DrivenHold::Level,
        load: Some(load),
        adhesion_energy: 0.3,
        shift: tribos::md::pair::Shift::Force,
        substrate_columns: 8,
        substrate_rows: 10,
        substrate_layers: 4,
        tip_layers: 4,
        tip_side_atoms: 3,
        temperature,
        time_step,
        equilibration: 10.0,
        drive_time: STROKES * stroke / speed,
        rest_time: 0.0,
        ..TipScene::default()
    };
    let name = format!("slid,speed={speed},load={load},temperature={temperature}");
    Row { name, scene }
}
