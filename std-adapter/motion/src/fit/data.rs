//! Measurements: friction at speeds, or over time.

use super::FitError;
use std::borrow::Cow;

/// Motion of the surfaces.
#[derive(Clone, Debug, PartialEq)]
pub enum Motion {
    /// Steady sliding at these velocities.
    Steady {
        /// Velocities of either sign, none 0, in m/s.
        speeds: Vec<f64>,
    },
    /// A record over time.
    Series {
        /// Times in rising order, in s.
        times: Vec<f64>,
        /// Velocities at those times, of either sign, in m/s.
        velocities: Vec<f64>,
    },
}

/// Validated measurements. *Units*: SI; friction as a force or, per load, as a coefficient: the
/// parameters come out likewise.
///
/// ```
/// use tribos::fit::{FitError, Measurements, Motion};
/// // A block drawn to and fro: s, m/s, N and the standard deviation of the force.
/// let (times, velocities) = (vec![0.0, 0.1, 0.2], vec![0.2, 0.0, -0.2]);
/// let data = Measurements::series(times, velocities, vec![1.5, 0.1, -1.5], Some(vec![0.05; 3]))?;
/// assert!(matches!(data.motion(), Motion::Series { .. }));
/// assert_eq!((data.velocities()[2], data.friction()[2]), (-0.2, -1.5)); // it resists
/// assert_eq!(data.sigma(), Some(&[0.05; 3][..]));
/// // A force that drives the body is no friction.
/// assert!(matches!(Measurements::steady(vec![0.2], vec![-1.5], None), Err(FitError::Whole(_))));
/// # Ok::<(), FitError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Measurements {
    pub(super) motion: Motion,
    pub(super) friction: Vec<f64>,
    pub(super) sigma: Option<Vec<f64>>,
    pub(super) load: Option<Vec<f64>>,
    pub(super) acceleration: Option<Vec<f64>>,
}

/// Speeds and frictions whose logarithms and ratios to each other stay within the normal numbers.
const MAGNITUDES: std::ops::RangeInclusive<f64> = 1e-290..=1e290;

impl Measurements {
    /// Friction of steady sliding, in one direction or both.
    ///
    /// *Domain*: velocities finite and not 0, friction finite and with the sign of the velocity on the whole,
    /// standard deviations finite and > 0; speeds and the largest friction between 1e-290 and 1e290.
    pub fn steady(
        speeds: Vec<f64>,
        friction: Vec<f64>,
        sigma: Option<Vec<f64>>,
    ) -> Result<Self, FitError> {
        let wrong = |v: &f64| *v == 0.0 || !v.is_finite();
        refuse(&speeds, wrong, |v| {
            format!(
                "the velocity of steady sliding must be finite and not 0, not {v}; leave rest out"
            )
        })?;
        Self::checked(Motion::Steady { speeds }, friction, sigma)
    }

    /// Friction over time. Between two times the velocity goes from one value to the other.
    ///
    /// *Domain*: times finite and rising, velocities and friction finite, friction with the sign of the
    /// velocity on the whole; speeds other than 0 and the largest friction between 1e-290 and 1e290.
    pub fn series(
        times: Vec<f64>,
        velocities: Vec<f64>,
        friction: Vec<f64>,
        sigma: Option<Vec<f64>>,
    ) -> Result<Self, FitError> {
        same_length(times.len(), velocities.len())?;
        rising(&times)?;
        refuse(
            &velocities,
            |v| !v.is_finite(),
            |v| format!("the velocity must be finite, not {v}"),
        )?;
        Self::checked(Motion::Series { times, velocities }, friction, sigma)
    }

    fn checked(
        motion: Motion,
        friction: Vec<f64>,
        sigma: Option<Vec<f64>>,
    ) -> Result<Self, FitError> {
        let velocities = match &motion {
            Motion::Steady { speeds } => speeds,
            Motion::Series { velocities, .. } => velocities,
        };
        same_length(velocities.len(), friction.len())?;
        refuse(
            &friction,
            |f| !f.is_finite(),
            |f| format!("friction must be finite, not {f}"),
        )?;
        if let Some(sigma) = &sigma {
            same_length(friction.len(), sigma.len())?;
            refuse(
                sigma,
                |s| !(*s > 0.0 && s.is_finite()),
                |s| format!("the standard deviation must be > 0, not {s}"),
            )?;
        }
        let largest = friction.iter().fold(0.0, |most: f64, f| most.max(f.abs()));
        let speeds = extremes(velocities.iter().map(|v| v.abs()));
        let fits = |x: f64| x <= 0.0 || x.is_infinite() || MAGNITUDES.contains(&x);
        if !fits(largest) || !speeds.into_iter().all(fits) {
            return Err(FitError::Whole(
                "speeds and the largest friction must lie between 1e-290 and 1e290; give them in \
                 another unit",
            ));
        }
        resists(velocities, &friction)?;
        Ok(Self {
            motion,
            friction,
            sigma,
            load: None,
            acceleration: None,
        })
    }

    /// The same with the load in N at each point: friction is then a force in N, and parameters are per load.
    ///
    /// *Domain*: finite and > 0.
    pub fn with_load(mut self, load: Vec<f64>) -> Result<Self, FitError> {
        same_length(self.friction.len(), load.len())?;
        refuse(
            &load,
            |n| !(*n > 0.0 && n.is_finite()),
            |n| format!("the load must be > 0, not {n}"),
        )?;
        self.load = Some(load);
        Ok(self)
    }

    /// The same with the acceleration in m/s² at each point, to which a drive's inertia adds a force.
    ///
    /// *Domain*: finite.
    pub fn with_acceleration(mut self, acceleration: Vec<f64>) -> Result<Self, FitError> {
        same_length(self.friction.len(), acceleration.len())?;
        refuse(
            &acceleration,
            |a| !a.is_finite(),
            |a| format!("the acceleration must be finite, not {a}"),
        )?;
        self.acceleration = Some(acceleration);
        Ok(self)
    }

    /// Motion of the surfaces.
    pub fn motion(&self) -> &Motion {
        &self.motion
    }

    /// Times of the points in s, if this is a record over time.
    pub fn times(&self) -> Option<&[f64]> {
        match &self.motion {
            Motion::Steady { .. } => None,
            Motion::Series { times, .. } => Some(times),
        }
    }

    /// Friction of each point.
    pub fn friction(&self) -> &[f64] {
        &self.friction
    }

    /// Standard deviation of each point, if known.
    pub fn sigma(&self) -> Option<&[f64]> {
        self.sigma.as_deref()
    }

    /// Load of each point in N, if known.
    pub fn load(&self) -> Option<&[f64]> {
        self.load.as_deref()
    }

    /// Velocity of each point.
    pub fn velocities(&self) -> &[f64] {
        match &self.motion {
            Motion::Steady { speeds } => speeds,
            Motion::Series { velocities, .. } => velocities,
        }
    }

    /// Whether friction is large for a coefficient, so that it is a force, and no load is known.
    pub fn is_large(&self) -> bool {
        /// Coefficients of sliding friction stay below it.
        const LARGE: f64 = 3.0;
        self.load.is_none() && self.forces()[1] > LARGE
    }

    /// Friction of a point per load, if loads are known.
    pub(super) fn per_load(&self, point: usize) -> f64 {
        let load = self.load.as_ref().map_or(1.0, |load| load[point]);
        self.friction[point] / load
    }

    /// Friction of all points per load, if loads are known.
    pub(super) fn all_per_load(&self) -> Cow<'_, [f64]> {
        match self.load {
            None => Cow::Borrowed(&self.friction),
            Some(_) => (0..self.friction.len()).map(|i| self.per_load(i)).collect(),
        }
    }

    /// Smallest and largest nonzero |velocity|.
    pub(super) fn speeds(&self) -> [f64; 2] {
        extremes(self.velocities().iter().map(|v| v.abs()))
    }

    /// Smallest and largest nonzero |friction|, per load if loads are known.
    pub(super) fn forces(&self) -> [f64; 2] {
        extremes((0..self.friction.len()).map(|i| self.per_load(i).abs()))
    }
}

/// Refuses friction that drives the body: where it moves both ways, beside a constant force.
fn resists(velocities: &[f64], friction: &[f64]) -> Result<(), FitError> {
    let along = velocities.iter().zip(friction);
    let work: f64 = along.map(|(v, f)| f.copysign(f * v)).sum();
    let mean = |sign: f64| {
        let of_sign = velocities
            .iter()
            .zip(friction)
            .filter(|(v, _)| **v * sign > 0.0);
        // By size, so that sums do not overflow.
        let (sum, count) = of_sign.fold((0.0, 0.0), |(mean, n), (_, f)| {
            let count: f64 = n + 1.0;
            (mean + (f - mean) / count, count)
        });
        (count > 0.0).then_some(sum)
    };
    let resists_both_ways = mean(1.0)
        .zip(mean(-1.0))
        .is_some_and(|(forth, back)| forth > back);
    if work > 0.0 || resists_both_ways {
        return Ok(());
    }
    Err(FitError::Whole(
        "friction must be positive where the velocity is: it resists a body that moves with v; turn its sign \
         by --columns f=-NAME, or give each direction by itself if it was recorded without sign",
    ))
}

/// Error for the first time that is not finite or does not come after the one before it.
pub(super) fn rising(times: &[f64]) -> Result<(), FitError> {
    refuse(
        times,
        |t| !t.is_finite(),
        |t| format!("the time must be finite, not {t}"),
    )?;
    match (1..times.len()).find(|&i| times[i] <= times[i - 1]) {
        None => Ok(()),
        Some(point) => Err(FitError::Point {
            point,
            message: format!(
                "times must rise: {} does not come after {}",
                times[point],
                times[point - 1]
            ),
        }),
    }
}

pub(super) fn same_length(one: usize, other: usize) -> Result<(), FitError> {
    if one == other {
        Ok(())
    } else {
        Err(FitError::Lengths(one, other))
    }
}

/// Error for the first invalid value.
pub(super) fn refuse(
    values: &[f64],
    wrong: impl Fn(&f64) -> bool,
    message: impl Fn(&f64) -> String,
) -> Result<(), FitError> {
    match values.iter().position(wrong) {
        Some(point) => Err(FitError::Point {
            point,
            message: message(&values[point]),
        }),
        None => Ok(()),
    }
}

fn extremes(values: impl Iterator<Item = f64>) -> [f64; 2] {
    let none = [f64::INFINITY, 0.0];
    values
        .filter(|x| *x > 0.0)
        .fold(none, |[low, high], x| [low.min(x), high.max(x)])
}
