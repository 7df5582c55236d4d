//! The fitted forms of Coulomb friction in lanes.

use super::speeds::LaneSpeeds;
use super::{LaneProfile, Lanes};
use crate::coupling::SmoothProfile;
use crate::coupling::coulomb::{Fitted, sums};
use crate::coupling::pressure_family::moment;
use crate::lanes::{Eight, Lanes as _, even_and_odd};
use crate::real::{InEach, Real};
use crate::special::log_part;
use core::marker::PhantomData;

/// P, Q, R and S. Where both sides have the same terms, contacts lie side by side; else the four sums of each
/// contact do, and its lane chooses the terms.
#[inline(always)]
fn all_sums<F: Fitted, R: Real>(slides: Lanes<R>, argument: Lanes<R>) -> [Lanes<R>; 4] {
    struct AllSums<F>(PhantomData<F>);
    impl<F: Fitted> InEach for AllSums<F> {
        type Input<R: Real> = Lanes<R>;
        type Output<R: Real> = [Lanes<R>; 4];
        #[inline(always)]
        fn single(argument: Lanes<f32>) -> [Lanes<f32>; 4] {
            abreast(F::SINGLE[0], argument)
        }
        #[inline(always)]
        fn double(argument: Lanes<f64>) -> [Lanes<f64>; 4] {
            abreast(F::DOUBLE[0], argument)
        }
    }
    if F::IS_ONE_SIDED {
        return R::in_own::<AllSums<F>>(argument);
    }
    let mut slides = slides.bits();
    let found = argument.to_array().map(|argument| {
        let found = sums::<F, R>(slides & 1 == 1, argument);
        slides >>= 1;
        found
    });
    [
        Eight::new(found.map(|[p, _, _, _]| p)),
        Eight::new(found.map(|[_, q, _, _]| q)),
        Eight::new(found.map(|[_, _, r, _]| r)),
        Eight::new(found.map(|[_, _, _, s]| s)),
    ]
}

/// The four sums of the same terms in every lane.
#[inline(always)]
fn abreast<R: Real, const TERMS: usize>(
    terms: &[[R; 4]; TERMS],
    argument: Lanes<R>,
) -> [Lanes<R>; 4] {
    [0, 1, 2, 3].map(|i: usize| even_and_odd::<_, TERMS>(|n| Eight::repeat(terms[n][i]), argument))
}

/// Φ and Φ' at z; `slides` is a mask.
#[inline(always)]
pub fn forces_and_slopes<F: Fitted, R: Real>(slides: Lanes<R>, z: Lanes<R>) -> [Lanes<R>; 2] {
    let repeat = Lanes::<R>::repeat;
    if F::HAS_ROOTS {
        let u = z.sqrt() - repeat(R::HALF);
        let [p, q, r, s] = all_sums::<F, R>(slides, u * u);
        return [p + u * q, r + u * s];
    }
    let [p, q, r, s] = all_sums::<F, R>(slides, z);
    let positive = repeat(R::MIN_POSITIVE).larger(z);
    let log = log_part(positive, positive.octave(), repeat);
    match F::TWICE_POWER {
        0 => {
            let end = repeat(R::ZERO) - s * repeat(R::INFINITY);
            let slope = Lanes::<R>::select(z.equal(repeat(R::ZERO)), end, r + log * s);
            [p + z * log * q, slope]
        }
        2 => [p + z * (z * log) * q, r + z * log * s],
        _ => [p + z * z * (z * log) * q, r + z * (z * log) * s],
    }
}

/// zΦ', from Φ'.
#[inline(always)]
fn times_complement<R: Real>(z: Lanes<R>, slope: Lanes<R>) -> Lanes<R> {
    let none = Lanes::<R>::repeat(R::ZERO);
    Lanes::<R>::select(z.equal(none), none, z * slope)
}

impl<R: Real, F: Fitted + SmoothProfile<R>> LaneProfile<R> for F {
    #[inline(always)]
    fn drags(&self, slide_sq: Lanes<R>, rim: Lanes<R>) -> Option<[Lanes<R>; 2]> {
        let [none, half, one] = [R::ZERO, R::HALF, R::ONE].map(Lanes::<R>::repeat);
        let rim_sq = rim * rim;
        let (major, minor) = (slide_sq.larger(rim_sq), slide_sq.smaller(rim_sq));
        let per_major = one / major;
        let (x, z) = (minor * per_major, (major - minor) * per_major);
        let slides = slide_sq.above(rim_sq);
        let [phi, slope] = forces_and_slopes::<F, R>(slides, z);
        let inv_n = R::ONE / moment(R::from_f64(F::PRESSURE.order()), R::ZERO);
        let inv_n = Lanes::<R>::repeat(inv_n);
        let theta = inv_n * (half * phi + times_complement::<R>(z, slope));
        let turns = Lanes::<R>::select(slides, none, inv_n * z);
        let part = Lanes::<R>::select(slides, one, x);
        let per_speed = per_major.sqrt();
        Some([
            per_speed * phi,
            rim * (per_speed * (turns * phi + part * theta)),
        ])
    }

    #[inline(always)]
    fn drags_and_torques(&self, at: &LaneSpeeds<R>) -> Option<[Lanes<R>; 2]> {
        let [phi, _, chi] = self.factors_and_slopes(at)?;
        Some([phi, at.rim() * chi])
    }

    #[inline(always)]
    fn factors_and_slopes(&self, at: &LaneSpeeds<R>) -> Option<[Lanes<R>; 3]> {
        let one = Lanes::<R>::repeat(R::ONE);
        // Sliding leads where a scalar says so: not where h was rounded to 1.
        let slides = at.slides & one.above(at.ratio);
        let z = at.complement();
        let [phi, slope] = forces_and_slopes::<F, R>(slides, z);
        let inv_n = R::ONE / moment(R::from_f64(F::PRESSURE.order()), R::ZERO);
        let inv_n = Lanes::<R>::repeat(inv_n);
        let half = Lanes::<R>::repeat(R::HALF);
        let theta = inv_n * (half * phi + times_complement::<R>(z, slope));
        let x = at.ratio * at.ratio;
        let chi = Lanes::<R>::select(slides, theta, inv_n * z * phi + x * theta);
        Some([phi, slope, chi])
    }

    #[inline(always)]
    fn speed_scales(&self, _: Lanes<R>) -> Option<Lanes<R>> {
        Some(Eight::repeat(R::ONE))
    }

    #[inline(always)]
    fn rate_scales(&self, speed: Lanes<R>) -> Option<Lanes<R>> {
        Some(Lanes::<R>::repeat(R::ONE) / speed)
    }
}
