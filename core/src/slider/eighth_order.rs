//! One step of an embedded Runge–Kutta pair of order 8.
//!
//! E. Hairer, S. P. Nørsett & G. Wanner, Solving Ordinary Differential Equations I, 2nd edition,
//! section II.10: method of Dormand and Prince with twelve stages and two error estimates, of order 5
//! and 3, which together make one of order 7.

use crate::real::Real;

/// Stages, which is evaluations of a step.
pub(super) const STAGES: usize = 12;

/// Weights of the slopes, with their places, for the second stage to the last.
const ROWS: [&[(usize, f64)]; STAGES - 1] = [
    &[(0, 0.05260015195876773)],
    &[(0, 0.0197250569845379), (1, 0.0591751709536137)],
    &[(0, 0.02958758547680685), (2, 0.08876275643042054)],
    &[
        (0, 0.2413651341592667),
        (2, -0.8845494793282861),
        (3, 0.924834003261792),
    ],
    &[
        (0, 0.037037037037037035),
        (3, 0.17082860872947386),
        (4, 0.12546768756682242),
    ],
    &[
        (0, 0.037109375),
        (3, 0.17025221101954405),
        (4, 0.06021653898045596),
        (5, -0.017578125),
    ],
    &[
        (0, 0.03709200011850479),
        (3, 0.17038392571223998),
        (4, 0.10726203044637328),
        (5, -0.015319437748624402),
        (6, 0.008273789163814023),
    ],
    &[
        (0, 0.6241109587160757),
        (3, -3.3608926294469414),
        (4, -0.868219346841726),
        (5, 27.59209969944671),
        (6, 20.154067550477894),
        (7, -43.48988418106996),
    ],
    &[
        (0, 0.47766253643826434),
        (3, -2.4881146199716677),
        (4, -0.590290826836843),
        (5, 21.230051448181193),
        (6, 15.279233632882423),
        (7, -33.28821096898486),
        (8, -0.020331201708508627),
    ],
    &[
        (0, -0.9371424300859873),
        (3, 5.186372428844064),
        (4, 1.0914373489967295),
        (5, -8.149787010746927),
        (6, -18.52006565999696),
        (7, 22.739487099350505),
        (8, 2.4936055526796523),
        (9, -3.0467644718982196),
    ],
    &[
        (0, 2.273310147516538),
        (3, -10.53449546673725),
        (4, -2.0008720582248625),
        (5, -17.9589318631188),
        (6, 27.94888452941996),
        (7, -2.8589982771350235),
        (8, -8.87285693353063),
        (9, 12.360567175794303),
        (10, 0.6433927460157636),
    ],
];
/// Weights of the end.
const END: &[(usize, f64)] = &[
    (0, 0.054293734116568765),
    (5, 4.450312892752409),
    (6, 1.8915178993145003),
    (7, -5.801203960010585),
    (8, 0.3111643669578199),
    (9, -0.1521609496625161),
    (10, 0.20136540080403034),
    (11, 0.04471061572777259),
];
/// Difference of the end from that of order 5, and from that of order 3.
const ERRORS: [&[(usize, f64)]; 2] = [
    &[
        (0, 0.01312004499419488),
        (5, -1.2251564463762044),
        (6, -0.4957589496572502),
        (7, 1.6643771824549864),
        (8, -0.35032884874997366),
        (9, 0.3341791187130175),
        (10, 0.08192320648511571),
        (11, -0.022355307863886294),
    ],
    &[
        (0, -0.18980075407240762),
        (5, 4.450312892752409),
        (6, 1.8915178993145003),
        (7, -5.801203960010585),
        (8, -0.4226823213237919),
        (9, -0.1521609496625161),
        (10, 0.20136540080403034),
        (11, 0.02265179219836082),
    ],
];
/// Square of the part of the estimate of order 3 that joins that of order 5.
const JOINED: f64 = 0.01;

/// One step of size `h` from zero, whose slope is `first`; returns the end point and the error estimate.
///
/// *Cost*: 11 calls of `derivative`.
pub(super) fn step<R: Real, const N: usize>(
    first: [R; N],
    h: R,
    derivative: impl Fn(&[R; N]) -> [R; N],
) -> ([R; N], [R; N]) {
    let mut slopes = [first; STAGES];
    for (stage, row) in ROWS.iter().enumerate() {
        let slope = derivative(&sum(&slopes, row, h));
        if let Some(next) = slopes.get_mut(stage + 1) {
            *next = slope;
        }
    }
    let [fine, coarse] = ERRORS.map(|row| sum(&slopes, row, h));
    let mut error = fine;
    for (error, coarse) in error.iter_mut().zip(coarse) {
        let squares = *error * *error + R::from_f64(JOINED) * coarse * coarse;
        if squares > R::ZERO {
            *error *= error.abs() / squares.sqrt();
        }
    }
    (sum(&slopes, END, h), error)
}

/// h times the weighted sum of slopes.
fn sum<R: Real, const N: usize>(slopes: &[[R; N]; STAGES], row: &[(usize, f64)], h: R) -> [R; N] {
    let mut sum = [R::ZERO; N];
    for (place, weight) in row {
        if let Some(slope) = slopes.get(*place) {
            for (sum, slope) in sum.iter_mut().zip(slope) {
                *sum += R::from_f64(*weight) * *slope;
            }
        }
    }
    sum.map(|sum| h * sum)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_error_falls_with_the_ninth_power_of_the_step() {
        // x' = 1 + x², x = tan t.
        let slope = |x: &[f64; 1]| [1.0 + x[0] * x[0]];
        let errors = [0.6, 0.3].map(|h| {
            let (end, estimate) = step([1.0], h, slope);
            let error = libm::fabs(end[0] - libm::tan(h));
            assert!(libm::fabs(estimate[0]) > error, "{h}");
            error
        });
        let order = libm::log2(errors[0] / errors[1]);
        assert!(order > 8.5 && order < 10.5, "{order}");
    }
}
