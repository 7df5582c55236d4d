//! What of the thesis has an exhibit, and why the rest has none.

use super::document::TEXT;
use tribos_report::page::Table;

/// A figure, a table, or a section that states results.
#[derive(Debug)]
pub struct Item {
    pub name: &'static str,
    /// Exhibits that show it, by their names.
    pub exhibits: &'static [&'static str],
    /// Why nothing is recomputed; empty where an exhibit shows all of it.
    pub reason: &'static str,
}

/// Shown by exhibits.
const fn shown(name: &'static str, exhibits: &'static [&'static str]) -> Item {
    let reason = "";
    Item {
        name,
        exhibits,
        reason,
    }
}

/// Without an exhibit.
const fn without(name: &'static str, reason: &'static str) -> Item {
    let exhibits = &[];
    Item {
        name,
        exhibits,
        reason,
    }
}

/// Every figure, table and section with results, in the order of the thesis.
pub const ITEMS: &[Item] = &[
    without("figure 1.1", "a drawing of length scales"),
    without(
        "figure 2.1",
        "a portrait, and sketches of Leonardo's experiments without numbers",
    ),
    without(
        "figure 2.2",
        "a sketch of the inclined plane and of Euler's interlocking asperities",
    ),
    without(
        "figure 2.3",
        "a portrait, and sketches of Euler's model without numbers",
    ),
    without(
        "figure 2.4",
        "a portrait, and Coulomb's drawings of rough surfaces",
    ),
    shown("figure 2.5", &["2.5"]),
    without("figure 2.6", "a drawing of apparent and real contact"),
    shown("figure 2.7", &["2.7"]),
    shown("figure 2.8", &["2.8"]),
    shown("section 2.1", &["section-2.1", "2.5"]),
    shown("section 2.2", &["2.5"]),
    shown("section 2.3.1", &["2.7", "section-2.3"]),
    shown("section 2.3.2", &["2.8"]),
    shown("figure 3.1", &["3.1"]),
    without("figure 3.2", "a drawing of the disk with its variables"),
    shown("figure 3.3", &["3.3"]),
    shown("figure 3.4", &["3.4"]),
    without(
        "figure 3.5",
        "photographs, and Farkas' measured points, which are not published as numbers; the curves \
         under them are those of figure 3.4",
    ),
    shown("table 3.1", &["table-3.1"]),
    shown("figure 3.6", &["3.6"]),
    shown("figure 3.7", &["3.7"]),
    shown("figure 3.8", &["3.8"]),
    shown("figure 3.9", &["3.9"]),
    shown("table 3.2", &["table-3.2"]),
    shown("figure 3.10", &["3.10"]),
    shown("figure 3.11", &["3.11"]),
    without(
        "figure 3.12",
        "a drawing of the double disk; its motion is figure 3.13",
    ),
    shown("figure 3.13", &["3.13"]),
    without(
        "figure 3.14",
        "a drawing of the cylinder's path; its friction is figure 3.16",
    ),
    without(
        "figure 3.15",
        "a drawing of the pressure under the cylinder; its friction is figure 3.16",
    ),
    shown("figure 3.16", &["3.16"]),
    shown("figure 3.17", &["3.17"]),
    without(
        "figure 3.18",
        "a drawing and a photograph of a curling rock",
    ),
    shown("figure 3.19", &["3.19"]),
    shown(
        "section 3.1",
        &[
            "3.1",
            "section-3.1",
            "section-3.1-board",
            "section-3.1-inverse",
            "3.6",
            "3.11",
        ],
    ),
    shown("section 3.2.1", &["3.3"]),
    shown("section 3.2.2", &["3.4"]),
    shown("section 3.2.3", &["appendix-a"]),
    shown("section 3.2.4", &["3.4"]),
    shown("section 3.2.5", &["3.4"]),
    shown("section 3.3", &["table-3.1"]),
    shown("section 3.4.1", &["3.11"]),
    shown("section 3.4.2", &["3.6"]),
    shown("section 3.4.3", &["3.7"]),
    shown("section 3.4.4", &["3.8", "3.9", "table-3.2", "3.10"]),
    shown("section 3.4.5", &["3.11", "3.13", "section-3.1-inverse"]),
    shown("section 3.5.1", &["3.16", "3.17"]),
    shown(
        "section 3.5.2",
        &["3.19", "section-3.5.2", "section-5.1-modes"],
    ),
    shown("section 3.6", &["section-5.1", "section-5.1-lateral"]),
    without("figure 4.1", "a photograph of powders"),
    shown("figure 4.2", &["4.2"]),
    shown("figure 4.3", &["4.3"]),
    without("figure 4.4", "a drawing of a sinter neck"),
    shown("figure 4.5", &["4.5"]),
    shown("figure 4.6", &["4.6"]),
    shown("figure 4.7", &["4.7"]),
    shown("table 4.1", &["table-4.1"]),
    shown("section 4.1", &["section-4.1"]),
    shown("section 4.2", &["section-4.2", "4.6"]),
    shown("section 4.3.1", &["4.2"]),
    shown("section 4.3.2", &["4.3"]),
    shown("section 4.4.1", &["section-4.4.1"]),
    shown("section 4.4.2", &["section-4.4.2"]),
    shown("section 4.5", &["4.5"]),
    shown("section 4.6.1", &["4.7", "section-4.6-choices"]),
    shown("section 4.6.2", &["table-4.1", "section-4.6-choices"]),
    shown("section 4.7", &["4.5", "4.7"]),
    shown(
        "section 5.1",
        &["section-5.1", "section-5.1-modes", "section-5.1-lateral"],
    ),
    shown("section 5.2", &["section-5.2"]),
    shown("figure 5.1", &["5.1"]),
    shown("figure 5.2", &["5.2"]),
    shown(
        "section 5.3",
        &[
            "5.1",
            "5.2",
            "section-5.3",
            "section-5.3-map",
            "section-5.3-metals",
        ],
    ),
    shown("appendix A", &["appendix-a"]),
    shown("appendix B", &["appendix-b", "4.6", "5.2"]),
];

/// The items without an exhibit, for the end of the report.
pub fn left_out() -> Table {
    let missing = ITEMS.iter().filter(|item| item.exhibits.is_empty());
    Table {
        id: "left-out".into(),
        heading: "What of the thesis has no exhibit".into(),
        text: TEXT.part("Left out"),
        head: ["of the thesis", "reason"].map(String::from).into(),
        rows: missing
            .map(|item| vec![item.name.into(), item.reason.into()])
            .collect(),
    }
}
