//! `tribos contact`: problems of other programs, files that go together, an exit code for what is not solved.

use crate::program::{Error, Outcome, assert_has, tribos};
use serde_json::Value;
use std::path::Path;

/// Samples of Siconos.
fn sample(name: &str) -> String {
    let root = env!("CARGO_MANIFEST_DIR");
    format!("{root}/../std-adapter/contacts/src/problem/file/samples/{name}")
}

fn summary(folder: &Path) -> Result<Value, Error> {
    Ok(serde_json::from_str(&std::fs::read_to_string(
        folder.join("summary.json"),
    )?)?)
}

#[test]
fn several_problems_have_a_folder_each() -> Outcome {
    let folder = tempfile::tempdir()?;
    let (rover, spheres) = (sample("Rover1041.dat"), sample("NESpheres_10_1.dat"));
    let line = ["contact", &rover, &spheres, "--out", "out"];
    let (code, told, said) = tribos(folder.path(), line)?;
    assert_eq!(code, Some(0), "{said}");
    assert_has(
        &told,
        &[
            "contacts",
            "converged",
            "Rover1041.dat",
            "NESpheres_10_1.dat",
        ],
    );
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
    let (code, _, said) = tribos(folder.path(), line)?;
    assert_eq!(code, Some(0), "{said}");
    // Other problems: what the first ones left is gone.
    let (code, _, said) = tribos(folder.path(), ["contact", &spheres, "--out", "out"])?;
    assert_eq!(code, Some(0), "{said}");
    for name in ["Rover1041", "NESpheres_10_1"] {
        assert!(!folder.path().join("out").join(name).exists(), "{name}");
    }
    let alone = ["contact", &rover, "--method", "interior", "--out", "alone"];
    let (code, _, said) = tribos(folder.path(), alone)?;
    assert_eq!(code, Some(0), "{said}");
    assert_eq!(summary(&folder.path().join("alone"))?["contacts"], 5);
    Ok(())
}

#[test]
fn what_is_not_solved_is_kept_and_has_its_own_exit_code() -> Outcome {
    let folder = tempfile::tempdir()?;
    // Below what numbers of 53 bits can reach.
    let rover = sample("Rover1041.dat");
    let line = ["contact", &rover, "--tolerance", "1e-30", "--out", "out"];
    let (code, told, said) = tribos(folder.path(), line)?;
    assert_eq!(code, Some(4), "{told}{said}");
    assert_has(&said, &["not solved to 1e-30", "Rover1041.dat", "--method"]);
    assert_eq!(summary(&folder.path().join("out"))?["converged"], false);
    assert!(folder.path().join("out/reactions.csv").exists());
    Ok(())
}

#[test]
fn what_no_impulses_solve_says_so_with_its_proof() -> Outcome {
    let folder = tempfile::tempdir()?;
    // A body between two plates that close: u_0 + u_1 = -2, whatever r.
    let matrix = "1 0 0 -1 0 0\n0 0 0 0 0 0\n0 0 0 0 0 0\n-1 0 0 1 0 0\n0 0 0 0 0 0\n0 0 0 0 0 0";
    let text = format!("3\n2\n0\n6\n6\n6\t6\n{matrix}\n-1 0 0 -1 0 0\n0.5 0.5\n");
    std::fs::write(folder.path().join("plates.dat"), text)?;
    for method in ["automatic", "sweeps", "gradient", "interior", "proximal"] {
        let line = ["contact", "plates.dat", "--method", method, "--out", "out"];
        let (code, told, said) = tribos(folder.path(), line)?;
        assert_eq!(code, Some(4), "{method}: {told}{said}");
        assert_has(&said, &["insoluble: 2 contacts close at 1.000e0"]);
        let summary = summary(&folder.path().join("out"))?;
        assert_eq!(summary["ending"], "insoluble", "{method}");
        let certificate = summary["certificate"].as_str().unwrap_or_default();
        assert!(certificate.starts_with("insoluble: "), "{certificate}");
    }
    Ok(())
}

#[test]
fn files_are_refused_before_anything_is_solved() -> Outcome {
    let folder = tempfile::tempdir()?;
    std::fs::write(folder.path().join("bad.dat"), "3\n1\n0\n3 x")?;
    let rover = sample("Rover1041.dat");
    let (code, told, said) = tribos(
        folder.path(),
        ["contact", &rover, "bad.dat", "--out", "out"],
    )?;
    assert_eq!(code, Some(2), "{said}");
    assert_has(
        &said,
        &[
            "bad.dat, line 4",
            "the number of rows is 3, not at most 2, for which the file has room",
        ],
    );
    assert!(told.is_empty() && !folder.path().join("out").exists());
    let (code, _, said) = tribos(folder.path(), ["contact", &rover, &rover, "--out", "out"])?;
    assert_eq!(code, Some(2), "{said}");
    assert_has(&said, &["is given twice"]);
    std::fs::copy(&rover, folder.path().join("Rover1041.hdf5"))?;
    let line = ["contact", &rover, "Rover1041.hdf5", "--out", "out"];
    let (code, _, said) = tribos(folder.path(), line)?;
    assert_eq!(code, Some(2), "{said}");
    assert_has(&said, &["would both have the folder"]);
    Ok(())
}

#[test]
fn methods_are_compared_on_the_problem_of_a_step() -> Outcome {
    let folder = tempfile::tempdir()?;
    let scene = "body = \"powder\"\nwidth = 6\nheight = 8\npressure = 0.02\nmax_steps = 4";
    std::fs::write(folder.path().join("tiny.toml"), scene)?;
    let (code, _, said) = tribos(folder.path(), ["run", "tiny.toml", "--out", "run"])?;
    assert_eq!(code, Some(0), "{said}");
    let (code, told, said) = tribos(folder.path(), ["export", "problem", "run", "--step", "3"])?;
    assert_eq!(code, Some(0), "{said}");
    assert_has(
        &told,
        &[
            "problem-3.hdf5",
            "contacts",
            "solved to a residual of",
            "within its tolerance",
        ],
    );
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
    let (code, _, said) = tribos(folder.path(), ["export", "problem", "run", "--step", "5"])?;
    assert_eq!(code, Some(2), "{said}");
    assert_has(&said, &["--step 5: the run ends with step 4"]);
    // A disk has no contact problem.
    let (code, _, said) = tribos(folder.path(), ["run", "disk", "--out", "disk"])?;
    assert_eq!(code, Some(0), "{said}");
    let (code, _, said) = tribos(folder.path(), ["export", "problem", "disk", "--step", "1"])?;
    assert_eq!(code, Some(2), "{said}");
    assert_has(&said, &["only runs with body = \"powder\" or \"grains\""]);
    Ok(())
}
