//! Derivatives of the paths to rest by the direction of the launch.
//!
//! With (v, ωR) = s (cos φ, sin φ) = s (c, n), p = 2 − α, the loss k and the turning rate m of the
//! direction (dφ/dτ = m, d ln s/dτ = −k), the remaining path is s^p X(φ)/κ. It shrinks by c s^p/κ
//! per unit of τ, and the path of the rim likewise:
//!
//! ```text
//! m X' = p k X − c,        m Y' = p k Y − n                                            (1)
//! ```
//!
//! Where m ≈ 0 both sides vanish. There, with the path X_s = c/(pk) that would remain at constant direction,
//! and after integration of ∫ e^(pL) c dτ by parts,
//!
//! ```text
//! X' = p k₀ ∫ W X_s' dτ,     W = e^(pL) m/m₀,     dW/dτ = (m' − p k) W,     W(0) = 1   (2)
//! ```
//!
//! which contains no quotient. (2) is integrated until the direction turns fast enough for (1),
//! or until it has settled and the integral has a closed form: W X_s'/(p k − m').

use super::RestMap;
use tribos_core::Real;
use tribos_core::coupling::{PowerLawFriction, ReducedFriction};
use tribos_core::internals::runge_kutta;

/// c, n, W, ∫ W X_s' dτ, ∫ W Y_s' dτ.
type State = [f64; 5];

/// Local error tolerance of a step.
pub(super) const TOLERANCE: f64 = 1e-14;
/// If the direction turns by this fraction of the loss, (1) is accurate to 1e-13 of the slope.
pub(super) const BRISK: f64 = 1e-2;
/// A turning rate below this fraction of the loss has no further effect.
pub(super) const SETTLED: f64 = 1e-14;
/// A weight this small is below rounding.
pub(super) const SPENT: f64 = 1e-17;
/// First step in τ, and a number of steps that no integral needs.
pub(super) const FIRST: f64 = 1.0 / 32.0;
pub(super) const MAX_STEPS: u32 = 20_000;
/// Half step of the difference quotient used where the slope of the law is infinite.
pub(super) const STEP: f64 = 1e-6;

/// Loss and turning rate at one direction, with their derivatives along the circle.
pub(super) struct Rates {
    pub loss: f64,
    pub turning: f64,
    pub turning_slope: f64,
    loss_slope: f64,
    /// X_s' and Y_s'.
    frozen: [f64; 2],
}

impl Rates {
    /// Derivative of 1/(q k).
    pub(super) fn frozen_time(&self, q: f64) -> f64 {
        -self.loss_slope / (q * self.loss * self.loss)
    }
}

impl<P: PowerLawFriction<f64> + ReducedFriction<f64>> RestMap<P> {
    /// X' and Y' at the direction (c, n).
    /// *Accuracy*: 1e-9, the tolerance of the check of [`RestMap::jacobian`]; none is guaranteed for a thin
    /// ring whose direction has settled at v = ωR, where the slopes of the law itself are infinite.
    pub(super) fn slopes(&self, at: [f64; 2]) -> [f64; 2] {
        self.followed(at).unwrap_or_else(|| self.difference(at))
    }

    /// Derivatives by (1) or (2); `None` where the law has no slope.
    fn followed(&self, [c, n]: [f64; 2]) -> Option<[f64; 2]> {
        let [start, turning] = self.loss_and_turning([c, n]);
        if turning.abs() >= BRISK * start {
            return Some(self.direction_derivatives([c, n]));
        }
        // c, n, W and the two integrals.
        let mut state: State = [c, n, 1.0, 0.0, 0.0];
        let mut size = FIRST / start;
        let p = self.degree();
        for _ in 0..MAX_STEPS {
            let [c, n, weight, x, y] = state;
            let [loss, turning] = self.loss_and_turning([c, n]);
            if turning.abs() >= BRISK * loss {
                let left = weight * start / loss;
                let [dx, dy] = self.direction_derivatives([c, n]);
                return finite([p * start * x + left * dx, p * start * y + left * dy]);
            }
            let rates = self.rates([c, n]);
            if turning.abs() <= SETTLED * loss || weight < SPENT {
                let left = weight / (p * loss - rates.turning_slope);
                let [dx, dy] = rates.frozen;
                return finite([p * start * (x + left * dx), p * start * (y + left * dy)]);
            }
            let (next, error) = runge_kutta::step(&state, size, |y| self.derivative(y));
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

    /// Derivatives by (1).
    fn direction_derivatives(&self, at: [f64; 2]) -> [f64; 2] {
        let [loss, turning] = self.loss_and_turning(at);
        let paths = self.reduced(at);
        let gain = self.degree() * loss;
        [
            (gain * paths.centre - at[0]) / turning,
            (gain * paths.rim - at[1]) / turning,
        ]
    }

    /// Derivatives by a symmetric difference.
    fn difference(&self, [c, n]: [f64; 2]) -> [f64; 2] {
        let [after, before] = [STEP, -STEP].map(|turn| {
            let (sin, cos) = (Real::sin(turn), Real::cos(turn));
            self.reduced([c * cos - n * sin, n * cos + c * sin])
        });
        [
            (after.centre - before.centre) / (2.0 * STEP),
            (after.rim - before.rim) / (2.0 * STEP),
        ]
    }

    fn derivative(&self, state: &State) -> State {
        let [c, n, weight, ..] = *state;
        let rates = self.rates([c, n]);
        let [x, y] = rates.frozen;
        [
            -rates.turning * n,
            rates.turning * c,
            (rates.turning_slope - self.degree() * rates.loss) * weight,
            weight * x,
            weight * y,
        ]
    }

    /// k = F c + T n/C and m = F n − T c/C.
    pub(super) fn loss_and_turning(&self, [c, n]: [f64; 2]) -> [f64; 2] {
        let wrench = self.profile().reduced_wrench(c, n);
        let (force, spin_down) = (wrench.force, wrench.torque / self.inertia_ratio());
        [force * c + spin_down * n, force * n - spin_down * c]
    }

    pub(super) fn rates(&self, [c, n]: [f64; 2]) -> Rates {
        let wrench = self.profile().reduced_wrench(c, n);
        let slopes = self.profile().reduced_jacobian(c, n);
        let (force, spin_down) = (wrench.force, wrench.torque / self.inertia_ratio());
        // Derivatives along the circle, d(c, n) = (−n, c) dφ.
        let force_turn = slopes.mixed * c - slopes.force_slide * n;
        let spin_down_turn = (slopes.torque_rim * c - slopes.mixed * n) / self.inertia_ratio();
        let loss = force * c + spin_down * n;
        let turning = force * n - spin_down * c;
        let loss_slope = force_turn * c + spin_down_turn * n - turning;
        let gain = self.degree() * loss;
        Rates {
            loss,
            turning,
            turning_slope: force_turn * n - spin_down_turn * c + loss,
            loss_slope,
            frozen: [
                -(n + c * loss_slope / loss) / gain,
                (c - n * loss_slope / loss) / gain,
            ],
        }
    }
}

fn finite(pair: [f64; 2]) -> Option<[f64; 2]> {
    pair.iter().all(|x| x.is_finite()).then_some(pair)
}

/// The largest error. Each component of the direction is compared with itself, so that a small one
/// keeps its accuracy.
fn worst(at: &State, error: &State) -> f64 {
    let units = [at[0].abs(), at[1].abs(), 1.0, 1.0, 1.0];
    let terms = error.iter().zip(units).map(|(error, unit)| match error {
        0.0 => 0.0,
        _ => error.abs() / unit,
    });
    terms.fold(0.0, |a: f64, b| if b > a || b.is_nan() { b } else { a })
}
