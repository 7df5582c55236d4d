//! Slots sorted into cells as wide as the reach of the list.

use super::LANES;
use super::images::{Slot, fill_slots};
use crate::space::PeriodicBox;
use nalgebra::Vector3;
use std::ops::Range;

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
            inv_width,
            cells: cells as usize + 2,
        }
    }

    fn cell(&self, x: f64) -> usize {
        let inner = ((x - self.low) * self.inv_width) as usize;
        inner.min(self.cells - 3) + 1
    }

    /// First and last cell within `reach` of `x`, with some doubt.
    fn span(&self, x: f64, reach: f64) -> [usize; 2] {
        let reach = reach + DOUBT / self.inv_width;
        [self.cell(x - reach), self.cell(x + reach)]
    }

    /// Squares of the least distances from `x` to the cell before its own, its own and the next,
    /// rounded down.
    fn gaps_sq(&self, x: f64) -> [f64; 3] {
        let inside = (x - self.low) * self.inv_width - (self.cell(x) - 1) as f64;
        [inside, 0.0, 1.0 - inside].map(|gap| {
            let gap = (gap - DOUBT).max(0.0) / self.inv_width;
            gap * gap
        })
    }
}

/// Slots in the order of their cells: x varies fastest, z slowest.
#[derive(Clone, Debug, Default)]
pub struct Cells {
    axes: [Axis; 3],
    slots: Vec<Slot>,
    /// Positions of the slots, one array per axis, and a block of none.
    places: [Vec<f64>; 3],
    /// Cell of each slot.
    cell_of: Vec<u32>,
    /// First slot of each cell, and the end of the last.
    starts: Vec<u32>,
    /// Number of images before each slot, and in total.
    images: Vec<u32>,
    /// Memory of the sorting: slots with their cells, and the place of the next slot of each cell.
    unsorted: Vec<Slot>,
    unsorted_cells: Vec<u32>,
    next: Vec<u32>,
}

impl Cells {
    /// Sorts the atoms and their images; within a cell they keep their order.
    pub fn fill(&mut self, space: &PeriodicBox, positions: &[Vector3<f64>], reach: f64) {
        let mut slots = std::mem::take(&mut self.unsorted);
        fill_slots(&mut slots, space, positions, reach);
        let place = |slot: &Slot| positions[slot.atom as usize] + slot.shift;
        let count = slots.len();
        self.lay(slots.iter().map(place), count, reach);
        let mut cells = std::mem::take(&mut self.unsorted_cells);
        cells.clear();
        cells.extend(slots.iter().map(|slot| self.cell(&place(slot))));
        let [x, y, z] = self.axes.map(|axis| axis.cells);
        self.starts.clear();
        self.starts.resize(x * y * z + 1, 0);
        for &cell in &cells {
            self.starts[cell as usize + 1] += 1;
        }
        for cell in 1..self.starts.len() {
            self.starts[cell] += self.starts[cell - 1];
        }
        self.next.clone_from(&self.starts);
        self.slots.clone_from(&slots);
        self.cell_of.resize(count, 0);
        for along in &mut self.places {
            along.clear();
            along.resize(count + LANES, f64::NAN);
        }
        for (slot, &cell) in slots.iter().zip(&cells) {
            let next = &mut self.next[cell as usize];
            let at = *next as usize;
            *next += 1;
            self.slots[at] = *slot;
            self.cell_of[at] = cell;
            for (along, x) in self.places.iter_mut().zip(place(slot).iter()) {
                along[at] = *x;
            }
        }
        let count = |before: &mut u32, slot: &Slot| {
            *before += u32::from(slot.is_image);
            Some(*before)
        };
        self.images.clear();
        self.images.push(0);
        self.images.extend(self.slots.iter().scan(0, count));
        (self.unsorted, self.unsorted_cells) = (slots, cells);
    }

    /// Fits the cells to all positions.
    fn lay(&mut self, places: impl Iterator<Item = Vector3<f64>>, count: usize, reach: f64) {
        let mut extent = [[f64::INFINITY, f64::NEG_INFINITY]; 3];
        for place in places {
            for (axis, [low, high]) in extent.iter_mut().enumerate() {
                *low = low.min(place[axis]);
                *high = high.max(place[axis]);
            }
        }
        if count == 0 {
            extent = [[0.0; 2]; 3];
        }
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

    /// Positions of the sorted slots along x, y and z, and of a block more that is nowhere.
    pub fn places(&self) -> [&[f64]; 3] {
        let [x, y, z] = &self.places;
        [x, y, z]
    }

    /// Position of a slot.
    pub fn place(&self, slot: usize) -> [f64; 3] {
        self.places().map(|along| along[slot])
    }

    /// True if one of these slots is an image.
    pub fn has_image(&self, slots: &Range<usize>) -> bool {
        self.images[slots.end] > self.images[slots.start]
    }

    /// The slots of one of the nine rows around the cell of `slot`, in cells `first` to `last` along x.
    fn row(&self, slot: usize, row: usize, [first, last]: [usize; 2]) -> Range<usize> {
        let [x, y, _] = self.axes.map(|axis| axis.cells);
        let own = self.cell_of[slot] as usize;
        let (dz, dy) = (row / 3, row % 3);
        let start = own - own % x + dz * x * y + dy * x - x * y - x;
        self.starts[start + first] as usize..self.starts[start + last + 1] as usize
    }

    /// The slots of some of the nine rows of cells around `slot`, the row `from` and the next ones,
    /// without cells entirely beyond `reach_sq`.
    #[inline(always)]
    pub fn in_reach<const ROWS: usize>(
        &self,
        slot: usize,
        reach_sq: f64,
        from: usize,
    ) -> [Range<usize>; ROWS] {
        let [x, y, z] = self.place(slot);
        let [y, z] = [(1, y), (2, z)].map(|(axis, place)| self.axes[axis].gaps_sq(place));
        std::array::from_fn(|row| {
            let row = from + row;
            let left_sq = reach_sq - (z[row / 3] + y[row % 3]);
            if left_sq <= 0.0 {
                return 0..0;
            }
            self.row(slot, row, self.axes[0].span(x, left_sq.sqrt()))
        })
    }

    /// Whether there may be images in reach before `slot`.
    #[inline]
    pub fn has_image_before(&self, slot: usize) -> bool {
        let own = self.cell_of[slot] as usize % self.axes[0].cells;
        let span = [own.saturating_sub(SLIM), own + SLIM];
        let last = self.axes[0].cells - 1;
        (0..5).any(|row| self.has_image(&self.row(slot, row, span.map(|cell| cell.min(last)))))
    }

    /// Slots of all cells around those of `owned`.
    pub fn window(&self, owned: &Range<usize>) -> Range<usize> {
        let whole = [0, self.axes[0].cells - 1];
        let first = self.row(owned.start, 0, whole).start;
        let last = self.row(owned.end - 1, 8, whole).end;
        first.min(owned.start)..last.max(owned.end)
    }
}
