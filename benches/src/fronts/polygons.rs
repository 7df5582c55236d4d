//! Flat feet: closed forms, nodes, ellipsoid, convex quartic and sampled hull.

use super::{Finding, Front, Setting};
use crate::outlines::{Method, SLOPED, Shape, methods, shapes};
use crate::picture::{self, PicturePoint};
use crate::timing::{self, Samples, Task};
use crate::written::{Sheet, short};
use std::hint::black_box;
use tribos_core::coupling::flat::{PatchShape, ShapeFriction};
use tribos_core::coupling::{RoundFriction, coulomb::CoulombDisk};
use tribos_core::twist::{Twist, Wrench};

const ROUNDS: usize = 31;
const QUICK_ROUNDS: usize = 3;
/// Twists that are timed and judged.
const TWISTS: usize = 1000;
/// Distances of their centres of rotation, in radii, evenly spread in the logarithm.
const DISTANCES: [f64; 2] = [0.01, 100.0];
/// Errors below rounding are drawn at it.
const ROUNDING: f64 = 1e-17;
const UNIT: &str = "disk by table";
const PICTURE: &str = "polygons.svg";
const EXACT: &str = "closed";

/// One method on one shape.
struct Row {
    shape: String,
    method: &'static str,
    points: usize,
    /// Largest and root mean square error, of μN and μN R.
    error: [f64; 2],
    judge: &'static str,
}

/// Makes the front.
pub fn run(setting: &Setting<'_>) -> Result<Finding, String> {
    let (mut rows, mut tasks) = (Vec::new(), vec![unit()?]);
    for shape in shapes() {
        let exact = ShapeFriction::new(shape.patch::<f64>(), 1.0).map_err(|e| e.to_string())?;
        let twists = twists(exact.patch().radius());
        for method in methods(&shape)? {
            rows.push(judged(&shape, &exact, &method, &twists));
            let (twists, name) = (twists.clone(), (rows.len() - 1).to_string());
            tasks.push(timed(name, twists, method.wrench));
        }
    }
    let rounds = if setting.quick { QUICK_ROUNDS } else { ROUNDS };
    let samples = timing::interleaved(tasks, rounds);
    let sheet = sheet(&rows, &samples, rounds);
    setting.table("polygons", &sheet)?;
    let body = format!(
        "![Time against error]({PICTURE})\n\n{LEGEND}\n{}",
        sheet.markdown()
    );
    setting.page(Front::Polygons, &body)?;
    let known = rows
        .iter()
        .enumerate()
        .filter(|(_, row)| !row.error[0].is_nan());
    let places = known.map(|(index, row)| PicturePoint {
        label: row.shape.clone(),
        group: row.method.into(),
        at: (
            samples.ratio(&index.to_string(), UNIT).unwrap_or(f64::NAN),
            row.error[0].max(ROUNDING),
        ),
    });
    let axes = ["time, of the disk's form", "largest error, of μN and μN R"];
    let title = "Coulomb friction of flat feet";
    picture::scatter(setting.out, "polygons", title, axes, places.collect())?;
    Ok(Finding {
        line: line(&rows, &samples),
        picture: PICTURE,
    })
}

/// Twists about the centroid.
fn twists(radius: f64) -> Vec<Twist<f64>> {
    let [least, most] = DISTANCES.map(f64::ln);
    let twist = |i: usize| {
        // A full period of the distances, in an order that angles do not follow.
        let part = (i * 387 % TWISTS) as f64 / (TWISTS - 1) as f64;
        let distance = radius * (least + (most - least) * part).exp();
        let angle = 2.4 * i as f64;
        let sense = if i.is_multiple_of(2) { 1.0 } else { -1.0 };
        Twist::new(
            sense * distance * angle.sin(),
            -sense * distance * angle.cos(),
            sense,
        )
    };
    (0..TWISTS).map(twist).collect()
}

/// The larger error of force (of μN = 1) and torque (of μN R).
fn error(found: &Wrench<f64>, [x, y, torque]: [f64; 3], radius: f64) -> f64 {
    let force = (found.force.x - x).hypot(found.force.y - y);
    force.max((found.torque - torque).abs() / radius)
}

fn judged(
    shape: &Shape,
    exact: &ShapeFriction<f64, impl PatchShape<f64>>,
    method: &Method,
    twists: &[Twist<f64>],
) -> Row {
    let radius = exact.patch().radius();
    let is_exact = method.name.starts_with(EXACT) && !method.name.ends_with("f32");
    let is_sloped = method.name == SLOPED;
    let mut references = if is_exact {
        shape.references()
    } else {
        Vec::new()
    };
    references.retain(|one| (one.slope != [0.0; 2]) == is_sloped);
    let (errors, judge): (Vec<f64>, _) = if is_exact {
        let errors = references.iter().map(|one| {
            let found = if is_sloped {
                shape.sloped(one.slope).wrench(1.0, &one.twist)
            } else {
                (method.wrench)(&one.twist)
            };
            error(&found, one.wrench, radius)
        });
        (
            errors.collect(),
            if references.is_empty() {
                "none"
            } else {
                "150 digits"
            },
        )
    } else {
        let errors = twists.iter().map(|twist| {
            let wanted = exact.wrench(1.0, twist);
            let wanted = [wanted.force.x, wanted.force.y, wanted.torque];
            error(&(method.wrench)(twist), wanted, radius)
        });
        (errors.collect(), EXACT)
    };
    let largest = errors.iter().copied().fold(f64::NAN, f64::max);
    let squares: f64 = errors.iter().map(|error| error * error).sum();
    Row {
        shape: shape.name.clone(),
        method: method.name,
        points: method.points,
        error: [largest, (squares / errors.len() as f64).sqrt()],
        judge,
    }
}

fn unit() -> Result<Task<'static>, String> {
    let disk = RoundFriction::new(CoulombDisk, 1.0, 1.0).map_err(|error| error.to_string())?;
    let wrench = move |twist: &Twist<f64>| disk.wrench(1.0, twist);
    Ok(timed(UNIT.into(), twists(1.0), wrench))
}

fn timed(
    name: String,
    twists: Vec<Twist<f64>>,
    wrench: impl Fn(&Twist<f64>) -> Wrench<f64> + 'static,
) -> Task<'static> {
    let mut results = vec![Wrench::ZERO; twists.len()];
    Task::new(name, twists.len(), move || {
        for (twist, result) in black_box(&twists).iter().zip(&mut results) {
            *result = wrench(twist);
        }
        black_box(&mut results);
    })
}

const LEGEND: &str = "\
Force and torque about the centroid for a given twist. The centres of 1000 twists lie 0.01 to 100 radii from the \
centroid, in every direction, evenly in the logarithm of the distance; times are means over them. `x` is the time in \
units of the disk's Coulomb form over the same twists, the median of the rounds' own ratios. Errors are of μN and \
μN R. The closed form in f64 is judged by the tests' table of 150 digits (centres on corners and edges and up to \
1e16 radii away; torques beyond some radii of the centroid carry the rounding of the twist's own coordinates), all \
other methods by the closed form. Linear pressure is judged under the slopes of the table, which go up to 0.99 of the \
steepest one, and timed under two thirds of the mean pressure a radius; all else is under uniform pressure. `points` \
are edges, nodes, or sampled wrenches. The ellipsoid has the exact largest force and torque; the hull answers with the sampled wrench that dissipates most, as planners do; the convex quartic is fitted to 400 \
wrenches, as `tribos fit` does with `--support`. It gives the motion under a push at once; the push for a motion, which \
stands here, takes Newton's method.
";

fn sheet(rows: &[Row], samples: &Samples, rounds: usize) -> Sheet {
    let medians = samples.medians();
    let ratio = |index: usize| samples.ratio(&index.to_string(), UNIT).unwrap_or(f64::NAN);
    Sheet::of(
        format!("Shape and method: medians of {rounds} interleaved rounds"),
        rows.iter().enumerate(),
        &[
            ("shape", &|(_, row)| row.shape.clone()),
            ("method", &|(_, row)| row.method.into()),
            ("points", &|(_, row)| row.points.to_string()),
            // The unit is the first task.
            ("ns", &|(index, _)| short(1e9 * medians[index + 1])),
            ("x", &|(index, _)| short(ratio(*index))),
            ("largest error", &|(_, row)| judged_error(row.error[0])),
            ("rms error", &|(_, row)| judged_error(row.error[1])),
            ("judge", &|(_, row)| row.judge.into()),
        ],
    )
}

/// An error, if something judged it.
fn judged_error(error: f64) -> String {
    if error.is_nan() {
        "–".into()
    } else {
        short(error)
    }
}

fn line(rows: &[Row], samples: &Samples) -> String {
    let of = |shape: &str, method: &str| {
        let is_it = |row: &Row| row.shape == shape && row.method == method;
        let index = rows.iter().position(is_it);
        let ratio = index.and_then(|index| samples.ratio(&index.to_string(), UNIT));
        (
            ratio.unwrap_or(f64::NAN),
            index.map_or(f64::NAN, |index| rows[index].error[0]),
        )
    };
    let worst = |method: &str| {
        let errors = rows.iter().filter(|row| row.method == method);
        errors.map(|row| row.error[0]).fold(0.0, f64::max)
    };
    let (closed, exact) = of("square", EXACT);
    let nodes = rows
        .iter()
        .position(|row| row.shape == "square" && row.method == "nodes" && row.points > 300);
    let nodes = nodes.and_then(|index| {
        Some((
            rows[index].points,
            samples.ratio(&index.to_string(), UNIT)?,
            rows[index].error[0],
        ))
    });
    let (count, ratio, error) = nodes.unwrap_or((0, f64::NAN, f64::NAN));
    format!(
        "A square costs {} times the disk's form with an error of {}; {count} nodes cost {} times it and err by {}. \
         The ellipsoid errs by up to {}.",
        short(closed),
        short(exact),
        short(ratio),
        short(error),
        short(worst("ellipsoid")),
    )
}
