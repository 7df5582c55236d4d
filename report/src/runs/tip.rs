//! Pictures of a tip: its atoms, coloured by part, the angles over time of a turned one and the
//! friction loop of a slid one.

use crate::drawing_grid::DrawingGrid;
use crate::figure::{Axis, Color, Figure, Panels, ReferenceLine, Series};
use crate::packing::{Packing, PackingError, PackingPicture};
use crate::player::PART_COLORS;
use nalgebra::Vector3;
use tribos::scene::{DriveKind, TipScene};
use tribos::tip::{AtomRole, Shape, TipSimulation, TipSummary};

/// Colour of one marked atom in each part of the tip, which shows its rotation.
const MARK: Color = Color(250, 205, 30);

/// Colours of all atoms.
pub fn colors(shape: &Shape) -> Vec<Color> {
    let sites = shape.sites();
    let mut colors: Vec<_> = sites
        .iter()
        .map(|site| {
            let part = AtomRole::ALL.iter().position(|&part| part == site.part);
            PART_COLORS[part.unwrap_or_default()]
        })
        .collect();
    for atom in shape.marked() {
        colors[atom] = MARK;
    }
    colors
}

/// The system of a scene, with its atoms at given positions.
pub fn atoms(
    title: &str,
    scene: &TipScene,
    positions: &[Vector3<f64>],
) -> Result<PackingPicture, PackingError> {
    let shape = scene.shape();
    let lengths = shape.periods();
    let places: Vec<[f64; 3]> = positions
        .iter()
        .map(|place| [place.x, place.y, place.z])
        .collect();
    let radii = vec![0.5 * shape.spacing; places.len()];
    let packing = Packing::new(&places, &radii, lengths, None)?;
    let picture = PackingPicture::spheres(title, &packing).bare();
    picture.colors(&colors(&shape))
}

/// Before and after.
pub fn both_ends(scene: &TipScene, run: &TipSimulation) -> Result<DrawingGrid, PackingError> {
    let start: Vec<Vector3<f64>> = scene
        .shape()
        .sites()
        .iter()
        .map(|site| site.place)
        .collect();
    let end = &run.system().atoms().positions;
    let title = format!("Tip on a substrate, {}", title(scene));
    Ok(DrawingGrid::new(title, 2)
        .drawing(atoms("Crystal", scene, &start)?.size(620, 480))
        .drawing(atoms("End", scene, end)?.size(620, 480)))
}

/// The drive of a scene.
fn title(scene: &TipScene) -> String {
    match (scene.drive, scene.speed) {
        (DriveKind::Slide, Some(speed)) => format!("support at speed {speed}"),
        _ => format!("λ = {}", scene.lambda),
    }
}

/// A turned tip: angle of the driven layers, and of each layer of the tip, over time. A slid one:
/// its friction loop, and its forces, height and temperatures over time.
pub fn series(scene: &TipScene, run: &TipSimulation, outcome: &TipSummary) -> Panels {
    match scene.drive {
        DriveKind::Torque => turned(scene, run, outcome),
        DriveKind::Slide => slid(scene, run),
    }
}

/// Column of a series by its name, over another.
fn curve(run: &TipSimulation, x: &str, y: &str) -> Vec<(f64, f64)> {
    let columns = run.columns();
    let number = |name: &str| columns.iter().position(|column| column == name);
    let (Some(x), Some(y)) = (number(x), number(y)) else {
        return Vec::new();
    };
    run.series().iter().map(|row| (row[x], row[y])).collect()
}

/// Units of length, time, energy and temperature.
fn units(scene: &TipScene) -> [&'static str; 4] {
    if scene.potential.is_metal() {
        ["Å", "ps", "eV", "K"]
    } else {
        ["σ", "σ√(m/ε)", "ε", "ε/k_B"]
    }
}

fn slid(scene: &TipScene, run: &TipSimulation) -> Panels {
    let [length, time, energy, heat] = units(scene);
    let time = || Axis::linear(format!("time [{time}]"));
    let driven: Vec<(f64, f64)> = curve(run, "time", "support")
        .into_iter()
        .zip(curve(run, "support", "lateral_force"))
        .filter(|((time, _), _)| (0.0..=scene.drive_time).contains(time))
        .map(|(_, point)| point)
        .collect();
    let friction = Figure::new(
        "Friction loop",
        Axis::linear(format!("support [{length}]")),
        Axis::linear(format!("lateral force [{energy}/{length}]")),
    )
    .series(Series::line("", driven));
    let ways = Figure::new(
        "Ways along the drive",
        time(),
        Axis::linear(format!("way [{length}]")),
    )
    .series(Series::line("support", curve(run, "time", "support")))
    .series(Series::line("tip", curve(run, "time", "tip")));
    let work = Figure::new("", time(), Axis::linear(format!("energy [{energy}]")))
        .series(Series::line("work", curve(run, "time", "work")))
        .series(Series::line("heat", curve(run, "time", "heat")));
    let heat = Figure::new("", time(), Axis::linear(format!("temperature [{heat}]")))
        .series(Series::line(
            "substrate",
            curve(run, "time", "substrate_temperature"),
        ))
        .series(Series::line("tip", curve(run, "time", "tip_temperature")));
    Panels::new(title(scene), 2)
        .figure(friction)
        .figure(ways)
        .figure(work)
        .figure(heat)
}

fn turned(scene: &TipScene, run: &TipSimulation, outcome: &TipSummary) -> Panels {
    let rows = run.series();
    let first = rows.first().map_or(0, Vec::len) - scene.tip_layers;
    let curve = |column: usize| rows.iter().map(|row| (row[0], row[column])).collect();
    let time = || Axis::linear("time [σ√(m/ε)]");
    let end = scene.drive_time;
    let mut driven = Figure::new("Driven layers", time(), Axis::linear("angle [degree]"))
        .series(Series::line("", curve(1)))
        .guide(ReferenceLine::vertical(end, "off"));
    for plateau in &outcome.plateaus {
        driven = driven.guide(ReferenceLine::horizontal(plateau.angle_degrees, ""));
    }
    let mut layers = Figure::new("Layers of the tip", time(), Axis::linear("angle [degree]"))
        .guide(ReferenceLine::vertical(end, "off"));
    for layer in 0..scene.tip_layers {
        layers = layers.series(Series::line(format!("{}", layer + 1), curve(first + layer)));
    }
    let torque = Figure::new("", time(), Axis::linear("resisting torque [ε]"))
        .series(Series::line("", curve(2)))
        .guide(ReferenceLine::vertical(end, "off"));
    let heat = Figure::new("", time(), Axis::linear("temperature [ε/k_B]"))
        .series(Series::line("substrate", curve(4)))
        .series(Series::line("tip", curve(5)));
    Panels::new(format!("λ = {}", scene.lambda), 2)
        .figure(driven)
        .figure(layers)
        .figure(torque)
        .figure(heat)
}
