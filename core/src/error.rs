//! One error for the whole kernel.

use crate::contact::{TimeStepError, TouchError};
use crate::coupling::FrictionError;
use crate::coupling::tall::Tips;
use crate::law::LawError;
use crate::limit_surface::SurfaceError;
use crate::manifold::ManifoldError;
use crate::modes::InertiaError;
use crate::patch::PatchError;
use crate::patch::nodes::NodeError;
use crate::patch::polar::PolarError;
use crate::patch::polygon::PolygonError;
use crate::patch::tripod::TripodError;
use crate::planar::{FootError, PlanarBodyError};
use crate::slider::SliderError;

/// One variant for each typed error, with its conversion and its message.
macro_rules! errors {
    ($($(#[$doc:meta])* $variant:ident($error:ty),)*) => {
        /// Any error of the kernel. The typed error of every constructor converts into it with `?`.
        ///
        /// ```
        /// use tribos_core::prelude::*;
        /// fn stopping_time(mu: f32, radius: f32) -> Result<Option<f32>, Error> {
        ///     let coupling = PatchFriction::new(Coulomb, mu, radius)?; // FrictionError
        ///     let parameters = SliderParameters { deceleration: mu * 9.81, radius, inertia_ratio: 0.5 };
        ///     let puck = Slider::new(*coupling.coupling(), parameters)?; // SliderError
        ///     Ok(puck.to_rest(&Motion::launched(1.0, 5.0)).map(|rest| rest.motion.time))
        /// }
        /// assert!(stopping_time(0.3, 0.04).is_ok());
        /// assert!(matches!(stopping_time(-0.3, 0.04), Err(Error::Law(_))));
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
    /// A parameter of a friction law.
    Law(LawError),
    /// The pressure, the radius or the height of a contact patch.
    Patch(PatchError),
    /// A list of contact points.
    Nodes(NodeError),
    /// A quadrature rule on a disk.
    Polar(PolarError),
    /// A polygonal patch.
    Polygon(PolygonError),
    /// A body on three feet.
    Tripod(TripodError),
    /// A tall body that tips over.
    Tips(Tips),
    /// A limit surface.
    Surface(SurfaceError),
    /// An inertia ratio.
    Inertia(InertiaError),
    /// A sliding body.
    Slider(SliderError),
    /// The geometry of a contact.
    Touch(TouchError),
    /// A time step.
    TimeStep(TimeStepError),
    /// A body or contact of a manifold.
    Manifold(ManifoldError),
    /// The contact points of a planar body.
    Foot(FootError),
    /// The mass or the moment of inertia of a planar body.
    PlanarBody(PlanarBodyError),
}

impl core::error::Error for Error {}

impl From<FrictionError> for Error {
    fn from(error: FrictionError) -> Self {
        match error {
            FrictionError::Law(error) => Self::Law(error),
            FrictionError::Patch(error) => Self::Patch(error),
        }
    }
}
