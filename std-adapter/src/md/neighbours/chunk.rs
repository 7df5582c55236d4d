//! A part of a Verlet list: its slots, those that they see, and the pairs.

use super::cells::Cells;
use super::images::Slot;
use nalgebra::Vector3;
use std::ops::Range;

/// Pairs computed side by side. Part of the result: sums run lane by lane, whatever the machine's
/// vectors hold.
pub const LANES: usize = 4;

/// Where the site stands that fills up the lanes: far from all others, its square still a number.
const NOWHERE: f64 = 1e100;

/// What the loop over pairs reads and writes of a slot, in one line of cache.
#[derive(Clone, Copy, Debug)]
#[repr(align(64))]
pub struct Site {
    /// Place now.
    pub place: [f64; 3],
    /// Force gathered so far.
    pub force: [f64; 3],
    /// Species.
    pub species: u8,
}

/// Owned slots with their neighbours.
#[derive(Clone, Debug)]
pub struct Chunk {
    /// All slots in sight, ordered by cells.
    window: Vec<Slot>,
    /// As many sites, and a last one nowhere.
    sites: Vec<Site>,
    /// The owned ones among them.
    owned: Range<usize>,
    /// Where the row of each owned slot begins, and one more: blocks of `neighbours`.
    starts: Vec<u32>,
    neighbours: Vec<[u32; LANES]>,
    pairs: usize,
}

impl Chunk {
    /// The pairs of `owned` slots nearer than the root of `reach_sq`.
    pub(super) fn build(cells: &Cells, owned: Range<usize>, reach_sq: f64, species: &[u8]) -> Self {
        let window = cells.window(&owned);
        let slots = cells.slots()[window.clone()].to_vec();
        let blank = Site {
            place: [NOWHERE; 3],
            force: [0.0; 3],
            species: 0,
        };
        let mut sites = vec![blank; slots.len() + 1];
        for (site, slot) in sites.iter_mut().zip(&slots) {
            site.species = species[slot.atom as usize];
        }
        let mut chunk = Self {
            sites,
            owned: owned.start - window.start..owned.end - window.start,
            starts: vec![0],
            neighbours: Vec::new(),
            pairs: 0,
            window: slots,
        };
        let mut row = Vec::new();
        for slot in owned {
            row.clear();
            if !cells.slots()[slot].is_image {
                near(cells, slot, reach_sq, window.start, &mut row);
            }
            chunk.push_row(&mut row);
        }
        chunk
    }

    /// Adds a row, its last block filled up with the site that is nowhere.
    fn push_row(&mut self, row: &mut Vec<u32>) {
        self.pairs += row.len();
        let nowhere = self.window.len() as u32;
        row.resize(row.len().next_multiple_of(LANES), nowhere);
        self.neighbours.extend_from_slice(row.as_chunks().0);
        self.starts.push(self.neighbours.len() as u32);
    }

    /// Takes over the places of the atoms and forgets the forces.
    pub(super) fn refresh(&mut self, positions: &[Vector3<f64>]) {
        for (site, slot) in self.sites.iter_mut().zip(&self.window) {
            site.place = (positions[slot.atom as usize] + slot.shift).into();
            site.force = [0.0; 3];
        }
    }

    /// Slots in sight; the first [`window`](Self::window)`.len()` sites are theirs.
    pub fn window(&self) -> &[Slot] {
        &self.window
    }

    /// Number of pairs.
    pub fn pairs(&self) -> usize {
        self.pairs
    }

    /// The sites.
    pub fn sites(&self) -> &[Site] {
        &self.sites
    }

    /// The sites to write to, and the rows: an owned site with the blocks of its neighbours.
    pub fn sites_and_rows(
        &mut self,
    ) -> (
        &mut [Site],
        impl Iterator<Item = (usize, &[[u32; LANES]])> + Clone,
    ) {
        let blocks = &self.neighbours;
        let ends = self.starts.windows(2);
        let rows = self
            .owned
            .clone()
            .zip(ends)
            .map(|(site, ends)| (site, &blocks[ends[0] as usize..ends[1] as usize]));
        (&mut self.sites, rows)
    }
}

/// Neighbours of a slot that is no image: all images in reach, of the atoms those after it.
fn near(cells: &Cells, slot: usize, reach_sq: f64, first: usize, row: &mut Vec<u32>) {
    let place = cells.places()[slot];
    for range in cells.around(slot) {
        let later = range.start.max(slot + 1)..range.end;
        // Rows behind the slot matter for their images only.
        let before = range.start..range.end.min(slot);
        if !before.is_empty() && cells.has_image(&before) {
            let images = before.filter(|&other| cells.slots()[other].is_image);
            let near =
                images.filter(|&other| (cells.places()[other] - place).norm_squared() < reach_sq);
            row.extend(near.map(|other| (other - first) as u32));
        }
        if later.start >= later.end {
            continue;
        }
        // Written always, kept if near: no branch to guess.
        let mut end = row.len();
        row.resize(end + later.len(), 0);
        for (other, there) in later.clone().zip(&cells.places()[later]) {
            row[end] = (other - first) as u32;
            end += usize::from((there - place).norm_squared() < reach_sq);
        }
        row.truncate(end);
    }
}
