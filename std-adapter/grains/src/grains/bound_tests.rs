//! Scenes with grains that no force moves, and with walls of triangles.

use super::{Coordinates, GrainsSimulation};
use crate::grains::scene::{EndBoundary, GrainsScene, SideBoundary};
use crate::packing::method::ContactMethod;
use nalgebra::Vector3;
use std::path::Path;
use tribos_base::run::{Simulation, run_to_end};

const METHODS: [ContactMethod; 2] = [ContactMethod::ContactDynamics, ContactMethod::Soft];

fn run(scene: &GrainsScene) -> GrainsSimulation {
    let mut run = GrainsSimulation::new(scene).unwrap();
    run_to_end(&mut run, |_, _| ()).unwrap();
    run
}

/// The end of a run, taken up again in the middle from its checkpoint.
fn broken(scene: &GrainsScene, steps: usize) -> String {
    let mut run = GrainsSimulation::new(scene).unwrap();
    for _ in 0..steps {
        run.step().unwrap();
    }
    let mut run = GrainsSimulation::resume(scene, &run.checkpoint()).unwrap();
    run_to_end(&mut run, |_, _| ()).unwrap();
    without_clock(&run)
}

/// The state of a run and its series, bit by bit.
fn without_clock(run: &GrainsSimulation) -> String {
    format!("{:?} {}", run.series(), run.state())
}

/// A binary STL file of these triangles.
fn write_stl(path: &Path, triangles: &[[[f32; 3]; 3]]) {
    let mut bytes = vec![0_u8; 80];
    bytes.extend((triangles.len() as u32).to_le_bytes());
    for corners in triangles {
        bytes.extend([0_u8; 12]);
        bytes.extend(corners.iter().flatten().flat_map(|x| x.to_le_bytes()));
        bytes.extend([0_u8; 2]);
    }
    std::fs::write(path, bytes).unwrap();
}

/// Thirty grains on a floor of glued ones.
fn rough(method: ContactMethod) -> GrainsScene {
    GrainsScene {
        width: 0.04,
        count: 30,
        rough_floor: Some(0.004),
        duration: 0.6,
        mu_rolling: 0.1,
        max_iterations: 5000,
        sample_every: 7,
        method,
        ..GrainsScene::default()
    }
}

#[test]
fn a_rough_floor_bears_the_grains_and_stays() {
    for method in METHODS {
        let scene = rough(method);
        let run = run(&scene);
        let end = run.outcome();
        // 5 × 5 glued grains are no part of the totals.
        assert_eq!((end.grains, run.seen.packing.radii().len()), (30, 55));
        let weight = 9.81 * end.mass;
        assert!((end.mass / (30.0 * 2500.0 * 5.235_987_755_982_99e-7) - 1.0).abs() < 1e-9);
        assert!(
            (end.end.floor_force / weight - 1.0).abs() < 2e-2,
            "{}",
            end.end.floor_force / weight
        );
        assert!(end.end.speed < 1e-2);
        for (index, place) in run.seen.packing.positions()[30..].iter().enumerate() {
            let at = |index: usize| 0.008 * (index as f64 + 0.5);
            assert!((place - Vector3::new(at(index % 5), at(index / 5), 0.0)).norm() < 1e-15);
        }
        assert_eq!(broken(&scene, 40), without_clock(&run));

        // A run that goes on keeps them, by their types.
        let home = tempfile::tempdir().unwrap();
        let file = home.path().join("final-state.json");
        std::fs::write(&file, run.state()).unwrap();
        let on = GrainsScene {
            rough_floor: None,
            initial_state: Some(file),
            duration: 0.01,
            ..scene
        };
        let on = self::run(&on);
        assert_eq!(on.outcome().grains, 30);
        assert_eq!(
            on.seen.packing.positions()[30..],
            run.seen.packing.positions()[30..]
        );
    }
}

#[test]
fn an_intruder_takes_the_momentum_that_the_grains_lose() {
    let mut scene = GrainsScene {
        width: 0.05,
        height: Some(0.05),
        boundary_z: EndBoundary::Periodic,
        count: 40,
        intruder_radius: Some(0.008),
        intruder_position: Some(Coordinates([0.025, 0.025, 0.025])),
        gravity: 0.0.into(),
        duration: 0.1,
        sample_every: 1,
        tolerance: 1e-10,
        // Forces stand on the normals of the places after the step.
        max_displacement: 0.005,
        ..GrainsScene::default()
    };
    scene.driven_velocity_x = 0.3.into();
    let run = run(&scene);
    let (series, packing) = (run.series(), &run.seen.packing);
    let column = |name: &str| {
        super::COLUMNS
            .iter()
            .position(|column| *column == name)
            .unwrap()
    };
    let time = column("time");
    let impulse = |name: &str| -> f64 {
        let force = column(name);
        series
            .windows(2)
            .map(|lines| lines[1][force] * (lines[1][time] - lines[0][time]))
            .sum()
    };
    let taken = Vector3::new(
        impulse("driven_force_x"),
        impulse("driven_force_y"),
        impulse("driven_force_z"),
    );
    let free = packing
        .spheres()
        .iter()
        .filter(|grain| grain.inv_mass > 0.0);
    let momentum: Vector3<f64> = free.map(|grain| grain.velocity / grain.inv_mass).sum();
    assert!(
        momentum.x > 5e-4 && (momentum + taken).norm() < 5e-3 * momentum.norm(),
        "{momentum} {taken}"
    );
    // Its drive did the work of this force, and the balance closes.
    let work = packing.energy().work;
    assert!((work / (0.3 * momentum.x) - 1.0).abs() < 1e-9);
    assert!(packing.energy().imbalance().abs() < 1e-10 * work);
    let at = packing.positions()[40];
    let time = packing.clock().0;
    assert!((at - Vector3::new(0.025 + 0.3 * time, 0.025, 0.025)).norm() < 1e-12);
    assert_eq!(broken(&scene, 20), without_clock(&run));
}

#[test]
fn a_rough_plate_shears_what_a_smooth_one_slips_over() {
    let shear = |lid: Option<f64>| {
        let scene = GrainsScene {
            width: 0.05,
            boundary_z: EndBoundary::Walls,
            height: Some(0.05),
            count: 45,
            rough_floor: Some(0.005),
            rough_lid: lid,
            wall_velocity_z: Some((-0.02).into()),
            lid_speed_x: 0.2.into(),
            gravity: 0.0.into(),
            mu: 0.3,
            max_iterations: 3000,
            duration: 0.4,
            sample_every: 1,
            ..GrainsScene::default()
        };
        run(&scene)
    };
    let rough = shear(Some(0.005));
    let (packing, line) = (&rough.seen.packing, rough.outcome().end);
    // Its grains keep their places under the plate.
    let time = packing.clock().0;
    let (first, last) = (packing.positions()[70], packing.positions()[94]);
    assert_eq!(packing.positions().len(), 95);
    assert!((first - Vector3::new(0.005 + 0.2 * time, 0.005, 0.05 - 0.02 * time)).norm() < 1e-4);
    assert!((last - first - Vector3::new(0.04, 0.04, 0.0)).norm() < 1e-15);
    assert!((line.plate_speed, line.kinetic > 0.0) == (0.2, true));
    // The drives do the work that the contacts take.
    let energy = packing.energy();
    assert!(energy.work > 0.0 && energy.imbalance().abs() < 1e-9 * energy.work);
}

/// One grain above a floor of two triangles at a height of 2 cm.
fn on_mesh(file: &Path, method: ContactMethod) -> GrainsScene {
    write_stl(
        file,
        &[
            [
                [-100.0, -100.0, 20.0],
                [200.0, -100.0, 20.0],
                [200.0, 200.0, 20.0],
            ],
            [
                [-100.0, -100.0, 20.0],
                [200.0, 200.0, 20.0],
                [-100.0, 200.0, 20.0],
            ],
        ],
    );
    GrainsScene {
        width: 0.1,
        boundary_x: SideBoundary::Walls,
        boundary_y: SideBoundary::Walls,
        count: 5,
        initial_height: 0.021,
        mesh: Some(file.into()),
        mesh_scale: 1e-3,
        mesh_centre: Coordinates([0.01, 0.02, 0.02]),
        mu_rolling: 0.2,
        duration: 0.5,
        method,
        ..GrainsScene::default()
    }
}

#[test]
fn a_mesh_bears_force_and_torque_of_the_grains_on_it() {
    let home = tempfile::tempdir().unwrap();
    let file = home.path().join("table.stl");
    for method in METHODS {
        let scene = on_mesh(&file, method);
        let run = run(&scene);
        let (end, packing) = (run.outcome(), &run.seen.packing);
        let weight = 9.81 * end.mass;
        assert!(
            (end.end.mesh_force_z / -weight - 1.0).abs() < 1e-3,
            "{}",
            end.end.mesh_force_z / weight
        );
        assert!(end.end.floor_force == 0.0 && end.end.speed < 1e-3);
        let mut torque = Vector3::zeros();
        for (x, grain) in packing.positions().iter().zip(packing.spheres()) {
            // Rigid at R above, soft lower by m g/k.
            assert!((x.z - 0.025).abs() < 4e-6, "{}", x.z);
            let force = Vector3::new(0.0, 0.0, -9.81 / grain.inv_mass);
            torque += (x - Vector3::new(0.01, 0.02, 0.02)).cross(&force);
        }
        let found = Vector3::new(
            end.end.mesh_torque_x,
            end.end.mesh_torque_y,
            end.end.mesh_torque_z,
        );
        assert!(
            (found - torque).norm() < 1e-2 * torque.norm(),
            "{found} {torque}"
        );
        assert_eq!(broken(&scene, 60), without_clock(&run));
    }
}

#[test]
fn a_moving_mesh_goes_on_from_a_checkpoint_with_the_same_bits() {
    let home = tempfile::tempdir().unwrap();
    let file = home.path().join("table.stl");
    for method in METHODS {
        let scene = GrainsScene {
            mesh_velocity: Coordinates([0.0, 0.0, 0.05]),
            mesh_angular_velocity: 2.0,
            mesh_axis: Coordinates([0.0, 0.0, 2.0]),
            mesh_centre: Coordinates([0.05, 0.05, 0.02]),
            sample_every: 10,
            duration: 0.2,
            ..on_mesh(&file, method)
        };
        let run = run(&scene);
        let time = run.time();
        let heights = run
            .seen
            .packing
            .positions()
            .iter()
            .map(|x| x.z - 0.02 - 0.05 * time);
        assert!(
            heights
                .into_iter()
                .all(|above| (above - 0.005).abs() < 2e-4)
        );
        assert!(run.seen.packing.energy().work > 0.0);
        assert_eq!(broken(&scene, 31), without_clock(&run));
    }
}

#[test]
fn grains_of_a_file_are_fixed_and_driven_by_their_types() {
    let home = tempfile::tempdir().unwrap();
    let file = home.path().join("start.xyz");
    let text = "3\nLattice=\"0.1 0 0 0 0.1 0 0 0 0.1\" pbc=\"T T F\" \
                Properties=species:S:1:pos:R:3:radius:R:1:material:I:1\n\
                X 0.05 0.05 0.005 0.005 2\nX 0.0502 0.05 0.0152 0.005 1\nX 0.02 0.02 0.005 0.005 7\n";
    std::fs::write(&file, text).unwrap();
    let scene = GrainsScene {
        width: 0.1,
        initial_state: Some(file),
        fixed_kinds: "2".parse().unwrap(),
        driven_kinds: "7".parse().unwrap(),
        driven_velocity_y: 0.1.into(),
        duration: 0.5,
        ..GrainsScene::default()
    };
    let run = run(&scene);
    let (end, places) = (run.outcome(), run.seen.packing.positions());
    assert_eq!(end.grains, 1);
    assert_eq!(places[0], Vector3::new(0.05, 0.05, 0.005));
    assert!((places[2] - Vector3::new(0.02, 0.02 + 0.1 * run.time(), 0.005)).norm() < 1e-4);
    // The free one has fallen off the fixed one.
    assert!((places[1].z - 0.005).abs() < 1e-5, "{}", places[1].z);
    // A type that nothing names is refused.
    let unnamed = GrainsScene {
        driven_kinds: "4".parse().unwrap(),
        ..scene
    };
    let refused = GrainsSimulation::new(&unnamed).unwrap_err().to_string();
    assert!(refused.contains("type 7"), "{refused}");
}

#[test]
fn what_cannot_be_is_refused_before_work_starts() {
    let refusal = |scene: GrainsScene| GrainsSimulation::new(&scene).unwrap_err().to_string();
    let open = GrainsScene {
        rough_lid: Some(0.005),
        ..GrainsScene::default()
    };
    assert!(refusal(open).contains("boundary_z"));
    let pressed = GrainsScene {
        rough_lid: Some(0.005),
        boundary_z: EndBoundary::Walls,
        wall_stress_z: Some(10.0.into()),
        ..GrainsScene::default()
    };
    assert!(refusal(pressed).contains("wall_velocity_z"));
    let nowhere = GrainsScene {
        intruder_radius: Some(0.01),
        ..GrainsScene::default()
    };
    assert!(refusal(nowhere).contains("intruder_position"));
    let home = tempfile::tempdir().unwrap();
    let file = home.path().join("broken.stl");
    std::fs::write(&file, "solid x\nvertex 0 0\n").unwrap();
    let mesh = GrainsScene {
        mesh: Some(file),
        ..GrainsScene::default()
    };
    let message = refusal(mesh);
    assert!(
        message.contains("broken.stl") && message.contains("line 2"),
        "{message}"
    );
}

/// Four driven grains on a cross that turns about a slanted axis in a gas of grains.
#[test]
fn an_impeller_turns_as_one_body_and_does_the_work_of_its_torque() {
    let home = tempfile::tempdir().unwrap();
    let file = home.path().join("cross.xyz");
    let mut text = String::from("31\nProperties=pos:R:3:radius:R:1:type:I:1\n");
    for arm in [[0.01, 0.0], [-0.01, 0.0], [0.0, 0.01], [0.0, -0.01]] {
        text += &format!("{} {} 0.03 0.004 8\n", 0.03 + arm[0], 0.03 + arm[1]);
    }
    let places = (0..64).map(|at| [at % 4, at / 4 % 4, at / 16]);
    let apart = |at: &[usize; 3]| at.iter().any(|along| ![1, 2].contains(along));
    for at in places.filter(apart).step_by(2).take(27) {
        let [x, y, z] = at.map(|along| 0.0075 + 0.015 * along as f64);
        text += &format!("{x} {y} {z} 0.0035 1\n");
    }
    std::fs::write(&file, text).unwrap();
    for method in METHODS {
        let scene = GrainsScene {
            width: 0.06,
            height: Some(0.06),
            boundary_z: EndBoundary::Periodic,
            initial_state: Some(file.clone()),
            radius: 0.0035,
            driven_angular_velocity: 20.0.into(),
            driven_velocity_y: 0.05.into(),
            driven_axis: Coordinates([0.0, 3.0, 4.0]),
            gravity: 0.0.into(),
            duration: 0.3,
            tolerance: 1e-10,
            max_displacement: 0.01,
            sample_every: 1,
            method,
            ..GrainsScene::default()
        };
        let run = run(&scene);
        let packing = &run.seen.packing;
        // Half the turn of a rotation about (0, 0.6, 0.8): arms by Rodrigues' formula in quaternions.
        let time = packing.clock().0;
        let turn = nalgebra::Quaternion::new(0.0, 0.0, 0.6, 0.8) * libm::sin(10.0 * time)
            + nalgebra::Quaternion::new(libm::cos(10.0 * time), 0.0, 0.0, 0.0);
        let arm = nalgebra::Quaternion::new(0.0, 0.01, 0.0, 0.0);
        let turned = (turn * arm * turn.conjugate()).imag();
        let centre = Vector3::new(0.03, 0.03 + 0.05 * time, 0.03);
        // A step goes along the tangent.
        let off = (packing.positions()[0] - centre - turned).norm();
        assert!(off < 1e-4, "{method:?} {off:e}");
        let grain = &packing.spheres()[0];
        assert!((grain.spin - Vector3::new(0.0, 12.0, 16.0)).norm() < 1e-12);
        let energy = packing.energy();
        assert!(energy.work > 1e-6, "{method:?} {energy:?}");
        let tolerance = if method == ContactMethod::Soft {
            5e-3
        } else {
            1e-9
        };
        assert!(
            energy.imbalance().abs() < tolerance * energy.work,
            "{method:?} {:e} of {:e}",
            energy.imbalance(),
            energy.work
        );
        assert_eq!(broken(&scene, 20), without_clock(&run));
    }
}

#[test]
fn an_inertial_number_sets_the_rate_of_a_slow_deformation() {
    let scene = |text: &str| {
        let text = format!(
            "body = \"grains\"\nmethod = \"soft\"\nwidth = 0.06\nheight = 0.06\nboundary_z = \"periodic\"\ngravity = 0\n\
             radius = 0.005\ndensity = 2500\ncount = 60\nduration = 0.02\nsample_every = 1\n{text}"
        );
        GrainsScene::parse("slow.toml", &text, &[]).map_err(|refused| refused.to_string())
    };
    // I = rate d √(ρ/P): 0.01 · √(1000/2500)/0.01 s⁻¹.
    let rate = 0.632_455_532_033_675_9;
    let sheared = scene("inertial_number = 0.01\nwall_stress_z = 1000").unwrap();
    let line = run(&sheared).outcome().end;
    assert!((line.shear_rate / rate - 1.0).abs() < 1e-12);
    let pressed =
        scene("inertial_number = 0.01\nwall_stress_x = 1000\nwall_stress_y = 1000").unwrap();
    let line = run(&pressed).outcome().end;
    let strain = 1.0 - line.height / 0.06;
    assert!((strain / (rate * line.time) - 1.0).abs() < 1e-9, "{strain}");
    assert_eq!(line.shear_rate, 0.0);
    for refused in [
        "inertial_number = 0.01",
        "inertial_number = 0.01\nwall_stress_z = \"0:10, 1:20\"",
        "inertial_number = 0.01\nwall_stress_z = 1000\nshear_rate = 1",
        "inertial_number = 0.01\nwall_stress_x = 1000\nwall_velocity_z = 1",
    ] {
        assert!(
            scene(refused).unwrap_err().contains("inertial_number"),
            "{refused}"
        );
    }
}
