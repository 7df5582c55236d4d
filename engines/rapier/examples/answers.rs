//! The scenes of the reference answers in Rapier, alone and with patches, as CSV.
//!
//! `cargo run --release --manifest-path engines/Cargo.toml -p tribos-rapier --example answers tests/answers/v1`

use rapier3d::prelude::*;
use std::collections::HashMap;
use std::error::Error;
use std::path::Path;
use std::time::Instant;
use tribos_rapier::{Patch, PatchContacts};

const STEP: f32 = 1.0 / 240.0; // s
/// As in `engines/ranking/scenes.py`: half the height of a flat body, radius of a foot, half width of the bar, in m.
const HALF_HEIGHT: f32 = 0.01;
const FOOT: f32 = 0.01;
const BLADE: f32 = 0.001;
/// Below this part of the speed of the launch a body rests.
const STILL: f32 = 1e-3;
const SETTLE: f32 = 0.5; // s
/// Thickness of the ground in m.
const GROUND: f32 = 0.1;

/// A shape of a body, and its patch.
type Foot = (ColliderBuilder, Option<Patch>);
type Answers = HashMap<(String, String, String), f64>;

/// Parameters of a scene.
#[derive(Clone, Debug, Default)]
struct Scene {
    name: String,
    texts: HashMap<String, String>,
}

impl Scene {
    fn number(&self, name: &str) -> f32 {
        self.texts
            .get(name)
            .and_then(|text| text.parse().ok())
            .unwrap_or(0.0)
    }

    fn feet(&self) -> Vec<[f32; 2]> {
        (1..4)
            .map(|i| [format!("foot_{i}_x"), format!("foot_{i}_y")])
            .filter(|[x, _]| self.texts.contains_key(x))
            .map(|place| place.map(|key| self.number(&key)))
            .collect()
    }

    fn half_sides(&self) -> Option<[f32; 2]> {
        match self.name.as_str() {
            "box" | "plank" => Some([self.number("corner_1_x"), self.number("corner_1_y")]),
            "bar" => Some([self.number("end_1_x"), BLADE]),
            _ => None,
        }
    }

    fn is_ball(&self) -> bool {
        self.name == "ball"
    }

    /// Height of the middle of the shape.
    fn middle(&self) -> f32 {
        match self.name.as_str() {
            "ball" => self.number("radius"),
            "tall" => self.number("height"),
            "tripod" | "three_ball" | "three_ball_low" => FOOT,
            _ => HALF_HEIGHT,
        }
    }

    fn gyration_sq(&self) -> f32 {
        match (self.name.as_str(), self.half_sides()) {
            ("bar", Some([x, _])) => x * x / 3.0,
            (_, Some([x, y])) => (x * x + y * y) / 3.0,
            ("ball", _) => 0.4 * self.number("radius").powi(2),
            _ => self.number("gyration_sq"),
        }
    }

    /// Of 1 kg, about y, which is up.
    fn mass_properties(&self) -> MassProperties {
        let upright = self.gyration_sq();
        let height = self.number("height");
        let level = if self.is_ball() {
            upright
        } else {
            (0.5 * upright + height * height / 3.0).max(0.55 * upright)
        };
        let low = if self.is_ball() {
            0.0
        } else {
            height - self.middle()
        };
        MassProperties::new(
            Vector::new(0.0, low, 0.0),
            1.0,
            Vector::new(level, upright, level),
        )
    }

    /// Shapes about the middle of the body, with their patches.
    fn shapes(&self) -> Result<Vec<Foot>, Box<dyn Error>> {
        let (mu, radius) = (self.number("mu"), self.number("radius"));
        let feet = self.feet();
        if !feet.is_empty() {
            return feet
                .into_iter()
                .map(|[x, y]| {
                    let ball = ColliderBuilder::ball(FOOT).translation(Vector::new(x, 0.0, -y));
                    Ok((ball, Some(Patch::disk(mu, 1e-4)?)))
                })
                .collect();
        }
        Ok(vec![match (self.name.as_str(), self.half_sides()) {
            ("ball", _) => (ColliderBuilder::ball(radius), None),
            ("bar", Some([x, y])) => (
                ColliderBuilder::cuboid(x, HALF_HEIGHT, y),
                Some(Patch::bar(mu, x)?),
            ),
            (_, Some([x, y])) => {
                let corners = [[-x, -y], [x, -y], [x, y], [-x, y]];
                (
                    ColliderBuilder::cuboid(x, HALF_HEIGHT, y),
                    Some(Patch::polygon(mu, &corners, 2)?),
                )
            }
            ("ring", _) => (
                ColliderBuilder::cylinder(HALF_HEIGHT, radius),
                Some(Patch::ring(mu, radius)?),
            ),
            _ => (
                ColliderBuilder::cylinder(self.middle(), radius),
                Some(Patch::disk(mu, radius)?),
            ),
        }])
    }
}

/// A body on the ground that has settled.
struct Stage {
    world: PhysicsWorld,
    body: RigidBodyHandle,
    patches: PatchContacts,
}

impl Stage {
    fn new(scene: &Scene, is_patched: bool) -> Result<Self, Box<dyn Error>> {
        let mut world = PhysicsWorld::new();
        world.gravity = Vector::new(0.0, -scene.number("g"), 0.0);
        world.integration_parameters.dt = STEP;
        let mu = scene.number("mu");
        let ground = ColliderBuilder::cuboid(50.0, GROUND, 50.0).friction(mu);
        let (_, ground) = world.insert(RigidBodyBuilder::fixed(), ground);
        let body = RigidBodyBuilder::dynamic()
            .translation(Vector::new(0.0, GROUND + scene.middle(), 0.0))
            .additional_mass_properties(scene.mass_properties())
            .allow_fast_rotation(true)
            .can_sleep(false);
        let body = world.insert_body(body);
        let mut patches = PatchContacts::new();
        for (shape, patch) in scene.shapes()? {
            let foot = world.insert_collider(shape.density(0.0).friction(mu), Some(body));
            if let Some(patch) = patch.filter(|_| is_patched) {
                patches.insert(foot, ground, patch, &world.bodies, &mut world.colliders)?;
            }
        }
        let mut stage = Self {
            world,
            body,
            patches,
        };
        for _ in 0..(SETTLE / STEP) as usize {
            stage.step();
        }
        Ok(stage)
    }

    fn step(&mut self) {
        self.patches.step(&mut self.world);
    }

    /// Along x; the spin is about y, of a ball about the axis across that rolls it forwards.
    fn launch(&mut self, scene: &Scene, spin: f32) {
        let turn = if scene.is_ball() {
            Vector::new(0.0, 0.0, -spin)
        } else {
            Vector::new(0.0, spin, 0.0)
        };
        let body = &mut self.world.bodies[self.body];
        body.set_linvel(Vector::new(scene.number("speed"), 0.0, 0.0), true);
        body.set_angvel(turn, true);
    }

    /// Along, left, yaw.
    fn pose(&self) -> [f32; 3] {
        let body = &self.world.bodies[self.body];
        let place = body.center_of_mass();
        let ahead = body.rotation() * Vector::new(1.0, 0.0, 0.0);
        [place.x, -place.z, (-ahead.z).atan2(ahead.x)]
    }
}

fn print_row(way: &str, scene: &str, spin: &str, quantity: &str, value: f64) {
    let repaired = u8::from(way != "alone");
    println!("{way},{repaired},{scene},{spin},{quantity},{value:.8}");
}

fn throw(way: &str, scene: &Scene, spin: &str, exact: &Answers) -> Result<(), Box<dyn Error>> {
    let answer = |quantity: &str| {
        exact
            .get(&(scene.name.clone(), spin.into(), quantity.into()))
            .copied()
    };
    let mut stage = Stage::new(scene, way != "alone")?;
    let rate: f32 = spin.parse()?;
    stage.launch(scene, rate);
    if scene.is_ball() {
        let time = answer("slide_s").ok_or("no answer")?;
        for _ in 0..(2.0 * time / f64::from(STEP)).ceil() as usize {
            stage.step();
        }
        let speed = f64::from(stage.world.bodies[stage.body].linvel().x);
        print_row(way, &scene.name, spin, "rolling_speed_m_s", speed);
        return Ok(());
    }
    let longest = 1.5 * answer("stop_s").ok_or("no answer")? + 0.5;
    let start = stage.pose();
    let gyration = scene.gyration_sq().sqrt();
    let unit = if scene.number("speed") > 0.0 {
        scene.number("speed")
    } else {
        gyration * rate.abs()
    };
    let (mut yaw, mut turned, mut stop) = (start[2], 0.0, f64::NAN);
    for i in 0..(longest / f64::from(STEP)).ceil() as usize {
        stage.step();
        let now = stage.pose()[2];
        let full = std::f32::consts::TAU;
        turned += f64::from((now - yaw + 0.5 * full).rem_euclid(full) - 0.5 * full);
        yaw = now;
        let body = &stage.world.bodies[stage.body];
        let (v, w) = (body.linvel(), body.angvel().y);
        if v.x.hypot(v.z).hypot(gyration * w) >= STILL * unit {
            stop = f64::NAN;
        } else if stop.is_nan() {
            stop = (i + 1) as f64 * f64::from(STEP);
        }
    }
    let end = stage.pose();
    for (quantity, value) in [
        ("along_m", f64::from(end[0] - start[0])),
        ("left_m", f64::from(end[1] - start[1])),
        ("turn_rad", turned),
        ("stop_s", stop),
    ] {
        print_row(way, &scene.name, spin, quantity, value);
    }
    Ok(())
}

/// Least time of a step of a sliding puck, in µs.
fn cost(way: &str, scene: &Scene) -> Result<(), Box<dyn Error>> {
    let mut least = f64::INFINITY;
    for _ in 0..20 {
        let mut stage = Stage::new(scene, way != "alone")?;
        stage.launch(scene, 50.0);
        let start = Instant::now();
        for _ in 0..40 {
            stage.step();
        }
        least = least.min(start.elapsed().as_secs_f64() / 40.0);
    }
    print_row(way, "cost", "50", "step_us", 1e6 * least);
    Ok(())
}

fn columns(path: &Path) -> Result<Vec<Vec<String>>, Box<dyn Error>> {
    let text =
        std::fs::read_to_string(path).map_err(|error| format!("{}: {error}", path.display()))?;
    Ok(text
        .lines()
        .skip(1)
        .map(|line| line.split(',').map(str::to_owned).collect())
        .collect())
}

fn main() -> Result<(), Box<dyn Error>> {
    let folder = std::env::args()
        .nth(1)
        .ok_or("usage: answers FOLDER, that of answers.csv and problems.csv")?;
    let mut scenes: Vec<Scene> = Vec::new();
    for row in columns(&Path::new(&folder).join("problems.csv"))? {
        if scenes.last().is_none_or(|scene| scene.name != row[0]) {
            scenes.push(Scene {
                name: row[0].clone(),
                ..Scene::default()
            });
        }
        let scene = scenes.last_mut().ok_or("no scene")?;
        scene.texts.insert(row[1].clone(), row[2].clone());
    }
    let mut exact = Answers::new();
    for row in columns(&Path::new(&folder).join("answers.csv"))? {
        exact.insert(
            (row[0].clone(), row[1].clone(), row[2].clone()),
            row[4].parse()?,
        );
    }
    println!("# Rapier 0.36, Apache-2.0, steps of 1/240 s");
    println!("way,repaired,scene,spin_rad_s,quantity,value");
    for way in ["alone", "tribos-rapier"] {
        for scene in scenes.iter().filter(|scene| scene.name != "capsule") {
            // Patches do not concern a ball, which touches in a point.
            if scene.is_ball() && way != "alone" {
                continue;
            }
            for spin in scene.texts["spins"].split(' ') {
                throw(way, scene, spin, &exact)?;
            }
            if scene.name == "puck" {
                cost(way, scene)?;
            }
        }
    }
    Ok(())
}
