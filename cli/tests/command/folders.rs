//! Output folders that were used before: what stands there is of one command, or a clear refusal.

use crate::program::{self, Error, Outcome, files, succeed};
use crate::reader::copy;
use std::path::Path;

const POWDER: &str = "body = \"powder\"\nwidth = 6\nheight = 8\npressure = 0.02\nmax_steps = 20\n";
const TIP: &str = "body = \"tip\"\nlambda = 0.02\nsubstrate_columns = 8\nsubstrate_rows = 8\ntip_side_atoms = 2\n\
                   substrate_layers = 4\ntip_layers = 4\nequilibration = 0.1\ndrive_time = 0.2\n\
                   rest_time = 0.1\nsample_every = 20\n";
const ATOMS: &str = "2\nLattice=\"20 0 0 0 20 0 0 0 20\" Properties=species:S:1:pos:R:3\n\
                     Ar 1 1 1\nAr 2.2 1 1\n";
const PULLS: &str = "v,f\n0.1,0.30\n0.2,0.31\n0.4,0.29\n0.8,0.30\n1.6,0.31\n";

/// Commands that write into `DIR`, and whether the folder can be played afterwards.
const WRITERS: [(&str, bool); 9] = [
    ("run disk --set samples=20 --out DIR", true),
    ("run cylinder --set samples=20 --out DIR", true),
    ("run powder.toml --out DIR", true),
    ("run powder.toml --set mu=0.5 --frames 0 --out DIR", false),
    ("run tip.toml --out DIR", true),
    ("deposit --count 20 --out DIR", false),
    ("eval atoms.xyz --pair lj:cutoff=2.5 --out DIR", false),
    ("fit --law power pulls.csv --out DIR", false),
    ("export lammps tip.toml --out DIR", false),
];

/// Runs a command in the home folder: exit code and what was said.
fn tribos(home: &Path, command: &str) -> Result<(Option<i32>, String), Error> {
    let (code, _, said) = program::tribos(home, command)?;
    Ok((code, said))
}

fn home() -> Result<tempfile::TempDir, Error> {
    let home = tempfile::tempdir()?;
    for (name, text) in [
        ("powder.toml", POWDER),
        ("tip.toml", TIP),
        ("atoms.xyz", ATOMS),
        ("pulls.csv", PULLS),
    ] {
        std::fs::write(home.path().join(name), text)?;
    }
    Ok(home)
}

#[test]
fn every_command_after_every_other_leaves_its_own_files_only() -> Outcome {
    let home = home()?;
    let alone = |index: usize| format!("alone-{index}");
    for (index, (command, _)) in WRITERS.iter().enumerate() {
        succeed(home.path(), command.replace("DIR", &alone(index)))?;
    }
    let mut mixed = 0;
    for (first, (earlier, _)) in WRITERS.iter().enumerate() {
        for (second, (command, plays)) in WRITERS.iter().enumerate() {
            let used = home.path().join("used");
            copy(&home.path().join(alone(first)), &used)?;
            let (code, said) = tribos(home.path(), &command.replace("DIR", "used"))?;
            mixed += 1;
            if earlier.contains("run powder") || earlier.contains("run tip") {
                // What took long is replaced by another run only.
                if !command.starts_with("run") {
                    assert_eq!(code, Some(2), "{command} after {earlier}: {said}");
                    assert!(said.contains("the results of `tribos run`"), "{said}");
                    assert!(files(&used)? == files(&home.path().join(alone(first)))?);
                    std::fs::remove_dir_all(&used)?;
                    continue;
                }
            }
            assert_eq!(code, Some(0), "{command} after {earlier}: {said}");
            assert!(
                files(&used)? == files(&home.path().join(alone(second)))?,
                "{command} after {earlier}"
            );
            // One view a command is enough: the folder is to the byte what it is without the first.
            if first == 0 {
                let (code, said) = tribos(home.path(), "view used")?;
                assert_eq!(code == Some(0), *plays, "view of {command}: {said}");
            }
            std::fs::remove_dir_all(&used)?;
        }
    }
    assert!(mixed > 50);
    Ok(())
}

#[test]
fn sweeps_are_not_replaced_and_a_sweep_replaces_a_run() -> Outcome {
    let home = home()?;
    let sweep = "sweep disk --set spin=0,5 --set samples=20 --out DIR";
    succeed(home.path(), sweep.replace("DIR", "sweep"))?;
    let before = files(&home.path().join("sweep"))?;
    for (command, _) in WRITERS {
        let (code, said) = tribos(home.path(), &command.replace("DIR", "sweep"))?;
        assert_eq!(code, Some(2), "{command}: {said}");
        assert!(said.contains("holds the results of `tribos"), "{said}");
    }
    assert!(files(&home.path().join("sweep"))? == before);
    let (code, said) = tribos(home.path(), "view sweep")?;
    assert!(code == Some(2) && said.contains("not a run"), "{said}");
    succeed(home.path(), "run cylinder --out used")?;
    succeed(home.path(), sweep.replace("DIR", "used"))?;
    assert!(files(&home.path().join("used"))? == files(&home.path().join("sweep"))?);
    Ok(())
}

#[test]
fn a_strangers_file_is_never_replaced() -> Outcome {
    let home = home()?;
    for (index, (command, _)) in WRITERS.iter().enumerate() {
        let out = format!("mine-{index}");
        let folder = home.path().join(&out);
        succeed(home.path(), command.replace("DIR", &out))?;
        std::fs::write(folder.join("notes.txt"), "mine")?;
        std::fs::remove_file(folder.join("tribos.json"))?;
        let before = files(&folder)?;
        let (code, said) = tribos(home.path(), &command.replace("DIR", &out))?;
        assert_eq!(code, Some(2), "{command}: {said}");
        assert!(said.contains("does not say that tribos wrote it"), "{said}");
        assert!(files(&folder)? == before, "{command}");
    }
    Ok(())
}

#[test]
fn a_powder_is_not_lost_to_an_export_a_fit_or_a_sweep() -> Outcome {
    let home = home()?;
    let run = |scene: &str, out: &str| succeed(home.path(), format!("run {scene} --out {out}"));
    for (scene, out) in [
        ("powder.toml", "a"),
        ("powder.toml --set pressure=0.03", "b"),
        ("tip.toml", "c"),
    ] {
        run(scene, out)?;
    }
    for used in ["b", "c"] {
        let before = files(&home.path().join(used))?;
        for command in [
            "export xyz a --out DIR",
            "export vtk a --out DIR",
            "export lammps-dump a --out DIR",
            "export lammps tip.toml --out DIR",
            "fit --law power pulls.csv --out DIR",
            "sweep disk --set spin=0,5 --set samples=20 --out DIR",
        ] {
            let (code, said) = tribos(home.path(), &command.replace("DIR", used))?;
            assert_eq!(code, Some(2), "{command}: {said}");
            let is_told = said.contains("holds the results of `tribos run`")
                && said.contains("another --out");
            assert!(is_told, "{command}: {said}");
            assert!(files(&home.path().join(used))? == before, "{command}");
        }
    }
    // Its own trajectory goes beside it, and another one into a folder of its own.
    for command in [
        "export xyz b",
        "export vtk b --out b",
        "export xyz a --out x",
    ] {
        succeed(home.path(), command)?;
    }
    assert!(home.path().join("b/trajectory.xyz").exists());
    // Another run replaces it, with what was exported from it.
    run("disk --set samples=20", "b")?;
    for gone in ["frames", "trajectory.xyz", "trajectory.pvd", "trajectory"] {
        assert!(!home.path().join("b").join(gone).exists(), "{gone}");
    }
    Ok(())
}

#[test]
fn a_folder_says_what_was_written_and_other_files_are_their_owners() -> Outcome {
    let home = home()?;
    let out = home.path().join("out");
    std::fs::create_dir_all(out.join("trajectory"))?;
    let mine = [
        "view.html",
        "trajectory.xyz",
        "trajectory/7.vtp",
        "still-7.png",
    ];
    for name in mine {
        std::fs::write(out.join(name), "mine")?;
    }
    let kept = || {
        mine.map(|name| std::fs::read(out.join(name)).ok())
            .iter()
            .all(|bytes| bytes.as_deref() == Some(b"mine"))
    };
    for command in ["run powder.toml --out out", "run disk --out out"] {
        succeed(home.path(), command)?;
        assert!(kept(), "{command}");
        for command in ["view out", "export xyz out", "export vtk out"] {
            let (code, said) = tribos(home.path(), command)?;
            assert_eq!(code, Some(2), "{command}: {said}");
            assert!(said.contains("does not say that tribos wrote it"), "{said}");
            assert!(kept(), "{command}");
        }
    }
    let text = std::fs::read_to_string(out.join("tribos.json"))?;
    let manifest: serde_json::Value = serde_json::from_str(&text)?;
    for name in manifest["files"].as_array().ok_or("no names")? {
        let name = name.as_str().ok_or("no text")?;
        assert!(out.join(name).exists(), "{name}");
    }
    Ok(())
}
