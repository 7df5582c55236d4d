//! One part of a report: text, figure, film, and the rows of its comparison.

use super::{address, anchor, paragraphs};
use crate::claim::Claim;
use crate::html::{escape, inline};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::fmt::Write as _;

/// One part of the report.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct Section {
    /// Name for links to this section, unique in the report.
    pub id: String,
    /// Heading.
    pub heading: String,
    /// How it was made, in one line; may be empty.
    pub made: String,
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

impl Section {
    /// The rows with their names for links, unique in the report: section and claim, with a number where
    /// several rows make one statement.
    pub fn rows(&self) -> impl Iterator<Item = (String, &Claim)> {
        let mut seen = BTreeMap::<&str, usize>::new();
        self.claims.iter().map(move |claim| {
            let nth = seen.entry(&claim.id).or_default();
            *nth += 1;
            let id = anchor(&format!("{}.{}", self.id, claim.id));
            let id = if *nth > 1 { format!("{id}-{nth}") } else { id };
            (id, claim)
        })
    }

    // The section with text, figure and table.
    pub(super) fn html(&self) -> String {
        let (id, heading) = (anchor(&self.id), inline(&self.heading));
        let made = match self.made.as_str() {
            "" => String::new(),
            made => format!("<p class=\"made\">{}</p>\n", inline(made)),
        };
        let text = paragraphs(&self.text);
        let figure = self.figure.as_ref().map(FigureRef::html);
        let figure = figure.unwrap_or_default();
        let film = self.film.as_deref().unwrap_or_default();
        format!(
            "<section id=\"{id}\">\n<h2>{heading}</h2>\n{made}{text}{figure}{film}{}</section>\n",
            self.table()
        )
    }

    // The comparison table, or nothing without claims.
    fn table(&self) -> String {
        if self.claims.is_empty() {
            return String::new();
        }
        let rows: String = self.rows().map(|(id, claim)| claim.row(&id)).collect();
        format!(
            "<div class=\"scroll\">\n<table>\n<thead><tr><th>claim</th><th>thesis</th>\
             <th>ours</th><th>difference</th><th>verdict</th></tr></thead>\n\
             <tbody>\n{rows}</tbody>\n</table>\n</div>\n"
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
