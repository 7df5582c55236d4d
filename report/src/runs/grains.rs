//! Pictures of grains in a box: the packing at both ends, and series over time.

use super::packing::{State, both, over_time};
use crate::drawing_grid::DrawingGrid;
use crate::figure::Panels;
use crate::packing::PackingError;
use tribos::grains::{COLUMNS, GrainsSimulation};

/// Initial and final grains in one scale, and the final forces.
pub fn packing(
    before: &GrainsSimulation,
    after: &GrainsSimulation,
) -> Result<DrawingGrid, PackingError> {
    let [first, last] = [before, after].map(|grains| grains.with_snapshot(State::of));
    let extents = [before, after].map(|grains| grains.with_snapshot(|state| state.extents));
    let [x, y, _] = extents[0].map(|[low, high]| high - low);
    let [low, high] = extents.map(|[_, _, [_, top]]| top);
    let name = format!("{} grains", first.positions.len());
    let ends = [
        (&first, "Initial".into(), None),
        (&last, "Final".into(), None),
    ];
    both(
        [&name, "initial height [m]", ""],
        &ends,
        [x, y],
        low.max(high),
    )
}

/// Solid fraction, forces, stresses and energies over time.
pub fn series(grains: &GrainsSimulation) -> Panels {
    let panel = |axis: &str, curves: &[(&str, &str)]| {
        over_time((grains.series(), COLUMNS), ["time [s]", axis], curves)
    };
    Panels::new("", 2)
        .figure(panel("solid fraction", &[("", "solid_fraction")]))
        .figure(panel(
            "force [N]",
            &[
                ("floor", "floor_force"),
                ("plate", "plate_force"),
                ("side x", "side_force_x"),
            ],
        ))
        .figure(panel(
            "stress [Pa]",
            &[
                ("xx", "stress_xx"),
                ("zz", "stress_zz"),
                ("plate, shear", "shear_stress"),
            ],
        ))
        .figure(panel(
            "energy [J]",
            &[
                ("work", "work"),
                ("kinetic", "kinetic"),
                ("normal", "dissipated_normal"),
                ("sliding", "dissipated_sliding"),
                ("rolling", "dissipated_rolling"),
            ],
        ))
}
