//! Contacts a second of plain sweeps, by size, order, way and threads.

use super::packing::{Order, world};
use super::{Pools, THREADS};
use crate::clock::Clock;
use crate::packing::problems::cool;
use crate::timing::median;
use crate::written::{Sheet, short};
use std::hint::black_box;
use std::time::Instant;
use tribos::cd::internals::{Coefficients, NoMonitor, Operator, Pairs, Spheres, Visit};
use tribos::powder::deposit::Deposit;
use tribos_core::contact::{ContactFriction, IndependentFriction};

/// Coefficients: sliding as in the thesis, small enough that some contacts roll and spin.
const MU: [f64; 3] = [0.3, 0.1, 0.1];
/// Names of the sets of modes.
pub const ALL_MODES: &str = "all six";
const SLIDING: &str = "sliding";
/// Sweeps of a sample, from zero impulses.
const SWEEPS: usize = 10;

/// A way to sweep a problem.
struct SolverVariant<F: ContactFriction<f64>> {
    name: &'static str,
    /// What is done to a problem before its sweeps.
    prepare: fn(&mut Spheres<F>),
}

/// The ways that are compared; their bits are the same.
fn ways<F: ContactFriction<f64>>() -> [SolverVariant<F>; 2] {
    [
        SolverVariant {
            name: "one by one",
            prepare: Spheres::without_lanes,
        },
        SolverVariant {
            name: "four at a time",
            prepare: |_| (),
        },
    ]
}

/// Speed of one problem swept in one way.
#[derive(Clone, Debug)]
pub struct Point {
    /// Set of modes.
    pub modes: &'static str,
    /// Way of the sweep.
    pub way: &'static str,
    /// Order of the spheres.
    pub order: Order,
    /// Number of spheres.
    pub spheres: usize,
    /// Number of contacts.
    pub contacts: usize,
    /// Bytes of a contact with its bodies.
    pub bytes: usize,
    /// The processor's time of an update on one thread.
    pub processor: f64,
    /// Shortest time of day of an update for each number of threads.
    pub day: [f64; 2],
}

impl Point {
    /// Strong scaling: time of day on one thread over that on two.
    pub fn speedup(&self) -> f64 {
        self.day[0] / self.day[1]
    }
}

/// Sweeps of a deposit with all six modes, and with sliding alone.
pub fn measure(deposit: &Deposit, pools: &Pools, rounds: usize) -> Result<Vec<Point>, String> {
    let sliding = IndependentFriction::sliding(MU[0]).map_err(|error| error.to_string())?;
    let mut points = of_modes((ALL_MODES, all_modes()?), deposit, pools, rounds)?;
    points.extend(of_modes((SLIDING, sliding), deposit, pools, rounds)?);
    Ok(points)
}

/// Friction with all six modes.
pub fn all_modes() -> Result<IndependentFriction<f64, tribos_core::contact::AllModes>, String> {
    let [mu, mu_t, mu_n] = MU;
    IndependentFriction::all(mu, mu_t, mu_n).map_err(|error| error.to_string())
}

fn of_modes<F>(
    (modes, friction): (&'static str, F),
    deposit: &Deposit,
    pools: &Pools,
    rounds: usize,
) -> Result<Vec<Point>, String>
where
    F: ContactFriction<f64> + Coefficients,
{
    let mut points = Vec::new();
    for order in Order::ALL {
        let mut world = world(&order.of(deposit), friction, 1)?;
        world.step().map_err(|error| error.to_string())?;
        let mut start = world.problem().clone();
        drop(world);
        cool(&mut start);
        for way in ways() {
            let (processor, day) = time(&start, &way, pools, rounds);
            points.push(Point {
                modes,
                way: way.name,
                order,
                spheres: deposit.positions.len(),
                contacts: start.contacts(),
                bytes: Pairs::<F::Modes>::BYTES,
                processor,
                day,
            });
        }
    }
    Ok(points)
}

/// Seconds of an update: the median of the processor's on one thread, and the shortest of the day's, which
/// other work on the machine disturbs least, for each number of threads.
fn time<F: ContactFriction<f64>>(
    start: &Spheres<F>,
    way: &SolverVariant<F>,
    pools: &Pools,
    rounds: usize,
) -> (f64, [f64; 2]) {
    let updates = (SWEEPS * start.contacts()) as f64;
    let mut problem = start.clone();
    let (mut processor, mut day) = (Vec::new(), [f64::INFINITY; 2]);
    for _ in 0..rounds {
        for (number, (pool, day)) in pools.iter().zip(&mut day).enumerate() {
            problem.clone_from(start);
            (way.prepare)(&mut problem);
            let (clock, instant) = (Clock::start(), Instant::now());
            pool.install(|| {
                for _ in 0..SWEEPS {
                    black_box(&mut problem).sweep(Visit::Forward, &mut NoMonitor);
                }
            });
            *day = day.min(instant.elapsed().as_secs_f64() / updates);
            if number == 0 {
                processor.push(clock.seconds() / updates);
            }
        }
    }
    (median(&processor), day)
}

/// Speed on two threads of a problem twice as large, over twice that on one thread; `None` if it was not
/// measured.
pub fn weak(points: &[Point], point: &Point) -> Option<f64> {
    let is_double = |other: &&Point| {
        other.spheres == 2 * point.spheres
            && (other.modes, other.way, other.order) == (point.modes, point.way, point.order)
    };
    let double = points.iter().find(is_double)?;
    Some(0.5 * point.day[0] / double.day[1])
}

/// A row for each problem and way.
pub fn sheet(points: &[Point], rounds: usize) -> Sheet {
    let million = |seconds: f64| short(1e-6 / seconds);
    let [_, threads] = THREADS;
    Sheet::of(
        format!(
            "Sweeps of shaken cohesive deposits, {SWEEPS} from zero impulses, {rounds} rounds: million \
             contacts a second by the processor's time on one thread (median), then by the time of day on \
             one and on {threads} threads (best; other work on the machine shows); strong: speed on {threads} \
             threads over one; weak: speed on {threads} threads of a deposit {threads} times as large over \
             {threads} times that on one"
        ),
        points,
        &[
            ("modes", &|point| point.modes.into()),
            ("spheres", &|point| point.spheres.to_string()),
            ("order", &|point| point.order.name().into()),
            ("way", &|point| point.way.into()),
            ("contacts", &|point| point.contacts.to_string()),
            ("million/s (processor)", &|point| million(point.processor)),
            ("million/s (1 thread)", &|point| million(point.day[0])),
            ("million/s (2 threads)", &|point| million(point.day[1])),
            ("strong", &|point| short(point.speedup())),
            ("weak", &|point| {
                weak(points, point).map_or("-".into(), short)
            }),
            ("bytes a contact", &|point| point.bytes.to_string()),
        ],
    )
}
