//! Four numbers with the instructions of the target.

use super::Four;
use std::ops::{Add, Div, Mul, Neg, Sub};
use wide::f64x4;

/// Lanes whose instructions are chosen when the crate is compiled.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Portable(f64x4);

macro_rules! operations {
    ($($operator:ident $name:ident;)*) => {
        $(
            impl $operator for Portable {
                type Output = Self;
                #[inline(always)]
                fn $name(self, other: Self) -> Self {
                    Self(self.0.$name(other.0))
                }
            }
        )*
    };
}

operations! {
    Add add;
    Sub sub;
    Mul mul;
    Div div;
}

impl Neg for Portable {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self(-self.0)
    }
}

impl Four for Portable {
    #[inline(always)]
    fn new(lanes: [f64; 4]) -> Self {
        Self(f64x4::new(lanes))
    }
    #[inline(always)]
    fn splat(number: f64) -> Self {
        Self(f64x4::splat(number))
    }
    #[inline(always)]
    fn lanes(self) -> [f64; 4] {
        self.0.to_array()
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        Self(self.0.sqrt())
    }
    #[inline(always)]
    fn abs(self) -> Self {
        Self(self.0.abs())
    }
    #[inline(always)]
    fn copysign(self, other: Self) -> Self {
        let sign = f64x4::splat(-0.0);
        Self(self.0.abs() | (other.0 & sign))
    }
    #[inline(always)]
    fn less(self, other: Self) -> Self {
        Self(self.0.simd_lt(other.0))
    }
    #[inline(always)]
    fn less_or_equal(self, other: Self) -> Self {
        Self(self.0.simd_le(other.0))
    }
    #[inline(always)]
    fn equal(self, other: Self) -> Self {
        Self(self.0.simd_eq(other.0))
    }
    #[inline(always)]
    fn and(self, other: Self) -> Self {
        Self(self.0 & other.0)
    }
    #[inline(always)]
    fn and_not(self, other: Self) -> Self {
        Self(other.0.select(f64x4::splat(0.0), self.0))
    }
    #[inline(always)]
    fn or(self, other: Self) -> Self {
        Self(self.0 | other.0)
    }
    #[inline(always)]
    fn select(self, yes: Self, no: Self) -> Self {
        Self(self.0.select(yes.0, no.0))
    }
    #[inline(always)]
    fn any(self) -> bool {
        self.0.any()
    }
}
