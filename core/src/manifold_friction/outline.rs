//! The limit curve of a patch: how much torque is left at a given force.

use super::Lanes;

/// The limit curve in one direction of the force. With x = |force|/μN, y = |torque|/(μN r̄), where r̄ is the mean
/// distance from the friction centre, and X = x²,
///
/// ```text
/// y = √(1 − X) h(X),     h = 1 + h₁ X + h₂ X² + h₄ X⁴
/// ```
///
/// Both ends have the curvature of the exact curve: h₁ = −c₀/2 with 1 + c₀ = 1/(r̄ ⟨r∥²/r³⟩) at pure spin and
/// h(1)² = w = ⟨r∥²⟩/r̄² at pure slip, r∥ along the slip. h₂ is the fit between them.
#[doc(hidden)]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Curve<T> {
    pub(super) h1: T,
    pub(super) h2: T,
    pub(super) h4: T,
}

/// What a contact manifold knows of the area that it stands for.
pub trait LimitCurve<T: Lanes>: Copy {
    /// The limit curve for a force along the unit vector `direction`.
    #[doc(hidden)]
    fn curve(&self, direction: [T; 2]) -> Curve<T>;

    /// True if the direction of slip matters.
    const TURNS: bool;
    /// Newton steps of [`manifold_friction`](super::project_friction).
    const STEPS: usize;

    /// Direction of the force nearest to a candidate along `direction`: that of the vector u with
    /// (`isotropic` 1 + `coupled` (1 + C₀)) u = `direction`.
    fn turned(&self, direction: [T; 2], isotropic: T, coupled: T) -> [T; 2];
}

/// Patches whose limit curve is the same in all directions, or nearly so: disks, squares, hexagons, rings.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct IsotropicLimitCurve<T>(Curve<T>);

/// Patches of any outline, such as planks: limit curves that depend on the direction of slip.
///
/// Symmetric matrices have the components xx, xy, yy in the frame of the tangential impulse.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct DirectionalLimitCurve<T> {
    /// 1 + C₀ = ⟨r r/r³⟩⁻¹/r̄, dimensionless: curvatures of the limit surface at pure spin.
    pub spinning: [T; 3],
    /// ⟨r r⟩/r̄², dimensionless: reciprocal curvatures at pure slip.
    pub slipping: [T; 3],
}

/// h₂ = `BETWEEN`[0] + `BETWEEN`[1] w: limit curves of disk, square, hexagon, ellipses and rectangles from
/// 1 : 1 to 10 : 1, in all directions, are within −0.7 % and +0.8 % of the radius.
const BETWEEN: [f32; 2] = [-0.1126, 0.1339];
/// Range of 1 + c₀ and of w in which the curve is convex. Of the areas fitted a bar that slides across itself
/// (w = 0) leaves it.
const LEAST_SPINNING: f32 = 0.3;
const MOST_SPINNING: f32 = 2.0;
const LEAST_SLIPPING: f32 = 0.05;
const MOST_SLIPPING: f32 = 1.5;
/// 1 + c₀ and w. Disk: 3/2 and 9/16; square: 1.482 and 0.569.
const AREA: [f32; 2] = [1.49, 0.566];
/// Coefficients of h for a ring, whose limit curve they give to 0.12 % of the radius; minimax fit.
const RING: [f32; 3] = [-0.5203, 0.2304, 0.0135];

impl<T: Lanes> Curve<T> {
    /// From 1 + c₀ and w.
    #[inline(always)]
    fn new(spinning: T, slipping: T) -> Self {
        let (one, half) = (T::splat(1.0), T::splat(0.5));
        let g = spinning
            .larger(T::splat(LEAST_SPINNING))
            .smaller(T::splat(MOST_SPINNING));
        let w = slipping
            .larger(T::splat(LEAST_SLIPPING))
            .smaller(T::splat(MOST_SLIPPING));
        let [constant, linear] = BETWEEN.map(T::splat);
        let (h1, h2) = (half - half * g, constant + linear * w);
        Self {
            h1,
            h2,
            h4: w.sqrt() - one - h1 - h2,
        }
    }
}

impl<T: Lanes> IsotropicLimitCurve<T> {
    /// A pressed area of compact outline: disk, square, hexagon.
    ///
    /// *Accuracy*: radius of the limit curve −0.3…0.7 % of the exact one; triangle −1.7…1.3 %, rectangle 2 : 1 ±5 %.
    #[inline]
    pub fn area() -> Self {
        let [spinning, slipping] = AREA.map(T::splat);
        Self(Curve::new(spinning, slipping))
    }

    /// A ring, or feet at the corners of a square.
    #[inline]
    pub fn points() -> Self {
        let [h1, h2, h4] = RING.map(T::splat);
        Self(Curve { h1, h2, h4 })
    }

    /// x² + y² = 1, the ellipsoid of Howe and Cutkosky (1996). *Accuracy*: the radius is 7 % too large for areas.
    #[inline]
    pub fn ellipsoid() -> Self {
        let [h1, h2, h4] = [T::splat(0.0); 3];
        Self(Curve { h1, h2, h4 })
    }
}

impl<T: Lanes> LimitCurve<T> for IsotropicLimitCurve<T> {
    const TURNS: bool = false;
    const STEPS: usize = 2;

    #[inline(always)]
    fn curve(&self, _: [T; 2]) -> Curve<T> {
        self.0
    }

    #[inline(always)]
    fn turned(&self, direction: [T; 2], _: T, _: T) -> [T; 2] {
        direction
    }
}

impl<T: Lanes> LimitCurve<T> for DirectionalLimitCurve<T> {
    const TURNS: bool = true;
    const STEPS: usize = 3;

    #[inline(always)]
    fn curve(&self, direction: [T; 2]) -> Curve<T> {
        Curve::new(
            form(&self.spinning, direction),
            form(&self.slipping, direction),
        )
    }

    #[inline(always)]
    fn turned(&self, [x, y]: [T; 2], isotropic: T, coupled: T) -> [T; 2] {
        let [xx, xy, yy] = self.spinning;
        let (xx, xy, yy) = (
            isotropic + coupled * xx,
            coupled * xy,
            isotropic + coupled * yy,
        );
        let (x, y) = (yy * x - xy * y, xx * y - xy * x);
        let norm = (x * x + y * y).sqrt();
        let scale = T::splat(1.0) / (norm + T::splat(super::TINY));
        [x * scale, y * scale]
    }
}

/// The quadratic form of a symmetric matrix.
#[inline(always)]
fn form<T: Lanes>(&[xx, xy, yy]: &[T; 3], [x, y]: [T; 2]) -> T {
    xx * x * x + (xy + xy) * x * y + yy * y * y
}
