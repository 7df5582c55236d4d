//! All commands that take an exponent serve the same ones, refuse the others in the same words, and say
//! which tier they chose.

use crate::program::{Error, Outcome, tribos};

/// Exit code, and all that was said.
fn said(arguments: &str) -> Result<(i32, String), Error> {
    let (code, out, err) = tribos(".", arguments)?;
    Ok((code.ok_or("ended by a signal")?, out + &err))
}

/// Commands with the exponent and a folder left open.
const PLACES: [&str; 8] = [
    "wrench --speed 1 --spin 1 --alpha=ALPHA",
    "wrench --speed 1 --spin 1 --law power:gamma=1,alpha=ALPHA",
    "modes --inertia-ratio 0.5 --alpha=ALPHA",
    "explain disk --set alpha=ALPHA",
    "explain cylinder --set on_tipping=clamp --set alpha=ALPHA",
    "run disk --set alpha=ALPHA --set duration=1 --out FOLDER",
    "run cylinder --set on_tipping=clamp --set alpha=ALPHA --out FOLDER",
    "laws --curve power:gamma=1,alpha=ALPHA --out FOLDER.svg",
];

#[test]
fn every_place_serves_the_same_exponents() -> Outcome {
    let folder = tempfile::tempdir()?;
    let at = |place: &str, alpha: &str| {
        let folder = folder.path().join("out").display().to_string();
        said(&place.replace("ALPHA", alpha).replace("FOLDER", &folder))
    };
    for place in PLACES {
        for alpha in ["-0.5", "0", "10", "20"] {
            let (code, told) = at(place, alpha)?;
            assert_eq!(code, 0, "{place} {alpha}: {told}");
        }
        for alpha in ["-1", "129", "200"] {
            let (code, told) = at(place, alpha)?;
            assert_eq!(code, 2, "{place} {alpha}: {told}");
            let words = format!("must be a number > -1 and <= 128, not {alpha}");
            assert!(told.contains(&words), "{place} {alpha}: {told}");
        }
    }
    Ok(())
}

#[test]
fn the_tier_that_was_chosen_is_said() -> Outcome {
    for (arguments, tier) in [
        ("--alpha 10", "table"),
        ("--alpha 20", "compact"),
        ("--alpha 20 --patch polynomial:1,1", "quadrature"),
        ("--patch polynomial:1,1 --precision f32", "quadrature"),
        ("--law dry:mu_s=0.3,mu_d=0.2", "quadrature"),
        ("--law power:gamma=1,alpha=20 --patch hertz", "compact"),
    ] {
        let (_, told) = said(&format!("wrench --speed 1 --spin 1 {arguments}"))?;
        let line = told.lines().find(|line| line.starts_with("tier "));
        let words: Vec<&str> = line.ok_or("no tier")?.split_whitespace().collect();
        assert_eq!(words, ["tier", tier], "{arguments}");
    }
    for (set, words) in [
        ("alpha=0", "table in the program"),
        ("alpha=0.5", "table made at the start"),
        ("alpha=20", "series without a table"),
    ] {
        let (_, told) = said(&format!("explain disk --set {set}"))?;
        assert!(told.contains(words), "{set}: {told}");
    }
    Ok(())
}

#[test]
fn laws_with_a_state_are_refused_with_the_reason() -> Outcome {
    for (law, steady) in [
        ("lugre-bristles", "`lugre`"),
        ("rate-state-slip", "`rate-state`"),
    ] {
        let (code, told) = said(&format!("wrench --speed 1 --spin 1 --law {law}"))?;
        assert_eq!(code, 2, "{told}");
        assert!(
            told.contains("at every point of a patch") && told.contains(steady),
            "{told}"
        );
    }
    Ok(())
}
