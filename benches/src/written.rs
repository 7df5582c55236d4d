//! Results as files: one table, written as CSV and as Markdown.

use std::fmt::Write as _;
use std::fs;
use std::path::Path;

/// Rows of text under a header.
#[derive(Clone, Debug, Default)]
pub struct Sheet {
    /// One line above the table: what was measured, how, by which command.
    pub about: String,
    /// Column names.
    pub header: Vec<&'static str>,
    /// Cells, row by row.
    pub rows: Vec<Vec<String>>,
}

/// A column: its name, and the cell of a row.
pub type Column<'a, T> = (&'static str, &'a dyn Fn(&T) -> String);

impl Sheet {
    /// A line for each row, column by column.
    pub fn of<T>(
        about: impl Into<String>,
        rows: impl IntoIterator<Item = T>,
        columns: &[Column<'_, T>],
    ) -> Self {
        let line = |row: T| columns.iter().map(|(_, cell)| cell(&row)).collect();
        Self {
            about: about.into(),
            header: columns.iter().map(|(name, _)| *name).collect(),
            rows: rows.into_iter().map(line).collect(),
        }
    }

    /// The table as CSV, with its description as a comment.
    pub fn csv(&self) -> String {
        let mut text = format!("# {}\n{}\n", self.about, self.header.join(","));
        for row in &self.rows {
            let _ = writeln!(text, "{}", row.join(","));
        }
        text
    }

    /// The table as Markdown.
    pub fn markdown(&self) -> String {
        let rule = vec!["---"; self.header.len()].join("|");
        let mut text = format!(
            "{}\n\n| {} |\n|{rule}|\n",
            self.about,
            self.header.join(" | ")
        );
        for row in &self.rows {
            let _ = writeln!(text, "| {} |", row.join(" | "));
        }
        text
    }
}

/// Writes `text` to `folder`/`name`, making the folder first.
pub fn write(folder: &Path, name: &str, text: &str) -> Result<(), String> {
    let path = folder.join(name);
    fs::create_dir_all(folder)
        .and_then(|()| fs::write(&path, text))
        .map_err(|error| format!("cannot write {}: {error}", path.display()))
}

/// Three significant digits, in the notation that suits the size.
pub fn short(value: f64) -> String {
    if value == 0.0 {
        "0".into()
    } else if !(1e-3..1e5).contains(&value.abs()) {
        format!("{value:.1e}")
    } else {
        let digits = 2 - value.abs().log10().floor() as i32;
        format!("{value:.*}", digits.max(0) as usize)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_short() {
        assert_eq!(short(13.456), "13.5");
        assert_eq!(short(0.01234), "0.0123");
        assert_eq!(short(2.2e-16), "2.2e-16");
        assert_eq!(short(-1234.5), "-1234");
        assert_eq!(short(f64::INFINITY), "inf");
    }

    #[test]
    fn sheets_have_one_line_a_row() {
        let sheet = Sheet::of(
            "about",
            [1],
            &[("a", &|n| n.to_string()), ("b", &|n| (n + 1).to_string())],
        );
        assert_eq!(sheet.csv(), "# about\na,b\n1,2\n");
        assert_eq!(
            sheet.markdown(),
            "about\n\n| a | b |\n|---|---|\n| 1 | 2 |\n"
        );
    }
}
