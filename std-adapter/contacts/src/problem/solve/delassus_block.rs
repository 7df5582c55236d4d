//! The solution of one contact with all others held.

use super::cone::{Cone, Local, Square, solve_small};
use super::natural::linearised;

/// Steps of the search for the multiplier of sliding.
const SEARCH: usize = 40;
/// Relative step after which the next one would be rounding: Newton's steps are squared.
const CLOSE: f64 = 1e-8;
/// Newton steps on the natural map, and projections where those do not lead on; relative size at which they end.
const STEPS: usize = 20;
const CLOSED: f64 = 1e-14;

/// W of one contact.
#[derive(Clone, Copy, Debug)]
pub(super) struct DelassusBlock {
    pub w: Square,
    /// Its inverse, if it has one.
    inverse: Option<Square>,
    /// 1/W_NN, and W_TT − W_TN W_NT/W_NN for two components of sliding.
    inv_normal: f64,
    sliding: [[f64; 2]; 2],
}

impl DelassusBlock {
    pub fn new(w: Square, size: usize) -> Self {
        let mut inverse = Some(Square::default());
        for column in 0..size {
            let mut unit = Local::default();
            unit[column] = 1.0;
            let solved = solve_small(w, unit, size);
            inverse = inverse.zip(solved).map(|(mut square, solved)| {
                for (row, value) in square.iter_mut().zip(solved) {
                    row[column] = value;
                }
                square
            });
        }
        let inv_normal = w[0][0].recip();
        let reduced =
            |row: usize, column: usize| w[row][column] - w[row][0] * w[0][column] * inv_normal;
        let mut sliding = [
            [reduced(1, 1), reduced(1, 2)],
            [reduced(2, 1), reduced(2, 2)],
        ];
        if size == 2 {
            sliding[1][1] = 1.0;
        }
        Self {
            w,
            inverse,
            inv_normal,
            sliding,
        }
    }
}

/// As [`solve_contact`] for |r_T| ≤ μ r_N with two components of sliding.
pub(super) fn solve_three(mu: f64, own: &DelassusBlock, q: [f64; 3]) -> [f64; 3] {
    if q[0] >= 0.0 {
        return [0.0; 3];
    }
    if let Some(inverse) = &own.inverse {
        let row = |row: usize| {
            let [a, b, c, ..] = inverse[row];
            -(a * q[0] + b * q[1] + c * q[2])
        };
        let [n, a, b] = [row(0), row(1), row(2)];
        if n >= 0.0 && (a * a + b * b).sqrt() <= mu * n {
            return [n, a, b];
        }
    }
    if own.w[0][0] > 0.0 {
        return slide(mu, own, q);
    }
    let mut all = Local::default();
    all[..3].copy_from_slice(&q);
    let mut cone = Cone::default();
    cone.push(2, mu);
    let [n, a, b, ..] = iterate(&cone, &own.w, &all, &Local::default());
    [n, a, b]
}

/// r with ũ ∈ K* ⊥ r ∈ K and u = W r + q for one contact's W; near `guess` where it is found by iteration.
pub(super) fn solve_contact(cone: &Cone, own: &DelassusBlock, q: &Local, guess: &Local) -> Local {
    let size = cone.size();
    let w = &own.w;
    // The contact opens.
    if q[0] >= 0.0 {
        return Local::default();
    }
    if size == 1 {
        let mut pushed = Local::default();
        pushed[0] = if w[0][0] > 0.0 {
            -q[0] / w[0][0]
        } else {
            guess[0]
        };
        return pushed;
    }
    // It sticks.
    if let Some(inverse) = &own.inverse {
        let mut stuck = Local::default();
        for (value, row) in stuck.iter_mut().zip(inverse).take(size) {
            *value = -row.iter().zip(q).map(|(a, b)| a * b).sum::<f64>();
        }
        let inside = |mode: &super::cone::Mode| mode.length(&stuck) <= mode.threshold * stuck[0];
        if stuck[0] >= 0.0 && cone.modes().iter().all(inside) {
            return stuck;
        }
    }
    match cone.modes() {
        [mode] if mode.end <= 3 && w[0][0] > 0.0 => {
            let mut out = Local::default();
            let slid = slide(mode.threshold, own, [q[0], q[1], q[2]]);
            out[..3].copy_from_slice(&slid);
            out
        }
        _ => iterate(cone, w, q, guess),
    }
}

/// Sliding at its threshold: r_T = (A + λ)⁻¹ b with |r_T| = μ r_N, and r_N from u_N = 0.
///
/// Newton's method for λ on μ r_N/|r_T| = 1, whose left side is almost a straight line (Moré and Sorensen, SIAM J.
/// Sci. Stat. Comput. 4 (1983) 553, have it for trust regions), within a bracket.
fn slide(mu: f64, own: &DelassusBlock, q: [f64; 3]) -> [f64; 3] {
    let (w, inv, a) = (&own.w, own.inv_normal, &own.sliding);
    let b = [1, 2].map(|row| w[row][0] * q[0] * inv - q[row]);
    let (trace, cross) = (a[0][0] + a[1][1], a[0][1] * a[1][0]);
    let normal = |t: [f64; 2]| -(q[0] + w[0][1] * t[0] + w[0][2] * t[1]) * inv;
    let (mut low, mut high) = (0.0, f64::INFINITY);
    let mut lambda = 0.0;
    let mut is_last = false;
    let (mut best, mut length_sq) = ([0.0; 2], 0.0);
    for _ in 0..SEARCH {
        let (p, s) = (a[0][0] + lambda, a[1][1] + lambda);
        let over = (p * s - cross).recip();
        let divide = |x: [f64; 2]| {
            [
                (s * x[0] - a[0][1] * x[1]) * over,
                (p * x[1] - a[1][0] * x[0]) * over,
            ]
        };
        best = divide(b);
        length_sq = best[0] * best[0] + best[1] * best[1];
        let pushed = normal(best);
        if is_last {
            break;
        }
        let length = length_sq.sqrt();
        let limit = mu * pushed;
        if length > limit {
            low = lambda;
        } else {
            high = lambda;
        }
        // Derivatives by λ, the length's times the length.
        let change = divide(best);
        let longer = -(best[0] * change[0] + best[1] * change[1]);
        let rise = mu * inv * (w[0][1] * change[0] + w[0][2] * change[1]);
        let mut next = lambda + (length - limit) * length_sq / (rise * length_sq - limit * longer);
        // Outside the bracket, or not a number: halve it, or look farther.
        if !(next > low && next < high) {
            next = if high.is_finite() {
                0.5 * (low + high)
            } else {
                2.0 * lambda + trace
            };
        }
        is_last = (next - lambda).abs() <= CLOSE * next;
        lambda = next;
    }
    // On the cone to the last bit.
    let pushed = normal(best).max(0.0);
    let length = length_sq.sqrt();
    let factor = if length > 0.0 {
        mu * pushed / length
    } else {
        0.0
    };
    [pushed, best[0] * factor, best[1] * factor]
}

/// Newton steps on the natural map; projected steps where they do not shorten it.
fn iterate(cone: &Cone, w: &Square, q: &Local, guess: &Local) -> Local {
    let size = cone.size();
    let velocity = |r: &Local| -> Local {
        let mut u = *q;
        for (u, row) in u.iter_mut().zip(w).take(size) {
            *u += row.iter().zip(r).map(|(w, r)| w * r).sum::<f64>();
        }
        u
    };
    let length = |x: &Local| x.iter().map(|x| x * x).sum::<f64>().sqrt();
    let trace: f64 = (0..size).map(|at| w[at][at]).sum();
    let mut r = *guess;
    for _ in 0..STEPS {
        let u = velocity(&r);
        let (map, impulse, velocity_slope) = linearised(cone, &r, &u);
        let now = length(&map);
        if now <= CLOSED * length(&r) {
            break;
        }
        let mut matrix = impulse;
        for (entries, velocity) in matrix.iter_mut().zip(&velocity_slope).take(size) {
            for (factor, source) in velocity.iter().zip(w).take(size) {
                for (entry, w) in entries.iter_mut().zip(source) {
                    *entry += factor * w;
                }
            }
        }
        let trial = solve_small(matrix, map.map(|x| -x), size)
            .map(|step| -> Local { std::array::from_fn(|at| r[at] + step[at]) });
        let better = trial.filter(|trial| {
            let u = velocity(trial);
            length(&linearised(cone, trial, &u).0) < 0.9 * now
        });
        r = better.unwrap_or_else(|| {
            let corrected = cone.corrected(&u);
            let step = if trace > 0.0 { 1.0 / trace } else { 1.0 };
            cone.project(&std::array::from_fn(|at| r[at] - step * corrected[at]))
                .point
        });
    }
    cone.project(&r).point
}
