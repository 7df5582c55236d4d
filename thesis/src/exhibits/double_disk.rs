//! Figure 3.13: final motion of the double disk.

use crate::exhibit::{Exhibit, table};
use crate::text::Text;
use anyhow::Result;
use tribos_core::coupling::table::DiskTable64;
use tribos_core::modes::{TerminalMode, TerminalMotion, inertia_interval};
use tribos_core::slider::{Slider, SliderParameters, SliderState};
use tribos_report::claim::Claim;
use tribos_report::figure::{Axis, Figure, Legend, Panels, Series};
use tribos_report::verdict::Allowance;

const TEXT: Text = Text(include_str!("figure-3.13.md"));

/// Launch ratios of every panel; the fixed point of the disk joins them.
const LAUNCHES: [f64; 6] = [0.1, 0.25, 0.5, 0.8, 1.5, 4.0];
/// The runs end when both speeds are below this fraction of their start.
const FADED: f64 = 1e-4;
/// A record per this fraction of the fading time.
const FRACTION: f64 = 0.02;
/// Ratios of radii R/R_c below, inside and above the interval, for α = 0 and α = 3.
const RADII: [(f64, [f64; 3]); 2] = [(0.0, [0.69, 1.0, 1.18]), (3.0, [0.8, 1.0, 1.44])];

/// One run: spin over its start, and ε, until both speeds have faded.
fn follow(slider: &Slider<f64, DiskTable64>, alpha: f64, launch: f64) -> Vec<(f64, f64)> {
    let start = SliderState::launched(launch, 1.0);
    let mut motion = start;
    let mut points = Vec::new();
    while motion.speed > FADED * start.speed || motion.spin > FADED * start.spin {
        points.push((motion.spin, slider.ratio(&motion)));
        // γg = R = 1: the fading time of the larger speed.
        let fading = motion.speed.max(motion.spin).powf(1.0 - alpha);
        motion = slider.advance(&motion, FRACTION * fading).motion;
        if motion.is_at_rest() {
            break;
        }
    }
    points
}

/// Six panels: two exponents, three ratios of radii.
pub fn figure_3_13() -> Result<Exhibit> {
    let mut panels = Panels::new(
        "Velocity ratio of the double disk while it slows down (right to left)",
        3,
    );
    let mut rows = Vec::new();
    let mut claims = bounds()?;
    claims.push(kept_by_verlet());
    for (alpha, radii) in RADII {
        let table = table(alpha)?;
        let disk = TerminalMotion::new(&table, 0.5)?;
        let fixed = disk.finite_fixed_point().unwrap_or(f64::NAN);
        for radius in radii {
            let inertia = 0.5 * radius * radius;
            let slider = Slider::new(
                table,
                SliderParameters {
                    deceleration: 1.0,
                    radius: 1.0,
                    inertia_ratio: inertia,
                },
            )?;
            let modes = TerminalMotion::new(&table, inertia)?;
            let mut figure = Figure::new(
                format!("α = {alpha}, R/R_c = {radius}"),
                Axis::log10("ω/ω₀").range(1e-4, 1.0),
                Axis::log10("ε").range(1e-2, 1e2),
            )
            .legend(Legend::Hidden);
            let mut right = 0;
            for launch in LAUNCHES.into_iter().chain([fixed]) {
                let points = follow(&slider, alpha, launch);
                right += usize::from(ends_at_predicted_mode(&modes, launch, &points));
                rows.extend(
                    points
                        .iter()
                        .map(|&(spin, ratio)| vec![alpha, radius, launch, spin, ratio]),
                );
                let line = if launch == fixed {
                    Series::dashed
                } else {
                    Series::line
                };
                figure = figure.series(line(format!("{launch:.3}"), points));
            }
            claims.push(panel_claim(alpha, radius, right));
            panels = panels.figure(figure);
        }
    }
    Ok(Exhibit::new(
        TEXT.prose(),
        panels.cell(300, 260).zoom(1.25),
        &["alpha", "radius_ratio", "launch_ratio", "spin", "ratio"],
        rows,
        claims,
    ))
}

/// True if the run moves from its launch towards the end that the fixed points foretell.
fn ends_at_predicted_mode<P: tribos_core::coupling::PowerLawFriction<f64>>(
    modes: &TerminalMotion<f64, P>,
    launch: f64,
    points: &[(f64, f64)],
) -> bool {
    let Some(&(_, last)) = points.last() else {
        return false;
    };
    match modes.terminal_mode(launch) {
        TerminalMode::Spinning => last < launch,
        TerminalMode::Sliding => last > launch,
        TerminalMode::Together { ratio } => {
            (last - ratio).abs() <= (launch - ratio).abs() + 1e-9 * ratio
        }
    }
}

fn panel_claim(alpha: f64, radius: f64, right: usize) -> Claim {
    let (low, high) = inertia_interval(alpha, 0.0);
    let c = 0.5 * radius * radius;
    let end = match (alpha, c < low, c > high) {
        (_, true, _) => "all ε → ∞",
        (_, _, true) => "all ε → 0",
        (0.0, ..) => "all ε → ε₀",
        _ => "ε → 0 or ∞, separated by ε₀",
    };
    let all = LAUNCHES.len() + 1;
    Claim::trend(
        TEXT.said("panel")
            .with("alpha", alpha)
            .with("radius", radius)
            .with("end", end),
        format!("{right} of {all} launches"),
        right == all,
    )
}

/// The launch at the unstable fixed point of α = 3 and C = 1/2, by the velocity form of Verlet's method
/// with 3.21 and 3.22, the speed predicted and corrected.
fn kept_by_verlet() -> Claim {
    let rates = |[v, w]: [f64; 2]| [-v * (v * v + w * w), -2.0 * w * (v * v + w * w / 3.0)];
    let fixed = f64::sqrt(1.0 / 3.0);
    let (mut motion, mut worst) = ([fixed, 1.0], 0.0_f64);
    while motion[1] > FADED {
        let step = FRACTION * motion[1].powi(-2);
        let before = rates(motion);
        let ahead = [0, 1].map(|i| motion[i] + step * before[i]);
        let after = rates(ahead);
        motion = [0, 1].map(|i| motion[i] + 0.5 * step * (before[i] + after[i]));
        worst = worst.max((motion[0] / motion[1] / fixed - 1.0).abs());
    }
    Claim::trend(
        TEXT.said("kept"),
        format!("leaves it by {worst:.1e}, relative"),
        worst < 1e-6,
    )
}

/// Eqs. 3.35 and 3.36, from the inertia ratios of fixed points at both ends of ε.
fn bounds() -> Result<Vec<Claim>> {
    /// So near to the ends that the next terms, of order ε², do not count.
    const FAR: f64 = 1e9;
    let ends = |alpha: f64| -> Result<[f64; 2]> {
        let modes = TerminalMotion::new(table(alpha)?, 0.5)?;
        Ok([1.0 / FAR, FAR].map(|ratio| (2.0 * modes.inertia_ratio_of(ratio)).sqrt()))
    };
    let ([dry_high, dry_low], [cubic_low, cubic_high]) = (ends(0.0)?, ends(3.0)?);
    let rows = [
        ("eq. 3.35", "Lower", 0, ("1/√2", 0.5_f64.sqrt()), dry_low),
        (
            "eq. 3.35",
            "Upper",
            0,
            ("2/√3", 2.0 / 3f64.sqrt()),
            dry_high,
        ),
        (
            "eq. 3.36",
            "Lower",
            3,
            ("√(2/3)", (2.0 / 3.0_f64).sqrt()),
            cubic_low,
        ),
        ("eq. 3.36", "Upper", 3, ("√2", 2f64.sqrt()), cubic_high),
    ];
    let rows = rows
        .into_iter()
        .map(|(place, which, alpha, printed, ours)| {
            Claim::stated(
                TEXT.said("bound")
                    .with("place", place)
                    .with("which", which)
                    .with("alpha", alpha),
                printed,
                ours,
                Allowance::Exact(1e-14),
            )
        });
    Ok(rows.collect())
}
