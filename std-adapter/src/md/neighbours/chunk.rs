//! A part of a Verlet list: its slots, their neighbours, and the pairs.

use super::cells::Cells;
use super::images::Slot;
use nalgebra::Vector3;
use std::ops::Range;

/// Number of pairs computed at once. It affects results: sums run lane by lane on every machine,
/// whatever its vector width.
pub const LANES: usize = 4;

/// Number of distances tested at once when a list is built.
const ABREAST: usize = 8;

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
#[derive(Clone, Debug)]
pub struct Chunk {
    /// Owned slots and all slots within reach of them, ordered by cells.
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
}

impl Chunk {
    /// The pairs of `owned` slots nearer than the root of `reach_sq`.
    pub(super) fn build(cells: &Cells, owned: Range<usize>, reach_sq: f64, species: &[u8]) -> Self {
        let window = cells.window(&owned);
        let slots = cells.slots()[window.clone()].to_vec();
        let blank = Site {
            place: [NOWHERE, NOWHERE, NOWHERE, 0.0],
            force: [0.0; 4],
        };
        let mut sites = vec![blank; slots.len() + 1];
        for (site, slot) in sites.iter_mut().zip(&slots) {
            site.place[3] = species[slot.atom as usize].into();
        }
        let mut chunk = Self {
            sites,
            owned: owned.start - window.start..owned.end - window.start,
            starts: vec![0],
            neighbours: Vec::new(),
            pairs: 0,
            kept: Vec::new(),
            window: slots,
        };
        let mut row = Row::default();
        for slot in owned {
            row.count = 0;
            if !cells.slots()[slot].is_image {
                row.fill(cells, slot, reach_sq, window.start);
            }
            chunk.push_row(&mut row);
        }
        chunk
    }

    /// Adds a row and pads its last block with the distant site.
    fn push_row(&mut self, row: &mut Row) {
        self.pairs += row.count;
        let nowhere = self.window.len() as u32;
        let full = row.count.next_multiple_of(LANES);
        row.make_room(LANES);
        row.sites[row.count..full].fill(nowhere);
        self.neighbours
            .extend_from_slice(row.sites[..full].as_chunks().0);
        self.starts.push(self.neighbours.len() as u32);
    }

    /// Copies the positions of the atoms and clears the forces.
    pub(super) fn refresh(&mut self, positions: &[Vector3<f64>]) {
        for (site, slot) in self.sites.iter_mut().zip(&self.window) {
            let place = positions[slot.atom as usize] + slot.shift;
            site.place[..3].copy_from_slice(place.as_slice());
            site.force = [0.0; 4];
        }
    }

    /// Slots of this chunk and within its reach; the first [`window`](Self::window)`.len()` sites
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

/// Neighbours of one slot; the memory is reused for the next slot.
#[derive(Debug, Default)]
struct Row {
    /// Sites; entries from `count` on are unused.
    sites: Vec<u32>,
    count: usize,
}

impl Row {
    /// Finds the neighbours of a slot that is not an image: all images in reach, and the atoms after it.
    fn fill(&mut self, cells: &Cells, slot: usize, reach_sq: f64, first: usize) {
        let place = cells.place(slot);
        for range in cells.in_reach(slot, reach_sq) {
            // Rows before the slot matter only for their images.
            let before = range.start..range.end.min(slot);
            if !before.is_empty() && cells.has_image(&before) {
                for other in before.filter(|&other| cells.slots()[other].is_image) {
                    let [way_sq] = ways_sq(cells.place(other).map(|along| [along]), place);
                    self.make_room(1);
                    self.keep(other - first, way_sq < reach_sq);
                }
            }
            let later = range.start.max(slot + 1)..range.end;
            if !later.is_empty() {
                self.test(cells.places(), place, reach_sq, later, first);
            }
        }
    }

    /// Keeps the slots of `later` that are in reach, testing several distances at once.
    fn test(
        &mut self,
        places: [&[f64]; 3],
        place: [f64; 3],
        reach_sq: f64,
        later: Range<usize>,
        first: usize,
    ) {
        self.make_room(later.len());
        let mut site = later.start - first;
        let [x, y, z] = places.map(|along| along[later.clone()].as_chunks::<ABREAST>());
        for ((x, y), z) in x.0.iter().zip(y.0).zip(z.0) {
            for way_sq in ways_sq([*x, *y, *z], place) {
                self.keep(site, way_sq < reach_sq);
                site += 1;
            }
        }
        for ((x, y), z) in x.1.iter().zip(y.1).zip(z.1) {
            let [way_sq] = ways_sq([[*x], [*y], [*z]], place);
            self.keep(site, way_sq < reach_sq);
            site += 1;
        }
    }

    fn make_room(&mut self, more: usize) {
        let needed = self.count + more;
        if self.sites.len() < needed {
            self.sites.resize(needed.next_power_of_two(), 0);
        }
    }

    /// Always written, kept if near, so there is no branch to predict.
    #[inline(always)]
    fn keep(&mut self, site: usize, is_near: bool) {
        self.sites[self.count] = site as u32;
        self.count += usize::from(is_near);
    }
}

/// Squared distances from `place` to some others.
#[inline(always)]
fn ways_sq<const N: usize>(there: [[f64; N]; 3], place: [f64; 3]) -> [f64; N] {
    std::array::from_fn(|lane| {
        let [x, y, z]: [f64; 3] = std::array::from_fn(|axis| there[axis][lane] - place[axis]);
        x * x + y * y + z * z
    })
}
