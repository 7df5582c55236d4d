//! Derivatives of limit surfaces.
//!
//! With the dissipated power D(t), its gradient g, a wrench of the surface, and its Hessian D″,
//!
//! ```text
//! ∂²gauge = ((g gᵀ + D″)⁻¹ − n nᵀ)/gauge       n = ∂gauge, the normal with D(n) = 1; D″ at n
//! ∂projection = D″ (λ M + D″)⁻¹                 x − y = λ M n,  M = diag(1, 1, length²);  D″ at n
//! ```
//!
//! Straight edges and points have them in the kernel, which knows facets; for surfaces without facets
//! they are computed here, in units of force limit and radius.

use super::part;
use super::step::{AFTER, BY, STEP, StepGradient, moved};
use crate::arrays::{Numbers, Output, Rows, View, broadcast, refused};
use crate::model::{Sets, twist_numbers, twist_of, wrench_of};
use crate::patch::Patch;
use crate::threads::fill;
use nalgebra::{Matrix2, Matrix3, Matrix3x2, Vector3};
use pyo3::prelude::*;
use pyo3::types::PyTuple;
use tribos::friction::{self, Area, AreaFriction, Law};
use tribos_core::contact::TimeStep;
use tribos_core::coupling::flat::ShapeFriction;
use tribos_core::limit_surface::{FrictionSet, Projection, Region, ShapeLimitSurface};
use tribos_core::planar::PlanarBody;
use tribos_core::twist::{Twist, Wrench};

/// Nanoseconds that a derivative takes, about.
const COST: usize = 1500;

/// A limit surface with second derivatives.
pub trait Smooth {
    /// The surface.
    fn set(&self) -> &dyn FrictionSet<f64>;
    /// D″ at a twist.
    fn support_hessian(&self, twist: &Twist<f64>) -> Matrix3<f64>;
    /// Gradient and Hessian of the gauge.
    fn gauge_derivatives(&self, wrench: &Wrench<f64>) -> (Twist<f64>, Matrix3<f64>);
    /// The nearest wrench and its derivative, outside of a set with a force limit > 0.
    fn pulled_back(&self, wrench: &Wrench<f64>, length: f64) -> (Projection<f64>, Matrix3<f64>);
}

impl dyn Smooth + '_ {
    /// The nearest wrench of the set, and its derivative.
    pub fn project(&self, wrench: &Wrench<f64>, length: f64) -> (Wrench<f64>, Matrix3<f64>) {
        if self.set().force_limit() == 0.0 {
            let nearest = self.set().project_with_length(wrench, length).wrench;
            return (nearest, Matrix3::zeros());
        }
        let (projection, rate) = self.pulled_back(wrench, length);
        (projection.wrench, rate)
    }

    /// ∂(unit normal)/∂wrench: that of gradient/|gradient|.
    fn normal_jacobian(&self, wrench: &Wrench<f64>) -> Matrix3<f64> {
        let (gradient, hessian) = self.gauge_derivatives(wrench);
        let radius = self.set().radius();
        let rim = gradient.spin * radius;
        let length = gradient.velocity.x.hypot(gradient.velocity.y).hypot(rim);
        let unit = Vector3::from(gradient) / length;
        let dual = Vector3::new(unit.x, unit.y, unit.z * radius * radius);
        (hessian - unit * (dual.transpose() * hessian)) / length
    }
}

/// Work with a limit surface.
type Work<'a> = &'a mut dyn FnMut(&dyn Smooth);

/// Surfaces of a patch for every force limit.
trait Family: Send + Sync {
    fn with(&self, force_limit: f64, work: Work<'_>) -> PyResult<()>;
}

/// Straight edges, meshes and points.
struct Flat(friction::Flat<f64>);

struct FlatSurface<'a> {
    surface: ShapeLimitSurface<f64, &'a friction::Flat<f64>>,
    friction: ShapeFriction<f64, &'a friction::Flat<f64>>,
}

impl Family for Flat {
    fn with(&self, force_limit: f64, work: Work<'_>) -> PyResult<()> {
        work(&FlatSurface {
            surface: ShapeLimitSurface::new(&self.0, force_limit).map_err(refused)?,
            friction: ShapeFriction::new(&self.0, 1.0).map_err(refused)?,
        });
        Ok(())
    }
}

impl Smooth for FlatSurface<'_> {
    fn set(&self) -> &dyn FrictionSet<f64> {
        &self.surface
    }
    fn support_hessian(&self, twist: &Twist<f64>) -> Matrix3<f64> {
        let limit = self.surface.force_limit();
        -self.friction.wrench_and_jacobian(limit, twist).1
    }
    fn gauge_derivatives(&self, wrench: &Wrench<f64>) -> (Twist<f64>, Matrix3<f64>) {
        self.surface.gauge_derivatives(wrench)
    }
    fn pulled_back(&self, wrench: &Wrench<f64>, length: f64) -> (Projection<f64>, Matrix3<f64>) {
        self.surface.project_with_jacobian(wrench, length)
    }
}

/// Round patches.
struct Round {
    sets: Sets,
    /// With a coefficient of 1.
    friction: AreaFriction,
}

impl Family for Round {
    fn with(&self, force_limit: f64, work: Work<'_>) -> PyResult<()> {
        let hessian = |twist: &Twist<f64>| -self.friction.wrench_jacobian(1.0, twist);
        self.sets.with(force_limit, |set| {
            work(&Curved {
                set,
                hessian: &hessian,
            });
        })
    }
}

/// Ellipsoids: D = limit √(|velocity|² + (arm spin)²).
struct Ellipsoids {
    sets: Sets,
    arm: f64,
}

impl Family for Ellipsoids {
    fn with(&self, force_limit: f64, work: Work<'_>) -> PyResult<()> {
        let hessian = |twist: &Twist<f64>| {
            let weights = Vector3::new(1.0, 1.0, self.arm * self.arm);
            let rim = twist.spin * self.arm;
            let length = twist.velocity.x.hypot(twist.velocity.y).hypot(rim);
            let gradient = weights.component_mul(&Vector3::from(*twist)) / length;
            (Matrix3::from_diagonal(&weights) - gradient * gradient.transpose()) / length
        };
        self.sets.with(force_limit, |set| {
            work(&Curved {
                set,
                hessian: &hessian,
            });
        })
    }
}

/// A surface without facets.
struct Curved<'a> {
    set: &'a dyn FrictionSet<f64>,
    /// D″ at a force limit of 1.
    hessian: &'a (dyn Fn(&Twist<f64>) -> Matrix3<f64> + Sync),
}

impl Curved<'_> {
    /// A wrench in units of force limit and radius.
    fn scaled(&self, wrench: &Wrench<f64>) -> Vector3<f64> {
        let torque = wrench.torque / self.set.radius();
        Vector3::new(wrench.force.x, wrench.force.y, torque) / self.set.force_limit()
    }

    /// A normal as velocity and rim speed, with the D″ of these units at it.
    fn curvature(&self, normal: &Twist<f64>) -> (Vector3<f64>, Matrix3<f64>) {
        let radius = self.set.radius();
        let at = Vector3::new(normal.velocity.x, normal.velocity.y, normal.spin * radius);
        let inv_radius = Matrix3::from_diagonal(&Vector3::new(1.0, 1.0, 1.0 / radius));
        (at, inv_radius * (self.hessian)(normal) * inv_radius)
    }
}

impl Smooth for Curved<'_> {
    fn set(&self) -> &dyn FrictionSet<f64> {
        self.set
    }

    fn support_hessian(&self, twist: &Twist<f64>) -> Matrix3<f64> {
        (self.hessian)(twist) * self.set.force_limit()
    }

    fn gauge_derivatives(&self, wrench: &Wrench<f64>) -> (Twist<f64>, Matrix3<f64>) {
        let (limit, radius) = (self.set.force_limit(), self.set.radius());
        let gauge = self.set.gauge(wrench);
        let normal = self.set.twist_normal_to(wrench);
        let surface = self.scaled(wrench) / gauge;
        let (at, bend) = self.curvature(&normal);
        // Scaled such that the power is 1; D″ falls as the twist grows.
        let power = at.dot(&surface);
        let (at, bend) = (at / power, bend * power);
        let matrix = surface * surface.transpose() + bend;
        let nan = Matrix3::from_element(f64::NAN);
        let inverse = matrix.cholesky().map_or(nan, |factors| factors.inverse());
        let hessian = (inverse - at * at.transpose()) / gauge;
        // Back to the units of wrench and twist.
        let unit = Vector3::new(1.0, 1.0, 1.0 / radius) / limit;
        let gradient = at.component_mul(&unit);
        let unit = Matrix3::from_diagonal(&unit);
        (twist_of(gradient.into()), unit * hessian * unit)
    }

    fn pulled_back(&self, wrench: &Wrench<f64>, length: f64) -> (Projection<f64>, Matrix3<f64>) {
        let radius = self.set.radius();
        let projection = self.set.project_with_length(wrench, length);
        let normal = match projection.region {
            // NaN is no wrench that stays.
            Region::OnSurface { normal } if projection.wrench != *wrench => normal,
            _ => return (projection, Matrix3::identity()),
        };
        let away = self.scaled(wrench) - self.scaled(&projection.wrench);
        let (at, bend) = self.curvature(&normal);
        let lever = length / radius;
        let weights = Vector3::new(1.0, 1.0, lever * lever);
        let along = weights.component_mul(&at);
        let distance = at.dot(&away) / at.dot(&along);
        // The derivative has the null vectors M n and, from the left, n: two equations are left.
        let plane = across(&along);
        let weighed = Matrix3::from_diagonal(&(weights * distance)) + bend;
        let both: Matrix2<f64> = plane.transpose() * weighed * plane;
        let nan = Matrix2::from_element(f64::NAN);
        let inverse = both.cholesky().map_or(nan, |factors| factors.inverse());
        let rate = bend * plane * inverse * plane.transpose();
        let unit = |z| Matrix3::from_diagonal(&Vector3::new(1.0, 1.0, z));
        (projection, unit(radius) * rate * unit(1.0 / radius))
    }
}

/// Pair2 directions of length 1 across another and each other.
fn across(along: &Vector3<f64>) -> Matrix3x2<f64> {
    let mut axis = Vector3::zeros();
    axis[along.iamin()] = 1.0;
    let first = along.cross(&axis).normalize();
    let second = along.cross(&first).normalize();
    Matrix3x2::from_columns(&[first, second])
}

fn family(area: &Area) -> PyResult<Box<dyn Family>> {
    let Area::Flat(flat) = area else {
        let law = Law::coulomb(1.0).map_err(refused)?;
        return Ok(Box::new(Round {
            sets: Sets::new(area)?,
            friction: AreaFriction::new(area, &law, None).map_err(refused)?,
        }));
    };
    Ok(Box::new(Flat(flat.clone())))
}

/// Derivatives of the limit surfaces of a patch, and of steps on it.
#[pyclass(frozen, module = "tribos._native")]
pub struct SurfaceDerivatives {
    family: Box<dyn Family>,
}

impl SurfaceDerivatives {
    /// What `of` makes of the surface and of each row, as matrices or rows of `shape`.
    fn each<'py, const M: usize>(
        &self,
        (name, limits, rows): (&'static str, &Bound<'py, PyAny>, &Bound<'py, PyAny>),
        shape: &[usize],
        out: Option<&Bound<'py, PyAny>>,
        of: impl Fn(&dyn Smooth, [f64; 3]) -> [f64; M] + Sync,
    ) -> PyResult<Bound<'py, PyAny>> {
        let py = rows.py();
        let rows = Rows::<3>::new(name, rows)?;
        let limits = Numbers::new("force limit", limits)?;
        let batch = broadcast(&[&rows, &limits])?;
        let (rows, limits) = (rows.over(&batch)?, limits.over(&batch)?);
        let (rows, limits) = (rows.view()?, limits.view()?);
        let mut output = Output::new(py, &batch, shape, out)?;
        fill(py, output.rows::<M>()?, COST, |from, piece| {
            if let View::One([limit]) = limits {
                return self.family.with(limit, &mut |surface| {
                    for (index, row) in (from..).zip(piece.iter_mut()) {
                        *row = of(surface, rows.at(index));
                    }
                });
            }
            for (index, row) in (from..).zip(piece.iter_mut()) {
                let [limit] = limits.at(index);
                let mut work = |surface: &dyn Smooth| *row = of(surface, rows.at(index));
                self.family.with(limit, &mut work)?;
            }
            Ok(())
        })?;
        output.finish()
    }

    /// Steps and derivatives of a batch.
    fn steps(
        &self,
        [twists, pushes]: [&Bound<'_, PyAny>; 2],
        [limits, mass, inertia, dt]: [&Bound<'_, PyAny>; 4],
    ) -> PyResult<(Vec<usize>, Vec<[f64; STEP]>)> {
        let py = twists.py();
        let limits = Numbers::new("load", limits)?;
        let twists = Rows::<3>::new("twists", twists)?;
        let pushes = Rows::<3>::new("pushes", pushes)?;
        let mass = Numbers::new("mass", mass)?;
        let inertia = Numbers::new("inertia", inertia)?;
        let dt = Numbers::new("dt", dt)?;
        let batch = broadcast(&[&twists, &pushes, &limits, &mass, &inertia, &dt])?;
        let (twists, pushes) = (twists.over(&batch)?, pushes.over(&batch)?);
        let (twists, pushes) = (twists.view()?, pushes.view()?);
        let (limits, mass) = (limits.over(&batch)?, mass.over(&batch)?);
        let (inertia, dt) = (inertia.over(&batch)?, dt.over(&batch)?);
        let (limits, mass, inertia, dt) =
            (limits.view()?, mass.view()?, inertia.view()?, dt.view()?);
        let mut rows = vec![[0.0; STEP]; batch.iter().product()];
        fill(py, &mut rows, COST, |from, piece| {
            for (index, row) in (from..).zip(piece.iter_mut()) {
                let ([mass], [inertia], [dt]) = (mass.at(index), inertia.at(index), dt.at(index));
                let [limit] = limits.at(index);
                let mut body = StepGradient {
                    body: PlanarBody::new(mass, inertia).map_err(refused)?,
                    dt: TimeStep::new(dt).map_err(refused)?,
                    twist: twist_of(twists.at(index)),
                    push: wrench_of(pushes.at(index)),
                    first: Wrench::ZERO,
                };
                if limit == 0.0 {
                    let twist = body.resisted();
                    let mut work = |unit: &dyn Smooth| body.first = unit.set().wrench(&twist);
                    self.family.with(1.0, &mut work)?;
                }
                self.family
                    .with(limit, &mut |surface| *row = moved(surface, &body))?;
            }
            Ok(())
        })?;
        Ok((batch, rows))
    }
}

/// A matrix as its rows.
fn by_rows(matrix: &Matrix3<f64>) -> [f64; 9] {
    let mut rows = [0.0; 9];
    rows.copy_from_slice(matrix.transpose().as_slice());
    rows
}

fn validated(length: Option<f64>) -> PyResult<()> {
    match length {
        Some(length) if !(length > 0.0 && length.is_finite()) => Err(refused(format!(
            "length must be > 0 and finite, not {length}"
        ))),
        _ => Ok(()),
    }
}

#[pymethods]
impl SurfaceDerivatives {
    #[new]
    fn new(patch: &Patch) -> PyResult<Self> {
        let family = family(&patch.0)?;
        Ok(Self { family })
    }

    /// Those of the ellipsoids with the same largest force and torque.
    #[staticmethod]
    fn of_ellipsoids(patch: &Patch) -> PyResult<Self> {
        let sets = Sets::new(&patch.0)?.ellipsoids()?;
        let turn = twist_of([0.0, 0.0, 1.0]);
        let arm = sets.with(1.0, |set| set.support(&turn))?;
        let family = Box::new(Ellipsoids { sets, arm });
        Ok(Self { family })
    }

    /// Gradients of the gauge at wrenches.
    #[pyo3(signature = (force_limit, wrenches, out=None))]
    fn gauge_gradient<'py>(
        &self,
        force_limit: &Bound<'py, PyAny>,
        wrenches: &Bound<'py, PyAny>,
        out: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let given = ("wrenches", force_limit, wrenches);
        self.each(given, &[3], out, |surface, row| {
            twist_numbers(&surface.gauge_derivatives(&wrench_of(row)).0)
        })
    }

    /// Hessians of the gauge at wrenches.
    #[pyo3(signature = (force_limit, wrenches, out=None))]
    fn gauge_hessian<'py>(
        &self,
        force_limit: &Bound<'py, PyAny>,
        wrenches: &Bound<'py, PyAny>,
        out: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let given = ("wrenches", force_limit, wrenches);
        self.each(given, &[3, 3], out, |surface, row| {
            by_rows(&surface.gauge_derivatives(&wrench_of(row)).1)
        })
    }

    /// Derivatives of the normals above wrenches.
    #[pyo3(signature = (force_limit, wrenches, out=None))]
    fn normal_jacobian<'py>(
        &self,
        force_limit: &Bound<'py, PyAny>,
        wrenches: &Bound<'py, PyAny>,
        out: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let given = ("wrenches", force_limit, wrenches);
        self.each(given, &[3, 3], out, |surface, row| {
            by_rows(&surface.normal_jacobian(&wrench_of(row)))
        })
    }

    /// Derivatives of the nearest wrenches; None as length for the radius.
    #[pyo3(signature = (force_limit, wrenches, length=None, out=None))]
    fn project_jacobian<'py>(
        &self,
        force_limit: &Bound<'py, PyAny>,
        wrenches: &Bound<'py, PyAny>,
        length: Option<f64>,
        out: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        validated(length)?;
        let given = ("wrenches", force_limit, wrenches);
        self.each(given, &[3, 3], out, |surface, row| {
            let length = length.unwrap_or(surface.set().radius());
            by_rows(&surface.project(&wrench_of(row), length).1)
        })
    }

    /// Hessians of the support function at twists.
    #[pyo3(signature = (force_limit, twists, out=None))]
    fn support_hessian<'py>(
        &self,
        force_limit: &Bound<'py, PyAny>,
        twists: &Bound<'py, PyAny>,
        out: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let given = ("twists", force_limit, twists);
        self.each(given, &[3, 3], out, |surface, row| {
            by_rows(&surface.support_hessian(&twist_of(row)))
        })
    }

    /// Implicit steps of bodies: twists after, mean friction, 1 at rest or else 0, and the derivatives of
    /// the first two by twist, push, force limit, mass, inertia and time.
    fn planar_step_jacobian<'py>(
        &self,
        force_limit: &Bound<'py, PyAny>,
        twists: &Bound<'py, PyAny>,
        pushes: &Bound<'py, PyAny>,
        mass: &Bound<'py, PyAny>,
        inertia: &Bound<'py, PyAny>,
        dt: &Bound<'py, PyAny>,
    ) -> PyResult<Bound<'py, PyTuple>> {
        let py = twists.py();
        let (rows, numbers) = ([twists, pushes], [force_limit, mass, inertia, dt]);
        let (batch, rows) = self.steps(rows, numbers)?;
        let parts = [
            part::<STEP, 3>(py, &batch, &[3], &rows, 0)?,
            part::<STEP, 3>(py, &batch, &[3], &rows, 3)?,
            part::<STEP, 1>(py, &batch, &[], &rows, 6)?,
            part::<STEP, { 6 * BY }>(py, &batch, &[6, BY], &rows, AFTER)?,
        ];
        PyTuple::new(py, parts)
    }
}
