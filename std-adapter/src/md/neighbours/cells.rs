//! Slots sorted into cells as wide as the reach of the list.

use super::images::Slot;
use nalgebra::Vector3;
use std::ops::Range;

/// Cells per slot at most; far outliers make cells wider instead of more.
const CELLS_PER_SLOT: f64 = 4.0;

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
    /// Positions of the slots, one array per axis.
    places: [Vec<f64>; 3],
    /// Cell of each slot.
    cell_of: Vec<u32>,
    /// First slot of each cell, and the end of the last.
    starts: Vec<u32>,
    /// Number of images before each slot, and in total.
    images: Vec<u32>,
}

impl Cells {
    /// Sorts `slots`; within a cell they keep their order.
    pub fn sort(&mut self, positions: &[Vector3<f64>], slots: Vec<Slot>, reach: f64) {
        let place = |slot: &Slot| positions[slot.atom as usize] + slot.shift;
        self.lay(slots.iter().map(place), slots.len(), reach);
        let cells: Vec<u32> = slots.iter().map(|slot| self.cell(&place(slot))).collect();
        let [x, y, z] = self.axes.map(|axis| axis.cells);
        self.starts.clear();
        self.starts.resize(x * y * z + 1, 0);
        for &cell in &cells {
            self.starts[cell as usize + 1] += 1;
        }
        for cell in 1..self.starts.len() {
            self.starts[cell] += self.starts[cell - 1];
        }
        let mut next = self.starts.clone();
        let mut order = vec![0_u32; slots.len()];
        for (slot, &cell) in cells.iter().enumerate() {
            order[next[cell as usize] as usize] = slot as u32;
            next[cell as usize] += 1;
        }
        let order = || order.iter().map(|&slot| slot as usize);
        self.cell_of = order().map(|slot| cells[slot]).collect();
        self.slots = order().map(|slot| slots[slot]).collect();
        let places: Vec<Vector3<f64>> = self.slots.iter().map(place).collect();
        self.places = std::array::from_fn(|axis| places.iter().map(|place| place[axis]).collect());
        let count = |before: &mut u32, slot: &Slot| {
            *before += u32::from(slot.is_image);
            Some(*before)
        };
        self.images.clear();
        self.images.push(0);
        self.images.extend(self.slots.iter().scan(0, count));
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
            > most
        {
            width *= 2.0;
        }
        for (axis, extent) in extent.into_iter().enumerate() {
            self.axes[axis] = Axis::new(extent, width);
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

    /// Positions of the sorted slots along x, y and z.
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

    /// The nine rows of three cells around the cell of `slot`, as ranges of slots in ascending order.
    pub fn around(&self, slot: usize) -> [Range<usize>; 9] {
        std::array::from_fn(|row| self.row(slot, row, [1, 1]))
    }

    /// One of these rows, with `beside` cells left and right of its middle one.
    fn row(&self, slot: usize, row: usize, [left, right]: [usize; 2]) -> Range<usize> {
        let [x, y, _] = self.axes.map(|axis| axis.cells);
        let own = self.cell_of[slot] as usize;
        let (dz, dy) = (row / 3, row % 3);
        let middle = own + dz * x * y + dy * x - x * y - x;
        self.starts[middle - left] as usize..self.starts[middle + right + 1] as usize
    }

    /// The same rows without the cells that are entirely beyond `reach_sq`.
    pub fn in_reach(&self, slot: usize, reach_sq: f64) -> [Range<usize>; 9] {
        let place = self.place(slot);
        let [x, y, z]: [[f64; 3]; 3] =
            std::array::from_fn(|axis| self.axes[axis].gaps_sq(place[axis]));
        std::array::from_fn(|row| {
            let aside = z[row / 3] + y[row % 3];
            if aside >= reach_sq {
                return 0..0;
            }
            let beside = [x[0], x[2]].map(|gap_sq| usize::from(aside + gap_sq < reach_sq));
            self.row(slot, row, beside)
        })
    }

    /// Slots of all cells around those of `owned`.
    pub fn window(&self, owned: &Range<usize>) -> Range<usize> {
        let rows = |slot: usize| self.around(slot);
        let first = rows(owned.start)[0].start;
        let last = rows(owned.end - 1)[8].end;
        first.min(owned.start)..last.max(owned.end)
    }
}
