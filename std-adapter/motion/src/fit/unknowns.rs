//! What a fit seeks: the free parameters of a model.

use super::error::FitError;
use super::jacobian::DifferenceScale;
use super::parameter::{Model, Range};

/// The free parameters, and the values of the fixed ones.
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

    /// All values from the coordinates of the free parameters.
    pub fn values(&self, q: &[f64]) -> Vec<f64> {
        let fixed = self.fixed.iter();
        let mut values: Vec<f64> = fixed.map(|value| value.unwrap_or(f64::NAN)).collect();
        for (&j, &x) in self.sought.iter().zip(q) {
            values[j] = self.range(j).value(x);
        }
        values
    }

    /// The coordinates of values.
    pub fn coordinates(&self, values: &[f64]) -> Vec<f64> {
        let sought = self.sought.iter();
        sought
            .map(|&j| self.range(j).coordinate(values[j]))
            .collect()
    }

    /// The same unknowns for another model with the same parameters.
    pub fn with<'b>(&self, model: &'b dyn Model) -> Unknowns<'b> {
        Unknowns {
            model,
            fixed: self.fixed.clone(),
            sought: self.sought.clone(),
        }
    }

    /// Bounds of the coordinates.
    pub fn bounds(&self) -> Vec<[f64; 2]> {
        let sought = self.sought.iter();
        sought.map(|&j| self.range(j).bounds()).collect()
    }

    fn range(&self, j: usize) -> Range {
        self.model.parameters()[j].range
    }

    /// Moves coordinates to the nearest that the law admits; unchanged ones keep their bits.
    pub fn repair(&self, q: &mut [f64]) {
        let before = self.values(q);
        let mut values = before.clone();
        let is_free: Vec<bool> = self.fixed.iter().map(Option::is_none).collect();
        self.model.project_to_valid(&mut values, &is_free);
        for (x, &j) in q.iter_mut().zip(&self.sought) {
            if values[j] != before[j] {
                *x = self.range(j).coordinate(values[j]);
            }
        }
    }

    /// Lengths over which predictions change: without logarithm at least a thousandth of the
    /// largest start, since the parameter may approach zero.
    pub fn lengths(&self, starts: &[Vec<f64>]) -> Vec<DifferenceScale> {
        const SHARE: f64 = 1e-3;
        let largest = |k: usize| starts.iter().map(|q| q[k].abs()).fold(0.0, f64::max);
        let length = |(k, &j): (usize, &usize)| match self.range(j) {
            Range::Positive => DifferenceScale::Fold,
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
