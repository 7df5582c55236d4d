use super::*;

// A page with one claim per verdict.
fn page() -> Page {
    let verdicts = [
        Verdict::Agrees,
        Verdict::Agrees,
        Verdict::Erratum("sign of <b> & \"c\"".to_owned()),
        Verdict::Unstated("range of <cohesion>".to_owned()),
        Verdict::NotChecked,
    ];
    let claims = verdicts.into_iter().map(|verdict| Claim {
        statement: "a < b".to_owned(),
        thesis: "1".to_owned(),
        ours: "2".to_owned(),
        uncertainty: String::new(),
        difference: "1".to_owned(),
        verdict,
    });
    Page {
        title: "Report <1>".to_owned(),
        intro: vec!["x & y".to_owned()],
        environment: "tribos 0.1 <linux>".to_owned(),
        sections: vec![Section {
            id: "fig 1".to_owned(),
            heading: "Figure \"1\"".to_owned(),
            text: vec!["<script>alert(1)</script>".to_owned()],
            figure: Some(FigureRef {
                svg: "<svg><circle/></svg>".to_owned(),
                files: vec!["fig 1.csv".to_owned(), "a/fig1.png".to_owned()],
                caption: "ε > 0".to_owned(),
            }),
            film: None,
            claims: claims.collect(),
        }],
    }
}

#[test]
fn every_text_is_escaped() {
    let html = page().html();
    for text in [
        "Report &lt;1&gt;",
        "x &amp; y",
        "tribos 0.1 &lt;linux&gt;",
        "Figure &quot;1&quot;",
        "&lt;script&gt;",
        "a &lt; b",
        "sign of &lt;b&gt; &amp; &quot;c&quot;",
        "differs, with cause</span><br>range of &lt;cohesion&gt;",
        "ε &gt; 0",
    ] {
        assert!(html.contains(text), "{text}");
    }
    assert!(!html.contains("<script>") && !html.contains("of <b>"));
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
    let number = |count: usize| format!("<td class=\"number\">{count}</td>");
    let row = [2, 1, 1, 0, 1].map(number).concat();
    assert_eq!(html.matches(&row).count(), 2);
    assert!(html.contains("href=\"#fig-1\"") && html.contains("id=\"fig-1\""));
}

#[test]
fn each_verdict_has_its_words() {
    let html = page().html();
    assert_eq!(html.matches(">reproduced</span>").count(), 2);
    assert!(html.contains("thesis in error") && html.contains("not checked"));
    assert_eq!(
        Verdict::Differs.html(),
        "<span class=\"verdict differs\">differs</span>"
    );
}

#[test]
fn a_section_without_claims_has_no_table() {
    let mut page = page();
    page.sections[0].claims.clear();
    assert!(!page.html().contains("Claim (thesis)"));
}
