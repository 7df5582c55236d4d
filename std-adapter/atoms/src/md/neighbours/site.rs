//! What the loop over pairs reads and writes of a slot.

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
    pub(super) const NOWHERE: Self = Self {
        place: [NOWHERE, NOWHERE, NOWHERE, 0.0],
        force: [0.0; 4],
    };

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
