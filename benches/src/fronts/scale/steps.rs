//! Parts of a whole step and of its set-up, on one thread.

use super::packing::{MOTION, Order, world};
use super::sweeps::all_modes;
use crate::clock::Clock;
use crate::written::{Sheet, short};
use std::fs;
use tribos::powder::deposit::Deposit;
use tribos::space::pairs::Cells;

/// Sweeps of the two kinds of steps whose difference tells the cost of a sweep.
const FEW: usize = 5;
const MANY: usize = 25;
/// Steps timed, after the first; a list of neighbours lasts as many at least.
const STEPS: usize = 4;
/// Sweeps of the step whose shares are given.
const USUAL: usize = 100;
/// Reach of the neighbour list of a world, in motions of a step: contacts of the step and the margin.
const REACH: f64 = 12.0;
/// Spheres below which the memory of a world is lost among that of the program.
const SHOWN: usize = 100_000;

/// Times in s, on one thread.
#[derive(Clone, Copy, Debug)]
pub struct Split {
    /// Number of spheres.
    pub spheres: usize,
    /// Contacts of a step.
    pub contacts: usize,
    /// Growth of the deposit.
    pub growth: f64,
    /// Sorting its spheres along the curve.
    pub sorting: f64,
    /// A new list of neighbours.
    pub list: f64,
    /// One sweep.
    pub sweep: f64,
    /// The rest of a step: contacts, guesses, residual, energies.
    pub rest: f64,
    /// Bytes of the world after its steps.
    pub bytes: Option<f64>,
}

impl Split {
    /// Shares of a step with the usual number of sweeps: sweeps, the rest, the lists.
    fn shares(&self) -> [f64; 3] {
        let lists = self.list / STEPS as f64;
        let sweeps = USUAL as f64 * self.sweep;
        let rest = (self.rest - lists).max(0.0);
        let whole = sweeps + rest + lists;
        [sweeps, rest, lists].map(|part| part / whole)
    }
}

/// Times the parts for a deposit that took `growth` seconds.
pub fn measure(deposit: &Deposit, growth: f64) -> Result<Split, String> {
    let clock = Clock::start();
    let sorted = Order::Curve.of(deposit);
    let sorting = clock.seconds();
    let mut cells = Cells::default();
    let mut list = f64::INFINITY;
    for _ in 0..STEPS {
        let clock = Clock::start();
        let reach = REACH * MOTION;
        let found = cells.find(&sorted.space, &sorted.positions, &sorted.radii, reach);
        found.map_err(|error| error.to_string())?;
        list = list.min(clock.seconds());
    }
    drop(cells);
    let [few, many] = [FEW, MANY].map(|sweeps| steps(&sorted, sweeps));
    let (few, contacts, bytes) = few?;
    let (many, _, _) = many?;
    let sweep = (many - few) / (MANY - FEW) as f64;
    Ok(Split {
        spheres: deposit.positions.len(),
        contacts,
        growth,
        sorting,
        list,
        sweep,
        rest: few - FEW as f64 * sweep,
        bytes: bytes.filter(|_| deposit.positions.len() >= SHOWN),
    })
}

/// Mean time of a step with a number of sweeps, its contacts, and the bytes of the world.
fn steps(deposit: &Deposit, sweeps: usize) -> Result<(f64, usize, Option<f64>), String> {
    let before = resident();
    let mut world = world(deposit, all_modes()?, sweeps)?;
    let first = world.step().map_err(|error| error.to_string())?;
    let clock = Clock::start();
    for _ in 0..STEPS {
        world.step().map_err(|error| error.to_string())?;
    }
    let seconds = clock.seconds() / STEPS as f64;
    let bytes = resident().zip(before).map(|(after, before)| after - before);
    Ok((seconds, first.contacts, bytes))
}

/// Bytes of this program in memory, where Linux tells them.
fn resident() -> Option<f64> {
    let told = fs::read_to_string("/proc/self/status").ok()?;
    let line = told.lines().find_map(|line| line.strip_prefix("VmRSS:"))?;
    let kibibytes: f64 = line.split_whitespace().next()?.parse().ok()?;
    Some(1024.0 * kibibytes)
}

/// A row for each size.
pub fn sheet(splits: &[Split]) -> Sheet {
    let cells = |split: &Split| {
        let spheres = split.spheres as f64;
        let a_sphere = |seconds: f64| short(1e9 * seconds / spheres);
        let a_contact = |seconds: f64| short(1e9 * seconds / split.contacts as f64);
        let [sweeps, rest, lists] = split.shares().map(|share| short(100.0 * share));
        vec![
            split.spheres.to_string(),
            split.contacts.to_string(),
            short(split.growth),
            a_sphere(split.growth),
            a_sphere(split.sorting),
            a_sphere(split.list),
            a_contact(split.sweep),
            a_contact(split.rest),
            sweeps,
            rest,
            lists,
            split
                .bytes
                .map_or("-".into(), |bytes| short(bytes / spheres)),
        ]
    };
    Sheet {
        about: format!(
            "Steps of the same deposits with all six modes along the curve, by the processor's time on one \
             thread: shares of a step of {USUAL} sweeps with a new list every {STEPS} steps, as often as a \
             list can be renewed; memory of a world with its neighbours and contacts"
        ),
        header: vec![
            "spheres",
            "contacts",
            "growth [s]",
            "growth [ns a sphere]",
            "sorting [ns a sphere]",
            "list [ns a sphere]",
            "sweep [ns a contact]",
            "rest of a step [ns a contact]",
            "sweeps [%]",
            "rest [%]",
            "lists [%]",
            "bytes a sphere",
        ],
        rows: splits.iter().map(cells).collect(),
    }
}
