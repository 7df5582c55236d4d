//! Avian, alone and with patches, before the problems of friction-answers:
//!
//! `cargo build --release --manifest-path engines/Cargo.toml -p tribos-bevy --example avian_answers`, then
//! `friction-answers run engines/target/release/examples/libavian_answers.so`.

use avian3d::prelude::*;
use bevy::prelude::*;
use bevy::time::TimeUpdateStrategy;
use bevy::transform::TransformPlugin;
use core::ffi::CStr;
use core::time::Duration;
use friction_answers_engine::{Body, Engine, FOOT, Scene, Shape, State};
use tribos_bevy::{FrictionPatch, FrictionPatchPlugin};

/// Radius of the patch of a foot, in m: a point.
const POINT: f32 = 1e-4;
/// Substeps of the settings, and whether they have patches.
const SETTINGS: [(u32, bool); 6] = [
    (6, false),
    (12, false),
    (12, false),
    (6, true),
    (6, true),
    (12, true),
];

struct Avian {
    app: App,
    bodies: Vec<Entity>,
}

fn vector(v: [f64; 3]) -> Vec3 {
    Vec3::from(v.map(|part| part as f32))
}

fn numbers(v: Vec3) -> [f64; 3] {
    v.to_array().map(f64::from)
}

fn patches(body: &Body, mu: f32) -> Option<FrictionPatch> {
    match body.shape {
        Shape::Box([x, _, z]) => {
            let (x, z) = (x as f32, z as f32);
            FrictionPatch::polygon(mu, &[[-x, -z], [x, -z], [x, z], [-x, z]]).ok()
        }
        Shape::Cylinder(radius, _, true) => FrictionPatch::ring(mu, radius as f32).ok(),
        Shape::Cylinder(radius, _, false) if body.pose[3] == 1.0 => {
            FrictionPatch::disk(mu, radius as f32).ok()
        }
        // On its side.
        Shape::Cylinder(_, half, _) => FrictionPatch::bar(mu, half as f32)
            .ok()?
            .oriented(Dir3::NEG_Z, Dir3::Y)
            .ok(),
        _ => None,
    }
}

impl Avian {
    fn add(&mut self, body: &Body, mu: f32, is_patched: bool) -> Entity {
        let kind = if body.is_driven {
            RigidBody::Kinematic
        } else {
            RigidBody::Dynamic
        };
        let pose = Quat::from_array(body.pose.map(|part| part as f32));
        let [x, y, z] = body.inertia.map(|part| part as f32);
        let bundle = (
            kind,
            (NoAutoMass, NoAutoAngularInertia, NoAutoCenterOfMass),
            (
                Mass(body.mass as f32),
                AngularInertia::new(Vec3::new(x, y, z)),
                CenterOfMass(vector(body.com)),
            ),
            (Friction::new(mu), Restitution::ZERO, SleepingDisabled),
            ConstantForce::default(),
            Transform::from_translation(vector(body.place)).with_rotation(pose),
        );
        let world = self.app.world_mut();
        let collider = match body.shape {
            Shape::Box([x, y, z]) => {
                Collider::cuboid(2.0 * x as f32, 2.0 * y as f32, 2.0 * z as f32)
            }
            Shape::Cylinder(radius, half, _) => {
                Collider::cylinder(radius as f32, 2.0 * half as f32)
            }
            Shape::Ball(radius) => Collider::sphere(radius as f32),
            Shape::Capsule(radius, half) => Collider::compound(vec![(
                Vec3::ZERO,
                Quat::from_rotation_z(core::f32::consts::FRAC_PI_2),
                Collider::capsule(radius as f32, 2.0 * half as f32),
            )]),
            Shape::Feet(feet) => {
                let body = world.spawn(bundle).id();
                for [x, z] in feet {
                    let at = Transform::from_translation(vector([x, 0.0, z]));
                    let mut foot = world.spawn((
                        Collider::sphere(FOOT as f32),
                        Friction::new(mu),
                        at,
                        ChildOf(body),
                    ));
                    if let Some(patch) = FrictionPatch::disk(mu, POINT).ok().filter(|_| is_patched)
                    {
                        foot.insert(patch);
                    }
                }
                return body;
            }
        };
        let mut made = world.spawn((bundle, collider));
        if let Some(patch) = patches(body, mu).filter(|_| is_patched && !body.is_driven) {
            made.insert(patch);
        }
        made.id()
    }
}

impl Engine for Avian {
    const ABOUT: &CStr = c"{\"name\": \"Avian\", \"version\": \"0.7\", \"licence\": \"MIT OR Apache-2.0\", \"kind\": \"games\", \"settings\": {\
        \"default\": {\"dt\": 0.015625, \"substeps\": 6}, \
        \"240 Hz, 12 substeps\": {\"dt\": 0.004166666666666667, \"substeps\": 12}, \
        \"1 ms, 12 substeps\": {\"dt\": 0.001, \"substeps\": 12}, \
        \"tribos-bevy\": {\"engine\": \"Avian with tribos\", \"dt\": 0.015625, \"substeps\": 6}, \
        \"tribos-bevy, 240 Hz\": {\"engine\": \"Avian with tribos\", \"dt\": 0.004166666666666667, \"substeps\": 6}, \
        \"tribos-bevy, 1 ms\": {\"engine\": \"Avian with tribos\", \"dt\": 0.001, \"substeps\": 12}}}";

    fn new(scene: &Scene) -> Result<Self, &'static CStr> {
        let mut app = App::new();
        app.add_plugins((
            MinimalPlugins,
            TransformPlugin,
            PhysicsPlugins::default(),
            FrictionPatchPlugin,
        ));
        let step = Duration::from_secs_f64(scene.dt);
        app.insert_resource(Time::<Fixed>::from_duration(step));
        app.insert_resource(TimeUpdateStrategy::ManualDuration(step));
        app.insert_resource(Gravity(vector(scene.gravity)));
        let (substeps, is_patched) = SETTINGS[scene.setting];
        app.insert_resource(SubstepCount(substeps));
        let mu = scene.mu as f32;
        if scene.has_floor {
            app.world_mut().spawn((
                RigidBody::Static,
                // A wide cuboid has now and then a contact with one of its sides.
                Collider::half_space(Vec3::Y),
                Friction::new(mu),
            ));
        }
        let mut made = Self {
            app,
            bodies: Vec::new(),
        };
        for body in &scene.bodies {
            let entity = made.add(body, mu, is_patched);
            made.bodies.push(entity);
        }
        made.app.finish();
        made.app.cleanup();
        // The first update advances no time.
        made.app.update();
        Ok(made)
    }

    fn set(&mut self, body: usize, velocity: [f64; 3], spin: [f64; 3]) {
        let motion = (
            LinearVelocity(vector(velocity)),
            AngularVelocity(vector(spin)),
        );
        self.app
            .world_mut()
            .entity_mut(self.bodies[body])
            .insert(motion);
    }

    fn step(&mut self) {
        self.app.update();
    }

    fn state(&self, body: usize) -> State {
        let body = self.app.world().entity(self.bodies[body]);
        let pose = body
            .get::<Rotation>()
            .map_or(Quat::IDENTITY, |rotation| rotation.0);
        let place = body
            .get::<Position>()
            .map_or(Vec3::NAN, |position| position.0);
        let com = body.get::<CenterOfMass>().map_or(Vec3::ZERO, |com| com.0);
        State {
            place: numbers(place + pose * com),
            pose: pose.to_array().map(f64::from),
            velocity: numbers(body.get::<LinearVelocity>().map_or(Vec3::NAN, |v| v.0)),
            spin: numbers(body.get::<AngularVelocity>().map_or(Vec3::NAN, |w| w.0)),
        }
    }

    fn gravity(&mut self, gravity: [f64; 3]) {
        self.app.insert_resource(Gravity(vector(gravity)));
    }

    fn force(&mut self, body: usize, force: [f64; 3]) {
        self.app
            .world_mut()
            .entity_mut(self.bodies[body])
            .insert(ConstantForce(vector(force)));
    }
}

friction_answers_engine::export!(Avian);
