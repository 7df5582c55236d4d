//! Numbers of the spheres of large deposits.
//!
//! A deposit is numbered as it fell. The wider its base, the farther apart in memory are the two spheres of
//! a contact, and the more contacts join two of the blocks that the sweeps of contact dynamics share among
//! threads. Along the curve of Morton (1966), which visits a cube's eighths one after the other, near spheres
//! have near numbers.

use super::Deposit;
use nalgebra::Vector3;

/// Spheres from which a run numbers a deposit along the curve: their bodies, 64 bytes each, fill a
/// megabyte, the size of a core's own cache.
const LARGE: usize = 16_384;

/// Largest coordinate of the curve.
const MOST: f64 = ((1 << BITS) - 1) as f64;
/// Bits of a coordinate.
const BITS: u32 = 21;

impl Deposit {
    /// The deposit as a run takes it: a large one has its spheres sorted along the curve. Parents may then
    /// have a larger number than the spheres that they hold.
    pub(in crate::powder) fn numbered_for_run(self) -> Self {
        if self.positions.len() < LARGE {
            self
        } else {
            self.along_curve()
        }
    }

    /// The spheres in the order of the curve; those with the same key keep their order.
    #[doc(hidden)]
    #[must_use]
    pub fn along_curve(self) -> Self {
        let cell = self.radii.iter().copied().fold(0.0, f64::max) * 2.0;
        let mut keys: Vec<(u64, u32)> = self
            .positions
            .iter()
            .map(|x| key(x, cell))
            .zip(0..)
            .collect();
        keys.sort_unstable();
        let mut new = vec![0; keys.len()];
        for (number, (_, old)) in (0..).zip(&keys) {
            new[*old as usize] = number;
        }
        let old = || keys.iter().map(|(_, old)| *old as usize);
        let parent = |old: usize| self.parents[old].map(|parent| new[parent as usize]);
        Self {
            positions: old().map(|old| self.positions[old]).collect(),
            radii: old().map(|old| self.radii[old]).collect(),
            parents: old().map(parent).collect(),
            ..self
        }
    }
}

/// Position on the curve, with the coordinates counted in cells; those below zero count as zero.
fn key(place: &Vector3<f64>, cell: f64) -> u64 {
    let parts = place.iter().zip(0..);
    parts.fold(0, |key, (x, axis)| {
        let count = (x / cell).clamp(0.0, MOST) as u64;
        let bits = (0..BITS).map(|bit| (count >> bit & 1) << (3 * bit + axis));
        key | bits.sum::<u64>()
    })
}

#[cfg(test)]
mod tests {
    use super::{LARGE, key};
    use crate::packing::PlacementError;
    use crate::powder::deposit::{Ballistic, Deposit, DepositTarget};
    use nalgebra::Vector3;

    /// Share of the parents in another thousand of numbers, and heights of all with their parents'.
    fn describe(deposit: &Deposit) -> (f64, Vec<(u64, Option<u64>)>) {
        let pairs = (0_u32..).zip(&deposit.parents);
        let held: Vec<_> = pairs
            .filter_map(|(i, parent)| Some((i, (*parent)?)))
            .collect();
        let apart = held.iter().filter(|(i, parent)| i / 1000 != parent / 1000);
        let height = |i: u32| deposit.positions[i as usize].z.to_bits();
        let spheres = (0_u32..).zip(&deposit.parents);
        let mut heights: Vec<_> = spheres
            .map(|(i, parent)| (height(i), parent.map(height)))
            .collect();
        heights.sort_unstable();
        (apart.count() as f64 / held.len() as f64, heights)
    }

    #[test]
    fn large_deposits_number_spheres_that_touch_closely_and_keep_their_parents()
    -> Result<(), PlacementError> {
        let grown = Ballistic::new(150.0, 1.0, 3.0)?.grow(DepositTarget::Count(LARGE), 3)?;
        let (apart, heights) = describe(&grown);
        let (sorted_apart, sorted_heights) = describe(&grown.clone().numbered_for_run());
        assert!(sorted_apart < 0.5 * apart, "{sorted_apart} {apart}");
        assert_eq!(sorted_heights, heights);
        Ok(())
    }

    #[test]
    fn small_deposits_keep_the_order_of_arrival() -> Result<(), PlacementError> {
        let grown = Ballistic::new(60.0, 1.0, 3.0)?.grow(DepositTarget::Count(LARGE - 1), 3)?;
        assert_eq!(grown.clone().numbered_for_run(), grown);
        Ok(())
    }

    #[test]
    fn the_curve_visits_the_eighths_of_a_cube_in_turn() {
        let at = |x, y, z| key(&Vector3::new(x, y, z), 2.0);
        let eighth = [at(0.1, 1.9, -3.0), at(2.0, 0.0, 0.0), at(0.0, 2.0, 0.0)];
        assert_eq!(eighth, [0, 1, 2]);
        assert_eq!([at(3.9, 3.9, 3.9), at(4.0, 0.0, 0.0)], [7, 8]);
        assert_eq!(at(1e300, 1e300, 1e300), (1 << 63) - 1);
    }
}
