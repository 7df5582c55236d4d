//! Running-in: from which stroke on the mean friction is that of the worn surface.

use tribos_base::statistics::correlation::{correlation_time, drift, error_factor};
use tribos_base::statistics::marginal_error_cut;

/// Whether the mean friction settled, and after how many strokes.
///
/// The strokes left out are those whose omission makes the standard error of the remaining mean smallest
/// (the marginal standard error rule, White, *Simulation* 69, 1997, 323): the d ≤ ⅔ n with the least
/// Σ (mᵢ − m̄)²/(n − d)² over the strokes after d. They are a run-in only if they differ from
/// the rest beyond its scatter: their sum of squares, in the variance σ² of the rest, exceeds
/// d + 6√(2d), or their mean lies 4 standard errors away. Differences below a thousandth of the friction do not count. The
/// offset of the two directions is taken off before.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum RunIn {
    /// Fewer than eight complete strokes: not decided, and all strokes are used.
    TooFew,
    /// No stroke differs from the rest.
    None,
    /// The mean friction settled.
    Settled {
        /// Number of the last stroke of the run-in.
        after: usize,
    },
    /// The mean friction still changes at the end: over the strokes after `after` it has a slope beyond three
    /// of its standard errors, or more than half of the strokes are left out.
    NotSettled {
        /// Number of the last stroke that is left out.
        after: usize,
        /// Change of the mean friction from stroke to stroke over those that are left.
        drift: f64,
    },
}

impl RunIn {
    /// Number of the last stroke that the summary leaves out; 0 if it uses all.
    pub fn after(&self) -> usize {
        match self {
            Self::TooFew | Self::None => 0,
            Self::Settled { after } | Self::NotSettled { after, .. } => *after,
        }
    }
}

/// Fewest strokes by which a run-in is decided.
const FEWEST: usize = 8;
/// Largest share of the strokes that may be left out, and the one beyond which nothing has settled.
const MOST_LEFT_OUT: f64 = 2.0 / 3.0;
const SETTLED_SHARE: f64 = 0.5;
/// Excess of the sum of squares, in its standard deviations √(2d), that is a run-in.
const SQUARES: f64 = 6.0;
/// Distance of the means, in standard errors, that is a run-in, and of a slope that is a drift.
const FAR: f64 = 4.0;
const DRIFTS: f64 = 3.0;
/// Share of the friction below which a difference of means is of no interest, however small their scatter.
const RESOLUTION: f64 = 1e-3;

/// Decides from the mean friction of each stroke, freed of the offset of the directions; `numbers` are
/// those of the strokes.
pub(super) fn run_in(means: &[f64], numbers: &[usize]) -> RunIn {
    let count = means.len();
    if count < FEWEST {
        return RunIn::TooFew;
    }
    let cut = marginal_error_cut(means, &vec![1.0; count], MOST_LEFT_OUT);
    let (left_out, rest) = means.split_at(cut);
    let differs = differs(left_out, rest);
    let rest = if differs { rest } else { means };
    let after = match cut.checked_sub(1) {
        Some(last) if differs => numbers.get(last).copied().unwrap_or(0),
        _ => 0,
    };
    let (drift, z) = drift(rest);
    let level = rest.last().map_or(0.0, |mean| mean.abs());
    let is_drift = z.abs() > DRIFTS && drift.abs() * rest.len() as f64 > RESOLUTION * level;
    if is_drift || (differs && cut as f64 > SETTLED_SHARE * count as f64) {
        RunIn::NotSettled { after, drift }
    } else if differs {
        RunIn::Settled { after }
    } else {
        RunIn::None
    }
}

/// Whether the strokes left out differ from the rest beyond its scatter.
fn differs(left_out: &[f64], rest: &[f64]) -> bool {
    let count = rest.len() as f64;
    let level = rest.iter().sum::<f64>() / count;
    let squares = |values: &[f64]| {
        values
            .iter()
            .map(|m| (m - level) * (m - level))
            .sum::<f64>()
    };
    let factor = error_factor(correlation_time(rest.to_vec()));
    let variance = squares(rest) / (count - 1.0) * factor * factor;
    // Means that differ by less than a thousandth are the same.
    let variance = variance + (RESOLUTION * level) * (RESOLUTION * level);
    let d = left_out.len() as f64;
    let excess = squares(left_out) - variance * (d + SQUARES * (2.0 * d).sqrt());
    let shift = left_out.iter().map(|m| m - level).sum::<f64>() / d;
    let error = (variance * (1.0 / d + 1.0 / count)).sqrt();
    d > 0.0 && (excess > 0.0 || shift.abs() > FAR * error)
}
