//! A contact problem between impulses alone: u = W r + q.

use super::error::ProblemError;
use super::global::SourceBodies;
use super::law::{ContactComponents, ContactThresholds};
use super::matrix::SparseMatrix;

/// Impulses r and velocities u = W r + q at contacts.
///
/// Components of contact i are those from i d, with d the size of the [`ContactComponents`]. The laws of each contact:
/// 0 ≤ P ⊥ u_N ≥ 0 with P = r_N plus cohesion; |r_k| ≤ m_k P for each mode k, and r_k = −m_k P u_k/|u_k| where
/// u_k ≠ 0.
///
/// *Units*: any consistent set.
///
/// ```
/// use tribos::problem::{ContactThresholds, ContactComponents, SparseMatrix, ReducedProblem};
/// // A mass of 2 kg falls onto a floor at 3 m/s, at an angle: μ = 0.5.
/// let w = SparseMatrix::from_triplets([3, 3], &[(0, 0, 0.5), (1, 1, 0.5), (2, 2, 0.5)])?;
/// let fall = ReducedProblem::new(ContactComponents::Space, w, vec![-3.0, 4.0, 0.0], vec![ContactThresholds::coulomb(0.5)])?;
/// let end = tribos::problem::solve(&fall, &Default::default(), |_| ());
/// let expected = [6.0, -3.0, 0.0]; // N s
/// assert!(end.impulses.iter().zip(expected).all(|(r, exact)| (r - exact).abs() < 1e-12));
/// # Ok::<(), tribos::problem::ProblemError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct ReducedProblem {
    pub(super) layout: ContactComponents,
    pub(super) w: SparseMatrix,
    pub(super) q: Vec<f64>,
    pub(super) laws: Vec<ContactThresholds>,
    /// The bodies that W was made from.
    pub(super) made: Option<Box<SourceBodies>>,
}

impl ReducedProblem {
    /// A problem of W, q and one law a contact.
    ///
    /// # Errors
    /// [`ProblemError::Size`] if sizes do not fit, [`ProblemError::NotFinite`], or [`ProblemError::Law`].
    pub fn new(
        layout: ContactComponents,
        w: SparseMatrix,
        q: Vec<f64>,
        laws: Vec<ContactThresholds>,
    ) -> Result<Self, ProblemError> {
        let wanted = layout.size() * laws.len();
        let sizes = [
            ("W", "rows", w.rows()),
            ("W", "columns", w.columns()),
            ("q", "elements", q.len()),
        ];
        check_sizes(&sizes, wanted)?;
        if !q.iter().all(|x| x.is_finite()) {
            return Err(ProblemError::NotFinite { what: "q" });
        }
        check_laws(&laws)?;
        Ok(Self {
            layout,
            w,
            q,
            laws,
            made: None,
        })
    }

    /// Components of each contact.
    #[must_use]
    pub fn layout(&self) -> ContactComponents {
        self.layout
    }

    /// Number of contacts.
    #[must_use]
    pub fn contacts(&self) -> usize {
        self.laws.len()
    }

    /// The matrix W.
    #[must_use]
    pub fn w(&self) -> &SparseMatrix {
        &self.w
    }

    /// Velocities without impulses.
    #[must_use]
    pub fn q(&self) -> &[f64] {
        &self.q
    }

    /// Laws of the contacts.
    #[must_use]
    pub fn laws(&self) -> &[ContactThresholds] {
        &self.laws
    }

    /// u = W r + q, from the motion of the bodies where the problem was made from them.
    #[must_use]
    pub fn velocities(&self, r: &[f64]) -> Vec<f64> {
        if let Some(made) = &self.made {
            return made.velocities(r);
        }
        let mut u = self.w.times(r);
        u.iter_mut().zip(&self.q).for_each(|(u, q)| *u += q);
        u
    }

    /// Rounding of each velocity, in units of ε.
    pub(super) fn rounding(&self, r: &[f64]) -> Vec<f64> {
        match &self.made {
            Some(made) => made.rounding(r),
            None => (0..self.w.rows())
                .map(|row| {
                    self.w
                        .row(row)
                        .iter()
                        .map(|&(at, w)| (w * r[at]).abs())
                        .sum()
                })
                .collect(),
        }
    }

    pub(super) fn diagonal(&self, at: usize) -> f64 {
        let row = self.w.row(at);
        row.binary_search_by_key(&at, |entry| entry.0)
            .map_or(0.0, |place| row[place].1)
    }

    /// q − W C e_N: the velocities without impulses where impulses count from the pull of cohesion.
    pub(super) fn without_cohesion(&self) -> Vec<f64> {
        if self.laws.iter().all(|law| law.cohesion == 0.0) {
            return self.q.clone();
        }
        let mut pull = vec![0.0; self.q.len()];
        let normals = pull.iter_mut().step_by(self.layout.size());
        for (pull, law) in normals.zip(&self.laws) {
            *pull = -law.cohesion;
        }
        self.velocities(&pull)
    }
}

pub(super) fn check_sizes(
    sizes: &[(&'static str, &'static str, usize)],
    wanted: usize,
) -> Result<(), ProblemError> {
    for &(what, of, found) in sizes {
        if found != wanted {
            return Err(ProblemError::Size {
                what,
                of,
                found,
                wanted,
            });
        }
    }
    Ok(())
}

pub(super) fn check_laws(laws: &[ContactThresholds]) -> Result<(), ProblemError> {
    for (contact, law) in laws.iter().enumerate() {
        let numbers = [
            ("the friction coefficient", law.sliding),
            ("the rolling threshold", law.rolling),
            ("the torsion threshold", law.torsion),
            ("the cohesion", law.cohesion),
        ];
        for (what, value) in numbers {
            if !(value.is_finite() && value >= 0.0) {
                return Err(ProblemError::Law {
                    what,
                    contact,
                    value,
                });
            }
        }
    }
    Ok(())
}
