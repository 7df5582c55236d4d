//! Combinations that cannot be run: what stands in their place in the tables.

use serde_json::Value;

/// Word of the summary for the end of a run that was refused.
const REFUSED: &str = "refused";
/// Member of the summary, and column, with the reason.
pub const REASON: &str = "refusal";

/// Notes in a summary that its run was refused.
pub fn note(summary: &mut Value, reason: &str) {
    summary["ending"] = REFUSED.into();
    summary[REASON] = reason.into();
    summary["version"] = env!("CARGO_PKG_VERSION").into();
}

/// The reason if the run was refused.
pub fn reason(summary: &Value) -> Option<&str> {
    summary[REASON].as_str()
}
