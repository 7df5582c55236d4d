//! `tribos inverse` prints launches that lead to the pose, or says what is missing.

use crate::program::{Outcome, succeed, told};

const PUCK: &str = "inverse --coefficient 0.3 --radius 0.08 --inertia-ratio 0.5 --gravity 9.81";
const LIMITS: &str = "--max-speed 3 --max-spin 40";
const TARGET: &str = "--x 1.2 --y 0.3 --angle 90deg";

#[test]
fn launches_come_by_energy_in_every_format() -> Outcome {
    let base = format!("{PUCK} {LIMITS} {TARGET}");
    let text = told(format!("{base} --format json --jacobian"))?;
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
    let csv = told(format!("{base} --format csv"))?;
    assert_eq!(csv.lines().count(), launches.len() + 1);
    assert!(csv.starts_with("speed,spin,direction,vx,vy,angle,turns,time,energy_per_mass\n"));
    let text = told(base)?;
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
        let body = "inverse --coefficient 0.3 --radius 0.08 --inertia-ratio 0.6";
        let target = "--x 0.5 --y 0 --angle -400deg --turns exact";
        let contact = format!("--patch {patch} --alpha -0.2 --format csv");
        let csv = told(format!("{body} {LIMITS} {target} {contact}"))?;
        assert_eq!(csv.lines().count(), 2, "{patch}");
        let spin = csv.lines().nth(1).and_then(|line| line.split(',').nth(1));
        assert!(spin.is_some_and(|spin| spin.starts_with('-')));
    }
    Ok(())
}

#[test]
fn the_reach_is_drawn() -> Outcome {
    let folder = tempfile::tempdir()?;
    let line = format!("{PUCK} {LIMITS} {TARGET} --plot reach.svg");
    succeed(folder.path(), line)?;
    let svg = std::fs::read_to_string(folder.path().join("reach.svg"))?;
    assert!(svg.contains("distance in m") && svg.contains("launches to the target"));
    Ok(())
}

#[test]
fn many_launches_are_counted_and_only_the_first_worked_out() -> Outcome {
    let more = "--max-speed 3 --max-spin 162 --symmetry 4 --most 5 --format csv";
    let [csv, said] = succeed(".", format!("{PUCK} {TARGET} {more}"))?;
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
fn limits_that_do_not_limit_are_no_limit() -> Outcome {
    let huge = |speed, spin| {
        let limits = format!("--max-speed {speed} --max-spin {spin}");
        succeed(".", format!("{PUCK} {TARGET} --most 5 {limits}"))
    };
    let [wanted, _] = huge("100", "1000")?;
    for (speed, spin) in [("1e12", "1e12"), ("1e9", "1e12"), ("1e300", "1e300")] {
        let [text, told] = huge(speed, spin)?;
        assert_eq!(text, wanted);
        assert!(told.contains("lower --max-spin for fewer"), "{told}");
    }
    Ok(())
}
