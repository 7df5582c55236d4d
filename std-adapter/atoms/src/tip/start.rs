//! How well the tip is in equilibrium at the moment the drive begins.

use tribos_base::results::summary;
use tribos_base::statistics;

summary! {
    /// The tip before the drive: means over the last 20 τ of the first stage, closer to its start if it
    /// is shorter. In equilibrium forces and torque are 0 within their errors, and nothing drifts.
    ///
    /// Driven layers that are held in their plane (`hold = "plane"`) may have a mean force along z: it is
    /// the force that holds them, per atom. With a load in equilibrium it is the load.
    ///
    /// ```
    /// use tribos::run::run_to_end;
    /// use tribos::scene::TipScene;
    /// use tribos::tip::{EquilibriumCheck, TipSimulation};
    /// let scene = TipScene {
    ///     lambda: 0.0,
    ///     substrate_columns: 8,
    ///     substrate_rows: 8,
    ///     substrate_layers: 4,
    ///     tip_layers: 4,
    ///     tip_side_atoms: 2,
    ///     equilibration: 5.0,
    ///     drive_time: 0.0,
    ///     rest_time: 0.0,
    ///     ..TipScene::default()
    /// };
    /// let mut run = TipSimulation::new(&scene)?;
    /// run_to_end(&mut run, |_, _| ())?;
    /// let start: EquilibriumCheck = run.outcome().start;
    /// assert!(start.force[0].abs() < 10.0 * start.force_error[0]);
    /// assert!(start.torque.abs() < 10.0 * start.torque_error);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// *Units*: those of the scene. *Accuracy*: errors are standard errors of lines 0.5 τ apart
    /// (closer if a stage is short), treated as independent; neighbouring ones are correlated.
    #[derive(Copy)]
    pub struct EquilibriumCheck = part;

    /// Mean force of all other atoms on a driven atom.
    force: [f64; 3], "eps/sigma";
    /// Standard errors of `force`.
    force_error: [f64; 3], "eps/sigma";
    /// Mean torque of all other atoms on the driven layers about the vertical axis.
    torque: f64, "eps";
    /// Standard error of `torque`.
    torque_error: f64, "eps";
    /// Mean temperatures of the thermostatted layers of substrate and tip.
    temperature: [f64; 2], "eps/k_B";
    /// Rise of the driven layers per time.
    height_drift: f64, "sigma/tau";
    /// Rotation of the driven layers per time.
    angle_drift_degrees: f64, "degrees/tau";
    /// Rise of the potential energy per time.
    energy_drift: f64, "eps/tau";
    /// Number of lines that the means are over.
    lines: usize, "-";
}

/// Columns of a line that tell of equilibrium.
#[derive(Clone, Copy, Debug)]
pub(super) struct Columns {
    /// Of the angle of the driven layers.
    pub angle: usize,
    /// Of the torque against the drive.
    pub torque: usize,
    /// Of the height of the driven layers.
    pub height: usize,
    /// Of both temperatures.
    pub temperatures: [usize; 2],
    /// Of the potential energy.
    pub energy: usize,
    /// Of the three components of the mean force on a driven atom.
    pub force: [usize; 3],
}

impl EquilibriumCheck {
    /// From lines before the drive, whose first column is the time.
    pub(super) fn of(lines: &[&[f64]], columns: Columns) -> Self {
        let [mean, error, slope] =
            [mean, standard_error, slope].map(|of| move |column: usize| of(lines, column));
        Self {
            force: columns.force.map(&mean),
            force_error: columns.force.map(&error),
            // A line has the torque against the drive.
            torque: -mean(columns.torque),
            torque_error: error(columns.torque),
            temperature: columns.temperatures.map(&mean),
            height_drift: slope(columns.height),
            angle_drift_degrees: slope(columns.angle),
            energy_drift: slope(columns.energy),
            lines: lines.len(),
        }
    }
}

/// A column; NaN where a line is too short.
fn values<'a>(lines: &'a [&[f64]], column: usize) -> impl Iterator<Item = f64> + 'a {
    let of = move |line: &&[f64]| line.get(column).copied().unwrap_or(f64::NAN);
    lines.iter().map(of)
}

fn mean(lines: &[&[f64]], column: usize) -> f64 {
    statistics::mean(&values(lines, column).collect::<Vec<_>>())
}

/// Standard error of a mean of independent numbers.
fn standard_error(lines: &[&[f64]], column: usize) -> f64 {
    statistics::mean_and_error(&values(lines, column).collect::<Vec<_>>())[1]
}

/// Slope of the straight line of least squares against the time.
fn slope(lines: &[&[f64]], column: usize) -> f64 {
    let [t0, x0] = [0, column].map(|column| mean(lines, column));
    let times = || values(lines, 0).map(|time| time - t0);
    let cross: f64 = times()
        .zip(values(lines, column))
        .map(|(t, x)| t * (x - x0))
        .sum();
    cross / times().map(|t| t * t).sum::<f64>()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn means_errors_and_drifts_are_those_of_a_known_series() {
        // x = 3 + 2 t with a scatter of ±1 that has no mean and no trend.
        let lines: Vec<Vec<f64>> = (0..8)
            .map(|k: i32| {
                let t = f64::from(k) - 3.5;
                let scatter = if [0, 3, 5, 6].contains(&k) { 1.0 } else { -1.0 };
                vec![t, 3.0 + 2.0 * t, scatter, -5.0]
            })
            .collect();
        let lines: Vec<&[f64]> = lines.iter().map(Vec::as_slice).collect();
        let columns = Columns {
            angle: 1,
            torque: 3,
            height: 2,
            temperatures: [1, 3],
            energy: 3,
            force: [1, 2, 9],
        };
        let start = EquilibriumCheck::of(&lines, columns);
        assert_eq!((start.force[0], start.force[1]), (3.0, 0.0));
        assert!(start.force[2].is_nan());
        assert_eq!((start.torque, start.torque_error), (5.0, 0.0));
        assert!((start.force_error[1] - (1.0 / 7.0_f64).sqrt()).abs() < 1e-15);
        assert_eq!((start.angle_drift_degrees, start.energy_drift), (2.0, 0.0));
        assert_eq!(start.temperature, [3.0, -5.0]);
        assert_eq!(start.lines, 8);
        // No line, no number.
        assert!(EquilibriumCheck::of(&[], columns).torque.is_nan());
    }
}
