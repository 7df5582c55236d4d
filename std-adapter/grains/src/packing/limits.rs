//! Friction thresholds of the contacts of a packing.

use super::Material;
use crate::packing::method::{FrictionCoupling, WallLaw};
use nalgebra::Vector3;
use tribos_base::record::{ContactRow, Partner};
use tribos_core::coupling::coulomb;
use tribos_core::limit_surface::{FrictionSet, LimitEllipsoid, RoundLimitSurface};
use tribos_core::twist::Wrench;

/// A contact whose P is below this value, in F_coh, carries no force although cohesion pulls.
const IDLE: f64 = 1e-9;
/// A force within this relative distance of its threshold counts as at the threshold: more than a step's
/// rotation of the normal takes off it.
const AT_THRESHOLD: f64 = 1.0 - 1e-3;

/// Thresholds of sliding, rolling and torsion of the contacts of a packing. A load of 99.9 % of its
/// threshold or more counts as at the threshold.
///
/// ```
/// use nalgebra::Vector3;
/// use tribos::powder::Limits;
/// use tribos::record::{ContactRow, Partner};
/// # use tribos::scene::{FrictionCoupling, PowderScene};
/// // A push of 1 and the cohesion of 1 allow 0.3 · 2 of sliding and, on spheres of radius 1,
/// // 0.5 · 2/2 of torsion: 0.6 and 0.8 of them are at work.
/// let (a, b, normal) = (0, Partner::Particle(1), Vector3::x());
/// let (force, torque) = (Vector3::new(1.0, 0.36, 0.0), Vector3::new(0.4, 0.0, 0.0));
/// let contact = ContactRow { a, b, normal, gap: 0.0, force, torque };
/// for (coupling, reached) in [(FrictionCoupling::Independent, false), (FrictionCoupling::Ellipsoid, true)] {
///     let scene = PowderScene { mu_torsion: 0.5, coupling, ..PowderScene::default() };
///     let limits = Limits::of(&scene.material());
///     assert_eq!(limits.resists(), [true, false, true]); // there is no rolling friction
///     assert_eq!(limits.reached(&contact, &[1.0; 2]), Some([reached, false, reached]));
/// }
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Limits {
    friction: [f64; 3],
    joint: Option<CommonThreshold>,
    /// Cohesion, and the largest gap at which it acts.
    cohesion: f64,
    range: f64,
    rough_walls: bool,
}

/// Common threshold of the sliding force over P and the torsion torque over P r_eff.
#[derive(Clone, Copy, Debug)]
enum CommonThreshold {
    Ellipsoid(LimitEllipsoid<f64>),
    Exact(RoundLimitSurface<f64, coulomb::CoulombDisk>),
}

impl Limits {
    /// Thresholds of a material.
    pub fn of(material: &Material) -> Self {
        // If the kernel refuses a material's set, there is no packing and hence no contact.
        let mu = material.sliding;
        let joint = match material.carried().coupling {
            FrictionCoupling::Independent => None,
            FrictionCoupling::Ellipsoid => {
                material.ellipsoid(mu).ok().map(CommonThreshold::Ellipsoid)
            }
            FrictionCoupling::Exact => material.exact(mu).ok().map(CommonThreshold::Exact),
        };
        Self {
            friction: [mu, material.rolling, material.torsion],
            joint,
            cohesion: material.cohesion,
            range: material.cohesion_range,
            rough_walls: material.wall == WallLaw::Full,
        }
    }

    /// Modes with friction between spheres.
    pub fn resists(&self) -> [bool; 3] {
        self.friction.map(|mu| mu > 0.0)
    }

    /// Modes with friction that are at their thresholds; `radii` are those of all spheres.
    /// Sliding and torsion with a common threshold reach it together. `None` if a contact carries
    /// no force, and at smooth walls.
    pub fn reached(&self, contact: &ContactRow, radii: &[f64]) -> Option<[bool; 3]> {
        let resists = matches!(contact.b, Partner::Particle(_)) || self.rough_walls;
        let loads = self.relative_loads(contact, radii).filter(|_| resists)?;
        let is_at = |mode: usize| {
            let mu = self.friction[mode];
            mu > 0.0 && loads[mode] >= AT_THRESHOLD * mu
        };
        let mut reached = [0, 1, 2].map(is_at);
        if let Some(joint) = &self.joint {
            reached[0] = joint.gauge(loads) >= AT_THRESHOLD;
            reached[2] = reached[0];
        }
        Some(reached)
    }

    /// Sliding force over P, rolling and torsion torque over P r_eff, to be compared with the coefficients.
    /// `None` if the contact carries no force.
    fn relative_loads(&self, contact: &ContactRow, radii: &[f64]) -> Option<[f64; 3]> {
        let pulled = if contact.gap <= self.range {
            self.cohesion
        } else {
            0.0
        };
        let bound = contact.normal_force() + pulled;
        if bound.is_nan() || bound <= IDLE * self.cohesion {
            return None;
        }
        let [ra, rb] = [Some(contact.a), contact.b.particle()]
            .map(|body| body.map_or(f64::INFINITY, |body| radii[body as usize]));
        let lever = bound / (1.0 / ra + 1.0 / rb);
        let across = |v: &Vector3<f64>| (v - contact.normal * v.dot(&contact.normal)).norm();
        let torsion = contact.torque.dot(&contact.normal).abs();
        Some([
            across(&contact.force) / bound,
            across(&contact.torque) / lever,
            torsion / lever,
        ])
    }
}

impl CommonThreshold {
    /// 1 if the relative loads of sliding and torsion lie on the surface of the set.
    fn gauge(&self, [force, _, torque]: [f64; 3]) -> f64 {
        let wrench = Wrench::new(force, 0.0, torque);
        match self {
            Self::Ellipsoid(set) => set.gauge(&wrench),
            Self::Exact(set) => set.gauge(&wrench),
        }
    }
}
