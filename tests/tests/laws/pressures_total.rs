//! No argument makes the couplings of pressures panic or lie: NaN, infinities, the ends of the
//! range, random bits.

use tribos_core::coupling::round::LateralPolynomialTable;
use tribos_core::coupling::{Annulus, LateralFriction, table};
use tribos_core::patch::PolynomialPressure;
use tribos_core::real::Real;
use tribos_tests::patches::{self, PatchTier, RoundTabulated};
use tribos_tests::sweep::{Lcg, special_f64};
use tribos_tests::tolerance;

const ORDERS: [f64; 7] = [-1.0, -0.9, -0.5, 0.0, 0.5, 1.0, 6.0];
const EXPONENTS: [f64; 8] = [-0.9, -0.5, 0.0, 0.25, 0.5, 1.0, 1.5, 3.0];

/// F, T, G and the entries of both Jacobians.
fn all<R: Real>(tier: &dyn LateralFriction<R>, slide: R, rim: R) -> [f64; 9] {
    let w = tier.reduced_wrench(slide, rim);
    let j = tier.reduced_jacobian(slide, rim);
    let l = tier.lateral_jacobian(slide, rim);
    [
        w.force,
        w.torque,
        tier.lateral(slide, rim),
        l.slide,
        l.rim,
        j.force_per_slide,
        j.force_slide,
        j.mixed,
        j.torque_rim,
    ]
    .map(R::to_f64)
}

/// Every tier of every pressure (1−r²)^q.
fn visit<R: RoundTabulated>(mut check: impl FnMut(&PatchTier<R>, f64, f64)) {
    for alpha in EXPONENTS {
        for order in ORDERS {
            for tier in patches::tiers::<R>(order, alpha) {
                check(&tier, order, alpha);
            }
        }
    }
}

/// Every annulus, with its disk and inner ratio.
fn visit_annuli<R: RoundTabulated>(
    mut check: impl FnMut(&PatchTier<R>, &dyn LateralFriction<R>, f64, f64),
) {
    for alpha in EXPONENTS {
        for inner in [0.0, 0.5, 0.999] {
            for ((name, disk), (_, again)) in patches::disks::<R>(alpha)
                .into_iter()
                .zip(patches::disks(alpha))
            {
                let band = Annulus::new(BoxedTier(disk), R::from_f64(inner));
                let band: PatchTier<R> = (name, Box::new(band.expect("in range")));
                check(&band, again.as_ref(), inner, alpha);
            }
        }
    }
}

/// A boxed tier as a coupling of its own.
struct BoxedTier<R>(Box<dyn LateralFriction<R>>);

impl<R: Real> tribos_core::coupling::ReducedFriction<R> for BoxedTier<R> {
    fn reduced_wrench(&self, slide: R, rim: R) -> tribos_core::coupling::ReducedWrench<R> {
        self.0.reduced_wrench(slide, rim)
    }
    fn reduced_jacobian(&self, slide: R, rim: R) -> tribos_core::coupling::ReducedJacobian<R> {
        self.0.reduced_jacobian(slide, rim)
    }
}

impl<R: Real> LateralFriction<R> for BoxedTier<R> {
    fn lateral(&self, slide: R, rim: R) -> R {
        self.0.lateral(slide, rim)
    }
    fn lateral_jacobian(&self, slide: R, rim: R) -> tribos_core::internals::LateralJacobian<R> {
        self.0.lateral_jacobian(slide, rim)
    }
    fn mean_square_radius(&self) -> R {
        self.0.mean_square_radius()
    }
}

/// A polynomial pressure's table.
fn polynomial(alpha: f64) -> PatchTier<f64> {
    let pressure = PolynomialPressure::new([0.2, 1.0, -0.5]).expect("positive");
    let table = LateralPolynomialTable::new(alpha, &pressure).expect("in range");
    ("polynomial", Box::new(table))
}

/// All misses by name, at most twenty of them.
#[derive(Default)]
struct Misses(Vec<String>);

impl Misses {
    fn expect(&mut self, is_fine: bool, place: impl FnOnce() -> String) {
        if !is_fine {
            self.0.push(place());
        }
    }
}

impl Drop for Misses {
    fn drop(&mut self) {
        let shown: Vec<_> = self.0.iter().take(400).cloned().collect();
        assert!(
            self.0.is_empty(),
            "{} misses\n{}",
            self.0.len(),
            shown.join("\n")
        );
    }
}

fn assert_nan_goes_through<R: RoundTabulated>() {
    let mut misses = Misses::default();
    visit::<R>(|(name, tier), order, alpha| {
        for other in special_f64() {
            let (nan, other) = (R::from_f64(f64::NAN), R::from_f64(other));
            for (slide, rim) in [(nan, other), (other, nan)] {
                let got = all(tier.as_ref(), slide, rim);
                misses.expect(got.iter().all(|x| x.is_nan()), || {
                    format!("{name}, q {order}, alpha {alpha}: ({slide:?}, {rim:?}) gives {got:?}")
                });
            }
        }
    });
}

#[test]
fn nan_is_never_laundered() {
    assert_nan_goes_through::<f64>();
    for alpha in EXPONENTS {
        let (_, tier) = polynomial(alpha);
        for other in special_f64() {
            for (slide, rim) in [(f64::NAN, other), (other, f64::NAN)] {
                assert!(all(tier.as_ref(), slide, rim).iter().all(|x| x.is_nan()));
            }
        }
    }
}

#[test]
fn nan_is_never_laundered_in_single_precision() {
    assert_nan_goes_through::<f32>();
}

#[test]
fn two_infinite_speeds_have_no_ratio() {
    let mut misses = Misses::default();
    visit::<f64>(|(name, tier), order, alpha| {
        let got = all(tier.as_ref(), f64::INFINITY, -f64::INFINITY);
        misses.expect(got.iter().all(|x| x.is_nan()), || {
            format!("{name}, q {order}, alpha {alpha}: {got:?}")
        });
    });
}

#[test]
fn one_infinite_speed_gives_coulombs_limit_and_no_jacobian() {
    let mut misses = Misses::default();
    visit::<f64>(|(name, tier), order, alpha| {
        for minor in [0.0, 1e-300, 1.0, 1e300] {
            for (slide, rim) in [(f64::INFINITY, minor), (minor, f64::INFINITY)] {
                let got = all(tier.as_ref(), slide, rim);
                let place =
                    || format!("{name}, q {order}, alpha {alpha}: ({slide}, {rim}) gives {got:?}");
                misses.expect(got[5..].iter().all(|x| x.is_nan()), place);
                if alpha != 0.0 {
                    continue;
                }
                let far = if slide > rim {
                    all(tier.as_ref(), 1.0, 0.0)
                } else {
                    all(tier.as_ref(), 0.0, 1.0)
                };
                let close = |a: f64, b: f64| (a - b).abs() <= tolerance::ROUNDING.limit;
                misses.expect((0..3).all(|n| close(got[n], far[n])), place);
            }
        }
    });
}

#[test]
fn a_patch_at_rest_feels_no_friction_and_its_damping_is_the_limit() {
    let mut misses = Misses::default();
    visit::<f64>(|(name, tier), order, alpha| {
        for (slide, rim) in [(0.0, 0.0), (-0.0, 0.0), (0.0, -0.0)] {
            let got = all(tier.as_ref(), slide, rim);
            let place = || format!("{name}, q {order}, alpha {alpha}: {got:?}");
            misses.expect(got[..5].iter().all(|x| *x == 0.0), place);
            let [drag, force, mixed, torque] = [got[5], got[6], got[7], got[8]];
            let r_sq = tier.mean_square_radius();
            let fine = match alpha {
                1.0 => {
                    drag == 1.0
                        && force == 1.0
                        && (torque - r_sq).abs() <= tolerance::ROUNDING.limit
                }
                a if a > 1.0 => drag == 0.0 && force == 0.0 && torque == 0.0,
                _ => [drag, force, torque].iter().all(|x| *x == f64::INFINITY),
            };
            misses.expect(fine && mixed == 0.0, place);
        }
    });
}

#[test]
fn signs_of_the_arguments_do_not_matter() {
    visit::<f64>(|(name, tier), order, alpha| {
        for (slide, rim) in [
            (0.7, 1.1),
            (1.3, 0.2),
            (0.0, 1.0),
            (1.0, 0.0),
            (0.0, 0.0),
            (2.0, 2.0),
        ] {
            let bits = |v, w| all(tier.as_ref(), v, w).map(f64::to_bits);
            let wanted = bits(slide, rim);
            for (v, w) in [(-slide, rim), (slide, -rim), (-slide, -rim)] {
                assert_eq!(
                    bits(v, w),
                    wanted,
                    "{name}, q {order}, alpha {alpha}: ({v}, {w})"
                );
            }
        }
    });
}

/// Finite speeds of random bits: F, T, G are numbers and not negative, derivatives are numbers.
fn assert_random_bits<R: RoundTabulated>(from_bits: impl Fn(u64) -> R) {
    let mut misses = Misses::default();
    visit::<R>(|(name, tier), order, alpha| {
        let mut rng = Lcg::new(13);
        for n in 0..500 {
            let slide = from_bits(rng.bits());
            let rim = if n % 5 == 0 {
                slide
            } else {
                from_bits(rng.bits())
            };
            let got = all(tier.as_ref(), slide, rim);
            if slide.is_finite() && rim.is_finite() {
                let fine = got
                    .iter()
                    .enumerate()
                    .all(|(n, x)| !x.is_nan() && (n > 2 || *x >= 0.0));
                misses.expect(fine, || {
                    format!("{name}, q {order}, alpha {alpha}: ({slide:?}, {rim:?}) gives {got:?}")
                });
            }
        }
    });
}

#[test]
fn finite_speeds_give_numbers() {
    assert_random_bits(f64::from_bits);
}

#[test]
fn finite_speeds_give_numbers_in_single_precision() {
    assert_random_bits(|bits| f32::from_bits((bits >> 32) as u32));
}

#[test]
fn special_arguments_give_numbers() {
    let mut misses = Misses::default();
    let finite: Vec<f64> = special_f64()
        .into_iter()
        .filter(|x| x.is_finite())
        .collect();
    visit::<f64>(|(name, tier), order, alpha| {
        for &slide in &finite {
            for &rim in &finite {
                let got = all(tier.as_ref(), slide, rim);
                misses.expect(got.iter().all(|x| !x.is_nan()), || {
                    format!("{name}, q {order}, alpha {alpha}: ({slide:e}, {rim:e}) gives {got:?}")
                });
            }
        }
    });
}

/// What an annulus has in the number range wherever its two disks have it.
fn assert_annuli_are_numbers<R: RoundTabulated>(arguments: &[(f64, f64)]) {
    let mut misses = Misses::default();
    visit_annuli::<R>(|(name, band), disk, inner, alpha| {
        let k = R::from_f64(inner);
        for &(slide, rim) in arguments {
            let (slide, rim) = (R::from_f64(slide), R::from_f64(rim));
            let got = all(band.as_ref(), slide, rim);
            let whole = all(disk, slide, rim);
            let middle = all(disk, slide, k * rim);
            let fine = (0..9).all(|n| {
                let in_range = whole[n].is_finite() && middle[n].is_finite();
                // Without a hole the middle does not count.
                let in_range = in_range || inner == 0.0 && !whole[n].is_nan();
                // Rounding of the difference, at the end of the range as well.
                let size = 1e3
                    * (R::EPSILON.to_f64() * whole[n].abs()
                        + (R::MIN_POSITIVE * R::EPSILON).to_f64());
                !in_range || !got[n].is_nan() && (n > 1 || got[n] >= -size)
            });
            misses.expect(fine, || {
                format!("{name}, k {inner}, alpha {alpha}: ({slide:?}, {rim:?}) gives {got:?}, whole {whole:?}, middle {middle:?}")
            });
        }
    });
}

/// Pairs of finite special numbers and of random bits.
fn finite_pairs() -> Vec<(f64, f64)> {
    let finite: Vec<f64> = special_f64()
        .into_iter()
        .filter(|x| x.is_finite())
        .collect();
    let mut out: Vec<_> = finite
        .iter()
        .flat_map(|&v| finite.iter().map(move |&w| (v, w)))
        .collect();
    let mut rng = Lcg::new(29);
    let random = (0..1_000).map(|_| (f64::from_bits(rng.bits()), f64::from_bits(rng.bits())));
    out.extend(random.filter(|(v, w)| v.is_finite() && w.is_finite()));
    out
}

#[test]
fn annuli_have_what_their_disks_have() {
    assert_annuli_are_numbers::<f64>(&finite_pairs());
}

#[test]
fn annuli_without_a_hole_are_disks_for_every_argument() {
    visit_annuli::<f64>(|(name, band), disk, inner, alpha| {
        if inner != 0.0 {
            return;
        }
        for slide in special_f64() {
            for rim in special_f64() {
                let (got, wanted) = (all(band.as_ref(), slide, rim), all(disk, slide, rim));
                for (got, wanted) in got.into_iter().zip(wanted) {
                    let same = got == wanted || got.is_nan() && wanted.is_nan();
                    assert!(
                        same,
                        "{name}, alpha {alpha}: ({slide:e}, {rim:e}): {got:e} {wanted:e}"
                    );
                }
            }
        }
    });
}

#[test]
fn annuli_do_not_launder_nan_and_rest_like_their_disks() {
    visit_annuli::<f64>(|(name, band), _, inner, alpha| {
        for other in special_f64() {
            for (slide, rim) in [
                (f64::NAN, other),
                (other, f64::NAN),
                (f64::INFINITY, f64::INFINITY),
            ] {
                let got = all(band.as_ref(), slide, rim);
                assert!(
                    got.iter().all(|x| x.is_nan()),
                    "{name}, k {inner}, alpha {alpha}: ({slide}, {rim}) {got:?}"
                );
            }
        }
        let got = all(band.as_ref(), 0.0, -0.0);
        assert!(
            got[..5].iter().all(|x| *x == 0.0),
            "{name}, k {inner}, alpha {alpha}: {got:?}"
        );
        let torque = match alpha {
            1.0 => 0.5 * (1.0 + inner * inner),
            a if a > 1.0 => 0.0,
            _ => f64::INFINITY,
        };
        assert!(got[8] == torque || (got[8] - torque).abs() <= tolerance::ROUNDING.limit);
        assert_eq!(got[7], 0.0);
    });
}

#[test]
fn dry_forces_do_not_depend_on_the_unit_of_speed_down_to_the_last_octaves() {
    for (name, tier) in ORDERS
        .iter()
        .flat_map(|&order| patches::tiers::<f64>(order, 0.0))
    {
        for (slide, rim) in [(0.75, 1.0), (1.0, 0.75), (1.0, 1.0), (0.0, 1.0)] {
            let wanted = tier.reduced_wrench(slide, rim);
            for scale in [2.0_f64.powi(-1070), 2.0_f64.powi(1020)] {
                let got = tier.reduced_wrench(slide * scale, rim * scale);
                for (got, wanted) in [(got.force, wanted.force), (got.torque, wanted.torque)] {
                    let slack = tolerance::ROUNDING.limit * wanted;
                    assert!(
                        (got - wanted).abs() <= slack,
                        "{name}: ({slide}, {rim}) x {scale:e}"
                    );
                }
            }
        }
    }
    assert!(table::CoulombDisk.lateral(0.0_f64, 1.0) > 0.0);
}
