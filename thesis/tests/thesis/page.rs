//! What the page says around its rows, and of the time that it takes.

use std::time::Duration;
use tribos_report::claim::{Claim, Statement};
use tribos_report::page::Section;
use tribos_report::verdict::Allowance;
use tribos_thesis::document::{claims_csv, lead};
use tribos_thesis::plan::{cores, left, told};

#[test]
fn the_first_sentence_counts_every_statement_once_and_its_rows_in_brackets() {
    let named = |id: &str, words: &str| Statement {
        id: id.into(),
        ..Statement::parse(words)
    };
    let stated = |words, allowance| Claim::stated(named("n", words), ("0.5", 0.5), 0.5, allowance);
    let claims = vec![
        stated("(1): a", Allowance::Exact(0.0)),
        stated("(2): a", Allowance::Digits(0.05)),
        stated("(2): a again", Allowance::Digits(0.05)),
        // One statement, of which a model misses what another has.
        Claim::trend(named("m", "(1): one — order"), "", true),
        Claim::contradiction(named("m", "(1): two — its formula"), "", true),
        Claim::own_statement(Statement::parse("ours — brute force"), "", true),
        Claim::not_checkable(Statement::parse("(1): b — no number")),
    ];
    let section = Section {
        claims,
        ..Section::default()
    };
    let text = lead(&[section]);
    assert!(
        text.starts_with(
            "Of 4 distinct statements of the thesis [6 rows], 2 [3] reproduce a number"
        ),
        "{text}"
    );
    assert!(text.contains("(1 of them exact values and closed forms, 1 with an error)"));
    assert!(
        text.contains("0 [1] reproduce a trend")
            && text.contains("1 [1] differ for a reason that is shown")
    );
    assert!(text.contains("1 [1] cannot be checked") && text.contains("have 1 more rows"));
    assert!(!text.contains('{') && !text.contains("failed"));
}

#[test]
fn claims_are_a_table_without_backticks() {
    let section = Section {
        id: "figure-1".into(),
        claims: vec![Claim::not_checkable(Statement::parse(
            "(1): run `tribos` — a \"b\"",
        ))],
        ..Section::default()
    };
    let text = claims_csv(&[section]);
    let line = text.lines().nth(1);
    let expected = "\"figure-1\",\"\",\"1\",\"run tribos\",\"\",\"\",\"\",\"\",\"\",\"not checkable\",\"a \"\"b\"\"\"";
    assert_eq!(line, Some(expected));
}

#[test]
fn what_is_left_follows_the_pace() {
    // A fifth of the work took 20 s.
    assert_eq!(left(100.0, 20.0, 20.0), Duration::from_secs(80));
    assert_eq!(left(100.0, 100.0, 50.0), Duration::ZERO);
    // Too little to tell a pace from.
    let first = left(100.0, 1.0, 50.0).as_secs_f64();
    assert!((first - 99.0 / cores()).abs() <= 0.5, "{first}");
}

#[test]
fn times_are_told_as_a_person_would() {
    let cases = [
        (0, "0 s"),
        (99, "99 s"),
        (130, "2 min"),
        (12_000, "3 h 20 min"),
    ];
    for (seconds, text) in cases {
        assert_eq!(told(Duration::from_secs(seconds)), text);
    }
}
