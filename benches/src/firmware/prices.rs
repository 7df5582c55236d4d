//! Builds, weighs and runs the programs.
//!
//! Flash is that of small programs for `thumbv7em-none-eabihf`; instructions and stack are those of
//! calls on a Cortex-M4F and a Cortex-M0 that QEMU (`qemu-system-arm`) emulates.

use super::board::{self, Board, CORTEX_M0, CORTEX_M0_LARGE, CORTEX_M4F, Cost};
use super::image::{Flash, Image, modules_of_kernel};
use super::items::{BASELINE, PLUMBING};
use super::programs::{LEVELS, Program, Purpose, Workshop};
use super::report::Row;
use super::{assert_named, price};
use std::collections::BTreeSet;

/// Boards to measure on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Boards {
    /// The Cortex-M4F alone.
    Fast,
    /// And the Cortex-M0.
    Both,
}

/// Beside this program, so that two copies of the project do not meet.
fn workshop(purpose: Purpose, programs: &[Program]) -> Result<Workshop, String> {
    let here = std::env::current_exe().map_err(|error| format!("cannot find myself: {error}"))?;
    Workshop::write(&here.with_file_name("firmware-programs"), purpose, programs)
}

/// Flash and modules of every row at the first `levels` of [`LEVELS`].
///
/// Fails if the image of a program holds a module of the kernel that the program does not name.
pub fn weigh(rows: &mut [Row], levels: usize) -> Result<(), String> {
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

/// Size of the image beyond that of the program that uses no item.
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

/// Why calls cannot be measured here, if they cannot.
pub fn obstacle(boards: Boards) -> Option<String> {
    let boards = match boards {
        Boards::Fast => &[CORTEX_M4F][..],
        Boards::Both => &[CORTEX_M4F, CORTEX_M0],
    };
    let missing = boards.iter().find_map(|board| board.installed().err());
    missing.or(board::emulator().err())
}

/// Instructions and stack of the rows.
pub fn measure(mut rows: Vec<&mut Row>, boards: Boards) -> Result<(), String> {
    let programs: Vec<Program> = rows.iter().map(|row| row.program).collect();
    let workshop = workshop(Purpose::Measure, &programs)?;
    let fast = on_board(&workshop, &CORTEX_M4F, &programs)?;
    for (row, cost) in rows.iter_mut().zip(fast) {
        row.fast = Some(cost?);
    }
    if boards == Boards::Fast {
        return Ok(());
    }
    let small = on_board(&workshop, &CORTEX_M0, &programs)?;
    let mut left = Vec::new();
    for (row, cost) in rows.into_iter().zip(small) {
        row.small = cost.ok();
        if row.small.is_none() {
            left.push(row);
        }
    }
    let programs: Vec<Program> = left.iter().map(|row| row.program).collect();
    let large = on_board(&workshop, &CORTEX_M0_LARGE, &programs)?;
    for (row, cost) in left.into_iter().zip(large) {
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
