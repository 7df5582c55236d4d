//! The exact limit surface of a patch of any shape.
//!
//! Nothing is known of its form but the dissipated power D(t), which is convex and grows in
//! proportion to the twist t, its gradient g, which is a wrench of the surface, and its Hessian. With
//!
//! ```text
//! φ(t) = D(t)²/2 − x·t       D g = x where it is least: t is the normal above x, and D(t) the gauge of x
//! ψ(t) = t·M t/2 + D(t) − x·t       g = x − M t where it is least: the point of the set nearest to x
//! ```
//!
//! both questions are smooth, strictly convex problems in three unknowns: Newton's method, with
//! steps that are halved until they descend. φ's matrix g gᵀ + D D″ at its minimum is also the inverse of the
//! normal's derivative; and M + D″ that of the projection's.

use super::nonsmooth_search::{self, NonsmoothPoint};
use super::quadratic::{Factors, dot, norm, outer, over, product, stretched, unit_matrix};
use super::search::{
    self, Ended, GaugeObjective, Minimiser, Power, ProjectionObjective, TwistObjective, pivot,
};
use super::{FrictionSet, Projection, Region, collar};
use crate::coupling::flat::{PatchShape, ShapeFriction};
use crate::law::{LawError, validated_not_negative};
use crate::real::Real;
use crate::twist::{Twist, Wrench};
use nalgebra::{Matrix3, Vector2, Vector3};

/// Force limits up to which the search of a smooth surface takes the wrench as it is: beyond, rounding of
/// the wrench is more than that of its balance.
const FAR: f64 = 1_048_576.0;

/// Gauge from which on the displacement of a projection is nearly along the wrench.
const BEYOND: f64 = 8.0;

/// All wrenches that the dry friction of a patch of any shape can carry, about the origin of its
/// coordinates.
///
/// *Accuracy* (f64): gauge 1e-14, surface points and normals 1e-13 of the limits (f32: 1e-5), with the
/// origin at most a few radii away from the centre of pressure; about a distant one their ratio is lost. A
/// patch or a wall that is more than 10 times as long as wide loses its aspect ratio over 10 (f32: twice
/// that, up to 100:1), a needle of a mesh up to the square of it, and what counts as on the surface widens with
/// it, so that no projection moves a projected wrench.
/// Points: the same on facets; between them the gauge 1e-9, next to a facet's rim normals to its square
/// root; projections 1e-8 of the wrench there (f32: 1e-3). A projected wrench lies in the set to 16 rounding
/// errors, however far the given one, whatever the length, and wherever the search has ended. It is the nearest
/// one for lengths of 10⁻⁶ to 10⁶ radii in f64; in f32, beyond 0.1 to 10 radii, one in 200 is a more distant one.
/// *Special values*: gauge and normal are NaN should their search not end. *Cost*, in wrenches with Jacobian:
/// gauge, normal and projection about 5 each, at most 12 (more next to the rotation about a point).
///
/// ```
/// use tribos_core::limit_surface::{FrictionSet, ShapeLimitSurface};
/// use tribos_core::patch::outline::Polygon;
/// use tribos_core::twist::Wrench;
/// let (a, b) = (0.1_f64, 0.05); // half sides in m
/// let book = Polygon::new([[-a, -b], [a, -b], [a, b], [-a, b]])?;
/// let table = ShapeLimitSurface::new(book, 2.0)?; // μN in N
/// assert!(table.contains(&Wrench::new(1.0, 0.0, 0.05))); // N, N, N m
/// // Pushed at its long side, off the middle, it slides and turns.
/// let motion = table.twist_normal_to(&Wrench::new(0.0, 2.0, 2.0 * 0.04));
/// assert!(motion.velocity.y > 0.0 && motion.spin > 0.0 && motion.velocity.x.abs() < 1e-14);
/// # Ok::<(), tribos_core::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ShapeLimitSurface<R, P> {
    /// With a coefficient of 1.
    friction: ShapeFriction<R, P>,
    /// μN
    limit: R,
    /// Largest torque about the origin over the force limit: the unit of length of the search.
    arm: R,
    radius: R,
    /// Half width of the surface, of the gauge.
    collar: R,
}

impl<R: Real, P: PatchShape<R>> ShapeLimitSurface<R, P> {
    /// *Domain*: 0 ≤ `force_limit` < ∞ (μN). Without force limit the set is {0}.
    pub fn new(patch: P, force_limit: R) -> Result<Self, LawError> {
        // A quotient by −0 would have the wrong sign.
        let limit = validated_not_negative("force limit", force_limit)?.abs();
        let centre = patch.centre();
        let radius = patch.radius() + centre.x.hypot(centre.y);
        let collar = collar_of(patch.rounding());
        let turn = Twist::new(R::ZERO, R::ZERO, R::ONE);
        let friction = ShapeFriction::new(patch, R::ONE)?;
        let arm = friction.wrench(R::ONE, &turn).torque.abs();
        Ok(Self {
            friction,
            limit,
            arm,
            radius,
            collar,
        })
    }

    /// The patch.
    pub fn patch(&self) -> &P {
        self.friction.patch()
    }

    /// The largest torque about the origin.
    pub fn torque_limit(&self) -> R {
        self.force_limit() * self.arm
    }

    /// ∂gauge/∂wrench: the normal above `wrench`, scaled such that its support is 1, and the
    /// symmetric ∂²gauge/∂wrench².
    ///
    /// *Units*: 1/force and 1/(force × length); their products. *Special values*: NaN for the zero
    /// wrench, where the gauge has no derivative, for an infinite one and without force limit.
    ///
    /// ```
    /// use nalgebra::Vector3;
    /// use tribos_core::limit_surface::{FrictionSet, ShapeLimitSurface};
    /// use tribos_core::patch::outline::Polygon;
    /// use tribos_core::twist::Wrench;
    /// let foot = Polygon::new([[-0.05_f64, -0.04], [0.2, -0.05], [0.2, 0.05], [-0.05, 0.04]])?; // m
    /// let floor = ShapeLimitSurface::new(foot, 400.0)?; // N
    /// let push = Wrench::new(100.0, 50.0, 10.0); // N, N, N m
    /// let (normal, hessian) = floor.gauge_derivatives(&push);
    /// // The gauge grows in proportion to the wrench.
    /// assert!((push.power(&normal) - floor.gauge(&push)).abs() < 1e-14);
    /// assert!((hessian * Vector3::new(100.0, 50.0, 10.0)).amax() < 1e-12);
    /// # Ok::<(), tribos_core::Error>(())
    /// ```
    pub fn gauge_derivatives(&self, wrench: &Wrench<R>) -> (Twist<R>, Matrix3<R>) {
        let Some(wanted) = self.scaled(wrench) else {
            let nan = R::NAN;
            return (Twist::new(nan, nan, nan), Matrix3::from_element(nan));
        };
        let size = norm(&wanted);
        let goal = GaugeObjective {
            wrench: over(&wanted, size),
        };
        let found = self.above(&goal);
        let gauge = self.gauge_of(&goal, &found);
        let Minimiser {
            at, power, is_flat, ..
        } = found;
        let normal = at * (R::ONE / power.value);
        let hessian = if is_flat {
            Matrix3::from_element(R::ZERO)
        } else {
            let curvature = Factors::of(&goal.matrix(&power), pivot()).inverse();
            (curvature - outer(&normal)) * (R::ONE / (gauge * size))
        };
        // Back to the units of wrench and twist.
        let (unit, arm) = (R::ONE / self.force_limit(), R::ONE / self.arm);
        let twist = Twist::new(normal.x * unit, normal.y * unit, normal.z * unit * arm);
        (twist, stretched(&hessian, unit * unit, [arm, arm]))
    }

    /// [`FrictionSet::project_with_length`] and the derivative of the projected wrench.
    ///
    /// The derivative is the unit matrix inside the set and has the normal as its null space
    /// outside of it. *Units*: none, length, 1/length by row and column.
    ///
    /// ```
    /// use tribos_core::limit_surface::ShapeLimitSurface;
    /// use tribos_core::patch::outline::Polygon;
    /// use tribos_core::twist::Wrench;
    /// let tile = Polygon::new([[-0.1_f64, -0.1], [0.1, -0.1], [0.1, 0.1], [-0.1, 0.1]])?; // m
    /// let floor = ShapeLimitSurface::new(tile, 5.0)?; // N
    /// // A straight push of 9 N, where 5 N are carried: to the side alone the force follows.
    /// let (carried, rate) = floor.project_with_jacobian(&Wrench::new(9.0, 0.0, 0.0), 0.1);
    /// assert!((carried.wrench.force.x - 5.0).abs() < 1e-13 && rate[(0, 0)].abs() < 1e-13);
    /// assert!((rate[(1, 1)] - 5.0 / 9.0).abs() < 1e-13);
    /// # Ok::<(), tribos_core::Error>(())
    /// ```
    pub fn project_with_jacobian(
        &self,
        wrench: &Wrench<R>,
        length: R,
    ) -> (Projection<R>, Matrix3<R>) {
        match self.project_outside(wrench, length) {
            ProjectionCase::Stays(projection) => (projection, unit_matrix()),
            ProjectionCase::Nowhere(projection) => (projection, Matrix3::from_element(R::NAN)),
            ProjectionCase::Back {
                projection,
                goal,
                found,
            } => {
                let rate = if found.is_flat {
                    flattened(&goal, &found.at)
                } else {
                    let inverse = Factors::of(&goal.matrix(&found.power), pivot()).inverse();
                    product(&(found.power.hessian * goal.reach), &inverse)
                };
                let rate = stretched(&rate, R::ONE, [self.arm, R::ONE / self.arm]);
                (projection, rate)
            }
        }
    }

    /// The wrench in units of force limit and arm; `None` where it has no direction.
    fn scaled(&self, wrench: &Wrench<R>) -> Option<Vector3<R>> {
        let limit = self.force_limit();
        let scaled = Vector3::new(
            wrench.force.x / limit,
            wrench.force.y / limit,
            wrench.torque / limit / self.arm,
        );
        let size = norm(&scaled);
        (size > R::ZERO && size.is_finite()).then_some(scaled)
    }

    fn power(&self, at: &Vector3<R>) -> Power<R> {
        let inv_arm = R::ONE / self.arm;
        let twist = Twist::new(at.x, at.y, at.z * inv_arm);
        let (wrench, jacobian) = self.friction.wrench_and_jacobian(R::ONE, &twist);
        let gradient = Vector3::new(-wrench.force.x, -wrench.force.y, -(wrench.torque * inv_arm));
        let hessian = stretched(&jacobian, -R::ONE, [inv_arm, inv_arm]);
        Power {
            value: dot(&gradient, at),
            gradient,
            hessian,
        }
    }

    /// The normal above a wrench of length 1, not normalised, from that of the ellipsoid on.
    fn above(&self, goal: &GaugeObjective<R>) -> Minimiser<R> {
        self.least(goal, goal.wrench)
    }

    /// True if points carry load: the surface has facets.
    fn has_points(&self) -> bool {
        let middle = Vector2::new(R::ZERO, R::ZERO);
        self.patch().nearest_point(&middle).is_some()
    }

    /// Force limits from which on a wrench is the unit of its own search.
    fn far(&self) -> R {
        if self.has_points() {
            R::ONE
        } else {
            R::from_f64(FAR)
        }
    }

    fn least(&self, goal: &impl TwistObjective<R>, start: Vector3<R>) -> Minimiser<R> {
        let power_at = |at: &Vector3<R>| self.power(at);
        if !self.has_points() {
            return search::minimise(goal, start, self.patch().rounding(), power_at);
        }
        nonsmooth_search::minimise(goal, start, power_at, |at| self.kink(at))
    }

    /// The point next to the centre of rotation, if points carry load.
    fn kink(&self, at: &Vector3<R>) -> Option<NonsmoothPoint<R>> {
        let (centre, radius) = (self.patch().centre(), self.patch().radius());
        let arms = |x: R| self.arm * (x / at.z);
        let place = Vector2::new(
            (-arms(at.y) - centre.x) / radius,
            (arms(at.x) - centre.y) / radius,
        );
        if !(place.x.is_finite() && place.y.is_finite()) {
            return None;
        }
        let point = self.patch().nearest_point(&place)?;
        let [x, y] = [
            (centre.x + point.place.x * radius) / self.arm,
            (centre.y + point.place.y * radius) / self.arm,
        ];
        Some(NonsmoothPoint {
            turn: Vector3::new(y, -x, R::ONE),
            share: point.share,
            place: [x, y],
        })
    }

    /// The gauge of a wrench above which the search has ended: from below at any twist, so that it is no number
    /// where the search has missed.
    fn gauge_of(&self, goal: &GaugeObjective<R>, found: &Minimiser<R>) -> R {
        match found.ended {
            Ended::Level | Ended::Rounding => dot(&goal.wrench, &found.at) / found.power.value,
            Ended::Missed => R::NAN,
        }
    }

    /// A twist of the search with |velocity|² + (spin · radius)² = 1.
    fn normal(&self, at: &Vector3<R>) -> Twist<R> {
        let spin = at.z / self.arm;
        let length = at.x.hypot(at.y).hypot(spin * self.radius);
        Twist::new(at.x / length, at.y / length, spin / length)
    }

    fn project_outside(&self, wrench: &Wrench<R>, length: R) -> ProjectionCase<R> {
        let limit = self.force_limit();
        let stays = |region| {
            ProjectionCase::Stays(Projection {
                wrench: *wrench,
                region,
            })
        };
        if *wrench == Wrench::ZERO {
            return stays(Region::Inside);
        }
        let arm = length / self.arm;
        let (Some(wanted), true) = (self.scaled(wrench), arm > R::ZERO && arm.is_finite()) else {
            return self.pulled_to_zero(wrench, length);
        };
        let size = norm(&wanted);
        let radial = GaugeObjective {
            wrench: over(&wanted, size),
        };
        let found = self.above(&radial);
        // No number where the search has missed: the wrench is then brought to the surface.
        let gauge = size * self.gauge_of(&radial, &found);
        let Minimiser {
            at: above, power, ..
        } = found;
        if gauge < R::ONE - self.collar {
            return stays(Region::Inside);
        }
        if gauge <= R::ONE + self.collar {
            let normal = self.normal(&above);
            return stays(Region::OnSurface { normal });
        }
        // A wrench of any size is one of order 1 to the search.
        let (wrench, reach) = if size > self.far() {
            (radial.wrench, R::ONE / size)
        } else {
            (wanted, R::ONE)
        };
        let goal = ProjectionObjective {
            wrench,
            reach,
            length_sq: arm * arm,
        };
        let start = if gauge > R::from_f64(BEYOND) && self.has_points() {
            // What is left of a wrench far outside is along it.
            goal.twist_along(&(goal.wrench * (R::ONE - R::ONE / gauge)))
        } else {
            // Along the normal above the wrench ψ is a parabola.
            above * goal.length_along(&above, power.value)
        };
        let found = self.least(&goal, start);
        let g = &found.power.gradient;
        ProjectionCase::Back {
            projection: Projection {
                wrench: Wrench::new(limit * g.x, limit * g.y, limit * self.arm * g.z),
                region: Region::OnSurface {
                    normal: self.normal(&found.at),
                },
            },
            goal,
            found,
        }
    }

    /// The answer where no wrench is carried, and where there is no nearest one.
    #[cold]
    fn pulled_to_zero(&self, wrench: &Wrench<R>, length: R) -> ProjectionCase<R> {
        let nan = R::NAN;
        let spin = wrench.torque / (length * length);
        let at = Vector3::new(wrench.force.x, wrench.force.y, spin * self.arm);
        let normal = self.normal(&at);
        let is_number = normal.spin.is_finite() && normal.velocity.x.is_finite();
        let (wrench, normal) = if self.force_limit() == R::ZERO && length > R::ZERO && is_number {
            (Wrench::ZERO, normal)
        } else {
            (Wrench::new(nan, nan, nan), Twist::new(nan, nan, nan))
        };
        ProjectionCase::Nowhere(Projection {
            wrench,
            region: Region::OnSurface { normal },
        })
    }
}

/// Half width of the surface of a slender patch, in units of the rounding of its power; 11 were seen. And
/// the largest one, of the gauge: beyond, single precision does not know the width of the patch.
const SLENDER_COLLAR: f64 = 24.0;
const LARGEST_COLLAR: f64 = 1.0 / 64.0;

/// Half width of the surface of a patch with this rounding.
fn collar_of<R: Real>(rounding: R) -> R {
    let own = R::from_f64(SLENDER_COLLAR) * rounding;
    let most = R::from_f64(LARGEST_COLLAR);
    let least = collar();
    if own > most {
        most
    } else if own > least {
        own
    } else {
        least
    }
}

/// How a wrench is brought into the set.
enum ProjectionCase<R: Real> {
    Stays(Projection<R>),
    Back {
        projection: Projection<R>,
        goal: ProjectionObjective<R>,
        found: Minimiser<R>,
    },
    Nowhere(Projection<R>),
}

/// Derivative of the nearest wrench of a facet with the normal `at`.
fn flattened<R: Real>(goal: &ProjectionObjective<R>, at: &Vector3<R>) -> Matrix3<R> {
    let away = goal.displacement(at);
    let share = away * (R::ONE / dot(at, &away));
    unit_matrix() - Matrix3::from_columns(&[share * at.x, share * at.y, share * at.z])
}

impl<R: Real, P: PatchShape<R>> FrictionSet<R> for ShapeLimitSurface<R, P> {
    fn force_limit(&self) -> R {
        self.limit
    }

    fn radius(&self) -> R {
        self.radius
    }

    fn support(&self, twist: &Twist<R>) -> R {
        -self.friction.wrench(self.limit, twist).power(twist)
    }

    fn wrench(&self, twist: &Twist<R>) -> Wrench<R> {
        self.friction.wrench(self.limit, twist)
    }

    fn gauge(&self, wrench: &Wrench<R>) -> R {
        let Some(wanted) = self.scaled(wrench) else {
            return self.odd_gauge(wrench);
        };
        let size = norm(&wanted);
        let goal = GaugeObjective {
            wrench: over(&wanted, size),
        };
        size * self.gauge_of(&goal, &self.above(&goal))
    }

    fn contains(&self, wrench: &Wrench<R>) -> bool {
        self.gauge(wrench) <= R::ONE + self.collar
    }

    fn twist_normal_to(&self, push: &Wrench<R>) -> Twist<R> {
        let Some(wanted) = self.scaled(push) else {
            let nan = R::NAN;
            return if *push == Wrench::ZERO {
                Twist::ZERO
            } else {
                Twist::new(nan, nan, nan)
            };
        };
        let goal = GaugeObjective {
            wrench: over(&wanted, norm(&wanted)),
        };
        let found = self.above(&goal);
        match found.ended {
            Ended::Level | Ended::Rounding => self.normal(&found.at),
            Ended::Missed => self.normal(&(found.at * R::NAN)),
        }
    }

    fn scale_to_surface(&self, wrench: &Wrench<R>) -> Wrench<R> {
        if *wrench == Wrench::ZERO {
            return *wrench;
        }
        *wrench * (R::ONE / self.gauge(wrench))
    }

    fn project_with_length(&self, wrench: &Wrench<R>, length: R) -> Projection<R> {
        match self.project_outside(wrench, length) {
            ProjectionCase::Stays(projection)
            | ProjectionCase::Nowhere(projection)
            | ProjectionCase::Back { projection, .. } => projection,
        }
    }
}

impl<R: Real, P: PatchShape<R>> ShapeLimitSurface<R, P> {
    /// The gauge of a wrench without direction.
    #[cold]
    fn odd_gauge(&self, wrench: &Wrench<R>) -> R {
        let size = wrench.force.x.abs() + wrench.force.y.abs() + wrench.torque.abs();
        if size == R::ZERO || size.is_nan() {
            size
        } else {
            R::INFINITY
        }
    }
}

#[cfg(test)]
mod tests;
