//! Several searches from starts that are spread evenly.

use super::Measurements;
use super::error::FitError;
use super::halton::halton;
use super::jacobian::DifferenceScale;
use super::minimise::{Minimum, Problem, minimise};
use super::sample::{WeightedData, sample};
use super::unknowns::Unknowns;
use nalgebra::DMatrix;

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

/// The best of several searches.
pub(super) struct Search {
    /// The best minimum.
    pub best: Minimum,
    /// Residuals r at the minimum, in units of 1/[`Self::unit`].
    pub residuals: Vec<f64>,
    /// Jacobian ∂r/∂q at the minimum.
    pub jacobian: DMatrix<f64>,
    /// Bounds of the coordinates.
    pub bounds: Vec<[f64; 2]>,
    /// Lengths over which predictions change.
    pub lengths: Vec<DifferenceScale>,
    /// √Σ (data/σ)² in the unit of the residuals.
    pub size: f64,
    /// Factor by which residuals were multiplied.
    pub unit: f64,
    /// Starts from which a search was possible.
    pub starts: usize,
    /// Number of starts that ended at the best minimum.
    pub at_best: usize,
    /// Number of points on which the starts were searched.
    pub searched: usize,
}

/// Largest number of minima on a sample that are refined on all points.
const MOST_REFINED: usize = 3;
/// Minima whose costs on a sample differ by less than this many variances of a residual are alike:
/// five standard deviations of a likelihood's logarithm.
const ALIKE: f64 = 25.0;

/// Searches from all starts.
pub(super) fn search(
    unknowns: &Unknowns<'_>,
    data: &Measurements,
    starts: usize,
    watch: &mut dyn FnMut(FitProgress),
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
    let target = WeightedData::new(data);
    let points = sample(data);
    let thinned = points.as_deref().and_then(|points| {
        let model = unknowns.model.subsample(points)?;
        Some((model, target.thinned(points)))
    });
    let lengths = unknowns.lengths(&starts);
    let mut searched = measured.len();
    let mut ends = match &thinned {
        Some((model, part)) => {
            searched = part.friction.len();
            let few = unknowns.with(model.as_ref());
            minima(&few, part, &lengths, &starts, watch)
        }
        None => minima(unknowns, &target, &lengths, &starts, watch),
    };
    ends.sort_by(|a, b| a.cost.total_cmp(&b.cost));
    let found = ends.len();
    let floor = target.floor();
    let mut candidates = distinct(ends, floor, searched - unknowns.sought.len());
    if thinned.is_some() {
        let places: Vec<Vec<f64>> = candidates.iter().map(|(end, _)| end.q.clone()).collect();
        let refined = minima(unknowns, &target, &lengths, &places, watch);
        let counts = candidates.iter().map(|(_, count)| *count);
        candidates = refined
            .into_iter()
            .zip(counts.collect::<Vec<_>>())
            .collect();
    }
    let least = candidates
        .into_iter()
        .min_by(|(a, _), (b, _)| a.cost.total_cmp(&b.cost));
    let (best, at_best) = least.ok_or(FitError::NoStart)?;
    let problem = Problem {
        residuals: &|q: &[f64]| target.residuals(unknowns, q),
        repair: &|_: &mut [f64]| (),
        bounds: unknowns.bounds(),
        lengths,
        floor,
    };
    let residuals = target
        .residuals(unknowns, &best.q)
        .ok_or(FitError::NoStart)?;
    let jacobian = problem
        .slopes(&best.q, &residuals)
        .ok_or(FitError::NoStart)?;
    Ok(Search {
        residuals,
        jacobian,
        bounds: problem.bounds,
        lengths: problem.lengths,
        size: target.size(),
        unit: target.unit,
        starts: found,
        at_best,
        searched,
        best,
    })
}

/// Ends of the searches, in the order of their starts.
fn minima(
    unknowns: &Unknowns<'_>,
    target: &WeightedData,
    lengths: &[DifferenceScale],
    places: &[Vec<f64>],
    watch: &mut dyn FnMut(FitProgress),
) -> Vec<Minimum> {
    let problem = Problem {
        residuals: &|q: &[f64]| target.residuals(unknowns, q),
        repair: &|q: &mut [f64]| unknowns.repair(q),
        bounds: unknowns.bounds(),
        lengths: lengths.to_vec(),
        floor: target.floor(),
    };
    let ends = places.iter().enumerate().filter_map(|(index, place)| {
        let mut step = |steps| {
            watch(FitProgress {
                points: target.friction.len(),
                search: [index + 1, places.len()],
                steps,
            });
        };
        minimise(&problem, place, &mut step)
    });
    ends.collect()
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
