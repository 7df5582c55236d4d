//! Every command that the README, the docs and the help texts print runs, and so does every scene.
//!
//! Powders and tips are cut short; with TRIBOS_PRINTED=whole they run to their ends.
#![cfg(unix)]

use crate::program::{Error, Outcome};
use std::fs;
use std::path::Path;
use std::process::{Command, Stdio};

/// As printed for a reader who has the repository, and for one who has the command.
const CALLS: [&str; 2] = ["cargo run --release -- ", "tribos "];
/// Keys that cut a powder, and a tip, to a few steps.
const SHORT: [(&str, &str); 9] = [
    ("compaction-", " --set max_steps=2"),
    ("shear-cell", " --set max_steps=2"),
    ("column", " --set max_steps=2"),
    ("heap", " --set max_steps=2"),
    ("hopper", " --set max_steps=2"),
    ("drum", " --set max_steps=2"),
    ("cyclic", " --set max_steps=2"),
    ("shaken", " --set max_steps=2"),
    (
        "tip-",
        " --set equilibration=0.01 --set drive_time=0.01 --set rest_time=0.01",
    ),
];
/// Commands that need more than a folder: what shows that they work is said beside them.
const ELSEWHERE: [(&str, &str); 7] = [
    (
        "--resume",
        "a run that was killed: tests of powders and tips",
    ),
    ("--full", "an hour"),
    ("--film", "ffmpeg"),
    ("Out-String", "PowerShell"),
    ("&& man ", "a reader of manuals"),
    ("sbatch", "Slurm: tests/slurm.sh"),
    ("tribos reproduce ", "tribos-thesis: its own tests"),
];

#[test]
fn commands_of_the_readme_and_the_docs_run() -> Outcome {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let mut pages = vec![root.join("README.md")];
    for entry in fs::read_dir(root.join("docs"))? {
        pages.push(entry?.path());
    }
    pages.sort();
    let texts = pages
        .iter()
        .filter(|page| page.extension().is_some_and(|e| e == "md"));
    let texts: Result<Vec<String>, _> = texts.map(fs::read_to_string).collect();
    let mut commands: Vec<String> = texts?.iter().flat_map(|text| printed(text)).collect();
    assert!(commands.len() > 40, "{}", commands.len());
    let mut seen = std::collections::HashSet::new();
    commands.retain(|command| seen.insert(command.clone()));
    all_run(&commands)
}

#[test]
fn every_scene_runs() -> Outcome {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let mut names = Vec::new();
    for entry in fs::read_dir(root.join("scenes"))? {
        names.push(entry?.file_name().to_string_lossy().into_owned());
    }
    names.retain(|name| name.ends_with(".toml") && !name.starts_with("golden"));
    names.sort();
    assert!(names.len() >= 11, "{names:?}");
    let run = |name: &String| format!("tribos run scenes/{name} --out out/{name}");
    all_run(&names.iter().map(run).collect::<Vec<_>>())
}

#[test]
fn examples_of_the_help_texts_run() -> Outcome {
    let help = |name: &str| -> Result<String, Error> {
        let mut command = Command::new(env!("CARGO_BIN_EXE_tribos"));
        let output = command.arg(name).arg("--help").output()?;
        Ok(String::from_utf8(output.stdout)?)
    };
    let mut commands = Vec::new();
    for command in tribos_cli::command::program().get_subcommands() {
        commands.extend(printed(&help(command.get_name())?));
    }
    assert!(commands.len() > 30, "{}", commands.len());
    all_run(&commands)
}

/// Commands in blocks of code and, where they have options and no gaps, in running text.
fn printed(text: &str) -> Vec<String> {
    let mut commands = Vec::new();
    let mut lines = text.lines();
    while let Some(line) = lines.next() {
        let mut whole = line.trim().to_owned();
        if CALLS.iter().any(|call| whole.starts_with(call)) {
            while whole.ends_with('\\') {
                whole.pop();
                whole += lines.next().unwrap_or_default().trim();
            }
            commands.push(whole);
        } else {
            let quoted = line.split('`').skip(1).step_by(2);
            let is_whole = |quoted: &&str| quoted.starts_with("tribos ") && quoted.contains(" --");
            commands.extend(quoted.filter(is_whole).map(String::from));
        }
    }
    let placeholder = |word: &str| {
        let gap = |c: char| c.is_ascii_uppercase() || ".[=".contains(c);
        word.len() > 1 && word.chars().all(gap)
    };
    commands
        .retain(|command| !command.contains(['…', '<']) && !command.split(' ').any(placeholder));
    commands
}

/// Runs them one after another in one folder, as a reader does.
fn all_run(commands: &[String]) -> Outcome {
    let folder = tempfile::tempdir()?;
    prepare(folder.path())?;
    let mut failed = Vec::new();
    for command in commands {
        let whole = format!("{command}\n");
        if ELSEWHERE.iter().any(|(part, _)| whole.contains(part)) {
            continue;
        }
        if let Err(said) = runs(&line(command), folder.path())? {
            failed.push(format!("{command}\n{said}"));
        }
    }
    assert!(failed.is_empty(), "{}", failed.join("\n"));
    Ok(())
}

/// What a shell gets: the commands, cut short.
fn line(command: &str) -> String {
    let command = command.split(" #").next().unwrap_or_default();
    let whole = std::env::var("TRIBOS_PRINTED").is_ok_and(|how| how == "whole");
    let [cargo, tribos] = CALLS;
    let each = command.split(" && ").map(|one| {
        let one = one.trim();
        let mut one = match one.strip_prefix(cargo) {
            Some(rest) => format!("{tribos}{rest}"),
            None => one.to_owned(),
        };
        let simulates = ["tribos run ", "tribos sweep ", "tribos explain "];
        if !whole && simulates.iter().any(|call| one.starts_with(call)) {
            let short = SHORT.iter().find(|(scene, _)| one.contains(scene));
            one = cut_short(&one, short.map_or("", |(_, keys)| keys));
        }
        one
    });
    each.collect::<Vec<_>>().join(" && ")
}

/// The command with these `--set KEY=VALUE`, in place of its own of the same keys.
fn cut_short(command: &str, settings: &str) -> String {
    let mut words: Vec<&str> = command.split(' ').collect();
    for setting in settings.split_whitespace().filter(|word| *word != "--set") {
        let Some((key, _)) = setting.split_once('=') else {
            words.push(setting);
            continue;
        };
        let start = format!("{key}=");
        match words.iter().position(|word| word.starts_with(&start)) {
            Some(at) => words[at] = setting,
            None => words.extend(["--set", setting]),
        }
    }
    words.join(" ")
}

/// What it said, if it failed.
fn runs(line: &str, folder: &Path) -> Result<Result<(), String>, Error> {
    let program = Path::new(env!("CARGO_BIN_EXE_tribos"));
    let own = program.parent().ok_or("no folder")?.display();
    let path = format!("{own}:{}", std::env::var("PATH")?);
    let output = Command::new("sh")
        .args(["-c", line])
        .current_dir(folder)
        .env("PATH", path)
        .env("HOME", folder)
        .stdin(Stdio::null())
        .output()?;
    if output.status.success() {
        return Ok(Ok(()));
    }
    Ok(Err(String::from_utf8_lossy(&output.stderr).into_owned()))
}

/// The scenes, and the files that a reader is taken to have.
fn prepare(folder: &Path) -> Outcome {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    copy(&root.join("scenes"), &folder.join("scenes"))?;
    fs::copy(root.join("scenes/disk.toml"), folder.join("my.toml"))?;
    let contacts = root.join("std-adapter/contacts/src/problem/file/samples");
    for (theirs, ours) in [
        ("Rover1041.dat", "rover.dat"),
        ("NESpheres_10_1.dat", "spheres.dat"),
    ] {
        fs::copy(contacts.join(theirs), folder.join(ours))?;
    }
    // Where shells look for completions.
    for place in [
        ".local/share/bash-completion/completions",
        ".zfunc",
        ".config/fish/completions",
    ] {
        fs::create_dir_all(folder.join(place))?;
    }
    let atoms = root.join("tests/tables/md");
    for (theirs, ours) in [
        ("fcc500.data", "melt.data"),
        ("slab576.data", "slab.data"),
        ("binary500.data", "glass.data"),
    ] {
        fs::copy(atoms.join(theirs), folder.join(ours))?;
    }
    // A metal under the name of another.
    let metal = fs::read_to_string(atoms.join("synthetic.eam.alloy"))?;
    let metal = metal.replacen("2 Aa Bb", "2 Cu Bb", 1);
    fs::write(folder.join("Cu_mishin1.eam.alloy"), metal)?;
    fs::write(folder.join("copper.xyz"), copper())?;
    fs::write(folder.join("twists.csv"), "speed,spin\n1,0\n0.5,20\n")?;
    let feet = "x,y,weight\n0.1,0,0.4\n-0.1,0.1,0.3\n-0.1,-0.1,0.3\n";
    fs::write(folder.join("feet.csv"), feet)?;
    let sole = "x,y\n0,0\n0.24,0\n0.24,0.1\n0,0.08\n";
    fs::write(folder.join("sole.csv"), sole)?;
    let face = "x1,y1,p1,x2,y2,p2,x3,y3,p3\n0,0,1,0.1,0,2,0,0.1,0\n";
    fs::write(folder.join("face.csv"), face)?;
    let pushes = "force_x,force_y,torque\n100,20,5\n300,0,-10\n";
    fs::write(folder.join("pushes.csv"), pushes)?;
    measurements(folder)
}

/// Friction over speed, and over time, as somebody may have measured it.
fn measurements(folder: &Path) -> Outcome {
    let speeds: Vec<f64> = (0..40).map(|i| 1e-4 * 1.25_f64.powi(i)).collect();
    let noise = |i: usize| 1e-3 * ((7 * i % 11) as f64 - 5.0);
    let steady = |f: &dyn Fn(f64) -> f64, columns: &str, rest: &str| {
        let lines = speeds.iter().enumerate();
        let lines = lines.map(|(i, v)| format!("{v},{}{rest}\n", f(*v) + noise(i)));
        format!("{columns}\n{}", lines.collect::<String>())
    };
    let stribeck = |v: f64| 0.1 + 0.05 * (-(v / 0.01).powi(2)).exp() + 0.02 * v;
    fs::write(
        folder.join("bearing.csv"),
        steady(&stribeck, "v,f,sigma", ",0.002"),
    )?;
    fs::write(
        folder.join("forces.csv"),
        steady(&|v| 12.5 * stribeck(v), "v,f", ""),
    )?;
    fs::write(
        folder.join("ice.csv"),
        steady(&|v| 0.05 * v.powf(0.5), "v,f", ""),
    )?;
    fs::write(
        folder.join("steps.csv"),
        steady(&|v| 0.6 - 0.01 * v.ln(), "v,f", ""),
    )?;
    let pull = (0..300).map(|i| {
        let (t, v) = (1e-3 * f64::from(i), 0.05 * (0.04 * f64::from(i)).sin());
        format!(
            "{t},{v},{}\n",
            (1.0 - (-30.0 * t).exp()) * v.signum() + 0.4 * v
        )
    });
    fs::write(
        folder.join("pull.csv"),
        format!("t,v,f\n{}", pull.collect::<String>()),
    )?;
    Ok(())
}

fn copy(from: &Path, to: &Path) -> Outcome {
    fs::create_dir_all(to)?;
    for entry in fs::read_dir(from)? {
        let (path, name) = (
            entry.as_ref().map(fs::DirEntry::path),
            entry.as_ref().map(fs::DirEntry::file_name),
        );
        let (Ok(path), Ok(name)) = (path, name) else {
            continue;
        };
        if path.is_dir() {
            copy(&path, &to.join(name))?;
        } else {
            fs::copy(&path, to.join(name))?;
        }
    }
    Ok(())
}

/// A crystal of 3 × 3 × 3 cubes of four atoms.
fn copper() -> String {
    const EDGE: f64 = 3.6;
    let side = 3.0 * EDGE;
    let mut text = format!(
        "108\nLattice=\"{side} 0 0 0 {side} 0 0 0 {side}\" pbc=\"T T T\" Properties=species:S:1:pos:R:3\n"
    );
    for cell in 0..27 {
        let corner = [cell % 3, cell / 3 % 3, cell / 9].map(f64::from);
        for shift in [
            [0.0, 0.0, 0.0],
            [0.5, 0.5, 0.0],
            [0.5, 0.0, 0.5],
            [0.0, 0.5, 0.5],
        ] {
            let [x, y, z] = [0, 1, 2].map(|axis| EDGE * (corner[axis] + shift[axis]));
            text += &format!("Cu {x} {y} {z}\n");
        }
    }
    text
}
