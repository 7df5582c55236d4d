//! A tip's checkpoints and its results: the same bits, whatever the breaks and the threads.

use tribos::record::CheckpointError;
use tribos::run::Simulation;
use tribos::scene::{DriveKind, TipScene};
use tribos::tip::{Reversal, TipError, TipSimulation};
use tribos_tests::tips::{scene, tiny, to_the_end};

type Error = Box<dyn std::error::Error>;

/// Every thermostat with both integrators; a thin skin, so that lists are built on the way.
fn kinds() -> Result<Vec<TipScene>, Error> {
    let mut scenes = Vec::new();
    for bath in [
        "thermostat = \"nose-hoover\"",
        "thermostat = \"nose-hoover\"\nspin = \"counts\"\nadhesion_energy = 0.5",
        "thermostat = \"langevin\"\ndriven_constraint = \"level\"\nload = 0.5",
        "thermostat = \"none\"\noutline = \"disk\"\ntip_orientation = 20",
    ] {
        for integrator in ["leap-frog", "velocity-verlet"] {
            scenes.push(tiny(&format!(
                "{bath}\nintegrator = \"{integrator}\"\nlambda = 0.5\nskin = 0.05\nsample_every = 7\n\
                 equilibration = 0.1\ndrive_time = 0.1\nrest_time = 0.1"
            ))?);
        }
    }
    // Slid tips, with turning points on the way.
    for bath in ["nose-hoover", "langevin"] {
        scenes.push(tiny(&format!(
            "thermostat = \"{bath}\"\ndrive = \"slide\"\nspeed = 2\nstroke = 0.07\nskin = 0.05\n\
             samples = 7\nequilibration = 0.1\ndrive_time = 0.1\nrest_time = 0.1"
        ))?);
    }
    Ok(scenes)
}

#[test]
fn a_run_goes_on_from_any_line_of_its_series_to_the_same_bits() -> Result<(), Error> {
    for scene in kinds()? {
        let mut whole = TipSimulation::new(&scene)?;
        let mut kept = vec![whole.checkpoint()];
        loop {
            let goes_on = whole.step()?;
            kept.push(whole.checkpoint());
            if !goes_on {
                break;
            }
        }
        // 60 steps in stretches of 7.
        assert_eq!(kept.len(), 10);
        assert!(whole.system().list_builds() > 2);
        for text in &kept {
            let mut resumed = TipSimulation::resume(&scene, text)?;
            assert_eq!(*text, resumed.checkpoint());
            to_the_end(&mut resumed)?;
            assert!(resumed.checkpoint() == whole.checkpoint());
            assert_eq!(resumed.system().state(), whole.system().state());
            assert_eq!(resumed.series(), whole.series());
            assert_eq!(
                resumed.outcome().json(&scene).to_string(),
                whole.outcome().json(&scene).to_string()
            );
        }
        assert_eq!(whole.progress(), 1.0);
        let is_open = whole.outcome().verdict == Reversal::Open;
        assert_eq!(is_open, scene.drive == DriveKind::Slide);
    }
    Ok(())
}

#[test]
fn a_damaged_checkpoint_is_refused_with_what_is_wrong() -> Result<(), Error> {
    let scene = kinds()?.swap_remove(0);
    let mut run = TipSimulation::new(&scene)?;
    run.step()?;
    let text = run.checkpoint();
    let nan = "7ff8000000000000";
    let hex = |name: &str| -> Result<[&str; 3], Error> {
        let (before, rest) = text
            .split_once(&format!("\"{name}\":\""))
            .ok_or("no such part")?;
        let (digits, after) = rest.split_once('"').ok_or("no end")?;
        Ok([before, digits, after])
    };
    for name in [
        "positions",
        "velocities",
        "list",
        "thermostats",
        "angles",
        "work",
        "heat",
        "lines",
        "series",
    ] {
        let [before, digits, after] = hex(name)?;
        let with = |digits: &str| format!("{before}\"{name}\":\"{digits}\"{after}");
        assert_eq!(with(digits), text);
        let mut damages = vec![
            with(""),
            with(&digits[16..]),
            with(&format!("{digits}{nan}")),
            with(&digits[1..]),
            with(&format!("x{}", &digits[1..])),
            text.replacen(&format!("\"{name}\":"), "\"other\":", 1),
        ];
        if !["lines", "series"].contains(&name) {
            damages.push(with(&format!("{nan}{}", &digits[16..])));
        }
        for damaged in damages {
            match TipSimulation::resume(&scene, &resealed(&damaged)) {
                Err(TipError::Checkpoint(CheckpointError::Format(said))) => {
                    assert!(said.contains(&format!("`{name}`")), "{name}: {said}");
                }
                other => return Err(format!("{name}: {:?}", other.is_ok()).into()),
            }
        }
    }
    for (from, to, words) in [
        ("\"steps\":7", "\"steps\":-7", "`steps`"),
        ("\"steps\":7", "\"steps\":18446744073709551615", "`steps`"),
        ("\"steps\":7", "\"steps\":61", "`steps`"),
        ("\"steps\":7", "\"steps\":15", "`lines`"),
        ("\"tribos_tip\":3", "\"tribos_tip\":4", "has format 4"),
        ("{", "[", "damaged"),
    ] {
        assert!(text.contains(from), "{from}");
        match TipSimulation::resume(&scene, &resealed(&text.replacen(from, to, 1))) {
            Err(error) => assert!(error.to_string().contains(words), "{to}: {error}"),
            Ok(_) => return Err(to.into()),
        }
    }
    Ok(())
}

/// With the digest of what it says now.
fn resealed(text: &str) -> String {
    let (body, _) = text.rsplit_once("\"digest\"").unwrap_or((text, ""));
    let digits = tribos::record::digest(body.as_bytes());
    format!("{body}\"digest\":\"{digits:032x}\"}}\n")
}

#[test]
fn a_checkpoint_of_another_scene_is_refused_with_the_key() -> Result<(), Error> {
    let text = TipSimulation::new(&tiny("lambda = 0.02")?)?.checkpoint();
    for (other, key) in [
        ("lambda = 0.03", "lambda"),
        ("lambda = 0.02\nseed = 2", "seed"),
        (
            "lambda = 0.02\ndriven_constraint = \"level\"",
            "driven_constraint",
        ),
        ("lambda = 0.02\noutline = \"cone\"", "outline"),
    ] {
        match TipSimulation::resume(&tiny(other)?, &text) {
            Err(TipError::Checkpoint(CheckpointError::Scene { key: found, .. })) => {
                assert_eq!(found, key);
            }
            other => return Err(format!("{key}: {:?}", other.is_ok()).into()),
        }
    }
    Ok(())
}

#[test]
fn results_do_not_depend_on_the_number_of_threads() -> Result<(), Error> {
    // Several chunks of the list.
    let text = "body = \"tip\"\nsubstrate_columns = 40\nsubstrate_rows = 40\nsubstrate_layers = 4\ntip_layers = 4\n\
                tip_side_atoms = 8\nlambda = 0.5\nskin = 0.1\nequilibration = 0.05\ndrive_time = 0.15\n\
                rest_time = 0.05\nsample_every = 10";
    let mut ends = Vec::new();
    for bath in ["nose-hoover", "langevin"] {
        let scene = scene(&format!("{text}\nthermostat = \"{bath}\""))?;
        for threads in [1, 2, 3] {
            let pool = rayon::ThreadPoolBuilder::new()
                .num_threads(threads)
                .build()?;
            let end = pool.install(|| -> Result<String, TipError> {
                let mut run = TipSimulation::new(&scene)?;
                while run.step()? {}
                Ok(run.checkpoint())
            })?;
            ends.push(end);
        }
    }
    assert!(ends.chunks(3).all(|of| of[0] == of[1] && of[1] == of[2]));
    assert!(ends[0] != ends[3]);
    Ok(())
}
