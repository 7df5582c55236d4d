//! Packings from a thousand to a million spheres: speed of the sweeps by order and threads, parts of a
//! step, memory, and what the machine allows.

mod drawn;
mod packing;
mod roof;
mod steps;
mod sweeps;

use super::{Finding, Front, Setting};
use crate::clock::Clock;
use crate::written::{Sheet, short};
use packing::Order;
use rayon::ThreadPool;
use steps::Split;
use sweeps::{ALL_MODES, Point};

/// Numbers of threads.
const THREADS: [usize; 2] = [1, 2];
/// A pool for each number of threads.
type Pools = [ThreadPool; 2];

const PICTURE: &str = "scale.svg";

/// Sizes and rounds of a run.
struct Extent {
    /// Numbers of spheres.
    sizes: &'static [usize],
    /// Those whose steps are split.
    split: &'static [usize],
    rounds: usize,
}

const FULL: Extent = Extent {
    sizes: &[1_000, 2_000, 10_000, 20_000, 100_000, 200_000, 1_000_000],
    split: &[10_000, 100_000, 1_000_000],
    rounds: 3,
};
const QUICK: Extent = Extent {
    sizes: &[1_000, 2_000, 10_000, 20_000],
    split: &[10_000],
    rounds: 3,
};

/// Makes the front.
pub fn run(setting: &Setting<'_>) -> Result<Finding, String> {
    let extent = if setting.quick { QUICK } else { FULL };
    let pools = pools()?;
    let copied = roof::measure(&pools);
    let (mut points, mut splits) = (Vec::new(), Vec::new());
    for &size in extent.sizes {
        let clock = Clock::start();
        let deposit = packing::deposit(size)?;
        let growth = clock.seconds();
        points.extend(sweeps::measure(&deposit, &pools, extent.rounds)?);
        if extent.split.contains(&size) {
            splits.push(pools[0].install(|| steps::measure(&deposit, growth))?);
        }
    }
    let of_sweeps = sweeps::sheet(&points, extent.rounds);
    setting.table("scale", &of_sweeps)?;
    let of_steps = steps::sheet(&splits);
    setting.table("scale_steps", &of_steps)?;
    let of_roof = roof_sheet(copied);
    drawn::scales(setting.out, "scale", &points, copied[0])?;
    let body = format!(
        "![Contacts a second against spheres]({PICTURE})\n\n{}\n{}\n{}",
        of_sweeps.markdown(),
        of_steps.markdown(),
        of_roof.markdown()
    );
    setting.page(Front::Scale, &body)?;
    Ok(Finding {
        line: line(&points, &splits),
        picture: PICTURE,
    })
}

fn pools() -> Result<Pools, String> {
    let pool = |threads| rayon::ThreadPoolBuilder::new().num_threads(threads).build();
    let [one, two] = THREADS.map(pool);
    let told = |error: rayon::ThreadPoolBuildError| error.to_string();
    Ok([one.map_err(told)?, two.map_err(told)?])
}

/// The copy, by threads.
fn roof_sheet(copied: [f64; 2]) -> Sheet {
    let row = |(threads, bytes): (usize, f64)| vec![threads.to_string(), short(1e-9 * bytes)];
    Sheet {
        about: "Roof: a copy of 128 MiB to another place, bytes read and written; the line in the picture is \
                that of one thread over twice the bytes of a contact"
            .into(),
        header: vec!["threads", "GB/s"],
        rows: THREADS.into_iter().zip(copied).map(row).collect(),
    }
}

/// Summary of the front: the largest deposit.
fn line(points: &[Point], splits: &[Split]) -> String {
    let largest = points.iter().map(|point| point.spheres).max().unwrap_or(0);
    let of = |spheres: usize, order: Order| {
        let wanted = |point: &&Point| {
            (point.modes, point.spheres, point.order) == (ALL_MODES, spheres, order)
        };
        points.iter().find(wanted)
    };
    let speed = |spheres, order| {
        let point = of(spheres, order);
        short(point.map_or(f64::NAN, |point| 1e-6 / point.processor))
    };
    let least = points.first().map_or(0, |point| point.spheres);
    let gain = of(largest, Order::Curve).map_or(f64::NAN, Point::speedup);
    let growth = splits.last().map_or(String::new(), |split| {
        let seconds = short(split.growth);
        format!("; a deposit of {} grows in {seconds} s", split.spheres)
    });
    format!(
        "One thread sweeps {} million contacts a second with all six modes in a deposit of {least} spheres, \
         {} in one of {largest} sorted along a curve ({} as fallen); two threads take it {} times as \
         fast{growth}.",
        speed(least, Order::Curve),
        speed(largest, Order::Curve),
        speed(largest, Order::Fallen),
        short(gain),
    )
}
