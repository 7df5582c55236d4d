//! The way to rest, in scale and direction.
//!
//! With (v, w) = s (c, n), c² + n² = 1, s = s₀ eᴸ and dτ = κ s^(α−1) dt, friction of degree α gives
//!
//! ```text
//! dL/dτ = −k,  k = F c + T n/C;    d(c, n)/dτ = m (−n, c),  m = F n − T c/C;
//! dt/dτ = e^((1−α)L),  d(path)/dτ = (c, n) e^((2−α)L)      in units of s₀^(1−α)/κ and s₀
//! ```
//!
//! with F, T at (c, n). The direction obeys an equation of its own and tends to a fixed point; the
//! scale falls exponentially in τ and never reaches zero, so that nothing is stepped over and
//! nothing underflows. Once the direction has settled the rest closes analytically: remaining
//! time e^((1−α)L)/(k(1−α)), remaining path (c, n) e^((2−α)L)/(k(2−α)).

use super::runge_kutta;
use super::{Motion, Slider};
use crate::coupling::{Coupling, Profile, ReducedWrench};
use crate::real::Real;

/// The end of a motion.
///
/// ```
/// use tribos_core::coupling::table::Coulomb;
/// use tribos_core::modes::Modes;
/// use tribos_core::slider::{Motion, Rest, Slider};
/// let puck = Slider::new(Coulomb, 0.3 * 9.81, 0.08, 0.5_f64)?;
/// let last = Modes::new(Coulomb, 0.5)?.finite_fixed_point().unwrap_or(f64::NAN);
/// // However it is thrown, sliding and spinning end together, in one ratio.
/// for (speed, spin) in [(2.0, 1.0), (0.1, 40.0)] {
///     let rest: Option<Rest<f64>> = puck.to_rest(&Motion::launched(speed, spin)); // m/s, rad/s
///     assert!(rest.is_some_and(|rest| (rest.ratio - last).abs() < 1e-12));
/// }
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Rest<R> {
    /// Time, distance and angle at rest; speeds zero.
    pub motion: Motion<R>,
    /// Velocity ratio ε in the limit of rest.
    pub ratio: R,
    /// Substeps taken.
    pub substeps: u32,
}

/// c, n, L, time, path of the centre, path of the rim.
type State<R> = [R; 6];

/// First substep in τ.
const FIRST: f64 = 1.0 / 16.0;
/// A direction that turns by less than this many rounding errors per e-fold of the remaining time
/// has settled.
const SETTLED_ULPS: f64 = 8.0;
/// Rounding errors of the turning rate itself: less cannot be told from none.
const NOISE_ULPS: f64 = 2.0;
/// Largest substep: e-folds of the remaining time.
const LARGEST: f64 = 1.0;
/// More substeps than any motion needs: 16 for each e-fold down to the last bit, and many times
/// over.
const MAX_SUBSTEPS: u32 = 100_000;

impl<R: Real, P: Profile<R> + Coupling<R>> Slider<R, P> {
    /// Follows the motion to rest. `None` for α ≥ 1, which never rests in finite time, and for
    /// a motion that is not finite.
    ///
    /// *Accuracy*: about 1e-14 relative in time, distance and angle, and 1e-14/(1−α) in the
    /// ratio (f64).
    /// *Cost*: mostly 1,000 to 2,500 substeps of 7 wrenches, at most 4,200 seen for smooth pressures.
    /// A ring with C = 1 settles at equal speeds, where its slopes are infinite under α ≤ 0: 12,000
    /// for α = 0, and for α = −1/2 the limit of 100,000.
    pub fn to_rest(&self, motion: &Motion<R>) -> Option<Rest<R>> {
        let (v, w) = (motion.speed, (motion.spin * self.radius).abs());
        let scale = v.hypot(w);
        if self.profile.exponent() >= R::ONE || !scale.is_finite() {
            return None;
        }
        if scale == R::ZERO {
            return Some(Rest {
                motion: *motion,
                ratio: v / w,
                substeps: 0,
            });
        }
        let start = [v / scale, w / scale, R::ZERO, R::ZERO, R::ZERO, R::ZERO];
        let (end, substeps) = self.follow(start);
        let time_unit = scale.pow(R::ONE - self.profile.exponent()) / self.deceleration;
        let path_unit = scale * time_unit;
        let turned = path_unit * end[5] / self.radius;
        Some(Rest {
            motion: Motion {
                time: motion.time + time_unit * end[3],
                speed: R::ZERO,
                spin: R::ZERO,
                distance: motion.distance + path_unit * end[4],
                angle: motion.angle + turned.copysign(motion.spin),
            },
            ratio: end[0] / end[1],
            substeps,
        })
    }

    /// Integrates in τ until the direction has settled, then closes.
    fn follow(&self, mut state: State<R>) -> (State<R>, u32) {
        let beta = R::ONE - self.profile.exponent();
        let mut size = R::from_f64(FIRST);
        let mut substeps = 0;
        loop {
            let [loss, turning] = self.loss_and_turning(&state);
            let (settled, noise) = (R::from_f64(SETTLED_ULPS) * beta, R::from_f64(NOISE_ULPS));
            let least = R::EPSILON * loss * if settled > noise { settled } else { noise };
            // At marginal inertia ratios, and where noise hides that it has settled, the direction
            // would turn for ever: it ends with the numbers that the time left can take.
            let has_faded = (beta * state[2]).exp() < R::MIN_POSITIVE;
            let has_settled = turning.abs() <= least || turning.is_nan();
            if has_settled || has_faded || substeps == MAX_SUBSTEPS {
                return (self.closed(&state, loss), substeps);
            }
            let largest = R::from_f64(LARGEST) / (loss * beta);
            size = if size > largest { largest } else { size };
            let (next, error) = runge_kutta::step(&state, size, |y| self.derivative(y));
            let admissible = next[0] >= R::ZERO && next[1] >= R::ZERO;
            let (accepted, factor) = runge_kutta::judge(
                self.weighed(&next, &error),
                runge_kutta::tolerance(),
                admissible,
            );
            if accepted {
                state = normalized(next);
            }
            size *= factor;
            substeps += 1;
        }
    }

    /// k and m at the direction of `state`.
    fn loss_and_turning(&self, state: &State<R>) -> [R; 2] {
        let (c, n) = (state[0], state[1]);
        let ReducedWrench { force, torque } = self.profile.reduced_wrench(c, n);
        let spin_down = torque / self.inertia_ratio;
        [force * c + spin_down * n, force * n - spin_down * c]
    }

    fn derivative(&self, state: &State<R>) -> State<R> {
        let [loss, turning] = self.loss_and_turning(state);
        let [c, n, log_scale, ..] = *state;
        let scale = log_scale.exp();
        let pace = ((R::ONE - self.profile.exponent()) * log_scale).exp();
        [
            -(turning * n),
            turning * c,
            -loss,
            pace,
            c * scale * pace,
            n * scale * pace,
        ]
    }

    /// The largest error in units that matter: direction as it is, the logarithm of the scale by
    /// what it does to the remaining time, time and paths relative to what they have reached.
    fn weighed(&self, at: &State<R>, error: &State<R>) -> R {
        let pace = ((R::ONE - self.profile.exponent()) * at[2]).exp();
        let reached = |x: R| if x > R::ONE { x } else { R::ONE };
        let terms = [
            error[0].abs(),
            error[1].abs(),
            error[2].abs() * pace,
            error[3].abs() / reached(at[3]),
            error[4].abs() / reached(at[4]),
            error[5].abs() / reached(at[5]),
        ];
        terms
            .into_iter()
            .fold(R::ZERO, |a, b| if b > a || b.is_nan() { b } else { a })
    }

    /// The closed form along the present direction, with loss rate `loss`.
    fn closed(&self, state: &State<R>, loss: R) -> State<R> {
        let beta = R::ONE - self.profile.exponent();
        let mut end = *state;
        let [c, n, log_scale, ..] = *state;
        let pace = (beta * log_scale).exp();
        let reach = pace * log_scale.exp() / (loss * (R::ONE + beta));
        end[3] += pace / (loss * beta);
        end[4] += c * reach;
        end[5] += n * reach;
        end
    }
}

/// The direction back on the unit circle.
fn normalized<R: Real>(mut state: State<R>) -> State<R> {
    let length = state[0].hypot(state[1]);
    state[0] /= length;
    state[1] /= length;
    state
}
