//! A straight line that carries load: a blade, a skate, the edge of a box.

use super::edge::Edge;
use super::flat_pressure::{LinearPressure, PressureField, UniformPressure};
use super::outline_error::OutlineError;
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
    /// Its centre of pressure: the middle under uniform pressure.
    pub fn centre(&self) -> Vector2<R> {
        self.centre
    }

    /// Distance of the farther end from the centre of pressure: half of the length under uniform pressure.
    pub fn radius(&self) -> R {
        self.radius
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
