//! What molecular dynamics promises: conservation, order, reversal, temperature, the same bits.

use nalgebra::Vector3;
use tribos::md::atoms::Atoms;
use tribos::md::group::{Group, MotionConstraint, ThermalFrame};
use tribos::md::interaction::Evaluation;
use tribos::md::neighbours::ListError;
use tribos::md::observe::{conserved_energy, kinetic_energies};
use tribos::md::pair::{LennardJones, Pairing, Shift};
use tribos::md::system::{Integrator, Setup, System, SystemError};
use tribos::md::thermostat::{Langevin, Noise, NoseHoover, RotationBias, Thermostat};
use tribos::space::PeriodicBox;

type Error = Box<dyn std::error::Error>;

/// A periodic face-centred cubic crystal of `cells`³ cubes at a density, warm.
fn crystal(cells: usize, density: f64, heat: f64) -> Result<Setup<LennardJones>, Error> {
    let edge = libm::cbrt(4.0 / density);
    let mut positions = Vec::new();
    for place in 0..cells * cells * cells {
        let cube = [place % cells, place / cells % cells, place / cells / cells];
        for inside in [
            [0.0, 0.0, 0.0],
            [0.0, 0.5, 0.5],
            [0.5, 0.0, 0.5],
            [0.5, 0.5, 0.0],
        ] {
            let at = |axis: usize| (cube[axis] as f64 + inside[axis]) * edge;
            positions.push(Vector3::new(at(0), at(1), at(2)));
        }
    }
    let mut atoms = Atoms::at(positions);
    let mut noise = Noise::new(5, 0, 0);
    for velocity in &mut atoms.velocities {
        *velocity = noise.vector() * heat.sqrt();
    }
    let mean: Vector3<f64> = atoms.velocities.iter().sum::<Vector3<f64>>() / atoms.len() as f64;
    for velocity in &mut atoms.velocities {
        *velocity -= mean;
    }
    Ok(Setup {
        group_of: vec![0; atoms.len()],
        atoms,
        space: PeriodicBox::new([Some(cells as f64 * edge); 3])?,
        interaction: lennard_jones(Shift::Force)?,
        skin: 0.3,
        groups: vec![Group::default()],
        drive: None,
        integrator: Integrator::VelocityVerlet,
        time_step: 0.005,
        seed: 11,
    })
}

fn lennard_jones(shift: Shift) -> Result<LennardJones, Error> {
    let pairing = Pairing {
        epsilon: 1.0,
        sigma: 1.0,
        cutoff: 2.5,
    };
    Ok(LennardJones::single(pairing, shift)?)
}

fn run(setup: Setup<LennardJones>, steps: usize) -> Result<System<LennardJones>, Error> {
    let mut system = System::new(setup)?;
    for _ in 0..steps {
        system.step(Evaluation::Sums)?;
    }
    Ok(system)
}

/// Error of what should be conserved at time 0.5, for time steps 1/1000, 1/2000 and 1/4000.
fn errors(group: Group) -> Result<[f64; 3], Error> {
    let mut errors = [0.0; 3];
    for (error, parts) in errors.iter_mut().zip([1000, 2000, 4000]) {
        let mut setup = crystal(5, 0.8442, 1.4)?;
        setup.time_step = 1.0 / f64::from(parts);
        setup.groups = vec![group];
        let start = conserved_energy(&System::new(crystal(5, 0.8442, 1.4)?)?);
        let system = run(setup, parts as usize / 2)?;
        *error = conserved_energy(&system) - start;
    }
    Ok(errors)
}

#[test]
fn the_energy_error_is_of_second_order() -> Result<(), Error> {
    let [coarse, middle, fine] = errors(Group::default())?;
    let slopes = [coarse / middle, middle / fine].map(|ratio| libm::log2(ratio.abs()));
    assert!((slopes[0] - 2.0).abs() < 0.01, "{slopes:?}");
    assert!((slopes[1] - 2.0).abs() < 0.0025, "{slopes:?}");
    Ok(())
}

#[test]
fn nose_hoover_conserves_its_energy_to_second_order() -> Result<(), Error> {
    let thermostat = NoseHoover::new(0.7, 0.3, RotationBias::Counts)?;
    let group = Group {
        thermostat: Thermostat::NoseHoover(thermostat),
        ..Group::default()
    };
    let [coarse, middle, fine] = errors(group)?;
    let slopes = [coarse / middle, middle / fine].map(|ratio| libm::log2(ratio.abs()));
    assert!(
        slopes.iter().all(|slope| (slope - 2.0).abs() < 0.02),
        "{slopes:?}"
    );
    Ok(())
}

/// 32 atoms in a periodic box.
fn small() -> Result<Setup<LennardJones>, Error> {
    let mut setup = crystal(2, 0.8442, 0.7)?;
    let pairing = Pairing {
        epsilon: 1.0,
        sigma: 1.0,
        cutoff: 1.33,
    };
    setup.interaction = LennardJones::single(pairing, Shift::Force)?;
    setup.skin = 0.3;
    Ok(setup)
}

#[test]
fn nose_hoover_keeps_the_mean_temperature_of_few_atoms_that_nothing_holds() -> Result<(), Error> {
    let mut setup = small()?;
    setup.groups[0].thermostat =
        Thermostat::NoseHoover(NoseHoover::new(0.7, 0.5, RotationBias::Counts)?);
    let mut system = System::new(setup)?;
    let (mut sum, mut count) = (0.0, 0.0);
    for step in 0..24_000 {
        system.step(Evaluation::Forces)?;
        if step >= 4_000 {
            // The mean velocity is none of their heat: 3 (N - 1) T/2.
            sum += 2.0 * kinetic_energies(&system)[0] / (3.0 * 31.0);
            count += 1.0;
        }
    }
    // The thermostat forces the mean.
    assert!((sum / count - 0.7).abs() < 0.003, "{}", sum / count);
    Ok(())
}

#[test]
fn momentum_is_no_heat_where_nothing_changes_it() -> Result<(), Error> {
    let freedoms = |change: &dyn Fn(&mut Setup<LennardJones>)| -> Result<f64, Error> {
        let mut setup = small()?;
        change(&mut setup);
        Ok(System::new(setup)?.heat_freedoms(0))
    };
    assert_eq!(freedoms(&|_| ())?, 93.0);
    let bath = Thermostat::NoseHoover(NoseHoover::new(0.7, 0.5, RotationBias::Counts)?);
    assert_eq!(freedoms(&|setup| setup.groups[0].thermostat = bath)?, 93.0);
    assert_eq!(
        freedoms(&|setup| setup.groups[0].frame = ThermalFrame::Mean)?,
        93.0
    );
    assert_eq!(
        freedoms(&|setup| setup.groups[0].hold = MotionConstraint::Plane)?,
        62.0
    );
    // Noise, a load and other groups change it.
    let noise = Thermostat::Langevin(Langevin::new(0.7, 1.0)?);
    assert_eq!(freedoms(&|setup| setup.groups[0].thermostat = noise)?, 96.0);
    assert_eq!(freedoms(&|setup| setup.groups[0].load = -0.1)?, 96.0);
    let two = |setup: &mut Setup<LennardJones>| {
        setup.groups.push(Group::default());
        setup.group_of[..2].fill(1);
    };
    assert_eq!(freedoms(&two)?, 90.0);
    Ok(())
}

#[test]
fn time_runs_backwards_too() -> Result<(), Error> {
    for integrator in [Integrator::VelocityVerlet, Integrator::LeapFrog] {
        let mut setup = crystal(5, 0.8442, 1.4)?;
        setup.integrator = integrator;
        let start = setup.atoms.positions.clone();
        let forth = run(setup, 300)?;
        let mut back = crystal(5, 0.8442, 1.4)?;
        back.integrator = integrator;
        back.atoms.positions = forth.atoms().positions.clone();
        back.atoms.velocities = forth.velocities_on_step().iter().map(|v| -v).collect();
        let end = run(back, 300)?;
        let farthest = start
            .iter()
            .zip(&end.atoms().positions)
            .map(|(a, b)| (a - b).norm())
            .fold(0.0, f64::max);
        // Rounding errors, grown by chaos e-fold in about 0.5 τ.
        assert!(farthest < 1e-8, "{integrator:?}: {farthest}");
    }
    Ok(())
}

#[test]
fn leap_frog_goes_where_velocity_verlet_goes() -> Result<(), Error> {
    let verlet = run(crystal(5, 0.8442, 1.4)?, 100)?;
    let mut setup = crystal(5, 0.8442, 1.4)?;
    setup.integrator = Integrator::LeapFrog;
    let frog = run(setup, 100)?;
    let pairs = |a: &[Vector3<f64>], b: &[Vector3<f64>]| {
        let ways = a.iter().zip(b).map(|(a, b)| (a - b).norm());
        ways.fold(0.0, f64::max)
    };
    let places = pairs(&verlet.atoms().positions, &frog.atoms().positions);
    let speeds = pairs(&verlet.velocities_on_step(), &frog.velocities_on_step());
    assert!(places < 1e-10 && speeds < 1e-9, "{places} {speeds}");
    Ok(())
}

#[test]
fn momentum_is_conserved_to_rounding() -> Result<(), Error> {
    let system = run(crystal(5, 0.8442, 1.4)?, 400)?;
    let momentum: Vector3<f64> = system.atoms().velocities.iter().sum();
    assert!(momentum.norm() < 1e-11, "{momentum}");
    Ok(())
}

#[test]
fn langevin_noise_gives_maxwells_velocities() -> Result<(), Error> {
    let mut setup = crystal(4, 0.8442, 0.7)?;
    setup.groups[0].thermostat = Thermostat::Langevin(Langevin::new(1.1, 2.0)?);
    setup.skin = 0.2;
    let mut system = System::new(setup)?;
    let mut speeds = Vec::new();
    for step in 0..4000 {
        system.step(Evaluation::Forces)?;
        // Velocities forget within 1/(2γ) = 50 steps.
        if step >= 1000 && step % 100 == 0 {
            let components = system
                .atoms()
                .velocities
                .iter()
                .flat_map(|v| v.iter().copied());
            speeds.extend(components);
        }
    }
    let count = speeds.len() as f64;
    let moment = |n: i32| speeds.iter().map(|v: &f64| v.powi(n)).sum::<f64>() / count;
    // Standard errors of the moments of a normal distribution, times four.
    let [first, second, fourth] = [1, 2, 4].map(moment);
    assert!(first.abs() < 4.0 * (1.1 / count).sqrt(), "{first}");
    let spread = 1.1 * (2.0 / count).sqrt();
    // BAOAB's velocities are colder by (ω Δt)²/4 at frequencies ω: below 1 % at Δt = 0.005.
    assert!((second - 1.1).abs() < 4.0 * spread + 0.003, "{second}");
    assert!(
        (fourth / (second * second) - 3.0).abs() < 4.0 * (24.0 / count).sqrt(),
        "{fourth}"
    );
    // Kolmogorov and Smirnov: the distance to the normal distribution, 0.1 % level.
    speeds.sort_by(f64::total_cmp);
    let normal = |v: f64| 0.5 * libm::erfc(-v / (2.0 * second).sqrt());
    let distance = speeds
        .iter()
        .enumerate()
        .map(|(index, &v)| (normal(v) - (index as f64 + 0.5) / count).abs())
        .fold(0.0, f64::max);
    assert!(distance < 1.95 / count.sqrt(), "{distance}");
    Ok(())
}

#[test]
fn damping_slows_a_lone_atom_exactly() -> Result<(), Error> {
    for [gamma, time_step] in [[0.1, 0.005], [3.0, 0.05], [500.0, 0.05]] {
        let mut atoms = Atoms::at(vec![Vector3::zeros()]);
        atoms.velocities[0] = Vector3::new(1.0, -2.0, 0.5);
        let setup = Setup {
            atoms,
            space: PeriodicBox::OPEN,
            interaction: lennard_jones(Shift::None)?,
            skin: 0.3,
            groups: vec![Group {
                damping: gamma,
                ..Group::default()
            }],
            group_of: vec![0],
            drive: None,
            integrator: Integrator::VelocityVerlet,
            time_step,
            seed: 1,
        };
        let system = run(setup, 100)?;
        let expected = libm::exp(-gamma * 100.0 * time_step);
        let got = system.atoms().velocities[0].x;
        assert!(
            (got - expected).abs() <= 1e-12 * expected + 1e-300,
            "{got} {expected}"
        );
    }
    Ok(())
}

#[test]
fn held_groups_keep_to_their_hold() -> Result<(), Error> {
    let holds = [
        MotionConstraint::Free,
        MotionConstraint::Frozen,
        MotionConstraint::Plane,
        MotionConstraint::Level,
        MotionConstraint::Turning {
            axis: [3.0, 4.0],
            rate: 0.25,
        },
    ];
    let mut setup = crystal(5, 0.8442, 0.3)?;
    setup.groups = holds
        .map(|hold| Group {
            hold,
            ..Group::default()
        })
        .to_vec();
    setup.group_of = (0..setup.atoms.len())
        .map(|atom| (atom % 5) as u8)
        .collect();
    for atom in 0..setup.atoms.len() {
        let velocity = &mut setup.atoms.velocities[atom];
        match atom % 5 {
            1 | 4 => *velocity = Vector3::zeros(),
            2 | 3 => velocity.z = 0.0,
            _ => {}
        }
    }
    let start = setup.atoms.positions.clone();
    let system = run(setup, 200)?;
    let places = &system.atoms().positions;
    let lifts: Vec<f64> = (0..start.len())
        .map(|atom| places[atom].z - start[atom].z)
        .collect();
    let arm = |place: &Vector3<f64>| libm::hypot(place.x - 3.0, place.y - 4.0);
    for atom in 0..start.len() {
        match atom % 5 {
            0 => assert!(places[atom] != start[atom]),
            1 => assert_eq!(places[atom], start[atom]),
            2 => assert_eq!(places[atom].z, start[atom].z),
            3 => assert!((lifts[atom] - lifts[3]).abs() < 1e-12),
            _ => assert!((arm(&places[atom]) - arm(&start[atom])).abs() < 1e-12),
        }
    }
    assert!(lifts[3] != 0.0);
    // 200 steps of 0.005 at 0.25 a time: a quarter of a radian.
    let at = |place: &Vector3<f64>| libm::atan2(place.y - 4.0, place.x - 3.0);
    assert!((at(&places[4]) - at(&start[4]) - 0.25).abs() < 1e-12);
    Ok(())
}

#[test]
fn a_run_goes_on_to_the_same_bits() -> Result<(), Error> {
    let setup = || -> Result<Setup<LennardJones>, Error> {
        let mut setup = crystal(5, 0.8442, 1.4)?;
        let nose = NoseHoover::new(0.7, 0.2, RotationBias::Counts)?;
        let noise = Langevin::new(0.7, 1.0)?;
        setup.groups = [Thermostat::NoseHoover(nose), Thermostat::Langevin(noise)]
            .map(|thermostat| Group {
                thermostat,
                ..Group::default()
            })
            .to_vec();
        setup.group_of = (0..setup.atoms.len())
            .map(|atom| (atom % 2) as u8)
            .collect();
        Ok(setup)
    };
    let whole = run(setup()?, 137)?;
    let half = run(setup()?, 71)?;
    let mut rest = System::resume(setup()?, half.state())?;
    for _ in 71..137 {
        rest.step(Evaluation::Sums)?;
    }
    assert_eq!(whole.state(), rest.state());
    assert_eq!(whole.tally(), rest.tally());
    Ok(())
}

#[test]
fn the_number_of_threads_changes_nothing() -> Result<(), Error> {
    let with = |threads: usize| -> Result<_, Error> {
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(threads)
            .build()?;
        let setup = crystal(13, 0.8442, 1.4)?;
        let state = pool.install(move || {
            let mut system = System::new(setup)?;
            for _ in 0..25 {
                system.step(Evaluation::Sums)?;
            }
            Ok::<_, SystemError>((system.state(), *system.tally()))
        })?;
        Ok(state)
    };
    let one = with(1)?;
    for threads in [2, 3] {
        assert_eq!(with(threads)?, one, "{threads} threads");
    }
    Ok(())
}

#[test]
fn what_cannot_run_is_refused_by_name() -> Result<(), Error> {
    let mut twins = crystal(5, 0.8442, 1.4)?;
    twins.atoms.positions[7] = twins.atoms.positions[3] + Vector3::new(1e-3, 0.0, 0.0);
    let Err(SystemError::Overlap { pair, distance }) = System::new(twins) else {
        return Err("an overlap was not refused".into());
    };
    assert_eq!(pair, [3, 7]);
    assert!((distance - 1e-3).abs() < 1e-12);

    let Err(SystemError::List(ListError::Cutoff { axis: 0, .. })) =
        System::new(crystal(2, 0.8442, 1.4)?)
    else {
        return Err("a cut-off beyond half the box was not refused".into());
    };

    let mut missing = crystal(5, 0.8442, 1.4)?;
    missing.atoms.masses = vec![1.0; 2];
    let Err(SystemError::Species { known: 1, given: 2 }) = System::new(missing) else {
        return Err("a missing species was not refused".into());
    };

    let mut wild = crystal(5, 0.8442, 1.4)?;
    wild.time_step = 0.2;
    let mut system = System::new(wild)?;
    let blown = (0..100).find_map(|_| system.step(Evaluation::Forces).err());
    let Some(SystemError::BlownUp { step, .. }) = blown else {
        return Err("a run that blew up was not stopped".into());
    };
    assert!(step < 100);
    Ok(())
}
