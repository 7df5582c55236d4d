use nalgebra::Vector3;
use std::path::PathBuf;
use tempfile::TempDir;
use tribos_base::record::{extended_xyz, particles_vtp};
use tribos_base::run::Simulation;
use tribos_grains::packing::SizeDistribution;
use tribos_grains::powder::PowderSimulation;
use tribos_grains::scene::PowderScene;

type Tested = Result<(), Box<dyn std::error::Error>>;

/// Some twenty spheres that sleep never.
fn tiny() -> PowderScene {
    PowderScene {
        width: 8.0,
        height: 12.0,
        pressure: 0.01,
        piston_mass: 100.0,
        still_speed: 0.0,
        mu_rolling: 0.1,
        mu_torsion: 0.2,
        ..PowderScene::default()
    }
}

fn after(
    scene: &PowderScene,
    steps: usize,
) -> Result<PowderSimulation, Box<dyn std::error::Error>> {
    let mut run = PowderSimulation::new(scene)?;
    for _ in 0..steps {
        run.step()?;
    }
    Ok(run)
}

fn kept(folder: &TempDir, name: &str, text: &str) -> std::io::Result<PathBuf> {
    let file = folder.path().join(name);
    std::fs::write(&file, text)?;
    Ok(file)
}

/// Places, velocities and spins.
fn motion(run: &PowderSimulation) -> Vec<[Vector3<f64>; 3]> {
    run.with_snapshot(|now| {
        let velocities = now.velocities.unwrap_or_default().iter();
        let spins = now.spins.unwrap_or_default();
        let both = velocities.zip(spins).zip(now.positions);
        both.map(|((velocity, spin), place)| [*place, *velocity, *spin])
            .collect()
    })
}

fn refusal(scene: &PowderScene) -> String {
    PowderSimulation::check(scene).map_or_else(|error| error.to_string(), |()| "taken".into())
}

#[test]
fn a_run_from_a_state_or_a_checkpoint_goes_on_to_the_bit() -> Tested {
    let home = tempfile::tempdir()?;
    for sizes in [None, Some(SizeDistribution::LogNormal(0.1))] {
        let scene = PowderScene {
            size_distribution: sizes,
            ..tiny()
        };
        let mut whole = after(&scene, 40)?;
        let state = kept(&home, "state.json", &whole.state())?;
        let checkpoint = kept(&home, "checkpoint.json", &whole.checkpoint())?;
        // A folder has them under these names.
        kept(&home, tribos_grains::packing::STATE, &whole.state())?;
        let mut parts = Vec::new();
        for start in [state, checkpoint, home.path().to_owned()] {
            let scene = PowderScene {
                initial_state: Some(start),
                size_distribution: None,
                ..scene.clone()
            };
            let part = PowderSimulation::new(&scene)?;
            assert_eq!((part.steps(), part.height()), (0, whole.height()));
            assert_eq!(part.contacts(), whole.contacts());
            assert_eq!(motion(&part), motion(&whole));
            parts.push(part);
        }
        for _ in 0..5 {
            whole.step()?;
            for part in &mut parts {
                part.step()?;
                assert_eq!(part.contacts(), whole.contacts());
                assert_eq!(motion(part), motion(&whole));
            }
        }
    }
    Ok(())
}

#[test]
fn another_material_starts_from_the_same_places() -> Tested {
    let home = tempfile::tempdir()?;
    let rough = after(&tiny(), 40)?;
    let start = Some(kept(&home, "state.json", &rough.state())?);
    for smooth in [
        PowderScene {
            mu: 0.0,
            mu_rolling: 0.0,
            mu_torsion: 0.0,
            initial_state: start.clone(),
            ..tiny()
        },
        PowderScene {
            pressure: 0.05,
            restitution: 0.3,
            initial_state: start,
            ..tiny()
        },
    ] {
        let mut run = PowderSimulation::new(&smooth)?;
        assert_eq!(motion(&run), motion(&rough));
        for _ in 0..20 {
            run.step()?;
        }
        assert!(run.height() < rough.height());
    }
    Ok(())
}

#[test]
fn a_run_from_a_start_resumes_from_its_own_checkpoint() -> Tested {
    let home = tempfile::tempdir()?;
    let start = Some(kept(&home, "state.json", &after(&tiny(), 30)?.state())?);
    let scene = PowderScene {
        initial_state: start,
        pressure: 0.02,
        ..tiny()
    };
    let mut whole = after(&scene, 10)?;
    let mut resumed = PowderSimulation::resume(&scene, &whole.checkpoint())?;
    whole.step()?;
    resumed.step()?;
    assert_eq!((resumed.steps(), motion(&resumed)), (11, motion(&whole)));
    Ok(())
}

#[test]
fn spheres_of_a_file_lie_between_the_plates_as_they_are() -> Tested {
    let home = tempfile::tempdir()?;
    let run = after(&tiny(), 60)?;
    let (xyz, vtp) = run.with_snapshot(|now| (extended_xyz(now), particles_vtp(now)));
    for (name, text) in [("a.xyz", xyz?), ("a.vtp", vtp?)] {
        let scene = PowderScene {
            initial_state: Some(kept(&home, name, &text)?),
            ..tiny()
        };
        let other = PowderSimulation::new(&scene)?;
        let (was, is) = (motion(&run), motion(&other));
        let low = run.with_snapshot(|now| {
            let lowest = now
                .positions
                .iter()
                .zip(now.radii)
                .map(|(place, radius)| place.z - radius);
            lowest.fold(f64::INFINITY, f64::min)
        });
        for (was, is) in was.iter().zip(&is) {
            assert_eq!((was[1], was[2]), (is[1], is[2]));
            assert!((was[0].z - low - is[0].z).abs() < 1e-14);
        }
        assert!((other.height() - run.height()).abs() < 1e-2);
        let mut other = other;
        for _ in 0..20 {
            other.step()?;
        }
    }
    Ok(())
}

#[test]
fn starts_that_do_not_fit_are_refused_with_what_would() -> Tested {
    let home = tempfile::tempdir()?;
    let file = |length: f64, second: f64, radius: f64| {
        format!(
            "2\nLattice=\"{length} 0 0 0 8 0 0 0 9\" pbc=\"T T F\" Properties=species:S:1:pos:R:3:radius:R:1\n\
             X 1 1 1 {radius}\nX {second} 1 1 {radius}\n"
        )
    };
    let told = |text: &str| -> Result<String, std::io::Error> {
        let start = kept(&home, "a.xyz", text)?;
        let shown = format!("`initial_state`: {}: ", start.display());
        let refused = refusal(&PowderScene {
            initial_state: Some(start),
            ..tiny()
        });
        Ok(refused
            .strip_prefix(&shown)
            .map_or(refused.clone(), String::from))
    };
    assert_eq!(told(&file(8.0, 3.0, 1.0))?, "taken");
    assert_eq!(
        told(&file(9.0, 3.0, 1.0))?,
        "its period along x is 9, and `width` is 8; set width = 9"
    );
    assert_eq!(
        told(&file(8.0, 2.8, 1.0))?,
        "spheres 0 and 1 (from 0) overlap by 20.000 % of the smaller radius; at most 5 % is taken: set method = \"soft\", or let \
         them part with it first and start from the folder of that run"
    );
    assert_eq!(
        told(&file(8.0, 3.0, 0.001))?,
        "the mean radius is 0.001, and that of the scene is 1; multiply all lengths by 1000"
    );
    assert!(
        told("0\npbc=\"F F F\" Properties=species:S:1:pos:R:3:radius:R:1\n")?
            .contains("there is no sphere")
    );
    let twice = PowderScene {
        initial_state: Some("a.xyz".into()),
        count: Some(7),
        ..tiny()
    };
    assert!(refusal(&twice).contains("leave out `count`, `size_distribution` and `radius_spread`"));
    let both = PowderScene {
        size_distribution: Some(SizeDistribution::Normal(0.1)),
        radius_spread: 0.1,
        ..tiny()
    };
    assert!(refusal(&both).contains("give `radius_spread` or `size_distribution`, not both"));
    Ok(())
}

#[test]
fn a_uniform_distribution_is_the_spread_of_the_radii() -> Tested {
    let spread = PowderSimulation::new(&PowderScene {
        radius_spread: 0.2,
        ..tiny()
    })?;
    let sizes = PowderSimulation::new(&PowderScene {
        size_distribution: Some(SizeDistribution::Uniform(0.2)),
        ..tiny()
    })?;
    assert_eq!(spread.deposit(), sizes.deposit());
    Ok(())
}
