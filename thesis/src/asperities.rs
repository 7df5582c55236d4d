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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_sphere_indents_by_hertz() {
        let (radius, contact_modulus) = (0.02_f64, 7e10);
        let sphere = HertzSphere {
            radius,
            contact_modulus,
        };
        for load in [1e-9, 1e-3, 1.0, 1e4] {
            // Back from the contact radius: L = 4E*a³/(3R).
            let a = (sphere.area(load) / PI).sqrt();
            let back = 4.0 * contact_modulus * a.powi(3) / (3.0 * radius);
            assert!((back / load - 1.0).abs() < 1e-13, "{back} for {load}");
        }
    }

    /// ∫ f over [0, ∞) by the trapezoid of x = exp(t − e^(−t)), which dies twice exponentially at
    /// zero.
    fn half_line(scale: f64, f: impl Fn(f64) -> f64) -> f64 {
        let step = 1.0 / 64.0;
        (-400..500)
            .map(|i| {
                let t = f64::from(i) * step;
                let x = (t - (-t).exp()).exp();
                f(scale * x) * scale * x * (1.0 + (-t).exp()) * step
            })
            .sum()
    }

    #[test]
    fn exponential_asperities_make_area_proportional_to_load() {
        let tip = HertzSphere {
            radius: 2e-4,
            contact_modulus: 1e11,
        };
        let decay_length = 1e-6;
        let rough = RoughSurface { decay_length, tip };
        for separation in [0.0_f64, 2e-6, 1e-5] {
            // Sum of Hertz contacts of tips that reach `indent` beyond the separation.
            let density = |indent: f64| 1e9 * (-(separation + indent) / decay_length).exp();
            let load_of = |indent: f64| {
                4.0 / 3.0 * tip.contact_modulus * (tip.radius * indent.powi(3)).sqrt()
            };
            let sum = |of: &dyn Fn(f64) -> f64| half_line(decay_length, |z| density(z) * of(z));
            let (load, area) = (sum(&load_of), sum(&|z| tip.area(load_of(z))));
            assert!((rough.mean_pressure() * area / load - 1.0).abs() < 1e-12);
        }
    }
}
