//! `tribos man`: manual pages, one a command.

use crate::failure::Failure;
use clap::Command;
use clap_mangen::Man;
use std::path::{Path, PathBuf};
use tribos::record::write_atomically;

/// Write the manual: tribos.1 and a page a command, such as tribos-run.1.
#[derive(Debug, clap::Args)]
#[command(after_long_help = EXAMPLES)]
pub struct Arguments {
    /// Folder for the pages; made if missing, files in it are replaced.
    #[arg(long, value_name = "DIR")]
    out: PathBuf,
}

/// Date of the pages: that of the version, so that the same version writes the same bytes.
const DATE: &str = "2026-11";

const EXAMPLES: &str = "\
Examples:
  tribos man --out man1
  man -l man1/tribos-sweep.1
  tribos man --out ~/.local/share/man/man1 && man tribos-run";

impl Arguments {
    /// Writes.
    pub fn execute(self) -> Result<(), Failure> {
        let mut program = super::program().disable_help_subcommand(true);
        program.build();
        let count = pages(&program, &self.out)?;
        super::print(&format!(
            "{count} pages written to {0}; man -l {1}\n",
            self.out.display(),
            self.out.join("tribos.1").display()
        ))
    }
}

/// The page of a command and those of its subcommands: how many.
fn pages(command: &Command, out: &Path) -> Result<usize, Failure> {
    let man = Man::new(command.clone())
        .date(DATE)
        .source(concat!("tribos ", env!("CARGO_PKG_VERSION")));
    let file = out.join(man.get_filename());
    let page = page(command, &man).map_err(Failure::run)?;
    write_atomically(&file, spaced_once(&page).as_bytes())?;
    let mut count = 1;
    for sub in command.get_subcommands() {
        count += pages(sub, out)?;
    }
    Ok(count)
}

/// All sections; what follows the options in the help stands as it is there.
fn page(command: &Command, man: &Man) -> std::io::Result<Vec<u8>> {
    let mut page = Vec::new();
    man.render_title(&mut page)?;
    man.render_name_section(&mut page)?;
    man.render_synopsis_section(&mut page)?;
    man.render_description_section(&mut page)?;
    man.render_options_section(&mut page)?;
    if command.has_subcommands() {
        man.render_subcommands_section(&mut page)?;
    }
    let after = command.get_after_long_help().or(command.get_after_help());
    if let Some(text) = after {
        page.extend(verbatim(&text.to_string()).into_bytes());
    }
    Ok(page)
}

/// The page without line breaks next to an empty line, which ends the line as well.
fn spaced_once(page: &[u8]) -> String {
    let text = String::from_utf8_lossy(page);
    let lines: Vec<&str> = text.lines().collect();
    let is_space = |at: Option<usize>| {
        let line = at.and_then(|at| lines.get(at));
        line.is_some_and(|line| line.starts_with(".sp"))
    };
    let kept = lines.iter().enumerate().filter(|(at, line)| {
        **line != ".br" || !(is_space(at.checked_sub(1)) || is_space(at.checked_add(1)))
    });
    kept.map(|(_, line)| format!("{line}\n")).collect()
}

/// A section of lines that are not filled; a line "Examples:" heads it.
fn verbatim(text: &str) -> String {
    let body = text.strip_prefix("Examples:\n").unwrap_or(text);
    let mut page = String::from(".SH EXAMPLES\n.nf\n");
    for line in body.lines() {
        let escaped = line.replace('\\', "\\e").replace('-', "\\-");
        // A dot or a quote at the start would be a request.
        if escaped.starts_with(['.', '\'']) {
            page += "\\&";
        }
        page += &escaped;
        page.push('\n');
    }
    page + ".fi\n"
}

#[cfg(test)]
mod tests {
    use super::{spaced_once, verbatim};

    #[test]
    fn an_empty_line_needs_no_line_break() {
        let page = spaced_once(b"a\n.br\nb\n.br\n.sp\nc\n.sp 1\n.br\nd\n");
        assert_eq!(page, "a\n.br\nb\n.sp\nc\n.sp 1\nd\n");
    }

    #[test]
    fn examples_stand_as_they_are() {
        let page = verbatim("Examples:\n  a --b \\\n.c");
        assert_eq!(page, ".SH EXAMPLES\n.nf\n  a \\-\\-b \\e\n\\&.c\n.fi\n");
    }
}
