//! Every row of the exhibits that need no simulation.

use super::*;
use anyhow::Result;
use std::sync::OnceLock;
use tribos_report::claim::Claim;
use tribos_report::verdict::Agreement;

type Outcome = Result<(), Box<dyn std::error::Error>>;

/// Rows with the names of their exhibits.
type Rows = Vec<(&'static str, Claim)>;

/// All rows of the exhibits that are made in a moment; made once for all tests.
fn rows() -> Result<&'static Rows, &'static str> {
    static ROWS: OnceLock<Result<Rows, String>> = OnceLock::new();
    let make = || {
        let mut rows = Vec::new();
        for (name, maker) in EXHIBITS {
            if let Alone(make) = maker {
                let claims = make().map_err(|failure| failure.to_string())?.claims;
                rows.extend(claims.into_iter().map(|claim| (*name, claim)));
            }
        }
        Ok(rows)
    };
    ROWS.get_or_init(make).as_ref().map_err(String::as_str)
}

/// The evidence of a row that counts as reproduced.
fn agreement(claim: &Claim) -> Option<&Agreement> {
    match &claim.verdict {
        Verdict::Reproduced(agreement) => Some(agreement),
        _ => None,
    }
}

/// A number, a closed form or an interval, without words.
fn is_number(text: &str) -> bool {
    let words = text.split(|c: char| !c.is_ascii_alphabetic());
    text.chars().any(|c| c.is_ascii_digit() || "π∞".contains(c))
        && words.into_iter().all(|word| word.len() < 3)
}

#[test]
fn a_row_is_reproduced_only_beside_a_number_and_within_its_allowance() -> Outcome {
    let mut reproduced = 0;
    for (name, claim) in rows()? {
        let what = format!("{name}: {}", claim.statement);
        assert!(
            claim.thesis.is_empty() || is_number(&claim.thesis),
            "{what}"
        );
        let Some(agreement) = agreement(claim) else {
            continue;
        };
        reproduced += 1;
        assert!(
            !claim.thesis.is_empty() && !claim.place.is_empty(),
            "{what}"
        );
        let [thesis, ours] = agreement.numbers();
        let size = agreement.allowance().size();
        assert!((ours - thesis).abs() <= size, "{what}");
        assert!(size <= 0.3 * thesis.abs().max(1e-3), "{what}: ± {size}");
    }
    assert!(reproduced > 30, "{reproduced}");
    Ok(())
}

#[test]
fn a_perturbed_number_is_not_reproduced() -> Outcome {
    for (name, claim) in rows()? {
        let Some(agreement) = agreement(claim) else {
            continue;
        };
        let [thesis, _] = agreement.numbers();
        let size = agreement.allowance().size();
        let step = 1.01 * size + 1e-12 * thesis.abs().max(1e-3);
        for ours in [thesis - step, thesis + step, f64::NAN] {
            let changed = agreement.with(ours);
            assert_eq!(changed, None, "{name}: {}, {ours}", claim.statement);
        }
    }
    Ok(())
}

#[test]
fn no_comparison_fails_and_no_number_is_long() -> Outcome {
    for (name, claim) in rows()? {
        let what = format!("{name}: {}", claim.statement);
        assert_ne!(claim.verdict, Verdict::Failed, "{what}");
        assert!(!claim.verdict.evidence().is_empty(), "{what}");
        for text in [&claim.ours, &claim.thesis, &claim.uncertainty] {
            let digits = text.split(|c: char| !c.is_ascii_digit() && c != '.');
            let long = digits.map(|run| run.trim_start_matches(['0', '.']));
            let longest = long.map(|run| run.matches(char::is_numeric).count()).max();
            assert!(longest <= Some(6), "{what}: {text}");
        }
    }
    Ok(())
}
