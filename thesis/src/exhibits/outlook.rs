//! Section 5.2: the questions of the outlook on contact torques in nano-powders.

mod claims;
pub mod map;
pub mod table;

use crate::exhibit::Exhibit;
use crate::runs::{Effort, Runs};
use crate::text::Text;
use anyhow::Result;
use map::{Estimate, Map};
use table::{CORNERS, COUPLINGS, PRESSURES, SPREADS, cells, name};
use tribos::scene::FrictionCoupling;
use tribos_report::figure::{Axis, Figure, Legend, Panels, ReferenceLine, Series};

const TEXT: Text = Text(include_str!("section-5.2.md"));

/// Corners at which sliding and torsion can be coupled.
const COUPLED: [[f64; 2]; 2] = [[0.0, 1.0], [1.0, 1.0]];
/// Ranges shown of porosities, and of their sums and differences in points.
const POROSITIES: (f64, f64) = (0.4, 1.0);
const POINTS: (f64, f64) = (-8.0, 4.0);

/// The map over pressure, width of the sizes and coupling.
pub fn section_5_2(runs: &Runs) -> Result<Exhibit> {
    let lines = match runs.effort() {
        Effort::Quick => table::kept()?,
        Effort::Full => table::run(runs)?,
    };
    let map = Map::new(lines);
    let claims = claims::all(runs, &map)?;
    Ok(Exhibit::new(
        TEXT.prose_of(runs.effort())
            .with("deposits", deposits(&map))
            .with("count", map.lines().len()),
        figure(&map),
        &[
            "radius_spread",
            "pressure",
            "rolling",
            "torsion",
            "coupling",
            "deposits",
            "porosity",
            "porosity_error",
            "excess",
            "excess_error",
        ],
        rows(&map),
        claims,
    )
    .kept("exhibits/outlook/runs.csv"))
}

/// "2 to 3 deposits a cell".
fn deposits(map: &Map) -> String {
    let counts = cells().map(|cell| map.excess(cell, FrictionCoupling::Independent).values.len());
    let counts: Vec<usize> = counts.collect();
    match (counts.iter().min(), counts.iter().max()) {
        (Some(least), Some(most)) if least < most => format!("{least} to {most} deposits a cell"),
        (Some(1), _) => "one deposit a cell".into(),
        (Some(count), _) => format!("{count} deposits a cell"),
        _ => String::new(),
    }
}

/// Porosities, sums and differences; a row of panels a width.
fn figure(map: &Map) -> Panels {
    let columns: [fn(&Map, f64) -> Figure; 3] = [porosities, excesses, couplings];
    let mut panels = Panels::new("", columns.len() as u32).cell(366, 330);
    for spread in SPREADS {
        for column in columns {
            panels = panels.figure(column(map, spread));
        }
    }
    panels
}

/// A curve over the pressure with the standard errors of its means.
fn curve(label: String, factor: f64, of: impl Fn(f64) -> Estimate) -> Series {
    let estimates = PRESSURES.map(of);
    let means = estimates.iter().map(|estimate| factor * estimate.mean());
    let errors = estimates.iter().map(|estimate| factor * estimate.error());
    Series::line_points(label, PRESSURES.into_iter().zip(means).collect()).errors(errors.collect())
}

fn axes(title: String, y: Axis) -> Figure {
    Figure::new(title, Axis::log10("P R²/F_coh"), y)
}

fn porosities(map: &Map, spread: f64) -> Figure {
    let (low, high) = POROSITIES;
    let y = Axis::linear("final porosity").range(low, high);
    let title = format!("radii 1 ± {spread}");
    CORNERS.into_iter().fold(axes(title, y), |figure, corner| {
        let [rolling, torsion] = corner;
        figure.series(curve(format!("({rolling}, {torsion})"), 1.0, |pressure| {
            map.porosity((spread, pressure), corner, FrictionCoupling::Independent)
        }))
    })
}

fn excesses(map: &Map, spread: f64) -> Figure {
    let (low, high) = POINTS;
    let y = Axis::linear("ΔE [points]").range(low, high);
    let figure = COUPLINGS
        .into_iter()
        .fold(axes(String::new(), y), |figure, coupling| {
            figure.series(curve(name(coupling).into(), 100.0, |pressure| {
                map.excess((spread, pressure), coupling)
            }))
        });
    figure.guide(ReferenceLine::horizontal(0.0, ""))
}

fn couplings(map: &Map, spread: f64) -> Figure {
    let (low, high) = POINTS;
    let y = Axis::linear("coupled − independent [points]").range(low, high);
    let mut figure = axes(String::new(), y).legend(Legend::default());
    for corner in COUPLED {
        for coupling in &COUPLINGS[1..] {
            let [rolling, torsion] = corner;
            let label = format!("{}, ({rolling}, {torsion})", name(*coupling));
            figure = figure.series(curve(label, 100.0, |pressure| {
                map.coupled((spread, pressure), corner, *coupling)
            }));
        }
    }
    figure.guide(ReferenceLine::horizontal(0.0, ""))
}

/// One line a cell, corner and coupling; couplings by their number.
fn rows(map: &Map) -> Vec<Vec<f64>> {
    let mut rows = Vec::new();
    for cell in cells() {
        for corner in CORNERS {
            let couplings = if corner[1] > 0.0 {
                &COUPLINGS[..]
            } else {
                &COUPLINGS[..1]
            };
            for (at, &coupling) in couplings.iter().enumerate() {
                let porosity = map.porosity(cell, corner, coupling);
                let excess = map.excess(cell, coupling);
                rows.push(vec![
                    cell.0,
                    cell.1,
                    corner[0],
                    corner[1],
                    at as f64,
                    porosity.values.len() as f64,
                    porosity.mean(),
                    porosity.error(),
                    excess.mean(),
                    excess.error(),
                ]);
            }
        }
    }
    rows
}
