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

    /// The two solutions z of 2z/(1 + z²) = W.
    pub fn tangent_of_half_arcsine(self) -> [Self; 2] {
        let Self { re, im } = self;
        let is_moderate = re.abs() + im.abs() < R::from_f64(LARGE);
        if !is_moderate {
            return [Self::new(R::ZERO, R::ONE); 2];
        }
        // √(1 − W²), with a real part ≥ 0.
        let (sq_re, sq_im) = ((R::ONE - re) * (R::ONE + re) + im * im, -(R::TWO * re * im));
        let size = sq_re.hypot(sq_im);
        let large = (R::HALF * (size + sq_re.abs())).sqrt();
        let small = R::HALF * sq_im / large;
        let root = if sq_re >= R::ZERO {
            Self::new(large, small)
        } else {
            Self::new(small.abs(), large.copysign(sq_im))
        };
        let below = Self::new(R::ONE + root.re, root.im).inverse();
        let z = Self::new(re * below.re - im * below.im, re * below.im + im * below.re);
        [z, z.inverse()]
    }
}

/// The interval −1 < z < 1 in panels, for an integrand that is analytic but for ±i, the `marks` and
/// their conjugates.
pub(super) struct Panels<R, const N: usize> {
    /// Place from which panels are laid to both sides.
    pub start: R,
    pub marks: [Complex<R>; N],
}

/// Semi-axis, in halves of a panel, of the ellipse with foci at its ends that no mark may enter: errors of
/// n points fall like (2 + √3)⁻²ⁿ.
const CLEAR: f64 = 2.0;
/// Panels on one side: they grow by factors of three, from the rounding of 1 on.
const MOST: usize = 64;

impl<R: Real, const N: usize> Panels<R, N> {
    /// Nodes, as z and z − start, and weights.
    #[inline(always)]
    pub fn each(&self, visit: &mut impl FnMut(R, R, R)) {
        for side in [R::ONE, -R::ONE] {
            let end = R::ONE - side * self.start;
            let mut from = R::ZERO;
            for _ in 0..MOST {
                let rest = end - from;
                if rest <= R::ZERO {
                    break;
                }
                let clear = self.clear(side, from);
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

    /// Length of the panel from a distance on one side of the start.
    #[inline(always)]
    fn clear(&self, side: R, from: R) -> R {
        let clear = R::from_f64(CLEAR);
        let start = self.start;
        // The poles ±i are of high order and take more room.
        let mut length = R::ONE;
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
