//! Gauss' rule on panels that keep clear of known places in the complex plane.

use crate::real::Real;
use crate::special::legendre::each_node;

/// A complex number; of a pair of conjugates the one above the real axis.
#[derive(Clone, Copy, Debug)]
pub(super) struct Complex<R> {
    re: R,
    im: R,
}

/// Beyond this size tan(asin(W)/2) is ±i to a thousandth.
const LARGE: f64 = 1e3;

impl<R: Real> Complex<R> {
    #[inline(always)]
    pub fn new(re: R, im: R) -> Self {
        Self { re, im }
    }

    #[inline(always)]
    pub fn over(self, divisor: R) -> Self {
        Self::new(self.re / divisor, self.im / divisor)
    }

    #[inline(always)]
    pub fn negative(self) -> Self {
        Self::new(-self.re, -self.im)
    }

    /// Mirrored at the imaginary axis.
    #[inline(always)]
    pub fn mirrored(self) -> Self {
        Self::new(-self.re, self.im)
    }

    /// 1/z
    #[inline(always)]
    pub fn inverse(self) -> Self {
        let sq = self.re * self.re + self.im * self.im;
        Self::new(self.re / sq, -(self.im / sq))
    }

    #[inline(always)]
    pub fn plus(self, other: Self) -> Self {
        Self::new(self.re + other.re, self.im + other.im)
    }

    #[inline(always)]
    pub fn times(self, other: Self) -> Self {
        Self::new(
            self.re * other.re - self.im * other.im,
            self.re * other.im + self.im * other.re,
        )
    }

    #[inline(always)]
    pub fn re(self) -> R {
        self.re
    }

    /// Distance from the real axis.
    #[inline(always)]
    pub fn height(self) -> R {
        self.im.abs()
    }

    #[inline(always)]
    pub fn size_sq(self) -> R {
        self.re * self.re + self.im * self.im
    }

    /// The square root with a real part ≥ 0.
    pub fn sqrt(self) -> Self {
        let Self { re, im } = self;
        let large = (R::HALF * (re.hypot(im) + re.abs())).sqrt();
        if large == R::ZERO {
            return self;
        }
        let small = R::HALF * im / large;
        if re >= R::ZERO {
            Self::new(large, small)
        } else {
            Self::new(small.abs(), large.copysign(im))
        }
    }

    /// The two solutions z of 2z/(1 + z²) = W.
    pub fn tangent_of_half_arcsine(self) -> [Self; 2] {
        let Self { re, im } = self;
        let is_moderate = re.abs() + im.abs() < R::from_f64(LARGE);
        if !is_moderate {
            return [Self::new(R::ZERO, R::ONE); 2];
        }
        let sq_re = (R::ONE - re) * (R::ONE + re) + im * im;
        let root = Self::new(sq_re, -(R::TWO * re * im)).sqrt();
        let z = self.times(Self::new(R::ONE + root.re, root.im).inverse());
        [z, z.inverse()]
    }
}

/// The interval −`end` < z < `end` in panels, for an integrand that is analytic but for ±i, the `marks` and
/// their conjugates.
#[derive(Clone, Copy)]
pub(super) struct Panels<R, const N: usize> {
    /// At most 1.
    pub end: R,
    /// Place from which panels are laid to both sides.
    pub start: R,
    /// Shortest and longest panel: the poles ±i are of high order and take more room.
    pub least: R,
    pub most: R,
    pub marks: [Complex<R>; N],
}

/// Semi-axis, in halves of a panel, of the ellipse with foci at its ends that no mark may enter: errors of
/// n points fall like (2 + √3)⁻²ⁿ.
const CLEAR: f64 = 2.0;
/// Part of an interval that must be clear for one panel to take all of it.
const NEARLY: f64 = 0.999;
/// Panels on one side: they grow by factors of three, from the rounding of 1 on.
const MOST: usize = 64;

impl<R: Real, const N: usize> Panels<R, N> {
    /// Nodes, as z and z − start, and weights.
    #[inline(always)]
    pub fn each(&self, visit: &mut impl FnMut(R, R, R)) {
        for side in [R::ONE, -R::ONE] {
            let end = self.end - side * self.start;
            let mut from = R::ZERO;
            for _ in 0..MOST {
                let rest = end - from;
                if rest <= R::ZERO {
                    break;
                }
                let clear = self.clear(side, from);
                let clear = if clear > self.least {
                    clear
                } else {
                    self.least
                };
                let length = if clear < rest { clear } else { rest };
                let (half, middle) = (R::HALF * length, from + R::HALF * length);
                each_node(|node, weight| {
                    let apart = side * (middle + half * node);
                    visit(self.start + apart, apart, half * weight);
                });
                from = if clear < rest { from + length } else { end };
            }
        }
    }

    /// The whole interval as one panel, if that is clear of all marks.
    #[inline(always)]
    pub fn joined(self) -> Self {
        let whole = Self {
            start: -self.end,
            ..self
        };
        let length = R::from_f64(NEARLY) * (whole.end + whole.end);
        if whole.clear(R::ONE, R::ZERO) >= length {
            whole
        } else {
            self
        }
    }

    /// Length of the panel from a distance on one side of the start.
    #[inline(always)]
    fn clear(&self, side: R, from: R) -> R {
        let clear = R::from_f64(CLEAR);
        let start = self.start;
        let mut length = self.most;
        let mut keep = |mark: &Complex<R>| {
            let ahead = side * (mark.re - start) - from;
            let size = (ahead * ahead + mark.im * mark.im).sqrt();
            // |mark − from| + |mark − to| ≥ 2 clear (to − from)/2
            let most = R::TWO * (clear * size - ahead) / (clear * clear - R::ONE);
            if most < length {
                length = most;
            }
        };
        keep(&Complex::new(R::ZERO, R::ONE));
        self.marks.iter().for_each(&mut keep);
        length
    }
}
