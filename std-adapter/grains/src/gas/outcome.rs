//! What a gas leaves: columns of the series, why it ended, and the summary.

use crate::packing::PackingStopReason;
use tribos_base::results::{Reporting::*, summary};

/// Columns of the series: temperatures in T0; energies a sphere; `theory` the mean-field temperatures after as
/// many collisions, `haff` the translational one after the same time.
pub const COLUMNS: [&str; 12] = [
    "time",
    "collisions",
    "temperature",
    "temperature_rotational",
    "theory",
    "theory_rotational",
    "haff",
    "enskog_rate",
    "energy",
    "lost",
    "momentum",
    "density_variance",
];

/// Indices of columns.
pub(super) const TIME: usize = 0;
pub(super) const COLLISIONS: usize = 1;
pub(super) const TRANSLATIONAL: usize = 2;
pub(super) const ROTATIONAL: usize = 3;
pub(super) const THEORY: usize = 4;
pub(super) const THEORY_ROTATIONAL: usize = 5;
pub(super) const HAFF: usize = 6;
pub(super) const ENERGY: usize = 8;
pub(super) const LOST: usize = 9;
pub(super) const MOMENTUM: usize = 10;
pub(super) const VARIANCE: usize = 11;

/// A row of the series.
pub(super) type Row = [f64; COLUMNS.len()];

summary! {
    /// Results of a gas, in the units of its scene.
    ///
    /// ```
    /// use tribos::gas::{GasSimulation, GasSummary};
    /// use tribos::run::run_to_end;
    /// # use tribos::scene::GasScene;
    /// # let scene = GasScene { count: 200, collisions: 3.0, ..GasScene::default() };
    /// let mut gas = GasSimulation::new(&scene)?;
    /// run_to_end(&mut gas, |_, _| ())?;
    /// let end: GasSummary = gas.outcome();
    /// let missing = end.energy_initial - end.energy_final - end.energy_lost;
    /// assert!(missing.abs() < 1e-10);
    /// assert_eq!(end.json(&scene)["ending"], "collisions");
    /// # Ok::<(), tribos::run::PackingRunError>(())
    /// ```
    pub struct GasSummary;

    /// Why the run ended; none if it has not.
    ending: Option<PackingStopReason>, "-";
    /// Translational temperature at the end.
    temperature: f64, "T0", Shown("temperature");
    /// Rotational temperature at the end.
    temperature_rotational: f64, "T0", Swept;
    /// Translational temperature of mean-field theory after as many collisions.
    theory: f64, "T0", Shown("mean field");
    /// Rotational temperature of mean-field theory after as many collisions.
    theory_rotational: f64, "T0", Swept;
    /// Haff's law of smooth spheres after the same time.
    haff: f64, "T0", Swept;
    /// Collisions a sphere.
    collisions: f64, "-", Shown("collisions");
    /// Time at the end.
    time: f64, "R sqrt(m/T0)", Shown("time");
    /// Kinetic energy a sphere at the start.
    energy_initial: f64, "T0";
    /// Kinetic energy a sphere at the end.
    energy_final: f64, "T0";
    /// Energy a sphere that collisions took.
    energy_lost: f64, "T0", Swept;
    /// Size of the total momentum.
    momentum: f64, "sqrt(m T0)", Swept;
    /// Variance over mean of the numbers of spheres in cells of about eight, at the start.
    density_variance_initial: f64, "-";
    /// The same at the end.
    density_variance_final: f64, "-", ShownAs("density_variance", "clusters");
    /// Edge of the cube.
    edge: f64, "R";
    /// Number of spheres.
    particles: usize, "-";
    /// Number of steps taken.
    steps: u64, "-";
    /// Collisions of pairs within the contact time, which lost no energy.
    collisions_cured: u64, "-", Swept;
    /// Time steps whose impacts missed their tolerance.
    steps_unmet: u64, "-";
    /// Wall-clock time.
    wall_seconds: f64, "s";
}
