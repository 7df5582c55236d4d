//! Deforming cells of rigid spheres: stress on every axis, energy, threads, going on, refusals.

use super::shear_tests::{Answer, gas, laws, solver};
use super::{AxisControl, CellControl, Wall, World, WorldError, WorldSetup};
use nalgebra::Vector3;
use tribos_core::contact::{AllModes, IndependentFriction};

type Setup = WorldSetup<IndependentFriction<f64, AllModes>>;
type Rough = World<IndependentFriction<f64, AllModes>>;

/// A gas of 64 spheres in a cell that is pressed by different stresses, and sheared.
fn pressed(rate: f64) -> Result<Setup, Box<dyn std::error::Error>> {
    let mut gas = gas(laws(0.0)?, [4, 4, 4], 2.3, 0.0)?;
    gas.solver = solver(1e-8);
    Ok(gas.deforming(CellControl {
        axes: [10.0, 11.0, 12.0].map(AxisControl::Stress),
        shear_rate: rate,
        mass: 100.0,
    }))
}

/// Stress along the axes: of the contacts by the forces across every plane, that is Σ f l/V, and of the motion.
fn stress(world: &Rough) -> Vector3<f64> {
    let (state, space) = (world.state(), world.space());
    let mut sum = Vector3::zeros();
    for ([a, b], force) in &state.memory.forces[0] {
        let [a, b] = [a, b].map(|body| state.positions[*body as usize]);
        let way = space.displacement(&a, &b);
        let force = way.normalize() * force.normal + force.sliding();
        sum += force.component_mul(&way);
    }
    let volume: f64 = space.lengths().into_iter().flatten().product();
    sum / volume
}

#[test]
fn a_packing_comes_to_rest_under_the_stresses_that_press_it() -> Answer {
    let mut world = World::new(pressed(0.0)?)?;
    let (mut steps, mut unmet) = (0, 0);
    while world.state().time < 12.0 {
        let report = world.step()?;
        assert!(report.residual.relative < 1e-6, "{report:?}");
        (steps, unmet) = (steps + 1, unmet + u32::from(!report.is_met()));
    }
    assert!(100 * unmet < steps, "{unmet} of {steps}");
    let state = world.state();
    // Spheres of radius 1 have filled 35 % of the cell, and jam.
    let volume: f64 = world.space().lengths().into_iter().flatten().product();
    let solid = 64.0 * 4.0 / 3.0 * std::f64::consts::PI / volume;
    assert!((0.5..0.68).contains(&solid), "{solid}");
    assert!(
        state.energy.kinetic < 1e-6 * state.energy.work,
        "{:?}",
        state.energy
    );
    assert!(state.energy.imbalance().abs() < 1e-9 * state.energy.work);
    let found = stress(&world);
    for (found, given) in found.iter().zip([10.0, 11.0, 12.0]) {
        assert!((found / given - 1.0).abs() < 1e-3, "{found} for {given}");
    }
    Ok(())
}

#[test]
fn the_work_on_the_grains_is_what_the_axes_lose() -> Answer {
    // Axes of a given mass M under no stress but that of the contacts: ½ M Σ L'² and the energy of the spheres, lost and kept.
    let mut setup = gas(laws(0.0)?, [4, 4, 4], 2.1, 0.0)?;
    setup
        .spheres
        .iter_mut()
        .for_each(|sphere| sphere.velocity *= 0.0);
    let mass = 300.0;
    let free = [AxisControl::Stress(0.0); 3];
    let mut world = World::new(setup.deforming(CellControl {
        axes: free,
        shear_rate: 0.0,
        mass,
    }))?;
    let speeds = [-0.4, 0.0, -0.2];
    if let Some(cell) = &mut world.state_mut().cell {
        cell.speeds = speeds;
    }
    let axes = |world: &Rough| -> f64 {
        let speeds = world.state().cell.map_or([0.0; 3], |cell| cell.speeds);
        0.5 * mass * speeds.iter().map(|speed| speed * speed).sum::<f64>()
    };
    let begin = axes(&world);
    for _ in 0..150 {
        world.step()?;
    }
    let energy = world.state().energy;
    // The contacts stop the axes, in collisions without rebound: what they lose in a step is half of Δ(L')² beside the work.
    assert!(
        axes(&world) < 0.7 * begin && energy.work > 0.05 * begin,
        "{} {begin} {energy:?}",
        axes(&world)
    );
    assert!(energy.work < begin - axes(&world));
    assert!(energy.imbalance().abs() < 1e-10 * begin);
    Ok(())
}

#[test]
fn a_flow_under_a_normal_stress_has_it_on_the_mean() -> Answer {
    let mut setup = gas(laws(0.0)?, [4, 4, 4], 2.15, 0.0)?;
    setup.gravity = Vector3::zeros();
    let axes = [
        AxisControl::Fixed,
        AxisControl::Fixed,
        AxisControl::Stress(10.0),
    ];
    let cell = CellControl {
        axes,
        shear_rate: 0.4,
        mass: 300.0,
    };
    let mut world = World::new(setup.deforming(cell))?;
    let (mut sum, mut time) = (0.0, 0.0);
    while world.state().time < 60.0 {
        let dt = world.step()?.dt;
        if world.state().time > 20.0 {
            sum += stress(&world).z * dt;
            time += dt;
        }
    }
    let state = world.state();
    // The motion bears what the contacts do not: some per cent.
    assert!(
        (0.85..1.02).contains(&(sum / time / 10.0)),
        "{}",
        sum / time
    );
    assert!(state.energy.imbalance().abs() < 1e-9 * state.energy.work);
    assert!(
        state
            .cell
            .is_some_and(|cell| cell.space.offset() == state.shear_offset)
    );
    Ok(())
}

#[test]
fn the_same_bits_on_any_threads_and_from_any_state() -> Answer {
    let on = |threads: usize, parts: &[usize]| -> Result<_, Box<dyn std::error::Error>> {
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(threads)
            .build()?;
        let mut world = World::new(pressed(0.3)?)?;
        for steps in parts {
            world = World::resume(world.setup().clone(), world.state().clone());
            pool.install(|| (0..*steps).try_for_each(|_| world.step().map(|_| ())))?;
        }
        Ok(world.state().clone())
    };
    let whole = on(1, &[200])?;
    assert!(on(3, &[200])? == whole && on(2, &[120, 80])? == whole);
    Ok(())
}

#[test]
fn cells_that_cannot_deform_are_refused() -> Answer {
    let refused = |change: &dyn Fn(&mut Setup)| -> Result<WorldError, Box<dyn std::error::Error>> {
        let mut setup = pressed(0.0)?;
        change(&mut setup);
        World::new(setup).err().ok_or_else(|| "taken".into())
    };
    let bouncing = laws(0.5)?;
    let cell = refused(&|setup| setup.laws = bouncing)?;
    assert!(matches!(cell, WorldError::RigidCell), "{cell}");
    let cell = refused(&|setup| setup.walls.push(Wall::fixed(Vector3::z(), 0.0)))?;
    assert!(matches!(cell, WorldError::RigidCell), "{cell}");
    let cell = refused(&|setup| setup.spheres[3].inv_mass = 0.0)?;
    assert!(
        matches!(cell, WorldError::Sphere { .. } | WorldError::RigidCell),
        "{cell}"
    );
    let massless = |setup: &mut Setup| {
        if let Some(cell) = &mut setup.cell {
            cell.mass = 0.0;
        }
    };
    assert!(matches!(refused(&massless)?, WorldError::CellMass { .. }));
    Ok(())
}
