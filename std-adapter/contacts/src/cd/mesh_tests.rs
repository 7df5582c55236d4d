//! Spheres on walls of triangles, and spheres that keep their motion, in both methods.

use super::{
    EnergyBalance, Mesh, MovingMesh, StepLimits, Wall, World, WorldMaterials, WorldSetup, solid,
};
use crate::soft::{STEPS_PER_COLLISION, SoftSetup, SoftWorld, Stiffness};
use nalgebra::Vector3;
use std::f64::consts::{FRAC_1_SQRT_2, TAU};
use std::sync::Arc;
use tribos_base::random::Random;
use tribos_base::space::PeriodicBox;
use tribos_core::contact::{Cohesion, IndependentFriction, NormalLaw, SlidingOnly, SphereBody};

type V = Vector3<f64>;
type Friction = IndependentFriction<f64, SlidingOnly>;

const GRAVITY: f64 = 9.81;

/// Both methods, the soft one with its stiffness.
const METHODS: [Option<f64>; 2] = [None, Some(1e6)];

fn v(x: f64, y: f64, z: f64) -> V {
    V::new(x, y, z)
}

/// Balls of 1 cm and 10 g or so, on walls, with so many steps of a soft collision.
struct Scene(WorldSetup<Friction>, f64);

struct End {
    positions: Vec<V>,
    spheres: Vec<SphereBody<f64>>,
    energy: EnergyBalance,
    steps: usize,
}

impl Scene {
    fn new(mu: f64) -> Self {
        let normal = NormalLaw::new(Cohesion::NONE, 0.0).unwrap();
        let laws = WorldMaterials::uniform(normal, IndependentFriction::sliding(mu).unwrap());
        let mut setup = WorldSetup::new(laws).gravity(v(0.0, 0.0, -GRAVITY));
        setup.step_limits = StepLimits {
            longest: 1e-3,
            motion: 1e-3,
        };
        setup.solver.method = super::SolverMethod::Accelerated { tolerance: 1e-12 };
        Self(setup, STEPS_PER_COLLISION)
    }

    fn mesh(mut self, triangles: Vec<[V; 3]>) -> Self {
        self.0.mesh = Some(MovingMesh::at_rest(Arc::new(Mesh::new(triangles).unwrap())));
        self
    }

    fn wall(self, wall: Wall) -> Self {
        Self(self.0.wall(wall), self.1)
    }

    fn ball(self, at: V, velocity: V, spin: V) -> Self {
        let ball = SphereBody {
            velocity,
            spin,
            ..solid(0.01, 2500.0)
        };
        Self(self.0.sphere(at, 0.01, ball), self.1)
    }

    /// A ball that keeps its velocity.
    fn driven(self, at: V, velocity: V) -> Self {
        let ball = SphereBody {
            velocity,
            inv_mass: 0.0,
            inv_inertia: 0.0,
            ..solid(0.01, 2500.0)
        };
        Self(self.0.sphere(at, 0.01, ball), self.1)
    }

    /// The state after a time, and what `watch` sees after every step.
    fn run(
        &self,
        soft: Option<f64>,
        time: f64,
        mut watch: impl FnMut(&[V], &[SphereBody<f64>]),
    ) -> End {
        let setup = self.0.clone();
        let mut steps = 0;
        let (positions, spheres, energy) = match soft {
            None => {
                let mut world = World::new(setup).unwrap();
                while world.state().time < time {
                    world.step().unwrap();
                    steps += 1;
                    watch(&world.state().positions, &world.state().spheres);
                }
                let state = world.state().clone();
                (state.positions, state.spheres, state.energy)
            }
            Some(stiffness) => {
                let mut world = SoftWorld::new(SoftSetup {
                    space: setup.space,
                    positions: setup.positions,
                    radii: setup.radii,
                    spheres: setup.spheres,
                    walls: setup.walls,
                    mesh: setup.mesh,
                    gravity: setup.gravity,
                    steps_per_collision: self.1,
                    ..SoftSetup::new(setup.laws, Stiffness::Linear(stiffness))
                })
                .unwrap();
                while world.state().time < time {
                    world.step().unwrap();
                    steps += 1;
                    watch(&world.state().positions, &world.state().spheres);
                }
                let state = world.state().clone();
                (state.positions, state.spheres, state.energy)
            }
        };
        End {
            positions,
            spheres,
            energy,
            steps,
        }
    }

    fn end(&self, soft: Option<f64>, time: f64) -> End {
        self.run(soft, time, |_, _| ())
    }
}

/// A flat mesh in the plane of two vectors from −1 to 1: squares with random diagonals and shifted corners.
fn flat(along: V, across: V) -> Vec<[V; 3]> {
    let side = 41;
    let mut random = Random::new(5, 0);
    let mut corners = Vec::new();
    for j in 0..=side {
        for i in 0..=side {
            let inner = |k: i32| if k == 0 || k == side { 0.0 } else { 0.6 };
            let mut place = |k: i32| {
                2.0 * (f64::from(k) + inner(k) * (random.unit() - 0.5)) / f64::from(side) - 1.0
            };
            corners.push(along * place(i) + across * place(j));
        }
    }
    let corner = |i: i32, j: i32| corners[(i + (side + 1) * j) as usize];
    let mut triangles = Vec::new();
    for j in 0..side {
        for i in 0..side {
            let [a, b, c, d] = [
                corner(i, j),
                corner(i + 1, j),
                corner(i + 1, j + 1),
                corner(i, j + 1),
            ];
            let other = random.unit() < 0.5;
            triangles.extend(if other {
                [[a, b, c], [a, c, d]]
            } else {
                [[a, b, d], [b, d, c]]
            });
        }
    }
    triangles
}

/// Energy of a rolling ball over ½ m v².
const ROLLING: f64 = 1.4;

#[test]
fn a_ball_rolls_over_the_edges_of_a_flat_mesh_as_on_a_plane() {
    let velocity = v(0.8, 0.31, 0.0);
    // A rolling ball spins with ω = z × v/R.
    let spin = v(-velocity.y, velocity.x, 0.0) / 0.01;
    for (soft, time) in METHODS.into_iter().zip([1.5, 0.3]) {
        // A soft ball starts at the height where its spring bears it.
        let mass = 1.0 / solid(0.01, 2500.0).inv_mass;
        let sunk = soft.map_or(0.0, |stiffness| mass * GRAVITY / stiffness);
        let start = v(-0.9, -0.5, 0.01 - sunk);
        let on = |scene: Scene| scene.ball(start, velocity, spin);
        let mesh = on(Scene::new(0.4).mesh(flat(v(1.0, 0.0, 0.0), v(0.0, 1.0, 0.0))));
        let plane = on(Scene::new(0.4).wall(Wall::fixed(V::z(), 0.0)));
        let [mesh, plane] = [mesh, plane].map(|scene| scene.end(soft, time));
        assert!(
            (mesh.positions[0] - plane.positions[0]).norm() < 1e-9,
            "{soft:?}: {} {}",
            mesh.positions[0],
            plane.positions[0]
        );
        // Straight on, with its energy.
        let way = mesh.positions[0] - start;
        assert!((way.cross(&velocity).z / velocity.norm()).abs() < 1e-9 && way.x > 0.79 * time);
        let end = &mesh.spheres[0];
        let energy = end.velocity.norm_squared() + 0.4 * 1e-4 * end.spin.norm_squared();
        let kept = energy / (ROLLING * velocity.norm_squared());
        assert!((kept - 1.0).abs() < 1e-6, "{soft:?}: {kept}");
        assert_eq!(mesh.steps, plane.steps);
    }
}

#[test]
fn a_ball_on_an_inclined_triangle_takes_the_path_of_one_on_a_plane() {
    let (down, up) = (
        v(FRAC_1_SQRT_2, 0.0, -FRAC_1_SQRT_2),
        v(FRAC_1_SQRT_2, 0.0, FRAC_1_SQRT_2),
    );
    // It slides with tan 45° > 7/2 μ and falls on the wall at first.
    for soft in METHODS {
        let start = up * 0.013 - down * 0.5;
        let on = |scene: Scene| scene.ball(start, v(0.0, 0.2, 0.0), V::zeros());
        let corners = [
            down * 9.0 - V::y() * 9.0,
            down * 9.0 + V::y() * 9.0,
            down * -9.0,
        ];
        let [mesh, plane] = [
            on(Scene::new(0.2).mesh(vec![corners])),
            on(Scene::new(0.2).wall(Wall::fixed(up, 0.0))),
        ]
        .map(|scene| scene.end(soft, 0.5));
        assert!((mesh.positions[0] - plane.positions[0]).norm() < 1e-9);
        assert!((mesh.spheres[0].spin - plane.spheres[0].spin).norm() < 1e-7);
        assert!(
            (mesh.energy.sliding / plane.energy.sliding - 1.0).abs() < 1e-7
                && mesh.energy.sliding > 0.0
        );
        // What it loses: g (sin 45° − μ cos 45°) down the wall, once it lies on it.
        let speed = mesh.spheres[0].velocity.dot(&down);
        let expected = GRAVITY * FRAC_1_SQRT_2 * (0.5 - 0.2 * 0.5);
        assert!((speed / expected - 1.0).abs() < 0.05, "{speed} {expected}");
    }
}

/// A plate with a square hole of a width around the origin.
fn with_hole(width: f64) -> Vec<[V; 3]> {
    let (a, b) = (0.5 * width, 0.1);
    let side = |turn: fn(f64, f64) -> V| {
        let [p, q, r, s] = [turn(-a, a), turn(a, a), turn(b, b), turn(-b, b)];
        [[p, q, r], [p, r, s]]
    };
    let sides: [fn(f64, f64) -> V; 4] = [
        |x, y| v(x, y, 0.0),
        |x, y| v(y, -x, 0.0),
        |x, y| v(-x, -y, 0.0),
        |x, y| v(-y, x, 0.0),
    ];
    sides.into_iter().flat_map(side).collect()
}

#[test]
fn a_ball_falls_through_a_larger_hole_and_rests_on_the_rim_of_a_smaller_one() {
    for soft in METHODS {
        let drop = |width: f64, steps: f64| {
            let mut scene = Scene::new(0.5).mesh(with_hole(width)).ball(
                v(0.0, 0.0, 0.011),
                V::zeros(),
                V::zeros(),
            );
            scene.1 = steps;
            scene.end(soft, 0.3)
        };
        // Free fall from 11 mm through a hole that is 1 % wider.
        let through = drop(0.0202, STEPS_PER_COLLISION);
        let fallen = 0.011 - 0.5 * GRAVITY * 0.3 * 0.3;
        assert!((through.positions[0].z - fallen).abs() < 2e-3);
        // Implicit steps lose ½ m (g dt)² each, 1.5e-4 J, and a touch of the rim 1e-3 J.
        assert!(through.energy.normal < 2e-4 && through.energy.sliding == 0.0);
        // On the middles of four edges, 6 mm from the axis: √(10² − 6²) = 8 mm above.
        let rests = drop(0.012, STEPS_PER_COLLISION);
        let strain = if soft.is_some() { 1e-6 } else { 2e-6 };
        assert!(
            (rests.positions[0] - v(0.0, 0.0, 0.008)).norm() < strain,
            "{}",
            rests.positions[0]
        );
        assert!(rests.spheres[0].velocity.norm() < 1e-6);
        // Four springs at once are 1.6 times as quick as one: 22 steps a collision in place of 35.
        let finer = drop(0.012, 4.0 * STEPS_PER_COLLISION);
        let errors = [&rests, &finer].map(|end| balance(end, soft));
        assert!(errors[0] < 2.0 && errors[1] < 0.1, "{soft:?}: {errors:?}");
    }
}

#[test]
fn a_ball_comes_to_rest_in_a_corner_of_three_faces() {
    // Three walls of one mesh, a corner leaning on its tip: the centre is √3 R above it.
    let tip = |k: f64| {
        let (sin, cos) = libm::sincos(TAU * k / 3.0);
        // Edges of a cube on its tip rise with 1/√3.
        v(
            cos * libm::sqrt(2.0 / 3.0),
            sin * libm::sqrt(2.0 / 3.0),
            libm::sqrt(1.0 / 3.0),
        )
    };
    let faces = [0.0, 1.0, 2.0]
        .map(|k| [V::zeros(), tip(k), tip(k + 1.0)])
        .to_vec();
    for soft in METHODS {
        let scene =
            Scene::new(0.0)
                .mesh(faces.clone())
                .ball(v(0.001, 0.0, 0.02), V::zeros(), V::zeros());
        let end = scene.end(soft, 1.0);
        let expected = v(0.0, 0.0, 0.01 * libm::sqrt(3.0));
        assert!(
            (end.positions[0] - expected).norm() < 2e-6,
            "{}",
            end.positions[0]
        );
    }
}

#[test]
fn a_ball_on_a_turntable_circles_with_two_sevenths_of_its_rate() {
    let (rate, time) = (3.0, 0.3);
    for soft in METHODS {
        let mut scene = Scene::new(10.0).mesh(flat(v(1.0, 0.0, 0.0), v(0.0, 1.0, 0.0)));
        scene.0.mesh.as_mut().unwrap().rate = rate;
        // It rolls without slip on a circle about the axis: its velocity is 2/7 of the table's under it, and the spin makes
        // up the rest, R ω = z × (v − Ω × r).
        let start = v(0.3, 0.0, 0.01);
        let velocity = v(0.0, 0.3 * rate * 2.0 / 7.0, 0.0);
        let slip = velocity - v(0.0, 0.3 * rate, 0.0);
        let spin = V::z().cross(&slip) / 0.01;
        let end = scene.ball(start, velocity, spin).end(soft, time);
        let (sin, cos) = libm::sincos(rate * 2.0 / 7.0 * time);
        let expected = v(0.3 * cos, 0.3 * sin, 0.01);
        assert!(
            (end.positions[0] - expected).norm() < 2e-3,
            "{soft:?}: {}",
            end.positions[0]
        );
        // Its speed stays, so the table does no net work beyond what the first steps lose.
        assert!((end.spheres[0].velocity.norm() / velocity.norm() - 1.0).abs() < 5e-3);
        let scale = 0.5 * velocity.norm_squared() / end.spheres[0].inv_mass;
        assert!(
            end.energy.imbalance().abs() < 1e-3 * scale,
            "{}",
            end.energy.imbalance() / scale
        );
    }
}

#[test]
fn a_moving_mesh_takes_a_ball_along_and_over_the_border_of_a_cell() {
    for soft in METHODS {
        let mut scene = Scene::new(0.5).mesh(flat(v(0.5, 0.0, 0.0), v(0.0, 0.5, 0.0)));
        scene.0.space = PeriodicBox::new([Some(1.0), None, None]).unwrap();
        scene.0.mesh.as_mut().unwrap().velocity = v(0.4, 0.0, 0.0);
        // At rest on the belt; the mesh ends where its next image begins.
        let scene = scene.ball(v(0.45, 0.1, 0.01), v(0.4, 0.0, 0.0), V::zeros());
        let still = scene.end(soft, 0.2);
        assert!((still.positions[0] - v(0.45 + 0.4 * still_time(&still), 0.1, 0.01)).norm() < 1e-3);
        // A ball that rolls over the border of the images of a belt at rest keeps its energy.
        let mut scene = Scene::new(0.5).mesh(flat(v(0.5, 0.0, 0.0), v(0.0, 0.5, 0.0)));
        scene.0.space = PeriodicBox::new([Some(1.0), None, None]).unwrap();
        let scene = scene.ball(v(0.45, 0.1, 0.01), v(0.5, 0.0, 0.0), v(0.0, 50.0, 0.0));
        let rolls = scene.end(soft, 0.2);
        assert!(rolls.positions[0].x > 0.549);
        let speed = rolls.spheres[0].velocity.norm();
        assert!((speed / 0.5 - 1.0).abs() < 1e-4, "{soft:?}: {speed}");
    }
}

/// Time that a ball at rest on its belt has taken.
fn still_time(end: &End) -> f64 {
    (end.positions[0].x - 0.45) / end.spheres[0].velocity.x
}

#[test]
fn a_ball_among_four_fixed_ones_rests_on_all_of_them() {
    // Neighbours that touch: the centre is √2 R above theirs.
    for soft in METHODS {
        let mut scene = Scene::new(0.3);
        for (x, y) in [(0.01, 0.01), (-0.01, 0.01), (-0.01, -0.01), (0.01, -0.01)] {
            scene = scene.driven(v(x, y, 0.0), V::zeros());
        }
        let scene = scene.ball(v(1e-4, 0.0, 0.016), V::zeros(), V::zeros());
        let end = scene.end(soft, 0.5);
        let height = 0.01 * libm::sqrt(2.0);
        assert!(
            (end.positions[4] - v(0.0, 0.0, height)).norm() < 3e-6,
            "{}",
            end.positions[4]
        );
        let fixed = &end.positions[..4];
        assert!(
            fixed
                .iter()
                .all(|x| x.x.abs() == 0.01 && x.y.abs() == 0.01 && x.z == 0.0)
        );
        // All energy that the ball had is work of gravity, and all of it is lost.
        let mass = 1.0 / end.spheres[4].inv_mass;
        assert!((end.energy.work / (mass * GRAVITY * (0.016 - height)) - 1.0).abs() < 1e-2);
        assert!(
            balance(&end, soft) < 1.0,
            "{soft:?}: {}",
            balance(&end, soft)
        );
    }
}

/// Error of the energy balance over what a method leaves of the work: rounding, or that of 35 steps a collision.
fn balance(end: &End, soft: Option<f64>) -> f64 {
    let share = if soft.is_some() { 1.5e-2 } else { 1e-12 };
    end.energy.imbalance().abs() / (share * end.energy.work)
}

#[test]
fn a_driven_ball_gives_what_it_meets_its_velocity_and_its_drive_does_the_work() {
    for soft in METHODS {
        let mut scene = Scene::new(0.0);
        scene.0.gravity = V::zeros();
        let scene = scene.driven(v(0.0, 0.0, 0.0), v(0.5, 0.0, 0.0)).ball(
            v(0.025, 0.0, 0.0),
            V::zeros(),
            V::zeros(),
        );
        let end = scene.end(soft, 0.2);
        // e = 0 in contact dynamics, 0.135 of a critically damped spring.
        let e = if soft.is_some() { 0.135 } else { 0.0 };
        let speed = 0.5 * (1.0 + e);
        assert!(
            (end.spheres[1].velocity.x - speed).abs() < 2e-3,
            "{}",
            end.spheres[1].velocity.x
        );
        assert_eq!(end.spheres[0].velocity.x, 0.5);
        assert!((end.positions[0].x - 0.5 * 0.2).abs() < 1e-3);
        // The drive's force times its way: m v' v.
        let momentum = end.spheres[1].velocity.x / end.spheres[1].inv_mass;
        assert!((end.energy.work / (momentum * 0.5) - 1.0).abs() < 1e-6);
        assert!(
            balance(&end, soft) < 1.0,
            "{soft:?}: {}",
            balance(&end, soft)
        );
    }
}
