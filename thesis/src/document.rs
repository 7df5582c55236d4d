//! What the report is written as: its pages, the claims as a table, lines for the terminal.

use super::coverage;
use super::effort::Effort;
use super::front;
use super::fronts;
use super::provenance;
use super::text::Text;
use std::collections::BTreeMap;
use std::time::Duration;
use tribos_report::claim::Claim;
use tribos_report::page::{Chapter, Section, Site, Table};
use tribos_report::verdict::{Counts, Verdict};

pub(super) const TEXT: Text = Text(include_str!("page.md"));

/// The verdicts of some claims.
pub fn counts<'a>(claims: impl IntoIterator<Item = &'a Claim>) -> Counts {
    Counts::of(claims.into_iter().map(|claim| &claim.verdict))
}

/// All claims as CSV text: what the page shows, the numbers alone, and how they were made.
pub fn claims_csv(sections: &[Section]) -> String {
    let quoted = |text: &str| format!("\"{}\"", text.replace('"', "\"\"").replace('`', ""));
    let number = |value: Option<f64>| value.map(|x| x.to_string()).unwrap_or_default();
    let mut text = format!(
        "# {}; numbers in the unit that the claim names\n\
         row,place,claim,thesis,ours,uncertainty,verdict,evidence,thesis_value,our_value,difference,allowance,\
         our_sigma,thesis_sigma,z,samples,made\n",
        provenance::program()
    );
    for section in sections {
        for (row, claim) in section.rows() {
            let numbers = &claim.numbers;
            let [our_sigma, thesis_sigma] =
                [0, 1].map(|whose| numbers.sigma.map(|both| both[whose]));
            let values = [
                numbers.thesis,
                numbers.ours,
                numbers.difference,
                numbers.allowance,
                our_sigma,
                thesis_sigma,
                numbers.z(),
            ];
            let samples = numbers.samples.map(|n| n.to_string()).unwrap_or_default();
            let words = [
                &row,
                &claim.place,
                &claim.statement,
                &claim.thesis,
                &claim.ours,
                &claim.uncertainty,
                claim.verdict.name(),
                &claim.verdict.evidence(),
            ]
            .map(quoted);
            let values = values.map(number);
            text += &[&words[..], &values, &[samples, quoted(&section.made)]]
                .concat()
                .join(",");
            text.push('\n');
        }
    }
    text
}

/// Verdicts on the distinct statements of the thesis. Rows of one section with one name and place make
/// one statement, for several models or parameters; it counts as the least favourable of them.
pub(super) fn statements(sections: &[Section]) -> Vec<&Verdict> {
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
pub(super) fn of_the_thesis(section: &Section) -> impl Iterator<Item = &Claim> {
    section
        .claims
        .iter()
        .filter(|claim| !claim.place.is_empty())
}

/// All pages; `wall` is what they took.
pub fn site(sections: Vec<Section>, effort: Effort, wall: Duration) -> anyhow::Result<Site> {
    let prose = TEXT.prose();
    let verdicts = Counts::of(statements(&sections));
    let [speed, modes] = fronts::tables();
    Ok(Site {
        title: prose.heading,
        lead: front::lead(&sections, effort),
        counted: ("statements of the thesis".into(), verdicts),
        pictures: front::pictures(&sections)?,
        tables: [
            front::open(&sections),
            speed,
            modes,
            Table {
                id: "how-to-read".into(),
                heading: "How to read the rows".into(),
                text: prose.paragraphs,
                ..Table::default()
            },
            provenance::table(effort, wall),
            coverage::left_out(),
        ]
        .into(),
        chapters: chapters(sections),
    })
}

/// The digit of a chapter in the name of a section or a heading; none in those of the appendices.
pub(super) fn digit(name: &str) -> Option<char> {
    name.chars().find(char::is_ascii_digit)
}

/// The page of the chapter to which a section belongs.
pub(super) fn file(section: &str) -> String {
    match digit(section) {
        Some(digit) => format!("chapter-{digit}.html"),
        None => "appendices.html".into(),
    }
}

/// Sections by chapter.
fn chapters(sections: Vec<Section>) -> Vec<Chapter> {
    let chapters = TEXT.items("Chapters").into_iter().map(|heading| Chapter {
        file: file(&heading),
        sections: sections
            .iter()
            .filter(|section| digit(&section.id) == digit(&heading))
            .cloned()
            .collect(),
        heading,
    });
    chapters
        .filter(|chapter| !chapter.sections.is_empty())
        .collect()
}
