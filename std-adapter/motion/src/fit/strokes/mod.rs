//! The strokes of a reciprocating tribometer, or the starts of a start–stop test, one by one.
//!
//! [`Strokes::new`] divides a [`StrokeRecord`] and measures each stroke; nothing is fitted.
//!
//! - **Division.** A stroke begins and ends where the velocity passes a threshold, the larger of 5 % of the largest
//!   speed and six standard deviations of its noise, with hysteresis. Reversals divide, and rests of the drive: five
//!   rows or more below the threshold, unless friction rises all through them, which are the sticks of stick–slip. A
//!   stroke shorter than a twentieth of the usual one is none.
//!   Positions alone give the velocity by differences. Without either the sign of the friction divides; if that
//!   does not change, the record is one stroke.
//! - **Sign.** Friction that has the sign of the velocity, the opposite one, or none (a coefficient that is
//!   positive in both directions) becomes positive where it resists.
//! - **Static peak.** The largest median of three rows between the middle of the rest before the stroke and its steady
//!   part: a single wild row is no peak. Noise raises it by up to three standard deviations of one row.
//! - **Steady part.** The middle half of the way, or of the time where there is no way, from where friction first
//!   reaches half of its median over the second half of the stroke: before, the machine's springs turn round. Mean and
//!   standard deviation of the friction over its rows.
//! - **Stick–slip.** A saw-tooth: friction falls by more than ten standard deviations of the noise and 2 % of the mean,
//!   in at most half of the time of the rise before, which is straight to a fifth of the fall. One fall is that of the static
//!   peak: fewer than three are no stick–slip.
//! - **Run-in**: [`RunIn`] has the rule. Strokes that the record cuts off are left out of the summary.
//!
//! ```
//! use tribos::fit::strokes::{StrokeOptions, StrokeRecord, Strokes};
//! // Two seconds to and fro, ten times, with the coefficient 0.3.
//! let times: Vec<f64> = (0..4000).map(|i| 0.01 * f64::from(i)).collect();
//! let signs = (0..4000).map(|i| if (i / 200) % 2 == 0 { 1.0 } else { -1.0 });
//! let velocities = signs.clone().map(|sign| 0.005 * sign).collect();
//! let friction = signs.map(|sign| 0.3 * sign).collect();
//! let record = StrokeRecord::new(times, friction)?.with_velocities(velocities)?;
//! let found = Strokes::new(&record, &StrokeOptions::default())?;
//! assert_eq!(found.strokes.len(), 20);
//! assert!((found.summary.mean - 0.3).abs() < 1e-12);
//! # Ok::<(), tribos::fit::FitError>(())
//! ```

mod divide;
mod measure;
pub(super) mod noise;
mod notes;
mod quantities;
mod record;
mod run_in;
mod stick_slip;
mod summary;

use super::FitError;
use divide::{FEWEST_AT_REST, Span, are_sticks, divide_into_strokes, gaps};
use noise::{largest, noise, noise_within, velocities};
pub use quantities::StrokeQuantity;
pub use record::StrokeRecord;
pub use run_in::RunIn;
use std::ops::Range;
pub use stick_slip::StickSlip;
pub use summary::StrokeSummary;

/// How strokes are taken apart.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StrokeOptions {
    /// Share of the way of a stroke, about its middle, that is its steady part: > 0 and at most 1.
    pub middle: f64,
    /// Shortest rest that divides strokes of one direction, in s; at least five rows.
    pub shortest_rest: f64,
}

impl Default for StrokeOptions {
    /// The middle half; a rest of five rows.
    fn default() -> Self {
        Self {
            middle: 0.5,
            shortest_rest: 0.0,
        }
    }
}

/// What divided the record.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DividedBy {
    /// The measured velocity.
    Velocity,
    /// The velocity from differences of positions.
    Position,
    /// The sign of the friction: there is no velocity and no position.
    FrictionSign,
    /// Nothing: there is no motion, and friction keeps its sign.
    Nothing,
}

/// Sign of the measured friction.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FrictionSign {
    /// That of the velocity.
    Along,
    /// Opposite to the velocity.
    Against,
    /// The same in both directions.
    Unsigned,
}

/// Direction of a stroke.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StrokeDirection {
    /// Velocity > 0.
    Forward,
    /// Velocity < 0.
    Backward,
}

impl StrokeDirection {
    /// 1 or −1.
    pub fn sign(self) -> f64 {
        match self {
            Self::Forward => 1.0,
            Self::Backward => -1.0,
        }
    }
}

/// The largest friction before steady sliding.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StaticPeak {
    /// Friction at the peak.
    pub value: f64,
    /// When it was reached, in s.
    pub time: f64,
}

/// One stroke. Friction is positive where it resists, in the unit of the record.
#[derive(Clone, Debug, PartialEq)]
pub struct Stroke {
    /// Number of the stroke, from 1.
    pub number: usize,
    /// Rows of the record in motion.
    pub rows: Range<usize>,
    /// Rows of the steady part.
    pub steady_rows: Range<usize>,
    /// Time of the first row, in s.
    pub start: f64,
    /// Time from the first to the last row, in s.
    pub duration: f64,
    /// Direction of the motion.
    pub direction: StrokeDirection,
    /// Distance from the first to the last row, in m, if the motion is known.
    pub length: Option<f64>,
    /// Length over duration, in m/s.
    pub mean_speed: Option<f64>,
    /// Static peak; none if the record begins within the stroke.
    pub static_peak: Option<StaticPeak>,
    /// Mean friction of the steady part.
    pub mean: f64,
    /// Standard deviation of the friction in the steady part; NaN with a single row.
    pub deviation: f64,
    /// Stick–slip over the whole stroke.
    pub stick_slip: StickSlip,
    /// Whether the record cuts the stroke off, and it is shorter than nine tenths of the others.
    pub is_cut_off: bool,
}

/// All strokes of a record, and what they have in common.
#[derive(Clone, Debug, PartialEq)]
pub struct Strokes {
    /// The strokes in the order of time.
    pub strokes: Vec<Stroke>,
    /// What divided the record.
    pub divided_by: DividedBy,
    /// Sign of the measured friction.
    pub friction_sign: FrictionSign,
    /// Whether bodies stick within the strokes so that the velocity rests.
    pub sticks: bool,
    /// Standard deviation of the white noise on the friction.
    pub noise: f64,
    /// Friction of each row, positive where it resists within a stroke; NaN between strokes.
    pub resistance: Vec<f64>,
    /// Run-in.
    pub run_in: RunIn,
    /// Means over the strokes after the run-in.
    pub summary: StrokeSummary,
}

/// Thresholds of the motion and of the sign of friction, as shares of the largest magnitude.
const SPEED_SHARE: f64 = 0.05;
const FRICTION_SHARE: f64 = 0.2;
/// Standard deviations of the noise below which nothing moves.
const SIGMAS: f64 = 6.0;
/// Share of the largest magnitude that noise may raise the threshold to.
const MOST_SHARE: f64 = 0.5;

impl Strokes {
    /// Takes a record apart.
    ///
    /// *Cost*: linear in the rows. *Errors*: a record in which nothing moves, and options out of
    /// their range.
    pub fn new(record: &StrokeRecord, options: &StrokeOptions) -> Result<Self, FitError> {
        if !(options.middle > 0.0 && options.middle <= 1.0) {
            return Err(FitError::Whole("the steady part must be > 0 and at most 1"));
        }
        if !(options.shortest_rest >= 0.0 && options.shortest_rest.is_finite()) {
            return Err(FitError::Whole("the shortest rest must be >= 0 s"));
        }
        let path = record.path();
        let (divided_by, sticks, spans) = divided(record, path.as_deref(), options)?;
        let noise = noise_within(&record.friction, spans.iter().map(|span| span.rows.clone()));
        let measured = measure::Measured::new(record, path.as_deref(), options, noise);
        let (friction_sign, strokes, resistance) = measured.all(&spans);
        let complete = || strokes.iter().filter(|stroke| !stroke.is_cut_off);
        let (means, numbers): (Vec<f64>, Vec<usize>) = {
            let offset = summary::late_offset(complete());
            let freed = |s: &Stroke| (s.mean - offset * s.direction.sign(), s.number);
            complete().map(freed).unzip()
        };
        let run_in = run_in::run_in(&means, &numbers);
        let summary = StrokeSummary::of(&strokes, run_in.after());
        Ok(Self {
            strokes,
            divided_by,
            friction_sign,
            sticks,
            noise,
            resistance,
            run_in,
            summary,
        })
    }
}

/// What divides the record, whether rests of the velocity are sticks, and the strokes.
fn divided(
    record: &StrokeRecord,
    path: Option<&[f64]>,
    options: &StrokeOptions,
) -> Result<(DividedBy, bool, Vec<Span>), FitError> {
    let time = |i: usize| record.times.get(i).copied().unwrap_or(0.0);
    let (by, signal, share) = match (&record.velocities, &record.positions) {
        (Some(velocities), _) => (DividedBy::Velocity, velocities.clone(), SPEED_SHARE),
        (None, Some(positions)) => {
            let found = velocities(&record.times, positions, SPEED_SHARE);
            (DividedBy::Position, found, SPEED_SHARE)
        }
        (None, None) => (
            DividedBy::FrictionSign,
            record.friction.clone(),
            FRICTION_SHARE,
        ),
    };
    // Way of a stroke, or its time where there is no way.
    let extent = |rows: &Range<usize>| match path {
        Some(path) => {
            let at = |i: usize| path.get(i).copied().unwrap_or(0.0);
            (at(rows.end - 1) - at(rows.start)).abs()
        }
        None => time(rows.end - 1) - time(rows.start),
    };
    let most = largest(&signal);
    let threshold = (share * most)
        .max(SIGMAS * noise(&signal))
        .min(MOST_SHARE * most);
    if by == DividedBy::FrictionSign {
        let spans = match threshold > 0.0 {
            true => divide_into_strokes(signal, threshold, |_| false, extent),
            false => Vec::new(),
        };
        return Ok(match spans.len() {
            0 | 1 => (DividedBy::Nothing, false, vec![whole(&record.friction)]),
            _ => (by, false, spans),
        });
    }
    if threshold <= 0.0 {
        return Err(FitError::Whole(
            "nothing moves: the velocity is 0 in all rows; check its column, or leave it out and \
             strokes are divided by the sign of the friction",
        ));
    }
    let is_rest = |gap: Range<usize>| {
        gap.len() >= FEWEST_AT_REST && time(gap.end - 1) - time(gap.start) >= options.shortest_rest
    };
    let sticks = are_sticks(&record.friction, &gaps(&signal, threshold, is_rest));
    let divides = |gap: Range<usize>| !sticks && is_rest(gap);
    let spans = divide_into_strokes(signal, threshold, divides, extent);
    Ok((by, sticks, spans))
}

/// The whole record as one stroke.
fn whole(friction: &[f64]) -> Span {
    Span {
        rows: 0..friction.len(),
        sign: 1.0,
        rest: 0,
        begins_in_motion: false,
        ends_in_motion: false,
    }
}

#[cfg(test)]
#[allow(clippy::disallowed_methods, reason = "tests compare with the platform")]
mod tests;
