//! The inverse sliding problem: the launch with which a body comes to rest at a given pose.
//!
//! A flat axisymmetric body under |v|^α, α < 1, slides straight and rests after a finite distance
//! d and angle θ. With (v, |ω|R) = s (cos φ, sin φ) and p = 2 − α the equations of motion are
//! homogeneous:
//!
//! ```text
//! d = s^p X(φ)/κ,      R|θ| = s^p Y(φ)/κ
//! ```
//!
//! **One launch for each distance and angle.** The direction φ obeys an equation of its own,
//! dφ/dτ = m(φ), and so moves monotonically towards a fixed point. (X, Y) is a positive sum of all the
//! directions (cos φ, sin φ) still to come; its own direction A therefore lies ahead of φ. From
//! m X' = p k X − cos φ and m Y' = p k Y − sin φ,
//!
//! ```text
//! A' = sin(A − φ) / (m hypot(X, Y)) > 0
//! ```
//!
//! A rises from 0 to π/2, for every exponent α < 1, pressure and inertia ratio: the given
//! R|θ|/d determines φ, then the distance determines s. There are no double roots.
//!
//! **Monotonicity.** For α < 1, ∂F/∂w = ∂T/∂v < 0: each motion reduces the friction of the other. Such a
//! system preserves the order of its states, hence d and |θ| never decrease if v or |ω| grows. At a given
//! distance more turns need more spin and less speed; the reach of launch limits is the image of
//! their corners and edges.
//!
//! `docs/theory.md` has the proofs. *Source*: the problem was posed by Partridge and Spong and by
//! Han and Park; the reduction to one monotone function is this project's own.
//!
//! ```
//! use tribos::slide::inverse::{LaunchLimits, Pose, RestMap, Turns};
//! use tribos::kernel::coupling::coulomb::CoulombDisk;
//!
//! let disk = RestMap::new(CoulombDisk, 0.3 * 9.81, 0.08, 0.5)?; // mu g, R, C = I/(M R^2)
//! let target = Pose { x: 1.2, y: 0.3, angle: 1.57 };
//! let limits = LaunchLimits::new(3.0, 100.0)?; // m/s, rad/s
//! let launches = disk.launches(&target, Turns::Exact, &limits)?;
//! let end = disk.rest(&launches[0].launch);
//! assert!((end.pose.x - 1.2).abs() < 1e-12 && (end.pose.angle - 1.57).abs() < 1e-12);
//! # Ok::<(), tribos::slide::inverse::MotionError>(())
//! ```

mod error;
mod jacobian;
mod limits;
mod map;
mod plan;
mod root;
mod slope;
mod solve;
mod time;

pub use super::Launch;
pub use crate::error::MotionError;
pub use crate::push::Pose;
#[doc(hidden)]
pub use error::OutOfReach;
#[doc(hidden)]
pub use jacobian::PoseJacobian;
pub use limits::LaunchLimits;
pub use map::RestMap;
#[doc(hidden)]
pub use map::RestPose;
#[doc(hidden)]
pub use plan::MAX_SOLUTIONS;
pub use plan::{LaunchSolution, Launches, Turns};
