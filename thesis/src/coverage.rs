//! What of the thesis has an exhibit, and why the rest has none.

#[cfg(test)]
use super::EXHIBITS;
use tribos_report::page::Appendix;

/// A figure, a table, or a section that states results.
struct Item {
    name: &'static str,
    /// Exhibits that show it, by their names.
    exhibits: &'static [&'static str],
    /// Why nothing is recomputed; empty where an exhibit shows all of it.
    reason: &'static str,
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
const ITEMS: &[Item] = &[
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
    shown("section 4.6.1", &["4.7"]),
    shown("section 4.6.2", &["table-4.1"]),
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

const HEADING: &str = "What of the thesis has no exhibit";
const TEXT: &str = "Figures, tables and sections with results that this report does not recompute, \
     with the reason. All others have an exhibit.";

/// The items without an exhibit, for the end of the report.
pub fn appendix() -> Appendix {
    let missing = ITEMS.iter().filter(|item| item.exhibits.is_empty());
    Appendix {
        heading: HEADING.into(),
        text: TEXT.into(),
        head: ["of the thesis", "reason"].map(String::from),
        rows: missing
            .map(|item| [item.name.into(), item.reason.into()])
            .collect(),
    }
}

/// All items as a page of the book.
#[cfg(test)]
fn book() -> String {
    let mut page = String::from(
        "# The thesis, item by item\n\nEvery figure, table and section with results of *Mesoscopic Aspects of Solid \
         Friction*, in its order, with the\nexhibits of `tribos reproduce` that recompute it, or the reason why there \
         is none. Made from the table that the report uses.\n\n| of the thesis | exhibits | reason |\n|---|---|---|\n",
    );
    for item in ITEMS {
        let exhibits: Vec<String> = item
            .exhibits
            .iter()
            .map(|name| format!("`{name}`"))
            .collect();
        page += &format!(
            "| {} | {} | {} |\n",
            item.name,
            exhibits.join(", "),
            item.reason
        );
    }
    let shown = ITEMS
        .iter()
        .filter(|item| !item.exhibits.is_empty())
        .count();
    page + &format!(
        "\n{} items: {shown} have exhibits, {} have none. The report has {} exhibits.\n",
        ITEMS.len(),
        ITEMS.len() - shown,
        EXHIBITS.len()
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The numbers of the thesis' figures and tables, chapter by chapter.
    const FIGURES: [(u32, u32); 5] = [(1, 1), (2, 8), (3, 19), (4, 7), (5, 2)];
    const TABLES: [&str; 3] = ["3.1", "3.2", "4.1"];
    /// Its sections and appendices that state results or describe what was computed.
    const SECTIONS: &str = "2.1 2.2 2.3.1 2.3.2 3.1 3.2.1 3.2.2 3.2.3 3.2.4 3.2.5 3.3 3.4.1 3.4.2 \
        3.4.3 3.4.4 3.4.5 3.5.1 3.5.2 3.6 4.1 4.2 4.3.1 4.3.2 4.4.1 4.4.2 4.5 4.6.1 4.6.2 4.7 5.1 5.2 5.3";

    #[test]
    fn every_figure_table_and_section_is_there_once() {
        let numbered = FIGURES.iter().flat_map(|&(chapter, last)| {
            (1..=last).map(move |number| format!("figure {chapter}.{number}"))
        });
        let tables = TABLES.iter().map(|name| format!("table {name}"));
        let sections = SECTIONS.split(' ').filter(|name| !name.is_empty());
        let sections = sections.map(|name| format!("section {name}"));
        let appendices = ["appendix A", "appendix B"].map(String::from);
        let mut expected: Vec<String> = numbered
            .chain(tables)
            .chain(sections)
            .chain(appendices)
            .collect();
        let mut given: Vec<String> = ITEMS.iter().map(|item| item.name.to_owned()).collect();
        expected.sort();
        given.sort();
        assert_eq!(given, expected);
    }

    #[test]
    fn every_item_has_exhibits_of_the_report_or_a_reason() {
        for item in ITEMS {
            assert_ne!(
                item.exhibits.is_empty(),
                item.reason.is_empty(),
                "{}",
                item.name
            );
            for name in item.exhibits {
                let mut exhibits = EXHIBITS.iter();
                let is_known = exhibits.any(|(known, _)| known == name);
                assert!(is_known, "{}: {name}", item.name);
            }
        }
    }

    #[test]
    fn every_exhibit_belongs_to_an_item() {
        for (name, _) in EXHIBITS {
            let belongs = ITEMS.iter().any(|item| item.exhibits.contains(name));
            assert!(belongs, "{name}");
        }
    }

    #[test]
    fn the_page_of_the_book_is_what_the_table_says() {
        let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../docs/exhibits.md");
        if std::env::var_os("TRIBOS_WRITE_EXHIBITS").is_some() {
            std::fs::write(path, book()).unwrap();
        }
        let page = std::fs::read_to_string(path).unwrap_or_default();
        assert!(
            page == book(),
            "run this test with TRIBOS_WRITE_EXHIBITS=1 to write {path}"
        );
    }
}
