//! A tip in motion: drive, holds, load, damping, stages.

use nalgebra::Vector3;
use tribos::md::interaction::Evaluation;
use tribos::md::observe::{RotationAngle, conserved_energy};
use tribos::md::system::{System, SystemError};
use tribos::run::Simulation;
use tribos::scene::TipScene;
use tribos::tip::{AtomRole, TipError, TipForces, TipSimulation, build};
use tribos_tests::tips::{tiny, to_the_end};

type Error = Box<dyn std::error::Error>;

/// Nothing moves but by forces.
const COLD: &str = "temperature = 0\nthermostat = \"none\"\ndrive_damping_rate = 0\nequilibration = 0\n\
                    integrator = \"velocity-verlet\"";

/// Its system, before the first step.
fn system(scene: &TipScene) -> Result<System<TipForces>, Error> {
    Ok(System::new(build(scene)?.setup)?)
}

fn steps(system: &mut System<TipForces>, count: usize) -> Result<(), Error> {
    for _ in 0..count {
        system.step(Evaluation::Forces)?;
    }
    Ok(())
}

/// Driven atoms.
fn driven(system: &System<TipForces>) -> &[usize] {
    system.members(AtomRole::ALL.len() - 1)
}

/// From the axis.
fn arm(scene: &TipScene, place: &Vector3<f64>) -> [f64; 2] {
    let [x, y] = scene.shape().axis();
    [place.x - x, place.y - y]
}

#[test]
fn all_driven_atoms_begin_with_the_same_angular_acceleration() -> Result<(), Error> {
    let lambda = 30.0;
    for reading in ["angular", "mean", "largest"] {
        let with = |lambda: f64| {
            tiny(&format!(
                "{COLD}\nlambda = {lambda:?}\nreading = \"{reading}\""
            ))
        };
        let scene = with(lambda)?;
        let (mut pushed, mut left) = (system(&scene)?, system(&with(0.0)?)?);
        let start = left.atoms().positions.clone();
        let members = driven(&left).to_vec();
        let arms: Vec<[f64; 2]> = members
            .iter()
            .map(|&atom| arm(&scene, &start[atom]))
            .collect();
        let lengths = || arms.iter().map(|[x, y]| x.hypot(*y));
        let acceleration = lambda
            / match reading {
                "angular" => 1.0,
                "mean" => lengths().sum::<f64>() / arms.len() as f64,
                _ => lengths().fold(0.0, f64::max),
            };
        steps(&mut pushed, 1)?;
        steps(&mut left, 1)?;
        let way = |atom: usize| pushed.atoms().positions[atom] - left.atoms().positions[atom];
        for (&atom, [x, y]) in members.iter().zip(&arms) {
            let half_time_sq = 0.5 * scene.time_step * scene.time_step;
            let expected = Vector3::new(-y, *x, 0.0) * (acceleration * half_time_sq);
            // A place of ten is rounded to 1e-15, a way is a thousandth.
            assert!((way(atom) - expected).norm() < 1e-14, "{reading} {atom}");
        }
        let others = (0..start.len()).filter(|atom| !members.contains(atom));
        assert!(others.into_iter().all(|atom| way(atom) == Vector3::zeros()));
    }
    Ok(())
}

#[test]
fn a_free_tip_gets_the_angular_momentum_of_the_drive_and_keeps_it() -> Result<(), Error> {
    for integrator in ["velocity-verlet", "leap-frog"] {
        // So little adhesion that the substrate does not hold the tip.
        let scene = tiny(&format!(
            "lambda = 0.05\nadhesion_energy = 1e-14\nshift = \"force\"\ntemperature = 0\ndrive_damping_rate = 0\n\
             thermostat = \"none\"\nintegrator = \"{integrator}\"\nequilibration = 0.1\n\
             drive_time = 1\nrest_time = 1"
        ))?;
        let mut system = system(&scene)?;
        let mut given = 0.0;
        for step in 1..=400 {
            // Kicks of half a step at both ends of each step of the drive.
            let is_driven = step > 20 && step <= 220;
            let kick = |system: &System<TipForces>| {
                let strength = if is_driven { scene.lambda } else { 0.0 };
                0.5 * scene.time_step * strength * inertia(&scene, system)
            };
            given += kick(&system);
            system.step(Evaluation::Forces)?;
            given += kick(&system);
            // The velocity of the last step's end knows nothing of the next step.
            let off = momentum(&scene, &system) - given;
            assert!(off.abs() < 1e-10, "{integrator} {step} {off}");
        }
        assert!(given > 1.0, "{given}");
    }
    Ok(())
}

/// Angular momentum of the tip about the axis.
fn momentum(scene: &TipScene, system: &System<TipForces>) -> f64 {
    let velocities = system.velocities_on_step();
    let atoms = (3..AtomRole::ALL.len()).flat_map(|group| system.members(group));
    let part = |&atom: &usize| {
        let [x, y] = arm(scene, &system.atoms().positions[atom]);
        x * velocities[atom].y - y * velocities[atom].x
    };
    atoms.map(part).sum()
}

/// Moment of inertia of the driven atoms.
fn inertia(scene: &TipScene, system: &System<TipForces>) -> f64 {
    let part = |&atom: &usize| {
        let [x, y] = arm(scene, &system.atoms().positions[atom]);
        x * x + y * y
    };
    driven(system).iter().map(part).sum()
}

#[test]
fn held_layers_stay_where_they_are() -> Result<(), Error> {
    for (hold, is_level) in [("plane", false), ("level", true)] {
        let scene = tiny(&format!(
            "lambda = 0.05\ndriven_constraint = \"{hold}\"\nequilibration = 0\ndrive_time = 1\nrest_time = 0"
        ))?;
        let mut run = TipSimulation::new(&scene)?;
        let start = run.system().atoms().positions.clone();
        to_the_end(&mut run)?;
        let end = &run.system().atoms().positions;
        assert!(
            run.system()
                .members(0)
                .iter()
                .all(|&atom| start[atom] == end[atom])
        );
        let layers = scene.shape().layers();
        let mut heights = vec![Vec::new(); layers];
        for &atom in driven(run.system()) {
            assert!(start[atom].xy() != end[atom].xy(), "{atom}");
            heights[run.layers()[atom]].push(end[atom].z.to_bits());
            assert_eq!(start[atom].z != end[atom].z, is_level, "{atom}");
        }
        for layer in heights {
            assert!(layer.windows(2).all(|pair| pair[0] == pair[1]), "{hold}");
        }
        // Both driven layers as one.
        let [lower, upper] = [layers - 2, layers - 1].map(|layer| {
            let of = run.layers().iter().position(|&other| other == layer);
            of.map_or(f64::NAN, |atom| end[atom].z - start[atom].z)
        });
        assert!((lower - upper).abs() < 1e-13, "{lower} {upper}");
    }
    Ok(())
}

#[test]
fn a_load_presses_the_tip_down_until_the_substrate_carries_it() -> Result<(), Error> {
    let mut heights = Vec::new();
    for load in [-1.0, 0.0, 1.0, 3.0, 10.0] {
        // Friction and no heat: everything comes to rest.
        let scene = tiny(&format!(
            "lambda = 0\ndriven_constraint = \"level\"\nload = {load:?}\ndrive_damping_rate = 2\nthermostat = \"langevin\"\n\
             langevin_rate = 2\ntemperature = 0\nshift = \"force\"\nequilibration = 0\n\
             drive_time = 0\nrest_time = 15\ntime_step = 0.01\nsample_every = 1500"
        ))?;
        let mut run = TipSimulation::new(&scene)?;
        to_the_end(&mut run)?;
        let system = run.system();
        let push: f64 = driven(system)
            .iter()
            .map(|&atom| system.forces()[atom].z)
            .sum();
        let carried = push / driven(system).len() as f64;
        assert!((carried - load).abs() < 1e-3, "{load} {carried}");
        heights.push(run.series().last().map_or(f64::NAN, |line| line[3]));
    }
    assert!(heights.is_sorted_by(|high, low| high > low), "{heights:?}");
    Ok(())
}

#[test]
fn damping_takes_its_share_of_the_driven_atoms_motion_only() -> Result<(), Error> {
    let rate = 20.0;
    let with = |damping: f64| {
        tiny(&format!(
            "lambda = 0\nthermostat = \"none\"\nintegrator = \"velocity-verlet\"\n\
             drive_damping_rate = {damping:?}"
        ))
    };
    let scene = with(rate)?;
    let (mut damped, mut plain) = (system(&scene)?, system(&with(0.0)?)?);
    let before = damped.atoms().clone();
    let forces = damped.forces().to_vec();
    steps(&mut damped, 1)?;
    steps(&mut plain, 1)?;
    let time = scene.time_step;
    for (atom, force) in forces.iter().enumerate() {
        let after = &damped.atoms().positions[atom];
        if driven(&damped).contains(&atom) {
            let kept = before.velocities[atom] * (-rate * 0.5 * time).exp();
            let mut push = *force;
            push.z = 0.0;
            let way = (kept + push * (0.5 * time)) * time;
            assert!((after - before.positions[atom] - way).norm() < 1e-14);
        } else {
            assert_eq!(*after, plain.atoms().positions[atom]);
        }
    }
    Ok(())
}

#[test]
fn the_angle_counts_turns_of_a_known_rotation() -> Result<(), Error> {
    let scene = tiny("lambda = 0")?;
    let sites = scene.shape().sites();
    let places: Vec<Vector3<f64>> = sites.iter().map(|site| site.place).collect();
    let tip: Vec<usize> = (0..sites.len())
        .filter(|&i| sites[i].part == AtomRole::Driven)
        .collect();
    let [x0, y0] = scene.shape().axis();
    for direction in [1.0, -1.0] {
        let mut torsion = RotationAngle::new(tip.clone(), &places);
        for step in 0..=40_u32 {
            let angle = direction * 0.3 * f64::from(step);
            let (sin, cos) = angle.sin_cos();
            // It wanders off meanwhile, stretches and lifts.
            let now: Vec<Vector3<f64>> = places
                .iter()
                .map(|place| {
                    let [x, y] = [1.1 * (place.x - x0), 1.1 * (place.y - y0)];
                    let way = Vector3::new(x0 + 0.2 * angle, y0 - 0.1 * angle, place.z + 0.3);
                    way + Vector3::new(cos * x - sin * y, sin * x + cos * y, 0.0)
                })
                .collect();
            let seen = torsion.update_angle(&now);
            assert!((seen - angle).abs() < 1e-12, "{seen} {angle}");
            assert_eq!(seen, torsion.angle());
        }
    }
    Ok(())
}

#[test]
fn a_run_that_blows_up_names_step_and_atom() -> Result<(), Error> {
    let scene = tiny("lambda = 1e6\nequilibration = 0.05")?;
    let mut run = TipSimulation::new(&scene)?;
    let error = loop {
        match run.step() {
            Ok(true) => {}
            Ok(false) => return Err("it did not blow up".into()),
            Err(error) => break error,
        }
    };
    match &error {
        TipError::System(SystemError::BlownUp { step, atom, .. }) => {
            // The drive is on from the tenth step on.
            assert_eq!(*step, 11);
            assert!(driven(run.system()).contains(atom));
            let said = error.to_string();
            assert!(
                said.contains("step 11: atom ") && said.contains("blew up"),
                "{said}"
            );
        }
        other => return Err(format!("{other:?}").into()),
    }
    Ok(())
}

#[test]
fn stages_without_steps_are_no_stages() -> Result<(), Error> {
    let stages = |times: [f64; 3]| {
        let [before, with, after] = times;
        tiny(&format!(
            "lambda = 0.01\nequilibration = {before:?}\ndrive_time = {with:?}\nrest_time = {after:?}\n\
             sample_every = 4"
        ))
    };
    for (times, lines) in [
        ([0.0, 0.0, 0.0], 1),
        ([0.02, 0.0, 0.0], 2),
        ([0.0, 0.03, 0.0], 3),
        ([0.0, 0.0, 0.025], 3),
    ] {
        let scene = stages(times)?;
        let mut run = TipSimulation::new(&scene)?;
        to_the_end(&mut run)?;
        assert_eq!(run.series().len(), lines, "{times:?}");
        // The end is the end.
        assert!(!run.step()?);
        assert_eq!(run.series().len(), lines, "{times:?}");
        let last = run.series().last().map_or(f64::NAN, |line| line[0]);
        assert!(
            (last - times[1] - times[2]).abs() < 1e-15,
            "{times:?} {last}"
        );
    }
    for key in ["equilibration", "drive_time", "rest_time"] {
        let said = tiny(&format!("lambda = 0\n{key} = 1e300")).map_err(|e| e.to_string());
        assert!(
            said.is_err_and(|said| said.contains(&format!("`{key}` is"))),
            "{key}"
        );
    }
    Ok(())
}

/// Atoms without thermostat, from rest: what the outcome says of the work against what they have.
#[test]
fn the_drives_work_is_what_the_atoms_gain() -> Result<(), Error> {
    let scene = tiny(&format!(
        "{COLD}\nshift = \"force\"\nlambda = 0.1\ntime_step = 0.002\ndrive_time = 4\nrest_time = 0\nsample_every = 10"
    ))?;
    let mut run = TipSimulation::new(&scene)?;
    let before = conserved_energy(run.system());
    to_the_end(&mut run)?;
    let gained = conserved_energy(run.system()) - before;
    let work = run.outcome().drive_energy.work;
    // An error of the second order in the time step.
    assert!((work / gained - 1.0).abs() < 1e-3, "{work} {gained}");
    Ok(())
}

#[test]
fn what_comes_out_does_not_depend_on_how_often_it_is_written() -> Result<(), Error> {
    let mut outcomes = Vec::new();
    for samples in ["1", "10", "200", "5000", "1e9"] {
        // A tip that turns about itself while it is driven.
        let scene = tiny(&format!(
            "lambda = 0.3\nequilibration = 0.5\ndrive_time = 25\nrest_time = 5\nsample_every = {samples}"
        ))?;
        let mut run = TipSimulation::new(&scene)?;
        to_the_end(&mut run)?;
        let angle = run.series().last().map_or(f64::NAN, |line| line[1]);
        let mut json = run.outcome().json(&scene);
        assert!(
            json["largest_angle_degrees"].as_f64() > Some(720.0),
            "{json}"
        );
        let lines = json["samples"].take();
        assert_eq!(lines, run.series().len());
        json["scene"]["sample_every"].take();
        outcomes.push((samples, angle, json.to_string()));
    }
    for (samples, angle, outcome) in &outcomes {
        assert_eq!(*angle, outcomes[0].1, "{samples}");
        assert_eq!(*outcome, outcomes[0].2, "{samples}");
    }
    Ok(())
}
