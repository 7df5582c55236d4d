//! What a sweep makes of the summaries of a kind of run.

/// A number of a summary that is averaged: its column and its place in the summary.
type Quantity = (&'static str, &'static str);

/// A column of the table for the terminal.
#[derive(Debug)]
pub struct TableColumn {
    /// Its head.
    pub head: &'static str,
    /// Index among the quantities.
    pub quantity: usize,
    /// Factor to the unit in the head.
    pub factor: f64,
}

/// The quantities of a kind of run.
#[derive(Debug)]
pub struct RunKind {
    /// All that go into the table; the first is the one drawn.
    pub quantities: &'static [Quantity],
    /// What the drawing is called, and its axis.
    pub drawn: [&'static str; 2],
    /// A word of the summary whose share is told: column, place, word.
    pub share: [&'static str; 3],
    /// For the terminal.
    pub told: &'static [TableColumn],
}

/// A column of a quantity for the terminal.
pub const fn told(head: &'static str, quantity: usize, factor: f64) -> TableColumn {
    TableColumn {
        head,
        quantity,
        factor,
    }
}
