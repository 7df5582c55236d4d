//! What the contacts of a packing carry.

use crate::packing::method::{FrictionCoupling, WallLaw};
use tribos_contacts::soft::Stiffness;
use tribos_core::Error;
use tribos_core::contact::{Attraction, Cohesion, NormalLaw};
use tribos_core::coupling::coulomb;
use tribos_core::law::LawError;
use tribos_core::limit_surface::{LimitEllipsoid, RoundLimitSurface};

/// The material of a packing's spheres: the law of their contacts. Any consistent units.
///
/// ```
/// use tribos::powder::{ModeSet, Material};
/// # use tribos::scene::PowderScene;
/// let powder: Material = PowderScene { mu_rolling: 0.1, ..PowderScene::default() }.material();
/// assert_eq!((powder.cohesion, powder.density), (1.0, 1.0)); // the units of a powder
/// assert_eq!(powder.carried().modes, ModeSet::SlidingRolling);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Material {
    /// Density of the spheres.
    pub density: f64,
    /// Cohesion F_coh, a force; 0 for none.
    pub cohesion: f64,
    /// Gap up to which cohesion acts.
    pub cohesion_range: f64,
    /// Cohesion at a gap.
    pub attraction: Attraction,
    /// Coefficient of restitution.
    pub restitution: f64,
    /// Sliding coefficient, of P.
    pub sliding: f64,
    /// Rolling coefficient, of P r_eff.
    pub rolling: f64,
    /// Torsion coefficient, of P r_eff.
    pub torsion: f64,
    /// How the thresholds of sliding and torsion depend on each other.
    pub coupling: FrictionCoupling,
    /// Law at walls.
    pub wall: WallLaw,
    /// Normal spring of soft contacts.
    pub stiffness: Stiffness,
}

/// Torque of pure spinning over force limit and radius, under uniform pressure.
const SPIN_TORQUE: f64 = 2.0 / 3.0;

impl Material {
    /// Laws along the normal, of pairs and at walls.
    pub(crate) fn normal_laws(&self) -> Result<[NormalLaw<f64>; 2], LawError> {
        let cohesion = if self.cohesion > 0.0 {
            Cohesion::new(self.cohesion, self.cohesion_range, self.attraction)?
        } else {
            Cohesion::NONE
        };
        let pair = NormalLaw::new(cohesion, self.restitution)?;
        let wall = match self.wall {
            WallLaw::Full | WallLaw::Smooth => pair,
            WallLaw::Bare => NormalLaw::new(Cohesion::NONE, self.restitution)?,
        };
        Ok([pair, wall])
    }

    /// Radius of the contact in r_eff that follows from its two thresholds.
    fn contact_radius(&self) -> f64 {
        self.torsion / (self.sliding * SPIN_TORQUE)
    }

    /// What a contact of a joint set carries at a coefficient, in P and P r_eff.
    pub(crate) fn ellipsoid(&self, mu: f64) -> Result<LimitEllipsoid<f64>, Error> {
        LimitEllipsoid::new(mu, self.contact_radius(), SPIN_TORQUE)
    }

    /// Exact limit surface that joins sliding and torsion at a coefficient `mu`.
    pub(crate) fn exact(
        &self,
        mu: f64,
    ) -> Result<RoundLimitSurface<f64, coulomb::CoulombDisk>, Error> {
        RoundLimitSurface::new(coulomb::CoulombDisk, mu, self.contact_radius())
    }
}
