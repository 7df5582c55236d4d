//! Verlet lists: all near pairs, each once, valid while atoms move less than the skin allows.

mod batch;
mod buckets;
mod candidates;
mod cells;
mod chunk;
mod images;
mod rough;
mod row;
pub(super) mod site;
#[cfg(test)]
mod tests;
mod window;

#[doc(hidden)]
pub use chunk::Chunk;
#[doc(hidden)]
pub use images::Slot;
#[doc(hidden)]
pub use site::{LANES, Site};

use super::blocks::Blocks;
use super::lanes;
use cells::Cells;
use chunk::Build;
use nalgebra::Vector3;
use rayon::prelude::*;
use tribos_base::space::{AXES, PeriodicBox};

/// Slots that one chunk of the list owns. Chunks, not threads, determine the order of sums.
const SLOTS_PER_CHUNK: usize = 4096;

/// Why a neighbour list cannot be built.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum ListError {
    /// The cut-off or the skin is not a valid length.
    #[error("{what} must be finite and positive, not {given}")]
    Length {
        /// Name of the invalid length: "the cut-off" or "the skin".
        what: &'static str,
        /// The rejected value.
        given: f64,
    },
    /// Two atoms could interact through two images.
    #[error(
        "the cut-off {cutoff} exceeds half the period along {}, {length}: \
         a larger box or a smaller cut-off is needed",
        AXES[*axis]
    )]
    Cutoff {
        /// Axis: 0, 1 or 2 for x, y or z.
        axis: usize,
        /// The cut-off.
        cutoff: f64,
        /// The period.
        length: f64,
    },
    /// Cut-off and skin exceed the period.
    #[error(
        "cut-off and skin together, {reach}, exceed the period along {}, {length}: \
         a smaller skin is needed",
        AXES[*axis]
    )]
    Skin {
        /// Axis: 0, 1 or 2 for x, y or z.
        axis: usize,
        /// Sum of cut-off and skin.
        reach: f64,
        /// The period.
        length: f64,
    },
    /// Atoms are numbered in 32 bits, images included.
    #[error("{given} atoms are more than a list can number")]
    TooMany {
        /// Number of atoms.
        given: usize,
    },
}

/// All pairs closer than cut-off plus skin at the last build, in chunks.
///
/// An atom near the end of a period has an image beyond the other end; a pair is two atoms or an
/// atom and an image, so distances do not depend on the box. Cells order the atoms: neighbours in
/// space are neighbours in memory.
///
/// ```
/// use nalgebra::Vector3;
/// use tribos::md::neighbours::{ListError, VerletList};
/// use tribos::space::PeriodicBox;
/// // A simple cubic crystal of 4 × 4 × 4 atoms has three bonds of length 1 an atom.
/// let place = |k: u8| Vector3::new(k % 4, k / 4 % 4, k / 16).map(f64::from);
/// let mut places: Vec<_> = (0..64).map(place).collect();
/// let space = PeriodicBox::new([Some(4.0); 3])?;
/// let mut list = VerletList::new(space, 1.1, 0.2)?;
/// assert!(list.update(&places, &[0; 64])?); // built
/// assert_eq!(list.chunks_mut().iter().map(|chunk| chunk.pairs()).sum::<usize>(), 3 * 64);
/// // One atom may move by the skin, and the list still holds.
/// places[5].x += 0.9 * list.skin();
/// assert!(!list.update(&places, &[0; 64])?);
/// assert_eq!(list.builds(), 1);
/// assert_eq!(list.reference()[5], place(5)); // where it was when the list was built
/// // A cut-off may reach half the box at most.
/// let refused = VerletList::new(*list.space(), 2.0 * list.cutoff(), 0.2);
/// assert!(matches!(refused, Err(ListError::Cutoff { axis: 0, .. })));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct VerletList {
    space: PeriodicBox,
    cutoff: f64,
    skin: f64,
    chunks: Vec<Chunk>,
    /// Positions of the atoms at the last build.
    reference: Vec<Vector3<f64>>,
    cells: Cells,
    builds: u64,
}

impl VerletList {
    /// An empty list. *Domain*: `cutoff` and `skin` > 0 in the unit of the positions; the cut-off
    /// at most half of every period, cut-off plus skin at most a period.
    pub fn new(space: PeriodicBox, cutoff: f64, skin: f64) -> Result<Self, ListError> {
        for (what, given) in [("the cut-off", cutoff), ("the skin", skin)] {
            if !given.is_finite() || given <= 0.0 {
                return Err(ListError::Length { what, given });
            }
        }
        for (axis, length) in space.lengths().into_iter().enumerate() {
            let Some(length) = length else { continue };
            if cutoff > 0.5 * length {
                return Err(ListError::Cutoff {
                    axis,
                    cutoff,
                    length,
                });
            }
            let reach = cutoff + skin;
            if reach > length {
                return Err(ListError::Skin {
                    axis,
                    reach,
                    length,
                });
            }
        }
        Ok(Self {
            space,
            cutoff,
            skin,
            chunks: Vec::new(),
            reference: Vec::new(),
            cells: Cells::default(),
            builds: 0,
        })
    }

    /// The box.
    pub fn space(&self) -> &PeriodicBox {
        &self.space
    }

    /// Cut-off: pairs farther apart do not interact.
    pub fn cutoff(&self) -> f64 {
        self.cutoff
    }

    /// Skin: the reach of the list beyond the cut-off.
    pub fn skin(&self) -> f64 {
        self.skin
    }

    /// Number of builds so far.
    pub fn builds(&self) -> u64 {
        self.builds
    }

    /// Positions of the atoms at the last build; a checkpoint stores them, since they determine
    /// the order of sums.
    pub fn reference(&self) -> &[Vector3<f64>] {
        &self.reference
    }

    /// The parts of the list.
    pub fn chunks_mut(&mut self) -> &mut [Chunk] {
        &mut self.chunks
    }

    /// Updates the list: rebuilds it if two atoms could have approached by the skin since the
    /// last build, and moves the sites. Returns whether it was rebuilt.
    ///
    /// *Domain*: finite positions, which are not checked.
    pub fn update(
        &mut self,
        positions: &[Vector3<f64>],
        species: &[u8],
    ) -> Result<bool, ListError> {
        let is_stale = self.reference.len() != positions.len() || self.is_stale(positions);
        if is_stale {
            self.build(positions, species)?;
        } else {
            self.refresh(positions);
        }
        Ok(is_stale)
    }

    /// Builds the list for atoms at `positions`.
    pub fn build(&mut self, positions: &[Vector3<f64>], species: &[u8]) -> Result<(), ListError> {
        let reach = self.cutoff + self.skin;
        self.cells.fill(&self.space, positions, reach);
        let (cells, count) = (&self.cells, self.cells.slots().len());
        if u32::try_from(count).is_err() {
            let given = positions.len();
            return Err(ListError::TooMany { given });
        }
        self.chunks
            .resize_with(count.div_ceil(SLOTS_PER_CHUNK), Chunk::default);
        let reaches = [self.cutoff, reach];
        let build = |(index, chunk): (usize, &mut Chunk)| {
            let start = index * SLOTS_PER_CHUNK;
            lanes::run(Build {
                chunk,
                cells,
                owned: start..(start + SLOTS_PER_CHUNK).min(count),
                reaches,
                atoms: (positions, species),
            });
        };
        let chunks = self.chunks.par_iter_mut().with_max_len(1);
        chunks.enumerate().for_each(build);
        self.reference.clear();
        self.reference.extend_from_slice(positions);
        self.builds += 1;
        Ok(())
    }

    /// Adds what the sites of each atom hold, chunk by chunk in the order of the sites.
    pub(crate) fn gather<T: Copy + Send + Sync>(
        &self,
        sums: &mut [T],
        nothing: T,
        add: impl Fn(&mut T, &Site) + Sync,
    ) {
        if rayon::current_num_threads() == 1 {
            // The same sums in the order of memory, which is quicker.
            sums.fill(nothing);
            for chunk in &self.chunks {
                for (slot, site) in chunk.window().iter().zip(chunk.sites()) {
                    add(&mut sums[slot.atom as usize], site);
                }
            }
            return;
        }
        let blocks = Blocks::new(self.reference.len());
        let gather = |(block, sums): (usize, &mut [T])| {
            sums.fill(nothing);
            let first = blocks.entries(block, sums.len()).start;
            for chunk in &self.chunks {
                for &[atom, site] in chunk.block(block) {
                    add(
                        &mut sums[atom as usize - first],
                        &chunk.sites()[site as usize],
                    );
                }
            }
        };
        sums.par_chunks_mut(blocks.len())
            .enumerate()
            .for_each(gather);
    }

    /// Writes the sum of the forces on each atom.
    pub(crate) fn gather_forces(&self, forces: &mut [Vector3<f64>]) {
        self.gather(forces, Vector3::zeros(), |sum, site| {
            let [x, y, z, _] = site.force;
            *sum += Vector3::new(x, y, z);
        });
    }

    /// Moves the sites of the list to the current positions.
    ///
    /// ```
    /// use nalgebra::Vector3;
    /// use tribos::{md::neighbours::VerletList, space::PeriodicBox};
    /// // A run goes on from a checkpoint: the pairs of then, the distances of now.
    /// let then = [Vector3::zeros(), Vector3::x() * 2.7];
    /// let now = [Vector3::zeros(), Vector3::x() * 2.9];
    /// let mut list = VerletList::new(PeriodicBox::OPEN, 2.5, 0.3)?;
    /// list.build(&then, &[0, 0])?;
    /// list.refresh(&now);
    /// let chunk = &list.chunks_mut()[0];
    /// assert_eq!(chunk.pairs(), 1); // a new list would have none
    /// for (slot, site) in chunk.window().iter().zip(chunk.sites()) {
    ///     assert_eq!(site.place[..3], now[slot.atom as usize].as_slice()[..]);
    /// }
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn refresh(&mut self, positions: &[Vector3<f64>]) {
        let chunks = self.chunks.par_iter_mut().with_max_len(1);
        chunks.for_each(|chunk| chunk.refresh(positions));
    }

    /// Whether the two largest displacements since the last build add up to the skin.
    fn is_stale(&self, positions: &[Vector3<f64>]) -> bool {
        let add = |[farthest, second]: [f64; 2], way_sq: f64| {
            if way_sq > second {
                [way_sq.max(farthest), way_sq.min(farthest)]
            } else {
                [farthest, second]
            }
        };
        let block = Blocks::new(positions.len()).len();
        let [farthest, second] = positions
            .par_chunks(block)
            .zip(self.reference.par_chunks(block))
            .map(|(now, then)| {
                let ways = now.iter().zip(then).map(|(now, then)| now - then);
                ways.fold([0.0; 2], |two, way| add(two, way.norm_squared()))
            })
            .reduce(|| [0.0; 2], |a, b| b.into_iter().fold(a, add));
        farthest.sqrt() + second.sqrt() > self.skin
    }
}
