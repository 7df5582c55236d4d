//! Pairs of nearby spheres, found by linked cells.

use super::grid::Grid;
use super::search::{Entry, Search};
use super::{AXES, PeriodicBox};
use nalgebra::Vector3;
use rayon::prelude::*;

/// Why a box or a search for neighbours in it is refused.
///
/// ```
/// use nalgebra::Vector3;
/// use tribos::space::{PeriodicBox, SpaceError, pairs::neighbours};
/// // Spheres of radius 1 in a period of 3 would touch each other from both sides.
/// let space = PeriodicBox::new([Some(3.0), None, None])?;
/// let found = neighbours(&space, &[Vector3::zeros(), Vector3::x()], &[1.0; 2], 0.0);
/// assert_eq!(found, Err(SpaceError::Reach { axis: 0, reach: 2.0, length: 3.0 }));
/// let flat = PeriodicBox::new([Some(1.0), Some(0.0), None]);
/// assert_eq!(flat, Err(SpaceError::Period { axis: 1, given: 0.0 }));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum SpaceError {
    /// A length cannot be a period.
    #[error("the period along {} must be finite and positive, not {given}", AXES[*axis])]
    Period {
        /// Axis: 0, 1 or 2 for x, y or z.
        axis: usize,
        /// The rejected value.
        given: f64,
    },
    /// The numbers of radii and positions differ.
    #[error("{positions} positions need as many radii, not {radii}")]
    Lengths {
        /// Number of positions.
        positions: usize,
        /// Number of radii.
        radii: usize,
    },
    /// Particles are numbered in 32 bits.
    #[error(
        "{given} particles are more than the {} that pairs can number",
        u32::MAX
    )]
    TooMany {
        /// Number of particles.
        given: usize,
    },
    /// A position is not finite.
    #[error("particle {particle}: {} is {given}, not finite", AXES[*axis])]
    Position {
        /// Index of the particle.
        particle: usize,
        /// Axis: 0, 1 or 2 for x, y or z.
        axis: usize,
        /// The rejected coordinate.
        given: f64,
    },
    /// A radius is negative, infinite or NaN.
    #[error("particle {particle}: the radius must be finite and not negative, not {given}")]
    Radius {
        /// Index of the particle.
        particle: usize,
        /// The rejected value.
        given: f64,
    },
    /// The largest gap is infinite or NaN.
    #[error("the largest gap of neighbours must be finite, not {given}")]
    Skin {
        /// The rejected value.
        given: f64,
    },
    /// Two particles could be neighbours over more than one image.
    #[error(
        "the largest distance of neighbours, {reach}, exceeds half the period along {}, {length}; \
         a larger box or a smaller skin is needed",
        AXES[*axis]
    )]
    Reach {
        /// Axis: 0, 1 or 2 for x, y or z.
        axis: usize,
        /// Sum of the two largest radii and the skin.
        reach: f64,
        /// The period.
        length: f64,
    },
}

/// Buffers of a search, reused by the next one.
///
/// ```
/// use nalgebra::Vector3;
/// use tribos::space::{PeriodicBox, pairs::Cells};
/// let mut cells = Cells::default();
/// // Two spheres of radius 1 come together; neighbours are those less than 0.5 apart.
/// for (distance, pairs) in [(3.0, 0), (2.4, 1), (1.9, 1)] {
///     let positions = [Vector3::zeros(), Vector3::x() * distance];
///     let found = cells.find(&PeriodicBox::OPEN, &positions, &[1.0; 2], 0.5)?;
///     assert_eq!(found.len(), pairs);
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, Default)]
pub struct Cells {
    /// Cell of each particle.
    cell_of: Vec<usize>,
    /// First entry of each cell in `entries`, and the end of the last.
    starts: Vec<u32>,
    /// The particles, cell by cell.
    entries: Vec<Entry>,
    /// Sorted radii, for the median.
    radii: Vec<f64>,
    /// Pairs as they are found, by stretches of entries.
    found: Vec<Vec<[u32; 2]>>,
    /// First pair of each particle in `pairs`, and the end of the last.
    ends: Vec<usize>,
    pairs: Vec<[u32; 2]>,
}

/// Entries whose neighbours one thread searches at a time.
const STRETCH: usize = 8192;
/// The same where pairs are not kept: as many as fill a few megabytes at some hundred neighbours each.
const PART: usize = 1024;
/// Parts with one sum.
const TOGETHER: usize = 16;

/// All pairs i < j with |xⱼ − xᵢ| − rᵢ − rⱼ < `skin`, in ascending order of (i, j); distances are
/// those of [`PeriodicBox::displacement`].
///
/// *Domain*: finite positions, inside the cell or not; radii finite and ≥ 0; `skin` finite, negative
/// for overlapping pairs only; two largest radii and the skin at most half of every period. *Cost*:
/// proportional to particles and pairs for evenly spread positions; spheres larger than 1.5 medians
/// search for smaller ones within their own diameter plus the skin, so a few large spheres among many small
/// ones are cheap. Large searches are shared among rayon's threads. Far outliers along an open axis make cells
/// coarse and the search slower. For a time loop keep a [`Cells`] instead.
///
/// ```
/// use nalgebra::Vector3;
/// use tribos::space::{PeriodicBox, pairs::neighbours};
/// let space = PeriodicBox::new([Some(10.0), None, None])?;
/// let positions = [Vector3::new(0.5, 0.0, 0.0), Vector3::new(9.0, 0.0, 0.0)];
/// assert_eq!(neighbours(&space, &positions, &[1.0, 1.0], 0.0)?, [[0, 1]]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn neighbours(
    space: &PeriodicBox,
    positions: &[Vector3<f64>],
    radii: &[f64],
    skin: f64,
) -> Result<Vec<[u32; 2]>, SpaceError> {
    let mut cells = Cells::default();
    cells.find(space, positions, radii, skin)?;
    Ok(cells.pairs)
}

impl Cells {
    /// The pairs of [`neighbours`], without new memory once the buffers have grown.
    pub fn find(
        &mut self,
        space: &PeriodicBox,
        positions: &[Vector3<f64>],
        radii: &[f64],
        skin: f64,
    ) -> Result<&[[u32; 2]], SpaceError> {
        self.pairs.clear();
        let (grid, median) = self.prepare(space, positions, radii, skin)?;
        self.search(&Search::new(&grid, space, radii, (median, skin)));
        self.order(positions.len());
        if space.offset() != 0.0 {
            self.pairs.dedup();
        }
        Ok(&self.pairs)
    }

    /// Sums of what `see` adds up over the pairs of [`neighbours`], some thousand particles' at a time: for searches so
    /// wide that all pairs are too many to keep. The sums start from zeros, and should be of whole numbers, whose sum
    /// is the same in any order.
    #[doc(hidden)]
    pub fn sums(
        &mut self,
        space: &PeriodicBox,
        positions: &[Vector3<f64>],
        radii: &[f64],
        (skin, zeros): (f64, &[f64]),
        see: impl Fn(&[[u32; 2]], &mut [f64]) + Sync,
    ) -> Result<Vec<f64>, SpaceError> {
        let (grid, median) = self.prepare(space, positions, radii, skin)?;
        let search = Search::new(&grid, space, radii, (median, skin));
        let (entries, starts) = (&self.entries[..], &self.starts[..]);
        let parts = (0..entries.len()).into_par_iter().step_by(PART);
        let part = |mut sums: Vec<f64>, first: usize| {
            let found = &mut Vec::new();
            let last = entries.len().min(first + PART);
            search.around(first..last, entries, starts, found);
            if space.offset() != 0.0 {
                // Images of one particle may find another twice.
                found.sort_unstable();
                found.dedup();
            }
            see(found, &mut sums);
            sums
        };
        let both = |mut sums: Vec<f64>, others: Vec<f64>| {
            let pairs = sums.iter_mut().zip(others);
            pairs.for_each(|(sum, other)| *sum += other);
            sums
        };
        let zeros = || zeros.to_vec();
        let folded = parts.with_min_len(TOGETHER).fold(zeros, part);
        Ok(folded.reduce(zeros, both))
    }

    /// Checks, and sorts the particles into cells; returns these, and the median radius.
    fn prepare(
        &mut self,
        space: &PeriodicBox,
        positions: &[Vector3<f64>],
        radii: &[f64],
        skin: f64,
    ) -> Result<(Grid, f64), SpaceError> {
        check(positions, radii, skin)?;
        check_reach(space, radii, skin)?;
        // A sheared border is crossed by images of the searching sphere instead of by the grid.
        let cut = if space.offset() != 0.0 {
            space.open_upwards()
        } else {
            *space
        };
        let median = self.median(radii);
        let grid = Grid::new(&cut, positions, 2.0 * median + skin);
        self.sort_into(&grid, space, positions, radii);
        Ok((grid, median))
    }

    /// Median radius, 0 of none.
    fn median(&mut self, radii: &[f64]) -> f64 {
        self.radii.clear();
        self.radii.extend_from_slice(radii);
        let middle = radii.len() / 2;
        if radii.is_empty() {
            0.0
        } else {
            *self.radii.select_nth_unstable_by(middle, f64::total_cmp).1
        }
    }

    /// Counting sort of the particles by cell; within one by index.
    fn sort_into(
        &mut self,
        grid: &Grid,
        space: &PeriodicBox,
        positions: &[Vector3<f64>],
        radii: &[f64],
    ) {
        self.cell_of.clear();
        self.cell_of
            .extend(positions.iter().map(|place| grid.cell(&space.wrap(place))));
        // Ends of the cells, lowered to their starts as the particles go in from the last.
        self.starts.clear();
        self.starts.resize(grid.cells() + 1, 0);
        for &cell in &self.cell_of {
            self.starts[cell] += 1;
        }
        let mut end = 0;
        for start in &mut self.starts {
            end += *start;
            *start = end;
        }
        let blank = Entry {
            position: Vector3::zeros(),
            radius: 0.0,
            index: 0,
        };
        self.entries.clear();
        self.entries.resize(positions.len(), blank);
        for (index, &cell) in self.cell_of.iter().enumerate().rev() {
            self.starts[cell] -= 1;
            self.entries[self.starts[cell] as usize] = Entry {
                position: positions[index],
                radius: radii[index],
                index: index as u32,
            };
        }
    }

    /// Searches around all entries, stretch by stretch.
    fn search(&mut self, search: &Search<'_>) {
        let (entries, starts) = (&self.entries[..], &self.starts[..]);
        let stretches = entries.len().div_ceil(STRETCH);
        self.found.resize_with(stretches, Vec::new);
        let search = |(stretch, found): (usize, &mut Vec<[u32; 2]>)| {
            found.clear();
            let first = stretch * STRETCH;
            let last = entries.len().min(first + STRETCH);
            search.around(first..last, entries, starts, found);
        };
        if stretches > 1 && rayon::current_num_threads() > 1 {
            self.found.par_iter_mut().enumerate().for_each(search);
        } else {
            self.found.iter_mut().enumerate().for_each(search);
        }
    }

    /// Counting sort of the pairs: they were found in the order of space, and come out in that of particles.
    fn order(&mut self, particles: usize) {
        let found = || self.found.iter().flatten();
        self.ends.clear();
        self.ends.resize(particles + 1, 0);
        for [low, _] in found() {
            self.ends[*low as usize] += 1;
        }
        let mut end = 0;
        for list in &mut self.ends {
            end += *list;
            *list = end;
        }
        // Ends become starts as the pairs go in.
        self.pairs.resize(end, [0; 2]);
        for pair in self.found.iter().flatten() {
            let place = &mut self.ends[pair[0] as usize];
            *place -= 1;
            self.pairs[*place] = *pair;
        }
        for bounds in self.ends.windows(2) {
            self.pairs[bounds[0]..bounds[1]].sort_unstable();
        }
    }
}

/// Refuses positions, radii and skins that are not finite.
fn check(positions: &[Vector3<f64>], radii: &[f64], skin: f64) -> Result<(), SpaceError> {
    if positions.len() != radii.len() {
        return Err(SpaceError::Lengths {
            positions: positions.len(),
            radii: radii.len(),
        });
    }
    if u32::try_from(positions.len()).is_err() {
        return Err(SpaceError::TooMany {
            given: positions.len(),
        });
    }
    if !skin.is_finite() {
        return Err(SpaceError::Skin { given: skin });
    }
    for (particle, (place, &radius)) in positions.iter().zip(radii).enumerate() {
        if let Some(axis) = (0..3).find(|&axis| !place[axis].is_finite()) {
            return Err(SpaceError::Position {
                particle,
                axis,
                given: place[axis],
            });
        }
        if !radius.is_finite() || radius < 0.0 {
            return Err(SpaceError::Radius {
                particle,
                given: radius,
            });
        }
    }
    Ok(())
}

/// Refuses boxes so small that a pair could meet through two images.
fn check_reach(space: &PeriodicBox, radii: &[f64], skin: f64) -> Result<(), SpaceError> {
    if radii.len() < 2 {
        return Ok(());
    }
    // The two largest radii.
    let [most, next] = radii.iter().fold([0.0_f64; 2], |[most, next], &radius| {
        [most.max(radius), next.max(most.min(radius))]
    });
    let reach = most + next + skin;
    for (axis, length) in space.lengths().into_iter().enumerate() {
        if let Some(length) = length
            && reach > 0.5 * length
        {
            return Err(SpaceError::Reach {
                axis,
                reach,
                length,
            });
        }
    }
    Ok(())
}
