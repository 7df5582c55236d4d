//! Bodies that slide to rest.

use super::stream::{Precision, Range, Stream};
use tribos_core::coupling::coulomb::CoulombDisk;
use tribos_core::real::Real;
use tribos_core::slider::{Slider, SliderParameters, SliderState};

pub fn steps<R: Precision>(s: &mut Stream, range: Range) {
    let [deceleration, radius, inertia, duration]: [R; 4] = s.draws(Range::Fit);
    let [speed, spin] = s.draws(range);
    let slider = Slider::new(
        CoulombDisk,
        SliderParameters {
            deceleration,
            radius,
            inertia_ratio: inertia,
        },
    );
    let mut motion = SliderState::launched(speed, spin);
    for _ in 0..4 {
        let quarter = duration / (R::TWO + R::TWO);
        if let Some(next) = s.ok(slider.map(|slider| slider.verlet_step(&motion, quarter))) {
            motion = next;
            feed(s, &motion);
        }
        s.result(slider.map(|slider| slider.energy_per_mass(&motion)));
        s.result(slider.map(|slider| slider.dissipation_per_mass(&motion)));
    }
}

pub fn ways<R: Precision>(s: &mut Stream, to_rest: bool) {
    let [deceleration, radius, inertia, duration]: [R; 4] = s.draws(Range::Sure);
    let [speed, spin] = s.draws::<R, 2>(Range::Sure);
    let slider = Slider::new(
        CoulombDisk,
        SliderParameters {
            deceleration,
            radius,
            inertia_ratio: inertia,
        },
    );
    let motion = SliderState::launched(speed, -spin);
    let short = duration / R::from_f64(64.0);
    if let Some(next) = s.ok(slider.map(|slider| slider.advance(&motion, short))) {
        feed(s, &next.motion);
        s.number(next.rest.map_or(R::NAN, |rest| rest.ratio));
        s.feed_bits(next.rest.is_some().into());
        s.feed_bits(next.evaluations.into());
    }
    if !to_rest {
        return;
    }
    let rest = slider.ok().and_then(|slider| slider.to_rest(&motion));
    if let Some(rest) = s.ok(rest.ok_or(())) {
        feed(s, &rest.motion);
        s.number(rest.ratio);
        s.feed_bits(rest.evaluations.into());
    }
}

fn feed<R: Real>(s: &mut Stream, m: &SliderState<R>) {
    s.numbers([m.time, m.speed, m.spin, m.distance, m.angle]);
}
