//! What a film does not tell, in words.

use super::super::estimate::Uncertainty;
use super::super::parameter::Model;
use super::model::{TrackModel, Turning};
use super::words::SeenMotion;

/// Parameters that the film does not tell, or does not tell apart.
pub(super) fn ambiguities(seen: &SeenMotion<'_>) -> Vec<String> {
    let (fit, model) = (seen.fit, seen.film.model);
    let mut words = Vec::new();
    if model.turning == Turning::Ratio {
        words.push(
            "without the angle a film tells the coefficient and the ratio v/(|spin| R), not R and spin by \
             themselves: give a column angle for them"
                .into(),
        );
        if let Some(radius) = seen.radius {
            let [speed, rim] = model.speeds(&fit.values());
            let least = fit.estimate("ratio").map_or(0.0, |ratio| ratio.interval[0]);
            let (most, rim) = if seen.is_unspun {
                ("at most ", speed / least)
            } else {
                ("", rim)
            };
            if rim.is_finite() {
                words.push(format!(
                    "with R = {radius} m the spin at the first frame is {most}{:.4} rad/s, to either side",
                    rim / radius
                ));
            }
        }
    }
    for estimate in &fit.parameters {
        let name = estimate.parameter.name;
        let [low, high] = estimate.interval;
        let is_lost = match &estimate.known {
            Uncertainty::Undetermined(others) => !(seen.is_unspun && others == &["ratio"]),
            _ => false,
        };
        match name {
            "R" if is_lost || high.is_infinite() || low == 0.0 => {
                let spin = fit.estimate("spin").map(|spin| spin.interval);
                let why = if spin.is_some_and(|[low, high]| low <= 0.0 && high >= 0.0) {
                    "a body that hardly spins tells nothing about its radius"
                } else {
                    "the film does not bound the radius on both sides"
                };
                words.push(format!("{why}: give --fix R=METRES"));
            }
            "ratio" if seen.is_unspun => {}
            "ratio" if high.is_infinite() && low > 0.0 => words.push(format!(
                "the ratio is above {low:.3}: the body may not have spun at all"
            )),
            _ if is_lost => words.push(format!(
                "the film does not determine {name}; give --fix {name}=VALUE"
            )),
            _ => {}
        }
    }
    for values in &seen.others {
        let names = model_names(model);
        let told = names
            .iter()
            .zip(values)
            .take(model.body.law.parameters().len() + 1);
        let told: Vec<String> = told
            .map(|(name, value)| format!("{name} = {value:.4}"))
            .collect();
        words.push(format!(
            "another motion fits the frames as well, with {}; the intervals include it",
            told.join(", ")
        ));
    }
    for (a, b, correlation) in &seen.correlations {
        words.push(format!(
            "correlation of {a} and {b} is {correlation:.4}: the film hardly tells these apart; fix one"
        ));
    }
    words
}

/// A film without the angle in which the coefficient follows a ratio that is not told.
pub(super) fn trade(seen: &SeenMotion<'_>) -> Option<String> {
    /// Width of the interval, over its middle, beyond which the coefficient is not told.
    const WIDE: f64 = 0.1;
    let of = |name: &str| seen.fit.estimate(name).map(|estimate| estimate.interval);
    let ([low, high], [least, most]) = of("mu").zip(of("ratio"))?;
    let is_sought = least < most;
    let is_wide = high - low > WIDE * seen.fit.value("mu")?;
    if !is_sought || !is_wide || seen.is_unspun {
        return None;
    }
    Some(format!(
        "the coefficient trades with the ratio: the frames allow {} with {}; a body that hardly spins slows down \
         uniformly, and so does one that spins fast under a larger coefficient. Film the angle, or give the ratio with \
         --fix ratio=VALUE (1000 without spin)",
        side("mu", [low, high]),
        side("ratio", [least, most])
    ))
}

/// A film without the angle whose body may not have spun: what is reported, what else the frames allow, and what decides.
pub(super) fn unspun(seen: &SeenMotion<'_>) -> Option<String> {
    let law = seen.film.model.body.law.parameters().len();
    let sought = seen.fit.parameters.iter().take(law + 1);
    let sought = sought.filter(|estimate| estimate.known != Uncertainty::Fixed);
    let allowed = sought.map(|estimate| side(estimate.parameter.name, estimate.interval));
    let allowed: Vec<String> = allowed.collect();
    seen.is_unspun.then(|| {
        format!(
            "no spin fits the frames as well as any spin, so all values are those of a body that does not spin, and the \
             frames allow {}: a mark on the body, filmed for the column angle, would decide, or --fix ratio=VALUE (1000 \
             without spin)",
            allowed.join(", ")
        )
    })
}

/// An interval in words.
fn side(name: &str, [low, high]: [f64; 2]) -> String {
    match (low.is_finite() && low != 0.0, high.is_finite()) {
        (true, true) => format!("{name} = {low:.4} to {high:.4}"),
        (true, false) => format!("{name} above {low:.4}"),
        (false, true) => format!("{name} below {high:.4}"),
        (false, false) => format!("any {name}"),
    }
}

fn model_names(model: &TrackModel<'_>) -> Vec<&'static str> {
    model
        .parameters()
        .iter()
        .map(|parameter| parameter.name)
        .collect()
}
