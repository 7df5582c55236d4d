//! Runs that are broken off by a signal, or start where another one works.

#![cfg(unix)]

use crate::program::{Error, Outcome, assert_has, files, prepared, succeed, tribos, wait_for};
use std::collections::BTreeMap;
use std::ops::ControlFlow;
use std::path::Path;
use std::process::{Child, Command, Output, Stdio};
use std::time::{Duration, Instant};
use tribos::gas::GasSimulation;
use tribos::grains::GrainsSimulation;
use tribos::powder::PowderSimulation;
use tribos::run::LongRun;
use tribos::run::folder::Manifest;
use tribos::scene::Scene;
use tribos::tip::TipSimulation;

/// Some twenty spheres, and 748 atoms: a second or two each.
const POWDER: &str = "body = \"powder\"\nwidth = 8\nheight = 12\npressure = 0.01\n\
                      piston_mass = 100\nmu_rolling = 0.1\nmu_torsion = 0.1\nmax_steps = 900\n";
const TIP: &str = "body = \"tip\"\nsubstrate_columns = 12\nsubstrate_rows = 14\ntip_side_atoms = 3\n\
                   substrate_layers = 4\ntip_layers = 4\nequilibration = 0.5\ndrive_time = 1\n\
                   rest_time = 0.5\nsample_every = 5\n";
/// Grains of two materials.
const GRAINS: &str = "body = \"grains\"\ncount = 60\nradius = 0.005\ndensity = 2500\nsecond_fraction = 0.4\n\
                      second_density = 7800\nmu_second = 0.2\nduration = 1\nsample_every = 7\n";
const SOFT: &str = "body = \"grains\"\ncount = 60\nradius = 0.005\ndensity = 2500\nduration = 1\n\
                    method = \"soft\"\nstiffness = 1e4\nsample_every = 7\n";
const GAS: &str = "body = \"gas\"\n";
/// Scenes that are broken off, each of two parts: every body, container and method that keeps checkpoints.
const BROKEN: [(&str, [&str; 2]); 14] = [
    ("powder", [POWDER, ""]),
    (
        "springs",
        [
            POWDER,
            "method = \"soft\"\nstiffness = 1e3\ndamping_ratio = 1\n",
        ],
    ),
    ("tip", [TIP, "lambda = 0.02\n"]),
    (
        "slid",
        [
            TIP,
            "drive = \"slide\"\nspeed = 0.5\nstroke = 0.3\nstiffness = 40\ndriven_constraint = \"level\"\nload = 0.5\n",
        ],
    ),
    (
        "column",
        [
            GRAINS,
            "width = 0.06\nboundary_x = \"walls\"\nmax_steps = 500\n",
        ],
    ),
    (
        "sheared",
        [
            GRAINS,
            "width = 0.06\nboundary_z = \"periodic\"\nheight = 0.09\ngravity = 0\nshear_rate = 5\nmax_steps = 500\n",
        ],
    ),
    (
        "plates",
        [
            GRAINS,
            "width = 0.06\nboundary_z = \"walls\"\ngravity = 0\nwall_stress_z = 1000\nlid_speed_x = 0.1\nmax_steps = 300\n",
        ],
    ),
    (
        "flat",
        [GRAINS, "width = 0.2\ndimension = 2\nmax_steps = 500\n"],
    ),
    (
        "drum",
        [
            GRAINS,
            "width = 0.2\ncontainer = \"drum\"\ndimension = 2\nmax_steps = 300\n",
        ],
    ),
    (
        "hopper",
        [
            GRAINS,
            "width = 0.12\ndepth = 0.03\nboundary_x = \"walls\"\ncontainer = \"hopper\"\norifice_width = 0.03\n\
             orifice_height = 0.05\nopen_time = 0.1\nmax_steps = 300\n",
        ],
    ),
    ("soft", [SOFT, "width = 0.06\nmax_steps = 100\n"]),
    ("gas", [GAS, "count = 800\ncollisions = 60\n"]),
    (
        "stepped",
        [
            GAS,
            "count = 100\ncollisions = 4\nmethod = \"contact-dynamics\"\n",
        ],
    ),
    (
        "bouncing",
        [
            GAS,
            "count = 100\ncollisions = 2\nmethod = \"soft\"\nstiffness = 1e5\n",
        ],
    ),
];
/// Breaks of each kind and scene; more by this variable of the environment.
const BREAKS: (&str, u64) = ("TRIBOS_BREAKS", 3);
/// Numbers of threads of the stretches.
const THREADS: [&str; 3] = ["1", "2", "7"];
/// A run that does not end meanwhile.
const LONG: &str = "body = \"powder\"\nwidth = 20\nheight = 61.5\n";

fn home() -> Result<tempfile::TempDir, Error> {
    let home = tempfile::tempdir()?;
    for (scene, parts) in BROKEN {
        std::fs::write(home.path().join(format!("{scene}.toml")), parts.concat())?;
    }
    std::fs::write(home.path().join("long.toml"), LONG)?;
    Ok(home)
}

fn signal(child: &Child, name: &str) -> Outcome {
    let mut kill = Command::new("kill");
    let status = kill.arg(format!("-{name}")).arg(child.id().to_string());
    // It may have ended by itself.
    status.stderr(Stdio::null()).status()?;
    Ok(())
}

fn said(output: &Output) -> String {
    String::from_utf8_lossy(&output.stderr).into_owned()
}

#[test]
fn runs_broken_by_any_signal_at_any_moment_go_on_to_the_same_bytes() -> Outcome {
    let home = home()?;
    let (variable, usual) = BREAKS;
    let breaks = std::env::var(variable)
        .ok()
        .and_then(|text| text.parse().ok());
    let mut moment = 12_345_u64;
    for (scene, _) in BROKEN {
        let run = format!("run {scene}.toml --frames 10 --out");
        let began = Instant::now();
        succeed(home.path(), format!("{run} whole-{scene}"))?;
        let lasts = began.elapsed().as_millis() as u64;
        let whole = files(&home.path().join(format!("whole-{scene}")))?;
        for name in ["INT", "TERM", "KILL"] {
            let out = format!("{scene}-{name}");
            let mut broken = 0;
            let mut resume = "";
            for _ in 0..breaks.unwrap_or(usual) {
                let command = format!("{run} {out} --checkpoint 0.05{resume}");
                moment = moment
                    .wrapping_mul(6_364_136_223_846_793_005)
                    .wrapping_add(1);
                // Each stretch on its own number of threads.
                let threads = THREADS[(moment >> 40) as usize % THREADS.len()];
                let child = prepared(home.path(), &command)
                    .env("RAYON_NUM_THREADS", threads)
                    .spawn()?;
                std::thread::sleep(Duration::from_millis((moment >> 33) % lasts.max(2)));
                signal(&child, name)?;
                let output = child.wait_with_output()?;
                if output.status.success() {
                    break;
                }
                broken += 1;
                let said = said(&output);
                // Before the command watches for signals it dies of them, with nothing done.
                if name != "KILL" && output.status.code().is_some() {
                    assert_eq!(output.status.code(), Some(130), "{said}");
                    assert!(said.contains("interrupted"), "{said}");
                }
                if home.path().join(&out).join("tribos.json").exists() {
                    resume = " --resume";
                }
            }
            // A run that was killed after its last result is tidied up.
            if !resume.is_empty() || !home.path().join(&out).join("summary.json").exists() {
                succeed(home.path(), format!("{run} {out}{resume}"))?;
            }
            let ours = files(&home.path().join(&out))?;
            let names =
                |files: &BTreeMap<String, Vec<u8>>| files.keys().cloned().collect::<Vec<_>>();
            assert_eq!(names(&ours), names(&whole), "{out} after {broken} breaks");
            assert!(ours == whole, "{out} after {broken} breaks");
        }
    }
    Ok(())
}

/// The checkpoint of the end of a scene's run, which stands until the results are written.
fn last_checkpoint(scene: &Path) -> Result<String, Error> {
    fn ended<R: LongRun<Error: 'static>>(scene: &R::Scene) -> Result<String, Error> {
        let mut run = R::begin(scene, None, &mut |_| ControlFlow::Continue(()))?;
        while run.step()? {}
        Ok(run.checkpoint())
    }
    match Scene::read(scene, &[])? {
        Scene::Powder(scene) => ended::<PowderSimulation>(&scene),
        Scene::Grains(scene) => ended::<GrainsSimulation>(&scene),
        Scene::Gas(scene) => ended::<GasSimulation>(&scene),
        Scene::Tip(scene) => ended::<TipSimulation>(&scene),
        _ => Err("a short run".into()),
    }
}

#[test]
fn a_run_broken_while_it_writes_its_results_goes_on_to_the_same_bytes() -> Outcome {
    let home = home()?;
    for (scene, _) in BROKEN {
        let run = format!("run {scene}.toml --frames 10 --out {scene}");
        succeed(home.path(), &run)?;
        let out = home.path().join(scene);
        let whole = files(&out)?;
        // Killed after its last result, it leaves half a file and names of files that are gone.
        std::fs::write(out.join(".tribos-x7.tmp"), "half")?;
        let mut manifest = Manifest::read(&out)?.ok_or("a manifest")?;
        manifest.add(&["checkpoint.json"]);
        manifest.write(&out)?;
        succeed(home.path(), format!("{run} --resume"))?;
        assert!(files(&out)? == whole, "{scene}");
        let checkpoint = last_checkpoint(&home.path().join(format!("{scene}.toml")))?;
        std::fs::write(out.join("checkpoint.json"), checkpoint)?;
        let mut manifest = Manifest::read(&out)?.ok_or("a manifest")?;
        manifest.add(&["checkpoint.json"]);
        manifest.write(&out)?;
        let is_result = |name: &&String| !name.starts_with("frames/") && *name != "tribos.json";
        for name in whole.keys().filter(is_result) {
            if name != "series.csv" {
                std::fs::remove_file(out.join(name))?;
            }
        }
        succeed(home.path(), format!("{run} --resume"))?;
        let ours = files(&out)?;
        for (name, bytes) in &whole {
            assert!(ours.get(name) == Some(bytes), "{scene}: {name}");
        }
        assert_eq!(ours.len(), whole.len(), "{scene}");
    }
    Ok(())
}

#[test]
fn the_first_second_is_kept_and_two_runs_do_not_share_a_folder() -> Outcome {
    let home = home()?;
    let out = home.path().join("out");
    let child = prepared(home.path(), "run long.toml --out out").spawn()?;
    wait_for("the run starts", || out.join("frames/bodies.json").exists());
    // Another one is told who works there, and changes nothing.
    let (code, _, told) = tribos(home.path(), "run disk --out out")?;
    assert_eq!(code, Some(2), "{told}");
    let process = format!("process {}", child.id());
    assert_has(
        &told,
        &[
            &process,
            "tribos run long.toml --out out",
            "since 20",
            "another --out",
        ],
    );
    signal(&child, "INT")?;
    let output = child.wait_with_output()?;
    assert_eq!(output.status.code(), Some(130), "{}", said(&output));
    assert!(
        said(&output).contains("same command and --resume"),
        "{}",
        said(&output)
    );
    assert!(
        said(&output).starts_with("about 450 spheres"),
        "{}",
        said(&output)
    );
    assert!(out.join("checkpoint.json").exists() && !out.join("summary.json").exists());
    assert!(out.join("frames/000000000000.frame").exists());
    assert!(!out.join(".tribos-lock").exists());
    succeed(home.path(), "view out")?;
    // What goes on has the folder again, from where it was.
    let child = prepared(home.path(), "run long.toml --resume --out out").spawn()?;
    wait_for("the run goes on", || out.join(".tribos-lock").exists());
    signal(&child, "KILL")?;
    child.wait_with_output()?;
    // A lock that its process did not take away is none; the run that was broken off is not lost to
    // another one by mistake.
    let names = ["checkpoint.json", "frames/bodies.json", "tribos.json"];
    for command in [
        "run disk --out out",
        "run tip.toml --out out",
        "run long.toml --out out",
        "deposit --count 20 --out out",
    ] {
        let (code, _, told) = tribos(home.path(), command)?;
        assert_eq!(code, Some(2), "{told}");
        assert!(told.contains("broken off"), "{command}: {told}");
        assert!(
            names.iter().all(|name| out.join(name).exists()),
            "{command}"
        );
        let is_run = command.starts_with("run");
        assert!(
            !is_run || (told.contains("--resume") && told.contains("--anew")),
            "{told}"
        );
    }
    succeed(home.path(), "run disk --out out --anew")?;
    assert!(!out.join("frames").exists() && !out.join("checkpoint.json").exists());
    Ok(())
}

#[test]
fn half_written_files_of_killed_runs_go_away() -> Outcome {
    let home = home()?;
    let out = home.path().join("out");
    std::fs::create_dir_all(out.join("frames"))?;
    for name in [
        ".tribos-Ab3.tmp",
        "frames/.tribos-x.tmp",
        ".tmpMine",
        "frames/mine",
    ] {
        std::fs::write(out.join(name), "half")?;
    }
    succeed(home.path(), "run powder.toml --set max_steps=5 --out out")?;
    let there = [
        ".tribos-Ab3.tmp",
        "frames/.tribos-x.tmp",
        ".tmpMine",
        "frames/mine",
    ];
    assert_eq!(
        there.map(|name| out.join(name).exists()),
        [false, false, true, true]
    );
    Ok(())
}

/// A run that keeps writing until its folder is lost; what `disturb` leaves there stays as it is.
fn lost(home: &Path, disturb: impl FnOnce(&Path) -> Outcome) -> Result<String, Error> {
    let out = home.join("out");
    let run = prepared(home, "run long.toml --checkpoint 0 --out out").spawn()?;
    wait_for("the run is under way", || {
        out.join("checkpoint.json").exists()
    });
    disturb(&out)?;
    let output = run.wait_with_output()?;
    let told = said(&output);
    assert_eq!(output.status.code(), Some(1), "{told}");
    assert!(told.contains("was moved or deleted"), "{told}");
    Ok(told)
}

#[test]
fn a_run_whose_folder_is_lost_ends_and_mixes_with_no_other() -> Outcome {
    let home = home()?;
    let out = home.path().join("out");
    // Moved away, and made again by another run, whose files are all of it.
    lost(home.path(), |out| {
        std::fs::rename(out, home.path().join("moved"))?;
        succeed(home.path(), "run powder.toml --out out")?;
        Ok(())
    })?;
    let alone = prepared(home.path(), "run powder.toml --out alone").output()?;
    assert!(alone.status.success());
    assert!(files(&out)? == files(&home.path().join("alone"))?);
    // What was moved goes on elsewhere.
    assert!(home.path().join("moved/checkpoint.json").exists());
    std::fs::remove_dir_all(&out)?;
    // Deleted, and only its lock deleted.
    lost(home.path(), |out| {
        std::fs::rename(out, home.path().join("gone"))?;
        Ok(std::fs::remove_dir_all(home.path().join("gone"))?)
    })?;
    // Deleted while a file was written, the folder may be there for that file.
    assert!(!out.join("tribos.json").exists() && !out.join("summary.json").exists());
    let _ = std::fs::remove_dir_all(&out);
    lost(home.path(), |out| {
        Ok(std::fs::remove_file(out.join(".tribos-lock"))?)
    })?;
    Ok(())
}

#[test]
fn a_run_under_way_is_in_use_for_one_that_would_go_on() -> Outcome {
    let home = home()?;
    let run = prepared(home.path(), "run long.toml --out out").spawn()?;
    wait_for("the run starts", || {
        home.path().join("out/frames/bodies.json").exists()
    });
    let other = prepared(home.path(), "run long.toml --resume --out out").output()?;
    let told = said(&other);
    assert_eq!(other.status.code(), Some(2), "{told}");
    assert!(
        told.contains(&format!("in use by process {}", run.id())),
        "{told}"
    );
    assert!(!told.contains("from the start"), "{told}");
    signal(&run, "INT")?;
    run.wait_with_output()?;
    Ok(())
}

#[test]
fn what_was_exported_from_a_broken_run_goes_away_when_it_goes_on() -> Outcome {
    let home = home()?;
    let out = home.path().join("out");
    let run = prepared(home.path(), "run powder.toml --checkpoint 0 --out out").spawn()?;
    wait_for("the run is under way", || {
        out.join("frames/000000000016.frame").exists()
    });
    signal(&run, "INT")?;
    let output = run.wait_with_output()?;
    assert_eq!(output.status.code(), Some(130), "{}", said(&output));
    for command in [
        "export xyz out",
        "export vtk out",
        "view out",
        "view out --still 1,last",
    ] {
        succeed(home.path(), command)?;
    }
    std::fs::write(out.join("still-life.png"), "mine")?;
    succeed(home.path(), "run powder.toml --resume --out out")?;
    for gone in [
        "trajectory.xyz",
        "trajectory.pvd",
        "trajectory",
        "view.html",
        "still-1.png",
    ] {
        assert!(!out.join(gone).exists(), "{gone}");
    }
    assert!(out.join("still-life.png").exists() && out.join("summary.json").exists());
    Ok(())
}
