//! Reading the tables of `tables/`.

use crate::reference::Reference;
use std::path::Path;

/// A CSV table: a comment line with its origin, a header, rows.
#[derive(Clone, Debug)]
pub struct Table {
    name: String,
    columns: Vec<String>,
    rows: Vec<Vec<String>>,
}

/// One row of a [`Table`].
#[derive(Clone, Copy, Debug)]
pub struct Row<'a> {
    table: &'a Table,
    number: usize,
}

impl Table {
    /// Reads `tables/<name>`.
    ///
    /// # Panics
    /// If the file is missing, has no rows or a row of the wrong length.
    pub fn read(name: &str) -> Self {
        let path = Path::new(env!("CARGO_MANIFEST_DIR"))
            .join("tables")
            .join(name);
        let text = std::fs::read_to_string(&path)
            .unwrap_or_else(|error| panic!("{}: {error}", path.display()));
        let mut lines = text.lines().filter(|line| !line.starts_with('#'));
        let split = |line: &str| line.split(',').map(str::to_owned).collect::<Vec<_>>();
        let columns = split(lines.next().expect("a header"));
        let rows: Vec<_> = lines.map(split).collect();
        assert!(!rows.is_empty(), "{name} is empty");
        for row in &rows {
            assert_eq!(row.len(), columns.len(), "{name}: {row:?}");
        }
        Self {
            name: name.to_owned(),
            columns,
            rows,
        }
    }

    /// All rows in order.
    pub fn rows(&self) -> impl Iterator<Item = Row<'_>> {
        (0..self.rows.len()).map(move |number| Row {
            table: self,
            number,
        })
    }

    /// The different values of a numeric column, in order of first appearance.
    pub fn distinct(&self, column: &str) -> Vec<f64> {
        let mut seen = Vec::new();
        for row in self.rows() {
            let value = row.number(column);
            if !seen.contains(&value) {
                seen.push(value);
            }
        }
        seen
    }
}

impl<'a> Row<'a> {
    /// True if there is such a column.
    pub fn has(&self, column: &str) -> bool {
        self.table.columns.iter().any(|one| one == column)
    }

    /// The text of a column.
    ///
    /// # Panics
    /// If there is no such column.
    pub fn text(&self, column: &str) -> &'a str {
        let at = self.table.columns.iter().position(|c| c == column);
        let at = at.unwrap_or_else(|| panic!("{} has no column {column}", self.table.name));
        &self.table.rows[self.number][at]
    }

    /// The f64 nearest to a column: arguments are such numbers by definition.
    ///
    /// # Panics
    /// If the column is not a number.
    pub fn number(&self, column: &str) -> f64 {
        self.reference(column).high
    }

    /// A column with all its digits.
    ///
    /// # Panics
    /// If the column is not a number.
    pub fn reference(&self, column: &str) -> Reference {
        let text = self.text(column);
        Reference::parse(text)
            .unwrap_or_else(|| panic!("{}, {column}: {text:?} is no number", self.table.name))
    }

    /// A column that may be blank.
    pub fn optional(&self, column: &str) -> Option<Reference> {
        (!self.text(column).is_empty()).then(|| self.reference(column))
    }
}
