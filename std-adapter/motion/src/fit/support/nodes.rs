//! Places where a foot may carry load.

/// Radius of the disc that an unknown foot lies in, in lengths: on three equal points the largest torque over the
/// largest force is their mean distance, and on a ring the radius.
const REACH: f64 = 2.2;
/// Cells across a disc, and across the longer side of a known support.
const ACROSS: usize = 15;
const ACROSS_SUPPORT: usize = 24;
/// Points of a bar.
const ALONG: usize = 41;

/// A grid over the disc around the origin.
pub fn disc(length: f64) -> Vec<[f64; 2]> {
    let radius = REACH * length;
    let place = |k: usize| radius * (2.0 * k as f64 / (ACROSS - 1) as f64 - 1.0);
    grid([ACROSS; 2], &|[i, j]| [place(i), place(j)])
        .filter(|[x, y]| x * x + y * y <= radius * radius * (1.0 + f64::EPSILON))
        .collect()
}

/// The middles of cells that lie in a support, or the points of a bar, which has two corners.
pub fn of(loops: &[Vec<[f64; 2]>]) -> Vec<[f64; 2]> {
    if let Some(&[from, to]) = loops.first().map(Vec::as_slice) {
        let at = |k: usize| {
            let share = k as f64 / (ALONG - 1) as f64;
            [0, 1].map(|axis| from[axis] + share * (to[axis] - from[axis]))
        };
        return (0..ALONG).map(at).collect();
    }
    let corners = || loops.iter().flatten();
    let span = [0, 1].map(|axis| {
        let low = corners()
            .map(|corner| corner[axis])
            .fold(f64::INFINITY, f64::min);
        let high = corners()
            .map(|corner| corner[axis])
            .fold(f64::NEG_INFINITY, f64::max);
        [low, high - low]
    });
    let cell = f64::max(span[0][1], span[1][1]) / ACROSS_SUPPORT as f64;
    let counts = span.map(|[_, side]| ((side / cell).ceil() as usize).max(1));
    let middle = |axis: usize, k: usize| {
        let [low, side] = span[axis];
        low + side * (k as f64 + 0.5) / counts[axis] as f64
    };
    let place = |[i, j]: [usize; 2]| [middle(0, i), middle(1, j)];
    let all = grid(counts, &place);
    all.filter(|place| lies_in(place, loops)).collect()
}

fn grid<'a>(
    [wide, high]: [usize; 2],
    place: &'a dyn Fn([usize; 2]) -> [f64; 2],
) -> impl Iterator<Item = [f64; 2]> + 'a {
    (0..wide * high).map(move |k| place([k % wide, k / wide]))
}

/// Whether a ray from the place crosses an odd number of edges.
fn lies_in([x, y]: &[f64; 2], loops: &[Vec<[f64; 2]>]) -> bool {
    let mut is_in = false;
    for corners in loops {
        for (k, [bx, by]) in corners.iter().enumerate() {
            let [ax, ay] = corners[(k + corners.len() - 1) % corners.len()];
            if (ay > *y) != (*by > *y) && *x < ax + (bx - ax) * (y - ay) / (by - ay) {
                is_in = !is_in;
            }
        }
    }
    is_in
}
