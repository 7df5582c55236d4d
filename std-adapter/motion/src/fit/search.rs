//! Several searches from starts that are spread evenly about a first guess.

use super::Measurements;
use super::error::FitError;
use super::halton::halton;
use super::jacobian::DifferenceScale;
use super::linear::improved;
use super::minimise::{Minimum, OFFSET, Problem, Stall, minimise};
use super::sample::{WeightedData, sample};
use super::unknowns::Unknowns;
use tribos_base::run::in_order;

/// Costs that differ relatively by less belong to the same minimum.
const SAME: f64 = 1e-6;

/// Progress of a fit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FitProgress {
    /// Number of points in the current search: a sample, or all.
    pub points: usize,
    /// Number of the search, from 1, and number of searches on these points.
    pub search: [usize; 2],
    /// Steps of the current search so far.
    pub steps: usize,
}

/// Receives the progress; searches run side by side.
pub(super) type ProgressWatch<'a> = dyn Fn(FitProgress) + Sync + 'a;

/// What the searches found.
pub(super) struct Search {
    /// Different minima by rising cost, roughly, with the number of searches that ended there.
    pub minima: Vec<(Minimum, usize)>,
    /// Lengths over which predictions change.
    pub lengths: Vec<DifferenceScale>,
    /// Starts from which a search was possible.
    pub starts: usize,
    /// Number of points on which the starts were searched.
    pub searched: usize,
}

/// Largest number of minima that are refined on all points.
const MOST_REFINED: usize = 3;
/// Minima whose costs differ by less than this many variances of a residual are alike:
/// five standard deviations of a likelihood's logarithm.
const ALIKE: f64 = 25.0;
/// Searches that must agree before no more are begun, if there are at least as many.
const ENOUGH: usize = 3;
/// Relative offset at which a search ends that another one continues: its sum of squares is then known to the square of
/// this.
pub(super) const ROUGH: f64 = 1e-4;
/// Factor by which the number of starts may grow.
const MOST_MORE: usize = 8;

/// Searches from all starts, and from more while fewer than three agree.
pub(super) fn search(
    unknowns: &Unknowns<'_>,
    data: &Measurements,
    target: &WeightedData,
    starts: usize,
    watch: &ProgressWatch<'_>,
) -> Result<Search, FitError> {
    let measured = data.friction();
    if measured.len() <= unknowns.sought.len() {
        return Err(FitError::TooFew {
            points: measured.len(),
            free: unknowns.sought.len(),
        });
    }
    let all = unknowns.fixed.len();
    let start = |index: usize| unknowns.coordinates(&unknowns.model.start(&halton(index, all)));
    let starts: Vec<Vec<f64>> = (0..starts.max(1)).map(start).collect();
    let lengths = unknowns.lengths(&starts);
    let points = sample(data, unknowns.model);
    let thinned = points.as_deref().and_then(|points| {
        let model = unknowns.model.subsample(points)?;
        Some((model, target.thinned(points)))
    });
    let (few, part) = match &thinned {
        Some((model, part)) => (unknowns.with(model.as_ref()), part),
        None => (unknowns.with(unknowns.model), target),
    };
    let searched = part.friction.len();
    let freedoms = searched.saturating_sub(unknowns.sought.len()).max(1);
    let floor = target.floor();
    let mut ends = minima(&few, part, &lengths, &starts, watch);
    let (mut tried, most) = (starts.len(), MOST_MORE * starts.len());
    while tried >= ENOUGH && tried < most && agreeing(&ends, floor) < ENOUGH {
        let more: Vec<Vec<f64>> = (tried..2 * tried).map(start).collect();
        ends.extend(minima(&few, part, &lengths, &more, watch));
        tried *= 2;
    }
    ends.sort_by(|a, b| a.cost.total_cmp(&b.cost));
    let found = ends.len();
    let candidates = distinct(ends, floor, freedoms);
    let places = candidates.iter().map(|(end, _)| unknowns.in_order(&end.q));
    let places: Vec<Vec<f64>> = places.collect();
    let refined = descents(unknowns, (target, ROUGH), &lengths, &places, watch);
    let counted = refined.into_iter().zip(&candidates);
    let counted = counted.filter_map(|(end, (_, count))| Some((end?, *count)));
    let mut candidates: Vec<_> = counted.collect();
    candidates.sort_by(|(a, _), (b, _)| a.cost.total_cmp(&b.cost));
    if candidates.is_empty() {
        return Err(FitError::NoStart);
    }
    Ok(Search {
        minima: candidates,
        lengths,
        starts: found,
        searched,
    })
}

/// Number of searches that ended at the best minimum so far.
fn agreeing(ends: &[Minimum], floor: f64) -> usize {
    let least = ends
        .iter()
        .fold(f64::INFINITY, |least, end| end.cost.min(least));
    let same = |end: &&Minimum| end.cost <= least * (1.0 + SAME) + floor;
    ends.iter().filter(same).count()
}

/// The problem of a model on a target.
pub(super) fn problem<'a>(
    residuals: &'a super::jacobian::Residuals<'a>,
    unknowns: &Unknowns<'_>,
    target: &WeightedData,
    lengths: &[DifferenceScale],
) -> Problem<'a> {
    Problem {
        residuals,
        bounds: unknowns.bounds(),
        lengths: lengths.to_vec(),
        floor: target.floor(),
        offset: OFFSET,
        stall: Stall::of(OFFSET),
    }
}

/// Ends of the searches from starts that linear least squares improve, in their order.
fn minima(
    unknowns: &Unknowns<'_>,
    target: &WeightedData,
    lengths: &[DifferenceScale],
    starts: &[Vec<f64>],
    watch: &ProgressWatch<'_>,
) -> Vec<Minimum> {
    let places: Vec<Vec<f64>> = starts
        .iter()
        .map(|start| improved(unknowns, target, start))
        .collect();
    let ends = descents(unknowns, (target, ROUGH), lengths, &places, watch);
    ends.into_iter().flatten().collect()
}

/// The end of a search from each place at a relative offset.
pub(super) fn descents(
    unknowns: &Unknowns<'_>,
    (target, offset): (&WeightedData, f64),
    lengths: &[DifferenceScale],
    places: &[Vec<f64>],
    watch: &ProgressWatch<'_>,
) -> Vec<Option<Minimum>> {
    let residuals = |q: &[f64]| target.residuals(unknowns, q);
    let mut problem = problem(&residuals, unknowns, target, lengths);
    problem.offset = offset;
    problem.stall = Stall::of(offset);
    let descent = |index: usize| {
        let mut step = |steps| {
            watch(FitProgress {
                points: target.friction.len(),
                search: [index + 1, places.len()],
                steps,
            });
        };
        minimise(&problem, &places[index], &mut step)
    };
    // Independent of the number of threads.
    let threads = std::thread::available_parallelism().map_or(1, usize::from);
    if threads == 1 || places.len() == 1 {
        return (0..places.len()).map(descent).collect();
    }
    let ends = in_order(places.len(), threads, descent);
    ends.into_iter().map(Option::flatten).collect()
}

/// Different minima by rising cost, with the number of searches that ended there: the best, and
/// those that the points hardly distinguish from it.
fn distinct(sorted: Vec<Minimum>, floor: f64, freedoms: usize) -> Vec<(Minimum, usize)> {
    let least = sorted.first().map_or(0.0, |best| best.cost);
    let alike = least + ALIKE * least / freedoms as f64 + floor;
    let mut all: Vec<(Minimum, usize)> = Vec::new();
    for end in sorted {
        let is_last = all.len() == MOST_REFINED;
        match all.last_mut() {
            Some((last, count)) if end.cost <= last.cost * (1.0 + SAME) + floor => *count += 1,
            Some(_) if is_last || end.cost > alike => break,
            _ => all.push((end, 1)),
        }
    }
    all
}
