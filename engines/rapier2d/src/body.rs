//! One body on the floor, through one step of the engine.

use crate::feet::PlacedFoot;
use crate::report::{Friction, Stop};
use crate::shape::Derived;
use rapier2d::prelude::*;
use std::sync::Arc;
use tribos_core::contact::TimeStep;
use tribos_core::twist::{Twist, Wrench};
use tribos_feet::{Foot, Footprint, Prediction, Reduced, Stance, Standing};

/// What the floor knows of a body.
#[derive(Clone, Debug, Default)]
#[cfg_attr(
    feature = "serde-serialize",
    derive(serde::Serialize, serde::Deserialize)
)]
pub(crate) struct RestingBody {
    /// Coefficient of friction in place of the floor's.
    pub(crate) mu: Option<f32>,
    /// Load in newtons in place of the weight.
    pub(crate) load: Option<f32>,
    /// Feet in place of those of its colliders.
    pub(crate) feet: Option<Vec<PlacedFoot>>,
    #[cfg_attr(feature = "serde-serialize", serde(skip))]
    derived: Derived,
    /// Force and torque beyond the expected ones, if friction held against them in the last step.
    held: Option<[f32; 3]>,
    pub(crate) friction: Friction,
    pub(crate) stop: Option<Stop>,
}

/// A foot under a body at half of a step.
#[derive(Clone, Debug)]
pub(crate) struct FootPose {
    footprint: Footprint,
    stance: Stance,
    /// Load in newtons.
    load: f32,
    mu: Mu,
}

/// Coefficient of friction under a foot.
#[derive(Clone, Debug)]
enum Mu {
    Even(f32),
    /// Of each of its points.
    OfPoints(Vec<f32>),
}

/// Prediction made before the engine's step.
#[derive(Clone, Debug)]
pub(crate) struct PendingPrediction {
    pub(crate) body: RigidBodyHandle,
    planar: Reduced,
    step: Prediction,
    stands: Vec<FootPose>,
}

/// A body's temporary changes.
#[derive(Clone, Debug)]
#[cfg_attr(
    feature = "serde-serialize",
    derive(serde::Serialize, serde::Deserialize)
)]
pub(crate) struct TemporaryForces {
    body: RigidBodyHandle,
    /// Changes of the velocity and the spin.
    offset: (Vector, f32),
    /// Force and torque that the user had set.
    user: (Vector, f32),
}

/// Whether forces move a body.
pub(crate) fn is_free(body: &RigidBody) -> bool {
    body.is_dynamic() && body.is_enabled() && !body.is_sleeping()
}

/// A body in the plane; `None` if both its motions are locked.
fn planar(body: &RigidBody) -> Option<Reduced> {
    let properties = body.mass_properties();
    let shift = properties.effective_inv_mass.max_element();
    let turn = properties.effective_world_inv_inertia;
    Reduced::new([[shift, turn], [0.0; 2]], [0.0; 2])
}

fn motion(body: &RigidBody) -> Twist<f32> {
    let velocity = body.linvel();
    Twist::new(velocity.x, velocity.y, body.angvel())
}

/// Changes the motion of a body except along locked axes, without waking it.
fn accelerate(body: &mut RigidBody, change: (Vector, f32), sign: f32) {
    let free = body
        .mass_properties()
        .effective_inv_mass
        .cmpgt(Vector::ZERO);
    let shift = Vector::select(free, change.0 * sign, Vector::ZERO);
    body.set_linvel(body.linvel() + shift, false);
    if body.mass_properties().effective_world_inv_inertia > 0.0 {
        body.set_angvel(body.angvel() + change.1 * sign, false);
    }
}

impl TemporaryForces {
    /// Adds a friction and a velocity offset.
    fn to(body: &mut RigidBody, handle: RigidBodyHandle, step: &Prediction) -> Self {
        let user = (body.user_force(), body.user_torque());
        let Wrench { force, torque } = step.friction;
        body.add_force(Vector::new(force.x, force.y), false);
        body.add_torque(torque, false);
        let velocity = step.offset.velocity;
        let offset = (Vector::new(velocity.x, velocity.y), step.offset.spin);
        accelerate(body, offset, 1.0);
        Self {
            body: handle,
            offset,
            user,
        }
    }

    /// Restores the user's forces and removes the velocity offset. A removed body is ignored.
    pub(crate) fn take_back(self, bodies: &mut RigidBodySet) {
        let Some(body) = bodies.get_mut(self.body) else {
            return;
        };
        body.reset_forces(false);
        body.reset_torques(false);
        body.add_force(self.user.0, false);
        body.add_torque(self.user.1, false);
        // A body that fell asleep is at rest.
        if !body.is_sleeping() {
            accelerate(body, self.offset, -1.0);
        }
    }
}

/// The body on its feet.
fn standing<'a>(planar: &'a Reduced, stands: &'a [FootPose]) -> Standing<'a> {
    let planar = planar.body();
    let foot = |stand: &'a FootPose| match stand.mu {
        Mu::Even(mu) => Some(Foot {
            axis: stand.stance.axis,
            ..Foot::new(&stand.footprint, mu * stand.load, stand.stance.place)
        }),
        Mu::OfPoints(_) => None,
    };
    if let [stand] = stands
        && let Some(foot) = foot(stand)
    {
        return Standing::new(planar, None, &[foot]);
    }
    match stands.iter().map(foot).collect::<Option<Vec<_>>>() {
        Some(feet) => Standing::new(planar, None, &feet),
        None => {
            let points: Vec<_> = stands.iter().flat_map(FootPose::points).collect();
            Standing::on_points(planar, &points)
        }
    }
}

impl FootPose {
    /// A foot after half of a step, with the body's rotation in it as half of that angle in radians.
    fn new(foot: &PlacedFoot, body: &RigidBody, half: f32, load: f32) -> Self {
        let rotation = body.rotation();
        let arm = *rotation * (foot.pose.translation - body.local_center_of_mass());
        let along = *rotation * (foot.pose.rotation * Vector::X);
        // Rotated, and so of length 1.
        let stance = Stance {
            place: [arm.x, arm.y].map(f64::from),
            axis: [along.x, along.y].map(f64::from),
        };
        Self {
            footprint: foot.footprint.clone(),
            stance: stance.turned(half),
            load,
            mu: Mu::Even(0.0),
        }
    }

    /// Sets the coefficient of friction by the floor around the centre of mass `at`.
    fn set_floor_friction(&mut self, materials: &impl Materials, at: Vector) {
        let place = |[x, y]: [f64; 2]| at + Vector::new(x as f32, y as f32);
        self.mu = match materials.even(place(self.stance.place), self.footprint.radius()) {
            Some(mu) => Mu::Even(mu),
            None => {
                let mu = |point: &[f32; 3]| materials.at(place(self.point(point)));
                let of_points: Vec<f32> = self.footprint.points().iter().map(mu).collect();
                match of_points.iter().all(|mu| *mu == of_points[0]) {
                    true => Mu::Even(of_points[0]),
                    false => Mu::OfPoints(of_points),
                }
            }
        };
    }

    /// Position of a point of the footprint from the centre of mass.
    fn point(&self, &[x, y, _]: &[f32; 3]) -> [f64; 2] {
        let Stance {
            place,
            axis: [c, s],
        } = self.stance;
        let [x, y] = [x, y].map(f64::from);
        [place[0] + c * x - s * y, place[1] + s * x + c * y]
    }

    /// Places and friction limits of all points.
    fn points(&self) -> impl Iterator<Item = ([f64; 2], f32)> + '_ {
        let points = self.footprint.points().iter().enumerate();
        points.map(|(number, point)| {
            let mu = match &self.mu {
                Mu::Even(mu) => *mu,
                Mu::OfPoints(mu) => mu[number],
            };
            (self.point(point), mu * self.load * point[2])
        })
    }
}

/// The coefficient of friction of each point of the floor.
pub(crate) trait Materials {
    /// The coefficient all over a disk, if there is only one.
    fn even(&self, middle: Vector, radius: f32) -> Option<f32>;
    /// The coefficient at a point.
    fn at(&self, point: Vector) -> f32;
}

/// A coefficient wherever the body is.
pub(crate) struct UniformMu(pub(crate) f32);

impl Materials for UniformMu {
    fn even(&self, _: Vector, _: f32) -> Option<f32> {
        Some(self.0)
    }

    fn at(&self, _: Vector) -> f32 {
        self.0
    }
}

impl RestingBody {
    /// Passes the friction of the coming step to the engine; `weight` is the gravity towards the floor in m/s².
    pub(crate) fn begin(
        &mut self,
        handle: RigidBodyHandle,
        body: &mut RigidBody,
        colliders: &ColliderSet,
        materials: &impl Materials,
        (gravity, weight): (Vector, f32),
        parameters: &IntegrationParameters,
    ) -> Option<(PendingPrediction, TemporaryForces)> {
        let planar = planar(body)?;
        let dt = TimeStep::new(parameters.dt).ok()?;
        let load = self.load.unwrap_or(weight * body.mass());
        let derived: Arc<[PlacedFoot]>;
        let feet = match &self.feet {
            Some(feet) => &feet[..],
            None => {
                self.derived.renew(body, colliders);
                derived = self.derived.feet.clone();
                &derived
            }
        };
        let whole: f32 = feet.iter().map(|foot| foot.share).sum();
        let half_turn = 0.25 * parameters.dt * body.angvel();
        // The materials halfway along the step.
        let at = body.center_of_mass() + body.linvel() * (0.5 * parameters.dt);
        let stand = |foot: &PlacedFoot| {
            let mut stand = FootPose::new(foot, body, half_turn, load * (foot.share / whole));
            let material = self.mu.map(UniformMu);
            match material {
                Some(everywhere) => stand.set_floor_friction(&everywhere, at),
                None => stand.set_floor_friction(materials, at),
            }
            stand
        };
        let stands: Vec<FootPose> = feet.iter().map(stand).collect();
        if stands.is_empty() {
            return None;
        }
        let before = motion(body);
        let held = self.held.map(|[x, y, torque]| Wrench::new(x, y, torque));
        let substeps = parameters.num_solver_iterations + body.additional_solver_iterations();
        let expected = expected(body, &planar, gravity);
        let step =
            standing(&planar, &stands).predict(&before, &expected, held, dt, substeps.max(1))?;
        let lent = TemporaryForces::to(body, handle, &step);
        let begun = PendingPrediction {
            body: handle,
            planar,
            step,
            stands,
        };
        Some((begun, lent))
    }

    /// Corrects the step with the pushes that the engine has found.
    pub(crate) fn finish(
        &mut self,
        begun: &PendingPrediction,
        body: &mut RigidBody,
        dt: f32,
    ) -> Option<()> {
        let step = &begun.step;
        let standing = standing(&begun.planar, &begun.stands);
        let end = standing.correct(Some(step), &motion(body), TimeStep::new(dt).ok()?)?;
        let velocity = end.change.velocity;
        accelerate(
            body,
            (Vector::new(velocity.x, velocity.y), end.change.spin),
            1.0,
        );
        let holds = end.ended.is_at_rest();
        self.stop = (holds && !self.friction.holds).then(|| Stop {
            within_step: standing.share_until_rest(Some(step), &end) * dt,
        });
        let Wrench { force, torque } = end.ended.friction;
        self.friction = Friction {
            force: Vector::new(force.x, force.y),
            torque,
            load: begun.stands.iter().map(|stand| stand.load).sum(),
            holds,
        };
        self.held = end
            .held
            .map(|held| [held.force.x, held.force.y, held.torque]);
        Some(())
    }
}

/// Expected push of gravity in the plane and the user's forces.
fn expected(body: &RigidBody, planar: &Reduced, gravity: Vector) -> Wrench<f32> {
    let linear = gravity * body.gravity_scale() + body.user_force() / body.mass();
    let angular = body.mass_properties().effective_world_inv_inertia * body.user_torque();
    let change = Twist::new(linear.x, linear.y, angular);
    planar.push(&change, 1.0)
}
