//! Builds the proof and its control for microcontrollers, and reports whether the kernel can panic.
//!
//! `cargo run -p tribos-no-panic --bin prove -- [--quick]` builds `no_panic` and `control` for three
//! targets at opt-levels 3, "s" and "z"; `--quick` omits "s" and "z" and all controls but one. It
//! fails if `no_panic` does not link, if a function of the list is not in the image, or if
//! `control` links, or fails for another reason than its panic.

use clap::Parser;
use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode};
use tribos_no_panic::functions;

const TARGETS: [&str; 3] = [
    "thumbv7em-none-eabihf",
    "thumbv6m-none-eabi",
    "riscv32imac-unknown-none-elf",
];
const LEVELS: [&str; 3] = ["3", "\"s\"", "\"z\""];

/// Message of the linker for a reachable panic.
const PANIC: &str = "undefined symbol: a_panic_is_reachable";

/// Proves by linking that no public function of tribos-core can panic.
#[derive(clap::Parser)]
struct Options {
    /// opt-level 3 alone, and one control
    #[arg(long)]
    quick: bool,
}

fn main() -> ExitCode {
    let outcome = match Options::parse().quick {
        true => prove(&LEVELS[..1], 1),
        false => prove(&LEVELS, TARGETS.len() * LEVELS.len()),
    };
    match outcome {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("prove: {message}");
            ExitCode::FAILURE
        }
    }
}

/// Builds all targets at `levels`, the first `controls` of them with their control.
fn prove(levels: &[&str], controls: usize) -> Result<(), String> {
    let functions::Image {
        source,
        names,
        functions,
    } = functions::image()?;
    let here = std::env::current_exe().map_err(|error| format!("cannot find myself: {error}"))?;
    let file = here.with_file_name("no-panic-functions.rs");
    std::fs::write(&file, source).map_err(|error| format!("{}: {error}", file.display()))?;
    println!(
        "{functions} public functions; {} instances of them",
        names.len()
    );
    let cases = TARGETS
        .iter()
        .flat_map(|target| levels.iter().map(move |level| (target, level)));
    for (number, (target, level)) in cases.enumerate() {
        let image = build("no_panic", &file, target, level)?
            .map_err(|complaint| format!("{target}, opt-level {level}: {complaint}"))?;
        let text = constants(&image)?;
        if let Some(name) = names.iter().find(|name| !text.contains(&**name)) {
            return Err(format!(
                "{target}, opt-level {level}: the image lacks {name}"
            ));
        }
        let control = if number < controls {
            control(&file, target, level)?
        } else {
            "not built"
        };
        println!("{target}, opt-level {level}: no panic; control: {control}");
    }
    Ok(())
}

/// The control must fail, and because of its panic.
fn control(functions: &Path, target: &str, level: &str) -> Result<&'static str, String> {
    match build("control", functions, target, level)? {
        Err(complaint) if complaint.contains(PANIC) => Ok("refused by the linker"),
        Err(complaint) => Err(format!(
            "{target}, opt-level {level}: the control fails for another reason: {complaint}"
        )),
        Ok(_) => Err(format!(
            "{target}, opt-level {level}: the control links, so that the proof proves nothing"
        )),
    }
}

/// Path of the image, or the messages of compiler and linker.
fn build(
    bin: &str,
    functions: &Path,
    target: &str,
    level: &str,
) -> Result<Result<PathBuf, String>, String> {
    let cargo = std::env::var("CARGO").unwrap_or_else(|_| "cargo".into());
    let output = Command::new(cargo)
        .args(["build", "--release", "--package", "tribos-no-panic"])
        .args([
            "--bin",
            bin,
            "--target",
            target,
            "--message-format",
            "json-render-diagnostics",
        ])
        .args(["--config", &format!("profile.release.opt-level={level}")])
        .env("TRIBOS_NO_PANIC", functions)
        .current_dir(env!("CARGO_MANIFEST_DIR"))
        .output()
        .map_err(|error| format!("cannot run cargo: {error}"))?;
    let said = String::from_utf8_lossy(&output.stdout);
    if !output.status.success() {
        let complaint = String::from_utf8_lossy(&output.stderr);
        return Ok(Err(complaint.into()));
    }
    // The output line of the image contains the file name; the rest is ignored.
    let path = said
        .split("\"executable\":\"")
        .skip(1)
        .find_map(|rest| rest.split('"').next())
        .ok_or_else(|| format!("cargo names no image of {bin}"))?;
    Ok(Ok(PathBuf::from(path)))
}

/// The constants of an image, as text.
fn constants(image: &PathBuf) -> Result<String, String> {
    use object::read::elf::ElfFile32;
    use object::{Object, ObjectSection, SectionKind};

    let told = |error: &dyn std::fmt::Display| format!("{}: {error}", image.display());
    let bytes = std::fs::read(image).map_err(|error| told(&error))?;
    let file = ElfFile32::<object::Endianness>::parse(&*bytes).map_err(|error| told(&error))?;
    let is_constant = |kind| {
        matches!(
            kind,
            SectionKind::ReadOnlyData | SectionKind::ReadOnlyString
        )
    };
    let mut text = String::new();
    for section in file
        .sections()
        .filter(|section| is_constant(section.kind()))
    {
        let data = section.data().map_err(|error| told(&error))?;
        text += &String::from_utf8_lossy(data);
    }
    Ok(text)
}
