//! Builds the proof and its control for microcontrollers, and reports whether the kernel can panic.
//!
//! `cargo run -p tribos-no-panic --bin prove -- [--quick]` builds `no_panic` and `control` for three
//! targets at opt-levels 3, "s" and "z"; `--quick` is the first of them alone, with a control that has no function
//! of the kernel. It fails if `no_panic` does not link, if a function of the list is not in the image, or if
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

/// Source of an image without functions of the kernel, which takes seconds to compile.
const NOTHING: &str = "pub fn everything(_: &mut crate::image::Opaque) {}\n";

/// Message of the linker for a reachable panic.
const PANIC: &str = "undefined symbol: a_panic_is_reachable";

/// Proves by linking that no public function of tribos-core can panic.
#[derive(clap::Parser)]
struct Options {
    /// The first target at opt-level 3 alone, with a small control
    #[arg(long)]
    quick: bool,
}

fn main() -> ExitCode {
    let outcome = match Options::parse().quick {
        true => prove(&TARGETS[..1], &LEVELS[..1], Some(NOTHING)),
        false => prove(&TARGETS, &LEVELS, None),
    };
    match outcome {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("prove: {message}");
            ExitCode::FAILURE
        }
    }
}

/// Builds `targets` at `levels`; the control has the functions of the proof unless it is given others.
fn prove(targets: &[&str], levels: &[&str], of_control: Option<&str>) -> Result<(), String> {
    let functions::Image {
        source,
        names,
        functions,
    } = functions::image()?;
    let file = write("no-panic-functions.rs", &source)?;
    let of_control = write("control-functions.rs", of_control.unwrap_or(&source))?;
    println!(
        "{functions} public functions; {} instances of them",
        names.len()
    );
    for level in levels {
        let images = build("no_panic", &file, targets, level)?
            .map_err(|complaint| format!("opt-level {level}: {complaint}"))?;
        for (target, image) in targets.iter().zip(&images) {
            let text = constants(image)?;
            if let Some(name) = names.iter().find(|name| !text.contains(&**name)) {
                return Err(format!(
                    "{target}, opt-level {level}: the image lacks {name}"
                ));
            }
            let control = control(&of_control, target, level)?;
            println!("{target}, opt-level {level}: no panic; control: {control}");
        }
    }
    Ok(())
}

/// Writes a file beside this program; its path.
fn write(name: &str, source: &str) -> Result<PathBuf, String> {
    let here = std::env::current_exe().map_err(|error| format!("cannot find myself: {error}"))?;
    let file = here.with_file_name(name);
    std::fs::write(&file, source).map_err(|error| format!("{}: {error}", file.display()))?;
    Ok(file)
}

/// The control must fail, and because of its panic.
fn control(functions: &Path, target: &str, level: &str) -> Result<&'static str, String> {
    match build("control", functions, &[target], level)? {
        Err(complaint) if complaint.contains(PANIC) => Ok("refused by the linker"),
        Err(complaint) => Err(format!(
            "{target}, opt-level {level}: the control fails for another reason: {complaint}"
        )),
        Ok(_) => Err(format!(
            "{target}, opt-level {level}: the control links, so that the proof proves nothing"
        )),
    }
}

/// Paths of the images, one for each target, or the messages of compiler and linker.
///
/// All targets are built by one cargo: each is one long compilation, and they run side by side.
fn build(
    bin: &str,
    functions: &Path,
    targets: &[&str],
    level: &str,
) -> Result<Result<Vec<PathBuf>, String>, String> {
    let cargo = std::env::var("CARGO").unwrap_or_else(|_| "cargo".into());
    let output = Command::new(cargo)
        .args(["build", "--profile", "dist", "--package", "tribos-no-panic"])
        .args(["--bin", bin, "--message-format", "json-render-diagnostics"])
        .args(targets.iter().flat_map(|target| ["--target", target]))
        .args(["--config", &format!("profile.dist.opt-level={level}")])
        .env("TRIBOS_NO_PANIC", functions)
        .current_dir(env!("CARGO_MANIFEST_DIR"))
        .output()
        .map_err(|error| format!("cannot run cargo: {error}"))?;
    if !output.status.success() {
        let complaint = String::from_utf8_lossy(&output.stderr);
        return Ok(Err(complaint.into()));
    }
    let said = String::from_utf8_lossy(&output.stdout);
    // The output line of an image contains its path; the rest is ignored.
    let images: Vec<&Path> = said
        .split("\"executable\":\"")
        .skip(1)
        .filter_map(|rest| rest.split('"').next())
        .map(Path::new)
        .collect();
    let image = |target: &&str| {
        let of_target = |path: &&&Path| path.iter().any(|folder| folder == *target);
        let found = images.iter().find(of_target);
        found
            .map(|path| path.to_path_buf())
            .ok_or_else(|| format!("cargo names no image of {bin} for {target}"))
    };
    targets.iter().map(image).collect::<Result<_, _>>().map(Ok)
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
