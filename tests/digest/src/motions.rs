//! Bits of sliders over thousands of steps, and of the Runge–Kutta step by itself.

use crate::hash::{Fnv, in_both};
use crate::inputs::{pairs_of_ends, triples_of_ends};
use tribos_core::coupling::closed::CoulombHertz;
use tribos_core::coupling::table;
use tribos_core::coupling::{PowerLawFriction, ReducedFriction};
use tribos_core::internals::runge_kutta::{judge, step, tolerance};
use tribos_core::real::Real;
use tribos_core::slider::{Slider, SliderParameters, SliderState};

/// Steps of a motion, half of them at rest or nearly so.
const STEPS: usize = 1000;

/// Digest of long motions, f64 and f32.
pub fn motions() -> u64 {
    in_both(motions_of::<f64>, motions_of::<f32>)
}

fn motions_of<R: Real>(hash: &mut Fnv) {
    long(hash, table::CoulombDisk, [1.0, 5.0].map(R::from_f64));
    long(hash, CoulombHertz, [0.25, -40.0].map(R::from_f64));
    pendulum::<R>(hash);
}

/// Digest of motions from the ends of the number range, f64 and f32.
pub fn extremes() -> u64 {
    let mut hash = Fnv::new();
    ends_of_motions(&mut hash, table::CoulombDisk, 1.0_f64);
    ends_of_motions(&mut hash, table::CoulombDisk, 1.0_f32);
    hash.0
}

fn slider<R: Real, P: PowerLawFriction<R> + ReducedFriction<R>>(profile: P) -> Slider<R, P> {
    let [deceleration, radius] = [2.943, 0.08].map(R::from_f64);
    Slider::new(
        profile,
        SliderParameters {
            deceleration,
            radius,
            inertia_ratio: R::HALF,
        },
    )
    .expect("in range")
}

fn feed<R: Real>(hash: &mut Fnv, m: &SliderState<R>) {
    hash.numbers([m.time, m.speed, m.spin, m.distance, m.angle]);
}

fn long<R: Real, P: PowerLawFriction<R> + ReducedFriction<R>>(
    hash: &mut Fnv,
    profile: P,
    [speed, spin]: [R; 2],
) {
    let puck = slider(profile);
    let dt = R::from_f64(1.0 / 2048.0);
    let mut fixed = SliderState::launched(speed, spin);
    for _ in 0..STEPS {
        fixed = puck.verlet_step(&fixed, dt);
        feed(hash, &fixed);
    }
    let mut state = SliderState::launched(speed, spin);
    for _ in 0..16 {
        state = puck.advance(&state, R::from_f64(1.0 / 32.0)).motion;
        feed(hash, &state);
        hash.numbers([puck.energy_per_mass(&state), puck.ratio(&state)]);
        hash.number(puck.dissipation_per_mass(&state));
        hash.feed(u64::from(state.is_at_rest()));
    }
    hash.number(puck.profile().exponent());
    let rest = puck.to_rest(&SliderState::launched(speed, spin));
    if let Some(rest) = rest {
        feed(hash, &rest.motion);
        hash.number(rest.ratio);
    }
}

fn ends_of_motions<R: Real, P>(hash: &mut Fnv, profile: P, unit: R)
where
    P: PowerLawFriction<R> + ReducedFriction<R> + Copy,
{
    let puck = slider(profile);
    for [speed, spin, duration] in triples_of_ends::<R>(151) {
        let start = SliderState::launched(speed, spin);
        let next = puck.advance(&start, duration);
        feed(hash, &next.motion);
        feed(hash, &puck.verlet_step(&start, duration));
        hash.numbers([puck.energy_per_mass(&start), puck.ratio(&start)]);
        hash.number(puck.dissipation_per_mass(&start));
        if let Some(rest) = puck.to_rest(&start) {
            feed(hash, &rest.motion);
        }
        hash.verdict(&Slider::new(
            profile,
            SliderParameters {
                deceleration: speed,
                radius: spin,
                inertia_ratio: unit,
            },
        ));
        hash.verdict(&Slider::new(
            profile,
            SliderParameters {
                deceleration: unit,
                radius: unit,
                inertia_ratio: duration,
            },
        ));
    }
}

/// A pendulum without trigonometry, x'' = −x, by steps of judged size.
fn pendulum<R: Real>(hash: &mut Fnv) {
    let mut state = [R::ONE, R::ZERO];
    let mut h = R::from_f64(0.125);
    for _ in 0..30 {
        let (next, error) = step(&state, h, |&[x, v]| [v, -x]);
        let size = error[0].abs() + error[1].abs();
        let (accepted, factor) = judge(size, tolerance::<R>(), next[0].is_finite());
        hash.numbers(next);
        hash.numbers(error);
        hash.number(factor);
        h *= factor;
        if accepted {
            state = next;
        }
    }
    for (error, bound) in pairs_of_ends::<R>() {
        let (accepted, factor) = judge(error, bound, true);
        hash.feed(u64::from(accepted));
        hash.number(factor);
    }
}
