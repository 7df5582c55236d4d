//! One step of an embedded Runge–Kutta pair, for any small autonomous system.

use crate::real::{Real, to_single};

/// Dormand & Prince, J. Comput. Appl. Math. 6 (1980) 19: order 5 with an error estimate of
/// order 4.
static STAGES: [[f64; 6]; 6] = [
    [1.0 / 5.0, 0.0, 0.0, 0.0, 0.0, 0.0],
    [3.0 / 40.0, 9.0 / 40.0, 0.0, 0.0, 0.0, 0.0],
    [44.0 / 45.0, -56.0 / 15.0, 32.0 / 9.0, 0.0, 0.0, 0.0],
    [
        19372.0 / 6561.0,
        -25360.0 / 2187.0,
        64448.0 / 6561.0,
        -212.0 / 729.0,
        0.0,
        0.0,
    ],
    [
        9017.0 / 3168.0,
        -355.0 / 33.0,
        46732.0 / 5247.0,
        49.0 / 176.0,
        -5103.0 / 18656.0,
        0.0,
    ],
    [
        35.0 / 384.0,
        0.0,
        500.0 / 1113.0,
        125.0 / 192.0,
        -2187.0 / 6784.0,
        11.0 / 84.0,
    ],
];
/// Difference of the two orders' weights.
static ERROR: [[f64; 7]; 1] = [[
    71.0 / 57600.0,
    0.0,
    -71.0 / 16695.0,
    71.0 / 1920.0,
    -17253.0 / 339200.0,
    22.0 / 525.0,
    -1.0 / 40.0,
]];

/// The same in single precision.
static STAGES_SINGLE: [[f32; 6]; 6] = to_single(&STAGES);
static ERROR_SINGLE: [[f32; 7]; 1] = to_single(&ERROR);

/// Step control: safety factor and bounds of change.
const SAFETY: f64 = 0.9;
const SHRINK: f64 = 0.2;
const GROW: f64 = 4.0;
/// Local error tolerance in units of the rounding error.
const TOLERANCE_ULPS: f64 = 4.0;

/// The tolerance of the exact steppers of [`super::Slider`]: 4 rounding errors.
pub fn tolerance<R: Real>() -> R {
    R::from_f64(TOLERANCE_ULPS) * R::EPSILON
}

/// One step of size `h` from `from`; returns the end point and the error estimate.
///
/// *Cost*: 7 calls of `derivative`.
pub fn step<R: Real, const N: usize>(
    from: &[R; N],
    h: R,
    derivative: impl Fn(&[R; N]) -> [R; N],
) -> ([R; N], [R; N]) {
    step_along(from, derivative(from), h, derivative)
}

/// The step whose first slope is known.
///
/// *Cost*: 6 calls of `derivative`.
pub(super) fn step_along<R: Real, const N: usize>(
    from: &[R; N],
    first: [R; N],
    h: R,
    derivative: impl Fn(&[R; N]) -> [R; N],
) -> ([R; N], [R; N]) {
    let mut slopes = [[R::ZERO; N]; 7];
    slopes[0] = first;
    let mut point = *from;
    let stages = R::pick(&STAGES_SINGLE, &STAGES);
    for (stage, row) in stages.iter().enumerate() {
        point = *from;
        for (slope, &weight) in slopes.iter().zip(row).take(stage + 1) {
            add_scaled(&mut point, slope, h * weight);
        }
        if let Some(next) = slopes.get_mut(stage + 1) {
            *next = derivative(&point);
        }
    }
    let mut error = [R::ZERO; N];
    let [weights] = R::pick(&ERROR_SINGLE, &ERROR);
    for (slope, &weight) in slopes.iter().zip(weights) {
        add_scaled(&mut error, slope, h * weight);
    }
    (point, error)
}

/// True if a step with this error estimate is good, and the factor for the next size.
///
/// `error` and `tolerance` are in the same units; a step that is not `admissible` for other
/// reasons is refused whatever its error, and so is a NaN.
pub fn judge<R: Real>(error: R, tolerance: R, admissible: bool) -> (bool, R) {
    let accepted = error <= tolerance && admissible;
    let (shrink, grow) = (R::from_f64(SHRINK), R::from_f64(GROW));
    if !admissible {
        return (false, shrink);
    }
    if error == R::ZERO {
        return (accepted, grow);
    }
    let factor = R::from_f64(SAFETY) * (tolerance / error).pow(R::from_f64(0.2));
    let factor = if factor > grow { grow } else { factor };
    // NaN shrinks.
    (accepted, if factor > shrink { factor } else { shrink })
}

fn add_scaled<R: Real, const N: usize>(sum: &mut [R; N], term: &[R; N], factor: R) {
    for (s, t) in sum.iter_mut().zip(term) {
        *s += factor * *t;
    }
}
