//! A round body from launch to rest: fixed steps of fading speeds, and polynomials between them.
//!
//! dv/dt = −F(v, w), dw/dt = −T(v, w)/C with the rim speed w = ωR. Each step takes the same share of the time in which the
//! faster of the two would fade, so that the steps are those of a similar motion and what they leave out
//! changes smoothly with the parameters: differences of motions are as exact as the motions.

use tribos_core::internals::runge_kutta;

/// The body at one frame, in the coordinates of its launch.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct FilmedPlace {
    /// Way along the launch, or along the axes of a body with edges, in m.
    pub way: [f64; 2],
    /// Angle turned; of a round body times its radius, in m.
    pub turned: f64,
    /// Speed of the centre, in m/s.
    pub speed: f64,
}

/// Share of the fading time that a step takes: places are good to 1e-7 of the way.
const SHARE: f64 = 0.125;
/// Speeds below this fraction of the initial ones are followed by uniform deceleration, within 1e-9 of the way.
const LAST: f64 = 1e-4;
/// More steps than any body under a law that reaches rest needs.
const MOST_STEPS: usize = 4000;

/// A moment of the motion: v, w and their paths.
type State = [f64; 4];

/// Rates of fading of both speeds, in m/s².
type Rates<'a> = &'a dyn Fn([f64; 2]) -> [f64; 2];

/// Places at times that do not fall, of a body launched with these speeds along its path and rim, both ≥ 0.
pub(super) fn march(speeds: [f64; 2], times: &[f64], rates: Rates<'_>) -> Option<Vec<FilmedPlace>> {
    let mut places = Vec::with_capacity(times.len());
    let mut from = Moment::new(0.0, [speeds[0], speeds[1], 0.0, 0.0], rates);
    let mut wanted = times.iter().copied().peekable();
    let smallest = LAST * speeds[0].max(speeds[1]);
    for _ in 0..MOST_STEPS {
        if wanted.peek().is_none() {
            return Some(places);
        }
        if from.state[0].max(from.state[1]) <= smallest {
            places.extend(wanted.map(|time| from.stopping(time)));
            return Some(places);
        }
        let step = SHARE / from.fading();
        let next = runge_kutta::step(&from.state, step, |state| derivative(state, rates)).0;
        let is_valid = next.iter().all(|x| x.is_finite()) && step > 0.0;
        if !is_valid {
            return None;
        }
        let to = Moment::new(from.time + step, next, rates);
        while let Some(time) = wanted.next_if(|time| *time < to.time) {
            places.push(from.between(&to, time));
        }
        from = to;
    }
    None
}

fn derivative(state: &State, rates: Rates<'_>) -> State {
    let speeds = [state[0].max(0.0), state[1].max(0.0)];
    let [slide, rim] = rates(speeds);
    [-slide, -rim, state[0], state[1]]
}

/// A node of the motion.
#[derive(Clone, Copy, Debug)]
struct Moment {
    time: f64,
    state: State,
    /// Decelerations of v and w.
    rates: [f64; 2],
}

impl Moment {
    fn new(time: f64, state: State, rates: Rates<'_>) -> Self {
        let [slide, rim, ..] = derivative(&state, rates);
        Self {
            time,
            state,
            rates: [-slide, -rim],
        }
    }

    /// Larger of the rates at which the logarithms of the speeds fall.
    fn fading(&self) -> f64 {
        let rate = |i: usize| {
            if self.state[i] > 0.0 {
                self.rates[i] / self.state[i]
            } else {
                0.0
            }
        };
        rate(0).max(rate(1))
    }

    /// A place between two nodes: polynomials of degree 5 through path, speed and deceleration at both.
    fn between(&self, to: &Self, time: f64) -> FilmedPlace {
        let step = to.time - self.time;
        let u = (time - self.time) / step;
        let path = |i: usize| {
            let from = [
                self.state[2 + i],
                step * self.state[i],
                -step * step * self.rates[i],
            ];
            let to = [
                to.state[2 + i],
                step * to.state[i],
                -step * step * to.rates[i],
            ];
            quintic(from, to, u)
        };
        let ([way, speed], [turned, _]) = (path(0), path(1));
        FilmedPlace {
            way: [way, 0.0],
            turned,
            speed: speed / step,
        }
    }

    /// A place of the last, uniform decelerations.
    fn stopping(&self, time: f64) -> FilmedPlace {
        let late = time - self.time;
        let path = |i: usize| {
            let (speed, rate) = (self.state[i].max(0.0), self.rates[i]);
            let lasts = if rate > 0.0 { speed / rate } else { 0.0 };
            let passed = late.min(lasts);
            let left = if late < lasts {
                speed - rate * passed
            } else {
                0.0
            };
            [
                self.state[2 + i] + passed * (speed - 0.5 * rate * passed),
                left,
            ]
        };
        let ([way, speed], [turned, _]) = (path(0), path(1));
        FilmedPlace {
            way: [way, 0.0],
            turned,
            speed,
        }
    }
}

/// Value and derivative at u of the quintic with these values, first and second derivatives at 0 and 1.
fn quintic(from: [f64; 3], to: [f64; 3], u: f64) -> [f64; 2] {
    let [a, b, c] = [from[0], from[1], 0.5 * from[2]];
    // What is left at u = 1 of value, slope and curvature for u³ (d + e u + f u²).
    let value = to[0] - a - b - c;
    let slope = to[1] - b - 2.0 * c;
    let curvature = to[2] - 2.0 * c;
    let d = 10.0 * value - 4.0 * slope + 0.5 * curvature;
    let e = -15.0 * value + 7.0 * slope - curvature;
    let f = 6.0 * value - 3.0 * slope + 0.5 * curvature;
    let at = a + u * (b + u * (c + u * (d + u * (e + u * f))));
    let rate = b + u * (2.0 * c + u * (3.0 * d + u * (4.0 * e + u * 5.0 * f)));
    [at, rate]
}

#[cfg(test)]
mod tests {
    use super::*;
    use tribos_core::coupling::ReducedFriction;
    use tribos_core::coupling::coulomb::CoulombDisk;
    use tribos_core::slider::{Slider, SliderParameters, SliderState};

    /// The slider of the kernel is exact to 1e-13.
    #[test]
    fn places_are_those_of_the_exact_slider() {
        let (deceleration, inertia_ratio) = (3.0, 0.5);
        let parameters = SliderParameters {
            deceleration,
            radius: 1.0,
            inertia_ratio,
        };
        let slider = Slider::new(CoulombDisk, parameters).unwrap();
        let rates = |[v, w]: [f64; 2]| {
            let at = CoulombDisk.reduced_wrench(v, w);
            [
                deceleration * at.force,
                deceleration * at.torque / inertia_ratio,
            ]
        };
        for (speed, rim) in [
            (1.0, 0.2),
            (1.0, 0.999),
            (1.0, 5.0),
            (2.0, 0.0),
            (0.0, 1.0),
            (1.0, 1.0),
        ] {
            let start = SliderState::launched(speed, rim);
            let rest = slider.to_rest(&start).unwrap().motion;
            let times: Vec<f64> = (0..=40).map(|k| rest.time * f64::from(k) / 35.0).collect();
            let places = march([speed, rim], &times, &rates).unwrap();
            assert_eq!(places.len(), times.len());
            for (place, time) in places.iter().zip(&times) {
                let exact = slider.advance(&start, *time).motion;
                let off = [place.way[0] - exact.distance, place.turned - exact.angle];
                let bound = 1e-7 * (rest.distance + rest.angle);
                assert!(
                    off[0].abs() < bound && off[1].abs() < bound,
                    "{speed} {rim} {time}: {off:?}"
                );
                assert!(
                    (place.speed - exact.speed).abs() < 1e-5,
                    "{place:?} {exact:?}"
                );
            }
        }
    }
}
