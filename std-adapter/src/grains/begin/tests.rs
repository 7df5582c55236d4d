use crate::grains::Grains;
use crate::measure::{Assembly, Measures, Options};
use crate::record::extended_xyz;
use crate::run::Simulation;
use crate::scene::{GrainsScene, Sides, Sizes};
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
