//! No argument makes the couplings of round patches panic or lie: NaN, infinities, zeros, the ends of the
//! range, random bits.

use tribos_core::coupling::{Annulus, LateralFriction};
use tribos_core::real::Real;
use tribos_tests::patches::{self, RoundTabulated, numbers, plain_numbers};
use tribos_tests::sweep::{Lcg, special_f64};
use tribos_tests::tolerance;

const ORDERS: [f64; 7] = [-1.0, -0.9, -0.5, 0.0, 0.5, 1.0, 6.0];
const EXPONENTS: [f64; 8] = [-0.9, -0.5, 0.0, 0.25, 0.5, 1.0, 1.5, 3.0];
/// Inner over outer radius.
const INNER: [f64; 3] = [0.0, 0.5, 0.999];

/// What a coupling is, as far as its promises differ.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Kind {
    /// A table, a closed form or a series.
    Exact,
    /// A difference of two disks.
    Annulus,
    /// A sum over elements, whose speeds and powers must be numbers as well.
    Quadrature,
}

/// A coupling under one exponent.
struct Coupling<R> {
    name: String,
    kind: Kind,
    alpha: f64,
    mean_square_radius: f64,
    /// F, T, F/v and the derivatives; then, if it has them, G and the gradient of vG.
    at: Box<dyn Fn(R, R) -> Vec<f64>>,
}

/// Force, torque and lateral function of a result.
fn forces(numbers: &[f64]) -> impl Iterator<Item = f64> {
    numbers[..2].iter().chain(numbers.get(6)).copied()
}

fn lateral<R: Real + 'static>(
    name: String,
    kind: Kind,
    alpha: f64,
    tier: impl LateralFriction<R> + 'static,
) -> Coupling<R> {
    let mean_square_radius = tier.mean_square_radius().to_f64();
    let at = move |slide, rim| {
        let [f, t, g, rates @ .., along, across] = numbers(&tier, slide, rim);
        [&[f, t][..], &rates, &[g, along, across]].concat()
    };
    Coupling {
        name,
        kind,
        alpha,
        mean_square_radius,
        at: Box::new(at),
    }
}

/// Every coupling of this precision.
fn couplings<R: RoundTabulated + 'static>() -> Vec<Coupling<R>> {
    let mut all = Vec::new();
    // Few and small: they may live as long as the test.
    let kept = |tier: Box<dyn LateralFriction<R>>| &*Box::leak(tier);
    for alpha in EXPONENTS {
        for order in ORDERS {
            for (name, tier) in patches::tiers::<R>(order, alpha) {
                let name = format!("{name}, q {order}, alpha {alpha}");
                all.push(lateral(name, Kind::Exact, alpha, kept(tier)));
            }
        }
        let polynomial = R::polynomial_table(alpha).into_iter();
        let named = |tier| {
            lateral(
                format!("polynomial, alpha {alpha}"),
                Kind::Exact,
                alpha,
                kept(tier),
            )
        };
        all.extend(polynomial.map(named));
        for inner in INNER {
            for (name, disk) in patches::disks::<R>(alpha) {
                let band = Annulus::new(kept(disk), R::from_f64(inner)).expect("in range");
                let name = format!("annulus {inner} of {name}, alpha {alpha}");
                all.push(lateral(name, Kind::Annulus, alpha, band));
            }
        }
        let (name, sum) = patches::all::<R>(alpha).pop().expect("the quadrature");
        all.push(Coupling {
            name: format!("{name}, alpha {alpha}"),
            kind: Kind::Quadrature,
            alpha,
            mean_square_radius: 0.5,
            at: Box::new(move |slide, rim| plain_numbers(&*sum, slide, rim).to_vec()),
        });
    }
    all
}

/// Asks every coupling for the answers to all `pairs` of speeds; `is_fine` judges them.
fn judge<R: RoundTabulated + 'static>(
    pairs: &[(R, R)],
    is_fine: impl Fn(&Coupling<R>, (R, R), &[f64]) -> bool,
) {
    let mut misses = Vec::new();
    for coupling in couplings::<R>() {
        for &(slide, rim) in pairs {
            let got = (coupling.at)(slide, rim);
            if !is_fine(&coupling, (slide, rim), &got) {
                misses.push(format!(
                    "{}: ({slide:?}, {rim:?}) gives {got:?}",
                    coupling.name
                ));
            }
        }
    }
    let shown = misses
        .iter()
        .take(20)
        .cloned()
        .collect::<Vec<_>>()
        .join("\n");
    assert!(misses.is_empty(), "{} misses\n{shown}", misses.len());
}

fn nan_stays<R: RoundTabulated + 'static>() {
    let (nan, infinite) = (R::NAN, R::INFINITY);
    let with = |other: f64| [(nan, R::from_f64(other)), (R::from_f64(other), nan)];
    let mut pairs: Vec<_> = special_f64().into_iter().flat_map(with).collect();
    // Two infinite speeds have no ratio.
    pairs.extend([(infinite, infinite), (infinite, -infinite)]);
    judge(&pairs, |_, _, got| got.iter().all(|x| x.is_nan()));
}

#[test]
fn nan_is_never_laundered() {
    nan_stays::<f64>();
    nan_stays::<f32>();
}

/// Limit of one speed without bound and the other `minor`, from the answers where the larger is 1.
fn limit(coupling: &Coupling<f64>, minor: f64, sliding_leads: bool) -> [f64; 2] {
    let power = |exponent: f64| match exponent {
        0.0 => 1.0,
        e if e > 0.0 => f64::INFINITY,
        _ => 0.0,
    };
    let (lead, trail) = if sliding_leads {
        let far = (coupling.at)(1.0, 0.0);
        (far[0], far[5])
    } else {
        let far = (coupling.at)(0.0, 1.0);
        (far[1], far[2])
    };
    let trailing = if minor == 0.0 {
        0.0
    } else {
        trail * minor * power(coupling.alpha - 1.0)
    };
    let leading = lead * power(coupling.alpha);
    if sliding_leads {
        [leading, trailing]
    } else {
        [trailing, leading]
    }
}

#[test]
fn one_infinite_speed_gives_the_limit_or_nan_and_no_jacobian() {
    let minor = [0.0, 1e-300, 1.0, 1e300];
    let pairs: Vec<_> = minor
        .iter()
        .flat_map(|&minor| [(f64::INFINITY, minor), (minor, f64::INFINITY)])
        .collect();
    judge(&pairs, |coupling, (slide, rim), got| {
        if coupling.kind == Kind::Annulus {
            return true;
        }
        let close = |a: f64, b: f64| a == b || (a - b).abs() <= tolerance::ROUNDING.limit;
        // Dry friction knows the limit; for other laws it may depend on more than the ratio.
        let knows = coupling.alpha == 0.0 && coupling.kind == Kind::Exact;
        let expected = limit(coupling, slide.min(rim), slide > rim);
        let is_limit = |(got, wanted): (f64, f64)| close(got, wanted) || got.is_nan() && !knows;
        let far = if slide > rim { (1.0, 0.0) } else { (0.0, 1.0) };
        let lateral = (coupling.at)(far.0, far.1).get(6).copied();
        let keeps_lateral = match (lateral, got.get(6)) {
            (Some(far), Some(&got)) if knows => close(got, far),
            _ => true,
        };
        let is_nan = |rates: &[f64]| rates.iter().all(|x| x.is_nan());
        let without_rates = coupling.kind == Kind::Quadrature || is_nan(&got[2..6]);
        without_rates && keeps_lateral && got.iter().copied().zip(expected).all(is_limit)
    });
}

#[test]
fn a_patch_at_rest_feels_no_friction_and_its_damping_is_the_limit() {
    judge(
        &[(0.0, 0.0), (-0.0, 0.0), (0.0, -0.0)],
        |coupling, _, got| {
            let [slide, torque] = match coupling.alpha {
                1.0 => [1.0, coupling.mean_square_radius],
                a if a > 1.0 => [0.0; 2],
                _ => [f64::INFINITY; 2],
            };
            let none = forces(got)
                .chain(got.iter().copied().skip(7))
                .all(|x| x == 0.0);
            let rim = got[5] == torque || (got[5] - torque).abs() <= tolerance::ROUNDING.limit;
            // An infinite damping less another one has no value.
            let drags = coupling.kind == Kind::Annulus || got[2] == slide && got[3] == slide;
            none && (coupling.kind == Kind::Quadrature || got[4] == 0.0 && rim && drags)
        },
    );
}

#[test]
fn signs_of_the_arguments_do_not_matter() {
    let pairs = [
        (0.7, 1.1),
        (1.3, 0.2),
        (0.0, 1.0),
        (1.0, 0.0),
        (0.0, 0.0),
        (2.0, 2.0),
    ];
    judge::<f64>(&pairs, |coupling, (slide, rim), got| {
        let bits = |numbers: &[f64]| numbers.iter().map(|x| x.to_bits()).collect::<Vec<_>>();
        let mirrored = [(-slide, rim), (slide, -rim), (-slide, -rim)];
        mirrored
            .iter()
            .all(|&(v, w)| bits(&(coupling.at)(v, w)) == bits(got))
    });
}

/// All pairs of finite special numbers, and pairs of random bits, one in five of them equal.
fn finite_pairs<R: Real>(count: usize, from_bits: impl Fn(u64) -> R) -> Vec<(R, R)> {
    let special: Vec<R> = special_f64().into_iter().map(R::from_f64).collect();
    let mut out: Vec<_> = special
        .iter()
        .flat_map(|&v| special.iter().map(move |&w| (v, w)))
        .collect();
    let mut rng = Lcg::new(13);
    out.extend((0..count).map(|n| {
        let slide = from_bits(rng.bits());
        let rim = if n % 5 == 0 {
            slide
        } else {
            from_bits(rng.bits())
        };
        (slide, rim)
    }));
    out.retain(|(v, w)| v.is_finite() && w.is_finite());
    out
}

/// Forces of finite speeds are numbers and not negative, derivatives are numbers.
fn assert_numbers<R: RoundTabulated + 'static>(from_bits: impl Fn(u64) -> R) {
    judge(&finite_pairs(500, from_bits), |coupling, _, got| {
        // The sums at least do not panic; annuli are judged below.
        coupling.kind != Kind::Exact
            || got.iter().all(|x| !x.is_nan()) && forces(got).all(|x| x >= 0.0)
    });
}

#[test]
fn finite_speeds_give_numbers() {
    assert_numbers(f64::from_bits);
}

#[test]
fn finite_speeds_give_numbers_in_single_precision() {
    assert_numbers(|bits| f32::from_bits((bits >> 32) as u32));
}

/// Visits annuli of all widths with their disks.
fn visit_annuli(check: impl Fn(&str, &dyn LateralFriction<f64>, &dyn LateralFriction<f64>, f64)) {
    for alpha in EXPONENTS {
        for inner in INNER {
            for (name, disk) in patches::disks::<f64>(alpha) {
                let band = Annulus::new(&*disk, inner).expect("in range");
                check(
                    &format!("{name}, k {inner}, alpha {alpha}"),
                    &band,
                    &*disk,
                    inner,
                );
            }
        }
    }
}

#[test]
fn annuli_have_what_their_disks_have() {
    let pairs = finite_pairs(500, f64::from_bits);
    visit_annuli(|name, band, disk, inner| {
        for &(slide, rim) in &pairs {
            let [got, whole] = [band, disk].map(|tier| numbers(tier, slide, rim));
            let middle = numbers(disk, slide, inner * rim);
            let fine = (0..9).all(|n| {
                let in_range = whole[n].is_finite() && middle[n].is_finite();
                // Without a hole the middle does not count.
                let in_range = in_range || inner == 0.0 && !whole[n].is_nan();
                // Rounding of the difference, at the end of the range as well.
                let size = 1e3 * (f64::EPSILON * whole[n].abs() + f64::MIN_POSITIVE * f64::EPSILON);
                !in_range || !got[n].is_nan() && (n > 1 || got[n] >= -size)
            });
            assert!(
                fine,
                "{name}: ({slide:e}, {rim:e}) gives {got:?}, whole {whole:?}"
            );
        }
    });
}

#[test]
fn annuli_without_a_hole_are_disks_for_every_argument() {
    visit_annuli(|name, band, disk, inner| {
        for slide in special_f64() {
            for rim in special_f64() {
                let [got, whole] = [band, disk].map(|tier| numbers(tier, slide, rim));
                let is_same = |(a, b): (f64, f64)| a == b || a.is_nan() && b.is_nan();
                let same = inner != 0.0 || got.into_iter().zip(whole).all(is_same);
                assert!(same, "{name}: ({slide:e}, {rim:e}): {got:?} {whole:?}");
            }
        }
    });
}
