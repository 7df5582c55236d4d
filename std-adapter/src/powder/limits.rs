//! What the friction of a contact is compared with.

use super::packing::{ellipsoid, exact};
use crate::record::{ContactRow, Partner};
use crate::scene::{Coupling, PowderScene, WallLaw};
use nalgebra::Vector3;
use tribos_core::coupling::table;
use tribos_core::limit_surface::{Ellipsoid, FrictionSet, LimitSurface};
use tribos_core::twist::Wrench;

/// Contacts whose P, in F_coh, is less carry nothing: cohesion pulls them together in vain.
const IDLE: f64 = 1e-9;
/// A force this near its threshold, relatively, is at it: more than what a turn of the normal in a
/// step takes off.
const AT_THRESHOLD: f64 = 1.0 - 1e-3;

/// Thresholds of sliding, rolling and torsion of the contacts of a powder. A load counts as at its
/// threshold from 99.9 % of it on.
///
/// ```
/// use nalgebra::Vector3;
/// use tribos::powder::Limits;
/// use tribos::record::{ContactRow, Partner};
/// # use tribos::scene::{Coupling, PowderScene};
/// // A push of 1 and the cohesion of 1 allow 0.3 · 2 of sliding and, on spheres of radius 1,
/// // 0.5 · 2/2 of torsion: 0.6 and 0.8 of them are at work.
/// let (a, b, normal) = (0, Partner::Particle(1), Vector3::x());
/// let (force, torque) = (Vector3::new(1.0, 0.36, 0.0), Vector3::new(0.4, 0.0, 0.0));
/// let contact = ContactRow { a, b, normal, gap: 0.0, force, torque };
/// for (coupling, reached) in [(Coupling::Independent, false), (Coupling::Ellipsoid, true)] {
///     let scene = PowderScene { torsion: 0.5, coupling, ..PowderScene::default() };
///     let limits = Limits::of(&scene);
///     assert_eq!(limits.resists(), [true, false, true]); // there is no rolling friction
///     assert_eq!(limits.reached(&contact, &[1.0; 2]), Some([reached, false, reached]));
/// }
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Limits {
    friction: [f64; 3],
    joint: Option<Joint>,
    /// Cohesion acts up to this gap.
    range: f64,
    rough_walls: bool,
}

/// What sliding force over P and torsion torque over P r_eff have for a common threshold.
#[derive(Clone, Copy, Debug)]
enum Joint {
    Ellipsoid(Ellipsoid<f64>),
    Exact(LimitSurface<f64, table::Coulomb>),
}

impl Limits {
    /// Those of a scene.
    pub fn of(scene: &PowderScene) -> Self {
        // A scene whose set the kernel refuses has no packing, thus no contacts.
        let joint = match scene.carried().coupling {
            Coupling::Independent => None,
            Coupling::Ellipsoid => ellipsoid(scene, scene.sliding).ok().map(Joint::Ellipsoid),
            Coupling::Exact => exact(scene, scene.sliding).ok().map(Joint::Exact),
        };
        Self {
            friction: [scene.sliding, scene.rolling, scene.torsion],
            joint,
            range: scene.cohesion_range,
            rough_walls: scene.wall == WallLaw::Full,
        }
    }

    /// Which modes resist between spheres.
    pub fn resists(&self) -> [bool; 3] {
        self.friction.map(|mu| mu > 0.0)
    }

    /// Which of the modes that resist are at their thresholds, `radii` being those of all spheres.
    /// Where sliding and torsion share one they reach it together. `None` where a contact carries
    /// nothing, and at smooth walls.
    pub fn reached(&self, contact: &ContactRow, radii: &[f64]) -> Option<[bool; 3]> {
        let resists = matches!(contact.b, Partner::Particle(_)) || self.rough_walls;
        let loads = relative_loads(contact, radii, self.range).filter(|_| resists)?;
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
}

impl Joint {
    /// 1 where the relative loads of sliding and torsion lie on the set's surface.
    fn gauge(&self, [force, _, torque]: [f64; 3]) -> f64 {
        let wrench = Wrench::new(force, 0.0, torque);
        match self {
            Self::Ellipsoid(set) => set.gauge(&wrench),
            Self::Exact(set) => set.gauge(&wrench),
        }
    }
}

/// Sliding force over P, rolling and torsion torque over P r_eff: what coefficients are compared
/// with. `None` where the contact carries nothing.
fn relative_loads(contact: &ContactRow, radii: &[f64], range: f64) -> Option<[f64; 3]> {
    let bound = contact.normal_force() + if contact.gap <= range { 1.0 } else { 0.0 };
    if bound.is_nan() || bound <= IDLE {
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
