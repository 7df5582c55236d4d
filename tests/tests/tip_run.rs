//! A tip in motion: drive, holds, load, damping, checkpoints, the same bits.

use nalgebra::Vector3;
use tribos::md::interaction::Wanted;
use tribos::md::observe::Torsion;
use tribos::md::pair::LennardJones;
use tribos::md::system::{System, SystemError};
use tribos::record::CheckpointError;
use tribos::run::Simulation;
use tribos::scene::{Scene, TipScene, parse_scene};
use tribos::tip::{Part, TipError, TipRun, Verdict, build};

type Error = Box<dyn std::error::Error>;

/// 748 atoms: a hexagon of three a side.
const TINY: &str = "body = \"tip\"\ncolumns = 12\nrows = 14\nsubstrate_layers = 4\ntip_layers = 4\n\
                    side = 3\nspacing = 1.1";
/// Nothing moves but by forces.
const COLD: &str = "temperature = 0\nthermostat = \"none\"\ndamping = 0\nequilibration = 0\n\
                    integrator = \"velocity-verlet\"";

fn scene(text: &str) -> Result<TipScene, Error> {
    match parse_scene("tip.toml", text, &[])? {
        Scene::Tip(scene) => Ok(*scene),
        other => Err(format!("{other:?}").into()),
    }
}

fn tiny(text: &str) -> Result<TipScene, Error> {
    scene(&format!("{TINY}\n{text}"))
}

/// Its system, before the first step.
fn system(scene: &TipScene) -> Result<System<LennardJones>, Error> {
    Ok(System::new(build(scene)?.setup)?)
}

fn steps(system: &mut System<LennardJones>, count: usize) -> Result<(), Error> {
    for _ in 0..count {
        system.step(Wanted::Forces)?;
    }
    Ok(())
}

fn to_the_end(run: &mut TipRun) -> Result<(), Error> {
    while run.step()? {}
    Ok(())
}

/// Driven atoms.
fn driven(system: &System<LennardJones>) -> &[usize] {
    system.members(Part::ALL.len() - 1)
}

/// From the axis.
fn arm(scene: &TipScene, place: &Vector3<f64>) -> [f64; 2] {
    let [x, y] = scene.shape.axis();
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
            "lambda = 0.05\nadhesion = 1e-14\nshift = \"force\"\ntemperature = 0\ndamping = 0\n\
             thermostat = \"none\"\nintegrator = \"{integrator}\"\nequilibration = 0.1\n\
             drive_time = 1\nrest_time = 1"
        ))?;
        let mut system = system(&scene)?;
        let mut given = 0.0;
        for step in 1..=400 {
            // Kicks of half a step at both ends of each step of the drive.
            let is_driven = step > 20 && step <= 220;
            let kick = |system: &System<LennardJones>| {
                let strength = if is_driven { scene.lambda } else { 0.0 };
                0.5 * scene.time_step * strength * inertia(&scene, system)
            };
            given += kick(&system);
            system.step(Wanted::Forces)?;
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
fn momentum(scene: &TipScene, system: &System<LennardJones>) -> f64 {
    let velocities = system.velocities_on_step();
    let atoms = (3..Part::ALL.len()).flat_map(|group| system.members(group));
    let part = |&atom: &usize| {
        let [x, y] = arm(scene, &system.atoms().positions[atom]);
        x * velocities[atom].y - y * velocities[atom].x
    };
    atoms.map(part).sum()
}

/// Moment of inertia of the driven atoms.
fn inertia(scene: &TipScene, system: &System<LennardJones>) -> f64 {
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
            "lambda = 0.05\nhold = \"{hold}\"\nequilibration = 0\ndrive_time = 1\nrest_time = 0"
        ))?;
        let mut run = TipRun::new(&scene)?;
        let start = run.system().atoms().positions.clone();
        to_the_end(&mut run)?;
        let end = &run.system().atoms().positions;
        assert!(
            run.system()
                .members(0)
                .iter()
                .all(|&atom| start[atom] == end[atom])
        );
        let layers = scene.shape.layers();
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
            "lambda = 0\nhold = \"level\"\nload = {load:?}\ndamping = 2\nthermostat = \"langevin\"\n\
             friction = 2\ntemperature = 0\nshift = \"force\"\nequilibration = 0\n\
             drive_time = 0\nrest_time = 15\ntime_step = 0.01\nsamples = 1500"
        ))?;
        let mut run = TipRun::new(&scene)?;
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
             damping = {damping:?}"
        ))
    };
    let scene = with(rate)?;
    let (mut damped, mut plain) = (system(&scene)?, system(&with(0.0)?)?);
    let before = damped.atoms().clone();
    let forces = damped.forces().to_vec();
    steps(&mut damped, 1)?;
    steps(&mut plain, 1)?;
    let time = scene.time_step;
    for atom in 0..before.len() {
        let after = &damped.atoms().positions[atom];
        if driven(&damped).contains(&atom) {
            let kept = before.velocities[atom] * (-rate * 0.5 * time).exp();
            let mut push = forces[atom];
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
    let sites = scene.shape.sites();
    let places: Vec<Vector3<f64>> = sites.iter().map(|site| site.place).collect();
    let tip: Vec<usize> = (0..sites.len())
        .filter(|&i| sites[i].part == Part::Driven)
        .collect();
    let [x0, y0] = scene.shape.axis();
    for direction in [1.0, -1.0] {
        let mut torsion = Torsion::new(tip.clone(), &places);
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
            let seen = torsion.look(&now);
            assert!((seen - angle).abs() < 1e-12, "{seen} {angle}");
            assert_eq!(seen, torsion.angle());
        }
    }
    Ok(())
}

/// Every thermostat with both integrators; a thin skin, so that lists are built on the way.
fn kinds() -> Result<Vec<TipScene>, Error> {
    let mut scenes = Vec::new();
    for bath in [
        "thermostat = \"nose-hoover\"",
        "thermostat = \"nose-hoover\"\nspin = \"counts\"\nadhesion = 0.5",
        "thermostat = \"langevin\"\nhold = \"level\"\nload = 0.5",
        "thermostat = \"none\"\noutline = \"disk\"\norientation = 20",
    ] {
        for integrator in ["leap-frog", "velocity-verlet"] {
            scenes.push(tiny(&format!(
                "{bath}\nintegrator = \"{integrator}\"\nlambda = 0.5\nskin = 0.05\nsamples = 7\n\
                 equilibration = 0.1\ndrive_time = 0.1\nrest_time = 0.1"
            ))?);
        }
    }
    Ok(scenes)
}

#[test]
fn a_run_goes_on_from_any_line_of_its_series_to_the_same_bits() -> Result<(), Error> {
    for scene in kinds()? {
        let mut whole = TipRun::new(&scene)?;
        let mut kept = vec![whole.checkpoint()];
        loop {
            let goes_on = whole.step()?;
            kept.push(whole.checkpoint());
            if !goes_on {
                break;
            }
        }
        // 60 steps in stretches of 7.
        assert_eq!(kept.len(), 10);
        assert!(whole.system().list_builds() > 2);
        for text in &kept {
            let mut resumed = TipRun::resume(&scene, text)?;
            assert_eq!(*text, resumed.checkpoint());
            to_the_end(&mut resumed)?;
            assert!(resumed.checkpoint() == whole.checkpoint());
            assert_eq!(resumed.system().state(), whole.system().state());
            assert_eq!(resumed.series(), whole.series());
            assert_eq!(
                resumed.outcome().json(&scene).to_string(),
                whole.outcome().json(&scene).to_string()
            );
        }
        assert_eq!(whole.progress(), 1.0);
        assert_ne!(whole.outcome().verdict, Verdict::Open);
    }
    Ok(())
}

#[test]
fn a_damaged_checkpoint_is_refused_with_what_is_wrong() -> Result<(), Error> {
    let scene = kinds()?.swap_remove(0);
    let mut run = TipRun::new(&scene)?;
    run.step()?;
    let text = run.checkpoint();
    let nan = "7ff8000000000000";
    let hex = |name: &str| -> Result<[&str; 3], Error> {
        let (before, rest) = text
            .split_once(&format!("\"{name}\":\""))
            .ok_or("no such part")?;
        let (digits, after) = rest.split_once('"').ok_or("no end")?;
        Ok([before, digits, after])
    };
    for name in [
        "positions",
        "velocities",
        "list",
        "thermostats",
        "angles",
        "series",
    ] {
        let [before, digits, after] = hex(name)?;
        let with = |digits: &str| format!("{before}\"{name}\":\"{digits}\"{after}");
        assert_eq!(with(digits), text);
        let mut damages = vec![
            with(""),
            with(&digits[16..]),
            with(&format!("{digits}{nan}")),
            with(&digits[1..]),
            with(&format!("x{}", &digits[1..])),
            text.replacen(&format!("\"{name}\":"), "\"other\":", 1),
        ];
        if name != "series" {
            damages.push(with(&format!("{nan}{}", &digits[16..])));
        }
        for damaged in damages {
            match TipRun::resume(&scene, &damaged) {
                Err(TipError::Checkpoint(CheckpointError::Format(said))) => {
                    assert!(said.contains(&format!("`{name}`")), "{name}: {said}");
                }
                other => return Err(format!("{name}: {:?}", other.is_ok()).into()),
            }
        }
    }
    for (from, to, words) in [
        ("\"steps\":7", "\"steps\":-7", "`steps`"),
        ("\"steps\":7", "\"steps\":18446744073709551615", "`steps`"),
        ("\"steps\":7", "\"steps\":61", "`steps`"),
        ("\"steps\":7", "\"steps\":15", "`series`"),
        ("\"tribos_tip\":1", "\"tribos_tip\":2", "version"),
        ("{", "[", "damaged"),
    ] {
        assert!(text.contains(from), "{from}");
        match TipRun::resume(&scene, &text.replacen(from, to, 1)) {
            Err(error) => assert!(error.to_string().contains(words), "{to}: {error}"),
            Ok(_) => return Err(to.into()),
        }
    }
    Ok(())
}

#[test]
fn a_checkpoint_of_another_scene_is_refused_with_the_key() -> Result<(), Error> {
    let text = TipRun::new(&tiny("lambda = 0.02")?)?.checkpoint();
    for (other, key) in [
        ("lambda = 0.03", "lambda"),
        ("lambda = 0.02\nseed = 2", "seed"),
        ("lambda = 0.02\nhold = \"level\"", "hold"),
        ("lambda = 0.02\noutline = \"cone\"", "outline"),
    ] {
        match TipRun::resume(&tiny(other)?, &text) {
            Err(TipError::Checkpoint(CheckpointError::Scene { key: found, .. })) => {
                assert_eq!(found, key);
            }
            other => return Err(format!("{key}: {:?}", other.is_ok()).into()),
        }
    }
    Ok(())
}

#[test]
fn a_run_that_blows_up_names_step_and_atom() -> Result<(), Error> {
    let scene = tiny("lambda = 1e6\nequilibration = 0.05")?;
    let mut run = TipRun::new(&scene)?;
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
             samples = 4"
        ))
    };
    for (times, lines) in [
        ([0.0, 0.0, 0.0], 1),
        ([0.02, 0.0, 0.0], 2),
        ([0.0, 0.03, 0.0], 3),
        ([0.0, 0.0, 0.025], 3),
    ] {
        let scene = stages(times)?;
        let mut run = TipRun::new(&scene)?;
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

#[test]
fn results_do_not_depend_on_the_number_of_threads() -> Result<(), Error> {
    // Several chunks of the list.
    let text = "body = \"tip\"\ncolumns = 40\nrows = 40\nsubstrate_layers = 4\ntip_layers = 4\n\
                side = 8\nlambda = 0.5\nskin = 0.1\nequilibration = 0.05\ndrive_time = 0.15\n\
                rest_time = 0.05\nsamples = 10";
    let mut ends = Vec::new();
    for bath in ["nose-hoover", "langevin"] {
        let scene = scene(&format!("{text}\nthermostat = \"{bath}\""))?;
        for threads in [1, 2, 3] {
            let pool = rayon::ThreadPoolBuilder::new()
                .num_threads(threads)
                .build()?;
            let end = pool.install(|| -> Result<String, TipError> {
                let mut run = TipRun::new(&scene)?;
                while run.step()? {}
                Ok(run.checkpoint())
            })?;
            ends.push(end);
        }
    }
    assert!(ends.chunks(3).all(|of| of[0] == of[1] && of[1] == of[2]));
    assert!(ends[0] != ends[3]);
    Ok(())
}
