//! Tick positions and their labels.

use super::axis::{Scale, Span};

/// One tick; minor ticks have no label.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Tick {
    /// Position along the axis from 0 to 1.
    pub at: f64,
    /// Text beside the tick.
    pub label: String,
}

/// All ticks of one axis and the power of ten their labels share.
#[derive(Debug, Clone, PartialEq, Default)]
pub(super) struct Ticks {
    pub marks: Vec<Tick>,
    pub factor: Option<String>,
}

/// Ticks of a span with about `target` labels.
pub(super) fn ticks(span: &Span, target: usize) -> Ticks {
    let target = target.max(2);
    match span.scale {
        Scale::Linear => linear(span.low, span.high, target, |value| span.place(value)),
        Scale::Log10 if span.high.floor() - span.low.ceil() >= 1.0 => decades(span, target),
        Scale::Log10 => within_decade(span, target),
    }
}

// Ticks at round multiples of 1, 2 or 5 times a power of ten.
fn linear(low: f64, high: f64, target: usize, place: impl Fn(f64) -> Option<f64>) -> Ticks {
    let raw = (high - low) / target as f64;
    let mut exponent = raw.log10().floor() as i32;
    let mut factor = [1.0, 2.0, 5.0, 10.0]
        .into_iter()
        .find(|factor| factor * power(exponent) >= raw * 0.999)
        .unwrap_or(10.0);
    if factor >= 10.0 {
        (factor, exponent) = (1.0, exponent + 1);
    }
    let step = factor * power(exponent);

    // Very large and very small values share one power of ten.
    let shared = shared_exponent(low.abs().max(high.abs()));
    let decimals = (shared - exponent).max(0) as usize;
    let first = (low / step - 1e-9).ceil();
    let last = (high / step + 1e-9).floor();
    let count = (last - first).clamp(0.0, 100.0) as usize;
    let marks = (0..=count)
        .map(|index| first + index as f64)
        .filter_map(|index| {
            let shown = index * factor * power(exponent - shared);
            place(index * step).map(|at| Tick {
                at: at.clamp(0.0, 1.0),
                label: minus(&format!("{shown:.decimals$}")),
            })
        })
        .collect();
    let factor = (shared != 0).then(|| format!("×{}", ten_to(shared)));
    Ticks { marks, factor }
}

// Labels at powers of ten, minor ticks between them.
fn decades(span: &Span, target: usize) -> Ticks {
    let (first, last) = (span.low.ceil() as i32, span.high.floor() as i32);
    let stride = ((last - first) as usize / (target + 1) + 1) as i32;
    let mut marks = Vec::new();
    for decade in first - 1..=last {
        let at = |unit: f64| (unit - span.low) / (span.high - span.low);
        let label = if decade.rem_euclid(stride) == 0 {
            ten_to(decade)
        } else {
            String::new()
        };
        marks.push((at(f64::from(decade)), label));
        if stride == 1 {
            let minors = (2..10).map(|digit| f64::from(decade) + f64::from(digit).log10());
            marks.extend(minors.map(|unit| (at(unit), String::new())));
        }
    }
    let marks = marks
        .into_iter()
        .filter(|(at, _)| (-1e-9..=1.0 + 1e-9).contains(at))
        .map(|(at, label)| Tick { at, label })
        .collect();
    Ticks {
        marks,
        factor: None,
    }
}

// A log axis shorter than two decades is labelled at 1, 2, 5 or linearly.
fn within_decade(span: &Span, target: usize) -> Ticks {
    let (low, high) = (10_f64.powf(span.low), 10_f64.powf(span.high));
    let mut marks = Vec::new();
    for decade in span.low.floor() as i32..=span.high.ceil() as i32 {
        for digit in 1..10 {
            let value = f64::from(digit) * power(decade);
            let labelled = matches!(digit, 1 | 2 | 5);
            let label = if labelled {
                plain(digit, decade)
            } else {
                String::new()
            };
            let inside = value >= low * (1.0 - 1e-9) && value <= high * (1.0 + 1e-9);
            if let (true, Some(at)) = (inside, span.place(value)) {
                marks.push(Tick { at, label });
            }
        }
    }
    if marks.iter().filter(|tick| !tick.label.is_empty()).count() < 2 {
        return linear(low, high, target, |value| span.place(value));
    }
    Ticks {
        marks,
        factor: None,
    }
}

// Exponent shared by the labels of an axis, zero for everyday sizes.
fn shared_exponent(largest: f64) -> i32 {
    if largest == 0.0 || (1e-2..1e5).contains(&largest) {
        0
    } else {
        largest.log10().floor() as i32
    }
}

// A digit times a power of ten, written out when short.
fn plain(digit: i32, decade: i32) -> String {
    match decade {
        0..=3 => format!("{:.0}", f64::from(digit) * power(decade)),
        -3..=-1 => {
            let decimals = decade.unsigned_abs() as usize;
            format!("{:.decimals$}", f64::from(digit) * power(decade))
        }
        _ if digit == 1 => ten_to(decade),
        _ => format!("{digit}·{}", ten_to(decade)),
    }
}

// Ten to a power that a number can hold.
fn power(exponent: i32) -> f64 {
    10_f64.powi(exponent)
}

// A power of ten with a raised exponent.
fn ten_to(exponent: i32) -> String {
    let exponent = exponent.to_string();
    let raised = exponent.chars().map(|digit| match digit {
        '-' => '⁻',
        '1' => '¹',
        '2' => '²',
        '3' => '³',
        '4' => '⁴',
        '5' => '⁵',
        '6' => '⁶',
        '7' => '⁷',
        '8' => '⁸',
        '9' => '⁹',
        _ => '⁰',
    });
    "10".chars().chain(raised).collect()
}

// A number with a true minus sign, and none before zero.
fn minus(number: &str) -> String {
    match number.strip_prefix('-') {
        Some(zero) if zero.chars().all(|digit| matches!(digit, '0' | '.')) => zero.to_owned(),
        Some(rest) => format!("−{rest}"),
        None => number.to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    // Labels of all major ticks over a span.
    fn labels(scale: Scale, low: f64, high: f64) -> Vec<String> {
        let marks = ticks(&Span { scale, low, high }, 6).marks;
        let labels = marks.into_iter().map(|tick| tick.label);
        labels.filter(|label| !label.is_empty()).collect()
    }

    #[test]
    fn linear_labels_are_round() {
        assert_eq!(labels(Scale::Linear, -0.5, 0.5)[0], "−0.4");
        assert!(labels(Scale::Linear, -0.5, 0.5).contains(&"0.0".to_owned()));
        assert_eq!(
            labels(Scale::Linear, 0.0, 6e-6).last(),
            Some(&"6".to_owned())
        );
        assert_eq!(labels(Scale::Linear, 0.0, 10.0).len(), 6);
    }

    #[test]
    fn log_labels_are_powers_of_ten() {
        assert_eq!(
            labels(Scale::Log10, -3.1, 1.2),
            ["10⁻³", "10⁻²", "10⁻¹", "10⁰", "10¹"]
        );
        assert!(labels(Scale::Log10, -30.0, 30.0).len() <= 7);
        assert_eq!(labels(Scale::Log10, -0.1, 0.8), ["1", "2", "5"]);
        assert!(labels(Scale::Log10, 0.31, 0.33).len() >= 2);
    }

    #[test]
    fn ticks_stay_on_the_axis_whatever_the_span() {
        for (low, high) in [
            (1e9, 1e9 + 2.0),
            (-1e300, 1e300),
            (0.0, 1e-290),
            (-7.3, 0.1),
        ] {
            let span = Span {
                scale: Scale::Linear,
                low,
                high,
            };
            let marks = ticks(&span, 5).marks;
            assert!(
                (2..12).contains(&marks.len()),
                "{low} {high} {}",
                marks.len()
            );
            assert!(marks.iter().all(|tick| (0.0..=1.0).contains(&tick.at)));
        }
    }
}
