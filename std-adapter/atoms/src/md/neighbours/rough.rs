//! Positions in single precision, for a first test of distances.

use nalgebra::Vector3;

/// Positions relative to the middle of all, over the reach of the list: one array an axis.
#[derive(Clone, Debug, Default)]
pub(super) struct SinglePrecisionPositions {
    along: [Vec<f32>; 3],
    unit: RoughUnit,
    /// Tolerance of rough distances.
    doubt: f64,
}

/// What rough positions are measured from and in.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct RoughUnit {
    middle: Vector3<f64>,
    inv_reach: f64,
}

/// Tolerance of a rough distance relative to the sum of the farthest coordinate and the reach. Two positions
/// and their difference are rounded by 2⁻²⁴ each, along three axes: less than 2√3 2⁻²⁴ of that sum.
const DOUBT: f64 = 1.0 / 2_097_152.0;

/// Tolerance of the square of a distance relative to it: above its five roundings of 2⁻²⁴.
const DOUBT_OF_SQUARE: f64 = 1.0 / 1_048_576.0;

impl RoughUnit {
    /// Rough position.
    #[inline(always)]
    pub(super) fn rough(&self, place: &Vector3<f64>) -> [f32; 3] {
        let [x, y, z] = ((place - self.middle) * self.inv_reach).into();
        [x as f32, y as f32, z as f32]
    }
}

impl SinglePrecisionPositions {
    /// Fits the unit to the positions and the reach.
    pub(super) fn fit(&mut self, extent: [[f64; 2]; 3], reach: f64) {
        let inv_reach = 1.0 / reach;
        let middle = Vector3::from(extent.map(|[low, high]| 0.5 * low + 0.5 * high));
        let half = extent.map(|[low, high]| (0.5 * high - 0.5 * low) * inv_reach);
        let farthest = half.into_iter().fold(1.0, f64::max);
        self.unit = RoughUnit { middle, inv_reach };
        self.doubt = DOUBT * (farthest + 1.0);
    }

    /// Makes room for some slots.
    pub(super) fn resize(&mut self, slots: usize) {
        for along in &mut self.along {
            along.resize(slots, 0.0);
        }
    }

    /// The unit, and positions along x, y and z to write to.
    pub(super) fn along_mut(&mut self) -> (RoughUnit, [&mut [f32]; 3]) {
        let along = self.along.each_mut().map(Vec::as_mut_slice);
        (self.unit, along)
    }

    /// Positions along x, y and z.
    #[inline(always)]
    pub(super) fn along(&self) -> [&[f32]; 3] {
        let [x, y, z] = &self.along;
        [x, y, z]
    }

    /// Squares of rough distances: slots are nearer than `distance` below the first, and farther above the second.
    pub(super) fn limits(&self, distance: f64) -> [f32; 2] {
        let distance = distance * self.unit.inv_reach;
        let [sure, possible] = [distance - self.doubt, distance + self.doubt].map(|d| d.max(0.0));
        [
            (sure * sure * (1.0 - DOUBT_OF_SQUARE)) as f32,
            (possible * possible * (1.0 + DOUBT_OF_SQUARE)) as f32,
        ]
    }
}
