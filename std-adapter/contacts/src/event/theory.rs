//! What kinetic theory says of a homogeneous gas of hard spheres with Gaussian velocities.
//!
//! With C collisions a sphere, ½ dC of them a pair, both temperatures change by
//!
//! ```text
//! dT/dC = ⅓ ΔE_tr,   dθ/dC = ⅓ ΔE_rot
//! ```
//!
//! where the means over a collision are ΔE_tr = −(1 − e²) T + ¼⟨(κ² − 2κρ) u_t²⟩ with κ = q/(1 + q) (1 + β),
//! ρ = T/(T + θ/q), and all that is lost along the tangent is ¼ q/(1 + q) ⟨(1 − β²) u_t²⟩; ⟨u_t²⟩ = 4 (T + θ/q)
//! (Huthmann & Zippelius 1997; here β may depend on the collision). Smooth spheres follow T = T₀ exp(−(1 − e²) C/3):
//! Haff's law (1983) in collisions.

use super::impact::{GRIP, INERTIA, Impact, Tangential};
use std::f64::consts::PI;

/// Diameter of the spheres.
const DIAMETER: f64 = 2.0;
/// Nodes of the mean over collisions; the error is 1e-6.
const NODES: u32 = 200;
/// Largest step in C of the integration; the error of a step is 1e-9.
const STEP: f64 = 0.05;

/// Value of the pair distribution at contact, by Carnahan and Starling (1969).
///
/// g = (1 − φ/2)/(1 − φ)³ at a packing fraction φ. *Domain*: 0 ≤ φ < 0.5. *Accuracy*: that of the equation of state,
/// below 0.5 % in the fluid.
///
/// ```
/// use tribos::event::contact_value;
/// assert_eq!(contact_value(0.0), 1.0);
/// assert!((contact_value(0.3) - 2.478134).abs() < 1e-6);
/// ```
pub fn contact_value(fraction: f64) -> f64 {
    let free = 1.0 - fraction;
    (1.0 - 0.5 * fraction) / (free * free * free)
}

/// Collisions a sphere and unit of time, by Enskog: 4 n d² g √(π T/m).
///
/// *Units*: R = m = 1. *Domain*: as [`contact_value`]; temperature ≥ 0.
///
/// ```
/// use tribos::event::collision_rate;
/// // A mean free path of 1/(√2 π n d²) at the mean speed √(8 T/π).
/// let (fraction, pi) = (1e-9, std::f64::consts::PI);
/// let density = fraction / (4.0 / 3.0 * pi);
/// let path = 1.0 / (2.0_f64.sqrt() * pi * density * 4.0);
/// assert!((collision_rate(fraction, 2.0) * path / (16.0 / pi).sqrt() - 1.0).abs() < 1e-8);
/// ```
pub fn collision_rate(fraction: f64, temperature: f64) -> f64 {
    let density = fraction / (4.0 / 3.0 * PI);
    let rate = 4.0 * density * DIAMETER * DIAMETER * contact_value(fraction);
    rate * (PI * temperature).sqrt()
}

/// Mean kinetic energies of a sphere, over 3/2: of its motion and of its spin.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Temperatures {
    /// ⅓ m ⟨v²⟩.
    pub translational: f64,
    /// ⅓ I ⟨ω²⟩.
    pub rotational: f64,
}

impl Temperatures {
    /// Temperatures after so many collisions a sphere more, if the gas stays homogeneous.
    ///
    /// *Accuracy*: 1e-6 of the theory, whose own neglect of correlations costs about 1 % at e = 0.95.
    ///
    /// ```
    /// use tribos::event::{Impact, Tangential, Temperatures};
    /// let start = Temperatures { translational: 1.0, rotational: 0.0 };
    /// let end = start.after(6.0, &Impact::new(0.95, Tangential::Smooth)?);
    /// assert!((end.translational - (-0.195_f64).exp()).abs() < 1e-9); // exp(-(1 - e²) 6/3)
    /// # Ok::<(), tribos::event::ImpactError>(())
    /// ```
    pub fn after(self, collisions: f64, law: &Impact) -> Self {
        let steps = (collisions / STEP).ceil().max(1.0);
        let dc = collisions / steps;
        let mut now = self;
        for _ in 0..steps as u64 {
            let k1 = now.rates(law);
            let k2 = now.plus(0.5 * dc, k1).rates(law);
            let k3 = now.plus(0.5 * dc, k2).rates(law);
            let k4 = now.plus(dc, k3).rates(law);
            let mean = |i: usize| (k1[i] + 2.0 * (k2[i] + k3[i]) + k4[i]) / 6.0;
            now = now.plus(dc, [mean(0), mean(1)]);
        }
        now
    }

    fn plus(self, dc: f64, [translational, rotational]: [f64; 2]) -> Self {
        Self {
            translational: self.translational + dc * translational,
            rotational: self.rotational + dc * rotational,
        }
    }

    /// Changes a collision.
    fn rates(self, law: &Impact) -> [f64; 2] {
        let (t, surface) = (
            self.translational,
            self.translational + self.rotational / INERTIA,
        );
        let e = law.restitution();
        let normal = -(1.0 - e * e) * t;
        if law.tangential() == Tangential::Smooth || surface <= 0.0 {
            return [normal / 3.0, 0.0];
        }
        let share = t / surface;
        let [mut moved, mut lost] = [0.0; 2];
        // Mean over u_n and u_t: z = 1/(1 + (u_n²/T)/(u_t²/(T + θ/q))) has the density 2 z under the weight u_t².
        for node in 0..NODES {
            let z = (f64::from(node) + 0.5) / f64::from(NODES);
            let approach = ((1.0 / z - 1.0) * t / surface).sqrt();
            let beta = law.beta(approach, 1.0);
            let kappa = GRIP * (1.0 + beta);
            let weight = 2.0 * z / f64::from(NODES) * 4.0 * surface;
            moved += weight * 0.25 * (kappa * kappa - 2.0 * kappa * share);
            lost += weight * 0.25 * GRIP * (1.0 - beta * beta);
        }
        [(normal + moved) / 3.0, (-lost - moved) / 3.0]
    }
}
