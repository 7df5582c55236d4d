//! Final motion and complete motions.

use super::check::{at_most, finite, holds};
use super::{Broken, Source};
use tribos_core::coupling::closed::{CoulombHertz, CoulombPunch, CoulombRing};
use tribos_core::coupling::table::CoulombDisk;
use tribos_core::coupling::{PowerLawFriction, ReducedFriction, compact};
use tribos_core::modes::{TerminalMode, TerminalMotion, inertia_interval};
use tribos_core::real::Real;
use tribos_core::slider::{Slider, SliderParameters, SliderState};

/// Fixed points of one profile.
pub fn modes(source: &mut Source) -> Result<(), Broken> {
    match source.below(5) {
        0 => of_profile::<f64, _>(source, CoulombDisk),
        1 => of_profile::<f32, _>(source, CoulombDisk),
        2 => of_profile::<f64, _>(source, CoulombHertz),
        3 => of_profile::<f64, _>(source, CoulombRing),
        _ => {
            let alpha = source.unit::<f64>() * 3.0 - 0.9;
            compact::CompactPower::new(alpha).map_or(Ok(()), |power| of_profile(source, power))
        }
    }
}

fn of_profile<R: Real, P: PowerLawFriction<R>>(
    source: &mut Source,
    profile: P,
) -> Result<(), Broken> {
    let Ok(modes) = TerminalMotion::new(profile, source.positive()) else {
        return Ok(());
    };
    let ratio = source.size::<R>();
    let interval = modes.inertia_interval();
    holds(
        interval.0 <= interval.1,
        "an ordered interval",
        &[interval.0, interval.1],
    )?;
    finite(
        source,
        "growth",
        [modes.growth(ratio), modes.inertia_ratio_of(ratio)],
    )?;
    let found = modes.finite_fixed_point();
    if let Some(fixed) = found {
        holds(fixed >= R::ZERO, "a fixed point ≥ 0", &[fixed])?;
    }
    let _ = modes.fixed_points();
    if let TerminalMode::Together { ratio } = modes.terminal_mode(ratio) {
        holds(
            ratio >= R::ZERO || !source.is_mild(),
            "a final ratio ≥ 0",
            &[ratio],
        )?;
    }
    let _ = inertia_interval(source.number::<R>(), source.number());
    Ok(())
}

/// A slider launched, advanced and brought to rest.
pub fn sliders(source: &mut Source) -> Result<(), Broken> {
    match source.below(5) {
        0 => slid::<f64, _>(source, CoulombDisk),
        1 => slid_single(source),
        2 => slid::<f64, _>(source, CoulombHertz),
        3 => slid::<f64, _>(source, CoulombPunch),
        _ => slid::<f64, _>(source, CoulombRing),
    }
}

fn slid_single(source: &mut Source) -> Result<(), Broken> {
    slid::<f32, _>(source, CoulombDisk)
}

fn slid<R: Real, P: PowerLawFriction<R> + ReducedFriction<R>>(
    source: &mut Source,
    profile: P,
) -> Result<(), Broken> {
    let (deceleration, radius, inertia) =
        (source.positive::<R>(), source.positive(), source.positive());
    let Ok(slider) = Slider::new(
        profile,
        SliderParameters {
            deceleration,
            radius,
            inertia_ratio: inertia,
        },
    ) else {
        return Ok(());
    };
    let start = SliderState::launched(source.size(), source.number());
    let duration = source.size::<R>();
    let energy = |motion: &SliderState<R>| slider.energy_per_mass(motion);
    let power = slider.dissipation_per_mass(&start);
    finite(source, "dissipation", [power])?;
    holds(
        power >= R::ZERO || !source.is_mild(),
        "dissipation ≥ 0",
        &[power],
    )?;

    let next = slider.advance(&start, duration).motion;
    told(source, "advance", &next)?;
    if source.is_mild() {
        at_most(
            "energy falls",
            energy(&next),
            energy(&start),
            energy(&start),
        )?;
    }
    let verlet = slider.verlet_step(&start, duration);
    if duration > R::ZERO {
        told(source, "verlet", &verlet)?;
    }
    if let Some(rest) = slider.to_rest(&start) {
        told(source, "rest", &rest.motion)?;
        let still = rest.motion.is_at_rest();
        holds(
            still || !source.is_mild(),
            "rest is rest",
            &[rest.motion.speed, rest.motion.spin],
        )?;
    }
    Ok(())
}

fn told<R: Real>(source: &Source, what: &str, motion: &SliderState<R>) -> Result<(), Broken> {
    let all = [
        motion.time,
        motion.speed,
        motion.spin,
        motion.distance,
        motion.angle,
    ];
    finite(source, what, all)?;
    holds(
        motion.speed >= R::ZERO || !source.is_mild(),
        "speed ≥ 0",
        &all,
    )
}
