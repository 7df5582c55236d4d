//! The fixed-step method of the thesis.

use super::{Slider, SliderState};
use crate::coupling::{PowerLawFriction, ReducedFriction, ReducedWrench};
use crate::real::Real;

impl<R: Real, P: PowerLawFriction<R> + ReducedFriction<R>> Slider<R, P> {
    /// One velocity-Verlet step of size `duration` (thesis 3.4.5).
    ///
    /// The force depends on velocity, hence the second half kick uses the predicted velocity.
    /// Friction cannot reverse a motion: a speed that would change sign becomes zero, which is
    /// where the method's error of order `duration` at rest comes from.
    ///
    /// *Domain*: `duration` > 0. *Accuracy*: second order while both speeds exceed
    /// `duration` × deceleration, first order at the stop.
    ///
    /// ```
    /// use tribos_core::coupling::coulomb::CoulombDisk;
    /// use tribos_core::slider::{SliderState, Slider};
    /// # use tribos_core::slider::SliderParameters;
    /// # let parameters = SliderParameters { deceleration: 3.0_f64, radius: 0.08, inertia_ratio: 0.5 };
    /// let puck = Slider::new(CoulombDisk, parameters)?; // μ g = 3 m/s², R = 0.08 m, C = 1/2
    /// let start = SliderState::launched(1.0, 5.0);
    /// let exact = puck.advance(&start, 0.1).motion;
    /// let error = |steps: u32| {
    ///     let mut motion = start;
    ///     for _ in 0..steps {
    ///         motion = puck.verlet_step(&motion, 0.1 / f64::from(steps));
    ///     }
    ///     (motion.speed - exact.speed).abs()
    /// };
    /// // Half the step, a quarter of the error.
    /// assert!((error(50) / error(100) - 4.0).abs() < 0.2);
    /// # Ok::<(), tribos_core::Error>(())
    /// ```
    pub fn verlet_step(&self, motion: &SliderState<R>, duration: R) -> SliderState<R> {
        let rim = (motion.spin * self.radius).abs();
        let half = R::HALF * duration;
        let [a0, b0] = self.accelerations(motion.speed, rim);
        let predicted = [
            not_reversed(motion.speed + duration * a0),
            not_reversed(rim + duration * b0),
        ];
        let [a1, b1] = self.accelerations(predicted[0], predicted[1]);
        let rim_after = not_reversed(rim + half * (b0 + b1));
        let turned = not_reversed(rim + half * b0) * duration / self.radius;
        SliderState {
            time: motion.time + duration,
            speed: not_reversed(motion.speed + half * (a0 + a1)),
            spin: (rim_after / self.radius).copysign(motion.spin),
            distance: motion.distance + not_reversed(motion.speed + half * a0) * duration,
            angle: motion.angle + turned.copysign(motion.spin),
        }
    }

    /// dv/dt and dw/dt.
    fn accelerations(&self, slide: R, rim: R) -> [R; 2] {
        let ReducedWrench { force, torque } = self.profile.reduced_wrench(slide, rim);
        [
            -(self.deceleration * force),
            -(self.deceleration * torque / self.inertia_ratio),
        ]
    }
}

/// Zero instead of a negative speed; NaN stays NaN.
fn not_reversed<R: Real>(speed: R) -> R {
    if speed < R::ZERO { R::ZERO } else { speed }
}
