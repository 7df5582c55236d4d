//! `tribos inverse` prints launches that lead to the pose, or says what is missing.

use crate::program::{Error, Outcome, Said, assert_has, tribos};

const PUCK: [&str; 9] = [
    "inverse",
    "--coefficient",
    "0.3",
    "--radius",
    "0.08",
    "--inertia-ratio",
    "0.5",
    "--gravity",
    "9.81",
];
const LIMITS: [&str; 4] = ["--max-speed", "3", "--max-spin", "40"];
const TARGET: [&str; 6] = ["--x", "1.2", "--y", "0.3", "--angle", "90deg"];

/// Exit code, standard output and standard error.
fn inverse(parts: &[&[&str]]) -> Result<Said, Error> {
    tribos(".", parts.concat())
}

#[test]
fn launches_come_by_energy_in_every_format() -> Outcome {
    let base: [&[&str]; 3] = [&PUCK, &LIMITS, &TARGET];
    let (code, text, _) = inverse(&[&base[..], &[&["--format", "json", "--jacobian"]]].concat())?;
    assert_eq!(code, Some(0));
    let value: serde_json::Value = serde_json::from_str(&text)?;
    let launches = value.as_array().ok_or("no array")?;
    assert!(launches.len() > 1);
    let number = |i: usize, name: &str| launches[i][name].as_f64().ok_or("no number");
    for i in 0..launches.len() {
        let (vx, vy) = (number(i, "vx")?, number(i, "vy")?);
        assert!((vy / vx - 0.25).abs() < 1e-14);
        assert!(number(i, "speed")? <= 3.0 && number(i, "spin")?.abs() <= 40.0);
        let turns = number(i, "turns")? - 0.25;
        assert!((turns - turns.round()).abs() < 1e-12);
        // The next launch needs more energy.
        if i > 0 {
            assert!(number(i, "energy_per_mass")? >= number(i - 1, "energy_per_mass")?);
        }
        assert!(number(i, "dx_dvx")? > 0.0 && number(i, "dangle_dspin")? > 0.0);
    }
    let (_, csv, _) = inverse(&[&base[..], &[&["--format", "csv"]]].concat())?;
    assert_eq!(csv.lines().count(), launches.len() + 1);
    assert!(csv.starts_with("speed,spin,direction,vx,vy,angle,turns,time,energy_per_mass\n"));
    let (_, text, _) = inverse(&base)?;
    assert!(
        text.starts_with(&format!("{} launches", launches.len())),
        "{text}"
    );
    Ok(())
}

#[test]
fn an_exact_angle_has_one_launch_on_every_patch() -> Outcome {
    let patches = [
        "disk",
        "ring",
        "annulus:0.5",
        "hertz",
        "punch",
        "paraboloid",
    ];
    for patch in patches {
        let asked = [
            "--x", "0.5", "--y", "0", "--angle", "-400deg", "--turns", "exact",
        ];
        let body = [
            "inverse",
            "--coefficient",
            "0.3",
            "--radius",
            "0.08",
            "--inertia-ratio",
            "0.6",
        ];
        let (code, csv, error) = inverse(&[
            &body,
            &LIMITS,
            &asked,
            &["--patch", patch, "--alpha", "-0.2", "--format", "csv"],
        ])?;
        assert_eq!(
            (code, csv.lines().count()),
            (Some(0), 2),
            "{patch}: {error}"
        );
        let spin = csv.lines().nth(1).and_then(|line| line.split(',').nth(1));
        assert!(spin.is_some_and(|spin| spin.starts_with('-')));
    }
    Ok(())
}

#[test]
fn what_is_out_of_reach_ends_with_code_2_and_the_reach() -> Outcome {
    let far = ["--x", "9", "--y", "0", "--angle", "1", "--turns", "exact"];
    let (code, out, error) = inverse(&[&PUCK, &LIMITS, &far])?;
    assert_eq!((code, out.as_str()), (Some(2), ""));
    assert_has(
        &error,
        &[
            "out of reach",
            "m/s",
            "the limits are 3 m/s and 40 rad/s",
            "they reach from",
        ],
    );
    Ok(())
}

#[test]
fn bad_input_is_refused_with_its_cure() -> Outcome {
    let cases: [(&[&str], &str); 6] = [
        (&["--alpha", "1"], "never comes to rest"),
        (&["--patch", "square"], "paraboloid"),
        (&["--patch", "annulus"], "annulus:0.8"),
        (&["--symmetry", "0"], "symmetry"),
        (&["--plot", "reach.gif"], ".svg or .png"),
        (&["--alpha", "-2"], "> -1 and <= 128"),
    ];
    for (more, words) in cases {
        let (code, _, error) = inverse(&[&PUCK, &LIMITS, &TARGET, more])?;
        assert_eq!(code, Some(2), "{more:?}");
        assert!(error.contains(words), "{more:?}: {error}");
    }
    let (code, _, error) = inverse(&[
        &PUCK,
        &LIMITS,
        &["--x", "1", "--y", "0", "--angle", "90grad"],
    ])?;
    assert!(code == Some(2) && error.contains("90deg"), "{error}");
    let (code, _, error) = inverse(&[&PUCK, &TARGET])?;
    assert!(code == Some(2) && error.contains("--max-speed"), "{error}");
    Ok(())
}

#[test]
fn the_reach_is_drawn() -> Outcome {
    let folder = tempfile::tempdir()?;
    let file = folder.path().join("reach.svg");
    let name = file.display().to_string();
    let (code, _, error) = inverse(&[&PUCK, &LIMITS, &TARGET, &["--plot", &name]])?;
    assert_eq!(code, Some(0), "{error}");
    let svg = std::fs::read_to_string(file)?;
    assert!(svg.contains("distance in m") && svg.contains("launches to the target"));
    Ok(())
}

#[test]
fn many_launches_are_counted_and_only_the_first_worked_out() -> Outcome {
    let limits = ["--max-speed", "3", "--max-spin", "162"];
    let base: [&[&str]; 3] = [&PUCK, &limits, &TARGET];
    let more: &[&str] = &["--symmetry", "4", "--most", "5", "--format", "csv"];
    let (code, csv, said) = inverse(&[&base[..], &[more]].concat())?;
    assert_eq!(code, Some(0), "{said}");
    assert_eq!(csv.lines().count(), 6);
    assert!(
        said.contains("launches lead there; the 5 with the fewest turns"),
        "{said}"
    );
    let count: u64 = said
        .split(' ')
        .nth(1)
        .and_then(|word| word.parse().ok())
        .ok_or("no number")?;
    assert!(count > 300, "{said}");
    Ok(())
}

#[test]
fn an_angle_without_a_unit_is_read_aloud() -> Outcome {
    let at = ["--x", "1.2", "--y", "0.3", "--angle"];
    let with = |angle| inverse(&[&PUCK, &LIMITS, &at, &[angle]]);
    let (code, told, said) = with("90")?;
    assert_eq!(code, Some(0));
    assert!(
        said.contains("read in radians") && said.contains("90deg"),
        "{said}"
    );
    assert!(told.contains("angle 90 rad (5156.62 deg)"), "{told}");
    for angle in ["90deg", "90rad", "1.5"] {
        assert_eq!(with(angle)?.2, "", "{angle}");
    }
    // What is out of reach by little says so with enough digits.
    let at = [
        "--x", "1e-300", "--y", "0", "--angle", "0", "--turns", "exact",
    ];
    let limits = ["--max-speed", "0", "--max-spin", "40"];
    let (code, _, said) = inverse(&[&PUCK, &limits, &at])?;
    assert_eq!(code, Some(2));
    assert!(said.contains("takes 2.426108e-150 m/s"), "{said}");
    Ok(())
}

#[test]
fn limits_that_do_not_limit_are_no_limit() -> Outcome {
    let few = ["--most", "5"];
    let huge = |speed, spin| -> Result<_, Error> {
        let limits = ["--max-speed", speed, "--max-spin", spin];
        inverse(&[&PUCK, &TARGET, &few, &limits])
    };
    let (_, wanted, _) = huge("100", "1000")?;
    for (speed, spin) in [("1e12", "1e12"), ("1e9", "1e12"), ("1e300", "1e300")] {
        let (code, text, told) = huge(speed, spin)?;
        assert_eq!(code, Some(0), "{told}");
        assert_eq!(text, wanted);
        assert!(told.contains("lower --max-spin for fewer"), "{told}");
    }
    let (_, _, told) = huge("1e300", "1e300")?;
    assert!(
        told.contains("more than 18446744073709551615 launches"),
        "{told}"
    );
    Ok(())
}

#[test]
fn whole_numbers_have_their_range_named() -> Outcome {
    let base: [&[&str]; 3] = [&PUCK, &LIMITS, &TARGET];
    for (option, value, range) in [
        ("--most", "1000000000", "from 1 to 100000"),
        ("--most", "0", "from 1 to 100000"),
        ("--symmetry", "0", "from 1 to 4294967295"),
        ("--symmetry", "1e3", "from 1 to 4294967295"),
    ] {
        let (code, _, told) = inverse(&[&base[..], &[&[option, value]]].concat())?;
        assert_eq!(code, Some(2));
        assert!(told.contains(range), "{option} {value}: {told}");
    }
    Ok(())
}
