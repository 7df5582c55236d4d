//! Parameters of a model, and the coordinates of the search.

/// Range of a parameter.
///
/// ```
/// use tribos::fit::Range;
/// let exponent = Range::Between { above: -1.0, up_to: 2.0 };
/// assert!(exponent.admits(2.0) && !exponent.admits(-1.0));
/// assert_eq!(exponent.describe(), "> -1 and <= 2");
/// assert!(Range::NotNegative.admits(0.0) && !Range::Positive.admits(0.0));
/// assert!(!Range::Any.admits(f64::INFINITY)); // all ranges are finite
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Range {
    /// Any finite number.
    Any,
    /// Finite and > 0: the search uses its logarithm.
    Positive,
    /// Finite and ≥ 0.
    NotNegative,
    /// `above` < value ≤ `up_to`.
    Between {
        /// Exclusive lower end.
        above: f64,
        /// Inclusive upper end.
        up_to: f64,
    },
}

/// One parameter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FitParameter {
    /// Name of the parameter on the command line and in files.
    pub name: &'static str,
    /// Unit of the parameter, or "-" for a pure number.
    pub unit: &'static str,
    /// Meaning of the parameter.
    pub meaning: &'static str,
    /// Range of the parameter.
    pub range: Range,
}

/// A model to be fitted: it predicts each point of the data.
///
/// ```
/// use tribos::fit::{Measurements, Model, FitOptions, FitParameter, Range};
/// /// Coulomb friction and a viscous film, a + b v.
/// struct Film(Vec<f64>);
/// const A: FitParameter =
///     FitParameter { name: "a", unit: "N", meaning: "dry friction", range: Range::NotNegative };
/// const B: FitParameter = FitParameter { name: "b", unit: "N s/m", meaning: "drag", ..A };
/// impl Model for Film {
///     fn parameters(&self) -> &[FitParameter] { &[A, B] }
///     fn reference(&self, _: usize) -> Option<f64> { None }
///     fn predict(&self, values: &[f64]) -> Option<Vec<f64>> {
///         Some(self.0.iter().map(|v| values[0] + values[1] * v).collect())
///     }
///     fn start(&self, unit: &[f64]) -> Vec<f64> { unit.to_vec() }
/// }
/// let speeds = vec![1.0, 2.0, 3.0];
/// let data = Measurements::steady(speeds.clone(), vec![2.5, 3.0, 3.5], None)?; // on the line 2 + v/2
/// let found = data.fit(&Film(speeds), &FitOptions::default())?;
/// assert!((found.parameters[0].value - 2.0).abs() < 1e-9);
/// assert!((found.parameters[1].value - 0.5).abs() < 1e-9);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub trait Model: Send + Sync {
    /// The parameters, in the order of all slices here.
    fn parameters(&self) -> &[FitParameter];

    /// Default value of a parameter that is fixed unless stated otherwise: a reference that only
    /// sets the scale of another one.
    fn reference(&self, parameter: usize) -> Option<f64>;

    /// One prediction per point; `None` if the law refuses the values.
    fn predict(&self, values: &[f64]) -> Option<Vec<f64>>;

    /// The same where each measured friction contains a part that is not the law's, from which a state that is
    /// sought in the measurement must be freed; empty if there is none.
    fn predict_beside(&self, values: &[f64], _beside: &[f64]) -> Option<Vec<f64>> {
        self.predict(values)
    }

    /// Predictions of a motion of which nothing was measured: it begins in steady sliding, relaxed where it begins at rest.
    fn foretell(&self, values: &[f64]) -> Option<Vec<f64>> {
        self.predict(values)
    }

    /// Initial values for a point of the unit cube with one coordinate per parameter; the middle is the best guess.
    fn start(&self, unit: &[f64]) -> Vec<f64>;

    /// Whether predictions are linear in this parameter while the others are kept, or nearly so: its
    /// starts are then improved by linear least squares.
    fn is_linear(&self, _parameter: usize) -> bool {
        false
    }

    /// Puts the values of parts that are alike, and may change places, in their order.
    fn put_in_order(&self, _values: &mut [f64]) {}

    /// The parameter that this one must not be below.
    fn above(&self, _parameter: usize) -> Option<usize> {
        None
    }

    /// Least and largest value that these data can show, within the parameter's range.
    fn limits(&self, _parameter: usize) -> [f64; 2] {
        [f64::NEG_INFINITY, f64::INFINITY]
    }

    /// The same model for a subset of the points, in rising order and including the first; `None`
    /// if it needs all points. Fits of many points search on such a sample first.
    fn subsample(&self, _points: &[usize]) -> Option<Box<dyn Model + '_>> {
        None
    }

    /// Points of a sample that serves this model better than an even one.
    fn sample(&self, _count: usize) -> Option<Vec<usize>> {
        None
    }

    /// The same model with another motion between the points; `None` if predictions do not depend on it.
    fn along(&self, _path: Between) -> Option<Box<dyn Model + '_>> {
        None
    }
}

/// What a record leaves open: the motion from one point to the next.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Between {
    /// Steps from one point to the next.
    pub steps: u32,
    /// How the velocity goes from its value at one point to that at the next.
    pub course: VelocityCourse,
}

/// How the velocity goes from one point of a record to the next.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum VelocityCourse {
    /// On a straight line.
    Straight,
    /// On the natural cubic spline through the points.
    Smooth,
    /// By a jump where the velocity changes abruptly, at the instant that suits the friction after it best; straight
    /// elsewhere.
    Jumps,
}

impl Between {
    /// One step along a straight line.
    pub const PLAIN: Self = Self {
        steps: 1,
        course: VelocityCourse::Straight,
    };
}

/// Least distance of a parameter from an exclusive end.
const MARGIN: f64 = 1e-9;

impl Range {
    /// Whether a value is in the range.
    pub fn admits(self, value: f64) -> bool {
        value.is_finite()
            && match self {
                Self::Any => true,
                Self::Positive => value > 0.0,
                Self::NotNegative => value >= 0.0,
                Self::Between { above, up_to } => value > above && value <= up_to,
            }
    }

    /// Description of the range.
    pub fn describe(self) -> String {
        match self {
            Self::Any => "finite".into(),
            Self::Positive => "> 0".into(),
            Self::NotNegative => ">= 0".into(),
            Self::Between { above, up_to } => format!("> {above} and <= {up_to}"),
        }
    }

    /// The coordinate of a value.
    pub(super) fn coordinate(self, value: f64) -> f64 {
        match self {
            Self::Positive => libm::log(value),
            _ => value,
        }
    }

    /// The value at a coordinate.
    pub(super) fn value(self, coordinate: f64) -> f64 {
        match self {
            Self::Positive => libm::exp(coordinate),
            _ => coordinate,
        }
    }

    /// Derivative of the value by the coordinate.
    pub(super) fn derivative(self, value: f64) -> f64 {
        match self {
            Self::Positive => value,
            _ => 1.0,
        }
    }

    /// Bounds of the coordinate, both included.
    pub(super) fn bounds(self) -> [f64; 2] {
        /// Logarithms of the smallest and largest values, within the normal numbers.
        const LOGARITHMS: [f64; 2] = [-700.0, 700.0];
        match self {
            Self::Any => [f64::NEG_INFINITY, f64::INFINITY],
            Self::Positive => LOGARITHMS,
            Self::NotNegative => [0.0, f64::INFINITY],
            Self::Between { above, up_to } => [above + MARGIN * (up_to - above).min(1.0), up_to],
        }
    }
}
