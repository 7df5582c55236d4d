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

/// Temporary.
pub struct Listed {
    pub quantities: &'static [(&'static str, &'static str)],
    pub drawn: [&'static str; 2],
    pub share: [&'static str; 3],
    pub told: &'static [(&'static str, usize, f64)],
}
pub const fn told(a: &'static str, b: usize, c: f64) -> (&'static str, usize, f64) {
    (a, b, c)
}
impl Listed {
    pub fn kind(&self) -> RunKind {
        let quantities = self
            .quantities
            .iter()
            .enumerate()
            .map(|(at, (column, place))| {
                let mut names = place[1..].split('/');
                SweptQuantity {
                    column,
                    path: [names.next(), names.next()],
                    label: self
                        .told
                        .iter()
                        .find(|told| told.1 == at)
                        .map(|told| told.0),
                    unit: "-",
                }
            });
        RunKind {
            quantities: quantities.collect(),
            drawn: 0,
            title: self.drawn[0],
            share: self.share,
        }
    }
}
