//! End conditions of a journey: rest, fading, and one motion that ends before the other.

use super::{LARGEST, MOST_FOLDS, PlanarSimulation, Resistance, State, normalized};
use tribos_base::bracket::Bracket;
use tribos_core::Real;
use tribos_core::internals::runge_kutta;

/// No motion has ended before the speed has fallen by this many e-folds: e⁻⁴⁰ = 4e-18.
pub(super) const FOLDS: f64 = 40.0;
/// Largest relative contribution of a further e-fold of the speed to path or angle at their end.
const REACHED: f64 = 4e-18;
/// e-folds of the remaining time granted to the velocity ratio to reach its limit.
const PATIENT_FOLDS: f64 = 100.0;
/// A ratio has settled if it changes by less than this fraction while the remaining time falls by
/// an e-fold.
const SETTLED: f64 = 1e-13;
/// Rounding error of the rate at which the ratio changes.
const NOISE: f64 = 4.0 * f64::EPSILON;
/// A decreasing part of e below this value no longer affects the other part.
const ALONE: f64 = 1e-16;
/// A part that has fallen below this fraction of its initial length contributes to no sum; the
/// error tolerance of a step is a thousandth of it.
const DEAD: f64 = 1e-16;
/// e-folds of a part per e-fold of the speed above which its decay limits the steps.
const STIFF: f64 = 10.0;
/// Halvings after which a step vanishes in f64.
const HALVINGS: usize = 53;

impl<B: Resistance> PlanarSimulation<'_, B> {
    /// 1 − α, the exponent with which the remaining time follows the speed; at most 1.
    fn slower(&self) -> f64 {
        let beta = 1.0 - self.body.exponent();
        if beta < 1.0 { beta } else { 1.0 }
    }

    /// True if nothing significant remains, or both speeds have faded.
    pub(super) fn is_over(&self) -> bool {
        let (folds, beta) = (self.state[9], self.slower());
        if beta > 0.0 && !self.body.is_round() {
            // Nothing adds to time and path any more; the ratio may need longer to settle.
            folds * beta >= FOLDS
        } else if beta > 0.0 {
            // The remaining time follows as a power of the speed once the ratio has settled.
            let is_settled = || self.has_arrived() && self.has_settled(beta);
            folds >= FOLDS && (folds * beta >= PATIENT_FOLDS || is_settled())
        } else {
            self.has_faded(&self.state)
        }
    }

    /// True if both speeds are below the fraction of their initial values that counts as rest.
    fn has_faded(&self, state: &State) -> bool {
        let left = self.stop_fraction * Real::exp(state[9]);
        let slide = Real::hypot(state[0], state[1]);
        slide <= left * self.lengths[0] && state[2].abs() <= left * self.lengths[1]
    }

    /// True if path and angle no longer grow: each follows a power of the speed above 1.
    fn has_arrived(&self) -> bool {
        let rates = self.derivative(&self.state);
        let is_reached = |part: usize| rates[part].abs() <= REACHED * self.state[part].abs();
        is_reached(6) && is_reached(7)
    }

    /// True if the velocity ratio has reached its limit.
    fn has_settled(&self, beta: f64) -> bool {
        let [x, y, w, ..] = self.state;
        let slide = Real::hypot(x, y);
        if slide == 0.0 || w == 0.0 {
            return true;
        }
        let [sliding, spinning] = self.rates();
        let (rate, allowed) = (sliding - spinning, SETTLED * beta);
        let slides_alone = w.abs() < ALONE && rate > 0.0;
        let spins_alone = slide < ALONE && rate < 0.0;
        slides_alone || spins_alone || rate.abs() < if allowed > NOISE { allowed } else { NOISE }
    }

    /// Growth of the sliding and of the spinning part of e per e-fold of the speed.
    fn rates(&self) -> [f64; 2] {
        let [x, y, w, ..] = self.state;
        let [dx, dy, dw, ..] = self.derivative(&self.state);
        let slide = Real::hypot(x, y);
        [(x / slide * dx + y / slide * dy) / slide, dw / w]
    }

    /// Longest step, which keeps the path smooth between accepted steps while it is visible.
    pub(super) fn largest_step(&self) -> f64 {
        let beta = self.slower();
        if self.state[9] > FOLDS && beta > 0.0 {
            LARGEST / beta
        } else {
            LARGEST
        }
    }

    /// e, projected back to the unit sphere where steps are long: off the sphere, errors grow as e^(2L).
    pub(super) fn direction(&self, state: &State) -> State {
        if state[9] > FOLDS {
            normalized(*state)
        } else {
            *state
        }
    }

    /// Factor by which the time depends on the speed once that is held constant: e^(−(1−α)(L−600)).
    pub(super) fn held_pace(&self, state: &State) -> f64 {
        let beyond = state[9] - MOST_FOLDS;
        if beyond > 0.0 {
            Real::exp(-(1.0 - self.body.exponent()) * beyond)
        } else {
            1.0
        }
    }

    /// Sets a part of e to zero if it has ended and its fast decay would keep the steps short.
    pub(super) fn zero_decayed_part(&mut self) -> bool {
        if !self.body.is_round() {
            return false;
        }
        let [x, y, w, ..] = self.state;
        let slide = Real::hypot(x, y);
        let [first_slide, first_rim] = self.lengths;
        let slides_no_more = slide > 0.0 && slide < DEAD * first_slide;
        let spins_no_more = w != 0.0 && w.abs() < DEAD * first_rim;
        if !slides_no_more && !spins_no_more {
            return false;
        }
        let [sliding, spinning] = self.rates();
        if slides_no_more && sliding < -STIFF {
            [self.state[0], self.state[1]] = [0.0, 0.0];
        } else if spins_no_more && spinning < -STIFF {
            self.state[2] = 0.0;
        } else {
            return false;
        }
        self.state = normalized(self.state);
        true
    }

    /// Shortens the step so that it ends with a fading motion; returns the new length.
    pub(super) fn truncate_at_decay(&mut self, from: &State, taken: f64) -> f64 {
        let fades = self.body.exponent() >= 1.0 && self.has_faded(&self.state);
        if !fades || self.has_faded(from) {
            return taken;
        }
        let (length, end) = self.first(from, taken, |at| self.has_faded(at));
        self.state = end;
        length
    }

    /// The first state within the step of length `taken` from `from` for which `holds` is true, as it is
    /// at the end of the step, and the length of the step to that state.
    pub(super) fn first(
        &self,
        from: &State,
        taken: f64,
        holds: impl Fn(&State) -> bool,
    ) -> (f64, State) {
        let mut end = self.state;
        let is_reached = |length: f64| {
            let at = normalized(runge_kutta::step(from, length, |y| self.derivative(y)).0);
            let is_reached = holds(&at);
            if is_reached {
                end = at;
            }
            is_reached
        };
        let high = Bracket::new(0.0, taken).halved(HALVINGS, is_reached).high;
        (high, end)
    }
}
