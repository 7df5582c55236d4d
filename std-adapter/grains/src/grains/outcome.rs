//! Summary of a run of grains.

use super::measure::GrainsLine;
use crate::packing::{ContactStatistics, Dissipation, PackingEnergy, PackingStopReason};
use tribos_base::results::{Reporting::*, summary};

summary! {
    /// Results of a run of grains, in the units of its scene. The parts of `end`, `statistics`, `dissipation` and
    /// `energy` are listed with their meanings in docs/results.md.
    ///
    /// [`GrainsScene`](crate::grains::scene::GrainsScene) has an example.
    pub struct GrainsSummary;

    /// Why the run ended; none if it has not.
    ending: Option<PackingStopReason>, "-";
    /// Number of grains that move freely.
    grains: usize, "-";
    /// Mass of these grains.
    mass: f64, "kg";
    /// Time at the end.
    time: f64, "s", Swept;
    /// Number of steps taken.
    steps: u64, "-", Swept;
    /// Total number of sweeps.
    iterations_total: u64, "-", Swept;
    /// Steps in which any tolerance or rule was not met.
    steps_unmet: u64, "-";
    /// Steps that sweeps handed over to a solver with factorisations; left out where there are none.
    steps_handed_over: Option<u64> = optional, "-";
    /// Number of contacts between grains at the end.
    contacts: usize, "-";
    /// The last line of the series.
    end: GrainsLine = flat, "-";
    /// Slopes of the lower and the upper half of the free surface along x: a heap has one of each sign, and its
    /// `surface_angle` says nothing. Left out without a free surface.
    surface_angles: Option<[f64; 2]> = optional, "deg";
    /// Deepest overlap in all steps.
    max_overlap: f64, "m";
    /// Numbers and forces of the contacts at the end.
    statistics: ContactStatistics, "-";
    /// Energy that the contacts took.
    dissipation: Dissipation, "-";
    /// Energy balance.
    energy: PackingEnergy, "-";
    /// Wall-clock time.
    wall_seconds: f64, "s";
}
