//! The motion of the filmed body under a law, at the times of the frames.

use super::super::FitError;
use super::law::TrackLaw;
use super::march::{FilmedPlace, march};
use crate::MotionError;
use crate::slide::planar::{Launch, PlanarSimulation, PlanarState, Plate, Resistance};
use std::sync::{Arc, Mutex, PoisonError};
use tribos_core::coupling::{ReducedFriction, ReducedWrench};
use tribos_friction::{AnyFriction, Flat, Patch, RoundPower, upright};

/// Relative accuracy of the steps of bodies whose motion is not followed by the slider.
const STEP_ACCURACY: f64 = 1e-9;
/// Fraction of the initial speeds that counts as rest under laws that vanish at rest.
const STOP_FRACTION: f64 = 1e-6;
/// Times that agree within this fraction are the same.
const SAME_TIME: f64 = 1e-13;

/// A body on the floor.
#[derive(Debug)]
pub(super) struct Body {
    pub patch: Patch,
    pub law: TrackLaw,
    /// In m/s².
    pub gravity: f64,
    /// I/(M R²).
    pub inertia_ratio: f64,
    flat: Option<Flat<f64>>,
    /// The coupling of the exponent that was asked for last.
    coupling: Mutex<Option<Coupling>>,
}

/// An exponent and |v| to its power on the patch.
#[derive(Clone)]
struct Coupling(f64, Arc<dyn RoundPower<f64>>);

impl std::fmt::Debug for Coupling {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_tuple("Coupling").field(&self.0).finish()
    }
}

impl Body {
    pub fn new(
        patch: &Patch,
        law: TrackLaw,
        gravity: f64,
        inertia_ratio: f64,
    ) -> Result<Self, FitError> {
        for (name, value) in [("gravity", gravity), ("the inertia ratio", inertia_ratio)] {
            let is_valid = value > 0.0 && value.is_finite();
            if !is_valid {
                return Err(FitError::Track(format!("{name} must be > 0, not {value}")));
            }
        }
        let flat = match patch {
            Patch::Flat(flat) => Some(flat.loaded(None)?),
            Patch::Points(_) => {
                return Err(FitError::Track(
                    "points have no outline; give a round patch, a box, a bar or a polygon".into(),
                ));
            }
            _ => None,
        };
        let is_dry = law == TrackLaw::Coulomb;
        if flat.is_some() && !is_dry {
            return Err(FitError::Track(
                "a patch with straight edges is followed under coulomb alone; give --law coulomb or \
                 a round patch"
                    .into(),
            ));
        }
        let serves = match law {
            TrackLaw::Coulomb | TrackLaw::Power => true,
            TrackLaw::Viscous => patch.pressure().is_some(),
            TrackLaw::Stribeck => matches!(patch, Patch::Disk | Patch::Annulus(_)),
        };
        if !serves {
            return Err(FitError::Track(format!(
                "under {law} give --patch disk, not {patch}"
            )));
        }
        let body = Self {
            patch: patch.clone(),
            law,
            gravity,
            inertia_ratio,
            flat,
            coupling: Mutex::new(None),
        };
        Ok(body)
    }

    /// Whether it is round and has a radius to be found.
    pub fn is_round(&self) -> bool {
        self.flat.is_none()
    }

    /// Places of a round body that is launched with a speed and a rim speed, both ≥ 0.
    pub fn roll_out(
        &self,
        law: &[f64],
        speeds: [f64; 2],
        times: &[f64],
    ) -> Option<Vec<FilmedPlace>> {
        let march = |wrench: &dyn Fn(f64, f64) -> ReducedWrench<f64>| {
            march(speeds, times, &|[v, w]| {
                let at = wrench(v, w);
                [at.force, at.torque / self.inertia_ratio].map(|rate| self.gravity * rate)
            })
        };
        match (self.law, law) {
            (TrackLaw::Coulomb, &[mu, ..]) => {
                let dry = self.coupling(0.0)?;
                march(&|v, w| scaled(dry.reduced_wrench(v, w), mu))
            }
            (TrackLaw::Power, &[gamma, alpha, ..]) => {
                let power = self.coupling(alpha)?;
                march(&|v, w| scaled(power.reduced_wrench(v, w), gamma))
            }
            (TrackLaw::Viscous, &[mu, k, ..]) => {
                let dry = self.coupling(0.0)?;
                // Mean of r² under the pressure (1 − r²)^q: the torque of k v is k w times this.
                let mean_square = 1.0 / (self.patch.pressure()?.order() + 2.0);
                march(&|v, w| {
                    let dry = scaled(dry.reduced_wrench(v, w), mu);
                    ReducedWrench {
                        force: dry.force + k * v,
                        torque: dry.torque + k * mean_square * w,
                    }
                })
            }
            _ => {
                let law = self.law.at(law)?;
                let foot = AnyFriction::new(&self.patch, &law, None).ok()?;
                march(&|v, w| foot.reduced_wrench(v, w))
            }
        }
    }

    /// |v|^α on the patch, whose table is kept until another exponent is asked for.
    fn coupling(&self, alpha: f64) -> Option<Arc<dyn RoundPower<f64>>> {
        let mut kept = self.coupling.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(Coupling(_, profile)) = kept.as_ref().filter(|kept| kept.0 == alpha) {
            return Some(Arc::clone(profile));
        }
        let profile: Arc<dyn RoundPower<f64>> = Arc::from(upright(&self.patch, alpha).ok()?);
        *kept = Some(Coupling(alpha, Arc::clone(&profile)));
        Some(profile)
    }

    /// Places of a plate under Coulomb friction.
    pub fn plate(
        &self,
        mu: f64,
        launch: &Launch,
        orientation: f64,
        times: &[f64],
    ) -> Option<Vec<FilmedPlace>> {
        let plate = Plate::new(self.flat.clone()?, mu, self.gravity).ok()?;
        let plate = Coarse(plate.with_orientation(orientation));
        follow(&plate, launch, times)
    }
}

fn scaled(wrench: ReducedWrench<f64>, factor: f64) -> ReducedWrench<f64> {
    ReducedWrench {
        force: factor * wrench.force,
        torque: factor * wrench.torque,
    }
}

/// A resistance whose motion is followed no finer than a film shows, at the times of the frames.
fn follow<B: Resistance>(body: &B, launch: &Launch, times: &[f64]) -> Option<Vec<FilmedPlace>> {
    let place = |point: &PlanarState| FilmedPlace {
        way: point.position,
        turned: point.angle,
        speed: libm::hypot(point.velocity[0], point.velocity[1]),
    };
    let mut places: Vec<FilmedPlace> = Vec::with_capacity(times.len());
    let later: Vec<f64> = times.iter().copied().filter(|t| *t > 0.0).collect();
    let observe = |point: &PlanarState| {
        // Points of turns come between those that are asked for.
        let wanted = times.get(places.len()).copied();
        if wanted.is_some_and(|t| (point.time - t).abs() <= SAME_TIME * t) {
            places.push(place(point));
        }
    };
    let journey = PlanarSimulation::new(body, launch, STOP_FRACTION);
    let end = match journey.and_then(|journey| journey.follow(&later, observe)) {
        Ok(end) => place(&end.point),
        // A body that is launched without motion stays.
        Err(MotionError::NotFinite { step: 0 }) => FilmedPlace {
            way: [0.0; 2],
            turned: 0.0,
            speed: 0.0,
        },
        Err(_) => return None,
    };
    places.resize(times.len(), end);
    Some(places)
}

/// A resistance whose motion is followed no finer than a film shows.
#[derive(Debug)]
struct Coarse<B>(B);

impl<B: Resistance> Resistance for Coarse<B> {
    fn deceleration(&self, velocity: [f64; 3]) -> [f64; 3] {
        self.0.deceleration(velocity)
    }
    fn deceleration_at(&self, velocity: [f64; 3], angle: f64) -> [f64; 3] {
        self.0.deceleration_at(velocity, angle)
    }
    fn is_round(&self) -> bool {
        self.0.is_round()
    }
    fn exponent(&self) -> f64 {
        self.0.exponent()
    }
    fn inertia_ratio(&self) -> f64 {
        self.0.inertia_ratio()
    }
    fn radius(&self) -> f64 {
        self.0.radius()
    }
    fn accuracy(&self) -> f64 {
        self.0.accuracy().max(STEP_ACCURACY)
    }
}
