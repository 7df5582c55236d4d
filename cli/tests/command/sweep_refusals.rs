//! Combinations of a sweep that are refused, or fail, once they run: a row with the reason each, and the others go on.

use crate::program::{Error, Outcome, prepared, texts, wait_for};
use std::path::Path;
use std::process::{Child, Command, Output};

/// Some ten spheres, some milliseconds a run.
const POWDER: &str = "body = \"powder\"\nwidth = 7\nheight = 9\npressure = 0.01\n\
                      piston_mass = 100\nmax_steps = 200\n";
/// 20 steps of some hundred atoms.
const TIP: &str = "body = \"tip\"\nlambda = 0.01\nsubstrate_columns = 8\nsubstrate_rows = 8\nsubstrate_layers = 4\n\
                   tip_layers = 4\ntip_side_atoms = 2\nequilibration = 0\ndrive_time = 0.1\nrest_time = 0\n\
                   time_step = 0.005\nsample_every = 4\n";
/// A run that does not end meanwhile.
const LONG: &str = "body = \"powder\"\nwidth = 20\nheight = 61.5\n";

/// A sweep with combinations that cannot be run.
struct Case {
    scene: &'static str,
    keys: &'static str,
    /// Runs, and those of them that are refused.
    runs: [usize; 2],
    /// Beginning of a row of sweep.csv, number of its runs that were refused, and words of the reason.
    rows: &'static [(&'static str, usize, &'static str)],
    /// A run that is refused and one that is not.
    names: [&'static str; 2],
}

/// Each is refused when it runs, not when its scene is read.
const CASES: [Case; 2] = [
    Case {
        scene: "powder.toml",
        keys: "--set height=9,1,1e12 --set pressure=0.01,1e306",
        runs: [6, 5],
        rows: &[
            ("9,0.01,1,", 0, ""),
            // Beyond the range of numbers after the first step.
            ("9,1e306,0,", 1, "after step 1: `work` is inf"),
            // No sphere is lower than its diameter.
            ("1,0.01,0,", 1, "a deposit has one sphere or more"),
            ("1,1e306,0,", 1, "a deposit has one sphere or more"),
            // More spheres than a deposit may have.
            ("1e12,0.01,0,", 1, "more than 20000000 spheres"),
            ("1e12,1e306,0,", 1, "more than 20000000 spheres"),
        ],
        names: ["height=9,pressure=1e306", "height=9,pressure=0.01"],
    },
    Case {
        scene: "tip.toml",
        keys: "--set lambda=0.01,900,1e8 --set temperature=0,0.7 --seeds 4",
        runs: [24, 10],
        rows: &[
            ("0.01,0,4,", 0, ""),
            ("0.01,0.7,4,", 0, ""),
            // At the edge of blowing up, which the heat of two seeds brings about.
            ("900,0,4,", 0, ""),
            ("900,0.7,2,", 2, "step 20: atom 271 moved by"),
            ("1e8,0,0,", 4, "step 1: atom 270 moved by"),
            ("1e8,0.7,0,", 4, "the run blew up"),
        ],
        names: [
            "lambda=1e8,temperature=0,seed=2",
            "lambda=0.01,temperature=0,seed=2",
        ],
    },
];

fn home() -> Result<tempfile::TempDir, Error> {
    let home = tempfile::tempdir()?;
    let scenes = [
        ("powder.toml", POWDER),
        ("tip.toml", TIP),
        ("long.toml", LONG),
    ];
    for (name, text) in scenes {
        std::fs::write(home.path().join(name), text)?;
    }
    Ok(home)
}

/// The same of a command that worked.
fn succeed(mut command: Command) -> Result<[String; 2], Error> {
    let output = command.output()?;
    let [told, said] = texts(&output)?;
    assert!(output.status.success(), "{command:?}\n{said}");
    Ok([told, said])
}

/// All tables of two sweeps.
fn assert_same_tables(home: &Path, one: &str, other: &str) -> Outcome {
    let parquet: &[&str] = match cfg!(feature = "parquet") {
        true => &["sweep.parquet", "runs.parquet"],
        false => &[],
    };
    for name in ["sweep.csv", "runs.csv"].iter().chain(parquet) {
        let [ours, theirs] = [one, other].map(|out| std::fs::read(home.join(out).join(name)));
        assert!(ours? == theirs?, "{other}: {name}");
    }
    Ok(())
}

impl Case {
    /// The sweep into a folder.
    fn sweep(&self, home: &Path, options: &str) -> Command {
        let Self { scene, keys, .. } = self;
        prepared(home, format!("sweep {scene} {keys} {options}"))
    }

    /// Every combination has its row in the tables, with the reason if it was refused.
    fn assert_rows(&self, home: &Path, out: &str, told: &str) -> Outcome {
        let sweep = std::fs::read_to_string(home.join(out).join("sweep.csv"))?;
        let runs = std::fs::read_to_string(home.join(out).join("runs.csv"))?;
        assert_eq!(sweep.lines().count(), 1 + self.rows.len(), "{sweep}");
        assert_eq!(runs.lines().count(), 1 + self.runs[0], "{runs}");
        let refused = runs.lines().filter(|line| line.contains(",refused,"));
        assert_eq!(refused.count(), self.runs[1], "{runs}");
        for ((start, refused, why), [row, shown]) in self.rows.iter().zip(
            sweep
                .lines()
                .zip(told.lines())
                .skip(1)
                .map(<[&str; 2]>::from),
        ) {
            let start = format!("{start}{refused},");
            assert!(row.starts_with(&start), "{start}: {row}");
            assert!(row.contains(why), "{why}: {row}");
            // The last column is the reason, and the line for the terminal has it too.
            assert_eq!(row.ends_with(','), *refused == 0, "{row}");
            assert_eq!(shown.contains("refused: "), *refused > 0, "{shown}");
            assert!(shown.contains(why), "{why}: {shown}");
            if cfg!(feature = "parquet") {
                for table in ["sweep.parquet", "runs.parquet"] {
                    let bytes = std::fs::read(home.join(out).join(table))?;
                    let why = why.as_bytes();
                    let is_there = why.is_empty() || bytes.windows(why.len()).any(|w| w == why);
                    assert!(is_there, "{table}: {why:?}");
                }
            }
        }
        Ok(())
    }
}

#[test]
fn a_run_that_fails_has_its_row_whatever_threads_and_parts_do() -> Outcome {
    for case in &CASES {
        let folder = home()?;
        let home = folder.path();
        let mut whole = case.sweep(home, "--jobs 1 --out whole");
        whole.env("RAYON_NUM_THREADS", "1");
        let [told, said] = succeed(whole)?;
        case.assert_rows(home, "whole", &told)?;
        let [all, refused] = case.runs;
        let last = format!("{refused} of {all} runs were refused");
        assert!(said.contains(&last), "{said}");
        assert_eq!(said.matches(": refused: ").count(), refused, "{said}");

        // Threads.
        let mut threads = case.sweep(home, "--jobs 3 --out threads");
        threads.env("RAYON_NUM_THREADS", "6");
        assert_eq!(
            succeed(threads)?[0].replace("threads\n", "whole\n"),
            told,
            "the table for the terminal"
        );
        assert_same_tables(home, "whole", "threads")?;

        // Parts, and merged.
        for part in ["--part 1/3", "--part 0/3", "--part 2/3"] {
            succeed(case.sweep(home, &format!("{part} --out parts")))?;
        }
        let [merged, _] = succeed(prepared(home, "sweep --merge parts"))?;
        assert_eq!(merged.replace("parts\n", "whole\n"), told);
        assert_same_tables(home, "whole", "parts")?;
    }
    Ok(())
}

#[test]
fn a_run_that_failed_is_not_taken_again_and_a_damaged_checkpoint_is_no_refusal() -> Outcome {
    for case in &CASES {
        let folder = home()?;
        let home = folder.path();
        succeed(case.sweep(home, "--out whole"))?;
        succeed(case.sweep(home, "--out again"))?;
        // As if it had been stopped before two of its runs ended, whose checkpoints are damaged.
        let out = home.join("again");
        for name in ["sweep.csv", "runs.csv"] {
            std::fs::remove_file(out.join(name))?;
        }
        for name in case.names {
            let run = out.join("runs").join(name);
            std::fs::remove_file(run.join("summary.json"))?;
            std::fs::write(run.join("checkpoint.json"), "{\"powder\":1,")?;
        }
        let [_, said] = succeed(case.sweep(home, "--out again"))?;
        let [all, _] = case.runs;
        let kept = format!("{} of {all} runs kept", all - case.names.len());
        assert_eq!(said.lines().next(), Some(kept.as_str()), "{said}");
        assert_same_tables(home, "whole", "again")?;
        // Nothing is left to go on from.
        for name in case.names {
            assert!(!out.join("runs").join(name).join("checkpoint.json").exists());
        }
    }
    Ok(())
}

/// Asks a process to end.
fn interrupt(child: Child) -> Result<Output, Error> {
    let id = child.id().to_string();
    Command::new("kill").args(["-INT", &id]).status()?;
    Ok(child.wait_with_output()?)
}

#[test]
fn what_is_no_fault_of_the_scene_ends_the_sweep_and_leaves_no_row() -> Outcome {
    let folder = home()?;
    let home = folder.path();

    // A run's folder that another process holds; the others have been tried.
    let place = "out/runs/height=61.5";
    let holder = prepared(home, format!("run long.toml --out {place}")).spawn()?;
    wait_for("the run starts", || {
        home.join(place).join("frames").exists()
    });
    let sweep = "sweep long.toml --set height=61.5,1e12,1 --jobs 2 --out out";
    let output = prepared(home, sweep).output()?;
    let [_, said] = texts(&output)?;
    let process = format!("process {}", holder.id());
    // Nothing is wrong with the scene.
    assert_eq!(output.status.code(), Some(1), "{said}");
    assert!(said.contains("error: height=61.5: "), "{said}");
    assert!(said.contains("the same command continues"), "{said}");
    assert!(said.contains(&process), "{process}: {said}");
    interrupt(holder)?;
    let summary = |height: &str| home.join(format!("out/runs/height={height}/summary.json"));
    assert!(summary("1e12").exists() && summary("1").exists());
    assert!(!summary("61.5").exists() && !home.join("out/sweep.csv").exists());

    // A signal: the run under way is not refused, it goes on later.
    let child = prepared(
        home,
        "sweep long.toml --set height=61.5,1e12 --out stopped --jobs 2",
    );
    let child = { child }.spawn()?;
    wait_for("the others are done", || {
        home.join("stopped/runs/height=1e12/summary.json").exists()
            && home.join("stopped/runs/height=61.5/.tribos-lock").exists()
    });
    let output = interrupt(child)?;
    let [_, said] = texts(&output)?;
    assert_eq!(output.status.code(), Some(130), "{said}");
    assert!(said.contains("1 of 2 runs are done"), "{said}");
    let run = home.join("stopped/runs/height=61.5");
    assert!(!run.join("summary.json").exists() && !home.join("stopped/sweep.csv").exists());

    // A folder that cannot be made.
    std::fs::create_dir_all(home.join("blocked/runs"))?;
    std::fs::write(home.join("blocked/runs/height=9"), "")?;
    let output = prepared(home, "sweep powder.toml --set height=9,1 --out blocked").output()?;
    let [_, said] = texts(&output)?;
    assert!(matches!(output.status.code(), Some(1 | 2)), "{said}");
    assert!(said.contains("error: height=9: "), "{said}");
    assert!(!home.join("blocked/sweep.csv").exists());
    Ok(())
}
