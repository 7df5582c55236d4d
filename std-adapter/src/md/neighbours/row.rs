//! The neighbours of one slot.

use super::LANES;
use super::cells::Cells;
use crate::md::lanes::Lanes;
use std::ops::Range;

/// Lanes of each set of lanes, and how many.
static CHOSEN: [([u32; LANES], usize); 1 << LANES] = chosen();

/// Neighbours of one slot; the memory is reused for the next slot.
#[derive(Debug, Default)]
pub(super) struct Row {
    /// Within the cut-off.
    near: Kept,
    /// Beyond it, within the skin.
    far: Kept,
}

impl Row {
    pub(super) fn clear(&mut self) {
        self.near.count = 0;
        self.far.count = 0;
    }

    /// Finds the neighbours of a slot that is not an image: all images in reach, and the atoms after it.
    #[inline(always)]
    pub(super) fn fill<N: Lanes>(
        &mut self,
        key: N::Key,
        cells: &Cells,
        slot: usize,
        reaches_sq: [f64; 2],
        first: usize,
    ) {
        let here = cells.place(slot);
        let place = here.map(|x| N::splat(key, x));
        let limits = reaches_sq.map(|reach_sq| N::splat(key, reach_sq));
        let slots = cells.slots();
        // Rows before the slot matter only for their images.
        if cells.has_image_before(slot) {
            for range in cells.in_reach::<5>(slot, reaches_sq[1], 0) {
                let before = range.start..range.end.min(slot);
                for image in before.filter(|&other| slots[other].is_image) {
                    self.test(key, cells, place, limits, image..image + 1, first);
                }
            }
        }
        for range in cells.in_reach::<5>(slot, reaches_sq[1], 4) {
            let later = range.start.max(slot + 1)..range.end;
            if !later.is_empty() {
                self.test(key, cells, place, limits, later, first);
            }
        }
    }

    /// Keeps the slots of a range that are in reach, testing several distances at once.
    #[inline(always)]
    fn test<N: Lanes>(
        &mut self,
        key: N::Key,
        cells: &Cells,
        place: [N; 3],
        limits: [N; 2],
        range: Range<usize>,
        first: usize,
    ) {
        let full = range.len().next_multiple_of(LANES);
        self.near.make_room(full);
        self.far.make_room(full);
        let mut site = (range.start - first) as u32;
        let [x, y, z] = cells.places().map(|along| {
            along[range.start..range.start + full]
                .as_chunks::<LANES>()
                .0
        });
        let blocks = x.iter().zip(y).zip(z);
        let mut near = self.near.free();
        let mut far = self.far.free();
        let whole = range.len() / LANES;
        for block in blocks.clone().take(whole) {
            let [inner, outer] = below(key, place, block, limits);
            near.keep(site, inner);
            far.keep(site, outer & !inner);
            site += LANES as u32;
        }
        // The last block goes on into the next cell.
        if let Some(block) = blocks.clone().nth(whole) {
            let inside = (1 << (range.len() % LANES)) - 1;
            let [inner, outer] = below(key, place, block, limits).map(|bits| bits & inside);
            near.keep(site, inner);
            far.keep(site, outer & !inner);
        }
        let [near, far] = [near.count, far.count];
        self.near.count += near;
        self.far.count += far;
    }

    /// Number of the neighbours, and their blocks; the last one is padded.
    pub(super) fn blocks(&mut self, nowhere: u32) -> (usize, &[[u32; LANES]]) {
        let Kept { sites: far, count } = &self.far;
        let near = &mut self.near;
        near.make_room(*count + LANES);
        near.sites[near.count..near.count + count].copy_from_slice(&far[..*count]);
        let pairs = near.count + count;
        let full = pairs.next_multiple_of(LANES);
        near.sites[pairs..full].fill(nowhere);
        (pairs, near.sites[..full].as_chunks().0)
    }
}

/// Which slots of a block are nearer than each of the limits.
#[inline(always)]
fn below<N: Lanes>(
    key: N::Key,
    here: [N; 3],
    ((x, y), z): ((&[f64; LANES], &[f64; LANES]), &[f64; LANES]),
    [cutoff_sq, reach_sq]: [N; 2],
) -> [usize; 2] {
    let way = [
        N::new(key, *x) - here[0],
        N::new(key, *y) - here[1],
        N::new(key, *z) - here[2],
    ];
    let r_sq = way[0] * way[0] + way[1] * way[1] + way[2] * way[2];
    [r_sq.which_below(cutoff_sq), r_sq.which_below(reach_sq)]
}

/// Some sites.
#[derive(Debug, Default)]
struct Kept {
    /// Entries from `count` on are unused.
    sites: Vec<u32>,
    count: usize,
}

impl Kept {
    /// Makes room for some more, and for a whole block after the last.
    fn make_room(&mut self, more: usize) {
        let needed = self.count + more + LANES;
        if self.sites.len() < needed {
            self.sites.resize(needed.next_power_of_two(), 0);
        }
    }

    fn free(&mut self) -> Free<'_> {
        Free {
            sites: &mut self.sites[self.count..],
            count: 0,
        }
    }
}

/// Free memory after some sites, and how many more are kept in it.
struct Free<'a> {
    sites: &'a mut [u32],
    count: usize,
}

impl Free<'_> {
    /// Keeps the lanes of a block of sites whose bits are set. A block is always written, so there
    /// is no branch to predict.
    #[inline(always)]
    fn keep(&mut self, site: u32, which: usize) {
        let (lanes, count) = &CHOSEN[which & (CHOSEN.len() - 1)];
        let sites: [u32; LANES] = lanes.map(|lane| site + lane);
        self.sites[self.count..self.count + LANES].copy_from_slice(&sites);
        self.count += *count;
    }
}

const fn chosen() -> [([u32; LANES], usize); 1 << LANES] {
    let mut all = [([0; LANES], 0); 1 << LANES];
    let mut which = 0;
    while which < all.len() {
        let mut lane = 0;
        while lane < LANES {
            if which >> lane & 1 == 1 {
                let (lanes, count) = &mut all[which];
                lanes[*count] = lane as u32;
                *count += 1;
            }
            lane += 1;
        }
        which += 1;
    }
    all
}
