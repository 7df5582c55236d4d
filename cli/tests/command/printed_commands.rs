//! Every command that the README, the docs and the help texts print runs, and so does every scene.
//!
//! Powders and tips are cut short; with TRIBOS_PRINTED=whole they run to their ends.
#![cfg(unix)]

use crate::program::{Outcome, told};
use crate::reader::{prepare, said};
use std::fs;
use std::path::Path;

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
    let mut commands = Vec::new();
    for command in tribos_cli::command::program().get_subcommands() {
        commands.extend(printed(&told([command.get_name(), "--help"])?));
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
        let (code, _, told) = said(folder.path(), &line(command), "")?;
        if code != Some(0) {
            failed.push(format!("{command}\n{told}"));
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
