//! A body that holds and slips.

use super::line;

/// Lines of heads and texts.
pub fn lines(parts: &[(&str, String)]) -> String {
    parts.iter().map(|(head, text)| line(head, text)).collect()
}
