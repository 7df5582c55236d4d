//! Against 300 binary digits of mpmath.

use super::*;

/// Bits of x, α and the nearest power, and the rest in units of its last place.
fn golden(precision: &str) -> impl Iterator<Item = ([u64; 3], f64)> {
    include_str!("powers.txt").lines().filter_map(move |line| {
        let mut words = line.strip_prefix(precision)?.split_whitespace();
        let mut bits = || u64::from_str_radix(words.next()?.strip_prefix("0x")?, 16).ok();
        let bits = [bits()?, bits()?, bits()?];
        Some((bits, words.next()?.parse().ok()?))
    })
}

/// Largest error in ulp that is promised for α.
fn promised(alpha: f64) -> f64 {
    match alpha.abs() {
        a if a <= 1.0 => 0.52,
        a if a <= 5.0 => 0.6,
        _ => 0.9,
    }
}

#[test]
fn powers_keep_their_bound_in_double_precision() {
    let mut seen = 0;
    for ([x, alpha, nearest], rest) in golden("f64") {
        let (x, alpha) = (f64::from_bits(x), f64::from_bits(alpha));
        let power = FixedPower::<f64>::new(alpha).of(x);
        let error = (power.to_bits() as i64 - nearest as i64) as f64 - rest;
        // Beyond the table the error is that of libm.
        let inside = libm::log2(x).abs() < 31.9;
        let bound = if inside { promised(alpha) } else { 1.0 };
        assert!(error.abs() <= bound, "{x:e}^{alpha}: {error} ulp");
        seen += 1;
    }
    assert!(seen > 500, "{seen}");
}

#[test]
fn powers_keep_their_bound_in_single_precision() {
    let mut seen = 0;
    for ([x, alpha, nearest], rest) in golden("f32") {
        let (x, alpha) = (f32::from_bits(x as u32), f32::from_bits(alpha as u32));
        let power = FixedPower::<f32>::new(alpha).of(x);
        let error = (i64::from(power.to_bits()) - nearest as i64) as f64 - rest;
        assert!(error.abs() <= 1.0, "{x:e}^{alpha}: {error} ulp");
        seen += 1;
    }
    assert!(seen > 400, "{seen}");
}

#[test]
fn one_and_whole_exponents_are_exact() {
    for alpha in [-0.93, -0.5, 0.37, 0.5, 1.0, 2.2, 10.0] {
        assert_eq!(FixedPower::<f64>::new(alpha).of(1.0), 1.0);
        assert_eq!(FixedPower::<f32>::new(alpha as f32).of(1.0), 1.0);
    }
    let same = FixedPower::<f64>::new(1.0);
    for x in numbers().take(10_000) {
        assert_eq!(same.of(x), x);
        assert_eq!(same.rate(x), 1.0);
    }
    // Exact roots.
    let root = FixedPower::<f64>::new(0.5);
    for n in 1..3000 {
        let n = f64::from(n);
        assert_eq!(root.of(n * n), n);
    }
}

/// Numbers over the whole table and a little beyond.
fn numbers() -> impl Iterator<Item = f64> {
    let mut state = 1_u64;
    core::iter::from_fn(move || {
        state = state
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        let exponent = 1023 - 34 + (state >> 33) % 68;
        Some(f64::from_bits((exponent << 52) | (state >> 12)))
    })
}

#[test]
fn powers_rise_with_their_argument() {
    for alpha in [0.3, 1.7, 7.7] {
        let power = FixedPower::<f64>::new(alpha);
        for x in numbers().take(20_000) {
            assert!(power.of(x) <= power.of(x.next_up()), "{x:e}");
        }
    }
    let falling = FixedPower::<f64>::new(-0.4);
    for x in numbers().take(20_000) {
        assert!(falling.of(x) >= falling.of(x.next_up()), "{x:e}");
    }
}

#[test]
fn both_sides_of_every_cell_agree() {
    for alpha in [-0.9, 0.37, 10.0] {
        let power = FixedPower::<f64>::new(alpha);
        for cell in 0..2 * STEPS {
            let edge = 1.0 + (cell as f64 + 0.5) / STEPS as f64;
            for x in [edge.next_down(), edge, 64.0 * edge] {
                let far = libm::pow(x, alpha);
                assert!((power.of(x) - far).abs() <= 2.0 * f64::EPSILON * far, "{x}");
            }
        }
    }
}

#[test]
fn beyond_the_table_libm_speaks() {
    let numbers = [0.0, -0.0, 5e-324, 1e-310, f64::MAX, f64::INFINITY, -1.0];
    for alpha in [-0.5, 0.37, 3.0] {
        let power = FixedPower::<f64>::new(alpha);
        for x in numbers {
            let [of, rate] = [libm::pow(x, alpha), libm::pow(x, alpha - 1.0)];
            assert!(power.of(x).to_bits() == of.to_bits() || of.is_nan());
            assert!(power.rate(x).to_bits() == rate.to_bits() || rate.is_nan());
            assert_eq!(power.of(x).is_nan(), of.is_nan());
        }
        assert!(power.of(f64::NAN).is_nan() && power.rate(f64::NAN).is_nan());
    }
    // Single precision ends before the table does.
    let steep = FixedPower::<f32>::new(10.0);
    assert_eq!(steep.of(1e4), f32::INFINITY);
    assert_eq!(steep.of(1e-5), 0.0);
}
