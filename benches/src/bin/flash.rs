//! What each law, patch, tier and body costs in flash when named, and that it costs none else.
//!
//! `cargo run --release -p tribos-benches --bin flash -- [--out DIR] [--quick]` writes `flash.csv`
//! and `flash.md` to DIR (default: docs/front); `--quick` leaves out opt-level "s". It builds some
//! fifty small programs for `thumbv7em-none-eabihf`, which must be installed, and fails if the image
//! of one holds a module of the kernel that it does not name.

use std::process::ExitCode;
use tribos_benches::args::Options;
use tribos_benches::flash::image::{Flash, Image, modules_of_kernel};
use tribos_benches::flash::items::{BASELINE, PLUMBING};
use tribos_benches::flash::programs::{LEVELS, Program, TARGET, Workshop};
use tribos_benches::flash::{all_programs, assert_named, price};
use tribos_benches::written::{self, Sheet};

fn main() -> ExitCode {
    match Options::read(std::env::args().skip(1)).and_then(|options| run(&options)) {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("flash: {message}");
            ExitCode::FAILURE
        }
    }
}

fn run(options: &Options) -> Result<(), String> {
    let programs = all_programs();
    let known = modules_of_kernel()?;
    let workshop = Workshop::write(&std::env::temp_dir().join("tribos-flash"), &programs)?;
    let levels = &LEVELS[..if options.quick { 1 } else { LEVELS.len() }];
    let mut prices: Vec<Vec<Flash>> = Vec::new();
    let mut modules = Vec::new();
    let mut unnamed = Vec::new();
    for (_, profile) in levels {
        workshop.build(profile)?;
        let read = |program: &Program| Image::read(&workshop.image(program, profile)?, &known);
        let images = programs.iter().map(read).collect::<Result<Vec<_>, _>>()?;
        for (program, image) in programs.iter().zip(&images) {
            unnamed.extend(assert_named(program, image).err());
        }
        let beside = |(program, image): (&Program, &Image)| {
            let baseline = programs.iter().zip(&images).find(|(other, _)| {
                other.item.group == BASELINE.group && other.precision == program.precision
            });
            baseline.map_or(image.flash, |(_, baseline)| price(image, baseline))
        };
        prices.push(programs.iter().zip(&images).map(beside).collect());
        modules = images.into_iter().map(|image| image.modules).collect();
    }
    if !unnamed.is_empty() {
        return Err(unnamed.join("\n"));
    }
    let modules: Vec<String> = modules.iter().map(features).collect();
    let sheet = sheet(&programs, &prices, &modules, levels);
    written::write(&options.out, "flash.csv", &sheet.csv())?;
    written::write(&options.out, "flash.md", &sheet.markdown())?;
    print!("{}", sheet.markdown());
    Ok(())
}

/// The modules of an image, without plumbing.
fn features(modules: &std::collections::BTreeSet<String>) -> String {
    let modules = modules.iter().map(String::as_str);
    let features: Vec<&str> = modules.filter(|m| !PLUMBING.contains(m)).collect();
    features.join(" ")
}

fn sheet(
    programs: &[Program],
    prices: &[Vec<Flash>],
    modules: &[String],
    levels: &[(&str, &str)],
) -> Sheet {
    let row = |(index, program): (usize, &Program)| {
        let mut cells = vec![
            program.item.group.into(),
            program.item.name.into(),
            program.precision.into(),
        ];
        for price in prices {
            let price = price[index];
            cells.extend([price.code, price.data, price.total()].map(|n| n.to_string()));
        }
        cells.push(modules[index].clone());
        cells
    };
    let mut header = vec!["group", "named", "type"];
    let columns = [
        ["code 3", "data 3", "flash 3"],
        ["code s", "data s", "flash s"],
    ];
    header.extend(columns[..levels.len()].iter().flatten());
    header.push("modules in the image");
    Sheet {
        about: format!(
            "Bytes of flash that naming an item adds to a {TARGET} program that names nothing, at \
             opt-level 3 and \"s\", with fat LTO and one codegen unit; f64 includes the \
             software arithmetic. Read from the sections of the linked images; no image holds a module of \
             the kernel beside those listed (and error types, scalars, twists), inlined or not, or \
             the program fails. By `cargo run --release -p tribos-benches --bin flash`"
        ),
        header,
        rows: programs.iter().enumerate().map(row).collect(),
    }
}
