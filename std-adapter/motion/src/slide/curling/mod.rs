//! Models of the curling rock on ice.
//!
//! Why a rock curls is not settled. Each model here is one published or plausible explanation, with its
//! formula, its source and our confidence in it; none is *the* model. `docs/curling.md` compares them
//! with observations.
//!
//! | type | friction at work | path for counterclockwise spin |
//! |---|---|---|
//! | [`Dry`] | Coulomb, pressure in front | right: the wrong way |
//! | [`LeftRight`] | γ v^α | straight |
//! | [`FrontBack`] | γ v^α, pressure in front | right: the wrong way |
//! | [`BackHeavy`] | γ v^α, more at the back | left, in proportion to the spin |
//! | [`Film`] | γ u^α, u against a dragged film | left, in proportion to the spin |
//! | [`PivotSlide`] | γ v^α and a sideways pull | left, *less* with more spin |
//! | [`ScratchGuide`] | γ v^α and guiding scratches | left, almost whatever the spin |

mod back_heavy;
mod dry;
mod film;
mod front_back;
mod left_right;
mod pivot_slide;
mod ring_rule;
mod rock;
mod scratch_guide;
mod side_force;

pub use back_heavy::BackHeavy;
pub use dry::Dry;
pub use film::Film;
#[doc(hidden)]
pub use film::FilmRing;
pub use front_back::FrontBack;
pub use left_right::LeftRight;
pub use pivot_slide::PivotSlide;
pub(crate) use ring_rule::POINTS as RING_POINTS;
#[doc(hidden)]
pub use rock::{CurlingRock, IceLaw};
pub use scratch_guide::ScratchGuide;

use super::MotionError;
use super::planar::Resistance;
use std::fmt::Debug;

/// An explanation of why a rock curls.
///
/// ```
/// use tribos::slide::curling::{CurlingModel, CurlingRock, Dry, IceLaw, LeftRight};
/// use tribos::slide::planar::{PlanarSimulation, Launch};
/// let models: [Box<dyn CurlingModel>; 2] =
///     [Box::new(Dry { coefficient: 0.0071 }), Box::new(LeftRight { ice: IceLaw::PENNER })];
/// assert_eq!([models[0].name(), models[1].name()], ["dry", "left-right"]);
/// let curl = |model: &Box<dyn CurlingModel>| {
///     let body = model.resistance(&CurlingRock::STANDARD)?;
///     let launch = Launch { velocity: [2.0, 0.0], spin: 1.5 };
///     let end = PlanarSimulation::new(&body, &launch, 1e-4)?.to_end()?;
///     Ok::<_, tribos::slide::MotionError>(end.point.position[1])
/// };
/// assert!(curl(&models[0])? < 0.0); // to the right
/// assert_eq!(curl(&models[1])?, 0.0);
/// # Ok::<(), tribos::slide::MotionError>(())
/// ```
#[doc(hidden)]
pub trait CurlingModel: Debug + Send + Sync {
    /// Name of the model in scenes.
    fn name(&self) -> &'static str;

    /// Resistance that the rock meets on the ice.
    fn resistance(&self, rock: &CurlingRock) -> Result<Box<dyn Resistance>, MotionError>;
}
