//! The fitted form, of numbers alone or side by side.

use super::super::pressure_family::moment;
use super::terms::DISK_SLOPE_ROUGH;
use crate::lanes::{Laned, Numbers, even_and_odd};
use crate::patch::PowerPressure;
use crate::real::{InEach, Real, Sealed as _};
use crate::special::log_part;

/// Rows of the regular parts P of two functions and of their singular parts Q, where spinning and where sliding leads.
type Sides<R, const TERMS: usize> = [&'static [[R; 4]; TERMS]; 2];

/// Terms of Φ and a second function in both precisions.
#[derive(Clone, Copy)]
pub(crate) struct Terms<const SINGLE: usize, const DOUBLE: usize> {
    pub single: Sides<f32, SINGLE>,
    pub double: Sides<f64, DOUBLE>,
}

/// Fitted terms for programs in other languages: rows from the constant term on, of the regular parts of two functions
/// and of their singular parts, where spinning leads and where sliding does.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct FittedRows {
    /// In f32.
    pub single: [&'static [[f32; 4]]; 2],
    /// In f64.
    pub double: [&'static [[f64; 4]]; 2],
}

/// A pressure with its fitted terms.
pub(crate) trait Fitted: Copy {
    const PRESSURE: PowerPressure;
    /// Φ and Φ'.
    const SLOPE: Terms<6, 12>;

    /// Sums of Φ and Χ where spinning leads and, unless the pressure is mirrored, where sliding does; Θ in the place
    /// of Χ where one function serves both sides.
    fn torque_sums<L: Numbers<Real: Real>>(slides: L::Mask, argument: L) -> [L; 4];

    /// One function serves both sides.
    const IS_ONE_SIDED: bool = Self::PRESSURE.order() == 0.0;
    /// q is not whole: powers of √z stand in for the logarithm.
    const HAS_ROOTS: bool = Self::PRESSURE.order() % 1.0 != 0.0;
    /// The power of z that multiplies ln z in the singular part of Φ': q + 1 for whole q.
    const SLOPE_POWER: u32 = (Self::PRESSURE.order() + 1.0) as u32;
    /// Φ' is infinite at z = 0, as a ring's is.
    const IS_ENDLESS: bool = !Self::HAS_ROOTS && Self::SLOPE_POWER == 0;
    /// Sliding and spinning change places with Φ and Χ, as for a ring.
    const IS_MIRRORED: bool = Self::PRESSURE.order() == -1.0;
}

/// q of the pressure.
#[inline]
pub(super) fn order<F: Fitted, R: Real>() -> R {
    R::from_f64(F::PRESSURE.order())
}

/// 1/n = T/F' of spinning alone.
#[inline(always)]
fn inv_moment<F: Fitted, L: Numbers<Real: Real>>() -> L {
    L::repeat(L::Real::ONE / moment(order::<F, L::Real>(), L::Real::ZERO))
}

impl<const SINGLE: usize, const DOUBLE: usize> Terms<SINGLE, DOUBLE> {
    pub(super) const fn rows(self) -> FittedRows {
        let ([a, b], [c, d]) = (self.single, self.double);
        FittedRows {
            single: [a, b],
            double: [c, d],
        }
    }

    /// The four sums of one number.
    #[inline(always)]
    fn alone<R: Real>(self, slides: bool, u: R) -> [R; 4] {
        struct Alone<const SINGLE: usize, const DOUBLE: usize>;
        impl<const SINGLE: usize, const DOUBLE: usize> InEach for Alone<SINGLE, DOUBLE> {
            type Input<R: Real> = (Terms<SINGLE, DOUBLE>, bool, R);
            type Output<R: Real> = [R; 4];
            #[inline(always)]
            fn single((terms, slides, u): Self::Input<f32>) -> [f32; 4] {
                let [spinning, sliding] = terms.single;
                Laned::four_sums(if slides { sliding } else { spinning }, u)
            }
            #[inline(always)]
            fn double((terms, slides, u): Self::Input<f64>) -> [f64; 4] {
                let [spinning, sliding] = terms.double;
                Laned::four_sums(if slides { sliding } else { spinning }, u)
            }
        }
        R::in_own::<Alone<SINGLE, DOUBLE>>((self, slides, u))
    }

    /// The four sums. Numbers side by side are computed together where both sides have the same terms, else each with
    /// its own.
    #[inline(always)]
    pub(super) fn sums<L: Numbers<Real: Real>>(self, slides: L::Mask, u: L) -> [L; 4] {
        let (arguments, [spinning, sliding]) = (u.to_array(), self.double);
        if core::ptr::eq(spinning, sliding) && arguments.as_ref().len() > 1 {
            return if L::Real::IS_SINGLE {
                abreast::<L, SINGLE>(|n, sum| f64::from(self.single[0][n][sum]), u)
            } else {
                abreast::<L, DOUBLE>(|n, sum| self.double[0][n][sum], u)
            };
        }
        let leads = L::select(slides, L::splat(1.0), L::splat(0.0)).to_array();
        let mut found = [arguments; 4];
        let [p, q, r, s] = found.each_mut().map(AsMut::as_mut);
        let lanes = p.iter_mut().zip(q).zip(r.iter_mut().zip(s));
        let given = leads.as_ref().iter().zip(arguments.as_ref());
        for (((p, q), (r, s)), (leads, u)) in lanes.zip(given) {
            [*p, *q, *r, *s] = self.alone(*leads > L::Real::ZERO, *u);
        }
        found.map(L::new)
    }
}

/// Four sums of the same terms in every lane.
#[inline(always)]
fn abreast<L: Numbers, const TERMS: usize>(term: impl Fn(usize, usize) -> f64, u: L) -> [L; 4] {
    // One after the other: a mapped array would call a function for each.
    let sum = |sum| even_and_odd::<_, TERMS>(|n| L::constant(term(n, sum)), u);
    [sum(0), sum(1), sum(2), sum(3)]
}

/// Argument of the sums, and what multiplies the singular parts of Φ and Χ, and that of Φ'.
#[inline(always)]
fn argument_and_hooks<F: Fitted, L: Numbers<Real: Real>>(z: L) -> [L; 3] {
    let half = L::splat(0.5);
    if F::HAS_ROOTS {
        let u = z.sqrt() - half;
        return [u * u, u, u];
    }
    // Below the least normal number the products count as nothing.
    let positive = L::repeat(L::Real::MIN_POSITIVE).larger(z);
    let log = log_part(positive, positive.octaves(), L::repeat);
    let hook = match F::SLOPE_POWER {
        0 => log,
        1 => z * log,
        _ => z * (z * log),
    };
    [z - half, z * hook, hook]
}

/// Φ and Χ = T/w at z; sliding leads where `slides`.
#[inline(always)]
pub(crate) fn force_and_torque<F: Fitted, L: Numbers<Real: Real>>(slides: L::Mask, z: L) -> [L; 2] {
    let [argument, hook, _] = argument_and_hooks::<F, L>(z);
    let [p, of_torque, q, q_of_torque] = F::torque_sums(slides, argument);
    let [phi, chi] = [p + hook * q, of_torque + hook * q_of_torque];
    if F::IS_ONE_SIDED {
        // Χ = Θ where sliding leads, Θ + z (Φ/n − Θ) where spinning does.
        let turns = L::select(slides, L::splat(0.0), z);
        return [phi, chi + turns * (inv_moment::<F, L>() * phi - chi)];
    }
    if F::IS_MIRRORED {
        return [L::select(slides, chi, phi), L::select(slides, phi, chi)];
    }
    [phi, chi]
}

/// Φ and Φ' at z in [0, 1]; a ring's Φ' is infinite at z = 0. NaN for NaN.
#[inline(always)]
pub(super) fn force_and_slope<F: Fitted, L: Numbers<Real: Real>>(slides: L::Mask, z: L) -> [L; 2] {
    joined::<F, L>(z, |argument| F::SLOPE.sums(slides, argument))
}

/// The disk's Φ and Φ' in half of the digits of f64.
#[inline(always)]
pub(super) fn rough_force_and_slope<F: Fitted, L: Numbers<Real: Real>>(z: L) -> [L; 2] {
    joined::<F, L>(z, |argument| {
        abreast::<L, 6>(|n, sum| DISK_SLOPE_ROUGH[n][sum], argument)
    })
}

#[inline(always)]
fn joined<F: Fitted, L: Numbers<Real: Real>>(z: L, sums: impl Fn(L) -> [L; 4]) -> [L; 2] {
    let [argument, hook, slope_hook] = argument_and_hooks::<F, L>(z);
    // The slope of a ring grows without bound: what multiplies ln z ends exactly.
    let [p, r, q, s] = sums(if F::IS_ENDLESS { z } else { argument });
    let (phi, slope) = (p + hook * q, r + slope_hook * s);
    if !F::IS_ENDLESS {
        return [phi, slope];
    }
    let none = L::splat(0.0);
    let end = none - s * L::repeat(L::Real::INFINITY);
    [phi, L::select(z.abs().at_most(none), end, slope)]
}

/// Χ from Φ and Φ', with Θ = (Φ/2 + zΦ')/n: Θ where sliding leads, zΦ/n + xΘ where spinning does.
#[inline(always)]
pub(crate) fn torque_of_slope<F: Fitted, L: Numbers<Real: Real>>(
    slides: L::Mask,
    [x, z]: [L; 2],
    [phi, slope]: [L; 2],
) -> L {
    let (none, inv_n) = (L::splat(0.0), inv_moment::<F, L>());
    // The slope's singularity is weaker than 1/z.
    let z_slope = L::select(z.abs().at_most(none), none, z * slope);
    let theta = inv_n * (L::splat(0.5) * phi + z_slope);
    L::select(slides, theta, inv_n * z * phi + x * theta)
}

/// Φ, Φ' and Χ.
#[inline(always)]
pub(crate) fn factors_and_slope<F: Fitted, L: Numbers<Real: Real>>(
    slides: L::Mask,
    [x, z]: [L; 2],
) -> [L; 3] {
    let [phi, slope] = force_and_slope::<F, L>(slides, z);
    let chi = torque_of_slope::<F, L>(slides, [x, z], [phi, slope]);
    [phi, slope, chi]
}

/// F/v and T for v² and w.
#[inline(always)]
pub(crate) fn drag<F: Fitted, L: Numbers<Real: Real>>(slide_sq: L, rim: L) -> [L; 2] {
    let rim_sq = rim * rim;
    let (major, minor) = (slide_sq.larger(rim_sq), slide_sq.smaller(rim_sq));
    let per_major = L::splat(1.0) / major;
    let z = (major - minor) * per_major;
    let [phi, chi] = force_and_torque::<F, L>(rim_sq.below(slide_sq), z);
    let per_speed = per_major.sqrt();
    let rim_part = L::select(rim_sq.below(slide_sq), rim * per_speed, L::splat(1.0));
    [per_speed * phi, rim_part * chi]
}

/// Numbers that stand alone.
#[inline(always)]
pub(super) fn numbers<R: Real, const COUNT: usize>(parts: [R::Alone; COUNT]) -> [R; COUNT] {
    parts.map(|part| {
        let [number] = part.to_array();
        number
    })
}
