//! What the page says around its rows, and of the time that it takes.

use std::time::Duration;
use tribos_report::claim::{Claim, Statement};
use tribos_report::page::Section;
use tribos_report::verdict::Allowance;
use tribos_thesis::document::{claims_csv, lead};
use tribos_thesis::plan::{cores, left, told};

#[test]
fn the_first_sentence_counts_every_row_once() {
    let statement = || Statement::parse("(1): a — order");
    let stated = |allowance| Claim::stated(statement(), ("0.5", 0.5), 0.5, allowance);
    let claims = vec![
        stated(Allowance::Exact(0.0)),
        stated(Allowance::Digits(0.05)),
        Claim::trend(statement(), "", true),
        Claim::own_statement(statement(), "", true),
        Claim::not_checkable(statement()),
    ];
    let section = Section {
        claims,
        ..Section::default()
    };
    let text = lead(&[section]);
    assert!(
        text.starts_with("Of 5 rows, 2 reproduce a number"),
        "{text}"
    );
    assert!(text.contains("(1 of them exact values and closed forms, 1 with an error)"));
    assert!(text.contains("The other 2 compare nothing") && !text.contains("failed"));
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
    let expected =
        "\"figure-1\",\"1\",\"run tribos\",\"\",\"\",\"\",\"\",\"not checkable\",\"a \"\"b\"\"\"";
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
