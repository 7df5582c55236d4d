//! Pages do what they print: every command of the README, of the book, of the doors' READMEs and of the help texts runs, and so
//! does every scene.
//!
//! A block ```` ```console ```` has commands after `$ ` and their standard output, which is compared: a line `…` stands for any
//! lines, `…` in a line for any text. Other commands need only succeed; powders and tips are cut short in them. A picture
//! after `<!-- picture: FILE -->` is the FILE that the page's commands left, to the byte. With
//! TRIBOS_PRINTED=whole nothing is cut short; TRIBOS_WRITE_PAGES=1 writes outputs and pictures anew.
#![cfg(unix)]

use crate::program::{Error, Outcome, told};
use crate::reader::{prepare, said};
use std::collections::HashSet;
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::Mutex;

/// Keys that cut a powder, and a tip, to a few steps.
const SHORT: [(&str, &str); 10] = [
    ("compaction-", " --set max_steps=2"),
    ("shear-cell", " --set max_steps=2"),
    ("pressed", " --set max_steps=2"),
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
fn pages_do_what_they_print() -> Outcome {
    let pages = pages()?;
    assert!(pages.len() > 50, "{}", pages.len());
    let (queue, faults) = (Mutex::new(pages), Mutex::new(Vec::new()));
    let next = || queue.lock().ok()?.pop();
    let work = || {
        while let Some(page) = next() {
            let found = Page::read(&page).and_then(Page::judged);
            let found = found.unwrap_or_else(|error| vec![error.to_string()]);
            let told = found
                .into_iter()
                .map(|fault| format!("{}: {fault}", page.display()));
            faults.lock().expect("a list").extend(told);
        }
    };
    std::thread::scope(|scope| {
        for _ in 0..2 {
            scope.spawn(work);
        }
    });
    let faults = faults.into_inner()?;
    assert!(faults.is_empty(), "{}", faults.join("\n\n"));
    Ok(())
}

/// Every page of the repository but the list of changes, which tells of commands as they were.
fn pages() -> Result<Vec<PathBuf>, Error> {
    let mut folders = vec![Path::new(env!("CARGO_MANIFEST_DIR")).join("..")];
    let mut pages = Vec::new();
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(folder)? {
            let path = entry?.path();
            let name = path.file_name().unwrap_or_default().to_string_lossy();
            let skipped = name.starts_with('.')
                || ["target", "node_modules", "CHANGELOG.md"].contains(&&*name);
            if skipped || path.is_symlink() {
                continue;
            }
            if path.is_dir() {
                folders.push(path);
            } else if name.ends_with(".md") {
                pages.push(path);
            }
        }
    }
    Ok(pages)
}

/// A page that is run from its top to its end, in a folder of its own.
struct Page {
    path: PathBuf,
    text: String,
    folder: tempfile::TempDir,
    /// The page as it should be.
    written: String,
    faults: Vec<String>,
}

impl Page {
    fn read(path: &Path) -> Result<Self, Error> {
        Ok(Self {
            path: path.to_owned(),
            text: fs::read_to_string(path)?,
            folder: tempfile::tempdir()?,
            written: String::new(),
            faults: Vec::new(),
        })
    }

    /// What is wrong with it.
    fn judged(mut self) -> Result<Vec<String>, Error> {
        let text = std::mem::take(&mut self.text);
        if !text.contains("tribos ") {
            return Ok(self.faults);
        }
        prepare(self.folder.path())?;
        // A page may show a picture before the command that draws it.
        let mut pictures = Vec::new();
        let mut lines = text.lines();
        while let Some(line) = lines.next() {
            self.keep(line);
            if line == "```console" {
                let block: Vec<&str> = lines.by_ref().take_while(|line| *line != "```").collect();
                self.session(&block)?;
                self.keep("```");
            } else if let Some(drawn) = line.strip_prefix("<!-- picture: ") {
                let mut shown = String::new();
                while !shown.contains("](")
                    && let Some(more) = lines.next()
                {
                    self.keep(more);
                    shown += more;
                }
                pictures.push((drawn.trim_end_matches(" -->"), shown));
            } else if line.trim_start().starts_with("$ tribos ") {
                let fault = format!("a command outside of a console block is not run: {line}");
                self.faults.push(fault);
            } else {
                let mut command = line.to_owned();
                while command.trim_start().starts_with("tribos ") && command.ends_with('\\') {
                    let more = lines.next().unwrap_or_default();
                    self.keep(more);
                    command = command.trim_end_matches('\\').to_owned() + more.trim();
                }
                for command in printed(&command) {
                    self.faults.extend(fault(self.folder.path(), &command)?);
                }
            }
        }
        for (drawn, shown) in pictures {
            self.picture(drawn, &shown)?;
        }
        if writes() && self.written != text {
            fs::write(&self.path, &self.written)?;
        }
        Ok(self.faults)
    }

    fn keep(&mut self, line: &str) {
        self.written += line;
        self.written.push('\n');
    }

    /// Commands after `$ `, each with what it prints.
    fn session(&mut self, block: &[&str]) -> Outcome {
        let mut rest = block;
        while let [first, ..] = rest {
            let Some(mut command) = first.strip_prefix("$ ").map(String::from) else {
                self.faults
                    .push(format!("no command begins a console block: {first}"));
                return Ok(());
            };
            self.keep(first);
            rest = &rest[1..];
            while command.ends_with('\\') {
                command.pop();
                command += rest.first().unwrap_or(&"");
                self.keep(rest.first().unwrap_or(&""));
                rest = rest.get(1..).unwrap_or_default();
            }
            let end = rest.iter().position(|line| line.starts_with("$ "));
            let (expected, later) = rest.split_at(end.unwrap_or(rest.len()));
            rest = later;
            let (code, out, err) = said(self.folder.path(), &command, "")?;
            if code != Some(0) {
                self.faults.push(format!("{command}\n{err}"));
            }
            let printed: Vec<&str> = out.lines().map(str::trim_end).collect();
            if expected.is_empty() || same(expected, &printed) {
                expected.iter().for_each(|line| self.keep(line));
            } else {
                printed.iter().for_each(|line| self.keep(line));
                if !writes() {
                    self.faults
                        .push(format!("{command} prints\n{}", printed.join("\n")));
                }
            }
        }
        Ok(())
    }

    /// The picture that the line shows is the file that a command drew.
    fn picture(&mut self, drawn: &str, shown: &str) -> Outcome {
        let kept = shown
            .split_once("](")
            .and_then(|(_, rest)| rest.split_once(')'));
        let kept = kept.map(|(path, _)| self.path.with_file_name(path));
        let (Some(kept), Ok(drawn)) = (kept, fs::read(self.folder.path().join(drawn))) else {
            self.faults.push(format!("no picture {drawn}: {shown}"));
            return Ok(());
        };
        if writes() {
            fs::write(kept, drawn)?;
        } else if fs::read(&kept).ok().as_ref() != Some(&drawn) {
            self.faults
                .push(format!("another picture is drawn: {shown}"));
        }
        Ok(())
    }
}

/// Whether a session printed what a page says.
fn same(expected: &[&str], printed: &[&str]) -> bool {
    match expected {
        [] => printed.is_empty(),
        ["…", rest @ ..] => (0..=printed.len()).any(|count| same(rest, &printed[count..])),
        [first, rest @ ..] => {
            printed.first().is_some_and(|line| like(first, line)) && same(rest, &printed[1..])
        }
    }
}

fn like(expected: &str, printed: &str) -> bool {
    let Some((head, tail)) = expected.split_once('…') else {
        return expected == printed;
    };
    let Some(rest) = printed.strip_prefix(head) else {
        return false;
    };
    let mut ends = rest.char_indices().map(|(at, _)| at).chain([rest.len()]);
    ends.any(|at| like(tail, &rest[at..]))
}

#[test]
fn what_a_page_leaves_out_is_any_text() {
    assert!(same(&["a", "…", "b … s"], &["a", "x", "y", "b 0.3 s"]));
    assert!(same(&["…"], &[]) && same(&["1…"], &["1"]));
    assert!(!same(&["a 1"], &["a 2"]) && !same(&["a"], &["a", "b"]) && !same(&["a", "…"], &["b"]));
    assert!(!like("b … s", "b 3 m"));
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
        if whole.starts_with("tribos ") {
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
    let mut seen = HashSet::new();
    let mut failed = Vec::new();
    for command in commands.iter().filter(|command| seen.insert(*command)) {
        failed.extend(fault(folder.path(), command)?);
    }
    assert!(failed.is_empty(), "{}", failed.join("\n"));
    Ok(())
}

/// What is wrong with a command, cut short.
fn fault(folder: &Path, command: &str) -> Result<Option<String>, Error> {
    let padded = format!("{command}\n");
    if ELSEWHERE.iter().any(|(part, _)| padded.contains(part)) {
        return Ok(None);
    }
    let (code, _, told) = said(folder, &line(command), "")?;
    Ok((code != Some(0)).then(|| format!("{command}\n{told}")))
}

fn whole() -> bool {
    std::env::var("TRIBOS_PRINTED").is_ok_and(|how| how == "whole")
}

fn writes() -> bool {
    std::env::var_os("TRIBOS_WRITE_PAGES").is_some()
}

/// What a shell gets: the commands, cut short.
fn line(command: &str) -> String {
    let command = command.split(" #").next().unwrap_or_default();
    let each = command.split(" && ").map(|one| {
        let one = one.trim();
        let simulates = ["tribos run ", "tribos sweep ", "tribos explain "];
        if whole() || !simulates.iter().any(|call| one.starts_with(call)) {
            return one.to_owned();
        }
        let short = SHORT.iter().find(|(scene, _)| one.contains(scene));
        cut_short(one, short.map_or("", |(_, keys)| keys))
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
