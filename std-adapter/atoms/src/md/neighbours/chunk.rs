//! A part of a Verlet list: its slots, their neighbours, and the pairs.

use super::buckets::Buckets;
use super::candidates::Candidates;
use super::cells::{Cells, Rows};
use super::images::Slot;
use super::row::{RowWriter, SearchContext};
use super::site::{LANES, Site};
use super::window::Window;
use crate::md::blocks::Blocks;
use crate::md::lanes::{LaneLoop, Lanes};
use nalgebra::Vector3;
use std::ops::Range;

/// Owned slots with their neighbours.
///
/// In the row of a slot come first the neighbours that were within the cut-off when the list was built,
/// then those within the skin: most of the last blocks stay beyond the cut-off as a whole, and need no
/// forces.
///
/// ```
/// use nalgebra::{Vector3, Vector4};
/// use tribos::md::neighbours::{Chunk, LANES, Site, VerletList};
/// use tribos::space::PeriodicBox;
/// // Springs of stiffness 1 and no length between all neighbours.
/// fn pull(chunk: &mut Chunk) {
///     let nowhere = chunk.window().len(); // this site fills up the last block of a row
///     let (sites, rows) = chunk.sites_and_rows();
///     let vector = |of: [f64; 4]| Vector3::new(of[0], of[1], of[2]);
///     let way = |a: &Site, b: &Site| vector(b.place) - vector(a.place);
///     for (here, blocks) in rows {
///         let sites_of = |block: &[u32; LANES]| block.map(|site| site as usize);
///         for there in blocks.iter().flat_map(sites_of).filter(|&site| site != nowhere) {
///             let force = way(&sites[here], &sites[there]);
///             for axis in 0..3 {
///                 sites[here].force[axis] += force[axis];
///                 sites[there].force[axis] -= force[axis];
///             }
///         }
///     }
/// }
/// let places = [Vector3::zeros(), Vector3::new(3.0, 4.0, 0.0)];
/// let mut list = VerletList::new(PeriodicBox::OPEN, 6.0, 0.5)?;
/// list.update(&places, &[0, 0])?;
/// let chunk = &mut list.chunks_mut()[0];
/// pull(chunk);
/// assert_eq!(chunk.pairs(), 1);
/// let strengths = chunk.sites().iter().map(|site| Vector4::from(site.force).norm());
/// assert_eq!(strengths.collect::<Vec<_>>(), [5.0, 5.0, 0.0]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, Default)]
pub struct Chunk {
    /// Owned slots and all their neighbours, ordered by cells.
    window: Vec<Slot>,
    /// One site for each slot of the window, and a last one that pads the lanes.
    sites: Vec<Site>,
    /// Range of the owned slots within the window.
    owned: Range<usize>,
    /// First block of `neighbours` of each owned slot, and the end of the last.
    starts: Vec<u32>,
    /// Neighbours in blocks, and unused memory.
    neighbours: Vec<u32>,
    pairs: usize,
    /// Atoms and sites of the slots, sorted by blocks of atoms.
    blocks: Buckets,
    /// What a law of several passes keeps of every block from one to the next.
    pub(crate) kept: Vec<[f64; LANES]>,
    /// Whether it kept something of each block.
    pub(crate) near: Vec<bool>,
}

impl Chunk {
    /// Makes sites for the slots of a window, in place.
    fn lay(
        &mut self,
        cells: &Cells,
        around: &Window,
        owned: usize,
        (positions, species): (&[Vector3<f64>], &[u8]),
    ) {
        let slots = cells.slots();
        self.window.clear();
        let images = slots[around.before.clone()].iter();
        self.window.extend(images.filter(|slot| slot.is_image));
        self.owned = self.window.len()..self.window.len() + owned;
        self.window.extend_from_slice(&slots[around.here.clone()]);
        self.window.extend_from_slice(&slots[around.next.clone()]);
        self.sites.clear();
        let site = |slot: &Slot| {
            let place = slot.place(positions);
            Site {
                place: [
                    place.x,
                    place.y,
                    place.z,
                    species[slot.atom as usize].into(),
                ],
                force: [0.0; 4],
            }
        };
        self.sites.extend(self.window.iter().map(site));
        self.sites.push(Site::NOWHERE);
    }

    /// Keeps the sites that are owned or in a row, and renumbers those of the rows.
    fn keep_used(&mut self, rows: &mut RowWriter) {
        let (sites, is_used) = rows.sites_mut();
        is_used[self.owned.clone()].fill(true);
        // The last site pads the lanes.
        is_used[self.window.len()] = true;
        let count = |number: &mut u32, is_used: &bool| {
            let own = *number;
            *number += u32::from(*is_used);
            Some(own)
        };
        let numbers: Vec<u32> = is_used.iter().scan(0, count).collect();
        for site in sites {
            *site = numbers[*site as usize];
        }
        let start = numbers[self.owned.start] as usize;
        self.owned = start..start + self.owned.len();
        let mut each = is_used.iter();
        self.window.retain(|_| each.next() == Some(&true));
        let mut each = is_used.iter();
        self.sites.retain(|_| each.next() == Some(&true));
    }

    /// Sorts the sites by blocks of atoms.
    fn sort_by_blocks(&mut self, atoms: usize) {
        let blocks = Blocks::new(atoms);
        let slots = self.window.iter().enumerate();
        let entries = slots.map(|(site, slot)| [slot.atom, site as u32]);
        let block = |[atom, _]: [u32; 2]| blocks.of(atom as usize);
        self.blocks
            .sort(entries, atoms.div_ceil(blocks.len()), block);
    }

    /// The atoms of a block that have slots here, with the site of each slot.
    pub(super) fn block(&self, block: usize) -> &[[u32; 2]] {
        self.blocks.get(block)
    }

    /// Copies the positions of the atoms and clears the forces.
    pub(super) fn refresh(&mut self, positions: &[Vector3<f64>]) {
        for (site, slot) in self.sites.iter_mut().zip(&self.window) {
            let place = slot.place(positions);
            site.place[..3].copy_from_slice(place.as_slice());
            site.force = [0.0; 4];
        }
    }

    /// Slots of this chunk and their neighbours; the first [`window`](Self::window)`.len()` sites
    /// belong to them.
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
        let blocks = self.neighbours.as_chunks::<LANES>().0;
        let ends = self.starts.windows(2);
        let rows = self
            .owned
            .clone()
            .zip(ends)
            .map(|(site, ends)| (site, &blocks[ends[0] as usize..ends[1] as usize]));
        (&mut self.sites, rows)
    }

    /// Slots and sites in pairs.
    pub(crate) fn places_mut(&mut self) -> impl Iterator<Item = (&Slot, &mut Site)> {
        self.window.iter().zip(&mut self.sites)
    }
}

/// A new list for a chunk, in its memory.
pub(super) struct Build<'a> {
    pub(super) chunk: &'a mut Chunk,
    pub(super) cells: &'a Cells,
    pub(super) owned: Range<usize>,
    /// The cut-off, and the cut-off plus the skin.
    pub(super) reaches: [f64; 2],
    /// Positions and species of the atoms.
    pub(super) atoms: (&'a [Vector3<f64>], &'a [u8]),
}

impl LaneLoop for Build<'_> {
    type Out = ();

    #[inline(always)]
    fn go<N: Lanes>(self, key: N::Key) {
        let Self { chunk, cells, .. } = self;
        let window = Window::new(cells, self.owned.clone());
        chunk.lay(cells, &window, self.owned.len(), self.atoms);
        chunk.starts.clear();
        chunk.starts.push(0);
        let sites = std::mem::take(&mut chunk.sites);
        let around = SearchContext {
            cells,
            window: &window,
            sites: &sites,
            reaches_sq: self.reaches.map(|reach| reach * reach),
            limits: self.reaches.map(|reach| cells.rough().limits(reach)),
        };
        let mut row = RowWriter::new(std::mem::take(&mut chunk.neighbours), sites.len());
        let mut candidates = Candidates::default();
        let (mut end, mut rows) = (0, Rows::default());
        for slot in self.owned {
            if !cells.slots()[slot].is_image {
                // The first atom of a cell.
                if slot >= end {
                    let cell = cells.cell_of(slot);
                    end = cells.start(cell + 1);
                    rows = cells.rows(cell);
                    candidates.gather(cells, &window, (cell, &rows), sites.len() as u32 - 1);
                }
                row.fill::<N>(key, around, slot, (&rows, &candidates));
            }
            chunk.starts.push(row.blocks() as u32);
        }
        chunk.sites = sites;
        chunk.keep_used(&mut row);
        chunk.pairs = row.pairs();
        chunk.neighbours = row.into_memory();
        chunk.sort_by_blocks(self.atoms.0.len());
    }
}
