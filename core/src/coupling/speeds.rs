//! The two speeds of a contact in units of the larger one.

use super::extended_range::is_in_normal_range;
use crate::real::Real;

/// Which of the two speeds is the larger one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum DominantSpeed {
    /// The rim moves faster than the centre, w ≥ v.
    Spinning,
    /// The centre moves faster than the rim, v > w.
    Sliding,
}

/// Sliding speed v and rim speed w = |ω|R in units of m = max(v, w).
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Speeds<R> {
    /// m, zero only at rest.
    pub(super) major: R,
    /// v/m
    pub(super) slide: R,
    /// w/m
    pub(super) rim: R,
    /// h, the smaller speed over the larger one.
    ratio: R,
    /// |v − w|/m, from the speeds themselves.
    gap: R,
}

impl<R: Real> Speeds<R> {
    /// From two speeds; their signs are ignored.
    #[inline]
    pub fn new(slide: R, rim: R) -> Self {
        let (slide, rim) = (slide.abs(), rim.abs());
        let major = if slide > rim { slide } else { rim };
        let (a, b) = (slide / major, rim / major);
        // One comparison finds rest (0/0), infinities (∞/∞) and NaN.
        if a * b >= R::ZERO {
            Self {
                major,
                slide: a,
                rim: b,
                ratio: a * b,
                gap: (slide - rim).abs() / major,
            }
        } else {
            Self::limit_at_rest_or_nonfinite(slide, rim)
        }
    }

    /// From two ordinary speeds (from `LEAST_SPEED` up to its reciprocal), `rim` may be 0; with 1/m, the
    /// only quotient.
    #[inline]
    pub(super) fn of_ordinary(slide: R, rim: R) -> (Self, R) {
        // A selection for each, by a comparison of its own: which speed leads is a coin toss to a
        // branch predictor, and selections in common become branches, or a quotient on each side.
        let major = if slide > rim { slide } else { rim };
        let minor = if slide < rim { slide } else { rim };
        let slides = slide > rim;
        let per_major = R::ONE / major;
        let ratio = minor * per_major;
        let speeds = Self {
            major,
            slide: if slides { R::ONE } else { ratio },
            rim: if slides { ratio } else { R::ONE },
            ratio,
            gap: (major - minor) * per_major,
        };
        (speeds, per_major)
    }

    /// From the smaller over the larger speed, `ratio` in [0, 1], with m = 1.
    #[inline]
    pub fn from_ratio(lead: DominantSpeed, ratio: R) -> Self {
        let (slide, rim) = match lead {
            DominantSpeed::Spinning => (ratio, R::ONE),
            DominantSpeed::Sliding => (R::ONE, ratio),
        };
        Self {
            major: R::ONE,
            slide,
            rim,
            ratio,
            gap: R::ONE - ratio,
        }
    }

    /// From the smaller over the larger speed and its distance from 1, each with its own digits.
    #[inline]
    pub(crate) fn from_ratio_and_gap(lead: DominantSpeed, ratio: R, gap: R) -> Self {
        Self {
            gap,
            ..Self::from_ratio(lead, ratio)
        }
    }

    /// m
    #[inline]
    pub(crate) fn major(&self) -> R {
        self.major
    }

    /// |v − w|/m.
    #[inline]
    pub(crate) fn gap(&self) -> R {
        self.gap
    }

    /// Rest, infinities and NaN: the limit if only one speed is infinite, zeros at rest.
    #[cold]
    fn limit_at_rest_or_nonfinite(slide: R, rim: R) -> Self {
        let in_units = |speed: R, other: R| {
            if speed == R::INFINITY && other < R::INFINITY {
                R::ONE
            } else if other == R::INFINITY && speed < R::INFINITY {
                R::ZERO
            } else if speed == R::INFINITY {
                speed - other
            } else {
                // Zero, or NaN from either.
                speed + R::ZERO * other
            }
        };
        let (a, b) = (in_units(slide, rim), in_units(rim, slide));
        Self {
            major: slide + rim,
            slide: a,
            rim: b,
            ratio: a * b,
            gap: (a - b).abs(),
        }
    }

    /// The same in f64.
    #[inline]
    pub(super) fn widened(&self) -> Speeds<f64> {
        Speeds {
            major: self.major.to_f64(),
            slide: self.slide.to_f64(),
            rim: self.rim.to_f64(),
            ratio: self.ratio.to_f64(),
            gap: self.gap.to_f64(),
        }
    }

    /// True if nothing moves; false for NaN.
    #[inline]
    pub fn at_rest(&self) -> bool {
        self.major == R::ZERO
    }

    /// Which speed leads; spinning if they are equal.
    #[inline]
    pub fn lead(&self) -> DominantSpeed {
        if self.slide > self.rim {
            DominantSpeed::Sliding
        } else {
            DominantSpeed::Spinning
        }
    }

    /// h, the smaller speed over the larger one.
    #[inline]
    pub fn ratio(&self) -> R {
        self.ratio
    }

    /// z = 1 − h², without cancellation near equal speeds.
    #[inline]
    pub fn complement(&self) -> R {
        self.gap * (R::ONE + self.ratio())
    }

    /// True if h² is a normal number, or `slide` or `rim` zero: h and its powers have all digits.
    #[inline]
    pub(super) fn are_resolved(&self, slide: R, rim: R) -> bool {
        let h = self.ratio();
        h * h >= R::MIN_POSITIVE || slide == R::ZERO || rim == R::ZERO
    }

    /// True if `scale` times a product with h or 1 is right at once: a scale of 1 makes no number
    /// of a quotient that is none.
    #[inline]
    pub(super) fn may_be_scaled(&self, scale: R, slide: R, rim: R) -> bool {
        scale == R::ONE || is_in_normal_range(scale) && self.are_resolved(slide, rim)
    }

    /// x = h² and z = 1 − x, each without rounding near its zero.
    #[inline]
    pub(super) fn square_and_complement(&self) -> (R, R) {
        let h = self.ratio();
        (h * h, self.complement())
    }
}
