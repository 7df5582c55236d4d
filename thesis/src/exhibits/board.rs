//! Section 3.1: a board on a ring, on a disk and on three feet, whose mass sits farther out or in.

use crate::exhibit::{Exhibit, linear, points};
use crate::reference_integration::{Points, to_rest};
use crate::text::Text;
use anyhow::{Context, Result};
use std::f64::consts::{FRAC_1_SQRT_2, SQRT_2, TAU};
use tribos_core::contact::TimeStep;
use tribos_core::coupling::round::RoundTable64;
use tribos_core::modes::{TerminalMode, TerminalMotion};
use tribos_core::patch::PowerPressure;
use tribos_core::patch::nodes::{Node, Nodes};
use tribos_core::planar::{PlanarBody, PointContacts};
use tribos_core::slider::{Slider, SliderParameters, SliderState};
use tribos_core::twist::{Twist, Wrench};
use tribos_report::claim::Claim;
use tribos_report::figure::{Axis, Figure, Legend, ReferenceLine, Series};

const TEXT: Text = Text(include_str!("section-3.1-board.md"));

/// Radii of the board's mass below, between and above the ring's borders.
const BOARDS: [f64; 3] = [0.6, 1.0, 1.6];
/// Spins ω₀R of the launches with v₀ = 1.
const SPINS: [f64; 4] = [0.2, 0.7, 1.5, 5.0];

/// What points at a thousandth and a thousand of the speeds leave of a border.
const BORDER: f64 = 1e-3;
/// Implicit steps on three feet, as a share of the time in which the present speed would fade, and
/// the fraction of the launch at which they end.
const SHARE: f64 = 0.02;
const FADED: f64 = 1e-4;
/// A centre of rotation this near to a foot, in radii, is that foot.
const PIVOT: f64 = 1e-2;

/// A board on a round support with μg = R = 1 and its mass at this radius: C is its square.
fn board(pressure: PowerPressure, radius: f64) -> Result<Slider<f64, RoundTable64>> {
    let parameters = SliderParameters {
        deceleration: 1.0,
        radius: 1.0,
        inertia_ratio: radius * radius,
    };
    Ok(Slider::new(RoundTable64::new(0.0, pressure)?, parameters)?)
}

/// The ratio at which a board that is thrown at v = ωR ends.
fn end(pressure: PowerPressure, radius: f64) -> Result<f64> {
    let rest = board(pressure, radius)?.to_rest(&SliderState::launched(1.0, 1.0));
    Ok(rest
        .context("dry friction brings every body to rest")?
        .ratio)
}

/// Final ratios over the radius of the mass.
pub fn section_3_1_board() -> Result<Exhibit> {
    let mut rows = Vec::new();
    for radius in linear(0.4, 1.8, 280) {
        let ends = [PowerPressure::RING, PowerPressure::UNIFORM].map(|p| end(p, radius));
        let [ring, disk] = ends;
        rows.push(vec![radius, ring?, disk?]);
    }
    let curve = |column| {
        let shown = points(&rows, 0, column).into_iter();
        shown
            .filter(|(_, ratio)| *ratio > 0.0 && ratio.is_finite())
            .collect::<Vec<_>>()
    };
    let figure = Figure::new(
        "Final velocity ratio of a board: left of a curve it slides in the end, right of it it spins",
        Axis::linear("radius of the mass over that of the support").range(0.4, 1.8),
        Axis::log10("final ratio v/(ωR)").range(0.05, 20.0),
    )
    .series(Series::line("on a ring", curve(1)))
    .series(Series::line("on a disk", curve(2)))
    .guide(ReferenceLine::vertical(FRAC_1_SQRT_2, "1/√2"))
    .guide(ReferenceLine::vertical(SQRT_2, "√2"))
    .legend(Legend::Below);
    let claims = [round_supports()?, three_feet()?].concat();
    Ok(Exhibit::new(
        TEXT.prose(),
        figure,
        &["mass_radius", "ring_final_ratio", "disk_final_ratio"],
        rows,
        claims,
    ))
}

/// Boards on a ring and on a disk.
fn round_supports() -> Result<Vec<Claim>> {
    let (ring, disk) = (Points::ring(720), Points::disk(200, 64));
    let mut modes = [true; 3];
    for spin in SPINS {
        for (radius, right) in BOARDS.into_iter().zip(&mut modes) {
            let friction = |v| ring.friction(v, 0.0, [0.0; 2]);
            let ratio = to_rest(friction, 0.0, radius * radius, [1.0, 0.0, spin]).ratio;
            // The slow approach to the end has passed this much of it.
            let found = if ratio > 3.0 {
                f64::INFINITY
            } else if ratio < 0.3 {
                0.0
            } else {
                1.0
            };
            let motion = SliderState::launched(1.0, spin);
            let kernel = board(PowerPressure::RING, radius)?.to_rest(&motion);
            let kernel = kernel
                .context("dry friction brings every body to rest")?
                .ratio;
            *right &= kernel == found || (kernel - found).abs() < 1e-12;
        }
    }
    let mut claims = vec![Claim::trend(
        TEXT.said("three-modes"),
        "radii 0.6, 1, 1.6 of the ring's: slides, both (ratio 1), spins; 4 launches of each",
        modes == [true; 3] && end(PowerPressure::RING, BOARDS[0])? == f64::INFINITY,
    )];
    // C where the sums of the points are almost a pure slide or a pure spin.
    let border = |points: &Points, ratio: f64| {
        let [force, torque] = points.reduced(0.0, ratio);
        (ratio * torque / force).sqrt()
    };
    let interval = |pressure| -> Result<(f64, f64)> {
        let modes = TerminalMotion::new(RoundTable64::new(0.0, pressure)?, 1.0)?;
        Ok(modes.inertia_interval())
    };
    let (ring_low, ring_high) = interval(PowerPressure::RING)?;
    let (disk_low, disk_high) = interval(PowerPressure::UNIFORM)?;
    for (id, ours, other) in [
        ("ring-slides", ring_low, border(&ring, 1e3)),
        ("ring-spins", ring_high, border(&ring, 1e-3)),
        ("disk-slides", disk_low, border(&disk, 1e3)),
        ("disk-spins", disk_high, border(&disk, 1e-3)),
    ] {
        claims.push(Claim::own(TEXT.said(id), ours.sqrt(), other, BORDER));
    }
    claims.push(depends()?);
    Ok(claims)
}

/// Law, pressure and mass each change the final motion of one board.
fn depends() -> Result<Claim> {
    let mode = |alpha: f64, pressure, radius: f64, launch: f64| -> Result<TerminalMode<f64>> {
        let modes = TerminalMotion::new(RoundTable64::new(alpha, pressure)?, radius * radius)?;
        Ok(modes.terminal_mode(launch))
    };
    let (ring, disk) = (PowerPressure::RING, PowerPressure::UNIFORM);
    let together = matches!(mode(0.0, ring, 0.9, 1.0)?, TerminalMode::Together { .. });
    let on_disk = mode(0.0, disk, 0.9, 1.0)? == TerminalMode::Spinning;
    let heavier = mode(0.0, ring, 1.6, 1.0)? == TerminalMode::Spinning;
    let cubic = [0.1, 10.0].map(|launch| mode(3.0, ring, 0.9, launch));
    let [slow, fast] = cubic;
    let by_launch = slow? == TerminalMode::Spinning && fast? == TerminalMode::Sliding;
    Ok(Claim::trend(
        TEXT.said("depends"),
        "mass at 0.9: both stop together on a ring, on a disk it spins; mass at 1.6: it spins on the \
         ring too; at 0.9 and α = 3 the launch decides",
        together && on_disk && heavier && by_launch,
    ))
}

/// Places of three feet on the circle of radius 1.
fn feet() -> [[f64; 2]; 3] {
    [0.0, 1.0, 2.0].map(|third| {
        let angle = TAU * third / 3.0;
        [angle.cos(), angle.sin()]
    })
}

/// The distance of the centre of rotation from the nearest foot just before rest, in radii, for a
/// board on three feet that is thrown at v = 1.
fn last_pivot(inertia: f64, heading: f64, spin: f64) -> Result<f64> {
    let nodes = Nodes::new(feet().map(|[x, y]| Node { x, y, weight: 1.0 }))?;
    let mut foot = PointContacts::<f64, _, 3>::new(nodes, 1.0)?;
    let body = PlanarBody::new(1.0, inertia)?;
    let mut twist = Twist::new(heading.cos(), heading.sin(), spin);
    let size = |twist: &Twist<f64>| twist.velocity.norm().hypot(twist.spin);
    let start = size(&twist);
    while size(&twist) > FADED * start {
        let dt = SHARE * size(&twist);
        let step = body.step_on_points(&mut foot, &twist, &Wrench::ZERO, TimeStep::new(dt)?);
        // The feet turn with the board: the velocity is kept in their frame.
        let turned = 0.5 * dt * (twist.spin + step.twist.spin);
        let (sin, cos) = turned.sin_cos();
        let [x, y] = [step.twist.velocity.x, step.twist.velocity.y];
        twist = Twist::new(cos * x + sin * y, cos * y - sin * x, step.twist.spin);
    }
    let centre = [
        -twist.velocity.y / twist.spin,
        twist.velocity.x / twist.spin,
    ];
    let away = |[x, y]: [f64; 2]| (centre[0] - x).hypot(centre[1] - y);
    Ok(feet().map(away).into_iter().fold(f64::INFINITY, f64::min))
}

/// Launches of a board on three feet, and how many of them end as a turn about one foot.
fn pivots(inertia: f64) -> Result<[usize; 2]> {
    let mut counts = [0, 0];
    for heading in [0.1, 0.5, 0.9] {
        for spin in [-3.0, 0.4, 1.1, 6.0] {
            counts[0] += 1;
            counts[1] += usize::from(last_pivot(inertia, heading, spin)? < PIVOT);
        }
    }
    Ok(counts)
}

/// Three feet in place of the ring.
fn three_feet() -> Result<Vec<Claim>> {
    let feet = Points::ring(3);
    // C where the feet almost only slide or spin, whichever way they face.
    let border = |heading: f64, ratio: f64| {
        let (sin, cos) = heading.sin_cos();
        let [x, y, torque] = feet.friction([ratio * cos, ratio * sin, 1.0], 0.0, [0.0; 2]);
        ratio * torque / (x * cos + y * sin)
    };
    let mut deviation = 0.0_f64;
    for heading in [0.0, 0.3, 0.7, 1.0] {
        for (ratio, value) in [(1e3, 0.5), (1e-3, 2.0)] {
            deviation = deviation.max((border(heading, ratio) - value).abs());
        }
    }
    let [[_, below], [all, inside], [_, beside], [_, above]] =
        [pivots(0.25)?, pivots(1.0)?, pivots(3.0)?, pivots(3.9)?];
    Ok(vec![
        Claim::own_statement(
            TEXT.said("feet-borders"),
            "1/2 and 2 for four headings",
            deviation < 2.0 * BORDER,
        ),
        Claim::own_statement(
            TEXT.said("pivots"),
            format!(
                "of {all} launches each, {below} at C = 0.25, {inside} at C = 1, {beside} at C = 3, \
                 {above} at C = 3.9"
            ),
            below == 0 && inside == all && beside > 0 && beside < all && above == 0,
        ),
    ])
}
