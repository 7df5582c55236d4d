//! What the report is written as: its page, the claims as a table, lines for the terminal.

use super::coverage;
use super::effort::Effort;
use super::text::{Prose, Text};
use std::collections::BTreeMap;
use std::fmt::Display;
use tribos_report::claim::Claim;
use tribos_report::page::{Page, Section};
use tribos_report::verdict::{Counts, Verdict};

const TEXT: Text = Text(include_str!("page.md"));

/// The verdicts of some claims.
pub fn counts<'a>(claims: impl IntoIterator<Item = &'a Claim>) -> Counts {
    Counts::of(claims.into_iter().map(|claim| &claim.verdict))
}

/// All claims as CSV text.
pub fn claims_csv(sections: &[Section]) -> String {
    let quoted = |text: &str| format!("\"{}\"", text.replace('"', "\"\"").replace('`', ""));
    let mut text = String::from(
        "exhibit,id,place,claim,thesis,ours,uncertainty,difference,z,verdict,evidence\n",
    );
    for section in sections {
        for claim in &section.claims {
            let fields = [
                &section.id,
                &claim.id,
                &claim.place,
                &claim.statement,
                &claim.thesis,
                &claim.ours,
                &claim.uncertainty,
                &claim.difference,
                &claim.z,
                claim.verdict.name(),
                &claim.verdict.evidence(),
            ];
            text += &fields.map(quoted).join(",");
            text.push('\n');
        }
    }
    text
}

/// Verdicts on the distinct statements of the thesis. Rows of one section with one name and place make
/// one statement, for several models or parameters; it counts as the least favourable of them.
fn statements(sections: &[Section]) -> Vec<&Verdict> {
    let mut all: BTreeMap<[&str; 3], &Verdict> = BTreeMap::new();
    for section in sections {
        for claim in of_the_thesis(section) {
            let name = match claim.id.as_str() {
                "" => &claim.statement,
                id => id,
            };
            let key = [section.id.as_str(), &claim.place, name];
            let worst = all.entry(key).or_insert(&claim.verdict);
            if claim.verdict.kind() > worst.kind() {
                *worst = &claim.verdict;
            }
        }
    }
    all.into_values().collect()
}

/// Rows that have a place in the thesis; the others are statements of ours.
fn of_the_thesis(section: &Section) -> impl Iterator<Item = &Claim> {
    section
        .claims
        .iter()
        .filter(|claim| !claim.place.is_empty())
}

/// The sentence that a reader takes away.
pub fn lead(sections: &[Section]) -> String {
    let statements = statements(sections);
    let rows = counts(sections.iter().flat_map(of_the_thesis));
    let distinct = Counts::of(statements.iter().copied());
    // Statements, and their rows in brackets.
    let both = |kind: usize| format!("{} [{}]", distinct.0[kind], rows.0[kind]);
    let exact = |verdict: &&&Verdict| match verdict {
        Verdict::Reproduced(agreement) => agreement.allowance().is_exact(),
        _ => false,
    };
    let exact = statements.iter().filter(exact).count();
    let [
        reproduced,
        trend,
        ours,
        definition,
        known,
        differs,
        error,
        unchecked,
        failed,
    ] = std::array::from_fn(both);
    let failures = match rows.0[Verdict::Failed.kind()] {
        0 => String::new(),
        _ => format!(" {failed} comparisons failed."),
    };
    let own = sections.iter().map(|section| section.claims.len());
    let own = own.sum::<usize>() - rows.total();
    let values: [(&str, &dyn Display); 14] = [
        ("statements", &distinct.total()),
        ("rows", &rows.total()),
        ("reproduced", &reproduced),
        ("exact", &exact),
        ("measured", &(distinct.0[0] - exact)),
        ("trend", &trend),
        ("differs", &differs),
        ("known", &known),
        ("error", &error),
        ("failures", &failures),
        ("ours", &ours),
        ("definition", &definition),
        ("unchecked", &unchecked),
        ("own", &own),
    ];
    let text = TEXT.part("Lead").concat();
    values.into_iter().fold(text, |text, (name, value)| {
        text.replace(&format!("{{{name}}}"), &value.to_string())
    })
}

/// The whole page.
pub fn page(sections: Vec<Section>, effort: Effort) -> Page {
    let Prose {
        heading,
        paragraphs,
        ..
    } = TEXT.prose();
    Page {
        title: heading,
        lead: lead(&sections),
        intro: paragraphs,
        environment: environment(effort),
        sections,
        appendix: Some(coverage::appendix()),
    }
}

/// Program, effort and how to get more.
fn environment(effort: Effort) -> String {
    let version = env!("CARGO_PKG_VERSION");
    let part = match effort {
        Effort::Quick => "Quick",
        Effort::Full => "Full",
    };
    let made = TEXT.part(part).concat();
    format!("tribos {version}, exact tier in f64. {made}")
}
