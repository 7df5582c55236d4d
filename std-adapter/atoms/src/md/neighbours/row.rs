//! The search for the neighbours of one slot after the other.

use super::candidates::Candidates;
use super::cells::{Cells, Rows};
use super::window::Window;
use super::{LANES, Site};
use crate::md::lanes::{Lanes, ROUGH_LANES, Rough};
use std::ops::Range;

/// Lanes of each set of eight lanes.
static CHOSEN: [[u32; ROUGH_LANES]; 1 << ROUGH_LANES] = chosen();
/// Number of lanes of each set.
static COUNTS: [u8; 1 << ROUGH_LANES] = counts();

/// Rows of neighbours, one slot after the other.
#[derive(Debug, Default)]
pub(super) struct RowWriter {
    /// Those of the slot in reach, and some a little beyond.
    found: FoundSites,
    /// The rows so far, then the neighbours of the slot within the cut-off.
    near: SelectedSites,
    /// Those beyond it, within the skin.
    far: SelectedSites,
    /// Whether each site is in a row.
    is_used: Vec<bool>,
    pairs: usize,
}

/// What neighbours are searched in.
#[derive(Clone, Copy)]
pub(super) struct SearchContext<'a> {
    pub(super) cells: &'a Cells,
    pub(super) window: &'a Window,
    /// Sites of the window, in place, and one that is nowhere.
    pub(super) sites: &'a [Site],
    /// Squares of the cut-off, and of the cut-off plus the skin.
    pub(super) reaches_sq: [f64; 2],
    /// Squares of rough distances for both: nearer below the first, farther above the second.
    pub(super) limits: [[f32; 2]; 2],
}

impl SearchContext<'_> {
    /// Which sites of a block are within each reach of a site, a bit for each lane.
    #[cold]
    fn exactly(&self, site: u32, block: &[u32; ROUGH_LANES]) -> [usize; 2] {
        let here = self.sites[site as usize].place;
        let mut within = [0; 2];
        for (lane, other) in block.iter().enumerate() {
            let there = self.sites[*other as usize].place;
            let [x, y, z] = [0, 1, 2].map(|axis: usize| here[axis] - there[axis]);
            let square = x * x + y * y + z * z;
            for (within, reach_sq) in within.iter_mut().zip(self.reaches_sq) {
                *within |= usize::from(square < reach_sq) << lane;
            }
        }
        within
    }
}

impl RowWriter {
    /// No rows yet, in the memory of others; there will be neighbours among some sites.
    pub(super) fn new(memory: Vec<u32>, sites: usize) -> Self {
        Self {
            near: SelectedSites {
                sites: memory,
                count: 0,
            },
            is_used: vec![false; sites],
            ..Self::default()
        }
    }

    /// Appends the neighbours of a slot that is not an image: all images in reach, and the atoms after it.
    #[inline(always)]
    pub(super) fn fill<N: Lanes>(
        &mut self,
        key: N::Key,
        around: SearchContext<'_>,
        slot: usize,
        (rows, candidates): (&Rows, &Candidates),
    ) {
        let SearchContext { cells, window, .. } = around;
        self.found.count = 0;
        let site = window.site(slot);
        // Rows before the slot matter only for their images.
        if rows.has_image_before {
            let [x, y, z, _] = around.sites[site as usize].place;
            let reach_sq = around.reaches_sq[1];
            for range in cells.before(rows, [x, y, z], reach_sq) {
                let before = range.start..range.end.min(slot).max(range.start);
                self.find_images(around, slot, before);
            }
        }
        self.find::<N>(key, around, candidates, slot);
        self.judge::<N>(key, around, site);
    }

    /// Finds the images of a range, wherever they are.
    #[inline(always)]
    fn find_images(&mut self, around: SearchContext<'_>, here: usize, range: Range<usize>) {
        let SearchContext { cells, window, .. } = around;
        let images = cells.images(&range);
        self.found.make_room(images.len());
        for &slot in images {
            let slot = slot as usize;
            let site = if slot < window.before.end {
                window.site_of_image(cells, slot)
            } else {
                window.site(slot)
            };
            let [x, y, z] = cells.rough().along().map(|along| along[slot] - along[here]);
            self.found.sites[self.found.count] = site;
            self.found.squares[self.found.count] = x * x + y * y + z * z;
            self.found.count += 1;
        }
    }

    /// Finds the candidates after the slot that may be in reach, by rough distances.
    #[inline(always)]
    fn find<N: Lanes>(
        &mut self,
        key: N::Key,
        around: SearchContext<'_>,
        candidates: &Candidates,
        slot: usize,
    ) {
        let limit = N::Rough::splat(key, around.limits[1][1]);
        let here: [N::Rough; 3] = candidates.place(key, slot);
        let range = candidates.after(slot);
        self.found.make_room(range.len() + ROUGH_LANES);
        let mut count = self.found.count;
        let FoundSites { sites, squares, .. } = &mut self.found;
        for ([x, y, z], block) in candidates.blocks(range) {
            let x = N::Rough::new(key, x) - here[0];
            let y = N::Rough::new(key, y) - here[1];
            let z = N::Rough::new(key, z) - here[2];
            let square = x * x + y * y + z * z;
            let which = square.which_not_above(limit) & (CHOSEN.len() - 1);
            // A block is always written, so there is no branch to predict.
            let block = N::Rough::pick_whole(key, block, &CHOSEN[which]);
            sites[count..count + ROUGH_LANES].copy_from_slice(&block);
            squares[count..count + ROUGH_LANES].copy_from_slice(&square.pick(&CHOSEN[which]));
            count += usize::from(COUNTS[which]);
        }
        self.found.count = count;
    }

    /// Appends those that are in reach, near ones first, and fills up the last block.
    #[inline(always)]
    fn judge<N: Lanes>(&mut self, key: N::Key, around: SearchContext<'_>, site: u32) {
        let [[near_sure, near_possible], [far_sure, far_possible]] = around.limits;
        let near_sure = N::Rough::splat(key, near_sure);
        let near_possible = N::Rough::splat(key, near_possible);
        let far_sure = N::Rough::splat(key, far_sure);
        let far_possible = N::Rough::splat(key, far_possible);
        let nowhere = around.sites.len() as u32 - 1;
        let Self {
            found, near, far, ..
        } = self;
        found.fill_up(nowhere);
        near.make_room(found.count);
        far.make_room(found.count);
        far.count = 0;
        let start = near.count;
        let sites = found.sites[..found.count].as_chunks().0;
        let squares = found.squares[..found.count].as_chunks().0;
        for (block, squares) in sites.iter().zip(squares) {
            let squares = N::Rough::new(key, squares);
            let mut inner = near_sure.which_above(squares);
            let mut outer = far_sure.which_above(squares);
            let doubt = inner ^ squares.which_not_above(near_possible)
                | outer ^ squares.which_not_above(far_possible);
            // Rounding decides almost never.
            if doubt != 0 {
                [inner, outer] = around.exactly(site, block);
            }
            near.keep::<N>(key, block, inner);
            far.keep::<N>(key, block, outer & !inner);
        }
        let end = near.count + far.count;
        let far = far.sites[..far.count.next_multiple_of(LANES)]
            .as_chunks::<LANES>()
            .0;
        for block in far {
            near.sites[near.count..near.count + LANES].copy_from_slice(block);
            near.count += LANES;
        }
        near.count = end;
        self.pairs += end - start;
        near.fill_up(nowhere);
        for &site in &near.sites[start..near.count] {
            self.is_used[site as usize] = true;
        }
    }

    /// Number of blocks so far.
    pub(super) fn blocks(&self) -> usize {
        self.near.count / LANES
    }

    /// Number of pairs so far.
    pub(super) fn pairs(&self) -> usize {
        self.pairs
    }

    /// The sites of all rows, and whether each site is among them.
    pub(super) fn sites_mut(&mut self) -> (&mut [u32], &mut [bool]) {
        (&mut self.near.sites[..self.near.count], &mut self.is_used)
    }

    /// The rows, and unused memory.
    pub(super) fn into_memory(self) -> Vec<u32> {
        self.near.sites
    }
}

/// Some sites, with the squares of their rough distances.
#[derive(Debug, Default)]
struct FoundSites {
    sites: Vec<u32>,
    squares: Vec<f32>,
    /// Entries from here on are unused.
    count: usize,
}

impl FoundSites {
    /// Makes room for some more, and for a whole block after the last.
    fn make_room(&mut self, more: usize) {
        let needed = self.count + more + ROUGH_LANES;
        if self.sites.len() < needed {
            self.sites.resize(needed.next_power_of_two(), 0);
            self.squares.resize(needed.next_power_of_two(), 0.0);
        }
    }

    /// Fills up the last block.
    #[inline(always)]
    fn fill_up(&mut self, site: u32) {
        self.make_room(ROUGH_LANES);
        self.sites[self.count..self.count + ROUGH_LANES].fill(site);
        self.squares[self.count..self.count + ROUGH_LANES].fill(f32::INFINITY);
        self.count = self.count.next_multiple_of(ROUGH_LANES);
    }
}

/// Some sites.
#[derive(Debug, Default)]
struct SelectedSites {
    /// Entries from `count` on are unused.
    sites: Vec<u32>,
    count: usize,
}

impl SelectedSites {
    /// Makes room for some more, and for a whole block after the last.
    fn make_room(&mut self, more: usize) {
        let needed = self.count + more + ROUGH_LANES;
        if self.sites.len() < needed {
            self.sites.resize(needed.next_power_of_two(), 0);
        }
    }

    /// Fills up the last block.
    #[inline(always)]
    fn fill_up(&mut self, site: u32) {
        self.make_room(LANES);
        self.sites[self.count..self.count + LANES].fill(site);
        self.count = self.count.next_multiple_of(LANES);
    }

    /// Keeps the sites of a block whose bits are set; a block is always written.
    #[inline(always)]
    fn keep<N: Lanes>(&mut self, key: N::Key, block: &[u32; ROUGH_LANES], which: usize) {
        let which = which & (CHOSEN.len() - 1);
        let sites = N::Rough::pick_whole(key, block, &CHOSEN[which]);
        self.sites[self.count..self.count + ROUGH_LANES].copy_from_slice(&sites);
        self.count += usize::from(COUNTS[which]);
    }
}

const fn chosen() -> [[u32; ROUGH_LANES]; 1 << ROUGH_LANES] {
    let mut all = [[0; ROUGH_LANES]; 1 << ROUGH_LANES];
    let mut which = 0;
    while which < all.len() {
        let (mut lane, mut count) = (0, 0);
        while lane < ROUGH_LANES {
            if which >> lane & 1 == 1 {
                all[which][count] = lane as u32;
                count += 1;
            }
            lane += 1;
        }
        which += 1;
    }
    all
}

const fn counts() -> [u8; 1 << ROUGH_LANES] {
    let mut all = [0; 1 << ROUGH_LANES];
    let mut which = 0;
    while which < all.len() {
        all[which] = which.count_ones() as u8;
        which += 1;
    }
    all
}
