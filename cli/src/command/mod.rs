//! The subcommands, one module each.

pub(crate) mod bodies;
mod coefficients;
mod completion;
mod completions;
mod contact;
mod deposit;
mod digits;
mod eval;
mod explain;
mod export;
mod file;
mod fit;
mod folder;
mod golden;
mod hold;
pub(crate) mod interrupt;
mod inverse;
mod laws;
mod manual;
mod measure;
mod modes;
mod number;
mod onset;
mod output_options;
mod overview;
mod packing;
pub(crate) mod progress;
mod push;
mod reproduce;
pub(crate) mod run;
mod scene;
mod spool;
mod steady;
mod suggestions;
mod surface;
mod sweep;
mod view;
mod wrench;

use crate::failure::Failure;
use clap::builder::StyledStr;
use clap::{CommandFactory, FromArgMatches};
use std::ffi::OsString;
use std::fmt;
use std::io::Write;

/// Solid friction of bodies that slide and spin at once: laws, contacts, simulations.
#[derive(Debug, clap::Parser)]
#[command(name = "tribos", version, arg_required_else_help = true)]
#[command(after_help = overview::EXAMPLES)]
struct Program {
    #[command(flatten)]
    presentation: output_options::OutputOptions,
    #[command(subcommand)]
    command: Command,
}

/// The whole command line.
pub fn program() -> clap::Command {
    let program = overview::with_page(Program::command());
    let program = folder::with_paths(completion::with_words(program));
    documentation()
        .into_iter()
        .fold(program, |program, (name, text)| {
            program.mut_subcommand(name, |command| command.long_about(text))
        })
}

/// What `--help` of a command begins with: the documentation of its arguments.
fn documentation() -> [(&'static str, StyledStr); 24] {
    fn of<A: clap::Args>() -> StyledStr {
        let command = A::augment_args(clap::Command::new(""));
        let text = command.get_long_about().or(command.get_about());
        text.cloned().unwrap_or_default()
    }
    [
        ("wrench", of::<wrench::Arguments>()),
        ("surface", of::<surface::Arguments>()),
        ("hold", of::<hold::Arguments>()),
        ("steady", of::<steady::Arguments>()),
        ("coefficients", of::<coefficients::Arguments>()),
        ("onset", of::<onset::Arguments>()),
        ("push", of::<push::Arguments>()),
        ("modes", of::<modes::Arguments>()),
        ("laws", of::<laws::Arguments>()),
        ("inverse", of::<inverse::Arguments>()),
        ("run", of::<run::Arguments>()),
        ("deposit", of::<deposit::Arguments>()),
        ("eval", of::<eval::Arguments>()),
        ("export", of::<export::Arguments>()),
        ("measure", of::<measure::Arguments>()),
        ("packing", of::<packing::Arguments>()),
        ("golden", of::<golden::Arguments>()),
        ("sweep", of::<sweep::Arguments>()),
        ("reproduce", of::<reproduce::Arguments>()),
        ("view", of::<view::Arguments>()),
        ("scene", of::<scene::Arguments>()),
        ("explain", of::<explain::Arguments>()),
        ("fit", of::<fit::Arguments>()),
        ("contact", of::<contact::Arguments>()),
    ]
}

/// Answers a shell that asks for completions, and ends the process then; else nothing.
pub fn complete(arguments: &[OsString]) {
    let here = std::env::current_dir().ok();
    let shell = clap_complete::CompleteEnv::with_factory(program)
        .var(completion::VARIABLE)
        .bin("tribos");
    match shell.try_complete(arguments, here.as_deref()) {
        Ok(false) => {}
        Ok(true) => std::process::exit(0),
        Err(error) => error.exit(),
    }
}

/// What the arguments ask for; ends the process with help or a refusal if that is the answer.
pub fn parse(arguments: Vec<OsString>) -> Command {
    match Program::from_arg_matches(&program().get_matches_from(arguments)) {
        Ok(program) => {
            program.presentation.set_global();
            program.command
        }
        Err(error) => error.exit(),
    }
}

/// What to do.
#[derive(Debug, clap::Subcommand)]
pub enum Command {
    /// Friction force and torque of a sliding, spinning contact.
    Wrench(wrench::Arguments),
    /// Limit surface: the wrenches that dry friction carries, and the motion under a push.
    Surface(surface::Arguments),
    /// Whether a push moves a body at rest: holds, slips or undecided, with margins.
    Hold(hold::Arguments),
    /// The motion that a body on moving surfaces comes to: belts, treads, turntables, wheels that turn in place.
    Steady(steady::Arguments),
    /// Torsional coefficients for engines that fit a patch best, and the error that remains.
    Coefficients(coefficients::Arguments),
    /// Onset of sliding: what bonds hold under force and torque before the body slides.
    Onset(onset::Arguments),
    /// A body that a pusher moves over the floor: sticking or sliding, motion cone, path.
    Push(push::Arguments),
    /// Final motion: fixed points of the velocity ratio and the phase diagram.
    Modes(modes::Arguments),
    /// Friction laws: formulas, parameters, units, sources; curves of the local ones.
    Laws(laws::Arguments),
    /// The launches after which a body comes to rest at a wanted pose.
    Inverse(inverse::Arguments),
    /// Simulate a scene.
    Run(run::Arguments),
    /// Which laws, modes and unknowns a scene carries, and what they cost.
    Explain(explain::Arguments),
    /// Scenes that come with the program; `scene new` starts one, `scene check` checks it.
    Scene(scene::Arguments),
    /// A run as a film in a web page, as pictures or as a film file.
    View(view::Arguments),
    /// Ballistic deposits of spheres: grown, exported, their porosity.
    Deposit(deposit::Arguments),
    /// Stress, fabric, correlations, force chains of a packing.
    Measure(measure::Arguments),
    /// What a file of spheres is taken for; the same spheres in another format.
    Packing(packing::Arguments),
    /// Parameters of a friction law from measurements, with their standard errors.
    Fit(fit::Arguments),
    /// Contact problems of other programs (FCLib, Siconos): impulses at all contacts.
    Contact(contact::Arguments),
    /// Forces, energy and pressure of atoms as a file has them.
    Eval(eval::Arguments),
    /// A scene as files of another program.
    Export(export::Arguments),
    /// Results of scenes pinned to the bit, and checked on other machines or later.
    Golden(golden::Arguments),
    /// A scene run for all combinations of some keys and seeds, on one machine or many.
    Sweep(sweep::Arguments),
    /// Reproduce the thesis' figures and tables, claim by claim.
    Reproduce(reproduce::Arguments),
    /// Completions for bash, zsh, fish, PowerShell and elvish.
    Completions(completions::Arguments),
    /// Manual pages, one a command.
    Man(manual::Arguments),
}

impl Command {
    /// Does it.
    pub fn execute(self) -> Result<(), Failure> {
        match self {
            Self::Wrench(arguments) => arguments.execute(),
            Self::Surface(arguments) => arguments.execute(),
            Self::Hold(arguments) => arguments.execute(),
            Self::Steady(arguments) => arguments.execute(),
            Self::Coefficients(arguments) => arguments.execute(),
            Self::Onset(arguments) => arguments.execute(),
            Self::Push(arguments) => arguments.execute(),
            Self::Modes(arguments) => arguments.execute(),
            Self::Laws(arguments) => arguments.execute(),
            Self::Inverse(arguments) => arguments.execute(),
            Self::Run(arguments) => arguments.execute(),
            Self::Explain(arguments) => arguments.execute(),
            Self::Scene(arguments) => arguments.execute(),
            Self::View(arguments) => arguments.execute(),
            Self::Deposit(arguments) => arguments.execute(),
            Self::Measure(arguments) => arguments.execute(),
            Self::Packing(arguments) => arguments.execute(),
            Self::Fit(arguments) => arguments.execute(),
            Self::Contact(arguments) => arguments.execute(),
            Self::Eval(arguments) => arguments.execute(),
            Self::Export(arguments) => arguments.execute(),
            Self::Golden(arguments) => arguments.execute(),
            Self::Sweep(arguments) => arguments.execute(),
            Self::Reproduce(arguments) => arguments.execute(),
            Self::Completions(arguments) => arguments.execute(),
            Self::Man(arguments) => arguments.execute(),
        }
    }
}

/// A line on standard error about progress or a choice, unless --quiet is given.
fn note(line: fmt::Arguments<'_>) {
    if !output_options::is_quiet() {
        warn(line);
    }
}

/// A line on standard error that --quiet does not take away; work goes on if nobody can read it.
pub fn warn(line: fmt::Arguments<'_>) {
    progress::erase();
    // One write a line: lines of several threads do not mix.
    let line = format!("{line}\n");
    let _ = std::io::stderr().lock().write_all(line.as_bytes());
}

/// Prints; a reader that went away is not an error.
fn print(text: &str) -> Result<(), Failure> {
    progress::erase();
    match std::io::stdout().lock().write_all(text.as_bytes()) {
        Err(error) if error.kind() != std::io::ErrorKind::BrokenPipe => Err(Failure::run(format!(
            "cannot write to standard output: {error}"
        ))),
        _ => Ok(()),
    }
}
