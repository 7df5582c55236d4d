//! Space that is periodic along some axes.

use super::SpaceError;
use nalgebra::Vector3;

/// Names of the axes, as messages spell them.
pub const AXES: [&str; 3] = ["x", "y", "z"];

/// Lengths after which space repeats, each axis periodic or open.
///
/// The cell begins at the origin: a periodic axis runs from 0 to its length. Any unit of length.
///
/// ```
/// use nalgebra::Vector3;
/// use tribos::space::{AXES, PeriodicBox};
/// // A channel that repeats after 10 m along x.
/// let channel = PeriodicBox::new([Some(10.0), None, None])?;
/// let (a, b) = (Vector3::new(9.5, 0.0, 0.0), Vector3::new(0.5, 0.0, 2.0));
/// // The shortest way crosses the border, where there is one.
/// assert_eq!(channel.displacement(&a, &b), Vector3::new(1.0, 0.0, 2.0));
/// assert_eq!(PeriodicBox::OPEN.displacement(&a, &b), b - a);
/// assert_eq!(channel.wrap(&Vector3::new(-0.5, 0.0, 7.0)), Vector3::new(9.5, 0.0, 7.0));
/// for (axis, period) in AXES.iter().zip(channel.lengths()) {
///     assert_eq!(period.is_some(), *axis == "x");
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PeriodicBox {
    lengths: [Option<f64>; 3],
    /// Displacement along x of the image one period higher along z (Lees and Edwards 1972).
    offset: f64,
}

impl PeriodicBox {
    /// Open along every axis.
    pub const OPEN: Self = Self {
        lengths: [None; 3],
        offset: 0.0,
    };

    /// A box with these periods, `None` for an open axis. *Domain*: finite, > 0.
    pub fn new(lengths: [Option<f64>; 3]) -> Result<Self, SpaceError> {
        for (axis, length) in lengths.into_iter().enumerate() {
            match length {
                Some(given) if given.is_nan() || given <= 0.0 || given.is_infinite() => {
                    return Err(SpaceError::Period { axis, given });
                }
                _ => {}
            }
        }
        Ok(Self {
            lengths,
            offset: 0.0,
        })
    }

    /// The periods, `None` for an open axis.
    pub fn lengths(&self) -> [Option<f64>; 3] {
        self.lengths
    }

    /// Shortest displacement from `a` to `b`: b − a minus whole periods.
    ///
    /// *Domain*: any; NaN and infinite coordinates give NaN along their axis, or infinity along an
    /// open one. At half a period the sign of b − a stays. `displacement(b, a)` is its negative to
    /// the bit. *Accuracy*: one rounding of b − a for positions within a period of each other,
    /// otherwise half an ulp of each position.
    #[inline]
    pub fn displacement(&self, a: &Vector3<f64>, b: &Vector3<f64>) -> Vector3<f64> {
        let mut straight = b - a;
        if self.offset != 0.0 {
            straight.x -= self.offset * self.levels(straight.z);
        }
        Vector3::new(
            nearest_image(straight.x, self.lengths[0]),
            nearest_image(straight.y, self.lengths[1]),
            nearest_image(straight.z, self.lengths[2]),
        )
    }

    /// The image of `x` in the cell: periodic coordinates in [0, length), open ones unchanged.
    ///
    /// *Domain*: any; NaN and infinity give NaN along a periodic axis.
    pub fn wrap(&self, x: &Vector3<f64>) -> Vector3<f64> {
        let mut along = x.x;
        if self.offset != 0.0 {
            along -= self.offset * self.level(x.z);
        }
        Vector3::new(
            wrapped(along, self.lengths[0]),
            wrapped(x.y, self.lengths[1]),
            wrapped(x.z, self.lengths[2]),
        )
    }

    /// The box whose images one period higher along z are displaced along x by `offset`. *Domain*: finite;
    /// 0 unless x and z are periodic.
    #[doc(hidden)]
    pub fn sheared(self, offset: f64) -> Self {
        Self { offset, ..self }
    }

    /// Displacement along x of the image one period higher along z.
    #[doc(hidden)]
    pub fn offset(&self) -> f64 {
        self.offset
    }

    /// Whole periods along z between the ends of a distance and its nearest image: 0 for most pairs.
    #[inline]
    #[doc(hidden)]
    pub fn levels(&self, distance: f64) -> f64 {
        match self.lengths[2] {
            Some(length) if distance.abs() > 0.5 * length => (distance / length).round(),
            _ => 0.0,
        }
    }

    /// Number of periods along z by which [`PeriodicBox::wrap`] lowers a coordinate.
    #[doc(hidden)]
    pub fn level(&self, z: f64) -> f64 {
        match self.lengths[2] {
            Some(length) => ((z - wrapped(z, Some(length))) / length).round(),
            None => 0.0,
        }
    }

    /// The box with its axis z open.
    pub(crate) fn open_upwards(self) -> Self {
        let [x, y, _] = self.lengths;
        Self {
            lengths: [x, y, None],
            offset: 0.0,
        }
    }

    /// The places from which a search looks around, for a `place` in the cell: itself and, in a sheared box,
    /// its images beyond the borders along z that are within `reach`.
    pub(crate) fn search_origins(
        &self,
        place: Vector3<f64>,
        reach: f64,
    ) -> [Option<Vector3<f64>>; 3] {
        let mut all = [Some(place), None, None];
        if let Some(height) = self.lengths[2].filter(|_| self.offset != 0.0) {
            let moved = |levels: f64| {
                let along = place.x + levels * self.offset;
                let x = wrapped(along, self.lengths[0]);
                Vector3::new(x, place.y, place.z + levels * height)
            };
            let wide = reach + ROUNDING * height;
            all[1] = (place.z < wide).then(|| moved(1.0));
            all[2] = (place.z > height - wide).then(|| moved(-1.0));
        }
        all
    }
}

/// Relative tolerance for the rounding of a position, about 1e-15.
const ROUNDING: f64 = 8.0 * f64::EPSILON;

/// `distance` minus whole periods, at most half of one.
#[inline]
fn nearest_image(distance: f64, length: Option<f64>) -> f64 {
    match length {
        None => distance,
        // The common case: most pairs are far nearer than half a period.
        Some(length) if distance.abs() <= 0.5 * length => distance,
        Some(length) => distance - length * (distance / length).round(),
    }
}

/// `x` minus whole periods, in [0, length).
fn wrapped(x: f64, length: Option<f64>) -> f64 {
    match length {
        None => x,
        Some(length) if (0.0..length).contains(&x) => x,
        Some(length) => {
            let inside = x - length * (x / length).floor();
            // A small negative number rounds to the whole length, which is the image of 0.
            if inside < 0.0 || inside >= length {
                0.0
            } else {
                inside
            }
        }
    }
}
