//! Columns of a log as measurements: what is left out, and what is made of a friction without sign.

use super::data::Measurements;
use super::error::FitError;
use super::law::FitLaw;
use super::slopes::Accelerated;

/// Columns of a log in SI, one number a row.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct FitColumns {
    /// Times in s; none of steady sliding.
    pub times: Option<Vec<f64>>,
    /// Velocities in m/s.
    pub velocities: Vec<f64>,
    /// Friction, as a coefficient or in N.
    pub friction: Vec<f64>,
    /// Standard deviations of friction.
    pub sigma: Option<Vec<f64>>,
    /// Accelerations in m/s².
    pub acceleration: Option<Vec<f64>>,
    /// Loads in N.
    pub load: Option<Vec<f64>>,
    /// Speed in m/s up to which a sample counts as at rest under laws of sliding.
    pub rest: f64,
    /// Whether a constant force is in the friction, which then has a sign of its own.
    pub has_offset: bool,
    /// Whether accelerations are wanted: without a column they are slopes of the velocity.
    pub wants_acceleration: bool,
}

/// Measurements from a log.
#[derive(Clone, Debug, PartialEq)]
pub struct Prepared {
    /// The measurements.
    pub data: Measurements,
    /// Row of each point, if rows were left out.
    pub rows: Option<Vec<usize>>,
    /// Rows at rest that were left out.
    pub resting: usize,
    /// Rows without a load that were left out: the sample was lifted.
    pub lifted: usize,
    /// Share of noise in accelerations that are slopes of the velocity; 0 where they were measured.
    pub acceleration_noise: f64,
    /// Whether friction had no sign, and was taken along the velocity.
    pub is_signed_by_velocity: bool,
}

impl FitColumns {
    /// The measurements for a law, or for all of them.
    ///
    /// Rows at rest are left out where they say nothing of sliding friction, and rows without a load. Friction that is hardly ever negative, of a sample that
    /// moves in both directions, was recorded without sign: it gets that of the velocity.
    ///
    /// ```
    /// use tribos::fit::{FitColumns, FitLaw};
    /// let log = FitColumns {
    ///     velocities: vec![0.1, 0.0, -0.1],
    ///     friction: vec![0.3, 0.4, 0.3],
    ///     ..FitColumns::default()
    /// };
    /// let found = log.prepared(Some(FitLaw::Coulomb))?;
    /// assert_eq!((found.data.friction(), found.resting), (&[0.3, -0.3][..], 1));
    /// assert!(found.is_signed_by_velocity && found.rows == Some(vec![0, 2]));
    /// # Ok::<(), tribos::fit::FitError>(())
    /// ```
    pub fn prepared(mut self, law: Option<FitLaw>) -> Result<Prepared, FitError> {
        let is_signed_by_velocity = !self.has_offset && self.is_without_sign();
        if is_signed_by_velocity {
            for (f, v) in self.friction.iter_mut().zip(&self.velocities) {
                *f *= v.signum();
            }
        }
        let sliding_only = self.times.is_none() || law.is_none_or(FitLaw::needs_motion);
        let rests = |row: usize| sliding_only && self.velocities[row].abs() <= self.rest;
        let lifts = |row: usize| self.load.as_ref().is_some_and(|load| load[row] <= 0.0);
        let mut acceleration_noise = 0.0;
        if let (true, None, Some(times)) =
            (self.wants_acceleration, &self.acceleration, &self.times)
        {
            let record = Accelerated {
                times,
                velocities: &self.velocities,
                friction: &self.friction,
                load: self.load.as_deref(),
            };
            let (slopes, noise) = record.slopes(|row| !rests(row) && !lifts(row));
            self.acceleration = Some(slopes);
            acceleration_noise = noise;
        }
        let all = || 0..self.velocities.len();
        let lifted = all().filter(|&row| lifts(row)).count();
        let resting = all().filter(|&row| rests(row) && !lifts(row)).count();
        let rows: Option<Vec<usize>> = (resting + lifted > 0)
            .then(|| all().filter(|&row| !rests(row) && !lifts(row)).collect());
        if let Some(rows) = &rows {
            self.keep(rows);
        }
        let row_of = |point: usize| rows.as_ref().map_or(point, |rows| rows[point]);
        let in_log = |error| match error {
            FitError::Point { point, message } => FitError::Point {
                point: row_of(point),
                message,
            },
            other => other,
        };
        let data = self.measurements().map_err(in_log)?;
        Ok(Prepared {
            data,
            rows,
            resting,
            lifted,
            acceleration_noise,
            is_signed_by_velocity,
        })
    }

    /// Whether friction does not change its sign with the velocity, but for noise about zero.
    fn is_without_sign(&self) -> bool {
        /// Share of the sum that may have the other sign.
        const NOISE: f64 = 0.01;
        let is_both = |sign: f64| self.velocities.iter().any(|v| v * sign > 0.0);
        let sum = |sign: f64| {
            let of_sign = self.friction.iter().map(|f| (f * sign).max(0.0));
            of_sign.sum::<f64>()
        };
        is_both(1.0) && is_both(-1.0) && sum(-1.0) <= NOISE * sum(1.0)
    }

    /// Leaves other rows out.
    fn keep(&mut self, rows: &[usize]) {
        let picked = |column: &mut Vec<f64>| {
            *column = rows
                .iter()
                .filter_map(|&row| column.get(row).copied())
                .collect();
        };
        let more = [
            &mut self.times,
            &mut self.sigma,
            &mut self.acceleration,
            &mut self.load,
        ];
        for column in more.into_iter().flatten() {
            picked(column);
        }
        picked(&mut self.velocities);
        picked(&mut self.friction);
    }

    fn measurements(self) -> Result<Measurements, FitError> {
        let mut data = match self.times {
            Some(times) => Measurements::series(times, self.velocities, self.friction, self.sigma)?,
            None => Measurements::steady(self.velocities, self.friction, self.sigma)?,
        };
        if let Some(acceleration) = self.acceleration {
            data = data.with_acceleration(acceleration)?;
        }
        match self.load {
            Some(load) => data.with_load(load),
            None => Ok(data),
        }
    }
}
