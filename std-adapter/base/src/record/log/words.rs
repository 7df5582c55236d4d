//! What was understood of a log, in words.

use super::DropReason;
use super::derive::Plan;
use crate::record::cells::Decimal;
use crate::record::sheet::Sheet;
use crate::record::significant;

/// Digits of the size of a unit.
const DIGITS: usize = 6;

/// A line for each part.
pub(super) fn understood(
    plan: &Plan,
    sheet: Option<&Sheet<'_>>,
    dropped: &[(DropReason, u64)],
) -> Vec<String> {
    let mut all = sheet.map_or(Vec::new(), table);
    for one in &plan.assigned {
        let role = &one.role;
        let sign = if one.factor < 0.0 {
            ", its sign changed"
        } else {
            ""
        };
        let size = significant(one.factor.abs(), DIGITS);
        let unit = match (&one.unit, one.si) {
            (Some(given), si) if given == si => format!(" in {si}"),
            (Some(given), "") => format!(" in {given}"),
            (Some(given), si) => format!(" in {given}, of {size} {si} each"),
            // A coefficient and a force look alike.
            (None, "-") => String::new(),
            (None, si) => format!(", taken as {si}"),
        };
        all.push(format!("{} is `{}`{unit}{sign}", role.name, one.name));
    }
    for (role, _, source) in &plan.derived {
        all.push(format!(
            "{} is the derivative of `{source}` by differences",
            role.name
        ));
    }
    all.extend(plan.remarks.iter().cloned());
    all.extend(lost(dropped));
    all
}

/// One line, and another for rows that were dropped; nothing where all is usual.
pub(super) fn brief(
    plan: &Plan,
    sheet: Option<&Sheet<'_>>,
    dropped: &[(DropReason, u64)],
) -> Vec<String> {
    let mut parts = sheet.map_or(Vec::new(), Sheet::differences);
    for one in plan.assigned.iter().filter(|one| !one.is_plain) {
        let sign = if one.factor < 0.0 { "-" } else { "" };
        let unit = one
            .unit
            .as_ref()
            .map_or(String::new(), |unit| format!(" in {unit}"));
        // A heading that is the role's own name needs no repetition.
        let name = if one.name == one.role.name {
            String::new()
        } else {
            format!(" from {sign}\"{}\"", one.name)
        };
        parts.push(format!("{}{name}{unit}", one.role.name));
    }
    for (role, _, source) in &plan.derived {
        parts.push(format!("{} by differences of \"{source}\"", role.name));
    }
    parts.extend(plan.remarks.iter().cloned());
    let line = (!parts.is_empty()).then(|| parts.join(", "));
    line.into_iter().chain(lost(dropped)).collect()
}

/// The rows that were dropped.
fn lost(dropped: &[(DropReason, u64)]) -> Option<String> {
    let whole: u64 = dropped.iter().map(|(_, count)| count).sum();
    let parts: Vec<String> = dropped
        .iter()
        .map(|(reason, count)| format!("{count} {}", reason.name()))
        .collect();
    let rows = if whole == 1 { "row" } else { "rows" };
    (whole > 0).then(|| format!("{whole} {rows} dropped: {}", parts.join(", ")))
}

/// The dialect of a table.
pub(super) fn table(sheet: &Sheet<'_>) -> Vec<String> {
    let decimal = match sheet.dialect.decimal {
        Decimal::Point => "points",
        Decimal::Comma => "commas",
    };
    let encoding = sheet
        .encoding()
        .map_or(String::new(), |name| format!(" ({name})"));
    let mut all = vec![format!("{}{encoding}", sheet.name())];
    all.push(format!(
        "{} between cells, decimal {decimal}",
        sheet.dialect.delimiter.name()
    ));
    let units = sheet
        .units_line()
        .map_or(String::new(), |line| format!(", units in line {line}"));
    all.push(match (sheet.headings.len(), sheet.left_out()) {
        (0, _) => "no header".into(),
        (_, 0) => format!("header in line {}{units}", sheet.header_line()),
        (_, count) => format!(
            "header in line {}, {count} before it left out{units}",
            sheet.header_line()
        ),
    });
    all
}
