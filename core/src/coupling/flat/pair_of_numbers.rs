//! Two numbers at once, which processors with vectors add and divide in the time of one.

use crate::real::Real;
use core::ops::{Add, Mul, Sub};

/// Two numbers; every operation is that of the scalars.
#[derive(Clone, Copy)]
pub(super) struct Pair2<R>(pub(super) [R; 2]);

impl<R: Real> Pair2<R> {
    #[inline(always)]
    pub(super) fn of(both: R) -> Self {
        Self([both; 2])
    }

    #[inline(always)]
    pub(super) fn sqrt(self) -> Self {
        let Self([a, b]) = self;
        Self([a.sqrt(), b.sqrt()])
    }

    #[inline(always)]
    pub(super) fn inverse(self) -> Self {
        let Self([a, b]) = self;
        Self([R::ONE / a, R::ONE / b])
    }

    #[inline(always)]
    pub(super) fn sum(self) -> R {
        let Self([a, b]) = self;
        a + b
    }
}

impl<R: Real> Add for Pair2<R> {
    type Output = Self;
    #[inline(always)]
    fn add(self, Self([c, d]): Self) -> Self {
        let Self([a, b]) = self;
        Self([a + c, b + d])
    }
}

impl<R: Real> Sub for Pair2<R> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, Self([c, d]): Self) -> Self {
        let Self([a, b]) = self;
        Self([a - c, b - d])
    }
}

impl<R: Real> Mul for Pair2<R> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, Self([c, d]): Self) -> Self {
        let Self([a, b]) = self;
        Self([a * c, b * d])
    }
}
