//! Pictures of grains in a box: the packing at both ends, and series over time.

use super::powder::State;
use crate::drawing_grid::DrawingGrid;
use crate::figure::{Axis, Figure, Panels, Series};
use crate::packing::{PackingError, PackingPicture};
use tribos::grains::{COLUMNS, GrainsSimulation};

/// Initial and final grains in one scale, and the final forces.
pub fn packing(
    before: &GrainsSimulation,
    after: &GrainsSimulation,
) -> Result<DrawingGrid, PackingError> {
    let ends = [before, after].map(|grains| grains.with_snapshot(State::of));
    let tops = [before, after].map(|grains| grains.with_snapshot(|state| state.extents[2][1]));
    let top = tops[0].max(tops[1]);
    let periods = before.with_snapshot(|state| {
        let [x, y, _] = state.extents.map(|[low, high]| high - low);
        [x, y]
    });
    let heights: Vec<f64> = ends[0].positions.iter().map(|[_, _, z]| *z).collect();
    let packings = [ends[0].open(periods)?, ends[1].open(periods)?];
    let picture = |name: &str, index: usize| {
        let picture = PackingPicture::spheres(name, &packings[index]).headroom(top);
        picture.color_by(Axis::linear("initial height [m]"), &heights)
    };
    let full = ends[1].largest_force();
    let forces = PackingPicture::forces("Final forces", &packings[1], ends[1].contacts())?
        .full_force(full, "")
        .headroom(top);
    Ok(DrawingGrid::new(format!("{} grains", heights.len()), 3)
        .drawing(picture("Initial", 0)?)
        .drawing(picture("Final", 1)?)
        .drawing(forces))
}

/// Solid fraction, forces, stresses and energies over time.
pub fn series(grains: &GrainsSimulation) -> Panels {
    let rows = grains.series();
    let column = |name: &str| COLUMNS.iter().position(|known| *known == name);
    let curve = |name: &str| -> Vec<(f64, f64)> {
        let column = column(name).unwrap_or_default();
        rows.iter().map(|row| (row[0], row[column])).collect()
    };
    let panel = |axis: &str, names: &[(&str, &str)]| {
        let figure = Figure::new("", Axis::linear("time [s]"), Axis::linear(axis));
        names.iter().fold(figure, |figure, (label, name)| {
            figure.series(Series::line(*label, curve(name)))
        })
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
