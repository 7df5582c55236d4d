//! The slots that may be neighbours of the owned ones of a cell.

use super::cells::{Cells, Rows};
use super::window::Window;
use crate::md::lanes::{ROUGH_LANES, Rough};
use std::ops::Range;

/// The later slots around a cell, side by side in memory: rough positions, and numbers of the sites.
#[derive(Debug, Default)]
pub(super) struct Candidates {
    along: [Vec<f32>; 3],
    sites: Vec<u32>,
    /// First owned slot of the cell, the first candidate.
    first: usize,
}

impl Candidates {
    /// Gathers the slots from the first owned one of the cell on, in the order of cells.
    pub(super) fn gather(
        &mut self,
        cells: &Cells,
        window: &Window,
        (cell, rows): (u32, &Rows),
        nowhere: u32,
    ) {
        self.along.iter_mut().for_each(Vec::clear);
        self.sites.clear();
        self.first = cells.start(cell).max(window.here.start);
        for row in 4..9 {
            let slots = cells.near(rows, row);
            // Slots of the own row before the first are no candidates.
            let slots = slots.start.max(self.first)..slots.end;
            if slots.is_empty() {
                continue;
            }
            for (along, from) in self.along.iter_mut().zip(cells.rough().along()) {
                along.extend_from_slice(&from[slots.clone()]);
            }
            let site = window.site(slots.start);
            self.sites.extend(site..site + slots.len() as u32);
        }
        // The last block goes on to infinity.
        for along in &mut self.along {
            along.extend([f32::INFINITY; ROUGH_LANES]);
        }
        self.sites.extend([nowhere; ROUGH_LANES]);
    }

    /// Candidates after a slot of the cell.
    #[inline(always)]
    pub(super) fn after(&self, slot: usize) -> Range<usize> {
        slot + 1 - self.first..self.sites.len() - ROUGH_LANES
    }

    /// Blocks of rough positions along x, y and z, and of sites.
    #[inline(always)]
    #[allow(clippy::type_complexity)] // Three coordinates and a number.
    pub(super) fn blocks(
        &self,
        range: Range<usize>,
    ) -> impl Iterator<Item = ([&[f32; ROUGH_LANES]; 3], &[u32; ROUGH_LANES])> {
        let full = range.start..range.start + range.len().next_multiple_of(ROUGH_LANES);
        let [x, y, z] = &self.along;
        let x = x[full.clone()].as_chunks().0;
        let y = y[full.clone()].as_chunks().0;
        let z = z[full.clone()].as_chunks().0;
        let sites = self.sites[full].as_chunks().0;
        let places = x.iter().zip(y).zip(z).map(|((x, y), z)| [x, y, z]);
        places.zip(sites)
    }

    /// Rough position of a slot of the cell.
    #[inline(always)]
    pub(super) fn place<R: Rough>(&self, key: R::Key, slot: usize) -> [R; 3] {
        let [x, y, z] = &self.along;
        let at = slot - self.first;
        [
            R::splat(key, x[at]),
            R::splat(key, y[at]),
            R::splat(key, z[at]),
        ]
    }
}
