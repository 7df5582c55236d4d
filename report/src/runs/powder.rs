//! Pictures of a compaction: the packing at both ends, and series over time.

pub use super::packing::State;

use super::packing::{both, over_time};
use crate::drawing_grid::DrawingGrid;
use crate::figure::{Panels, ReferenceLine};
use crate::packing::PackingError;
use tribos::powder::{COLUMNS, PowderSimulation, PowderSummary};
use tribos::scene::PowderScene;

/// Initial and final spheres in one scale, and the final forces.
pub fn packing(
    scene: &PowderScene,
    [before, after]: &[State; 2],
    outcome: &PowderSummary,
) -> Result<DrawingGrid, PackingError> {
    let porosity = [outcome.porosity_initial, outcome.porosity_final];
    let [first, last] = porosity.map(|porosity| 100.0 * porosity);
    let (mu, mu_t, mu_n) = (scene.mu, scene.mu_rolling, scene.mu_torsion);
    let name = format!("Compaction, μ = {mu}, μ_t = {mu_t}, μ_n = {mu_n}");
    let (start, end) = (outcome.height_initial, outcome.height_final);
    let ends = [
        (before, format!("Initial, {first:.1} % empty"), Some(start)),
        (after, format!("Final, {last:.1} % empty"), Some(end)),
    ];
    let words = [&name, "initial height", "F_coh"];
    both(words, &ends, [scene.width; 2], (start, &[]))
}

/// Porosity, stress and energies over time.
pub fn series(compaction: &PowderSimulation) -> Panels {
    let over_time = |axis: &str, curves: &[(&str, &str)]| {
        let axes = ["time [√(ρR⁴/F_coh)]", axis];
        over_time((compaction.series(), COLUMNS), axes, curves)
    };
    let porosity = over_time("porosity", &[("", "porosity")])
        .guide(ReferenceLine::horizontal(compaction.porosity(), ""));
    let stress = over_time("σ_zz of the pressure", &[("", "stress_zz")])
        .guide(ReferenceLine::horizontal(1.0, "applied"));
    let energies = over_time(
        "energy [F_coh R]",
        &[
            ("work", "work"),
            ("normal", "dissipated_normal"),
            ("sliding", "dissipated_sliding"),
            ("rolling", "dissipated_rolling"),
            ("torsion", "dissipated_torsion"),
            ("cohesion", "dissipated_cohesion"),
        ],
    );
    Panels::new("", 2)
        .figure(porosity)
        .figure(stress)
        .figure(over_time("contacts", &[("", "contacts")]))
        .figure(energies)
}

impl State {
    /// The initial deposit and the current state.
    pub fn both(compaction: &PowderSimulation) -> [Self; 2] {
        let before = Self::of(&compaction.deposit().snapshot(&[]));
        [before, compaction.with_snapshot(Self::of)]
    }
}
