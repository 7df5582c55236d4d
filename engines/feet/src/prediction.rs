//! Friction around the step of an engine that does not know it.
//!
//! Before the engine's step the friction of the expected pushes is predicted and passed on as a force. After
//! it the same step is repeated with the pushes that the engine has found: its end is the motion, at rest
//! zero to the last bit.

use crate::ended::Ended;
use crate::standing::Standing;
use tribos_core::contact::TimeStep;
use tribos_core::twist::{Twist, Wrench};

/// What an engine is given for its step.
///
/// ```
/// use tribos_core::contact::TimeStep;
/// use tribos_core::planar::PlanarBody;
/// use tribos_core::twist::{Twist, Wrench};
/// use tribos_feet::{Foot, Footprint, Standing};
/// let (puck, disk) = (PlanarBody::new(0.17, 1.36e-4)?, Footprint::disk(0.04)?);
/// let feet = [Foot::new(&disk, 0.5, [0.0; 2])]; // mu N is 0.5 N
/// let standing = Standing::new(&puck, None, &feet);
/// let (thrown, dt) = (Twist::new(1.0, 0.0, 0.0), TimeStep::new(1.0 / 60.0)?);
/// let step = standing.predict(&thrown, &Wrench::ZERO, None, dt, 4).ok_or("not finite")?;
/// assert!((step.friction.force.x + 0.5).abs() < 1e-6);
/// // The engine has moved the body under this force, and a wall has stopped it.
/// let end = standing.correct(Some(&step), &Twist::ZERO, dt).ok_or("not finite")?;
/// assert_eq!(end.change, Twist::ZERO);
/// assert!(end.ended.is_at_rest());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Prediction {
    /// The motion before the step.
    before: Twist<f32>,
    /// Pushes that were expected.
    push: Wrench<f32>,
    /// Friction at the centre of mass, as its mean over the step.
    pub friction: Wrench<f32>,
    /// To be added to the velocity during the step, and subtracted after it: the displacement is then that of
    /// the mean velocity.
    pub offset: Twist<f32>,
    /// The part of the step that it takes to stop, if it ends at rest.
    pub stops: Option<f32>,
}

/// How the engine's step is corrected.
#[derive(Debug)]
pub struct Correction {
    /// Motion and friction.
    pub ended: Ended,
    /// To be added to the motion after the engine's step.
    pub change: Twist<f32>,
    /// The push beyond the expected one, if friction held against it: expected in the next step.
    pub held: Option<Wrench<f32>>,
}

impl Standing<'_> {
    /// The friction of a step from `before` under the expected `push` and the push that was `held` in the last
    /// step. `substeps` are those of the engine. `None` for a motion that is not finite.
    pub fn predict(
        &self,
        before: &Twist<f32>,
        push: &Wrench<f32>,
        held: Option<Wrench<f32>>,
        dt: TimeStep<f32>,
        substeps: usize,
    ) -> Option<Prediction> {
        let pushed = held.map_or(*push, |held| *push + held);
        let end = self.step(before, &pushed, dt)?;
        let stops = end.is_at_rest().then(|| match *before == Twist::ZERO {
            true => 0.0,
            false => self.share(&end, before),
        });
        Some(Prediction {
            before: *before,
            push: *push,
            friction: end.friction,
            offset: offset(before, &end.twist, stops.unwrap_or(1.0), substeps),
            stops,
        })
    }

    /// The correction of a step that has ended with the motion `after`; without prediction of one without
    /// friction, under no pushes.
    pub fn correct(
        &self,
        prediction: Option<&Prediction>,
        after: &Twist<f32>,
        dt: TimeStep<f32>,
    ) -> Option<Correction> {
        // All pushes except friction, as their mean over the step, and the expected part of them.
        let (before, others, push) = match prediction {
            Some(step) => {
                let all = self.push(&(*after - step.before), dt.dt());
                (step.before, all - step.friction, step.push)
            }
            None => (*after, Wrench::ZERO, Wrench::ZERO),
        };
        let ended = self.step(&before, &others, dt)?;
        Some(Correction {
            change: ended.twist - *after,
            held: ended.is_at_rest().then_some(others - push),
            ended,
        })
    }

    /// The fraction of a corrected step until rest.
    pub fn share_until_rest(
        &self,
        prediction: Option<&Prediction>,
        correction: &Correction,
    ) -> f32 {
        let before = prediction.map_or(correction.ended.twist - correction.change, |step| {
            step.before
        });
        self.share(&correction.ended, &before)
    }
}

/// The velocity offset during the step that makes the engine's displacement that of the mean
/// velocity.
///
/// The engine moves a body by its velocity at the end of each of its n substeps, so that a body under
/// constant deceleration lags by half a substep's change. Friction that ends the motion needs the
/// given `share` of the step for it, and the remaining displacement is cut.
fn offset(before: &Twist<f32>, after: &Twist<f32>, share: f32, substeps: usize) -> Twist<f32> {
    let [late, cut] = [0.5 / substeps as f32, 0.5 * (1.0 - share)];
    (*after - *before) * -late - *before * cut
}
