//! Instruction counts of the tiers on microcontrollers.

use crate::firmware::prices::{self, Boards};
use crate::firmware::report::Row as Priced;
use crate::firmware::{TIER, all_programs};
use crate::methods::Method;

/// Methods, without their precision, that are items of the firmware's front.
const ITEMS: [(&str, &str); 4] = [
    ("form", "form: Coulomb"),
    ("table alpha 0.5", "table: alpha 0.5"),
    ("compact power", "compact: power alpha 0"),
    ("quadrature", "quadrature: Coulomb"),
];

/// Counts the instructions of the tiers; returns the reason if that is impossible here.
pub fn count(quick: bool) -> Result<(Vec<Priced>, Option<String>), String> {
    let programs = all_programs();
    let tiers = programs.iter().filter(|program| program.item.group == TIER);
    let mut rows: Vec<Priced> = tiers.map(Priced::of).collect();
    let boards = if quick { Boards::Fast } else { Boards::Both };
    let obstacle = prices::obstacle(boards);
    if obstacle.is_none() {
        prices::measure(rows.iter_mut().collect(), boards)?;
    }
    Ok((rows, obstacle))
}

/// Mean instructions of a call on both targets.
pub fn of(method: &Method, counted: &[Priced]) -> [Option<u64>; 2] {
    let bare = method.name.replace(" f32", "");
    let item = ITEMS.iter().find(|(name, _)| *name == bare);
    let of_method = |row: &&Priced| {
        let program = &row.program;
        let is_item = item.is_some_and(|(_, item)| program.item.name == *item);
        program.item.group == TIER && is_item && program.precision == method.precision()
    };
    let row = counted.iter().find(of_method);
    [row.and_then(|row| row.fast), row.and_then(|row| row.small)]
        .map(|cost| cost.map(|cost| cost.mean))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::firmware::board::Cost;
    use crate::fronts::kernel::all_methods;

    #[test]
    fn every_counted_item_is_a_method_in_both_precisions() {
        let methods = all_methods().unwrap();
        let cost = Cost {
            mean: 7,
            worst: 9,
            stack: 0,
            worst_at: 0,
        };
        for (name, item) in ITEMS {
            let programs = all_programs();
            let of_item = programs.iter().filter(|program| program.item.name == item);
            let mut rows: Vec<Priced> = of_item.map(Priced::of).collect();
            assert_eq!(rows.len(), 2, "{item}");
            rows.iter_mut().for_each(|row| row.fast = Some(cost));
            let counted = methods.iter().filter(|m| of(m, &rows)[0] == Some(7));
            let counted: Vec<&Method> = counted.collect();
            assert_eq!(counted.len(), 2, "{name}: {counted:?}");
            assert_ne!(counted[0].precision(), counted[1].precision());
        }
    }
}
