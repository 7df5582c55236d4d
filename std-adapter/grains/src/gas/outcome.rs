//! What a gas leaves: the lines of its series and the summary.

use crate::packing::PackingStopReason;
use tribos_base::results::{Reporting::*, summary};

summary! {
    /// A line of the series, in the units of the scene.
    #[derive(Copy)]
    pub struct GasLine = series;

    /// Time.
    time: f64, "R sqrt(m/T0)";
    /// Collisions a sphere.
    collisions: f64, "-";
    /// Translational temperature.
    temperature: f64, "T0";
    /// Rotational temperature.
    temperature_rotational: f64, "T0";
    /// Translational temperature of mean-field theory after as many collisions.
    theory: f64, "T0";
    /// Rotational temperature of mean-field theory after as many collisions.
    theory_rotational: f64, "T0";
    /// Haff's law of smooth spheres after the same time.
    haff: f64, "T0";
    /// Enskog's rate of the collisions of a sphere.
    enskog_rate: f64, "sqrt(T0/m)/R";
    /// Kinetic energy a sphere.
    energy: f64, "T0";
    /// Energy a sphere that collisions took.
    lost: f64, "T0";
    /// Size of the total momentum.
    momentum: f64, "sqrt(m T0)";
    /// Variance over mean of the numbers of spheres in cells of about eight.
    density_variance: f64, "-";
}

/// Columns of the series.
pub const COLUMNS: [&str; GasLine::COLUMNS.len()] = GasLine::COLUMNS;

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
