//! The limit surface of a support whose pressure is unknown but for its centre.
//!
//! All pressures p ≥ 0 of one load N and centre c, with friction |f| ≤ μp, are a convex set, hence so are their
//! wrenches. Their support function at a motion is μN times the greatest mean of the speed φ over these
//! pressures. φ is convex in the place: the mean is greatest with all load on corners of the hull, and its
//! greatest value is the upper concave envelope of φ at c. By Jensen's inequality it is least, |v(c)|,
//! with all load at c, so that *every* pressure with this centre carries any |F| ≤ μN without torque about c,
//! and nothing else is carried by all of them.

use super::central_path::{WrenchRay, reach, speed};
use super::load_sharing::{Greatest, LoadSharing, cross};
use super::quadratic::{norm, over};
use crate::error::Error;
use crate::law::validated_not_negative;
use crate::real::Real;
use crate::twist::{Twist, Wrench};
use nalgebra::{Vector2, Vector3};

/// Rounding errors of a force over the force limit: two quotients, a root and their sum.
const FORCE_ULPS: f64 = 2.0;

/// All wrenches that dry friction can carry on a support of which only the corners, the load and the
/// centre of pressure are known: about the origin of the corners' coordinates.
///
/// A foot on the floor is one: its sensors give load and centre of pressure, not the pressure. What this set
/// does not contain, no pressure carries. The storage `S` holds the corners, in any order: an
/// array, or a slice. Corners inside of the convex hull of the others change nothing.
///
/// *Units*: length, force. *Accuracy* (f64): support 1e-14 of the force limit times the fastest corner's
/// speed. *Cost*: `support` and `wrench` look at every corner once per pivot of the simplex method, of which
/// there are about two.
///
/// ```
/// use tribos_core::limit_surface::UnknownPressureSet;
/// let sole = [[-0.06_f64, -0.04], [0.18, -0.05], [0.18, 0.05], [-0.06, 0.04]]; // m
/// let foot = UnknownPressureSet::new(sole, [0.05, 0.01], 0.6 * 700.0)?; // m; μN in N
/// // The yaw torque that the foot may be asked for while it pushes forwards with 200 N.
/// let yaw = foot.torque_limits([200.0, 0.0]).ok_or("the foot slips")?;
/// let [lowest, highest] = yaw.certain; // N m
/// assert!(highest > 30.0 && lowest < -30.0 && yaw.possible[1] - highest < 1e-9);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct UnknownPressureSet<R: Real, S> {
    sharing: LoadSharing<R, S>,
    /// μN
    limit: R,
    /// A torque about the centre that is carried without force, over force limit and radius.
    torque: R,
}

/// Torques about the origin that friction can carry together with a force, from both sides.
///
/// ```
/// use tribos_core::limit_surface::UnknownPressureSet;
/// let feet = UnknownPressureSet::new([[-0.1_f64, 0.0], [0.1, 0.0]], [0.0, 0.0], 300.0)?; // m; N
/// let yaw = feet.torque_limits([0.0, 0.0]).ok_or("slips")?;
/// // Both feet push across the line between them: 300 N on an arm of 0.1 m.
/// assert!((yaw.certain[1] - 30.0).abs() < 1e-9 && (yaw.possible[0] + 30.0).abs() < 1e-9);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct TorqueLimits<R> {
    /// Lowest and highest torque that a pressure was found for.
    pub certain: [R; 2],
    /// Torques below the first and above the second are carried by no pressure.
    pub possible: [R; 2],
}

impl<R: Real, S: AsRef<[[R; 2]]>> UnknownPressureSet<R, S> {
    /// *Domain*: finite `corners`, at least one; `centre` (of pressure) in their convex hull, which may
    /// be a line or a point; 0 ≤ `force_limit` < ∞ (μN). *Cost*: corners times those of the hull.
    pub fn new(corners: S, centre: [R; 2], force_limit: R) -> Result<Self, Error> {
        let limit = validated_not_negative("force limit", force_limit)?.abs();
        let sharing = LoadSharing::new(corners, centre)?;
        // Forces λd across d add up to none, and none exceeds its share: the torque is Σλ|d|².
        let square = |d: &Vector2<R>| d.x * d.x + d.y * d.y;
        let mut torque = R::ZERO;
        for share in sharing.greatest(square).shares {
            torque += share.part * square(&share.at);
        }
        Ok(Self {
            sharing,
            limit,
            torque,
        })
    }

    /// The largest force, μN.
    pub fn force_limit(&self) -> R {
        self.limit
    }

    /// The centre of pressure.
    pub fn centre(&self) -> Vector2<R> {
        self.sharing.centre
    }

    /// Distance of the farthest corner from the centre of pressure.
    pub fn radius(&self) -> R {
        self.sharing.radius
    }

    /// Support function: the largest wrench·twist that any pressure gives.
    ///
    /// Should the simplex method end before it has found that pressure, a bound from above; then the power of
    /// [`UnknownPressureSet::wrench`] is one from below. *Units*: power. *Special values*: 0 at rest, NaN for NaN.
    pub fn support(&self, twist: &Twist<R>) -> R {
        let motion = self.at_centre(twist);
        let worst = self.worst_pressure(&motion);
        let mut mean = worst.excess;
        for share in &worst.shares {
            mean += share.part * speed(&velocity(&motion, &share.at));
        }
        // An empty sum would hide NaN.
        self.limit * mean + (motion.x + motion.y + motion.z) * R::ZERO
    }

    /// Friction on the support that moves with `twist` under a pressure that dissipates most: of the
    /// set, one of the points whose outward normal is −`twist`; a point of the set in any case.
    ///
    /// *Special values*: zero at rest; NaN for an infinite twist.
    pub fn wrench(&self, twist: &Twist<R>) -> Wrench<R> {
        let motion = self.at_centre(twist);
        let mut sum = Vector3::new(R::ZERO, R::ZERO, R::ZERO);
        for share in self.worst_pressure(&motion).shares {
            let u = velocity(&motion, &share.at);
            let size = speed(&u);
            // A corner at rest may rub in any direction; it rubs in none.
            let force = if size == R::ZERO {
                u
            } else {
                Vector2::new(-(u.x / size), -(u.y / size)) * share.part
            };
            sum += Vector3::new(force.x, force.y, cross(&share.at, &force));
        }
        let force = Vector2::new(sum.x, sum.y) * self.limit;
        let torque = sum.z * self.limit * self.radius();
        self.about_origin(force, torque)
    }

    /// The yaw torques about the origin that can be carried together with `force`; none if the force alone
    /// cannot.
    ///
    /// *Accuracy* (f64): `carried` and `outer` differ by less than 1e-9 of force limit times radius (f32: 2e-3)
    /// for forces up to 1 − 1e-11 of the limit; the last rounding errors of a force are worth up to 1e-7.
    /// Both are sound to rounding, whatever their distance, which says how near the search came.
    /// *Cost*: about 100 Newton steps of five unknowns, each a sum over the corners. *Special values*: NaN
    /// for NaN.
    ///
    /// ```
    /// use tribos_core::limit_surface::UnknownPressureSet;
    /// let sole = [[-0.1_f64, -0.05], [0.1, -0.05], [0.1, 0.05], [-0.1, 0.05]]; // m
    /// let foot = UnknownPressureSet::new(sole, [0.0, 0.0], 100.0)?; // N
    /// // All load on the corners, all of them as far away from the centre as they can be.
    /// let still = foot.torque_limits([0.0, 0.0]).ok_or("slips")?;
    /// assert!((still.certain[1] - 100.0 * 0.1_f64.hypot(0.05)).abs() < 1e-9);
    /// assert!(foot.torque_limits([101.0, 0.0]).is_none());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn torque_limits(&self, force: [R; 2]) -> Option<TorqueLimits<R>> {
        let [x, y] = force;
        let force = Vector2::new(x, y);
        let offset = cross(&self.centre(), &force);
        let unit = self.limit * self.radius();
        let reduced = Vector2::new(x / self.limit, y / self.limit);
        let size = if x == R::ZERO && y == R::ZERO {
            R::ZERO
        } else if self.limit > R::ZERO {
            speed(&reduced)
        } else {
            // Without limit no force is carried; NaN stays.
            speed(&force) * R::INFINITY
        };
        if size > R::ONE {
            return None;
        }
        if size.is_nan() || (offset + unit).is_nan() {
            let nan = [R::NAN; 2];
            let (carried, outer) = (nan, nan);
            return Some(TorqueLimits {
                certain: carried,
                possible: outer,
            });
        }
        let zero = R::ZERO;
        let [low, high] = if self.torque > zero && unit > zero {
            // −x is carried with x.
            let signs = [-R::ONE, R::ONE];
            signs.map(|sign| self.beside(&(reduced * sign), size).map(|s| unit * s))
        } else {
            [[zero; 2]; 2]
        };
        let ([low, lower], [high, higher]) = (low, high);
        Some(TorqueLimits {
            certain: [offset - low, offset + high],
            possible: [offset - lower, offset + higher],
        })
    }

    /// A lower and an upper bound of the gauge, the smallest λ ≥ 0 with `wrench`/λ in the set.
    ///
    /// A lower bound above 1 proves that no pressure carries the wrench, an upper one of at most 1 that some
    /// pressure does. *Accuracy* (f64): they differ by less than 1e-9 of the gauge. *Cost*: as
    /// [`UnknownPressureSet::torque_limits`], half as much. *Special values*: 0 for no wrench, infinite for one
    /// that no load carries, NaN for NaN and where the torque about the centre of pressure is out of range.
    ///
    /// ```
    /// use tribos_core::limit_surface::UnknownPressureSet;
    /// use tribos_core::twist::Wrench;
    /// let sole = [[-0.1_f64, -0.05], [0.1, -0.05], [0.1, 0.05], [-0.1, 0.05]]; // m
    /// let foot = UnknownPressureSet::new(sole, [0.04, 0.0], 400.0)?; // N
    /// let [_, at_most] = foot.gauge_bounds(&Wrench::new(100.0, 50.0, 20.0)); // N, N, N m
    /// let [at_least, _] = foot.gauge_bounds(&Wrench::new(300.0, 50.0, 60.0));
    /// assert!(at_most < 1.0 && at_least > 1.0); // may hold; slips for certain
    /// # Ok::<(), tribos_core::Error>(())
    /// ```
    pub fn gauge_bounds(&self, wrench: &Wrench<R>) -> [R; 2] {
        let torque = wrench.torque - cross(&self.centre(), &wrench.force);
        let reduced = Vector3::new(
            wrench.force.x / self.limit,
            wrench.force.y / self.limit,
            torque / self.limit / self.radius(),
        );
        let given = wrench.force.x.abs() + wrench.force.y.abs() + torque.abs();
        let force = speed(&Vector2::new(reduced.x, reduced.y));
        let size = norm(&reduced);
        if given == R::ZERO || given.is_nan() {
            return [given; 2];
        }
        // Without an arm no torque is carried.
        if self.torque <= R::ZERO && torque == R::ZERO && force.is_finite() {
            return [force; 2];
        }
        let is_ordinary = size > R::ZERO && size.is_finite() && self.torque > R::ZERO;
        if !is_ordinary {
            return [R::INFINITY; 2];
        }
        let ray = WrenchRay {
            direction: Vector2::new(R::ONE, R::ZERO),
            lead: R::ZERO,
            from: Vector3::new(R::ZERO, R::ZERO, R::ZERO),
            along: over(&reduced, size),
            margin: R::ONE,
            torque: self.torque,
        };
        let [lower, upper] = reach(&self.sharing, &ray);
        [size / upper, size / lower]
    }

    /// Bounds of the greatest torque about the centre beside a force of this `size`, in units of force limit
    /// and radius.
    fn beside(&self, force: &Vector2<R>, size: R) -> [R; 2] {
        let (zero, one) = (R::ZERO, R::ONE);
        let along = Vector3::new(zero, zero, one);
        if size == zero {
            let ray = WrenchRay {
                direction: Vector2::new(one, zero),
                lead: zero,
                from: Vector3::new(zero, zero, zero),
                along,
                margin: one,
                torque: self.torque,
            };
            return reach(&self.sharing, &ray);
        }
        // What the force leaves of the limit, as far as it is known.
        let rounding = R::from_f64(FORCE_ULPS) * R::EPSILON;
        let left = one - size;
        let margin = if left > rounding { left } else { rounding };
        let ray = WrenchRay {
            direction: Vector2::new(force.x / size, force.y / size),
            lead: one,
            from: Vector3::new(-margin, zero, zero),
            along,
            margin,
            torque: self.torque,
        };
        let [low, high] = reach(&self.sharing, &ray);
        // The torque is concave in what is left, and none where nothing is.
        let doubt = rounding / margin;
        [low * (one - doubt), high * (one + doubt)]
    }

    /// Velocity of the centre and spin times radius.
    fn at_centre(&self, twist: &Twist<R>) -> Vector3<R> {
        let c = self.centre();
        Vector3::new(
            twist.velocity.x - twist.spin * c.y,
            twist.velocity.y + twist.spin * c.x,
            twist.spin * self.radius(),
        )
    }

    /// The pressure under which a motion dissipates most.
    fn worst_pressure(&self, motion: &Vector3<R>) -> Greatest<R> {
        self.sharing.greatest(|d| speed(&velocity(motion, d)))
    }

    fn about_origin(&self, force: Vector2<R>, torque: R) -> Wrench<R> {
        let torque = torque + cross(&self.centre(), &force);
        Wrench { force, torque }
    }
}

/// Velocity of a place in radii, at a motion of the centre.
fn velocity<R: Real>(motion: &Vector3<R>, d: &Vector2<R>) -> Vector2<R> {
    Vector2::new(motion.x - motion.z * d.y, motion.y + motion.z * d.x)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A number of −1 … 1 that golden angles and their like spread evenly.
    fn part(i: u32, k: f64) -> f64 {
        2.0 * (f64::from(i) * k).fract() - 1.0
    }

    fn corners<const N: usize>(i: u32) -> [[f64; 2]; N] {
        core::array::from_fn(|j| {
            let j = 31 * i + j as u32;
            let angle = 3.2 * part(j, 0.754_877_666_25);
            let far = 1.2 + part(j, 0.569_840_290_99);
            [far * libm::cos(angle), far * libm::sin(angle)]
        })
    }

    /// The greatest mean speed over all triangles of corners around the centre.
    fn by_triangles<const N: usize>(
        corners: &[[f64; 2]; N],
        c: [f64; 2],
        twist: &Twist<f64>,
    ) -> f64 {
        let at = |j: usize| Vector2::new(corners[j][0], corners[j][1]);
        let c = Vector2::new(c[0], c[1]);
        let height = |p: &Vector2<f64>| {
            let u = twist.velocity + Vector2::new(-p.y, p.x) * twist.spin;
            u.norm()
        };
        let mut most = f64::NEG_INFINITY;
        for i in 0..N {
            for j in 0..i {
                for k in 0..j {
                    let [p, q, r] = [at(i), at(j), at(k)];
                    let area = cross(&(q - p), &(r - p));
                    let parts = [
                        cross(&(q - c), &(r - c)) / area,
                        cross(&(r - c), &(p - c)) / area,
                        cross(&(p - c), &(q - c)) / area,
                    ];
                    if parts.iter().all(|part| *part >= -1e-9) {
                        let [a, b, c] = parts;
                        most = most.max(a * height(&p) + b * height(&q) + c * height(&r));
                    }
                }
            }
        }
        most
    }

    fn bounds_are_near<const N: usize>(count: u32) -> [f64; 3] {
        let mut worst = [0.0_f64; 3];
        for i in 0..count {
            let corners: [[f64; 2]; N] = corners(i);
            let mut centre = [0.0; 2];
            let mut sum = 0.0;
            for (j, corner) in corners.iter().enumerate() {
                // At times all but on an edge.
                let narrow = if (i + j as u32).is_multiple_of(3) {
                    1e-6
                } else {
                    1.0
                };
                let share = narrow * (1.01 + part(i + j as u32, 0.819_172_513_4));
                sum += share;
                centre = [centre[0] + share * corner[0], centre[1] + share * corner[1]];
            }
            let centre = centre.map(|x| x / sum);
            let foot = UnknownPressureSet::new(corners, centre, 1.0).unwrap();
            let angle = 3.2 * part(i, 0.671_043_606_7);
            let twist = Twist::new(
                2.0 * part(i, 0.445_041_867_9),
                libm::sin(angle),
                libm::cos(angle),
            );
            let exact = by_triangles(&corners, centre, &twist);
            worst[0] = worst[0].max((foot.support(&twist) / exact - 1.0).abs());
            let power = -foot.wrench(&twist).power(&twist);
            worst[0] = worst[0].max((power / exact - 1.0).abs());
            let size = 0.999 * part(i, 0.324_717_957_2).abs();
            let force = [size * libm::cos(angle), size * libm::sin(angle)];
            let yaw = foot.torque_limits(force).unwrap();
            for side in [0, 1] {
                let gap = (yaw.certain[side] - yaw.possible[side]).abs();
                worst[1] = worst[1].max(gap / foot.radius());
                // The gauge of a limit is 1.
                let wrench = Wrench::new(force[0], force[1], yaw.certain[side]);
                let [low, high] = foot.gauge_bounds(&wrench);
                assert!(
                    low <= 1.0 + 1e-10 && high < 1.0 + 1e-8,
                    "{N} {i} {low} {high}"
                );
                worst[2] = worst[2].max((high - low) / high);
            }
        }
        worst
    }

    /// Largest gap of the limits of two corners that carry half the load each. Across their line a force
    /// leaves the torque 1 − F, along it √(1 − F²), in units of force limit and radius.
    fn gap_of_two<R: Real>(left: f64) -> f64 {
        let pair = UnknownPressureSet::new(
            [[-R::ONE, R::ZERO], [R::ONE, R::ZERO]],
            [R::ZERO; 2],
            R::ONE,
        );
        let (pair, zero, force) = (pair.unwrap(), R::ZERO, R::from_f64(1.0 - left));
        // What the rounded force leaves.
        let left = 1.0 - force.to_f64();
        let mut worst = 0.0_f64;
        for (force, exact) in [
            ([zero, force], left),
            ([zero, -force], left),
            ([force, zero], libm::sqrt(left * (2.0 - left))),
        ] {
            let yaw = pair.torque_limits(force).unwrap();
            let rounding = 4.0 * R::EPSILON.to_f64() * exact / left;
            for (sign, side) in [(-1.0, 0), (1.0, 1)] {
                let [carried, outer] =
                    [yaw.certain[side], yaw.possible[side]].map(|torque| sign * torque.to_f64());
                assert!(
                    carried <= exact + rounding && outer >= exact - rounding,
                    "{left:e} {exact:e} {carried:e} {outer:e}"
                );
                worst = worst.max(outer - carried);
            }
        }
        worst
    }

    #[test]
    fn bounds_meet_next_to_the_largest_force() {
        for left in [1e-1, 1e-3, 1e-6, 1e-8, 1e-10, 1e-11] {
            let gap = gap_of_two::<f64>(left);
            assert!(gap < 1e-9, "{left:e} {gap:e}");
        }
        for left in [1e-12, 1e-14, 4e-16] {
            let gap = gap_of_two::<f64>(left);
            assert!(gap < 1e-7, "{left:e} {gap:e}");
        }
        for left in [0.3, 1e-2, 1e-3, 1e-4, 1e-6, 1e-7] {
            let gap = gap_of_two::<f32>(left);
            assert!(gap < 2e-3, "{left:e} {gap:e}");
        }
        // Any corners, in any direction.
        for i in 0..2000 {
            let corners: [[f64; 2]; 5] = corners(i);
            let centre = [0, 1].map(|k| corners.iter().map(|corner| corner[k]).sum::<f64>() / 5.0);
            let foot = UnknownPressureSet::new(corners, centre, 3.0).unwrap();
            let size = 3.0 * (1.0 - libm::exp(-25.0 * part(i, 0.445_041_867_9).abs()));
            let angle = 3.2 * part(i, 0.671_043_606_7);
            let yaw = foot
                .torque_limits([size * libm::cos(angle), size * libm::sin(angle)])
                .unwrap();
            let unit = 3.0 * foot.radius();
            assert!(
                (yaw.possible[1] - yaw.certain[1]).abs() < 1e-9 * unit,
                "{i} {yaw:?}"
            );
            assert!(
                (yaw.possible[0] - yaw.certain[0]).abs() < 1e-9 * unit,
                "{i} {yaw:?}"
            );
        }
    }

    #[test]
    fn bounds_meet_and_supports_are_those_of_the_best_triangle() {
        let all = [
            bounds_are_near::<3>(2000),
            bounds_are_near::<4>(2000),
            bounds_are_near::<5>(1000),
            bounds_are_near::<8>(1000),
            bounds_are_near::<24>(200),
        ];
        for [support, torque, gauge] in all {
            assert!(
                support < 1e-14 && torque < 1e-10 && gauge < 1e-11,
                "{all:?}"
            );
        }
    }
}
