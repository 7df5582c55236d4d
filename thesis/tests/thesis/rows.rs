//! Every row of the exhibits that need no simulation.

use crate::Outcome;
use std::sync::OnceLock;
use tribos_report::claim::Claim;
use tribos_report::verdict::{Agreement, Verdict};
use tribos_thesis::EXHIBITS;
use tribos_thesis::Maker::{Alone, Checked};
use tribos_thesis::exhibit::Exhibit;
use tribos_thesis::text::Text;

/// Rows with the names of their exhibits, and texts in which a placeholder is left.
#[derive(Default)]
struct ExhibitRows {
    rows: Vec<(&'static str, Claim)>,
    unfilled: Vec<(&'static str, String)>,
}

/// All exhibits that are made in a moment; made once for all tests.
fn made() -> Result<&'static ExhibitRows, &'static str> {
    static MADE: OnceLock<Result<ExhibitRows, String>> = OnceLock::new();
    let make = || {
        let mut all = ExhibitRows::default();
        for (name, maker) in EXHIBITS {
            if let Alone(make) | Checked(make, _) = maker {
                let exhibit = make().map_err(|failure| failure.to_string())?;
                all.unfilled
                    .extend(exhibit.unfilled().map(|text| (*name, text)));
                let claims = exhibit.claims.into_iter();
                all.rows.extend(claims.map(|claim| (*name, claim)));
            }
        }
        Ok(all)
    };
    MADE.get_or_init(make).as_ref().map_err(String::as_str)
}

/// All their rows.
fn rows() -> Result<&'static [(&'static str, Claim)], &'static str> {
    Ok(&made()?.rows)
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

/// The sources of the exhibits and the Markdown beside them, by file name.
fn files(ending: &str) -> std::io::Result<Vec<(String, String)>> {
    let mut found = Vec::new();
    let all = concat!(env!("CARGO_MANIFEST_DIR"), "/src/exhibits");
    for folder in [
        all.to_owned(),
        format!("{all}/choices"),
        format!("{all}/outlook"),
        format!("{all}/porosity"),
    ] {
        for entry in std::fs::read_dir(folder)? {
            let path = entry?.path();
            if path.extension().is_some_and(|name| name == ending) {
                let name = path.file_name().unwrap_or_default().to_string_lossy();
                found.push((name.into_owned(), std::fs::read_to_string(&path)?));
            }
        }
    }
    Ok(found)
}

/// What stands between two marks, each time.
fn between<'a>(text: &'a str, open: &'a str, close: char) -> impl Iterator<Item = &'a str> {
    let parts = text.split(open).skip(1);
    parts.filter_map(move |part| part.split_once(close).map(|(inside, _)| inside))
}

/// Of both efforts: those that need simulations are read, not run.
#[test]
fn every_text_is_shown_and_every_placeholder_filled() -> Outcome {
    let (sources, texts) = (files("rs")?, files("md")?);
    assert_eq!(texts.len(), EXHIBITS.len());
    let code = sources.into_iter().map(|(_, source)| source);
    let code: String = code.collect::<String>().split_whitespace().collect();
    let mut known = Vec::new();
    for (file, markdown) in texts {
        assert!(
            code.contains(&format!("Text(include_str!(\"{file}\"))")),
            "{file}"
        );
        let text = Text(Box::leak(markdown.into_boxed_str()));
        let prose = text.prose();
        assert!(
            !prose.heading.is_empty() && !prose.caption.is_empty(),
            "{file}"
        );
        for (id, statement) in text.statements() {
            assert!(
                code.contains(&format!("\"{id}\"")),
                "{file}: {id} is not used"
            );
            assert!(!statement.text.is_empty(), "{file}: {id} is empty");
            known.push(id);
        }
        for name in between(text.0, "{", '}') {
            let filled = format!("with(\"{name}\",");
            assert!(code.contains(&filled), "{file}: {{{name}}} is not filled");
        }
    }
    for id in between(&code, "said(\"", '"') {
        assert!(known.iter().any(|known| known == id), "no text for {id}");
    }
    Ok(())
}

#[test]
fn no_placeholder_is_left_in_what_needs_no_simulation() -> Outcome {
    assert_eq!(made()?.unfilled, []);
    Ok(())
}

#[test]
fn an_unknown_statement_or_an_unfilled_placeholder_is_found() {
    let text = Text(
        "# A\n\nB {b}\nc.\n\n## Caption\n\nD.\n\n## Claims\n\n- e (1.2): F {f} — g\n  {f}\n- h: I\n",
    );
    let exhibit = |prose, statement| {
        let figure = tribos_report::figure::Figure::new(
            "",
            tribos_report::figure::Axis::linear(""),
            tribos_report::figure::Axis::linear(""),
        );
        let claims = vec![Claim::trend(statement, "", true)];
        Exhibit::new(prose, figure, &[], Vec::new(), claims).unfilled()
    };
    let filled = || text.prose().with("b", 1);
    let statement = text.said("e").with("f", 2);
    let words = [&statement.place, &statement.text, &statement.basis];
    assert_eq!(words, ["1.2", "F 2", "g 2"]);
    assert_eq!(filled().paragraphs, ["B 1 c."]);
    assert_eq!([filled().heading, filled().caption], ["A", "D."]);
    assert_eq!(exhibit(filled(), statement.clone()), None);
    assert_eq!(exhibit(text.prose(), statement), Some("B {b} c.".into()));
    assert_eq!(exhibit(filled(), text.said("e")), Some("F {f}".into()));
    assert_eq!(
        exhibit(filled(), text.said("x")),
        Some("{no statement x}".into())
    );
    assert_eq!(text.statements()[1].0, "h");
}
