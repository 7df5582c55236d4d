//! Figure 3.11: how a motion fades for different exponents, and who travels farther.

use crate::exhibit::{Exhibit, linear, table};
use anyhow::Result;
use tribos_core::coupling::table::Table64;
use tribos_core::slider::{Motion, Slider, SliderParameters};
use tribos_report::claim::Claim;
use tribos_report::figure::{Axis, Figure, Series};

/// Disk with γg = 1 and R = 1.
fn disk(alpha: f64) -> Result<Slider<f64, Table64>> {
    Ok(Slider::new(
        table(alpha)?,
        SliderParameters {
            deceleration: 1.0,
            radius: 1.0,
            inertia_ratio: 0.5,
        },
    )?)
}

const START: f64 = 1.0;
const END: f64 = 5.0;

/// Sliding speed over time for α = 0, 1, 3.
pub fn figure_3_11() -> Result<Exhibit> {
    let times = linear(0.0, END, 250);
    let mut rows: Vec<Vec<f64>> = times.iter().map(|&time| vec![time]).collect();
    let mut figure = Figure::new(
        "Fading of the sliding speed, disk with ω₀R = v₀",
        Axis::linear("time [v₀^(1−α)/(γg)]").range(0.0, END),
        Axis::linear("v/v₀").range(0.0, 1.0),
    );
    for alpha in [0.0, 1.0, 3.0] {
        let slider = disk(alpha)?;
        let start = Motion::launched(START, START);
        let curve: Vec<_> = times
            .iter()
            .map(|&time| (time, slider.advance(&start, time).motion.speed))
            .collect();
        for (row, (_, speed)) in rows.iter_mut().zip(&curve) {
            row.push(*speed);
        }
        figure = figure.series(Series::line(format!("α = {alpha}"), curve));
    }
    let mut claims = laws_of_fading()?;
    claims.extend(travel()?);
    claims.push(dimensionless_equation()?);
    Ok(Exhibit {
        heading: "Figure 3.11: stopping times".into(),
        text: vec![
            "Below α = 1 the body rests after a finite time, at α = 1 it fades exponentially, \
             above only with a power of time. The stepper follows each to rounding accuracy."
                .into(),
        ],
        film: None,
        caption: "Under dry friction the disk stops; under linear and cubic friction it never \
                  does."
            .into(),
        drawing: Box::new(figure),
        columns: vec!["time", "speed_alpha_0", "speed_alpha_1", "speed_alpha_3"],
        rows,
        claims,
    })
}

/// Eq. 3.34 and the exponential, against the stepper.
fn laws_of_fading() -> Result<Vec<Claim>> {
    let sliding = Motion::launched(START, 0.0);
    let speed_at = |alpha: f64, time: f64| -> Result<f64> {
        Ok(disk(alpha)?.advance(&sliding, time).motion.speed)
    };
    // v = [1 − (1 − α) t]^(1/(1−α))
    let fading = |alpha: f64, time: f64| (1.0 - (1.0 - alpha) * time).powf(1.0 / (1.0 - alpha));
    let mut claims = Vec::new();
    for (alpha, time) in [(0.0, 0.7), (0.5, 1.3), (2.0, 20.0), (3.0, 1e4)] {
        let deviation = (speed_at(alpha, time)? / fading(alpha, time) - 1.0).abs();
        let what = format!("v at t = {time} for α = {alpha}, pure sliding");
        claims.push(Claim::formula(
            "eq. 3.34", &what, deviation, 1e-13, "relative",
        ));
    }
    let spinning = Motion::launched(START, START);
    let decay = disk(1.0)?.advance(&spinning, END).motion.speed;
    claims.push(Claim::formula(
        "3.4.5",
        "α = 1: exponential, v at t = 5, spinning or not",
        (decay / (-END).exp() - 1.0).abs(),
        1e-13,
        "v = exp(−t), relative",
    ));
    let rests = |alpha: f64| -> Result<bool> { Ok(disk(alpha)?.to_rest(&spinning).is_some()) };
    claims.push(Claim::trend(
        "3.4.5",
        "α < 1: rest in finite time",
        "α = 0, 0.5, 0.9 rest".into(),
        rests(0.0)? && rests(0.5)? && rests(0.9)?,
        "finite time",
    ));
    claims.push(Claim::trend(
        "3.4.5",
        "α ≥ 1: this takes infinite time",
        "α = 1, 3 never rest".into(),
        !rests(1.0)? && !rests(3.0)?,
        "infinite time",
    ));
    let exponent = |alpha: f64| 1.0 / (1.0 - alpha);
    claims.push(Claim::refutation(
        "after 3.34",
        "For α < 1 the exponent 1/(1−α) is larger than one",
        format!(
            "1 for α = 0, {:.3} for α = −0.5, and the body still rests in finite time",
            exponent(-0.5)
        ),
        exponent(0.0) == 1.0 && exponent(-0.5) < 1.0 && rests(-0.5)?,
        "only for 0 < α < 1; stopping in finite time needs a positive exponent, no more",
    ));
    Ok(claims)
}

/// Eq. 3.26 against a disk with dimensions: m, s, and γ = 1 for α = 3.
fn dimensionless_equation() -> Result<Claim> {
    let (alpha, gravity, radius, speed) = (3.0, 9.81, 0.08, 1.3);
    let slider = Slider::new(
        table(alpha)?,
        SliderParameters {
            deceleration: gravity,
            radius,
            inertia_ratio: 0.5,
        },
    )?;
    let power = slider.dissipation_per_mass(&Motion::launched(speed, 0.0));
    let scale = f64::sqrt(gravity * radius);
    // dv*/dt* over (v*)³, from the deceleration P/(M v) of the body.
    let ours = power / speed / gravity / (speed / scale).powi(3);
    Ok(Claim::erratum(
        "eq. 3.26",
        "α = 3: dv*/dt* over γ (v*)³ for pure sliding, g = 9.81, R = 0.08",
        ("1", 1.0),
        (ours, (gravity * radius).powf(alpha / 2.0)),
        "the factor (g R_c)^(α/2) is missing, unless γ absorbs it; 3.27 is not affected",
    )
    .printed(""))
}

/// Spinning disks travel farther; both motions stop together.
fn travel() -> Result<Vec<Claim>> {
    let slider = disk(0.0)?;
    let mut distances = Vec::new();
    let mut together = true;
    for spin in [0.0, 0.5, 1.0, 2.0, 4.0] {
        let mut motion = Motion::launched(START, spin);
        // With fixed steps: the last moving state still slides and spins.
        let rest = loop {
            let step = slider.advance(&motion, 0.01);
            match step.rest {
                Some(rest) => break rest,
                None => motion = step.motion,
            }
        };
        together &= spin == 0.0 || (motion.speed > 0.0 && motion.spin > 0.0);
        distances.push(rest.motion.distance);
    }
    let farther = distances.windows(2).all(|w| w[1] > w[0]);
    let shown: Vec<String> = distances.iter().map(|x| format!("{x:.4}")).collect();
    Ok(vec![
        Claim::trend(
            "3.1",
            "The spinning disk slides farther; ω₀R/v₀ = 0, 0.5, 1, 2, 4",
            format!("distances {}", shown.join(", ")),
            farther,
            "order",
        ),
        Claim::trend(
            "3.1",
            "Sliding and spinning stop at the same time (α = 0, C = 1/2)",
            "same step of 0.01 for every spin".into(),
            together,
            "same time, to the step",
        ),
    ])
}
