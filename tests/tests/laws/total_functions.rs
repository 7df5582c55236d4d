//! No argument makes the kernel panic or lie: NaN, infinities, random bits.

use tribos_core::coupling::{ReducedJacobian, ReducedWrench};
use tribos_core::real::Real;
use tribos_tests::reference::Reference;
use tribos_tests::sweep::{Lcg, special_f64};
use tribos_tests::tiers::{self, Tabulated};
use tribos_tests::tolerance;

const EXPONENTS: [f64; 8] = [-0.9, -0.5, 0.0, 0.25, 0.5, 1.0, 1.5, 3.0];

fn wrench<R: Real>(w: ReducedWrench<R>) -> [f64; 2] {
    [w.force, w.torque].map(R::to_f64)
}

fn jacobian<R: Real>(j: ReducedJacobian<R>) -> [f64; 4] {
    [j.force_per_slide, j.force_slide, j.mixed, j.torque_rim].map(R::to_f64)
}

/// NaN in either argument, whatever the other is.
fn assert_nan_goes_through<R: Tabulated>() {
    for alpha in EXPONENTS {
        for (name, tier) in tiers::all::<R>(alpha) {
            for other in special_f64() {
                let (nan, other) = (R::from_f64(f64::NAN), R::from_f64(other));
                for (slide, rim) in [(nan, other), (other, nan)] {
                    let w = wrench(tier.reduced_wrench(slide, rim));
                    let j = jacobian(tier.reduced_jacobian(slide, rim));
                    let all = w.iter().chain(&j).all(|x| x.is_nan());
                    assert!(
                        all,
                        "{name}, alpha {alpha}: ({slide:?}, {rim:?}) gives {w:?}, {j:?}"
                    );
                }
            }
        }
    }
}

#[test]
fn nan_is_never_laundered() {
    assert_nan_goes_through::<f64>();
    assert_nan_goes_through::<f32>();
}

#[test]
fn two_infinite_speeds_have_no_ratio() {
    for alpha in EXPONENTS {
        for (name, tier) in tiers::all::<f64>(alpha) {
            let got = wrench(tier.reduced_wrench(f64::INFINITY, -f64::INFINITY));
            assert!(
                got.iter().all(|x| x.is_nan()),
                "{name}, alpha {alpha}: {got:?}"
            );
        }
    }
}

/// Table 3.1 as one speed grows without bound and the other stays `minor`; what depends on more
/// than the ratio may be NaN, but never a wrong number.
fn limit_of_wrench(alpha: f64, minor: f64, sliding_leads: bool) -> [f64; 2] {
    let power = |exponent: f64| match exponent {
        0.0 => 1.0,
        e if e > 0.0 => f64::INFINITY,
        _ => 0.0,
    };
    let (lead, trail) = if sliding_leads {
        (1.0, (1.0 + alpha) / 4.0)
    } else {
        (2.0 / (3.0 + alpha), 1.0)
    };
    let trailing = if minor == 0.0 {
        0.0
    } else {
        trail * minor * power(alpha - 1.0)
    };
    if sliding_leads {
        [lead * power(alpha), trailing]
    } else {
        [trailing, lead * power(alpha)]
    }
}

#[test]
fn one_infinite_speed_gives_the_limit_or_nan() {
    for alpha in EXPONENTS {
        for (name, tier) in tiers::all::<f64>(alpha) {
            for (minor, sliding_leads) in [(0.0, true), (0.0, false), (1.0, true), (1.0, false)] {
                let (slide, rim) = if sliding_leads {
                    (f64::INFINITY, minor)
                } else {
                    (minor, f64::INFINITY)
                };
                let wanted = limit_of_wrench(alpha, minor, sliding_leads);
                let got = wrench(tier.reduced_wrench(slide, rim));
                for (w, g) in wanted.iter().zip(&got) {
                    let close = w == g || (w - g).abs() < tolerance::ROUNDING.limit;
                    // Closed forms of Coulomb's law know the limit.
                    let excused = g.is_nan() && (alpha != 0.0 || name == "quadrature");
                    assert!(
                        close || excused,
                        "{name}, alpha {alpha}: ({slide}, {rim}) gives {got:?}, limit {wanted:?}"
                    );
                }
            }
        }
    }
}

/// Calls every tier with random bit patterns: no panic. `checked` judges the finite ones.
fn assert_random_bits<R: Tabulated>(
    from_bits: impl Fn(u64) -> R,
    checked: impl Fn([f64; 2], [f64; 4]) -> bool,
    tiers_of: impl Fn(f64) -> Vec<tiers::Tier<R>>,
) {
    let mut rng = Lcg::new(13);
    let (mut misses, mut example) = (0, String::new());
    for alpha in EXPONENTS {
        for (name, tier) in tiers_of(alpha) {
            for _ in 0..2000 {
                let (slide, rim) = (from_bits(rng.bits()), from_bits(rng.bits()));
                let w = wrench(tier.reduced_wrench(slide, rim));
                let j = jacobian(tier.reduced_jacobian(slide, rim));
                if slide.is_finite() && rim.is_finite() && !checked(w, j) {
                    misses += 1;
                    example =
                        format!("{name}, alpha {alpha}: ({slide:?}, {rim:?}) gives {w:?}, {j:?}");
                }
            }
        }
    }
    assert_eq!(misses, 0, "the last: {example}");
}

#[test]
fn random_bits_never_panic() {
    assert_random_bits(f64::from_bits, |_, _| true, tiers::all);
    assert_random_bits(
        |bits| f32::from_bits((bits >> 32) as u32),
        |_, _| true,
        tiers::all,
    );
}

#[test]
fn finite_speeds_give_forces_that_are_numbers_and_not_negative() {
    let fine = |w: [f64; 2], _: [f64; 4]| w.iter().all(|&x| x >= 0.0);
    assert_random_bits(f64::from_bits, fine, tiers::exact);
    assert_random_bits(
        |bits| f32::from_bits((bits >> 32) as u32),
        fine,
        tiers::exact,
    );
}

#[test]
fn finite_speeds_give_derivatives_that_are_numbers() {
    let fine = |_: [f64; 2], j: [f64; 4]| j.iter().all(|x| !x.is_nan());
    assert_random_bits(f64::from_bits, fine, tiers::exact);
    assert_random_bits(
        |bits| f32::from_bits((bits >> 32) as u32),
        fine,
        tiers::exact,
    );
}

#[test]
fn quadrature_works_wherever_the_power_of_friction_is_in_range() {
    let mut rng = Lcg::new(19);
    for alpha in [-0.5, 0.0, 0.5, 1.0, 1.5, 3.0] {
        let (_, quadrature) = tiers::all::<f64>(alpha).pop().expect("the last tier");
        let (_, exact) = tiers::exact::<f64>(alpha).pop().expect("the last tier");
        for _ in 0..2000 {
            let (slide, rim) = (rng.log_between(1e-60, 1e60), rng.log_between(1e-60, 1e60));
            let wanted = wrench(exact.reduced_wrench(slide, rim));
            let got = wrench(quadrature.reduced_wrench(slide, rim));
            for (wanted, got) in wanted.into_iter().zip(got) {
                let error = Reference::exact(wanted).relative(got);
                let place = format!("alpha {alpha}: ({slide:e}, {rim:e}): {error:e}");
                assert!(error <= tolerance::QUADRATURE_FALLING.limit, "{place}");
            }
        }
    }
}
