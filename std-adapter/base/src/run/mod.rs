//! The driver of simulations: step, observe, record, checkpoint, resume, cancel; and the estimated
//! cost of a run.
//!
//! [`run_to_end`] runs any [`Simulation`]. A [`Session`] runs a long simulation in a folder, from which it
//! can be resumed to the same bits.

mod film;
#[doc(hidden)]
pub mod folder;
mod long_run;
mod parallel;
#[doc(hidden)]
pub mod program;
mod session;

#[doc(hidden)]
pub use film::FRAMES;
#[doc(hidden)]
pub use long_run::{Cause, LongRun};
pub use long_run::{RunError, StartMode};
#[doc(hidden)]
pub use parallel::in_order;
pub use session::Session;
#[doc(hidden)]
pub use session::{CHECKPOINT, forget_checkpoint, read_checkpoint};

/// Estimated size of a run, from its scene alone, before anything is built.
///
/// ```
/// use tribos::powder::size;
/// use tribos::run::RunSize;
/// # use tribos::scene::PowderScene;
/// let scene = PowderScene { width: 1e6, height: 61.5, ..PowderScene::default() };
/// let told: RunSize = size(&scene);
/// assert!(told.bodies > 1e12 && told.bytes > 1e15 && told.seconds > 1e9);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[doc(hidden)]
pub struct RunSize {
    /// Number of spheres or atoms.
    pub bodies: f64,
    /// Memory, in bytes.
    pub bytes: f64,
    /// Time to the end on two cores of 2020, in s: the order of magnitude.
    pub seconds: f64,
}

/// Something that advances step by step.
///
/// ```
/// use tribos::run::{Simulation, run_to_end};
/// /// A block that brakes with 2 m/s².
/// struct Block { speed: f64, way: f64 }
/// impl Simulation for Block {
///     type Record = f64;
///     type Error = std::convert::Infallible;
///     fn record(&self) -> f64 { self.way }
///     fn step(&mut self) -> Result<bool, Self::Error> {
///         let end = (self.speed - 2.0 * 0.25).max(0.0); // after 0.25 s
///         self.way += 0.25 * 0.5 * (self.speed + end);
///         self.speed = end;
///         Ok(end > 0.0)
///     }
///     fn progress(&self) -> f64 { 1.0 - self.speed / 3.0 }
/// }
/// let mut ways = Vec::new();
/// run_to_end(&mut Block { speed: 3.0, way: 0.0 }, |way, _done| ways.push(way))?;
/// assert_eq!(ways.len(), 1 + 6); // the start and 3 m/s over 0.5 m/s a step
/// assert_eq!(ways.last(), Some(&2.25)); // v²/(2 a)
/// # Ok::<(), std::convert::Infallible>(())
/// ```
pub trait Simulation {
    /// One line of the series.
    type Record;
    /// Why a step can fail.
    type Error;

    /// The current state as a line of the series.
    fn record(&self) -> Self::Record;

    /// Takes one step. `Ok(false)` when the simulation has ended.
    fn step(&mut self) -> Result<bool, Self::Error>;

    /// Fraction of the work done, between 0 and 1.
    fn progress(&self) -> f64;
}

/// Runs to the end; `observe` sees the first state, the state after every step, and the progress.
pub fn run_to_end<S: Simulation>(
    simulation: &mut S,
    mut observe: impl FnMut(S::Record, f64),
) -> Result<(), S::Error> {
    observe(simulation.record(), 0.0);
    loop {
        let goes_on = simulation.step()?;
        observe(simulation.record(), simulation.progress());
        if !goes_on {
            return Ok(());
        }
    }
}
