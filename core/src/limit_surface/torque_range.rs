//! The torques that a patch of known pressure carries together with a force.
//!
//! Along a line of wrenches with this force the gauge is convex, and at most 1 without torque about the centre
//! of pressure: every pressure carries that. From the torque of the ellipsoid one Newton step of the
//! gauge leads outside of the set, and the next ones come back to its surface without ever passing it.

use super::{FrictionSet, ShapeLimitSurface};
use crate::coupling::flat::PatchShape;
use crate::real::Real;
use crate::twist::Wrench;

/// Most Newton steps; 8 were seen, save for forces next to the limit.
const MOST_STEPS: usize = 60;
/// A gauge this near to 1 is on the surface.
const DONE_ULPS: f64 = 4.0;

impl<R: Real, P: PatchShape<R>> ShapeLimitSurface<R, P> {
    /// The lowest and the highest torque about the origin that friction carries together with `force`;
    /// none if it does not carry the force alone.
    ///
    /// *Accuracy* (f64): the gauge there is 1 within 1e-14; next to the largest force, where the torques vanish
    /// like the root of what the force leaves, the square of the torque has that accuracy. *Cost*:
    /// about 8 gauges with derivatives. *Special values*: NaN for NaN.
    ///
    /// ```
    /// use tribos_core::limit_surface::{FrictionSet, ShapeLimitSurface};
    /// use tribos_core::patch::outline::Polygon;
    /// use tribos_core::twist::Wrench;
    /// let sole = [[-0.06_f64, -0.04], [0.18, -0.05], [0.18, 0.05], [-0.06, 0.04]]; // m
    /// let floor = ShapeLimitSurface::new(Polygon::new(sole)?, 420.0)?; // μN in N
    /// let [lowest, highest] = floor.torque_limits([0.0, 200.0]).ok_or("the foot slips")?; // N; N m
    /// assert!((floor.gauge(&Wrench::new(0.0, 200.0, highest)) - 1.0).abs() < 1e-13);
    /// assert!(highest > -lowest); // the centre of pressure lies ahead of the ankle
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn torque_limits(&self, force: [R; 2]) -> Option<[R; 2]> {
        let [x, y] = force;
        let size = x.hypot(y);
        let limit = self.force_limit();
        if size > limit {
            return None;
        }
        let centre = self.patch().centre();
        let offset = centre.x * y - centre.y * x;
        if (size + offset).is_nan() {
            return Some([R::NAN; 2]);
        }
        if size >= limit {
            return Some([offset; 2]);
        }
        let highest = self.highest([x, y], offset);
        // −x is carried with x.
        let lowest = -self.highest([-x, -y], -offset);
        Some([lowest, highest])
    }

    /// The highest torque with a force that leaves room for some; NaN where the gauge is.
    fn highest(&self, [x, y]: [R; 2], offset: R) -> R {
        // About the centre: carried for certain, with what its gauge leaves of 1, and not.
        let reach = self.patch().radius() * self.force_limit();
        let share = x.hypot(y) / self.force_limit();
        let (mut inside, mut room) = (R::ZERO, R::ONE - share);
        let (mut outside, mut beyond) = (reach, R::INFINITY);
        let mut torque = R::HALF * reach * ((R::ONE - share) * (R::ONE + share)).sqrt();
        for _ in 0..MOST_STEPS {
            let wrench = Wrench::new(x, y, offset + torque);
            let (normal, _) = self.gauge_derivatives(&wrench);
            let excess = wrench.power(&normal) - R::ONE;
            if excess.abs() <= R::from_f64(DONE_ULPS) * R::EPSILON || excess.is_nan() {
                return offset + torque + excess * R::ZERO;
            }
            if excess > R::ZERO {
                (outside, beyond) = (torque, excess);
            } else {
                (inside, room) = (torque, -excess);
            }
            let next = torque - excess / normal.spin;
            // Not true for NaN either.
            let is_between = next > inside && next < outside;
            let next = if is_between {
                next
            } else {
                R::HALF * (inside + outside)
            };
            let is_settled = !(next > inside && next < outside);
            if is_settled {
                break;
            }
            torque = next;
        }
        // The gauge is convex: on the chord between both ends what is within 1 there is carried.
        offset + inside + (outside - inside) * (room / (room + beyond))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::patch::outline::Polygon;

    #[test]
    fn a_few_steps_find_the_torque_beside_any_force() {
        let sole = [
            [-0.06_f64, -0.04],
            [0.18, -0.05],
            [0.18, 0.05],
            [-0.06, 0.04],
        ];
        let even = Polygon::new(sole).unwrap();
        let leaning = even.with_centre_of_pressure([0.08, 0.01]).unwrap();
        let floor = ShapeLimitSurface::new(leaning, 420.0).unwrap();
        for i in 0..5000 {
            let share = 1.0 - libm::exp(-f64::from(i % 500) / 20.0);
            let angle = f64::from(i) * 0.7;
            let force = [share * libm::cos(angle), share * libm::sin(angle)].map(|x| 420.0 * x);
            let offset = 0.08 * force[1] - 0.01 * force[0];
            let limits = floor.torque_limits(force).unwrap();
            assert!(
                limits[0] <= offset && offset <= limits[1],
                "{share} {limits:?}"
            );
            for torque in limits {
                let gauge = floor.gauge(&Wrench::new(force[0], force[1], torque));
                assert!((gauge - 1.0).abs() < 1e-14, "{share} {angle} {gauge}");
            }
        }
    }

    #[test]
    fn torques_next_to_the_largest_force_are_carried_and_nan_stays() {
        let sole = [[-0.1_f64, -0.05], [0.1, -0.05], [0.1, 0.05], [-0.1, 0.05]];
        let floor = ShapeLimitSurface::new(Polygon::new(sole).unwrap(), 300.0).unwrap();
        for octave in 0..53 {
            for angle in [0.0, 0.4, 1.1, 2.0, 4.0] {
                let size = 300.0 * (1.0 - libm::exp2(-f64::from(octave)));
                let force = [size * libm::cos(angle), size * libm::sin(angle)];
                for torque in floor.torque_limits(force).unwrap() {
                    let gauge = floor.gauge(&Wrench::new(force[0], force[1], torque));
                    assert!((gauge - 1.0).abs() < 2e-14, "{octave} {angle} {gauge}");
                }
            }
        }
        for force in [[f64::NAN, 0.0], [0.0, f64::NAN]] {
            let limits = floor.torque_limits(force).unwrap();
            assert!(limits.iter().all(|torque| torque.is_nan()));
        }
    }
}
