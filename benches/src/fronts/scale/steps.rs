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
    let a_sphere = |split: &Split, seconds: f64| short(1e9 * seconds / split.spheres as f64);
    let a_contact = |split: &Split, seconds: f64| short(1e9 * seconds / split.contacts as f64);
    let share = |split: &Split, part: usize| short(100.0 * split.shares()[part]);
    let bytes = |split: &&Split| {
        let bytes = split.bytes.map(|bytes| short(bytes / split.spheres as f64));
        bytes.unwrap_or("-".into())
    };
    Sheet::of(
        format!(
            "Steps of the same deposits with all six modes along the curve, by the processor's time on one \
             thread: shares of a step of {USUAL} sweeps with a new list every {STEPS} steps, as often as a \
             list can be renewed; memory of a world with its neighbours and contacts"
        ),
        splits,
        &[
            ("spheres", &|split| split.spheres.to_string()),
            ("contacts", &|split| split.contacts.to_string()),
            ("growth [s]", &|split| short(split.growth)),
            ("growth [ns a sphere]", &|split| {
                a_sphere(split, split.growth)
            }),
            ("sorting [ns a sphere]", &|split| {
                a_sphere(split, split.sorting)
            }),
            ("list [ns a sphere]", &|split| a_sphere(split, split.list)),
            ("sweep [ns a contact]", &|split| {
                a_contact(split, split.sweep)
            }),
            ("rest of a step [ns a contact]", &|split| {
                a_contact(split, split.rest)
            }),
            ("sweeps [%]", &|split| share(split, 0)),
            ("rest [%]", &|split| share(split, 1)),
            ("lists [%]", &|split| share(split, 2)),
            ("bytes a sphere", &bytes),
        ],
    )
}
