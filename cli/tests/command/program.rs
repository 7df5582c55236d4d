//! The program as a test starts it, what it says, and what it leaves.

use serde_json::Value;
use std::collections::BTreeMap;
use std::path::Path;
use std::process::{Command, Output, Stdio};
use std::time::{Duration, Instant};

pub type Error = Box<dyn std::error::Error>;
pub type Outcome = Result<(), Error>;

/// Exit code, standard output and standard error.
pub type Said = (Option<i32>, String, String);

/// Arguments of a command: a line that is cut at its spaces, or words that may contain some.
pub trait Arguments {
    fn words(&self) -> Vec<String>;
}

impl Arguments for str {
    fn words(&self) -> Vec<String> {
        self.split_whitespace().map(Into::into).collect()
    }
}

impl<A: Arguments + ?Sized> Arguments for &A {
    fn words(&self) -> Vec<String> {
        (*self).words()
    }
}

impl Arguments for String {
    fn words(&self) -> Vec<String> {
        self.as_str().words()
    }
}

impl<S: AsRef<str>> Arguments for [S] {
    fn words(&self) -> Vec<String> {
        self.iter().map(|word| word.as_ref().to_owned()).collect()
    }
}

impl<S: AsRef<str>, const N: usize> Arguments for [S; N] {
    fn words(&self) -> Vec<String> {
        self.as_slice().words()
    }
}

impl<S: AsRef<str>> Arguments for Vec<S> {
    fn words(&self) -> Vec<String> {
        self.as_slice().words()
    }
}

/// The command in a folder, to be run: it says nothing on the terminal.
pub fn prepared(folder: impl AsRef<Path>, arguments: impl Arguments) -> Command {
    let mut tribos = Command::new(env!("CARGO_BIN_EXE_tribos"));
    tribos.current_dir(folder).args(arguments.words());
    tribos
        .stdin(Stdio::null())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped());
    tribos
}

/// Runs the command in a folder.
pub fn tribos(folder: impl AsRef<Path>, arguments: impl Arguments) -> Result<Said, Error> {
    let output = prepared(folder, arguments).output()?;
    let [out, err] = texts(&output)?;
    Ok((output.status.code(), out, err))
}

/// Runs a command that works in a folder: what it said on standard output and error.
pub fn succeed(folder: impl AsRef<Path>, arguments: impl Arguments) -> Result<[String; 2], Error> {
    let (code, out, err) = tribos(folder, &arguments)?;
    assert_eq!(code, Some(0), "{:?}: {err}", arguments.words());
    Ok([out, err])
}

/// Runs a command that works without files: its standard output.
pub fn told(arguments: impl Arguments) -> Result<String, Error> {
    let [out, _] = succeed(".", arguments)?;
    Ok(out)
}

/// Standard output and error of a command that has ended.
pub fn texts(output: &Output) -> Result<[String; 2], Error> {
    let text = |bytes: &[u8]| String::from_utf8(bytes.to_vec());
    Ok([text(&output.stdout)?, text(&output.stderr)?])
}

/// The path of a scene that ships with the project.
pub fn scene(name: &str) -> String {
    format!("{}/../scenes/{name}.toml", env!("CARGO_MANIFEST_DIR"))
}

/// `tribos run SCENE --out OUT --set …`, not yet run.
pub fn run(scene: &str, out: &Path, overrides: &[&str]) -> Command {
    let mut command = prepared(".", ["run", scene, "--out"]);
    command.arg(out);
    for item in overrides {
        command.args(["--set", item]);
    }
    command
}

/// The summary of a run of a scene that ships with the project.
pub fn summary_of(name: &str, out: &Path, overrides: &[&str]) -> Result<Value, Error> {
    let output = run(&scene(name), out, overrides).output()?;
    let [_, said] = texts(&output)?;
    assert!(output.status.success(), "{name}: {said}");
    summary(out)
}

/// A file of JSON.
pub fn json(file: &Path) -> Result<Value, Error> {
    Ok(serde_json::from_str(&std::fs::read_to_string(file)?)?)
}

/// The summary in a folder.
pub fn summary(out: &Path) -> Result<Value, Error> {
    json(&out.join("summary.json"))
}

/// A number of a summary by its name, or its place that begins with a slash.
pub fn number(value: &Value, place: &str) -> f64 {
    let found = match place.starts_with('/') {
        true => value.pointer(place),
        false => value.get(place),
    };
    found.and_then(Value::as_f64).unwrap_or(f64::NAN)
}

/// The files of a folder with all below it; times on the clock left out.
pub fn files(folder: &Path) -> Result<BTreeMap<String, Vec<u8>>, Error> {
    let mut files = BTreeMap::new();
    let mut folders = vec![folder.to_path_buf()];
    while let Some(here) = folders.pop() {
        for entry in std::fs::read_dir(&here)? {
            let path = entry?.path();
            if path.is_dir() {
                folders.push(path);
                continue;
            }
            let name = path.strip_prefix(folder)?.to_string_lossy().into_owned();
            let mut bytes = std::fs::read(&path)?;
            if name == "summary.json" {
                let text = String::from_utf8(bytes)?;
                let kept = text.lines().filter(|line| !line.contains("wall_seconds"));
                bytes = kept.collect::<String>().into_bytes();
            }
            files.insert(name, bytes);
        }
    }
    Ok(files)
}

/// The text has all of these words.
#[track_caller]
pub fn assert_has(text: &str, words: &[&str]) {
    for words in words {
        assert!(text.contains(words), "{words} not in {text}");
    }
}

/// Waits a minute at most.
#[track_caller]
pub fn wait_for(what: &str, is_there: impl Fn() -> bool) {
    let patience = Instant::now();
    while !is_there() {
        assert!(patience.elapsed() < Duration::from_secs(60), "{what}");
        std::thread::sleep(Duration::from_millis(1));
    }
}
