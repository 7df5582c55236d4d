//! Ranges of values: FROM:TO:STEP in equal steps, FROM:TO:xFACTOR in equal ratios.

/// Most values of a range.
const MOST: usize = 10_000;
const FORM: &str =
    "a range is FROM:TO:STEP, such as 0:50:10, or FROM:TO:xFACTOR, such as 1e-4:1:x10";

/// The values that an item of a list stands for: itself, or those of a range, both ends included
/// where the steps meet them.
pub fn expand(item: &str) -> Result<Vec<String>, String> {
    let parts: Vec<&str> = item.split(':').map(str::trim).collect();
    if parts.len() == 1 || parts[0].parse::<f64>().is_err() {
        // A word, also one with colons.
        return Ok(vec![item.to_owned()]);
    }
    let refusal = |why: &str| format!("`{item}`: {why}; {FORM}");
    let &[from, to, step] = parts.as_slice() else {
        return Err(refusal("three parts are needed"));
    };
    let number = |text: &str| {
        Decimal::parse(text).ok_or_else(|| refusal(&format!("`{text}` is not a number")))
    };
    let (from, to) = (number(from)?, number(to)?);
    let values = match step.strip_prefix('x') {
        Some(factor) => geometric(from, to, number(factor)?),
        None => arithmetic(from, to, number(step)?),
    };
    let values = values.map_err(|why| refusal(&why))?;
    Ok(values.iter().map(Decimal::text).collect())
}

/// A decimal number, `digits` · 10^`power`: steps of 0.1 stay tenths.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Decimal {
    digits: i128,
    power: i32,
}

/// Decimal digits that an i128 surely holds, and that a value may have.
const MOST_DIGITS: i32 = 36;

impl Decimal {
    fn parse(text: &str) -> Option<Self> {
        text.parse::<f64>().ok().filter(|x| x.is_finite())?;
        let (mantissa, power) = text.split_once(['e', 'E']).unwrap_or((text, "0"));
        let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
        let power: i32 = power.parse().ok()?;
        let digits: i128 = format!("{whole}{fraction}").parse().ok()?;
        let power = power.checked_sub(fraction.len().try_into().ok()?)?;
        Some(Self { digits, power }.plain())
    }

    /// Without zeros at the end.
    fn plain(mut self) -> Self {
        if self.digits == 0 {
            self.power = 0;
        }
        while self.digits != 0 && self.digits % 10 == 0 {
            self.digits /= 10;
            self.power += 1;
        }
        self
    }

    /// The digits at another, lower power.
    fn at(self, power: i32) -> Option<i128> {
        let shift = u32::try_from(self.power.checked_sub(power)?).ok()?;
        10_i128.checked_pow(shift)?.checked_mul(self.digits)
    }

    /// The product to the digits of an f64.
    fn times(self, other: Self) -> Option<Self> {
        /// More digits are rounded away.
        const LARGEST: i128 = 1_000_000_000_000_000;
        let mut digits = self.digits.checked_mul(other.digits)?;
        let mut power = self.power.checked_add(other.power)?;
        while digits.abs() >= LARGEST {
            digits = (digits + 5 * digits.signum()) / 10;
            power = power.checked_add(1)?;
        }
        Some(Self { digits, power }.plain())
    }

    fn value(&self) -> f64 {
        self.text().parse().unwrap_or(f64::NAN)
    }

    /// As people write it.
    fn text(&self) -> String {
        /// Powers of ten that are written out.
        const EVERYDAY: std::ops::RangeInclusive<i32> = -6..=6;
        let Self { digits, power } = *self;
        if !EVERYDAY.contains(&power) {
            return format!("{digits}e{power}");
        }
        if power >= 0 {
            return format!("{digits}{}", "0".repeat(power.unsigned_abs() as usize));
        }
        let places = power.unsigned_abs() as usize;
        let all = format!("{:0>width$}", digits.unsigned_abs(), width = places + 1);
        let (whole, fraction) = all.split_at(all.len() - places);
        let sign = if digits < 0 { "-" } else { "" };
        format!("{sign}{whole}.{fraction}")
    }
}

/// From one number in equal steps as far as the other.
fn arithmetic(from: Decimal, to: Decimal, step: Decimal) -> Result<Vec<Decimal>, String> {
    let power = from.power.min(to.power).min(step.power);
    let all = [from, to, step].map(|number| number.at(power));
    let [Some(first), Some(last), Some(step)] = all else {
        return Err(format!("its numbers need more than {MOST_DIGITS} digits"));
    };
    let way = last
        .checked_sub(first)
        .ok_or("its numbers are too far apart")?;
    if step == 0 || way.signum() * step.signum() < 0 {
        return Err("the step does not lead there".into());
    }
    let count = way / step;
    if count >= MOST as i128 {
        return Err(format!("more than {MOST} values"));
    }
    let value = |k| Decimal {
        digits: first + k * step,
        power,
    };
    Ok((0..=count).map(|k| value(k).plain()).collect())
}

/// From one number in equal ratios as far as the other.
fn geometric(from: Decimal, to: Decimal, factor: Decimal) -> Result<Vec<Decimal>, String> {
    let less = |a: Decimal, b: Decimal| a.value() < b.value();
    let one = Decimal {
        digits: 1,
        power: 0,
    };
    if from.digits <= 0 || to.digits <= 0 || factor.digits <= 0 || factor == one {
        return Err("equal ratios need numbers > 0 and a factor other than 1".into());
    }
    let rises = less(one, factor);
    if from != to && less(from, to) != rises {
        return Err("the factor does not lead there".into());
    }
    let mut all = vec![from];
    let mut value = from;
    loop {
        value = value
            .times(factor)
            .ok_or_else(|| format!("its values need more than {MOST_DIGITS} digits"))?;
        let is_beyond = if rises {
            less(to, value)
        } else {
            less(value, to)
        };
        if is_beyond {
            return Ok(all);
        }
        if all.len() == MOST {
            return Err(format!("more than {MOST} values"));
        }
        all.push(value);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ranges_hold_both_ends_and_stay_decimal() {
        for (item, values) in [
            ("0:50:10", "0 10 20 30 40 50"),
            ("0:55:10", "0 10 20 30 40 50"),
            ("0:1:0.1", "0 0.1 0.2 0.3 0.4 0.5 0.6 0.7 0.8 0.9 1"),
            ("5:-5:-2.5", "5 2.5 0 -2.5 -5"),
            ("-1e-3:1e-3:5e-4", "-0.001 -0.0005 0 0.0005 0.001"),
            ("3:3:1", "3"),
            (" 1 : 3 : 1 ", "1 2 3"),
            ("1e-4:1:x10", "0.0001 0.001 0.01 0.1 1"),
            ("1:0.1:x0.5", "1 0.5 0.25 0.125"),
            ("1e20:1e22:x10", "1e20 1e21 1e22"),
            ("1:2:x1.25", "1 1.25 1.5625 1.953125"),
            ("hertz", "hertz"),
            ("C:/scenes", "C:/scenes"),
            ("1.5", "1.5"),
        ] {
            let expanded = expand(item).map(|values| values.join(" "));
            assert_eq!(expanded.as_deref(), Ok(values), "{item}");
        }
    }

    #[test]
    fn ranges_without_an_end_are_refused() {
        for (item, words) in [
            ("0:50", "three parts"),
            ("0:50:10:1", "three parts"),
            ("0:50:0", "does not lead there"),
            ("0:50:-10", "does not lead there"),
            ("0:50:ten", "`ten` is not a number"),
            ("0:1e9:1", "more than 10000 values"),
            ("0:1e300:1", "digits"),
            ("1:8:x1", "factor other than 1"),
            ("1:8:x0.5", "does not lead there"),
            ("0:8:x2", "numbers > 0"),
            ("1:1e30:x1.000001", "more than 10000 values"),
            ("0:inf:1", "`inf` is not a number"),
        ] {
            let refused = expand(item).err().unwrap_or_default();
            assert!(refused.contains(words), "{item}: {refused}");
            assert!(refused.contains("FROM:TO:STEP"), "{item}: {refused}");
        }
    }
}
