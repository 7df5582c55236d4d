//! The slots of a block of atoms before they are sorted into cells.

use super::buckets::Buckets;
use super::images::{Slot, fill_slots};
use nalgebra::Vector3;
use std::ops::Range;
use tribos_base::space::PeriodicBox;

/// Atoms of a block and their images, in the order of the atoms.
#[derive(Clone, Debug, Default)]
pub(super) struct Batch {
    pub(super) slots: Vec<Slot>,
    /// Least and largest coordinates of the slots along each axis.
    pub(super) extent: [[f64; 2]; 3],
    /// Cells and slots, sorted by parts of the cells.
    pub(super) parts: Buckets,
    /// Cell of each slot.
    cells: Vec<u32>,
}

impl Batch {
    /// No coordinates.
    pub(super) const NO_EXTENT: [[f64; 2]; 3] = [[f64::INFINITY, f64::NEG_INFINITY]; 3];

    /// Takes the atoms of a block and their images.
    pub(super) fn collect(
        &mut self,
        space: &PeriodicBox,
        positions: &[Vector3<f64>],
        atoms: Range<usize>,
        reach: f64,
    ) {
        fill_slots(&mut self.slots, space, positions, atoms, reach);
        let places = self.slots.iter().map(|slot| slot.place(positions));
        self.extent = places.fold(Self::NO_EXTENT, |extent, place| {
            std::array::from_fn(|axis| {
                let [low, high] = extent[axis];
                [low.min(place[axis]), high.max(place[axis])]
            })
        });
    }

    /// Sorts the slots by the parts of their cells.
    pub(super) fn sort(
        &mut self,
        positions: &[Vector3<f64>],
        cell: impl Fn(&Vector3<f64>) -> u32,
        count: usize,
        part: impl Fn(usize) -> usize,
    ) {
        self.cells.clear();
        let cells = self.slots.iter().map(|slot| cell(&slot.place(positions)));
        self.cells.extend(cells);
        let entries = self.cells.iter().enumerate();
        let entries = entries.map(|(slot, &cell)| [cell, slot as u32]);
        let part = |[cell, _]: [u32; 2]| part(cell as usize);
        self.parts.sort(entries, count, part);
    }
}
