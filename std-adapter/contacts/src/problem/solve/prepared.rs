//! A contact problem in the form that all methods solve: scaled, without cohesion and without unknowns that are
//! zero by law.

use super::super::law::{ContactThresholds, Friction};
use super::super::reduced::ReducedProblem;
use super::blocks::Blocks;
use super::bodies::Bodies;
use super::cone::{Cone, Local};

/// u = W r + q with ũ ∈ K* ⊥ r ∈ K at every contact.
///
/// r' = r/(s c): a factor s for each unknown, which makes the mean diagonal of W one third at every contact, in
/// sliding as in rolling, and c, the root mean square of q, for all.
#[derive(Clone, Debug)]
pub(super) struct Prepared {
    pub w: Blocks,
    pub q: Vec<f64>,
    pub cones: Vec<Cone>,
    /// The way over the bodies, where they are known.
    pub bodies: Option<Bodies>,
    /// Unknown of the problem that each one here stands for, and its unit s.
    origin: Vec<(usize, f64)>,
    /// Unit c of all unknowns.
    unit: f64,
}

/// The mean diagonal of W in scaled unknowns.
const DIAGONAL: f64 = 1.0 / 3.0;

impl Prepared {
    pub fn new(problem: &ReducedProblem) -> Self {
        let size = problem.layout.size();
        let mut first = vec![0];
        let (mut cones, mut origin) = (Vec::new(), Vec::new());
        for (contact, law) in problem.laws.iter().enumerate() {
            let start = contact * size;
            let (cone, units) = scaled(problem, start, law);
            for (component, unit) in units {
                origin.push((start + component, unit));
            }
            first.push(origin.len());
            cones.push(cone);
        }
        let mut place = vec![None; problem.q.len()];
        for (at, &(from, _)) in origin.iter().enumerate() {
            place[from] = Some(at);
        }
        let bodies = problem.made.as_ref().map(|made| {
            let columns: Vec<_> = place
                .iter()
                .enumerate()
                .map(|(from, at)| at.map(|at| (from / size, at - first[from / size], origin[at].1)))
                .collect();
            Bodies::new(made, cones.len(), &columns)
        });
        let w = gather(problem, &place, &origin, first);
        let shifted = problem.without_cohesion();
        let mut q: Vec<f64> = origin
            .iter()
            .map(|&(from, unit)| shifted[from] * unit)
            .collect();
        // In units of the largest, squares keep their digits.
        let largest = q.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
        let unit = if largest > 0.0 {
            let sum: f64 = q.iter().map(|x| (x / largest) * (x / largest)).sum();
            largest * (sum / cones.len() as f64).sqrt()
        } else {
            1.0
        };
        q.iter_mut().for_each(|x| *x /= unit);
        Self {
            w,
            q,
            cones,
            bodies,
            origin,
            unit,
        }
    }

    pub fn contacts(&self) -> usize {
        self.cones.len()
    }

    /// The contact's part of a vector.
    pub fn local(&self, contact: usize, vector: &[f64]) -> Local {
        let mut local = Local::default();
        let part = &vector[self.w.first[contact]..self.w.first[contact + 1]];
        local[..part.len()].copy_from_slice(part);
        local
    }

    /// Replaces the contact's part of a vector.
    pub fn put(&self, contact: usize, local: &Local, vector: &mut [f64]) {
        let part = &mut vector[self.w.first[contact]..self.w.first[contact + 1]];
        part.copy_from_slice(&local[..part.len()]);
    }

    /// W times a vector.
    pub fn apply(&self, vector: &[f64], out: &mut [f64]) {
        match &self.bodies {
            Some(bodies) => bodies.apply(self, vector, out),
            None => self.w.multiply(vector, out),
        }
    }

    /// u = W r + q.
    pub fn velocities(&self, r: &[f64], u: &mut [f64]) {
        self.apply(r, u);
        for (u, q) in u.iter_mut().zip(&self.q) {
            *u += q;
        }
    }

    /// |r − P_K(r − ũ)|/|r|: the scaled residual.
    pub fn residual(&self, r: &[f64], u: &[f64]) -> f64 {
        let (mut map_sq, mut size_sq) = (0.0, 0.0);
        for (contact, cone) in self.cones.iter().enumerate() {
            let (r, u) = (self.local(contact, r), self.local(contact, u));
            let corrected = cone.corrected(&u);
            let trial = std::array::from_fn(|at| r[at] - corrected[at]);
            let nearest = cone.project(&trial).point;
            for at in 0..cone.size() {
                map_sq += (r[at] - nearest[at]) * (r[at] - nearest[at]);
                size_sq += r[at] * r[at];
            }
        }
        relative(map_sq, size_sq)
    }

    /// Impulses in the units of the problem.
    pub fn unscaled(&self, r: &[f64], problem: &ReducedProblem) -> Vec<f64> {
        let mut all = vec![0.0; problem.q.len()];
        for (&(to, unit), value) in self.origin.iter().zip(r) {
            all[to] = value * unit * self.unit;
        }
        let size = problem.layout.size();
        for (law, normal) in problem.laws.iter().zip(all.iter_mut().step_by(size)) {
            *normal -= law.cohesion;
        }
        all
    }

    /// Scaled impulses from those of the problem.
    pub fn scaled(&self, r: &[f64], problem: &ReducedProblem) -> Vec<f64> {
        let size = problem.layout.size();
        self.origin
            .iter()
            .map(|&(from, unit)| {
                let cohesion = problem.laws[from / size].cohesion;
                let shift = if from % size == 0 { cohesion } else { 0.0 };
                (r[from] + shift) / (unit * self.unit)
            })
            .collect()
    }
}

/// √(part/whole); 0 for nothing of nothing.
fn relative(part: f64, whole: f64) -> f64 {
    if part == 0.0 {
        0.0
    } else {
        (part / whole).sqrt()
    }
}

/// Modes of a contact with thresholds above zero, and its unknowns: component, unit.
fn scaled(
    problem: &ReducedProblem,
    start: usize,
    law: &ContactThresholds,
) -> (Cone, Vec<(usize, f64)>) {
    let layout = problem.layout;
    let mean = |range: std::ops::Range<usize>| -> f64 {
        let count = range.len() as f64;
        range.map(|at| problem.diagonal(start + at)).sum::<f64>() / count
    };
    // A contact between bodies that do not move has no scale of its own.
    let unit = |diagonal: f64| {
        if diagonal > 0.0 {
            (DIAGONAL / diagonal).sqrt()
        } else {
            1.0
        }
    };
    let sliding = layout.sliding();
    let base = unit(mean(0..sliding.end));
    let mut cone = Cone::default();
    let mut units = vec![(0, base)];
    let joint =
        matches!(law.friction, Friction::Ellipsoid) && law.sliding > 0.0 && law.torsion > 0.0;
    let spin = layout.torsion();
    if law.sliding > 0.0 {
        units.extend(sliding.clone().map(|at| (at, base)));
        if joint {
            units.extend(
                spin.clone()
                    .map(|at| (at, base * law.torsion / law.sliding)),
            );
        }
        cone.push(units.len() - 1, law.sliding);
    }
    let mut apart = |range: std::ops::Range<usize>, threshold: f64| {
        if threshold > 0.0 && !range.is_empty() {
            let own = unit(mean(range.clone()));
            let size = range.len();
            units.extend(range.map(|at| (at, own)));
            cone.push(size, threshold * base / own);
        }
    };
    apart(layout.rolling(), law.rolling);
    if !joint {
        apart(spin, law.torsion);
    }
    (cone, units)
}

/// W between the unknowns that are left, in scaled units.
fn gather(
    problem: &ReducedProblem,
    place: &[Option<usize>],
    origin: &[(usize, f64)],
    first: Vec<usize>,
) -> Blocks {
    let size = problem.layout.size();
    let contacts = problem.laws.len();
    let mut rows = Vec::with_capacity(contacts);
    for contact in 0..contacts {
        let mut nodes = vec![contact];
        for (from, _) in &origin[first[contact]..first[contact + 1]] {
            let columns = problem.w.row(*from).iter();
            nodes.extend(
                columns
                    .filter(|entry| entry.1 != 0.0)
                    .map(|&(column, _)| column / size),
            );
        }
        nodes.sort_unstable();
        nodes.dedup();
        rows.push(nodes);
    }
    let mut blocks = Blocks::zeros(first, &rows);
    for contact in 0..contacts {
        let row_start = blocks.first[contact];
        for at in row_start..blocks.first[contact + 1] {
            let (from, unit) = origin[at];
            for &(column, value) in problem.w.row(from) {
                let (Some(to), Some(number)) = (place[column], blocks.find(contact, column / size))
                else {
                    continue;
                };
                let node = column / size;
                let (width, left) = (blocks.size(node), to - blocks.first[node]);
                blocks.block_mut(number)[(at - row_start) * width + left] =
                    value * unit * origin[to].1;
            }
        }
    }
    blocks
}
