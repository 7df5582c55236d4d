//! Map from launch to rest pose.

use super::{Launch, MotionError, Pose};
use tribos_core::Real;
use tribos_core::coupling::{PowerLawFriction, ReducedFriction};
use tribos_core::slider::{Slider, SliderParameters, SliderState};

/// Rest pose of a body as a function of its launch.
///
/// ```
/// use tribos::slide::inverse::{Launch, RestMap};
/// use tribos::kernel::coupling::coulomb::CoulombDisk;
/// let disk = RestMap::new(CoulombDisk, 0.3 * 9.81, 0.08, 0.5)?; // mu g, R, C = I/(M R^2)
/// let end = disk.rest(&Launch { velocity: [0.0, 1.0], spin: 0.0 });
/// assert_eq!(end.pose.x, 0.0);
/// assert!((end.pose.y - 1.0 / (2.0 * 0.3 * 9.81)).abs() < 1e-14);
/// # Ok::<(), tribos::slide::inverse::MotionError>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct RestMap<P> {
    /// The body scaled to κ = R = 1.
    unit: Slider<f64, P>,
    deceleration: f64,
    radius: f64,
    inertia_ratio: f64,
}

/// Rest pose and time of a launch.
///
/// ```
/// use tribos::slide::inverse::{RestPose, Launch, RestMap};
/// use tribos::kernel::coupling::PowerLawFriction;
/// use tribos::kernel::coupling::coulomb::CoulombDisk;
/// let disk = RestMap::new(CoulombDisk, 0.3 * 9.81, 0.08, 0.5)?; // mu g, R, C = I/(M R^2)
/// assert_eq!((disk.deceleration(), disk.radius(), disk.inertia_ratio()), (0.3 * 9.81, 0.08, 0.5));
/// let alpha: f64 = disk.profile().exponent();
/// assert_eq!(alpha, 0.0); // CoulombDisk's
/// let launch = Launch { velocity: [0.6, 0.8], spin: 0.0 }; // 1 m/s
/// let RestPose { pose, time } = disk.rest(&launch);
/// assert!((time - 1.0 / (0.3 * 9.81)).abs() < 1e-14); // v/(mu g)
/// let work = 0.3 * 9.81 * pose.x.hypot(pose.y); // of friction, per mass
/// assert!((work - disk.energy_per_mass(&launch)).abs() < 1e-14);
/// # Ok::<(), tribos::slide::inverse::MotionError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RestPose {
    /// Position and orientation at rest.
    pub pose: Pose,
    /// Time from launch to rest, in s.
    pub time: f64,
}

/// Paths and time to rest from unit scale, s² = v² + (ωR)² = 1, with κ = R = 1.
#[derive(Clone, Copy, Debug)]
pub(super) struct Reduced {
    /// X, the path of the centre.
    pub centre: f64,
    /// Y, the path of the rim.
    pub rim: f64,
    /// Time to rest.
    pub time: f64,
}

impl<P: PowerLawFriction<f64> + ReducedFriction<f64>> RestMap<P> {
    /// *Domain*: α < 1; `deceleration` κ = γ g (μ g for Coulomb), `radius` of the contact and
    /// `inertia_ratio` C = I/(M R²) positive and finite.
    pub fn new(
        profile: P,
        deceleration: f64,
        radius: f64,
        inertia_ratio: f64,
    ) -> Result<Self, MotionError> {
        Slider::new(
            &profile,
            SliderParameters {
                deceleration,
                radius,
                inertia_ratio,
            },
        )?;
        let alpha = profile.exponent();
        if alpha >= 1.0 {
            return Err(MotionError::NeverRests { alpha });
        }
        Ok(Self {
            unit: Slider::new(
                profile,
                SliderParameters {
                    deceleration: 1.0,
                    radius: 1.0,
                    inertia_ratio,
                },
            )?,
            deceleration,
            radius,
            inertia_ratio,
        })
    }

    /// The rest pose, starting at the origin with angle 0. Without sliding x = y = 0.
    ///
    /// *Accuracy*: 1e-13 relative in each of distance and angle. *Special values*: NaN for a launch that
    /// is not finite.
    pub fn rest(&self, launch: &Launch) -> RestPose {
        let [x, y] = launch.velocity;
        let speed = Real::hypot(x, y);
        let motion = SliderState::launched(speed, launch.spin * self.radius);
        let Some(rest) = self.unit.to_rest(&motion) else {
            return RestPose {
                pose: Pose {
                    x: f64::NAN,
                    y: f64::NAN,
                    angle: f64::NAN,
                },
                time: f64::NAN,
            };
        };
        let distance = rest.motion.distance / self.deceleration;
        let along = |component: f64| match speed {
            0.0 => 0.0,
            _ => distance * (component / speed),
        };
        RestPose {
            pose: Pose {
                x: along(x),
                y: along(y),
                angle: rest.motion.angle / (self.deceleration * self.radius),
            },
            time: rest.motion.time / self.deceleration,
        }
    }

    /// Kinetic energy per mass, (v² + C (ωR)²)/2, in J/kg.
    pub fn energy_per_mass(&self, launch: &Launch) -> f64 {
        let [x, y] = launch.velocity;
        let rim = launch.spin * self.radius;
        0.5 * (x * x + y * y + self.inertia_ratio * rim * rim)
    }

    /// X, Y and time in the direction (c, n) = (v, ωR)/s.
    pub(super) fn reduced(&self, [c, n]: [f64; 2]) -> Reduced {
        let rest = self.unit.to_rest(&SliderState::launched(c, n));
        let motion = rest.map_or(SliderState::launched(f64::NAN, f64::NAN), |rest| {
            rest.motion
        });
        Reduced {
            centre: motion.distance,
            rim: motion.angle,
            time: motion.time,
        }
    }

    /// p = 2 − α, the degree of both paths in the speeds.
    pub(super) fn degree(&self) -> f64 {
        2.0 - self.profile().exponent()
    }

    /// Coupling of friction law and pressure.
    pub fn profile(&self) -> &P {
        self.unit.profile()
    }

    /// κ = γ g.
    pub fn deceleration(&self) -> f64 {
        self.deceleration
    }

    /// Radius of the contact.
    pub fn radius(&self) -> f64 {
        self.radius
    }

    /// C = I/(M R²).
    pub fn inertia_ratio(&self) -> f64 {
        self.inertia_ratio
    }
}
