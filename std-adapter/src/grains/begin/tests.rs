use crate::grains::Grains;
use crate::measure::{Assembly, Measures, Options};
use crate::record::extended_xyz;
use crate::run::Simulation;
use crate::scene::{ContactMethod, Container, GrainsScene, Sides, Sizes};
use nalgebra::Vector3;

type Tested = Result<(), Box<dyn std::error::Error>>;

fn scene() -> GrainsScene {
    GrainsScene {
        width: 0.06,
        count: 30,
        torsion: 0.1,
        duration: 10.0,
        ..GrainsScene::default()
    }
}

fn after(scene: &GrainsScene, steps: usize) -> Result<Grains, Box<dyn std::error::Error>> {
    let mut run = Grains::new(scene)?;
    for _ in 0..steps {
        run.step()?;
    }
    Ok(run)
}

fn motion(run: &Grains) -> Vec<[Vector3<f64>; 3]> {
    run.with_snapshot(|now| {
        let velocities = now.velocities.unwrap_or_default().iter();
        let both = velocities
            .zip(now.spins.unwrap_or_default())
            .zip(now.positions);
        both.map(|((velocity, spin), place)| [*place, *velocity, *spin])
            .collect()
    })
}

#[test]
fn grains_go_on_from_a_state_or_a_checkpoint_to_the_bit() -> Tested {
    let home = tempfile::tempdir()?;
    for sides in [Sides::Periodic, Sides::Walls] {
        let scene = GrainsScene {
            x: sides,
            ..scene()
        };
        let mut whole = after(&scene, 300)?;
        for (name, text) in [("a.json", whole.state()), ("b.json", whole.checkpoint())] {
            std::fs::write(home.path().join(name), text)?;
        }
        let from = |name: &str| GrainsScene {
            start: Some(home.path().join(name)),
            ..scene.clone()
        };
        let mut parts = [Grains::new(&from("a.json"))?, Grains::new(&from("b.json"))?];
        for _ in 0..10 {
            whole.step()?;
            for part in &mut parts {
                part.step()?;
                assert_eq!(motion(part), motion(&whole));
            }
        }
        assert_eq!(parts[0].steps(), 10);
    }
    Ok(())
}

#[test]
fn a_measured_state_weighs_on_its_floor() -> Tested {
    let run = after(&scene(), 3000)?;
    let state = Assembly::parse("state", &run.state())?;
    let found = Measures::of(state, &Options::default())?;
    // The weight passes through every height of the packing: at its floor it is that of all grains.
    let weight = run.outcome().mass * 9.81;
    let at_floor = found
        .assembly
        .contacts
        .iter()
        .filter(|row| row.b.particle().is_none());
    let floor: f64 = at_floor.map(|row| -row.force.z).sum();
    assert!((floor / weight - 1.0).abs() < 0.02, "{floor} {weight}");
    assert!(found.stress.is_some_and(|stress| stress.total().m33 > 0.0));
    Ok(())
}

#[test]
fn grains_of_a_file_lie_on_the_floor_and_inside_the_walls() -> Tested {
    let home = tempfile::tempdir()?;
    let run = after(&scene(), 300)?;
    let file = home.path().join("a.xyz");
    std::fs::write(&file, run.with_snapshot(extended_xyz)?)?;
    let start = Some(file.clone());
    let other = Grains::new(&GrainsScene {
        start: start.clone(),
        ..scene()
    })?;
    let lowest = other.with_snapshot(|now| {
        let spheres = now.positions.iter().zip(now.radii);
        spheres
            .map(|(place, radius)| place.z - radius)
            .fold(f64::INFINITY, f64::min)
    });
    assert!(lowest.abs() < 1e-15);
    for (was, is) in motion(&run).iter().zip(motion(&other)) {
        assert_eq!([was[1], was[2]], [is[1], is[2]]);
    }
    let refusal = |scene: GrainsScene| {
        Grains::new(&scene).map_or_else(|error| error.to_string(), |_| "taken".into())
    };
    let wide = refusal(GrainsScene {
        start: start.clone(),
        width: 0.07,
        ..scene()
    });
    assert!(
        wide.contains("its period along x is 0.06, and `width` is 0.07; set width = 0.06"),
        "{wide}"
    );
    let fine = refusal(GrainsScene {
        start,
        radius: 5.0,
        ..scene()
    });
    assert!(fine.contains("multiply all lengths by"), "{fine}");
    Ok(())
}

#[test]
fn grains_of_a_file_stay_where_they_are_in_a_hopper_or_a_drum() -> Tested {
    let home = tempfile::tempdir()?;
    let file = home.path().join("a.xyz");
    let write = |x: f64, z: f64| {
        let text = format!("1\nProperties=species:S:1:pos:R:3:radius:R:1\nG {x} 0.05 {z} 0.005\n");
        std::fs::write(&file, text)
    };
    let hopper = GrainsScene {
        width: 0.16,
        depth: Some(0.1),
        x: Sides::Walls,
        container: Container::Hopper,
        outlet: 0.04,
        slope: 45.0,
        start: Some(file.clone()),
        ..scene()
    };
    let drum = GrainsScene {
        x: Sides::Periodic,
        container: Container::Drum,
        ..hopper.clone()
    };
    // In the slot, above a plate, below the slot, at the bottom and at the side of the drum.
    for (scene, x, z) in [
        (&hopper, 0.08, 0.1),
        (&hopper, 0.03, 0.2),
        (&hopper, 0.08, 0.02),
        (&drum, 0.08, 0.006),
        (&drum, 0.154, 0.08),
    ] {
        write(x, z)?;
        let run = Grains::new(scene)?;
        let place = run.with_snapshot(|now| now.positions[0]);
        assert_eq!([place.x, place.z], [x, z]);
    }
    // Across a plate, in the floor, and beyond the drum.
    let refusal = |scene: &GrainsScene| {
        Grains::new(scene).map_or_else(|error| error.to_string(), |_| "taken".into())
    };
    for (scene, x, z) in [
        (&hopper, 0.05, 0.11),
        (&hopper, 0.08, 0.001),
        (&drum, 0.01, 0.01),
    ] {
        write(x, z)?;
        let refused = refusal(scene);
        let container = scene.container;
        let wanted = format!("at x = {x} and z = {z}, reaches into the {container}");
        assert!(refused.contains(&wanted), "{refused}");
    }
    // A closed slot cuts through what lies in it.
    write(0.08, 0.1)?;
    let opening = 1.0;
    let refused = refusal(&GrainsScene { opening, ..hopper });
    assert!(refused.contains("reaches into the hopper"), "{refused}");
    Ok(())
}

#[test]
fn springs_take_overlaps_that_rigid_grains_cannot_have() -> Tested {
    let home = tempfile::tempdir()?;
    let file = home.path().join("a.xyz");
    let text = "2\nLattice=\"0.06 0 0 0 0.06 0 0 0 0.1\" pbc=\"T T F\" \
                Properties=species:S:1:pos:R:3:radius:R:1\nG 0.03 0.03 0.005 0.005\nG 0.03 0.03 0.014 0.005\n";
    std::fs::write(&file, text)?;
    let rigid = GrainsScene {
        start: Some(file),
        ..scene()
    };
    let refused = Grains::new(&rigid).map_or_else(|error| error.to_string(), |_| "taken".into());
    let wanted = "overlap by 20.000 % of the smaller radius; at most 5 %";
    assert!(refused.contains(wanted), "{refused}");
    let mut run = Grains::new(&GrainsScene {
        method: ContactMethod::Soft,
        ..rigid
    })?;
    run.step()?;
    // The spring of 1 mm parts them.
    let speed = run.with_snapshot(|now| now.velocities.unwrap_or_default()[1].z);
    assert!(speed > 0.0 && run.outcome().statistics.max_overlap > 0.99e-3);
    Ok(())
}

#[test]
fn grains_of_a_distribution_keep_the_mean_and_the_bounds() -> Tested {
    let sizes = Sizes::LogNormal(0.2);
    let [low, high] = sizes.radii()?.bounds();
    let run = Grains::new(&GrainsScene {
        sizes: Some(sizes),
        count: 2000,
        width: 0.2,
        ..scene()
    })?;
    run.with_snapshot(|now| {
        let mean = now.radii.iter().sum::<f64>() / 2000.0;
        assert!((mean / 0.005 - 1.0).abs() < 0.02);
        assert!(
            now.radii
                .iter()
                .all(|radius| (low..=high).contains(&(radius / 0.005)))
        );
    });
    Ok(())
}
