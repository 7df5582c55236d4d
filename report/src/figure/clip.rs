//! Cuts lines and polygons to the plot, the square from 0 to 1 in both directions.

/// A place in the plot, counted from its lower left corner.
pub(super) type Point = (f64, f64);

/// The unbroken pieces of a curve inside the plot; missing points break it.
pub(super) fn pieces(points: impl Iterator<Item = Option<Point>>) -> Vec<Vec<Point>> {
    let mut pieces: Vec<Vec<Point>> = Vec::new();
    let mut last: Option<Point> = None;
    for point in points {
        if let (Some(from), Some(to)) = (last, point) {
            // Points too close to be told apart are left out.
            if (from.0 - to.0).hypot(from.1 - to.1) < 2e-4 {
                continue;
            }
            for pair in cut(from, to).windows(2).filter(|pair| seen(pair)) {
                match pieces.last_mut() {
                    Some(piece) if piece.last() == Some(&pair[0]) => piece.push(pair[1]),
                    _ => pieces.push(pair.to_vec()),
                }
            }
        }
        last = point;
    }
    pieces
}

/// The part of a polygon inside the plot: outer edges are pushed onto the border.
pub(super) fn polygon(outline: &[Point]) -> Vec<Point> {
    let ends = outline.iter().cycle().skip(1);
    let cuts = outline.iter().zip(ends).flat_map(|(a, b)| cut(*a, *b));
    cuts.map(|(x, y)| (x.clamp(0.0, 1.0), y.clamp(0.0, 1.0)))
        .collect()
}

/// Whether a place lies in the plot.
pub(super) fn inside((x, y): Point) -> bool {
    (0.0..=1.0).contains(&x) && (0.0..=1.0).contains(&y)
}

// Whether the middle of a segment lies in the plot.
fn seen(pair: &[Point]) -> bool {
    inside(((pair[0].0 + pair[1].0) / 2.0, (pair[0].1 + pair[1].1) / 2.0))
}

// The ends of a segment and the places between where it meets the lines of the border.
fn cut((x, y): Point, end: Point) -> Vec<Point> {
    let (dx, dy) = (end.0 - x, end.1 - y);
    let mut shares = vec![-x / dx, (1.0 - x) / dx, -y / dy, (1.0 - y) / dy];
    shares.retain(|share| *share > 0.0 && *share < 1.0);
    shares.sort_by(f64::total_cmp);
    let mut places = vec![(x, y)];
    places.extend(shares.iter().map(|t| (x + t * dx, y + t * dy)));
    places.push(end);
    places
}
