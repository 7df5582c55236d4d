//! Rigid bodies in space and contacts between them, as matrices.

use nalgebra::{Vector3, Vector6};
use tribos::problem::{ContactComponents, ContactThresholds, GlobalProblem, SparseMatrix};

/// A problem under construction.
#[derive(Clone, Debug)]
pub struct Builder {
    layout: ContactComponents,
    masses: Vec<(usize, usize, f64)>,
    arms: Vec<(usize, usize, f64)>,
    momenta: Vec<f64>,
    centres: Vec<Vector3<f64>>,
    laws: Vec<ContactThresholds>,
}

impl Builder {
    /// Nothing yet.
    pub fn new(layout: ContactComponents) -> Self {
        Self {
            layout,
            masses: Vec::new(),
            arms: Vec::new(),
            momenta: Vec::new(),
            centres: Vec::new(),
            laws: Vec::new(),
        }
    }

    /// A body that would move with this velocity and spin; returns its number. What is fixed has none.
    pub fn body(
        &mut self,
        centre: Vector3<f64>,
        (mass, inertia): (f64, f64),
        motion: Vector6<f64>,
    ) -> usize {
        for (axis, speed) in motion.iter().enumerate() {
            let own = if axis < 3 { mass } else { inertia };
            let at = self.momenta.len();
            self.masses.push((at, at, own));
            self.momenta.push(own * speed);
        }
        self.centres.push(centre);
        self.centres.len() - 1
    }

    /// A contact at a point, with the normal from the first body to the second; `None` is fixed.
    pub fn contact(
        &mut self,
        bodies: [Option<usize>; 2],
        (point, normal): (Vector3<f64>, Vector3<f64>),
        law: ContactThresholds,
    ) {
        let normal = normal.normalize();
        let axis = Vector3::ith(normal.iamin(), 1.0);
        let first = (axis - normal * normal.dot(&axis)).normalize();
        let tangents = [first, normal.cross(&first)];
        let sliding = self.layout.sliding().len();
        let along = std::iter::once(normal).chain(tangents.into_iter().take(sliding));
        let about = tangents.into_iter().take(self.layout.rolling().len());
        let about = about.chain(std::iter::once(normal).take(self.layout.torsion().len()));
        let start = self.laws.len() * self.layout.size();
        let directions = along
            .map(|axis| (axis, true))
            .chain(about.map(|axis| (axis, false)));
        for (component, (axis, is_force)) in directions.enumerate() {
            for (body, sign) in bodies.into_iter().zip([-1.0, 1.0]) {
                let Some(body) = body else { continue };
                let (push, turn) = if is_force {
                    (axis, (point - self.centres[body]).cross(&axis))
                } else {
                    (Vector3::zeros(), axis)
                };
                for (at, value) in push.iter().chain(turn.iter()).enumerate() {
                    if *value != 0.0 {
                        self.arms
                            .push((6 * body + at, start + component, sign * value));
                    }
                }
            }
        }
        self.laws.push(law);
    }

    /// The problem.
    pub fn finish(self) -> GlobalProblem {
        let (freedoms, components) = (self.momenta.len(), self.laws.len() * self.layout.size());
        let matrix = |shape, entries: &[_]| {
            SparseMatrix::from_triplets(shape, entries).expect("entries are inside")
        };
        let m = matrix([freedoms; 2], &self.masses);
        let h = matrix([freedoms, components], &self.arms);
        let still = vec![0.0; components];
        GlobalProblem::new(self.layout, m, h, self.momenta, still, self.laws)
            .expect("the problem is valid")
    }
}
