//! Bodies of several materials.

use super::{
    ContactMaterial, ContactSolver, IterationOrder, MaterialTable, Mesh, MovingMesh, StepLimits,
    StopRule, Wall, World, WorldMaterials, WorldSetup,
};
use super::{SolverMethod, WorldError, solid};
use crate::soft::{SoftSetup, SoftWorld, Sprung, Stiffness};
use nalgebra::Vector3;
use std::sync::Arc;
use tribos_core::contact::{
    Attraction, Cohesion, IndependentFriction, NormalLaw, SlidingOnly, SphereBody,
};

type Answer = Result<(), Box<dyn std::error::Error>>;
type Friction = IndependentFriction<f64, SlidingOnly>;

/// The same laws between spheres and at walls.
fn laws(restitution: f64, mu: f64) -> Result<WorldMaterials<Friction>, tribos_core::law::LawError> {
    let normal = NormalLaw::new(Cohesion::NONE, restitution)?;
    Ok(WorldMaterials::uniform(
        normal,
        IndependentFriction::sliding(mu)?,
    ))
}

/// Laws by the materials of two bodies, numbered 0 and 1.
fn table(
    of: [[f64; 2]; 3],
) -> Result<impl Fn([u8; 2]) -> WorldMaterials<Friction>, tribos_core::law::LawError> {
    let [first, mixed, second] = of.map(|[e, mu]| laws(e, mu));
    let all = [first?, mixed?, second?];
    Ok(move |[a, b]: [u8; 2]| all[usize::from(a + b)])
}

fn setup(laws: WorldMaterials<Friction>) -> WorldSetup<Friction> {
    WorldSetup {
        step_limits: StepLimits {
            longest: 0.01,
            motion: 0.05,
        },
        solver: ContactSolver {
            method: SolverMethod::Accelerated { tolerance: 1e-12 },
            most_sweeps: 1000,
            warm_start: 1.0,
        },
        ..WorldSetup::new(laws)
    }
}

fn thrown(velocity: Vector3<f64>) -> SphereBody<f64> {
    SphereBody {
        velocity,
        ..solid(1.0, 1.0)
    }
}

#[test]
fn every_pair_of_materials_rebounds_and_slides_by_its_own_law() -> Answer {
    // Pairs of spheres far apart, which meet obliquely: 0 and 0, 0 and 1, 1 and 0, 1 and 1.
    let coefficients = [[0.2, 0.1], [0.5, 0.05], [0.9, 0.15]];
    let mut both = setup(laws(0.0, 0.0)?);
    let mut materials = Vec::new();
    let pairs = [[0, 0], [0, 1], [1, 0], [1, 1]];
    for (row, pair) in pairs.into_iter().enumerate() {
        let place = Vector3::y() * (10.0 * row as f64);
        let speed = Vector3::new(1.0, 2.0, 0.0);
        both = both.sphere(place, 1.0, thrown(speed)).sphere(
            place + Vector3::x() * 2.0,
            1.0,
            thrown(-speed),
        );
        materials.extend(pair);
    }
    both.mixture = Some(MaterialTable::new(
        materials,
        Vec::new(),
        table(coefficients)?,
    ));
    let mut world = World::new(both)?;
    world.step()?;
    for (row, [a, b]) in pairs.into_iter().enumerate() {
        let [e, mu] = coefficients[usize::from(a + b)];
        let rebound = world.state().spheres[2 * row].velocity;
        // Normal impulse (1 + e) m/2 · 2, and μ times that against the slip, over m.
        assert!((rebound.x + e).abs() < 1e-12, "{a} {b}: {rebound}");
        assert!(
            (2.0 - rebound.y - mu * (1.0 + e)).abs() < 1e-12,
            "{a} {b}: {rebound}"
        );
    }
    Ok(())
}

#[test]
fn spheres_slide_on_a_floor_by_their_own_coefficients() -> Answer {
    for solver in [
        SolverMethod::Accelerated { tolerance: 1e-12 },
        SolverMethod::GaussSeidel {
            order: IterationOrder::Random { seed: 3 },
            stop: StopRule::Local(1e-12),
        },
    ] {
        let up = Vector3::z();
        let mut both = setup(laws(0.0, 0.9)?).gravity(-up);
        for x in [0.0, 10.0] {
            both = both.sphere(up + Vector3::x() * x, 1.0, thrown(Vector3::y()));
        }
        both = both.wall(Wall::fixed(up, 0.0));
        both.solver.method = solver;
        let of = table([[0.0, 0.1], [0.0, 0.4], [0.0, 0.9]])?;
        both.mixture = Some(MaterialTable::new(vec![0, 1], vec![0], of));
        let mut world = World::new(both)?;
        for _ in 0..20 {
            world.step()?;
        }
        // Under gravity 1 the speed falls by μ t while the ball slides.
        let state = world.state();
        for (sphere, mu) in state.spheres.iter().zip([0.1, 0.4]) {
            assert!((sphere.velocity.y - (1.0 - mu * state.time)).abs() < 1e-12);
        }
    }
    Ok(())
}

#[test]
fn two_names_for_one_material_change_no_bit() -> Answer {
    for restitution in [0.0, 0.4] {
        let mut one = setup(laws(restitution, 0.3)?).gravity(-Vector3::z());
        for index in 0..60_usize {
            let [x, y, z] = [index % 3, index / 3 % 4, index / 12].map(|at| at as f64);
            let place = Vector3::new(1.9 * x + 0.2 * z, 2.01 * y - 0.1 * z, 1.0 + 1.95 * z);
            one = one.sphere(place, 1.0, thrown(Vector3::new(0.1 * y, -0.2 * x, 0.0)));
        }
        one = one.wall(Wall::fixed(Vector3::z(), 0.0));
        let mut two = one.clone();
        let materials = (0..60).map(|index| index % 2).collect();
        two.mixture = Some(MaterialTable::new(materials, vec![1], |_| one.laws));
        let (mut one, mut two) = (World::new(one)?, World::new(two)?);
        for _ in 0..40 {
            assert_eq!(one.step()?, two.step()?);
        }
        assert_eq!(one.state(), two.state());
    }
    Ok(())
}

/// Soft spheres that attract each other across gaps, on a wall and a mesh, which has the number of its own after walls.
fn heap(cohesion: f64) -> Result<SoftSetup<Friction>, Box<dyn std::error::Error>> {
    let pull = Cohesion::new(cohesion, 0.02, Attraction::Pull)?;
    let laws = WorldMaterials::uniform(
        NormalLaw::new(pull, 0.4)?,
        IndependentFriction::sliding(0.3)?,
    );
    let mut setup = SoftSetup::new(laws, Stiffness::Hertz(1e4)).gravity(-Vector3::z());
    for index in 0..40_usize {
        let [x, y, z] = [index % 3, index / 3 % 4, index / 12].map(|at| at as f64);
        let place = Vector3::new(1.99 * x + 0.2 * z, 2.01 * y - 0.1 * z, 1.01 + 1.99 * z);
        let speed = Vector3::new(0.1 * y, -0.2 * x, -0.1);
        setup = setup.sphere(place, 1.0, thrown(speed));
    }
    let [a, b] = [-20.0, 40.0].map(|y| Vector3::new(5.4, y, -20.0));
    let mesh = Mesh::new(vec![[a, b, Vector3::new(5.4, 10.0, 60.0)]])?;
    setup.mesh = Some(MovingMesh::at_rest(Arc::new(mesh)));
    Ok(setup.wall(Wall::fixed(Vector3::z(), 0.0)))
}

#[test]
fn two_names_for_one_material_change_no_bit_of_springs() -> Answer {
    for cohesion in [0.0, 0.5] {
        let one = heap(cohesion)?;
        let mut two = one.clone();
        let sprung = |law: ContactMaterial<Friction>| ContactMaterial {
            normal: law.normal,
            friction: Sprung {
                stiffness: one.stiffness,
                friction: law.friction,
            },
        };
        let laws = WorldMaterials {
            pairs: sprung(one.laws.pairs),
            walls: sprung(one.laws.walls),
        };
        let materials = (0..40).map(|index| index % 2).collect();
        two.mixture = Some(MaterialTable::new(materials, vec![1], |_| laws));
        let (mut one, mut two) = (SoftWorld::new(one)?, SoftWorld::new(two)?);
        let mut at_mesh = false;
        for _ in 0..400 {
            assert_eq!(one.step()?, two.step()?);
            let [_, walls] = &one.state().contacts;
            at_mesh |= walls
                .iter()
                .any(|contact| contact.bodies[1] > 0 && contact.in_range);
        }
        assert_eq!(one.state(), two.state());
        assert!(at_mesh);
    }
    Ok(())
}

#[test]
fn springs_reach_as_far_as_the_cohesion_of_their_own_material() -> Answer {
    // Across a gap of a hundredth of the radius, of a wall, of a mesh and of another sphere.
    let law = |strength: f64| -> Result<_, tribos_core::law::LawError> {
        let range = if strength > 0.0 { 0.02 } else { 0.0 };
        let pull = Cohesion::new(strength, range, Attraction::Pull)?;
        let friction = Sprung {
            stiffness: Stiffness::Linear(1e4),
            friction: IndependentFriction::sliding(0.3)?,
        };
        Ok(WorldMaterials::uniform(
            NormalLaw::new(pull, 0.0)?,
            friction,
        ))
    };
    let laws = [law(0.0)?, law(0.5)?];
    let mut setup = heap(0.0)?.gravity(Vector3::zeros());
    let at = |x: f64, y: f64, z: f64| Vector3::new(x, y, z);
    setup.positions = vec![
        at(4.39, 0.0, 5.0),
        at(4.39, 10.0, 5.0),
        at(0.0, 0.0, 1.01),
        at(0.0, 10.0, 1.01),
        at(-9.0, 0.0, 9.0),
        at(-9.0, 0.0, 11.01),
        at(-9.0, 10.0, 9.0),
        at(-9.0, 10.0, 11.01),
    ];
    setup.radii.truncate(8);
    setup.spheres = vec![solid(1.0, 1.0); 8];
    let materials = vec![0, 1, 0, 1, 0, 0, 1, 1];
    setup.mixture = Some(MaterialTable::new(materials, vec![0], |[a, _]| {
        laws[usize::from(a)]
    }));
    let mut world = SoftWorld::new(setup)?;
    world.step()?;
    let speed = |i: usize| world.state().spheres[i].velocity;
    assert_eq!([0, 2, 4, 5].map(speed), [Vector3::zeros(); 4]);
    assert!(speed(1).x > 0.0 && speed(3).z < 0.0 && speed(6).z > 0.0 && speed(7).z < 0.0);
    Ok(())
}

#[test]
fn the_residual_judges_each_contact_by_its_own_law() -> Answer {
    let up = Vector3::z();
    let (smooth, rough) = (laws(0.0, 0.0)?, laws(0.0, 0.7)?);
    let mut both = setup(rough).gravity(-up);
    both = both
        .sphere(up, 1.0, thrown(Vector3::x()))
        .wall(Wall::fixed(up, 0.0));
    both.mixture = Some(MaterialTable::new(vec![1], vec![1], |materials| {
        if materials == [1, 1] { smooth } else { rough }
    }));
    let mut world = World::new(both)?;
    let report = world.step()?;
    assert!(report.residual.relative < 1e-12);
    assert_eq!(world.state().spheres[0].velocity.x, 1.0);
    // Of another material the same impulse would be wrong.
    let mut other = world.problem().clone();
    other.mixture = Some(Arc::new(MaterialTable::new(vec![0], vec![0], |_| rough)));
    assert!(super::internals::residual(&other).relative > 0.1);
    Ok(())
}

#[test]
fn a_mixture_without_a_material_for_every_body_is_refused() -> Answer {
    let one = setup(laws(0.0, 0.3)?).sphere(Vector3::zeros(), 1.0, solid(1.0, 1.0));
    for (spheres, walls) in [(vec![], vec![]), (vec![0, 1], vec![]), (vec![0], vec![0])] {
        let mut setup = one.clone();
        setup.mixture = Some(MaterialTable::new(spheres, walls, |_| one.laws));
        let refused = World::new(setup).err();
        assert!(matches!(refused, Some(WorldError::Mixture)), "{refused:?}");
    }
    Ok(())
}
