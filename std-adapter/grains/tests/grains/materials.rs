//! Grains of several materials, rigid and on springs, against closed forms.

use std::f64::consts::PI;
use tribos_base::run::run_to_end;
use tribos_grains::grains::{GrainsSimulation, stable_step};
use tribos_grains::scene::GrainsScene;

type Answer = Result<(), Box<dyn std::error::Error>>;

const METHODS: [&str; 2] = [
    "method = \"contact-dynamics\"\ntolerance = 1e-12\n",
    "method = \"soft\"\nstiffness = 1e5\nsteps_per_collision = 100\n",
];
const RADIUS: f64 = 0.005;
const GRAVITY: f64 = 9.81;

fn read(keys: &str) -> Result<GrainsScene, String> {
    let text = format!("body = \"grains\"\nradius = 0.005\ndensity = 2500\n{keys}");
    GrainsScene::parse("materials.toml", &text, &[]).map_err(|error| error.to_string())
}

/// A run to its end from these rows of `x,y,z,type,vx,vy,vz`, with keys of the scene.
fn run(rows: &str, keys: &str) -> Result<GrainsSimulation, Box<dyn std::error::Error>> {
    let home = tempfile::tempdir()?;
    let file = home.path().join("grains.csv");
    std::fs::write(&file, format!("x,y,z,type,vx,vy,vz\n{rows}"))?;
    let path = file.display();
    let scene = read(&format!(
        "width = 0.2\ninitial_state = \"{path}\"\ncolumns = \"radius=all:0.005\"\n{keys}"
    ))?;
    let mut grains = GrainsSimulation::new(&scene)?;
    run_to_end(&mut grains, |_, _| ())?;
    Ok(grains)
}

/// Motion of each grain: place, velocity and spin.
fn motions(grains: &GrainsSimulation) -> Vec<[[f64; 3]; 3]> {
    grains.with_snapshot(|now| {
        let vectors = |all: Option<&[nalgebra::Vector3<f64>]>, i: usize| {
            all.map_or([f64::NAN; 3], |all| [all[i].x, all[i].y, all[i].z])
        };
        let of = |i: usize| {
            let place = now.positions[i];
            let (velocity, spin) = (vectors(now.velocities, i), vectors(now.spins, i));
            [[place.x, place.y, place.z], velocity, spin]
        };
        (0..now.radii.len()).map(of).collect()
    })
}

/// Mass of a grain of a density.
fn mass(density: f64) -> f64 {
    density * 4.0 / 3.0 * PI * RADIUS * RADIUS * RADIUS
}

/// Three materials whose pairs have restitutions and coefficients of their own.
const THREE: &str = "materials = \"a: restitution=0.9, mu=0.4; b: density=7800, restitution=0.4, mu=0.1; c: density=1000, restitution=0.6\"\n\
                     pairs = \"a-b: restitution=0.5, mu=0.05; c-b: mu=0.02\"\nmu = 0.3\n";

#[test]
fn grains_part_with_the_restitution_and_slide_with_the_coefficient_of_their_pair() -> Answer {
    let mean = |a: f64, b: f64| (a * b).sqrt();
    // Types, restitution, coefficient: given, given in the other order, and mixed.
    let pairs = [
        ([1, 1], 0.9, 0.4),
        ([1, 2], 0.5, 0.05),
        ([2, 1], 0.5, 0.05),
        ([2, 2], 0.4, 0.1),
        ([1, 3], mean(0.9, 0.6), mean(0.4, 0.3)),
        ([2, 3], mean(0.4, 0.6), 0.02),
        ([3, 3], 0.6, 0.3),
    ];
    // The first of two grains, a micrometre apart, meets the second along x and slides past it along y.
    let speed = [1.0, 3.0];
    let mut rows = String::new();
    for (row, ([a, b], ..)) in pairs.iter().enumerate() {
        let z = 0.02 + 0.024 * row as f64;
        rows += &format!("0.08,0.1,{z},{a},1,3,0\n0.090001,0.100003,{z},{b},0,0,0\n");
    }
    let keys = "gravity = 0\nboundary_z = \"periodic\"\nheight = 0.2\nduration = 3e-5\n";
    for method in METHODS {
        // A collision in which no grain goes round the other.
        let method = method.replace("1e5", "1e10");
        let ends = motions(&run(&rows, &format!("{keys}{THREE}{method}"))?);
        for ((kinds, e, mu), two) in pairs.iter().zip(ends.chunks(2)) {
            let ([_, a, _], [_, b, _]) = (two[0], two[1]);
            let message = format!("{method}{kinds:?}: {a:?} {b:?}");
            assert!(
                ((b[0] - a[0]) / e / speed[0] - 1.0).abs() < 4e-3,
                "{message}"
            );
            // The masses are those of the types, and friction is at its threshold throughout.
            let [mass_a, mass_b] = kinds.map(|kind| [2500.0, 7800.0, 1000.0][kind - 1]);
            assert!(
                (mass_a * (speed[0] - a[0]) / (mass_b * b[0]) - 1.0).abs() < 1e-9,
                "{message}"
            );
            let drag = (speed[1] - a[1]) / (speed[0] - a[0]);
            assert!((drag / mu - 1.0).abs() < 0.02, "{message}");
        }
    }
    Ok(())
}

#[test]
fn a_grain_slides_down_a_plane_above_its_own_limit_of_rolling() -> Answer {
    // A sphere that rolls down a plane needs a friction of 2/7 tan(angle); beyond it it slides with g (sin - mu cos).
    let mus = [0.1, 0.2, 0.4];
    let materials = "materials = \"a: mu=0.1; b: mu=0.6; c\"\npairs = \"b-walls: mu=0.2; c-walls: mu=0.4; a-b: mu=0\"\nmu = 0.7\n";
    let rows = "0.03,0.05,0.005,1,0,0,0\n0.03,0.1,0.005,2,0,0,0\n0.03,0.15,0.005,3,0,0,0\n";
    let (time, over) = (0.1, 3.5);
    for limit in mus {
        for (share, beyond) in [(0.97, false), (1.03, true)] {
            let slope: f64 = share * over * limit;
            let angle = libm::atan(slope);
            let keys = format!(
                "duration = {time}\ngravity_angle = {}\nmax_time_step = 1e-4\n{materials}",
                angle.to_degrees()
            );
            for method in METHODS {
                let ends = motions(&run(rows, &format!("{keys}{method}"))?);
                for (mu, [_, velocity, spin]) in mus.into_iter().zip(ends) {
                    let slides = if mu == limit {
                        beyond
                    } else {
                        slope > over * mu
                    };
                    let wanted = GRAVITY
                        * time
                        * if slides {
                            libm::sin(angle) - mu * libm::cos(angle)
                        } else {
                            5.0 / 7.0 * libm::sin(angle)
                        };
                    let message = format!("{method}{mu} at {slope}: {velocity:?} {spin:?}");
                    assert!((velocity[0] / wanted - 1.0).abs() < 3e-3, "{message}");
                    let slip = velocity[0] - spin[1] * RADIUS;
                    assert_eq!(slip > 0.01 * velocity[0], slides, "{message}");
                }
            }
        }
    }
    Ok(())
}

#[test]
fn a_steel_grain_on_a_glass_one_sinks_as_far_as_hertz_says() -> Answer {
    let rows = "0.1,0.1,0.005,1,0,0,0\n0.1,0.1,0.015,2,0,0,0\n";
    let keys = "method = \"soft\"\nfixed_kinds = \"1\"\nduration = 0.3\n";
    let overlap = |materials: &str| -> Result<f64, Box<dyn std::error::Error>> {
        let ends = motions(&run(rows, &format!("{keys}{materials}"))?);
        Ok(2.0 * RADIUS - (ends[1][0][2] - ends[0][0][2]))
    };
    let weight = GRAVITY * mass(7800.0);

    // 1/E* = (1 - nu²)/E of both, r_eff = R/2 and W = 4/3 E* sqrt(r_eff) d^(3/2); a thousandth of the moduli of glass and steel.
    let hertz = "materials = \"glass: young_modulus=7e7, poisson_ratio=0.22; steel: density=7800, young_modulus=2e8, poisson_ratio=0.3\"\n";
    let modulus = 1.0 / ((1.0 - 0.22_f64 * 0.22) / 7e7 + (1.0 - 0.3_f64 * 0.3) / 2e8);
    let root = (0.5 * RADIUS).sqrt();
    let depth = libm::pow(0.75 * weight / (modulus * root), 2.0 / 3.0);
    let found = overlap(hertz)?;
    assert!((found / depth - 1.0).abs() < 1e-6, "{found} {depth}");

    // Springs of 3 kN/m and 6 kN/m in series, each twice as stiff on its own side: 4 kN/m; or what a pair is given.
    let linear = "materials = \"glass: stiffness=3e3; steel: density=7800, stiffness=6e3\"\n";
    for (pairs, k) in [("", 4e3), ("pairs = \"steel-glass: stiffness=1e3\"\n", 1e3)] {
        let found = overlap(&format!("{linear}{pairs}"))?;
        assert!((found / (weight / k) - 1.0).abs() < 1e-6, "{found} {k}");
    }
    Ok(())
}

/// Grains that fall on a floor under these keys: every line of their series.
fn series(keys: &str) -> Result<Vec<Vec<f64>>, Box<dyn std::error::Error>> {
    let scene = read(&format!(
        "width = 0.05\ncount = 60\nduration = 0.25\n{keys}"
    ))?;
    let mut grains = GrainsSimulation::new(&scene)?;
    run_to_end(&mut grains, |_, _| ())?;
    Ok(grains.series().iter().map(|row| row.to_vec()).collect())
}

#[test]
fn equal_materials_and_the_short_form_give_the_bits_of_one_material_and_of_two() -> Answer {
    for method in [
        "method = \"soft\"\nrestitution = 0.5\n",
        "method = \"contact-dynamics\"\n",
    ] {
        let of = |keys: &str| series(&format!("{method}{keys}"));
        assert_eq!(
            of("")?,
            of("materials = \"a; b: share=0.4; c: share=0.1, mu=0.5\"\n")?
        );
        let second =
            "second_fraction = 0.4\nsecond_radius = 0.7\nsecond_density = 7800\nmu_second = 0.2\n";
        let long = "materials = \"a; b: share=0.4, radius=0.7, density=7800, mu=0.2\"\n";
        let two = of(&format!("{second}mu_mixed = 0.05\n"))?;
        assert_eq!(two, of(&format!("{long}pairs = \"b-a: mu=0.05\"\n"))?);
        assert_eq!(of(second)?, of(long)?);
        assert_ne!(of(second)?, two);
        // The name of a material is no number.
        assert_ne!(
            of(long)?,
            of(&long.replace("mu=0.2", "mu=0.2, restitution=0.9"))?
        );
    }
    Ok(())
}

#[test]
fn types_of_a_file_are_the_materials_in_their_order() -> Answer {
    let rows = "0.05,0.05,0.005,1,0,0,0\n0.1,0.05,0.005,2,0,0,0\n0.15,0.05,0.005,3,0,0,0\n0.1,0.15,0.005,7,0,0,0\n";
    let keys = format!("gravity = 0\nduration = 1e-3\n{THREE}");
    let grains = run(rows, &keys)?;
    grains.with_snapshot(|now| {
        assert_eq!(now.materials, Some(&[1, 2, 3, 7][..]));
        assert_eq!(now.densities, Some(&[2500.0, 7800.0, 1000.0, 2500.0][..]));
    });
    let refused = run(&rows.replace("5,3,", "5,4,"), &keys).err();
    let told = refused.map(|error| error.to_string()).unwrap_or_default();
    assert!(
        told.contains("type 4") && told.contains("are types 1 to 3"),
        "{told}"
    );
    Ok(())
}

#[test]
fn so_many_grains_of_each_material_are_drawn_with_its_radius_and_density() -> Answer {
    let scene = read(
        "width = 0.1\ncount = 101\nduration = 1\nmaterials = \"a: radius=1.2; b: share=0.2, radius=0.5; c: share=0.5, density=1000\"\n",
    )?;
    GrainsSimulation::new(&scene)?.with_snapshot(|now| {
        let kinds = now.materials.unwrap_or_default();
        let count = |kind: u8| kinds.iter().filter(|other| **other == kind).count();
        // Shares of 101 grains, rounded; the first has the rest.
        assert_eq!([1, 2, 3].map(count), [30, 20, 51]);
        let grains = kinds
            .iter()
            .zip(now.radii)
            .zip(now.densities.unwrap_or_default());
        for ((kind, radius), density) in grains {
            let wanted = [(1.2, 2500.0), (0.5, 2500.0), (1.0, 1000.0)][usize::from(*kind) - 1];
            assert_eq!((radius / RADIUS, *density), wanted);
        }
    });
    Ok(())
}

#[test]
fn the_step_is_that_of_the_stiffest_pair_and_the_lightest_grain() -> Answer {
    let soft = |keys: &str| {
        read(&format!(
            "method = \"soft\"\nwidth = 0.1\ncount = 20\nduration = 1\n{keys}"
        ))
    };
    let step = |keys: &str| -> Result<f64, String> { Ok(stable_step(&soft(keys)?).unwrap_or(0.0)) };
    // The collision of two grains takes the root of mass over stiffness.
    let one = step("stiffness = 1e4")?;
    let both = step(
        "materials = \"a: stiffness=1e4; b: stiffness=4e4, share=0.1; c: share=0.1, density=625\"",
    )?;
    assert!((both / one - 0.25).abs() < 1e-3, "{both} {one}");
    Ok(())
}

#[test]
fn what_materials_cannot_be_is_refused_with_entry_and_cure() {
    let soft = "method = \"soft\"\n";
    let two = "materials = \"glass: mu=0.5; steel\"\n";
    for (keys, told) in [
        (
            "materials = \"glass: mue=0.5\"".into(),
            &["`glass: mue=0.5`", "did you mean \"mu\"?"][..],
        ),
        (
            "materials = \"glass: mu=0,5\"".into(),
            &["`5` must be PROPERTY=NUMBER"],
        ),
        (
            "materials = \"glass: mu=high\"".into(),
            &["`glass: mu=high`", "`mu`"],
        ),
        (
            "materials = \"glass: mu=-1\"".into(),
            &["`mu` must be a finite number >= 0, not -1"],
        ),
        (
            "materials = \"glass: restitution=2\"".into(),
            &["a number from 0 to 1"],
        ),
        (
            "materials = \"glass: mu=1, mu=2\"".into(),
            &["`mu` is given twice"],
        ),
        (
            "materials = \"glass; glass\"".into(),
            &["`glass` is given twice"],
        ),
        ("materials = \"\"".into(), &["name something"]),
        ("materials = \"two words: mu=1\"".into(), &["`two words`"]),
        ("materials = \"walls\"".into(), &["another name than walls"]),
        (
            "materials = \"a; b; c; d; e; f; g\"".into(),
            &["there are 7", "at most 6"],
        ),
        (
            "materials = \"a; b: share=0.7; c: share=0.4\"".into(),
            &["add up to 1.1"],
        ),
        (
            "materials = \"a: share=0.5; b: share=0.4\"".into(),
            &["`a`, has the rest"],
        ),
        (
            "materials = \"a: radius=2\"\ninitial_state = \"x.xyz\"".into(),
            &["its own radii"],
        ),
        (
            format!("{two}second_fraction = 0.5"),
            &["`materials` or `second_fraction`"],
        ),
        (
            format!("{two}mu_mixed = 0.5"),
            &["`materials` or `mu_mixed`"],
        ),
        (
            "pairs = \"a-b: mu=1\"".into(),
            &["`pairs` names `materials`"],
        ),
        (
            format!("{two}pairs = \"glass-steal: mu=1\""),
            &["no material `steal`", "did you mean `steel`?"],
        ),
        (
            format!("{two}pairs = \"glass: mu=1\""),
            &["\"glass-steel\"", "\"glass-walls\""],
        ),
        (
            format!("{two}pairs = \"walls-glass: mu=1\""),
            &["no material `walls`", "walls behind"],
        ),
        (
            format!("{two}pairs = \"glass-glass: mu=1\""),
            &["give it there"],
        ),
        (
            format!("{two}pairs = \"glass-steel: mu=1; steel-glass: mu=1\""),
            &["as `glass-steel` before"],
        ),
        (
            format!("{two}pairs = \"glass-steel: density=1\""),
            &["density is of a material"],
        ),
        (
            format!("{two}wall_contact = \"smooth\"\npairs = \"glass-walls: mu=1\""),
            &["walls have no mu"],
        ),
        (
            "materials = \"a: young_modulus=1e9\"".into(),
            &["young_modulus is for method \"soft\" only"],
        ),
        (
            format!("{two}pairs = \"glass-steel: stiffness=1\""),
            &["stiffness is for method \"soft\" only"],
        ),
        (
            format!("{soft}materials = \"a: young_modulus=1e9; b\""),
            &["`b`: give its young_modulus"],
        ),
        (
            format!("{soft}materials = \"a: poisson_ratio=0.2\""),
            &["goes with young_modulus"],
        ),
        (
            format!("{soft}young_modulus = 1e9\nmaterials = \"a: stiffness=1\""),
            &["leave stiffness out"],
        ),
        (
            format!("{soft}stiffness = 1\nmaterials = \"a: young_modulus=1e9\""),
            &["not both"],
        ),
        (
            format!("{soft}normal_law = \"linear\"\nmaterials = \"a: young_modulus=1e9\""),
            &["`normal_law`"],
        ),
        (
            format!("{soft}young_modulus = 1e9\n{two}pairs = \"glass-steel: stiffness=1\""),
            &["of both; leave stiffness out"],
        ),
        (
            format!("{soft}damping_ratio = 0.5\nmaterials = \"a: restitution=0.5\""),
            &["`damping_ratio`"],
        ),
        (
            "mu_torsion = 0.1\ncoupling = \"exact\"\nmaterials = \"a; b: mu=0\"".into(),
            &["all contacts have mu and mu_torsion"],
        ),
    ] {
        let read = read(&format!(
            "width = 0.1\nduration = 1\n{}{keys}",
            if keys.contains("initial_state") {
                ""
            } else {
                "count = 9\n"
            }
        ));
        let message = read.map_or_else(|message| message, |_| "taken".into());
        for part in told {
            assert!(message.contains(part), "{keys}: {message}");
        }
    }
}
