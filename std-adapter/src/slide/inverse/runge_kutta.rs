//! One step of an embedded Runge–Kutta pair for the slopes.

/// c, n, W, ∫ W X_s' dτ, ∫ W Y_s' dτ.
pub(super) type State = [f64; 5];

/// Dormand & Prince, J. Comput. Appl. Math. 6 (1980) 19: order 5 with an error estimate of
/// order 4.
const STAGES: [[f64; 6]; 6] = [
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
const ERROR: [f64; 7] = [
    71.0 / 57600.0,
    0.0,
    -71.0 / 16695.0,
    71.0 / 1920.0,
    -17253.0 / 339200.0,
    22.0 / 525.0,
    -1.0 / 40.0,
];

/// Step control: safety factor, bounds of change, local tolerance.
const SAFETY: f64 = 0.9;
const SHRINK: f64 = 0.2;
const GROW: f64 = 4.0;
const TOLERANCE: f64 = 1e-14;

/// One step of size `h` from `from`; returns the end point and the error estimate.
pub(super) fn step(from: &State, h: f64, derivative: impl Fn(&State) -> State) -> (State, State) {
    let mut slopes = [[0.0; 5]; 7];
    slopes[0] = derivative(from);
    let mut point = *from;
    for (stage, row) in STAGES.iter().enumerate() {
        point = *from;
        for (slope, &weight) in slopes.iter().zip(row).take(stage + 1) {
            add_scaled(&mut point, slope, h * weight);
        }
        slopes[stage + 1] = derivative(&point);
    }
    let mut error = [0.0; 5];
    for (slope, &weight) in slopes.iter().zip(&ERROR) {
        add_scaled(&mut error, slope, h * weight);
    }
    (point, error)
}

/// True if a step with this error estimate is good, and the factor for the next size. The
/// direction counts relative to its own components, so that a small one keeps its digits.
pub(super) fn judge(at: &State, error: &State) -> (bool, f64) {
    let units = [at[0].abs(), at[1].abs(), 1.0, 1.0, 1.0];
    let terms = error.iter().zip(units).map(|(error, unit)| match error {
        0.0 => 0.0,
        _ => error.abs() / unit,
    });
    let worst = terms.fold(0.0, |a: f64, b| if b > a || b.is_nan() { b } else { a });
    let admissible = at[0] >= 0.0 && at[1] >= 0.0;
    if !admissible || worst.is_nan() {
        return (false, SHRINK);
    }
    if worst == 0.0 {
        return (true, GROW);
    }
    let factor = SAFETY * (TOLERANCE / worst).powf(0.2);
    (worst <= TOLERANCE, factor.clamp(SHRINK, GROW))
}

fn add_scaled(sum: &mut State, term: &State, factor: f64) {
    for (s, t) in sum.iter_mut().zip(term) {
        *s += factor * t;
    }
}
