//! Limit surfaces with second derivatives.
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

use crate::arrays::refused;
use crate::model::{Sets, twist_of};
use nalgebra::{Matrix2, Matrix3, Matrix3x2, Vector3};
use pyo3::prelude::*;
use tribos::friction::{self, Area, AreaFriction, Law};
use tribos_core::coupling::flat::ShapeFriction;
use tribos_core::limit_surface::{FrictionSet, Projection, Region, ShapeLimitSurface};
use tribos_core::twist::{Twist, Wrench};

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
    pub fn normal_jacobian(&self, wrench: &Wrench<f64>) -> Matrix3<f64> {
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
pub type Work<'a> = &'a mut dyn FnMut(&dyn Smooth);

/// Surfaces of a patch for every force limit.
pub trait Family: Send + Sync {
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
pub struct Ellipsoids {
    pub sets: Sets,
    pub arm: f64,
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

/// Two directions of length 1 across another and each other.
fn across(along: &Vector3<f64>) -> Matrix3x2<f64> {
    let mut axis = Vector3::zeros();
    axis[along.iamin()] = 1.0;
    let first = along.cross(&axis).normalize();
    let second = along.cross(&first).normalize();
    Matrix3x2::from_columns(&[first, second])
}

/// The surfaces of an area.
pub fn family(area: &Area) -> PyResult<Box<dyn Family>> {
    let Area::Flat(flat) = area else {
        let law = Law::coulomb(1.0).map_err(refused)?;
        return Ok(Box::new(Round {
            sets: Sets::new(area)?,
            friction: AreaFriction::new(area, &law, None).map_err(refused)?,
        }));
    };
    Ok(Box::new(Flat(flat.clone())))
}
