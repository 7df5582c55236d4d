//! Grains do what their loads say.

use tribos_base::run::{Simulation, run_to_end};
use tribos_grains::grains::*;
use tribos_grains::packing::{PackingRunError, PlacementError};
use tribos_grains::scene::{Axis, Container, EndBoundary, GrainsScene, SideBoundary};
use tribos_grains::scene::{ContactMethod, NormalForce, WallLaw};

/// A run to its end.
fn run(scene: &GrainsScene) -> GrainsSimulation {
    let mut grains = GrainsSimulation::new(scene).unwrap();
    run_to_end(&mut grains, |_, _| ()).unwrap();
    grains
}

/// A column of the series by its name.
fn column(grains: &GrainsSimulation, name: &str) -> Vec<f64> {
    let column = COLUMNS.iter().position(|known| *known == name).unwrap();
    grains.series().iter().map(|row| row[column]).collect()
}

/// Mean of a column over the lines after a time.
fn late(grains: &GrainsSimulation, name: &str, after: f64) -> f64 {
    let [times, values] = ["time", name].map(|name| column(grains, name));
    let late = times.iter().zip(values).filter(|(time, _)| **time > after);
    let late: Vec<f64> = late.map(|(_, value)| value).collect();
    late.iter().sum::<f64>() / late.len() as f64
}

fn ramp(text: &str) -> Ramp {
    text.parse().unwrap()
}

/// A few beads with the usual tolerances.
fn beads(count: usize) -> GrainsScene {
    GrainsScene {
        width: 0.05,
        count,
        radius: 0.005,
        radius_spread: 0.2,
        max_time_step: Some(2e-3),
        sample_every: 5,
        ..GrainsScene::default()
    }
}

#[test]
fn the_integral_of_a_ramp_is_that_of_its_values() {
    for text in ["3", "0.5:2", "0:0, 1:4, 1.5:-2, 4:1", "2:1, 3:5"] {
        let ramp = ramp(text);
        assert_eq!(ramp.to_string().parse(), Ok(ramp.clone()));
        let (n, end) = (200_000, 5.0);
        let dt = end / f64::from(n);
        let midpoints = (0..n).map(|i| ramp.at((f64::from(i) + 0.5) * dt) * dt);
        let sum: f64 = midpoints.sum();
        assert!((ramp.integral(end) - sum).abs() < 1e-7, "{text}: {sum}");
    }
    for text in [
        "", "1:2, x", "1:2, 1:3", "2:0, 1:0", "-1:0", "0:inf", "0:1:2",
    ] {
        assert!(text.parse::<Ramp>().is_err(), "{text}");
    }
}

#[test]
fn the_floor_carries_the_weight_of_grains_at_rest_in_space_and_plane() {
    for (dimension, sliding, rolling) in [(3, 0.5, 0.0), (3, 0.3, 0.2), (2, 0.4, 0.0)] {
        let scene = GrainsScene {
            dimension,
            mu: sliding,
            mu_rolling: rolling,
            rest_speed: Some(1e-3),
            duration: 5.0,
            ..beads(30)
        };
        let grains = run(&scene);
        let outcome = grains.outcome();
        assert_eq!(grains.ending(), Some(GrainsStopReason::Rest));
        let share = outcome.end.floor_force / (outcome.mass * 9.81);
        assert!((share - 1.0).abs() < 0.01, "{dimension}: {share}");
        assert!(outcome.energy.imbalance.abs() < 1e-12 * outcome.energy.work);
    }
}

#[test]
fn grains_of_two_dimensions_stay_in_their_plane_to_the_bit() {
    let scene = GrainsScene {
        dimension: 2,
        width: 0.08,
        boundary_x: SideBoundary::Walls,
        mu_rolling: 0.1,
        mu_torsion: 0.1,
        gravity_angle: ramp("0:0, 0.3:30"),
        restitution: 0.3,
        duration: 0.5,
        ..beads(40)
    };
    let grains = run(&scene);
    grains.with_snapshot(|now| {
        assert!(now.contacts.len() > 40);
        let motions = now.velocities.unwrap().iter().zip(now.spins.unwrap());
        for (x, (v, w)) in now.positions.iter().zip(motions) {
            assert_eq!([x.y, v.y, w.x, w.z], [0.0; 4]);
        }
    });
}

#[test]
fn pistons_hold_the_stress_of_their_ramp_and_cycles_repeat_it() {
    let scene = GrainsScene {
        boundary_z: EndBoundary::Walls,
        gravity: 0.0.into(),
        wall_stress_z: Some(ramp("0:500, 1:500, 1.05:2000, 1.5:2000")),
        ramp_period: Some(1.5),
        mu: 0.2,
        duration: 3.0,
        ..beads(40)
    };
    let grains = run(&scene);
    let [times, stresses] = ["time", "plate_stress"].map(|name| column(&grains, name));
    let mean = |from: f64, to: f64| {
        let inside = times.iter().zip(&stresses);
        let inside: Vec<f64> = inside
            .filter(|(time, _)| (from..to).contains(*time))
            .map(|(_, stress)| *stress)
            .collect();
        inside.iter().sum::<f64>() / inside.len() as f64
    };
    for (from, to, stress) in [
        (0.7, 1.0, 500.0),
        (1.2, 1.5, 2000.0),
        (2.2, 2.5, 500.0),
        (2.7, 3.0, 2000.0),
    ] {
        let found = mean(from, to);
        assert!((found / stress - 1.0).abs() < 0.05, "{from}: {found}");
    }
}

#[test]
fn walls_go_where_their_speed_takes_them() {
    for (speed, moved) in [("0:0, 0.2:0.1", 0.01 + 0.03), ("-0.02", -0.01)] {
        let scene = GrainsScene {
            boundary_x: SideBoundary::Walls,
            boundary_z: EndBoundary::Walls,
            height: Some(0.1),
            gravity: 0.0.into(),
            wall_velocity_z: Some(speed.parse().unwrap_or_else(|_| ramp(speed))),
            wall_velocity_x: Some(ramp(speed)),
            duration: 0.5,
            ..beads(8)
        };
        let mut grains = run(&scene);
        // The last step goes beyond the end; the next would put the wall where the ramp is by then.
        let time = grains.time();
        let exact = scene.wall_velocity_z.as_ref().unwrap().integral(time);
        let height = column(&grains, "height").pop().unwrap();
        assert!((exact - moved).abs() < 2e-3);
        assert!((height - 0.1 - exact).abs() < 2e-5, "{height} {exact}");
        let width = column(&grains, "width").pop().unwrap();
        assert!((width - 0.05 - exact).abs() < 2e-5, "{width}");
        assert!(!grains.step().unwrap());
    }
}

#[test]
fn moving_plates_shear_with_and_against_x_and_no_energy_is_missing() {
    for sign in [1.0, -1.0] {
        let scene = GrainsScene {
            boundary_z: EndBoundary::Walls,
            gravity: 0.0.into(),
            wall_stress_z: Some(1000.0.into()),
            lid_speed_x: Ramp::through(&[[0.3, 0.0], [0.35, sign * 0.1]]).unwrap(),
            duration: 1.0,
            ..beads(60)
        };
        let grains = run(&scene);
        let stresses = column(&grains, "shear_stress");
        let late = &stresses[stresses.len() / 2..];
        let mean = late.iter().sum::<f64>() / late.len() as f64;
        assert!(sign * mean > 20.0 && mean.abs() < 500.0, "{sign}: {mean}");
        let energy = grains.outcome().energy;
        assert!(energy.imbalance.abs() < 1e-9 * energy.work, "{energy:?}");
    }
}

#[test]
fn walls_that_move_up_carry_part_of_a_rough_column_and_nothing_of_a_smooth_one() {
    // Moved on, the walls' friction is used up. Janssen: a share of (1 − exp(−h))/h is left on the floor,
    // h = 4 μ K H/D = 1.2 for μ = 0.5, K = 0.4 and a height of 1.5 widths; 0.58.
    let scene = GrainsScene {
        width: 0.04,
        boundary_x: SideBoundary::Walls,
        boundary_y: SideBoundary::Walls,
        mu: 0.5,
        side_wall_speed_z: ramp("0.02"),
        max_iterations: 300,
        tolerance: 1e-3,
        duration: 0.7,
        ..beads(120)
    };
    let share = |scene: &GrainsScene| {
        let grains = run(scene);
        let [times, forces] = ["time", "floor_force"].map(|name| column(&grains, name));
        let late: Vec<f64> = times
            .iter()
            .zip(forces)
            .filter(|(time, _)| **time > 0.4)
            .map(|(_, force)| force)
            .collect();
        late.iter().sum::<f64>() / late.len() as f64 / (grains.outcome().mass * 9.81)
    };
    let rough = share(&scene);
    assert!((0.4..0.8).contains(&rough), "{rough}");
    let smooth = share(&GrainsScene {
        wall_contact: WallLaw::Bare,
        ..scene
    });
    // The bed of smooth beads still rattles.
    assert!((smooth - 1.0).abs() < 0.05, "{smooth}");
}

#[test]
fn a_shaken_floor_throws_grains_up_and_takes_them_along() {
    // Beads that do not roll: they come to rest, and a floor takes them along.
    let scene = GrainsScene {
        mu: 0.5,
        mu_rolling: 1.0,
        shake_amplitude: 2e-3,
        duration: 1.0,
        ..beads(20)
    };
    for (axis, frequency) in [(Axis::Z, 20.0), (Axis::X, 5.0)] {
        let shaken = GrainsScene {
            shake_axis: axis,
            shake_frequency: frequency,
            ..scene.clone()
        };
        let [shaken, still] = [
            &shaken,
            &GrainsScene {
                shake_amplitude: 0.0,
                ..scene.clone()
            },
        ]
        .map(|scene| column(&run(scene), "speed").pop().unwrap());
        assert!(shaken > 0.03 && still < 2e-3, "{axis}: {shaken} {still}");
    }
}

/// The scene with soft grains.
fn soft(scene: GrainsScene) -> GrainsScene {
    GrainsScene {
        method: ContactMethod::Soft,
        ..scene
    }
}

#[test]
fn the_floor_carries_the_weight_of_soft_grains_unless_walls_bear_it() {
    for (normal_law, dimension, restitution) in [
        (NormalForce::Linear, 3, 0.0),
        (NormalForce::Linear, 2, 0.6),
        (NormalForce::Hertz, 3, 0.3),
    ] {
        let scene = GrainsScene {
            normal_law,
            dimension,
            restitution,
            rest_speed: Some(1e-4),
            duration: 5.0,
            ..soft(beads(30))
        };
        let outcome = run(&scene).outcome();
        assert_eq!(outcome.ending, Some(GrainsStopReason::Rest));
        let share = outcome.end.floor_force / (outcome.mass * 9.81);
        assert!((share - 1.0).abs() < 0.01, "{normal_law} {share}");
        assert!(outcome.energy.elastic > Some(0.0) && outcome.iterations_total == 0);
    }
    // Rough walls that move up bear a part of a column, smooth ones nothing.
    let column_of = |wall: WallLaw| {
        let scene = GrainsScene {
            width: 0.04,
            boundary_x: SideBoundary::Walls,
            boundary_y: SideBoundary::Walls,
            side_wall_speed_z: ramp("0.02"),
            wall_contact: wall,
            duration: 0.7,
            ..soft(beads(120))
        };
        let grains = run(&scene);
        late(&grains, "floor_force", 0.4) / (grains.outcome().mass * 9.81)
    };
    let [rough, smooth] = [WallLaw::Full, WallLaw::Bare].map(column_of);
    // Contact dynamics leaves 0.38 to 0.49 of the weight to the floor, springs 0.33 to 0.44 (three seeds).
    assert!((0.25..0.6).contains(&rough), "{rough}");
    assert!((smooth - 1.0).abs() < 0.05, "{smooth}");
}

#[test]
fn soft_grains_between_plates_bear_their_pressure_and_shear_with_them() {
    for sign in [1.0, -1.0] {
        let scene = GrainsScene {
            boundary_z: EndBoundary::Walls,
            gravity: 0.0.into(),
            wall_stress_z: Some(1000.0.into()),
            lid_speed_x: Ramp::through(&[[0.3, 0.0], [0.35, sign * 0.1]]).unwrap(),
            duration: 1.0,
            ..soft(beads(60))
        };
        let mut grains = GrainsSimulation::new(&scene).unwrap();
        while grains.time() < 0.4 {
            grains.step().unwrap();
        }
        let before = grains.outcome().energy;
        run_to_end(&mut grains, |_, _| ()).unwrap();
        let [pressure, shear] =
            ["plate_stress", "shear_stress"].map(|name| late(&grains, name, 0.4));
        assert!((pressure / 1000.0 - 1.0).abs() < 0.05, "{sign}: {pressure}");
        assert!(
            sign * shear > 20.0 && shear.abs() < 500.0,
            "{sign}: {shear}"
        );
        // The plate's work is lost; only the steps' own error is missing.
        let after = grains.outcome().energy;
        let missing = after.imbalance - before.imbalance;
        let work = after.work - before.work;
        assert!(
            work > 0.0 && missing.abs() < 0.05 * work,
            "{missing} {work}"
        );
    }
}

#[test]
fn what_springs_cannot_do_is_refused_with_key_value_and_cure() {
    let refused = |keys: &str| {
        let text = format!(
            "body = \"grains\"\nwidth = 0.1\ncount = 9\nradius = 0.005\ndensity = 2500\nduration = 1\nmethod = \"soft\"\n{keys}"
        );
        GrainsScene::parse("soft.toml", &text, &[])
            .map_or_else(|error| error.to_string(), |_| String::new())
    };
    assert_eq!(refused("stiffness = 1e5\nnormal_law = \"hertz\""), "");
    for (keys, told) in [
        ("attraction = \"resistance\"", "`attraction`"),
        ("restitution = 0.5\ndamping_ratio = 1", "`damping_ratio`"),
        ("max_iterations = 10", "max_iterations"),
        ("tolerance = 1e-3", "tolerance"),
        ("stiffness = -1", "stiffness"),
    ] {
        let message = refused(keys);
        assert!(message.contains(told), "{keys}: {message}");
    }
}

#[test]
fn gravity_is_refused_where_nothing_bears_the_grains() {
    let periodic = |x: SideBoundary, shear_rate: Option<f64>, gravity: Ramp| GrainsScene {
        boundary_x: x,
        boundary_z: EndBoundary::Periodic,
        height: Some(0.1),
        shear_rate,
        gravity,
        ..GrainsScene::default()
    };
    for (scene, is_refused) in [
        (periodic(SideBoundary::Periodic, None, 9.81.into()), true),
        (
            periodic(SideBoundary::Periodic, None, ramp("0:0, 1:1e-9")),
            true,
        ),
        (
            periodic(SideBoundary::Periodic, Some(1.0), 9.81.into()),
            true,
        ),
        (
            periodic(SideBoundary::Periodic, Some(1.0), 0.0.into()),
            false,
        ),
        // A chute.
        (periodic(SideBoundary::Walls, None, 9.81.into()), false),
    ] {
        let told = scene
            .check()
            .map_or_else(|error| error.to_string(), |()| String::new());
        assert_eq!(told.contains("set gravity = 0"), is_refused, "{told}");
    }
}

/// A hopper above a floor.
fn hopper() -> GrainsScene {
    GrainsScene {
        width: 0.16,
        depth: Some(0.03),
        boundary_x: SideBoundary::Walls,
        container: Container::Hopper,
        orifice_width: 0.05,
        orifice_height: 0.08,
        duration: 1.2,
        ..beads(80)
    }
}

#[test]
fn a_hopper_holds_its_grains_until_it_is_opened_and_loses_none() {
    let closed = run(&GrainsScene {
        open_time: 9.0,
        duration: 0.6,
        ..hopper()
    });
    assert!(
        column(&closed, "discharged")
            .iter()
            .all(|mass| *mass == 0.0)
    );
    let open = run(&GrainsScene {
        open_time: 0.5,
        ..hopper()
    });
    let masses = column(&open, "discharged");
    assert!(masses.windows(2).all(|pair| pair[0] <= pair[1] + 1e-15));
    let all = open.outcome().mass;
    assert!((0.3 * all..=all * (1.0 + 1e-12)).contains(&masses[masses.len() - 1]));
    open.with_snapshot(|now| {
        assert!(
            now.positions
                .iter()
                .all(|x| x.z > 0.003 && x.x > 0.003 && x.x < 0.157)
        );
    });
}

/// A file with one grain a place, in a box of 16 by 3 cm.
fn placed(places: &[[f64; 3]], radius: f64) -> tempfile::NamedTempFile {
    let file = tempfile::Builder::new().suffix(".xyz").tempfile().unwrap();
    let mut text = format!(
        "{}\nLattice=\"0.16 0 0 0 0.03 0 0 0 1\" Properties=species:S:1:pos:R:3:radius:R:1 pbc=\"F T F\"\n",
        places.len()
    );
    for [x, y, z] in places {
        text += &format!("G {x} {y} {z} {radius}\n");
    }
    std::fs::write(file.path(), text).unwrap();
    file
}

#[test]
fn a_grain_over_a_slot_falls_freely_whatever_the_slope() {
    let (high, duration) = (0.1, 0.12);
    let file = placed(&[[0.08, 0.015, high]], 0.0025);
    for slope in [0.5, 5.0, 60.0] {
        let scene = GrainsScene {
            hopper_angle: slope,
            initial_state: Some(file.path().into()),
            radius: 0.0025,
            radius_spread: 0.0,
            max_time_step: Some(1e-3),
            duration,
            ..hopper()
        };
        for scene in [scene.clone(), soft(scene)] {
            let grains = run(&scene);
            let fallen = 0.5 * 9.81 * grains.time() * grains.time();
            let z = grains.with_snapshot(|now| now.positions[0].z);
            // The last step counts whole.
            let late = 9.81 * duration * 1e-3;
            assert!((high - z - fallen).abs() < late, "{slope}: {z}");
            assert!(z < scene.orifice_height - 0.04);
        }
    }
}

#[test]
fn a_flat_silo_keeps_no_more_than_slopes_of_repose_beside_its_slot() {
    for x in [SideBoundary::Walls, SideBoundary::Periodic] {
        let scene = GrainsScene {
            dimension: 2,
            width: 0.08,
            depth: None,
            boundary_x: x,
            orifice_width: 0.03,
            hopper_angle: 0.1,
            open_time: 0.2,
            count: 90,
            radius: 0.002,
            mu: 0.3,
            duration: 1.0,
            ..hopper()
        };
        let grains = run(&scene);
        let (mut kept, mut fallen) = (0, 0.0);
        grains.with_snapshot(|now| {
            assert_eq!(now.positions.len(), 90);
            for (x, radius) in now.positions.iter().zip(now.radii) {
                let above = x.z - scene.orifice_height;
                if above < 0.0 {
                    fallen += radius * radius * radius;
                    continue;
                }
                kept += 1;
                // A wedge of 35 degrees from the edge on, and two diameters for its roughness.
                let x = now.space.wrap(x).x;
                let behind = (x - 0.04).abs() - 0.5 * scene.orifice_width;
                let wedge = 0.7 * behind + 4.0 * scene.radius;
                assert!(above < wedge, "{x} {above}: {wedge}");
            }
        });
        // Two wedges of 2.5 cm at 35 degrees hold 4.4e-4 m² at a solid fraction of 0.85, 30 grains.
        assert!((1..30).contains(&kept), "{kept}");
        let mass = 2500.0 * 4.0 / 3.0 * std::f64::consts::PI * fallen;
        let told = column(&grains, "discharged").pop().unwrap();
        assert!((told / mass - 1.0).abs() < 1e-12, "{told} {mass}");
        let energy = grains.outcome().energy;
        assert!(energy.imbalance.abs() < 1e-9 * energy.work);
    }
}

#[test]
fn rigid_grains_that_are_pressed_beyond_any_packing_end_the_run() {
    let pressed = GrainsScene {
        boundary_z: EndBoundary::Walls,
        height: Some(0.11),
        gravity: 0.0.into(),
        // At the end the box has little more than the volume of its grains.
        wall_velocity_z: Some(ramp("-0.4")),
        duration: 0.24,
        ..beads(60)
    };
    let mut grains = GrainsSimulation::new(&pressed).unwrap();
    let error = run_to_end(&mut grains, |_, _| ()).unwrap_err();
    let told = error.to_string();
    let PackingRunError::Overlap {
        step,
        overlap,
        solid_fraction,
    } = error
    else {
        panic!("{told}");
    };
    // No rigid packing is denser than 0.74; overlaps of a tenth of a radius shorten lengths by 5 %.
    assert!(
        (0.1..0.3).contains(&overlap) && step == grains.steps(),
        "{told}"
    );
    assert!((0.5..0.9).contains(&solid_fraction), "{told}");
    let words = ["after step", "solid fraction of 0.", "method = \"soft\""];
    assert!(words.iter().all(|words| told.contains(words)), "{told}");
    // Springs take it.
    run(&soft(pressed));
}

#[test]
fn the_first_line_of_a_sheared_box_has_the_energy_of_its_flow() {
    let sheared = GrainsScene {
        boundary_z: EndBoundary::Periodic,
        height: Some(0.05),
        gravity: 0.0.into(),
        shear_rate: Some(5.0),
        duration: 0.01,
        ..beads(20)
    };
    let grains = GrainsSimulation::new(&sheared).unwrap();
    let wanted: f64 = grains.with_snapshot(|now| {
        let moving = now.velocities.unwrap().iter().zip(now.radii);
        let mass =
            |radius: &f64| 2500.0 * 4.0 / 3.0 * std::f64::consts::PI * (radius * radius * radius);
        moving
            .map(|(v, radius)| 0.5 * mass(radius) * v.norm_squared())
            .sum()
    });
    let first = column(&grains, "kinetic")[0];
    assert!(
        wanted > 0.0 && (first / wanted - 1.0).abs() < 1e-12,
        "{first} {wanted}"
    );
    assert_eq!(grains.outcome().energy.imbalance, 0.0);
}

#[test]
fn the_deepest_overlap_of_a_bounce_stays_in_the_summary() {
    // A grain of a file lies on the floor: it falls to the plate above and comes back.
    let (radius, height, stiffness) = (0.005, 0.05, 1e4);
    let file = placed(&[[0.08, 0.015, 0.1]], radius);
    let scene = GrainsScene {
        width: 0.16,
        depth: Some(0.03),
        boundary_x: SideBoundary::Walls,
        boundary_z: EndBoundary::Walls,
        height: Some(height),
        gravity_angle: ramp("180"),
        initial_state: Some(file.path().into()),
        radius_spread: 0.0,
        stiffness,
        damping_ratio: 0.0,
        max_time_step: Some(1e-4),
        duration: 0.12,
        ..soft(beads(1))
    };
    let grains = run(&scene);
    assert!(grains.contacts().is_empty(), "it is in flight again");
    // The spring takes the energy of the fall: k δ²/2 = m g (h + δ).
    let outcome = grains.outcome();
    let weight = outcome.mass * 9.81;
    let fall = height - 2.0 * radius;
    let deepest = (weight + (weight * weight + 2.0 * stiffness * weight * fall).sqrt()) / stiffness;
    let told = outcome.max_overlap;
    assert!((told / deepest - 1.0).abs() < 0.1, "{told} {deepest}");
}

#[test]
fn a_heap_falls_to_both_sides() {
    // A ridge of 20 degrees in the middle of the box, and a slope of 20 degrees.
    let tan = libm::tan(20_f64.to_radians());
    for (is_heap, wanted) in [(true, [-20.0, 20.0]), (false, [20.0, 20.0])] {
        let places: Vec<[f64; 3]> = (0..16)
            .map(|strip| {
                let x = 0.005 + 0.01 * f64::from(strip);
                let way = if is_heap { (x - 0.08).abs() } else { x };
                [x, 0.015, 0.1 - way * tan]
            })
            .collect();
        let file = placed(&places, 0.0025);
        let scene = GrainsScene {
            width: 0.16,
            depth: Some(0.03),
            boundary_x: SideBoundary::Walls,
            initial_state: Some(file.path().into()),
            radius: 0.0025,
            radius_spread: 0.0,
            ..beads(1)
        };
        let outcome = GrainsSimulation::new(&scene).unwrap().outcome();
        for (found, wanted) in outcome.surface_angles.unwrap().into_iter().zip(wanted) {
            assert!((found - wanted).abs() < 1e-9, "{found} {wanted}");
        }
        let whole = outcome.end.surface_angle;
        let wanted = if is_heap { 0.0 } else { 20.0 };
        assert!((whole - wanted).abs() < 1e-9, "{whole}");
        let told = outcome.json(&scene);
        assert_eq!(told["surface_angles"].as_array().unwrap().len(), 2);
    }
}

/// A drum.
fn drum(rate: f64) -> GrainsScene {
    GrainsScene {
        width: 0.08,
        depth: Some(0.03),
        container: Container::Drum,
        drum_angular_velocity: rate.into(),
        duration: 1.5,
        ..beads(28)
    }
}

#[test]
fn a_drum_lifts_its_bed_on_the_side_that_rises() {
    for rate in [1.5, -1.5] {
        let grains = run(&drum(rate));
        grains.with_snapshot(|now| {
            let count = now.positions.len() as f64;
            let mean = now.positions.iter().map(|x| x.x).sum::<f64>() / count;
            // The bottom moves along -x if the drum turns about +y.
            assert!(rate * (mean - 0.04) < -0.003, "{rate}: {mean}");
            let reach = |x: &nalgebra::Vector3<f64>| libm::hypot(x.x - 0.04, x.z - 0.04);
            assert!(now.positions.iter().all(|x| reach(x) < 0.0375));
        });
    }
}

#[test]
fn a_run_resumes_to_the_byte() {
    let sheared = GrainsScene {
        boundary_z: EndBoundary::Walls,
        boundary_x: SideBoundary::Walls,
        wall_stress_z: Some(ramp("0:100, 0.5:1000")),
        lid_speed_x: ramp("0:0, 0.1:0.1"),
        ramp_period: Some(0.3),
        ..beads(30)
    };
    let shaken = GrainsScene {
        shake_amplitude: 1e-3,
        restitution: 0.5,
        ..beads(30)
    };
    let soft_ones = [soft(sheared.clone()), soft(shaken.clone()), soft(hopper())];
    for scene in [sheared, shaken, hopper(), drum(2.0)]
        .into_iter()
        .chain(soft_ones)
    {
        let mut whole = GrainsSimulation::new(&scene).unwrap();
        for _ in 0..60 {
            whole.step().unwrap();
        }
        let mut broken = GrainsSimulation::resume(&scene, &whole.checkpoint()).unwrap();
        for _ in 0..30 {
            whole.step().unwrap();
            broken.step().unwrap();
        }
        assert_eq!(whole.series(), broken.series());
        // Between two lines, too, and once a run has ended.
        let resumed = GrainsSimulation::resume(&scene, &whole.checkpoint()).unwrap();
        assert_eq!(resumed.record(), whole.record());
        assert_eq!(resumed.last_step(), whole.last_step());
        let bits = |run: &GrainsSimulation| run.with_snapshot(|now| now.positions.to_vec());
        assert_eq!(bits(&whole), bits(&broken));
    }
}

#[test]
fn what_does_not_fit_together_is_refused_by_name() {
    let scene = || GrainsScene::default();
    let both = GrainsScene {
        boundary_z: EndBoundary::Walls,
        wall_stress_z: Some(1.0.into()),
        wall_velocity_z: Some(1.0.into()),
        ..scene()
    };
    let pull = GrainsScene {
        boundary_z: EndBoundary::Walls,
        wall_stress_z: Some(ramp("0:1, 1:-1")),
        ..scene()
    };
    let flat = GrainsScene {
        dimension: 2,
        depth: Some(1.0),
        ..scene()
    };
    let periodic = GrainsScene {
        boundary_z: EndBoundary::Periodic,
        ..scene()
    };
    for (scene, key) in [
        (both, "wall_stress_z"),
        (pull, "wall_stress_z"),
        (flat, "depth"),
        (periodic, "height"),
    ] {
        let refused = scene.check().unwrap_err().to_string();
        assert!(refused.contains(&format!("`{key}`")), "{refused}");
    }
    let full = GrainsScene {
        boundary_z: EndBoundary::Walls,
        height: Some(0.03),
        count: 1000,
        ..scene()
    };
    let refused = GrainsSimulation::new(&full).unwrap_err();
    assert!(matches!(
        refused,
        PackingRunError::Placement(PlacementError::Full { given: 1000, .. })
    ));
}
