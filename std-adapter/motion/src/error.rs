//! Why a body in motion has no result.

use crate::slide::inverse::{OutOfReach, Pose};
use tribos_base::record::brief;
use tribos_base::scene::InvalidScene;
use tribos_core::law::LawError;
use tribos_core::patch::PatchError;
use tribos_friction::FrictionError;

/// Why a body that slides, or holds and slips, could not be followed to the end, or no launch leads to its end.
///
/// ```
/// use tribos::scene::{DiskScene, SpringScene};
/// use tribos::slide::MotionError;
/// let scene = SpringScene { stiffness: -1.0, ..SpringScene::default() };
/// assert!(matches!(scene.run(), Err(MotionError::Scene(_))));
/// // A disk that is at rest after 0.4 s.
/// let scene = DiskScene { time_step: Some(1e-12), ..DiskScene::default() };
/// assert!(matches!(scene.run(), Err(MotionError::TooManySteps { .. })));
/// ```
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum MotionError {
    /// A field of the scene is wrong.
    #[error(transparent)]
    Scene(#[from] InvalidScene),
    /// The time step is so short that the run would need too many steps.
    #[error(
        "a time_step of {} s needs {steps:.3e} steps, more than {most:.0e}; \
         use at least {at_least:.1e} s",
        brief(.time_step)
    )]
    TooManySteps {
        /// Requested time step.
        time_step: f64,
        /// Number of steps it would need.
        steps: f64,
        /// Largest number of steps allowed.
        most: f64,
        /// Shortest time step allowed.
        at_least: f64,
    },
    /// Whoever asked for the run ended it.
    #[error("interrupted after {steps} steps")]
    Interrupted {
        /// Number of steps taken.
        steps: u64,
    },
    /// A number left the range of f64, or the time no longer advances.
    #[error("the motion is no longer finite after step {step}; its scales are too far apart")]
    NotFinite {
        /// Number of the step.
        step: u64,
    },
    /// The kinetic energy of the launch, or one of its two shares, is not a positive f64.
    #[error(
        "the launch has a kinetic energy of {} J, outside the range of numbers; bring \
         `speed`, `spin`, `radius` and `mass` nearer to 1",
        brief(.energy)
    )]
    Energy {
        /// Kinetic energy at the launch, in J.
        energy: f64,
    },
    /// One motion keeps the steps so short that the other does not reach its end.
    #[error(
        "after {steps} steps the speeds have fallen by {folds:.3} e-folds only; sliding and \
         spinning change on scales that are too far apart"
    )]
    TooStiff {
        /// Number of steps taken.
        steps: u64,
        /// e-folds by which the common scale of both speeds has fallen.
        folds: f64,
    },
    /// A tall body would tip, and the scene forbids it.
    #[error(
        "the body tips: from {time:.6} s on its foot cannot bear the pressure gradient, which \
         reaches {lean:.4} times the limit; lower `height` or `gamma`, or set \
         on_tipping = \"clamp\""
    )]
    Tips {
        /// Time at which tipping begins, in s.
        time: f64,
        /// Largest |l| during the motion.
        lean: f64,
    },
    /// The law, or the tier chosen for it, was refused.
    #[error(transparent)]
    Choice(#[from] FrictionError),
    /// The method supports only powers of the speed.
    #[error(
        "integrator = \"verlet\" follows powers of the speed; the law {law} needs integrator = \"exact\""
    )]
    OnlyPowers {
        /// Name of the law.
        law: &'static str,
    },
    /// The kernel refused the contact patch.
    #[error(transparent)]
    Patch(#[from] PatchError),
    /// The kernel refused the law or the inertia.
    #[error(transparent)]
    Law(#[from] LawError),
    /// The kernel refused the body on its patch.
    #[error(transparent)]
    Body(#[from] tribos_core::Error),
    /// A number left the range of f64, or the time no longer advances.
    #[error("the motion cannot be followed beyond {} s; its scales are too far apart", brief(.time))]
    NotFiniteAt {
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
    InterruptedAt {
        /// Time reached, in s.
        time: f64,
    },
    /// The run needs more steps than it may take.
    #[error("{steps} steps reach {} s only; shorten the run or soften its scales", brief(.time))]
    TooManyStepsAt {
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
    /// The inverse problem has no solution for α ≥ 1.
    #[error("a body under |v|^{alpha} never comes to rest; the inverse problem needs alpha < 1")]
    NeverRests {
        /// The exponent.
        alpha: f64,
    },
    /// A launch limit is negative, infinite or NaN.
    #[error("the largest {name} must be finite and not negative, not {given}")]
    Limit {
        /// Name of the limit.
        name: &'static str,
        /// Value given.
        given: f64,
    },
    /// The target is not finite, or so far away that the launch exceeds the range of numbers.
    #[error(
        "the target x {} m, y {} m, angle {} rad is not finite or its launch is not",
        given.x, given.y, given.angle
    )]
    Target {
        /// Target given.
        given: Pose,
    },
    /// There are more solutions than can usefully be listed.
    #[error(
        "{count} numbers of turns lead there; lower the largest spin or ask for an exact angle"
    )]
    TooMany {
        /// Number of solutions.
        count: u64,
    },
    /// No launch within the limits reaches the target.
    #[error(transparent)]
    OutOfReach(Box<OutOfReach>),
}

impl MotionError {
    /// Whether whoever asked for the run ended it.
    #[doc(hidden)]
    pub fn is_interruption(&self) -> bool {
        matches!(self, Self::Interrupted { .. } | Self::InterruptedAt { .. })
    }
}
