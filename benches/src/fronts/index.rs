//! The first page of the folder: methods of the thesis, summary and picture of each front.

use super::{Finding, Front, Setting, places};
use crate::written;

const PAGE: &str = "index.md";

const OPENING: &str = "\
# Speed against error

`cargo run --profile dist -p tribos-benches --bin fronts` makes this folder; `--help` tells how to make one
front alone. Ratios within a run are steadier than times: the load average in the headers tells how
busy the machine was.
";

/// Puts the finding in the front's section, makes the table of methods anew, and leaves the other sections.
pub fn enter(setting: &Setting<'_>, front: Front, finding: &Finding) -> Result<(), String> {
    let old = std::fs::read_to_string(setting.out.join(PAGE)).unwrap_or_default();
    let opening = format!("{OPENING}\n{}", places::write(setting)?);
    let page = entered(
        (&opening, &old),
        front,
        &section(setting.made, front, finding),
    );
    written::write(setting.out, PAGE, &page)
}

fn section(made: &str, front: Front, Finding { line, picture }: &Finding) -> String {
    let (name, title) = (front.name(), front.title());
    format!(
        "## {name}\n\n{line}\n\n[![{title}]({picture})]({picture})\n\nTables: [{name}.md]({name}.md). {made}.\n"
    )
}

/// The page with a new opening, and a section in the place of the one with its heading.
fn entered((opening, page): (&str, &str), front: Front, section: &str) -> String {
    let of = |wanted: Front| {
        if wanted == front {
            return Some(section.trim_start_matches("## ").trim_end());
        }
        let mut old = page.split("\n## ").skip(1).map(str::trim_end);
        old.find(|text| text.lines().next() == Some(wanted.name()))
    };
    let sections = Front::ALL.into_iter().filter_map(of);
    let sections = sections.map(|text| format!("\n## {text}\n"));
    opening.to_owned() + &sections.collect::<String>()
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::fs;
    use std::path::Path;

    #[test]
    fn a_front_takes_its_own_place() {
        let page = entered(("old", ""), Front::Firmware, "## firmware\n\none\n");
        let page = entered(("old", &page), Front::Kernel, "## kernel\n\ntwo\n");
        let page = entered(("new\n", &page), Front::Firmware, "## firmware\n\nthree\n");
        assert_eq!(page, "new\n\n## kernel\n\ntwo\n\n## firmware\n\nthree\n");
    }

    /// Targets of Markdown's links and pictures.
    fn links(page: &str) -> Vec<&str> {
        let after = page.split("](").skip(1);
        after.filter_map(|text| text.split(')').next()).collect()
    }

    #[test]
    fn what_the_published_pages_link_to_is_there() {
        let folder = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../docs/fronts"));
        let pages = Front::ALL.map(|front| format!("{}.md", front.name()));
        let index = fs::read_to_string(folder.join(PAGE)).unwrap();
        for name in &pages {
            assert!(links(&index).contains(&name.as_str()), "{name}");
        }
        for name in pages.iter().map(String::as_str).chain([PAGE]) {
            let page = fs::read_to_string(folder.join(name)).unwrap();
            assert!(
                page.contains("Made 20") && page.contains("rustc "),
                "{name}"
            );
            let found = links(&page);
            assert!(found.iter().any(|link| link.ends_with(".svg")), "{name}");
            for link in found {
                assert!(folder.join(link).is_file(), "{name}: {link}");
            }
        }
    }
}
