//! Builds and runs the digests of one platform.

use super::options::Options;
use super::platforms::{Machine, Platform, Tool};
use super::process::output;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::{Duration, Instant};
use std::{env, fs};
use tribos_subjects::SUBJECTS;

/// Longest time for one build.
const BUILD_LIMIT: Duration = Duration::from_secs(1800);
/// QEMU's clock: one nanosecond per instruction, so that instructions of whole subjects can be counted.
const ICOUNT: &str = "shift=0,sleep=off";
/// Message of the linker for an image larger than its flash.
const TOO_LARGE: &str = "will not fit in region";

/// Runs every subject of the WebAssembly module given as argument.
const NODE_SCRIPT: &str = "
const bytes = require('fs').readFileSync(process.argv[1]);
const { digest } = new WebAssembly.Instance(new WebAssembly.Module(bytes), {}).exports;
for (let index = 0, got; (got = BigInt.asUintN(64, digest(index))) !== 0n; index++)
  console.log(`${index} ${got.toString(16)}`);
";

/// One subject as a platform computed it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Answer {
    /// Its index among all subjects.
    pub subject: usize,
    /// Its digest.
    pub digest: u64,
    /// Number of instructions, if counted.
    pub instructions: Option<u64>,
}

/// A program and the subjects that it contains.
#[derive(Clone, Debug)]
pub struct Image {
    file: PathBuf,
    subjects: Vec<usize>,
}

/// Missing programs of a platform: one line each, with the command that installs it.
pub fn missing(platform: &Platform) -> Vec<String> {
    let absent = |tool: &&Tool| {
        let [name, arguments @ ..] = tool.check else {
            return false;
        };
        output(Command::new(name).args(arguments), BUILD_LIMIT).is_err()
    };
    let tools = platform.tools.iter().filter(absent);
    let mut lines: Vec<String> = tools.map(|tool| tool.install.into()).collect();
    lines.extend(
        platform
            .target
            .filter(|target| !is_installed(target))
            .map(|target| format!("rustup target add {target}")),
    );
    lines
}

fn is_installed(target: &str) -> bool {
    let root = output(
        Command::new("rustc").args(["--print", "sysroot"]),
        BUILD_LIMIT,
    );
    let library = |root: String| Path::new(root.trim()).join("lib/rustlib").join(target);
    root.is_ok_and(|root| library(root).join("lib").is_dir())
}

/// Builds the programs of a platform: one, or as many as the flash requires.
///
/// # Errors
/// The message of cargo or the linker.
pub fn build(platform: &Platform) -> Result<Vec<Image>, String> {
    let mut open = vec![platform.subjects()];
    let mut images = Vec::new();
    while let Some(subjects) = open.pop() {
        match image(platform, &subjects) {
            Ok(image) => images.push(image),
            // Half the subjects in each of two images.
            Err(message) if message.contains(TOO_LARGE) && subjects.len() > 1 => {
                let (first, second) = subjects.split_at(subjects.len() / 2);
                open.extend([second.to_vec(), first.to_vec()]);
            }
            Err(message) => return Err(message),
        }
    }
    Ok(images)
}

fn image(platform: &Platform, subjects: &[usize]) -> Result<Image, String> {
    let listed: Vec<String> = subjects.iter().map(usize::to_string).collect();
    let target_dir = target_dir();
    let mut cargo = Command::new(env::var_os("CARGO").unwrap_or("cargo".into()));
    cargo.current_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/.."));
    cargo.args(["build", "--quiet", "--profile", platform.profile]);
    cargo.arg("--target-dir").arg(&target_dir);
    for setting in platform.config {
        cargo.args(["--config", setting]);
    }
    cargo.env("RUSTFLAGS", platform.flags);
    cargo.env_remove("CARGO_ENCODED_RUSTFLAGS");
    if let Some(target) = platform.target {
        cargo.args(["--target", target]);
    }
    let made = match platform.machine {
        Machine::Host(_) => {
            cargo.args(["-p", "tribos-subjects", "--example", "print"]);
            "examples/print"
        }
        Machine::Node => {
            cargo.args(["-p", "tribos-subjects", "--example", "wasm"]);
            "examples/wasm.wasm"
        }
        Machine::Board { board, .. } => {
            cargo.args(["-p", "tribos-boards", "--bin", "digest"]);
            cargo.env("TRIBOS_BOARD", board);
            cargo.env("TRIBOS_SUBJECTS", listed.join(","));
            "digest"
        }
    };
    output(&mut cargo, BUILD_LIMIT)?;
    // A copy, because the next build may overwrite the image.
    let folder = [("dev", "debug")]
        .into_iter()
        .find(|(of, _)| *of == platform.profile);
    let folder = folder.map_or(platform.profile, |(_, folder)| folder);
    let built = target_dir.join(platform.target.unwrap_or(""));
    let file = target_dir.join(format!("{}-{}", platform.name, subjects[0]));
    let built = built.join(folder).join(made);
    fs::copy(&built, &file).map_err(|e| format!("{}: {e}", built.display()))?;
    let subjects = subjects.to_vec();
    Ok(Image { file, subjects })
}

/// A separate folder, so that no other build waits for this one.
fn target_dir() -> PathBuf {
    let usual = concat!(env!("CARGO_MANIFEST_DIR"), "/../target").into();
    let root: PathBuf = env::var_os("CARGO_TARGET_DIR").unwrap_or(usual).into();
    root.join("cross")
}

/// Runs the images one after the other: returns the results in the order of the subjects, and the time.
///
/// # Errors
/// A program that fails, takes too long or gives no result for one of its subjects.
pub fn run(
    platform: &Platform,
    images: &[Image],
    options: &Options,
) -> Result<(Vec<Answer>, Duration), String> {
    let begin = Instant::now();
    let limit = Duration::from_secs(options.limit);
    let mut answers = Vec::new();
    for image in images {
        let mut command = command(platform, &image.file);
        if !options.quick && matches!(platform.machine, Machine::Board { .. }) {
            command.args(["-icount", ICOUNT]);
        }
        let text = output(&mut command, limit)?;
        let lines = text.lines().map(answer).collect::<Result<Vec<_>, _>>()?;
        let told: Vec<usize> = lines.iter().map(|answer| answer.subject).collect();
        if told != image.subjects {
            return Err(format!(
                "subjects {told:?} answered, not {:?}",
                image.subjects
            ));
        }
        answers.extend(lines);
    }
    answers.sort_by_key(|answer| answer.subject);
    Ok((answers, begin.elapsed()))
}

fn command(platform: &Platform, file: &Path) -> Command {
    match platform.machine {
        Machine::Host([]) => Command::new(file),
        Machine::Host([emulator, arguments @ ..]) => {
            let mut command = Command::new(emulator);
            command.args(arguments).arg(file);
            command
        }
        Machine::Node => {
            let mut command = Command::new("node");
            command.args(["-e", NODE_SCRIPT]).arg(file);
            command
        }
        Machine::Board {
            emulator, board, ..
        } => {
            let mut command = Command::new(emulator);
            command.args(["-M", board, "-nographic"]);
            command.args(["-semihosting-config", "enable=on,target=native"]);
            // QEMU's RISC-V machine would start its own firmware by default.
            if board == "virt" {
                command.args(["-bios", "none"]);
            }
            command.arg("-kernel").arg(file);
            command
        }
    }
}

/// `index digest [instructions]`
fn answer(line: &str) -> Result<Answer, String> {
    let wrong = || format!("an answer that cannot be read: {line}");
    let mut words = line.split_whitespace();
    let mut word = || words.next();
    let subject = word().and_then(|w| w.parse().ok()).ok_or_else(wrong)?;
    let digest = word().and_then(|w| u64::from_str_radix(w, 16).ok());
    let digest = digest.ok_or_else(wrong)?;
    let instructions = word()
        .and_then(|w| w.parse().ok())
        .filter(|&count| count > 0);
    if subject >= SUBJECTS.len() {
        return Err(wrong());
    }
    Ok(Answer {
        subject,
        digest,
        instructions,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn answers_are_read_whole_or_refused() {
        let got = answer("3 00ff 17").unwrap();
        assert_eq!([got.subject as u64, got.digest], [3, 255]);
        assert_eq!(got.instructions, Some(17));
        assert_eq!(answer("0 1").unwrap().instructions, None);
        for wrong in ["", "3", "x 1 1", "3 g 1", "99999 1 1"] {
            answer(wrong).unwrap_err();
        }
    }
}
