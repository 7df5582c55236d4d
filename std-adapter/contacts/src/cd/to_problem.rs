//! The contact problem of a step as data, for solvers that know nothing of spheres.

use super::cell::CellBody;
use super::image::{Images, seen};
use super::operator::Operator;
use super::residual::Coefficients;
use super::spheres::{Link, Spheres};
use crate::problem::{ContactComponents, ContactThresholds, Friction, GlobalProblem, SparseMatrix};
use nalgebra::Vector3;
use tribos_core::contact::{ContactFriction, ContactModes, ContactVector, SphereBody, WallBody};
use tribos_core::internals::{AxialPart, PlanarPart};

/// A contact problem, and the directions that its components stand for.
#[derive(Clone, Debug)]
pub struct PosedProblem {
    /// The problem. Components of a contact: along its normal, along both tangents, then rolling about
    /// the tangents and torsion where the contacts have these modes.
    pub problem: GlobalProblem,
    /// Two tangents of each contact.
    pub tangents: Vec<[Vector3<f64>; 2]>,
}

/// Numbers of the degrees of freedom of a body: of its velocity and its spin, along each axis.
#[derive(Clone, Copy, Debug, Default)]
struct Freedoms {
    linear: [Option<usize>; 3],
    angular: [Option<usize>; 3],
}

/// Three degrees of freedom from the first on.
fn three(first: Option<usize>) -> [Option<usize>; 3] {
    [0, 1, 2].map(|axis| first.map(|first| first + axis))
}

impl<F: ContactFriction<f64> + Coefficients> Spheres<F> {
    /// The problem as data; `None` if one of its laws has no such form: sliding and torsion under a common set that
    /// is no ellipsoid, or an open gap under a resistance.
    pub fn to_problem(&self) -> Option<PosedProblem> {
        let mut posing = Posing::<F::Modes>::new(self);
        // Images move with the axes of a cell, which are bodies too, or as they are prescribed.
        let axes = self
            .cell
            .as_ref()
            .map(|cell| (posing.cell(cell), cell.driven()));
        let mut moved = self
            .cell
            .as_ref()
            .map_or(&[][..], |cell| &cell.periods[..])
            .iter();
        let mut images = Images::new(&self.images);
        for (number, link) in self.pairs.iter().enumerate() {
            let [a, b] = link.bodies.map(|body| body as usize);
            let (a, b) = (posing.sphere(self, a), posing.sphere(self, b));
            let mut image = images.of(number);
            let mut border = (Freedoms::default(), [0.0; 3]);
            if let (Some((freedoms, driven)), Some(_)) = (&axes, image)
                && let Some(periods) = moved.next()
            {
                image = Some(driven.image(periods));
                border = (*freedoms, *periods);
            }
            let prescribed = seen(&b.1, image);
            let rows = |impulse: &ContactVector<f64, F::Modes>| {
                let (mut first, mut second) = (unit_sphere(), unit_sphere());
                link.contact.apply(impulse, &mut first, &mut second);
                let pushed = SphereBody {
                    velocity: -second.velocity.component_mul(&Vector3::from(border.1)),
                    ..still_sphere()
                };
                vec![(a.0, first), (b.0, second), (border.0, pushed)]
            };
            let still = link.contact.velocity(&a.1, &prescribed);
            posing.add(&link, self.pair_friction(link.bodies), rows, &still)?;
        }
        for (index, link) in self.walls.iter().enumerate() {
            let [a, b] = link.bodies.map(|body| body as usize);
            let a = posing.sphere(self, a);
            if let Some(surface) = self.surface(index) {
                let rows = |impulse: &ContactVector<f64, F::Modes>| {
                    let mut first = unit_sphere();
                    link.contact.apply(impulse, &mut first, &mut { *surface });
                    vec![(a.0, first)]
                };
                let still = link.contact.velocity(&a.1, surface);
                posing.add(link, self.wall_friction(link.bodies), rows, &still)?;
                continue;
            }
            let (normal, b) = posing.plate(self, b, link.contact.normal());
            let rows = |impulse: &ContactVector<f64, F::Modes>| {
                let mut first = unit_sphere();
                let mut second = WallBody {
                    velocity: Vector3::zeros(),
                    inv_mass: 1.0,
                };
                link.contact.apply(impulse, &mut first, &mut second);
                let along = second.velocity.dot(link.contact.normal());
                let pushed = SphereBody {
                    velocity: Vector3::x() * along,
                    ..still_sphere()
                };
                vec![(a.0, first), (normal, pushed)]
            };
            let still = link.contact.velocity(&a.1, &b);
            posing.add(link, self.wall_friction(link.bodies), rows, &still)?;
        }
        posing.finish()
    }

    /// Takes over the impulses of a solution, as far as the contacts admit them, and the velocities that follow.
    pub fn apply_solution(&mut self, posed: &PosedProblem, impulses: &[f64]) {
        let layout = posed.problem.layout();
        for (contact, (r, t)) in impulses
            .chunks_exact(layout.size())
            .zip(&posed.tangents)
            .enumerate()
        {
            let plane = |range: std::ops::Range<usize>| match r.get(range) {
                Some([a, b]) => t[0] * *a + t[1] * *b,
                _ => Vector3::zeros(),
            };
            let torsion = r
                .get(layout.torsion())
                .and_then(|part| part.first())
                .copied();
            let impulse = ContactVector::new(
                r[0],
                plane(layout.sliding()),
                plane(layout.rolling()),
                torsion.unwrap_or(0.0),
            );
            self.guess(contact, &impulse);
        }
        self.refresh();
    }
}

fn still_sphere() -> SphereBody<f64> {
    SphereBody {
        velocity: Vector3::zeros(),
        spin: Vector3::zeros(),
        inv_mass: 0.0,
        inv_inertia: 0.0,
    }
}

/// A sphere whose velocities are the impulses it receives.
pub(super) fn unit_sphere() -> SphereBody<f64> {
    SphereBody {
        inv_mass: 1.0,
        inv_inertia: 1.0,
        ..still_sphere()
    }
}

/// Matrices under construction.
struct Posing<M> {
    layout: ContactComponents,
    spheres: Vec<Option<Freedoms>>,
    plates: Vec<Option<usize>>,
    masses: Vec<(usize, usize, f64)>,
    momenta: Vec<f64>,
    arms: Vec<(usize, usize, f64)>,
    prescribed: Vec<f64>,
    laws: Vec<ContactThresholds>,
    tangents: Vec<[Vector3<f64>; 2]>,
    modes: std::marker::PhantomData<M>,
}

impl<M: ContactModes<f64>> Posing<M> {
    fn new<F: ContactFriction<f64, Modes = M>>(problem: &Spheres<F>) -> Self {
        let layout = match (M::Rolling::PRESENT, M::Torsion::PRESENT) {
            (true, true) => ContactComponents::All,
            (true, false) => ContactComponents::Rolling,
            (false, true) => ContactComponents::Torsion,
            (false, false) => ContactComponents::Space,
        };
        Self {
            layout,
            spheres: vec![None; problem.free.0.len()],
            plates: vec![None; problem.free.1.len()],
            masses: Vec::new(),
            momenta: Vec::new(),
            arms: Vec::new(),
            prescribed: Vec::new(),
            laws: Vec::new(),
            tangents: Vec::new(),
            modes: std::marker::PhantomData,
        }
    }

    /// Adds degrees of freedom with a common mass; returns the number of the first. A body of infinite mass has
    /// none.
    fn free(&mut self, inverse: f64, velocity: &[f64]) -> Option<usize> {
        if inverse == 0.0 {
            return None;
        }
        let first = self.momenta.len();
        for v in velocity {
            let at = self.momenta.len();
            self.masses.push((at, at, inverse.recip()));
            self.momenta.push(v / inverse);
        }
        Some(first)
    }

    /// Degrees of freedom of the axes of a cell.
    fn cell(&mut self, cell: &CellBody) -> Freedoms {
        Freedoms {
            linear: [0, 1, 2].map(|axis| self.free(cell.inv_mass[axis], &[cell.free[axis]])),
            ..Freedoms::default()
        }
    }

    /// Degrees of freedom of a sphere, and the sphere with its prescribed velocities alone.
    fn sphere<F: ContactFriction<f64>>(
        &mut self,
        problem: &Spheres<F>,
        body: usize,
    ) -> (Freedoms, SphereBody<f64>) {
        let sphere = &problem.free.0[body];
        let freedoms = match self.spheres[body] {
            Some(known) => known,
            None => Freedoms {
                linear: three(self.free(sphere.inv_mass, sphere.velocity.as_slice())),
                angular: three(self.free(sphere.inv_inertia, sphere.spin.as_slice())),
            },
        };
        self.spheres[body] = Some(freedoms);
        let mut prescribed = *sphere;
        if sphere.inv_mass != 0.0 {
            prescribed.velocity = Vector3::zeros();
        }
        if sphere.inv_inertia != 0.0 {
            prescribed.spin = Vector3::zeros();
        }
        (freedoms, prescribed)
    }

    /// The degree of freedom of a plate along its normal, and the plate with its prescribed velocities alone.
    fn plate<F: ContactFriction<f64>>(
        &mut self,
        problem: &Spheres<F>,
        body: usize,
        normal: &Vector3<f64>,
    ) -> (Freedoms, WallBody<f64>) {
        let plate = &problem.free.1[body];
        let along = plate.velocity.dot(normal);
        let linear = match self.plates[body] {
            Some(known) => Some(known),
            None => self.free(plate.inv_mass, &[along]),
        };
        self.plates[body] = linear;
        let mut prescribed = *plate;
        if linear.is_some() {
            prescribed.velocity -= normal * along;
        }
        let freedoms = Freedoms {
            linear: [linear, None, None],
            ..Freedoms::default()
        };
        (freedoms, prescribed)
    }

    /// Adds a contact, from the impulses on bodies that an impulse at it means and its velocity if only
    /// prescribed velocities remain.
    fn add(
        &mut self,
        link: &Link<M>,
        friction: &impl Coefficients,
        rows: impl Fn(&ContactVector<f64, M>) -> Vec<(Freedoms, SphereBody<f64>)>,
        still: &ContactVector<f64, M>,
    ) -> Option<()> {
        let contact = &link.contact;
        let coupling = match friction.joint() {
            None => Friction::Separate,
            Some(_) if friction.is_ellipsoid() => Friction::Ellipsoid,
            Some(_) => return None,
        };
        if contact.holds_gap_open() {
            return None;
        }
        let normal = contact.normal();
        let tangents = tangents(normal);
        let zero = Vector3::zeros();
        let mut directions = vec![ContactVector::new(1.0, zero, zero, 0.0)];
        let mut velocities = vec![still.normal + contact.approach_limit()];
        for t in &tangents {
            directions.push(ContactVector::new(0.0, *t, zero, 0.0));
            velocities.push(still.sliding().dot(t));
        }
        if M::Rolling::PRESENT {
            for t in &tangents {
                directions.push(ContactVector::new(0.0, zero, *t, 0.0));
                velocities.push(still.rolling().dot(t));
            }
        }
        if M::Torsion::PRESENT {
            directions.push(ContactVector::new(0.0, zero, zero, 1.0));
            velocities.push(still.torsion());
        }
        for (component, direction) in directions.iter().enumerate() {
            let column = self.prescribed.len() + component;
            for (freedoms, pushed) in rows(direction) {
                self.enter(column, freedoms.linear, &pushed.velocity);
                self.enter(column, freedoms.angular, &pushed.spin);
            }
        }
        self.prescribed.extend(velocities);
        let [mu, mu_rolling, mu_torsion] = friction.coefficients();
        self.laws.push(ContactThresholds {
            sliding: if M::Sliding::PRESENT { mu } else { 0.0 },
            rolling: mu_rolling * contact.effective_radius(),
            torsion: mu_torsion * contact.effective_radius(),
            cohesion: contact.cohesion(),
            friction: coupling,
        });
        self.tangents.push(tangents);
        Some(())
    }

    /// Adds the entries of a column of H for three degrees of freedom.
    fn enter(&mut self, column: usize, numbers: [Option<usize>; 3], pushed: &Vector3<f64>) {
        let entries = numbers.into_iter().zip(pushed);
        let entries = entries.filter(|(_, value)| **value != 0.0);
        let entry = |(at, value): (Option<usize>, &f64)| Some((at?, column, *value));
        self.arms.extend(entries.filter_map(entry));
    }

    fn finish(self) -> Option<PosedProblem> {
        let (freedoms, components) = (self.momenta.len(), self.prescribed.len());
        let m = SparseMatrix::from_triplets([freedoms; 2], &self.masses).ok()?;
        let h = SparseMatrix::from_triplets([freedoms, components], &self.arms).ok()?;
        let problem =
            GlobalProblem::new(self.layout, m, h, self.momenta, self.prescribed, self.laws).ok()?;
        Some(PosedProblem {
            problem,
            tangents: self.tangents,
        })
    }
}

/// Two unit vectors that make a right-handed frame with a unit normal.
///
/// The normal's smallest component tells the axis that is farthest from it.
fn tangents(normal: &Vector3<f64>) -> [Vector3<f64>; 2] {
    let axis = Vector3::ith(normal.iamin(), 1.0);
    let first = axis - normal * normal.dot(&axis);
    let first = first / first.norm_squared().sqrt();
    [first, normal.cross(&first)]
}
