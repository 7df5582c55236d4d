//! A part of a Verlet list: its slots, their neighbours, and the pairs.

use super::cells::Cells;
use super::images::Slot;
use super::row::Row;
use crate::md::lanes::{InLanes, Lanes};
use nalgebra::Vector3;
use std::ops::Range;

/// Number of pairs computed at once. It affects results: sums run lane by lane on every machine,
/// whatever its vector width.
pub const LANES: usize = 4;

/// Coordinate of the site that pads the lanes: far from all others, with a finite square.
const NOWHERE: f64 = 1e100;

/// The data of a slot that the loop over pairs reads and writes, in one cache line and two
/// registers of four numbers.
#[derive(Clone, Copy, Debug)]
#[repr(align(64))]
pub struct Site {
    /// Current position, and the species as a number.
    pub place: [f64; 4],
    /// Force summed so far. The fourth number is the density of embedded atoms summed so far, then
    /// the slope of their embedding energy.
    pub force: [f64; 4],
}

impl Site {
    /// A site out of reach.
    fn nowhere(species: u8) -> Self {
        Self {
            place: [NOWHERE, NOWHERE, NOWHERE, species.into()],
            force: [0.0; 4],
        }
    }

    /// Species.
    #[inline(always)]
    pub fn species(&self) -> usize {
        self.place[3] as usize
    }

    /// Density or slope of an embedded atom.
    #[inline(always)]
    pub(crate) fn density(&self) -> f64 {
        self.force[3]
    }

    #[inline(always)]
    pub(crate) fn density_mut(&mut self) -> &mut f64 {
        &mut self.force[3]
    }
}

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
    neighbours: Vec<[u32; LANES]>,
    pairs: usize,
    /// What a law of several passes keeps of every block from one to the next.
    pub(crate) kept: Vec<[f64; LANES]>,
    /// Whether it kept something of each block.
    pub(crate) near: Vec<bool>,
    /// Number of the site of each slot of the cells around, while the list is built.
    numbers: Vec<u32>,
}

impl Chunk {
    /// Adds a row of `first`-based slots and pads its last block with the slot after the last.
    fn push_row(&mut self, row: &mut Row, nowhere: u32) {
        let (pairs, blocks) = row.blocks(nowhere);
        self.pairs += pairs;
        self.neighbours.extend_from_slice(blocks);
        self.starts.push(self.neighbours.len() as u32);
    }

    /// Makes sites for the slots of `around` that are owned or neighbours, and renumbers the
    /// neighbours.
    fn number(&mut self, around: &[Slot], owned: Range<usize>, species: &[u8]) {
        const UNUSED: u32 = u32::MAX;
        let numbers = &mut self.numbers;
        numbers.clear();
        numbers.resize(around.len() + 1, UNUSED);
        numbers[owned.clone()].fill(0);
        for &slot in self.neighbours.as_flattened() {
            numbers[slot as usize] = 0;
        }
        self.window.clear();
        self.sites.clear();
        for (number, slot) in numbers.iter_mut().zip(around) {
            if *number != UNUSED {
                *number = self.window.len() as u32;
                self.window.push(*slot);
                let species = species[slot.atom as usize];
                self.sites.push(Site::nowhere(species));
            }
        }
        self.sites.push(Site::nowhere(0));
        numbers[around.len()] = self.window.len() as u32;
        for slot in self.neighbours.as_flattened_mut() {
            *slot = numbers[*slot as usize];
        }
        let start = numbers[owned.start] as usize;
        self.owned = start..start + owned.len();
    }

    /// Copies the positions of the atoms and clears the forces.
    pub(super) fn refresh(&mut self, positions: &[Vector3<f64>]) {
        for (site, slot) in self.sites.iter_mut().zip(&self.window) {
            let place = positions[slot.atom as usize] + slot.shift;
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
        let blocks = &self.neighbours;
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
    /// Squares of the cut-off, and of the cut-off plus the skin.
    pub(super) reaches_sq: [f64; 2],
    /// Species of the atoms.
    pub(super) species: &'a [u8],
}

impl InLanes for Build<'_> {
    type Out = ();

    #[inline(always)]
    fn go<N: Lanes>(self, key: N::Key) {
        let Self { chunk, cells, .. } = self;
        let window = cells.window(&self.owned);
        let around = &cells.slots()[window.clone()];
        chunk.pairs = 0;
        chunk.neighbours.clear();
        chunk.starts.clear();
        chunk.starts.push(0);
        let mut row = Row::default();
        for slot in self.owned.clone() {
            row.clear();
            if !cells.slots()[slot].is_image {
                row.fill::<N>(key, cells, slot, self.reaches_sq, window.start);
            }
            chunk.push_row(&mut row, around.len() as u32);
        }
        let owned = self.owned.start - window.start..self.owned.end - window.start;
        chunk.number(around, owned, self.species);
    }
}
