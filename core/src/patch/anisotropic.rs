//! Friction that differs along two axes: tread, skates, grooved, brushed or woven surfaces.
//!
//! With the coefficients μ₁ along an axis and μ₂ across it the rule of largest dissipation makes the
//! dissipated power that of a velocity stretched by both,
//!
//! ```text
//! D = N ∫ p √((μ₁ u₁)² + (μ₂ u₂)²) dA,     u = v + ω × r
//! ```
//!
//! Since μ₁ u₁ = μ₁ v₁ − ω (μ₁ x₂) and μ₂ u₂ = μ₂ v₂ + ω (μ₂ x₁), this is the power of *isotropic* friction
//! on the patch that is stretched by μ₂ along the axis and by μ₁ across it, and that moves with
//! (μ₁ v₁, μ₂ v₂, ω). The force follows as (μ₁ F₁, μ₂ F₂), the torque as it is: exact for every patch.

use super::PatchError;
use super::affine_image::{AffineImage, AffineMap};
use super::piece::HalfPlane;
use crate::coupling::flat::PatchShape;
use crate::law::{LawError, validated_positive};
use crate::real::Real;
use nalgebra::Vector2;

/// Coefficients of friction along an axis of the patch and across it.
///
/// *Source*: the ellipse of Zmitrowicz, Int. J. Solids Structures 25 (1989) 837, with slip normal to it.
///
/// ```
/// use tribos_core::coupling::flat::ShapeFriction;
/// use tribos_core::patch::anisotropic::{AnisotropicPatch, AxisCoefficients};
/// use tribos_core::patch::outline::Polygon;
/// use tribos_core::twist::Twist;
/// let sole = Polygon::new([[-0.1_f64, -0.04], [0.1, -0.04], [0.1, 0.04], [-0.1, 0.04]])?; // m
/// let tread = AxisCoefficients::new([0.5, 0.9], [1.0, 0.0])?; // along x and across it
/// let friction = ShapeFriction::new(AnisotropicPatch::new(sole, tread)?, tread.largest())?;
/// let along = friction.wrench(100.0, &Twist::new(0.2, 0.0, 0.0)); // N; m/s, m/s, rad/s
/// let across = friction.wrench(100.0, &Twist::new(0.0, 0.2, 0.0));
/// assert!((along.force.x + 50.0).abs() < 1e-12 && (across.force.y + 90.0).abs() < 1e-12);
/// # Ok::<(), tribos_core::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AxisCoefficients<R: Real> {
    /// The axis, of length 1.
    axis: Vector2<R>,
    /// Coefficients along the axis and across it.
    mu: [R; 2],
}

impl<R: Real> AxisCoefficients<R> {
    /// *Domain*: coefficients > 0, those of a wheel or a skate being small along it; an `axis` of any finite length but
    /// zero.
    pub fn new(mu: [R; 2], axis: [R; 2]) -> Result<Self, LawError> {
        let [along, across] = mu;
        validated_positive("coefficient along the axis", along)?;
        validated_positive("coefficient across the axis", across)?;
        let [x, y] = axis;
        let length = validated_positive("length of the axis", x.hypot(y))?;
        Ok(Self {
            axis: Vector2::new(x / length, y / length),
            mu,
        })
    }

    /// The larger coefficient: the one that multiplies the friction of an [`AnisotropicPatch`].
    pub fn largest(&self) -> R {
        let [along, across] = self.mu;
        if along > across { along } else { across }
    }

    /// Coefficients along the axis and across it.
    pub fn mu(&self) -> [R; 2] {
        self.mu
    }

    /// Both over the larger one.
    pub(crate) fn shares(&self) -> [R; 2] {
        let largest = self.largest();
        self.mu.map(|mu| mu / largest)
    }
}

/// Rounding errors by which the length of a turned axis may differ from 1.
const TURN_ULPS: f64 = 16.0;

/// A patch under friction that differs along two axes, which are fixed to the patch.
///
/// It is a [`crate::coupling::flat::PatchShape`] under the larger coefficient: friction, limit surface, time steps and
/// pushes take it as any other patch.
///
/// *Accuracy*: that of the stretched patch, which is longer than the given one by up to the ratio of the coefficients.
/// *Cost*: that of the patch, and 20 products.
///
/// ```
/// use tribos_core::limit_surface::{FrictionSet, ShapeLimitSurface};
/// use tribos_core::patch::anisotropic::{AnisotropicPatch, AxisCoefficients};
/// use tribos_core::patch::bar::Bar;
/// use tribos_core::twist::Wrench;
/// let blade = Bar::new([-0.15_f64, 0.0], [0.15, 0.0])?; // m
/// let ice = AxisCoefficients::new([0.005, 0.3], [1.0, 0.0])?; // it glides along itself
/// let skate = ShapeLimitSurface::new(AnisotropicPatch::new(blade, ice)?, 0.3 * 700.0)?; // N
/// assert!((skate.gauge(&Wrench::new(7.0, 0.0, 0.0)) - 2.0).abs() < 1e-12);
/// # Ok::<(), tribos_core::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AnisotropicPatch<R: Real, P> {
    /// The patch in coordinates along the axis and across it, stretched.
    pub(crate) stretched: P,
    pub(crate) axis: Vector2<R>,
    /// Coefficients over the larger one.
    pub(crate) shares: [R; 2],
    pub(crate) centre: Vector2<R>,
    pub(crate) radius: R,
    /// Radius of the stretched patch over that of the given one.
    pub(crate) inner: R,
}

impl<R: Real, P: AffineImage<R>> AnisotropicPatch<R, P> {
    /// `patch` under friction of these coefficients.
    ///
    /// *Domain*: stretched by the coefficients over the larger one the patch has an extent that is a normal number.
    pub fn new(patch: P, friction: AxisCoefficients<R>) -> Result<Self, PatchError> {
        let (axis, shares) = (friction.axis, friction.shares());
        let [along, across] = shares;
        let map = AffineMap {
            rows: [
                Vector2::new(axis.x, axis.y) * across,
                Vector2::new(-axis.y, axis.x) * along,
            ],
            shift: Vector2::new(R::ZERO, R::ZERO),
        };
        let (centre, radius) = (patch.centre(), patch.radius());
        let stretched = patch.image(&map).ok_or(PatchError::NoImage)?;
        let inner = stretched.radius() / radius;
        if !(stretched.radius() >= R::MIN_POSITIVE / R::EPSILON && inner.is_finite()) {
            let given = stretched.radius().to_f64();
            return Err(PatchError::Radius { given });
        }
        Ok(Self {
            stretched,
            axis,
            shares,
            centre,
            radius,
            inner,
        })
    }
}

impl<R: Real, P: AffineImage<R>> AnisotropicPatch<R, P> {
    /// The patch and its axes, turned and moved; `None` for a map that stretches.
    #[doc(hidden)]
    pub fn placed(self, map: &AffineMap<R>) -> Option<Self> {
        let [first, second] = map.rows;
        let is_turn = first.x == second.y && first.y == -second.x;
        let length = first.x.hypot(first.y);
        if !(is_turn && (length - R::ONE).abs() <= R::from_f64(TURN_ULPS) * R::EPSILON) {
            return None;
        }
        let axis = map.of_vector(&self.axis);
        let ([along, across], shift) = (self.shares, map.shift);
        let moved = AffineMap {
            rows: [Vector2::new(R::ONE, R::ZERO), Vector2::new(R::ZERO, R::ONE)],
            shift: Vector2::new(
                across * (axis.x * shift.x + axis.y * shift.y),
                along * (axis.x * shift.y - axis.y * shift.x),
            ),
        };
        Some(Self {
            stretched: self.stretched.image(&moved)?,
            axis,
            centre: map.of(&self.centre),
            ..self
        })
    }
}

impl<R: Real, P: PatchShape<R>> AnisotropicPatch<R, P> {
    /// The patch in coordinates along the axis and across it, stretched.
    #[doc(hidden)]
    pub fn stretched(&self) -> &P {
        &self.stretched
    }

    /// The image of a half-plane in these coordinates.
    #[doc(hidden)]
    pub fn stretched_side(&self, side: &HalfPlane<R>) -> HalfPlane<R> {
        let ([along, across], axis) = (self.shares, self.axis);
        side.mapped(|at| {
            Vector2::new(
                across * (axis.x * at.x + axis.y * at.y),
                along * (axis.x * at.y - axis.y * at.x),
            )
        })
    }

    /// The same friction on the patch whose image this is.
    #[doc(hidden)]
    pub fn with_stretched(&self, stretched: P) -> Self {
        let ([along, across], axis) = (self.shares, self.axis);
        let there = stretched.centre();
        let (x, y) = (there.x / across, there.y / along);
        Self {
            centre: Vector2::new(x * axis.x - y * axis.y, x * axis.y + y * axis.x),
            // Any length will do as the unit of torques.
            radius: self.radius,
            inner: stretched.radius() / self.radius,
            stretched,
            ..*self
        }
    }
}
