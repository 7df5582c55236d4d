//! Derivatives of residuals by differences.

use nalgebra::DMatrix;
use tribos_base::run::in_order;

/// Residuals as a function of the coordinates; `None` if the model refuses them.
pub(super) type Residuals<'a> = dyn Fn(&[f64]) -> Option<Vec<f64>> + Sync + 'a;

/// Length of a coordinate over which residuals change.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum DifferenceScale {
    /// An e-fold of the value: 1 of a logarithm.
    Fold,
    /// The coordinate itself, but not less than this.
    Own {
        /// > 0
        least: f64,
    },
}

impl DifferenceScale {
    fn at(self, q: f64) -> f64 {
        match self {
            Self::Fold => 1.0,
            Self::Own { least } if q.abs() <= least => least,
            Self::Own { .. } => q.abs(),
        }
    }

    /// The length at zero.
    pub fn least(self) -> f64 {
        self.at(0.0)
    }
}

/// Step of a central difference of fourth order, relative to the length: ε^(1/5), where
/// the errors of truncation and of rounding are alike, 3e-13.
const STEP: f64 = 7.400_959_797_414_05e-4;
/// Step of a central difference of second order: ε^(1/3), 4e-11.
const SHORT_STEP: f64 = 6.055_454_452_393_343e-6;

/// Order of central differences.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Order {
    /// Two evaluations a coordinate.
    Second,
    /// Four evaluations a coordinate.
    Fourth,
}

/// Number of residuals beyond which they are many: a difference is worth two threads.
const MANY: usize = 100_000;

impl Order {
    /// The finest that so many residuals are worth: of many the errors of second order, some 1e-10, are far below what
    /// noise leaves open.
    pub fn finest(residuals: usize) -> Self {
        if residuals > MANY {
            Self::Second
        } else {
            Self::Fourth
        }
    }
}

/// ∂r/∂q at `q`; a coordinate whose steps would leave its bounds, or are refused, gets one-sided
/// differences.
pub(super) fn jacobian(
    residuals: &Residuals<'_>,
    q: &[f64],
    here: &[f64],
    (bounds, lengths): (&[[f64; 2]], &[DifferenceScale]),
    order: Order,
) -> Option<DMatrix<f64>> {
    let mut jacobian = DMatrix::zeros(here.len(), q.len());
    for (j, mut column) in jacobian.column_iter_mut().enumerate() {
        let size = lengths[j].at(q[j]);
        let line = Line {
            residuals,
            place: q,
            index: j,
            bounds: bounds[j],
            are_many: here.len() > MANY,
        };
        let central = match order {
            Order::Second => line.short(SHORT_STEP * size),
            Order::Fourth => line.central(STEP * size),
        };
        let found = central
            .or_else(|| line.one_sided(SHORT_STEP * size, here))
            .or_else(|| line.one_sided(-SHORT_STEP * size, here))?;
        column.copy_from_slice(&found);
    }
    Some(jacobian)
}

/// Residuals along one coordinate.
struct Line<'a> {
    residuals: &'a Residuals<'a>,
    place: &'a [f64],
    index: usize,
    bounds: [f64; 2],
    /// Whether there are many residuals.
    are_many: bool,
}

impl Line<'_> {
    /// The residuals at a distance; `None` beyond the bounds.
    fn beyond(&self, shift: f64) -> Option<Vec<f64>> {
        let mut place = self.place.to_vec();
        let moved = place[self.index] + shift;
        let [low, high] = self.bounds;
        if !(low <= moved && moved <= high) {
            return None;
        }
        place[self.index] = moved;
        (self.residuals)(&place)
    }

    /// The residuals at a distance to either side, side by side where they are many.
    fn around(&self, shift: f64) -> Option<(Vec<f64>, Vec<f64>)> {
        let threads = std::thread::available_parallelism().map_or(1, usize::from);
        if !self.are_many || threads == 1 {
            return self.beyond(shift).zip(self.beyond(-shift));
        }
        let sides = [shift, -shift];
        let mut found = in_order(sides.len(), threads, |side| self.beyond(sides[side])).into_iter();
        let mut next = || found.next().flatten().flatten();
        next().zip(next())
    }

    /// Rounds the step so that the increment and the divisor are the same number.
    fn rounded(&self, step: f64) -> f64 {
        let at = self.place[self.index];
        (at + step) - at
    }

    /// (8 (f(h) − f(−h)) − (f(2h) − f(−2h)))/12h
    fn central(&self, step: f64) -> Option<Vec<f64>> {
        let h = self.rounded(step);
        let [far, near] = [2.0 * h, h].map(|h| self.around(h));
        let ((far_up, far_down), (mut up, down)) = far.zip(near)?;
        for (i, up) in up.iter_mut().enumerate() {
            *up = (8.0 * (*up - down[i]) - (far_up[i] - far_down[i])) / (12.0 * h);
        }
        Some(up)
    }

    /// (f(h) − f(−h))/2h
    fn short(&self, step: f64) -> Option<Vec<f64>> {
        let h = self.rounded(step);
        let (mut up, down) = self.around(h)?;
        for (up, down) in up.iter_mut().zip(&down) {
            *up = (*up - down) / (2.0 * h);
        }
        Some(up)
    }

    /// (4 f(h) − 3 f(0) − f(2h))/2h
    fn one_sided(&self, step: f64, here: &[f64]) -> Option<Vec<f64>> {
        let h = self.rounded(step);
        let (near, far) = self.beyond(h).zip(self.beyond(2.0 * h))?;
        let slope = |i: usize| (4.0 * near[i] - 3.0 * here[i] - far[i]) / (2.0 * h);
        Some((0..near.len()).map(slope).collect())
    }
}
