//! Builds the proof and its control for microcontrollers, and reports whether the kernel can panic.
//!
//! `cargo run -p tribos-no-panic --bin prove -- [--quick]` builds `no_panic` and `control` for three
//! targets at opt-levels 3, "s" and "z"; `--quick` omits "s" and "z" and all controls but one. It
//! fails if `no_panic` does not link, if a function of the list is not in the image, or if
//! `control` links, or fails for another reason than its panic.

use std::path::PathBuf;
use std::process::{Command, ExitCode};
use tribos_no_panic::coverage::{Kernel, kept_names, missing};

const TARGETS: [&str; 3] = [
    "thumbv7em-none-eabihf",
    "thumbv6m-none-eabi",
    "riscv32imac-unknown-none-elf",
];
const LEVELS: [&str; 3] = ["3", "\"s\"", "\"z\""];

/// Message of the linker for a reachable panic.
const PANIC: &str = "undefined symbol: a_panic_is_reachable";

const HELP: &str = "prove [--quick]
Proves by linking that no public function of tribos-core can panic.
  --quick  opt-level 3 alone, and one control";

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let arguments: Vec<&str> = arguments.iter().map(String::as_str).collect();
    let outcome = match arguments[..] {
        [] => prove(&LEVELS, TARGETS.len() * LEVELS.len()),
        ["--quick"] => prove(&LEVELS[..1], 1),
        ["--help" | "-h"] => {
            println!("{HELP}");
            Ok(())
        }
        _ => Err(format!("unknown arguments {arguments:?}\n{HELP}")),
    };
    match outcome {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("prove: {message}");
            ExitCode::FAILURE
        }
    }
}

/// All targets at `levels`, the first `controls` of them with their control.
fn prove(levels: &[&str], controls: usize) -> Result<(), String> {
    let required = Kernel::read()?.functions()?;
    let names = kept_names();
    let missing = missing(&required, &names);
    if !missing.is_empty() {
        return Err(format!("add these functions to kept/: {missing:#?}"));
    }
    println!(
        "{} public functions, counted once a precision; {} instances of them",
        required.len(),
        names.len()
    );
    let cases = TARGETS
        .iter()
        .flat_map(|target| levels.iter().map(move |level| (target, level)));
    for (number, (target, level)) in cases.enumerate() {
        let image = build("no_panic", target, level)?
            .map_err(|complaint| format!("{target}, opt-level {level}: {complaint}"))?;
        let text = constants(&image)?;
        if let Some(name) = names.iter().find(|name| !text.contains(**name)) {
            return Err(format!(
                "{target}, opt-level {level}: the image lacks {name}"
            ));
        }
        let control = if number < controls {
            control(target, level)?
        } else {
            "not built"
        };
        println!("{target}, opt-level {level}: no panic; control: {control}");
    }
    Ok(())
}

/// The control has to fail, for its panic.
fn control(target: &str, level: &str) -> Result<&'static str, String> {
    match build("control", target, level)? {
        Err(complaint) if complaint.contains(PANIC) => Ok("refused by the linker"),
        Err(complaint) => Err(format!(
            "{target}, opt-level {level}: the control fails for another reason: {complaint}"
        )),
        Ok(_) => Err(format!(
            "{target}, opt-level {level}: the control links, so that the proof proves nothing"
        )),
    }
}

/// Path of the image, or the errors of compiler and linker.
fn build(bin: &str, target: &str, level: &str) -> Result<Result<PathBuf, String>, String> {
    let cargo = std::env::var("CARGO").unwrap_or_else(|_| "cargo".into());
    let output = Command::new(cargo)
        .args(["build", "--release", "--package", "tribos-no-panic"])
        .args(["--bin", bin, "--target", target, "--message-format", "json"])
        .args(["--config", &format!("profile.release.opt-level={level}")])
        .current_dir(env!("CARGO_MANIFEST_DIR"))
        .output()
        .map_err(|error| format!("cannot run cargo: {error}"))?;
    let said = String::from_utf8_lossy(&output.stdout);
    if !output.status.success() {
        let complaint = String::from_utf8_lossy(&output.stderr);
        return Ok(Err(format!("{complaint}{said}")));
    }
    // The line of the image names its file; nothing else of the output is needed.
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
