//! Atoms and their periodic images.

use nalgebra::Vector3;
use std::ops::Range;
use tribos_base::space::PeriodicBox;

/// An atom or one of its images.
///
/// ```
/// use nalgebra::Vector3;
/// use tribos::md::neighbours::{Slot, VerletList};
/// use tribos::space::PeriodicBox;
/// // Two atoms 1 apart over the end of a period of 4: the left one stands at 4.5 too.
/// let places = [Vector3::x() * 0.5, Vector3::x() * 3.5];
/// let space = PeriodicBox::new([Some(4.0), None, None])?;
/// let mut list = VerletList::new(space, 1.5, 0.3)?;
/// list.update(&places, &[0, 0])?;
/// let seen = list.chunks_mut()[0].window();
/// let images: Vec<&Slot> = seen.iter().filter(|slot| slot.is_image).collect();
/// assert_eq!(images.len(), 1);
/// assert_eq!((images[0].atom, images[0].shift), (0, Vector3::x() * 4.0));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Slot {
    /// The atom.
    pub atom: u32,
    /// False for the atom itself.
    pub is_image: bool,
    /// Displacement of the image from the atom, in whole periods.
    pub shift: Vector3<f64>,
}

impl Slot {
    /// No atom's.
    pub(super) const NOWHERE: Self = Self {
        atom: u32::MAX,
        is_image: false,
        shift: Vector3::new(0.0, 0.0, 0.0),
    };

    /// Its place, while the atoms are at `positions`.
    #[inline(always)]
    pub(super) fn place(&self, positions: &[Vector3<f64>]) -> Vector3<f64> {
        positions[self.atom as usize] + self.shift
    }
}

/// Some atoms, each wrapped into the cell, and the images that pairs need.
///
/// Of two opposite images one suffices, since (i, j + L) and (i − L, j) are the same pair: the one
/// whose last shifted axis is shifted upwards.
pub fn fill_slots(
    slots: &mut Vec<Slot>,
    space: &PeriodicBox,
    positions: &[Vector3<f64>],
    atoms: Range<usize>,
    reach: f64,
) {
    let lengths = space.lengths();
    slots.clear();
    for (atom, place) in atoms.clone().zip(&positions[atoms]) {
        let inside = space.wrap(place);
        let home = inside - place;
        for z in shifts(inside.z, lengths[2], reach) {
            for y in shifts(inside.y, lengths[1], reach) {
                for x in shifts(inside.x, lengths[0], reach) {
                    let last = [z, y, x].into_iter().find(|&shift| shift != 0.0);
                    if last.is_none_or(|shift| shift > 0.0) {
                        slots.push(Slot {
                            atom: atom as u32,
                            is_image: last.is_some(),
                            shift: home + Vector3::new(x, y, z),
                        });
                    }
                }
            }
        }
    }
}

/// Shifts that keep a coordinate within `reach` of the cell: zero, and up to two by a period.
fn shifts(x: f64, length: Option<f64>, reach: f64) -> impl Iterator<Item = f64> + Clone {
    let up = length.filter(|_| x <= reach);
    let down = length.filter(|length| x >= length - reach).map(|l| -l);
    [Some(0.0), up, down].into_iter().flatten()
}
