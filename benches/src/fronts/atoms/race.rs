//! Speed of ours and of LAMMPS, run in turn on one core.

use super::gromacs;
use super::lammps::{self, MISSING, RunReport};
use super::parts::{self, Parts};
use super::problems::{Problem, TimedRun};
use crate::timing::median;
use crate::written::{Sheet, short};
use std::iter::once;

/// Both programs compute the same energy of the start, relative: sums of other orders.
const SAME_ENERGY: f64 = 1e-10;

/// The same of GROMACS, whose log has six digits.
const SAME_LOGGED_ENERGY: f64 = 1e-5;

/// Speed of one program on one problem; the processor's times.
#[derive(Clone, Copy, Debug)]
pub struct Speed {
    /// Seconds per atom and step.
    pub per_atom_step: f64,
    /// Seconds of the forces per listed pair.
    pub per_pair: f64,
    /// Seconds of a list per atom.
    pub per_listed_atom: f64,
    /// Share of the lists in all.
    pub list_share: f64,
    /// Steps from list to list.
    pub list_life: f64,
}

/// One problem.
#[derive(Debug)]
pub struct Race {
    /// Name of the problem.
    pub name: &'static str,
    /// Number of atoms.
    pub atoms: usize,
    /// Speed of Tribos.
    pub ours: Speed,
    /// Speed of LAMMPS, if it is installed.
    pub theirs: Option<Speed>,
    /// Speed of Tribos over that of LAMMPS, median over the rounds.
    pub ratio: f64,
    /// Speed of GROMACS, if it is installed and the problem is a melt.
    pub gromacs: Option<Anchor>,
}

/// Speed of a program that is only timed as a whole.
#[derive(Clone, Copy, Debug)]
pub struct Anchor {
    /// Seconds per atom and step.
    pub per_atom_step: f64,
    /// Speed of Tribos over that of the program, median over the rounds.
    pub ratio: f64,
}

/// Which other programs are installed.
#[derive(Clone, Copy, Debug)]
pub struct Peers {
    /// LAMMPS.
    pub lammps: bool,
    /// GROMACS in double precision.
    pub gromacs: bool,
}

/// Runs all in turn, `rounds` times.
pub fn race(problem: &Problem, rounds: usize, peers: Peers) -> Result<Race, String> {
    let input = peers.lammps.then(|| problem.input()).transpose()?;
    let (mut ours, mut theirs, mut ratios) = (Vec::new(), Vec::new(), Vec::new());
    let (mut anchors, mut anchor_ratios) = (Vec::new(), Vec::new());
    let mut atoms = 0;
    for _ in 0..rounds {
        let ran = problem.run()?;
        let parts = parts::measure(&ran)?;
        atoms = ran.atoms.len();
        ours.push(own_speed(&ran, &parts));
        if let Some(input) = &input {
            let told = lammps::run(input)?;
            agree("LAMMPS", ran.energy, told.energy, SAME_ENERGY)?;
            theirs.push(their_speed(&ran, &told));
            ratios.push(told.seconds / ran.seconds);
        }
        if let (true, Problem::Melt { melt, steps }) = (peers.gromacs, problem) {
            let told = gromacs::run(melt, *steps, (*steps / ran.builds.max(1)).max(1))?;
            agree("GROMACS", ran.energy, told.energy, SAME_LOGGED_ENERGY)?;
            anchors.push(told.seconds / (*steps as f64 * atoms as f64));
            anchor_ratios.push(told.seconds / ran.seconds);
        }
    }
    Ok(Race {
        name: problem.name(),
        atoms,
        ours: middle(&ours),
        theirs: (!theirs.is_empty()).then(|| middle(&theirs)),
        ratio: median(&ratios),
        gromacs: (!anchors.is_empty()).then(|| Anchor {
            per_atom_step: median(&anchors),
            ratio: median(&anchor_ratios),
        }),
    })
}

/// Refuses to compare programs that compute different things.
fn agree(peer: &str, ours: f64, theirs: f64, tolerance: f64) -> Result<(), String> {
    if (ours - theirs).abs() <= tolerance * ours.abs() {
        Ok(())
    } else {
        Err(format!(
            "{peer}: the potential energy at the start is {theirs}, ours {ours}: \
             they do not run the same"
        ))
    }
}

fn own_speed(ran: &TimedRun, parts: &Parts) -> Speed {
    let (steps, builds) = (ran.steps as f64, ran.builds as f64);
    Speed {
        per_atom_step: ran.seconds / (steps * ran.atoms.len() as f64),
        per_pair: parts.forces / parts.pairs,
        per_listed_atom: parts.list / ran.atoms.len() as f64,
        list_share: builds * parts.list / ran.seconds,
        list_life: steps / builds,
    }
}

fn their_speed(ran: &TimedRun, told: &RunReport) -> Speed {
    let (steps, atoms) = (ran.steps as f64, ran.atoms.len() as f64);
    let [forces, lists] = told.shares.map(|share| share * told.seconds);
    Speed {
        per_atom_step: told.seconds / (steps * atoms),
        per_pair: forces / (steps * told.pairs),
        per_listed_atom: lists / (told.builds * atoms),
        list_share: told.shares[1],
        list_life: steps / told.builds,
    }
}

/// Medians over the rounds.
fn middle(speeds: &[Speed]) -> Speed {
    let of = |read: fn(&Speed) -> f64| median(&speeds.iter().map(read).collect::<Vec<_>>());
    Speed {
        per_atom_step: of(|speed| speed.per_atom_step),
        per_pair: of(|speed| speed.per_pair),
        per_listed_atom: of(|speed| speed.per_listed_atom),
        list_share: of(|speed| speed.list_share),
        list_life: of(|speed| speed.list_life),
    }
}

/// All problems, a row a program.
pub fn sheet(races: &[Race], rounds: usize, release: Option<&str>) -> Sheet {
    let peer = release.map_or(MISSING.into(), |release| {
        // A comma would end the cell of a table.
        format!("LAMMPS ({})", release.replace(',', ""))
    });
    let rows = races.iter().flat_map(|race| {
        let ratio = if race.theirs.is_some() {
            short(race.ratio)
        } else {
            "-".into()
        };
        let ours = row(race, "tribos", Some(&race.ours), ratio);
        let theirs = race.theirs.as_ref();
        let one = if theirs.is_some() { "1" } else { "-" };
        let anchor = race.gromacs.iter().map(|anchor| anchored(race, anchor));
        once(ours)
            .chain(once(row(race, &peer, theirs, one.into())))
            .chain(anchor)
    });
    Sheet {
        about: format!(
            "One core: median of {rounds} rounds of the programs in turn from the same places and velocities"
        ),
        header: vec![
            "problem",
            "atoms",
            "program",
            "million atom-steps/s",
            "speed over LAMMPS",
            "forces: ns per listed pair",
            "list: ns per atom",
            "list: % of all",
            "steps per list",
        ],
        rows: rows.collect(),
    }
}

/// GROMACS' row; lists and forces are not told apart.
fn anchored(race: &Race, anchor: &Anchor) -> Vec<String> {
    let over_lammps = match race.theirs {
        Some(_) => short(race.ratio / anchor.ratio),
        None => "-".into(),
    };
    let mut row = vec![
        race.name.into(),
        race.atoms.to_string(),
        "GROMACS (double)".into(),
        short(1e-6 / anchor.per_atom_step),
        over_lammps,
    ];
    row.resize(9, "-".into());
    row
}

fn row(race: &Race, program: &str, speed: Option<&Speed>, ratio: String) -> Vec<String> {
    let told = |read: fn(&Speed) -> f64| speed.map_or("-".into(), |speed| short(read(speed)));
    vec![
        race.name.into(),
        race.atoms.to_string(),
        program.into(),
        told(|speed| 1e-6 / speed.per_atom_step),
        ratio,
        told(|speed| 1e9 * speed.per_pair),
        told(|speed| 1e9 * speed.per_listed_atom),
        told(|speed| 100.0 * speed.list_share),
        told(|speed| speed.list_life),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn programs_that_differ_are_not_compared() {
        let agree = |theirs| agree("LAMMPS", -6.75, theirs, SAME_ENERGY);
        assert!(agree(-6.75 * (1.0 + 1e-13)).is_ok());
        assert!(agree(-6.7501).is_err());
        assert!(agree(f64::NAN).is_err());
    }

    #[test]
    fn without_lammps_a_row_says_so() {
        let speed = Speed {
            per_atom_step: 5e-7,
            per_pair: 4e-9,
            per_listed_atom: 8e-7,
            list_share: 0.2,
            list_life: 10.0,
        };
        let race = Race {
            name: "melt",
            atoms: 4000,
            ours: speed,
            theirs: None,
            ratio: f64::NAN,
            gromacs: None,
        };
        let rows = sheet(&[race], 5, None).rows;
        assert_eq!(rows[0][2..5], ["tribos", "2.00", "-"]);
        assert!(rows[1][2].contains("apt-get install lammps"));
        assert!(rows[1][3..].iter().all(|cell| cell == "-"));
    }
}
