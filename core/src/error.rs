//! One error for the whole kernel.

use crate::contact::ContactError;
use crate::law::LawError;
use crate::manifold::ContactSystemError;
use crate::patch::PatchError;
use crate::patch::mesh::MeshError;
use crate::patch::outline::OutlineError;

/// One variant for each typed error, with its conversion and its message.
macro_rules! errors {
    ($($(#[$doc:meta])* $variant:ident($error:ty),)*) => {
        /// Any error of the kernel: one kind for each room, which converts into it with `?`.
        ///
        /// Constructors that check a law and a patch, or their limits, answer with it.
        ///
        /// ```
        /// use tribos_core::prelude::*;
        /// fn stopping_time(mu: f32, radius: f32) -> Result<Option<f32>, Error> {
        ///     let coupling = RoundFriction::new(CoulombDisk, mu, radius)?;
        ///     let parameters = SliderParameters { deceleration: mu * 9.81, radius, inertia_ratio: 0.5 };
        ///     let puck = Slider::new(*coupling.coupling(), parameters)?;
        ///     Ok(puck.to_rest(&SliderState::launched(1.0, 5.0)).map(|rest| rest.motion.time))
        /// }
        /// assert!(stopping_time(0.3, 0.04).is_ok());
        /// assert!(matches!(stopping_time(-0.3, 0.04), Err(Error::Law(_))));
        /// assert!(matches!(stopping_time(0.3, 0.0), Err(Error::Patch(_))));
        /// ```
        #[derive(Clone, Copy, Debug, PartialEq)]
        #[cfg_attr(feature = "defmt", derive(defmt::Format))]
        pub enum Error {
            $($(#[$doc])* $variant($error),)*
        }

        $(
            impl From<$error> for Error {
                fn from(error: $error) -> Self {
                    Self::$variant(error)
                }
            }
        )*

        impl core::fmt::Display for Error {
            fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
                match self {
                    $(Self::$variant(error) => error.fmt(f),)*
                }
            }
        }
    };
}

errors! {
    /// A parameter of a friction law, or of what it acts on.
    Law(LawError),
    /// A contact patch: its dimensions, its pressure, its points, or the corners that support it.
    Patch(PatchError),
    /// The corners of a polygon, or its pressure.
    Outline(OutlineError),
    /// The triangles of a mesh, or their pressure.
    Mesh(MeshError),
    /// The geometry of a contact.
    Touch(ContactError),
    /// A body or contact of a manifold.
    Manifold(ContactSystemError),
}

impl core::error::Error for Error {}
