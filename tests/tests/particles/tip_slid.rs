//! A tip that is slid: the support, its work, and the friction loop.

use tribos::scene::TipScene;
use tribos::tip::{SlidingSummary, TipSimulation};
use tribos_tests::tips::{tiny, to_the_end};

const SLID: &str = "body = \"tip\"\nsubstrate_columns = 12\nsubstrate_rows = 14\nsubstrate_layers = 4\ntip_layers = 4\ntip_side_atoms = 3\n\
                    spacing = 1.1\ndrive = \"slide\"\nspeed = 0.5\nstroke = 1.65\ndriven_constraint = \"level\"\n\
                    load = 0.5\nadhesion_energy = 0.3\nshift = \"force\"\nequilibration = 5\n\
                    drive_time = 9.9\nrest_time = 0";

type Error = Box<dyn std::error::Error>;

/// A short loop and a half: three strokes of a spacing and a half.
fn slid(keys: &[&str]) -> Result<TipScene, Error> {
    let keys: Vec<String> = keys.iter().map(|&key| key.into()).collect();
    Ok(TipScene::parse("tip.toml", SLID, &keys)?)
}

fn outcome(scene: &TipScene) -> Result<SlidingSummary, Error> {
    let mut run = TipSimulation::new(scene)?;
    to_the_end(&mut run)?;
    run.outcome().slid.ok_or_else(|| "it was not slid".into())
}

#[test]
fn the_supports_work_is_heat_and_stored_energy() -> Result<(), Error> {
    for (bath, integrator, direction) in [
        ("nose-hoover", "leap-frog", 0.0),
        ("nose-hoover", "velocity-verlet", 120.0),
        ("langevin", "leap-frog", -60.0),
        ("langevin", "velocity-verlet", 30.0),
        ("none", "velocity-verlet", 0.0),
    ] {
        let spin = if direction == 30.0 {
            "counts"
        } else {
            "spared"
        };
        let scene = slid(&[
            &format!("thermostat={bath}"),
            &format!("integrator={integrator}"),
            &format!("drive_angle={direction:?}"),
            &format!("spin={spin}"),
        ])?;
        let slid = outcome(&scene)?;
        let heat = slid.heat.abs() + slid.stored.abs();
        let error = (slid.work - slid.heat - slid.stored).abs();
        assert!(slid.work > 1.0, "{bath} {slid:?}");
        assert!(error < 0.02 * heat, "{bath} {integrator}: {slid:?}");
        assert_eq!((slid.strokes, slid.loops), (3, 1), "{bath}");
    }
    Ok(())
}

#[test]
fn a_tip_that_touches_nothing_follows_its_support_without_friction() -> Result<(), Error> {
    for bath in ["nose-hoover", "langevin"] {
        // So little adhesion that the substrate neither holds nor carries it.
        let scene = slid(&[
            &format!("thermostat={bath}"),
            "adhesion_energy=1e-14",
            "load=0",
            "drive_damping_rate=2",
            "temperature=1e-4",
            "stiffness=50",
            "speed=0.05",
            "stroke=2",
            "drive_time=40",
        ])?;
        let mut run = TipSimulation::new(&scene)?;
        to_the_end(&mut run)?;
        let slid = run.outcome().slid.ok_or("it was not slid")?;
        // Damping or a bath at rest in the box would resist with γ m v: 3.8 and 1.9.
        assert!(slid.friction_forth.abs() < 0.3, "{bath} {slid:?}");
        let columns = run.columns();
        let at = |name: &str| columns.iter().position(|column| column == name);
        let (support, tip) = (at("support").ok_or("none")?, at("tip").ok_or("none")?);
        for line in run.series() {
            assert!((line[support] - line[tip]).abs() < 0.2, "{bath}");
        }
    }
    Ok(())
}

#[test]
fn a_tip_resists_in_both_directions_and_more_under_load() -> Result<(), Error> {
    let mut friction = Vec::new();
    for load in ["0.5", "4.0"] {
        let load_key = format!("load={load}");
        let scene = slid(&[
            "speed=0.2",
            "drive_time=24.75",
            "stiffness=40",
            "drive_damping_rate=2",
            &load_key,
        ])?;
        let slid = outcome(&scene)?;
        assert!(slid.friction > 0.0, "{slid:?}");
        assert!(
            (slid.normal_force / 38.0 / load.parse::<f64>()? - 1.0).abs() < 0.5,
            "{slid:?}"
        );
        friction.push(slid.friction);
    }
    assert!(friction[1] > friction[0], "{friction:?}");
    Ok(())
}

#[test]
fn a_spring_twists_back_a_tip_that_is_turned_and_series_say_where_it_is() -> Result<(), Error> {
    let scene = slid(&["drive_angle=90", "samples=1"])?;
    let mut run = TipSimulation::new(&scene)?;
    to_the_end(&mut run)?;
    let columns = run.columns();
    let at = |name: &str| {
        let found = columns.iter().position(|column| column == name);
        found.ok_or_else(|| format!("no column {name}"))
    };
    let (support, tip, force) = (at("support")?, at("tip")?, at("lateral_force")?);
    let scene = &scene;
    for line in run.series() {
        // The support's way is the triangle of its speed; the spring's force is its length.
        let path = 0.5 * line[0].max(0.0);
        let phase = path % (2.0 * 1.65);
        let way = if phase <= 1.65 {
            phase
        } else {
            2.0 * 1.65 - phase
        };
        assert!((line[support] - way).abs() < 1e-9, "{line:?}");
        let spring = scene.stiffness * (line[support] - line[tip]);
        assert!((line[force] - spring).abs() < 1e-9, "{line:?}");
    }
    // The axis of the drive is y: the mean place of the driven atoms moved along it.
    let system = run.system();
    let driven = system.members(5);
    let sites = scene.shape().sites();
    let way = |axis: usize| {
        let ways = driven
            .iter()
            .map(|&atom| system.atoms().positions[atom][axis] - sites[atom].place[axis]);
        ways.sum::<f64>() / driven.len() as f64
    };
    let last = run.series().last().ok_or("no line")?;
    assert!(
        (way(1) - last[tip]).abs() < 1e-9,
        "{} {}",
        way(1),
        last[tip]
    );
    assert!(way(0).abs() < 0.5, "{}", way(0));
    Ok(())
}

#[test]
fn a_slid_tip_has_a_speed_and_no_torque() {
    for (text, words) in [
        ("drive = \"slide\"", "`lambda` is missing"),
        ("drive = \"slide\"\nlambda = 1", "`speed` is missing"),
        ("drive = \"slide\"\nlambda = 1\nspeed = 1", "not both"),
        ("speed = 1", "`speed` is for drive \"slide\" only"),
        ("drive = \"slide\"\nspeed = 0", "`speed` must be"),
        (
            "drive = \"slide\"\nspeed = 200",
            "more than half the spacing",
        ),
        ("drive = \"slide\"\nspeed = 1\nstroke = 1e-4", "`stroke` is"),
        (
            "lambda = 1\nstiffness = 3",
            "`stiffness` is for drive \"slide\" only",
        ),
        (
            "drive = \"pull\"\nspeed = 1",
            "one of \"torque\", \"slide\"",
        ),
    ] {
        match tiny(text) {
            Err(error) => assert!(error.to_string().contains(words), "{text}: {error}"),
            Ok(_) => assert_eq!(text, "", "it was not refused"),
        }
    }
}
