//! What a sweep makes of the summaries of a kind of run.

use tribos::results::{Quantity, SweptQuantity, swept};

/// The quantities of a kind of run.
#[derive(Clone, Debug, PartialEq)]
pub struct RunKind {
    /// All that go into the table.
    pub quantities: Vec<SweptQuantity>,
    /// The one that is drawn.
    pub drawn: usize,
    /// What the drawing is called.
    pub title: &'static str,
    /// A word of the summary whose share is told: column, place, word.
    pub share: [&'static str; 3],
}

impl RunKind {
    /// The quantities of a summary; of them the column that is drawn, after the title of its picture.
    pub fn of(
        table: &'static [Quantity],
        [title, drawn]: [&'static str; 2],
        share: [&'static str; 3],
    ) -> Self {
        Self::among(swept(table), [title, drawn], share)
    }

    /// The same of some of the quantities.
    pub fn among(
        quantities: Vec<SweptQuantity>,
        [title, drawn]: [&'static str; 2],
        share: [&'static str; 3],
    ) -> Self {
        let place = quantities.iter().position(|known| known.column == drawn);
        Self {
            quantities,
            drawn: place.unwrap_or(0),
            title,
            share,
        }
    }

    /// Label of the axis of the drawn quantity.
    pub fn axis(&self) -> String {
        let drawn = self.quantities.get(self.drawn);
        drawn.map_or(String::new(), |drawn| {
            drawn.labelled(&drawn.column.replace('_', " "))
        })
    }
}

/// A quantity of a summary that is no table yet: its column, its place, and its label and unit if people are shown it.
pub type ListedQuantity = (
    &'static str,
    [Option<&'static str>; 2],
    Option<[&'static str; 2]>,
);

impl RunKind {
    /// Quantities of a summary that is no table yet.
    pub fn listed(list: &[ListedQuantity], drawn: [&'static str; 2], share: [&'static str; 3]) -> Self {
        let quantity = |&(column, path, shown): &ListedQuantity| SweptQuantity {
            column,
            path,
            label: shown.map(|[label, _]| label),
            unit: shown.map_or("-", |[_, unit]| unit),
        };
        Self::among(list.iter().map(quantity).collect(), drawn, share)
    }
}
