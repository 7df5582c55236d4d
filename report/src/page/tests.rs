use super::*;
use crate::claim::{Claim, Statement};
use crate::verdict::Allowance;

// A report with one claim of most verdicts.
fn site() -> Site {
    let stated = |ours| {
        let allowance = Allowance::Digits(0.5);
        let statement = Statement::parse("(eq. 1 & 2): a < b");
        Claim::stated(statement, ("1", 1.0), ours, allowance)
    };
    let claims = vec![
        stated(1.1),
        stated(0.9).uncertain("± <0.1>"),
        Claim::refutation(
            Statement::parse("(1): run `a < b` — sign of <b> & \"c\""),
            "2",
            true,
        ),
        Claim::contradiction(Statement::parse("(1): a — range of <cohesion>"), "2", true),
        Claim::not_checkable(Statement::parse("(1): a — no numbers")),
    ];
    let section = Section {
        id: "fig 1".to_owned(),
        heading: "Figure \"1\"".to_owned(),
        made: "`run <1>`".to_owned(),
        text: vec!["<script>alert(1)</script>".to_owned()],
        figure: Some(FigureRef {
            svg: "<svg><circle/></svg>".to_owned(),
            files: vec!["fig 1.csv".to_owned(), "a/fig1.png".to_owned()],
            caption: "ε > 0, `a`".to_owned(),
        }),
        film: None,
        claims,
    };
    Site {
        title: "Report <1>".to_owned(),
        lead: vec!["**2** of `5` <rows>".to_owned()],
        counted: (
            "statements".to_owned(),
            Counts::of(section.claims.iter().map(|claim| &claim.verdict)),
        ),
        pictures: vec![Picture {
            svg: "<svg><path/></svg>".to_owned(),
            caption: "ours & [theirs](chapter-1.html#fig-1)".to_owned(),
        }],
        tables: vec![Table {
            id: "left out".to_owned(),
            heading: "Left out & why".to_owned(),
            text: vec!["All <others> are shown.".to_owned()],
            head: vec!["what".to_owned(), "why".to_owned()],
            rows: vec![vec!["figure 1".to_owned(), "a `drawing` <b>".to_owned()]],
        }],
        chapters: vec![
            Chapter {
                file: "chapter-1.html".to_owned(),
                heading: "Chapter 1".to_owned(),
                sections: vec![section],
            },
            Chapter {
                file: "chapter-2.html".to_owned(),
                heading: "Chapter 2".to_owned(),
                ..Chapter::default()
            },
        ],
    }
}

// All pages, the front page last.
fn html(site: &Site) -> String {
    site.pages().into_iter().map(|(_, page)| page).collect()
}

#[test]
fn every_text_is_escaped() {
    let html = html(&site());
    for text in [
        "Report &lt;1&gt;",
        "<li><b>2</b> of <code>5</code> &lt;rows&gt;</li>",
        "<code>run &lt;1&gt;</code>",
        "ours &amp; <a href=\"chapter-1.html#fig-1\">theirs</a>",
        "Figure &quot;1&quot;",
        "&lt;script&gt;",
        "a &lt; b",
        "eq. 1 &amp; 2",
        "± &lt;0.1&gt;",
        "sign of &lt;b&gt; &amp; &quot;c&quot;",
        "differs, cause known</span><br>range of &lt;cohesion&gt;",
        "ε &gt; 0",
    ] {
        assert!(html.contains(text), "{text}");
    }
    assert!(!html.contains("<script>") && !html.contains("of <b>"));
}

#[test]
fn tables_stand_on_the_front_page_which_is_the_last() {
    let site = site();
    let pages = site.pages();
    let names: Vec<&str> = pages.iter().map(|(name, _)| *name).collect();
    assert_eq!(names, ["chapter-1.html", "chapter-2.html", "index.html"]);
    let row = "<tr><td>figure 1</td><td>a <code>drawing</code> &lt;b&gt;</td></tr>";
    let front = &pages[2].1;
    assert!(front.contains("<th>what</th><th>why</th>") && front.contains(row));
    assert!(front.contains("<section id=\"left-out\">"));
    // A chapter leads to the others.
    assert!(
        pages[0]
            .1
            .contains("<a href=\"index.html\">Report &lt;1&gt;</a> <a href=\"chapter-2.html\">→")
    );
    assert!(
        pages[1]
            .1
            .contains("<a href=\"chapter-1.html\">← Chapter 1</a>")
    );
}

#[test]
fn every_row_has_a_name_of_its_own_for_links() {
    let mut site = site();
    let section = &mut site.chapters[0].sections[0];
    for claim in &mut section.claims {
        claim.id = "same".to_owned();
    }
    section.claims[4].id = "other".to_owned();
    let ids: Vec<String> = section.rows().map(|(id, _)| id).collect();
    let expected = [
        "fig-1.same",
        "fig-1.same-2",
        "fig-1.same-3",
        "fig-1.same-4",
        "fig-1.other",
    ];
    assert_eq!(ids, expected);
    let html = html(&site);
    assert!(html.contains("<tr id=\"fig-1.same-2\">") && html.contains("href=\"#fig-1.same-2\""));
}

#[test]
fn the_bar_has_a_part_for_each_verdict() {
    let html = html(&site());
    assert!(html.contains("<span class=\"reproduced\" style=\"flex:2\">2</span>"));
    assert!(html.contains("<b>5 statements</b>"));
    assert!(html.contains("<span class=\"key unchecked\"></span>1 not checkable"));
    assert!(!html.contains("class=\"key failed\""));
}

#[test]
fn what_stands_between_backticks_is_code() {
    let html = html(&site());
    assert!(html.contains("run <code>a &lt; b</code>"));
    assert!(!html.contains('`'));
}

#[test]
fn the_figure_is_inline_and_its_files_are_linked() {
    let html = html(&site());
    assert!(html.contains("<svg><circle/></svg>"));
    assert!(html.contains("<a href=\"fig%201.csv\">fig 1.csv</a>"));
    assert!(html.contains("<a href=\"a/fig1.png\">a/fig1.png</a>"));
}

#[test]
fn contents_count_the_verdicts_and_link_the_sections() {
    let html = html(&site());
    let number = |count: usize| match count {
        0 => "<td class=\"number none\">0</td>".to_owned(),
        _ => format!("<td class=\"number\">{count}</td>"),
    };
    // Of the ten kinds failures have no column, as there are none.
    let row = [2, 0, 0, 0, 1, 0, 0, 1, 1].map(number).concat() + "</tr>";
    // Of the section and the sum, and of the chapter and the sum on the front page.
    assert_eq!(html.matches(&row).count(), 4);
    assert!(!html.contains("<th>failed</th>"));
    assert!(html.contains("href=\"#fig-1\"") && html.contains("id=\"fig-1\""));
    assert!(html.contains("<td><a href=\"chapter-1.html\">Chapter 1</a></td>"));
}

#[test]
fn failures_are_counted_where_there_are_any() {
    let mut site = site();
    site.chapters[0].sections[0].claims[0] =
        Claim::trend(Statement::parse("(1): a — order"), "", false);
    assert!(html(&site).contains("<th>failed</th>"));
}

#[test]
fn each_verdict_has_its_words_and_its_evidence() {
    let html = html(&site());
    assert_eq!(html.matches(">reproduced</span>").count(), 2);
    assert_eq!(
        html.matches("± 0.50: half a unit of the last printed digit")
            .count(),
        2
    );
    assert!(html.contains("thesis in error") && html.contains("not checkable"));
}

#[test]
fn a_thesis_without_a_number_has_a_dash() {
    let html = html(&site());
    assert!(html.contains("</span> a <a class=\"id\" href=\"#fig-1.-4\"></a></td><td>–</td>"));
    assert!(!html.contains("<td></td>"));
}

#[test]
fn a_section_without_claims_has_no_table() {
    let mut site = site();
    site.chapters[0].sections[0].claims.clear();
    assert!(!html(&site).contains("<th>claim</th>"));
}
