//! A flat disk under any law of the local speed.

use super::outcome::terminal;
use super::planar::{Gradient, Launch, PlanarSimulation, PlanarState, Resistance, TallBody};
use super::simulation::{MOST_STEPS, SLIVER};
use super::{
    COLUMNS, MotionError, SlideRun, SlideStopReason, SlideSummary, energy_at_launch, follow,
};
use crate::motion_run::SceneRun;
use crate::slide::scene::{DiskScene, SliderIntegrator};
use tribos_core::modes::TerminalMotion;
use tribos_friction::{AnyFriction, Law, Patch};

/// Runs a scene to its end under `law`, which replaces the scene's `gamma` and `alpha`.
///
/// For a power of the speed this is [`follow`]. Under any other law the motion is integrated over the logarithm
/// of the speed, like that of a body in the plane ([`PlanarSimulation`]).
pub(super) fn run_law(
    scene: &DiskScene,
    law: &Law,
    mut progress: impl FnMut(f64),
) -> Result<SlideRun, MotionError> {
    if let Some([coefficient, alpha]) = law.power_of_speed() {
        let scene = DiskScene {
            gamma: coefficient,
            alpha,
            law: None,
            ..*scene
        };
        return follow(&scene, progress);
    }
    scene.check()?;
    if scene.integrator == SliderIntegrator::Verlet {
        return Err(MotionError::OnlyPowers { law: law.name() });
    }
    let friction = AnyFriction::new(&Patch::Disk, law, None)?.with_radius(scene.radius)?;
    let upright = [scene.gravity, scene.inertia_ratio];
    let body = TallBody::new(friction, 0.0, Gradient::AllRound, upright)?;
    let launch = Launch {
        velocity: [scene.speed, 0.0],
        spin: scene.spin,
    };
    let journey = || PlanarSimulation::new(&body, &launch, scene.stop_fraction);
    let energy = |point: &PlanarState| scene.mass * super::path::energy_per_mass(&body, point);

    // A first pass finds the end and thus the length of a sample.
    let scouted = journey()?.to_end()?.point.time;
    let end = scene
        .duration
        .map_or(scouted, |duration| duration.min(scouted));
    let times = sample_times(scene, end)?;
    let mut points: Vec<PlanarState> = Vec::new();
    let arrival = journey()?.follow(&times, |point| {
        // Sample times are met to 2 ulp.
        if point.time <= end * (1.0 + SLIVER) {
            points.push(*point);
            progress((point.time / end).clamp(0.0, 1.0));
        }
    })?;
    let (Some(first), Some(last)) = (points.first(), points.last()) else {
        return Err(MotionError::NotFinite { step: 0 });
    };
    let initial_energy = energy_at_launch(energy(first))?;
    let dissipated = scene.mass * last.work;
    let lost = initial_energy - energy(last);
    // Towards rest the law tends to a power of the speed, whose fixed points give the limit of the ratio.
    let near_rest = Law::power(1.0, body.exponent())?;
    let near_rest = AnyFriction::<f64>::new(&Patch::Disk, &near_rest, None)?;
    let profile = near_rest
        .power()
        .ok_or(MotionError::NotFinite { step: 0 })?;
    let ending = match (arrival.ending, scene.duration) {
        (_, Some(duration)) if duration < scouted => SlideStopReason::Duration,
        (ending, _) => ending,
    };
    let limit = TerminalMotion::new(profile, scene.inertia_ratio)?.terminal_mode(last.ratio);
    let (limit_ratio, final_mode) = terminal(limit);
    Ok(SceneRun {
        columns: &COLUMNS,
        rows: points
            .iter()
            .map(|point| row(point, energy(point), scene.mass))
            .collect(),
        outcome: SlideSummary {
            ending,
            stop_time: (ending == SlideStopReason::Rest).then_some(last.time),
            end_time: last.time,
            distance: last.distance,
            angle: last.angle,
            final_ratio: last.ratio,
            limit_ratio,
            final_mode,
            steps: points.len() as u64 - 1,
            initial_energy,
            energy_dissipated: dissipated,
            energy_error: (dissipated - lost).abs() / initial_energy,
        },
    })
}

/// Times of the samples up to and including `end`.
fn sample_times(scene: &DiskScene, end: f64) -> Result<Vec<f64>, MotionError> {
    let interval = scene.time_step.unwrap_or(end / f64::from(scene.samples));
    let steps = end / interval;
    if steps > MOST_STEPS {
        return Err(MotionError::TooManySteps {
            time_step: interval,
            steps,
            most: MOST_STEPS,
            at_least: end / MOST_STEPS,
        });
    }
    let all = (1..=steps.ceil() as u64).map(|k| interval * k as f64);
    let mut times: Vec<f64> = all.filter(|time| *time < end * (1.0 - SLIVER)).collect();
    times.push(end);
    Ok(times)
}

fn row(point: &PlanarState, kinetic: f64, mass: f64) -> [f64; COLUMNS.len()] {
    [
        point.time,
        point.velocity[0],
        point.spin,
        point.distance,
        point.angle,
        point.ratio,
        kinetic,
        mass * point.work,
    ]
}
