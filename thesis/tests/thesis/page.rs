//! What the page says around its rows, and of the time that it takes.

use std::time::Duration;
use tribos_report::claim::{Claim, Statement};
use tribos_report::page::Section;
use tribos_report::verdict::Allowance;
use tribos_thesis::Effort;
use tribos_thesis::document::claims_csv;
use tribos_thesis::front::lead;
use tribos_thesis::plan::{cores, left, told};

#[test]
fn every_statement_is_counted_once() {
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
    let text = lead(&[section], Effort::Quick).concat();
    let words = "4 statements of the thesis in 6 rows: 2 numbers reproduced, 0 trends reproduced, \
        1 that differ for a reason that is shown, 0 that differ, 0 errors of the thesis, 0 undecided, 0 without a \
        number that are checked against something else, 0 definitions, 1 that cannot be checked. This is a part";
    assert!(text.starts_with(words), "{text}");
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
    let line = text.lines().nth(2);
    let expected = "\"figure-1.\",\"1\",\"run tribos\",\"\",\"\",\"\",\"not checkable\",\"a \"\"b\"\"\",,,,,,,,,\"\"";
    assert_eq!(line, Some(expected));
}

#[test]
fn numbers_of_a_row_are_numbers_in_the_table() {
    let statement = Statement::parse("(4.6.1): E₀ — open");
    let allowance = Allowance::StatedError(2.0, "4.6.1".into());
    let claim =
        Claim::stated(statement, ("≈ 54 %", 54.0), 55.5, allowance).apart(1.5, [1.5, 2.0], 5);
    let section = Section {
        claims: vec![claim],
        made: "`tribos reproduce --out DIR 4.7`".into(),
        ..Section::default()
    };
    let text = claims_csv(&[section]);
    let lines: Vec<&str> = text.lines().collect();
    assert!(lines[0].starts_with("# tribos ") && lines[1].ends_with(",z,samples,made"));
    let numbers = ",54,55.5,1.5,2,1.5,2,0.6,5,\"tribos reproduce --out DIR 4.7\"";
    assert!(lines[2].ends_with(numbers), "{}", lines[2]);
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

#[test]
fn the_benchmarks_tables_are_those_of_the_book() {
    for (name, kept) in tribos_thesis::fronts::KEPT {
        let root = concat!(env!("CARGO_MANIFEST_DIR"), "/..");
        let path = format!("{root}/docs/fronts/{name}");
        let book = std::fs::read_to_string(&path).unwrap_or_default();
        if std::env::var_os("TRIBOS_WRITE_EXHIBITS").is_some() {
            std::fs::write(format!("{root}/thesis/src/fronts/{name}"), &book).unwrap();
        }
        assert!(
            kept == book,
            "run this test with TRIBOS_WRITE_EXHIBITS=1 to copy {path}"
        );
    }
}
