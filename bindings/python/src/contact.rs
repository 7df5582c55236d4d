//! Contacts of spheres and plates that may open, slide, roll and spin.

use crate::arrays::{Output, Rows, broadcast, refused};
use crate::patch::Patch;
use crate::threads::fill;
use pyo3::prelude::*;
use tribos::friction::{AnyContactFriction, ContactVisitor};
use tribos_core::contact::{
    Attraction, Cohesion, Contact, ContactBody, ContactError, ContactFriction, ContactGeometry,
    NormalLaw, SphereBody, TimeStep, WallBody,
};
use tribos_core::nalgebra::Vector3;

/// Laws of a contact: along the normal, and friction.
#[pyclass(frozen, module = "tribos._native")]
pub struct ContactLaw {
    /// Cohesion and restitution.
    pub normal: NormalLaw<f64>,
    /// By the modes that it resists.
    pub friction: AnyContactFriction,
}

#[pymethods]
impl ContactLaw {
    /// Friction coefficients of sliding, rolling and torsion, or those of sliding and rolling with a patch
    /// of radius R_c/r_eff; restitution; cohesion's strength in N, range in m and whether it attracts.
    #[new]
    fn new(
        coefficients: [f64; 3],
        patch: Option<&Patch>,
        restitution: f64,
        cohesion: [f64; 2],
        attraction: &str,
    ) -> PyResult<Self> {
        let attraction = match attraction {
            "pull" => Attraction::Pull,
            "resistance" => Attraction::Resistance,
            other => {
                return Err(refused(format!(
                    "attraction must be 'pull' or 'resistance', not {other:?}"
                )));
            }
        };
        let [strength, range] = cohesion;
        let cohesion = Cohesion::new(strength, range, attraction).map_err(refused)?;
        let [mu, rolling, _] = coefficients;
        let friction = match patch {
            None => AnyContactFriction::thresholds(coefficients),
            Some(patch) => AnyContactFriction::coupled(&patch.0, mu, rolling),
        };
        Ok(Self {
            normal: NormalLaw::new(cohesion, restitution).map_err(refused)?,
            friction: friction.map_err(refused)?,
        })
    }

    /// Largest torsion torque without sliding, over force and lever.
    fn mu_torsion(&self) -> f64 {
        self.friction.mu_torsion()
    }

    /// Contacts of two spheres: rows of velocity, spin, 1/mass, 1/inertia and radius of both, normal and
    /// gap. Returns rows of both bodies' velocities and spins and of the impulse on the second: normal,
    /// sliding, rolling, torsion.
    fn spheres<'py>(
        &self,
        py: Python<'py>,
        rows: &Bound<'py, PyAny>,
        dt: f64,
    ) -> PyResult<Bound<'py, PyAny>> {
        self.each(py, rows, dt, |row| {
            let (first, second) = (sphere(row, 0), sphere(row, FIELDS));
            let (normal, gap) = geometry(row);
            let touch = sphere_touch(&normal, gap, [row[8], row[FIELDS + 8]])?;
            Ok((first, second, touch))
        })
    }

    /// The same for a sphere and a plate, of which velocity and 1/mass count.
    fn plate<'py>(
        &self,
        py: Python<'py>,
        rows: &Bound<'py, PyAny>,
        dt: f64,
    ) -> PyResult<Bound<'py, PyAny>> {
        self.each(py, rows, dt, |row| {
            let (first, second) = (sphere(row, 0), sphere(row, FIELDS));
            let plate = WallBody {
                velocity: second.velocity,
                inv_mass: second.inv_mass,
            };
            let (normal, gap) = geometry(row);
            Ok((first, plate, plate_touch(&normal, gap, row[8])?))
        })
    }
}

/// Numbers of a body in a row: velocity, spin, 1/mass, 1/inertia, radius.
const FIELDS: usize = 9;
/// Both bodies, normal and gap.
const GIVEN: usize = 2 * FIELDS + 4;
/// Velocities and spins of both, and the impulse.
const ANSWER: usize = 20;
/// Nanoseconds that a contact takes, about.
const COST: usize = 100;

/// A row as three numbers from `at` on.
fn vector(row: &[f64; GIVEN], at: usize) -> Vector3<f64> {
    Vector3::new(row[at], row[at + 1], row[at + 2])
}

fn sphere(row: &[f64; GIVEN], at: usize) -> SphereBody<f64> {
    SphereBody {
        velocity: vector(row, at),
        spin: vector(row, at + 3),
        inv_mass: row[at + 6],
        inv_inertia: row[at + 7],
    }
}

fn geometry(row: &[f64; GIVEN]) -> (Vector3<f64>, f64) {
    (vector(row, 2 * FIELDS), row[2 * FIELDS + 3])
}

/// The touch of spheres with this unit normal, from the first to the second, and gap.
pub fn sphere_touch(
    normal: &Vector3<f64>,
    gap: f64,
    radii: [f64; 2],
) -> Result<ContactGeometry<f64>, ContactError> {
    let [first, second] = radii;
    let touch = ContactGeometry::spheres(&(normal * (first + second + gap)), radii)?;
    // To the bit as given: a gap of 0 is closed.
    let normal = *normal;
    Ok(ContactGeometry {
        normal,
        gap,
        ..touch
    })
}

/// The touch of a sphere with a plate, to which the unit normal leads.
pub fn plate_touch(
    normal: &Vector3<f64>,
    gap: f64,
    radius: f64,
) -> Result<ContactGeometry<f64>, ContactError> {
    let touch = ContactGeometry::plate(radius + gap, &-normal, radius)?;
    Ok(ContactGeometry { gap, ..touch })
}

/// Bodies and geometry of a row.
type Prepared<B> = Result<(SphereBody<f64>, B, ContactGeometry<f64>), ContactError>;

impl ContactLaw {
    fn each<'py, B: ContactBody<f64>>(
        &self,
        py: Python<'py>,
        rows: &Bound<'py, PyAny>,
        dt: f64,
        of: impl Fn(&[f64; GIVEN]) -> Prepared<B> + Sync,
    ) -> PyResult<Bound<'py, PyAny>> {
        let dt = TimeStep::new(dt).map_err(refused)?.dt();
        let rows = Rows::<GIVEN>::new("rows", rows)?;
        let batch = broadcast(&[&rows])?;
        let rows = rows.over(&batch)?;
        let rows = rows.view()?;
        let mut output = Output::new(py, &batch, &[ANSWER], None)?;
        fill(py, output.rows::<ANSWER>()?, COST, |from, piece| {
            self.friction.visit(ContactRows {
                law: &self.normal,
                dt,
                prepared: |index: usize| of(&rows.at(from + index)),
                out: piece,
            })
        })?;
        output.finish()
    }
}

/// Contacts to be updated.
struct ContactRows<'a, P> {
    law: &'a NormalLaw<f64>,
    dt: f64,
    prepared: P,
    out: &'a mut [[f64; ANSWER]],
}

impl<B: ContactBody<f64>, P: Fn(usize) -> Prepared<B>> ContactVisitor for ContactRows<'_, P> {
    type Output = PyResult<()>;
    fn visit<F: ContactFriction<f64>>(self, friction: &F) -> PyResult<()> {
        for (index, row) in self.out.iter_mut().enumerate() {
            let (mut a, mut b, touch) = (self.prepared)(index).map_err(refused)?;
            let mut contact = Contact::<f64, F::Modes>::new(&touch, self.law, &a, &b, self.dt);
            contact.update(friction, &mut a, &mut b);
            let impulse = contact.impulse();
            let vectors = [
                a.velocity,
                a.spin,
                b.velocity(),
                b.angular_velocity(),
                impulse.sliding(),
                impulse.rolling(),
            ];
            for (numbers, vector) in row.as_chunks_mut::<3>().0.iter_mut().zip(vectors) {
                *numbers = vector.into();
            }
            [row[18], row[19]] = [impulse.normal, impulse.torsion()];
        }
        Ok(())
    }
}
