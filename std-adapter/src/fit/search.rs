//! Several searches from starts that are spread evenly.

use super::Data;
use super::estimate::FitError;
use super::jacobian::Length;
use super::minimise::{Minimum, Problem, minimise};
use super::parameter::{Model, Range};
use super::starts::halton;

/// Costs that differ relatively by less belong to the same minimum.
const SAME: f64 = 1e-6;

/// The parameters that are sought, and the values of the others.
pub(super) struct Unknowns<'a> {
    /// The model.
    pub model: &'a dyn Model,
    /// Values of those that are not sought.
    pub fixed: Vec<Option<f64>>,
    /// Numbers of those that are.
    pub sought: Vec<usize>,
}

impl<'a> Unknowns<'a> {
    /// All but the fixed ones and references.
    pub fn new(model: &'a dyn Model, given: &[(String, f64)]) -> Result<Self, FitError> {
        let fixed = fixed(model, given)?;
        let sought: Vec<usize> = (0..fixed.len()).filter(|&j| fixed[j].is_none()).collect();
        if sought.is_empty() {
            return Err(FitError::NothingFree);
        }
        Ok(Self {
            model,
            fixed,
            sought,
        })
    }

    /// All values from the coordinates of those that are sought.
    pub fn values(&self, q: &[f64]) -> Vec<f64> {
        let fixed = self.fixed.iter();
        let mut values: Vec<f64> = fixed.map(|value| value.unwrap_or(f64::NAN)).collect();
        for (&j, &x) in self.sought.iter().zip(q) {
            values[j] = self.range(j).value(x);
        }
        values
    }

    /// The coordinates of values.
    fn coordinates(&self, values: &[f64]) -> Vec<f64> {
        let sought = self.sought.iter();
        sought
            .map(|&j| self.range(j).coordinate(values[j]))
            .collect()
    }

    fn range(&self, j: usize) -> Range {
        self.model.parameters()[j].range
    }

    /// Moves coordinates to the nearest that the law admits; untouched ones keep their bits.
    fn repair(&self, q: &mut [f64]) {
        let before = self.values(q);
        let mut values = before.clone();
        let is_free: Vec<bool> = self.fixed.iter().map(Option::is_none).collect();
        self.model.repair(&mut values, &is_free);
        for (x, &j) in q.iter_mut().zip(&self.sought) {
            if values[j] != before[j] {
                *x = self.range(j).coordinate(values[j]);
            }
        }
    }

    /// Over which lengths predictions change: of what has no logarithm, a thousandth of the largest
    /// start at least, as it may come near zero.
    fn lengths(&self, starts: &[Vec<f64>]) -> Vec<Length> {
        const SHARE: f64 = 1e-3;
        let largest = |k: usize| starts.iter().map(|q| q[k].abs()).fold(0.0, f64::max);
        let length = |(k, &j): (usize, &usize)| match self.range(j) {
            Range::Positive => Length::Fold,
            _ if largest(k) > 0.0 => Length::Own {
                least: SHARE * largest(k),
            },
            _ => Length::Own { least: SHARE },
        };
        self.sought.iter().enumerate().map(length).collect()
    }
}

/// Values of the parameters that are not sought.
fn fixed(model: &dyn Model, given: &[(String, f64)]) -> Result<Vec<Option<f64>>, FitError> {
    let all = model.parameters();
    let mut fixed: Vec<_> = (0..all.len()).map(|j| model.reference(j)).collect();
    for (name, value) in given {
        let Some(j) = all.iter().position(|parameter| parameter.name == name) else {
            return Err(FitError::NoParameter {
                name: name.clone(),
                known: all.iter().map(|parameter| parameter.name).collect(),
            });
        };
        if !all[j].range.admits(*value) {
            return Err(FitError::Range {
                name: all[j].name,
                range: all[j].range.describe(),
                given: *value,
            });
        }
        fixed[j] = Some(*value);
    }
    Ok(fixed)
}

/// The best of several searches.
pub(super) struct Search {
    /// Where it ended.
    pub best: Minimum,
    /// Bounds of the coordinates.
    pub bounds: Vec<[f64; 2]>,
    /// Over which lengths predictions change.
    pub lengths: Vec<Length>,
    /// √Σ (data/σ)²
    pub size: f64,
    /// Starts from which a search was possible.
    pub starts: usize,
    /// How many of them ended at the best.
    pub at_best: usize,
}

/// Searches from all starts.
pub(super) fn search(
    unknowns: &Unknowns<'_>,
    data: &Data,
    starts: usize,
) -> Result<Search, FitError> {
    let measured = data.friction();
    if measured.len() <= unknowns.sought.len() {
        return Err(FitError::TooFew {
            points: measured.len(),
            free: unknowns.sought.len(),
        });
    }
    let weights: Vec<f64> = match data.sigma() {
        Some(sigma) => sigma.iter().map(|s| 1.0 / s).collect(),
        None => vec![1.0; measured.len()],
    };
    let residuals = |q: &[f64]| {
        let predicted = unknowns.model.predict(&unknowns.values(q))?;
        let pairs = measured.iter().zip(&predicted).zip(&weights);
        Some(pairs.map(|((f, p), w)| (p - f) * w).collect())
    };
    let all = unknowns.fixed.len();
    let start = |index: usize| unknowns.coordinates(&unknowns.model.start(&halton(index, all)));
    let points: Vec<Vec<f64>> = (0..starts.max(1)).map(start).collect();
    let weighted = measured.iter().zip(&weights).map(|(f, w)| f * w);
    let size = weighted.map(|x| x * x).sum::<f64>().sqrt();
    let problem = Problem {
        residuals: &residuals,
        repair: &|q: &mut [f64]| unknowns.repair(q),
        bounds: unknowns
            .sought
            .iter()
            .map(|&j| unknowns.range(j).bounds())
            .collect(),
        lengths: unknowns.lengths(&points),
        floor: f64::EPSILON * size * f64::EPSILON * size,
    };
    let ends = points.iter().filter_map(|point| minimise(&problem, point));
    let ends: Vec<Minimum> = ends.collect();
    let least = ends.iter().min_by(|a, b| a.cost.total_cmp(&b.cost));
    let best = least.ok_or(FitError::NoStart)?.clone();
    let limit = best.cost * (1.0 + SAME) + problem.floor;
    Ok(Search {
        starts: ends.len(),
        at_best: ends.iter().filter(|end| end.cost <= limit).count(),
        bounds: problem.bounds,
        lengths: problem.lengths,
        size,
        best,
    })
}
