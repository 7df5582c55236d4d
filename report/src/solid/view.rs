//! Parallel projection of space onto the picture: one scale for all directions.

/// A point in space; z points up in the picture.
pub type Point = [f64; 3];

/// A place in the picture, in pixels from the upper left corner.
pub type CanvasPoint = (f64, f64);

/// A rectangle of the picture in pixels: left, top, right, bottom.
pub type Frame = [f64; 4];

/// The directions of the picture in space, its scale and its origin.
#[derive(Debug, Clone, Copy)]
pub struct View {
    right: Point,
    up: Point,
    toward: Point,
    scale: f64,
    origin: CanvasPoint,
}

impl View {
    /// Looks from an azimuth, counted from x towards y, and an elevation above the plane of x and
    /// y, both in radians; one pixel a unit.
    pub fn new(azimuth: f64, elevation: f64) -> Self {
        let ((sin, cos), (rise, run)) = (azimuth.sin_cos(), elevation.sin_cos());
        Self {
            right: [-sin, cos, 0.0],
            up: [-rise * cos, -rise * sin, run],
            toward: [run * cos, run * sin, rise],
            scale: 1.0,
            origin: (0.0, 0.0),
        }
    }

    /// The same directions, scaled so that all points just fit into a frame, centred.
    pub fn fitted(mut self, points: &[Point], [left, top, right, bottom]: Frame) -> Self {
        (self.scale, self.origin) = (1.0, (0.0, 0.0));
        let (mut low, mut high) = ((f64::MAX, f64::MAX), (f64::MIN, f64::MIN));
        for (x, y) in points.iter().map(|point| self.place(*point)) {
            low = (low.0.min(x), low.1.min(y));
            high = (high.0.max(x), high.1.max(y));
        }
        let across = (right - left) / (high.0 - low.0).max(f64::MIN_POSITIVE);
        let down = (bottom - top) / (high.1 - low.1).max(f64::MIN_POSITIVE);
        self.scale = across.min(down).min(f64::MAX);
        let middle = |low: f64, high: f64| self.scale * (low + high) / 2.0;
        self.origin.0 = (left + right) / 2.0 - middle(low.0, high.0);
        self.origin.1 = (top + bottom) / 2.0 - middle(low.1, high.1);
        self
    }

    /// Position of a point in the picture, in pixels from the upper left corner.
    pub fn place(&self, point: Point) -> CanvasPoint {
        let (x, y) = (dot(self.right, point), dot(self.up, point));
        (
            self.origin.0 + self.scale * x,
            self.origin.1 - self.scale * y,
        )
    }

    /// How near a point is: larger is nearer.
    pub fn nearness(&self, point: Point) -> f64 {
        dot(self.toward, point)
    }

    /// Pixels a unit of length.
    pub fn scale(&self) -> f64 {
        self.scale
    }
}

// Scalar product.
fn dot(a: Point, b: Point) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// The eight corners of a box from the low to the high ends of its sides.
pub fn corners(low: Point, high: Point) -> Vec<Point> {
    let side = |at: usize, axis: usize| {
        if at >> axis & 1 == 0 {
            low[axis]
        } else {
            high[axis]
        }
    };
    (0..8)
        .map(|at| [side(at, 0), side(at, 1), side(at, 2)])
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    // Rounding of a few sums of numbers near a hundred.
    const ROUNDING: f64 = 1e-12;

    fn near(a: f64, b: f64) -> bool {
        (a - b).abs() < ROUNDING * (1.0 + a.abs())
    }

    #[test]
    fn directions_are_an_orthonormal_right_handed_frame() {
        let view = View::new(0.7, 0.4);
        let axes = [view.right, view.up, view.toward];
        for (i, a) in axes.iter().enumerate() {
            for (j, b) in axes.iter().enumerate() {
                assert!(near(dot(*a, *b), f64::from(u8::from(i == j))));
            }
        }
        let [r, u, t] = axes;
        assert!(near(r[0] * u[1] - r[1] * u[0], t[2]) && t[2] > 0.0);
    }

    #[test]
    fn a_view_from_the_side_shows_lengths_and_puts_z_up() {
        let view = View::new(-std::f64::consts::FRAC_PI_2, 0.0);
        let (x, y) = view.place([3.0, 5.0, 2.0]);
        assert!(near(x, 3.0) && near(y, -2.0) && near(view.nearness([0.0, -1.0, 9.0]), 1.0));
    }

    #[test]
    fn a_fitted_box_touches_its_frame_and_stays_inside() {
        let points = corners([0.0, 0.0, 0.0], [2.0, 2.0, 9.0]);
        let view = View::new(-1.1, 0.3).fitted(&points, [50.0, 20.0, 300.0, 420.0]);
        let places = points.iter().map(|point| view.place(*point));
        let heights: Vec<f64> = places.clone().map(|place| place.1).collect();
        let top = heights.iter().copied().fold(f64::MAX, f64::min);
        let bottom = heights.iter().copied().fold(f64::MIN, f64::max);
        assert!(near(top, 20.0) && near(bottom, 420.0));
        assert!(
            places
                .clone()
                .all(|place| place.0 > 50.0 && place.0 < 300.0)
        );
    }
}
