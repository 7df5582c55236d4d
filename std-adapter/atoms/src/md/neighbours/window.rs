//! The slots of a chunk and around it, and the numbers of their sites.

use super::cells::Cells;
use std::ops::Range;

/// Three ranges of slots in ascending order. Sites are numbered in the same order, so a site's number follows
/// from its slot.
#[derive(Clone, Debug, Default)]
pub(super) struct Window {
    /// Slots before the owned ones, of which only the images matter.
    pub(super) before: Range<usize>,
    /// Number of images before `before`.
    images: usize,
    /// The owned slots and those after them in this layer of cells.
    pub(super) here: Range<usize>,
    /// Slots of the next layer.
    pub(super) next: Range<usize>,
    /// Slot that would have site 0 if `here` went back that far, modulo 2⁶⁴; the same for `next`.
    zeros: [usize; 2],
}

impl Window {
    /// The owned slots and all cells around the atoms among them.
    pub(super) fn new(cells: &Cells, owned: Range<usize>) -> Self {
        let is_atom = |slot: &usize| !cells.slots()[*slot].is_image;
        let first = owned.clone().find(is_atom);
        let last = owned.clone().rfind(is_atom);
        let mut window = Self {
            before: owned.start..owned.start,
            here: owned.clone(),
            next: owned.end..owned.end,
            ..Self::default()
        };
        if let (Some(first), Some(last)) = (first, last) {
            // Rows are numbered along y within three layers along z; the own one is 4.
            window.before.start = cells.row(first, 0).start.min(owned.start);
            window.here.end = cells.row(last, 5).end.max(owned.end);
            window.next.start = cells.row(first, 6).start.max(window.here.end);
            window.next.end = cells.row(last, 8).end.max(window.next.start);
        }
        window.images = cells.images_before(window.before.start);
        let before = cells.images_before(owned.start) - window.images;
        let here = window.here.start.wrapping_sub(before);
        let next = window.next.start.wrapping_sub(before + window.here.len());
        window.zeros = [here, next];
        window
    }

    /// Number of the site of an image in `before`.
    pub(super) fn site_of_image(&self, cells: &Cells, slot: usize) -> u32 {
        (cells.images_before(slot) - self.images) as u32
    }

    /// Number of the site of any other slot.
    #[inline(always)]
    pub(super) fn site(&self, slot: usize) -> u32 {
        let [here, next] = self.zeros;
        let zero = if slot < self.here.end { here } else { next };
        slot.wrapping_sub(zero) as u32
    }
}
