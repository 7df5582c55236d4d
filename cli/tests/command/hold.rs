//! `tribos hold`: the three answers and their margins.

use crate::program::{Outcome, number, told};
use serde_json::Value;

/// A uniform disk of 6 mm under 10 N: 6 N are held for certain, 8 N at most.
const FINGER: &str = "hold --radius 0.006 --mu-s 0.8 --mu-d 0.6 --load 10";
/// Largest torque over force limit of that disk, 2R/3.
const ARM: f64 = 0.004;

fn asked(line: &str) -> Result<Value, crate::program::Error> {
    Ok(serde_json::from_str(&told(format!(
        "{FINGER} {line} --format json"
    ))?)?)
}

#[test]
fn the_answer_changes_at_both_coefficients() -> Outcome {
    for (line, expected) in [
        ("--force 5.9,0", "holds"),
        ("--force 0,-6.1", "undecided"),
        ("--force -7.9,0", "undecided"),
        ("--force 0,8.1", "slips"),
        ("--torque 0.0239", "holds"),
        ("--torque -0.0241", "undecided"),
        ("--torque 0.0321", "slips"),
        // Together they are too much, each alone is not.
        ("--force 6,0 --torque 0.024", "slips"),
        ("", "holds"),
    ] {
        assert_eq!(asked(line)?["hold"], expected, "{line}");
    }
    // Under one coefficient every push is decided.
    let one = "hold --radius 0.006 --mu-s 0.8 --load 10 --format json";
    for (force, expected) in [("7.9,0", "holds"), ("8.1,0", "slips")] {
        let answer: Value = serde_json::from_str(&told(format!("{one} --force {force}"))?)?;
        assert_eq!(answer["hold"], expected);
    }
    Ok(())
}

#[test]
fn margins_and_displacement_are_those_of_the_closed_forms() -> Outcome {
    let answer = asked("--force -3,4 --stiffness 2e4")?;
    let close = |place: &str, expected: f64| {
        let found = number(&answer, place);
        assert!(
            (found - expected).abs() < 1e-12,
            "{place}: {found} {expected}"
        );
    };
    close("/certain_gauge", 5.0 / 6.0);
    close("/possible_gauge", 5.0 / 8.0);
    close("/surely_held_scale", 1.2);
    close("/surely_slipping_scale", 1.6);
    close("/first_motion/0", -0.6);
    close("/first_motion/1", 0.8);
    close("/displacement/0", -3.0 / 2e4);
    close("/displacement/1", 4.0 / 2e4);
    let twisted = asked("--torque -0.016 --stiffness 2e4 --torsional-stiffness 0.36")?;
    assert!((number(&twisted, "/surely_slipping_scale") - 8.0 * ARM / 0.016).abs() < 1e-12);
    assert!((number(&twisted, "/displacement/2") + 0.016 / 0.36).abs() < 1e-14);
    // What slips has no place to rest.
    assert_eq!(
        asked("--force 9,0 --stiffness 2e4")?.get("displacement"),
        None
    );
    Ok(())
}
