//! Dry friction in closed form: rest, and arcs of a harmonic oscillation between its ends.
//!
//! A body of mass m that slips forward under the constant friction N μ_d, on a spring whose end moves with
//! the speed V, obeys for its place u relative to that end
//!
//! ```text
//! m u'' = −k u ∓ N μ_d    ⇒    u = c + C cos ωτ + S sin ωτ,    c = ∓N μ_d/k,  ω = √(k/m)
//! v = V + u' = V + ωR cos(ωτ + δ),    R = hypot(C, S),  δ = atan2(C, S)
//! ```
//!
//! The instants at which it stops (v = 0) and at which the spring force is extremal (u' = 0) are therefore
//! known. At rest the force grows linearly, and the body lets go where it meets N μ_s(age).

use super::motion::{SpringIntegrator, SpringSample};
use crate::stick::MotionError;
use std::f64::consts::{FRAC_PI_2, PI, TAU};
use tribos_core::Real;
use tribos_core::law::{RestTime, StaticAgeing};

/// Mass, spring and load, and dry friction whose static coefficient may grow with the time of rest.
#[derive(Clone, Copy, Debug)]
pub(super) struct DryBlock {
    pub mass: f64,
    pub stiffness: f64,
    pub load: f64,
    pub mu_dynamic: f64,
    pub mu_static: StaticAgeing<f64>,
}

/// A dry block under way.
#[derive(Debug)]
pub(super) struct DryMotion {
    block: DryBlock,
    time: f64,
    pull: f64,
    /// Stays as it is while the body sticks.
    position: f64,
    /// Place relative to the end of the spring.
    offset: f64,
    phase: Phase,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Phase {
    /// At rest for this time.
    Sticks { age: f64 },
    /// In motion with this velocity; friction acts against `sign`.
    Slips { velocity: f64, sign: f64 },
}

/// Phase of the oscillation, in rad, within which an instant counts as now: its rounding.
const NOW: f64 = 1e-9;
/// Shares of the swing of the force and of what friction holds, beyond which a force exceeds what friction holds: its
/// rounding over as many pieces as an arc may have. Without friction in motion a body stops where it began.
const ROUNDED: f64 = 1e-9;
const MOST_ROUNDED: f64 = 1e-6;
/// Bits from the smallest to the largest number of f64, more than any count here reaches. A step of Newton's method from
/// above on a convex function leaves at most a quarter of the function times its slope: as many steps bring both below
/// every number, and some ten are taken. As many doublings make any time infinite, and then the body holds for ever.
const ALL_BITS: u32 = 2100;

impl DryMotion {
    /// At rest with a relaxed spring.
    pub fn new(block: DryBlock) -> Self {
        Self {
            block,
            time: 0.0,
            pull: 0.0,
            position: 0.0,
            offset: 0.0,
            phase: Phase::Sticks { age: 0.0 },
        }
    }

    fn force(&self) -> f64 {
        -self.block.stiffness * self.offset
    }

    /// What friction holds at an age.
    fn limit(&self, time: f64) -> f64 {
        self.block.load * self.block.mu_static.mu_static(RestTime { time })
    }

    /// Time until the body lets go; infinite if it does not.
    fn release(&self, age: f64, speed: f64) -> f64 {
        let rate = (self.block.stiffness * speed).abs();
        if rate == 0.0 {
            return f64::INFINITY;
        }
        let force = self.force() * speed.signum();
        // Contacts that do not grow stronger; a force that rounding puts beyond the limit lets go at once.
        let young = ((self.limit(age) - force) / rate).max(0.0);
        let strengthens = self.block.mu_static.rate(RestTime { time: age + young }) > 0.0;
        if !strengthens {
            return young;
        }
        // What is missing is a convex function of the time, negative now: Newton's method from above.
        let missing = |wait: f64| force + rate * wait - self.limit(age + wait);
        let mut wait = young.max(f64::MIN_POSITIVE);
        for _ in 0..ALL_BITS {
            if missing(wait) >= 0.0 {
                break;
            }
            wait *= 2.0;
        }
        for _ in 0..ALL_BITS {
            let growth = self.block.load * self.block.mu_static.rate(RestTime { time: age + wait });
            let next = wait - missing(wait) / (rate - growth);
            if next >= wait || next.is_nan() {
                break;
            }
            wait = next;
        }
        wait
    }

    /// Waits at rest, until it lets go at most.
    fn wait(&mut self, age: f64, speed: f64, left: f64) -> f64 {
        let release = self.release(age, speed);
        let lets_go = release <= left;
        let wait = if lets_go { release } else { left };
        let before = self.force();
        self.offset -= speed * wait;
        self.phase = Phase::Sticks { age: age + wait };
        if lets_go {
            let sign = speed.signum();
            // Exactly what friction held.
            self.offset = -sign * self.limit(age + wait) / self.block.stiffness;
            let velocity = 0.0;
            self.phase = Phase::Slips { velocity, sign };
        }
        self.advance(wait, speed);
        0.5 * wait * (before + self.force())
    }

    fn advance(&mut self, step: f64, speed: f64) {
        self.pull += speed * step;
        self.time += step;
    }

    /// Follows the oscillation, until it stops or the force is extremal at most.
    fn slide(&mut self, velocity: f64, sign: f64, speed: f64, left: f64) -> f64 {
        let block = &self.block;
        let omega = Real::sqrt(block.stiffness / block.mass);
        let friction = sign * block.load * block.mu_dynamic;
        let centre = -friction / block.stiffness;
        let arc = HarmonicMotion {
            cosine: self.offset - centre,
            sine: (velocity - speed) / omega,
            drift: speed / omega,
        };
        let (stop, turn) = (arc.stop(sign) / omega, arc.turn() / omega);
        let stops = stop <= turn && stop <= left;
        let step = if stops { stop } else { turn.min(left) };
        let (sin, cos) = (Real::sin(omega * step), Real::cos(omega * step));
        let before = self.offset;
        self.offset = centre + arc.cosine * cos + arc.sine * sin;
        self.position += speed * step + (self.offset - before);
        let after = if stops {
            0.0
        } else {
            speed + omega * (arc.sine * cos - arc.cosine * sin)
        };
        let slides_on = Phase::Slips {
            velocity: after,
            sign,
        };
        self.phase = match stops {
            false => slides_on,
            true if self.holds_after(&arc) => Phase::Sticks { age: 0.0 },
            // The spring pulls it back at once.
            true => Phase::Slips {
                velocity: 0.0,
                sign: self.force().signum(),
            },
        };
        let impulse = self.block.mass * (after - velocity) + friction * step;
        self.advance(step, speed);
        impulse
    }

    /// Whether friction holds the force at the end of an arc, up to its rounding.
    fn holds_after(&self, arc: &HarmonicMotion) -> bool {
        let limit = self.limit(0.0);
        let swing = self.block.stiffness * (arc.cosine.abs() + arc.sine.abs() + arc.drift.abs());
        self.force().abs() - limit <= (ROUNDED * swing).min(MOST_ROUNDED * limit)
    }
}

/// v/ω = drift + sine cos φ − cosine sin φ over the phase φ = ωτ.
struct HarmonicMotion {
    cosine: f64,
    sine: f64,
    drift: f64,
}

impl HarmonicMotion {
    /// Phase at which a motion of this sign stops; infinite if it does not.
    fn stop(&self, sign: f64) -> f64 {
        let lead = libm::atan2(self.cosine, self.sine);
        // R² − drift²: of a body that has just been released it is the square of `cosine`.
        let square =
            self.cosine * self.cosine + (self.sine - self.drift) * (self.sine + self.drift);
        if square < 0.0 || square.is_nan() {
            return f64::INFINITY;
        }
        let half = libm::atan2(Real::sqrt(square), -self.drift);
        let phase = (sign * half - lead).rem_euclid(TAU);
        let slows_down = sign * self.cosine > 0.0;
        match phase {
            // It has just been released.
            now if now <= NOW && !slows_down => now + TAU,
            // The body stops now, and rounding says before.
            now if now >= TAU - NOW && slows_down => 0.0,
            ahead => ahead,
        }
    }

    /// Phase at which the body is as fast as the end of the spring: an extremum of the force.
    fn turn(&self) -> f64 {
        let lead = libm::atan2(self.cosine, self.sine);
        let phase = (FRAC_PI_2 - lead).rem_euclid(PI);
        if phase > NOW { phase } else { phase + PI }
    }
}

impl SpringIntegrator for DryMotion {
    fn moment(&self) -> SpringSample {
        let (velocity, friction, state, slips) = match self.phase {
            Phase::Sticks { age } => (0.0, self.force(), age, false),
            Phase::Slips { velocity, sign } => {
                let friction = sign * self.block.load * self.block.mu_dynamic;
                (velocity, friction, 0.0, true)
            }
        };
        SpringSample {
            time: self.time,
            pull: self.pull,
            position: self.position,
            velocity,
            spring_force: self.force(),
            friction,
            state,
            slips,
        }
    }

    fn step(&mut self, speed: f64, until: f64) -> Result<f64, MotionError> {
        let left = until - self.time;
        let before = self.time;
        let impulse = match self.phase {
            Phase::Sticks { age } => self.wait(age, speed, left),
            Phase::Slips { velocity, sign } => self.slide(velocity, sign, speed, left),
        };
        // What is left of the interval after rounding is no step.
        if until - self.time <= f64::EPSILON * until.abs() {
            self.time = until;
        }
        if !(self.offset.is_finite() && self.time >= before) {
            return Err(MotionError::NotFiniteAt { time: before });
        }
        Ok(impulse)
    }

    fn holds_exactly(&self) -> bool {
        true
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_body_lets_go_where_its_force_first_meets_what_its_age_brings() {
        // Growth and speed, with force and age at the start: from growth that is far quicker than the pull to none.
        for growth in [1e-3, 0.1, 1.0, 30.0] {
            for speed in [1e-12, 1e-6, 1e-3, 1.0 - 1e-9, 1.0, 1.0 + 1e-9, 50.0] {
                for (offset, age) in [(0.0, 0.0), (-0.4, 0.0), (-0.4, 1.0), (-0.39, 1e3)] {
                    let block = DryBlock {
                        mass: 1.0,
                        stiffness: 1.0,
                        load: 1.0,
                        mu_dynamic: 0.2,
                        mu_static: StaticAgeing::new(0.4, growth, 1e-2).unwrap(),
                    };
                    let mut motion = DryMotion::new(block);
                    motion.offset = offset;
                    let wait = motion.release(age, speed);
                    let held =
                        |wait: f64| motion.limit(age + wait) - (motion.force() + speed * wait);
                    let scale = motion.limit(age + wait);
                    // It meets it there, and nowhere before.
                    let about = 1e-12 * scale;
                    assert!(
                        held(wait).abs() <= about,
                        "{growth} {speed} {offset} {age}: {wait}"
                    );
                    for i in 1..1000 {
                        let before = wait * f64::from(i) / 1000.0;
                        assert!(
                            held(before) >= -about,
                            "{growth} {speed} {offset} {age}: {before}"
                        );
                    }
                    // A force that is met at once is a tie; otherwise it exceeds it from then on.
                    if wait > 0.0 {
                        assert!(
                            held(wait * 1.001) < 0.0,
                            "{growth} {speed} {offset} {age}: {wait}"
                        );
                    }
                }
            }
        }
    }
}
