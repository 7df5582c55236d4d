//! A straight line that carries load: a blade, a skate, the edge of a box.

use super::affine_image::AffineMap;
use super::edge::Edge;
use super::flat_pressure::{LinearPressure, PressureField, UniformPressure};
use super::outline_error::OutlineError;
use super::piece::{HalfPlane, PatchPiece};
use crate::real::Real;
use nalgebra::Vector2;

/// A straight bar under uniform or linear pressure: the limit of a rectangle that becomes ever thinner.
///
/// *Units*: length.
///
/// ```
/// use tribos_core::coupling::flat::ShapeFriction;
/// use tribos_core::patch::bar::Bar;
/// use tribos_core::twist::Twist;
/// let blade = ShapeFriction::new(Bar::new([-0.1_f64, 0.0], [0.1, 0.0])?, 0.05)?; // m, mu
/// let pivoting = blade.wrench(700.0, &Twist::new(0.0, 0.0, 1.0)); // N; rad/s
/// assert!((pivoting.torque + 0.05 * 700.0 * 0.05).abs() < 1e-14); // mean distance: 5 cm
/// # Ok::<(), tribos_core::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bar<R: Real, K = UniformPressure> {
    /// In units of the radius, about the centre of pressure.
    edge: Edge<R>,
    pressure: K,
    centre: Vector2<R>,
    radius: R,
}

/// Parts of the smallest rounding by which the pressure at an end may be negative.
const LIFT_ULPS: f64 = 8.0;

impl<R: Real> Bar<R> {
    /// The bar between two points.
    ///
    /// *Domain*: finite points a finite, positive distance apart.
    pub fn new(from: [R; 2], to: [R; 2]) -> Result<Self, OutlineError> {
        let ends = [from, to];
        for (corner, end) in ends.iter().enumerate() {
            if !end.iter().all(|part| part.is_finite()) {
                let in_loop = 0;
                return Err(OutlineError::Position { in_loop, corner });
            }
        }
        let [half_x, half_y] = [
            R::HALF * to[0] - R::HALF * from[0],
            R::HALF * to[1] - R::HALF * from[1],
        ];
        let radius = half_x.hypot(half_y);
        if radius == R::ZERO {
            let (in_loop, corner) = (0, 0);
            return Err(OutlineError::Repeated { in_loop, corner });
        }
        if !radius.is_finite() {
            return Err(OutlineError::Extent);
        }
        let end = Vector2::new(half_x / radius, half_y / radius);
        Ok(Self {
            edge: Edge::new(-end, end),
            pressure: UniformPressure,
            centre: Vector2::new(from[0] + half_x, from[1] + half_y),
            radius,
        })
    }

    /// The bar under the pressure p₀ (1 + `slope` s), s the distance from its middle towards the second point.
    /// *Units*: 1/length.
    ///
    /// *Domain*: the pressure is nowhere negative, |slope| ≤ 2/length. *Accuracy* of its friction: 3e-14 (f32: 4e-6).
    /// *Cost*: 1.25 uniform bars.
    ///
    /// ```
    /// use tribos_core::patch::bar::Bar;
    /// let blade = Bar::new([0.0_f64, 0.0], [0.3, 0.0])?; // m
    /// let blade = blade.with_slope(2.0 / 0.3)?; // no pressure at its start, twice the mean at its end
    /// assert!((blade.centre().x - 0.2).abs() < 1e-16);
    /// # Ok::<(), tribos_core::patch::outline::OutlineError>(())
    /// ```
    pub fn with_slope(self, slope: R) -> Result<Bar<R, LinearPressure<R>>, OutlineError> {
        let steep = slope * self.radius;
        self.tilted(steep, steep / (R::TWO + R::ONE))
    }

    /// The bar under linear pressure with its centre at a distance from the middle, towards the second point.
    ///
    /// *Domain*: the pressure is nowhere negative: the centre lies in the middle third, |distance| ≤ length/6.
    ///
    /// ```
    /// use tribos_core::patch::bar::Bar;
    /// use tribos_core::patch::outline::OutlineError;
    /// let skate = Bar::new([-0.15_f64, 0.0], [0.15, 0.0])?; // m
    /// assert!(skate.with_centre_of_pressure(0.03).is_ok());
    /// let lifts = skate.with_centre_of_pressure(0.06);
    /// assert!(matches!(lifts, Err(OutlineError::LiftOff { .. })));
    /// # Ok::<(), OutlineError>(())
    /// ```
    pub fn with_centre_of_pressure(
        self,
        distance: R,
    ) -> Result<Bar<R, LinearPressure<R>>, OutlineError> {
        let shift = distance / self.radius;
        self.tilted((R::TWO + R::ONE) * shift, shift)
    }

    /// The bar whose pressure changes by `steep` of the mean over half the length, with its centre at `shift` half lengths.
    fn tilted(self, steep: R, shift: R) -> Result<Bar<R, LinearPressure<R>>, OutlineError> {
        let centre = self.centre + self.edge.end() * (shift * self.radius);
        if !(steep.is_finite() && centre.x.is_finite() && centre.y.is_finite()) {
            return Err(OutlineError::Slope);
        }
        // In half lengths, then in units of the longer part.
        let reach = R::ONE + shift.abs();
        let radius = self.radius * reach;
        if !radius.is_finite() {
            return Err(OutlineError::Extent);
        }
        let lowest = R::ONE - steep.abs();
        if lowest < -(R::from_f64(LIFT_ULPS) * R::EPSILON) {
            return Err(OutlineError::LiftOff {
                lowest: lowest.to_f64(),
            });
        }
        let tangent = self.edge.tangent();
        let pressure = LinearPressure::new(
            R::ONE + steep * shift,
            [tangent.x, tangent.y].map(|part| part * steep * reach),
        );
        Ok(Bar {
            edge: self.edge.about(&(self.edge.end() * shift), reach),
            pressure,
            centre,
            radius,
        })
    }
}

impl<R: Real, K: PressureField<R>> Bar<R, K> {
    /// Both ends.
    pub fn ends(&self) -> [[R; 2]; 2] {
        [self.edge.start(), self.edge.end()].map(|end| {
            let at = self.centre + end * self.radius;
            [at.x, at.y]
        })
    }

    /// Its centre of pressure: the middle under uniform pressure.
    pub fn centre(&self) -> Vector2<R> {
        self.centre
    }

    /// Distance of the farther end from the centre of pressure: half of the length under uniform pressure.
    pub fn radius(&self) -> R {
        self.radius
    }

    /// Its image under an affine map: pressure changes along it as before.
    pub(super) fn moved(&self, map: &AffineMap<R>) -> Self {
        let tangent = map.of_vector(&self.edge.tangent());
        let scale = tangent.x.hypot(tangent.y);
        let tangent = Vector2::new(tangent.x / scale, tangent.y / scale);
        let [from, to] = self.span();
        Self {
            edge: Edge::between([tangent * from, tangent * to], tangent, self.edge.length()),
            pressure: Self::pressure_along(&tangent, self.slope_along(), self.pressure.at_centre()),
            centre: map.of(&self.centre),
            radius: self.radius * scale,
        }
    }

    /// Where it begins and ends along itself, from the centre of pressure on.
    fn span(&self) -> [R; 2] {
        let tangent = self.edge.tangent();
        [self.edge.start(), self.edge.end()].map(|end| end.x * tangent.x + end.y * tangent.y)
    }

    /// Slope of the pressure along itself, of the mean pressure over the radius.
    fn slope_along(&self) -> R {
        let ([x, y], tangent) = (self.pressure.slope(), self.edge.tangent());
        x * tangent.x + y * tangent.y
    }

    fn pressure_along(tangent: &Vector2<R>, slope: R, at_centre: R) -> K {
        K::of_piece(at_centre, [slope * tangent.x, slope * tangent.y])
    }

    /// What of the bar lies within a half-plane, under the same pressure; `None` if nothing does.
    ///
    /// ```
    /// use tribos_core::patch::bar::Bar;
    /// use tribos_core::patch::piece::HalfPlane;
    /// let blade = Bar::new([0.0_f64, 0.0], [0.3, 0.0])?; // m
    /// let ice = HalfPlane::new([0.1, 0.0], [0.0, 1.0])?; // left of the line upwards
    /// let piece = blade.within(&ice).ok_or("nothing there")?;
    /// assert!((piece.share - 1.0 / 3.0).abs() < 1e-15 && (piece.patch.radius() - 0.05).abs() < 1e-16);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn within(&self, side: &HalfPlane<R>) -> Option<PatchPiece<R, Self>> {
        let ends = self.ends();
        let [from, to] = self.span();
        let (from, to) = match side.crossing(ends) {
            None if side.contains(ends[0]) => (from, to),
            None => return None,
            Some(part) => {
                let met = from + (to - from) * part;
                if side.contains(ends[0]) {
                    (from, met)
                } else {
                    (met, to)
                }
            }
        };
        // Load and its moment, of the mean pressure and the radius.
        let (slope, at_centre) = (self.slope_along(), self.pressure.at_centre());
        let (length, sum) = (to - from, to + from);
        let load = length * (at_centre + R::HALF * slope * sum);
        let third = R::from_f64(1.0 / 3.0);
        let bent = third * slope * (to * to + to * from + from * from);
        let centre = length * (R::HALF * at_centre * sum + bent) / load;
        let farther = if to - centre > centre - from {
            to - centre
        } else {
            centre - from
        };
        let inv_mean = length / load;
        if !(load > R::ZERO && farther > R::ZERO && inv_mean.is_finite()) {
            return None;
        }
        let tangent = self.edge.tangent();
        let places = [from, to].map(|end| tangent * ((end - centre) / farther));
        let at_centre = (at_centre + slope * centre) * inv_mean;
        let patch = Self {
            edge: Edge::between(places, tangent, length / farther),
            pressure: Self::pressure_along(&tangent, slope * farther * inv_mean, at_centre),
            centre: self.centre + tangent * (centre * self.radius),
            radius: self.radius * farther,
        };
        let share = load / self.edge.length();
        Some(PatchPiece { patch, share })
    }

    #[inline(always)]
    pub(crate) fn edge(&self) -> &Edge<R> {
        &self.edge
    }

    #[inline(always)]
    pub(crate) fn pressure(&self) -> &K {
        &self.pressure
    }
}
