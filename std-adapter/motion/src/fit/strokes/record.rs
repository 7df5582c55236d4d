//! What a tribometer recorded: friction over time, with the motion if it is known.

use crate::fit::FitError;
use crate::fit::data::{refuse, rising, same_length};

/// Magnitudes whose squares neither overflow nor vanish.
const MAGNITUDES: std::ops::RangeInclusive<f64> = 1e-140..=1e140;

/// A validated record of strokes. *Units*: s, m/s, m; friction as a coefficient or in N.
///
/// ```
/// use tribos::fit::strokes::StrokeRecord;
/// let record = StrokeRecord::new(vec![0.0, 0.1, 0.2], vec![3.0, 3.1, 2.9])?
///     .with_velocities(vec![0.01, 0.01, 0.01])?
///     .per_load(&[10.0, 10.0, 10.0])?;
/// assert_eq!(record.friction()[0], 0.3);
/// assert!(StrokeRecord::new(vec![0.0, 0.0], vec![0.3, 0.3]).is_err()); // times must rise
/// # Ok::<(), tribos::fit::FitError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct StrokeRecord {
    pub(super) times: Vec<f64>,
    pub(super) friction: Vec<f64>,
    pub(super) velocities: Option<Vec<f64>>,
    pub(super) positions: Option<Vec<f64>>,
}

impl StrokeRecord {
    /// Friction over time; the motion is unknown until it is added.
    ///
    /// *Domain*: at least two rows, times finite and rising, friction finite; magnitudes other than 0
    /// between 1e-140 and 1e140.
    pub fn new(times: Vec<f64>, friction: Vec<f64>) -> Result<Self, FitError> {
        same_length(times.len(), friction.len())?;
        rising(&times)?;
        checked("friction", &friction)?;
        if times.len() < 2 {
            return Err(FitError::Whole("strokes need at least two rows"));
        }
        Ok(Self {
            times,
            friction,
            velocities: None,
            positions: None,
        })
    }

    /// Adds the sliding velocity of each row, of either sign, in m/s.
    pub fn with_velocities(self, velocities: Vec<f64>) -> Result<Self, FitError> {
        same_length(self.times.len(), velocities.len())?;
        checked("the velocity", &velocities)?;
        let velocities = Some(velocities);
        Ok(Self { velocities, ..self })
    }

    /// Adds the position of each row, in m. Lengths of strokes come from it; without velocities the
    /// velocity is its difference over time.
    pub fn with_positions(self, positions: Vec<f64>) -> Result<Self, FitError> {
        same_length(self.times.len(), positions.len())?;
        checked("the position", &positions)?;
        let positions = Some(positions);
        Ok(Self { positions, ..self })
    }

    /// Divides friction by the load of each row, in N.
    pub fn per_load(mut self, loads: &[f64]) -> Result<Self, FitError> {
        same_length(self.times.len(), loads.len())?;
        refuse(
            loads,
            |load| !(*load > 0.0 && load.is_finite()),
            |load| format!("the load must be > 0, not {load}"),
        )?;
        for (friction, load) in self.friction.iter_mut().zip(loads) {
            *friction /= load;
        }
        checked("friction per load", &self.friction)?;
        Ok(self)
    }

    /// Times, in s.
    pub fn times(&self) -> &[f64] {
        &self.times
    }

    /// Friction as it was measured, per load if loads were given.
    pub fn friction(&self) -> &[f64] {
        &self.friction
    }

    /// Positions in m; without them, the integral of the velocities; none if the motion is unknown.
    pub fn path(&self) -> Option<Vec<f64>> {
        let integral = |velocities: &Vec<f64>| {
            let mut at = 0.0;
            let steps = self.times.windows(2).zip(velocities.windows(2));
            let steps = steps.map(|(t, v)| match (t, v) {
                ([t0, t1], [v0, v1]) => 0.5 * (t1 - t0) * (v0 + v1),
                _ => 0.0,
            });
            let later = steps.map(|step| {
                at += step;
                at
            });
            std::iter::once(0.0).chain(later).collect()
        };
        let positions = self.positions.clone();
        positions.or_else(|| self.velocities.as_ref().map(integral))
    }
}

/// Refuses values that are not finite or whose squares are out of range.
fn checked(what: &str, values: &[f64]) -> Result<(), FitError> {
    let fits = |x: &f64| *x == 0.0 || MAGNITUDES.contains(&x.abs());
    refuse(
        values,
        |x| !fits(x),
        |x| match x.is_finite() {
            true => {
                format!("{what} is {x:e}, beyond 1e-140 to 1e140; give the column in another unit")
            }
            false => format!("{what} must be finite, not {x}"),
        },
    )
}
