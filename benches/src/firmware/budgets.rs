//! Budgets of f32 calls on a Cortex-M4F.

use super::programs::Program;

/// Limits of one item.
#[derive(Clone, Copy, Debug)]
pub struct Budget {
    /// Group and name of the item.
    pub item: [&'static str; 2],
    /// Largest number of instructions of a call.
    pub instructions: u64,
    /// Bytes of flash at opt-level 3.
    pub flash: Option<u64>,
}

const fn budget(item: [&'static str; 2], instructions: u64, flash: Option<u64>) -> Budget {
    Budget {
        item,
        instructions,
        flash,
    }
}

/// All budgets.
pub const BUDGETS: [Budget; 6] = [
    budget(["body", "disk with dimensions"], 450, Some(4096)),
    budget(["impulse", "sliding, rolling, torsion"], 1200, None),
    budget(
        ["impulse", "sliding, rolling, torsion: two balls"],
        1200,
        None,
    ),
    budget(["patch", "square, exact: Coulomb"], 1100, None),
    budget(["motion", "slider: Verlet step"], 2500, None),
    budget(["motion", "slider: a given time"], 2500, None),
];

impl Budget {
    /// Whether the budget is that of a program.
    pub fn is_of(&self, program: &Program) -> bool {
        [program.item.group, program.item.name] == self.item && program.precision == "f32"
    }

    /// Whether neither limit is exceeded.
    pub fn is_kept(&self, instructions: u64, flash: u64) -> bool {
        instructions <= self.instructions && self.flash.is_none_or(|limit| flash <= limit)
    }

    /// "kept", or by how much it is missed.
    pub fn verdict(&self, instructions: u64, flash: u64) -> String {
        let over = |spent: u64, limit: u64, unit| {
            (spent > limit).then(|| format!("missed by {} {unit}", spent - limit))
        };
        let complaints = [
            over(instructions, self.instructions, "instructions"),
            self.flash.and_then(|limit| over(flash, limit, "bytes")),
        ];
        let complaints: Vec<String> = complaints.into_iter().flatten().collect();
        if self.is_kept(instructions, flash) {
            "kept".into()
        } else {
            complaints.join(", ")
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::firmware::all_programs;

    #[test]
    fn every_budget_is_of_one_program() {
        let programs = all_programs();
        for budget in BUDGETS {
            let of = programs.iter().filter(|program| budget.is_of(program));
            assert_eq!(of.count(), 1, "{:?}", budget.item);
        }
    }

    #[test]
    fn a_budget_is_kept_to_the_last_instruction() {
        let budget = budget(["body", "disk"], 450, Some(4096));
        assert_eq!(budget.verdict(450, 4096), "kept");
        assert_eq!(
            budget.verdict(451, 4100),
            "missed by 1 instructions, missed by 4 bytes"
        );
    }
}
