//! A worn annulus: pressure p ∝ 1/r, as the facing of a clutch or a thrust bearing ends up with.
//!
//! Wear goes like pressure times speed, and a facing that stays flat wears alike everywhere: p r is constant. Rings of
//! all radii then carry the same load per width, and with Φ and Χ of a ring ([`CoulombRing`])
//!
//! ```text
//! Φ = 1/(1−k) ∫ Φᵣ dr,     Χ = 1/(1−k) ∫ r² Χᵣ dr     from k to 1, Φᵣ = F/v, Χᵣ = T/(r w) of the ring at v, r w
//! ```
//!
//! which are analytic but for x ln|x| about the ring r* = v/w on which the centre of rotation lies. Gauss' rule in s, with
//! s⁴ in proportion to the distance from r*, serves next to it, and in r elsewhere; far outside a ring's series in
//! r*/r is integrated in closed form. Derivatives need no integral: F w (1−k) = ∫F(v, u) du has the integrand at its ends.

use super::coulomb::CoulombRing;
use super::profile::{self, PowerLawFriction, SmoothProfile};
use super::speeds::{DominantSpeed, Speeds};
use super::{DryReducedFriction, ReducedFriction, pressure_family};
use crate::patch::PatchError;
use crate::real::Real;
use crate::special::legendre::each_node;

/// Coulomb friction under pressure p ∝ 1/r between `inner_ratio` and 1 radii.
///
/// *Accuracy*: 2e-15 (f32: 1e-6) of force and torque limit; the Jacobian 1e-14 (f32: 5e-6) of the larger of the entry
/// and F/v, times 1/(1 − `inner_ratio`) for bands that hold the centre of rotation or end next to it.
/// *Special values*: as [`ReducedFriction`]; a full disk (`inner_ratio` = 0) that spins in place has an infinite F/v, for
/// which a large number stands. *Cost*: 16 [`CoulombRing`]s (13 disks), 32 to 48 with the centre of rotation in
/// the band or next to it, 96 at most; two disks where sliding is 133 times slower than the inner edge.
///
/// ```
/// use tribos_core::coupling::{RoundFriction, WornAnnulus};
/// use tribos_core::twist::Twist;
/// let (inner, outer) = (0.06_f64, 0.10); // m
/// let clutch = RoundFriction::new(WornAnnulus::new(inner / outer)?, 0.35, outer)?;
/// let slipping = clutch.wrench(4000.0, &Twist::new(0.0, 0.0, 20.0)); // N; rad/s
/// assert!((slipping.torque + 0.35 * 4000.0 * (inner + outer) / 2.0).abs() < 1e-12); // N m
/// # Ok::<(), tribos_core::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct WornAnnulus<R> {
    inner: R,
}

/// Next to the ring at r*: from this part of r* up to this multiple of it.
const NEAR: [f64; 2] = [0.6, 2.5];
/// Growth of panels beyond: the integrand is singular at ±r*.
const GROWTH: f64 = 2.75;
/// From this multiple of r* on four terms of the series are exact to rounding.
const FAR: f64 = 133.0;
/// Panels from 2.5 to 133 times r*.
const PANELS: usize = 4;
/// Inner ratio from which on derivatives are means, not differences, where they can.
const THIN: f64 = 0.9375;

/// Coefficients of 2F/(v/u) − 1 and of 1 − T of a ring by powers of (v/u)² from the first on, v < u.
const FORCE: [f64; 3] = [1.0 / 8.0, 3.0 / 64.0, 25.0 / 1024.0];
const TORQUE: [f64; 3] = [1.0 / 4.0, 3.0 / 64.0, 5.0 / 256.0];

/// Sums of Φ and Χ, and of the width.
#[derive(Default)]
struct Sums<R> {
    drag: R,
    torque: R,
    width: R,
}

impl<R: Real> WornAnnulus<R> {
    /// Thinnest annulus: beyond, a ring is as good to six digits.
    pub const MAX_INNER_RATIO: f64 = 0.999_999;

    /// *Domain*: 0 ≤ `inner_ratio` ≤ [`WornAnnulus::MAX_INNER_RATIO`].
    ///
    /// ```
    /// use tribos_core::coupling::WornAnnulus;
    /// assert!(WornAnnulus::new(0.5_f64).is_ok() && WornAnnulus::new(1.0_f64).is_err());
    /// ```
    pub fn new(inner_ratio: R) -> Result<Self, PatchError> {
        let max = Self::MAX_INNER_RATIO;
        if inner_ratio >= R::ZERO && inner_ratio <= R::from_f64(max) {
            Ok(Self { inner: inner_ratio })
        } else {
            Err(PatchError::InnerRatio {
                given: inner_ratio.to_f64(),
                max,
            })
        }
    }

    /// The inner over the outer radius.
    pub fn inner_ratio(&self) -> R {
        self.inner
    }

    /// Φ and Χ for the speeds of a motion over the larger one.
    fn means(&self, at: &Speeds<R>) -> [R; 2] {
        let (slide, rim) = (at.slide, at.rim);
        let pole = slide / rim;
        let (low, high) = (self.inner, R::ONE);
        let [near, past] = NEAR.map(|part| R::from_f64(part) * pole);
        let mut sums = Sums::default();
        // Rings that slide more than they turn.
        let inside = |radius: R, gap: R| {
            let ratio = radius * rim / slide;
            let ring = Speeds::from_ratio_and_gap(DominantSpeed::Sliding, ratio, gap);
            (ring, R::ONE / slide)
        };
        let to = least(high, near);
        if low < to {
            sums.add_panel([low, to], |radius| {
                inside(radius, R::ONE - radius * rim / slide)
            });
        }
        let (from, to) = (most(low, near), least(high, pole));
        if from < to {
            sums.add_towards(pole, from, to, |radius, apart| inside(radius, apart / pole));
        }
        // Rings that turn more than they slide.
        let outside = |radius: R, gap: R| {
            let ratio = slide / (radius * rim);
            let ring = Speeds::from_ratio_and_gap(DominantSpeed::Spinning, ratio, gap);
            (ring, R::ONE / (radius * rim))
        };
        let (from, to) = (least(high, past), most(low, pole));
        if to < from {
            sums.add_towards(pole, from, to, |radius, apart| {
                outside(radius, apart / radius)
            });
        }
        let mut from = most(low, past);
        let far = R::from_f64(FAR) * pole;
        for _ in 0..PANELS {
            let to = least(least(high, far), R::from_f64(GROWTH) * from);
            if from < to {
                let gap = |radius: R| (radius * rim - slide) / (radius * rim);
                sums.add_panel([from, to], |radius| outside(radius, gap(radius)));
                from = to;
            }
        }
        let from = most(most(low, far), R::MIN_POSITIVE);
        if from < high {
            sums.add_series([from, high], pole, rim);
        }
        [sums.drag / sums.width, sums.torque / sums.width]
    }

    /// Φ' from the rings at both ends.
    fn slope(&self, at: &Speeds<R>, chi: R) -> R {
        let (slide, rim, inner) = (at.slide, at.rim, self.inner);
        let width = R::ONE - inner;
        let (x, _) = at.square_and_complement();
        let pole = slide / rim;
        let leaves_room = pole < inner - width || pole > R::ONE + width;
        if inner > R::from_f64(THIN) && leaves_room {
            return self.mean_slope(at);
        }
        let ends = [R::ONE, inner].map(|radius| {
            let ring = Speeds::new(slide, radius * rim);
            if ring.at_rest() {
                return [R::ZERO; 2];
            }
            CoulombRing
                .factors(&ring)
                .map(|factor| factor / ring.major())
        });
        let [[drag, torque], [inner_drag, inner_torque]] = ends;
        match at.lead() {
            // ∂T/∂w = −2Φ'
            DominantSpeed::Sliding => {
                let cube = inner * inner * inner;
                chi - R::HALF * (torque - cube * inner_torque) / width
            }
            // ∂F/∂v = Φ + 2xΦ'
            DominantSpeed::Spinning if x > R::ZERO => {
                -(R::HALF * (drag - inner * inner_drag) / (width * x))
            }
            DominantSpeed::Spinning => R::ZERO,
        }
    }

    /// Φ' as a mean over rings.
    fn mean_slope(&self, at: &Speeds<R>) -> R {
        let (x, _) = at.square_and_complement();
        let (mut sum, mut weights) = (R::ZERO, R::ZERO);
        let middle = R::HALF * (R::ONE + self.inner);
        each_node(|node, weight| {
            let radius = middle + R::HALF * (R::ONE - self.inner) * node;
            let ring = CoulombRing.reduced_jacobian(at.slide, radius * at.rim);
            let slope = match at.lead() {
                DominantSpeed::Sliding => -(radius * radius * ring.torque_rim),
                DominantSpeed::Spinning => ring.force_slide - ring.force_per_slide,
            };
            weights += weight;
            sum += weight * slope;
        });
        let twice = sum / weights;
        match at.lead() {
            DominantSpeed::Sliding => R::HALF * twice,
            DominantSpeed::Spinning if x > R::ZERO => R::HALF * twice / x,
            DominantSpeed::Spinning => R::ZERO,
        }
    }
}

impl<R: Real> Sums<R> {
    /// A ring of weight dr at a radius, from its speeds and the reciprocal of the larger one.
    #[inline(always)]
    fn add(&mut self, width: R, radius: R, (ring, per_speed): (Speeds<R>, R)) {
        let [drag, torque] = CoulombRing.factors(&ring);
        let share = width * per_speed;
        self.drag += share * drag;
        self.torque += share * torque * (radius * radius);
        self.width += width;
    }

    /// Rings between two radii.
    #[inline(always)]
    fn add_panel(&mut self, [from, to]: [R; 2], ring: impl Fn(R) -> (Speeds<R>, R)) {
        let (half, middle) = (R::HALF * (to - from), R::HALF * (to + from));
        each_node(|node, weight| {
            let radius = middle + half * node;
            self.add(half * weight, radius, ring(radius));
        });
    }

    /// Rings from a radius towards the singular one at `pole`, up to another; `ring` has the distance from the pole.
    #[inline(always)]
    fn add_towards(&mut self, pole: R, from: R, to: R, ring: impl Fn(R, R) -> (Speeds<R>, R)) {
        let step = from - pole;
        let reach = step.abs();
        // r = r* + step s⁴
        let start = ((to - pole).abs() / reach).sqrt().sqrt();
        let half = R::HALF * (R::ONE - start);
        each_node(|node, weight| {
            let s = R::ONE - half + half * node;
            let cube = s * s * s;
            let four = R::TWO + R::TWO;
            let width = four * reach * cube * (half * weight);
            let fourth = cube * s;
            let radius = pole + step * fourth;
            self.add(width, radius, ring(radius, reach * fourth));
        });
    }

    /// All rings between two radii far outside the pole.
    fn add_series(&mut self, [from, to]: [R; 2], pole: R, rim: R) {
        let width = to - from;
        let log = (to / from).ln();
        // ∫ (r*/r)²ⁿ dr/r and r*² times it
        let [a, b] = [pole / from, pole / to].map(|ratio| ratio * ratio);
        let second = R::HALF * (a - b);
        let fourth = second * R::HALF * (a + b);
        let sixth = (a - b) * (a * a + a * b + b * b) / R::from_f64(6.0);
        let [f2, f4, f6] = FORCE.map(R::from_f64);
        let [t2, t4, t6] = TORQUE.map(R::from_f64);
        self.drag += R::HALF * (log + f2 * second + f4 * fourth + f6 * sixth) / rim;
        let area = R::HALF * width * (to + from);
        let lost = t2 * log + t4 * second + t6 * fourth;
        self.torque += (area - pole * pole * lost) / rim;
        self.width += width;
    }
}

#[inline(always)]
fn least<R: Real>(a: R, b: R) -> R {
    if b < a { b } else { a }
}

#[inline(always)]
fn most<R: Real>(a: R, b: R) -> R {
    if b > a { b } else { a }
}

impl<R: Real> PowerLawFriction<R> for WornAnnulus<R> {
    fn exponent(&self) -> R {
        R::ZERO
    }
    fn factors(&self, at: &Speeds<R>) -> [R; 2] {
        self.means(at)
    }
}

impl<R: Real> SmoothProfile<R> for WornAnnulus<R> {
    fn factors_and_slope(&self, at: &Speeds<R>) -> [R; 3] {
        let [phi, chi] = self.means(at);
        [phi, self.slope(at, chi), chi]
    }
}

impl<R: Real> ReducedFriction<R> for WornAnnulus<R> {
    pressure_family::coupling_methods!();
}

impl<R: Real> DryReducedFriction<R> for WornAnnulus<R> {
    #[inline]
    fn reduced_point(&self, lead: DominantSpeed, ratio: R) -> [R; 3] {
        profile::point(self, lead, ratio)
    }
}

#[cfg(test)]
#[path = "worn_tests.rs"]
mod tests;
