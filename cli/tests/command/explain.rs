//! `tribos explain` says what a scene carries, and after a run what it could have left out.

use crate::program::{Error, Outcome, assert_has, tribos};

#[test]
fn every_body_tells_its_unknowns_and_cost() -> Outcome {
    let folder = tempfile::tempdir()?;
    for (arguments, words) in [
        (
            &["disk"][..],
            // m v²/2 and m R² ω²/4 of the scene are 0.05 J and 0.004 J.
            &[
                "2: sliding speed and spin",
                "Coulomb",
                "ns an evaluation",
                "92.6 % of it slowed the sliding",
            ][..],
        ),
        (
            &["cylinder", "--set", "pressure=hertz"],
            &["Hertz", "table made at the start", "lateral"],
        ),
        (&["disk", "--set", "spin=1"], &["check with --set spin=0"]),
        (
            &["cylinder", "--set", "height=0.001"],
            &["the path bends by 0.0"],
        ),
        (&["pipe-a"], &["annulus", "two disks"]),
        (
            &["curling-draw", "--set", "model=film"],
            &["quadrature over 256 points"],
        ),
        (
            &[
                "compaction-small",
                "--set",
                "height=12",
                "--set",
                "mu_torsion=0.1",
                "--set",
                "coupling=exact",
            ],
            &[
                "normal, sliding, torsion; rolling not resisted",
                "4 unknowns",
                "limit surface",
                "million a second",
                "kB",
            ],
        ),
        (
            &[
                "tip-reversible",
                "--set",
                "substrate_layers=4",
                "--set",
                "tip_layers=4",
            ],
            &[
                "atom-steps",
                "within the cut-off",
                "Nose-Hoover on 2 groups",
                "70000 of 0.005 tau",
            ],
        ),
    ] {
        let (code, told, said) = tribos(folder.path(), [&["explain"], arguments].concat())?;
        assert_eq!(code, Some(0), "{said}");
        for word in words {
            assert!(told.contains(word), "{word} not in {told}");
        }
    }
    Ok(())
}

#[test]
fn after_a_run_it_tells_where_the_energy_went_and_what_could_go() -> Outcome {
    let folder = tempfile::tempdir()?;
    let scene = "body = \"powder\"\nwidth = 8\nheight = 12\npressure = 0.01\npiston_mass = 100\n";
    std::fs::write(folder.path().join("tiny.toml"), scene)?;
    let at = folder.path();
    // So small a threshold of torsion takes next to nothing.
    let little = ["--set", "mu_torsion=1e-6", "--out", "out"];
    tribos(at, [&["run", "tiny.toml"], &little[..]].concat())?;
    let (code, told, said) = tribos(at, [&["explain", "tiny.toml"], &little[..]].concat())?;
    assert_eq!(code, Some(0), "{said}");
    assert_has(
        &told,
        &[
            "4 unknowns",
            "torsion dissipated",
            "4 unknowns a contact become 3",
            "tribos run tiny.toml --set mu_torsion=1e-6 --out out-less --set mu_torsion=0",
            "at threshold",
        ],
    );
    // Shares of what was exchanged add up, those that gave energy counted alike.
    let shares = told
        .lines()
        .filter_map(|line| line.split_once(" %"))
        .filter_map(|(head, _)| {
            let name = head.split_whitespace().next()?;
            let parts = ["normal", "sliding", "rolling", "torsion", "cohesion"];
            let number: f64 = head.split_whitespace().last()?.parse().ok()?;
            (parts.contains(&name) && head.split_whitespace().count() == 2).then_some(number.abs())
        });
    let total: f64 = shares.sum();
    assert!((total - 100.0).abs() < 0.3, "{total}: {told}");
    assert!(!told.contains("sliding dissipated"), "{told}");

    let (code, _, said) = tribos(at, "explain tiny.toml --out out")?;
    assert!(
        code == Some(2) && said.contains("`mu_torsion` is 0.000001 there, 0 here"),
        "{said}"
    );
    let (code, _, said) = tribos(at, "explain tiny.toml --out nowhere")?;
    assert!(
        code == Some(2) && said.contains("finished `tribos run`"),
        "{said}"
    );
    let (code, _, said) = tribos(at, "explain disk --out out")?;
    assert!(code == Some(2) && said.contains("powders"), "{said}");
    Ok(())
}

#[test]
fn after_a_tips_run_it_tells_its_work_and_how_long_a_drive_would_do() -> Outcome {
    let folder = tempfile::tempdir()?;
    let small = "body = \"tip\"\nlambda = 0.01\nsubstrate_columns = 12\nsubstrate_rows = 14\ntip_side_atoms = 3\nspacing = 1.1\n\
                 substrate_layers = 4\ntip_layers = 4\nequilibration = 5\ndrive_time = 80\nrest_time = 5\ntemperature = 0.01\n";
    std::fs::write(folder.path().join("tip.toml"), small)?;
    let at = folder.path();
    let (code, _, said) = tribos(at, "run tip.toml --out out")?;
    assert_eq!(code, Some(0), "{said}");
    let (code, told, said) = tribos(at, "explain tip.toml --out out")?;
    assert_eq!(code, Some(0), "{said}");
    assert_has(
        &told,
        &["eps of work", "slipped", "could go", "--set drive_time="],
    );
    let (code, _, said) = tribos(
        at,
        ["explain", "tip.toml", "--set", "seed=2", "--out", "out"],
    )?;
    assert!(
        code == Some(2) && said.contains("`seed` is 1 there, 2 here"),
        "{said}"
    );
    Ok(())
}

#[test]
fn the_reading_of_a_tips_drive_is_told_with_the_force_that_it_means() -> Outcome {
    let folder = tempfile::tempdir()?;
    let force = |reading: &str| -> Result<f64, Error> {
        let reading = format!("reading={reading}");
        let small = ["--set", "substrate_layers=4", "--set", "tip_layers=4"];
        let asked = [
            &["explain", "tip-reversible", "--set", &reading],
            &small[..],
        ]
        .concat();
        let (code, told, said) = tribos(folder.path(), &asked)?;
        assert_eq!(code, Some(0), "{said}");
        let (_, rest) = told.split_once("up to ").ok_or("no force")?;
        Ok(rest.split(' ').next().ok_or("no number")?.parse()?)
    };
    let [angular, mean, largest] = [force("angular")?, force("mean")?, force("largest")?];
    // The outermost atom stands farthest out: lambda itself acts on it under `largest`.
    assert!(
        largest < mean && mean < angular,
        "{angular} {mean} {largest}"
    );
    assert!((1.2..3.0).contains(&(mean / largest)) && angular / largest > 3.0);
    // A key that is given twice would lose one of its values.
    let twice = ["explain", "disk", "--set", "spin=1", "--set", "spin=2"];
    let (code, _, said) = tribos(folder.path(), twice)?;
    assert!(
        code == Some(2) && said.contains("`spin` is given twice"),
        "{said}"
    );
    Ok(())
}
