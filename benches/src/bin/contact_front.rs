//! Contact dynamics: cost of an update, residual against work, work against size.
//!
//! `cargo run --release -p tribos-benches --bin contact_front -- [--out DIR] [--quick]
//! [--only PART]` writes tables and pictures of every part, and `contact_front.md` with all of them,
//! to DIR (default: docs/front). Parts: `updates`, `residual`, `scaling`; one alone takes the place
//! of its section in `contact_front.md`.

use std::process::ExitCode;
use tribos_benches::args::Options;
use tribos_benches::packing::scaling::Extent;
use tribos_benches::packing::{drawn, ladder, scaling, updates};
use tribos_benches::written::{self, Sheet};

/// Rounds of all updates, and of a quick look.
const ROUNDS: usize = 101;
const QUICK_ROUNDS: usize = 15;
/// Most sweeps of a method on the jammed box, and in a quick look.
const MOST_SWEEPS: usize = 10_000;
const QUICK_SWEEPS: usize = 1000;

const COMMAND: &str = "by `cargo run --release -p tribos-benches --bin contact_front`";

/// The page of all parts, and its title.
const PAGE: &str = "contact_front.md";
const TITLE: &str = "# Contacts of packings: speed, residual, size\n";

/// What others report for a contact update or a step of contacts.
const PEERS: [[&str; 3]; 4] = [
    [
        "single-file C++ program, Gauss-Seidel",
        "sliding",
        "about 50 million updates/s",
    ],
    [
        "YADE",
        "sliding, rolling, torsion (springs)",
        "2 to 3.3 million/s",
    ],
    [
        "LIGGGHTS",
        "sliding, rolling, torsion (springs)",
        "18 million/s",
    ],
    ["Chrono NSC", "470 spheres, 100 sweeps", "6 to 9 ms a step"],
];

fn main() -> ExitCode {
    match arguments().and_then(|(options, only)| run(&options, only.as_deref())) {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("contact_front: {message}");
            ExitCode::FAILURE
        }
    }
}

/// The options of all fronts, and the part that is wanted.
fn arguments() -> Result<(Options, Option<String>), String> {
    let mut words: Vec<String> = std::env::args().skip(1).collect();
    let mut only = None;
    if let Some(at) = words.iter().position(|word| word == "--only") {
        let part = words.drain(at..(at + 2).min(words.len())).nth(1);
        only = Some(part.ok_or("--only needs a part after it")?);
    }
    Ok((Options::read(words.into_iter())?, only))
}

/// A part: writes its files and returns its tables under a heading.
type Part = fn(&Options) -> Result<String, String>;

fn run(options: &Options, only: Option<&str>) -> Result<(), String> {
    let parts: [(&str, Part); 3] = [
        ("updates", time_updates),
        ("residual", climb_ladders),
        ("scaling", grow),
    ];
    let wanted = |name: &str| only.is_none_or(|only| only == name);
    if !parts.iter().any(|(name, _)| wanted(name)) {
        let names = parts.map(|(name, _)| name).join(", ");
        return Err(format!("unknown part; known: {names}"));
    }
    for (name, part) in parts {
        if wanted(name) {
            let text = part(options)?;
            println!("{text}");
            let old = std::fs::read_to_string(options.out.join(PAGE)).unwrap_or_default();
            written::write(&options.out, PAGE, &with_section(&old, &text))?;
        }
    }
    Ok(())
}

/// The page with a section in the place of the one with its heading, or at the end.
fn with_section(page: &str, section: &str) -> String {
    let mut sections: Vec<&str> = page.split("\n## ").skip(1).map(str::trim_end).collect();
    let section = section.trim_start_matches("## ").trim_end();
    let same = |old: &&str| old.lines().next() == section.lines().next();
    match sections.iter().position(same) {
        Some(place) => sections[place] = section,
        None => sections.push(section),
    }
    let sections = sections.iter().map(|text| format!("\n## {text}\n"));
    TITLE.to_owned() + &sections.collect::<String>()
}

/// Updates a second for every set of modes, beside the figures of others.
fn time_updates(options: &Options) -> Result<String, String> {
    let rounds = if options.quick { QUICK_ROUNDS } else { ROUNDS };
    let costs = updates::measure(rounds).map_err(|error| error.to_string())?;
    let sheet = updates::sheet(&costs, rounds, COMMAND);
    written::write(&options.out, "contact_updates.csv", &sheet.csv())?;
    let peers = Sheet {
        about: "Figures of another machine of the same kind:".into(),
        header: vec!["program", "contact", "speed"],
        rows: PEERS.map(|row| row.map(String::from).to_vec()).to_vec(),
    };
    Ok(format!(
        "## Updates\n\n{}\n{}",
        sheet.markdown(),
        peers.markdown()
    ))
}

/// Residual against work for all methods and rules.
fn climb_ladders(options: &Options) -> Result<String, String> {
    let most = if options.quick {
        QUICK_SWEEPS
    } else {
        MOST_SWEEPS
    };
    let (rungs, contests) = ladder::measure(most).map_err(|error| error.to_string())?;
    let all = ladder::rungs_sheet(&rungs, COMMAND);
    written::write(&options.out, "contact_residual.csv", &all.csv())?;
    let sheet = ladder::contest_sheet(&contests, COMMAND);
    written::write(&options.out, "contact_contest.csv", &sheet.csv())?;
    drawn::residuals(&options.out, &rungs)?;
    Ok(format!(
        "## Residual against work\n\n{}\n![Residual against sweeps and time](contact_residual.svg)\
         \n\nAll rules and levels: [contact_residual.csv](contact_residual.csv).\n",
        sheet.markdown()
    ))
}

/// Sweeps against size.
fn grow(options: &Options) -> Result<String, String> {
    let extent = if options.quick {
        Extent {
            chains: vec![12, 25, 50, 100],
            towers: vec![250, 500, 1000],
            cubes: vec![500, 1000, 2000],
            updates: 1e8,
        }
    } else {
        Extent {
            chains: vec![12, 25, 50, 100, 200, 400, 800, 1600, 3200],
            towers: vec![125, 250, 500, 1000, 2000],
            cubes: vec![500, 1000, 2000, 5000],
            updates: 2e8,
        }
    };
    let points = scaling::measure(&extent).map_err(|error| error.to_string())?;
    let all = scaling::points_sheet(&points, COMMAND);
    written::write(&options.out, "contact_scaling.csv", &all.csv())?;
    let laws = scaling::laws_sheet(&scaling::laws(&points), COMMAND);
    drawn::sizes(&options.out, &points)?;
    Ok(format!(
        "## Work against size\n\n{}\n{}\n![Sweeps against size](contact_scaling.svg)\n",
        laws.markdown(),
        all.markdown()
    ))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_section_takes_its_own_place() {
        let page = with_section(&with_section("", "## A\n\none\n"), "## B\n\ntwo\n");
        assert_eq!(page, format!("{TITLE}\n## A\n\none\n\n## B\n\ntwo\n"));
        let page = with_section(&page, "## A\n\nthree\n");
        assert_eq!(page, format!("{TITLE}\n## A\n\nthree\n\n## B\n\ntwo\n"));
    }
}
