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
            title: view.title.to_owned(),
            share: view.share,
            quantities,
        }
    }

    /// The same with a column that is drawn in place of the usual one.
    pub fn drawing(mut self, column: &str) -> Result<Self, Failure> {
        let found = self
            .quantities
            .iter()
            .position(|known| known.column == column);
        let Some(drawn) = found else {
            let mut columns = self
                .quantities
                .iter()
                .map(|known| known.column)
                .collect::<Vec<_>>();
            columns.sort_unstable();
            let columns = columns.join(", ");
            return Err(Failure::input(format!(
                "--plot {column}: the sweep has no such column; give one of {columns}"
            )));
        };
        self.drawn = drawn;
        self.title = match self.quantities[drawn].error {
            Some(_) => format!("{}, mean over time", column.replace('_', " ")),
            None => column.replace('_', " "),
        };
        Ok(self)
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

    /// Label of the axis of the drawn quantity.
    pub fn axis(&self) -> String {
        let drawn = self.quantities.get(self.drawn);
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
