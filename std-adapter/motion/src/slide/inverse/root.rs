//! Root of an increasing function of one variable.

/// The argument at which an increasing function passes zero.
///
/// Chandrupatla, Adv. Eng. Softw. 28 (1997) 145: inverse quadratic interpolation where it is
/// safe, otherwise bisection. The iteration ends when the absolute value is at most `enough` or the bracket
/// has closed to rounding.
///
/// *Domain*: `below.1` ≤ 0 ≤ `above.1`. Returns the argument with the smaller value of the last
/// two.
pub(super) fn rising_root(
    below: (f64, f64),
    above: (f64, f64),
    enough: f64,
    mut function: impl FnMut(f64) -> f64,
) -> f64 {
    if let Some(end) = [above, below].iter().find(|end| end.1.abs() <= enough) {
        return end.0;
    }
    let (mut newest, mut other) = (above, below);
    let mut share = 0.5;
    for _ in 0..MAX_ROUNDS {
        let at = newest.0 + share * (other.0 - newest.0);
        let value = function(at);
        // The third point of the parabola is the one that the new point replaces.
        let third;
        if (value > 0.0) == (newest.1 > 0.0) {
            third = newest;
        } else {
            third = other;
            other = newest;
        }
        newest = (at, value);
        let best = if newest.1.abs() < other.1.abs() {
            newest
        } else {
            other
        };
        let width = (other.0 - newest.0).abs();
        let grain = f64::EPSILON * best.0.abs();
        if best.1.abs() <= enough || width <= 2.0 * grain || value.is_nan() {
            return best.0;
        }
        share = interpolated(newest, other, third).clamp(grain / width, 1.0 - grain / width);
    }
    newest.0
}

/// More iterations than bisection from the largest f64 to the smallest needs.
const MAX_ROUNDS: u32 = 2200;

/// Fraction of the interval from `newest` to `other` at which the inverse parabola has its zero; one half
/// where the parabola is not monotone.
fn interpolated(newest: (f64, f64), other: (f64, f64), third: (f64, f64)) -> f64 {
    let place = (newest.0 - other.0) / (third.0 - other.0);
    let height = (newest.1 - other.1) / (third.1 - other.1);
    let monotone = height * height < place && (1.0 - height) * (1.0 - height) < 1.0 - place;
    if !monotone {
        return 0.5;
    }
    let slope = (third.0 - newest.0) / (other.0 - newest.0);
    newest.1 / (other.1 - newest.1) * (third.1 / (other.1 - third.1))
        + slope * (newest.1 / (third.1 - newest.1)) * (other.1 / (third.1 - other.1))
}

#[cfg(test)]
#[allow(clippy::disallowed_methods, reason = "tests compare with the platform")]
mod tests {
    use super::*;

    #[test]
    fn roots_are_found_to_the_last_digit_in_few_rounds() {
        type Case = (fn(f64) -> f64, f64, f64, f64);
        let cases: [Case; 7] = [
            (|x| x * x - 2.0, 0.0, 2.0, 2.0_f64.sqrt()),
            (|x| x.exp() - 1e-3, -40.0, 4.0, 1e-3_f64.ln()),
            (|x| (x - 0.3).cbrt(), 0.0, 1.0, 0.3),
            (|x| if x < 0.7 { -1.0 } else { 1.0 }, 0.0, 1.0, 0.7),
            // A straight line, with its zero at either end.
            (|x| (x + 8.0) - 15.0, 1.0, 12.0, 7.0),
            (|x| x - 7.0, 7.0, 9.0, 7.0),
            (|x| x - 7.0, 4.0, 7.0, 7.0),
        ];
        for (function, low, high, wanted) in cases {
            let mut rounds = 0;
            let root = rising_root((low, function(low)), (high, function(high)), 0.0, |x| {
                rounds += 1;
                function(x)
            });
            assert!(
                (root - wanted).abs() <= 5e-16 * wanted.abs(),
                "{root} {wanted}"
            );
            assert!(rounds <= 70, "{rounds}");
        }
    }
}
