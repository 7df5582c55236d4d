//! The floor under all bodies of a world.

use crate::body::{Materials, PendingPrediction, RestingBody, TemporaryForces, is_free};
use crate::feet::{PlacedFoot, checked};
use crate::refusal::{FloorError, not_negative};
use crate::region::{Region, RegionId};
use crate::report::{Friction, Stop};
use rapier2d::data::Coarena;
use rapier2d::prelude::*;

/// The floor of a world seen from above.
///
/// Every dynamic body lies on it. Use [`Floor::step`] instead of [`PhysicsWorld::step`], or with a pipeline of
/// your own [`Floor::begin_step`], the pipeline's step and [`Floor::finish_step`].
///
/// ```
/// use rapier2d::prelude::*;
/// use tribos_rapier2d::Floor;
/// let mut world = PhysicsWorld::new();
/// world.gravity = Vector::ZERO;
/// let thrown = RigidBodyBuilder::dynamic().linvel(Vector::new(3.0, 0.0)).angvel(20.0);
/// let (box_, _) = world.insert(thrown, ColliderBuilder::cuboid(0.1, 0.1));
/// let mut floor = Floor::new(0.4, 9.81)?;
/// floor.add_region(SharedShape::ball(0.5), Pose::translation(1.0, 0.0), 0.02)?; // ice
/// floor.step(&mut world);
/// assert!(world.bodies[box_].linvel().x < 3.0);
/// # Ok::<(), tribos_rapier2d::FloorError>(())
/// ```
///
/// *State*: what friction held in the last step is part of the simulation state. To save a game, clone the floor
/// with the engine's sets, or serialise both (feature `serde-serialize`), between two steps.
#[derive(Clone, Debug)]
#[cfg_attr(
    feature = "serde-serialize",
    derive(serde::Serialize, serde::Deserialize)
)]
pub struct Floor {
    ground: Ground,
    /// Gravity towards the floor in m/s².
    gravity: f32,
    next_region: u32,
    bodies: Coarena<RestingBody>,
    /// Forces and offsets that bodies have received for the current step.
    lent: Vec<TemporaryForces>,
    #[cfg_attr(feature = "serde-serialize", serde(skip))]
    begun: Vec<PendingPrediction>,
}

/// Coefficients of friction, by place.
#[derive(Clone, Debug)]
#[cfg_attr(
    feature = "serde-serialize",
    derive(serde::Serialize, serde::Deserialize)
)]
struct Ground {
    mu: f32,
    regions: Vec<Region>,
}

impl Materials for Ground {
    fn even(&self, middle: Vector, radius: f32) -> Option<f32> {
        let is_far = |region: &Region| !region.is_near(middle, radius);
        self.regions.iter().all(is_far).then_some(self.mu)
    }

    fn at(&self, point: Vector) -> f32 {
        let region = self
            .regions
            .iter()
            .rev()
            .find(|region| region.contains(point));
        region.map_or(self.mu, |region| region.mu)
    }
}

impl Floor {
    /// A floor with the coefficient of friction `mu` under a gravity of `gravity` m/s² towards it. *Domain*:
    /// both finite and ≥ 0. In worlds whose unit is not the metre, `gravity` is in their unit per s².
    pub fn new(mu: f32, gravity: f32) -> Result<Self, FloorError> {
        Ok(Self {
            ground: Ground {
                mu: not_negative(mu, FloorError::Coefficient { given: mu })?,
                regions: Vec::new(),
            },
            gravity: not_negative(gravity, FloorError::Gravity { given: gravity })?,
            next_region: 0,
            bodies: Coarena::new(),
            lent: Vec::new(),
            begun: Vec::new(),
        })
    }

    /// Gives a part of the floor another coefficient of friction: ice, a carpet. Where regions overlap, the
    /// last one that was added counts. A body on a border is resisted by the material below each of 56 to 256
    /// points of its area.
    pub fn add_region(
        &mut self,
        shape: SharedShape,
        pose: Pose,
        mu: f32,
    ) -> Result<RegionId, FloorError> {
        let mu = not_negative(mu, FloorError::Coefficient { given: mu })?;
        let id = RegionId(self.next_region);
        self.next_region += 1;
        self.ground.regions.push(Region::new(id, shape, pose, mu));
        Ok(id)
    }

    /// Returns a region to the floor's coefficient; true if it was there.
    pub fn remove_region(&mut self, id: RegionId) -> bool {
        let before = self.ground.regions.len();
        self.ground.regions.retain(|region| region.id != id);
        self.ground.regions.len() < before
    }

    /// The coefficient of friction at a point of the floor.
    pub fn mu_at(&self, point: Vector) -> f32 {
        self.ground.at(point)
    }

    /// Gives a body its own coefficient of friction, everywhere on the floor: 0 for one that hovers.
    pub fn set_mu(&mut self, body: RigidBodyHandle, mu: f32) -> Result<(), FloorError> {
        let mu = not_negative(mu, FloorError::Coefficient { given: mu })?;
        self.lying(body).mu = Some(mu);
        Ok(())
    }

    /// Gives a body another load on the floor than its weight, in newtons: downforce, a rider.
    pub fn set_load(&mut self, body: RigidBodyHandle, load: f32) -> Result<(), FloorError> {
        let load = not_negative(load, FloorError::Load { given: load })?;
        self.lying(body).load = Some(load);
        Ok(())
    }

    /// Gives a body other areas than those of its colliders: a ring, wheels, runners.
    pub fn set_feet(
        &mut self,
        body: RigidBodyHandle,
        feet: Vec<PlacedFoot>,
    ) -> Result<(), FloorError> {
        checked(&feet)?;
        self.lying(body).feet = Some(feet);
        Ok(())
    }

    /// Returns a body to the floor's coefficient, its weight and the areas of its colliders.
    pub fn reset(&mut self, body: RigidBodyHandle) {
        let lying = self.lying(body);
        (lying.mu, lying.load, lying.feet) = (None, None, None);
    }

    /// Friction on a body in the last step. `None` for a body that was not in a step of this floor.
    pub fn friction(&self, body: RigidBodyHandle) -> Option<Friction> {
        self.bodies.get(body.0).map(|lying| lying.friction)
    }

    /// The end of a body's motion if it came to rest in the last step.
    pub fn stop(&self, body: RigidBodyHandle) -> Option<Stop> {
        self.bodies.get(body.0)?.stop
    }

    /// Advances the world by one step of its own length.
    pub fn step(&mut self, world: &mut PhysicsWorld) {
        self.step_with_events(world, &(), &());
    }

    /// The same with hooks and a listener to the engine's events.
    pub fn step_with_events(
        &mut self,
        world: &mut PhysicsWorld,
        hooks: &dyn PhysicsHooks,
        events: &dyn EventHandler,
    ) {
        let parameters = world.integration_parameters;
        let gravity = world.gravity;
        self.begin_step(gravity, &parameters, &mut world.bodies, &world.colliders);
        world.step_with_events(hooks, events);
        self.finish_step(&parameters, &mut world.bodies);
    }

    /// Predicts friction and passes it to the engine, before its step. `gravity` is that in the plane.
    ///
    /// ```
    /// use rapier2d::prelude::*;
    /// use tribos_rapier2d::Floor;
    /// let mut world = PhysicsWorld::new();
    /// world.gravity = Vector::ZERO;
    /// let body = RigidBodyBuilder::dynamic().linvel(Vector::new(1.0, 0.0));
    /// let (puck, _) = world.insert(body, ColliderBuilder::ball(0.04));
    /// let mut floor = Floor::new(0.1, 9.81)?;
    /// let parameters = world.integration_parameters;
    /// floor.begin_step(world.gravity, &parameters, &mut world.bodies, &world.colliders);
    /// world.step(); // the step of your own pipeline
    /// floor.finish_step(&parameters, &mut world.bodies);
    /// let lost = 0.1 * 9.81 / 60.0; // mu g dt
    /// assert!((world.bodies[puck].linvel().x - (1.0 - lost)).abs() < 1e-6);
    /// # Ok::<(), tribos_rapier2d::FloorError>(())
    /// ```
    pub fn begin_step(
        &mut self,
        gravity: Vector,
        parameters: &IntegrationParameters,
        bodies: &mut RigidBodySet,
        colliders: &ColliderSet,
    ) {
        // For a step that was begun and not finished.
        self.cancel_step(bodies);
        let pulls = (gravity, self.gravity);
        let free = |(handle, body): (RigidBodyHandle, &RigidBody)| is_free(body).then_some(handle);
        let free: Vec<RigidBodyHandle> = bodies.iter().filter_map(free).collect();
        for (handle, _) in bodies.iter() {
            if let Some(lying) = self.bodies.get_mut(handle.0) {
                lying.stop = None;
            }
        }
        for handle in free {
            let lying = self
                .bodies
                .ensure_element_exist(handle.0, RestingBody::default());
            let Some(body) = bodies.get_mut(handle) else {
                continue;
            };
            let begun = lying.begin(handle, body, colliders, &self.ground, pulls, parameters);
            if let Some((begun, lent)) = begun {
                self.begun.push(begun);
                self.lent.push(lent);
            }
        }
    }

    /// Corrects the motion with the pushes that the engine has found, after its step.
    pub fn finish_step(&mut self, parameters: &IntegrationParameters, bodies: &mut RigidBodySet) {
        for lent in self.lent.drain(..) {
            lent.take_back(bodies);
        }
        for begun in self.begun.drain(..) {
            let Some(lying) = self.bodies.get_mut(begun.body.0) else {
                continue;
            };
            if let Some(body) = bodies.get_mut(begun.body).filter(|body| is_free(body)) {
                lying.finish(&begun, body, parameters.dt);
            }
        }
    }

    /// Undoes the changes of [`begin_step`](Self::begin_step) to bodies, for a step that will not be taken. The
    /// next `begin_step` does the same first.
    pub fn cancel_step(&mut self, bodies: &mut RigidBodySet) {
        for lent in self.lent.drain(..) {
            lent.take_back(bodies);
        }
        self.begun.clear();
    }

    fn lying(&mut self, body: RigidBodyHandle) -> &mut RestingBody {
        self.bodies
            .ensure_element_exist(body.0, RestingBody::default())
    }
}
