//! `tribos run` and `tribos sweep` of powders: complete, resumable, repeatable results.

use crate::program::{self, Error, Outcome, assert_has, json, number, prepared, summary, wait_for};
use serde_json::Value;
use std::path::Path;

/// Some twenty spheres.
const TINY: &str =
    "body = \"powder\"\nwidth = 8\nheight = 12\npressure = 0.01\npiston_mass = 100\n";

/// A command that works in the folder, where the scene is `tiny.toml`: what was said.
fn succeed(folder: &Path, command: &str) -> Result<[String; 2], Error> {
    std::fs::write(folder.join("tiny.toml"), TINY)?;
    program::succeed(folder, command)
}

#[test]
fn a_run_leaves_summary_series_states_and_pictures() -> Outcome {
    let folder = tempfile::tempdir()?;
    let out = folder.path().join("out");
    let run = "run tiny.toml --set mu_rolling=0.3 --out out";
    let [told, _] = succeed(folder.path(), run)?;
    assert_has(
        &told,
        &["blocked: ", "stress_zz", "of which", "rolling", "imbalance"],
    );

    let summary = summary(&out)?;
    assert_eq!(summary["ending"], "blocked");
    for place in [
        "/porosity_initial",
        "/porosity_final",
        "/particles",
        "/contacts",
        "/steps",
        "/iterations_total",
        "/stress_zz_plus",
        "/stress_zz_minus",
        "/residual_final",
        "/max_overlap",
        "/wall_seconds",
        "/dissipation/normal",
        "/dissipation/sliding",
        "/dissipation/rolling",
        "/dissipation/torsion",
        "/dissipation/cohesion",
        "/scene/pressure",
    ] {
        assert!(number(&summary, place).is_finite(), "{place}");
    }
    assert!((number(&summary, "/stress_zz") - 1.0).abs() < 0.01);
    assert_eq!(summary["scene"]["mu_rolling"].as_f64(), Some(0.3));
    // Porosity, spheres and heights belong together (eq. 4.5).
    let solid = number(&summary, "/particles") * 4.0 / 3.0 * std::f64::consts::PI;
    for end in ["initial", "final"] {
        let height = number(&summary, &format!("/height_{end}"));
        let porosity = number(&summary, &format!("/porosity_{end}"));
        assert!((1.0 - solid / (64.0 * height) - porosity).abs() < 1e-12);
    }
    // The pressure does its work on the way of the piston.
    let way = number(&summary, "/height_initial") - number(&summary, "/height_final");
    assert!((number(&summary, "/energy/work") / (0.64 * way) - 1.0).abs() < 1e-9);
    // The substrate and the piston count twice in no list of contacts.
    let ends: f64 = summary["statistics"]["coordination"]
        .as_array()
        .into_iter()
        .flatten()
        .enumerate()
        .map(|(n, spheres)| n as f64 * spheres.as_f64().unwrap_or(f64::NAN))
        .sum();
    let walls = number(&summary, "/statistics/wall_contacts");
    assert_eq!(ends, 2.0 * number(&summary, "/contacts") + walls);

    let series = std::fs::read_to_string(out.join("series.csv"))?;
    assert!(series.starts_with("time,step,piston_height,porosity,contacts,stress_zz,sweeps,"));
    let last: Vec<f64> = series
        .lines()
        .last()
        .unwrap_or_default()
        .split(',')
        .map(str::parse)
        .collect::<Result<_, _>>()?;
    assert_eq!(last[1], number(&summary, "/steps"));
    assert_eq!(last[3], number(&summary, "/porosity_final"));
    let particles = number(&summary, "/particles");
    for state in ["initial", "final"] {
        let xyz = std::fs::read_to_string(out.join(format!("{state}.xyz")))?;
        assert_eq!(xyz.lines().count() as f64, particles + 2.0);
        let vtp = std::fs::read_to_string(out.join(format!("{state}.vtp")))?;
        assert!(vtp.contains(&format!("NumberOfVerts=\"{particles}\"")));
    }
    let network = std::fs::read_to_string(out.join("final-contacts.vtp"))?;
    let lines = number(&summary, "/contacts") + walls;
    assert!(network.contains(&format!("NumberOfLines=\"{lines}\"")));
    for plot in ["packing.svg", "packing.png", "series.svg", "series.png"] {
        assert!(out.join(plot).metadata()?.len() > 1000, "{plot}");
    }
    assert!(!out.join("checkpoint.json").exists());
    Ok(())
}

/// A heavy piston that falls on spheres that rebound.
const CRUSHED: &str = "--set height=16 --set cohesion_range=0 --set restitution=0.5 --set pressure=10 \
                       --set piston_mass=1e4 --set max_steps=300";

#[test]
fn steps_that_end_approximately_are_told_and_counted() -> Outcome {
    let folder = tempfile::tempdir()?;
    let out = folder.path().join("out");
    let run = |keys: &str| -> Result<(String, Value), Error> {
        let [told, _] = succeed(folder.path(), &format!("run tiny.toml {keys} --out out"))?;
        Ok((told, summary(&out)?))
    };
    let lines = [
        ("impacts       cut in ", "steps_impacts_cut"),
        ("impacts       unmet in ", "steps_impacts_unmet"),
        ("unmet         ", "steps_solver_unmet"),
    ];
    // As few sweeps for lasting contacts as leave some of them unsolved.
    let (told, summary) = run(&format!("{CRUSHED} --set max_iterations=20"))?;
    let mut most = 0;
    let mut sum = 0;
    for (start, name) in lines {
        let line = told.lines().find_map(|line| line.strip_prefix(start));
        let word = line.and_then(|line| line.split(' ').next()).ok_or(start)?;
        let steps: u64 = word.parse()?;
        assert!(steps > 0 && summary[name] == steps, "{name}: {told}");
        (most, sum) = (most.max(steps), sum + steps);
    }
    // A step counts once, whatever it missed.
    let all = summary["steps_unmet"].as_u64().ok_or("a number")?;
    assert!((most..=sum).contains(&all), "{summary}");

    // Nothing is told of what did not happen, and nothing counted that cannot.
    let (told, summary) = run("--set max_steps=300")?;
    assert_eq!(summary["steps_unmet"], 0);
    for (start, name) in lines {
        assert!(!told.lines().any(|line| line.starts_with(start)), "{told}");
        assert_eq!(summary.get(name), None, "{name}");
    }
    Ok(())
}

#[test]
fn a_killed_run_goes_on_to_the_same_bits() -> Outcome {
    let folder = tempfile::tempdir()?;
    let [whole, broken] = ["whole", "broken"].map(|name| folder.path().join(name));
    let run = "run tiny.toml --set max_steps=400 --set mu_rolling=0.1";
    succeed(folder.path(), &format!("{run} --out whole"))?;

    // A checkpoint after every step, until the run is killed somewhere on its way.
    let under_way = format!("{run} --checkpoint 0 --out broken");
    let mut child = prepared(folder.path(), under_way).spawn()?;
    let steps = || json(&broken.join("checkpoint.json")).ok()?["steps"].as_u64();
    wait_for("a checkpoint", || steps() >= Some(30));
    child.kill()?;
    child.wait()?;
    let at = steps().unwrap_or(0);
    assert!((30..400).contains(&at), "killed at {at}");
    assert!(!broken.join("summary.json").exists());

    // Not for another scene.
    let (code, _, said) = program::tribos(folder.path(), "run tiny.toml --resume --out broken")?;
    assert_eq!(code, Some(2));
    assert!(
        said.contains("`mu_rolling` is") && said.contains("--anew"),
        "{said}"
    );

    let resume = format!("{run} --resume --out broken");
    succeed(folder.path(), &resume)?;
    for file in ["series.csv", "final.xyz", "final.vtp", "final-contacts.vtp"] {
        let bytes = std::fs::read(whole.join(file))?;
        assert!(bytes == std::fs::read(broken.join(file))?, "{file}");
    }
    let [mut one, mut other] = [summary(&whole)?, summary(&broken)?];
    for summary in [&mut one, &mut other] {
        summary["wall_seconds"] = 0.into();
    }
    assert_eq!(one, other);
    // Done: nothing is run, and nothing is changed.
    let left = std::fs::read(broken.join("summary.json"))?;
    let [told, _] = succeed(folder.path(), &resume)?;
    assert!(told.contains("finished already"), "{told}");
    assert!(std::fs::read(broken.join("summary.json"))? == left);
    Ok(())
}

#[test]
fn a_sweep_averages_its_runs_and_keeps_them() -> Outcome {
    let folder = tempfile::tempdir()?;
    let [serial, parallel] = ["serial", "parallel"].map(|name| folder.path().join(name));
    let sweep = |options: &str| -> Result<String, Error> {
        let keys = "--set mu_rolling=0,0.3 --set mu_torsion=0,0.3 --set max_steps=200 --seeds 2";
        let [_, said] = succeed(folder.path(), &format!("sweep tiny.toml {keys} {options}"))?;
        Ok(said)
    };
    assert_eq!(sweep("--jobs 1 --out serial")?.lines().count(), 8);
    sweep("--jobs 3 --out parallel")?;
    let table = std::fs::read_to_string(serial.join("sweep.csv"))?;
    assert_eq!(table, std::fs::read_to_string(parallel.join("sweep.csv"))?);

    // Means and deviations of two are half the sum and the difference over √2.
    let lines: Vec<Vec<&str>> = table
        .lines()
        .map(|line| line.split(',').collect())
        .collect();
    assert_eq!(lines.len(), 5);
    assert_eq!(
        lines[0][..6],
        [
            "mu_rolling",
            "mu_torsion",
            "max_steps",
            "runs",
            "blocked",
            "porosity_final"
        ]
    );
    assert_eq!(lines[2][..4], ["0", "0.3", "200", "2"]);
    let run = |seed: u32| {
        serial.join(format!(
            "runs/mu_rolling=0,mu_torsion=0.3,max_steps=200,seed={seed}"
        ))
    };
    let [a, b] = [
        number(&summary(&run(1))?, "/porosity_final"),
        number(&summary(&run(2))?, "/porosity_final"),
    ];
    let [mean, deviation]: [f64; 2] = [lines[2][5].parse()?, lines[2][6].parse()?];
    assert!(a != b && (mean - 0.5 * (a + b)).abs() < 1e-15);
    assert!((deviation - (a - b).abs() / 2.0_f64.sqrt()).abs() < 1e-15);
    for plot in ["sweep.svg", "sweep.png"] {
        assert!(serial.join(plot).metadata()?.len() > 1000, "{plot}");
    }

    // What was interrupted: one run is missing, one belongs to another scene.
    std::fs::remove_file(run(1).join("summary.json"))?;
    let other = run(2).join("summary.json");
    let text = std::fs::read_to_string(&other)?;
    let stranger = text.replace("\"pressure\": 0.", "\"pressure\": 1.");
    assert!(stranger != text, "{text}");
    std::fs::write(&other, stranger)?;
    let said = sweep("--jobs 2 --out serial")?;
    assert_eq!(said.lines().next(), Some("6 of 8 runs kept"), "{said}");
    assert_eq!(said.lines().count(), 4, "{said}");
    assert!(
        said.contains("seed=2: its summary was changed after the run"),
        "{said}"
    );
    assert_eq!(table, std::fs::read_to_string(serial.join("sweep.csv"))?);
    Ok(())
}

#[test]
fn a_soft_powder_is_exported_for_lammps_and_starts_a_run_of_ours() -> Outcome {
    let home = tempfile::tempdir()?;
    let sets = "--set method=soft --set mu_torsion=0.2 --set mu_rolling=0.1 --set coupling=exact \
                --set wall_contact=smooth --set gravity=0.001";
    let export = format!("export lammps tiny.toml {sets} --out files");
    let [told, _] = succeed(home.path(), &export)?;
    assert!(told.contains("lmp -in in.powder"));
    let script = std::fs::read_to_string(home.path().join("files/in.powder"))?;
    assert_has(
        &script,
        &[
            "read_data powder.data",
            "pair_coeff * * hooke 1000.0 damping 1.0 sliding 0.3 coupling exact torsion 0.2 torsion/spring inertia \
             rolling 0.1 cohesion 1.0 0.01\n",
            "fix weight all gravity 0.001 vector 0 0 -1\n",
            "fix walls all wall/gran/tribos hooke 1000.0 damping 1.0 cohesion 1.0 0.01 zlo 0 zhi ",
            // The load on 64 R² and the mass of the piston.
            " piston 0.64 100.0\n",
        ],
    );

    // The same spheres start a run of ours.
    let mut porosities = Vec::new();
    for start in ["", "--set initial_state=files/powder.data"] {
        let out = home.path().join("out");
        let run = format!("run tiny.toml --set method=soft --set max_steps=1 {start} --out out");
        let (code, _, said) = program::tribos(home.path(), run)?;
        assert!(matches!(code, Some(0 | 3)), "{said}");
        let summary = summary(&out)?;
        porosities.push((
            number(&summary, "/particles"),
            number(&summary, "/porosity_initial"),
        ));
        std::fs::remove_dir_all(&out)?;
    }
    assert_eq!(porosities[0].0, porosities[1].0);
    assert!((porosities[0].1 - porosities[1].1).abs() < 1e-3);
    Ok(())
}
