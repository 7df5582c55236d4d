//! Laws of contacts, and the order of their components.

use std::ops::Range;

/// Components of a contact's impulse and velocity, in this order: normal, sliding, rolling, torsion.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ContactComponents {
    /// Two: normal and sliding in a plane.
    Plane,
    /// Three: normal and two of sliding.
    Space,
    /// Four: normal, two of sliding, torsion.
    Torsion,
    /// Five: normal, two of sliding, two of rolling.
    Rolling,
    /// Six: normal, two of sliding, two of rolling, torsion.
    All,
}

impl ContactComponents {
    /// The layout of a number of components.
    #[must_use]
    pub fn of_size(size: usize) -> Option<Self> {
        Some(match size {
            2 => Self::Plane,
            3 => Self::Space,
            4 => Self::Torsion,
            5 => Self::Rolling,
            6 => Self::All,
            _ => return None,
        })
    }

    /// Number of components.
    #[must_use]
    pub fn size(self) -> usize {
        match self {
            Self::Plane => 2,
            Self::Space => 3,
            Self::Torsion => 4,
            Self::Rolling => 5,
            Self::All => 6,
        }
    }

    /// Components of sliding.
    #[must_use]
    pub fn sliding(self) -> Range<usize> {
        match self {
            Self::Plane => 1..2,
            _ => 1..3,
        }
    }

    /// Components of rolling; empty where there are none.
    #[must_use]
    pub fn rolling(self) -> Range<usize> {
        match self {
            Self::Rolling | Self::All => 3..5,
            _ => 0..0,
        }
    }

    /// The component of torsion; empty where there is none.
    #[must_use]
    pub fn torsion(self) -> Range<usize> {
        match self {
            Self::Torsion => 3..4,
            Self::All => 5..6,
            _ => 0..0,
        }
    }
}

/// How thresholds of sliding and torsion go together.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Friction {
    /// Each has its own: |r_T| ≤ μ P and |r_S| ≤ μ_n P.
    #[default]
    Separate,
    /// An ellipsoid: |r_T|²/μ² + r_S²/μ_n² ≤ P².
    Ellipsoid,
}

/// Law of a contact: thresholds over P, the normal impulse plus cohesion.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ContactThresholds {
    /// Friction coefficient μ: largest sliding impulse over P.
    pub sliding: f64,
    /// Rolling threshold: largest rolling impulse over P, a length.
    pub rolling: f64,
    /// Torsion threshold μ_n: largest torsion impulse over P, a length.
    pub torsion: f64,
    /// Largest pull, an impulse ≥ 0.
    pub cohesion: f64,
    /// How sliding and torsion go together.
    pub friction: Friction,
}

impl ContactThresholds {
    /// Coulomb friction without rolling, torsion and cohesion.
    #[must_use]
    pub fn coulomb(sliding: f64) -> Self {
        Self {
            sliding,
            ..Self::default()
        }
    }
}
