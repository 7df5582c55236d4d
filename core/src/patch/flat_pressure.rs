//! Pressure on patches with straight edges.

use crate::real::Real;

/// Pressure that is the same everywhere on a patch.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct UniformPressure;

/// Pressure that changes linearly along a patch.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct LinearPressure<R> {
    at_centre: R,
    slope: [R; 2],
}

impl<R: Real> LinearPressure<R> {
    /// Pressure at the centre of pressure and its slope, of the mean pressure (and over the radius).
    #[doc(hidden)]
    #[inline(always)]
    pub fn new(at_centre: R, slope: [R; 2]) -> Self {
        Self { at_centre, slope }
    }
}

mod sealed {
    pub trait Sealed {}
    impl Sealed for super::UniformPressure {}
    impl<R> Sealed for super::LinearPressure<R> {}
}

/// How pressure is spread over a patch with straight edges: [`UniformPressure`] or [`LinearPressure`].
///
/// A patch under uniform pressure carries no code or number of a linear one.
pub trait PressureField<R: Real>: Copy + sealed::Sealed {
    /// True if there may be a slope.
    #[doc(hidden)]
    const IS_LINEAR: bool;

    /// Pressure at the centre of pressure, of the mean pressure.
    #[doc(hidden)]
    fn at_centre(&self) -> R;

    /// Slope of the pressure, of the mean pressure over the radius.
    #[doc(hidden)]
    fn slope(&self) -> [R; 2];

    /// That of another patch with this pressure at its centre and this slope, if there may be one.
    #[doc(hidden)]
    fn of_piece(at_centre: R, slope: [R; 2]) -> Self;
}

impl<R: Real> PressureField<R> for UniformPressure {
    const IS_LINEAR: bool = false;
    #[inline(always)]
    fn at_centre(&self) -> R {
        R::ONE
    }
    #[inline(always)]
    fn slope(&self) -> [R; 2] {
        [R::ZERO; 2]
    }
    #[inline(always)]
    fn of_piece(_: R, _: [R; 2]) -> Self {
        Self
    }
}

impl<R: Real> PressureField<R> for LinearPressure<R> {
    const IS_LINEAR: bool = true;
    #[inline(always)]
    fn at_centre(&self) -> R {
        self.at_centre
    }
    #[inline(always)]
    fn slope(&self) -> [R; 2] {
        self.slope
    }
    #[inline(always)]
    fn of_piece(at_centre: R, slope: [R; 2]) -> Self {
        Self::new(at_centre, slope)
    }
}
