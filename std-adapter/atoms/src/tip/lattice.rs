//! Faces of a face-centred cubic crystal: rows, layers and stacking.

/// Orientation of the layers: the face that is parallel to them. Close-packed rows are along x.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CrystalFace {
    /// (111): triangular layers, stacked ABC.
    Fcc111,
    /// (100): square layers, stacked AB.
    Fcc100,
    /// (110): rectangular layers with open rows, stacked AB.
    Fcc110,
}

impl CrystalFace {
    /// Distance of two rows of a layer, for atoms a distance `spacing` apart in a row.
    pub fn row_distance(self, spacing: f64) -> f64 {
        match self {
            Self::Fcc111 => 0.5 * spacing * 3.0_f64.sqrt(),
            Self::Fcc100 => spacing,
            Self::Fcc110 => spacing * 2.0_f64.sqrt(),
        }
    }

    /// Distance of two layers.
    pub fn layer_distance(self, spacing: f64) -> f64 {
        match self {
            Self::Fcc111 => spacing * (2.0_f64 / 3.0).sqrt(),
            Self::Fcc100 => spacing * 0.5_f64.sqrt(),
            Self::Fcc110 => 0.5 * spacing,
        }
    }

    /// Start of a row along x, in spacings.
    pub fn row_start(self, row: usize) -> f64 {
        if self == Self::Fcc111 && !row.is_multiple_of(2) {
            0.5
        } else {
            0.0
        }
    }

    /// Shift from a site of the lowest layer to one of this layer.
    pub fn stacking(self, layer: usize, spacing: f64) -> [f64; 2] {
        let third = spacing / 3.0_f64.sqrt();
        match (self, layer % 3) {
            (Self::Fcc111, 0) => [0.0; 2],
            (Self::Fcc111, 1) => [0.0, third],
            (Self::Fcc111, _) => [0.0, -third],
            _ if layer.is_multiple_of(2) => [0.0; 2],
            _ => [0.5 * spacing, 0.5 * self.row_distance(spacing)],
        }
    }

    /// Largest distance between sites of two layers that are stacked to either side of one axis.
    pub fn overhang(self, spacing: f64) -> f64 {
        match self {
            Self::Fcc111 => spacing / 3.0_f64.sqrt(),
            _ => {
                let [x, y] = self.stacking(1, spacing);
                libm::hypot(x, y)
            }
        }
    }
}
