//! Scalars, twists and special functions.

use super::{Keeper, keep};
use nalgebra::Vector3;
use tribos_core::Real;
use tribos_core::special::{CompleteElliptic, Gauss};
use tribos_core::twist::{Twist, Wrench};

/// Functions of both precisions.
pub fn all<R: Real>(keeper: &mut impl Keeper) {
    elementary::<R>(keeper);
    keep!(keeper:
        Twist::<R>::new,
        Twist::<R>::speed,
        <Twist<R> as From<Vector3<R>>>::from,
        <Vector3<R> as From<Wrench<R>>>::from,
        <Wrench<R> as From<Vector3<R>>>::from,
        <Vector3<R> as From<Twist<R>>>::from,
        CompleteElliptic::<R>::new,
        CompleteElliptic::<R>::k,
        CompleteElliptic::<R>::e,
    );
}

fn elementary<R: Real>(keeper: &mut impl Keeper) {
    keep!(keeper:
        <R as Real>::from_f64,
        <R as Real>::to_f64,
        <R as Real>::abs,
        <R as Real>::copysign,
        <R as Real>::sqrt,
        <R as Real>::pow,
        <R as Real>::exp,
        <R as Real>::exp_m1,
        <R as Real>::ln,
        <R as Real>::ln_1p,
        <R as Real>::sin,
        <R as Real>::cos,
        <R as Real>::asin,
        <R as Real>::atan,
        <R as Real>::asinh,
        <R as Real>::is_finite,
        <R as Real>::is_nan,
        <R as Real>::half_octave,
        <R as Real>::hypot,
    );
}

/// Gauss' function works in f64.
pub fn gauss(keeper: &mut impl Keeper) {
    keep!(keeper:
        Gauss::new,
        Gauss::at,
        Gauss::series,
        Gauss::series_coefficients::<20>,
        Gauss::taylor::<20>,
    );
}
