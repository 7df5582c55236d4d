//! Effective masses: how the relative velocity of a contact responds to its impulses.
//!
//! For spheres the normal mode and torsion are independent of all others. Sliding and rolling are coupled by
//! k = R₁/I₁ − R₂/I₂: a rolling torque T changes the sliding velocity by k T × n, a sliding force F
//! the rolling velocity by k n × F. For equal spheres k = 0, which is why methods that leave the
//! coupling out are limited to them (thesis, section 5.2).

use super::body::ContactBody;
use super::geometry::ContactGeometry;
use crate::real::Real;

/// Effective masses of one contact: how its relative velocity responds to its impulses.
///
/// *Units*: mass, mass, mass·length², 1/(mass·length).
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Block<R> {
    /// Effective mass along the normal.
    pub mass_normal: R,
    /// Effective mass across it.
    pub mass_sliding: R,
    /// Effective moment of inertia, of rolling and of torsion.
    pub inertia: R,
    /// Coupling k of sliding and rolling.
    pub coupling: R,
}

impl<R: Real> Block<R> {
    /// The block of two bodies.
    ///
    /// *Special values*: a mode that nothing can move has the mass 0, so that it takes no impulse.
    pub fn new(
        touch: &ContactGeometry<R>,
        a: &impl ContactBody<R>,
        b: &impl ContactBody<R>,
    ) -> Self {
        let [arm_a, arm_b] = touch.arms;
        let (turn_a, turn_b) = (a.inv_inertia(), b.inv_inertia());
        Self {
            mass_normal: mass(a.inv_mass_normal() + b.inv_mass_normal()),
            mass_sliding: mass(
                a.inv_mass_tangential()
                    + b.inv_mass_tangential()
                    + arm_a * arm_a * turn_a
                    + arm_b * arm_b * turn_b,
            ),
            inertia: mass(turn_a + turn_b),
            coupling: arm_a * turn_a - arm_b * turn_b,
        }
    }

    /// The effective masses of sliding and torsion.
    #[inline(always)]
    pub fn masses(&self) -> Masses<R> {
        Masses {
            sliding: self.mass_sliding,
            torsion: self.inertia,
        }
    }
}

/// Effective masses of sliding and torsion: the metric in which friction is projected.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Masses<R> {
    /// A mass.
    pub sliding: R,
    /// A moment of inertia.
    pub torsion: R,
}

impl<R: Real> Masses<R> {
    /// The lever at which a force costs as much as a torque: √(I/m_t). 0 where nothing can turn.
    pub fn gyration(&self) -> R {
        (self.torsion / self.sliding).sqrt()
    }
}

/// The inverse of a mass' inverse; 0 for what cannot move.
fn mass<R: Real>(inverse: R) -> R {
    if inverse == R::ZERO {
        R::ZERO
    } else {
        R::ONE / inverse
    }
}
