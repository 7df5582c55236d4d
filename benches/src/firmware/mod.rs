//! Cost of an item of the kernel on a microcontroller: flash, stack and instructions; and proof
//! that unused items cost nothing.
//!
//! Each item has its own bare-metal program that uses nothing else. Its size beyond that of a
//! program that uses no item is the item's cost. Symbols and debug records of the linked image
//! show which modules of the kernel it contains: every function leaves its name there, inlined or
//! not. A second program calls the same code fragment on an emulated board for many inputs and
//! counts.

pub mod board;
pub mod budgets;
pub mod image;
pub mod items;
pub mod prices;
pub mod programs;
pub mod report;

use image::{Flash, Image};
use items::{BASELINE, PLUMBING};
use programs::Program;

/// The group of tiers among the items.
pub const TIER: &str = "tier";

/// Modules of the kernel without a price of their own, and why.
pub const UNPRICED: [(&str, &str); 5] = [
    ("coupling::dry", "hands calls on to the tier inside"),
    (
        "coupling::lean_profile",
        "hands calls on to the tier inside",
    ),
    ("error", "moves a refusal into another type"),
    ("patch::node_storage", "borrows the caller's nodes"),
    (
        "planar::point_contacts",
        "not priced yet: as many rounds as the pose needs",
    ),
];

/// All programs, the baseline of each precision first.
pub fn all_programs() -> Vec<Program> {
    let pairs = items::all().flat_map(|item| item.precisions.iter().map(move |&p| (item, p)));
    let program = |(number, (item, precision))| Program {
        item,
        precision,
        number,
    };
    pairs.enumerate().map(program).collect()
}

/// Fails if `image` holds a module that its program does not name, or shows none that it does:
/// then the records that this judgement rests on are gone.
pub fn assert_named(program: &Program, image: &Image) -> Result<(), String> {
    let is_allowed = |module: &&String| {
        let module = module.as_str();
        program.item.modules().any(|named| named == module)
            || (PLUMBING.contains(&module) && program.item.group != BASELINE.group)
    };
    let Program {
        item, precision, ..
    } = program;
    if item.group != BASELINE.group && !item.modules().any(|named| image.modules.contains(named)) {
        return Err(format!(
            "{} {} in {precision} shows no module",
            item.group, item.name
        ));
    }
    let unnamed: Vec<&String> = image.modules.iter().filter(|m| !is_allowed(m)).collect();
    if unnamed.is_empty() {
        Ok(())
    } else {
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

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeSet;

    fn verdict(program: &Program, modules: &[&str]) -> Result<(), String> {
        let image = Image {
            flash: Flash::default(),
            modules: modules.iter().map(ToString::to_string).collect(),
        };
        assert_named(program, &image)
    }

    #[test]
    fn an_unnamed_module_is_found() {
        let programs = all_programs();
        let of = |name| programs.iter().find(|p| p.item.name == name).unwrap();
        assert!(verdict(of("nothing"), &[]).is_ok());
        assert!(verdict(of("nothing"), &["real"]).is_err());
        let lugre = of("LuGre");
        assert!(verdict(lugre, &["law::lugre", "real"]).is_ok());
        assert!(verdict(lugre, &["law::lugre", "law::stribeck"]).is_err());
        assert!(verdict(lugre, &["real"]).is_err());
    }

    #[test]
    fn every_module_with_public_functions_has_a_price() {
        let kernel = tribos_api::Library::read("tribos-core", &[]).unwrap();
        let module = |symbol: String| {
            let holds = |module: &&String| symbol.starts_with(&format!("{module}::"));
            kernel.modules().iter().filter(holds).max().cloned()
        };
        let functions = kernel.functions().unwrap().into_iter();
        let symbols = functions
            .filter(|function| !function.derived)
            .filter_map(|f| f.symbol);
        let mut unpriced: BTreeSet<String> = symbols.filter_map(module).collect();
        for program in all_programs() {
            for module in program.item.modules() {
                unpriced.remove(module);
            }
        }
        unpriced.retain(|module| !PLUMBING.contains(&module.as_str()));
        for (exception, _) in UNPRICED {
            assert!(unpriced.remove(exception), "{exception} needs no exception");
        }
        assert!(
            unpriced.is_empty(),
            "no item of firmware/items names these: {unpriced:#?}"
        );
    }

    #[test]
    fn items_name_modules_of_the_kernel_and_have_names_of_their_own() {
        let known = image::modules_of_kernel().unwrap();
        let mut names = BTreeSet::new();
        for Program {
            item, precision, ..
        } in all_programs()
        {
            for module in item.modules().chain(PLUMBING) {
                assert!(known.iter().any(|k| k == module), "{module}");
            }
            assert!(
                names.insert((item.group, item.name, precision)),
                "{}",
                item.name
            );
        }
    }
}
