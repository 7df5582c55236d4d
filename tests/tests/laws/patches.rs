//! Patches: what their constructors refuse and what they let through.

use tribos_core::coupling::round::{
    LateralPolynomialTable, PolynomialTable, RoundTable32, RoundTable64,
};
use tribos_core::coupling::{Annulus, compact, coulomb, table};
use tribos_core::law::PowerLaw;
use tribos_core::patch::{PatchError, PolynomialPressure, PowerPressure};
use tribos_tests::pucks::relative;
use tribos_tests::sweep::Lcg;
use tribos_tests::tolerance;

#[test]
fn orders_beyond_ring_and_needle_are_refused() {
    for order in [-1.0, -0.999, -0.0, 0.5, 8.0] {
        assert_eq!(PowerPressure::new(order).expect("in range").order(), order);
    }
    let below = (-1.0_f64).next_down();
    let above = 8.0_f64.next_up();
    for order in [
        below,
        above,
        -1e300,
        f64::INFINITY,
        f64::NEG_INFINITY,
        f64::NAN,
    ] {
        let error = PowerPressure::new(order).expect_err("out of range");
        let PatchError::Order { given, max } = error else {
            panic!("{order}: {error:?}")
        };
        assert!(given.to_bits() == order.to_bits() && max == PowerPressure::MAX_ORDER);
        assert!(error.to_string().contains("-1 <= q <= 8"), "{error}");
    }
}

#[test]
fn named_pressures_are_their_orders() {
    for (pressure, order) in [
        (PowerPressure::RING, -1.0),
        (PowerPressure::FLAT_PUNCH, -0.5),
        (PowerPressure::UNIFORM, 0.0),
        (PowerPressure::HERTZ, 0.5),
        (PowerPressure::PARABOLOID, 1.0),
    ] {
        assert_eq!(pressure, PowerPressure::new(order).expect("in range"));
        assert_eq!(pressure.mean_square_radius(), 1.0 / (order + 2.0));
    }
}

#[test]
fn inner_ratios_that_leave_no_disk_or_no_digits_are_refused() {
    let band = |inner: f64| Annulus::new(coulomb::CoulombDisk, inner);
    for inner in [0.0, -0.0, 5e-324, 0.5, 0.999_999] {
        assert!(band(inner).is_ok(), "{inner}");
    }
    for inner in [
        -5e-324,
        0.999_999_f64.next_up(),
        1.0,
        2.0,
        f64::INFINITY,
        f64::NAN,
    ] {
        let error = band(inner).expect_err("no annulus");
        let PatchError::InnerRatio { given, max } = error else {
            panic!("{inner}: {error:?}")
        };
        assert!(given.to_bits() == inner.to_bits() && max == 0.999_999);
        assert!(
            error.to_string().contains("a thinner annulus is a ring"),
            "{error}"
        );
    }
    assert!(Annulus::new(coulomb::CoulombDisk, 0.999_999_f32).is_ok());
}

#[test]
fn exponents_of_tables_and_powers_are_refused_alike_for_every_pressure() {
    for pressure in [PowerPressure::RING, PowerPressure::HERTZ] {
        for alpha in [-1.0, -2.0, f64::NAN, f64::INFINITY] {
            assert!(RoundTable64::new(alpha, pressure).is_err(), "{alpha}");
            assert!(
                RoundTable32::new(alpha as f32, pressure).is_err(),
                "{alpha}"
            );
            assert!(
                compact::CompactPower::with_pressure(alpha, pressure).is_err(),
                "{alpha}"
            );
        }
        let beyond = table::DiskTable64::MAX_EXPONENT.next_up();
        assert!(RoundTable64::new(table::DiskTable64::MAX_EXPONENT, pressure).is_ok());
        assert!(RoundTable64::new(beyond, pressure).is_err());
        let most = PowerLaw::<f64>::MAX_EXPONENT;
        assert!(compact::CompactPower::with_pressure(most, pressure).is_ok());
        assert!(compact::CompactPower::with_pressure(most.next_up(), pressure).is_err());
    }
    let flat = PolynomialPressure::new([1.0]).expect("positive");
    for alpha in [-1.0, f64::NAN, 10.5] {
        assert!(PolynomialTable::new(alpha, &flat).is_err());
        assert!(LateralPolynomialTable::new(alpha, &flat).is_err());
    }
}

fn polynomial<const N: usize>(coefficients: [f64; N]) -> Result<PolynomialPressure<N>, PatchError> {
    PolynomialPressure::new(coefficients)
}

#[test]
fn pressures_that_are_nowhere_negative_are_accepted_even_where_they_touch_zero() {
    for coefficients in [
        [1.0, -2.0, 1.0],
        [0.25, -1.0, 1.0],
        [0.0, 1.0, 0.0],
        [0.0, 0.0, 1e-200],
        [1e200, -1e200, 0.0],
        [1.0, -2.0, 1.5],
        [0.0, 1.0, -1.0],
    ] {
        let pressure = polynomial(coefficients).expect("positive");
        let sum: f64 = pressure.shares().iter().sum();
        assert!(
            (sum - 1.0).abs() <= tolerance::ROUNDING.limit,
            "{coefficients:?}"
        );
    }
    // (1 - 3 s)^2 s and ((s - 0.3)(s - 0.8))^2: zeros inside, one and two of them.
    assert!(polynomial([0.0, 1.0, -6.0, 9.0]).is_ok());
    assert!(polynomial([0.0576, -0.528, 1.69, -2.2, 1.0]).is_ok());
}

#[test]
fn pressures_that_dip_below_zero_are_refused_wherever_they_do() {
    let negative = |result: Result<(), PatchError>| assert_eq!(result, Err(PatchError::Negative));
    for coefficients in [
        [1.0, -2.1, 1.05],
        [-1e-9, 1.0, 0.0],
        [1.0, -1.000_001, 0.0],
        [0.249_999, -1.0, 1.0],
        [-1.0, 0.0, 0.0],
        [1.0, -2.0, 0.999_999],
    ] {
        negative(polynomial(coefficients).map(|_| ()));
    }
    // A narrow dip between the ends, seen by nothing but a search.
    negative(polynomial([0.0575, -0.528, 1.69, -2.2, 1.0]).map(|_| ()));
}

#[test]
fn dips_are_found_with_a_resolution_of_their_square() {
    // (s - c)^2 - d is negative within sqrt(d) of c, for any c.
    let mut rng = Lcg::new(3);
    for _ in 0..2_000 {
        let c = rng.between(0.01, 0.99);
        let dip = rng.log_between(1e-11, 1e-3);
        let with = |d: f64| polynomial([c * c + d, -2.0 * c, 1.0]).is_ok();
        assert!(!with(-dip), "c {c}, dip {dip:e} is not seen");
        assert!(with(dip), "c {c}, clearance {dip:e} is refused");
    }
}

#[test]
fn pressures_without_load_or_number_are_refused() {
    assert_eq!(polynomial([0.0, 0.0]), Err(PatchError::NoLoad));
    assert_eq!(polynomial([-0.0]), Err(PatchError::NoLoad));
    assert_eq!(polynomial([]), Err(PatchError::NoLoad));
    for odd in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        for coefficients in [[odd, 1.0, 0.0], [1.0, odd, 0.0], [0.0, 0.0, odd], [odd; 3]] {
            assert_eq!(polynomial(coefficients), Err(PatchError::Negative));
        }
    }
}

#[test]
fn as_many_coefficients_as_orders_are_served() {
    assert!(polynomial([1.0; 9]).is_ok());
    let error = polynomial([1.0; 10]).expect_err("degree 9 in r^2");
    assert_eq!(
        error,
        PatchError::Order {
            given: 9.0,
            max: 8.0
        }
    );
}

#[test]
fn a_common_scale_of_the_coefficients_does_not_matter() {
    let plain = polynomial([0.2, 1.0, -0.5]).expect("positive");
    for scale in [1e-300, 0.25, 1e300] {
        let scaled = polynomial([0.2, 1.0, -0.5].map(|a| a * scale)).expect("positive");
        for (a, b) in plain.shares().iter().zip(scaled.shares()) {
            assert!(relative(*a, *b) <= tolerance::ROUNDING.limit);
        }
    }
}

#[test]
fn shares_and_mean_square_radius_are_those_of_the_moments() {
    // p ~ sum a_k s^k, s = r^2: load sum a_k/(k+1), <s> = sum a_k/(k+2) over it.
    let mut rng = Lcg::new(17);
    for _ in 0..1_000 {
        let a = [(); 5].map(|()| rng.unit());
        let pressure = polynomial(a).expect("positive");
        let moment = |n: f64| -> f64 {
            let terms = a.iter().enumerate();
            terms.map(|(k, a)| a / (k as f64 + n)).sum()
        };
        let wanted = moment(2.0) / moment(1.0);
        let shares: f64 = pressure.shares().iter().map(|w| w.abs()).sum();
        let got = pressure.mean_square_radius();
        assert!(
            (got - wanted).abs() <= tolerance::ROUNDING.limit * shares,
            "{a:?}"
        );
        // The shares' pressure is the polynomial: sum w_j (j+1) (1-s)^j.
        for s in [0.0, 0.3, 1.0] {
            let terms = pressure.shares().iter().enumerate();
            let value: f64 = terms
                .map(|(j, w)| w * (j as f64 + 1.0) * (1.0_f64 - s).powi(j as i32))
                .sum();
            let terms = a.iter().enumerate();
            let direct: f64 = terms.map(|(k, a)| a * f64::powi(s, k as i32)).sum();
            let slack = 5.0 * tolerance::ROUNDING.limit * shares;
            assert!(
                (value - direct / moment(1.0)).abs() <= slack,
                "{a:?} at {s}"
            );
        }
    }
}
