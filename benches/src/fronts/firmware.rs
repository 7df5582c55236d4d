//! Cost of each law, patch, tier and body on a microcontroller that uses it, and proof that it
//! costs no other.

use super::{Finding, Front, Setting};
use crate::firmware::board;
use crate::firmware::budgets::BUDGETS;
use crate::firmware::items::BASELINE;
use crate::firmware::prices::{self, Boards};
use crate::firmware::programs::{LEVELS, Program};
use crate::firmware::report::{self, Row};
use crate::firmware::{TIER, all_programs};
use crate::picture::{self, PicturePoint};
use std::path::Path;

const PICTURE: &str = "firmware.svg";
/// Flash below this is drawn at it.
const LEAST_FLASH: u64 = 1;

/// Makes the front; its rows are for the kernel's.
///
/// A quick look weighs only tiers and what has a budget, at opt-level 3, and measures only the latter, on the Cortex-M4F.
/// Without QEMU nothing is measured, and the page says so.
pub fn run(setting: &Setting<'_>) -> Result<(Finding, Vec<Row>), String> {
    let mut programs = all_programs();
    if setting.quick {
        programs.retain(is_quick);
    }
    let mut rows: Vec<Row> = programs.iter().map(Row::of).collect();
    let (levels, boards) = if setting.quick {
        (1, Boards::Fast)
    } else {
        (LEVELS.len(), Boards::Both)
    };
    prices::weigh(&mut rows, levels)?;
    let is_measured = |row: &&mut Row| !setting.quick || has_budget(&row.program);
    let obstacle = measure(rows.iter_mut().filter(is_measured).collect(), boards)?;
    let levels: Vec<&str> = LEVELS[..levels].iter().map(|(level, _)| *level).collect();
    setting.table("firmware", &report::all(&rows, &levels))?;
    setting.table("firmware_budgets", &report::budgets(&rows))?;
    let emulated = match (board::emulator(), obstacle) {
        (Ok(emulator), None) => format!("Emulated by {emulator}"),
        (_, obstacle) => format!("Nothing is measured: {}", obstacle.unwrap_or_default()),
    };
    let body = format!(
        "{emulated}.\n\n![Flash and instructions]({PICTURE})\n\n{}",
        report::markdown(&rows, &levels)
    );
    setting.page(Front::Firmware, &body)?;
    draw(setting.out, &rows)?;
    let finding = Finding {
        line: line(&rows),
        picture: PICTURE,
    };
    Ok((finding, rows))
}

/// What the others are compared with, tiers, and what has a budget.
fn is_quick(program: &Program) -> bool {
    has_budget(program) || [TIER, BASELINE.group].contains(&program.item.group)
}

fn has_budget(program: &Program) -> bool {
    BUDGETS.iter().any(|budget| budget.is_of(program))
}

/// Measures the rows; returns the reason if that is impossible here.
fn measure(rows: Vec<&mut Row>, boards: Boards) -> Result<Option<String>, String> {
    let obstacle = prices::obstacle(boards);
    if obstacle.is_none() {
        prices::measure(rows, boards)?;
    }
    Ok(obstacle)
}

/// Flash against instructions in f32 on the Cortex-M4F; flash alone where nothing was measured.
fn draw(out: &Path, rows: &[Row]) -> Result<(), String> {
    let place = |row: &Row| {
        let flash = row.flash.first()?.total().max(LEAST_FLASH);
        let instructions = row.fast.map_or(1, |cost| cost.mean);
        Some(PicturePoint {
            label: row.program.item.name.into(),
            group: row.program.item.group.into(),
            at: (flash as f64, instructions as f64),
        })
    };
    let is_drawn = |row: &&Row| {
        let measured = rows.iter().any(|row| row.fast.is_some());
        let Program {
            item, precision, ..
        } = row.program;
        precision == "f32" && item.group != "baseline" && (row.fast.is_some() || !measured)
    };
    picture::scatter(
        out,
        "firmware",
        "What naming an item costs, f32 on a Cortex-M4F",
        ["flash [bytes]", "instructions of a call, mean"],
        rows.iter().filter(is_drawn).filter_map(place).collect(),
    )
}

/// Summary of the front: budgets, with the smallest disk beside them.
fn line(rows: &[Row]) -> String {
    let kept = report::kept(rows);
    let flash = |row: &Row| row.flash.first().map_or(0, |flash| flash.total());
    let first = BUDGETS.iter().find_map(|budget| {
        let row = rows.iter().find(|row| budget.is_of(&row.program))?;
        Some((budget, row))
    });
    let disk = first.map_or(String::new(), |(budget, row)| {
        let counted = row
            .fast
            .map_or("unmeasured".into(), |cost| cost.mean.to_string());
        format!(
            "; a {} takes {counted} instructions on average and {} bytes of flash",
            budget.item[1],
            flash(row)
        )
    });
    let budgets = match kept.len() {
        0 => "No call was measured for want of QEMU".into(),
        known => format!(
            "{} of {known} budgets of the Cortex-M4F are kept",
            kept.iter().filter(|&&kept| kept).count()
        ),
    };
    format!("{budgets}{disk}; no image holds a module of the kernel that its item does not name.")
}
