//! What each law, patch, tier and body costs a microcontroller when named, and that it costs none
//! else.
//!
//! `cargo run --release -p tribos-benches --bin firmware -- [--out DIR] [--quick]` writes
//! `firmware.csv` and `firmware.md` to DIR (default: docs/front). Flash is that of small programs
//! for `thumbv7em-none-eabihf`; instructions and stack are those of calls on a Cortex-M4F and a
//! Cortex-M0 that QEMU (`qemu-system-arm`) emulates. `--quick` leaves out opt-level "s", and
//! measures only what has a budget, on the Cortex-M4F. It fails if the image of a program holds a
//! module of the kernel that the program does not name.

use std::collections::BTreeSet;
use std::process::ExitCode;
use tribos_benches::args::Options;
use tribos_benches::firmware::board::{Board, CORTEX_M0, CORTEX_M0_LARGE, CORTEX_M4F, Cost};
use tribos_benches::firmware::budgets::BUDGETS;
use tribos_benches::firmware::image::{Flash, Image, modules_of_kernel};
use tribos_benches::firmware::items::{BASELINE, PLUMBING};
use tribos_benches::firmware::programs::{LEVELS, Program, Purpose, Workshop};
use tribos_benches::firmware::report::{self, Row};
use tribos_benches::firmware::{all_programs, assert_named, price};
use tribos_benches::written;

fn main() -> ExitCode {
    match Options::read(std::env::args().skip(1)).and_then(|options| run(&options)) {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("firmware: {message}");
            ExitCode::FAILURE
        }
    }
}

fn run(options: &Options) -> Result<(), String> {
    let programs = all_programs();
    let mut rows: Vec<Row> = programs.iter().map(Row::of).collect();
    let levels = if options.quick { 1 } else { LEVELS.len() };
    weigh(&mut rows, levels)?;
    measure(&mut rows, options.quick)?;
    let levels: Vec<&str> = LEVELS[..levels].iter().map(|(level, _)| *level).collect();
    let about = report::about()?;
    let markdown = report::markdown(&about, &rows, &levels);
    written::write(
        &options.out,
        "firmware.csv",
        &report::csv(&about, &rows, &levels),
    )?;
    written::write(&options.out, "firmware.md", &markdown)?;
    print!("{markdown}");
    Ok(())
}

/// Beside this program, so that two copies of the project do not meet.
fn workshop(purpose: Purpose, programs: &[Program]) -> Result<Workshop, String> {
    let here = std::env::current_exe().map_err(|error| format!("cannot find myself: {error}"))?;
    Workshop::write(&here.with_file_name("firmware-programs"), purpose, programs)
}

/// Flash and modules of every row.
fn weigh(rows: &mut [Row], levels: usize) -> Result<(), String> {
    let known = modules_of_kernel()?;
    let programs: Vec<Program> = rows.iter().map(|row| row.program).collect();
    let workshop = workshop(Purpose::Flash, &programs)?;
    let mut unnamed = Vec::new();
    for (_, profile) in &LEVELS[..levels] {
        workshop.build(&CORTEX_M4F, profile, &programs)?;
        let read = |program: &Program| {
            Image::read(&workshop.image(&CORTEX_M4F, profile, program)?, &known)
        };
        let images = programs.iter().map(read).collect::<Result<Vec<_>, _>>()?;
        for ((row, program), image) in rows.iter_mut().zip(&programs).zip(&images) {
            unnamed.extend(assert_named(program, image).err());
            row.flash
                .push(beside_nothing(program, image, &programs, &images));
            row.modules = features(&image.modules);
        }
    }
    if unnamed.is_empty() {
        Ok(())
    } else {
        Err(unnamed.join("\n"))
    }
}

/// What the image has more than that of the program that names nothing.
fn beside_nothing(
    program: &Program,
    image: &Image,
    programs: &[Program],
    images: &[Image],
) -> Flash {
    let baseline = programs.iter().zip(images).find(|(other, _)| {
        other.item.group == BASELINE.group && other.precision == program.precision
    });
    baseline.map_or(image.flash, |(_, baseline)| price(image, baseline))
}

/// The modules of an image, without plumbing.
fn features(modules: &BTreeSet<String>) -> String {
    let modules = modules.iter().map(String::as_str);
    let features: Vec<&str> = modules.filter(|m| !PLUMBING.contains(m)).collect();
    features.join(" ")
}

/// Instructions and stack: of all rows on both boards, or of those with a budget on one.
fn measure(rows: &mut [Row], quick: bool) -> Result<(), String> {
    let has_budget = |row: &&mut Row| BUDGETS.iter().any(|budget| budget.is_of(&row.program));
    let mut rows: Vec<&mut Row> = rows
        .iter_mut()
        .filter(|row| !quick || has_budget(row))
        .collect();
    let programs: Vec<Program> = rows.iter().map(|row| row.program).collect();
    let workshop = workshop(Purpose::Measure, &programs)?;
    let fast = on_board(&workshop, &CORTEX_M4F, &programs)?;
    for (row, cost) in rows.iter_mut().zip(fast) {
        row.fast = Some(cost?);
    }
    if quick {
        return Ok(());
    }
    let small = on_board(&workshop, &CORTEX_M0, &programs)?;
    let mut left = Vec::new();
    for (row, cost) in rows.iter_mut().zip(small) {
        row.small = cost.ok();
        if row.small.is_none() {
            left.push(row);
        }
    }
    let programs: Vec<Program> = left.iter().map(|row| row.program).collect();
    let large = on_board(&workshop, &CORTEX_M0_LARGE, &programs)?;
    for (row, cost) in left.iter_mut().zip(large) {
        row.small = Some(cost?);
        row.fits_small = false;
    }
    Ok(())
}

/// The cost of each program, or why there is none: too large for the board.
fn on_board(
    workshop: &Workshop,
    board: &Board,
    programs: &[Program],
) -> Result<Vec<Result<Cost, String>>, String> {
    if programs.is_empty() {
        return Ok(Vec::new());
    }
    workshop.build(board, "release", programs)?;
    let run = |program| board.run(&workshop.path(board, "release", program));
    Ok(programs.iter().map(run).collect())
}
