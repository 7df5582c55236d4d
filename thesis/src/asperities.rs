//! Real area of contact: how much of two rough surfaces touches under a load (section 2.2).
//!
//! Loads are pushes, L > 0. *Units*: SI or consistent.

use std::f64::consts::PI;
use tribos_core::Real;

/// Three quarters, of Hertz' a³ = 3LR/(4E*).
const HERTZ_FACTOR: f64 = 0.75;

/// Area L/σ_c of junctions at the limit of plastic flow, σ_c their hardness.
///
/// *Source*: Bowden and Tabor; eq. 2.1.
pub fn plastic_area(load: f64, hardness: f64) -> f64 {
    load / hardness
}

/// One elastic sphere: A = π (3LR/4E*)^⅔.
#[derive(Clone, Copy, Debug)]
pub struct HertzSphere {
    /// Radius R.
    pub radius: f64,
    /// Contact modulus E*.
    pub contact_modulus: f64,
}

impl HertzSphere {
    /// Radius a = (3LR/4E*)^⅓ of the contact.
    pub fn contact_radius(&self, load: f64) -> f64 {
        let cube = HERTZ_FACTOR * load * (self.radius / self.contact_modulus);
        Real::pow(cube, 1.0 / 3.0)
    }

    /// Its area.
    pub fn area(&self, load: f64) -> f64 {
        let a = self.contact_radius(load);
        PI * a * a
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
/// *Source*: Greenwood and Williamson 1966.
#[derive(Clone, Copy, Debug)]
pub struct RoughSurface {
    /// Decay length s of the heights.
    pub decay_length: f64,
    /// Its tips: radius R_a and contact modulus E*.
    pub tip: HertzSphere,
}

impl RoughSurface {
    /// L/A = E*√(s/(πR_a)), which takes the place of the hardness.
    pub fn mean_pressure(&self) -> f64 {
        self.tip.contact_modulus * Real::sqrt(self.decay_length / self.tip.radius / PI)
    }
}
