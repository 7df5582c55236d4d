//! What naming an item of the kernel costs in flash, and that the unnamed costs nothing.
//!
//! Each item has a bare-metal program of its own that names it and nothing else. Its size beyond
//! that of a program that names nothing is the item's price. Symbols and debug records of the
//! linked image tell which modules of the kernel are in it: every function leaves its name there,
//! inlined or not.

pub mod image;
pub mod items;
pub mod programs;

use image::{Flash, Image};
use items::{BASELINE, BODIES, LAWS, PATCHES, PLUMBING, TIERS};
use programs::Program;

/// All programs, the baseline of each precision first.
pub fn all_programs() -> Vec<Program> {
    let items = [BASELINE].into_iter().chain(LAWS).chain(TIERS);
    let items = items.chain(PATCHES).chain(BODIES);
    let pairs = items.flat_map(|item| item.precisions.iter().map(move |&p| (item, p)));
    let program = |(number, (item, precision))| Program {
        item,
        precision,
        number,
    };
    pairs.enumerate().map(program).collect()
}

/// Fails if `image` holds a module that its program does not name.
pub fn assert_named(program: &Program, image: &Image) -> Result<(), String> {
    let is_allowed = |module: &&String| {
        let module = module.as_str();
        program.item.modules.contains(&module)
            || (PLUMBING.contains(&module) && program.item.group != BASELINE.group)
    };
    let unnamed: Vec<&String> = image.modules.iter().filter(|m| !is_allowed(m)).collect();
    if unnamed.is_empty() {
        Ok(())
    } else {
        let Program {
            item, precision, ..
        } = program;
        Err(format!(
            "{} {} in {precision} holds modules that it does not name: {unnamed:?}",
            item.group, item.name
        ))
    }
}

/// The price of a program beside the baseline.
pub fn price(image: &Image, baseline: &Image) -> Flash {
    image.flash.beyond(baseline.flash)
}
