//! Atoms and their images behind the ends of the periods.

use crate::space::PeriodicBox;
use nalgebra::Vector3;

/// An atom or one of its images.
#[derive(Clone, Copy, Debug)]
pub struct Slot {
    /// The atom.
    pub atom: u32,
    /// False for the atom itself.
    pub is_image: bool,
    /// From the atom's place to this one's: whole periods.
    pub shift: Vector3<f64>,
}

/// The atoms, each moved into the cell, and those of their images that a pair needs.
///
/// Of two opposite images one suffices, since (i, j + L) and (i − L, j) are the same pair: the one
/// whose last shifted axis is shifted upwards.
pub fn slots(space: &PeriodicBox, positions: &[Vector3<f64>], reach: f64) -> Vec<Slot> {
    let lengths = space.lengths();
    let mut slots = Vec::with_capacity(2 * positions.len());
    for (atom, place) in positions.iter().enumerate() {
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
    slots
}

/// Shifts that keep a coordinate within `reach` of the cell: none, and up to two of a period.
fn shifts(x: f64, length: Option<f64>, reach: f64) -> impl Iterator<Item = f64> + Clone {
    let up = length.filter(|_| x <= reach);
    let down = length.filter(|length| x >= length - reach).map(|l| -l);
    [Some(0.0), up, down].into_iter().flatten()
}
