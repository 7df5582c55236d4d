//! Polygons with many corners.

use crate::points::{POINTS, TRIANGLE};

/// Largest number of corners of a footprint.
const MOST_CORNERS: usize = POINTS / TRIANGLE + 2;
/// Divisions of the edges of a polygon with few corners.
const DIVISIONS: usize = 2;

/// Divisions of every edge that the number of points allows.
pub(crate) fn divisions(corners: usize) -> u32 {
    let most = POINTS / (TRIANGLE * corners.saturating_sub(2).max(1));
    // At most `DIVISIONS`, which fits.
    most.isqrt().min(DIVISIONS) as u32
}

/// The polygon with at most as many corners as a footprint takes, of the same area.
pub(crate) fn thinned(corners: &[[f32; 2]]) -> Vec<[f32; 2]> {
    if corners.len() <= MOST_CORNERS {
        return corners.to_vec();
    }
    let kept = |k: usize| corners[k * corners.len() / MOST_CORNERS];
    let kept: Vec<[f32; 2]> = (0..MOST_CORNERS).map(kept).collect();
    let (whole, part) = (Moments::of(corners), Moments::of(&kept));
    let (scale, [x, y]) = ((whole.area / part.area).sqrt(), part.centre);
    kept.into_iter()
        .map(|[cx, cy]| [x + (cx - x) * scale, y + (cy - y) * scale])
        .collect()
}

/// The centre of a polygon's area.
pub(crate) fn centroid(corners: &[[f32; 2]]) -> [f32; 2] {
    Moments::of(corners).centre
}

/// Area in m², negative if the corners run clockwise, and its centre.
struct Moments {
    area: f32,
    centre: [f32; 2],
}

impl Moments {
    fn of(corners: &[[f32; 2]]) -> Self {
        let [ox, oy] = corners.first().copied().unwrap_or_default();
        let [mut area, mut x, mut y] = [0.0; 3];
        for (a, b) in corners.iter().zip(corners.iter().skip(1)) {
            let [ax, ay, bx, by] = [a[0] - ox, a[1] - oy, b[0] - ox, b[1] - oy];
            let twice = ax * by - ay * bx;
            area += 0.5 * twice;
            x += twice * (ax + bx) / 6.0;
            y += twice * (ay + by) / 6.0;
        }
        let centre = [ox + x / area, oy + y / area];
        Self { area, centre }
    }
}
