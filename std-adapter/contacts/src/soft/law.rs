//! Normal springs, the dashpots beside them, and the laws of a contact.

use crate::cd::{ContactMaterial, MaterialTable};
use tribos_base::bracket::Bracket;
use tribos_core::Real;
use tribos_core::contact::Cohesion;

/// How the elastic force of a contact grows with its overlap δ.
///
/// *Formula*: F = k δ, or F = 4/3 E* √r_eff δ^(3/2) (Hertz), with 1/r_eff = 1/R₁ + 1/R₂ and R at a plate.
///
/// ```
/// use tribos::soft::Stiffness;
/// // Steel on steel, E* = 115 GPa, r_eff = 5 mm, an overlap of 1 µm.
/// let [force, slope] = Stiffness::Hertz(1.15e11).force(1e-6, 5e-3); // N, N/m
/// assert!((force - 10.84).abs() < 0.01);
/// assert!((slope * 1e-6 / force - 1.5).abs() < 1e-12);
/// assert_eq!(Stiffness::Linear(1e7).force(1e-6, 5e-3), [10.0, 1e7]);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Stiffness {
    /// Spring constant k. *Units*: force/length.
    Linear(f64),
    /// Contact modulus E*: 1/E* = (1 − ν₁²)/E₁ + (1 − ν₂²)/E₂, with one term at a rigid wall. *Units*: force/area.
    Hertz(f64),
}

/// Share of the tangent stiffness that takes part in the critical damping of a Hertz contact, √(5/6): with
/// it the restitution of an impact does not depend on its speed, and is that of a linear spring
/// (Tsuji, Tanaka and Ishida, Powder Technol. 71 (1992) 239; Antypov and Elliott, EPL 94 (2011) 50004).
const HERTZ_DAMPING: f64 = 0.912_870_929_175_276_9;

impl Stiffness {
    /// Elastic force of an overlap, and its derivative, the tangent stiffness.
    ///
    /// *Domain*: overlap ≥ 0, `r_eff` > 0.
    #[inline]
    pub fn force(&self, overlap: f64, r_eff: f64) -> [f64; 2] {
        match *self {
            Self::Linear(k) => [k * overlap, k],
            Self::Hertz(modulus) => {
                let slope = 2.0 * modulus * (r_eff * overlap).sqrt();
                [2.0 / 3.0 * slope * overlap, slope]
            }
        }
    }

    /// Elastic energy of an overlap: ½ k δ², or 2/5 F δ.
    #[inline]
    pub(crate) fn energy(&self, overlap: f64, force: f64) -> f64 {
        match self {
            Self::Linear(_) => 0.5 * force * overlap,
            Self::Hertz(_) => 0.4 * force * overlap,
        }
    }

    /// Overlap at which the elastic force has this value.
    ///
    /// *Domain*: force ≥ 0, `r_eff` > 0.
    pub fn overlap(&self, force: f64, r_eff: f64) -> f64 {
        match *self {
            Self::Linear(k) => force / k,
            Self::Hertz(modulus) => {
                let reduced = 0.75 * force / (modulus * r_eff.sqrt());
                Real::pow(reduced, 2.0 / 3.0)
            }
        }
    }

    /// Largest overlap of a head-on impact without damping, at a relative speed v of bodies with the
    /// effective mass m: the elastic energy is ½ m v².
    #[doc(hidden)]
    pub fn impact_overlap(&self, speed: f64, mass: f64, r_eff: f64) -> f64 {
        match *self {
            Self::Linear(k) => speed * (mass / k).sqrt(),
            Self::Hertz(modulus) => {
                let reduced = 15.0 / 16.0 * mass * speed * speed / (modulus * r_eff.sqrt());
                Real::pow(reduced, 0.4)
            }
        }
    }

    /// Constant of the normal dashpot at a tangent stiffness: 2 ζ √(S m_eff), and √(5/6) of that for Hertz.
    #[inline]
    pub(crate) fn dashpot(&self, damping: f64, slope: f64, mass: f64) -> f64 {
        let critical = 2.0 * (slope * mass).sqrt() * damping;
        match self {
            Self::Linear(_) => critical,
            Self::Hertz(_) => HERTZ_DAMPING * critical,
        }
    }

    /// Impulse of a dashpot while an overlap grows from none, over overlap times the constant at its end:
    /// the constant does not change on a linear spring and grows as δ^(1/4) on a Hertz contact.
    pub(crate) fn dashpot_path(&self) -> f64 {
        const HERTZ: f64 = 0.8;
        match self {
            Self::Linear(_) => 1.0,
            Self::Hertz(_) => HERTZ,
        }
    }

    /// The number that the law is made of.
    pub(crate) fn given(&self) -> f64 {
        match *self {
            Self::Linear(given) | Self::Hertz(given) => given,
        }
    }
}

impl Stiffness {
    /// Coefficient of restitution of a head-on impact of two bodies on a spring with damping ratio ζ that only
    /// pushes.
    ///
    /// *Formula*: e = exp(−2 ζ arccos(ζ)/√(1 − ζ²)) for ζ < 1, exp(−2) at ζ = 1, and with arcosh(ζ)/√(ζ² − 1)
    /// above. The contact ends where the dashpot's pull would exceed the spring's push, before the overlap is zero.
    /// Hertz contacts with the dashpot of this module have the same e at any speed.
    ///
    /// *Domain*: ζ ≥ 0. *Accuracy*: 1e-14 relative, to ζ = 1e3. *Source*: Schwager and Pöschel, Granular Matter 9
    /// (2007) 465, in one expression instead of two branches below ζ = 1.
    ///
    /// ```
    /// use tribos::soft::Stiffness;
    /// assert_eq!(Stiffness::restitution_of(0.0), 1.0);
    /// assert!((Stiffness::restitution_of(0.2) - 0.5717).abs() < 1e-4);
    /// assert!((Stiffness::restitution_of(1.0) - (-2.0_f64).exp()).abs() < 1e-15);
    /// ```
    pub fn restitution_of(damping: f64) -> f64 {
        Real::exp(-damping * duration(damping))
    }

    /// Damping ratio ζ whose [`Self::restitution_of`] is e.
    ///
    /// *Domain*: 0 < e ≤ 1. *Accuracy*: e is met to 1e-12 relative.
    ///
    /// ```
    /// use tribos::soft::Stiffness;
    /// for e in [1.0, 0.9, 0.5, 0.135, 0.01] {
    ///     assert!((Stiffness::restitution_of(Stiffness::damping_ratio_of(e)) / e - 1.0).abs() < 1e-12);
    /// }
    /// ```
    pub fn damping_ratio_of(coefficient: f64) -> f64 {
        // Restitution falls with ζ: an interval that brackets the answer, then bisection to the last bit.
        const MOST_HALVINGS: usize = 200;
        if coefficient >= 1.0 {
            return 0.0;
        }
        let mut high = 1.0;
        while Self::restitution_of(high) > coefficient && high < f64::MAX {
            high *= 2.0;
        }
        let is_damped = |ratio: f64| Self::restitution_of(ratio) <= coefficient;
        Bracket::new(0.0, high)
            .halved(MOST_HALVINGS, is_damped)
            .high
    }
}

/// Duration of that impact, in units of √(m/k): 2 arccos(ζ)/√(1 − ζ²).
pub(super) fn duration(damping: f64) -> f64 {
    // Near ζ = 1 both expressions are differences of small numbers: there arccos(ζ)/√(1 − ζ²) = 1 + (1 − ζ)/3
    // + 2 (1 − ζ)²/15 + …; the next term is below 1e-17.
    const NEAR: f64 = 1e-5;
    let below = 1.0 - damping;
    let angle = if below.abs() < NEAR {
        1.0 + below / 3.0 + 2.0 / 15.0 * below * below
    } else if below > 0.0 {
        // arccos(ζ) = 2 arctan √((1 − ζ)/(1 + ζ))
        2.0 * Real::atan((below / (1.0 + damping)).sqrt()) / (below * (1.0 + damping)).sqrt()
    } else {
        let root = (-below * (1.0 + damping)).sqrt();
        Real::asinh(root) / root
    };
    2.0 * angle
}

/// Friction of a soft contact, and the normal spring that carries it: the law of two materials in a
/// [`MaterialTable`] of a [`SoftSetup`](super::SoftSetup).
///
/// ```
/// use tribos::cd::{MaterialTable, WorldMaterials};
/// use tribos::kernel::contact::{Cohesion, IndependentFriction, NormalLaw};
/// use tribos::soft::{Sprung, Stiffness};
/// // Unlike spheres touch softly; all slide alike and bounce alike.
/// let normal = NormalLaw::new(Cohesion::NONE, 0.8)?;
/// let friction = IndependentFriction::sliding(0.3)?;
/// let mixture = MaterialTable::new(vec![0, 1], vec![], |[a, b]| {
///     let stiffness = Stiffness::Linear(if a == b { 1e5 } else { 1e3 }); // N/m
///     WorldMaterials::uniform(normal, Sprung { stiffness, friction })
/// });
/// assert_eq!(mixture.of_pair([0, 1]).friction.stiffness, Stiffness::Linear(1e3));
/// # Ok::<(), tribos::kernel::law::LawError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sprung<F> {
    /// Normal spring.
    pub stiffness: Stiffness,
    /// Friction.
    pub friction: F,
}

/// The laws of a world: the same for all pairs and for all walls, or by the materials of the bodies.
pub(super) trait Laws<F>: Sync {
    /// Whether contacts differ in the range of their cohesion.
    const ARE_MIXED: bool;
    /// Law between two spheres.
    fn of_pair(&self, bodies: [u32; 2]) -> &Law<F>;
    /// Law of a sphere at a wall.
    fn at_wall(&self, bodies: [u32; 2]) -> &Law<F>;
}

impl<F: Sync> Laws<F> for [Law<F>; 2] {
    const ARE_MIXED: bool = false;

    #[inline(always)]
    fn of_pair(&self, _: [u32; 2]) -> &Law<F> {
        &self[0]
    }

    #[inline(always)]
    fn at_wall(&self, _: [u32; 2]) -> &Law<F> {
        &self[1]
    }
}

impl<F: Sync> Laws<F> for MaterialTable<Law<F>> {
    const ARE_MIXED: bool = true;

    #[inline(always)]
    fn of_pair(&self, bodies: [u32; 2]) -> &Law<F> {
        &MaterialTable::of_pair(self, bodies).friction
    }

    #[inline(always)]
    fn at_wall(&self, bodies: [u32; 2]) -> &Law<F> {
        &MaterialTable::at_wall(self, bodies).friction
    }
}

/// Laws of a contact.
#[derive(Clone, Copy, Debug)]
pub(super) struct Law<F> {
    pub stiffness: Stiffness,
    /// Damping ratio ζ.
    pub damping: f64,
    pub cohesion: Cohesion<f64>,
    pub friction: F,
}

impl<F: Copy> Law<F> {
    /// The law of a material without restitution has this damping ratio.
    pub(super) fn of(material: &ContactMaterial<Sprung<F>>, damping: f64) -> Self {
        let restitution = material.normal.restitution();
        Self {
            stiffness: material.friction.stiffness,
            damping: if restitution > 0.0 {
                Stiffness::damping_ratio_of(restitution)
            } else {
                damping
            },
            cohesion: *material.normal.cohesion(),
            friction: material.friction.friction,
        }
    }
}

impl<F> Law<F> {
    /// Cohesion across a gap.
    pub(super) fn pull(&self, gap: f64) -> f64 {
        if gap <= self.cohesion.range() {
            self.cohesion.strength()
        } else {
            0.0
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Restitution by integrating the impact itself, with a step of 1e-5 of its time.
    fn integrated(zeta: f64) -> f64 {
        let (mut x, mut v, dt) = (0.0, 1.0, 1e-5);
        // Unit mass and stiffness; leapfrog with the dashpot's force at the middle.
        loop {
            let force = -x - 2.0 * zeta * v;
            if x > 0.0 && force >= 0.0 {
                return -v;
            }
            let half = v + 0.5 * dt * force;
            x += dt * half;
            v = (half - 0.5 * dt * x) / (1.0 + dt * zeta);
        }
    }

    #[test]
    fn restitution_is_that_of_the_integrated_impact() {
        for zeta in [
            0.01, 0.2, 0.5, 0.707, 0.9, 0.999_99, 1.0, 1.000_02, 1.5, 4.0,
        ] {
            let error = Stiffness::restitution_of(zeta) - integrated(zeta);
            assert!(error.abs() < 3e-5, "{zeta}: {error:e}");
        }
    }

    #[test]
    fn restitution_is_smooth_through_critical_damping() {
        // From both sides of both borders of the series.
        for middle in [1.0 - 1e-5, 1.0 + 1e-5] {
            let [a, b] = [middle - 1e-12, middle + 1e-12].map(Stiffness::restitution_of);
            assert!(((a - b) / a).abs() < 1e-11, "{middle}: {a} {b}");
        }
    }

    #[test]
    fn overlaps_and_forces_are_inverse() {
        for law in [Stiffness::Linear(3e3), Stiffness::Hertz(2e4)] {
            for force in [1e-3, 1.0, 40.0] {
                let overlap = law.overlap(force, 0.7);
                assert!((law.force(overlap, 0.7)[0] / force - 1.0).abs() < 1e-12);
            }
            // The energy of an impact is that of its largest overlap.
            let overlap = law.impact_overlap(0.3, 2.0, 0.7);
            let [force, _] = law.force(overlap, 0.7);
            assert!((law.energy(overlap, force) / (0.5 * 2.0 * 0.09) - 1.0).abs() < 1e-12);
        }
    }
}
