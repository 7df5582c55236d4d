//! Each item of the thesis has its exhibits or a reason, and the book says so.

use tribos_thesis::EXHIBITS;
use tribos_thesis::coverage::ITEMS;

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

/// All items as a page of the book.
fn book() -> String {
    let mut page = String::from(
        "# The thesis, item by item\n\nEvery figure, table and section with results of *Mesoscopic Aspects of Solid \
         Friction*, in its order, with the\nexhibits of `tribos reproduce` that recompute it, or the reason why there \
         is none. Made from the table that the report uses. In a clone, `cargo install --path thesis` installs the \
         command.\n\n```sh\ntribos reproduce --list\ntribos reproduce --out out/thesis 3.4 table-3.1\n\
         tribos reproduce --quick --out out/sections section-2.1 section-2.3\n```\n\nIt leaves `index.html`, a page \
         a chapter, `claims.csv` and the figures, and ends with exit code 1 if a comparison fails for no known reason.\n\n| of the thesis | exhibits | reason |\n|---|---|---|\n",
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
