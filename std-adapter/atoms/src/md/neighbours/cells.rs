//! Slots sorted into cells as wide as the reach of the list.

use super::batch::Batch;
use super::buckets::accumulate;
use super::images::Slot;
use super::rough::{RoughUnit, SinglePrecisionPositions};
use crate::md::blocks::Blocks;
use nalgebra::Vector3;
use rayon::prelude::*;
use std::ops::Range;
use tribos_base::space::PeriodicBox;

/// Cells per slot at most; far outliers make cells wider instead of more.
const CELLS_PER_SLOT: f64 = 4.0;

/// Cells along x within the reach: slim ones, since a row of them is one range of slots whatever their number.
const SLIM: usize = 3;

/// Tolerance as a fraction of a cell's width, far more than rounding can move a cell's border.
const DOUBT: f64 = 1e-6;

/// Cells along one axis: their start, width and number, including one empty cell at each end.
#[derive(Clone, Copy, Debug, Default)]
struct Axis {
    low: f64,
    width: f64,
    inv_width: f64,
    cells: usize,
}

impl Axis {
    /// Cells over `extent` at least `width` wide, and one before and one after.
    fn new([low, high]: [f64; 2], width: f64) -> Self {
        let cells = ((high - low) / width).floor().max(1.0);
        let inv_width = cells / (high - low).max(width);
        Self {
            low,
            width: 1.0 / inv_width,
            inv_width,
            cells: cells as usize + 2,
        }
    }

    #[inline(always)]
    fn cell(&self, x: f64) -> usize {
        // The cells of all axes together are numbered in 32 bits.
        let inner = ((x - self.low) * self.inv_width) as u32 as usize;
        inner.min(self.cells - 3) + 1
    }

    /// First and last cell within `reach` of `x`, with some doubt.
    #[inline(always)]
    fn span(&self, x: f64, reach: f64) -> [usize; 2] {
        let reach = reach + DOUBT * self.width;
        [self.cell(x - reach), self.cell(x + reach)]
    }

    /// Squares of the least distances from `x` to the cell before its own, its own and the next,
    /// rounded down.
    #[inline(always)]
    fn gaps_sq(&self, x: f64) -> [f64; 3] {
        let inside = (x - self.low) * self.inv_width - (self.cell(x) - 1) as f64;
        let before = (inside - DOUBT).max(0.0) * self.width;
        let after = (1.0 - inside - DOUBT).max(0.0) * self.width;
        [before * before, 0.0, after * after]
    }
}

/// The nine rows of cells along x around a cell, numbered along y within three layers along z.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Rows {
    /// First cell of the first row.
    first: usize,
    /// First and last cell of all rows along x within the reach of the cell.
    span: [usize; 2],
    /// Whether there may be images in reach before the slots of the cell.
    pub(super) has_image_before: bool,
}

/// Slots in the order of their cells: x varies fastest, z slowest.
#[derive(Clone, Debug, Default)]
pub struct Cells {
    axes: [Axis; 3],
    slots: Vec<Slot>,
    /// Rough positions of the slots.
    rough: SinglePrecisionPositions,
    /// First slot of each cell, and the end of the last.
    starts: Vec<u32>,
    /// Number of images before each slot, and in total.
    images_before: Vec<u32>,
    /// The slots that are images.
    images: Vec<u32>,
    /// Memory of the sorting.
    batches: Vec<Batch>,
}

/// Some consecutive cells and their slots.
struct Part<'a> {
    number: usize,
    first_cell: usize,
    first_slot: usize,
    slots: &'a mut [Slot],
    /// Rough positions of the slots.
    along: [&'a mut [f32]; 3],
    /// First slot of each cell.
    starts: &'a mut [u32],
    unit: RoughUnit,
}

impl Part<'_> {
    /// Takes the slots from the batches in turn.
    fn fill(self, batches: &[Batch], positions: &[Vector3<f64>]) {
        let [x, y, z] = self.along;
        let cell = |cell: u32| cell as usize - self.first_cell;
        self.starts.fill(0);
        for batch in batches {
            for entry in batch.parts.get(self.number) {
                self.starts[cell(entry[0])] += 1;
            }
        }
        accumulate(self.starts, self.first_slot as u32);
        // From the last slot back, ends become starts.
        for batch in batches.iter().rev() {
            for entry in batch.parts.get(self.number).iter().rev() {
                let start = &mut self.starts[cell(entry[0])];
                *start -= 1;
                let at = *start as usize - self.first_slot;
                let slot = batch.slots[entry[1] as usize];
                self.slots[at] = slot;
                [x[at], y[at], z[at]] = self.unit.rough(&slot.place(positions));
            }
        }
    }
}

/// Cuts the first entries off.
fn take<'a, T>(from: &mut &'a mut [T], count: usize) -> &'a mut [T] {
    from.split_off_mut(..count).unwrap_or_default()
}

impl Cells {
    /// Sorts the atoms and their images; within a cell they keep their order.
    ///
    /// Blocks of atoms are sorted by parts of the cells, then each part takes its slots from all blocks in turn.
    pub fn fill(&mut self, space: &PeriodicBox, positions: &[Vector3<f64>], reach: f64) {
        let blocks = Blocks::new(positions.len());
        let mut batches = std::mem::take(&mut self.batches);
        batches.resize_with(positions.len().div_ceil(blocks.len()), Batch::default);
        let collect = |(block, batch): (usize, &mut Batch)| {
            let len = blocks.len().min(positions.len() - block * blocks.len());
            batch.collect(space, positions, blocks.entries(block, len), reach);
        };
        batches.par_iter_mut().enumerate().for_each(collect);
        let count = batches.iter().map(|batch| batch.slots.len()).sum();
        self.lay(&batches, count, reach);
        let cells = self.axes.iter().map(|axis| axis.cells).product();
        let parts = Blocks::at_most(batches.len(), cells);
        let part = |cell| parts.of(cell);
        batches.par_iter_mut().for_each(|batch| {
            let cell = |place: &Vector3<f64>| self.cell(place);
            batch.sort(positions, cell, cells.div_ceil(parts.len()), part);
        });
        self.slots.resize(count, Slot::NOWHERE);
        self.rough.resize(count);
        self.starts.resize(cells + 1, 0);
        self.starts[cells] = count as u32;
        let parts = self.split(&batches, parts.len());
        let fill = |part: Part<'_>| part.fill(&batches, positions);
        parts.into_par_iter().for_each(fill);
        self.list_images();
        self.batches = batches;
    }

    /// Cuts the cells and their slots into parts of `len` cells.
    fn split<'a>(&'a mut self, batches: &[Batch], len: usize) -> Vec<Part<'a>> {
        let cells = self.starts.len() - 1;
        let (unit, mut along) = self.rough.along_mut();
        let mut slots = &mut self.slots[..];
        let mut first_slot = 0;
        let starts = self.starts[..cells].chunks_mut(len).enumerate();
        let part = |(number, starts)| {
            let slots_of = |batch: &Batch| batch.parts.get(number).len();
            let count = batches.iter().map(slots_of).sum();
            let part = Part {
                number,
                first_cell: number * len,
                first_slot,
                slots: take(&mut slots, count),
                along: along.each_mut().map(|along| take(along, count)),
                starts,
                unit,
            };
            first_slot += count;
            part
        };
        starts.map(part).collect()
    }

    /// Lists and counts the images.
    fn list_images(&mut self) {
        self.images.clear();
        self.images_before.clear();
        for (slot, Slot { is_image, .. }) in self.slots.iter().enumerate() {
            self.images_before.push(self.images.len() as u32);
            if *is_image {
                self.images.push(slot as u32);
            }
        }
        self.images_before.push(self.images.len() as u32);
    }

    /// Fits the cells to all slots.
    fn lay(&mut self, batches: &[Batch], count: usize, reach: f64) {
        let mut extent = Batch::NO_EXTENT;
        for batch in batches {
            for ([low, high], [least, most]) in extent.iter_mut().zip(batch.extent) {
                *low = low.min(least);
                *high = high.max(most);
            }
        }
        if count == 0 {
            extent = [[0.0; 2]; 3];
        }
        self.rough.fit(extent, reach);
        let most = (CELLS_PER_SLOT * count as f64).max(64.0);
        let mut width = reach;
        while extent
            .iter()
            .map(|[l, h]| ((h - l) / width).max(1.0))
            .product::<f64>()
            > most / SLIM as f64
        {
            width *= 2.0;
        }
        for (axis, extent) in extent.into_iter().enumerate() {
            let cells = if axis == 0 { SLIM } else { 1 };
            self.axes[axis] = Axis::new(extent, width / cells as f64);
        }
    }

    fn cell(&self, place: &Vector3<f64>) -> u32 {
        let [x, y, z] = &self.axes;
        let row = z.cell(place.z) * y.cells + y.cell(place.y);
        (row * x.cells + x.cell(place.x)) as u32
    }

    /// The sorted slots.
    pub fn slots(&self) -> &[Slot] {
        &self.slots
    }

    /// Rough positions of the sorted slots.
    pub fn rough(&self) -> &SinglePrecisionPositions {
        &self.rough
    }

    /// Cell of a slot.
    pub fn cell_of(&self, slot: usize) -> u32 {
        let after = self.starts.partition_point(|&start| start as usize <= slot);
        after as u32 - 1
    }

    /// Number of images before a slot.
    pub fn images_before(&self, slot: usize) -> usize {
        self.images_before[slot] as usize
    }

    /// The images among some slots.
    pub fn images(&self, slots: &Range<usize>) -> &[u32] {
        let [start, end] = [slots.start, slots.end].map(|slot| self.images_before(slot));
        self.images.get(start..end).unwrap_or_default()
    }

    /// The rows around a cell.
    pub fn rows(&self, cell: u32) -> Rows {
        let [x, y, _] = self.axes.map(|axis| axis.cells);
        let along = cell as usize % x;
        let rows = Rows {
            first: cell as usize - along - x * y - x,
            ..Rows::default()
        };
        let span = [along.saturating_sub(SLIM), (along + SLIM).min(x - 1)];
        let rows = Rows { span, ..rows };
        let mut before = (0..5).map(|row| self.near(&rows, row));
        Rows {
            has_image_before: before.any(|slots| !self.images(&slots).is_empty()),
            ..rows
        }
    }

    /// The slots of one of nine rows that may be near the slots of the cell.
    pub fn near(&self, rows: &Rows, row: usize) -> Range<usize> {
        self.cells(self.row_start(rows, row), rows.span)
    }

    /// First slot of a cell.
    pub fn start(&self, cell: u32) -> usize {
        self.starts[cell as usize] as usize
    }

    /// First cell of one of nine rows.
    #[inline(always)]
    fn row_start(&self, rows: &Rows, row: usize) -> usize {
        let [x, y, _] = &self.axes;
        rows.first + (row / 3 * y.cells + row % 3) * x.cells
    }

    /// The slots in some cells after the first of a row.
    #[inline(always)]
    fn cells(&self, row_start: usize, [first, last]: [usize; 2]) -> Range<usize> {
        self.starts[row_start + first] as usize..self.starts[row_start + last + 1] as usize
    }

    /// All slots of one of the nine rows around the cell of `slot`.
    pub fn row(&self, slot: usize, row: usize) -> Range<usize> {
        let whole = [0, self.axes[0].cells - 1];
        self.cells(self.row_start(&self.rows(self.cell_of(slot)), row), whole)
    }

    /// The slots of the rows before a place and of its own, without cells entirely beyond `reach_sq` of it.
    pub fn before(&self, rows: &Rows, [x, y, z]: [f64; 3], reach_sq: f64) -> [Range<usize>; 5] {
        let y = self.axes[1].gaps_sq(y);
        let z = self.axes[2].gaps_sq(z);
        std::array::from_fn(|row| {
            let left_sq = reach_sq - (z[row / 3] + y[row % 3]);
            if left_sq <= 0.0 {
                return 0..0;
            }
            let span = self.axes[0].span(x, left_sq.sqrt());
            self.cells(self.row_start(rows, row), span)
        })
    }
}
