use super::*;
use crate::claim::Statement;
use crate::verdict::Allowance;

// A page with one claim of most verdicts.
fn page() -> Page {
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
    Page {
        title: "Report <1>".to_owned(),
        lead: "2 of `5` <rows>".to_owned(),
        intro: vec!["x & y".to_owned()],
        environment: "tribos 0.1 <linux>, `tribos run`".to_owned(),
        sections: vec![Section {
            id: "fig 1".to_owned(),
            heading: "Figure \"1\"".to_owned(),
            text: vec!["<script>alert(1)</script>".to_owned()],
            figure: Some(FigureRef {
                svg: "<svg><circle/></svg>".to_owned(),
                files: vec!["fig 1.csv".to_owned(), "a/fig1.png".to_owned()],
                caption: "ε > 0, `a`".to_owned(),
            }),
            film: None,
            claims,
        }],
        appendix: Some(Appendix {
            heading: "Left out & why".to_owned(),
            text: "All <others> are shown.".to_owned(),
            head: ["what".to_owned(), "why".to_owned()],
            rows: vec![["figure 1".to_owned(), "a `drawing` <b>".to_owned()]],
        }),
    }
}

#[test]
fn every_text_is_escaped() {
    let html = page().html();
    for text in [
        "Report &lt;1&gt;",
        "<p class=\"lead\">2 of <code>5</code> &lt;rows&gt;</p>",
        "x &amp; y",
        "tribos 0.1 &lt;linux&gt;",
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
fn the_appendix_follows_the_sections_as_a_table() {
    let html = page().html();
    let row = "<tr><td>figure 1</td><td>a <code>drawing</code> &lt;b&gt;</td></tr>";
    let place = |text: &str| html.find(text);
    assert!(html.contains("<th>what</th><th>why</th>") && html.contains(row));
    assert!(place("Left out &amp; why") > place("<section id=\"fig-1\">"));
    let without = Page {
        appendix: None,
        ..page()
    };
    assert!(!without.html().contains("id=\"appendix\""));
}

#[test]
fn what_stands_between_backticks_is_code() {
    let html = page().html();
    assert!(html.contains("run <code>a &lt; b</code>"));
    assert!(html.contains("<code>tribos run</code>"));
    assert!(!html.contains('`'));
}

#[test]
fn the_figure_is_inline_and_its_files_are_linked() {
    let html = page().html();
    assert!(html.contains("<svg><circle/></svg>"));
    assert!(html.contains("<a href=\"fig%201.csv\">fig 1.csv</a>"));
    assert!(html.contains("<a href=\"a/fig1.png\">a/fig1.png</a>"));
}

#[test]
fn contents_count_the_verdicts_and_link_the_sections() {
    let html = page().html();
    let number = |count: usize| match count {
        0 => "<td class=\"number none\">0</td>".to_owned(),
        _ => format!("<td class=\"number\">{count}</td>"),
    };
    // Of the nine kinds failures have no column, as there are none.
    let row = [2, 0, 0, 0, 1, 0, 1, 1].map(number).concat() + "</tr>";
    assert_eq!(html.matches(&row).count(), 2);
    assert!(!html.contains("<th>failed</th>"));
    assert!(html.contains("href=\"#fig-1\"") && html.contains("id=\"fig-1\""));
}

#[test]
fn failures_are_counted_where_there_are_any() {
    let mut page = page();
    page.sections[0].claims[0] = Claim::trend(Statement::parse("(1): a — order"), "", false);
    assert!(page.html().contains("<th>failed</th>"));
}

#[test]
fn each_verdict_has_its_words_and_its_evidence() {
    let html = page().html();
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
    let html = page().html();
    assert!(html.contains("</span> a</td><td>–</td>"));
    assert!(!html.contains("<td></td>"));
}

#[test]
fn a_section_without_claims_has_no_table() {
    let mut page = page();
    page.sections[0].claims.clear();
    assert!(!page.html().contains("<th>claim</th>"));
}
