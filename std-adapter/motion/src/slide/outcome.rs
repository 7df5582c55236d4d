//! The summary of a slide.

use tribos_base::results::{Reporting::*, summary};
use tribos_base::scene::words::words;
use tribos_core::modes::TerminalMode;

/// Columns of the series.
pub(super) const COLUMNS: [&str; 8] = [
    "time",
    "speed",
    "spin",
    "distance",
    "angle",
    "ratio",
    "kinetic_energy",
    "dissipated_energy",
];

/// Why a run ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SlideStopReason {
    /// Sliding and spinning stopped at the same instant.
    Rest,
    /// Both speeds fell below the scene's `stop_fraction`; under a law with α ≥ 1 the body never comes to rest.
    Faded,
    /// The scene's `duration` elapsed.
    Duration,
}
words!(SlideStopReason { Rest = "rest", Faded = "faded", Duration = "duration" });

summary! {
    /// Results of a run of a disk, in the units of its scene.
    ///
    /// ```
    /// use tribos::scene::DiskScene;
    /// use tribos::slide::{SlideStopReason, SlideSummary};
    /// let scene = DiskScene::default(); // 1 m/s, 5 rad/s, 8 cm, 0.1 kg
    /// let end: SlideSummary = scene.run()?.outcome;
    /// assert_eq!(end.ending, SlideStopReason::Rest);
    /// // A disk under Coulomb friction stops at v = 0.653 ωR, whatever the launch.
    /// assert!((end.final_ratio - 0.653).abs() < 1e-3);
    /// assert!(end.final_mode == "together" && (end.limit_ratio - end.final_ratio).abs() < 1e-6);
    /// let energy = 0.5 * 0.1 * (1.0 + 0.5 * 0.4 * 0.4); // M (v² + C (ωR)²)/2
    /// assert!((end.initial_energy - energy).abs() < 1e-15);
    /// assert!((end.energy_dissipated - energy).abs() < 1e-9 * energy);
    /// assert_eq!(end.json(&scene)["ending"], "rest");
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[derive(Copy)]
    pub struct SlideSummary;

    /// Why the run ended.
    ending: SlideStopReason, "-";
    /// Time at which the body comes to rest; none if it does not.
    stop_time: Option<f64>, "s";
    /// Time at the end.
    end_time: f64, "s", Shown("time");
    /// Distance covered.
    distance: f64, "m", Shown("distance");
    /// Angle turned.
    angle: f64, "rad", Shown("angle");
    /// Velocity ratio v/(|ω|R) at the end; its limit if the body comes to rest.
    final_ratio: f64, "-", Shown("final ratio");
    /// The same as the theory of fixed points predicts it.
    limit_ratio: f64, "-", Swept;
    /// Final motion that the theory predicts: `sliding`, `spinning`, or both `together`.
    final_mode: &'static str, "-";
    /// Number of steps taken.
    steps: u64, "-", Swept;
    /// Kinetic energy at the launch.
    initial_energy: f64, "J", Swept;
    /// Work of friction, integrated from its power.
    energy_dissipated: f64, "J", Swept;
    /// |work − loss of kinetic energy| / initial energy.
    energy_error: f64, "-", Swept;
}

/// Velocity ratio and name of a final motion.
pub(super) fn terminal(mode: TerminalMode<f64>) -> (f64, &'static str) {
    match mode {
        TerminalMode::Spinning => (0.0, "spinning"),
        TerminalMode::Sliding => (f64::INFINITY, "sliding"),
        TerminalMode::Together { ratio } => (ratio, "together"),
    }
}
