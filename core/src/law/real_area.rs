//! Real area of contact: how much of two rough surfaces touches under a load.
//!
//! Loads are pushes: where L ≤ 0 nothing touches (no adhesion) and the area is zero.

use super::LawError;
use super::error::positive;
use crate::real::Real;

/// The real area of contact of a load.
///
/// *Units*: `load` in force; areas in length².
///
/// ```
/// use tribos_core::law::{GreenwoodWilliamson, HertzSphere, Plastic, RealArea};
/// fn growth(contact: &impl RealArea<f64>) -> f64 {
///     contact.area(16.0) / contact.area(2.0) // eight times the load
/// }
/// // Flowing or rough: as the load, which is Coulomb's law. One elastic ball: as L^(2/3).
/// assert!((growth(&Plastic::new(1e9)?) - 8.0).abs() < 1e-14);
/// assert!((growth(&GreenwoodWilliamson::new(1e-6, 1e-4, 1e11)?) - 8.0).abs() < 1e-14);
/// assert!((growth(&HertzSphere::new(5e-3, 1e11)?) - 4.0).abs() < 1e-13);
/// # Ok::<(), tribos_core::law::LawError>(())
/// ```
pub trait RealArea<R: Real> {
    /// Area A(L); zero for L ≤ 0.
    fn area(&self, load: R) -> R;
    /// dA/dL for L > 0, and its limit for L → 0; zero for L < 0.
    fn slope(&self, load: R) -> R;
    /// A/L for L > 0, and its limit for L → 0; zero for L < 0.
    fn area_per_load(&self, load: R) -> R;
}

/// Junctions at the limit of plastic flow: A = L/σ_c.
///
/// *Source*: Bowden and Tabor; thesis eq. 2.1.
///
/// ```
/// use tribos_core::law::{Plastic, RealArea};
/// let steel = Plastic::new(2e9_f64)?; // Pa
/// let carried = steel.area(500.0) * steel.hardness(); // N
/// assert!((carried - 500.0).abs() < 1e-12);
/// assert_eq!(steel.area(-500.0), 0.0); // pulled apart
/// # Ok::<(), tribos_core::law::LawError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Plastic<R> {
    hardness: R,
}

impl<R: Real> Plastic<R> {
    /// Penetration hardness σ_c. *Units*: pressure. *Domain*: 0 < `hardness` < ∞.
    pub fn new(hardness: R) -> Result<Self, LawError> {
        Ok(Self {
            hardness: positive("hardness", hardness)?,
        })
    }

    /// The penetration hardness σ_c.
    pub fn hardness(&self) -> R {
        self.hardness
    }
}

impl<R: Real> RealArea<R> for Plastic<R> {
    #[inline]
    fn area(&self, load: R) -> R {
        pushed(load, load / self.hardness)
    }
    #[inline]
    fn slope(&self, load: R) -> R {
        pushed(load, R::ONE / self.hardness)
    }
    #[inline]
    fn area_per_load(&self, load: R) -> R {
        pushed(load, R::ONE / self.hardness)
    }
}

/// One elastic sphere: A = π (3LR/4E*)^⅔.
///
/// *Source*: Hertz; thesis section 2.2 (A ∝ L^⅔). *Accuracy*: 1e-14 relative in f64 for areas of
/// ordinary size; the power multiplies the rounding of ⅓ by the logarithm of its base.
///
/// ```
/// use tribos_core::law::{HertzSphere, RealArea};
/// let ball = HertzSphere::new(0.01_f64, 75e9)?; // m, Pa
/// let radius = ball.contact_radius(10.0); // under 10 N
/// assert!((radius - 1e-4).abs() < 1e-18); // (3/4 * 10 * 0.01/75e9)^(1/3)
/// let area = core::f64::consts::PI * 1e-8;
/// assert!((ball.area(10.0) - area).abs() < 1e-21);
/// assert!((ball.slope(10.0) * 10.0 - area * 2.0 / 3.0).abs() < 1e-21); // A goes as L^(2/3)
/// # Ok::<(), tribos_core::law::LawError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct HertzSphere<R> {
    /// R/E*
    radius_per_modulus: R,
}

/// Three quarters, of Hertz' a³ = 3LR/(4E*).
const HERTZ_FACTOR: f64 = 0.75;
/// a ∝ L^⅓, and the slope dA/dL is 2 · ⅓ of A/L.
const THIRD: f64 = 1.0 / 3.0;

impl<R: Real> HertzSphere<R> {
    /// Sphere radius R (of two spheres 1/R = 1/R₁ + 1/R₂) and contact modulus E*, where
    /// 1/E* = (1 − ν₁²)/E₁ + (1 − ν₂²)/E₂.
    ///
    /// *Units*: length, pressure. *Domain*: both positive and finite, with R/E* in the range of
    /// the type.
    pub fn new(radius: R, contact_modulus: R) -> Result<Self, LawError> {
        positive("sphere radius", radius)?;
        positive("contact modulus", contact_modulus)?;
        Ok(Self {
            radius_per_modulus: positive("radius per modulus", radius / contact_modulus)?,
        })
    }

    /// Radius a = (3LR/4E*)^⅓ of the contact; zero for L ≤ 0.
    #[inline]
    pub fn contact_radius(&self, load: R) -> R {
        if load <= R::ZERO {
            return R::ZERO;
        }
        (R::from_f64(HERTZ_FACTOR) * load * self.radius_per_modulus).pow(R::from_f64(THIRD))
    }
}

impl<R: Real> RealArea<R> for HertzSphere<R> {
    #[inline]
    fn area(&self, load: R) -> R {
        let a = self.contact_radius(load);
        R::PI * a * a
    }
    #[inline]
    fn slope(&self, load: R) -> R {
        R::TWO * R::from_f64(THIRD) * self.area_per_load(load)
    }
    /// Infinite for L → 0.
    #[inline]
    fn area_per_load(&self, load: R) -> R {
        if load == R::ZERO {
            return R::INFINITY;
        }
        // A/L = π a²/L = π (3R/4E*)/a, where the small load has cancelled.
        let per_radius = R::PI * R::from_f64(HERTZ_FACTOR) * self.radius_per_modulus;
        pushed(load, per_radius / self.contact_radius(load))
    }
}

/// Many elastic asperities with exponentially distributed heights: A = L √(πR_a/s)/E*.
///
/// Tips of radius R_a, n of them per unit of height z above the nominal surface, n(z) = n₀
/// e^(−z/s). At separation d each higher tip is a Hertz contact with indentation z − d, area
/// πR_a(z − d) and load (4/3) E* √R_a (z − d)^(3/2). With q = n₀ e^(−d/s):
///
/// ```text
/// A = πR_a ∫(z−d) n dz               = πR_a s² q
/// L = (4/3) E*√R_a ∫(z−d)^(3/2) n dz = (4/3) E*√R_a Γ(5/2) s^(5/2) q = √π E* √R_a s^(5/2) q
/// L/A = E* √(s/(πR_a))
/// ```
///
/// The separation drops out: area is proportional to load although every contact is elastic.
///
/// *Source*: Greenwood and Williamson 1966; thesis section 2.2.
///
/// ```
/// use tribos_core::law::{GreenwoodWilliamson, RealArea};
/// let rough = GreenwoodWilliamson::new(1e-6_f64, 1e-4, 1e11)?; // m, m, Pa
/// // More load makes more junctions, not larger ones.
/// let junctions = |load| rough.area(load) / rough.junction_area();
/// assert!((junctions(20.0) / junctions(10.0) - 2.0).abs() < 1e-15);
/// // Smoother by a factor of four: half the pressure, twice the area.
/// let smooth = GreenwoodWilliamson::new(0.25e-6, 1e-4, 1e11)?;
/// assert!((smooth.mean_pressure() / rough.mean_pressure() - 0.5).abs() < 1e-15);
/// assert!((smooth.area(10.0) / rough.area(10.0) - 2.0).abs() < 1e-14);
/// # Ok::<(), tribos_core::law::LawError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct GreenwoodWilliamson<R> {
    mean_pressure: R,
    junction_area: R,
}

impl<R: Real> GreenwoodWilliamson<R> {
    /// Decay length s of the heights, tip radius R_a, contact modulus E*.
    ///
    /// *Units*: length, length, pressure. *Domain*: all positive and finite, with the mean
    /// pressure in the range of the type.
    pub fn new(decay_length: R, tip_radius: R, contact_modulus: R) -> Result<Self, LawError> {
        positive("decay length", decay_length)?;
        positive("tip radius", tip_radius)?;
        positive("contact modulus", contact_modulus)?;
        let pressure = contact_modulus * (decay_length / tip_radius / R::PI).sqrt();
        Ok(Self {
            mean_pressure: positive("mean pressure", pressure)?,
            junction_area: R::PI * tip_radius * decay_length,
        })
    }

    /// L/A = E*√(s/(πR_a)), which takes the place of the hardness.
    pub fn mean_pressure(&self) -> R {
        self.mean_pressure
    }

    /// Mean area πR_a s of one junction, the same for every load.
    pub fn junction_area(&self) -> R {
        self.junction_area
    }
}

impl<R: Real> RealArea<R> for GreenwoodWilliamson<R> {
    #[inline]
    fn area(&self, load: R) -> R {
        pushed(load, load / self.mean_pressure)
    }
    #[inline]
    fn slope(&self, load: R) -> R {
        pushed(load, R::ONE / self.mean_pressure)
    }
    #[inline]
    fn area_per_load(&self, load: R) -> R {
        pushed(load, R::ONE / self.mean_pressure)
    }
}

/// `value` under a push, zero under a pull, NaN for a load of NaN.
#[inline]
fn pushed<R: Real>(load: R, value: R) -> R {
    if load.is_nan() {
        load
    } else if load < R::ZERO {
        R::ZERO
    } else {
        value
    }
}
