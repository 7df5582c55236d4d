//! The surface in reduced units: one curve in the quarter plane f, t ≥ 0, and two searches on it.
//!
//! Rotation about the torque axis and mirror symmetry leave the curve (F, T)(v, w), v, w ≥ 0. The
//! twist (v, w) is its outward normal and runs once from the force's pole (1, 0) to the torque's
//! (0, T₀). Both searches look for the normal, as the ratio h ∈ [0, 1] of the smaller to the larger
//! speed: near either pole h keeps its relative accuracy. With capitals for the component
//! that leads and p = (A, a) the given point, the zeros of
//!
//! ```text
//! through the ray of p:    A m(h) − a M(h)                          (M, m) parallel to p
//! nearest to p:            (A − M(h)) h − κ (a − m(h))              p − (M, m) along the normal
//! ```
//!
//! are unique: along the curve both rise through zero, the second because a normal that points
//! inwards from the quarter plane never leaves the set. κ is the squared ratio of
//! the lever that weighs torque to the radius if spinning leads, its inverse if sliding leads.

use crate::coupling::{DryCoupling, ReducedJacobian, ReducedWrench};
use crate::real::Real;

/// More steps than any search needs: bisection alone gets from 1 to the rounding error.
const MAX_STEPS: u32 = 64;
/// Relative step of a search below which its end is known to rounding: noise of the couplings is
/// smaller, and a Newton step that small has squared it away.
const SETTLED_ULPS: f64 = 256.0;
/// Radius of curvature of a typical surface, for the start of the search for the nearest point.
const TYPICAL_CURVATURE_RADIUS: f64 = 0.5;

/// The curve of one coupling.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Meridian<R, C> {
    pub coupling: C,
    /// Point at equal speeds, where the leading component changes.
    equal: ReducedWrench<R>,
    /// m/M per h at the two poles: of torque in force, of force in torque.
    pole_slopes: [R; 2],
    /// Lines through the equal point and a pole, as α f + β t = 1: of the force's pole, of the torque's.
    chords: [[R; 2]; 2],
}

/// An outward normal: the larger of the two speeds is 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Normal<R> {
    pub slide: R,
    pub rim: R,
}

/// Which speed is the larger one.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Lead {
    Slide,
    Rim,
}

/// Point and rates at one normal, the leading component first.
struct Local<R> {
    major: R,
    minor: R,
    mixed: R,
    minor_rate: R,
}

/// A point's normal along its ray.
#[derive(Clone, Copy, Debug)]
pub(super) struct Radial<R> {
    pub normal: Normal<R>,
    /// Gauge of the given point.
    pub gauge: R,
}

/// How closely the normal along a ray is wanted.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Aim {
    /// The gauge: stationary in the normal, half of its digits are enough.
    Gauge,
    /// The normal itself.
    Normal,
}

impl Lead {
    #[inline]
    fn normal<R: Real>(self, ratio: R) -> Normal<R> {
        match self {
            Self::Slide => Normal {
                slide: R::ONE,
                rim: ratio,
            },
            Self::Rim => Normal {
                slide: ratio,
                rim: R::ONE,
            },
        }
    }

    /// Force and torque, or the other way round: the leading component first.
    #[inline]
    fn order<T>(self, force: T, torque: T) -> [T; 2] {
        match self {
            Self::Slide => [force, torque],
            Self::Rim => [torque, force],
        }
    }
}

impl<R: Real, C: DryCoupling<R>> Meridian<R, C> {
    pub fn new(coupling: C) -> Self {
        let equal = coupling.reduced_wrench(R::ONE, R::ONE);
        let at = |slide, rim| {
            let w = coupling.reduced_wrench(slide, rim);
            (w, coupling.reduced_jacobian(slide, rim))
        };
        let (sliding, near_sliding) = at(R::ONE, R::ZERO);
        let (spinning, near_spinning) = at(R::ZERO, R::ONE);
        let [top, side] = [sliding.force, spinning.torque];
        let chords = [
            [R::ONE / top, (R::ONE - equal.force / top) / equal.torque],
            [(R::ONE - equal.torque / side) / equal.force, R::ONE / side],
        ];
        Self {
            equal,
            chords,
            pole_slopes: [
                near_sliding.torque_rim / sliding.force,
                near_spinning.force_slide / spinning.torque,
            ],
            coupling,
        }
    }

    /// A bound from above of the gauge: the set is convex and holds its poles and the equal point.
    ///
    /// *Domain*: components ≥ 0; NaN gives NaN.
    #[inline]
    pub fn gauge_bound(&self, force: R, torque: R) -> R {
        let [[a, b], [c, d]] = self.chords;
        let [one, other] = [a * force + b * torque, c * force + d * torque];
        if one > other { one } else { other }
    }

    /// The point whose outward normal is given.
    #[inline]
    pub fn point(&self, normal: Normal<R>) -> ReducedWrench<R> {
        self.coupling.reduced_wrench(normal.slide, normal.rim)
    }

    /// The normal where the ray of a point meets the curve, and the point's gauge
    /// max p·(v, w)/D(v, w), which is stationary there.
    ///
    /// *Domain*: finite components ≥ 0 of which the larger is of order 1; NaN gives NaN.
    pub fn radial(&self, point: ReducedWrench<R>, aim: Aim) -> Radial<R> {
        let ReducedWrench { force, torque } = point;
        let lead = if force * self.equal.torque >= torque * self.equal.force {
            Lead::Slide
        } else {
            Lead::Rim
        };
        let [major, minor] = lead.order(force, torque);
        let tolerance = match aim {
            Aim::Gauge => R::EPSILON.sqrt(),
            Aim::Normal => settled(),
        };
        let start = self.start(lead, minor / major);
        let ratio = solve_rising(start, tolerance, |h| {
            let at = self.local(lead, h);
            [
                major * at.minor - minor * at.major,
                major * at.minor_rate - minor * at.mixed,
            ]
        });
        let normal = lead.normal(ratio);
        let on = self.point(normal);
        let power = normal.slide * on.force + normal.rim * on.torque;
        Radial {
            normal,
            gauge: (force * normal.slide + torque * normal.rim) / power,
        }
    }

    /// The normal at the point of the curve nearest to one outside, in the norm
    /// √(f² + t²/`lever_sq`). `radial` is what [`Meridian::radial`] says about the point.
    ///
    /// Products with a weight only overflow where the other component leads.
    pub fn nearest(&self, point: ReducedWrench<R>, lever_sq: R, radial: &Radial<R>) -> Normal<R> {
        let ReducedWrench { force, torque } = point;
        let equal = &self.equal;
        let lead = if torque - equal.torque <= lever_sq * (force - equal.force) {
            Lead::Slide
        } else {
            Lead::Rim
        };
        let [major, minor] = lead.order(force, torque);
        let [weight, _] = lead.order(R::ONE / lever_sq, lever_sq);
        // Close by the normal is that of the ray, far away the direction of the point.
        let bend = R::from_f64(TYPICAL_CURVATURE_RADIUS);
        let away = R::ONE - R::ONE / radial.gauge;
        let [lean, rest] = lead.order(
            bend * radial.normal.slide + away * force,
            bend * radial.normal.rim + away * torque / lever_sq,
        );
        let ratio = solve_rising(rest / lean, settled(), |h| {
            let at = self.local(lead, h);
            let ahead = major - at.major;
            [
                ahead * h - weight * (minor - at.minor),
                ahead - h * at.mixed + weight * at.minor_rate,
            ]
        });
        lead.normal(ratio)
    }

    /// h on the ray with m/M = `slope`: exact at both ends, and for an ellipse everywhere.
    #[inline]
    fn start(&self, lead: Lead, slope: R) -> R {
        let [at_pole, _] = lead.order(self.pole_slopes[0], self.pole_slopes[1]);
        let [major, minor] = lead.order(self.equal.force, self.equal.torque);
        let at_equal = minor / major;
        slope / (at_pole + (R::ONE - at_pole / at_equal) * slope)
    }

    #[inline]
    fn local(&self, lead: Lead, ratio: R) -> Local<R> {
        let Normal { slide, rim } = lead.normal(ratio);
        let ReducedWrench { force, torque } = self.coupling.reduced_wrench(slide, rim);
        let ReducedJacobian {
            force_slide,
            mixed,
            torque_rim,
            ..
        } = self.coupling.reduced_jacobian(slide, rim);
        let [major, minor] = lead.order(force, torque);
        let [_, minor_rate] = lead.order(force_slide, torque_rim);
        Local {
            major,
            minor,
            mixed,
            minor_rate,
        }
    }
}

#[inline]
fn settled<R: Real>() -> R {
    R::from_f64(SETTLED_ULPS) * R::EPSILON
}

/// The zero in [0, 1] of a function that rises through it, by Newton steps kept in the bracket;
/// bisection replaces a step that leaves it or has no slope.
///
/// *Domain*: any `start`. `function` gives value and slope. Ends at once on NaN.
/// *Cost*: at most [`MAX_STEPS`] calls.
#[inline]
fn solve_rising<R: Real>(start: R, tolerance: R, function: impl Fn(R) -> [R; 2]) -> R {
    let (mut low, mut high) = (R::ZERO, R::ONE);
    let mut at = if start >= low && start <= high {
        start
    } else {
        high
    };
    for _ in 0..MAX_STEPS {
        let [value, slope] = function(at);
        if value < R::ZERO {
            low = at;
        } else if value > R::ZERO {
            high = at;
        } else {
            return at;
        }
        let newton = at - value / slope;
        let next = if slope.is_finite() && newton >= low && newton <= high {
            newton
        } else {
            R::HALF * (low + high)
        };
        if (next - at).abs() <= tolerance * next {
            return next;
        }
        at = next;
    }
    at
}
