//! Tests of gases: laws of kinetic theory, conservation, collapse and its cure, the same bits.

use super::*;
use crate::event::{HardSpheres, Impact, Tangential, collision_rate, contact_value};
use crate::run::{Simulation, drive};
use crate::scene::{GasMethod, GasScene};
use std::ops::ControlFlow;

type Tested = Result<(), Box<dyn std::error::Error>>;

fn finished(scene: &GasScene) -> Result<Gas, GasError> {
    let mut gas = Gas::new(scene)?;
    drive(&mut gas, |_, _| ())?;
    Ok(gas)
}

fn small() -> GasScene {
    GasScene {
        count: 300,
        fraction: 0.1,
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
            fraction,
            rotational,
            ..small()
        };
        let first = Gas::new(&scene)?.record();
        assert!((first[run::TRANSLATIONAL] - 1.0).abs() < 1e-12);
        assert!((first[run::ROTATIONAL] - rotational).abs() < 1e-12);
        assert!(first[run::MOMENTUM] < 1e-12);
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
            tangential,
            friction,
            method,
            rotational: 0.5,
            collisions: 2.0,
            ..small()
        };
        let end = finished(&scene)?.outcome();
        assert_eq!(end.ending, Some(Ending::Collisions), "{scene:?}");
        let [before, after] = end.energy;
        assert!(after < before);
        assert!(
            (before - after - end.lost).abs() < 1e-9,
            "{scene:?} {end:?}"
        );
        assert!(end.momentum < 1e-9, "{end:?}");
        assert_eq!(end.unmet, 0);
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
                fraction: 0.01,
                restitution: e,
                collisions,
                sample: collisions,
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
            fraction: 0.02,
            restitution: 0.95,
            tangential,
            friction,
            rotational: 0.3,
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
            fraction,
            mixing: 50.0,
            ..GasScene::default()
        };
        let bodies = start::start(&scene, &mut |_| ControlFlow::Continue(()))?;
        let law = Impact::new(1.0, Tangential::Smooth)?;
        let mut gas = HardSpheres::new(edge(1000, fraction), &bodies, law, 0.0)?;
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
        fraction: 0.5,
        restitution: 0.2,
        collisions: 200.0,
        ..GasScene::default()
    };
    let stuck = finished(&dense)?.outcome();
    assert_eq!(stuck.ending, Some(Ending::Collapse), "{stuck:?}");
    let cured = GasScene {
        contact_time: 1e-4,
        ..dense
    };
    let through = finished(&cured)?.outcome();
    assert_eq!(through.ending, Some(Ending::Collisions), "{through:?}");
    assert!(through.cured > 0 && through.time > 2.0 * stuck.time);
    Ok(())
}

#[test]
fn dissipation_makes_clusters() -> Tested {
    let scene = GasScene {
        count: 2000,
        fraction: 0.2,
        restitution: 0.6,
        contact_time: 1e-5,
        collisions: 100.0,
        sample: 10.0,
        ..GasScene::default()
    };
    let [before, after] = finished(&scene)?.outcome().density_variance;
    assert!(before < 0.6 && after > 2.0 * before, "{before} {after}");
    Ok(())
}

#[test]
fn a_resumed_gas_ends_with_the_same_bits() -> Tested {
    for method in [GasMethod::Events, GasMethod::ContactDynamics] {
        let scene = GasScene {
            friction: Some(0.3),
            method,
            collisions: 2.0,
            ..small()
        };
        let whole = finished(&scene)?;
        let mut first = Gas::new(&scene)?;
        while first.steps() < whole.steps() / 2 {
            assert!(first.step()?);
        }
        let mut second = Gas::resume(&scene, &first.checkpoint())?;
        drive(&mut second, |_, _| ())?;
        assert_eq!(whole.series(), second.series());
        assert_eq!(whole.state(), second.state());
        // The end is the end.
        let mut again = Gas::resume(&scene, &whole.checkpoint())?;
        assert!(!again.step()?);
        assert_eq!(again.series(), whole.series());
    }
    Ok(())
}

#[test]
fn checkpoints_of_other_gases_and_damaged_ones_are_refused() -> Tested {
    let here = small();
    let kept = Gas::new(&here)?.checkpoint();
    let refusal = |scene: &GasScene, text: &str| {
        let told = Gas::resume(scene, text).map(|_| ());
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
    let refusal = |scene: GasScene| match Gas::new(&scene) {
        Err(GasError::Scene(error)) => error.to_string(),
        other => format!("{other:?}"),
    };
    let few = GasScene {
        count: 10,
        fraction: 0.5,
        ..GasScene::default()
    };
    assert!(refusal(few).contains("6 R"));
    let rough = GasScene {
        tangential: Some(0.5),
        method: GasMethod::ContactDynamics,
        ..GasScene::default()
    };
    assert!(refusal(rough).contains("no tangential restitution"));
    let fine = GasScene {
        sample: 1e-9,
        ..GasScene::default()
    };
    assert!(refusal(fine).contains("`sample`"));
}

#[test]
fn contact_dynamics_cools_like_events() -> Tested {
    let scene = |method| GasScene {
        count: 500,
        fraction: 0.1,
        restitution: 0.9,
        collisions: 4.0,
        sample: 4.0,
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
