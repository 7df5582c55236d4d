//! The front page: what a reader takes away, the verdicts as a bar, pictures, contents, tables.

use super::{Chapter, Picture, Section, Site, Table, anchor, document};
use crate::html::{escape, inline};
use crate::verdict::{CLASSES, Counts, KINDS, Verdict};

impl Site {
    /// The front page as one HTML document.
    pub(super) fn front(&self) -> String {
        let title = escape(&self.title);
        let lead = self
            .lead
            .iter()
            .map(|item| format!("<li>{}</li>\n", inline(item)));
        let pictures: String = self.pictures.iter().map(Picture::html).collect();
        let tables: String = self.tables.iter().map(Table::html).collect();
        let body = format!(
            "<h1>{title}</h1>\n<ul class=\"lead\">\n{}</ul>\n{}<div class=\"pictures\">\n{pictures}</div>\n{}{tables}",
            lead.collect::<String>(),
            self.bar(),
            contents(&self.chapters, false),
        );
        document(&title, &body, false)
    }

    // The verdicts as parts of a bar, with their names below it.
    fn bar(&self) -> String {
        let (what, counts) = &self.counted;
        let kinds = || (0..KINDS.len()).filter(|kind| counts.0[*kind] > 0);
        let parts = kinds().map(|kind| {
            let (count, class) = (counts.0[kind], CLASSES[kind]);
            format!("<span class=\"{class}\" style=\"flex:{count}\">{count}</span>")
        });
        let names = kinds().map(|kind| {
            let (count, class, name) = (counts.0[kind], CLASSES[kind], KINDS[kind]);
            format!("<li><span class=\"key {class}\"></span>{count} {name}</li>")
        });
        format!(
            "<div class=\"verdicts\" role=\"img\" aria-label=\"{}\">{}</div>\n<ul class=\"keys\"><li><b>{} {}</b></li>{}</ul>\n",
            escape(&counts.words()),
            parts.collect::<String>(),
            counts.total(),
            inline(what),
            names.collect::<String>(),
        )
    }
}

impl Picture {
    fn html(&self) -> String {
        let (caption, svg) = (inline(&self.caption), self.svg.trim());
        format!(
            "<figure>\n<div class=\"card\">\n{svg}\n</div>\n<figcaption>{caption}</figcaption>\n</figure>\n"
        )
    }
}

// Chapters with the verdicts of their rows, or the sections of one; failures have a column if there are any.
pub(super) fn contents(chapters: &[Chapter], is_within: bool) -> String {
    let of = |sections: &[Section]| {
        let claims = sections.iter().flat_map(|section| &section.claims);
        Counts::of(claims.map(|claim| &claim.verdict))
    };
    let counts = chapters.iter().map(|chapter| of(&chapter.sections));
    let total = counts.fold(Counts::default(), Counts::plus);
    let shown = |kind: &usize| *kind != Verdict::Failed.kind() || total.0[*kind] > 0;
    let kinds = || (0..KINDS.len()).filter(shown);
    let row = |name: &str, counts: Counts| {
        let cells = kinds().map(|kind| match counts.0[kind] {
            0 => "<td class=\"number none\">0</td>".to_owned(),
            count => format!("<td class=\"number\">{count}</td>"),
        });
        format!("<tr><td>{name}</td>{}</tr>\n", cells.collect::<String>())
    };
    let rows: String = if is_within {
        let sections = chapters.iter().flat_map(|chapter| &chapter.sections);
        sections
            .map(|section| {
                let (id, heading) = (anchor(&section.id), inline(&section.heading));
                let name = format!("<a href=\"#{id}\">{heading}</a>");
                row(&name, of(std::slice::from_ref(section)))
            })
            .collect()
    } else {
        chapters
            .iter()
            .map(|chapter| {
                let (file, heading) = (&chapter.file, inline(&chapter.heading));
                row(
                    &format!("<a href=\"{file}\">{heading}</a>"),
                    of(&chapter.sections),
                )
            })
            .collect()
    };
    let heads: String = kinds()
        .map(|kind| format!("<th>{}</th>", KINDS[kind]))
        .collect();
    format!(
        "<nav class=\"scroll\">\n<table>\n<thead><tr><th>rows</th>{heads}</tr></thead>\n\
         <tbody>\n{rows}</tbody>\n<tfoot>\n{}</tfoot>\n</table>\n</nav>\n",
        row("all", total)
    )
}
