//! Positions in single precision, for a first test of distances.

use nalgebra::Vector3;

/// Positions relative to the middle of all, over the reach of the list: one array an axis.
#[derive(Clone, Debug, Default)]
pub(super) struct SinglePrecisionPositions {
    along: [Vec<f32>; 3],
    middle: Vector3<f64>,
    inv_reach: f64,
    /// Squares of rough distances in reach are not above this.
    limit: f32,
}

/// Tolerance of a rough distance relative to the sum of the farthest coordinate and the reach. Two positions
/// and their difference are rounded by 2⁻²⁴ each, along three axes: less than 2√3 2⁻²⁴ of that sum.
const DOUBT: f64 = 1.0 / 2_097_152.0;

/// Tolerance of the square of a distance relative to it: above its five roundings of 2⁻²⁴.
const DOUBT_OF_SQUARE: f64 = 1.0 / 1_048_576.0;

impl SinglePrecisionPositions {
    /// Fits the unit to the positions and the reach.
    pub(super) fn fit(&mut self, extent: [[f64; 2]; 3], reach: f64) {
        self.inv_reach = 1.0 / reach;
        self.middle = Vector3::from(extent.map(|[low, high]| 0.5 * low + 0.5 * high));
        let half = extent.map(|[low, high]| (0.5 * high - 0.5 * low) * self.inv_reach);
        let farthest = half.into_iter().fold(1.0, f64::max);
        let reach = 1.0 + DOUBT * (farthest + 1.0);
        self.limit = (reach * reach * (1.0 + DOUBT_OF_SQUARE)) as f32;
    }

    /// Makes room for some slots.
    pub(super) fn resize(&mut self, slots: usize) {
        for along in &mut self.along {
            along.resize(slots, 0.0);
        }
    }

    /// Sets the position of a slot.
    pub(super) fn set(&mut self, slot: usize, place: &Vector3<f64>) {
        let place = (place - self.middle) * self.inv_reach;
        for (along, x) in self.along.iter_mut().zip(place.iter()) {
            along[slot] = *x as f32;
        }
    }

    /// Positions along x, y and z.
    #[inline(always)]
    pub(super) fn along(&self) -> [&[f32]; 3] {
        let [x, y, z] = &self.along;
        [x, y, z]
    }

    /// Largest square of a rough distance of slots in reach.
    #[inline(always)]
    pub(super) fn limit(&self) -> f32 {
        self.limit
    }
}
