//! What a sweep makes of the summaries of a kind of run.

use crate::failure::Failure;
use tribos::results::{SweepView, SweptQuantity};

/// The quantities of a kind of run.
#[derive(Clone, Debug)]
pub struct RunKind {
    /// All that go into the table.
    pub quantities: Vec<SweptQuantity>,
    /// The one that is drawn.
    pub drawn: usize,
    /// The one that it is drawn over, in place of a key.
    pub over: Option<usize>,
    /// What the drawing is called.
    pub title: String,
    /// A word of the summary whose share is told: column, place, word.
    pub share: [&'static str; 3],
}

impl RunKind {
    /// The quantities of a summary, with what a sweep shows of them.
    pub fn of(quantities: Vec<SweptQuantity>, view: SweepView) -> Self {
        let mut columns = quantities.iter().map(|known| known.column);
        Self {
            drawn: columns.position(|column| column == view.drawn).unwrap_or(0),
            over: None,
            title: view.title.to_owned(),
            share: view.share,
            quantities,
        }
    }

    /// The same with a column that is drawn in place of the usual one, `COLUMN` or `COLUMN:OVER` with the one below it.
    pub fn drawing(mut self, columns: &str) -> Result<Self, Failure> {
        let (column, over) = match columns.split_once(':') {
            Some((column, over)) => (column, Some(over)),
            None => (columns, None),
        };
        self.drawn = self.place(column)?;
        self.over = over.map(|over| self.place(over)).transpose()?;
        self.title = match self.quantities[self.drawn].error {
            Some(_) => format!("{}, mean over time", column.replace('_', " ")),
            None => column.replace('_', " "),
        };
        Ok(self)
    }

    fn place(&self, column: &str) -> Result<usize, Failure> {
        let names = || self.quantities.iter().map(|known| known.column);
        names().position(|known| known == column).ok_or_else(|| {
            let mut columns = names().collect::<Vec<_>>();
            columns.sort_unstable();
            let columns = columns.join(", ");
            Failure::input(format!(
                "--plot {column}: the sweep has no such column; give one of {columns}"
            ))
        })
    }

    /// Whether one table can hold the results of both.
    pub fn has_columns_of(&self, other: &Self) -> bool {
        let columns = |kind: &Self| {
            kind.quantities
                .iter()
                .map(|known| known.column)
                .collect::<Vec<_>>()
        };
        self.title == other.title && columns(self) == columns(other)
    }

    /// Label of the axis of a quantity.
    pub fn axis(&self, quantity: usize) -> String {
        let drawn = self.quantities.get(quantity);
        drawn.map_or(String::new(), |drawn| {
            drawn.labelled(&drawn.column.replace('_', " "))
        })
    }
}

/// Quantities, those of these columns before the others.
pub fn first(columns: &[&str], mut all: Vec<SweptQuantity>) -> Vec<SweptQuantity> {
    let place = |known: &SweptQuantity| columns.iter().position(|column| *column == known.column);
    all.sort_by_key(|known| place(known).unwrap_or(columns.len()));
    all
}
