//! Outline, pusher and path from above.

use crate::failure::Failure;
use std::path::Path;
use tribos::push::{PathSample, PushResult};
use tribos::record::series_csv;
use tribos::scene::PushScene;
use tribos_report::figure::{Axis, Color, Figure, Legend, Series};
use tribos_report::image;

/// Outlines between the first and the last one.
const BETWEEN: usize = 3;
/// Room around everything, of its size.
const MARGIN: f64 = 0.05;
/// Size of the picture in pixels; the legend takes the difference.
const SIZE: (u32, u32) = (720, 760);

type Points = Vec<(f64, f64)>;

/// Draws the scene at its start, on its way and at its end.
pub fn draw(path: &Path, scene: &PushScene, answer: &PushResult) -> Result<(), Failure> {
    let moments = &answer.journey.moments;
    let last = moments.len().saturating_sub(1);
    let shown: Vec<usize> = (0..=BETWEEN + 1)
        .map(|i| last * i / (BETWEEN + 1))
        .collect();
    let outline = |moment: &PathSample| -> Points {
        let mut points = Points::new();
        for corners in &answer.outline {
            let closed = corners.iter().chain(corners.first());
            points.extend(closed.map(|&corner| {
                let at = moment.pose.place(corner.into());
                (at.x, at.y)
            }));
            // The loops are apart.
            points.push((f64::NAN, f64::NAN));
        }
        points
    };
    let pusher: Points = moments.iter().map(touching).collect();
    let centre: Points = moments
        .iter()
        .map(|moment| (moment.pose.x, moment.pose.y))
        .collect();
    let outlines: Vec<Points> = shown.iter().map(|&at| outline(&moments[at])).collect();
    let all = outlines.iter().flatten().chain(&pusher);
    let [x, y] = square(all);
    let mut figure = Figure::new(
        format!("{}, pushed", scene.patch),
        Axis::linear("x [m]").range(x.0, x.1),
        Axis::linear("y [m]").range(y.0, y.1),
    )
    .legend(Legend::Below)
    .size(SIZE.0, SIZE.1);
    for (number, points) in outlines.into_iter().enumerate() {
        let series = match number {
            0 => Series::line("at the start", points).color(Color::palette(0)),
            n if n == BETWEEN + 1 => Series::line("at the end", points).color(Color::palette(1)),
            1 => Series::dashed("on the way", points).color(Color::pale(0)),
            _ => Series::dashed("", points).color(Color::pale(0)),
        };
        figure = figure.series(series);
    }
    figure = figure
        .series(Series::line("origin of the patch", centre).color(Color::palette(2)))
        .series(Series::line_points("pusher", ends(&pusher)).color(Color::palette(3)));
    let csv = || {
        series_csv(
            &PushResult::COLUMNS,
            answer.rows().collect::<Vec<_>>().iter().map(|row| &row[..]),
        )
    };
    Ok(image::write_as_named(path, &figure, csv)?)
}

/// Where the pusher is.
fn touching(moment: &PathSample) -> (f64, f64) {
    let at = moment.pose.place(moment.contact);
    (at.x, at.y)
}

fn ends(points: &Points) -> Points {
    points
        .first()
        .into_iter()
        .chain(points.last())
        .copied()
        .collect()
}

/// Ranges of the same length that hold all points.
fn square<'a>(points: impl Iterator<Item = &'a (f64, f64)>) -> [(f64, f64); 2] {
    let mut range = [(f64::INFINITY, f64::NEG_INFINITY); 2];
    for &(x, y) in points.filter(|(x, _)| x.is_finite()) {
        for (range, part) in range.iter_mut().zip([x, y]) {
            *range = (range.0.min(part), range.1.max(part));
        }
    }
    let half = range.map(|(low, high)| 0.5 * (high - low));
    let half = (1.0 + MARGIN) * half[0].max(half[1]);
    range.map(|(low, high)| {
        let middle = 0.5 * (low + high);
        (middle - half, middle + half)
    })
}
