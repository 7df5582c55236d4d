//! The first page of `tribos --help`: what the commands are for, by example.

use clap::Command;
use std::fmt::Write;

/// The commands, by what they are for.
pub const GROUPS: [(&str, &[&str]); 6] = [
    (
        "One contact",
        &[
            "wrench",
            "surface",
            "hold",
            "steady",
            "coefficients",
            "onset",
            "push",
            "laws",
            "modes",
            "fit",
        ],
    ),
    (
        "Bodies, powders, atoms",
        &[
            "run", "view", "inverse", "deposit", "packing", "measure", "contact", "eval", "export",
        ],
    ),
    ("What a run needs", &["scene", "explain"]),
    ("Many runs", &["sweep"]),
    ("Results that can be checked", &["golden", "reproduce"]),
    ("This command", &["completions", "man"]),
];

/// What comes after the options.
pub const EXAMPLES: &str = "\
Examples:
  A disk thrown at 1 m/s with 5 rad/s of spin, until it rests:
    tribos run scenes/disk.toml --out out/disk && tribos view out/disk
  Force and torque of a ball on a soft pad that slides and spins:
    tribos wrench --patch hertz --speed 2 --spin 40 --radius 0.03
  How far the disk slides, over the spin, on all cores:
    tribos sweep scenes/disk.toml --set spin=0,5,10,20,50 --out out/spin

More:
  tribos COMMAND --help    what a command does, its options, examples
  tribos man --out DIR     the same as manual pages
  tribos scene list        scenes that run as they are
  docs/index.md            the book: first steps, tasks one by one, theory, laws, accuracy

Exit codes: 0 done, 1 the run failed, 2 bad usage or bad input, 3 results differ from those pinned,
4 no solution, or none found, 130 interrupted.";

/// The command with its first page.
pub fn with_page(command: Command) -> Command {
    let mut groups = String::new();
    for (heading, names) in GROUPS {
        let _ = writeln!(groups, "{heading}:");
        for sub in names
            .iter()
            .filter_map(|name| command.find_subcommand(name))
        {
            let about = sub.get_about().map(ToString::to_string);
            let _ = writeln!(
                groups,
                "  {:<12} {}",
                sub.get_name(),
                about.unwrap_or_default()
            );
        }
        groups.push('\n');
    }
    command.help_template(format!(
        "{{about-with-newline}}\n{{usage-heading}} {{usage}}\n\n{groups}Options:\n{{options}}{{after-help}}"
    ))
}
