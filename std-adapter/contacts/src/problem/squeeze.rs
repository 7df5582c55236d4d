//! Proof that a contact problem has no solution: normal impulses that only squeeze.
//!
//! Let y ≥ 0 weigh the contacts, with sum 1, and z = Wᵀ y e_N. For all impulses r that the laws admit,
//!
//! ```text
//! y · u_N = z · r + y · q_N ≤ Σ δ_i P_i + y · q_N,    δ_i = max(0, z_N + Σ m_k |z_k|) at contact i,
//! ```
//!
//! with P_i the normal impulse plus cohesion, and q under the pull of cohesion. Where y moves nothing, all δ_i are zero:
//! contacts that close in this mean close whatever the impulses. This is the alternative of Farkas' lemma for
//! u_N ≥ 0; W need not be symmetric.

use super::law::ContactThresholds;
use super::reduced::ReducedProblem;
use super::residual::allowed;

/// Normal impulses that move nothing, at contacts that close in the mean: proof that a problem has no solution.
///
/// ```
/// use tribos::problem::{ContactThresholds, ContactComponents, SparseMatrix, ReducedProblem, solve};
/// // A body of 1 kg between two plates, each of which comes nearer at 1 m/s.
/// let w = SparseMatrix::from_triplets([4, 4], &[(0, 0, 1.0), (0, 2, -1.0), (2, 0, -1.0), (2, 2, 1.0)])?;
/// let laws = vec![ContactThresholds::coulomb(0.5); 2];
/// let plates = ReducedProblem::new(ContactComponents::Plane, w, vec![-1.0, 0.0, -1.0, 0.0], laws)?;
/// let squeeze = solve(&plates, &Default::default(), |_| ()).squeeze.ok_or("solved")?;
/// assert!((squeeze.weights[0] - 0.5).abs() < 1e-9 && (squeeze.closing - 1.0).abs() < 1e-9);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Squeeze {
    /// Weight of each contact, at least 0; their sum is 1.
    pub weights: Vec<f64>,
    /// Weighted mean of the speeds at which contacts close, above 0, in the problem's unit of velocity: no impulses change
    /// it, so that at least one contact closes as fast.
    pub closing: f64,
}

impl Squeeze {
    /// Number of contacts that are squeezed.
    #[must_use]
    pub fn contacts(&self) -> usize {
        self.weights.iter().filter(|&&weight| weight > 0.0).count()
    }

    /// The proof that the normal part of `impulses` gives, if it is one: every answer to `tolerance` would need an
    /// impulse at which rounding alone hides the speeds that are asked for.
    pub(super) fn of(problem: &ReducedProblem, impulses: &[f64], tolerance: f64) -> Option<Self> {
        let size = problem.layout.size();
        let normals = impulses.iter().step_by(size).map(|r| r.max(0.0));
        let largest = normals.clone().fold(0.0, f64::max);
        let sum: f64 = normals.clone().map(|r| r / largest).sum();
        if !(largest > 0.0 && sum.is_finite()) {
            return None;
        }
        let weights: Vec<f64> = normals.map(|r| r / largest / sum).collect();
        let pulled = problem.without_cohesion();
        let mean = |speeds: &[f64]| -> f64 {
            let normals = speeds.iter().step_by(size);
            weights.iter().zip(normals).map(|(y, q)| y * q).sum()
        };
        let closing = -mean(&pulled);
        let blur = allowed(problem, &pulled, tolerance);
        let opened = opened(problem, &weights, blur);
        (closing > opened + blur).then_some(Self { weights, closing })
    }
}

/// The most that impulses of a size that rounding resolves to `blur` change the mean speed by.
fn opened(problem: &ReducedProblem, weights: &[f64], blur: f64) -> f64 {
    let size = problem.layout.size();
    // z, and the sizes of what cancels in it.
    let mut moved = vec![[0.0; 2]; problem.q.len()];
    for (contact, &weight) in weights.iter().enumerate().filter(|entry| *entry.1 > 0.0) {
        for &(to, w) in problem.w.row(contact * size) {
            moved[to][0] += w * weight;
            moved[to][1] += (w * weight).abs();
        }
    }
    let mut sum = 0.0;
    for (contact, law) in problem.laws.iter().enumerate() {
        let start = contact * size;
        let excess = excess(problem, law, &moved[start..start + size]);
        if excess > 0.0 {
            // The impulse whose own part of W r rounding blurs by as much.
            sum += excess * blur / (f64::EPSILON * problem.diagonal(start));
        }
    }
    sum
}

/// z_N + Σ m_k |z_k| of a contact, with rounding against the proof.
fn excess(problem: &ReducedProblem, law: &ContactThresholds, moved: &[[f64; 2]]) -> f64 {
    let layout = problem.layout;
    let mode = |range: std::ops::Range<usize>| -> f64 {
        let part = &moved[range];
        let sum: f64 = part.iter().map(|[z, _]| z * z).sum();
        sum.sqrt()
    };
    let rounding: f64 = moved.iter().map(|[_, size]| f64::EPSILON * size).sum();
    let separate = law.sliding * mode(layout.sliding())
        + law.rolling * mode(layout.rolling())
        + law.torsion * mode(layout.torsion());
    moved[0][0] + separate + rounding
}
