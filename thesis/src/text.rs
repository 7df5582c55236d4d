//! The texts of the exhibits: Markdown beside the code, with `{name}` where a number or a word is filled in.

use super::effort::Effort;
use std::fmt::Display;
use tribos_report::claim::Statement;

/// A Markdown file: a heading, paragraphs, and parts under headings of their own. *Caption* is the
/// text under the figure. *Quick* is added to the paragraphs of a quick report. *Claims* is a list of
/// items `id (place): statement — basis`; place and basis may be missing.
#[derive(Debug, Clone, Copy)]
pub struct Text(pub &'static str);

/// What a reader finds around the figure.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Prose {
    pub heading: String,
    pub paragraphs: Vec<String>,
    pub caption: String,
}

impl Text {
    /// Heading, paragraphs and caption.
    pub fn prose(self) -> Prose {
        let mut paragraphs = self.part("").into_iter();
        Prose {
            heading: paragraphs.next().unwrap_or_default().replace("# ", ""),
            paragraphs: paragraphs.collect(),
            caption: self.part("Caption").concat(),
        }
    }

    /// The same with what a report of this effort adds.
    pub fn prose_of(self, effort: Effort) -> Prose {
        let mut prose = self.prose();
        if effort == Effort::Quick {
            prose.paragraphs.extend(self.part("Quick"));
        }
        prose
    }

    /// The statement with this id. One that is missing leaves a brace, which no report accepts.
    pub fn said(self, id: &str) -> Statement {
        let mut all = self.statements().into_iter();
        let found = all.find(|(known, _)| known == id);
        found.map_or_else(
            || Statement::parse(&format!("{{no statement {id}}}")),
            |(_, statement)| statement,
        )
    }

    /// All statements with their ids.
    pub fn statements(self) -> Vec<(String, Statement)> {
        let items = self.items("Claims").into_iter();
        items
            .map(|item| {
                let end = item.find([' ', ':']).unwrap_or(item.len());
                let (id, words) = item.split_at(end);
                let words = words.trim_start_matches(':').trim_start();
                let id = id.to_owned();
                (
                    id.clone(),
                    Statement {
                        id,
                        ..Statement::parse(words)
                    },
                )
            })
            .collect()
    }

    /// The paragraphs under a heading; without a name those at the beginning.
    pub fn part(self, name: &str) -> Vec<String> {
        let blocks = self.lines(name).split("\n\n").map(joined);
        blocks.filter(|block| !block.is_empty()).collect()
    }

    /// The items of the list under a heading.
    pub fn items(self, name: &str) -> Vec<String> {
        let list = format!("\n{}", self.lines(name));
        list.split("\n- ").skip(1).map(joined).collect()
    }

    fn lines(self, name: &str) -> &'static str {
        let mut parts = self.0.split("\n## ");
        let first = parts.next().unwrap_or_default();
        if name.is_empty() {
            return first;
        }
        let named = parts.filter_map(|part| part.split_once('\n'));
        let mut named = named.filter(|(heading, _)| heading.trim() == name);
        named.next().map_or("", |(_, lines)| lines)
    }
}

/// Lines as one.
fn joined(lines: &str) -> String {
    let words: Vec<&str> = lines.split_whitespace().collect();
    words.join(" ")
}

impl Prose {
    /// With a value in place of `{name}`.
    pub fn with(mut self, name: &str, value: impl Display) -> Self {
        let (name, value) = (format!("{{{name}}}"), value.to_string());
        for text in self.paragraphs.iter_mut().chain([&mut self.caption]) {
            *text = text.replace(&name, &value);
        }
        self
    }
}
