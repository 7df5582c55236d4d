//! Scaling of Nesterov and Todd of a pair of points in a second-order cone.

/// Second-order cone points of one mode: the first component, and at most three others.
pub(super) type Point = [f64; 4];

/// F with F y = F⁻¹ z = λ: F = η (w wᵀ-like arrow of a hyperbolic unit vector).
#[derive(Clone, Copy, Debug)]
pub(super) struct Scaling {
    /// η, and the hyperbolic unit vector w.
    size: f64,
    axis: Point,
    scaled: Point,
    dual: Point,
}

fn dot(a: &Point, b: &Point) -> f64 {
    (a[0] * b[0] + a[1] * b[1]) + (a[2] * b[2] + a[3] * b[3])
}

/// √(t² − |w|²), and the point over it.
fn normalised(point: &Point) -> (f64, Point) {
    let length = (point[1] * point[1] + point[2] * point[2] + point[3] * point[3]).sqrt();
    let root = ((point[0] - length) * (point[0] + length))
        .max(f64::MIN_POSITIVE)
        .sqrt();
    (root, point.map(|x| x / root))
}

impl Scaling {
    pub fn new(primal: &Point, dual: &Point) -> Self {
        let ((y_size, y), (z_size, z)) = (normalised(primal), normalised(dual));
        let gamma = (0.5 * (1.0 + dot(&y, &z))).sqrt();
        let mut axis: Point = std::array::from_fn(|at| (z[at] - y[at]) / (2.0 * gamma));
        axis[0] = (z[0] + y[0]) / (2.0 * gamma);
        let mut scaling = Self {
            size: (z_size / y_size).sqrt(),
            axis,
            scaled: [0.0; 4],
            dual: *dual,
        };
        scaling.scaled = scaling.apply(primal);
        scaling
    }

    /// F x.
    fn apply(&self, x: &Point) -> Point {
        self.arrow(x, 1.0).map(|value| self.size * value)
    }

    /// F⁻¹ x.
    fn apply_inverse(&self, x: &Point) -> Point {
        self.arrow(x, -1.0).map(|value| value / self.size)
    }

    fn arrow(&self, x: &Point, sign: f64) -> Point {
        let [w0, a, b, c] = self.axis;
        let side = a * x[1] + b * x[2] + c * x[3];
        let along = sign * x[0] + side / (1.0 + w0);
        [
            w0 * x[0] + sign * side,
            x[1] + a * along,
            x[2] + b * along,
            x[3] + c * along,
        ]
    }

    /// D = F²: η² (2 w wᵀ − J).
    pub fn square(&self) -> [[f64; 4]; 4] {
        let factor = self.size * self.size;
        let mut square = self.axis.map(|a| self.axis.map(|b| 2.0 * factor * a * b));
        for (at, row) in square.iter_mut().enumerate() {
            row[at] += if at == 0 { -factor } else { factor };
        }
        square
    }

    /// D x.
    pub fn apply_square(&self, x: &Point) -> Point {
        self.apply(&self.apply(x))
    }

    /// Δz for Δy = 0: towards y ∘ z = `centre`, with Mehrotra's correction for an affine step.
    pub fn target(&self, centre: f64, affine: Option<(&Point, &Point)>) -> Point {
        let Some((by_y, by_z)) = affine else {
            return self.towards(centre, &[0.0; 4]);
        };
        self.towards(
            centre,
            &product(&self.apply(by_y), &self.apply_inverse(by_z)),
        )
    }

    /// F (λ \ (centre e − correction)) − z.
    fn towards(&self, centre: f64, correction: &Point) -> Point {
        let mut right = correction.map(|x| -x);
        right[0] += centre;
        let moved = self.apply(&divide(&self.scaled, &right));
        std::array::from_fn(|at| moved[at] - self.dual[at])
    }
}

/// Jordan product: (a·b, a₀ b₁ + b₀ a₁).
fn product(a: &Point, b: &Point) -> Point {
    let mut out: Point = std::array::from_fn(|at| a[0] * b[at] + b[0] * a[at]);
    out[0] = dot(a, b);
    out
}

/// x with a ∘ x = b.
fn divide(a: &Point, b: &Point) -> Point {
    let length = (a[1] * a[1] + a[2] * a[2] + a[3] * a[3]).sqrt();
    let square = ((a[0] - length) * (a[0] + length)).max(f64::MIN_POSITIVE);
    let side = a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
    let first = (a[0] * b[0] - side) / square;
    let mut out: Point = std::array::from_fn(|at| (b[at] - first * a[at]) / a[0]);
    out[0] = first;
    out
}
