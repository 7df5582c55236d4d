//! Walls that end: faces, edges and corners.

use super::wall::{Facing, Rectangle, Wall};
use super::{
    ContactSolver, SolverMethod, StepLimits, World, WorldError, WorldMaterials, WorldSetup, solid,
};
use crate::soft;
use nalgebra::Vector3;
use tribos_base::random::Random;
use tribos_base::space::PeriodicBox;
use tribos_core::contact::{Cohesion, IndependentFriction, NormalLaw, SlidingOnly};

type Tested = Result<(), Box<dyn std::error::Error>>;

const ENDLESS: [f64; 2] = [f64::NEG_INFINITY, f64::INFINITY];
/// All that lies below 0.
const BELOW: [f64; 2] = [f64::NEG_INFINITY, 0.0];

/// A part of the plane z = 0.
fn table(ends: [[f64; 2]; 2]) -> Wall {
    Wall {
        edges: Some(Rectangle {
            along: Vector3::x(),
            ends,
        }),
        ..Wall::fixed(Vector3::z(), 0.0)
    }
}

fn laws(
    mu: f64,
) -> Result<WorldMaterials<IndependentFriction<f64, SlidingOnly>>, tribos_core::law::LawError> {
    let normal = NormalLaw::new(Cohesion::NONE, 0.0)?;
    Ok(WorldMaterials::uniform(
        normal,
        IndependentFriction::sliding(mu)?,
    ))
}

/// A ball of radius 1 under gravity 1.
fn ball(
    at: Vector3<f64>,
    mu: f64,
    (wall, dt): (Wall, f64),
) -> Result<WorldSetup<IndependentFriction<f64, SlidingOnly>>, tribos_core::law::LawError> {
    let setup = WorldSetup {
        step_limits: StepLimits {
            longest: dt,
            motion: 1.0,
        },
        solver: ContactSolver {
            method: SolverMethod::Accelerated { tolerance: 1e-13 },
            most_sweeps: 1000,
            warm_start: 1.0,
        },
        ..WorldSetup::new(laws(mu)?)
    };
    let setup = setup.wall(wall).gravity(-Vector3::z());
    Ok(setup.sphere(at, 1.0, solid(1.0, 1.0)))
}

/// A unit vector of any direction.
fn direction(random: &mut Random) -> Vector3<f64> {
    let mut part = || 2.0 * random.unit() - 1.0;
    Vector3::new(part(), part(), part()).normalize()
}

#[test]
fn no_point_of_a_rectangle_is_nearer_than_the_one_that_is_met() -> Tested {
    /// Points of the grid along a side.
    const GRID: usize = 60;
    let mut random = Random::new(7, 0);
    let space = PeriodicBox::new([Some(20.0), Some(20.0), None])?;
    let mut met = [0; 3];
    for case in 0..300 {
        let outward = direction(&mut random);
        let along = outward.cross(&direction(&mut random)).normalize();
        let across = outward.cross(&along);
        let place = random.unit() - 0.5;
        let ends = [0, 1].map(|_| {
            let low = -2.0 * random.unit();
            [low, low + 2.5 * random.unit()]
        });
        let wall = Wall {
            edges: Some(Rectangle { along, ends }),
            ..Wall::fixed(outward, place)
        };
        let centre = direction(&mut random) * (3.0 * random.unit());
        let Facing {
            outward: normal,
            height,
        } = wall.facing(&space, &centre);
        let on = |shares: [f64; 2]| {
            let [a, b] = [0, 1]
                .map(|side: usize| ends[side][0] + shares[side] * (ends[side][1] - ends[side][0]));
            outward * place + along * a + across * b
        };

        // The point is one of the rectangle, and the distance is that of the nearest point of a grid.
        let point = centre - normal * height;
        let inside = [along, across].map(|axis| axis.dot(&point));
        let beyond = inside
            .iter()
            .zip(&ends)
            .filter(|(x, [low, high])| **x < low + 1e-9 || **x > high - 1e-9);
        met[beyond.count()] += 1;
        assert!((outward.dot(&point) - place).abs() < 1e-12, "{case}");
        for (x, [low, high]) in inside.iter().zip(&ends) {
            assert!((low - 1e-12..high + 1e-12).contains(x), "{case}: {x}");
        }
        let shares = (0..=GRID).flat_map(|i| (0..=GRID).map(move |j| [i, j]));
        let nearest = shares
            .map(|at| (on(at.map(|k| k as f64 / GRID as f64)) - centre).norm())
            .fold(f64::INFINITY, f64::min);
        let spacing = 2.5 / GRID as f64;
        assert!(
            height <= nearest + 1e-12 && nearest < height + spacing,
            "{case}: {height} {nearest}"
        );

        // A sphere some periods away meets the same image.
        let image = centre + Vector3::new(-40.0, 20.0, 0.0);
        assert!((wall.facing(&space, &image).height - height).abs() < 1e-12);
    }
    // Faces, edges and corners are all met.
    assert!(met.iter().all(|count| *count > 30), "{met:?}");
    Ok(())
}

#[test]
fn edges_and_corners_push_along_the_line_to_the_centre() -> Tested {
    let corner = Vector3::new(1.0, 2.0, 2.0) / 3.0;
    let edge = Vector3::new(0.6, 0.0, 0.8);
    for (normal, ends) in [(corner, [BELOW, BELOW]), (edge, [BELOW, ENDLESS])] {
        let dt = 1e-3;
        let mut world = World::new(ball(normal, 0.0, (table(ends), dt))?)?;
        world.step()?;
        // Gravity without its part along the normal.
        let wanted = (normal * normal.z - Vector3::z()) * dt;
        let found = world.state().spheres[0].velocity;
        assert!((found - wanted).norm() < 1e-15, "{found} {wanted}");
        // The problem as data has the same solution.
        let posed = world
            .problem()
            .to_problem()
            .ok_or("a problem without contacts")?;
        let solved = crate::problem::solve(&posed.problem.reduced()?, &Default::default(), |_| ());
        let weight = 4.0 / 3.0 * std::f64::consts::PI * normal.z * dt;
        assert!((solved.impulses[0] / weight - 1.0).abs() < 1e-9);
    }
    Ok(())
}

#[test]
fn a_ball_leaves_an_edge_where_gravity_no_longer_holds_it() -> Tested {
    // From rest at the angle a, the ball loses touch at cos = 2/3 cos a if it slides, and if it rolls, with 7/5 of
    // its inertia, at 10/17 cos a.
    let start: f64 = 0.05;
    let at = Vector3::new(libm::sin(start), 0.0, libm::cos(start));
    for (mu, share) in [(0.0, 2.0 / 3.0), (100.0, 10.0 / 17.0)] {
        let mut errors = Vec::new();
        for dt in [4e-3, 2e-3, 1e-3] {
            let mut world = World::new(ball(at, mu, (table([BELOW, ENDLESS]), dt))?)?;
            let mut last = 1.0;
            while world.state().positions[0].z > 0.3 {
                world.step()?;
                let state = world.state();
                if state.memory.forces[1]
                    .iter()
                    .any(|(_, force)| force.normal > 0.0)
                {
                    last = state.positions[0].normalize().z;
                }
            }
            errors.push(last / libm::cos(start) - share);
        }
        println!("cosines of the last touch, {mu}: {errors:?}");
        assert!(
            errors[2].abs() < 5e-3 && errors[2].abs() < 0.7 * errors[0].abs(),
            "{mu}: {errors:?}"
        );
    }
    Ok(())
}

#[test]
fn a_ball_rests_over_an_edge_and_rolls_off_beyond_it() -> Tested {
    for (x, stays) in [(0.0, true), (-0.01, true), (0.01, false)] {
        let at = Vector3::new(x, 0.0, 1.0);
        let mut world = World::new(ball(at, 0.5, (table([BELOW, ENDLESS]), 0.01))?)?;
        for _ in 0..1000 {
            world.step()?;
        }
        let place = world.state().positions[0];
        assert_eq!((place - at).norm() < 1e-12, stays, "{x}: {place}");
        assert_eq!(place.z < -1.0, !stays, "{x}: {place}");
    }
    Ok(())
}

#[test]
fn soft_balls_leave_an_edge_as_rigid_ones_do() -> Tested {
    let start: f64 = 0.05;
    let mut setup = soft::SoftSetup::new(laws(0.0)?, soft::Stiffness::Linear(1e5))
        .wall(table([BELOW, ENDLESS]))
        .gravity(-Vector3::z())
        .sphere(
            Vector3::new(libm::sin(start), 0.0, libm::cos(start)),
            1.0,
            solid(1.0, 1.0),
        );
    setup.longest = 1e-2;
    let mut world = soft::SoftWorld::new(setup)?;
    let mut last = 1.0;
    while world.state().positions[0].z > 0.3 {
        world.step()?;
        let state = world.state();
        if state.contacts[1]
            .iter()
            .any(|contact| contact.force.normal > 0.0)
        {
            last = state.positions[0].normalize().z;
        }
    }
    assert!((last / libm::cos(start) - 2.0 / 3.0).abs() < 5e-3, "{last}");
    Ok(())
}

#[test]
fn edges_that_no_sphere_could_meet_are_refused() -> Tested {
    let good = table([[0.0, 1.0], ENDLESS]);
    let edged = |along, ends| Wall {
        edges: Some(Rectangle { along, ends }),
        ..good
    };
    let piston = Wall {
        edges: good.edges,
        ..Wall::piston(Vector3::z(), 0.0, 1.0, 0.0)
    };
    let nan = [[f64::NAN, 1.0], ENDLESS];
    let space = PeriodicBox::new([Some(3.0), None, None])?;
    for (wall, taken) in [
        (good, true),
        (edged(Vector3::y(), [ENDLESS, [0.0, 1.0]]), true),
        (edged(Vector3::z(), [ENDLESS, ENDLESS]), false),
        (edged(Vector3::x() * 1.1, [ENDLESS, ENDLESS]), false),
        (edged(Vector3::x(), nan), false),
        // Half a plane along the period.
        (edged(Vector3::x(), [BELOW, ENDLESS]), false),
        (edged(Vector3::y(), [BELOW, ENDLESS]), true),
        (piston, false),
    ] {
        let mut setup = WorldSetup::new(laws(0.0)?).wall(wall);
        setup.space = space;
        match World::new(setup) {
            Ok(_) => assert!(taken, "{wall:?}"),
            Err(WorldError::Wall { wall: 0 }) => assert!(!taken, "{wall:?}"),
            Err(error) => return Err(error.into()),
        }
    }
    Ok(())
}
