//! A slid tip: the friction loop, its stick and slip, and where the work of the support went.

use super::loop_work::{LoopWork, Totals};
use crate::tip::scene::TipScene;
use tribos_base::results::{Reporting::*, summary};

/// Part of a stroke that is left out of means: the spring unloads and loads after a turning point.
const TURNED: f64 = 0.5;
/// Part of a stroke that is left out of the search for the period.
const BEGUN: f64 = 0.25;
/// Number of wavelengths tried between the shortest and the longest.
const WAVELENGTHS: usize = 400;
/// Shortest wavelength tried, in spacings.
const SHORTEST: f64 = 0.3;
/// The force is called periodic if at least this part of its variance is at one wavelength.
const PERIODIC: f64 = 0.3;
/// A drop of the force counts as a slip if it is more than this part of the force's range.
const SLIP: f64 = 0.5;

/// One look at a slid tip.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct SlidingSample {
    /// Time from the start of the drive.
    pub time: f64,
    /// Position of the support.
    pub support: f64,
    /// Force of the spring on the tip along the direction of the drive.
    pub force: f64,
    /// Force of the substrate on the driven layers along z.
    pub normal: f64,
}

summary! {
    /// The friction of a slid tip.
    ///
    /// Forces are those of the spring along the direction of the drive, positive against the motion of
    /// the support. Loops begin at the first turning point, so that none contains the first loading
    /// of the spring. What a run has not is NaN.
    ///
    /// ```
    /// use tribos::run::run_to_end;
    /// use tribos::scene::{DriveKind, DrivenHold, TipScene};
    /// use tribos::tip::{SlidingSummary, TipSimulation};
    /// // A cold tip on a weakly attracting substrate, pulled forth by half a spacing and back, twice.
    /// let scene = TipScene {
    ///     drive: DriveKind::Slide,
    ///     speed: Some(0.5),
    ///     stroke: Some(0.6),
    ///     driven_constraint: DrivenHold::Level,
    ///     load: Some(0.1),
    ///     adhesion_energy: 0.2,
    ///     substrate_columns: 10,
    ///     substrate_rows: 10,
    ///     substrate_layers: 4,
    ///     tip_layers: 4,
    ///     tip_side_atoms: 2,
    ///     temperature: 0.0,
    ///     equilibration: 0.5,
    ///     drive_time: 4.8,
    ///     rest_time: 0.0,
    ///     time_step: 0.01,
    ///     ..TipScene::default()
    /// };
    /// let mut run = TipSimulation::new(&scene)?;
    /// run_to_end(&mut run, |_, _| ())?;
    /// let slid: SlidingSummary = run.outcome().slid.ok_or("it is slid")?;
    /// assert_eq!((slid.strokes, slid.loops), (4, 1));
    /// assert!((slid.loop_work - slid.friction * 2.0 * 0.6).abs() < 1e-12);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// *Units*: those of the scene.
    #[derive(Copy)]
    pub struct SlidingSummary = part;

    /// Complete strokes of the support; 1 for a support that does not turn.
    strokes: usize, "-";
    /// Mean force over the second half of the strokes forth.
    friction_forth: f64, "eps/sigma", Swept;
    /// Mean force over the second half of the strokes back.
    friction_back: f64, "eps/sigma", Swept;
    /// Complete loops from the first turning point on.
    loops: usize, "-";
    /// Mean work of the support in a loop: the area of the friction loop.
    loop_work: f64, "eps";
    /// Loop area over the length of its path, two strokes.
    friction: f64, "eps/sigma", Shown("friction");
    /// Mean force of the substrate on the driven layers over the second halves of all strokes.
    normal_force: f64, "eps/sigma", Shown("normal force");
    /// Wavelength at which the force varies most along the path of the support.
    period: f64, "sigma", Shown("period");
    /// Part of the force's variance at that wavelength, from 0 to 1.
    period_share: f64, "-";
    /// Drops of the force by more than half its range, in the searched parts of all strokes.
    slips: usize, "-";
    /// Mean force before these drops.
    peak_force: f64, "eps/sigma", Swept;
    /// Work of the support while it moved.
    work: f64, "eps";
    /// Heat that thermostats and damping took meanwhile.
    heat: f64, "eps";
    /// Rise of the energy of atoms, springs and load meanwhile.
    stored: f64, "eps";
    /// Part of the work that is neither heat nor stored: the error of the energy balance.
    imbalance: f64, "-";
    /// Whether the force is `periodic` along the path, or `irregular`.
    motion: &'static str, "-";
}

impl SlidingSummary {
    /// What a run of a slid tip shows so far, from its lines for averages and its loops.
    pub(super) fn of(scene: &TipScene, looks: &[SlidingSample], loops: &LoopWork) -> Self {
        let drive = scene.stage_steps().driven as f64 * scene.time_step;
        let path = scene.speed.unwrap_or(f64::NAN) * drive;
        let stroke = scene.stroke.unwrap_or(path);
        // A stroke that the drive ends within a thousandth of counts as complete.
        let strokes = (path / stroke + 1e-3).floor() as usize;
        let strokes = StrokeSeries::of(looks, strokes, stroke, scene.speed.unwrap_or(f64::NAN));
        let turned = strokes.later(TURNED);
        let begun = strokes.later(BEGUN);
        let (period, period_share) = period(&begun, scene.spacings()[0], stroke);
        let (slips, peak_force) = slips(&begun);
        let works = loop_works(&loops.turns);
        let loop_work = mean(works.iter().copied());
        let of = |part: fn(&Totals) -> f64| match loops.ends.as_slice() {
            [first, last] => part(last) - part(first),
            _ => f64::NAN,
        };
        let side = |parity: usize| {
            let of_side = turned.iter().enumerate();
            let of_side = of_side.filter(|(number, _)| number % 2 == parity);
            mean(of_side.flat_map(|(_, looks)| looks.iter().map(|[_, force, _]| *force)))
        };
        let (work, heat) = (of(|totals| totals.work), of(|totals| totals.heat));
        let stored = of(|totals| totals.energy);
        Self {
            strokes: strokes.0.len(),
            friction_forth: side(0),
            friction_back: side(1),
            loops: works.len(),
            loop_work,
            friction: loop_work / (2.0 * stroke),
            normal_force: mean(turned.iter().flatten().map(|[_, _, normal]| *normal)),
            period,
            period_share,
            slips,
            peak_force,
            work,
            heat,
            stored,
            imbalance: (work - heat - stored) / work,
            motion: if period_share >= PERIODIC {
                "periodic"
            } else {
                "irregular"
            },
        }
    }
}

/// Complete strokes: for each look the part of its stroke's path, the force against the motion, and
/// the normal force.
struct StrokeSeries(Vec<Vec<[f64; 4]>>);

impl StrokeSeries {
    fn of(looks: &[SlidingSample], count: usize, stroke: f64, speed: f64) -> Self {
        let mut strokes = vec![Vec::new(); count];
        for look in looks.iter().filter(|look| look.time >= 0.0) {
            let path = look.time * speed / stroke;
            let number = path.floor();
            let Some(own) = strokes.get_mut(number as usize) else {
                continue;
            };
            let against = if number % 2.0 == 0.0 {
                look.force
            } else {
                -look.force
            };
            own.push([path - number, look.support, against, look.normal]);
        }
        Self(strokes)
    }

    /// Position, force and normal force in the later part of each stroke.
    fn later(&self, from: f64) -> Vec<Vec<[f64; 3]>> {
        let of_stroke = |stroke: &Vec<[f64; 4]>| {
            let later = stroke.iter().filter(|[part, ..]| *part >= from);
            later
                .map(|[_, x, force, normal]| [*x, *force, *normal])
                .collect()
        };
        self.0.iter().map(of_stroke).collect()
    }
}

fn mean(numbers: impl Iterator<Item = f64>) -> f64 {
    let (sum, count) = numbers.fold((0.0, 0.0), |(sum, count), x| (sum + x, count + 1.0));
    sum / count
}

/// Work of each complete loop, from the work so far at each turning point.
fn loop_works(turns: &[f64]) -> Vec<f64> {
    let loops = turns.windows(3).step_by(2);
    loops.map(|works| works[2] - works[0]).collect()
}

/// The wavelength with the largest power, and its part of the variance.
fn period(strokes: &[Vec<[f64; 3]>], spacing: f64, stroke: f64) -> (f64, f64) {
    let curves: Vec<Vec<[f64; 2]>> = strokes.iter().map(|stroke| detrended(stroke)).collect();
    let variance = mean(curves.iter().flatten().map(|[_, force]| force * force));
    // At least two waves in the searched part of a stroke.
    let [shortest, longest] = [SHORTEST * spacing, 0.5 * (1.0 - BEGUN) * stroke];
    let is_known = variance > 0.0 && longest > shortest;
    if !is_known {
        return (f64::NAN, f64::NAN);
    }
    let mut best = (f64::NAN, 0.0);
    for number in 0..=WAVELENGTHS {
        // Equally spaced wave numbers.
        let part = number as f64 / WAVELENGTHS as f64;
        let wavelength = 1.0 / (part / shortest + (1.0 - part) / longest);
        let power = mean(curves.iter().map(|curve| power(curve, wavelength)));
        if power > best.1 {
            best = (wavelength, power);
        }
    }
    (best.0, best.1 / variance)
}

/// Force without its mean and its linear trend.
fn detrended(looks: &[[f64; 3]]) -> Vec<[f64; 2]> {
    let x0 = mean(looks.iter().map(|[x, ..]| *x));
    let mean_force = mean(looks.iter().map(|[_, force, _]| *force));
    let cross: f64 = looks
        .iter()
        .map(|[x, force, _]| (x - x0) * (force - mean_force))
        .sum();
    let square: f64 = looks.iter().map(|[x, ..]| (x - x0) * (x - x0)).sum();
    let slope = if square > 0.0 { cross / square } else { 0.0 };
    looks
        .iter()
        .map(|[x, force, _]| [*x, force - mean_force - slope * (x - x0)])
        .collect()
}

/// Mean square of the best sine of a wavelength.
fn power(curve: &[[f64; 2]], wavelength: f64) -> f64 {
    let (mut cosine, mut sine) = (0.0, 0.0);
    for [x, force] in curve {
        let (sin, cos) = libm::sincos(std::f64::consts::TAU * x / wavelength);
        cosine += force * cos;
        sine += force * sin;
    }
    let count = curve.len() as f64;
    2.0 * (cosine * cosine + sine * sine) / (count * count)
}

/// Number of large drops of the force, and the mean force before them.
fn slips(strokes: &[Vec<[f64; 3]>]) -> (usize, f64) {
    let forces = || strokes.iter().flatten().map(|[_, force, _]| *force);
    let range = forces().fold(f64::NEG_INFINITY, f64::max) - forces().fold(f64::INFINITY, f64::min);
    let mut peaks = Vec::new();
    for stroke in strokes {
        let (mut high, mut low, mut is_falling) = (f64::NEG_INFINITY, f64::INFINITY, false);
        for [_, force, _] in stroke {
            if is_falling {
                low = low.min(*force);
                if force - low > SLIP * range {
                    (is_falling, high) = (false, *force);
                }
            } else {
                high = high.max(*force);
                if high - force > SLIP * range {
                    peaks.push(high);
                    (is_falling, low) = (true, *force);
                }
            }
        }
    }
    (peaks.len(), mean(peaks.into_iter()))
}

#[cfg(test)]
mod tests;
