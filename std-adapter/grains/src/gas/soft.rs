//! Collisions of soft particles: their springs, how long they last and how deep they go.

use crate::gas::scene::{GasMethod, GasScene};
use crate::packing::Springs;
use crate::packing::method::NormalForce;
use nalgebra::Vector3;
use std::f64::consts::PI;
use tribos_contacts::cd::{StepLimits, solid};
use tribos_contacts::soft::{StepLength, Stiffness};
use tribos_core::contact::{Cohesion, SphereBody};

/// Effective mass and radius of a pair of spheres of mass 1 and radius 1.
const PAIR: f64 = 0.5;
/// Mean normal speed of a collision in a gas of temperature 1, √π.
const USUAL_SPEED: f64 = 1.772_453_850_905_516;
/// Speed of the fastest of some thousand spheres in a gas of temperature 1.
const FASTEST: f64 = 4.0;
/// Duration of an undamped Hertz collision over its largest overlap and speed:
/// 4 √π Γ(2/5)/(5 Γ(9/10)) (Landau and Lifshitz, Theory of Elasticity, § 9).
const HERTZ_DURATION: f64 = 2.943_275_3;

/// A usual head-on collision of soft particles at the temperature of the start, without its losses.
///
/// *Units*: R and R √(m/T0).
///
/// ```
/// use tribos::gas::soft_collision;
/// use tribos::scene::{GasMethod, GasScene};
/// let soft = GasScene { method: GasMethod::Soft, stiffness: 1e4, ..GasScene::default() };
/// let hit = soft_collision(&soft).ok_or("no springs")?;
/// // π √(m/(2 k)) and √(π m/(2 k)).
/// assert!((hit.duration - 0.022214).abs() < 1e-6 && (hit.overlap - 0.012533).abs() < 1e-6);
/// assert!(hit.step < hit.duration / 34.9);
/// # Ok::<(), &str>(())
/// ```
#[doc(hidden)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SoftCollision {
    /// Largest overlap.
    pub overlap: f64,
    /// How long the spheres touch.
    pub duration: f64,
    /// Time step at the start.
    pub step: f64,
}

/// What springs make of a usual collision; `None` of a method without springs.
#[doc(hidden)]
pub fn soft_collision(scene: &GasScene) -> Option<SoftCollision> {
    if scene.method != GasMethod::Soft {
        return None;
    }
    let stiffness = stiffness(scene);
    let overlap = stiffness.impact_overlap(USUAL_SPEED, PAIR, PAIR);
    let factor = match stiffness {
        Stiffness::Linear(_) => PI,
        Stiffness::Hertz(_) => HERTZ_DURATION,
    };
    let sphere = SphereBody {
        velocity: Vector3::x() * FASTEST,
        ..solid(1.0, 3.0 / (4.0 * PI))
    };
    let length = StepLength::of_spheres(
        (stiffness, Stiffness::damping_ratio_of(scene.restitution)),
        [1.0; 2],
        Cohesion::NONE,
        scene.steps_per_collision,
    );
    Some(SoftCollision {
        overlap,
        duration: factor * overlap / USUAL_SPEED,
        step: length.next(&[sphere], &[], 0.0, &[]),
    })
}

/// The springs of the spheres, in steps of which each is counted and none is longer than `longest`.
pub(super) fn springs(scene: &GasScene, longest: f64) -> Springs {
    Springs {
        // The restitution is above 0 and decides.
        damping: 1.0,
        steps_per_collision: scene.steps_per_collision,
        step_limits: StepLimits {
            // A stable step of the spheres is one of the gas, so that no collision passes between two looks.
            motion: 0.0,
            longest,
        },
    }
}

pub(super) fn stiffness(scene: &GasScene) -> Stiffness {
    match scene.normal_law {
        NormalForce::Linear => Stiffness::Linear(scene.stiffness),
        NormalForce::Hertz => Stiffness::Hertz(scene.stiffness),
    }
}
