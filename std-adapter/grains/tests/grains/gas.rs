//! Tests of gases: laws of kinetic theory, conservation, collapse and its cure, the same bits.

use nalgebra::Vector3;
use tribos_base::run::{Simulation, run_to_end};
use tribos_contacts::event::{
    HardSpheres, Impact, Motion, Tangential, collision_rate, contact_value,
};
use tribos_grains::gas::*;
use tribos_grains::packing::PackingRunError;
use tribos_grains::scene::NormalForce;
use tribos_grains::scene::{GasMethod, GasScene};

type Tested = Result<(), Box<dyn std::error::Error>>;

fn finished(scene: &GasScene) -> Result<GasSimulation, PackingRunError> {
    let mut gas = GasSimulation::new(scene)?;
    run_to_end(&mut gas, |_, _| ())?;
    Ok(gas)
}

/// Where the spheres are, and how they move.
fn state(gas: &GasSimulation) -> (Vec<Vector3<f64>>, Vec<Motion>) {
    let state = gas.with_snapshot(|now| {
        let motions = now.velocities.unwrap().iter().zip(now.spins.unwrap());
        let motions = motions.map(|(&velocity, &spin)| Motion { velocity, spin });
        (now.positions.to_vec(), motions.collect())
    });
    state.unwrap()
}

fn small() -> GasScene {
    GasScene {
        count: 300,
        packing_fraction: 0.1,
        restitution: 0.9,
        collisions: 5.0,
        ..GasScene::default()
    }
}

#[test]
fn a_start_has_the_temperatures_asked_for_and_no_momentum() -> Tested {
    for (fraction, rotational) in [(0.01, 0.0), (0.3, 0.5), (0.55, 2.0)] {
        let scene = GasScene {
            count: 400,
            packing_fraction: fraction,
            rotational_temperature: rotational,
            ..small()
        };
        let first = GasSimulation::new(&scene)?.outcome();
        assert!((first.temperature - 1.0).abs() < 1e-12);
        assert!((first.temperature_rotational - rotational).abs() < 1e-12);
        assert!(first.momentum < 1e-12);
    }
    Ok(())
}

#[test]
fn the_energy_balance_of_a_gas_closes_and_its_momentum_stays() -> Tested {
    for (tangential, friction, method) in [
        (None, None, GasMethod::Events),
        (Some(0.5), None, GasMethod::Events),
        (Some(0.3), Some(0.4), GasMethod::Events),
        (None, None, GasMethod::ContactDynamics),
        (None, Some(0.3), GasMethod::ContactDynamics),
    ] {
        let scene = GasScene {
            tangential_restitution: tangential,
            mu: friction,
            method,
            rotational_temperature: 0.5,
            collisions: 2.0,
            ..small()
        };
        let end = finished(&scene)?.outcome();
        assert_eq!(end.ending, Some(GasStopReason::Collisions), "{scene:?}");
        let (before, after) = (end.energy_initial, end.energy_final);
        assert!(after < before);
        assert!(
            (before - after - end.energy_lost).abs() < 1e-9,
            "{scene:?} {end:?}"
        );
        assert!(end.momentum < 1e-9, "{end:?}");
        assert_eq!(end.steps_unmet, 0);
    }
    Ok(())
}

/// The law in collisions, over the mean of some starts. Correlations that theory neglects cool a little
/// faster; the scatter of one start at N = 1000 is 0.4 %.
#[test]
fn a_dilute_gas_cools_by_haffs_law() -> Tested {
    const STARTS: u64 = 6;
    for (e, collisions) in [(0.95, 10.0), (0.8, 4.0)] {
        let mut mean = 0.0;
        for seed in 1..=STARTS {
            let scene = GasScene {
                count: 1000,
                packing_fraction: 0.01,
                restitution: e,
                collisions,
                sample_every: collisions,
                seed,
                ..GasScene::default()
            };
            mean += finished(&scene)?.outcome().temperature / STARTS as f64;
        }
        let law = libm::exp(-(1.0 - e * e) * collisions / 3.0);
        assert!((mean / law - 1.0).abs() < 0.015, "{e}: {mean} {law}");
    }
    Ok(())
}

#[test]
fn rough_spheres_follow_the_mean_field_of_both_temperatures() -> Tested {
    for (tangential, friction) in [(Some(0.5), None), (Some(0.2), Some(0.3))] {
        let scene = GasScene {
            count: 2000,
            packing_fraction: 0.02,
            restitution: 0.95,
            tangential_restitution: tangential,
            mu: friction,
            rotational_temperature: 0.3,
            collisions: 4.0,
            ..GasScene::default()
        };
        let end = finished(&scene)?.outcome();
        assert!((end.temperature / end.theory - 1.0).abs() < 0.03, "{end:?}");
        let rotational = end.temperature_rotational / end.theory_rotational;
        assert!((rotational - 1.0).abs() < 0.04, "{end:?}");
    }
    Ok(())
}

/// Pressure and collision rate of the elastic fluid against Carnahan and Starling's equation of state,
/// Z = (1 + φ + φ² − φ³)/(1 − φ)³, which is 1 + 4 φ g.
#[test]
fn an_elastic_gas_has_the_pressure_and_the_collision_rate_of_carnahan_and_starling() -> Tested {
    for fraction in [0.05, 0.2, 0.4] {
        let scene = GasScene {
            count: 1000,
            packing_fraction: fraction,
            mixing_collisions: 50.0,
            ..GasScene::default()
        };
        let started = GasSimulation::new(&scene)?;
        let (places, motions) = state(&started);
        let bodies: Vec<_> = places.into_iter().zip(motions).collect();
        let law = Impact::new(1.0, Tangential::Smooth)?;
        let mut gas = HardSpheres::new(started.length(), &bodies, law, 0.0)?;
        gas.advance(100_000, f64::INFINITY);
        let rate = 2.0 * gas.collisions() as f64 / 1000.0 / gas.time();
        assert!(
            (rate / collision_rate(fraction, 1.0) - 1.0).abs() < 0.015,
            "{rate}"
        );
        let z = 1.0 + gas.virial() / (3.0 * 1000.0 * gas.time());
        let free = 1.0 - fraction;
        let cubes = fraction * fraction * (1.0 - fraction);
        let state = (1.0 + fraction + cubes) / (free * free * free);
        assert!((z / state - 1.0).abs() < 0.015, "{fraction}: {z} {state}");
        assert!((1.0 + 4.0 * fraction * contact_value(fraction) - state).abs() < 1e-12);
    }
    Ok(())
}

#[test]
fn a_dense_gas_collapses_and_a_contact_time_prevents_it() -> Tested {
    let dense = GasScene {
        count: 1000,
        packing_fraction: 0.5,
        restitution: 0.2,
        collisions: 200.0,
        ..GasScene::default()
    };
    let stuck = finished(&dense)?.outcome();
    assert_eq!(stuck.ending, Some(GasStopReason::Collapse), "{stuck:?}");
    let cured = GasScene {
        contact_time: 1e-4,
        ..dense
    };
    let through = finished(&cured)?.outcome();
    assert_eq!(
        through.ending,
        Some(GasStopReason::Collisions),
        "{through:?}"
    );
    assert!(through.collisions_cured > 0 && through.time > 2.0 * stuck.time);
    Ok(())
}

#[test]
fn dissipation_makes_clusters() -> Tested {
    let scene = GasScene {
        count: 2000,
        packing_fraction: 0.2,
        restitution: 0.6,
        contact_time: 1e-5,
        collisions: 100.0,
        sample_every: 10.0,
        ..GasScene::default()
    };
    let end = finished(&scene)?.outcome();
    let (before, after) = (end.density_variance_initial, end.density_variance_final);
    assert!(before < 0.6 && after > 2.0 * before, "{before} {after}");
    Ok(())
}

#[test]
fn a_resumed_gas_ends_with_the_same_bits() -> Tested {
    for method in [
        GasMethod::Events,
        GasMethod::ContactDynamics,
        GasMethod::Soft,
    ] {
        let scene = GasScene {
            mu: Some(0.3),
            method,
            collisions: 2.0,
            ..small()
        };
        let whole = finished(&scene)?;
        let mut first = GasSimulation::new(&scene)?;
        while first.steps() < whole.steps() / 2 {
            assert!(first.step()?);
        }
        let mut second = GasSimulation::resume(&scene, &first.checkpoint())?;
        run_to_end(&mut second, |_, _| ())?;
        assert_eq!(whole.series(), second.series());
        assert_eq!(state(&whole), state(&second));
        // The end is the end.
        let mut again = GasSimulation::resume(&scene, &whole.checkpoint())?;
        assert!(!again.step()?);
        assert_eq!(again.series(), whole.series());
    }
    Ok(())
}

#[test]
fn checkpoints_of_other_gases_and_damaged_ones_are_refused() -> Tested {
    let here = small();
    let kept = GasSimulation::new(&here)?.checkpoint();
    let refusal = |scene: &GasScene, text: &str| {
        let told = GasSimulation::resume(scene, text).map(|_| ());
        told.map_or_else(|error| error.to_string(), |()| "accepted".into())
    };
    assert_eq!(refusal(&here, &kept), "accepted");
    let other = GasScene {
        restitution: 0.8,
        ..here.clone()
    };
    assert!(refusal(&other, &kept).contains("`restitution` is 0.9"));
    assert!(refusal(&here, &kept.replace("tribos_gas", "tribos_gaz")).contains("digest"));
    Ok(())
}

#[test]
fn impossible_gases_are_refused_before_work() {
    let refusal = |scene: GasScene| match GasSimulation::new(&scene) {
        Err(PackingRunError::Scene(error)) => error.to_string(),
        other => format!("{other:?}"),
    };
    let few = GasScene {
        count: 10,
        packing_fraction: 0.5,
        ..GasScene::default()
    };
    assert!(refusal(few).contains("6 R"));
    let rough = GasScene {
        tangential_restitution: Some(0.5),
        method: GasMethod::ContactDynamics,
        ..GasScene::default()
    };
    for method in [GasMethod::ContactDynamics, GasMethod::Soft] {
        let rough = GasScene {
            method,
            ..rough.clone()
        };
        assert!(refusal(rough).contains("no tangential restitution"));
    }
    let dead = GasScene {
        restitution: 0.0,
        method: GasMethod::Soft,
        ..GasScene::default()
    };
    assert!(refusal(dead).contains("`restitution` must be above 0"));
    let fine = GasScene {
        sample_every: 1e-9,
        ..GasScene::default()
    };
    assert!(refusal(fine).contains("`sample_every`"));
}

#[test]
fn contact_dynamics_cools_like_events() -> Tested {
    let scene = |method| GasScene {
        count: 500,
        packing_fraction: 0.1,
        restitution: 0.9,
        collisions: 4.0,
        sample_every: 4.0,
        method,
        ..GasScene::default()
    };
    let [events, steps] = [GasMethod::Events, GasMethod::ContactDynamics]
        .map(|method| finished(&scene(method)).map(|gas| gas.outcome().temperature));
    let (events, steps) = (events?, steps?);
    // One start, N = 500: the scatter is 1 %.
    assert!((events / steps - 1.0).abs() < 0.04, "{events} {steps}");
    Ok(())
}

/// Soft spheres, mean of six starts of 500: a standard error of 0.4 %. Stiff springs, so that a collision takes
/// 1 % of the time between two; Hertz's restitution does not depend on the speed.
#[test]
fn a_dilute_gas_of_soft_spheres_cools_by_haffs_law() -> Tested {
    const STARTS: u64 = 6;
    for (restitution, normal_law, stiffness) in [
        (0.9, NormalForce::Linear, 1e4),
        (0.6, NormalForce::Linear, 2e4),
        (0.9, NormalForce::Hertz, 1e5),
    ] {
        let collisions = 1.0 / (1.0 - restitution * restitution);
        let mut mean = 0.0;
        for seed in 1..=STARTS {
            let scene = GasScene {
                count: 500,
                packing_fraction: 0.05,
                restitution,
                collisions,
                sample_every: collisions,
                seed,
                method: GasMethod::Soft,
                normal_law,
                stiffness,
                ..GasScene::default()
            };
            mean += finished(&scene)?.outcome().temperature / STARTS as f64;
        }
        let law = libm::exp(-1.0 / 3.0);
        assert!(
            (mean / law - 1.0).abs() < 0.015,
            "{restitution} {normal_law}: {mean} {law}"
        );
    }
    Ok(())
}

#[test]
fn soft_spheres_keep_their_momentum_and_lose_what_springs_do_not_hold() -> Tested {
    for friction in [None, Some(0.3)] {
        let scene = GasScene {
            mu: friction,
            rotational_temperature: 0.5,
            collisions: 2.0,
            method: GasMethod::Soft,
            ..small()
        };
        let end = finished(&scene)?.outcome();
        let (before, after) = (end.energy_initial, end.energy_final);
        // Contacts that are open hold the rest: a collision lasts 1 % of the time between two.
        assert!(end.momentum < 1e-9, "{end:?}");
        assert!(
            (before - after - end.energy_lost).abs() < 0.03 * end.energy_lost,
            "{end:?}"
        );
        // Friction, and only friction, turns spheres.
        let turned = (end.temperature_rotational - 0.5).abs();
        assert_eq!(friction.is_some(), turned > 1e-3);
    }
    Ok(())
}

#[test]
fn collisions_of_soft_spheres_are_as_frequent_as_events() -> Tested {
    let scene = |method| GasScene {
        packing_fraction: 0.1,
        restitution: 1.0,
        collisions: 1e3,
        duration: Some(10.0),
        method,
        ..small()
    };
    let [events, soft] = [GasMethod::Events, GasMethod::Soft]
        .map(|method| finished(&scene(method)).map(|gas| gas.outcome()));
    let (events, soft) = (events?, soft?);
    // 1,500 collisions each: a scatter of 4 %, and one of 2 % if neighbours alternate.
    assert!((soft.collisions / events.collisions - 1.0).abs() < 0.08);
    assert!(
        (soft.temperature - 1.0).abs() < 0.01,
        "{}",
        soft.temperature
    );
    Ok(())
}

#[test]
fn soft_spheres_have_the_same_bits_on_any_number_of_threads() -> Tested {
    let scene = GasScene {
        count: 1500,
        packing_fraction: 0.4,
        collisions: 0.3,
        mixing_collisions: 2.0,
        mu: Some(0.3),
        method: GasMethod::Soft,
        ..GasScene::default()
    };
    let on = |threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
        let ended = || finished(&scene).map(|gas| (gas.series().to_vec(), state(&gas)));
        pool.map(|pool| pool.install(ended))
    };
    assert_eq!(on(1)??, on(3)??);
    Ok(())
}

#[test]
fn the_step_of_soft_spheres_is_foreseen() -> Tested {
    for (normal_law, stiffness) in [(NormalForce::Linear, 1e4), (NormalForce::Hertz, 1e5)] {
        let scene = GasScene {
            count: 3000,
            normal_law,
            stiffness,
            method: GasMethod::Soft,
            ..small()
        };
        let foreseen = soft_collision(&scene).ok_or("no springs")?.step;
        let mut gas = GasSimulation::new(&scene)?;
        gas.step()?;
        let ratio = gas.time() / foreseen;
        assert!((ratio - 1.0).abs() < 0.1, "{normal_law}: {ratio}");
    }
    Ok(())
}
