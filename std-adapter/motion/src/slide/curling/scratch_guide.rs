//! Guidance by scratches in the ice.

use super::side_force::{Mechanism, RockWithSideForce};
use super::{CurlingModel, CurlingRock, IceLaw};
use crate::slide::MotionError;
use crate::slide::planar::Resistance;
use tribos_core::Real;

/// The front of the band scratches the ice; the back crosses these scratches at an angle and is
/// guided by them.
///
/// *Formula* (our own reduction): friction [`IceLaw`] on the upright rock, and a force
///
/// ```text
/// σ N · w/√(w² + (δv)²) · v/√(v² + w²),    w = |ω|R
/// ```
///
/// to the left for counterclockwise spin. Front and back cross at the angle 2w/v: below δ they run
/// in the same grooves and there is no guidance, above δ the force no longer depends on the angle. The
/// last factor makes the force vanish with the sliding speed, as symmetry requires.
///
/// *Source of the idea*: Nyberg, Alfredson, Hogmark & Jacobson, Wear 301 (2013) 583, and Penner's
/// scratch-guide model (2019); their equations were not available and are not reproduced here.
/// *Confidence*: the mechanism is well supported (scratched ice steers even a rock without spin);
/// this form is our interpretation, with σ fitted only to a curl of about 1 m and a small
/// value chosen for δ.
///
/// ```
/// use tribos::slide::curling::{CurlingModel, CurlingRock, IceLaw, ScratchGuide};
/// let (strength, onset) = (ScratchGuide::STRENGTH, ScratchGuide::ONSET);
/// let rock = CurlingRock::STANDARD;
/// let body = ScratchGuide { ice: IceLaw::PENNER, strength, onset }.resistance(&rock)?;
/// let left = |rim: f64| -body.deceleration([2.0, 0.0, rim])[1] / (strength * rock.gravity);
/// assert_eq!(left(0.0), 0.0);
/// // Far above the onset (2 m/s times 0.01) the force hardly knows the spin.
/// assert!([0.1, 0.2, 0.3].iter().all(|&rim| (0.97..1.0).contains(&left(rim))));
/// assert!((left(0.02) - 0.5_f64.sqrt()).abs() < 1e-3); // at the onset
/// # Ok::<(), tribos::slide::MotionError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ScratchGuide {
    /// Law of the ice.
    pub ice: IceLaw,
    /// σ, the guiding force per load.
    pub strength: f64,
    /// δ, half the crossing angle above which scratches guide, in rad.
    pub onset: f64,
}

impl ScratchGuide {
    /// Value of σ with which a draw at 1.5 rad/s curls by about 1 m.
    pub const STRENGTH: f64 = 0.0006;
    /// Value of δ: about half a degree.
    pub const ONSET: f64 = 0.01;
}

impl CurlingModel for ScratchGuide {
    fn name(&self) -> &'static str {
        "scratch-guide"
    }

    fn resistance(&self, rock: &CurlingRock) -> Result<Box<dyn Resistance>, MotionError> {
        Ok(Box::new(RockWithSideForce {
            body: rock.body(self.ice, 0.0)?,
            mechanism: Scratches {
                pull: self.strength * rock.gravity,
                onset: self.onset,
            },
        }))
    }
}

#[derive(Debug)]
struct Scratches {
    pull: f64,
    onset: f64,
}

impl Mechanism for Scratches {
    fn added(&self, slide: f64, rim: f64) -> [f64; 2] {
        let crossing = rim / Real::hypot(rim, self.onset * slide);
        let sliding = slide / Real::hypot(slide, rim);
        [self.pull * crossing * sliding, 0.0]
    }
}
