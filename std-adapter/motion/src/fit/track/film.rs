//! The frames of a film that a fit uses.

use super::super::FitError;
use std::f64::consts::TAU;

/// A change of the angle beyond this is taken for a jump by a whole turn.
const HALF_TURN: f64 = 0.5 * TAU;
/// Angles within this range may have been reduced to one turn.
const ONE_TURN: f64 = 1.01 * TAU;
/// Turn between two frames beyond which the number of whole turns is doubtful.
const DOUBTFUL_TURN: f64 = 0.4 * TAU;
/// Steps of about this size, where angles in radians would turn by less, are whole turns in degrees.
const DEGREES: [f64; 2] = [300.0, 420.0];

/// Positions of a body over time, as they were filmed.
///
/// *Units*: s, m and rad. The angle may be reduced to one turn.
///
/// ```
/// use tribos::fit::track::Track;
/// let track = Track::new(vec![0.0, 0.1, 0.2], vec![0.0, 0.1, 0.2], vec![0.0; 3], Some(vec![3.0, -3.0, -2.7]))?;
/// assert_eq!(track.times().len(), 3);
/// assert!((track.angle().ok_or("no angle")?[1] - 3.283).abs() < 1e-3); // counted on past half a turn
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Track {
    times: Vec<f64>,
    x: Vec<f64>,
    y: Vec<f64>,
    angle: Option<Vec<f64>>,
    notes: Vec<String>,
}

impl Track {
    /// From columns of equal lengths. *Domain*: finite; times rise.
    pub fn new(
        times: Vec<f64>,
        x: Vec<f64>,
        y: Vec<f64>,
        angle: Option<Vec<f64>>,
    ) -> Result<Self, FitError> {
        for (name, column) in [("t", Some(&times)), ("x", Some(&x)), ("y", Some(&y))]
            .into_iter()
            .chain([("angle", angle.as_ref())])
        {
            let Some(column) = column else { continue };
            if column.len() != times.len() {
                return Err(FitError::Lengths(times.len(), column.len()));
            }
            if let Some(point) = column.iter().position(|value| !value.is_finite()) {
                let given = column.get(point).copied().unwrap_or(f64::NAN);
                let message = format!("{name} must be a finite number, not {given}");
                return Err(FitError::Point { point, message });
            }
        }
        let falls = times.windows(2).position(|pair| pair[1] <= pair[0]);
        if let Some(before) = falls {
            let (point, late) = (before + 1, times[before]);
            let message = format!(
                "times must rise: {} does not come after {late}",
                times[point]
            );
            return Err(FitError::Point { point, message });
        }
        let mut track = Self {
            times,
            x,
            y,
            angle,
            notes: Vec::new(),
        };
        track.unwrap_angle();
        track.doubt_times();
        Ok(track)
    }

    /// Times of the frames, in s.
    pub fn times(&self) -> &[f64] {
        &self.times
    }

    /// First coordinate of the frames, in m.
    pub fn x(&self) -> &[f64] {
        &self.x
    }

    /// Second coordinate of the frames, in m.
    pub fn y(&self) -> &[f64] {
        &self.y
    }

    /// Angles of the frames in rad, counted on over whole turns.
    pub fn angle(&self) -> Option<&[f64]> {
        self.angle.as_deref()
    }

    /// What was noticed about the columns.
    pub(super) fn notes(&self) -> &[String] {
        &self.notes
    }

    /// The frames between two times, both included, without the first `skip`.
    pub(super) fn between(&self, skip: usize, from: Option<f64>, to: Option<f64>) -> Self {
        let is_used = |i: usize, t: f64| {
            i >= skip && from.is_none_or(|from| t >= from) && to.is_none_or(|to| t <= to)
        };
        let used = self.times.iter().enumerate();
        let used: Vec<usize> = used
            .filter_map(|(i, t)| is_used(i, *t).then_some(i))
            .collect();
        let of = |column: &[f64]| {
            used.iter()
                .filter_map(|&i| column.get(i))
                .copied()
                .collect()
        };
        Self {
            times: of(&self.times),
            x: of(&self.x),
            y: of(&self.y),
            angle: self.angle.as_deref().map(of),
            notes: self.notes.clone(),
        }
    }

    /// Largest distance between two frames along one axis, in m.
    pub(super) fn extent(&self) -> f64 {
        let range = |column: &[f64]| {
            let low = column.iter().copied().fold(f64::INFINITY, f64::min);
            let high = column.iter().copied().fold(f64::NEG_INFINITY, f64::max);
            high - low
        };
        range(&self.x).max(range(&self.y))
    }

    /// Counts angles that were reduced to one turn on over whole turns.
    fn unwrap_angle(&mut self) {
        let Some(angle) = &mut self.angle else { return };
        let low = angle.iter().copied().fold(f64::INFINITY, f64::min);
        let high = angle.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        let steps = angle.windows(2).map(|pair| (pair[1] - pair[0]).abs());
        let is_turn_of_degrees = |step: &f64| DEGREES[0] < *step && *step < DEGREES[1];
        if steps.clone().filter(is_turn_of_degrees).count() > 0 {
            self.notes.push(
                "angles jump by about 360: they look like degrees; give --units angle=deg".into(),
            );
            return;
        }
        if high - low > ONE_TURN {
            return;
        }
        let (mut turns, mut jumps, mut largest, mut last) = (0.0, 0, 0.0_f64, f64::NAN);
        for value in angle.iter_mut() {
            let step = *value - last;
            last = *value;
            if step.abs() > HALF_TURN {
                turns -= TAU.copysign(step);
                jumps += 1;
                largest = largest.max(TAU - step.abs());
            } else {
                largest = largest.max(step.abs());
            }
            *value += turns;
        }
        if jumps > 0 {
            self.notes.push(format!(
                "the angle jumps by a turn in {jumps} places and is counted on over them"
            ));
        }
        if largest > DOUBTFUL_TURN {
            self.notes.push(
                "the body turns by more than 0.4 of a turn from one frame to the next: whole turns may be \
                 lost; film it faster, or give an angle that counts them"
                    .into(),
            );
        }
    }

    /// Notes times that are probably numbers of frames.
    fn doubt_times(&mut self) {
        /// Fewer frames may well be seconds.
        const MANY: usize = 8;
        let is_whole = self.times.iter().all(|t| t.fract() == 0.0);
        if is_whole && self.times.len() >= MANY {
            self.notes.push(
                "all times are whole numbers: if they are numbers of frames, give --frame-rate HZ"
                    .into(),
            );
        }
    }
}
