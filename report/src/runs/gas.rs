//! Pictures of a gas: its spheres at the end, and temperatures, energies and clusters over the collisions.

use crate::figure::{Axis, Figure, Panels, Series};
use crate::packing::{Packing, PackingError, PackingPicture};
use tribos::gas::{COLUMNS, GasSimulation};
use tribos::record::Snapshot;
use tribos::run::PackingRunError;

/// Why the spheres of a gas cannot be drawn.
#[derive(Debug, thiserror::Error)]
pub enum GasPictureError {
    /// The gas has no state.
    #[error(transparent)]
    Gas(#[from] PackingRunError),
    /// The spheres cannot be drawn.
    #[error(transparent)]
    Packing(#[from] PackingError),
}

/// The spheres, coloured by speed.
pub fn spheres(gas: &GasSimulation) -> Result<PackingPicture, GasPictureError> {
    let title = format!("Gas after {:.4} collisions a sphere", gas.collisions());
    let picture = gas.with_snapshot(|now: &Snapshot<'_>| {
        let places: Vec<[f64; 3]> = now.positions.iter().map(|x| [x.x, x.y, x.z]).collect();
        let velocities = now.velocities.unwrap_or_default().iter();
        let speeds: Vec<f64> = velocities.map(|velocity| velocity.norm()).collect();
        let packing = Packing::new(&places, now.radii, [gas.length(); 2], None)?;
        let picture = PackingPicture::spheres(title, &packing).bare();
        picture.color_by(Axis::linear("speed [√(T₀/m)]"), &speeds)
    })?;
    Ok(picture?)
}

/// Temperatures beside theory, over collisions and over time, and the clusters.
pub fn series(gas: &GasSimulation) -> Panels {
    let rows = gas.series();
    let column = |name: &str| {
        COLUMNS
            .iter()
            .position(|column| *column == name)
            .unwrap_or(0)
    };
    let curve = |x: &str, y: &str| {
        let (x, y) = (column(x), column(y));
        let points = rows.iter().map(|row| (row[x], row[y]));
        points.collect::<Vec<(f64, f64)>>()
    };
    let later = |x: &str, y: &str| -> Vec<(f64, f64)> {
        let points = curve(x, y).into_iter();
        points.filter(|&(x, y)| x > 0.0 && y > 0.0).collect()
    };
    let is_rough = rows
        .iter()
        .any(|row| row[column("temperature_rotational")] > 0.0);
    let collisions = || Axis::linear("collisions a sphere");
    let mut temperature = Figure::new("", collisions(), Axis::log10("temperature [T₀]"))
        .series(Series::line(
            "translational",
            curve("collisions", "temperature"),
        ))
        .series(Series::dashed("mean field", curve("collisions", "theory")));
    if is_rough {
        let drawn = |y| later("collisions", y);
        temperature = temperature
            .series(Series::line("rotational", drawn("temperature_rotational")))
            .series(Series::dashed(
                "mean field, rotational",
                drawn("theory_rotational"),
            ));
    }
    let time = || Axis::log10("time [R√(m/T₀)]");
    let haff = Figure::new("", time(), Axis::log10("temperature [T₀]"))
        .series(Series::line("translational", later("time", "temperature")))
        .series(Series::dashed("Haff", later("time", "haff")));
    let energies = Figure::new("", collisions(), Axis::linear("energy a sphere [T₀]"))
        .series(Series::line("kinetic", curve("collisions", "energy")))
        .series(Series::line("lost", curve("collisions", "lost")));
    let clusters = Figure::new(
        "",
        collisions(),
        Axis::linear("variance over mean of counts"),
    )
    .series(Series::line("", curve("collisions", "density_variance")));
    Panels::new("", 2)
        .figure(temperature)
        .figure(haff)
        .figure(energies)
        .figure(clusters)
}
