//! Force and torque limited each by itself: a model to compare the exact limit surface with.

use tribos_core::limit_surface::{FrictionSet, Projection, Region};
use tribos_core::real::Real;
use tribos_core::twist::{Twist, Wrench};

/// The cylinder |force| ≤ μN, |torque| ≤ the largest torque of pure spinning.
///
/// Friction of each motion is as if the other were not there. The exact set lies inside.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Separate {
    /// μN, in N.
    pub force_limit: f64,
    /// In N m.
    pub torque_limit: f64,
    /// The lever that makes a speed of a spin, in m.
    pub radius: f64,
}

impl Separate {
    /// Force and torque over their limits.
    fn parts(&self, wrench: &Wrench<f64>) -> [f64; 2] {
        let part = |value: f64, limit: f64| if value == 0.0 { value } else { value / limit };
        let force = wrench.force.x.hypot_of(wrench.force.y);
        [
            part(force, self.force_limit),
            part(wrench.torque.abs(), self.torque_limit),
        ]
    }

    /// Outward normal at a wrench whose force, torque or both are at their limits.
    fn normal(&self, wrench: &Wrench<f64>, [force, torque]: [bool; 2]) -> Twist<f64> {
        let length = wrench.force.x.hypot_of(wrench.force.y);
        let lean = if force && length > 0.0 { 1.0 } else { 0.0 };
        let turn = if torque { 1.0 } else { 0.0 };
        // On the edge both motions, in equal parts.
        let scale = 1.0 / Real::sqrt(f64::max(lean + turn, 1.0));
        let along = |component: f64| {
            if lean > 0.0 {
                scale * component / length
            } else {
                0.0
            }
        };
        Twist::new(
            along(wrench.force.x),
            along(wrench.force.y),
            scale * turn * Real::copysign(1.0, wrench.torque) / self.radius,
        )
    }
}

/// The kernel's hypotenuse, which is the same on every platform.
trait Hypotenuse {
    fn hypot_of(self, other: f64) -> f64;
}

impl Hypotenuse for f64 {
    #[inline]
    fn hypot_of(self, other: f64) -> f64 {
        Real::hypot(self, other)
    }
}

impl FrictionSet<f64> for Separate {
    fn force_limit(&self) -> f64 {
        self.force_limit
    }
    fn radius(&self) -> f64 {
        self.radius
    }
    fn support(&self, twist: &Twist<f64>) -> f64 {
        self.force_limit * twist.speed() + self.torque_limit * twist.spin.abs()
    }
    fn wrench(&self, twist: &Twist<f64>) -> Wrench<f64> {
        let speed = twist.speed();
        let along = |component: f64| {
            if component == 0.0 {
                -component
            } else {
                -self.force_limit * (component / speed)
            }
        };
        let torque = if twist.spin == 0.0 || twist.spin.is_nan() {
            -twist.spin
        } else {
            -Real::copysign(self.torque_limit, twist.spin)
        };
        Wrench::new(along(twist.velocity.x), along(twist.velocity.y), torque)
    }
    fn gauge(&self, wrench: &Wrench<f64>) -> f64 {
        let [force, torque] = self.parts(wrench);
        if force.is_nan() || torque.is_nan() {
            return f64::NAN;
        }
        f64::max(force, torque)
    }
    fn twist_normal_to(&self, push: &Wrench<f64>) -> Twist<f64> {
        let [force, torque] = self.parts(push);
        if force.is_nan() || torque.is_nan() {
            return Twist::new(f64::NAN, f64::NAN, f64::NAN);
        }
        if force == 0.0 && torque == 0.0 {
            return Twist::ZERO;
        }
        self.normal(push, [force >= torque, torque >= force])
    }
    fn scale_to_surface(&self, wrench: &Wrench<f64>) -> Wrench<f64> {
        let gauge = self.gauge(wrench);
        if gauge == 0.0 {
            return *wrench;
        }
        Wrench::new(
            wrench.force.x / gauge,
            wrench.force.y / gauge,
            wrench.torque / gauge,
        )
    }
    /// Each part is scaled back by itself, whatever the `length`.
    fn project_with_length(&self, wrench: &Wrench<f64>, _length: f64) -> Projection<f64> {
        let [force, torque] = self.parts(wrench);
        if force.is_nan() || torque.is_nan() {
            let nan = f64::NAN;
            return Projection {
                wrench: Wrench::new(nan, nan, nan),
                region: Region::OnSurface {
                    normal: Twist::new(nan, nan, nan),
                },
            };
        }
        if force < 1.0 && torque < 1.0 {
            let (wrench, region) = (*wrench, Region::Inside);
            return Projection { wrench, region };
        }
        let mut nearest = *wrench;
        if force > 1.0 {
            let magnitude = wrench.force.x.hypot_of(wrench.force.y);
            nearest.force.x = self.force_limit * (wrench.force.x / magnitude);
            nearest.force.y = self.force_limit * (wrench.force.y / magnitude);
        }
        if torque > 1.0 {
            nearest.torque = Real::copysign(self.torque_limit, wrench.torque);
        }
        let normal = self.normal(&nearest, [force >= 1.0, torque >= 1.0]);
        let (wrench, region) = (nearest, Region::OnSurface { normal });
        Projection { wrench, region }
    }
}
