//! The rows of a log that are complete, and the numbers of those that are not.

use super::DropReason;
use super::assign::Assigned;
use crate::record::cells::Cell;

/// Columns in SI while they are read.
#[derive(Debug)]
pub(super) struct Collector {
    pub columns: Vec<Vec<f64>>,
    pub lines: Vec<u64>,
    /// Numbers of dropped rows in the order of [`DropReason::ALL`].
    pub dropped: [u64; 6],
    /// Factor of each column.
    factors: Vec<f64>,
    /// Which column is the time.
    time: Option<usize>,
    /// Dropped rows for a cell of each column.
    gaps: Vec<u64>,
    row: Vec<Option<Cell>>,
    last: Option<f64>,
}

impl Collector {
    pub fn new(assigned: &[Assigned]) -> Self {
        let count = assigned.len();
        Self {
            columns: vec![Vec::new(); count],
            lines: Vec::new(),
            dropped: [0; 6],
            factors: assigned.iter().map(|one| one.factor).collect(),
            time: assigned.iter().position(|one| one.role.name == "t"),
            gaps: vec![0; count],
            row: vec![None; count],
            last: None,
        }
    }

    /// Sets a cell of the present row.
    pub fn put(&mut self, slot: usize, cell: Cell) {
        if let Some(place) = self.row.get_mut(slot) {
            *place = Some(cell);
        }
    }

    /// Counts a row that holds no values.
    pub fn skip(&mut self, reason: DropReason) {
        let at = DropReason::ALL.iter().position(|known| *known == reason);
        if let Some(count) = at.and_then(|at| self.dropped.get_mut(at)) {
            *count += 1;
        }
        self.row.fill(None);
    }

    /// Ends the present row, which is kept if it is complete and its time rises.
    pub fn end(&mut self, line: u64) {
        if let Some((slot, reason)) = self.gap() {
            if let Some(gaps) = self.gaps.get_mut(slot) {
                *gaps += 1;
            }
            return self.skip(reason);
        }
        if let Some(time) = self.time.and_then(|slot| self.value(slot)) {
            match self.last {
                Some(last) if time < last => return self.skip(DropReason::TimeBack),
                Some(last) if time <= last => return self.skip(DropReason::RepeatedTime),
                _ => self.last = Some(time),
            }
        }
        for slot in 0..self.row.len() {
            let value = self.value(slot).unwrap_or(f64::NAN);
            if let Some(column) = self.columns.get_mut(slot) {
                column.push(value);
            }
        }
        self.lines.push(line);
        self.row.fill(None);
    }

    /// The first cell of the row that holds no number.
    fn gap(&self) -> Option<(usize, DropReason)> {
        let mut cells = self.row.iter().enumerate();
        cells.find_map(|(slot, cell)| match cell {
            Some(Cell::Number(_)) => None,
            Some(Cell::Empty) => Some((slot, DropReason::Empty)),
            Some(Cell::Missing | Cell::Word) => Some((slot, DropReason::NotANumber)),
            None => Some((slot, DropReason::Short)),
        })
    }

    /// A number of the row in SI.
    fn value(&self, slot: usize) -> Option<f64> {
        match self.row.get(slot) {
            Some(Some(Cell::Number(value))) => Some(value * self.factors.get(slot)?),
            _ => None,
        }
    }

    /// Refuses a log of which most rows, or all, were dropped.
    pub fn check(&self, assigned: &[Assigned]) -> Result<(), String> {
        let kept = self.lines.len() as u64;
        let dropped: u64 = self.dropped.iter().sum();
        if kept > 0 && dropped <= kept {
            return Ok(());
        }
        let all = DropReason::ALL.into_iter().zip(self.dropped);
        let counts = all.clone().filter(|(_, count)| *count > 0);
        let counts = counts.map(|(reason, count)| format!("{count} {}", reason.name()));
        let counts: Vec<String> = counts.collect();
        let worst = all.max_by_key(|(_, count)| *count);
        let cure = worst.map_or("", |(reason, _)| reason.cure());
        let gaps = self
            .gaps
            .iter()
            .zip(assigned)
            .max_by_key(|(gaps, _)| **gaps);
        let column = gaps
            .filter(|(gaps, _)| **gaps > 0)
            .map_or(String::new(), |(_, one)| {
                format!(", most of them for {} (`{}`)", one.role.name, one.name)
            });
        let whole = kept + dropped;
        Err(format!(
            "{dropped} of {whole} rows cannot be used: {}{column}; {cure}",
            counts.join(", ")
        ))
    }
}
