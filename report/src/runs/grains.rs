//! Pictures of grains in a box: the packing at both ends, and series over time.

use super::packing::{State, both, over_time};
use crate::drawing_grid::DrawingGrid;
use crate::figure::Panels;
use crate::packing::PackingError;
use tribos::grains::{COLUMNS, GrainsSimulation, plates};

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
    let top = low.max(high);
    let corners = [0, 1].map(|end| extents[0].map(|ends| ends[end]));
    let plates = plates(&before.scene().json(), corners);
    both(
        [&name, "initial height [m]", ""],
        &ends,
        [x, y],
        (top, &plates),
    )
}

/// Solid fraction, forces, stresses and energies over time; the stress ratio of what is sheared, the mass out of a hopper.
pub fn series(grains: &GrainsSimulation) -> Panels {
    let panel = |axis: &str, curves: &[(&str, &str)]| {
        over_time((grains.series(), COLUMNS), ["time [s]", axis], curves)
    };
    let is_ever = |name: &str| {
        let column = COLUMNS.iter().position(|column| *column == name);
        column.is_some_and(|at| grains.series().iter().any(|row| row[at] != 0.0))
    };
    let more = [
        ("shear stress over normal stress", "stress_ratio"),
        ("mass below the slot [kg]", "discharged"),
    ];
    let more = more.into_iter().filter(|(_, column)| is_ever(column));
    let usual = Panels::new("", 2)
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
        ));
    more.fold(usual, |panels, (axis, column)| {
        panels.figure(panel(axis, &[("", column)]))
    })
}
