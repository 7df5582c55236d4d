use nalgebra::{Matrix3, Vector3};
use std::cell::Cell;
use tribos_base::record::RecordError;
use tribos_base::record::with_digest;
use tribos_base::record::{ContactRow, Partner};
use tribos_base::results::Summary;
use tribos_base::run::{FRAMES, RunError, Session, Simulation, StartMode, run_to_end};
use tribos_grains::packing::PackingRunError;
use tribos_grains::powder::*;
use tribos_grains::scene::{BlockedCriterion, PowderScene};

type Tested = Result<(), Box<dyn std::error::Error>>;

/// Least number of steps in a window.
const WINDOW_STEPS: u64 = 200;
// Some twenty spheres, a fraction of a second.
const TINY: &str =
    "body = \"powder\"\nwidth = 8\nheight = 12\npressure = 0.01\npiston_mass = 100\n";

fn scene(overrides: &[&str]) -> Result<PowderScene, Box<dyn std::error::Error>> {
    let items: Vec<String> = overrides.iter().map(|item| (*item).into()).collect();
    Ok(PowderScene::parse("tiny.toml", TINY, &items)?)
}

fn finished(overrides: &[&str]) -> Result<PowderSimulation, Box<dyn std::error::Error>> {
    let mut compaction = PowderSimulation::new(&scene(overrides)?)?;
    run_to_end(&mut compaction, |_, _| ())?;
    Ok(compaction)
}

fn touching(a: u32, b: Partner, normal: Vector3<f64>, force: Vector3<f64>) -> ContactRow {
    ContactRow {
        a,
        b,
        normal,
        gap: 0.0,
        force,
        torque: Vector3::zeros(),
    }
}

#[test]
fn a_column_under_load_has_the_stress_of_its_load() {
    // Two spheres of radius 1 between plates 4 apart, 10 by 10, pressed with 3, pulled apart by 1.
    let up = Vector3::z();
    let column = |load: f64| {
        [
            touching(0, Partner::Wall(0), -up, -up * load),
            touching(0, Partner::Particle(1), up, up * load),
            touching(1, Partner::Wall(1), up, up * load),
        ]
    };
    let branch = |row: &ContactRow| row.normal * (1.0 + f64::from(row.b.particle().is_some()));
    let volume = 10.0 * 10.0 * 4.0;
    let pressed = Stress::of(&column(3.0), branch, volume);
    let expected = Matrix3::from_diagonal(&Vector3::new(0.0, 0.0, 3.0 / 100.0));
    assert!((pressed.total() - expected).norm() < 1e-16);
    assert_eq!(pressed.minus, Matrix3::zeros());
    let pulled = Stress::of(&column(-1.0), branch, volume);
    assert!((pulled.minus.m33 + 0.01).abs() < 1e-16);
    assert_eq!(pulled.plus, Matrix3::zeros());
    // A shear force counts by the sign of the normal one, and is not symmetric alone.
    let sheared = touching(0, Partner::Particle(1), up, Vector3::new(0.5, 0.0, -1.0));
    let sheared = Stress::of(&[sheared], branch, 1.0);
    assert_eq!((sheared.minus.m13, sheared.minus.m31), (1.0, 0.0));
}

#[test]
fn every_condition_of_balance_is_needed() {
    let stress = |zz: f64| Stress {
        plus: Matrix3::from_diagonal(&Vector3::new(0.0, 0.0, zz)),
        minus: Matrix3::zeros(),
    };
    let good = Means {
        moved: 9e-4,
        piston: 0.504,
        net: 9e-4,
        contact: 0.1,
        stress: stress(0.00504),
    };
    let blocked = |means: &Means, criterion| means.is_blocked(criterion, 0.005, 100.0);
    assert!(blocked(&good, BlockedCriterion::Balance) && blocked(&good, BlockedCriterion::Piston));
    let moving = Means {
        moved: 1.1e-3,
        ..good
    };
    assert!(
        !blocked(&moving, BlockedCriterion::Balance) && !blocked(&moving, BlockedCriterion::Piston)
    );
    for bad in [
        Means {
            piston: 0.494,
            ..good
        },
        Means {
            piston: 0.506,
            ..good
        },
        Means {
            net: 1.1e-3,
            ..good
        },
        Means {
            stress: stress(0.00506),
            ..good
        },
        Means {
            stress: stress(f64::NAN),
            ..good
        },
    ] {
        assert!(!blocked(&bad, BlockedCriterion::Balance), "{bad:?}");
        assert!(blocked(&bad, BlockedCriterion::Piston), "{bad:?}");
    }
}

#[test]
fn windows_average_over_time_and_wait_for_slow_pistons() {
    let mut window = Window::starting(5.0);
    window.add(1.0, &Stress::default(), [1.0, 0.0, 2.0]);
    window.add(3.0, &Stress::default(), [5.0, 4.0, 2.0]);
    let means = window.means(4.5);
    assert_eq!((means.moved, means.piston), (0.5, 4.0));
    assert_eq!((means.net, means.contact), (3.0, 2.0));
    for _ in 0..WINDOW_STEPS - 2 {
        assert!(!window.is_full(1.0, 1.0));
        window.add(0.01, &Stress::default(), [0.0; 3]);
    }
    // √(2 · 100 · 10⁻³ · mass/load) = 0.45 √(mass/load), and the window is 6 long.
    assert!(window.is_full(1.0, 1.0) && window.is_full(170.0, 1.0));
    assert!(!window.is_full(190.0, 1.0));
}

/// Those of sliding, rolling and torsion.
fn shares([sliding, rolling, torsion]: [Option<f64>; 3]) -> ThresholdShares {
    ThresholdShares {
        sliding,
        rolling,
        torsion,
    }
}

#[test]
fn contacts_are_counted_by_sign_and_threshold() -> Tested {
    let x = Vector3::x();
    // P is 2 under a push of 1 and 0.75 under a pull of 0.25; μ P is 0.6 and 0.225.
    let slides = touching(0, Partner::Particle(1), x, Vector3::new(1.0, 0.6, 0.0));
    let sticks = touching(1, Partner::Particle(2), x, Vector3::new(-0.25, 0.0, 0.1));
    let mut rolls = touching(0, Partner::Wall(0), x, Vector3::new(4.0, 0.0, 0.0));
    rolls.gap = -0.125;
    let mut spins = sticks;
    // r_eff is ½: μ_n P r_eff = 0.5 · 0.75 · 0.5.
    spins.torque = Vector3::new(-0.1875, 0.05, 0.0);
    (spins.a, spins.b) = (0, Partner::Particle(2));
    let rows = [slides, sticks, rolls, spins];
    let limits = |overrides: &[&str]| scene(overrides).map(|scene| Limits::of(&scene.material()));
    let rough = limits(&["mu=0.3", "mu_rolling=0.2", "mu_torsion=0.5"])?;
    let found = ContactStatistics::of(&rows, &[1.0; 4], &rough);
    assert_eq!(found.wall_contacts, 1);
    assert_eq!(found.coordination, [1, 0, 2, 1]);
    assert_eq!(found.mean_coordination, 7.0 / 4.0);
    let forces = |contacts, mean, largest| NormalForces {
        contacts,
        mean,
        largest,
    };
    assert_eq!(found.compression, forces(1, 1.0, 1.0));
    assert_eq!(found.tension, forces(2, 0.25, 0.25));
    let third = Some(1.0 / 3.0);
    assert_eq!(found.at_threshold, shares([third, Some(0.0), third]));
    let smooth = ContactStatistics::of(&rows, &[1.0; 4], &limits(&["mu=0"])?);
    assert_eq!(smooth.at_threshold, shares([None; 3]));
    Ok(())
}

#[test]
fn sliding_and_torsion_reach_a_joint_threshold_together() -> Tested {
    // P is 2 and r_eff ½. 0.6 and 0.8 of the two thresholds lie on the ellipsoid, 0.51 and 0.8 on the
    // exact surface (by quadrature), 0.5 and 0.8 within both.
    let contact = |share: f64| {
        let force = Vector3::new(1.0, share * 0.3 * 2.0, 0.0);
        let mut row = touching(0, Partner::Particle(1), Vector3::x(), force);
        row.torque = Vector3::new(0.8 * 0.5 * 2.0 * 0.5, 0.0, 0.0);
        row
    };
    for (coupling, slips) in [
        ("independent", [false; 2]),
        ("ellipsoid", [true, false]),
        ("exact", [true, false]),
    ] {
        let scene = scene(&["mu_torsion=0.5", &format!("coupling={coupling}")])?;
        let limits = Limits::of(&scene.material());
        for (share, slips) in [0.6, 0.5].into_iter().zip(slips) {
            let row = contact(share);
            let reached = limits.reached(&row, &[1.0; 2]);
            assert_eq!(reached, Some([slips, false, slips]), "{coupling} {share}");
            let found = ContactStatistics::of(&[row], &[1.0; 2], &limits).at_threshold;
            let share = Some(f64::from(u8::from(slips)));
            assert_eq!(found, shares([share, None, share]), "{coupling}");
        }
    }
    Ok(())
}

#[test]
fn smooth_walls_have_no_thresholds() -> Tested {
    let row = touching(
        0,
        Partner::Wall(0),
        Vector3::z(),
        Vector3::new(0.3, 0.0, 1.0),
    );
    for (wall, reached) in [("smooth", None), ("full", Some([false; 3]))] {
        let scene = scene(&[&format!("wall_contact={wall}")])?;
        assert_eq!(
            Limits::of(&scene.material()).reached(&row, &[1.0]),
            reached,
            "{wall}"
        );
    }
    Ok(())
}

#[test]
fn a_blocked_packing_carries_the_load_whatever_its_modes() -> Tested {
    let mut last = 1.0;
    for (modes, names) in [
        (
            ["mu_rolling=1", "mu_torsion=1", "mu=0.3"],
            "rolling torsion sliding",
        ),
        (
            ["mu_rolling=1", "mu_torsion=0", "mu=0.3"],
            "rolling sliding",
        ),
        (
            ["mu_rolling=0", "mu_torsion=1", "mu=0.3"],
            "torsion sliding",
        ),
        (["mu_rolling=0", "mu_torsion=0", "mu=0.3"], "sliding"),
        (["mu_rolling=0", "mu_torsion=0", "mu=0"], ""),
    ] {
        let compaction = finished(&modes)?;
        let outcome = compaction.outcome();
        assert_eq!(outcome.ending, Some(PowderStopReason::Blocked), "{modes:?}");
        let total = outcome.stress_zz;
        let (plus, minus) = (outcome.stress_zz_plus, outcome.stress_zz_minus);
        assert!((total - 1.0).abs() < 0.01, "{modes:?} {total}");
        assert!(
            (plus + minus - total).abs() < 1e-12 && minus < 0.0,
            "{modes:?} {minus}"
        );
        let residual = outcome.residual_final;
        assert!(residual < 1e-3, "{residual}");
        let at_walls = outcome.statistics.wall_contacts;
        assert_eq!(outcome.contacts + at_walls, compaction.contacts().len());
        assert!(outcome.energy.imbalance.abs() < 1e-9 * outcome.energy.work);
        // Less resistance, less room; modes without a coefficient take no energy.
        let porosity = outcome.porosity_final;
        assert!(porosity < last, "{modes:?} {porosity}");
        last = porosity;
        for (name, energy) in outcome.dissipation.entries() {
            let resists = ["normal", "cohesion", names]
                .iter()
                .any(|known| known.contains(&name));
            assert_eq!(energy != 0.0, resists, "{modes:?} {name} {energy}");
        }
    }
    Ok(())
}

#[test]
fn a_powder_under_gravity_bears_its_weight_and_the_lid() -> Tested {
    for gravity in ["0.01", "0.2"] {
        let compaction = finished(&["mu_rolling=0.3", &format!("gravity={gravity}")])?;
        let outcome = compaction.outcome();
        assert_eq!(outcome.ending, Some(PowderStopReason::Blocked), "{gravity}");
        let mass: f64 = compaction
            .deposit()
            .radii
            .iter()
            .map(|r| 4.0 / 3.0 * std::f64::consts::PI * r * r * r)
            .sum();
        let weight = gravity.parse::<f64>()? * mass;
        let at = |wall| {
            let rows = compaction.contacts().iter();
            let rows = rows.filter(move |row| row.b == Partner::Wall(wall));
            rows.map(|row| row.force.z).sum::<f64>()
        };
        let (floor, lid) = (-at(0), at(PISTON));
        let load = compaction.scene().load();
        assert!((lid / load - 1.0).abs() < 0.05, "{gravity}: lid {lid}");
        let expected = load + weight;
        assert!((floor / expected - 1.0).abs() < 0.05, "{gravity}: {floor}");
    }
    Ok(())
}

#[test]
fn a_resumed_run_ends_with_the_same_bits() -> Tested {
    for modes in [
        &["mu_rolling=0.1", "mu_torsion=0.1"][..],
        &["mu_rolling=0", "mu_torsion=0"],
        &["mu_rolling=0.1", "mu_torsion=0.1", "method=soft"],
        &["method=soft", "normal_law=hertz", "restitution=0.5"],
    ] {
        let scene = scene(modes)?;
        let whole = finished(modes)?;
        let mut first = PowderSimulation::new(&scene)?;
        // In the middle of a window, between two lines of the series.
        while first.steps() < whole.steps() / 2 + 7 {
            assert!(first.step()?);
        }
        let kept = first.checkpoint();
        drop(first);
        let mut second = PowderSimulation::resume(&scene, &kept)?;
        run_to_end(&mut second, |_, _| ())?;
        let ends = [&whole, &second].map(PowderSimulation::checkpoint);
        let [a, b] = ends.each_ref().map(|text| without_clock(text));
        assert!(a? == b?);
        let [mut a, mut b] = [whole.outcome(), second.outcome()];
        (a.wall_seconds, b.wall_seconds) = (0.0, 0.0);
        assert_eq!(a, b);
        assert_eq!(whole.series(), second.series());
        assert_eq!(whole.contacts(), second.contacts());
    }
    Ok(())
}

#[test]
fn soft_spheres_end_blocked_near_the_height_of_rigid_ones() -> Tested {
    for modes in [
        ["mu_rolling=0", "mu_torsion=0"],
        ["mu_rolling=1", "mu_torsion=1"],
    ] {
        let rigid = finished(&modes)?.outcome();
        for law in ["linear", "hertz"] {
            let law = format!("normal_law={law}");
            let keys = [&modes[..], &["method=soft", &law, "stiffness=2e3"]].concat();
            let soft = finished(&keys)?.outcome();
            assert_eq!(soft.ending, Some(PowderStopReason::Blocked), "{keys:?}");
            let total = soft.stress_zz;
            assert!((total - 1.0).abs() < 0.01, "{keys:?} {total}");
            // Twenty spheres: one more or less that is caught is a point.
            let apart = soft.porosity_final - rigid.porosity_final;
            assert!(apart.abs() < 0.05, "{keys:?} {apart}");
            assert!(soft.max_overlap > rigid.max_overlap);
            assert!(soft.energy.elastic > Some(0.0) && soft.iterations_total == 0);
        }
    }
    Ok(())
}

#[test]
fn spheres_all_of_the_second_material_are_those_of_it_alone() -> Tested {
    let first = finished(&["mu=0.1"])?;
    let second = finished(&["second_fraction=1", "mu_second=0.1"])?;
    assert_eq!(second.series(), first.series());
    let heavy = finished(&["second_fraction=1", "mu_second=0.1", "second_density=2"])?;
    assert_ne!(heavy.series(), first.series());
    // None of it, whatever it would be; and half of it, which is neither.
    let none = finished(&["mu_second=0.1", "second_density=2"])?;
    assert_eq!(none.series(), finished(&[])?.series());
    let half = finished(&["second_fraction=0.5", "mu_second=0"])?;
    assert_ne!(half.series(), none.series());
    assert_eq!(half.ending(), Some(PowderStopReason::Blocked));
    Ok(())
}

#[test]
fn keys_of_the_other_method_are_refused() {
    for (keys, told) in [
        (&["method=soft", "solver=gauss-seidel"][..], "solver"),
        (&["method=soft", "tolerance=1e-3"], "tolerance"),
        (&["method=soft", "max_iterations=10"], "max_iterations"),
        (&["method=soft", "attraction=resistance"], "attraction"),
        (
            &["method=soft", "restitution=0.5", "damping_ratio=1"],
            "damping_ratio",
        ),
        (&["stiffness=1e4"], "method = \"soft\""),
        (&["method=soft", "stiffness=0"], "stiffness"),
        (&["method=sfot"], "soft"),
    ] {
        let refused = scene(keys).expect_err("the scene is refused").to_string();
        assert!(refused.contains(told), "{keys:?}: {refused}");
    }
}

#[test]
fn a_checkpoint_of_the_end_is_the_end() -> Tested {
    let modes = ["mu_rolling=0.1", "mu_torsion=0.1"];
    let whole = finished(&modes)?;
    assert_eq!(COLUMNS.iter().position(|name| *name == "residual"), Some(7));
    let mut again = PowderSimulation::resume(&scene(&modes)?, &whole.checkpoint())?;
    assert!(!again.step()?);
    let [mut a, mut b] = [whole.outcome(), again.outcome()];
    (a.wall_seconds, b.wall_seconds) = (0.0, 0.0);
    assert_eq!(a, b);
    assert_eq!(whole.series(), again.series());
    assert_eq!(whole.contacts(), again.contacts());
    Ok(())
}

#[test]
fn forces_of_contacts_with_rebound_explain_every_velocity() -> Tested {
    let scene = scene(&["restitution=0.9", "height=16", "width=8"])?;
    let mut compaction = PowderSimulation::new(&scene)?;
    let velocities = |compaction: &PowderSimulation| {
        compaction.with_snapshot(|snapshot| snapshot.velocities.unwrap_or_default().to_vec())
    };
    let mut impacts = 0;
    while impacts < 100 {
        let before = velocities(&compaction);
        assert!(compaction.step()?);
        impacts += compaction.last_step().impacts;
        let radii = compaction.with_snapshot(|snapshot| snapshot.radii.to_vec());
        let mut forces = vec![(Vector3::zeros(), 0.0); radii.len()];
        for row in compaction.contacts() {
            let ends = [(Some(row.a), -row.force), (row.b.particle(), row.force)];
            for (body, force) in ends.into_iter().filter_map(|(b, f)| Some((b?, f))) {
                let (sum, size) = &mut forces[body as usize];
                *sum += force;
                *size += force.norm();
            }
        }
        let dt = compaction.last_step().dt;
        let changes = velocities(&compaction).into_iter().zip(before);
        for (((sum, size), radius), (new, old)) in forces.iter().zip(&radii).zip(changes) {
            let over_mass = dt * tribos_contacts::cd::solid(*radius, 1.0).inv_mass;
            // Rows have the normals of the step's end. A body laid to rest loses what it has left.
            let turned = 0.1 * size * over_mass + 1e-12;
            let rests = new.norm() == 0.0;
            assert!(rests || (new - old - sum * over_mass).norm() < turned);
        }
    }
    // Forces of impacts are kept with the state.
    let again = PowderSimulation::resume(&scene, &compaction.checkpoint())?;
    assert_eq!(again.contacts(), compaction.contacts());
    Ok(())
}

#[test]
fn a_checkpoint_read_and_written_is_the_same() -> Tested {
    let scene = scene(&["mu_rolling=0.1", "mu_torsion=0.1", "height=40"])?;
    let mut compaction = PowderSimulation::new(&scene)?;
    for _ in 0..WINDOW_STEPS + 10 {
        assert!(compaction.step()?);
    }
    let kept = compaction.checkpoint();
    let again = PowderSimulation::resume(&scene, &kept)?.checkpoint();
    assert!(without_clock(&kept)? == without_clock(&again)?);
    // Some sleep, some do not; a window is complete.
    let value = without_clock(&kept)?;
    let awake = value["awake"].as_str().unwrap_or_default();
    assert!(awake.contains('0') && awake.contains('1'), "{awake}");
    assert!(value["complete_window"] != "" && value["pair_forces"] != "");
    Ok(())
}

fn without_clock(checkpoint: &str) -> Result<serde_json::Value, serde_json::Error> {
    let mut value: serde_json::Value = serde_json::from_str(checkpoint)?;
    value["wall_seconds"] = 0.into();
    value["digest"] = 0.into();
    Ok(value)
}

#[test]
fn checkpoints_of_other_scenes_and_damaged_ones_are_refused() -> Tested {
    let here = scene(&[])?;
    let mut compaction = PowderSimulation::new(&here)?;
    assert!(compaction.step()?);
    let kept = compaction.checkpoint();
    let refusal = |scene: &PowderScene, text: &str| {
        let told = PowderSimulation::resume(scene, text).map(|_| ());
        told.map_or_else(|error| error.to_string(), |()| "accepted".into())
    };
    let other = refusal(&scene(&["mu_rolling=0.5"])?, &kept);
    assert!(other.contains("`mu_rolling` is 0.0") && other.contains("0.5 here"));
    assert!(refusal(&here, "{").contains("--anew"));
    assert!(refusal(&here, "{}").contains("its digest"));
    let old = "{\"tribos_compaction\":1,\"steps\":3}\n";
    assert!(refusal(&here, old).contains("has format 1"));
    // Sealed again after it was changed: every length is still looked at.
    let Ok(serde_json::Value::Object(whole)) = serde_json::from_str(&kept) else {
        unreachable!("an object")
    };
    let with = |name: &str, value: serde_json::Value| {
        let mut map = whole.clone();
        map.remove("digest");
        map.insert(name.into(), value);
        refusal(&here, &with_digest(map))
    };
    for name in [
        "positions",
        "motions",
        "walls",
        "book",
        "window",
        "series",
        "time",
        "last_step",
        "last_stress",
    ] {
        let numbers = whole[name].as_str().unwrap_or_default();
        for damage in [
            "",
            &numbers[1..],
            &numbers[16..],
            &format!("x{}", &numbers[1..]),
        ] {
            let told = with(name, damage.into());
            let refused = told.contains("cannot be read") || told.contains("numbers of spheres");
            assert!(refused, "{name}: {told}");
        }
        assert_eq!(with(name, numbers.into()), "accepted");
    }
    assert!(with("awake", "2".into()).contains("cannot be read"));
    assert!(with("still", serde_json::json!([300])).contains("cannot be read"));
    assert!(with("last_step_counts", serde_json::json!([1, 2])).contains("cannot be read"));
    // A powder does not end at rest, as grains do.
    assert!(!with("ending", "blocked".into()).contains("`ending`"));
    assert!(with("ending", "rest".into()).contains("`ending` cannot be read"));
    // What the run began with has changed.
    assert!(with("began_with", "0".into()).contains("`initial_state` is of other spheres"));
    assert!(with("tribos_compaction", 5.into()).contains("has format 5"));
    Ok(())
}

#[test]
fn a_run_ends_with_its_time_or_its_steps() -> Tested {
    let short = finished(&["max_steps=30", "samples=7"])?;
    assert_eq!(
        (short.ending(), short.steps()),
        (Some(PowderStopReason::Steps), 30)
    );
    // The start, every seventh step, the end.
    let steps: Vec<f64> = short.series().iter().map(|row| row[1]).collect();
    assert_eq!(steps, [0.0, 7.0, 14.0, 21.0, 28.0, 30.0]);
    let timed = finished(&["duration=5"])?;
    let time = timed.outcome().time;
    assert_eq!(timed.ending(), Some(PowderStopReason::Time));
    assert!((5.0..5.2).contains(&time), "{time}");
    Ok(())
}

/// A run that is broken off after three steps, and goes on once its folder of frames is removed.
fn resumed_without_frames(limit: u64) -> Result<u64, RunError<PackingRunError>> {
    let scene = PowderScene {
        width: 6.0,
        height: 8.0,
        max_steps: 6,
        ..PowderScene::default()
    };
    let home = tempfile::tempdir().unwrap();
    let session = || Session::<PowderSimulation>::in_folder(home.path()).unwrap();
    let steps = Cell::new(0);
    let broken = session()
        .frames(limit)
        .on_progress(|run: &PowderSimulation| steps.set(run.steps()))
        .cancel_when(|| steps.get() == 3);
    assert!(matches!(broken.run(&scene), Err(RunError::Cancelled(3))));
    let frames = home.path().join(FRAMES);
    assert_eq!(frames.exists(), limit > 0);
    if limit > 0 {
        std::fs::remove_dir_all(frames).unwrap();
    }
    Ok(session().start(StartMode::Resume).run(&scene)?.steps())
}

#[test]
fn frames_that_are_all_gone_are_missed_where_a_run_kept_some() {
    let refused = resumed_without_frames(20);
    assert!(
        matches!(&refused, Err(RunError::Frames(RecordError::Missing(path))) if path.ends_with(FRAMES)),
        "{refused:?}"
    );
    assert_eq!(resumed_without_frames(0).unwrap(), 6);
}
