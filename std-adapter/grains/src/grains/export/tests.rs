//! Scripts of scenes: walls, loads and held grains where those of Tribos are, and what is refused.

use super::{ExportError, start};
use crate::grains::export::Export;
use crate::grains::grains_body::GrainsBody;
use crate::grains::wall::WallId;
use crate::packing::PackingBody;
use crate::scene::GrainsScene;
use nalgebra::Vector3;
use std::ops::ControlFlow;
use tribos_base::exchange::lammps::read_spheres;

fn soft(keys: &str) -> GrainsScene {
    let text =
        format!("body = \"grains\"\nmethod = \"soft\"\nradius = 0.005\ndensity = 2500\n{keys}");
    GrainsScene::parse("tiny.toml", &text, &[]).unwrap()
}

fn exported(keys: &str) -> Export {
    start(&soft(keys)).unwrap()
}

/// Script and data must have these texts, in this order.
fn assert_has(script: &str, texts: &[&str]) {
    let mut rest = script;
    for text in texts {
        let at = rest.find(text);
        let at = at.unwrap_or_else(|| panic!("`{text}` is missing in\n{rest}"));
        rest = &rest[at + text.len()..];
    }
}

/// Numbers behind a word of a script.
fn numbers(script: &str, behind: &str) -> Vec<f64> {
    let at = script.find(behind).unwrap() + behind.len();
    let words = script[at..].split_whitespace();
    words.map_while(|word| word.parse().ok()).collect()
}

#[test]
fn the_grains_of_the_data_are_those_of_the_run_to_the_bit() {
    let keys = "width = 0.05\ncount = 40\nduration = 1\nradius_spread = 0.3\nrough_floor = 0.004";
    let scene = soft(keys);
    let (_, ours) = GrainsBody::place(&scene, &mut |_| ControlFlow::Continue(())).unwrap();
    let (read, spheres) = read_spheres(&start(&scene).unwrap().data).unwrap();
    assert_eq!(read.atoms.positions, ours.positions);
    let kinds: Vec<u8> = read.atoms.species.iter().map(|kind| kind + 1).collect();
    assert_eq!(kinds, ours.kinds.materials);
    for (a, b) in spheres.radii.unwrap().iter().zip(&ours.radii) {
        assert!((a / b - 1.0).abs() < 1e-15);
    }
}

#[test]
fn walls_and_loads_are_those_of_the_scene() {
    let column = exported(
        "width = 0.06\ncount = 40\nduration = 1\nboundary_x = \"walls\"\nboundary_y = \"walls\"\nside_wall_speed_z = 0.01\n\
         mu = 0.4\nrestitution = 1\nwall_contact = \"none\"",
    );
    assert_has(
        &column.script,
        &[
            "boundary m m m\n",
            "pair_coeff * * hooke 10000.0 damping 0.0 sliding 0.4 coupling separate torsion 0.0 torsion/spring inertia rolling \
             0.0\n",
            "fix move all nve/sphere\nfix weight all gravity 9.81 vector 0 0 -1\n",
            "fix walls all wall/gran/tribos hooke 10000.0 damping 0.0 zlo 0.0 xlo 0.0 velocity 0.0 0.0 0.01 xhi 0.06 velocity \
             0.0 0.0 0.01 ylo 0.0 velocity",
            "variable floor_force equal -f_walls[1][5]\n",
        ],
    );

    // A plate of 0.06 × 0.04 m² under 1000 Pa, then twice that, which slides.
    let shear = exported(
        "width = 0.06\ndepth = 0.04\nheight = 0.1\ncount = 40\nduration = 1\nboundary_z = \"walls\"\ngravity = 0\n\
         wall_stress_z = \"1:1000, 2:2000\"\nlid_speed_x = 0.1\npiston_mass = 0.5\nnormal_law = \"hertz\"",
    );
    let push = "(((time<=1.0)*1000.0+(time>1.0)*(time<=2.0)*(1000.0+1000.0*(time-1.0))+(time>2.0)*2000.0)*0.0024)";
    assert_has(
        &shear.script,
        &[
            "boundary p p m\n",
            "hertz 2000000.0 damping 1.0",
            &format!("variable zhi_push equal {}\n", &push[1..push.len() - 1]),
            " zlo 0.0 zhi 0.1 velocity 0.1 0.0 0.0 piston v_zhi_push 0.5\n",
        ],
    );
    assert!(!shear.script.contains("fix weight"));

    // Where two pistons move, the area of each follows the other.
    let pressed = exported(
        "width = 0.06\nheight = 0.1\ncount = 40\nduration = 1\nboundary_x = \"walls\"\nboundary_z = \"walls\"\nwall_stress_x = 100\n\
         wall_velocity_z = -0.01",
    );
    assert_has(
        &pressed.script,
        &[
            "variable xhi_push equal 100.0*(0.06*(f_walls[2][1]-f_walls[1][1]))\n",
            " zhi 0.1 velocity 0.0 0.0 -0.01 xlo 0.0 xhi 0.06 piston v_xhi_push ",
        ],
    );

    let shaken = exported(
        "width = 0.06\ncount = 40\nduration = 1\nshake_amplitude = 0.001\nshake_frequency = 10\nrough_floor = 0.005\n\
         gravity_angle = \"0:10, 1:20\"\nramp_period = 2",
    );
    assert_has(
        &shaken.script,
        &[
            "variable clock equal time-2.0*floor(time/2.0)\n",
            "group fixed type 7\n",
            "fix move_fixed fixed move variable NULL NULL NULL v_fixed_x v_fixed_y v_fixed_z\n",
            "fix weight free gravity 9.81 chute v_gravity_angle\n",
            "fix walls free wall/gran/tribos ",
            " zlo 0.0 velocity 0.0 0.0 v_zlo_z\n",
            "variable floor_force equal -f_walls[1][5]-c_on_fixed[3]\n",
        ],
    );
    assert!(
        shaken
            .script
            .contains("variable zlo_z equal 0.06283185307179587*cos(62.8318530717958")
    );
}

#[test]
fn held_grains_have_their_groups_and_velocities() {
    let files = exported(
        "width = 0.06\nheight = 0.1\ncount = 40\nduration = 1\nboundary_z = \"walls\"\nrough_lid = 0.005\nlid_speed_x = 0.2\n\
         intruder_radius = 0.01\nintruder_position = \"0.03, 0.03, 0.02\"\ndriven_velocity_z = \"0:0, 1:0.1\"",
    );
    assert_has(
        &files.script,
        &[
            "variable driven_z equal ((time<=0.0)*0.0+",
            "group driven type 8\ngroup lid type 9\ngroup bound union driven lid\ngroup free subtract all bound\n",
            "fix move_driven driven move variable NULL NULL NULL v_driven_x v_driven_y v_driven_z\n",
            "fix move_lid lid move linear 0.2 0.0 0.0\n",
            "fix force_on bound store/force\nfix hold bound freeze\n",
            "fix weight free gravity",
            "variable plate_force equal f_walls[2][5]+c_on_lid[3]\n",
            "variable driven_force_x equal c_on_driven[1]\n",
        ],
    );
}

#[test]
fn plates_of_a_hopper_lie_in_its_walls() {
    for boundary in ["walls", "periodic"] {
        for angle in [0.5, 30.0, 89.0] {
            let keys = format!(
                "width = 0.16\ndepth = 0.03\nboundary_x = \"{boundary}\"\ncontainer = \"hopper\"\ncount = 20\nduration = 1\n\
                 orifice_width = 0.05\norifice_height = 0.08\nhopper_angle = {angle}\nopen_time = 0.5"
            );
            let scene = soft(&keys);
            let script = start(&scene).unwrap().script;
            let (body, _) = GrainsBody::place(&scene, &mut |_| ControlFlow::Continue(())).unwrap();
            let slopes = body
                .layout
                .parts
                .iter()
                .filter(|part| part.face == WallId::Slope);
            for ((name, side), wall) in [("left", -1.0), ("right", 1.0)].iter().zip(slopes) {
                let [x0, x1, y0, y1, z0, z1, _, lean, _] =
                    numbers(&script, &format!("region {name} prism "))[..]
                else {
                    panic!("{script}")
                };
                // The face towards the grains begins at the slot and has the plane of the wall.
                let x = if *side < 0.0 { x1 } else { x0 };
                assert!((x - 0.08 - side * 0.025).abs() < 1e-12 && z0 == 0.08);
                for corner in [Vector3::new(x, 0.0, z0), Vector3::new(x + lean, 0.0, z1)] {
                    let off = wall.inward.dot(&corner) - wall.place;
                    assert!(off.abs() < 1e-12, "{boundary} {angle}: {off}");
                }
                // It reaches the side of the box, and ends there where its image begins.
                let reach = side * (x + lean) - side * 0.08;
                assert!(if boundary == "walls" {
                    reach > 0.085
                } else {
                    (reach - 0.08).abs() < 1e-12
                });
                assert!(y0 < -0.005 && y1 > 0.035 && x0 < x1);
                assert_eq!(
                    script.contains(&format!("region {name}_image")),
                    boundary == "periodic"
                );
            }
            assert_has(
                &script,
                &[
                    "region gate block 0.055 0.105",
                    "# The slot opens.\nrun ",
                    "unfix gate\nrun ",
                ],
            );
        }
    }
}

#[test]
fn a_drum_turns_as_its_scene_says() {
    let drum = "container = \"drum\"\nwidth = 0.2\ncount = 20\nduration = 1\ndimension = 2";
    let steady = exported(&format!("{drum}\ndrum_angular_velocity = -0.5"));
    assert_has(
        &steady.script,
        &[
            "boundary m m m\n",
            "variable drum_angle equal (-0.5)*time\n",
            "region drum cylinder y 0.1 0.1 0.1 INF INF side in rotate v_drum_angle 0.1 0 0.1 0 1 0 units box\n",
            " region drum\n",
        ],
    );
    assert!(
        steady
            .notes
            .iter()
            .any(|note| note.contains("64 plane sides"))
    );
}

#[test]
fn what_lammps_cannot_hold_is_refused_with_its_key() {
    let bed = "width = 0.06\ncount = 40\nduration = 1\n";
    let told = |keys: &str| match start(&soft(&format!("{bed}{keys}"))) {
        Err(ExportError::Beyond { key, .. }) => key,
        other => panic!("{keys}: {other:?}"),
    };
    assert_eq!(told("mesh = \"no.stl\""), "mesh");
    assert_eq!(told("wall_velocity_x = -0.01"), "wall_velocity_x");
    assert_eq!(
        told("height = 0.1\nboundary_z = \"periodic\"\ngravity = 0\nwall_stress_z = 10"),
        "wall_stress_z"
    );
    assert_eq!(
        told("height = 0.1\nboundary_z = \"periodic\"\ngravity = 0\nshear_rate = 1"),
        "shear_rate"
    );
    let two = "materials = \"a; b: mu=0.2, share=0.5\"\n";
    assert_eq!(told(two), "materials");
    assert_eq!(told("mu_second = 0.2\nsecond_fraction = 0.5"), "mu_second");
    assert!(matches!(
        start(&GrainsScene::default()),
        Err(ExportError::Rigid)
    ));
}

#[test]
fn every_pair_of_types_has_its_law() {
    let bed = "width = 0.06\ncount = 40\nduration = 1\nrough_floor = 0.005\ndamping_ratio = 0.25\n";
    let three = exported(&format!(
        "{bed}materials = \"a: mu=0.5; b: mu=0.2, share=0.3, stiffness=3e4; c: mu=0.5, share=0.1\"\n\
         pairs = \"b-c: mu=0.1, restitution=1; b-walls: mu=0.5, stiffness=1e4\"\n"
    ));
    let law = |k: f64, zeta: f64, mu: f64| {
        format!(
            "hooke {k:?} damping {zeta:?} sliding {mu:?} coupling separate torsion 0.0 torsion/spring inertia rolling 0.0\n"
        )
    };
    let mixed = |a: f64, b: f64| (a * b).sqrt();
    // Grains on the floor, of type 7, are of the first material, as is what c has of its own.
    let series = 2.0 / (1.0 / 1e4 + 1.0 / 3e4);
    let of_b = law(series, 0.25, mixed(0.5, 0.2));
    assert_has(
        &three.script,
        &[
            &format!(
                "pair_style gran/tribos\npair_coeff * * {}",
                law(1e4, 0.25, 0.5)
            ),
            &format!("pair_coeff 1 2 {of_b}"),
            &format!("pair_coeff 2 2 {}", law(3e4, 0.25, 0.2)),
            &format!("pair_coeff 2 3 {}", law(series, 0.0, 0.1)),
            &format!("pair_coeff 2 7 {of_b}"),
            "neighbor ",
            "fix walls free wall/gran/tribos hooke 10000.0 damping 0.25 sliding 0.5 ",
        ],
    );
    assert_eq!(three.script.matches("pair_coeff").count(), 5);
    // Without walls they may differ at them.
    let free = format!(
        "{bed}boundary_z = \"periodic\"\nheight = 0.06\ngravity = 0\nmaterials = \"a; b: mu=0.2, share=0.5\"\n"
    );
    assert!(start(&soft(&free.replace("rough_floor = 0.005\n", ""))).is_ok());
}

#[test]
fn steps_are_as_short_as_the_fall_and_the_springs_ask() {
    let step = |keys: &str| {
        let script = exported(&format!("width = 0.06\ncount = 40\nduration = 1\n{keys}")).script;
        numbers(&script, "timestep ")[0]
    };
    let plain = step("");
    // A hundredfold stiffness: a tenth of the step.
    assert!((step("stiffness = 1e6") / plain - 0.1).abs() < 1e-6);
    // Hertz contacts stiffen with the load.
    assert!(step("normal_law = \"hertz\"\ngravity = 98.1") < step("normal_law = \"hertz\""));
    // The stiffest of several materials decides.
    let steel =
        "materials = \"a; b: share=0.1, stiffness=1e6\"\npairs = \"b-walls: stiffness=1e4\"";
    assert!((step(steel) / plain - 0.1).abs() < 1e-6);
    // A wall or a glued grain weighs nothing in it.
    assert_eq!(step("rough_floor = 0.001"), plain);
}
