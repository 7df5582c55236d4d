//! Lanes of the processor's vectors; every operation rounds as the scalar one does.

use super::{Group, Lanes, Numbers, Summed, even_and_odd};
use core::fmt::Debug;
use core::ops::{BitAnd, BitOr};
use wide::{bytemuck, f32x4, f32x8, f64x2, f64x4, f64x8};

/// A precision whose numbers go in lanes.
pub trait Laned: Sized {
    /// Eight of its numbers.
    type Lanes: Eight<Real = Self>;
    /// A number of a body that is written once for numbers alone and side by side.
    type Alone: Numbers<Real = Self, Array = [Self; 1], Mask = bool>;
    /// As many of them as two vectors of the least width hold.
    type SideBySide: Numbers<Real = Self>;
    /// Four of them, for sums.
    type Several: Summed<Real = Self>;

    /// The sum of aₙ uⁿ and that of bₙ uⁿ, side by side.
    fn sums<const TERMS: usize>(pairs: &[[Self; 2]; TERMS], u: Self) -> [Self; 2];

    /// The same of four sums.
    fn four_sums<const TERMS: usize>(terms: &[[Self; 4]; TERMS], u: Self) -> [Self; 4];
}

impl Laned for f64 {
    type Lanes = f64x8;
    type Alone = f64;
    type SideBySide = f64x4;
    type Several = f64x4;

    #[inline(always)]
    fn sums<const TERMS: usize>(pairs: &[[f64; 2]; TERMS], u: f64) -> [f64; 2] {
        even_and_odd::<_, TERMS>(|n| f64x2::new(pairs[n]), f64x2::splat(u)).to_array()
    }
    #[inline(always)]
    fn four_sums<const TERMS: usize>(terms: &[[f64; 4]; TERMS], u: f64) -> [f64; 4] {
        even_and_odd::<_, TERMS>(|n| f64x4::new(terms[n]), f64x4::splat(u)).to_array()
    }
}
impl Laned for f32 {
    type Lanes = f32x8;
    type Alone = f32;
    type SideBySide = f32x8;
    type Several = f32x4;

    #[inline(always)]
    fn sums<const TERMS: usize>(pairs: &[[f32; 2]; TERMS], u: f32) -> [f32; 2] {
        let term = |n: usize| {
            let [a, b] = pairs[n];
            f32x4::new([a, b, 0.0, 0.0])
        };
        let [phi, partner, ..] = even_and_odd::<_, TERMS>(term, f32x4::splat(u)).to_array();
        [phi, partner]
    }
    #[inline(always)]
    fn four_sums<const TERMS: usize>(terms: &[[f32; 4]; TERMS], u: f32) -> [f32; 4] {
        even_and_odd::<_, TERMS>(|n| f32x4::new(terms[n]), f32x4::splat(u)).to_array()
    }
}

/// Eight numbers, or a mask of ones or zeros for each.
pub trait Eight:
    Numbers<Mask = Self, Array = Group<<Self as Numbers>::Real>>
    + Debug
    + BitAnd<Output = Self>
    + BitOr<Output = Self>
{
    fn equal(self, other: Self) -> Self;
    /// The mask, a bit a lane.
    fn bits(self) -> u32;
    /// The sum of aₙ uⁿ and that of bₙ uⁿ, of the pairs (aₙ, bₙ) that each lane has.
    fn sums<const TERMS: usize>(
        pairs: Group<&[[<Self as Numbers>::Real; 2]; TERMS]>,
        u: Self,
    ) -> [Self; 2];

    #[inline(always)]
    fn above(self, other: Self) -> Self {
        other.below(self)
    }
    #[inline(always)]
    fn at_least(self, other: Self) -> Self {
        other.at_most(self)
    }
}

macro_rules! lanes {
    ($lanes:ty, $splat:expr, |$mask:ident| $all:expr) => {
        impl Lanes for $lanes {
            type Mask = Self;

            #[inline(always)]
            fn splat(value: f32) -> Self {
                $splat(value)
            }
            #[inline(always)]
            fn sqrt(self) -> Self {
                self.sqrt()
            }
            #[inline(always)]
            fn abs(self) -> Self {
                self.abs()
            }
            #[inline(always)]
            fn below(self, other: Self) -> Self {
                self.simd_lt(other)
            }
            #[inline(always)]
            fn at_most(self, other: Self) -> Self {
                self.simd_le(other)
            }
            #[inline(always)]
            fn select(mask: Self, yes: Self, no: Self) -> Self {
                <$lanes>::select(mask, yes, no)
            }
            #[inline(always)]
            fn all($mask: Self) -> bool {
                $all
            }
            // One instruction each, of the same meaning.
            #[cfg(target_feature = "sse2")]
            #[inline(always)]
            fn smaller(self, other: Self) -> Self {
                other.fast_min(self)
            }
            #[cfg(target_feature = "sse2")]
            #[inline(always)]
            fn larger(self, other: Self) -> Self {
                other.fast_max(self)
            }
            #[cfg(target_feature = "simd128")]
            #[inline(always)]
            fn smaller(self, other: Self) -> Self {
                self.fast_min(other)
            }
            #[cfg(target_feature = "simd128")]
            #[inline(always)]
            fn larger(self, other: Self) -> Self {
                self.fast_max(other)
            }
        }
    };
}
lanes!(f32x4, f32x4::splat, |mask| mask.all());
lanes!(f32x8, f32x8::splat, |mask| {
    let part: [f32x4; 2] = bytemuck::cast(mask);
    (part[0] & part[1]).all()
});
lanes!(f64x4, |value| f64x4::splat(f64::from(value)), |mask| mask
    .all());
lanes!(f64x8, |value| f64x8::splat(f64::from(value)), |mask| {
    let part: [f64x2; 4] = bytemuck::cast(mask);
    ((part[0] & part[1]) & (part[2] & part[3])).all()
});

macro_rules! eight {
    ($lanes:ty, $real:ty, $sums:path) => {
        impl Eight for $lanes {
            #[inline(always)]
            fn equal(self, other: Self) -> Self {
                self.simd_eq(other)
            }
            #[inline(always)]
            fn bits(self) -> u32 {
                self.to_bitmask()
            }
            #[inline(always)]
            fn sums<const TERMS: usize>(pairs: Group<&[[$real; 2]; TERMS]>, u: Self) -> [Self; 2] {
                $sums(pairs, u)
            }
        }
    };
}
eight!(f64x8, f64, double_sums);
eight!(f32x8, f32, single_sums);

/// Both functions of a contact lie next to each other, and those of the next contact beside them: a
/// coefficient is loaded, not gathered.
#[inline(always)]
fn double_sums<const TERMS: usize>(
    [a, b, c, d, e, f, g, h]: Group<&[[f64; 2]; TERMS]>,
    u: f64x8,
) -> [f64x8; 2] {
    let two = |[[a, b], [c, d]]: [[f64; 2]; 2]| f64x4::new([a, b, c, d]);
    let of_two = |a: &[[f64; 2]; TERMS], b: &[[f64; 2]; TERMS], u, v| {
        even_and_odd::<_, TERMS>(|n| two([a[n], b[n]]), two([[u; 2], [v; 2]])).to_array()
    };
    let u = u.to_array();
    let [p, q] = [of_two(a, b, u[0], u[1]), of_two(c, d, u[2], u[3])];
    let [r, s] = [of_two(e, f, u[4], u[5]), of_two(g, h, u[6], u[7])];
    let unzipped =
        |i: usize, j: usize| f64x8::new([p[i], p[j], q[i], q[j], r[i], r[j], s[i], s[j]]);
    [unzipped(0, 2), unzipped(1, 3)]
}

/// [`double_sums`] with four contacts side by side.
#[inline(always)]
fn single_sums<const TERMS: usize>(pairs: Group<&[[f32; 2]; TERMS]>, u: f32x8) -> [f32x8; 2] {
    let [a, b, c, d, e, f, g, h] = pairs;
    let four =
        |[[a, b], [c, d], [e, f], [g, h]]: [[f32; 2]; 4]| f32x8::new([a, b, c, d, e, f, g, h]);
    let u = u.to_array().map(|u| [u; 2]);
    let low = |n: usize| four([a[n], b[n], c[n], d[n]]);
    let high = |n: usize| four([e[n], f[n], g[n], h[n]]);
    let low = even_and_odd::<_, TERMS>(low, four([u[0], u[1], u[2], u[3]])).to_array();
    let high = even_and_odd::<_, TERMS>(high, four([u[4], u[5], u[6], u[7]])).to_array();
    let [p, q] = [low, high];
    [
        f32x8::new([p[0], p[2], p[4], p[6], q[0], q[2], q[4], q[6]]),
        f32x8::new([p[1], p[3], p[5], p[7], q[1], q[3], q[5], q[7]]),
    ]
}
