//! The cost table.

use super::board::{CORTEX_M0, CORTEX_M4F, Cost};
use super::budgets::{BUDGETS, Budget};
use super::image::Flash;
use super::programs::Program;
use crate::written::Sheet;

/// Results of one program.
#[derive(Clone, Debug)]
pub struct Row {
    /// Which item, in which precision.
    pub program: Program,
    /// Flash beyond that of nothing, at each optimisation level.
    pub flash: Vec<Flash>,
    /// Modules in the image.
    pub modules: String,
    /// On the Cortex-M4F.
    pub fast: Option<Cost>,
    /// With the instructions of the Cortex-M0.
    pub small: Option<Cost>,
    /// Whether the board of the Cortex-M0 holds the program that measures.
    pub fits_small: bool,
}

impl Row {
    /// Nothing known yet.
    pub fn of(program: &Program) -> Self {
        Self {
            program: *program,
            flash: Vec::new(),
            modules: String::new(),
            fast: None,
            small: None,
            fits_small: true,
        }
    }

    fn name(&self) -> Vec<String> {
        let Program {
            item, precision, ..
        } = self.program;
        [item.group, item.name, precision].map(String::from).into()
    }

    /// Mean, worst and stack on both boards; "-" where not measured.
    fn costs(&self) -> Vec<String> {
        let told = |cost: &Option<Cost>| match cost {
            None => ["-", "-", "-"].map(String::from),
            Some(cost) => {
                // Painting tells no less.
                let stack = if cost.stack <= 64 {
                    "≤ 64".into()
                } else {
                    cost.stack.to_string()
                };
                [cost.mean.to_string(), cost.worst.to_string(), stack]
            }
        };
        let mut cells = Vec::from(told(&self.fast));
        cells.extend(told(&self.small));
        if let (false, Some(last)) = (self.fits_small, cells.last_mut()) {
            *last += " (large)";
        }
        cells
    }
}

/// Every number.
pub fn all(rows: &[Row], levels: &[&str]) -> Sheet {
    let mut header = vec!["group", "named", "type"];
    let columns = [
        ["code 3", "data 3", "flash 3"],
        ["code s", "data s", "flash s"],
    ];
    header.extend(columns[..levels.len()].iter().flatten());
    header.extend(["M4F mean", "M4F worst", "M4F stack"]);
    header.extend(["M0 mean", "M0 worst", "M0 stack"]);
    header.extend(["M4F worst input", "modules in the image"]);
    let row = |row: &Row| {
        let mut cells = row.name();
        for flash in &row.flash {
            cells.extend([flash.code, flash.data, flash.total()].map(|n| n.to_string()));
        }
        cells.extend(row.costs());
        let worst_at = row.fast.map(|cost| cost.worst_at.to_string());
        cells.push(worst_at.unwrap_or("-".into()));
        cells.push(row.modules.clone());
        cells
    };
    Sheet {
        about: "Bytes of flash; instructions and bytes of stack of a call".into(),
        header,
        rows: rows.iter().map(row).collect(),
    }
}

/// Budgets, then flash, instructions and stack of everything.
pub fn markdown(rows: &[Row], levels: &[&str]) -> String {
    let mut header = vec!["group", "named", "type"];
    header.extend(&["flash 3", "flash s"][..levels.len()]);
    header.extend(["M4F mean", "M4F worst", "M4F stack"]);
    header.extend(["M0 mean", "M0 worst", "M0 stack"]);
    let row = |row: &Row| {
        let mut cells = row.name();
        cells.extend(row.flash.iter().map(|flash| flash.total().to_string()));
        cells.extend(row.costs());
        cells
    };
    let all = Sheet {
        about: explained(),
        header,
        rows: rows.iter().map(row).collect(),
    };
    format!(
        "## Budgets\n\n{}\n## All items\n\n{}",
        budgets(rows).markdown(),
        all.markdown()
    )
}

fn explained() -> String {
    format!(
        "*Flash*: bytes that naming the item adds to a {} program that names nothing, at opt-level 3 \
         and \"s\", with fat LTO and one codegen unit, construction included; f64 includes the \
         software arithmetic. No image holds a module of the kernel that its item does not name, \
         inlined or not, or the program fails. *Mean* and *worst*: instructions of one call at \
         opt-level 3 on an object that was prepared before, over 256 seeded inputs of all regions; \
         the call through a pointer, one read and the return are not counted. QEMU counts \
         instructions, not cycles. *Stack*: bytes below the caller, by painting. {} is {}, {} is {}; \
         \"(large)\" marks what ran with the same instructions on {}, for want of memory there.",
        CORTEX_M4F.target,
        CORTEX_M4F.name,
        CORTEX_M4F.machine,
        CORTEX_M0.name,
        CORTEX_M0.machine,
        CORTEX_M4F.machine
    )
}

/// Share of every budget that was used; "not measured" if QEMU is missing.
pub fn budgets(rows: &[Row]) -> Sheet {
    let row = |budget: &Budget| {
        let row = rows.iter().find(|row| budget.is_of(&row.program))?;
        let flash = row.flash.first()?.total();
        let limit = |limit: Option<u64>| limit.map_or("-".into(), |limit| limit.to_string());
        let [mean, worst, verdict] =
            row.fast
                .map_or(["-", "-", "not measured"].map(String::from), |cost| {
                    let verdict = budget.verdict(cost.worst, flash);
                    [cost.mean.to_string(), cost.worst.to_string(), verdict]
                });
        Some(vec![
            budget.item.join(": ").replace(',', ""),
            budget.instructions.to_string(),
            mean,
            worst,
            limit(budget.flash),
            flash.to_string(),
            verdict.replace(", ", " and "),
        ])
    };
    Sheet {
        about: format!(
            "In f32 on a {}: the dearest call of the inputs against its limit.",
            CORTEX_M4F.name
        ),
        header: vec![
            "call",
            "instructions at most",
            "mean",
            "worst",
            "flash at most",
            "flash",
            "budget",
        ],
        rows: BUDGETS.iter().filter_map(row).collect(),
    }
}

/// Of the budgets that were measured, which are kept.
pub fn kept(rows: &[Row]) -> Vec<bool> {
    let of = |budget: &Budget| {
        let row = rows.iter().find(|row| budget.is_of(&row.program))?;
        let flash = row.flash.first()?.total();
        Some(budget.is_kept(row.fast?.worst, flash))
    };
    BUDGETS.iter().filter_map(of).collect()
}
