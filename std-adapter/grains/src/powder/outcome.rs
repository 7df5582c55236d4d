//! Summary of a compaction.

use crate::packing::{ContactStatistics, Dissipation, PackingEnergy, PackingStopReason};
use nalgebra::Matrix3;
use tribos_base::results::{Reporting::*, summary};

summary! {
    /// A line of the series, in the units of the scene.
    #[derive(Copy)]
    pub struct PowderLine = series;

    /// Time.
    time: f64, "sqrt(rho R^4/F_coh)";
    /// Number of steps taken.
    step: f64, "-";
    /// Height of the piston.
    piston_height: f64, "R";
    /// Porosity below the piston.
    porosity: f64, "-";
    /// Number of contacts, those with substrate and piston included.
    contacts: f64, "-";
    /// stress_zz of the step over the applied pressure.
    stress_zz: f64, "-";
    /// Sweeps of the step.
    sweeps: f64, "-";
    /// Relative residual of the contact laws in the step.
    residual: f64, "-";
    /// Kinetic energy.
    kinetic: f64, "F_coh R";
    /// Energy lost in collisions and in closing gaps.
    dissipated_normal: f64, "F_coh R";
    /// Energy lost in sliding.
    dissipated_sliding: f64, "F_coh R";
    /// Energy lost in rolling.
    dissipated_rolling: f64, "F_coh R";
    /// Energy lost in torsion.
    dissipated_torsion: f64, "F_coh R";
    /// Work against cohesion.
    dissipated_cohesion: f64, "F_coh R";
    /// Work of the loads.
    work: f64, "F_coh R";
}

/// Columns of the series.
pub const COLUMNS: [&str; PowderLine::COLUMNS.len()] = PowderLine::COLUMNS;

summary! {
    /// What the criterion of blocked packings looks at: means over the last window of steps.
    #[derive(Copy)]
    pub struct PistonBalance = part;

    /// Magnitude of the change of the piston's height in the window.
    piston_moved: f64, "R";
    /// Contact force on the piston over the applied load.
    piston_force: f64, "-";
    /// Net force on a sphere over the normal force of a contact.
    net_force: f64, "-";
}

summary! {
    /// Mean stress over the last window of steps, row by row.
    #[derive(Copy)]
    pub struct MeanStress = part;

    /// Stress of all contacts.
    total: Matrix3<f64>, "F_coh/R^2";
    /// Contribution of contacts that push.
    plus: Matrix3<f64>, "F_coh/R^2";
    /// Contribution of contacts that pull.
    minus: Matrix3<f64>, "F_coh/R^2";
}

summary! {
    /// Results of a compaction, in the units of its scene. The parts of `balance`, `stress`, `statistics`,
    /// `dissipation` and `energy` are listed with their meanings in docs/results.md.
    ///
    /// ```
    /// use tribos::powder::{PowderSimulation, PowderSummary};
    /// use tribos::run::Simulation;
    /// # use tribos::scene::PowderScene;
    /// # let scene = PowderScene { width: 6.0, height: 8.0, pressure: 0.02, ..PowderScene::default() };
    /// // A compaction after a hundred steps.
    /// let mut compaction = PowderSimulation::new(&scene)?;
    /// for _ in 0..100 {
    ///     compaction.step()?;
    /// }
    /// let outcome: PowderSummary = compaction.outcome();
    /// assert_eq!((outcome.ending, outcome.steps), (None, 100));
    /// // What pushes and what pulls add up.
    /// let missing = outcome.stress_zz - outcome.stress_zz_plus - outcome.stress_zz_minus;
    /// assert!(missing.abs() < 1e-12 && outcome.stress_zz_minus <= 0.0);
    /// // The work of the piston's load is lost or kept, and none is missing.
    /// let (lost, book) = (outcome.dissipation, outcome.energy);
    /// let lost = lost.normal + lost.sliding + lost.rolling + lost.torsion + lost.cohesion;
    /// let missing = book.work - lost - book.stilled.unwrap_or(0.0) - book.kinetic;
    /// assert!(missing.abs() < 1e-9 * book.work);
    /// assert_eq!(outcome.json(&scene)["steps"], 100);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub struct PowderSummary;

    /// Why the run ended; none if it has not.
    ending: Option<PackingStopReason>, "-";
    /// Porosity below the piston at the start (thesis, eq. 4.5).
    porosity_initial: f64, "-", Swept;
    /// Porosity below the piston at the end.
    porosity_final: f64, "-", Shown("porosity");
    /// Porosity in the middle half of the height, at the end.
    porosity_bulk: f64, "-", Swept;
    /// Height of the piston at the start.
    height_initial: f64, "R";
    /// Height of the piston at the end.
    height_final: f64, "R";
    /// Number of spheres.
    particles: usize, "-", Swept;
    /// Number of contacts between spheres at the end.
    contacts: usize, "-", Swept;
    /// Time at the end.
    time: f64, "sqrt(rho R^4/F_coh)";
    /// Number of steps taken.
    steps: u64, "-", Swept;
    /// Total number of sweeps.
    iterations_total: u64, "-", Swept;
    /// Steps in which any tolerance or rule was not met.
    steps_unmet: u64, "-";
    /// Steps that sweeps handed over to a solver with factorisations; left out where there are none.
    steps_handed_over: Option<u64> = optional, "-";
    /// Steps in which the solver for lasting contacts missed its stopping rule; left out without restitution.
    steps_solver_unmet: Option<u64> = optional, "-";
    /// Steps in which impacts still caused further impacts after the last round; left out without restitution.
    steps_impacts_cut: Option<u64> = optional, "-";
    /// Steps in which a reflection of impacts, or friction under it, missed its tolerance; left out without restitution.
    steps_impacts_unmet: Option<u64> = optional, "-";
    /// Mean stress_zz of all contacts over the applied pressure (thesis, table 4.1).
    stress_zz: f64, "-", Shown("stress_zz");
    /// Contribution of contacts that push.
    stress_zz_plus: f64, "-", Shown("plus");
    /// Contribution of contacts that pull.
    stress_zz_minus: f64, "-", Shown("minus");
    /// Relative residual of the contact laws in the last step.
    residual_final: f64, "-";
    /// Deepest overlap in all steps.
    max_overlap: f64, "R";
    /// What the criterion of blocked packings looks at.
    balance: PistonBalance, "-";
    /// Mean stress tensors.
    stress: MeanStress, "-";
    /// Numbers and forces of the contacts at the end.
    statistics: ContactStatistics, "-";
    /// Energy that the contacts took.
    dissipation: Dissipation, "-";
    /// Energy balance.
    energy: PackingEnergy, "-";
    /// Wall-clock time.
    wall_seconds: f64, "s";
}
