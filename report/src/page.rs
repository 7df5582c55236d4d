//! A self-contained web page that compares our results with a thesis.

use super::claim::Claim;
use super::html::{escape, inline};
use super::player;
use super::verdict::{Counts, KINDS};
use serde::{Deserialize, Serialize};
use std::fmt::Write as _;

/// Look of the page; figures stay on white cards in dark mode.
const STYLE: &str = "\
:root{color-scheme:light dark;--text:#1c1f23;--soft:#5b6570;--back:#fbfbfa;--card:#fff;\
--line:#d9dde1;--zebra:#f3f5f6;--link:#0b5cad;--good:#1a7f46;--bad:#b3261e;--open:#8a5a00}
@media(prefers-color-scheme:dark){:root{--text:#e4e7ea;--soft:#a2abb4;--back:#16191c;\
--card:#1e2226;--line:#363c42;--zebra:#22272b;--link:#7fb8ef;--good:#6fcf97;--bad:#ff8f85;\
--open:#e6b566}}
*{box-sizing:border-box}
body{margin:0 auto;padding:2rem 1.2rem 4rem;max-width:62rem;background:var(--back);\
color:var(--text);font:16px/1.55 system-ui,-apple-system,'Segoe UI',Roboto,sans-serif}
h1{font-size:1.9rem;line-height:1.2;margin:0 0 1rem}
h2{font-size:1.35rem;margin:3rem 0 .6rem;padding-top:1rem;border-top:1px solid var(--line)}
p{margin:.6rem 0;max-width:48rem}
a{color:var(--link)}
.environment,figcaption{color:var(--soft);font-size:.9rem}
figure{margin:1.2rem 0}
.card{background:#fff;border:1px solid var(--line);border-radius:6px;padding:.6rem;overflow-x:auto}
.card svg{display:block;max-width:100%;height:auto;margin:0 auto}
.files a{margin-right:.8rem;white-space:nowrap}
.scroll{overflow-x:auto}
table{border-collapse:collapse;width:100%;font-size:.93rem;margin:1rem 0;background:var(--card)}
th,td{text-align:left;vertical-align:top;padding:.45rem .7rem;border:1px solid var(--line)}
th{background:var(--zebra)}
tbody tr:nth-child(even){background:var(--zebra)}
td.number{text-align:right;font-variant-numeric:tabular-nums}
tfoot td{font-weight:600}
nav th,nav td{padding:.25rem .5rem}nav td:first-child{min-width:19rem}
.agrees{color:var(--good)}.differs{color:var(--bad)}.unchecked{color:var(--open)}.own{color:var(--link)}
.place,.none{color:var(--soft)}.place{font-size:.9em}
section td:first-child{min-width:14rem}
.lead{font-size:1.15rem}
code{font-size:.92em}
.verdict{font-weight:600}
";

/// The whole page.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Page {
    /// Heading of the page and title of the window.
    pub title: String,
    /// The first paragraph, in larger letters.
    pub lead: String,
    /// Further paragraphs under the heading.
    pub intro: Vec<String>,
    /// One line on program version, machine and settings; may be empty.
    pub environment: String,
    /// Parts of the report in order.
    pub sections: Vec<Section>,
    /// What follows the sections, if anything does.
    pub appendix: Option<Appendix>,
}

/// A table of words after the sections.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Appendix {
    /// Heading.
    pub heading: String,
    /// One paragraph.
    pub text: String,
    /// Heads of the two columns.
    pub head: [String; 2],
    /// Rows of the table.
    pub rows: Vec<[String; 2]>,
}

/// One part of the report.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct Section {
    /// Name for links to this section, unique on the page.
    pub id: String,
    /// Heading.
    pub heading: String,
    /// Paragraphs.
    pub text: Vec<String>,
    /// The figure, if the section has one.
    pub figure: Option<FigureRef>,
    /// Trusted HTML of a film for the page's player, if the section has one.
    pub film: Option<String>,
    /// Rows of the comparison table.
    pub claims: Vec<Claim>,
}

/// A figure shown inside the page and the files beside the page.
#[derive(Debug, Clone, PartialEq, Eq, Default, Serialize, Deserialize)]
pub struct FigureRef {
    /// Trusted SVG text, put into the page as it is.
    pub svg: String,
    /// Relative names of the files to link, such as CSV, SVG and PNG.
    pub files: Vec<String>,
    /// Text under the figure.
    pub caption: String,
}

impl Page {
    /// The page as one HTML document.
    pub fn html(&self) -> String {
        let title = escape(&self.title);
        let mut html = format!(
            "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
             <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
             <title>{title}</title>\n<link rel=\"icon\" href=\"data:,\">\n<style>\n{STYLE}</style>\n{}\
             </head>\n<body>\n<h1>{title}</h1>\n",
            if self.has_films() {
                player::style()
            } else {
                String::new()
            }
        );
        if !self.lead.is_empty() {
            html.push_str(&format!("<p class=\"lead\">{}</p>\n", inline(&self.lead)));
        }
        html.push_str(&paragraphs(&self.intro));
        if !self.environment.is_empty() {
            let line = inline(&self.environment);
            html.push_str(&format!("<p class=\"environment\">{line}</p>\n"));
        }
        html.push_str(&self.contents());
        for section in &self.sections {
            html.push_str(&section.html());
        }
        if let Some(appendix) = &self.appendix {
            html.push_str(&appendix.html());
        }
        if self.has_films() {
            html.push_str(&player::script());
        }
        html.push_str("</body>\n</html>\n");
        html
    }

    fn has_films(&self) -> bool {
        self.sections.iter().any(|section| section.film.is_some())
    }

    // The table of contents with the verdicts of each section; failures have a column if there are any.
    fn contents(&self) -> String {
        let counts = |section: &Section| Counts::of(section.claims.iter().map(|c| &c.verdict));
        let all = self.sections.iter().flat_map(|section| &section.claims);
        let total = Counts::of(all.map(|claim| &claim.verdict));
        let shown = |kind: usize| kind + 1 < KINDS.len() || total.0[kind] > 0;
        let row = |name: &str, counts: Counts| {
            let cells = counts.0.iter().enumerate().filter(|(kind, _)| shown(*kind));
            let cells = cells.map(|(_, count)| match count {
                0 => "<td class=\"number none\">0</td>".to_owned(),
                _ => format!("<td class=\"number\">{count}</td>"),
            });
            format!("<tr><td>{name}</td>{}</tr>\n", cells.collect::<String>())
        };
        let rows = self.sections.iter().map(|section| {
            let (id, heading) = (anchor(&section.id), inline(&section.heading));
            row(&format!("<a href=\"#{id}\">{heading}</a>"), counts(section))
        });
        let rows: String = rows.collect();
        let kinds = KINDS.iter().enumerate().filter(|(kind, _)| shown(*kind));
        let heads: String = kinds.map(|(_, kind)| format!("<th>{kind}</th>")).collect();
        format!(
            "<nav class=\"scroll\">\n<table>\n<thead><tr><th>section</th>{heads}</tr></thead>\n\
             <tbody>\n{rows}</tbody>\n<tfoot>\n{}</tfoot>\n</table>\n</nav>\n",
            row("all sections", total)
        )
    }
}

impl Section {
    // The section with text, figure and table.
    fn html(&self) -> String {
        let (id, heading) = (anchor(&self.id), inline(&self.heading));
        let text = paragraphs(&self.text);
        let figure = self.figure.as_ref().map(FigureRef::html);
        let figure = figure.unwrap_or_default();
        let claims = table(&self.claims);
        let film = self.film.as_deref().unwrap_or_default();
        format!(
            "<section id=\"{id}\">\n<h2>{heading}</h2>\n{text}{figure}{film}{claims}</section>\n"
        )
    }
}

impl Appendix {
    // Heading, paragraph and table.
    fn html(&self) -> String {
        let row = |cell: &str, [left, right]: &[String; 2]| {
            let [left, right] = [inline(left), inline(right)];
            format!("<tr><{cell}>{left}</{cell}><{cell}>{right}</{cell}></tr>\n")
        };
        let rows: String = self.rows.iter().map(|cells| row("td", cells)).collect();
        format!(
            "<section id=\"appendix\">\n<h2>{}</h2>\n{}<div class=\"scroll\">\n<table>\n<thead>{}</thead>\n\
             <tbody>\n{rows}</tbody>\n</table>\n</div>\n</section>\n",
            inline(&self.heading),
            paragraphs(std::slice::from_ref(&self.text)),
            row("th", &self.head)
        )
    }
}

impl FigureRef {
    // The drawing on a card, followed by caption and links.
    fn html(&self) -> String {
        let mut links = String::new();
        for file in &self.files {
            let (target, name) = (address(file), escape(file));
            let _ = write!(links, "<a href=\"{target}\">{name}</a> ");
        }
        let (caption, svg) = (inline(&self.caption), self.svg.trim());
        let spoken = escape(&self.caption.replace('`', ""));
        format!(
            "<figure>\n<div class=\"card\" role=\"img\" aria-label=\"{spoken}\">\n{svg}\n</div>\n\
             <figcaption>{caption}\n<div class=\"files\">{links}</div></figcaption>\n</figure>\n"
        )
    }
}

// The comparison table, or nothing without claims.
fn table(claims: &[Claim]) -> String {
    if claims.is_empty() {
        return String::new();
    }
    let rows: String = claims.iter().map(Claim::row).collect();
    format!(
        "<div class=\"scroll\">\n<table>\n<thead><tr><th>claim</th><th>thesis</th>\
         <th>ours</th><th>difference</th><th>verdict</th></tr></thead>\n\
         <tbody>\n{rows}</tbody>\n</table>\n</div>\n"
    )
}

// Each text as one paragraph.
fn paragraphs(texts: &[String]) -> String {
    let paragraphs = texts
        .iter()
        .map(|text| format!("<p>{}</p>\n", inline(text)));
    paragraphs.collect()
}

// A section name for use in a link.
fn anchor(id: &str) -> String {
    let keep = |character: char| character.is_ascii_alphanumeric() || "-_.".contains(character);
    let characters = id.chars();
    characters.map(|c| if keep(c) { c } else { '-' }).collect()
}

// A relative file name as a link target.
fn address(file: &str) -> String {
    let mut target = String::new();
    for byte in file.bytes() {
        if byte.is_ascii_alphanumeric() || b"-_./~".contains(&byte) {
            target.push(char::from(byte));
        } else {
            let _ = write!(target, "%{byte:02X}");
        }
    }
    target
}

#[cfg(test)]
mod tests;
