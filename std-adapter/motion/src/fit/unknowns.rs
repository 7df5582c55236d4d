//! What a fit seeks: the free parameters of a model.

use super::error::FitError;
use super::jacobian::DifferenceScale;
use super::parameter::{Model, Range};
use nalgebra::DMatrix;

/// The free parameters, and the values of the fixed ones.
///
/// A free parameter that must not be below another is sought as its excess over that one.
pub(super) struct Unknowns<'a> {
    /// The model.
    pub model: &'a dyn Model,
    /// Values of the parameters that are not free.
    pub fixed: Vec<Option<f64>>,
    /// Indices of the free parameters.
    pub sought: Vec<usize>,
}

impl<'a> Unknowns<'a> {
    /// All parameters except the fixed ones and references.
    pub fn new(model: &'a dyn Model, given: &[(String, f64)]) -> Result<Self, FitError> {
        let fixed = fixed(model, given)?;
        let unknowns = Self::with_fixed(model, fixed);
        if unknowns.sought.is_empty() {
            return Err(FitError::NothingFree);
        }
        Ok(unknowns)
    }

    /// All parameters that are not fixed.
    pub fn with_fixed(model: &'a dyn Model, fixed: Vec<Option<f64>>) -> Self {
        let sought = (0..fixed.len()).filter(|&j| fixed[j].is_none()).collect();
        Self {
            model,
            fixed,
            sought,
        }
    }

    /// The same unknowns for another model with the same parameters.
    pub fn with<'b>(&self, model: &'b dyn Model) -> Unknowns<'b> {
        Unknowns::with_fixed(model, self.fixed.clone())
    }

    /// The same with one more parameter kept.
    pub fn keeping(&self, parameter: usize, value: f64) -> Self {
        let mut fixed = self.fixed.clone();
        fixed[parameter] = Some(value);
        Self::with_fixed(self.model, fixed)
    }

    /// All values from the coordinates of the free parameters.
    pub fn values(&self, q: &[f64]) -> Vec<f64> {
        let fixed = self.fixed.iter();
        let mut values: Vec<f64> = fixed.map(|value| value.unwrap_or(f64::NAN)).collect();
        for (&j, &x) in self.sought.iter().zip(q) {
            values[j] = match self.model.above(j) {
                None => self.range(j).value(x),
                Some(_) => x,
            };
        }
        for &j in &self.sought {
            if let Some(low) = self.model.above(j) {
                values[j] += values[low];
            }
        }
        values
    }

    /// The coordinates of values.
    pub fn coordinates(&self, values: &[f64]) -> Vec<f64> {
        let sought = self.sought.iter();
        let coordinates = sought.map(|&j| match self.model.above(j) {
            None => self.range(j).coordinate(values[j]),
            Some(low) => (values[j] - values[low]).max(0.0),
        });
        coordinates.collect()
    }

    /// The coordinates with parts of the model that are alike in their order, if none of them is fixed.
    pub fn in_order(&self, q: &[f64]) -> Vec<f64> {
        let mut values = self.values(q);
        self.model.put_in_order(&mut values);
        let mut fixed = self.fixed.iter().zip(&values);
        if fixed.all(|(fixed, value)| fixed.is_none_or(|fixed| fixed == *value)) {
            self.coordinates(&values)
        } else {
            q.to_vec()
        }
    }

    /// Bounds of the coordinates.
    pub fn bounds(&self) -> Vec<[f64; 2]> {
        let sought = self.sought.iter();
        sought.map(|&j| self.bounds_of(j)).collect()
    }

    fn bounds_of(&self, j: usize) -> [f64; 2] {
        let [least, most] = self.model.limits(j);
        if self.model.above(j).is_some() {
            return [0.0, most.max(0.0)];
        }
        // A fixed parameter that must not be below this one limits it.
        let most = (0..self.fixed.len())
            .filter(|&high| self.model.above(high) == Some(j))
            .filter_map(|high| self.fixed[high])
            .fold(most, f64::min);
        let range = self.range(j);
        let [low, high] = range.bounds();
        let inside = |value: f64, otherwise: f64| {
            if value.is_finite() && range.admits(value) {
                range.coordinate(value)
            } else {
                otherwise
            }
        };
        let (low, high) = (inside(least, low).max(low), inside(most, high).min(high));
        [low.min(high), high]
    }

    /// ∂value/∂coordinate: a row for each sought parameter.
    pub fn slopes(&self, values: &[f64]) -> DMatrix<f64> {
        let count = self.sought.len();
        let mut slopes = DMatrix::zeros(count, count);
        for (row, &j) in self.sought.iter().enumerate() {
            let Some(low) = self.model.above(j) else {
                slopes[(row, row)] = self.range(j).derivative(values[j]);
                continue;
            };
            slopes[(row, row)] = 1.0;
            if let Some(column) = self.sought.iter().position(|&k| k == low) {
                slopes[(row, column)] = self.range(low).derivative(values[low]);
            }
        }
        slopes
    }

    fn range(&self, j: usize) -> Range {
        self.model.parameters()[j].range
    }

    /// Lengths over which predictions change: without logarithm at least a thousandth of the
    /// largest start, since the parameter may approach zero.
    pub fn lengths(&self, starts: &[Vec<f64>]) -> Vec<DifferenceScale> {
        const SHARE: f64 = 1e-3;
        let largest = |k: usize| starts.iter().map(|q| q[k].abs()).fold(0.0, f64::max);
        let length = |(k, &j): (usize, &usize)| match self.range(j) {
            Range::Positive if self.model.above(j).is_none() => DifferenceScale::Fold,
            _ if largest(k) > 0.0 => DifferenceScale::Own {
                least: SHARE * largest(k),
            },
            _ => DifferenceScale::Own { least: SHARE },
        };
        self.sought.iter().enumerate().map(length).collect()
    }
}

/// Values of the parameters that are not free.
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
