//! The outcome of a run: reversible or not, where it locked in, which layers slipped.

use super::energy::DriveEnergy;
use super::loop_work::LoopWork;
use super::sliding_summary::{SlidingSample, SlidingSummary};
use super::start::{Columns, EquilibriumCheck};
use crate::tip::scene::{DriveKind, StageSteps, TipScene};
use tribos_base::results::{Reporting::*, summary};
use tribos_base::scene::words::words;
use tribos_base::statistics::mean_and_error;

/// Column of the driven layers' angle.
const ANGLE: usize = 1;
/// Column of the torque against the drive.
const TORQUE: usize = 2;
/// Column of the driven layers' height.
const HEIGHT: usize = 3;
/// Columns of the temperatures of the baths.
const TEMPERATURES: [usize; 2] = [4, 5];
/// Column of the potential energy.
const POTENTIAL: usize = 6;
/// Columns of a slid tip: position of the support, force of the spring, normal force.
const SUPPORT: usize = 7;
const LATERAL: usize = 9;
const NORMAL: usize = 10;
/// Time at the end of a stage over which angles are averaged, in τ.
const END: f64 = 20.0;
/// An angle below which the tip counts as turned back, in degrees. Thermal motion is a tenth of it.
const BACK: f64 = 1.0;
/// Two layers slipped if their angles differ by more, in degrees.
const SLIPPED: f64 = 1.0;
/// An angle is locked while it stays within this width, in degrees, ...
const LOCKED_WIDTH: f64 = 1.0;
/// ... for at least so long, in τ.
const LOCKED_TIME: f64 = 15.0;

/// Whether the driven layers turned back.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Reversal {
    /// The driven layers turned back.
    Reversible,
    /// The driven layers did not turn back.
    Irreversible,
    /// Undecided: the run ended too early, or has no time after the drive; or the tip was slid.
    Open,
}

words!(Reversal { Reversible = "reversible", Irreversible = "irreversible", Open = "open" });

summary! {
    /// An interval during which the driven layers rested.
    #[derive(Copy)]
    pub struct AnglePlateau = part;

    /// Start of the interval, from the start of the drive.
    from: f64, "tau";
    /// End of the interval, from the start of the drive.
    to: f64, "tau";
    /// Mean angle.
    angle_degrees: f64, "degrees";
}

summary! {
    /// The result of a run.
    ///
    /// Turns and work are accumulated at every step, averages use lines 0.5 τ apart (closer if a
    /// stage is short): how often a series or frames are written changes only `sample_every`.
    ///
    /// ```
    /// use tribos::run::run_to_end;
    /// use tribos::scene::TipScene;
    /// use tribos::tip::{TipSummary, AnglePlateau, TipSimulation, Reversal};
    /// // A weak torque for a moment: nothing can slip, nothing stays turned.
    /// let scene = TipScene {
    ///     lambda: 0.001,
    ///     substrate_columns: 8,
    ///     substrate_rows: 8,
    ///     substrate_layers: 4,
    ///     tip_layers: 4,
    ///     tip_side_atoms: 2,
    ///     temperature: 0.0,
    ///     equilibration: 0.0,
    ///     drive_time: 0.1,
    ///     rest_time: 0.1,
    ///     time_step: 0.005,
    ///     sample_every: 5,
    ///     ..TipScene::default()
    /// };
    /// let mut run = TipSimulation::new(&scene)?;
    /// run_to_end(&mut run, |_, _| ())?;
    /// let outcome: TipSummary = run.outcome();
    /// assert_eq!(outcome.verdict, Reversal::Reversible);
    /// assert_eq!(outcome.json(&scene)["verdict"], "reversible");
    /// assert!(outcome.slipped_interfaces.is_empty() && outcome.samples == 1 + 40 / 5);
    /// let stood: &[AnglePlateau] = &outcome.plateaus;
    /// assert!(stood.is_empty()); // it was not driven for long enough
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub struct TipSummary;

    /// Whether the driven layers turned back.
    verdict: Reversal, "-";
    /// Mean angle of the driven layers before the drive ended.
    driven_angle_degrees: f64, "degrees", ShownAs("driven_angle", "driven");
    /// Largest angle of the driven layers.
    largest_angle_degrees: f64, "degrees", ShownAs("largest_angle", "largest");
    /// Mean angle of the driven layers at the end.
    final_angle_degrees: f64, "degrees", ShownAs("final_angle", "final angle");
    /// Mean angles of the tip's layers at the end, from below.
    layer_angles_degrees: Vec<f64>, "degrees";
    /// Interfaces that slipped for good: 0 between substrate and tip, k above the tip's k-th layer.
    slipped_interfaces: Vec<usize>, "-";
    /// Interfaces that had slipped before the drive ended.
    slipped_interfaces_while_driven: Vec<usize>, "-";
    /// Intervals in which the driven layers rested while they were driven.
    plateaus: Vec<AnglePlateau>, "-";
    /// Mean temperature of the tip's bath while driven.
    tip_temperature: f64, "eps/k_B", Shown("tip temperature");
    /// Energy balance of the drive.
    drive_energy: DriveEnergy, "-";
    /// How well the tip was in equilibrium when the drive began.
    start: EquilibriumCheck, "-";
    /// Lines of the series.
    samples: usize, "-";
    /// Friction of a slid tip.
    slid: Option<SlidingSummary>, "-";
}

/// Measurements of a run.
pub(super) struct Measured<'a> {
    /// Lines like those of the series, at times independent of it.
    pub lines: &'a [Vec<f64>],
    /// Column at which the angles of the tip's layers begin.
    pub layers: usize,
    /// Turning points of a slid tip.
    pub loops: &'a LoopWork,
    /// Work of the drive, in ε.
    pub work: f64,
    /// Lines of the series.
    pub samples: usize,
}

impl TipSummary {
    /// The outcome of what was measured.
    pub(super) fn of(scene: &TipScene, measured: &Measured) -> Self {
        let (series, layers) = (measured.lines, measured.layers);
        let StageSteps {
            before,
            driven,
            after,
        } = scene.stage_steps();
        let off = driven as f64 * scene.time_step;
        let end = (driven + after) as f64 * scene.time_step;
        let begin = -(before as f64) * scene.time_step;
        let width = layers + scene.tip_layers;
        let first = means(series, begin.max(-END), 0.0, width);
        let driven = means(series, (off - END).max(0.0), off, width);
        let last = means(series, (end - END).max(off), end, width);
        let is_over = series.last().is_some_and(|line| line[0] >= end);
        let on: Vec<[f64; 2]> = series
            .iter()
            .filter(|line| line[0] >= begin.max(0.0) && line[0] <= off)
            .map(|line| [line[0], line[ANGLE]])
            .collect();
        let verdict = if !is_over || after == 0 || scene.drive == DriveKind::Slide {
            Reversal::Open
        } else if last[ANGLE].abs() < BACK {
            Reversal::Reversible
        } else {
            Reversal::Irreversible
        };
        let stored = driven[POTENTIAL] - first[POTENTIAL];
        let largest = series.iter().map(|line| line[ANGLE]);
        Self {
            verdict,
            driven_angle_degrees: driven[ANGLE],
            largest_angle_degrees: largest.fold(
                0.0,
                |most: f64, x| if x.abs() > most.abs() { x } else { most },
            ),
            final_angle_degrees: last[ANGLE],
            layer_angles_degrees: last[layers..].to_vec(),
            slipped_interfaces: slipped(&last[layers..]),
            slipped_interfaces_while_driven: slipped(&driven[layers..]),
            plateaus: plateaus(&on),
            tip_temperature: means(series, 0.0, off, width)[5],
            drive_energy: DriveEnergy {
                work: measured.work,
                stored,
                heat: measured.work - stored,
                released: driven[POTENTIAL] - last[POTENTIAL],
                uncertainty: libm::hypot(
                    standard_error(series, begin.max(-END), 0.0),
                    standard_error(series, (off - END).max(0.0), off),
                ),
            },
            start: start(series, begin.max(-END), width),
            slid: (scene.drive == DriveKind::Slide)
                .then(|| SlidingSummary::of(scene, &looks(series, off), measured.loops)),
            samples: measured.samples,
        }
    }
}

/// Equilibrium before the drive, from lines with three more numbers than the series.
fn start(lines: &[Vec<f64>], from: f64, width: usize) -> EquilibriumCheck {
    let before = lines
        .iter()
        .filter(|line| line[0] >= from && line[0] <= 0.0);
    let before: Vec<&[f64]> = before.map(Vec::as_slice).collect();
    let columns = Columns {
        angle: ANGLE,
        torque: TORQUE,
        height: HEIGHT,
        temperatures: TEMPERATURES,
        energy: POTENTIAL,
        force: [width, width + 1, width + 2],
    };
    EquilibriumCheck::of(&before, columns)
}

/// Looks at a slid tip while it is driven.
fn looks(lines: &[Vec<f64>], off: f64) -> Vec<SlidingSample> {
    let driven = lines.iter().filter(|line| line[0] >= 0.0 && line[0] <= off);
    let look = |line: &Vec<f64>| SlidingSample {
        time: line[0],
        support: line[SUPPORT],
        force: line[LATERAL],
        normal: line[NORMAL],
    };
    driven.map(look).collect()
}

/// Means of all columns over an interval of time; NaN if it has no line.
fn means(series: &[Vec<f64>], from: f64, to: f64, width: usize) -> Vec<f64> {
    let mut sums = vec![0.0; width];
    let mut count = 0.0;
    for line in series
        .iter()
        .filter(|line| line[0] >= from && line[0] <= to)
    {
        count += 1.0;
        for (sum, value) in sums.iter_mut().zip(line) {
            *sum += value;
        }
    }
    sums.into_iter().map(|sum| sum / count).collect()
}

/// Standard error of the mean potential energy over an interval of time, with lines treated as independent.
fn standard_error(series: &[Vec<f64>], from: f64, to: f64) -> f64 {
    let within = series
        .iter()
        .filter(|line| line[0] >= from && line[0] <= to);
    mean_and_error(&within.map(|line| line[POTENTIAL]).collect::<Vec<_>>())[1]
}

/// Interfaces across which the angles differ; the substrate has angle 0.
fn slipped(layers: &[f64]) -> Vec<usize> {
    let below = std::iter::once(&0.0).chain(layers);
    let is_slip = |(below, above): (&f64, &f64)| (above - below).abs() > SLIPPED;
    let pairs = below.zip(layers).map(is_slip).enumerate();
    pairs
        .filter(|(_, is)| *is)
        .map(|(index, _)| index)
        .collect()
}

/// Successive longest intervals in which the angle stays within a width.
fn plateaus(curve: &[[f64; 2]]) -> Vec<AnglePlateau> {
    let mut found = Vec::new();
    let mut start = 0;
    while start < curve.len() {
        let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
        let stays = |[_, angle]: &&[f64; 2]| {
            low = low.min(*angle);
            high = high.max(*angle);
            high - low <= LOCKED_WIDTH
        };
        let stretch: Vec<&[f64; 2]> = curve[start..].iter().take_while(stays).collect();
        let [from, to] = [0, stretch.len() - 1].map(|at| stretch[at][0]);
        if to - from >= LOCKED_TIME {
            let sum: f64 = stretch.iter().map(|[_, angle]| angle).sum();
            let angle_degrees = sum / stretch.len() as f64;
            found.push(AnglePlateau {
                from,
                to,
                angle_degrees,
            });
            start += stretch.len();
        } else {
            start += 1;
        }
    }
    found
}

#[cfg(test)]
mod tests;
