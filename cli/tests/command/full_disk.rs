//! A disk that is full: what is told, what is kept, and how work goes on.
#![cfg(unix)]

use crate::program::{Error, Outcome};
use serde_json::Value;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

/// Some twenty spheres.
const TINY: &str = "body = \"powder\"\nwidth = 8\nheight = 12\npressure = 0.01\n\
                    piston_mass = 100\nmax_steps = 60\n";
/// Nine runs of it.
const GRID: &str = "--set mu_rolling=0,0.2,0.4 --set mu_torsion=0,0.2,0.4";
/// Of the whole small disk.
const SMALL: &str = "100k";
const ROOMY: &str = "20m";

/// A disk of its own in memory, where that is allowed.
struct Disk {
    place: PathBuf,
}

impl Disk {
    fn mount(place: PathBuf) -> Result<Option<Self>, Error> {
        std::fs::create_dir(&place)?;
        let mut mount = Command::new("mount");
        mount.args(["-t", "tmpfs", "-o", &format!("size={SMALL}"), "tmpfs"]);
        match mount.arg(&place).output() {
            Ok(output) if output.status.success() => Ok(Some(Self { place })),
            _ => {
                println!("skipped: a small disk cannot be mounted (needs root)");
                Ok(None)
            }
        }
    }

    /// Somebody makes room.
    fn enlarge(&self) -> Outcome {
        let mut mount = Command::new("mount");
        mount.args(["-o", &format!("remount,size={ROOMY}")]);
        assert!(mount.arg(&self.place).status()?.success());
        Ok(())
    }
}

impl Drop for Disk {
    fn drop(&mut self) {
        let _ = Command::new("umount").arg(&self.place).status();
    }
}

/// A folder with the scene in tiny.toml.
fn folder() -> Result<tempfile::TempDir, Error> {
    let folder = tempfile::tempdir()?;
    std::fs::write(folder.path().join("tiny.toml"), TINY)?;
    Ok(folder)
}

/// Runs `tribos` in the folder with files of at most `blocks` of 512 bytes; a larger write is an error, as
/// on a full disk.
fn tribos(folder: &Path, arguments: &str, blocks: Option<u32>) -> Result<Output, Error> {
    let limit = blocks.map(|blocks| format!("trap '' XFSZ; ulimit -f {blocks}; "));
    let program = env!("CARGO_BIN_EXE_tribos");
    let line = format!("{}exec '{program}' {arguments}", limit.unwrap_or_default());
    let mut shell = Command::new("sh");
    Ok(shell.args(["-c", &line]).current_dir(folder).output()?)
}

fn succeed(folder: &Path, arguments: &str) -> Result<String, Error> {
    let output = tribos(folder, arguments, None)?;
    let said = String::from_utf8(output.stderr)?;
    assert!(output.status.success(), "{arguments}: {said}");
    Ok(said)
}

/// The command ends with 1 and says all of this; nothing half written is left.
fn refused(folder: &Path, output: Output, words: &[&str]) -> Result<String, Error> {
    let said = String::from_utf8(output.stderr)?;
    assert_eq!(output.status.code(), Some(1), "{said}");
    for word in words {
        assert!(said.contains(word), "{word}: {said}");
    }
    assert_eq!(litter(folder)?, Vec::<PathBuf>::new());
    Ok(said)
}

/// Temporary files that were not taken away.
fn litter(folder: &Path) -> Result<Vec<PathBuf>, Error> {
    let mut found = Vec::new();
    for entry in std::fs::read_dir(folder)? {
        let path = entry?.path();
        if path.is_dir() {
            found.extend(litter(&path)?);
        } else if path
            .file_name()
            .is_some_and(|name| name.to_string_lossy().starts_with(".tribos-"))
        {
            found.push(path);
        }
    }
    Ok(found)
}

/// A summary without the time on the clock.
fn summary(out: &Path) -> Result<Value, Error> {
    let text = std::fs::read_to_string(out.join("summary.json"))?;
    let mut summary: Value = serde_json::from_str(&text)?;
    summary["wall_seconds"] = Value::Null;
    Ok(summary)
}

const NO_ROOM: &str = "No space left on device";
const TOO_LARGE: &str = "File too large";
const KEPT: &str = "whole and kept";

#[test]
fn a_powder_goes_on_from_its_checkpoint_when_there_is_room() -> Outcome {
    let folder = folder()?;
    succeed(folder.path(), "run tiny.toml --out whole")?;
    let run = "run tiny.toml --checkpoint 0 --out out";
    let place = folder.path().join("out");

    // Too little for a checkpoint: told at the first one.
    let output = tribos(folder.path(), run, Some(4))?;
    let again = ["out/checkpoint.json", TOO_LARGE, KEPT, "no checkpoint yet"];
    refused(folder.path(), output, &again)?;
    std::fs::remove_dir_all(&place)?;

    // Enough for checkpoints, too little for the pictures.
    let output = tribos(folder.path(), run, Some(50))?;
    let resume = [
        "cannot write out/",
        TOO_LARGE,
        KEPT,
        "out/checkpoint.json",
        "--resume",
    ];
    refused(folder.path(), output, &resume)?;
    assert!(place.join("checkpoint.json").exists() && !place.join("summary.json").exists());
    succeed(folder.path(), &format!("{run} --resume"))?;
    assert_eq!(summary(&place)?, summary(&folder.path().join("whole"))?);
    std::fs::remove_dir_all(&place)?;

    let Some(disk) = Disk::mount(place.clone())? else {
        return Ok(());
    };
    let output = tribos(folder.path(), run, None)?;
    refused(
        folder.path(),
        output,
        &["cannot write out/", NO_ROOM, KEPT, "--resume"],
    )?;
    disk.enlarge()?;
    succeed(folder.path(), &format!("{run} --resume"))?;
    assert_eq!(summary(&place)?, summary(&folder.path().join("whole"))?);
    Ok(())
}

#[test]
fn a_sweep_keeps_the_runs_that_were_done() -> Outcome {
    let folder = folder()?;
    let sweep = |out: &str| format!("sweep tiny.toml {GRID} --jobs 2 --out {out}");
    succeed(folder.path(), &sweep("whole"))?;
    let same = |out: &str| -> Outcome {
        for name in ["sweep.csv", "runs.csv", "sweep.png"] {
            let [ours, theirs] =
                ["whole", out].map(|out| std::fs::read(folder.path().join(out).join(name)));
            assert!(ours? == theirs?, "{name}");
        }
        Ok(())
    };

    // Too little for a summary: two runs are under way, and no other begins.
    let output = tribos(folder.path(), &sweep("none"), Some(4))?;
    let words = ["summary.json", TOO_LARGE, KEPT, "0 of 9 runs are done"];
    refused(folder.path(), output, &words)?;
    let begun = std::fs::read_dir(folder.path().join("none/runs"))?.count();
    assert!((1..=2).contains(&begun), "{begun} of 9 began");

    // Enough for summaries, too little for all tables and pictures.
    let output = tribos(folder.path(), &sweep("out"), Some(20))?;
    let words = [
        "cannot write out/",
        TOO_LARGE,
        KEPT,
        "the same command again",
    ];
    refused(folder.path(), output, &words)?;
    let said = succeed(folder.path(), &sweep("out"))?;
    assert_eq!(said, "9 of 9 runs kept\n");
    same("out")?;

    let Some(disk) = Disk::mount(folder.path().join("small"))? else {
        return Ok(());
    };
    // Others fill the disk but for a few files.
    std::fs::write(disk.place.join("others"), vec![1; 68 << 10])?;
    let output = tribos(folder.path(), &sweep("small"), None)?;
    let words = [
        "cannot write small/runs/mu_rolling=",
        NO_ROOM,
        KEPT,
        "the same command again",
    ];
    let said = refused(folder.path(), output, &words)?;
    let ended = said.lines().filter(|line| line.contains(" gone, ")).count();
    assert!((1..9).contains(&ended), "{said}");
    assert!(
        said.contains(&format!("{ended} of 9 runs are done")),
        "{said}"
    );
    disk.enlarge()?;
    let said = succeed(folder.path(), &sweep("small"))?;
    let kept = format!("{ended} of 9 runs kept");
    assert_eq!(said.lines().next(), Some(kept.as_str()), "{said}");
    same("small")
}

#[test]
fn a_lock_without_room_for_its_name_holds_and_goes_away() -> Outcome {
    let folder = folder()?;
    for command in ["run disk --out out", "sweep disk --set spin=1,2 --out out"] {
        let output = tribos(folder.path(), command, Some(0))?;
        refused(
            folder.path(),
            output,
            &["cannot write out/", TOO_LARGE, KEPT],
        )?;
    }
    Ok(())
}

#[test]
fn results_are_kept_when_the_terminal_cannot_be_written() -> Outcome {
    if !Path::new("/dev/full").exists() {
        println!("skipped: no /dev/full");
        return Ok(());
    }
    let folder = folder()?;
    let disk = format!("{}/../scenes/disk.toml", env!("CARGO_MANIFEST_DIR"));
    let run = format!("run '{disk}' --out out >/dev/full");
    let words = ["cannot write to standard output", NO_ROOM];
    let output = tribos(folder.path(), &run, None)?;
    refused(folder.path(), output, &words)?;
    assert!(folder.path().join("out/summary.json").exists());

    // A log on a full disk stops no run.
    let sweep = format!("sweep tiny.toml {GRID} --out log 2>/dev/full");
    succeed(folder.path(), &sweep)?;
    Ok(())
}
