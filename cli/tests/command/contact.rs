//! `tribos contact`: problems of other programs, files that go together.

use crate::program::{Outcome, assert_has, succeed, summary, tribos};

/// Samples of Siconos.
fn sample(name: &str) -> String {
    let root = env!("CARGO_MANIFEST_DIR");
    format!("{root}/../std-adapter/contacts/src/problem/file/samples/{name}")
}

#[test]
fn several_problems_have_a_folder_each() -> Outcome {
    let folder = tempfile::tempdir()?;
    let (rover, spheres) = (sample("Rover1041.dat"), sample("NESpheres_10_1.dat"));
    let line = ["contact", &rover, &spheres, "--out", "out"];
    succeed(folder.path(), line)?;
    for (name, contacts) in [("Rover1041", 5), ("NESpheres_10_1", 9)] {
        let out = folder.path().join("out").join(name);
        let summary = summary(&out)?;
        assert_eq!(summary["converged"], true);
        assert_eq!(summary["ending"], "converged");
        assert_eq!(summary["contacts"], contacts);
        for residual in ["residual", "residual_scaled"] {
            assert!(summary[residual].as_f64().is_some_and(|r| r <= 1e-8));
        }
        for key in ["iterations", "factorisations", "seconds", "method"] {
            assert!(!summary[key].is_null(), "{key}");
        }
        let reactions = std::fs::read_to_string(out.join("reactions.csv"))?;
        assert!(reactions.starts_with("contact,normal,sliding_1,sliding_2\n0,"));
        assert_eq!(reactions.lines().count(), contacts + 1);
        for plot in ["convergence.svg", "convergence.png"] {
            assert!(out.join(plot).metadata()?.len() > 1000);
        }
    }
    // Again into the same folder; alone a problem has the folder itself.
    succeed(folder.path(), line)?;
    // Other problems: what the first ones left is gone.
    succeed(folder.path(), ["contact", &spheres, "--out", "out"])?;
    for name in ["Rover1041", "NESpheres_10_1"] {
        assert!(!folder.path().join("out").join(name).exists(), "{name}");
    }
    let alone = ["contact", &rover, "--method", "interior", "--out", "alone"];
    succeed(folder.path(), alone)?;
    assert_eq!(summary(&folder.path().join("alone"))?["contacts"], 5);
    Ok(())
}

#[test]
fn methods_are_compared_on_the_problem_of_a_step() -> Outcome {
    let folder = tempfile::tempdir()?;
    let scene = "body = \"powder\"\nwidth = 6\nheight = 8\npressure = 0.02\nmax_steps = 4";
    std::fs::write(folder.path().join("tiny.toml"), scene)?;
    succeed(folder.path(), ["run", "tiny.toml", "--out", "run"])?;
    succeed(folder.path(), ["export", "problem", "run", "--step", "3"])?;
    let file = "run/problem-3.hdf5";
    let line = [
        "contact",
        "compare",
        file,
        "--method",
        "sweeps,interior",
        "--out",
        "out",
    ];
    let (code, told, said) = tribos(folder.path(), line)?;
    assert_eq!(code, Some(0), "{said}");
    assert_has(
        &told,
        &["sweeps     solves 1 of 1", "interior   solves 1 of 1"],
    );
    let times = std::fs::read_to_string(folder.path().join("out/times.csv"))?;
    assert_eq!(times.lines().count(), 3);
    for name in ["profile.csv", "profile.svg", "profile.png"] {
        assert!(folder.path().join("out").join(name).exists(), "{name}");
    }
    Ok(())
}
