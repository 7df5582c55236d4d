//! A report as web pages: a front page and one for each chapter, each in one file.

mod front;
mod section;

use super::html::inline;
use super::player;
use super::verdict::Counts;
pub use section::{FigureRef, Section};
use std::fmt::Write as _;

/// Look of the pages.
const STYLE: &str = include_str!("../assets/page.css");
/// Name of the front page.
const FRONT: &str = "index.html";

/// All pages.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Site {
    /// Heading of the front page and title of all windows.
    pub title: String,
    /// What a reader takes away: items of a list.
    pub lead: Vec<String>,
    /// What the bar counts, and the verdicts.
    pub counted: (String, Counts),
    /// Beside each other on the first screen.
    pub pictures: Vec<Picture>,
    /// Pages of their own, in order.
    pub chapters: Vec<Chapter>,
    /// On the front page, after the contents.
    pub tables: Vec<Table>,
}

/// A small drawing of the front page.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Picture {
    /// Trusted SVG text.
    pub svg: String,
    /// Text under it.
    pub caption: String,
}

/// Sections on a page of their own.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Chapter {
    /// Name of its file.
    pub file: String,
    /// Heading.
    pub heading: String,
    /// Its parts in order.
    pub sections: Vec<Section>,
}

/// A table of words, or paragraphs alone.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Table {
    /// Name for links to it.
    pub id: String,
    /// Heading.
    pub heading: String,
    /// Paragraphs above it.
    pub text: Vec<String>,
    /// Heads of the columns.
    pub head: Vec<String>,
    /// Rows; cells may have several lines.
    pub rows: Vec<Vec<String>>,
}

impl Site {
    /// Names of the files and their texts, the front page last.
    pub fn pages(&self) -> Vec<(&str, String)> {
        let chapters = self.chapters.iter().enumerate();
        let mut pages: Vec<(&str, String)> = chapters
            .map(|(at, chapter)| (chapter.file.as_str(), self.chapter(at, chapter)))
            .collect();
        pages.push((FRONT, self.front()));
        pages
    }

    fn chapter(&self, at: usize, chapter: &Chapter) -> String {
        let films = chapter
            .sections
            .iter()
            .any(|section| section.film.is_some());
        let (heading, title) = (inline(&chapter.heading), inline(&self.title));
        let mut way = format!("<a href=\"{FRONT}\">{title}</a>");
        let before = at
            .checked_sub(1)
            .and_then(|before| self.chapters.get(before));
        for (arrow, other) in [("←", before), ("→", self.chapters.get(at + 1))] {
            if let Some(Chapter { file, heading, .. }) = other {
                let _ = write!(way, " <a href=\"{file}\">{arrow} {}</a>", inline(heading));
            }
        }
        let sections: String = chapter.sections.iter().map(Section::html).collect();
        let body = format!(
            "<nav class=\"way\">{way}</nav>\n<h1>{heading}</h1>\n{}{sections}",
            front::contents(std::slice::from_ref(chapter), true)
        );
        document(&format!("{heading} – {title}"), &body, films)
    }
}

impl Table {
    fn html(&self) -> String {
        let row = |cell: &str, cells: &[String]| {
            let cells = cells
                .iter()
                .map(|text| match inline(text).replace('\n', "<br>") {
                    text if text.is_empty() => format!("<{cell}>–</{cell}>"),
                    text => format!("<{cell}>{text}</{cell}>"),
                });
            format!("<tr>{}</tr>\n", cells.collect::<String>())
        };
        let rows: String = self.rows.iter().map(|cells| row("td", cells)).collect();
        let table = match rows.as_str() {
            "" => String::new(),
            _ => format!(
                "<div class=\"scroll\">\n<table>\n<thead>{}</thead>\n<tbody>\n{rows}</tbody>\n</table>\n</div>\n",
                row("th", &self.head)
            ),
        };
        let (id, heading) = (anchor(&self.id), inline(&self.heading));
        format!(
            "<section id=\"{id}\">\n<h2>{heading}</h2>\n{}{table}</section>\n",
            paragraphs(&self.text)
        )
    }
}

// A whole document.
fn document(title: &str, body: &str, has_films: bool) -> String {
    let [style, script] = match has_films {
        true => [player::style(), player::script()],
        false => Default::default(),
    };
    format!(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <title>{title}</title>\n<link rel=\"icon\" href=\"data:,\">\n<style>\n{STYLE}</style>\n{style}\
         </head>\n<body>\n{body}{script}</body>\n</html>\n"
    )
}

// Each text as one paragraph.
fn paragraphs(texts: &[String]) -> String {
    let paragraphs = texts
        .iter()
        .map(|text| format!("<p>{}</p>\n", inline(text)));
    paragraphs.collect()
}

/// A name for use in a link.
pub fn anchor(id: &str) -> String {
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
