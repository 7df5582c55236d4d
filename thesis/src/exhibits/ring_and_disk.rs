//! Figure 3.1 and section 3.1: how long and how far a ring and a disk slide and spin.

use crate::exhibit::{Exhibit, linear, points};
use crate::reference_integration::{Points, to_rest};
use crate::text::Text;
use anyhow::{Context, Result};
use tribos_core::coupling::round::RoundTable64;
use tribos_core::patch::PowerPressure;
use tribos_core::slider::{Slider, SliderParameters, SliderRest, SliderState};
use tribos_report::claim::Claim;
use tribos_report::digits::short;
use tribos_report::figure::{Axis, Color, Figure, Legend, Panels, Series};
use tribos_report::verdict::Allowance;

const TEXT: Text = Text(include_str!("figure-3.1.md"));

/// Largest spin of a launch with v₀ = 1, as ω₀R.
const FASTEST: f64 = 4.0;
/// 1/F(ε₀) of the disk, from 3.17 and 3.18 at 40 digits (mpmath).
const DISK_TIME: f64 = 1.623_288_572_593_526_5;
/// Relative error of the direct integration: points, steps, and the rest that it leaves out.
const DIRECT: f64 = 2e-3;

/// A free ring or disk with μg = 1 and R = 1.
struct Body {
    name: &'static str,
    slider: Slider<f64, RoundTable64>,
    /// C = I/(M R²).
    inertia: f64,
    /// T(0).
    torque: f64,
    points: Points,
}

impl Body {
    fn new(
        name: &'static str,
        pressure: PowerPressure,
        torque: f64,
        points: Points,
    ) -> Result<Self> {
        // A ring or a disk of even thickness: C is the mean of r².
        let inertia = pressure.mean_square_radius();
        let parameters = SliderParameters {
            deceleration: 1.0,
            radius: 1.0,
            inertia_ratio: inertia,
        };
        Ok(Self {
            name,
            slider: Slider::new(RoundTable64::new(0.0, pressure)?, parameters)?,
            inertia,
            torque,
            points,
        })
    }

    fn ring() -> Result<Self> {
        Self::new("ring", PowerPressure::RING, 1.0, Points::ring(720))
    }

    fn disk() -> Result<Self> {
        Self::new(
            "disk",
            PowerPressure::UNIFORM,
            2.0 / 3.0,
            Points::disk(32, 32),
        )
    }

    fn stop(&self, speed: f64, spin: f64) -> Result<SliderRest<f64>> {
        let rest = self.slider.to_rest(&SliderState::launched(speed, spin));
        rest.context("dry friction brings every body to rest")
    }

    /// Times in which the slide and the spin would end if neither knew of the other.
    fn alone(&self, speed: f64, spin: f64) -> [f64; 2] {
        [speed, self.inertia * spin / self.torque]
    }
}

/// Stopping times and distances over the launch.
pub fn figure_3_1() -> Result<Exhibit> {
    let bodies = [Body::disk()?, Body::ring()?];
    let mut rows = Vec::new();
    for spin in linear(0.0, FASTEST, 160) {
        let mut row = vec![spin];
        for body in &bodies {
            let rest = body.stop(1.0, spin)?.motion;
            let [slide, turn] = body.alone(1.0, spin);
            row.extend([rest.time, rest.distance, rest.angle, slide.max(turn)]);
        }
        rows.push(row);
    }
    let claims = [ratios(&bodies)?, stops(&bodies)?, numbers(&bodies)?].concat();
    Ok(Exhibit::new(
        TEXT.prose(),
        drawing(&bodies, &rows),
        &[
            "spin",
            "disk_time",
            "disk_distance",
            "disk_angle",
            "disk_uncoupled_time",
            "ring_time",
            "ring_distance",
            "ring_angle",
            "ring_uncoupled_time",
        ],
        rows,
        claims,
    ))
}

/// Times on the left, distances on the right.
fn drawing(bodies: &[Body; 2], rows: &[Vec<f64>]) -> Panels {
    let spin = || Axis::linear("spin at launch ω₀R/v₀").range(0.0, FASTEST);
    let mut times = Figure::new("", spin(), Axis::linear("time [v₀/(μg)]"));
    let mut ways = Figure::new("", spin(), Axis::linear("distance [v₀²/(μg)]"));
    for (i, body) in bodies.iter().enumerate() {
        let (column, color) = (1 + 4 * i, Color::palette(i));
        let line = |column| Series::line(body.name, points(rows, 0, column)).color(color);
        let alone = points(rows, 0, column + 3);
        times = times
            .series(line(column))
            .series(Series::dashed(format!("{}, uncoupled", body.name), alone).color(color));
        ways = ways.series(line(column + 1));
    }
    ways = ways.series(
        Series::dashed("without coupling", vec![(0.0, 0.5), (FASTEST, 0.5)])
            .color(Color(90, 90, 90)),
    );
    let title = "How long and how far a disk and a ring slide under dry friction";
    Panels::new(title, 2)
        .figure(times.legend(Legend::Below))
        .figure(ways.legend(Legend::Below))
}

/// The ratios of the last instant, and that both motions have one.
fn ratios([disk, ring]: &[Body; 2]) -> Result<Vec<Claim>> {
    let spins = [0.05, 0.5, 1.0, 2.0, 20.0];
    let (mut together, mut worst) = (true, 0.0_f64);
    for body in [disk, ring] {
        let last = body.stop(1.0, 1.0)?.ratio;
        for spin in spins {
            let rest = body.stop(1.0, spin)?;
            worst = worst.max((rest.ratio / last - 1.0).abs());
            // The last thousandth of the time still slides and spins.
            let late = body
                .slider
                .advance(&SliderState::launched(1.0, spin), 0.999 * rest.motion.time);
            together &= late.motion.speed > 0.0 && late.motion.spin > 0.0;
        }
    }
    let ratio = ring.stop(1.0, 2.0)?.ratio;
    Ok(vec![
        Claim::stated(
            TEXT.said("ring-ratio"),
            ("1", 1.0),
            1.0 / ratio,
            Allowance::Exact(1e-12),
        ),
        Claim::trend(
            TEXT.said("together"),
            "10 launches; final ratios alike to 1e-12",
            together && worst < 1e-12,
        ),
    ])
}

/// Longer, farther, straight.
fn stops(bodies: &[Body; 2]) -> Result<Vec<Claim>> {
    let (mut slower, mut longer, mut farther) = (true, true, true);
    let mut most = [0.0_f64; 2];
    for (body, most) in bodies.iter().zip(&mut most) {
        let mut way = 0.5;
        for spin in linear(0.1, FASTEST, 39) {
            let rest = body.stop(1.0, spin)?.motion;
            let [slide, turn] = body.alone(1.0, spin);
            slower &= rest.time > slide;
            longer &= rest.time > turn;
            farther &= rest.distance > way;
            way = rest.distance;
            *most = most.max(rest.time / slide.max(turn));
        }
    }
    let row = |id, shown: String, holds| Claim::trend(TEXT.said(id), shown, holds);
    let launches = || "40 launches of each, 0.1 ≤ ω₀R/v₀ ≤ 4".to_owned();
    let aside = aside(bodies);
    let [disk, ring] = most.map(|most| short((1e4 * (most - 1.0)).round() / 100.0));
    Ok(vec![
        row("longer-than-slide", launches(), slower),
        row("longer-than-spin", launches(), longer),
        row("farther", launches(), farther),
        row(
            "straight",
            "less than 1e-12 of the way to the side".to_owned(),
            aside < 1e-12,
        ),
        Claim::own_statement(
            TEXT.said("uncoupled"),
            format!("disk by {disk} %, ring by {ring} % at most"),
            slower && longer,
        ),
    ])
}

/// Largest way to the side of bodies on points, for four distributions of the mass.
fn aside(bodies: &[Body; 2]) -> f64 {
    let mut most = 0.0_f64;
    for body in bodies {
        for inertia in [0.2, 0.5, 1.0, 3.0] {
            let friction = |v| body.points.friction(v, 0.0, [0.0; 2]);
            let stop = to_rest(friction, 0.0, inertia, [1.0, 0.0, 1.3]);
            most = most.max((stop.place[1] / stop.place[0]).abs());
        }
    }
    most
}

/// Two stops in closed form, and all against the points.
fn numbers([disk, ring]: &[Body; 2]) -> Result<Vec<Claim>> {
    use std::f64::consts::{FRAC_PI_2, FRAC_PI_4};
    let kept = ring.stop(1.0, 1.0)?.motion;
    let ratio = disk.stop(1.0, 1.0)?.ratio;
    let disk_kept = disk.stop(1.0, 1.0 / ratio)?.motion;
    let mut worst = 0.0_f64;
    for body in [disk, ring] {
        for (speed, spin) in [(1.0, 0.3), (1.0, 1.5), (0.4, 2.0)] {
            let rest = body.stop(speed, spin)?.motion;
            let friction = |v| body.points.friction(v, 0.0, [0.0; 2]);
            let other = to_rest(friction, 0.0, body.inertia, [speed, 0.0, spin]);
            for (ours, theirs) in [
                (rest.time, other.time),
                (rest.distance, other.place[0]),
                (rest.angle, other.angle),
            ] {
                worst = worst.max((ours / theirs - 1.0).abs());
            }
        }
    }
    Ok(vec![
        Claim::own(TEXT.said("ring-time"), kept.time, FRAC_PI_2, 1e-13),
        Claim::own(TEXT.said("ring-distance"), kept.distance, FRAC_PI_4, 1e-13),
        Claim::own(TEXT.said("disk-time"), disk_kept.time, DISK_TIME, 1e-12),
        Claim::own_statement(
            TEXT.said("direct"),
            format!("relative deviation {worst:.0e} at most"),
            worst < DIRECT,
        ),
    ])
}
