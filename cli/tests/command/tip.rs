//! Tips on a substrate: `tribos run`, `sweep`, `golden` and `export` of a small one.

use crate::program::{self, Error, Outcome, assert_has, json, prepared, wait_for};
use std::path::Path;

/// 748 atoms, 400 steps.
const TINY: &str = "body = \"tip\"\nlambda = 0.02\nsubstrate_columns = 12\nsubstrate_rows = 14\ntip_side_atoms = 3\n\
                    substrate_layers = 4\ntip_layers = 4\nequilibration = 0.5\ndrive_time = 1\n\
                    rest_time = 0.5\nsample_every = 20\n";

/// Runs a command in the folder, where the scene is `tiny.toml`: what was said.
fn succeed(folder: &Path, arguments: &str) -> Result<[String; 2], Error> {
    std::fs::write(folder.join("tiny.toml"), TINY)?;
    program::succeed(folder, arguments)
}

/// Runs it in vain: the exit code and what was said.
fn fail(folder: &Path, arguments: &str) -> Result<(Option<i32>, String), Error> {
    std::fs::write(folder.join("tiny.toml"), TINY)?;
    let (code, _, said) = program::tribos(folder, arguments)?;
    Ok((code, said))
}

/// The cells of a table.
fn table(file: &Path) -> Result<Vec<Vec<String>>, Error> {
    let text = std::fs::read_to_string(file)?;
    let cells = |line: &str| line.split(',').map(String::from).collect();
    Ok(text.lines().map(cells).collect())
}

#[test]
fn a_run_leaves_series_summary_pictures_and_atoms() -> Outcome {
    let folder = tempfile::tempdir()?;
    let [told, _] = succeed(folder.path(), "run tiny.toml --out out")?;
    let out = folder.path().join("out");
    assert_has(
        &told,
        &[
            "verdict       reversible",
            "degrees driven",
            "slipped",
            "written to    out",
        ],
    );
    let series = table(&out.join("series.csv"))?;
    let head = "time,angle,resisting_torque,height,substrate_temperature,tip_temperature,\
                potential_energy,layer_1,layer_2,layer_3,layer_4";
    assert_eq!(series[0].join(","), head);
    // A line at the start and after every twenty steps of 400.
    assert_eq!(series.len(), 22);
    let numbers = |line: usize| -> Result<Vec<f64>, std::num::ParseFloatError> {
        series[line].iter().map(|cell| cell.parse()).collect()
    };
    assert_eq!([numbers(1)?[0], numbers(21)?[0]], [-0.5, 1.5]);
    for line in 1..22 {
        assert!(
            numbers(line)?.iter().all(|number| number.is_finite()),
            "{line}"
        );
    }

    let summary = json(&out.join("summary.json"))?;
    assert_eq!(summary["verdict"], "reversible");
    assert_eq!(summary["samples"], 21);
    assert_eq!(summary["scene"]["lambda"].as_f64(), Some(0.02));
    assert_eq!(summary["scene"]["cutoff"].as_f64(), Some(2.5));
    // The rest is shorter than the stretch that angles are averaged over: its mean, from lines that
    // stand closer together than those of the series.
    let mut final_angle = 0.0;
    for line in 11 + 5..=21 {
        final_angle += numbers(line)?[1] / 6.0;
    }
    let found = summary["final_angle_degrees"].as_f64().unwrap_or(f64::NAN);
    let most = summary["largest_angle_degrees"]
        .as_f64()
        .unwrap_or(f64::NAN);
    assert!(
        (found - final_angle).abs() < 0.1 * most,
        "{found} {final_angle}"
    );
    for name in [
        "driven_angle_degrees",
        "largest_angle_degrees",
        "tip_temperature",
    ] {
        assert!(summary[name].as_f64().is_some(), "{name}");
    }
    let layers = summary["layer_angles_degrees"].as_array().map(Vec::len);
    assert_eq!(layers, Some(4));

    for plot in ["angles.svg", "angles.png", "tip.svg", "tip.png"] {
        assert!(out.join(plot).metadata()?.len() > 1000, "{plot}");
    }
    for state in ["initial.data", "final.data"] {
        let text = std::fs::read_to_string(out.join(state))?;
        assert!(
            text.contains("748 atoms") && text.contains("6 atom types"),
            "{state}"
        );
    }
    assert!(!out.join("checkpoint.json").exists());
    Ok(())
}

#[test]
fn a_killed_run_goes_on_to_the_same_files() -> Outcome {
    let folder = tempfile::tempdir()?;
    let sets = "--set rest_time=4 --set sample_every=5";
    succeed(folder.path(), &format!("run tiny.toml {sets} --out whole"))?;

    // A checkpoint after every line of the series, until the run is killed somewhere on its way.
    let broken = folder.path().join("broken");
    let under_way = format!("run tiny.toml {sets} --checkpoint 0 --out broken");
    let mut child = prepared(folder.path(), under_way).spawn()?;
    let steps = || json(&broken.join("checkpoint.json")).ok()?["steps"].as_u64();
    wait_for("a checkpoint", || steps() >= Some(50));
    child.kill()?;
    child.wait()?;
    let at = steps().unwrap_or(0);
    assert!((50..1100).contains(&at), "killed at {at}");
    assert!(!broken.join("summary.json").exists());

    // Not for another scene, and not a damaged one.
    let resume = format!("run tiny.toml {sets} --resume --out broken");
    let (code, said) = fail(folder.path(), &format!("{resume} --set lambda=0.03"))?;
    assert_eq!(code, Some(2));
    let is_told = said.contains("`lambda` is") && said.contains("--anew");
    assert!(is_told, "{said}");
    let file = broken.join("checkpoint.json");
    let kept = std::fs::read_to_string(&file)?;
    std::fs::write(
        &file,
        kept.replace("\"velocities\":\"", "\"velocities\":\"7ff8000000000000"),
    )?;
    let (code, said) = fail(folder.path(), &resume)?;
    assert_eq!(code, Some(2));
    assert!(said.contains("digest") && said.contains("--anew"), "{said}");
    std::fs::write(&file, kept)?;

    succeed(folder.path(), &resume)?;
    let files = [
        "series.csv",
        "summary.json",
        "angles.svg",
        "angles.png",
        "tip.svg",
        "tip.png",
        "initial.data",
        "final.data",
    ];
    for file in files {
        let bytes = std::fs::read(folder.path().join("whole").join(file))?;
        assert!(bytes == std::fs::read(broken.join(file))?, "{file}");
    }
    // Done: there is nothing left to do, nor for another scene.
    succeed(folder.path(), &resume)?;
    let (code, said) = fail(folder.path(), &format!("{resume} --set lambda=0.03"))?;
    assert!(code == Some(2) && said.contains("`lambda` is"), "{said}");
    Ok(())
}

#[test]
fn a_sweep_tells_the_share_of_tips_that_turned_back() -> Outcome {
    let folder = tempfile::tempdir()?;
    let sets = "--set rest_time=0.2 --set temperature=1e-4 --set lambda=0,3";
    let sweep = format!("sweep tiny.toml {sets} --seeds 2");
    let [told, said] = succeed(folder.path(), &format!("{sweep} --jobs 1 --out serial"))?;
    assert_eq!(said.lines().count(), 4, "{said}");
    let shares = ["reversible", "2/2", "0/2"];
    assert!(shares.iter().all(|share| told.contains(share)), "{told}");
    succeed(folder.path(), &format!("{sweep} --jobs 3 --out parallel"))?;
    let [serial, parallel] = ["serial", "parallel"].map(|name| folder.path().join(name));
    let lines = table(&serial.join("sweep.csv"))?;
    assert_eq!(lines, table(&parallel.join("sweep.csv"))?);

    let head = [
        "rest_time",
        "temperature",
        "lambda",
        "runs",
        "reversible",
        "driven_angle",
        "driven_angle_std",
        "largest_angle",
        "largest_angle_std",
        "final_angle",
        "final_angle_std",
        "tip_temperature",
        "tip_temperature_std",
    ];
    assert_eq!(lines[0], head);
    assert_eq!(lines.len(), 3);
    for (line, lambda, share) in [(1, "0", 1.0), (2, "3", 0.0)] {
        assert_eq!(lines[line][..4], ["0.2", "1e-4", lambda, "2"]);
        assert_eq!(lines[line][4].parse::<f64>()?, share);
        let mut sum = 0.0;
        for seed in [1, 2] {
            let name = format!("runs/rest_time=0.2,temperature=1e-4,lambda={lambda},seed={seed}");
            let summary = json(&serial.join(&name).join("summary.json"))?;
            sum += summary["final_angle_degrees"].as_f64().ok_or("no angle")?;
            assert_eq!(summary["verdict"] == "reversible", share == 1.0);
            assert!(serial.join(&name).join("series.csv").exists());
        }
        assert!((lines[line][9].parse::<f64>()? - 0.5 * sum).abs() < 1e-13);
    }
    for plot in ["sweep.svg", "sweep.png"] {
        assert!(serial.join(plot).metadata()?.len() > 1000, "{plot}");
    }

    // What was interrupted: one run is missing, with a checkpoint that is of no use.
    let run = serial.join("runs/rest_time=0.2,temperature=1e-4,lambda=3,seed=1");
    std::fs::remove_file(run.join("summary.json"))?;
    std::fs::write(run.join("checkpoint.json"), "{}")?;
    let [_, said] = succeed(folder.path(), &format!("{sweep} --out serial"))?;
    assert_eq!(said.lines().count(), 2, "{said}");
    assert_eq!(lines, table(&serial.join("sweep.csv"))?);
    assert!(!run.join("checkpoint.json").exists());
    Ok(())
}

#[test]
fn a_golden_file_pins_a_tip_and_tells_what_changed() -> Outcome {
    let folder = tempfile::tempdir()?;
    succeed(folder.path(), "golden write tiny.toml --out golden.toml")?;
    let verify = "golden verify golden.toml";
    let [said, _] = succeed(folder.path(), verify)?;
    assert!(said.contains("tiny.toml: same, 21 rows"), "{said}");

    // The last digit of the digest of the final velocities.
    let file = folder.path().join("golden.toml");
    let text = std::fs::read_to_string(&file)?;
    let after = text.find("[scene.state]").ok_or("no state")?;
    let (head, state) = text.split_at(after);
    let at = state.find("velocities").ok_or("no velocities")?;
    let digits = at + state[at..].find("\"0x").ok_or("no digest")? + 1..;
    let digit = digits.start + 17;
    let other = if state[digit..].starts_with('0') {
        "1"
    } else {
        "0"
    };
    let changed = format!("{head}{}{other}{}", &state[..digit], &state[digit + 1..]);
    std::fs::write(&file, changed)?;
    let (code, said, _) = program::tribos(folder.path(), verify)?;
    assert_eq!(code, Some(3), "{said}");
    assert!(said.contains("final state: velocities differ"), "{said}");
    Ok(())
}

#[test]
fn exported_atoms_have_the_energy_of_the_run() -> Outcome {
    let folder = tempfile::tempdir()?;
    for (name, sets, pair) in [
        ("plain", "", "lj:cutoff=2.5"),
        (
            "mixed",
            " --set adhesion_energy=0.5 --set shift=force --set tip_orientation=15 --set raise=0.1",
            "lj:cutoff=2.5,shift=force,epsilon14=0.5,epsilon15=0.5,epsilon16=0.5,epsilon24=0.5,\
             epsilon25=0.5,epsilon26=0.5,epsilon34=0.5,epsilon35=0.5,epsilon36=0.5",
        ),
    ] {
        succeed(folder.path(), &format!("run tiny.toml{sets} --out {name}"))?;
        let [told, _] = succeed(
            folder.path(),
            &format!("export lammps tiny.toml{sets} --out {name}/lammps"),
        )?;
        assert!(told.contains("lmp -in in.tip"), "{told}");
        let out = folder.path().join(name);
        let script = std::fs::read_to_string(out.join("lammps/in.tip"))?;
        assert_has(
            &script,
            &[
                "read_data tip.data",
                "run 100\n",
                "run 200\nunfix torque\nrun 100\n",
            ],
        );
        let data = std::fs::read(out.join("lammps/tip.data"))?;
        assert!(data == std::fs::read(out.join("initial.data"))?);
        succeed(
            folder.path(),
            &format!(
                "eval {name}/lammps/tip.data --pair {pair} --boundary p,p,f --out {name}/eval"
            ),
        )?;
        let evaluated = json(&out.join("eval/summary.json"))?["energy"].as_f64();
        let series = table(&out.join("series.csv"))?;
        let at = series[0].iter().position(|name| name == "potential_energy");
        let energy: f64 = series[1][at.ok_or("no column")?].parse()?;
        let off = evaluated.ok_or("no energy")? / energy - 1.0;
        assert!(off.abs() < 1e-12, "{name}: {off}");
    }
    Ok(())
}
