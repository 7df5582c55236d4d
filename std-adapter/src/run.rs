//! The one driver of simulations: step, record, tell how far.

/// Something that advances step by step.
pub trait Simulation {
    /// One line of its series.
    type Record;
    /// Why a step can fail.
    type Error;

    /// The present state as a line of the series.
    fn record(&self) -> Self::Record;

    /// Takes one step. `Ok(false)` when the simulation has ended.
    fn step(&mut self) -> Result<bool, Self::Error>;

    /// Fraction of the work done, between 0 and 1.
    fn progress(&self) -> f64;
}

/// Runs to the end; `observe` sees the first state, the state after every step, and the progress.
pub fn drive<S: Simulation>(
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

/// Runs to the end; `watch` sees the simulation before the first step and after every one, and can
/// stop it: where a checkpoint cannot be written, for one.
pub fn drive_watched<S: Simulation, E: From<S::Error>>(
    simulation: &mut S,
    mut watch: impl FnMut(&S) -> Result<(), E>,
) -> Result<(), E> {
    watch(simulation)?;
    while simulation.step()? {
        watch(simulation)?;
    }
    Ok(())
}
