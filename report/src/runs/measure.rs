//! Measures of a packing as figures.

use crate::figure::{Axis, Figure, Panels, ReferenceLine, Series};
use tribos::measure::{Layer, LayerProfile, Measures, Table};
use tribos::statistics::TimeAverage;

/// The figures of a state with the names of their files.
pub fn figures(measures: &Measures) -> Vec<(&'static str, Figure)> {
    let mut figures = vec![
        (
            "pair-correlation",
            drawn(&measures.pairs.table(), [0, 1], ["r", "g(r)"])
                .guide(ReferenceLine::horizontal(1.0, "")),
        ),
        (
            "coordination",
            drawn(
                &measures.coordination.table(),
                [0, 1],
                ["contacts of a sphere", "spheres"],
            ),
        ),
        ("porosity-profile", profile(measures)),
    ];
    if let Some(forces) = &measures.forces {
        figures.push((
            "forces",
            force_distribution(&forces.table(), forces.tail[0]),
        ));
    }
    if let Some(chains) = &measures.chains {
        let labels = ["spheres in a chain", "chains"];
        figures.push(("force-chains", drawn(&chains.table(), [0, 1], labels)));
    }
    figures
}

/// A series of measures over the steps.
pub fn series(table: &Table) -> Panels {
    let panel = |column: usize, label: &str| drawn(table, [0, column], ["step", label]);
    Panels::new("", 2)
        .figure(panel(1, "porosity"))
        .figure(panel(2, "pressure"))
        .figure(panel(5, "contacts of a sphere"))
        .figure(panel(4, "anisotropy of the fabric"))
        .figure(panel(10, "mean length of force chains"))
        .figure(panel(14, "buckled triples of force chains"))
}

/// The profile of a flow: velocity, solid fraction, stress and its ratio in the layers, with standard errors.
pub fn layers(profile: &LayerProfile) -> Panels {
    let axis = ["x", "y", "z"][profile.axis];
    let across = format!("stress {axis}{axis}");
    let of = |label: &str, mean: &dyn Fn(&Layer) -> TimeAverage| {
        let layers = || {
            profile
                .layers
                .iter()
                .filter(|layer| mean(layer).mean.is_finite())
        };
        let middle = |layer: &Layer| 0.5 * (layer.ends[0] + layer.ends[1]);
        let points = layers().map(|layer| (middle(layer), mean(layer).mean));
        let errors = layers().map(|layer| mean(layer).error);
        let line = Series::line_points("", points.collect()).errors(errors.collect());
        Figure::new("", Axis::linear(axis), Axis::linear(label)).series(line)
    };
    Panels::new("", 2)
        .figure(of("velocity x", &|layer| layer.velocity[0]))
        .figure(of("solid fraction", &|layer| layer.solid_fraction))
        .figure(of(&across, &|layer| layer.stress[profile.axis]))
        .figure(of("shear stress over normal stress, -xz/zz", &|layer| {
            layer.stress_ratio
        }))
}

/// Two columns of a table.
fn drawn(table: &Table, [x, y]: [usize; 2], [x_label, y_label]: [&str; 2]) -> Figure {
    let point = |row: &Vec<f64>| (row[x], row[y]);
    let points = table.rows.iter().map(point).collect();
    Figure::new("", Axis::linear(x_label), Axis::linear(y_label))
        .series(Series::line_points("", points))
}

/// Porosity against the middle of the slices.
fn profile(measures: &Measures) -> Figure {
    let axis = ["x", "y", "z"][measures.profile.axis];
    let middle = |slice: &[f64; 4]| (0.5 * (slice[0] + slice[1]), slice[2]);
    let points = measures.profile.slices.iter().map(middle).collect();
    Figure::new("", Axis::linear(axis), Axis::linear("porosity"))
        .series(Series::line_points("", points))
        .guide(ReferenceLine::horizontal(measures.porosity, "mean"))
}

/// Density on a logarithmic axis with the fitted tail from the mean on.
fn force_distribution(table: &Table, decay: f64) -> Figure {
    let points: Vec<(f64, f64)> = table.rows.iter().map(|row| (row[0], row[1])).collect();
    let width = points.get(1).map_or(1.0, |second| second.0 - points[0].0);
    let above = points.iter().filter(|point| point.0 > 1.0);
    let share: f64 = above.map(|point| point.1 * width).sum();
    let last = points.last().map_or(1.0, |point| point.0);
    let tail = [1.0, last].map(|f| (f, share * decay * (-decay * (f - 1.0)).exp()));
    Figure::new(
        "",
        Axis::linear("normal force over its mean"),
        Axis::log10("probability density"),
    )
    .series(Series::points("contacts that push", points))
    .series(Series::dashed("exponential tail", tail.to_vec()))
}
