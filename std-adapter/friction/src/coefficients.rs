//! Coefficients of friction, the same in all directions or along two axes.

use super::refusal::finite_number;
use super::{Area, FrictionError, Precision};
use std::fmt;
use std::str::FromStr;
use tribos_core::law::LawError;
use tribos_core::patch::anisotropic::AxisCoefficients;
use tribos_core::real::Real;

/// Dry friction of a patch: one coefficient, or two along an axis of the patch and across it.
///
/// Written `0.5`, `0.5,0.9` (along x and y) or `0.5,0.9,30deg` (along the direction at 30° from x and across it;
/// without `deg` the angle is in rad).
///
/// ```
/// use tribos::friction::{Area, AreaFriction, Coefficients, Law};
/// use tribos::prelude::*;
/// let tread: Coefficients = "0.5,0.9,90deg".parse()?;
/// assert_eq!((tread.largest(), tread.to_string().as_str()), (0.9, "0.5,0.9,90deg"));
/// let sole = tread.on(Area::named(&"box:0.2x0.08".parse()?, 1.0, None)?)?;
/// let friction = AreaFriction::new(&sole, &Law::coulomb(tread.largest())?, None)?;
/// // Along y, which is its axis, it slides more easily.
/// assert!((friction.wrench(100.0, &Twist::new(0.0, 0.1, 0.0)).force.y + 50.0).abs() < 1e-12);
/// # Ok::<(), tribos::friction::FrictionError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Coefficients {
    mu: [f64; 2],
    angle: Angle,
}

/// The direction of the first axis, as it is written.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Angle {
    Degrees(f64),
    Radians(f64),
}

impl Coefficients {
    /// The same in all directions. *Domain*: 0 ≤ `mu` < ∞.
    pub fn isotropic(mu: f64) -> Result<Self, FrictionError> {
        if !(mu >= 0.0 && mu.is_finite()) {
            return Err(LawError::Coefficient { given: mu }.into());
        }
        Ok(Self {
            mu: [mu; 2],
            angle: Angle::Radians(0.0),
        })
    }

    /// Along an axis at `angle` from x, in rad, and across it. *Domain*: both > 0, or both the same.
    pub fn along_and_across(mu: [f64; 2], angle: f64) -> Result<Self, FrictionError> {
        Self::new(mu, Angle::Radians(angle))
    }

    fn new(mu: [f64; 2], angle: Angle) -> Result<Self, FrictionError> {
        let made = Self { mu, angle };
        if !made.is_isotropic() {
            made.axes::<f64>()?;
        } else {
            Self::isotropic(mu[0])?;
        }
        Ok(made)
    }

    /// The larger one: the coefficient of the area of [`Coefficients::on`].
    pub fn largest(&self) -> f64 {
        self.mu[0].max(self.mu[1])
    }

    /// Whether both are the same.
    pub fn is_isotropic(&self) -> bool {
        self.mu[0] == self.mu[1]
    }

    /// Whether these are nowhere larger than `others`, along the same axis.
    pub(super) fn is_within(&self, others: &Self) -> bool {
        let same = self.angle == others.angle;
        match (self.is_isotropic(), others.is_isotropic()) {
            (true, _) => self.mu[0] <= others.mu[0].min(others.mu[1]),
            (false, true) => self.largest() <= others.mu[0],
            (false, false) => {
                same && self
                    .mu
                    .iter()
                    .zip(&others.mu)
                    .all(|(own, other)| own <= other)
            }
        }
    }

    /// `area` with these directions, under the larger coefficient.
    pub fn on<R: Precision>(&self, area: Area<R>) -> Result<Area<R>, FrictionError> {
        if self.is_isotropic() {
            return Ok(area);
        }
        area.with_axes(self.axes()?)
    }

    fn axes<R: Real>(&self) -> Result<AxisCoefficients<R>, FrictionError> {
        let axis = match self.angle {
            Angle::Degrees(degrees) => quarters(degrees),
            Angle::Radians(angle) => [Real::cos(angle), Real::sin(angle)],
        };
        let mu = self.mu.map(R::from_f64);
        Ok(AxisCoefficients::new(mu, axis.map(R::from_f64))?)
    }
}

/// Cosine and sine of an angle in degrees, exact at multiples of 90.
pub(super) fn quarters(degrees: f64) -> [f64; 2] {
    let rest = degrees % 360.0;
    let [cos, sin] = match rest.abs() {
        0.0 => [1.0, 0.0],
        90.0 => [0.0, 1.0],
        180.0 => [-1.0, 0.0],
        270.0 => [0.0, -1.0],
        angle => [Real::cos(angle.to_radians()), Real::sin(angle.to_radians())],
    };
    [cos, if rest < 0.0 { -sin } else { sin }]
}

impl FromStr for Coefficients {
    type Err = FrictionError;

    fn from_str(text: &str) -> Result<Self, FrictionError> {
        let number = |part: &str| finite_number(part).map_err(FrictionError::Syntax);
        let parts: Vec<&str> = text.split(',').map(str::trim).collect();
        match *parts {
            [mu] => Self::isotropic(number(mu)?),
            [along, across] => Self::new([number(along)?, number(across)?], Angle::Degrees(0.0)),
            [along, across, angle] => {
                let angle = match angle.strip_suffix("deg") {
                    Some(degrees) => Angle::Degrees(number(degrees)?),
                    None => Angle::Radians(number(angle)?),
                };
                Self::new([number(along)?, number(across)?], angle)
            }
            _ => Err(FrictionError::Syntax(
                "give one coefficient, 0.5, or two along x and y, 0.5,0.9, or along an axis and across it, \
                 0.5,0.9,30deg"
                    .into(),
            )),
        }
    }
}

impl fmt::Display for Coefficients {
    /// As [`Coefficients::from_str`] takes it.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [along, across] = self.mu;
        if self.is_isotropic() {
            return write!(f, "{along}");
        }
        match self.angle {
            Angle::Degrees(0.0) => write!(f, "{along},{across}"),
            Angle::Degrees(degrees) => write!(f, "{along},{across},{degrees}deg"),
            Angle::Radians(angle) => write!(f, "{along},{across},{angle}"),
        }
    }
}
