use nalgebra::Vector3;
use std::path::PathBuf;
use tribos_base::record::frames::{Frame, FrameFolder};
use tribos_base::record::trajectory::{Format, State, Trajectory};
use tribos_base::record::{extended_xyz, particles_vtp};
use tribos_base::run::{LongRun, Simulation};
use tribos_grains::grains::{GrainsSimulation, Ramp};
use tribos_grains::measure::{Assembly, MeasureOptions, Measures};
use tribos_grains::packing::STATE;
use tribos_grains::packing::SizeDistribution;
use tribos_grains::scene::ContactMethod;
use tribos_grains::scene::{Container, EndBoundary, GrainsScene, SideBoundary};

type Tested = Result<(), Box<dyn std::error::Error>>;

fn scene() -> GrainsScene {
    GrainsScene {
        width: 0.06,
        count: 30,
        mu_torsion: 0.1,
        duration: 10.0,
        ..GrainsScene::default()
    }
}

fn after(
    scene: &GrainsScene,
    steps: usize,
) -> Result<GrainsSimulation, Box<dyn std::error::Error>> {
    let mut run = GrainsSimulation::new(scene)?;
    for _ in 0..steps {
        run.step()?;
    }
    Ok(run)
}

fn motion(run: &GrainsSimulation) -> Vec<[Vector3<f64>; 3]> {
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
    for sides in [SideBoundary::Periodic, SideBoundary::Walls] {
        let scene = GrainsScene {
            boundary_x: sides,
            ..scene()
        };
        let mut whole = after(&scene, 300)?;
        for (name, text) in [("a.json", whole.state()), ("b.json", whole.checkpoint())] {
            std::fs::write(home.path().join(name), text)?;
        }
        let from = |name: &str| GrainsScene {
            initial_state: Some(home.path().join(name)),
            ..scene.clone()
        };
        let mut parts = [
            GrainsSimulation::new(&from("a.json"))?,
            GrainsSimulation::new(&from("b.json"))?,
        ];
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
    let found = Measures::of(state, &MeasureOptions::default())?;
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
    let other = GrainsSimulation::new(&GrainsScene {
        initial_state: start.clone(),
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
        GrainsSimulation::new(&scene).map_or_else(|error| error.to_string(), |_| "taken".into())
    };
    let wide = refusal(GrainsScene {
        initial_state: start.clone(),
        width: 0.07,
        ..scene()
    });
    assert!(
        wide.contains("its period along x is 0.06, and `width` is 0.07; set width = 0.06"),
        "{wide}"
    );
    let fine = refusal(GrainsScene {
        initial_state: start,
        radius: 5.0,
        ..scene()
    });
    assert!(fine.contains("multiply all lengths by"), "{fine}");
    Ok(())
}

#[test]
fn the_box_of_an_export_ends_at_its_walls_though_grains_press_them() -> Tested {
    let home = tempfile::tempdir()?;
    let scene = GrainsScene {
        boundary_x: SideBoundary::Walls,
        method: ContactMethod::Soft,
        stiffness: 1e3,
        ..scene()
    };
    let run = after(&scene, 3000)?;
    let reach = motion(&run)
        .iter()
        .map(|[place, ..]| place.x - scene.radius)
        .fold(f64::INFINITY, f64::min);
    assert!(reach < 0.0, "{reach}");
    for (name, text) in [
        ("a.xyz", run.with_snapshot(extended_xyz)?),
        ("a.vtp", run.with_snapshot(particles_vtp)?),
    ] {
        let file = home.path().join(name);
        std::fs::write(&file, text)?;
        assert_eq!(
            Assembly::read(&file)?.bounds[0],
            [0.0, scene.width],
            "{name}"
        );
        let other = GrainsSimulation::new(&GrainsScene {
            initial_state: Some(file),
            ..scene.clone()
        })?;
        for (was, is) in motion(&run).iter().zip(motion(&other)) {
            assert_eq!(was[0].x, is[0].x, "{name}");
        }
    }
    Ok(())
}

#[test]
fn a_flat_run_goes_on_from_its_trajectories_in_its_plane() -> Tested {
    let home = tempfile::tempdir()?;
    let scene = GrainsScene {
        dimension: 2,
        width: 0.3,
        second_fraction: 0.3,
        second_radius: 0.1,
        ..scene()
    };
    let run = after(&scene, 100)?;
    let state = {
        let (bodies, frame) = (
            run.bodies(9),
            Frame {
                step: 0,
                ..run.frame()
            },
        );
        let frames = home.path().join("frames");
        FrameFolder::begin(&frames, &bodies)?.finish(&frame)?;
        State::of_frame(&bodies, &FrameFolder::read(&frames, &bodies, 0)?)
    };
    for format in [Format::Xyz, Format::LammpsDump] {
        let mut trajectory = Trajectory::begin(home.path(), format)?;
        trajectory.add(&state)?;
        let file = trajectory.finish()?;
        let start = |file: PathBuf| {
            GrainsSimulation::new(&GrainsScene {
                initial_state: Some(file),
                ..scene.clone()
            })
        };
        let other = start(file.clone())?;
        for (was, is) in motion(&run).iter().zip(motion(&other)) {
            let apart = (was[0] - is[0]).x / scene.width;
            assert!((apart - apart.round()).abs() < 1e-5, "{format:?}");
            assert_eq!(is[0].y, 0.0, "{format:?}");
        }
        // A grain beside the plane by a thousandth of its radius is none of a flat box.
        let y = format!("{:e}", state.places[0].y as f32);
        let beside = std::fs::read_to_string(&file)?.replacen(&y, "5e-6", 1);
        std::fs::write(&file, beside)?;
        let refused = start(file).map_or_else(|error| error.to_string(), |_| "taken".into());
        assert!(refused.contains("all are at y = 0"), "{refused}");
    }
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
        boundary_x: SideBoundary::Walls,
        container: Container::Hopper,
        orifice_width: 0.04,
        hopper_angle: 45.0,
        initial_state: Some(file.clone()),
        ..scene()
    };
    let drum = GrainsScene {
        boundary_x: SideBoundary::Periodic,
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
        let run = GrainsSimulation::new(scene)?;
        let place = run.with_snapshot(|now| now.positions[0]);
        assert_eq!([place.x, place.z], [x, z]);
    }
    // Across a plate, in the floor, and beyond the drum.
    let refusal = |scene: &GrainsScene| {
        GrainsSimulation::new(scene).map_or_else(|error| error.to_string(), |_| "taken".into())
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
    let refused = refusal(&GrainsScene {
        open_time: opening,
        ..hopper.clone()
    });
    assert!(refused.contains("reaches into the hopper"), "{refused}");
    // Also where everything else goes on from a state.
    write(0.08, 0.1)?;
    std::fs::write(
        home.path().join("state.json"),
        GrainsSimulation::new(&hopper)?.state(),
    )?;
    let start = Some(home.path().join("state.json"));
    let open = GrainsScene {
        initial_state: start,
        ..hopper
    };
    assert!(GrainsSimulation::new(&open).is_ok());
    let refused = refusal(&GrainsScene {
        open_time: opening,
        ..open
    });
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
        initial_state: Some(file),
        ..scene()
    };
    let refused =
        GrainsSimulation::new(&rigid).map_or_else(|error| error.to_string(), |_| "taken".into());
    let wanted = "overlap by 20.000 % of the smaller radius; at most 5 %";
    assert!(refused.contains(wanted), "{refused}");
    let mut run = GrainsSimulation::new(&GrainsScene {
        method: ContactMethod::Soft,
        ..rigid
    })?;
    run.step()?;
    // The spring of 1 mm parts them.
    let speed = run.with_snapshot(|now| now.velocities.unwrap_or_default()[1].z);
    let overlap = run.outcome().max_overlap;
    assert!(speed > 0.0 && (overlap / 1e-3 - 1.0).abs() < 1e-12);
    Ok(())
}

#[test]
fn grains_of_a_distribution_keep_the_mean_and_the_bounds() -> Tested {
    let sizes = SizeDistribution::LogNormal(0.2);
    let [low, high] = sizes.radii()?.bounds();
    let run = GrainsSimulation::new(&GrainsScene {
        size_distribution: Some(sizes),
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

#[test]
fn grains_of_a_run_or_a_file_keep_materials_and_densities_whatever_the_seed() -> Tested {
    let home = tempfile::tempdir()?;
    let mixed = GrainsScene {
        second_fraction: 0.4,
        second_density: Some(7800.0),
        mu_second: Some(0.1),
        ..scene()
    };
    let run = after(&mixed, 100)?;
    let kinds = |run: &GrainsSimulation| {
        run.with_snapshot(|now| {
            let materials = now.materials.map(<[u8]>::to_vec);
            (materials, now.densities.map(<[f64]>::to_vec))
        })
    };
    let (xyz, vtp) = run.with_snapshot(|now| (extended_xyz(now), particles_vtp(now)));
    for (name, text) in [
        (STATE, run.state()),
        ("checkpoint.json", run.checkpoint()),
        ("a.xyz", xyz?),
        ("a.vtp", vtp?),
    ] {
        let file = home.path().join(name);
        std::fs::write(&file, text)?;
        // Another draw by another seed would be another packing.
        for (seed, share_second) in [(1, 0.4), (2, 0.4), (3, 0.9), (4, 0.0)] {
            let other = GrainsSimulation::new(&GrainsScene {
                initial_state: Some(file.clone()),
                seed,
                second_fraction: share_second,
                density: 1000.0,
                ..mixed.clone()
            })?;
            assert_eq!(kinds(&other), kinds(&run), "{name}");
            assert_eq!(other.outcome().mass, run.outcome().mass, "{name}");
        }
    }
    Ok(())
}

/// Grains of a diameter of 4 mm as LAMMPS data, which do not say which axes repeat.
fn data(grains: &str) -> String {
    let count = grains.lines().count();
    format!(
        "two materials\n\n{count} atoms\n2 atom types\n\n0 0.08 xlo xhi\n0 0.04 ylo yhi\n0 0.08 zlo zhi\n\n\
         Atoms # sphere\n\n{grains}"
    )
}

#[test]
fn imported_grains_have_the_density_and_the_material_of_each() -> Tested {
    let home = tempfile::tempdir()?;
    let file = home.path().join("dens.data");
    let scene = GrainsScene {
        width: 0.08,
        depth: Some(0.04),
        radius: 0.002,
        density: 1000.0,
        initial_state: Some(file.clone()),
        ..GrainsScene::default()
    };
    std::fs::write(
        &file,
        data("1 1 0.004 2500 0.04 0.02 0.04\n2 2 0.004 7800 0.05 0.02 0.04\n"),
    )?;
    let run = GrainsSimulation::new(&scene)?;
    let volume = 4.0 / 3.0 * std::f64::consts::PI * 8e-9;
    assert!((run.outcome().mass / (volume * 10300.0) - 1.0).abs() < 1e-14);
    assert_eq!(
        run.with_snapshot(|now| now.materials.map(<[u8]>::to_vec)),
        Some(vec![1, 2])
    );
    // A third material has no coefficients.
    std::fs::write(
        &file,
        data("1 3 0.004 2500 0.04 0.02 0.04\n").replace("2 atom", "3 atom"),
    )?;
    let refused =
        GrainsSimulation::new(&scene).map_or_else(|error| error.to_string(), |_| "taken".into());
    assert!(refused.contains("are types 1 to 2"), "{refused}");
    Ok(())
}

#[test]
fn axes_repeat_in_the_box_of_the_scene_and_not_in_that_of_the_file() -> Tested {
    let home = tempfile::tempdir()?;
    let file = home.path().join("two.data");
    // They would overlap across the border of z.
    std::fs::write(
        &file,
        data("1 1 0.004 2500 0.04 0.02 0.0015\n2 1 0.004 2500 0.04 0.02 0.0795\n"),
    )?;
    let scene = GrainsScene {
        width: 0.08,
        depth: Some(0.04),
        radius: 0.002,
        initial_state: Some(file),
        ..GrainsScene::default()
    };
    let run = GrainsSimulation::new(&scene)?;
    run.with_snapshot(|now| {
        assert_eq!(now.space.lengths(), [Some(0.08), Some(0.04), None]);
        assert!((now.positions[1].z - 0.08).abs() < 1e-15);
    });
    let closed = GrainsSimulation::new(&GrainsScene {
        boundary_z: EndBoundary::Periodic,
        height: Some(0.08),
        gravity: Ramp::from(0.0),
        ..scene
    });
    let refused = closed.map_or_else(|error| error.to_string(), |_| "taken".into());
    assert!(refused.contains("overlap by"), "{refused}");
    Ok(())
}
