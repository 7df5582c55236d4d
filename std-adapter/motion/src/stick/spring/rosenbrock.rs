//! The integrator of stiff motions: an L-stable Rosenbrock method with step control.
//!
//! RODAS of Hairer and Wanner (Solving Ordinary Differential Equations II, 1996, section IV.7): six stages,
//! order 4 with an embedded solution of order 3, stiffly accurate. Each step solves linear systems with
//! the matrix 1/(γh) − J only, so that no iteration can fail.

use tribos_core::Real;

/// An autonomous system of N differential equations.
pub(super) trait OdeSystem<const N: usize> {
    /// dy/dt.
    fn rate(&self, y: &[f64; N]) -> [f64; N];

    /// ∂(dy/dt)/∂y, row by row.
    fn jacobian(&self, y: &[f64; N]) -> [[f64; N]; N];
}

/// Diagonal coefficient γ of the method.
const GAMMA: f64 = 0.25;
/// Where stages 2 to 5 evaluate the system: sums of earlier stages (Hairer's RODAS, METH = 1).
const A: [[f64; 4]; 4] = [
    [1.544, 0.0, 0.0, 0.0],
    [0.946_678_528_081_582_6, 0.255_701_169_898_328_4, 0.0, 0.0],
    [
        3.314_825_187_068_521,
        2.896_124_015_972_201,
        0.998_641_913_997_781_7,
        0.0,
    ],
    [
        1.221_224_509_226_641,
        6.019_134_481_288_629,
        12.537_083_329_320_87,
        -0.687_886_036_105_895,
    ],
];
/// What stages 2 to 6 add of earlier stages over the step (the same source).
const C: [[f64; 5]; 5] = [
    [-5.6688, 0.0, 0.0, 0.0, 0.0],
    [
        -2.430_093_356_833_875,
        -0.206_359_915_709_191_5,
        0.0,
        0.0,
        0.0,
    ],
    [
        -0.107_352_905_815_137_5,
        -9.594_562_251_023_355,
        -20.470_286_148_096_16,
        0.0,
        0.0,
    ],
    [
        7.496_443_313_967_647,
        -10.246_804_314_643_52,
        -33.999_903_528_199_05,
        11.708_908_932_061_6,
        0.0,
    ],
    [
        8.083_246_795_921_522,
        -7.981_132_988_064_893,
        -31.521_594_328_743_71,
        16.319_305_431_231_36,
        -6.058_818_238_834_054,
    ],
];

/// The end of one step and its estimated error in units of `scale`.
pub(super) fn trial<const N: usize>(
    flow: &impl OdeSystem<N>,
    y: &[f64; N],
    step: f64,
    scale: &[f64; N],
) -> ([f64; N], f64) {
    let system = Factored::of(flow.jacobian(y), 1.0 / (GAMMA * step));
    let mut stages = [[0.0; N]; 6];
    let mut end = *y;
    for stage in 0..6 {
        // The last stages start from the embedded solutions.
        let at = match stage {
            0 => *y,
            1..=4 => plus(y, &A[stage - 1], &stages),
            _ => plus(&end, &[1.0], &stages[4..]),
        };
        if stage >= 4 {
            end = at;
        }
        let carried = match stage {
            0 => [0.0; N],
            _ => plus(&[0.0; N], &C[stage - 1], &stages),
        };
        let rate = flow.rate(&at);
        let right = std::array::from_fn(|i| rate[i] + carried[i] / step);
        stages[stage] = system.solve(right);
    }
    let last = stages[5];
    let end: [f64; N] = std::array::from_fn(|i| end[i] + last[i]);
    let worst = (0..N).fold(0.0, |worst: f64, i| {
        let share = (last[i] / scale[i]).abs();
        // NaN is the worst.
        if share <= worst { worst } else { share }
    });
    (end, worst)
}

/// `start` + Σ weight × stage.
fn plus<const N: usize>(start: &[f64; N], weights: &[f64], stages: &[[f64; N]]) -> [f64; N] {
    let parts = || weights.iter().zip(stages);
    std::array::from_fn(|i| {
        start[i]
            + parts()
                .map(|(weight, stage)| weight * stage[i])
                .sum::<f64>()
    })
}

/// diagonal · 1 − J, factored with row exchanges.
struct Factored<const N: usize> {
    rows: [[f64; N]; N],
    order: [usize; N],
}

impl<const N: usize> Factored<N> {
    fn of(jacobian: [[f64; N]; N], diagonal: f64) -> Self {
        let mut rows = jacobian.map(|row| row.map(|x| -x));
        for (i, row) in rows.iter_mut().enumerate() {
            row[i] += diagonal;
        }
        let mut order = std::array::from_fn(|i| i);
        for column in 0..N {
            let largest = (column..N).fold(column, |best, row| {
                if rows[row][column].abs() > rows[best][column].abs() {
                    row
                } else {
                    best
                }
            });
            rows.swap(column, largest);
            order.swap(column, largest);
            let pivot = rows[column];
            for row in rows.iter_mut().skip(column + 1) {
                let factor = row[column] / pivot[column];
                row[column] = factor;
                for (x, above) in row.iter_mut().zip(&pivot).skip(column + 1) {
                    *x -= factor * above;
                }
            }
        }
        Self { rows, order }
    }

    fn solve(&self, right: [f64; N]) -> [f64; N] {
        let mut x: [f64; N] = std::array::from_fn(|i| right[self.order[i]]);
        for row in 0..N {
            for k in 0..row {
                x[row] -= self.rows[row][k] * x[k];
            }
        }
        for row in (0..N).rev() {
            for k in row + 1..N {
                x[row] -= self.rows[row][k] * x[k];
            }
            x[row] /= self.rows[row][row];
        }
        x
    }
}

/// Chooses the lengths of steps.
#[derive(Clone, Debug)]
pub(super) struct StepSizeControl {
    next: f64,
    tolerance: f64,
}

/// Safety and bounds of the change of a step's length.
const SAFETY: f64 = 0.9;
const SHRINK: f64 = 0.2;
const GROW: f64 = 5.0;
/// Rejections in a row that say that no step will do.
const MOST_REJECTIONS: u32 = 200;

impl StepSizeControl {
    /// Starting with `first`, with errors below `tolerance` in units of the scales.
    pub fn new(first: f64, tolerance: f64) -> Self {
        Self {
            next: first,
            tolerance,
        }
    }

    /// The state after the next step and its length, `left` at most; none if no step will do.
    pub fn step<const N: usize>(
        &mut self,
        flow: &impl OdeSystem<N>,
        y: &[f64; N],
        left: f64,
        scale: &[f64; N],
    ) -> Option<([f64; N], f64)> {
        let mut length = self.next;
        for _ in 0..MOST_REJECTIONS {
            let is_cut = length >= left;
            let step = if is_cut { left } else { length };
            let (end, error) = trial(flow, y, step, scale);
            let share = error / self.tolerance;
            // The error of the embedded solution is of order 4.
            let change = SAFETY / Real::sqrt(Real::sqrt(share));
            if share <= 1.0 && end.iter().all(|x| x.is_finite()) {
                // A step that was cut says nothing about longer ones.
                let proposed = step * if change < GROW { change } else { GROW };
                if !is_cut || proposed > self.next {
                    self.next = proposed;
                }
                return Some((end, step));
            }
            let factor = if change > SHRINK { change } else { SHRINK };
            length = step * factor.min(SAFETY);
            self.next = length;
        }
        None
    }
}

#[cfg(test)]
#[allow(clippy::disallowed_methods, reason = "tests compare with the platform")]
mod tests {
    use super::*;

    /// A pendulum: its energy is known, its equation is not linear.
    struct Pendulum;
    impl OdeSystem<2> for Pendulum {
        fn rate(&self, &[angle, speed]: &[f64; 2]) -> [f64; 2] {
            [speed, -Real::sin(angle)]
        }
        fn jacobian(&self, &[angle, _]: &[f64; 2]) -> [[f64; 2]; 2] {
            [[0.0, 1.0], [-Real::cos(angle), 0.0]]
        }
    }

    #[test]
    fn the_error_falls_with_the_fourth_power_of_the_step() {
        // 2 asin(k sn(K − 2, k)) with k = sin(1/2): mpmath, 30 digits.
        let exact = -0.306_200_957_588_524;
        let error = |steps: u32| {
            let mut y = [1.0, 0.0];
            for _ in 0..steps {
                y = trial(&Pendulum, &y, 2.0 / f64::from(steps), &[1.0; 2]).0;
            }
            y[0] - exact
        };
        let [coarse, fine] = [error(40), error(80)];
        let order = (coarse / fine).abs().log2();
        assert!((order - 4.0).abs() < 0.25, "{order} {coarse:e} {fine:e}");
    }

    /// y' = −10⁹ (y − cos t), with the time as a second component.
    struct Stiff;
    impl OdeSystem<2> for Stiff {
        fn rate(&self, &[y, t]: &[f64; 2]) -> [f64; 2] {
            [-1e9 * (y - Real::cos(t)), 1.0]
        }
        fn jacobian(&self, &[_, t]: &[f64; 2]) -> [[f64; 2]; 2] {
            [[-1e9, -1e9 * Real::sin(t)], [0.0, 0.0]]
        }
    }

    #[test]
    fn a_fast_decay_does_not_bind_the_step() {
        let (mut y, mut pace, mut steps) = ([0.3, 0.0], StepSizeControl::new(1e-12, 1e-8), 0);
        while y[1] < 3.0 {
            let left = 3.0 - y[1];
            (y, _) = pace.step(&Stiff, &y, left, &[1.0; 2]).unwrap();
            steps += 1;
        }
        assert!((y[0] - Real::cos(y[1])).abs() < 1e-7, "{y:?}");
        assert!(steps < 200, "{steps}");
    }
}
