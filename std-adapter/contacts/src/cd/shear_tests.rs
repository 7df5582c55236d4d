//! Sheared cells: collisions across the border, energy and stress, scaling, threads.

use super::internals::Coefficients;
use super::{
    ContactSolver, SolverMethod, StepLimits, Wall, World, WorldError, WorldMaterials, WorldSetup,
    solid,
};
use nalgebra::Vector3;
use tribos_base::random::Random;
use tribos_base::space::PeriodicBox;
use tribos_core::contact::{
    AllModes, Cohesion, ContactFriction, IndependentFriction, NormalLaw, SlidingOnly, SphereBody,
};

pub(super) type Answer = Result<(), Box<dyn std::error::Error>>;

pub(super) fn laws(
    restitution: f64,
) -> Result<WorldMaterials<IndependentFriction<f64, AllModes>>, tribos_core::law::LawError> {
    let normal = NormalLaw::new(Cohesion::NONE, restitution)?;
    Ok(WorldMaterials::uniform(
        normal,
        IndependentFriction::all(0.4, 0.1, 0.05)?,
    ))
}

pub(super) fn solver(tolerance: f64) -> ContactSolver {
    ContactSolver {
        method: SolverMethod::Accelerated { tolerance },
        most_sweeps: 5_000,
        warm_start: 1.0,
    }
}

/// A lattice of spheres of radius 1 with random velocities, sheared. *Units*: density 1.
pub(super) fn gas<F: ContactFriction<f64>>(
    laws: WorldMaterials<F>,
    counts: [usize; 3],
    spacing: f64,
    rate: f64,
) -> Result<WorldSetup<F>, Box<dyn std::error::Error>> {
    let mut random = Random::new(11, 0);
    let mut setup = WorldSetup::new(laws);
    setup.space = PeriodicBox::new(counts.map(|count| Some(spacing * count as f64)))?;
    for index in 0..counts.iter().product() {
        let [x, y, _] = counts;
        let cell = [index % x, index / x % y, index / (x * y)];
        let mut jitter = |size: f64| {
            let mut part = || size * (2.0 * random.unit() - 1.0);
            Vector3::new(part(), part(), part())
        };
        let ball = SphereBody {
            velocity: jitter(0.5),
            spin: jitter(0.5),
            ..solid(1.0, 1.0)
        };
        let place = Vector3::from(cell.map(|cell| (0.5 + cell as f64) * spacing));
        setup = setup.sphere(place + jitter(0.02), 1.0, ball);
    }
    setup.step_limits = StepLimits {
        longest: 0.02,
        motion: 0.05,
    };
    setup.solver = solver(1e-11);
    Ok(setup.sheared(rate))
}

#[test]
fn spheres_collide_across_the_sheared_border_as_with_an_image_in_the_open() -> Answer {
    let (length, height) = (20.0, 12.0);
    for (rate, restitution) in [(0.3, 0.0), (-0.3, 0.6), (0.05, 1.0)] {
        let low = SphereBody {
            velocity: Vector3::new(0.2, -0.1, -0.3),
            spin: Vector3::new(0.1, 0.7, -0.2),
            ..solid(1.0, 1.0)
        };
        let high = SphereBody {
            velocity: Vector3::new(-0.1, 0.2, 0.4),
            ..solid(1.2, 2.0)
        };
        let mut setup = WorldSetup::new(laws(restitution)?)
            .sphere(Vector3::new(3.0, 5.0, 1.2), 1.0, low)
            .sphere(Vector3::new(3.4, 5.3, 10.9), 1.2, high);
        setup.space = PeriodicBox::new([Some(length), Some(length), Some(height)])?;
        setup.step_limits = StepLimits {
            longest: 0.01,
            motion: 0.1,
        };
        setup.solver = solver(1e-14);
        let setup = setup.sheared(rate);
        let start = setup.spheres[1].velocity;
        let jump = Vector3::new(0.0, 0.0, height);
        let faster = Vector3::x() * (rate * height);
        let mut open = setup.clone();
        open.space = PeriodicBox::OPEN;
        open.shear_rate = 0.0;
        open.positions[1] -= jump;
        open.spheres[1].velocity -= faster;

        let (mut cell, mut open) = (World::new(setup)?, World::new(open)?);
        let mut largest = 0.0_f64;
        for _ in 0..80 {
            cell.step()?;
            open.step()?;
            let [ours, theirs] = [cell.state(), open.state()].map(|state| &state.spheres);
            largest = largest.max((theirs[1].velocity + faster - start).norm());
            // The lower sphere may have left through the bottom by now.
            let level = cell.setup().space.levels(cell.state().positions[0].z - 1.2);
            assert!((ours[0].velocity - faster * level - theirs[0].velocity).norm() < 1e-12);
            assert!((ours[0].spin - theirs[0].spin).norm() < 1e-12);
            assert!((ours[1].spin - theirs[1].spin).norm() < 1e-12);
        }
        assert!(largest > 0.1, "they did not collide: {largest}");
    }
    Ok(())
}

#[test]
fn a_lone_sphere_crosses_the_border_and_keeps_its_own_velocity() -> Answer {
    for (rate, up) in [(0.2, 1.0), (0.2, -1.0), (-0.1, 1.0)] {
        let ball = SphereBody {
            velocity: Vector3::z() * up,
            ..solid(1.0, 1.0)
        };
        let mut setup = WorldSetup::new(laws(0.0)?).sphere(Vector3::repeat(4.0), 1.0, ball);
        setup.space = PeriodicBox::new([Some(10.0), None, Some(8.0)])?;
        let mut world = World::new(setup.sheared(rate))?;
        while world.state().time < 20.0 {
            world.step()?;
        }
        let state = world.state();
        let [x, z] = [state.positions[0].x, state.positions[0].z];
        let levels = 0.5 * up + 2.0 * up; // 20 of 8 in z, from the middle
        assert!((0.0..8.0).contains(&z));
        // Free flight in the open is straight: the images differ by their own motion alone.
        let shift = state.shear_offset - (rate * 8.0 * state.time).rem_euclid(10.0);
        assert!(shift.abs().min(10.0 - shift.abs()) < 1e-9);
        let crossed = ((4.0 + up * state.time - z) / 8.0).round();
        assert!((crossed - levels.trunc()).abs() <= 1.0 && crossed != 0.0);
        assert!((state.spheres[0].velocity.x + crossed * rate * 8.0).abs() < 1e-12);
        let straight = x + crossed * state.shear_offset - 4.0;
        assert!(
            (straight / 10.0 - (straight / 10.0).round()).abs() < 1e-9,
            "{straight}"
        );
        assert!(state.energy.imbalance().abs() < 1e-9);
    }
    Ok(())
}

/// Sums over a run: work by the stress, from impulses and motions alone, and the work of the balance.
fn works<F: ContactFriction<f64> + Coefficients>(
    setup: WorldSetup<F>,
    steps: usize,
) -> Result<[f64; 3], WorldError> {
    let rate = setup.shear_rate;
    let middle = 0.5 * setup.space.lengths()[2].unwrap_or(0.0);
    let mut world = World::new(setup)?;
    // Σ m v_x z, of which the work is the rate of change but for the stress.
    let moment = |world: &World<F>| -> f64 {
        let state = world.state();
        let spheres = state.spheres.iter().zip(&state.positions);
        spheres
            .map(|(s, x)| s.velocity.x * (x.z - middle) / s.inv_mass)
            .sum()
    };
    let start = moment(&world);
    let mut flux = 0.0;
    for _ in 0..steps {
        let dt = world.step()?.dt;
        for link in world.problem().pairs.iter() {
            let (contact, normal) = (&link.contact, link.contact.normal());
            let [a, b] = contact.centre_distances();
            flux += contact.impulse().linear(normal).x * (a + b) * normal.z;
        }
        let spheres = &world.problem().spheres;
        let carried = |s: &crate::cd::internals::Aligned| s.velocity.x * s.velocity.z / s.inv_mass;
        flux += dt * spheres.iter().map(carried).sum::<f64>();
    }
    let stress = rate * (moment(&world) - start - flux);
    let book = world.state().energy;
    Ok([stress, book.work, book.imbalance()])
}

#[test]
fn work_of_the_shear_is_stress_by_rate_by_volume_and_closes_the_balance() -> Answer {
    for (rate, restitution) in [(0.3, 0.0), (-0.3, 0.0), (0.5, 0.5)] {
        let setup = gas(laws(restitution)?, [4, 4, 4], 2.3, rate)?;
        let [stress, work, imbalance] = works(setup, 400)?;
        assert!(work > 20.0, "{work}");
        assert!(imbalance.abs() < 1e-10 * work, "{imbalance} of {work}");
        // Spheres cross the border up to a step late.
        assert!((stress / work - 1.0).abs() < 0.01, "{stress} {work}");
    }
    Ok(())
}

#[test]
fn momentum_across_the_flow_is_kept_and_the_residual_sees_the_images() -> Answer {
    let mut world = World::new(gas(laws(0.0)?, [4, 4, 4], 2.1, 0.4)?)?;
    let momentum = |world: &World<_>| -> Vector3<f64> {
        let spheres = world.state().spheres.iter();
        spheres.map(|s| s.velocity / s.inv_mass).sum()
    };
    let start = momentum(&world);
    let mut images = 0;
    for _ in 0..200 {
        let report = world.step()?;
        assert!(report.is_met() && report.residual.relative < 1e-9);
        images += world.problem().images.len();
    }
    assert!(images > 1000, "{images}");
    assert!((momentum(&world) - start).yz().norm() < 1e-10);
    // A solution for still images is none for those that move.
    let mut still = world.problem().clone();
    still
        .images
        .iter_mut()
        .for_each(|(_, faster)| faster.x *= 0.5);
    assert!(super::internals::residual(&still).relative > 1e-3);
    Ok(())
}

#[test]
fn twice_the_rate_takes_the_same_way_in_half_the_time_to_the_bit() -> Answer {
    let run = |factor: f64| -> Result<_, Box<dyn std::error::Error>> {
        let mut setup = gas(laws(0.3)?, [4, 3, 4], 2.2, 0.25)?;
        for sphere in &mut setup.spheres {
            sphere.velocity *= factor;
            sphere.spin *= factor;
        }
        setup.shear_rate *= factor;
        setup.step_limits.longest /= factor;
        let mut world = World::new(setup)?;
        for _ in 0..150 {
            world.step()?;
        }
        Ok(world.state().clone())
    };
    let (slow, fast) = (run(1.0)?, run(2.0)?);
    assert_eq!(slow.positions, fast.positions);
    assert_eq!(slow.shear_offset, fast.shear_offset);
    assert_eq!(
        [slow.time, 4.0 * slow.energy.work],
        [2.0 * fast.time, fast.energy.work]
    );
    assert!(slow.energy.work > 1.0);
    Ok(())
}

#[test]
fn sheared_states_have_the_same_bits_on_any_number_of_threads() -> Answer {
    let friction = IndependentFriction::<f64, SlidingOnly>::sliding(0.5)?;
    let laws = WorldMaterials::uniform(NormalLaw::new(Cohesion::NONE, 0.0)?, friction);
    let mut setup = gas(laws, [12, 12, 14], 2.02, 0.2)?;
    setup.solver = solver(1e-4);
    let on = |threads: usize| -> Result<_, Box<dyn std::error::Error>> {
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(threads)
            .build()?;
        let mut world = World::new(setup.clone())?;
        let stepped: Result<Vec<_>, _> = pool.install(|| (0..6).map(|_| world.step()).collect());
        stepped?;
        assert!(world.problem().pairs.len() > 2_500 && world.problem().images.len() > 100);
        Ok(world.state().clone())
    };
    let alone = on(1)?;
    for threads in [2, 5] {
        assert!(on(threads)? == alone, "{threads} threads");
    }
    Ok(())
}

#[test]
fn a_run_that_goes_on_from_a_state_takes_the_same_steps() -> Answer {
    let mut world = World::new(gas(laws(0.2)?, [4, 3, 4], 2.2, 0.4)?)?;
    for _ in 0..60 {
        world.step()?;
    }
    let mut again = World::resume(world.setup().clone(), world.state().clone());
    for _ in 0..60 {
        world.step()?;
        again.step()?;
    }
    assert!(world.state().shear_offset > 0.0);
    assert_eq!(again.state(), world.state());
    Ok(())
}

#[test]
fn cells_that_cannot_be_sheared_are_refused() -> Answer {
    let sound = gas(laws(0.0)?, [3, 3, 3], 2.5, 0.1)?;
    assert!(World::new(sound.clone()).is_ok());
    let mut open = sound.clone();
    open.space = PeriodicBox::new([Some(7.5), Some(7.5), None])?;
    let mut sleepy = sound.clone();
    sleepy.sleep_speed = 1e-3;
    let mut endless = sound.clone();
    endless.shear_rate = f64::INFINITY;
    let floored = sound.clone().wall(Wall::fixed(Vector3::z(), 0.0));
    for setup in [open, sleepy, endless, floored] {
        let refused = World::new(setup).err();
        assert!(
            matches!(refused, Some(WorldError::Shear { .. })),
            "{refused:?}"
        );
    }
    // Walls beside the flow are none of the shear's.
    let beside = sound.wall(Wall::fixed(Vector3::y(), -5.0));
    assert!(World::new(beside).is_ok());
    Ok(())
}

/// Inertial number and stress ratio of a steady flow, after a strain of 2 and over one of 3.
fn flow_law(mu: f64, spacing: f64) -> Result<[f64; 2], Box<dyn std::error::Error>> {
    let friction = IndependentFriction::<f64, SlidingOnly>::sliding(mu)?;
    let laws = WorldMaterials::uniform(NormalLaw::new(Cohesion::NONE, 0.7)?, friction);
    let mut setup = gas(laws, [5, 5, 5], spacing, 1.0)?;
    // Equal spheres would order.
    for (index, radius) in setup.radii.iter_mut().enumerate() {
        *radius = 0.9 + 0.05 * (index * 7 % 5) as f64;
        let sphere = &mut setup.spheres[index];
        *sphere = SphereBody {
            velocity: sphere.velocity,
            spin: sphere.spin,
            ..solid(*radius, 1.0)
        };
    }
    setup.solver = solver(1e-4);
    let volume: f64 = setup.space.lengths().into_iter().flatten().product();
    let middle = 0.5 * setup.space.lengths()[2].unwrap_or(0.0);
    let mut world = World::new(setup)?;
    let (mut shear, mut pressure, mut time) = (0.0, 0.0, 0.0);
    while world.state().time < 5.0 {
        let dt = world.step()?.dt;
        if world.state().time < 2.0 {
            continue;
        }
        time += dt;
        for link in world.problem().pairs.iter() {
            let (contact, normal) = (&link.contact, link.contact.normal());
            let [a, b] = contact.centre_distances();
            let impulse = contact.impulse().linear(normal) * (a + b);
            shear -= impulse.x * normal.z;
            pressure += impulse.dot(normal) / 3.0;
        }
        let state = world.state();
        for (sphere, x) in state.spheres.iter().zip(&state.positions) {
            let own = sphere.velocity - Vector3::x() * (x.z - middle);
            shear -= dt * own.x * own.z / sphere.inv_mass;
            pressure += dt * own.norm_squared() / (3.0 * sphere.inv_mass);
        }
    }
    // Diameter 2, rate 1, density 1.
    let inertial = 2.0 / (pressure / (volume * time)).sqrt();
    Ok([inertial, shear / pressure])
}

#[test]
fn stress_ratio_of_a_flow_lies_in_the_band_of_published_flows() -> Answer {
    // Glass beads: Jop, Forterre and Pouliquen, Nature 441 (2006) 727. Simulated spheres with μ = 0.5 at constant
    // volume lie up to 0.1 above (Chialvo, Sun and Sundaresan, Phys. Rev. E 85 (2012) 021305).
    let beads = |inertial: f64| 0.38 + 0.26 / (0.279 / inertial + 1.0);
    let mut last = 0.0;
    for spacing in [1.98, 2.05] {
        let [inertial, ratio] = flow_law(0.5, spacing)?;
        assert!((0.2..1.5).contains(&inertial), "{inertial}");
        let above = ratio - beads(inertial);
        assert!(
            (-0.05..0.15).contains(&above),
            "{ratio} at {inertial}: {above}"
        );
        // The looser flow is the faster one under the same pressure, and resists more.
        assert!(inertial > last, "{inertial} {last}");
        last = inertial;
    }
    let [_, smooth] = flow_law(0.0, 2.05)?;
    assert!(smooth > 0.1 && smooth < 0.55, "{smooth}");
    Ok(())
}
