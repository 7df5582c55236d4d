//! Derivatives of the time to rest.
//!
//! With q = 1 − α the time to rest is s^q Z(φ)/κ. It shrinks by s^q/κ per unit of τ; with the
//! names of [`super::slope`]
//!
//! ```text
//! m Z' = q k Z − 1                                                                      (1)
//! Z' = q k₀ ∫ W Z_s' dτ,     Z_s = 1/(q k),     dW/dτ = (m' − q k) W,     W(0) = 1      (2)
//! ```
//!
//! (2) contains no quotient by the turning rate m and is used until (1) is accurate.

use super::slope::{BRISK, FIRST, MAX_STEPS, SETTLED, SPENT, STEP, TOLERANCE};
use super::{Launch, PoseJacobian, RestMap, RestPose};
use tribos_core::Real;
use tribos_core::coupling::{PowerLawFriction, ReducedFriction};
use tribos_core::internals::runge_kutta;

/// c, n, W, ∫ W Z_s' dτ.
type State = [f64; 4];

impl<P: PowerLawFriction<f64> + ReducedFriction<f64>> RestMap<P> {
    /// The landing, its pose's derivatives, and those of the time by (v_x, v_y, ω).
    ///
    /// *Units*: 1/acceleration, and s² for the spin. *Special values*: all derivatives zero at rest, where
    /// the time has a kink.
    #[doc(hidden)]
    pub fn landing_derivatives(&self, launch: &Launch) -> (RestPose, PoseJacobian, [f64; 3]) {
        let landing = self.rest(launch);
        let pose = self.jacobian(launch);
        let [x, y] = launch.velocity;
        let (v, w) = (Real::hypot(x, y), launch.spin.abs() * self.radius());
        let s = Real::hypot(v, w);
        if s == 0.0 || !s.is_finite() {
            return (landing, pose, [0.0 * s; 3]);
        }
        let (c, n) = (v / s, w / s);
        let q = self.degree() - 1.0;
        let unit = Real::pow(s, q - 1.0) / self.deceleration();
        let time = landing.time / (unit * s);
        let slope = self.time_slope([c, n], time);
        let by_speed = unit * (q * time * c - slope * n);
        let by_rim = unit * (q * time * n + slope * c);
        // The time is even in velocity and spin.
        let [ex, ey] = if v == 0.0 { [0.0; 2] } else { [x / v, y / v] };
        let sense = if w == 0.0 { 0.0 } else { launch.spin.signum() };
        let by_spin = sense * self.radius() * by_rim;
        (landing, pose, [by_speed * ex, by_speed * ey, by_spin])
    }

    /// Z' at the direction (c, n), where Z = `time`.
    fn time_slope(&self, at: [f64; 2], time: f64) -> f64 {
        let [loss, turning] = self.loss_and_turning(at);
        let q = self.degree() - 1.0;
        if turning.abs() >= BRISK * loss {
            return (q * loss * time - 1.0) / turning;
        }
        self.time_followed(at)
            .filter(|slope| slope.is_finite())
            .unwrap_or_else(|| self.time_difference(at))
    }

    /// Z' by (2); `None` where the law has no slope.
    fn time_followed(&self, [c, n]: [f64; 2]) -> Option<f64> {
        let q = self.degree() - 1.0;
        let [start, _] = self.loss_and_turning([c, n]);
        let mut state: State = [c, n, 1.0, 0.0];
        let mut size = FIRST / start;
        for _ in 0..MAX_STEPS {
            let [c, n, weight, sum] = state;
            let [loss, turning] = self.loss_and_turning([c, n]);
            if turning.abs() >= BRISK * loss {
                let slope = (q * loss * self.reduced([c, n]).time - 1.0) / turning;
                return Some(q * start * sum + weight * start / loss * slope);
            }
            let rates = self.rates([c, n]);
            if turning.abs() <= SETTLED * loss || weight < SPENT {
                let left = weight / (q * loss - rates.turning_slope);
                return Some(q * start * (sum + left * rates.frozen_time(q)));
            }
            let derivative = |y: &State| self.time_derivative(y);
            let (next, error) = runge_kutta::step(&state, size, derivative);
            let admissible = next[0] >= 0.0 && next[1] >= 0.0;
            let (accepted, factor) =
                runge_kutta::judge(worst(&next, &error), TOLERANCE, admissible);
            if accepted {
                state = next;
            }
            size *= factor;
        }
        None
    }

    fn time_derivative(&self, state: &State) -> State {
        let [c, n, weight, _] = *state;
        let q = self.degree() - 1.0;
        let rates = self.rates([c, n]);
        [
            -rates.turning * n,
            rates.turning * c,
            (rates.turning_slope - q * rates.loss) * weight,
            weight * rates.frozen_time(q),
        ]
    }

    /// Z' by a symmetric difference.
    fn time_difference(&self, [c, n]: [f64; 2]) -> f64 {
        let [after, before] = [STEP, -STEP].map(|turn| {
            let (sin, cos) = (Real::sin(turn), Real::cos(turn));
            self.reduced([c * cos - n * sin, n * cos + c * sin]).time
        });
        (after - before) / (2.0 * STEP)
    }
}

/// The largest error; each component of the direction is compared with itself.
fn worst(at: &State, error: &State) -> f64 {
    let units = [at[0].abs(), at[1].abs(), 1.0, 1.0];
    let terms = error.iter().zip(units).map(|(error, unit)| match error {
        0.0 => 0.0,
        _ => error.abs() / unit,
    });
    terms.fold(0.0, |a: f64, b| if b > a || b.is_nan() { b } else { a })
}

#[cfg(test)]
mod tests {
    use super::*;
    use tribos_core::coupling::coulomb::CoulombDisk;
    use tribos_core::coupling::coulomb::CoulombHertz;

    /// Central differences of two widths, extrapolated.
    fn differences<P: PowerLawFriction<f64> + ReducedFriction<f64>>(
        map: &RestMap<P>,
        launch: &Launch,
    ) -> [f64; 3] {
        let time = |axis: usize, by: f64| {
            let mut at = *launch;
            match axis {
                2 => at.spin += by,
                _ => at.velocity[axis] += by,
            }
            map.rest(&at).time
        };
        [0, 1, 2].map(|axis| {
            let h = if axis == 2 { 1e-2 } else { 1e-3 };
            let slope = |h: f64| (time(axis, h) - time(axis, -h)) / (2.0 * h);
            (4.0 * slope(0.5 * h) - slope(h)) / 3.0
        })
    }

    #[test]
    fn derivatives_of_the_time_are_those_of_differences() {
        fn check<P: PowerLawFriction<f64> + ReducedFriction<f64>>(map: &RestMap<P>) {
            for launch in [
                ([1.0, 0.0], 3.0),
                ([0.8, -0.9], 12.0),
                ([0.3, 0.2], -40.0),
                // Next to the direction in which the body comes to rest.
                ([0.653 * 0.08 * 10.0, 0.0], 10.0),
                ([0.6, 0.0], 12.5),
            ] {
                let launch = Launch {
                    velocity: launch.0,
                    spin: launch.1,
                };
                let (_, _, by) = map.landing_derivatives(&launch);
                let expected = differences(map, &launch);
                for (a, b) in by.iter().zip(expected) {
                    assert!((a - b).abs() < 1e-8, "{launch:?} {by:?} {expected:?}");
                }
            }
        }
        check(&RestMap::new(CoulombDisk, 0.3 * 9.81, 0.08, 0.5).unwrap());
        check(&RestMap::new(CoulombHertz, 0.3 * 9.81, 0.08, 0.4).unwrap());
    }

    #[test]
    fn a_throw_without_spin_stops_as_a_point_does() {
        let map = RestMap::new(CoulombDisk, 2.0, 0.08, 0.5).unwrap();
        let launch = Launch {
            velocity: [0.0, 3.0],
            spin: 0.0,
        };
        let (landing, _, by) = map.landing_derivatives(&launch);
        assert!((landing.time - 1.5).abs() < 1e-14);
        assert!((by[1] - 0.5).abs() < 1e-13 && by[0] == 0.0 && by[2] == 0.0);
    }
}
