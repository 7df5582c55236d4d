//! Friction by shearing of junctions.

use super::error::positive;
use super::{CoulombLaw, LawError, Plastic, RealArea};
use crate::real::Real;

/// Friction force τ_c A(L): the real area of contact times the stress that shears it.
///
/// With plastic junctions A = L/σ_c this is Coulomb's law with μ = τ_c/σ_c, and it is linear in
/// the load for [`GreenwoodWilliamson`](super::GreenwoodWilliamson) asperities too. For a single
/// [`HertzSphere`](super::HertzSphere) the coefficient falls with the load like L^(−⅓).
///
/// *Units*: pressure for τ_c; force for loads and friction. *Source*: thesis eq. 2.2.
///
/// ```
/// use tribos_core::law::{BowdenTabor, HertzSphere, Plastic, RealArea};
/// let steel = Plastic::new(1e9_f64)?; // hardness in Pa
/// assert!((steel.area(100.0) - 1e-7).abs() < 1e-20); // 100 N rest on 0.1 mm^2
/// let friction = BowdenTabor::new(0.6e9, steel)?;
/// assert!((friction.force(100.0) - 60.0).abs() < 1e-12);
/// assert!((friction.coulomb()?.mu() - 0.6).abs() < 1e-15);
///
/// // One elastic ball: F goes as L^(2/3), so that eight times the load halves the coefficient.
/// let ball = BowdenTabor::new(0.6e9, HertzSphere::new(5e-3_f64, 1e11)?)?; // m, Pa
/// let [light, heavy] = [1.0, 8.0].map(|load| ball.effective_coefficient(load)); // N
/// assert!((heavy / light - 0.5).abs() < 1e-14);
/// assert!((ball.slope(1.0) / light - 2.0 / 3.0).abs() < 1e-14);
/// let sheared = ball.shear_strength() * ball.contact().area(1.0);
/// assert!((ball.force(1.0) / sheared - 1.0).abs() < 1e-15);
/// # Ok::<(), tribos_core::law::LawError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct BowdenTabor<R, A> {
    shear_strength: R,
    contact: A,
}

impl<R: Real, A: RealArea<R>> BowdenTabor<R, A> {
    /// Shear strength τ_c of the junctions and the model of their area.
    ///
    /// *Domain*: 0 < `shear_strength` < ∞.
    pub fn new(shear_strength: R, contact: A) -> Result<Self, LawError> {
        Ok(Self {
            shear_strength: positive("shear strength", shear_strength)?,
            contact,
        })
    }

    /// The shear strength τ_c.
    pub fn shear_strength(&self) -> R {
        self.shear_strength
    }

    /// The model of the real area.
    pub fn contact(&self) -> &A {
        &self.contact
    }

    /// Friction force under a load.
    #[inline]
    pub fn force(&self, load: R) -> R {
        self.shear_strength * self.contact.area(load)
    }

    /// d(force)/d(load).
    #[inline]
    pub fn slope(&self, load: R) -> R {
        self.shear_strength * self.contact.slope(load)
    }

    /// Force over load, with its limit at load zero.
    #[inline]
    pub fn effective_coefficient(&self, load: R) -> R {
        self.shear_strength * self.contact.area_per_load(load)
    }
}

impl<R: Real> BowdenTabor<R, Plastic<R>> {
    /// Coulomb's law with μ = τ_c/σ_c.
    ///
    /// Refused if the quotient leaves the range of the type.
    pub fn coulomb(&self) -> Result<CoulombLaw<R>, LawError> {
        CoulombLaw::new(self.shear_strength / self.contact.hardness())
    }
}
