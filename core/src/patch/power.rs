//! Pressures that are a power of 1 − r²: thin ring, flat punch, uniform disk, Hertz, paraboloid.

use super::PatchError;

/// The pressure (q+1)/π (1−r²)^q of a unit load on the unit disk; the thin ring is the limit
/// q → −1.
///
/// *Domain*: −1 ≤ q ≤ [`PowerPressure::MAX_ORDER`].
///
/// ```
/// use tribos_core::patch::PowerPressure;
/// assert_eq!(PowerPressure::new(0.5), Ok(PowerPressure::HERTZ));
/// assert_eq!(PowerPressure::FLAT_PUNCH.order(), -0.5);
/// // From the rim towards the centre.
/// for (pressure, mean_square_radius) in [
///     (PowerPressure::RING, 1.0),
///     (PowerPressure::FLAT_PUNCH, 2.0 / 3.0),
///     (PowerPressure::UNIFORM, 1.0 / 2.0),
///     (PowerPressure::HERTZ, 2.0 / 5.0),
///     (PowerPressure::PARABOLOID, 1.0 / 3.0),
/// ] {
///     assert_eq!(pressure.mean_square_radius(), mean_square_radius);
/// }
/// assert!(PowerPressure::new(PowerPressure::MAX_ORDER + 1.0).is_err());
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct PowerPressure {
    order: f64,
}

impl PowerPressure {
    /// Largest order: such a pressure sits within a third of the radius.
    pub const MAX_ORDER: f64 = 8.0;

    /// All load on the rim, q = −1.
    pub const RING: Self = Self { order: -1.0 };
    /// A rigid flat punch on an elastic half space, q = −1/2 (Boussinesq; Johnson, Contact
    /// Mechanics, 3.64).
    pub const FLAT_PUNCH: Self = Self { order: -0.5 };
    /// The same pressure everywhere, q = 0 (eq. 3.1).
    pub const UNIFORM: Self = Self { order: 0.0 };
    /// Elastic spheres, q = 1/2 (Hertz; Johnson, Contact Mechanics, 3.39).
    pub const HERTZ: Self = Self { order: 0.5 };
    /// q = 1
    pub const PARABOLOID: Self = Self { order: 1.0 };

    /// Any order of the domain.
    pub const fn new(order: f64) -> Result<Self, PatchError> {
        if order >= -1.0 && order <= Self::MAX_ORDER {
            Ok(Self { order })
        } else {
            Err(PatchError::Order {
                given: order,
                max: Self::MAX_ORDER,
            })
        }
    }

    /// The order q.
    pub const fn order(&self) -> f64 {
        self.order
    }

    /// ⟨r²⟩ = 1/(q+2), in radii squared.
    pub const fn mean_square_radius(&self) -> f64 {
        1.0 / (self.order + 2.0)
    }
}
