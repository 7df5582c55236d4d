//! Contact geometry of two bodies that touch or nearly touch.

use super::vector::length;
use crate::real::Real;
use nalgebra::Vector3;

/// Geometry of a contact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ContactGeometry<R> {
    /// Unit normal, from the first body to the second.
    pub normal: Vector3<R>,
    /// Distance of the surfaces; negative where they overlap.
    pub gap: R,
    /// Distances of the two centres from the contact point, along the normal. They add up to the
    /// distance of the centres, to 2 ulp, so that a contact changes no angular momentum; 0 for a
    /// plate.
    pub arms: [R; 2],
    /// r_eff = 1/(1/R₁ + 1/R₂), the lever of rolling and torsion friction (thesis, section 4.3.2);
    /// the sphere's own radius at a plate.
    pub lever: R,
}

/// Why a contact has no geometry.
///
/// ```
/// use nalgebra::Vector3;
/// use tribos_core::contact::{ContactGeometry, ContactError};
/// let [apart, nowhere] = [Vector3::new(0.1, 0.0, 0.0), Vector3::new(0.0, 0.0, 0.0)];
/// assert_eq!(ContactGeometry::spheres(&nowhere, [0.03, 0.06]), Err(ContactError::NoNormal));
/// assert_eq!(ContactGeometry::spheres(&apart, [0.03, -0.06]), Err(ContactError::NotFinite));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum ContactError {
    /// The centres coincide (to less than [`Real::MIN_POSITIVE`]), or the sphere's centre lies in
    /// the plate: there is no normal.
    NoNormal,
    /// A position, a radius or the sum of both is infinite or NaN, or a radius is not positive.
    NotFinite,
}

impl core::fmt::Display for ContactError {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.write_str(match self {
            Self::NoNormal => {
                "the centres coincide or the centre lies in the plate: there is no normal"
            }
            Self::NotFinite => "positions must be finite, radii positive and finite",
        })
    }
}

impl core::error::Error for ContactError {}

impl<R: Real> ContactGeometry<R> {
    /// Two spheres; `displacement` leads from the first centre to the second.
    ///
    /// *Accuracy*: the normal to 4 ulp; the gap to 2 ulp of the distance.
    ///
    /// ```
    /// use nalgebra::Vector3;
    /// use tribos_core::contact::ContactGeometry;
    /// // Balls of 3 and 6 cm, 10 cm apart.
    /// let touch = ContactGeometry::spheres(&Vector3::new(0.0, 0.1, 0.0), [0.03_f64, 0.06])?;
    /// assert_eq!(touch.normal, Vector3::new(0.0, 1.0, 0.0));
    /// assert!((touch.gap - 0.01).abs() < 1e-16);
    /// assert!((touch.arms[0] + touch.arms[1] - 0.1).abs() < 1e-16);
    /// assert!((touch.lever - 0.02).abs() < 1e-17); // 1/(1/3 + 1/6) = 2
    /// # Ok::<(), tribos_core::contact::ContactError>(())
    /// ```
    pub fn spheres(displacement: &Vector3<R>, radii: [R; 2]) -> Result<Self, ContactError> {
        let distance = length(displacement);
        let [first, second] = radii;
        let reach = first + second;
        if !(valid(first) && valid(second) && reach.is_finite() && distance.is_finite()) {
            return Err(ContactError::NotFinite);
        }
        if distance < R::MIN_POSITIVE {
            return Err(ContactError::NoNormal);
        }
        // The contact point divides the distance in the ratio of the radii. Both arms come from
        // their own share: the difference to the other one would cost a small sphere its digits.
        let [share, other] = [first / reach, second / reach];
        Ok(Self {
            normal: displacement / distance,
            gap: distance - reach,
            arms: [distance * share, distance * other],
            lever: share * second,
        })
    }

    /// A sphere whose centre is `height` above a plate; `outward` is the plate's unit normal, into
    /// the space of the sphere. The sphere is the first body.
    pub fn plate(height: R, outward: &Vector3<R>, radius: R) -> Result<Self, ContactError> {
        if !(valid(radius) && height.is_finite()) {
            return Err(ContactError::NotFinite);
        }
        if height <= R::ZERO {
            return Err(ContactError::NoNormal);
        }
        Ok(Self {
            normal: -outward,
            gap: height - radius,
            arms: [height, R::ZERO],
            lever: radius,
        })
    }
}

fn valid<R: Real>(radius: R) -> bool {
    radius > R::ZERO && radius.is_finite()
}
