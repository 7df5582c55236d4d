//! Levenberg–Marquardt within bounds.

use super::jacobian::{DifferenceScale, Order, Residuals, jacobian};
use super::reduce::{Reduced, reduced};
use nalgebra::{DMatrix, DVector};

/// A sum of squares to be minimised.
pub(super) struct Problem<'a> {
    /// r(q)
    pub residuals: &'a Residuals<'a>,
    /// Bounds of the coordinates.
    pub bounds: Vec<[f64; 2]>,
    /// Length over which residuals change, for each coordinate.
    pub lengths: Vec<DifferenceScale>,
    /// Sum of squares below which residuals are rounding errors.
    pub floor: f64,
    /// Fraction of the residuals' length that a Gauss–Newton step would remove (the relative offset of
    /// Bates and Watts 1981) below which a search has converged: parameters are good to this fraction of
    /// their standard errors.
    pub offset: f64,
    /// When to give up.
    pub stall: Stall,
}

impl Problem<'_> {
    /// ∂r/∂q; `None` where it is not finite.
    pub fn slopes(&self, q: &[f64], residuals: &[f64], order: Order) -> Option<DMatrix<f64>> {
        let ranges = (self.bounds.as_slice(), self.lengths.as_slice());
        let slopes = jacobian(self.residuals, q, residuals, ranges, order)?;
        slopes.iter().all(|x| x.is_finite()).then_some(slopes)
    }
}

/// Result of a search.
#[derive(Clone, Debug)]
pub(super) struct Minimum {
    /// q
    pub q: Vec<f64>,
    /// Σ r²
    pub cost: f64,
    /// Whether only rounding, or a kink, limits further descent.
    pub converged: bool,
    /// Steps taken.
    pub iterations: usize,
}

/// Largest number of steps of a search.
const MOST: usize = 400;
/// First damping, relative to squares of singular values of the scaled Jacobian.
const FIRST_DAMPING: f64 = 1e-3;
/// Damping under which steps are lost in rounding.
const LAST_DAMPING: f64 = 1e20;
/// The relative offset of a fit.
pub(super) const OFFSET: f64 = 1e-9;
/// The offset below which undamped steps are taken without checking the cost, whose last digits no
/// longer show the descent.
const NEAR: f64 = 1e-5;
/// The offset below which derivatives are taken to fourth order.
const PRECISE: f64 = 1e-3;
/// If such a step overshoots and the offset grows, later steps are halved; below this fraction only
/// rounding changes the offset.
const SHORTEST: f64 = 1.0 / 64.0;
/// Part of a standard error that a step would still change where rounding or a kink ends the descent, and the search
/// counts as converged.
const SMALL: f64 = 0.1;

/// Singular value over the largest below which a direction has no effect, so no step is taken along it.
const FLAT: f64 = 1e-10;
/// The same for a direction that the data do not determine: the errors of differences are larger than its effect.
const LOOSE: f64 = 1e-7;

/// When a search has stalled: where a law has kinks, descent may go on for long without a gain.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Stall {
    /// Decrease of the cost in a step, over its excess, that is a gain.
    pub share: f64,
    /// The cost above which the excess counts.
    pub above: f64,
    /// Number of steps in a row without a gain.
    pub steps: usize,
}

impl Stall {
    /// All that is left to gain is far below what tells two values apart.
    pub const PRECISE: Self = Self {
        share: 1e-10,
        above: 0.0,
        steps: 10,
    };
    /// Of a search that another one continues.
    pub const ROUGH: Self = Self {
        share: 1e-7,
        steps: 3,
        ..Self::PRECISE
    };

    /// For a search that ends at a relative offset.
    pub fn of(offset: f64) -> Self {
        /// From here on others continue the search.
        const ROUGH: f64 = 1e-4;
        if offset >= ROUGH {
            Self::ROUGH
        } else {
            Self::PRECISE
        }
    }
}

/// Searches from `start`, and passes the number of each step to `watch`; `None` if the model refuses `start`.
pub(super) fn minimise(
    problem: &Problem<'_>,
    start: &[f64],
    watch: &mut dyn FnMut(usize),
) -> Option<Minimum> {
    let mut place = Iterate::at(problem, start.to_vec())?;
    let mut pace = DampingControl {
        damping: FIRST_DAMPING,
        growth: 2.0,
        share: 1.0,
        last_offset: f64::INFINITY,
    };
    let mut iterations = 0;
    let mut order = Order::Second;
    let (mut stalled, mut least) = (0, f64::INFINITY);
    loop {
        let Iterate { q, residuals, cost } = &place;
        watch(iterations);
        let slopes = problem.slopes(q, residuals, order)?;
        let step = Step::new(problem, q, residuals, &slopes);
        let offset = step.offset(*cost, FLAT);
        if offset <= PRECISE {
            order = Order::finest(residuals.len());
        }
        let is_done = *cost <= problem.floor || offset <= problem.offset;
        let is_stalled = stalled == problem.stall.steps;
        let is_over = iterations == MOST || is_stalled;
        let next = if is_done || is_over {
            None
        } else if offset <= NEAR {
            pace.approach(problem, &place, &step, offset)
        } else {
            pace.descend(problem, &place, &step)
        };
        match next {
            Some(next) => {
                let worth = problem.stall.share * (place.cost - problem.stall.above).abs();
                let closer = offset < 0.5 * least;
                if closer {
                    least = offset;
                }
                let gains = place.cost - next.cost > worth || closer;
                stalled = if gains { 0 } else { stalled + 1 };
                place = next;
            }
            None => {
                let part = step.offset(place.cost, LOOSE) * (place.residuals.len() as f64).sqrt();
                return Some(Minimum {
                    q: place.q,
                    cost: place.cost,
                    converged: is_done || part <= SMALL,
                    iterations,
                });
            }
        }
        iterations += 1;
    }
}

/// A point of the search.
struct Iterate {
    q: Vec<f64>,
    residuals: Vec<f64>,
    cost: f64,
}

impl Iterate {
    /// The point within the bounds nearest to `q`; `None` if the model refuses it.
    fn at(problem: &Problem<'_>, mut q: Vec<f64>) -> Option<Self> {
        admit(problem, &mut q);
        let residuals = (problem.residuals)(&q)?;
        let cost = residuals.iter().map(|r| r * r).sum::<f64>();
        cost.is_finite().then_some(Self { q, residuals, cost })
    }
}

/// Step lengths.
struct DampingControl {
    damping: f64,
    growth: f64,
    /// Fraction of an undamped step.
    share: f64,
    last_offset: f64,
}

impl DampingControl {
    /// Tries ever shorter steps until one descends; `None` if rounding hides all.
    fn descend(&mut self, problem: &Problem<'_>, place: &Iterate, step: &Step) -> Option<Iterate> {
        while self.damping <= LAST_DAMPING {
            let mut trial = place.q.clone();
            let predicted = step.take(self.damping, &mut trial);
            let below = Iterate::at(problem, trial).filter(|trial| trial.cost < place.cost);
            if let Some(below) = below {
                // Nielsen's rule: the better the linear model, the less damping.
                let gain = (place.cost - below.cost) / predicted;
                let surplus = 2.0 * gain - 1.0;
                let shrink = 1.0 - surplus * surplus * surplus;
                self.damping *= shrink.max(1.0 / 3.0);
                self.growth = 2.0;
                return Some(below);
            }
            self.damping *= self.growth;
            self.growth *= 2.0;
        }
        None
    }

    /// An undamped step, or a fraction of it if such steps overshoot; `None` if it only changes by
    /// rounding.
    fn approach(
        &mut self,
        problem: &Problem<'_>,
        place: &Iterate,
        step: &Step,
        offset: f64,
    ) -> Option<Iterate> {
        if offset > self.last_offset {
            self.share *= 0.5;
        }
        self.last_offset = offset;
        if self.share < SHORTEST {
            return None;
        }
        let mut trial = place.q.clone();
        step.take(0.0, &mut trial);
        for (x, at) in trial.iter_mut().zip(&place.q) {
            *x = at + self.share * (*x - at);
        }
        Iterate::at(problem, trial)
    }
}

/// Moves `q` into the bounds.
fn admit(problem: &Problem<'_>, q: &mut [f64]) {
    for (x, [low, high]) in q.iter_mut().zip(&problem.bounds) {
        *x = x.max(*low).min(*high);
    }
}

/// Jᵀ r
pub(super) fn gradient(slopes: &DMatrix<f64>, residuals: &[f64]) -> Vec<f64> {
    let along = |column: nalgebra::DVectorView<'_, f64>| -> f64 {
        column.iter().zip(residuals).map(|(a, b)| a * b).sum()
    };
    slopes.column_iter().map(along).collect()
}

/// Indices of coordinates that may move: all but those at a bound over which the descent points.
pub(super) fn free(q: &[f64], bounds: &[[f64; 2]], gradient: &[f64]) -> Vec<usize> {
    let is_held = |j: usize| {
        let [low, high] = bounds[j];
        (q[j] <= low && gradient[j] >= 0.0) || (q[j] >= high && gradient[j] <= 0.0)
    };
    (0..q.len()).filter(|&j| !is_held(j)).collect()
}

/// Steps from one point for any damping: J D⁻¹ = Q R, R = U Σ Vᵀ.
struct Step {
    free: Vec<usize>,
    scales: Vec<f64>,
    /// Uᵀ Qᵀ r
    shares: DVector<f64>,
    sigma: DVector<f64>,
    v_t: DMatrix<f64>,
}

impl Step {
    fn new(problem: &Problem<'_>, q: &[f64], here: &[f64], slopes: &DMatrix<f64>) -> Self {
        let gradient = gradient(slopes, here);
        let free = free(q, &problem.bounds, &gradient);
        if free.is_empty() {
            return Self {
                free,
                scales: Vec::new(),
                shares: DVector::zeros(0),
                sigma: DVector::zeros(0),
                v_t: DMatrix::zeros(0, 0),
            };
        }
        // Columns of length 1, so that units do not matter (Marquardt 1963).
        let Reduced {
            norms: scales,
            triangle,
            turned: top,
        } = reduced(slopes, &free, here);
        let svd = triangle.svd(true, true);
        let rows = svd.singular_values.len();
        // Both factors exist, since they were requested.
        let shares = svd.u.map_or(top.clone(), |u| u.tr_mul(&top));
        let v_t = svd
            .v_t
            .unwrap_or_else(|| DMatrix::identity(rows, free.len()));
        Self {
            free,
            scales,
            shares,
            sigma: svd.singular_values,
            v_t,
        }
    }

    /// Moves `q`; returns the decrease of the cost that the linear model predicts.
    fn take(&self, damping: f64, q: &mut [f64]) -> f64 {
        let mut predicted = 0.0;
        let most = self.sigma.iter().copied().fold(0.0, f64::max);
        let damped = self.sigma.zip_map(&self.shares, |s, c| {
            if s <= FLAT * most {
                return 0.0;
            }
            let share = s * s + damping;
            let kept = damping / share;
            predicted += c * c * (1.0 - kept * kept);
            -s * c / share
        });
        let step = self.v_t.tr_mul(&damped);
        for ((&j, y), scale) in self.free.iter().zip(step.iter()).zip(&self.scales) {
            q[j] += y / scale;
        }
        predicted
    }

    /// Length of the residuals that a full step would remove, as a fraction of the whole. No step goes where singular
    /// values are this share of the largest.
    fn offset(&self, cost: f64, flat: f64) -> f64 {
        let most = self.sigma.iter().copied().fold(0.0, f64::max);
        let pairs = self.sigma.iter().zip(self.shares.iter());
        let gained: f64 = pairs
            .filter(|(s, _)| **s > flat * most)
            .map(|(_, c)| c * c)
            .sum();
        (gained / cost).sqrt()
    }
}
