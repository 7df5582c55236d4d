//! Figure 3.11: how a motion fades for different exponents, and who travels farther.

use crate::exhibit::{Exhibit, linear, table};
use crate::text::Text;
use anyhow::Result;
use tribos_core::coupling::table::DiskTable64;
use tribos_core::slider::{Slider, SliderParameters, SliderState};
use tribos_report::claim::Claim;
use tribos_report::figure::{Axis, Figure, Series};

const TEXT: Text = Text(include_str!("figure-3.11.md"));

/// Disk with γg = 1 and R = 1.
fn disk(alpha: f64) -> Result<Slider<f64, DiskTable64>> {
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
        let start = SliderState::launched(START, START);
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
    Ok(Exhibit::new(
        TEXT.prose(),
        figure,
        &["time", "speed_alpha_0", "speed_alpha_1", "speed_alpha_3"],
        rows,
        claims,
    ))
}

/// Eq. 3.34 and the exponential, against the stepper.
fn laws_of_fading() -> Result<Vec<Claim>> {
    let sliding = SliderState::launched(START, 0.0);
    let speed_at = |alpha: f64, time: f64| -> Result<f64> {
        Ok(disk(alpha)?.advance(&sliding, time).motion.speed)
    };
    // v = [1 − (1 − α) t]^(1/(1−α))
    let fading = |alpha: f64, time: f64| (1.0 - (1.0 - alpha) * time).powf(1.0 / (1.0 - alpha));
    let mut claims = Vec::new();
    for (alpha, time) in [(0.0, 0.7), (0.5, 1.3), (2.0, 20.0), (3.0, 1e4)] {
        let deviation = (speed_at(alpha, time)? / fading(alpha, time) - 1.0).abs();
        claims.push(Claim::formula(
            TEXT.said("fading").with("time", time).with("alpha", alpha),
            deviation,
            1e-13,
        ));
    }
    let spinning = SliderState::launched(START, START);
    let decay = disk(1.0)?.advance(&spinning, END).motion.speed;
    claims.push(Claim::formula(
        TEXT.said("exponential"),
        (decay / (-END).exp() - 1.0).abs(),
        1e-13,
    ));
    let rests = |alpha: f64| -> Result<bool> { Ok(disk(alpha)?.to_rest(&spinning).is_some()) };
    claims.push(Claim::trend(
        TEXT.said("finite-time"),
        "α = 0, 0.5, 0.9 rest",
        rests(0.0)? && rests(0.5)? && rests(0.9)?,
    ));
    claims.push(Claim::trend(
        TEXT.said("infinite-time"),
        "α = 1, 3 never rest",
        !rests(1.0)? && !rests(3.0)?,
    ));
    let exponent = |alpha: f64| 1.0 / (1.0 - alpha);
    claims.push(Claim::refutation(
        TEXT.said("exponent"),
        format!(
            "1 for α = 0, {:.3} for α = −0.5, and the body still rests in finite time",
            exponent(-0.5)
        ),
        exponent(0.0) == 1.0 && exponent(-0.5) < 1.0 && rests(-0.5)?,
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
    let power = slider.dissipation_per_mass(&SliderState::launched(speed, 0.0));
    let scale = f64::sqrt(gravity * radius);
    // dv*/dt* over (v*)³, from the deceleration P/(M v) of the body.
    let ours = power / speed / gravity / (speed / scale).powi(3);
    Ok(Claim::erratum(
        TEXT.said("dimensionless"),
        ("1", 1.0),
        (ours, (gravity * radius).powf(alpha / 2.0)),
    )
    .printed(""))
}

/// Spinning disks travel farther; both motions stop together.
fn travel() -> Result<Vec<Claim>> {
    let slider = disk(0.0)?;
    let mut distances = Vec::new();
    let mut together = true;
    for spin in [0.0, 0.5, 1.0, 2.0, 4.0] {
        let mut motion = SliderState::launched(START, spin);
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
            TEXT.said("farther"),
            format!("distances {}", shown.join(", ")),
            farther,
        ),
        Claim::trend(
            TEXT.said("together"),
            "same step of 0.01 for every spin",
            together,
        ),
    ])
}
