//! Loads in the words of an input script: numbers, or formulas in the time.

use crate::grains::Ramp;
use tribos_base::record::number;

/// A number, or a formula of LAMMPS in the time.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Quantity {
    Number(f64),
    Formula(String),
}

/// The time of a script within its period, if loads repeat: the variable `clock`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Clock(pub Option<f64>);

/// A number within a formula.
fn term(value: f64) -> String {
    if value < 0.0 {
        format!("({})", number(value))
    } else {
        number(value)
    }
}

impl Quantity {
    pub(super) const ZERO: Self = Self::Number(0.0);

    /// As a factor or a summand of a formula.
    pub(super) fn term(&self) -> String {
        match self {
            Self::Number(value) => term(*value),
            Self::Formula(text) => format!("({text})"),
        }
    }

    pub(super) fn plus(self, other: Self) -> Self {
        match (self, other) {
            (Self::Number(a), Self::Number(b)) => Self::Number(a + b),
            (one, Self::Number(0.0)) | (Self::Number(0.0), one) => one,
            (a, b) => Self::Formula(format!("{}+{}", a.term(), b.term())),
        }
    }

    pub(super) fn times(self, other: Self) -> Self {
        match (self, other) {
            (Self::Number(a), Self::Number(b)) => Self::Number(a * b),
            (Self::Number(0.0), _) | (_, Self::Number(0.0)) => Self::ZERO,
            (a, b) => Self::Formula(format!("{}*{}", a.term(), b.term())),
        }
    }
}

impl Clock {
    /// The line that defines the clock, if a script needs one.
    pub(super) fn definition(self) -> Option<String> {
        let period = number(self.0?);
        Some(format!(
            "variable clock equal time-{period}*floor(time/{period})\n"
        ))
    }

    fn name(self) -> &'static str {
        if self.0.is_some() { "v_clock" } else { "time" }
    }

    /// The value of a ramp.
    pub(super) fn value(self, ramp: &Ramp) -> Quantity {
        if let Some(value) = ramp.constant() {
            return Quantity::Number(value);
        }
        let (t, knots) = (self.name(), ramp.knots());
        let mut parts = Vec::new();
        // What a comparison yields is 1 or 0.
        let [first, last] = [knots[0], knots[knots.len() - 1]];
        parts.push(format!("({t}<={})*{}", term(first[0]), term(first[1])));
        for pair in knots.windows(2) {
            let [[t0, v0], [t1, v1]] = [pair[0], pair[1]];
            let slope = (v1 - v0) / (t1 - t0);
            let [from, until, value, slope] = [t0, t1, v0, slope].map(term);
            parts.push(format!(
                "({t}>{from})*({t}<={until})*({value}+{slope}*({t}-{from}))"
            ));
        }
        parts.push(format!("({t}>{})*{}", term(last[0]), term(last[1])));
        Quantity::Formula(parts.join("+"))
    }

    /// The integral of a ramp from 0 on.
    pub(super) fn integral(self, ramp: &Ramp) -> Quantity {
        if let Some(value) = ramp.constant() {
            return Quantity::Formula(format!("{}*time", term(value)));
        }
        let (t, knots) = (self.name(), ramp.knots());
        let [first, last] = [knots[0], knots[knots.len() - 1]];
        let [begin, value] = first.map(term);
        let mut parts = vec![format!(
            "{value}*(({t}<{begin})*{t}+({t}>={begin})*{begin})"
        )];
        for pair in knots.windows(2) {
            let [[t0, v0], [t1, v1]] = [pair[0], pair[1]];
            let [from, until, span] = [t0, t1, t1 - t0].map(term);
            let within = format!("({t}>{from})*(({t}<{until})*({t}-{from})+({t}>={until})*{span})");
            let [value, bend] = [v0, 0.5 * (v1 - v0) / (t1 - t0)].map(term);
            parts.push(format!("({within})*({value}+{bend}*({within}))"));
        }
        let [end, value] = last.map(term);
        parts.push(format!("({t}>{end})*{value}*({t}-{end})"));
        if let Some(period) = self.0 {
            let whole = term(ramp.integral(period));
            parts.push(format!("{whole}*floor(time/{})", term(period)));
        }
        Quantity::Formula(parts.join("+"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The value of a formula at a time: sums and products of numbers, comparisons and brackets.
    fn evaluated(text: &str, time: f64, clock: f64) -> f64 {
        let mut words = Words {
            rest: text,
            time,
            clock,
        };
        let value = words.sum();
        assert_eq!(words.rest, "", "{text}");
        value
    }

    struct Words<'a> {
        rest: &'a str,
        time: f64,
        clock: f64,
    }

    impl Words<'_> {
        fn takes(&mut self, word: &str) -> bool {
            let rest = self.rest.strip_prefix(word);
            self.rest = rest.unwrap_or(self.rest);
            rest.is_some()
        }

        fn compared(&mut self) -> f64 {
            let left = self.sum();
            let is = |holds: bool| f64::from(u8::from(holds));
            if self.takes("<=") {
                is(left <= self.sum())
            } else if self.takes(">=") {
                is(left >= self.sum())
            } else if self.takes("<") {
                is(left < self.sum())
            } else if self.takes(">") {
                is(left > self.sum())
            } else {
                left
            }
        }

        fn sum(&mut self) -> f64 {
            let mut value = self.product();
            loop {
                if self.takes("+") {
                    value += self.product();
                } else if self.takes("-") {
                    value -= self.product();
                } else {
                    return value;
                }
            }
        }

        fn product(&mut self) -> f64 {
            let mut value = self.factor();
            loop {
                if self.takes("*") {
                    value *= self.factor();
                } else if self.takes("/") {
                    value /= self.factor();
                } else {
                    return value;
                }
            }
        }

        fn factor(&mut self) -> f64 {
            if self.takes("floor(") {
                let value = self.compared();
                assert!(self.takes(")"));
                return value.floor();
            }
            if self.takes("(") {
                let value = self.compared();
                assert!(self.takes(")"));
                return value;
            }
            for (name, value) in [("time", self.time), ("v_clock", self.clock)] {
                if self.takes(name) {
                    return value;
                }
            }
            let is_part = |c: char| c.is_ascii_digit() || ".e".contains(c);
            let mut end = self
                .rest
                .find(|c| !is_part(c) && c != '-')
                .unwrap_or(self.rest.len());
            // A minus belongs to a number at its start and behind an e.
            let minus = self.rest[..end].match_indices('-').map(|(at, _)| at);
            let apart = |at: &usize| *at > 0 && !self.rest[..*at].ends_with('e');
            end = minus.filter(apart).min().unwrap_or(end);
            let (word, rest) = self.rest.split_at(end);
            self.rest = rest;
            word.parse().unwrap()
        }
    }

    #[test]
    fn formulas_are_the_ramps_and_their_integrals() {
        for text in ["0:0, 2:1e3, 3:500", "0.5:-2, 1:4, 1.25:-1e-3, 4:7", "3"] {
            let ramp: Ramp = text.parse().unwrap();
            for period in [None, Some(1.5)] {
                let clock = Clock(period);
                for step in 0..200 {
                    let time = 0.025 * f64::from(step) + 1e-4;
                    let cycles = period.map_or(0.0, |period| (time / period).floor());
                    let phase = time - period.unwrap_or(0.0) * cycles;
                    let whole = period.map_or(0.0, |period| cycles * ramp.integral(period));
                    let expected = [ramp.at(phase), whole + ramp.integral(phase)];
                    let told = [clock.value(&ramp), clock.integral(&ramp)];
                    for (quantity, expected) in told.iter().zip(expected) {
                        let value = evaluated(&quantity.term(), time, phase);
                        let scale = 1.0 + expected.abs();
                        assert!(
                            (value - expected).abs() < 1e-10 * scale,
                            "{quantity:?} at {time}: {value} {expected}"
                        );
                    }
                }
            }
        }
    }

    #[test]
    fn sums_and_products_fold_numbers() {
        let formula = || Quantity::Formula("time+1.0".into());
        assert_eq!(
            Quantity::Number(2.0).plus(Quantity::Number(3.0)),
            Quantity::Number(5.0)
        );
        assert_eq!(formula().plus(Quantity::ZERO), formula());
        assert_eq!(formula().times(Quantity::ZERO), Quantity::ZERO);
        let twice = formula().times(Quantity::Number(-2.0)).term();
        assert_eq!(twice, "((time+1.0)*(-2.0))");
        assert_eq!(evaluated(&twice, 3.0, 0.0), -8.0);
    }
}
