//! Final motion and complete motions.

use crate::{Input, Verdict};
use tribos_core::coupling::compact::CompactPower;
use tribos_core::coupling::coulomb::{CoulombDisk, CoulombHertz, CoulombPunch, CoulombRing};
use tribos_core::coupling::{PowerLawFriction, ReducedFriction};
use tribos_core::internals::runge_kutta::{judge, step, tolerance};
use tribos_core::modes::{TerminalMode, TerminalMotion, inertia_interval};
use tribos_core::real::Real;
use tribos_core::slider::{Slider, SliderParameters, SliderState};

/// Fixed points of one profile.
pub fn modes<R: Real>(input: &mut Input<'_>) -> Verdict {
    match input.below(4) {
        0 => of_profile::<R, _>(input, CoulombDisk),
        1 => of_profile::<R, _>(input, CoulombHertz),
        2 => of_profile::<R, _>(input, CoulombRing),
        _ => {
            let power = power::<R>(input, 3.0)?;
            of_profile(input, power)
        }
    }
}

/// A power law of an exponent from −0.9 to −0.9 + `range`.
fn power<R: Real>(input: &mut Input<'_>, range: f64) -> Verdict<CompactPower<R>> {
    let alpha = R::from_f64(input.unit::<f64>() * range - 0.9);
    input.taken(CompactPower::new(alpha))
}

fn of_profile<R: Real, P: PowerLawFriction<R>>(input: &mut Input<'_>, profile: P) -> Verdict {
    let modes = TerminalMotion::new(profile, input.positive());
    let modes = input.taken(modes)?;
    let ratio = input.size::<R>();
    let interval = modes.inertia_interval();
    input.holds(
        interval.0 <= interval.1,
        "an ordered interval",
        &[interval.0, interval.1],
    )?;
    input.finite(
        "growth",
        [modes.growth(ratio), modes.inertia_ratio_of(ratio)],
    )?;
    if let Ok(fixed) = input.taken(modes.finite_fixed_point().ok_or(())) {
        input.holds(fixed >= R::ZERO, "a fixed point ≥ 0", &[fixed])?;
    }
    let points = modes.fixed_points();
    input.give_bits(points.spinning as u64 | (points.sliding as u64) << 2);
    input.give(points.finite.map(|(ratio, _)| ratio));
    input.give_bits(points.finite.map_or(0, |(_, kind)| 1 + kind as u64));
    match modes.terminal_mode(ratio) {
        TerminalMode::Spinning => input.give_bits(0),
        TerminalMode::Sliding => input.give_bits(1),
        TerminalMode::Together { ratio } => {
            let is_fine = ratio >= R::ZERO || !input.is_mild();
            input.holds(is_fine, "a final ratio ≥ 0", &[ratio])?;
        }
    }
    let (least, most) = inertia_interval(input.number::<R>(), input.number());
    input.give([least, most]);
    Ok(())
}

/// A slider launched, advanced and brought to rest.
pub fn sliders<R: Real>(input: &mut Input<'_>) -> Verdict {
    match input.below(6) {
        0 => slid::<R, _>(input, CoulombDisk),
        1 => slid::<R, _>(input, CoulombHertz),
        2 => slid::<R, _>(input, CoulombPunch),
        3 => slid::<R, _>(input, CoulombRing),
        4 => {
            let power = power::<R>(input, 2.4)?;
            slid(input, power)
        }
        _ => pendulum::<R>(input),
    }
}

/// Runge–Kutta steps of x'' = −x, of judged size.
fn pendulum<R: Real>(input: &mut Input<'_>) -> Verdict {
    let (mut state, mut h) = ([input.number::<R>(), input.number()], input.positive::<R>());
    for _ in 0..4 {
        let (next, error) = step(&state, h, |&[x, v]| [v, -x]);
        let size = error[0].abs() + error[1].abs();
        let (accepted, factor) = judge(size, tolerance::<R>(), next[0].is_finite());
        input.give(next.into_iter().chain(error));
        input.finite("factor of a step", [factor])?;
        input.give_bits(u64::from(accepted));
        if accepted {
            state = next;
        }
        h *= factor;
    }
    let (_, factor) = judge(input.number::<R>(), input.number(), true);
    input.give([factor]);
    Ok(())
}

fn slid<R: Real, P: PowerLawFriction<R> + ReducedFriction<R>>(
    input: &mut Input<'_>,
    profile: P,
) -> Verdict {
    let (deceleration, radius, inertia) =
        (input.positive::<R>(), input.positive(), input.positive());
    let slider = input.taken(Slider::new(
        profile,
        SliderParameters {
            deceleration,
            radius,
            inertia_ratio: inertia,
        },
    ))?;
    let start = SliderState::launched(input.size(), input.number());
    let duration = input.size::<R>();
    let energy = |motion: &SliderState<R>| slider.energy_per_mass(motion);
    let power = slider.dissipation_per_mass(&start);
    input.finite("dissipation", [power])?;
    input.holds(
        power >= R::ZERO || !input.is_mild(),
        "dissipation ≥ 0",
        &[power],
    )?;

    input.give([slider.ratio(&start), slider.profile().exponent()]);
    let next = slider.advance(&start, duration).motion;
    told(input, "advance", &next)?;
    if input.is_mild() {
        input.at_most(
            "energy falls",
            energy(&next),
            energy(&start),
            energy(&start),
        )?;
    }
    let verlet = slider.verlet_step(&start, duration);
    if duration > R::ZERO {
        told(input, "verlet", &verlet)?;
    }
    if let Some(rest) = slider.to_rest(&start) {
        told(input, "rest", &rest.motion)?;
        input.give([rest.ratio]);
        input.give_bits(u64::from(rest.evaluations));
        let still = rest.motion.is_at_rest();
        input.holds(
            still || !input.is_mild(),
            "rest is rest",
            &[rest.motion.speed, rest.motion.spin],
        )?;
    }
    Ok(())
}

fn told<R: Real>(input: &mut Input<'_>, what: &'static str, motion: &SliderState<R>) -> Verdict {
    let all = [
        motion.time,
        motion.speed,
        motion.spin,
        motion.distance,
        motion.angle,
    ];
    input.finite(what, all)?;
    input.holds(
        motion.speed >= R::ZERO || !input.is_mild(),
        "speed ≥ 0",
        &all,
    )
}
