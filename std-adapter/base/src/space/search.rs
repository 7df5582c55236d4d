//! Search for the neighbours of particles that are sorted into cells.

use super::PeriodicBox;
use super::grid::Grid;
use nalgebra::Vector3;
use std::ops::Range;

/// Largest radius, in medians, up to which particles count as alike. The reach of larger ones would cost the many
/// more than it costs the few to search on all sides.
const ALIKE: f64 = 1.5;

/// A particle in its cell.
#[derive(Clone, Copy, Debug)]
pub struct Entry {
    pub position: Vector3<f64>,
    pub radius: f64,
    pub index: u32,
}

/// A search over cells. Of two alike particles the earlier entry searches for the other; else it is the larger one, or
/// that of the higher index.
#[derive(Debug)]
pub struct Search<'a> {
    grid: &'a Grid,
    space: &'a PeriodicBox,
    /// Radius up to which particles are alike, and the largest of these.
    alike: [f64; 2],
    skin: f64,
}

impl<'a> Search<'a> {
    /// For gaps below `skin` between particles with these radii and their median.
    pub fn new(
        grid: &'a Grid,
        space: &'a PeriodicBox,
        radii: &[f64],
        (median, skin): (f64, f64),
    ) -> Self {
        let alike = ALIKE * median;
        let radii = radii.iter().copied().filter(|&radius| radius <= alike);
        Self {
            grid,
            space,
            alike: [alike, radii.fold(0.0, f64::max)],
            skin,
        }
    }

    /// Appends the pairs that a stretch of the entries finds, the lower index first. The entries are sorted
    /// by cell, whose first ones are `starts`. In a sheared box a pair may come twice.
    pub fn around(
        &self,
        stretch: Range<usize>,
        entries: &[Entry],
        starts: &[u32],
        found: &mut Vec<[u32; 2]>,
    ) {
        for (own, entry) in entries
            .iter()
            .enumerate()
            .take(stretch.end)
            .skip(stretch.start)
        {
            let [alike, largest] = self.alike;
            let (reach, first) = if entry.radius <= alike {
                (entry.radius + largest + self.skin, own + 1)
            } else {
                (2.0 * entry.radius + self.skin, 0)
            };
            if reach <= 0.0 {
                continue;
            }
            let place = self.space.wrap(&entry.position);
            for place in self.space.search_origins(place, reach).iter().flatten() {
                self.grid.near(place, reach, |cells| {
                    let from = (starts[*cells.start()] as usize).max(first);
                    let to = starts[cells.end() + 1] as usize;
                    if from < to {
                        self.compare(entry, &entries[from..to], found);
                    }
                });
            }
        }
    }

    /// Appends the pairs of an entry with others.
    #[inline]
    fn compare(&self, entry: &Entry, others: &[Entry], found: &mut Vec<[u32; 2]>) {
        // Each pair is written down and stays only if it is one: few are, and a branch would be a guess.
        let mut count = found.len();
        found.resize(count + others.len(), [0; 2]);
        for other in others {
            let is_mine = if entry.radius <= self.alike[0] {
                other.radius <= self.alike[0]
            } else {
                let is_smaller = other.radius < entry.radius;
                is_smaller | (other.radius == entry.radius && other.index < entry.index)
            };
            if let Some(place) = found.get_mut(count) {
                *place = [entry.index.min(other.index), entry.index.max(other.index)];
            }
            count += usize::from(is_mine & is_near(self.space, entry, other, self.skin));
        }
        found.truncate(count);
    }
}

/// Whether the gap between two particles is below `skin`.
#[inline]
fn is_near(space: &PeriodicBox, a: &Entry, b: &Entry, skin: f64) -> bool {
    let distance = space.displacement(&a.position, &b.position).norm();
    distance - (a.radius + b.radius) < skin
}
