//! Boxes without walls that are sheared, and grains of two materials.

use tribos_base::record::extended_xyz;
use tribos_base::run::{Simulation, run_to_end};
use tribos_grains::grains::{COLUMNS, GrainsSimulation};
use tribos_grains::scene::{ContactMethod, EndBoundary, GrainsScene, SideBoundary};

type Answer = Result<(), Box<dyn std::error::Error>>;

/// 64 beads in a box that repeats, sheared at a rate.
fn sheared(rate: f64) -> GrainsScene {
    GrainsScene {
        width: 4.0 * 0.0112,
        height: Some(4.0 * 0.0112),
        radius_spread: 0.1,
        boundary_z: EndBoundary::Periodic,
        count: 64,
        initial_spacing: 1.01,
        gravity: 0.0.into(),
        shear_rate: Some(rate),
        restitution: 0.3,
        duration: 0.3,
        sample_every: 10,
        ..GrainsScene::default()
    }
}

fn last(grains: &GrainsSimulation, name: &str) -> f64 {
    let column = COLUMNS.iter().position(|column| *column == name);
    column.map_or(f64::NAN, |column| grains.record()[column])
}

#[test]
fn a_sheared_box_resists_with_stress_and_viscosity_of_one_sign() -> Answer {
    for rate in [10.0, -10.0] {
        let mut grains = GrainsSimulation::new(&sheared(rate))?;
        run_to_end(&mut grains, |_, _| ())?;
        assert_eq!(last(&grains, "shear_rate"), rate);
        // Mean over the second half of the run: a single step may have no contacts.
        let rows = grains.series();
        let mean = |name: &str| {
            let column = COLUMNS.iter().position(|column| *column == name);
            let later = rows.iter().skip(rows.len() / 2);
            later.map(|row| row[column.unwrap_or(0)]).sum::<f64>()
        };
        assert!(mean("shear_stress") * rate > 0.0);
        assert!(mean("viscosity") > 0.0);
        assert!((mean("viscosity") * rate / mean("shear_stress") - 1.0).abs() < 1e-12);
        assert!(mean("stress_zz") > 0.0);
        let book = grains.outcome().energy;
        assert!(book.work > 0.0, "{book:?}");
        assert!(book.imbalance.abs() < 1e-9 * book.work, "{book:?}");
    }
    Ok(())
}

#[test]
fn a_sheared_run_goes_on_from_its_checkpoint_with_the_same_bits() -> Answer {
    let scene = sheared(15.0);
    let mut whole = GrainsSimulation::new(&scene)?;
    for _ in 0..60 {
        whole.step()?;
    }
    let mut again = GrainsSimulation::resume(&scene, &whole.checkpoint())?;
    for _ in 0..60 {
        whole.step()?;
        again.step()?;
    }
    assert_eq!(again.record(), whole.record());
    assert_eq!(again.contacts(), whole.contacts());
    Ok(())
}

#[test]
fn exports_tell_how_far_a_sheared_box_leans() -> Answer {
    let mut grains = GrainsSimulation::new(&sheared(10.0))?;
    for _ in 0..20 {
        grains.step()?;
    }
    let frame = grains.with_snapshot(extended_xyz)?;
    let lattice = frame.split('"').nth(1).unwrap_or_default();
    let vectors: Result<Vec<f64>, _> = lattice.split(' ').map(str::parse).collect();
    let vectors = vectors?;
    // Speed of the images times the time, in a box of one width and height.
    let side = vectors[0];
    let offset = (10.0 * side * grains.time()).rem_euclid(side);
    assert!((vectors[6] - offset).abs() < 1e-9 && offset > 0.0);
    assert_eq!(vectors[8], side);
    Ok(())
}

#[test]
fn shears_of_boxes_with_walls_across_are_refused() {
    for scene in [
        GrainsScene {
            boundary_x: SideBoundary::Walls,
            ..sheared(1.0)
        },
        GrainsScene {
            shear_rate: Some(f64::NAN),
            ..sheared(1.0)
        },
        GrainsScene {
            shear_rate: Some(1.0),
            ..GrainsScene::default()
        },
    ] {
        assert!(GrainsSimulation::new(&scene).is_err());
    }
    let beside = GrainsScene {
        boundary_y: SideBoundary::Walls,
        ..sheared(1.0)
    };
    assert!(GrainsSimulation::new(&beside).is_ok());
}

/// Grains that fall on a floor, of two materials.
fn mixed(share: f64) -> GrainsScene {
    GrainsScene {
        width: 0.05,
        count: 50,
        second_fraction: share,
        duration: 0.2,
        ..GrainsScene::default()
    }
}

#[test]
fn so_many_grains_are_of_the_second_material() -> Answer {
    let scene = GrainsScene {
        second_radius: 0.5,
        second_density: Some(1000.0),
        ..mixed(0.3)
    };
    let grains = GrainsSimulation::new(&scene)?;
    let masses = grains.with_snapshot(|now| {
        assert_eq!(now.radii.iter().filter(|r| **r == 0.0025).count(), 15);
        assert_eq!(now.radii.iter().filter(|r| **r == 0.005).count(), 35);
        let mass = |(radius, density): (&f64, &f64)| {
            let wanted = if *radius == 0.005 { 2500.0 } else { 1000.0 };
            assert_eq!(*density, wanted);
            4.0 / 3.0 * std::f64::consts::PI * radius * radius * radius * density
        };
        let grains = now.radii.iter().zip(now.densities.unwrap_or_default());
        grains.map(mass).sum::<f64>()
    });
    // As heavy together as their materials make them: 15 of the one, 35 of the other.
    assert!((grains.outcome().mass / masses - 1.0).abs() < 1e-12);
    Ok(())
}

#[test]
fn grains_all_of_the_second_material_run_as_grains_of_it_alone() -> Answer {
    let second = GrainsScene {
        mu_second: Some(0.2),
        second_density: Some(4000.0),
        ..mixed(1.0)
    };
    let alone = GrainsScene {
        mu: 0.2,
        density: 4000.0,
        ..mixed(0.0)
    };
    let soft = |scene: &GrainsScene| GrainsScene {
        method: ContactMethod::Soft,
        ..scene.clone()
    };
    let springs = [soft(&second), soft(&alone)];
    let runs = [second, alone].into_iter().chain(springs).map(
        |scene| -> Result<_, tribos_grains::packing::PackingRunError> {
            let mut grains = GrainsSimulation::new(&scene)?;
            run_to_end(&mut grains, |_, _| ())?;
            Ok(grains.series().to_vec())
        },
    );
    let runs = runs.collect::<Result<Vec<_>, _>>()?;
    assert_eq!(runs[0], runs[1]);
    assert_eq!(runs[2], runs[3]);
    Ok(())
}

/// The same beads on springs, without friction, in a box whose height follows a stress.
fn pressed(rate: f64, stress: f64) -> GrainsScene {
    GrainsScene {
        method: ContactMethod::Soft,
        stiffness: 1e4,
        mu: 0.0,
        restitution: 0.0,
        wall_stress_z: Some(stress.into()),
        duration: 1.5,
        ..sheared(rate)
    }
}

#[test]
fn a_box_keeps_its_stress_while_it_is_sheared() -> Answer {
    let stress = 400.0; // Pa
    for scene in [pressed(4.0, stress), rigid(4.0, stress)] {
        keeps(stress, &scene)?;
    }
    Ok(())
}

fn keeps(stress: f64, scene: &GrainsScene) -> Answer {
    let mut grains = GrainsSimulation::new(scene)?;
    run_to_end(&mut grains, |_, _| ())?;
    let rows = grains.series();
    let mean = |name: &str| {
        let column = COLUMNS
            .iter()
            .position(|column| *column == name)
            .unwrap_or(0);
        let later = &rows[rows.len() / 2..];
        later.iter().map(|row| row[column]).sum::<f64>() / later.len() as f64
    };
    // Impulses of the motion carry a little of it.
    assert!(
        (mean("stress_zz") / stress - 1.0).abs() < 0.05,
        "{}",
        mean("stress_zz")
    );
    assert!(mean("shear_stress") > 0.0 && mean("stress_ratio") < 0.4);
    // Random loose packing and closest packing bound a flow of frictionless spheres.
    assert!(
        (0.5..0.7).contains(&mean("solid_fraction")),
        "{}",
        mean("solid_fraction")
    );
    Ok(())
}

/// The same of rigid grains.
fn rigid(rate: f64, stress: f64) -> GrainsScene {
    GrainsScene {
        method: ContactMethod::ContactDynamics,
        max_time_step: Some(2e-3),
        max_displacement: 0.02,
        ..pressed(rate, stress)
    }
}

#[test]
fn a_box_that_deforms_goes_on_from_its_checkpoint_with_the_same_bits() -> Answer {
    for scene in [pressed(4.0, 400.0), rigid(4.0, 400.0)] {
        goes_on(&GrainsScene {
            duration: 0.1,
            wall_velocity_x: Some((-0.02).into()),
            ..scene
        })?;
    }
    Ok(())
}

fn goes_on(scene: &GrainsScene) -> Answer {
    let mut whole = GrainsSimulation::new(scene)?;
    let mut kept = None;
    while whole.ending().is_none() {
        whole.step()?;
        if whole.steps() == 20 {
            kept = Some(whole.checkpoint());
        }
    }
    let mut rest = GrainsSimulation::begin(scene, kept.as_deref(), |_| {
        std::ops::ControlFlow::Continue(())
    })?;
    run_to_end(&mut rest, |_, _| ())?;
    assert_eq!(whole.record(), rest.record());
    assert_eq!(whole.contacts(), rest.contacts());
    assert!((last(&whole, "width") - (4.0 * 0.0112 - 0.02 * whole.time())).abs() < 1e-12);
    Ok(())
}

#[test]
fn a_box_without_contacts_carries_its_grains_with_its_strain() -> Answer {
    // Neighbours stay apart while the box grows along y and z.
    let scene = GrainsScene {
        wall_velocity_y: Some(0.05.into()),
        wall_velocity_z: Some(0.1.into()),
        wall_stress_z: None,
        shear_rate: None,
        radius_spread: 0.0,
        initial_spacing: 1.1,
        width: 4.0 * 0.0125,
        height: Some(4.0 * 0.0125),
        duration: 0.2,
        ..pressed(0.0, 0.0)
    };
    let mut grains = GrainsSimulation::new(&scene)?;
    let [before, mut after] = [(); 2].map(|()| Vec::new());
    let mut places = before;
    grains.with_snapshot(|state| places.extend_from_slice(state.positions));
    run_to_end(&mut grains, |_, _| ())?;
    grains.with_snapshot(|state| after.extend_from_slice(state.positions));
    let grown = [0.0, 0.05, 0.1].map(|speed| 1.0 + speed * grains.time() / (4.0 * 0.0125));
    for (x, y) in places.iter().zip(&after) {
        for axis in 0..3 {
            assert!((x[axis] * grown[axis] - y[axis]).abs() < 1e-12, "{x} {y}");
        }
    }
    assert_eq!(last(&grains, "contacts"), 0.0);
    Ok(())
}

#[test]
fn what_cannot_deform_is_refused() {
    let rigid = GrainsScene {
        restitution: 0.5,
        ..rigid(4.0, 400.0)
    };
    for (scene, word) in [
        (rigid, "restitution = 0"),
        (
            GrainsScene {
                boundary_z: EndBoundary::Floor,
                shear_rate: None,
                ..pressed(4.0, 1.0)
            },
            "above a floor",
        ),
    ] {
        let refusal = GrainsSimulation::new(&scene)
            .map(|_| ())
            .unwrap_err()
            .to_string();
        assert!(refusal.contains(word), "{refusal}");
    }
}
