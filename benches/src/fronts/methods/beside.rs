//! What `benches/methods_lammps.py` has measured, if its table lies beside the page.

use std::fmt::Write as _;
use std::fs;
use std::path::Path;

/// Name of the table.
const NAME: &str = "methods_lammps.csv";

/// The table as Markdown, under the line that says how it was made.
pub fn table(folder: &Path) -> Option<String> {
    markdown(&fs::read_to_string(folder.join(NAME)).ok()?)
}

fn markdown(csv: &str) -> Option<String> {
    let mut lines = csv.lines();
    let about = lines.next()?.strip_prefix("# ")?;
    let header = lines.next()?;
    let rule = vec!["---"; header.split(',').count()].join("|");
    let mut text = format!("{about}\n\n| {} |\n|{rule}|\n", header.replace(',', " | "));
    for line in lines {
        let _ = writeln!(text, "| {} |", line.replace(',', " | "));
    }
    Some(text)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_table_keeps_its_cells() {
        let text = markdown("# by a program\na,b\n1,2\n");
        assert_eq!(
            text.as_deref(),
            Some("by a program\n\n| a | b |\n|---|---|\n| 1 | 2 |\n")
        );
        assert_eq!(markdown("a,b\n"), None);
    }
}
