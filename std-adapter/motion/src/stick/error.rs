//! Why a scene of a held body has no result.

use tribos_base::record::brief;
use tribos_base::scene::InvalidScene;
use tribos_core::law::LawError;
use tribos_friction::FrictionError;

/// Why a body that holds and slips could not be followed to the end.
///
/// ```
/// use tribos::scene::SpringScene;
/// use tribos::stick::StickError;
/// let scene = SpringScene { stiffness: -1.0, ..SpringScene::default() };
/// assert!(matches!(scene.run(), Err(StickError::Scene(_))));
/// ```
#[derive(Debug, thiserror::Error)]
pub enum StickError {
    /// A field of the scene is wrong.
    #[error(transparent)]
    Scene(#[from] InvalidScene),
    /// The law or the patch was refused.
    #[error(transparent)]
    Choice(#[from] FrictionError),
    /// The kernel refused a parameter of the law.
    #[error(transparent)]
    Law(#[from] LawError),
    /// The kernel refused the body on its patch.
    #[error(transparent)]
    Body(#[from] tribos_core::Error),
    /// A number left the range of f64, or the time no longer advances.
    #[error("the motion cannot be followed beyond {} s; its scales are too far apart", brief(.time))]
    NotFinite {
        /// Time reached, in s.
        time: f64,
    },
    /// Under rate and state the body came to rest so closely that its speed is no number any more.
    #[error(
        "the speed falls below 1e-300 m/s at {} s: rate and state cannot be followed to rest; \
         raise `a`",
        brief(.time)
    )]
    TooSlow {
        /// Time reached, in s.
        time: f64,
    },
    /// The pads of a clamp hold the load, but their forces were not found.
    #[error(
        "the pads hold the load at {} s, but the search for their balance stopped with {} N left; \
         their stiffnesses are too far apart, or the pads turn too far",
        brief(.time),
        brief(.left)
    )]
    Unbalanced {
        /// Time of the load, in s.
        time: f64,
        /// Force that is left, in N.
        left: f64,
    },
    /// Whoever asked for the run ended it.
    #[error("interrupted at {} s", brief(.time))]
    Interrupted {
        /// Time reached, in s.
        time: f64,
    },
    /// The run needs more steps than it may take.
    #[error("{steps} steps reach {} s only; shorten the run or soften its scales", brief(.time))]
    TooManySteps {
        /// Number of steps taken.
        steps: u64,
        /// Time reached, in s.
        time: f64,
    },
    /// Under rate and state the spring came to push the body back.
    #[error(
        "the spring would push the body back at {} s, and rate and state is followed forward \
         only; raise `radiation_damping`, or lower `mass`",
        brief(.time)
    )]
    Backwards {
        /// Time at which the spring force reached zero, in s.
        time: f64,
    },
}
