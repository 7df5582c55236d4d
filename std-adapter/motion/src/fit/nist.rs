//! NIST's Statistical Reference Datasets for nonlinear regression
//! (<https://www.itl.nist.gov/div898/strd/nls/nls_main.shtml>, in the public domain): data, both
//! starting points and certified values of Misra1a (lower difficulty), Thurber and MGH09 (higher).

use super::parameter::{FitParameter, Model, Range};
use super::{Fit, FitOptions, Measurements};

struct Reference {
    name: &'static str,
    x: &'static [f64],
    y: &'static [f64],
    curve: fn(&[f64], f64) -> f64,
    starts: [&'static [f64]; 2],
    certified: &'static [f64],
    deviations: &'static [f64],
    sum_of_squares: f64,
}

const MISRA1A: Reference = Reference {
    name: "Misra1a",
    y: &[
        10.07, 14.73, 17.94, 23.93, 29.61, 35.18, 40.02, 44.82, 50.76, 55.05, 61.01, 66.40, 75.47,
        81.78,
    ],
    x: &[
        77.6, 114.9, 141.1, 190.8, 239.9, 289.0, 332.8, 378.4, 434.8, 477.3, 536.8, 593.1, 689.1,
        760.0,
    ],
    curve: |b, x| b[0] * (1.0 - libm::exp(-b[1] * x)),
    starts: [&[500.0, 1e-4], &[250.0, 5e-4]],
    certified: &[2.3894212918e+02, 5.5015643181e-04],
    deviations: &[2.7070075241e+00, 7.2668688436e-06],
    sum_of_squares: 1.2455138894e-01,
};

const THURBER: Reference = Reference {
    name: "Thurber",
    y: &[
        80.574, 84.248, 87.264, 87.195, 89.076, 89.608, 89.868, 90.101, 92.405, 95.854, 100.696,
        101.060, 401.672, 390.724, 567.534, 635.316, 733.054, 759.087, 894.206, 990.785, 1090.109,
        1080.914, 1122.643, 1178.351, 1260.531, 1273.514, 1288.339, 1327.543, 1353.863, 1414.509,
        1425.208, 1421.384, 1442.962, 1464.350, 1468.705, 1447.894, 1457.628,
    ],
    x: &[
        -3.067, -2.981, -2.921, -2.912, -2.840, -2.797, -2.702, -2.699, -2.633, -2.481, -2.363,
        -2.322, -1.501, -1.460, -1.274, -1.212, -1.100, -1.046, -0.915, -0.714, -0.566, -0.545,
        -0.400, -0.309, -0.109, -0.103, 0.010, 0.119, 0.377, 0.790, 0.963, 1.006, 1.115, 1.572,
        1.841, 2.047, 2.200,
    ],
    curve: |b, x| {
        (b[0] + x * (b[1] + x * (b[2] + x * b[3]))) / (1.0 + x * (b[4] + x * (b[5] + x * b[6])))
    },
    starts: [
        &[1000.0, 1000.0, 400.0, 40.0, 0.7, 0.3, 0.03],
        &[1300.0, 1500.0, 500.0, 75.0, 1.0, 0.4, 0.05],
    ],
    certified: &[
        1.2881396800e+03,
        1.4910792535e+03,
        5.8323836877e+02,
        7.5416644291e+01,
        9.6629502864e-01,
        3.9797285797e-01,
        4.9727297349e-02,
    ],
    deviations: &[
        4.6647963344e+00,
        3.9571156086e+01,
        2.8698696102e+01,
        5.5675370270e+00,
        3.1333340687e-02,
        1.4984928198e-02,
        6.5842344623e-03,
    ],
    sum_of_squares: 5.6427082397e+03,
};

const MGH09: Reference = Reference {
    name: "MGH09",
    y: &[
        0.1957, 0.1947, 0.1735, 0.16, 0.0844, 0.0627, 0.0456, 0.0342, 0.0323, 0.0235, 0.0246,
    ],
    x: &[
        4.0, 2.0, 1.0, 0.5, 0.25, 0.167, 0.125, 0.1, 0.0833, 0.0714, 0.0625,
    ],
    curve: |b, x| b[0] * (x * x + x * b[1]) / (x * x + x * b[2] + b[3]),
    starts: [&[25.0, 39.0, 41.5, 39.0], &[0.25, 0.39, 0.415, 0.39]],
    certified: &[
        1.9280693458e-01,
        1.9128232873e-01,
        1.2305650693e-01,
        1.3606233068e-01,
    ],
    deviations: &[
        1.1435312227e-02,
        1.9633220911e-01,
        8.0842031232e-02,
        9.0025542308e-02,
    ],
    sum_of_squares: 3.0750560385e-04,
};

const NAMES: [&str; 7] = ["b1", "b2", "b3", "b4", "b5", "b6", "b7"];

/// A curve that starts where NIST says.
struct Curve<'a> {
    problem: &'a Reference,
    start: &'a [f64],
    parameters: Vec<FitParameter>,
}

impl Model for Curve<'_> {
    fn parameters(&self) -> &[FitParameter] {
        &self.parameters
    }
    fn reference(&self, _: usize) -> Option<f64> {
        None
    }
    fn predict(&self, values: &[f64]) -> Option<Vec<f64>> {
        let curve = self.problem.curve;
        Some(self.problem.x.iter().map(|&x| curve(values, x)).collect())
    }
    fn start(&self, _: &[f64]) -> Vec<f64> {
        self.start.to_vec()
    }
}

fn fitted(problem: &Reference, start: &[f64], range: Range) -> Fit {
    let names = NAMES[..start.len()].iter();
    let parameter = |&name| FitParameter {
        name,
        unit: "-",
        meaning: "",
        range,
    };
    let model = Curve {
        problem,
        start,
        parameters: names.map(parameter).collect(),
    };
    // The abscissae of these problems are no speeds; the curve knows its own.
    let speeds = vec![1.0; problem.y.len()];
    let data = Measurements::steady(speeds, problem.y.to_vec(), None).unwrap();
    let options = FitOptions {
        starts: 1,
        ..FitOptions::default()
    };
    data.fit(&model, &options).unwrap()
}

#[test]
fn certified_values_and_deviations_come_out_from_both_starts() {
    for (problem, ranges) in [
        (&MISRA1A, &[Range::Any, Range::Positive][..]),
        (&THURBER, &[Range::Any, Range::Positive]),
        (&MGH09, &[Range::Any]),
    ] {
        for (start, &range) in problem
            .starts
            .iter()
            .flat_map(|s| ranges.iter().map(move |r| (s, r)))
        {
            let fit = fitted(problem, start, range);
            let name = problem.name;
            assert!(fit.converged, "{name} from {start:?}: {fit:?}");
            let close = |a: f64, b: f64, digits: i32| (a / b - 1.0).abs() < 10_f64.powi(-digits);
            assert!(
                close(fit.cost, problem.sum_of_squares, 9),
                "{name}: {}",
                fit.cost
            );
            let expected = problem.certified.iter().zip(problem.deviations);
            for (found, (value, deviation)) in fit.parameters.iter().zip(expected) {
                assert!(close(found.value, *value, 8), "{name}: {found:?}");
                let super::Uncertainty::StandardError(error) = found.known else {
                    panic!("{name}: {found:?}");
                };
                assert!(
                    close(error, *deviation, 6),
                    "{name}: {found:?}, {deviation}"
                );
            }
        }
    }
}
