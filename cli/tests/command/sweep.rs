//! `tribos sweep` stopped, in parts, as a job array: the same tables to the byte.

use crate::program::{Error, Outcome, assert_has, prepared, succeed, summary, texts, tribos};
use std::path::{Path, PathBuf};
use std::process::{Child, Command};
use std::time::{Duration, Instant};

/// Some ten spheres, some milliseconds a run.
const TINY: &str = "body = \"powder\"\nwidth = 7\nheight = 9\npressure = 0.01\npiston_mass = 100\n\
                    max_steps = 300\n";
/// 25 runs of it.
const GRID: &str =
    "sweep tiny.toml --set mu_rolling=0,0.1,0.2,0.3,0.4 --set mu_torsion=0,0.1,0.2,0.3,0.4";

/// A folder with the scene in tiny.toml, and the undisturbed sweep of 25 runs in `whole`.
fn undisturbed() -> Result<tempfile::TempDir, Error> {
    let folder = tempfile::tempdir()?;
    std::fs::write(folder.path().join("tiny.toml"), TINY)?;
    let [_, said] = succeed(folder.path(), format!("{GRID} --out whole"))?;
    assert_eq!(said.lines().count(), 25, "{said}");
    assert!(said.lines().all(|line| line.contains(" gone, ")), "{said}");
    Ok(folder)
}

/// All that a sweep leaves beside its runs.
fn assert_same_tables(folder: &Path, other: &str) -> Outcome {
    let parquet: &[&str] = match cfg!(feature = "parquet") {
        true => &["sweep.parquet", "runs.parquet"],
        false => &[],
    };
    for name in ["sweep.csv", "runs.csv", "sweep.svg", "sweep.png"]
        .iter()
        .chain(parquet)
    {
        let [ours, theirs] = ["whole", other].map(|out| std::fs::read(folder.join(out).join(name)));
        assert!(ours? == theirs?, "{other}: {name}");
    }
    Ok(())
}

fn summaries(out: &Path) -> Vec<PathBuf> {
    let runs = std::fs::read_dir(out.join("runs")).into_iter().flatten();
    let files = runs.flatten().map(|run| run.path().join("summary.json"));
    files.filter(|file| file.exists()).collect()
}

#[test]
fn a_killed_sweep_goes_on_to_the_undisturbed_tables() -> Outcome {
    let folder = undisturbed()?;
    let out = folder.path().join("killed");
    let mut child = prepared(folder.path(), format!("{GRID} --jobs 1 --out killed")).spawn()?;
    let began = Instant::now();
    while summaries(&out).len() < 5 && began.elapsed() < Duration::from_secs(60) {
        std::thread::sleep(Duration::from_micros(200));
    }
    // SIGKILL: nothing can be tidied up.
    child.kill()?;
    child.wait()?;
    let kept = summaries(&out).len();
    assert!((5..25).contains(&kept), "killed too late: {kept} of 25");

    let [_, said] = succeed(folder.path(), format!("{GRID} --out killed"))?;
    let first = format!("{kept} of 25 runs kept");
    assert_eq!(said.lines().next(), Some(first.as_str()));
    assert_eq!(said.lines().count(), 26 - kept, "{said}");
    assert_same_tables(folder.path(), "killed")
}

#[test]
fn parts_on_two_machines_merge_to_the_undisturbed_tables() -> Outcome {
    let folder = undisturbed()?;
    let [told, said] = succeed(folder.path(), format!("{GRID} --out parts --part 0/2"))?;
    assert_eq!(said.lines().count(), 13, "{said}");
    assert!(told.contains("tribos sweep --merge parts"), "{told}");
    assert!(!folder.path().join("parts/sweep.csv").exists());

    // The other machine has a copy of the folder, and the scene was edited meanwhile.
    let scene = folder.path().join("tiny.toml");
    std::fs::write(&scene, TINY.replace("0.01", "0.02"))?;
    let other = folder.path().join("other");
    std::fs::create_dir(&other)?;
    std::fs::copy(
        folder.path().join("parts/sweep.json"),
        other.join("sweep.json"),
    )?;
    let [_, said] = succeed(folder.path(), "sweep --plan other --part 1/2")?;
    assert_eq!(said.lines().count(), 12, "{said}");

    let (code, _, said) = tribos(folder.path(), "sweep --merge parts")?;
    assert_eq!(code, Some(1));
    assert_has(
        &said,
        &[
            "12 of 25 runs are missing",
            "\n  mu_rolling=0,mu_torsion=0.1\n",
            "and 2 more",
            "tribos sweep --plan parts",
        ],
    );

    // Runs come home; the same number of runs as in the plan, none of them new.
    for summary in summaries(&other) {
        let run = summary.parent().and_then(Path::file_name);
        let home = folder.path().join("parts/runs").join(run.ok_or("a run")?);
        std::fs::create_dir_all(&home)?;
        std::fs::copy(&summary, home.join("summary.json"))?;
    }
    assert_eq!(succeed(folder.path(), "sweep --merge parts")?[1], "");
    assert_same_tables(folder.path(), "parts")
}

#[test]
fn a_job_array_holds_its_plan_and_gives_the_undisturbed_tables() -> Outcome {
    let folder = undisturbed()?;
    let hand_over = |sweep: &str| {
        let options = "--slurm --slurm-tasks 3 --slurm-option --time=5 --out";
        let words = sweep.split(' ').chain(options.split(' ')).chain(["a b"]);
        words.map(str::to_owned).collect::<Vec<_>>()
    };
    let [told, _] = succeed(folder.path(), hand_over(GRID))?;
    assert!(told.starts_with("25 runs in 3 tasks\n"), "{told}");
    let script = std::fs::read_to_string(folder.path().join("a b/job.sh"))?;
    assert!(script.contains("#SBATCH --array=0-2\n"), "{script}");
    assert!(script.contains("#SBATCH --time=5\n"), "{script}");
    assert!(folder.path().join("a b/logs").is_dir());

    // As the cluster would start its tasks, from elsewhere.
    let elsewhere = tempfile::tempdir()?;
    if cfg!(unix) {
        for task in ["2", "0", "1"] {
            let mut bash = Command::new("bash");
            bash.arg(folder.path().join("a b/job.sh"))
                .current_dir(elsewhere.path())
                .env("SLURM_ARRAY_TASK_ID", task);
            assert!(bash.status()?.success(), "{task}");
        }
        succeed(folder.path(), ["sweep", "--merge", "a b"])?;
        assert_same_tables(folder.path(), "a b")?;
    }

    // Tasks that still wait would take another plan.
    let other = hand_over("sweep tiny.toml --set mu_rolling=0 --set mu_torsion=1");
    let (code, _, said) = tribos(folder.path(), other)?;
    assert_eq!(code, Some(2), "{said}");
    assert!(said.contains("another sweep"), "{said}");
    Ok(())
}

#[test]
fn sliders_are_swept_to_the_numbers_of_their_runs() -> Outcome {
    let folder = tempfile::tempdir()?;
    let scenes = format!("{}/../scenes", env!("CARGO_MANIFEST_DIR"));
    for (scene, key, column) in [
        ("disk", "spin=2,12.5", "distance"),
        ("cylinder", "spin=-3,3", "curl"),
        ("curling-draw", "speed=1.9,2", "curl"),
    ] {
        let file = format!("{scenes}/{scene}.toml");
        succeed(
            folder.path(),
            format!("sweep {file} --set {key} --out {scene}"),
        )?;
        let table = std::fs::read_to_string(folder.path().join(scene).join("sweep.csv"))?;
        let mut lines = table.lines();
        let head: Vec<&str> = lines.next().unwrap_or_default().split(',').collect();
        let at = head.iter().position(|name| *name == column);
        let [key, last] = key.split_once('=').map(|(k, v)| [k, v]).ok_or("a key")?;
        let last = last.split(',').next_back().unwrap_or_default();

        succeed(
            folder.path(),
            format!("run {file} --set {key}={last} --out run"),
        )?;
        let summary = summary(&folder.path().join("run"))?;
        let cell = lines
            .last()
            .unwrap_or_default()
            .split(',')
            .nth(at.ok_or("a column")?);
        let [cell, number] = [
            cell.and_then(|cell| cell.parse().ok()),
            summary[column].as_f64(),
        ];
        assert!(number.is_some(), "{scene}");
        assert_eq!(cell.map(f64::to_bits), number.map(f64::to_bits), "{scene}");
        assert!(folder.path().join(scene).join("sweep.svg").exists());
    }
    Ok(())
}

/// Heads of a table.
fn heads(file: &Path) -> Result<Vec<String>, Error> {
    let text = std::fs::read_to_string(file)?;
    let first = text.lines().next().unwrap_or_default();
    Ok(first.split(',').map(str::to_owned).collect())
}

#[test]
fn a_key_with_the_name_of_a_result_has_a_column_of_its_own() -> Outcome {
    let folder = tempfile::tempdir()?;
    std::fs::write(
        folder.path().join("tiny.toml"),
        "body = \"gas\"\ncount = 100",
    )?;
    succeed(
        folder.path(),
        "sweep tiny.toml --set collisions=1,2 --out out",
    )?;
    for table in ["sweep.csv", "runs.csv"] {
        let heads = heads(&folder.path().join("out").join(table))?;
        for (at, head) in heads.iter().enumerate() {
            assert!(!heads[..at].contains(head), "{table}: {head} twice");
        }
        let both =
            ["collisions", "collisions_result"].map(|name| heads.iter().any(|head| head == name));
        assert_eq!(both, [true; 2], "{table}: {heads:?}");
    }
    Ok(())
}

#[test]
fn a_refused_combination_has_its_row_and_the_others_run() -> Outcome {
    let folder = tempfile::tempdir()?;
    let sweep = "sweep cylinder --set spin=0,5,20 --set height=0.16,0.5,1.0";
    let [told, said] = succeed(folder.path(), format!("{sweep} --out whole"))?;
    assert!(said.contains("of 9 runs were refused"), "{said}");
    assert!(told.contains("refused: the body tips"), "{told}");
    let runs = std::fs::read_to_string(folder.path().join("whole/runs.csv"))?;
    assert_eq!(runs.lines().count(), 10);
    let tipped = runs.lines().filter(|line| line.contains("the body tips"));
    let tipped = tipped.count();
    assert!((1..9).contains(&tipped), "{tipped}");
    let table = heads(&folder.path().join("whole/sweep.csv"))?;
    assert!(
        ["refused", "refusal"]
            .iter()
            .all(|name| table.iter().any(|head| head == name))
    );

    // In parts, and merged: the same.
    for part in ["0/2", "1/2"] {
        succeed(folder.path(), format!("{sweep} --out parts --part {part}"))?;
    }
    succeed(folder.path(), "sweep --merge parts")?;
    for name in ["sweep.csv", "runs.csv"] {
        let [whole, parts] =
            ["whole", "parts"].map(|out| std::fs::read(folder.path().join(out).join(name)));
        assert!(whole? == parts?, "{name}");
    }

    // All refused: their rows, and the exit code of bad input.
    let (code, ..) = tribos(folder.path(), "sweep cylinder --set height=1:2:1 --out all")?;
    assert_eq!(code, Some(2));
    assert!(folder.path().join("all/runs.csv").exists());
    Ok(())
}

#[test]
fn a_range_stands_for_its_values() -> Outcome {
    let folder = tempfile::tempdir()?;
    for (values, out) in [("spin=0:20:10,50", "range"), ("spin=0,10,20,50", "list")] {
        succeed(
            folder.path(),
            format!("sweep disk --set {values} --out {out}"),
        )?;
    }
    let [range, list] =
        ["range", "list"].map(|out| std::fs::read(folder.path().join(out).join("runs.csv")));
    assert_eq!(range?, list?);
    Ok(())
}

#[test]
fn a_summary_that_was_changed_is_not_taken_for_a_result() -> Outcome {
    let folder = undisturbed()?;
    let whole = folder.path().join("whole");
    let tables = std::fs::read(whole.join("runs.csv"))?;
    let file = whole.join("runs/mu_rolling=0.1,mu_torsion=0.2/summary.json");
    let kept = std::fs::read_to_string(&file)?;
    let at = kept.find("\"porosity_final\": 0.").ok_or("no porosity")?;
    let mut changed = kept.clone();
    changed.replace_range(at + 20..at + 23, "777");
    assert_ne!(changed, kept);
    std::fs::write(&file, changed)?;

    let (code, _, said) = tribos(folder.path(), "sweep --merge whole")?;
    assert_eq!(code, Some(1), "{said}");
    let words = "mu_rolling=0.1,mu_torsion=0.2 (its summary was changed after the run)";
    assert!(said.contains(words), "{said}");

    let [_, said] = succeed(folder.path(), format!("{GRID} --out whole"))?;
    assert!(said.contains("the run is repeated"), "{said}");
    assert!(said.contains("24 of 25 runs kept"), "{said}");
    assert!(std::fs::read(whole.join("runs.csv"))? == tables);
    Ok(())
}

#[test]
fn two_processes_of_one_part_take_no_run_twice() -> Outcome {
    let folder = undisturbed()?;
    let part = || -> Result<Child, Error> {
        Ok(prepared(folder.path(), format!("{GRID} --out both --part 0/1")).spawn()?)
    };
    let outputs = [part()?, part()?].map(Child::wait_with_output);
    for output in outputs {
        let output = output?;
        let [_, said] = texts(&output)?;
        // A run that the other one has under way is no bad input.
        let is_in_use = output.status.code() == Some(1) && said.contains("is in use by");
        assert!(output.status.success() || is_in_use, "{said}");
    }
    succeed(folder.path(), format!("{GRID} --out both"))?;
    assert_same_tables(folder.path(), "both")
}

/// Sheared grains at two rates and two coefficients, a moment each.
const FLOWS: &str =
    "sweep shear-periodic --set duration=0.05 --set shear_rate=5,10 --set mu=0.1,0.5 --quiet";

#[test]
fn a_sweep_of_grains_has_means_over_time_and_draws_what_is_asked_for() -> Outcome {
    let home = tempfile::tempdir()?;
    let out = home.path().join("flows");
    // Refused before anything runs.
    let (code, _, told) = tribos(home.path(), format!("{FLOWS} --plot presure --out flows"))?;
    assert_eq!(code, Some(2));
    assert_has(&told, &["--plot presure", "stress_ratio", "flow_rate"]);
    assert!(!out.exists());

    let [told, _] = succeed(
        home.path(),
        format!("{FLOWS} --plot stress_ratio --out flows"),
    )?;
    assert!(
        told.lines()
            .next()
            .is_some_and(|head| head.contains("stress ratio")),
        "{told}"
    );
    let table = std::fs::read_to_string(out.join("sweep.csv"))?;
    let mut rows = table.lines().map(|row| row.split(',').collect::<Vec<_>>());
    let names = rows.next().ok_or("no header")?;
    let rows: Vec<_> = rows.collect();
    let cell = |row: usize, name: &str| -> Result<f64, Error> {
        let at = names
            .iter()
            .position(|known| *known == name)
            .ok_or(name.to_owned())?;
        Ok(rows[row][at].parse()?)
    };
    for (row, keys) in [(0, "shear_rate=5,mu=0.1"), (3, "shear_rate=10,mu=0.5")] {
        let run = out.join("runs").join(format!("duration=0.05,{keys}"));
        let averages = &summary(&run)?["averages"];
        for column in ["stress_ratio", "stress_zz", "kinetic"] {
            assert_eq!(
                Some(cell(row, column)?),
                averages[column]["mean"].as_f64(),
                "{column}"
            );
            let error = cell(row, &format!("{column}_error"))?;
            assert_eq!(Some(error), averages[column]["error"].as_f64(), "{column}");
            assert!(error > 0.0 && cell(row, &format!("{column}_std"))?.is_nan());
        }
        assert!(
            std::fs::read_to_string(run.join("series.csv"))?
                .lines()
                .count()
                > 5
        );
    }
    // A line for each coefficient; then another column of the same runs.
    let drawn = |words: &[&str]| -> Outcome {
        assert_has(&std::fs::read_to_string(out.join("sweep.svg"))?, words);
        Ok(())
    };
    drawn(&[
        "stress ratio, mean over time",
        "shear_rate",
        "mu = 0.1",
        "mu = 0.5",
    ])?;
    succeed(
        home.path(),
        "sweep --merge flows --plot solid_fraction --quiet",
    )?;
    drawn(&["solid fraction, mean over time", "mu = 0.5"])
}
