//! A contact problem between bodies: M v = H r + f.

use super::error::ProblemError;
use super::law::{ContactComponents, ContactThresholds};
use super::matrix::SparseMatrix;
use super::reduced::{ReducedProblem, check_laws, check_sizes};
use nalgebra::DMatrix;

/// Bodies of mass M, velocities v and contacts: M v = H r + f, u = Hᵀ v + w.
///
/// M is n × n and H is n × (d contacts), with d the size of the [`ContactComponents`]. Laws are those of [`ReducedProblem`].
///
/// *Units*: any consistent set.
///
/// ```
/// use tribos::problem::{ContactThresholds, GlobalProblem, ContactComponents, SparseMatrix, solve};
/// // A mass of 2 kg under a push of 10 N s along x rests on a floor: its weight times a step is 40 N s.
/// let m = SparseMatrix::from_triplets([3, 3], &[(0, 0, 2.0), (1, 1, 2.0), (2, 2, 2.0)])?;
/// let h = SparseMatrix::from_triplets([3, 3], &[(2, 0, 1.0), (0, 1, 1.0), (1, 2, 1.0)])?;
/// let laws = vec![ContactThresholds::coulomb(0.5)];
/// let rest = GlobalProblem::new(ContactComponents::Space, m, h, vec![10.0, 0.0, -40.0], vec![0.0; 3], laws)?;
/// let end = solve(&rest.reduced()?, &Default::default(), |_| ());
/// assert!((end.impulses[0] - 40.0).abs() < 1e-9 && (end.impulses[1] + 10.0).abs() < 1e-9);
/// assert!(rest.motion(&end.impulses)?.iter().all(|v| v.abs() < 1e-9)); // m/s
/// # Ok::<(), tribos::problem::ProblemError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct GlobalProblem {
    layout: ContactComponents,
    m: SparseMatrix,
    h: SparseMatrix,
    f: Vec<f64>,
    w: Vec<f64>,
    laws: Vec<ContactThresholds>,
}

impl GlobalProblem {
    /// A problem of M, H, f, w and one law a contact.
    ///
    /// # Errors
    /// [`ProblemError::Size`] if sizes do not fit, [`ProblemError::NotFinite`], or [`ProblemError::Law`].
    pub fn new(
        layout: ContactComponents,
        m: SparseMatrix,
        h: SparseMatrix,
        f: Vec<f64>,
        w: Vec<f64>,
        laws: Vec<ContactThresholds>,
    ) -> Result<Self, ProblemError> {
        let sizes = [
            ("M", "columns", m.columns()),
            ("H", "rows", h.rows()),
            ("f", "elements", f.len()),
        ];
        check_sizes(&sizes, m.rows())?;
        let sizes = [("H", "columns", h.columns()), ("w", "elements", w.len())];
        check_sizes(&sizes, layout.size() * laws.len())?;
        for (what, vector) in [("f", &f), ("w", &w)] {
            if !vector.iter().all(|x| x.is_finite()) {
                return Err(ProblemError::NotFinite { what });
            }
        }
        check_laws(&laws)?;
        Ok(Self {
            layout,
            m,
            h,
            f,
            w,
            laws,
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

    /// The mass matrix.
    #[must_use]
    pub fn m(&self) -> &SparseMatrix {
        &self.m
    }

    /// The matrix that takes impulses at contacts to impulses on bodies.
    #[must_use]
    pub fn h(&self) -> &SparseMatrix {
        &self.h
    }

    /// Momenta of the bodies without impulses at contacts.
    #[must_use]
    pub fn f(&self) -> &[f64] {
        &self.f
    }

    /// Velocities at contacts between bodies at rest.
    #[must_use]
    pub fn w(&self) -> &[f64] {
        &self.w
    }

    /// Laws of the contacts.
    #[must_use]
    pub fn laws(&self) -> &[ContactThresholds] {
        &self.laws
    }

    /// The same problem between impulses: W = Hᵀ M⁻¹ H and q = Hᵀ M⁻¹ f + w.
    ///
    /// # Errors
    /// [`ProblemError::Singular`] if M has no inverse.
    pub fn reduced(&self) -> Result<ReducedProblem, ProblemError> {
        let bodies = Bodies::new(&self.m)?;
        let mut triplets = Vec::new();
        for body in &bodies.all {
            // Columns of H that act on the body, and M⁻¹ H for them.
            let rows: Vec<_> = body.freedoms.iter().map(|&row| self.h.row(row)).collect();
            let mut columns: Vec<usize> = rows
                .iter()
                .flat_map(|row| row.iter().map(|e| e.0))
                .collect();
            columns.sort_unstable();
            columns.dedup();
            let mut part = DMatrix::zeros(rows.len(), columns.len());
            for (at, row) in rows.iter().enumerate() {
                for &(column, value) in *row {
                    if let Ok(place) = columns.binary_search(&column) {
                        part[(at, place)] = value;
                    }
                }
            }
            let product = part.transpose() * (&body.inverse * &part);
            for (a, &row) in columns.iter().enumerate() {
                for (b, &column) in columns.iter().enumerate() {
                    triplets.push((row, column, product[(a, b)]));
                }
            }
        }
        let size = self.w.len();
        let w = SparseMatrix::from_triplets([size, size], &triplets)?;
        let made = SourceBodies {
            arms: self.h.transposed(),
            bodies,
            global: self.clone(),
        };
        let q = made.velocities(&vec![0.0; size]);
        let mut reduced = ReducedProblem::new(self.layout, w, q, self.laws.clone())?;
        reduced.made = Some(Box::new(made));
        Ok(reduced)
    }

    /// Velocities of the bodies under impulses at the contacts: M⁻¹ (H r + f).
    ///
    /// # Errors
    /// [`ProblemError::Singular`] if M has no inverse.
    ///
    /// # Panics
    /// If there are fewer impulses than the problem has.
    pub fn motion(&self, r: &[f64]) -> Result<Vec<f64>, ProblemError> {
        let mut momenta = self.h.times(r);
        momenta.iter_mut().zip(&self.f).for_each(|(p, f)| *p += f);
        Ok(Bodies::new(&self.m)?.divide(&momenta))
    }
}

/// The bodies that a reduced problem was made from. Velocities that follow from theirs are as accurate as their
/// momenta; a sum W r may lose a light body's part beside the impulses of heavy ones.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct SourceBodies {
    pub global: GlobalProblem,
    pub bodies: Bodies,
    /// Hᵀ
    arms: SparseMatrix,
}

impl SourceBodies {
    /// u = Hᵀ M⁻¹ (H r + f) + w.
    pub fn velocities(&self, r: &[f64]) -> Vec<f64> {
        let GlobalProblem { h, f, w, .. } = &self.global;
        let mut momenta = h.times(r);
        momenta.iter_mut().zip(f).for_each(|(p, f)| *p += f);
        let mut u = self.arms.times(&self.bodies.divide(&momenta));
        u.iter_mut().zip(w).for_each(|(u, w)| *u += w);
        u
    }

    /// Rounding of the velocities at each contact component, in units of ε: the sizes of momenta that cancel.
    pub fn rounding(&self, r: &[f64]) -> Vec<f64> {
        let GlobalProblem { h, f, .. } = &self.global;
        let sizes: Vec<f64> = (0..h.rows())
            .map(|row| {
                let sum: f64 = h.row(row).iter().map(|&(at, h)| (h * r[at]).abs()).sum();
                sum + f[row].abs()
            })
            .collect();
        let speeds = self.bodies.divide(&sizes);
        (0..self.arms.rows())
            .map(|row| {
                self.arms
                    .row(row)
                    .iter()
                    .map(|&(at, h)| (h * speeds[at]).abs())
                    .sum()
            })
            .collect()
    }
}

/// Degrees of freedom that M joins, and the inverse of their part of it.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Body {
    pub freedoms: Vec<usize>,
    pub inverse: DMatrix<f64>,
}

/// The parts of M that are independent of each other, in the order of their first degree of freedom.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Bodies {
    pub all: Vec<Body>,
}

impl Bodies {
    pub fn new(m: &SparseMatrix) -> Result<Self, ProblemError> {
        let all = components(m)
            .into_iter()
            .map(|freedoms| {
                let size = freedoms.len();
                let mut part = DMatrix::zeros(size, size);
                for (at, &row) in freedoms.iter().enumerate() {
                    for &(column, value) in m.row(row) {
                        if let Ok(place) = freedoms.binary_search(&column) {
                            part[(at, place)] = value;
                        }
                    }
                }
                match part.try_inverse() {
                    Some(inverse) if inverse.iter().all(|x| x.is_finite()) => {
                        Ok(Body { freedoms, inverse })
                    }
                    _ => Err(ProblemError::Singular(freedoms[0])),
                }
            })
            .collect::<Result<_, _>>()?;
        Ok(Self { all })
    }

    /// M⁻¹ times a vector.
    pub fn divide(&self, vector: &[f64]) -> Vec<f64> {
        let mut out = vec![0.0; vector.len()];
        for body in &self.all {
            for (row, &at) in body.freedoms.iter().enumerate() {
                let columns = body.freedoms.iter().enumerate();
                out[at] = columns
                    .map(|(column, &from)| body.inverse[(row, column)] * vector[from])
                    .sum();
            }
        }
        out
    }
}

/// Rows of a square matrix that entries join, directly or through others.
pub(super) fn components(m: &SparseMatrix) -> Vec<Vec<usize>> {
    let mut leader: Vec<usize> = (0..m.rows()).collect();
    for (row, column, value) in m.triplets() {
        if value != 0.0 {
            let (a, b) = (find(&mut leader, row), find(&mut leader, column));
            leader[a.max(b)] = a.min(b);
        }
    }
    let mut number = vec![None; m.rows()];
    let mut all: Vec<Vec<usize>> = Vec::new();
    for row in 0..m.rows() {
        let first = find(&mut leader, row);
        let at = *number[first].get_or_insert_with(|| {
            all.push(Vec::new());
            all.len() - 1
        });
        all[at].push(row);
    }
    all
}

/// The least row joined to this one; paths are halved on the way.
fn find(leader: &mut [usize], mut row: usize) -> usize {
    while leader[row] != row {
        leader[row] = leader[leader[row]];
        row = leader[row];
    }
    row
}
