//! `tribos run` and `tribos sweep` of powders: complete, resumable, repeatable results.

use crate::program::{
    Error, Outcome, assert_has, assert_refused_scenes, json, number, prepared, summary, wait_for,
};
use assert_cmd::Command;
use serde_json::Value;
use std::path::Path;

/// Some twenty spheres.
const TINY: &str =
    "body = \"powder\"\nwidth = 8\nheight = 12\npressure = 0.01\npiston_mass = 100\n";

/// Writes the scene into the folder and begins a command on it.
fn tribos(folder: &Path, command: &str) -> Result<Command, Error> {
    let scene = folder.join("tiny.toml");
    std::fs::write(&scene, TINY)?;
    let mut tribos = Command::cargo_bin("tribos")?;
    tribos.arg(command).arg(scene);
    Ok(tribos)
}

#[test]
fn a_run_leaves_summary_series_states_and_pictures() -> Outcome {
    let folder = tempfile::tempdir()?;
    let out = folder.path().join("out");
    let mut command = tribos(folder.path(), "run")?;
    command.args(["--set", "mu_rolling=0.3", "--out"]).arg(&out);
    let output = command.output()?;
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{said}");
    let told = String::from_utf8(output.stdout)?;
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
const CRUSHED: &str = "height=16 cohesion_range=0 restitution=0.5 pressure=10 piston_mass=1e4 \
                       max_steps=300";

#[test]
fn steps_that_end_approximately_are_told_and_counted() -> Outcome {
    let folder = tempfile::tempdir()?;
    let out = folder.path().join("out");
    let run = |keys: &str| -> Result<(String, Value), Error> {
        let mut command = tribos(folder.path(), "run")?;
        for key in keys.split_whitespace() {
            command.args(["--set", key]);
        }
        let output = command.arg("--out").arg(&out).output()?;
        let said = String::from_utf8_lossy(&output.stderr);
        assert!(output.status.success(), "{keys}: {said}");
        Ok((String::from_utf8(output.stdout)?, summary(&out)?))
    };
    let lines = [
        ("impacts       cut in ", "steps_impacts_cut"),
        ("impacts       unmet in ", "steps_impacts_unmet"),
        ("unmet         ", "steps_solver_unmet"),
    ];
    // As few sweeps for lasting contacts as leave some of them unsolved.
    let (told, summary) = run(&format!("{CRUSHED} max_iterations=20"))?;
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
    let (told, summary) = run("max_steps=300")?;
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
    let sets = ["--set", "max_steps=400", "--set", "mu_rolling=0.1"];
    let mut command = tribos(folder.path(), "run")?;
    command
        .args(sets)
        .arg("--out")
        .arg(&whole)
        .assert()
        .success();

    // A checkpoint after every step, until the run is killed somewhere on its way.
    let mut child = prepared(folder.path(), ["run", "tiny.toml", "--checkpoint", "0"])
        .args(sets)
        .args(["--out", "broken"])
        .spawn()?;
    let steps = || json(&broken.join("checkpoint.json")).ok()?["steps"].as_u64();
    wait_for("a checkpoint", || steps() >= Some(30));
    child.kill()?;
    child.wait()?;
    let at = steps().unwrap_or(0);
    assert!((30..400).contains(&at), "killed at {at}");
    assert!(!broken.join("summary.json").exists());

    // Not for another scene.
    let mut other = tribos(folder.path(), "run")?;
    let refused = other.args(["--resume", "--out"]).arg(&broken).output()?;
    assert_eq!(refused.status.code(), Some(2));
    let said = String::from_utf8(refused.stderr)?;
    assert!(
        said.contains("`mu_rolling` is") && said.contains("--anew"),
        "{said}"
    );

    let mut command = tribos(folder.path(), "run")?;
    command.args(sets).args(["--resume", "--out"]).arg(&broken);
    command.assert().success();
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
    let mut again = tribos(folder.path(), "run")?;
    again.args(sets).args(["--resume", "--out"]).arg(&broken);
    let output = again.output()?;
    assert!(output.status.success());
    let told = String::from_utf8(output.stdout)?;
    assert!(told.contains("finished already"), "{told}");
    assert!(std::fs::read(broken.join("summary.json"))? == left);
    Ok(())
}

#[test]
fn bad_powders_are_refused_with_their_line_and_cure() -> Outcome {
    let cases = r#"
        width = 8\n |  | scene.toml: | `width` is missing
        height = 12\n |  | scene.toml: | or give `count`
        height = 12 | height = 12\ncount = 9 | scene.toml:4 | not both
        width = 8 | width = 5 | scene.toml:2 | must be twice that
        height = 12 | height = 12\ncapture_radius = 1 | scene.toml:4 | at least 2
        height = 12 | height = 12\nradius_spread = 1 | scene.toml:4 | >= 0 and < 1
        height = 12 | height = 1 | error | above a diameter
        pressure = 0.01 | pressure = 0 | scene.toml:4 | > 0
        pressure = 0.01 | mu_rolling = -0.1 | scene.toml:4 | >= 0
        pressure = 0.01 | mu_torsoin = 0.1 | scene.toml:4 | did you mean `mu_torsion`?
        pressure = 0.01 | sweep_order = "fixed" | scene.toml:4 | "gauss-seidel" only
        pressure = 0.01 | wall_contact = "rough" | scene.toml:4 | "smooth"
        pressure = 0.01 | restitution = 2 | scene.toml:4 | from 0 to 1
        pressure = 0.01 | max_displacement = 3 | scene.toml:4 | <= 0.5
        pressure = 0.01 | seed = 1.5 | scene.toml:4 | a whole number
        pressure = 0.01 | solver = "gauss-seidel"\nstop_rule = "fixed"\ntolerance = 1e-3 | scene.toml:6 | not used
    "#;
    assert_refused_scenes(TINY, cases)
}

#[test]
fn a_sweep_averages_its_runs_and_keeps_them() -> Outcome {
    let folder = tempfile::tempdir()?;
    let [serial, parallel] = ["serial", "parallel"].map(|name| folder.path().join(name));
    let sweep = |out: &Path, jobs: &str| -> Result<String, Error> {
        let mut command = tribos(folder.path(), "sweep")?;
        command.args(["--set", "mu_rolling=0,0.3", "--set", "mu_torsion=0,0.3"]);
        command.args([
            "--set",
            "max_steps=200",
            "--seeds",
            "2",
            "--jobs",
            jobs,
            "--out",
        ]);
        let output = command.arg(out).output()?;
        let said = String::from_utf8(output.stderr)?;
        assert!(output.status.success(), "{said}");
        Ok(said)
    };
    assert_eq!(sweep(&serial, "1")?.lines().count(), 8);
    sweep(&parallel, "3")?;
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
    let said = sweep(&serial, "2")?;
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
fn impossible_sweeps_are_refused_before_any_run() -> Outcome {
    let cases: [(&[&str], &str); 6] = [
        (&["--set", "rolling"], "not of the form"),
        (&["--set", "mu_rolling=0,0"], "twice"),
        (
            &["--set", "mu_rolling=0", "--set", "mu_rolling=1"],
            "at once",
        ),
        (&["--set", "mu_rolling=0,-1"], ">= 0"),
        (&["--set", "seed=1,2", "--seeds", "2"], "one or the other"),
        (&["--seeds", "2"], "no seed"),
    ];
    for (arguments, words) in cases {
        let folder = tempfile::tempdir()?;
        let out = folder.path().join("out");
        let mut command = tribos(folder.path(), "sweep")?;
        if words == "no seed" {
            let disk = format!("{}/../scenes/disk.toml", env!("CARGO_MANIFEST_DIR"));
            command = Command::cargo_bin("tribos")?;
            command.args(["sweep", &disk]);
        }
        command.args(arguments);
        let output = command.arg("--out").arg(&out).output()?;
        let said = String::from_utf8(output.stderr)?;
        assert_eq!(output.status.code(), Some(2), "{arguments:?} {said}");
        assert!(said.contains(words), "{arguments:?} {said}");
        assert!(!out.exists(), "{arguments:?}");
    }
    Ok(())
}

#[test]
fn a_soft_powder_is_exported_for_lammps_and_starts_a_run_of_ours() -> Outcome {
    let home = tempfile::tempdir()?;
    let export = |sets: &[&str]| -> Result<std::process::Output, Error> {
        tribos(home.path(), "export")?; // writes the scene
        let mut command = Command::cargo_bin("tribos")?;
        command.args(["export", "lammps"]);
        command.arg(home.path().join("tiny.toml"));
        for set in sets {
            command.args(["--set", set]);
        }
        Ok(command
            .arg("--out")
            .arg(home.path().join("files"))
            .output()?)
    };
    let soft = export(&[
        "method=soft",
        "mu_torsion=0.2",
        "mu_rolling=0.1",
        "coupling=exact",
        "wall_contact=smooth",
        "gravity=0.001",
    ])?;
    let said = String::from_utf8(soft.stderr)?;
    assert!(soft.status.success(), "{said}");
    assert!(String::from_utf8(soft.stdout)?.contains("lmp -in in.powder"));
    let script = std::fs::read_to_string(home.path().join("files/in.powder"))?;
    assert_has(
        &script,
        &[
            "read_data powder.data",
            "pair_coeff * * hooke 1000.0 damping 1.0 sliding 0.3 coupling exact torsion 0.2 torsion/spring inertia \
             rolling 0.1 cohesion 1 0.01\n",
            "fix weight all gravity 0.001 vector 0 0 -1\n",
            "fix walls all wall/gran/tribos hooke 1000.0 damping 1.0 cohesion 1 0.01 zlo 0 zhi ",
            // The load on 64 R² and the mass of the piston.
            " piston 0.64 100.0\n",
        ],
    );

    // The same spheres start a run of ours.
    let data = home.path().join("files/powder.data");
    let mut porosities = Vec::new();
    for start in [None, Some(format!("initial_state={}", data.display()))] {
        let out = home.path().join("out");
        let mut command = tribos(home.path(), "run")?;
        command.args(["--set", "method=soft", "--set", "max_steps=1"]);
        if let Some(start) = &start {
            command.args(["--set", start]);
        }
        let output = command.arg("--out").arg(&out).output()?;
        let said = String::from_utf8_lossy(&output.stderr);
        assert!(matches!(output.status.code(), Some(0 | 3)), "{said}");
        let summary = summary(&out)?;
        porosities.push((
            number(&summary, "/particles"),
            number(&summary, "/porosity_initial"),
        ));
        std::fs::remove_dir_all(&out)?;
    }
    assert_eq!(porosities[0].0, porosities[1].0);
    assert!((porosities[0].1 - porosities[1].1).abs() < 1e-3);

    // Rigid spheres have no springs.
    let rigid = export(&[])?;
    assert_eq!(rigid.status.code(), Some(2));
    assert!(String::from_utf8(rigid.stderr)?.contains("--set method=soft"));
    Ok(())
}
