//! How far impulses are from solving a contact problem, judged without the solvers' code.

use super::law::{ContactComponents, ContactThresholds, Friction};
use super::reduced::ReducedProblem;

/// Most components of a contact.
const MOST: usize = 6;

/// Residuals of impulses: 0 for a solution.
///
/// Both are sizes of the natural map r − P_K(r − ũ) over all contacts, with K the set of impulses that the laws
/// admit and ũ_N = u_N + Σ m_k |u_k| (De Saxcé and Feng 1998).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ProblemResidual {
    /// The map in the units of the problem, over the largest of |q|, |r| and |u|.
    ///
    /// It depends on the units of mass and length, and is weak for badly scaled problems.
    pub relative: f64,
    /// The map in scaled unknowns, over |r|: W has a mean diagonal of one third at every contact, in each mode.
    pub scaled: f64,
    /// Largest speed at which a contact closes.
    pub penetration: f64,
    /// Largest error of a normal speed that rounding of W r does not explain, over the largest |q| (or the largest
    /// velocity under the pull of cohesion): the speed of a contact that pushes, or closes.
    ///
    /// Both sizes of the map are relative to impulses. Where heavy bodies lie on light ones, or a problem has no
    /// solution, impulses may hide the map; this number is the relative error of what accelerates. Rounding
    /// explains at most 1e-6 of the largest |q|: where it blurs a speed by more, the blur counts as an error.
    pub speed: f64,
}

/// Largest [`ProblemResidual::speed`] of a solution, in units of its tolerance: where a heavy body lies on a light one, this
/// is the error of the force.
const SPEED: f64 = 100.0;
/// Largest share of |q| that rounding may explain: that of the default tolerance. Beside impulses that blur more,
/// speeds mean nothing.
const COARSEST: f64 = 1e-6;

impl ProblemResidual {
    /// The larger of both sizes of the map; NaN if either is.
    #[must_use]
    pub fn largest(&self) -> f64 {
        if self.relative >= self.scaled {
            self.relative
        } else {
            self.scaled
        }
    }

    /// The larger of [`Self::largest`] and the error of normal speeds, in units of the tolerance; NaN if either is.
    pub(super) fn worst(&self) -> f64 {
        let (map, speed) = (self.largest(), self.speed / SPEED);
        if map >= speed || map.is_nan() {
            map
        } else {
            speed
        }
    }

    /// Whether both sizes are at most `tolerance`, and [`ProblemResidual::speed`] at most a hundred times it: no contact
    /// closes faster than at the larger of a hundred times the tolerance and 1e-6, times the largest |q|.
    #[must_use]
    pub fn meets(&self, tolerance: f64) -> bool {
        self.relative <= tolerance && self.scaled <= tolerance && self.speed <= SPEED * tolerance
    }
}

/// Judges impulses in the units and in the order of the problem.
///
/// ```
/// use tribos::problem::{ContactThresholds, ContactComponents, SparseMatrix, ReducedProblem, residual};
/// let w = SparseMatrix::from_triplets([3, 3], &[(0, 0, 0.5), (1, 1, 0.5), (2, 2, 0.5)])?;
/// let fall = ReducedProblem::new(ContactComponents::Space, w, vec![-3.0, 4.0, 0.0], vec![ContactThresholds::coulomb(0.5)])?;
/// assert!(residual(&fall, &[6.0, -3.0, 0.0]).largest() < 1e-15);
/// assert_eq!(residual(&fall, &[0.0, 0.0, 0.0]).penetration, 3.0);
/// # Ok::<(), tribos::problem::ProblemError>(())
/// ```
///
/// # Panics
/// If there are fewer impulses than the problem has.
#[must_use]
pub fn residual(problem: &ReducedProblem, r: &[f64]) -> ProblemResidual {
    let (sums, u) = (problem.rounding(r), problem.velocities(r));
    let size = problem.layout.size();
    let largest = largest(problem, &problem.without_cohesion());
    // The map grows with impulses and velocities alike: in these units squares keep their digits.
    let unit = if largest > 0.0 { largest } else { 1.0 };
    let mut plain = Sum::default();
    let mut scaled = Sum::default();
    let (mut penetration, mut unexplained) = (0.0_f64, 0.0_f64);
    for (contact, law) in problem.laws.iter().enumerate() {
        let range = contact * size..(contact + 1) * size;
        let (mut diagonal, mut local) = ([0.0; MOST], [[0.0; MOST]; 2]);
        for (at, from) in range.enumerate() {
            diagonal[at] = problem.diagonal(from);
            local[0][at] = r[from];
            local[1][at] = u[from];
        }
        let [mut r, mut u] = local;
        r[0] += law.cohesion;
        penetration = penetration.max(-u[0]);
        // Either nothing pushes or nothing closes.
        let error = u[0].min(r[0] * diagonal[0]).abs();
        let blur = f64::EPSILON * sums[contact * size];
        let is_resolved = largest == 0.0 || error.max(blur) <= COARSEST * largest;
        unexplained = unexplained.max(if is_resolved {
            error - blur
        } else {
            error.max(blur)
        });
        for x in r.iter_mut().chain(&mut u) {
            *x /= unit;
        }
        plain.add(&r, &u, &modes(problem.layout, law, None));
        let own = &diagonal[..size];
        scaled.add(&r, &u, &modes(problem.layout, law, Some(own)));
    }
    let norm = |x: &[f64]| {
        let sum: f64 = x.iter().map(|x| (x / unit) * (x / unit)).sum();
        sum.sqrt()
    };
    let scale = norm(&problem.q).max(norm(r)).max(norm(&u));
    ProblemResidual {
        relative: ratio(plain.map_sq.sqrt(), scale),
        scaled: ratio(scaled.map_sq.sqrt(), scaled.size_sq.sqrt()),
        penetration,
        speed: ratio(unexplained, largest),
    }
}

/// Largest speed without impulses, and with the pull of cohesion alone.
fn largest(problem: &ReducedProblem, pulled: &[f64]) -> f64 {
    let speeds = problem.q.iter().chain(pulled);
    speeds.fold(0.0_f64, |most, q| most.max(q.abs()))
}

/// Largest speed at which a contact closes in a solution to `tolerance`, and largest blur of a speed by rounding.
pub(super) fn allowed(problem: &ReducedProblem, pulled: &[f64], tolerance: f64) -> f64 {
    COARSEST.max(SPEED * tolerance) * largest(problem, pulled)
}

fn ratio(part: f64, whole: f64) -> f64 {
    if part == 0.0 { 0.0 } else { part / whole }
}

/// One mode: a few components with their units, and the threshold in those units.
#[derive(Clone, Copy, Debug, Default)]
struct ModeTerms {
    components: [(usize, f64); 3],
    count: usize,
    threshold: f64,
}

impl ModeTerms {
    fn new(range: std::ops::Range<usize>, unit: f64, threshold: f64) -> Self {
        let mut mode = Self {
            threshold,
            ..Self::default()
        };
        mode.extend(range, unit);
        mode
    }

    fn extend(&mut self, range: std::ops::Range<usize>, unit: f64) {
        for at in range {
            self.components[self.count] = (at, unit);
            self.count += 1;
        }
    }

    /// The mode's part of an impulse and of a velocity.
    fn part(&self, r: &[f64], u: &[f64]) -> [[f64; 3]; 2] {
        let mut parts = [[0.0; 3]; 2];
        for (place, &(at, unit)) in self.components[..self.count].iter().enumerate() {
            parts[0][place] = r[at] / unit;
            parts[1][place] = u[at] * unit;
        }
        parts
    }
}

/// Modes of a contact, at most three, and the unit of its normal component; in the units of the problem or scaled by
/// its diagonal. Those without a threshold remain, with a threshold of zero.
fn modes(
    layout: ContactComponents,
    law: &ContactThresholds,
    diagonal: Option<&[f64]>,
) -> ([ModeTerms; 3], f64) {
    let unit = |range: std::ops::Range<usize>| -> f64 {
        let Some(diagonal) = diagonal else { return 1.0 };
        let count = range.len().max(1) as f64;
        let mean: f64 = diagonal
            .get(range)
            .map_or(0.0, |part| part.iter().sum::<f64>() / count);
        if mean > 0.0 {
            (mean * 3.0).sqrt().recip()
        } else {
            1.0
        }
    };
    let normal = unit(0..layout.sliding().end);
    let own = |range: std::ops::Range<usize>, threshold: f64| {
        let unit = unit(range.clone());
        ModeTerms::new(range, unit, threshold * normal / unit)
    };
    let mut sliding = ModeTerms::new(layout.sliding(), normal, law.sliding);
    let rolling = own(layout.rolling(), law.rolling);
    let joint = law.friction == Friction::Ellipsoid && law.sliding > 0.0 && law.torsion > 0.0;
    let torsion = if joint {
        // In units in which the set is a ball.
        sliding.extend(layout.torsion(), normal * law.torsion / law.sliding);
        ModeTerms::default()
    } else {
        own(layout.torsion(), law.torsion)
    };
    ([sliding, rolling, torsion], normal)
}

fn length(x: &[f64; 3]) -> f64 {
    (x[0] * x[0] + x[1] * x[1] + x[2] * x[2]).sqrt()
}

#[derive(Default)]
struct Sum {
    map_sq: f64,
    size_sq: f64,
}

impl Sum {
    /// Adds |r − P_K(r − ũ)|² of a contact.
    fn add(&mut self, r: &[f64], u: &[f64], (modes, unit): &([ModeTerms; 3], f64)) {
        let (normal, mut speed) = (r[0] / unit, u[0] * unit);
        let mut trials = [Trial::default(); 3];
        for (trial, mode) in trials.iter_mut().zip(modes) {
            let [r, u] = mode.part(r, u);
            speed += mode.threshold * length(&u);
            let point = std::array::from_fn(|at| r[at] - u[at]);
            *trial = Trial {
                from: r,
                length: length(&point),
                point,
                threshold: mode.threshold,
            };
        }
        let nearest = nearest(normal - speed, &trials);
        let mut add = |r: f64, nearest: f64| {
            self.map_sq += (r - nearest) * (r - nearest);
            self.size_sq += r * r;
        };
        add(normal, nearest);
        for trial in &trials {
            let limit = trial.threshold * nearest;
            let factor = if trial.length > limit {
                limit / trial.length
            } else {
                1.0
            };
            for (r, x) in trial.from.iter().zip(&trial.point) {
                add(*r, x * factor);
            }
        }
    }
}

/// r and r − u of one mode, and the length of the latter.
#[derive(Clone, Copy, Debug, Default)]
struct Trial {
    from: [f64; 3],
    point: [f64; 3],
    length: f64,
    threshold: f64,
}

/// Normal component of the nearest point of K: the P ≥ 0 at which the slope of half the square of the distance,
/// (P − n) − Σ m_k max(|x_k| − m_k P, 0), is zero, or 0 if it is positive there.
fn nearest(normal: f64, trials: &[Trial; 3]) -> f64 {
    let slope = |p: f64| {
        let beyond = |length: f64, m: f64| m * (length - m * p).max(0.0);
        (p - normal)
            - trials
                .iter()
                .map(|trial| beyond(trial.length, trial.threshold))
                .sum::<f64>()
    };
    if normal.is_nan() {
        return f64::NAN;
    }
    if slope(0.0) >= 0.0 {
        return 0.0;
    }
    let mut best = normal.max(0.0);
    for set in 1..1_usize << trials.len() {
        let (mut sum, mut steep) = (normal, 1.0);
        for (number, trial) in trials.iter().enumerate() {
            if set >> number & 1 == 1 {
                sum += trial.threshold * trial.length;
                steep += trial.threshold * trial.threshold;
            }
        }
        let candidate = (sum / steep).max(0.0);
        if slope(candidate).abs() < slope(best).abs() {
            best = candidate;
        }
    }
    best
}
