//! Quasi-static pushing: a body that slides on a surface, moved by a pusher that touches it.
//!
//! The body's friction with the floor is any limit surface (a [`FrictionSet`]), exact instead of the
//! usual ellipsoid; the pusher touches it at a [`PointContact`] or along a [`LineContact`], with friction of
//! its own. Nothing has inertia: friction on the floor balances the pusher's force at every moment.
//! Motions depend on the direction of the pusher's velocity alone, and scale with its speed.
//!
//! The forces that a contact can give are a cone, and the motions under them a *motion cone* (Mason, Int. J.
//! Robotics Research 5 (1986) 53; Chavan-Dafle, Holladay, Rodriguez, Robotics: Science and Systems
//! 2018). Pushes whose velocity lies in it stick, others slide along the body. By Goyal, Ruina and Papadopoulos (Wear
//! 143 (1991) 307) the motion is the outward normal above the push. The forces at one point are a plane
//! section of the limit surface, which is convex too, and the contact's velocity is the normal of the section:
//! it turns monotonically with the force, so that there is one push for each velocity.
//!
//! Places, velocities and forces are in the frame of the body, about the origin of its patch.
//!
//! ```
//! use tribos::friction::Area;
//! use tribos::push::{ContactMode, PointContact};
//! let table = Area::named(&"box:0.2x0.1".parse()?, 1.0, None)?.limit_surface(2.0)?; // μN in N
//! // A finger at the lower long side, 4 cm to the right of the middle, pushes upwards.
//! let finger = PointContact::new([0.04, -0.05], [0.0, 1.0], 0.3)?;
//! let moved = finger.push(&*table, [0.0, 0.01])?; // m/s
//! assert_eq!(moved.mode, ContactMode::SlidingLeft); // the body turns away to the right
//! assert!(moved.twist.spin > 0.0 && (moved.contact_velocity.y - 0.01).abs() < 1e-15);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod cone;
mod contact;
mod error;
mod line;
mod outline;
mod path;
mod run;
pub(crate) mod scene;
mod solve;

pub use cone::MotionCone;
pub use contact::PointContact;
pub use error::PushError;
pub use line::{LineContact, StablePush};
#[doc(hidden)]
pub use outline::straight_side;
pub use path::{PathEnd, PathSample, Pose, PushPath, PushedSide, Pusher};
#[doc(hidden)]
pub use run::PUSH_BOX;
pub use run::PushResult;
pub use solve::{ContactMode, QuasiStaticPush};

#[cfg(doc)]
use tribos_core::limit_surface::FrictionSet;
