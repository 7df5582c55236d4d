//! What the report is written as: its page, the claims as a table, lines for the terminal.

use super::coverage;
use super::effort::Effort;
use super::text::{Prose, Text};
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
    let mut text =
        String::from("exhibit,place,claim,thesis,ours,uncertainty,difference,verdict,evidence\n");
    for section in sections {
        for claim in &section.claims {
            let fields = [
                &section.id,
                &claim.place,
                &claim.statement,
                &claim.thesis,
                &claim.ours,
                &claim.uncertainty,
                &claim.difference,
                claim.verdict.name(),
                &claim.verdict.evidence(),
            ];
            text += &fields.map(quoted).join(",");
            text.push('\n');
        }
    }
    text
}

/// The sentence that a reader takes away.
pub fn lead(sections: &[Section]) -> String {
    let claims = || sections.iter().flat_map(|section| &section.claims);
    let all = counts(claims());
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
    ] = all.0;
    let random = |claim: &&Claim| match &claim.verdict {
        Verdict::Reproduced(agreement) => !agreement.allowance().is_exact(),
        _ => false,
    };
    let measured = claims().filter(random).count();
    let failures = match failed {
        0 => String::new(),
        n => format!(" {n} comparisons failed."),
    };
    let values: [(&str, &dyn Display); 13] = [
        ("rows", &all.total()),
        ("reproduced", &reproduced),
        ("exact", &(reproduced - measured)),
        ("measured", &measured),
        ("trend", &trend),
        ("differs", &differs),
        ("known", &known),
        ("error", &error),
        ("failures", &failures),
        ("others", &(ours + definition + unchecked)),
        ("ours", &ours),
        ("definition", &definition),
        ("unchecked", &unchecked),
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
