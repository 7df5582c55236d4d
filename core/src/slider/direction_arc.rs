//! The stretch of directions that a motion runs through, on one side of equal speeds.
//!
//! With h the smaller over the larger speed, a leg lies between `bottom` and `top`: 0, the fixed
//! point h₀, or 1. Its coordinate
//!
//! ```text
//! p = ln (top − h)/(h − bottom),      h = bottom + (top − bottom)/(1 + eᵖ)
//! ```
//!
//! runs over all numbers and turns what happens at the ends into exponentials: the pole of the time at a
//! fixed point, the kink of force and torque at equal speeds, the powers of a vanishing ratio. All
//! singularities of the wrench keep the distance π from the real axis of p.

use crate::coupling::{DominantSpeed, Speeds};
use crate::real::Real;

/// Where a leg leads.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum ArcEnd {
    /// Through equal speeds to the other side.
    EqualSpeeds,
    /// To the ratio that stays: a fixed point, or 0.
    Settled,
}

/// One stretch.
#[derive(Clone, Copy, Debug)]
pub(super) struct DirectionArc<R> {
    pub lead: DominantSpeed,
    pub bottom: R,
    pub top: R,
    /// True if h grows, and p falls.
    pub rising: bool,
    pub end: ArcEnd,
    /// Where the motion is.
    pub p: R,
    /// Where the leg is over.
    pub goal: R,
}

/// A place on a leg.
pub(super) struct ArcPoint<R> {
    pub at: Speeds<R>,
    /// −d ln h/dp
    pub share: R,
    /// Distance of h from the end of the leg.
    pub distance: R,
}

/// |p| beyond which functions differ from their limit by small exponentials: a panel may reach to the
/// next of these.
const OUTER: f64 = 5.0;
const FAR: f64 = 14.0;
/// p where the square of h is 1e-8 and 1e-16: nothing that matters changes between and beyond.
const FAINT: [f64; 2] = [18.0, 9.0];
/// Longest panel between: its nodes lie well within the distance π of the singularities.
const LONGEST: f64 = 10.0 / 3.0;

impl<R: Real> DirectionArc<R> {
    /// The leg from the ratio h (its logarithm, its distance from 1) between two ends.
    pub fn new(
        lead: DominantSpeed,
        [bottom, top]: [R; 2],
        rising: bool,
        end: ArcEnd,
        [ratio, ln_ratio, gap]: [R; 3],
    ) -> Self {
        let below = if top == R::ONE { gap } else { top - ratio };
        let above = ratio - bottom;
        let ln_above = if bottom == R::ZERO {
            ln_ratio
        } else {
            positive(above).ln()
        };
        let width = top - bottom;
        let goal = match end {
            ArcEnd::EqualSpeeds => -edge::<R>(),
            ArcEnd::Settled if bottom == R::ZERO && !rising => vanished::<R>(),
            ArcEnd::Settled => {
                let limit = if rising { top } else { bottom };
                let depth = (width / nearness(limit)).ln();
                if rising { -depth } else { depth }
            }
        };
        let start = positive(below).ln() - ln_above;
        let least = -edge::<R>() - R::TWO;
        Self {
            lead,
            bottom,
            top,
            rising,
            end,
            p: if start > least { start } else { least },
            goal,
        }
    }

    /// The leg that begins at equal speeds.
    pub fn from_equal(lead: DominantSpeed, bottom: R) -> Self {
        Self {
            p: -edge::<R>(),
            ..Self::new(
                lead,
                [bottom, R::ONE],
                false,
                ArcEnd::Settled,
                [R::ONE, R::ZERO, R::ZERO],
            )
        }
    }

    /// True if it is run through.
    pub fn is_complete(&self) -> bool {
        if self.rising {
            self.p <= self.goal
        } else {
            self.p >= self.goal
        }
    }

    /// The sign of C_α − C that drives the motion along the leg.
    pub fn sign(&self) -> R {
        if self.rising == (self.lead == DominantSpeed::Spinning) {
            R::ONE
        } else {
            -R::ONE
        }
    }

    /// The ratio that stays in the end.
    pub fn limit(&self) -> R {
        if self.rising { self.top } else { self.bottom }
    }

    /// Speeds at `p`.
    pub fn place(&self, p: R) -> ArcPoint<R> {
        let small = (-p.abs()).exp();
        let large = R::ONE / (R::ONE + small);
        let small = small * large;
        let (down, up) = if p > R::ZERO {
            (large, small)
        } else {
            (small, large)
        };
        let width = self.top - self.bottom;
        let (below, above) = (width * down, width * up);
        let ratio = self.bottom + above;
        let gap = (R::ONE - self.top) + below;
        // Profiles know speeds that differ by a rounding error or not at all.
        let gap = if gap > R::EPSILON { gap } else { R::EPSILON };
        ArcPoint {
            at: Speeds::from_ratio_and_gap(self.lead, ratio, gap),
            share: if self.bottom == R::ZERO {
                down
            } else {
                below * up / ratio
            },
            distance: if self.rising { below } else { above },
        }
    }

    /// Length in p over which force and torque are smooth for one panel.
    pub fn smooth_length(&self) -> R {
        let left = (self.goal - self.p).abs();
        let outward = self.rising == (self.p < R::ZERO);
        let size = self.p.abs();
        let [outer, far] = [OUTER, FAR].map(R::from_f64);
        let longest = R::from_f64(LONGEST);
        let length = if outward && size >= far {
            left
        } else if outward && size >= outer {
            far - size
        } else if outward {
            outer - size
        } else if size > outer {
            // Inward the function grows out of nothing: h² for p > 0, a kink or a pole for p < 0.
            let stops = if self.p > R::ZERO { FAINT } else { [FAR, FAR] };
            let next = stops.map(R::from_f64).into_iter().find(|stop| size > *stop);
            size - next.unwrap_or(outer)
        } else {
            size + outer
        };
        let length = if size < outer && length > longest {
            longest
        } else if length < R::HALF * longest {
            R::HALF * longest
        } else {
            length
        };
        if length < left { length } else { left }
    }
}

/// p at which nothing is left before equal speeds.
fn edge<R: Real>() -> R {
    -(R::EPSILON * R::HALF * R::HALF).ln()
}

/// p at which h⁴ is a rounding error.
fn vanished<R: Real>() -> R {
    -(R::EPSILON.ln() * R::HALF * R::HALF) + R::ONE
}

/// Distance from a fixed point within which the square of the distance does not matter.
fn nearness<R: Real>(limit: R) -> R {
    let gap = R::ONE - limit;
    let scale = if limit < gap { limit } else { gap };
    let near = R::EPSILON.sqrt() * R::HALF * scale;
    let least = R::EPSILON * R::from_f64(NEAREST_ULPS);
    if near > least { near } else { least }
}

/// Distance from a fixed point, in rounding errors, within which C_α − C has no sign.
const NEAREST_ULPS: f64 = 1024.0;

fn positive<R: Real>(x: R) -> R {
    if x > R::MIN_POSITIVE {
        x
    } else {
        R::MIN_POSITIVE
    }
}
