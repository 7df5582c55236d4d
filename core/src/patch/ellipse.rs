//! An elliptic contact: two curved bodies pressed together, or a cut cylinder.

use super::PatchError;
use super::affine_image::{AffineImage, AffineMap};
use crate::real::Real;
use crate::special::CompleteElliptic;
use nalgebra::Vector2;

/// How pressure is spread over an ellipse, with ρ from 0 at its centre to 1 on its edge.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum EllipsePressure {
    /// 1/√(1−ρ²): a rigid flat punch on an elastic half space.
    FlatPunch,
    /// The same everywhere.
    Uniform,
    /// √(1−ρ²): curved elastic bodies (Hertz; Johnson, Contact Mechanics, 4.24).
    Hertz,
    /// 1 − ρ²
    Paraboloid,
}

/// An ellipse under one of four pressures.
///
/// *Units*: length. *Accuracy* of its friction, of μN and μN a about the centre: 1e-14 (f32: 1e-6) for aspect ratios up
/// to 1e3 and any motion; the Jacobian 2e-12 (f32: 1e-5) of its largest entry, for a punch half of
/// those digits where the centre of rotation lies on the edge. *Cost*: two disks (the Jacobian another half) for Hertz'
/// pressure and the punch while the centre of rotation lies inside: complete elliptic integrals, found when the
/// ellipse is made. Else 32 to 64 lines, each a root or two and three divisions, 5 to 15 boxes (the Jacobian
/// 1.4 times that); 30 in the middle of an ellipse of 1000:1, and up to 60 next to the edge.
///
/// ```
/// use tribos_core::coupling::flat::ShapeFriction;
/// use tribos_core::patch::ellipse::{Ellipse, EllipsePressure};
/// use tribos_core::twist::Twist;
/// let wheel_on_rail = Ellipse::new([0.0_f64, 0.0], [0.006, 0.004], EllipsePressure::Hertz)?; // m
/// let friction = ShapeFriction::new(wheel_on_rail, 0.3)?;
/// let spinning = friction.wrench(5e4, &Twist::new(0.0, 0.0, 1.0)); // N; rad/s
/// // 3/8 μ N a E(e) with E(√5/3) = 1.3221199657742158
/// assert!((spinning.torque + 0.375 * 0.3 * 5e4 * 0.006 * 1.322_119_965_774_216).abs() < 1e-12);
/// # Ok::<(), tribos_core::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ellipse<R: Real> {
    pressure: EllipsePressure,
    centre: Vector2<R>,
    /// Direction of the major axis, of length 1.
    major: Vector2<R>,
    /// The larger semi-axis.
    radius: R,
    /// The smaller semi-axis over the larger one.
    ratio: R,
    /// Of the parameter 1 − ratio².
    integrals: CompleteElliptic<R>,
}

impl<R: Real> Ellipse<R> {
    /// Largest aspect ratio: a longer ellipse is a [`super::bar::Bar`].
    ///
    /// ```
    /// use tribos_core::patch::PatchError;
    /// use tribos_core::patch::ellipse::{Ellipse, EllipsePressure};
    /// let max = Ellipse::<f64>::MAX_ASPECT_RATIO;
    /// let blade = Ellipse::new([0.0_f64, 0.0], [1.0, 0.5 / max], EllipsePressure::FlatPunch);
    /// assert_eq!(blade, Err(PatchError::SemiAxes { given: [1.0, 0.5 / max] }));
    /// ```
    pub const MAX_ASPECT_RATIO: f64 = 1e6;

    /// The ellipse about a centre with semi-axes along x and y.
    ///
    /// *Domain*: a finite centre; positive, finite semi-axes whose quotient is at most
    /// [`Ellipse::MAX_ASPECT_RATIO`].
    pub fn new(
        centre: [R; 2],
        semi_axes: [R; 2],
        pressure: EllipsePressure,
    ) -> Result<Self, PatchError> {
        let [a, b] = semi_axes;
        let (large, small, major) = if b > a {
            (b, a, Vector2::new(R::ZERO, R::ONE))
        } else {
            (a, b, Vector2::new(R::ONE, R::ZERO))
        };
        let given = [a.to_f64(), b.to_f64()];
        Self::checked(centre, [large, small], major, pressure, given)
    }

    /// The ellipse centre + p cos φ + q sin φ, that is, the image of the unit disk under the matrix with columns p and q.
    ///
    /// *Domain*: as [`Ellipse::new`] for the semi-axes that follow. *Accuracy*: a relative rounding of p and q times
    /// the aspect ratio in the smaller semi-axis.
    ///
    /// ```
    /// use tribos_core::patch::ellipse::{Ellipse, EllipsePressure};
    /// let turned = [[0.3_f64, 0.4], [-0.16, 0.12]]; // m
    /// let ellipse = Ellipse::with_half_diameters([0.0, 0.0], turned, EllipsePressure::Uniform)?;
    /// let [a, b] = ellipse.semi_axes();
    /// assert!((a - 0.5).abs() < 1e-15 && (b - 0.2).abs() < 1e-15);
    /// # Ok::<(), tribos_core::patch::PatchError>(())
    /// ```
    pub fn with_half_diameters(
        centre: [R; 2],
        half_diameters: [[R; 2]; 2],
        pressure: EllipsePressure,
    ) -> Result<Self, PatchError> {
        let [[px, py], [qx, qy]] = half_diameters;
        // Singular values are half the sum and half the difference of the lengths of `sum` and `difference`.
        let sum = Vector2::new(R::HALF * px + R::HALF * qy, R::HALF * py - R::HALF * qx);
        let difference = Vector2::new(R::HALF * px - R::HALF * qy, R::HALF * py + R::HALF * qx);
        let (sum_length, difference_length) =
            (sum.x.hypot(sum.y), difference.x.hypot(difference.y));
        let large = sum_length + difference_length;
        // The determinant over the larger one has the digits of the smaller one.
        let (ux, uy) = (px / large, py / large);
        let small = (ux * qy - uy * qx).abs();
        let major = half_way([sum, difference], [sum_length, difference_length]);
        let given = [large.to_f64(), small.to_f64()];
        Self::checked(centre, [large, small], major, pressure, given)
    }

    fn checked(
        centre: [R; 2],
        [large, small]: [R; 2],
        major: Vector2<R>,
        pressure: EllipsePressure,
        given: [f64; 2],
    ) -> Result<Self, PatchError> {
        let [x, y] = centre;
        if !(x.is_finite() && y.is_finite()) {
            return Err(PatchError::Centre);
        }
        let ratio = small / large;
        let least = R::from_f64(1.0 / Self::MAX_ASPECT_RATIO);
        if !(large.is_finite() && small > R::ZERO && ratio >= least) {
            return Err(PatchError::SemiAxes { given });
        }
        // Rounding may leave the smaller one of half-diameters a bit larger.
        let ratio = if ratio < R::ONE { ratio } else { R::ONE };
        Ok(Self {
            pressure,
            centre: Vector2::new(x, y),
            major,
            radius: large,
            ratio,
            integrals: CompleteElliptic::new(ratio * ratio),
        })
    }

    /// Its pressure.
    pub fn pressure(&self) -> EllipsePressure {
        self.pressure
    }

    /// Its centre.
    pub fn centre(&self) -> Vector2<R> {
        self.centre
    }

    /// The larger semi-axis.
    pub fn radius(&self) -> R {
        self.radius
    }

    /// The larger and the smaller semi-axis.
    pub fn semi_axes(&self) -> [R; 2] {
        [self.radius, self.radius * self.ratio]
    }

    /// Direction of the major axis, of length 1.
    pub fn major_axis(&self) -> Vector2<R> {
        self.major
    }

    #[inline(always)]
    pub(crate) fn minor(&self) -> Vector2<R> {
        Vector2::new(-self.major.y, self.major.x)
    }

    /// The smaller semi-axis over the larger one.
    #[inline(always)]
    pub(crate) fn ratio(&self) -> R {
        self.ratio
    }

    #[inline(always)]
    pub(crate) fn integrals(&self) -> &CompleteElliptic<R> {
        &self.integrals
    }
}

impl<R: Real> AffineImage<R> for Ellipse<R> {
    fn image(self, map: &AffineMap<R>) -> Option<Self> {
        let long = map.of_vector(&(self.major * self.radius));
        let short = map.of_vector(&(self.minor() * (self.radius * self.ratio)));
        let half_diameters = [[long.x, long.y], [short.x, short.y]];
        let centre = map.of(&self.centre);
        Self::with_half_diameters([centre.x, centre.y], half_diameters, self.pressure).ok()
    }
}

/// The direction half way between two vectors of given lengths, one of which is 0 for a circle.
fn half_way<R: Real>([a, b]: [Vector2<R>; 2], [a_length, b_length]: [R; 2]) -> Vector2<R> {
    let along_x = Vector2::new(R::ONE, R::ZERO);
    if a_length == R::ZERO || b_length == R::ZERO {
        return along_x;
    }
    let (a, b) = (a / a_length, b / b_length);
    let sum = a + b;
    // Of almost opposite directions the difference has all digits; the mean is across it.
    let apart = a - b;
    let mean = if a.x * b.x + a.y * b.y >= R::ZERO {
        sum
    } else {
        Vector2::new(-apart.y, apart.x)
    };
    mean / mean.x.hypot(mean.y)
}
