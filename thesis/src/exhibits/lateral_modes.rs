//! Sections 3.6 and 5.1: the final motion of tall bodies, whose pressure leans and whose friction has
//! a lateral component.

use super::pressure::PRESSURES;
use crate::exhibit::{Exhibit, geometric, linear};
use crate::reference_integration::{Points, slowed, to_rest};
use crate::text::Text;
use anyhow::{Context, Result};
use tribos::slide::planar::{
    Gradient, Launch, PlanarSimulation, PlanarState, TallBody, TallCylinder,
};
use tribos_core::coupling::DryProfile;
use tribos_core::coupling::round::RoundTable64;
use tribos_core::internals::LeanProfile;
use tribos_core::modes::{Stability, TerminalMotion};
use tribos_core::patch::PowerPressure;
use tribos_report::claim::Claim;
use tribos_report::digits::short;
use tribos_report::figure::{Axis, Figure, Legend, ReferenceLine, Series};

const TEXT: Text = Text(include_str!("section-5.1-lateral.md"));

/// Largest λ shown: with λ ≤ 1 no body tips, whatever its motion.
const MOST: f64 = 1.0;
/// λ of the bodies that are integrated.
const LEAN: f64 = 0.8;
const GRAVITY: f64 = 9.81;
/// Coefficient of the cylinders, radius in m.
const MU: f64 = 0.2;
const RADIUS: f64 = 0.08;
/// Relative error of sums and integrations over points.
const DIRECT: f64 = 2e-3;

type Leaning = TerminalMotion<f64, LeanProfile<f64, DryProfile<RoundTable64>>>;

/// Final motion of a tall body under dry friction: pressure, λ, C.
fn modes(pressure: PowerPressure, lean: f64, inertia: f64) -> Result<Leaning> {
    let foot = DryProfile::new(RoundTable64::new(0.0, pressure)?)?;
    Ok(TerminalMotion::new(LeanProfile::new(foot, lean)?, inertia)?)
}

/// Its final ratio, if there is one.
fn root(pressure: PowerPressure, lean: f64, inertia: f64) -> Result<f64> {
    let root = modes(pressure, lean, inertia)?.finite_fixed_point();
    root.context("a body of even thickness has a finite fixed point")
}

/// Final ratios over λ.
pub fn section_5_1_lateral() -> Result<Exhibit> {
    let mut rows = Vec::new();
    for lean in linear(0.0, MOST, 100) {
        let mut row = vec![lean];
        for (_, pressure) in PRESSURES {
            row.push(root(pressure, lean, pressure.mean_square_radius())?);
        }
        rows.push(row);
    }
    let mut figure = Figure::new(
        "Final velocity ratio of tall bodies, each with C = ⟨r²⟩",
        Axis::linear("lean λ = 2μh/(R⟨r²⟩)").range(0.0, MOST),
        Axis::linear("final ratio v/(ωR)").range(0.4, 1.1),
    )
    .guide(ReferenceLine::vertical(LEAN, "integrated"))
    .legend(Legend::Below);
    for (i, (name, _)) in PRESSURES.iter().enumerate() {
        let curve = rows.iter().map(|row| (row[0], row[1 + i])).collect();
        figure = figure.series(Series::line(*name, curve));
    }
    let claims = [dry()?, plane()?, vec![fading()?], rock()?].concat();
    Ok(Exhibit::new(
        TEXT.prose(),
        figure,
        &[
            "lean",
            "ring",
            "flat_punch",
            "uniform",
            "hertz",
            "paraboloid",
        ],
        rows,
        claims,
    ))
}

/// A solid cylinder whose height gives this λ = 2γH/R for a friction coefficient γ.
fn cylinder(alpha: f64, lean: f64) -> Result<TallBody> {
    let body = TallCylinder {
        alpha,
        height: lean * RADIUS / (2.0 * MU),
        ..TallCylinder::solid(MU, RADIUS)
    };
    Ok(body.body(GRAVITY)?)
}

/// The last ratio of a cylinder that is thrown at 1 m/s.
fn last_ratio(body: &TallBody, launch: f64) -> Result<f64> {
    let launch = Launch {
        velocity: [1.0, 0.0],
        spin: 1.0 / (launch * RADIUS),
    };
    Ok(PlanarSimulation::new(body, &launch, 1e-9)?
        .to_end()?
        .point
        .ratio)
}

/// Dry friction: the autonomous equation survives.
fn dry() -> Result<Vec<Claim>> {
    let uniform = PowerPressure::UNIFORM;
    let (mut deviation, mut journeys) = (0.0_f64, 0);
    for lean in [0.2, 0.5, LEAN] {
        let body = cylinder(0.0, lean)?;
        let root = root(uniform, lean, 0.5)?;
        for launch in [0.05, 0.5, 1.0, 20.0] {
            deviation = deviation.max((last_ratio(&body, launch)? / root - 1.0).abs());
            journeys += 1;
        }
    }
    // ε₀ for C = 1/2 from 3.17, 3.18, G = (F/ε + T)/5 and its derivatives, at 30 digits (mpmath).
    let known = [
        (0.2, 0.654_284_935_411_499_3),
        (0.8, 0.670_104_521_635_125_7),
        (1.0, 0.677_305_418_212_129_1),
    ];
    let mut claims = vec![Claim::own_statement(
        TEXT.said("autonomous"),
        format!("{journeys} journeys, relative deviation below 1e-9"),
        deviation < 1e-9,
    )];
    for (lean, value) in known {
        let statement = TEXT.said("ratio").with("lean", lean);
        claims.push(Claim::own(
            statement,
            root(uniform, lean, 0.5)?,
            value,
            1e-12,
        ));
    }
    claims.push(directly()?);
    Ok(claims)
}

/// The final ratio of a disk and of a ring by points that lean, without an equation for ε.
fn directly() -> Result<Claim> {
    let mut shown = Vec::new();
    let mut deviation = 0.0_f64;
    for (pressure, points) in [
        (PowerPressure::UNIFORM, Points::disk(32, 32)),
        (PowerPressure::RING, Points::ring(360)),
    ] {
        let inertia = pressure.mean_square_radius();
        let root = root(pressure, LEAN, inertia)?;
        let friction = |velocity| points.leaning(velocity, 0.0, LEAN);
        // From near the level body's ratio; the lean moves it from there.
        let start = modes(pressure, 0.0, inertia)?.finite_fixed_point();
        let start = start.context("the level body has a final ratio")?;
        let stop = to_rest(friction, 0.0, inertia, [start, 0.0, 1.0]);
        deviation = deviation.max((stop.ratio / root - 1.0).abs());
        shown.push(format!("{:.4}", stop.ratio));
    }
    Ok(Claim::own_statement(
        TEXT.said("direct"),
        format!(
            "{}; relative deviation {deviation:.0e} at most",
            shown.join(" and ")
        ),
        deviation < DIRECT,
    ))
}

/// Existence and stability with the lateral force.
fn plane() -> Result<Vec<Claim>> {
    let ratios = geometric(1e-6, 1e6, 60);
    let (mut bodies, mut right) = (0, 0);
    for lean in [0.3, LEAN, MOST] {
        for (_, pressure) in PRESSURES {
            for inertia in geometric(0.05, 5.0, 20) {
                let modes = modes(pressure, lean, inertia)?;
                let (low, high) = modes.inertia_interval();
                let inside = inertia > low && inertia < high;
                let signs: Vec<bool> = ratios.iter().map(|&r| modes.growth(r) > 0.0).collect();
                let changes = signs.windows(2).filter(|w| w[0] != w[1]).count();
                let stable = matches!(modes.fixed_points().finite, Some((_, Stability::Stable)));
                bodies += 1;
                right += usize::from(
                    changes == usize::from(inside) && stable == inside && (!inside || signs[0]),
                );
            }
        }
    }
    let disk = Points::disk(200, 64);
    let seen = |ratio: f64| {
        let [along, _, torque] = disk.leaning([ratio, 0.0, 1.0], 0.0, LEAN);
        ratio * torque / along
    };
    let (low, high) = modes(PowerPressure::UNIFORM, LEAN, 0.5)?.inertia_interval();
    Ok(vec![
        Claim::own_statement(
            TEXT.said("plane"),
            format!("{right} of {bodies} bodies: five pressures, λ = 0.3, 0.8, 1, 0.05 < C < 5"),
            right == bodies,
        ),
        Claim::own(TEXT.said("low"), low, seen(1e3), DIRECT * low),
        Claim::own(TEXT.said("high"), high, seen(1e-3), DIRECT * high),
    ])
}

/// 0 < α < 1: the lean fades with the speed.
fn fading() -> Result<Claim> {
    let mut deviation = 0.0_f64;
    for alpha in [0.25, 0.5] {
        let level = last_ratio(&cylinder(alpha, 0.0)?, 0.5)?;
        for launch in [0.2, 3.0] {
            let tall = last_ratio(&cylinder(alpha, LEAN)?, launch)?;
            deviation = deviation.max((tall / level - 1.0).abs());
        }
    }
    Ok(Claim::own_statement(
        TEXT.said("fading"),
        format!("relative deviation {deviation:.0e} at most"),
        deviation < 1e-9,
    ))
}

/// A curling rock on its band under Penner's law.
const ROCK: TallCylinder = TallCylinder {
    coefficient: 0.008,
    alpha: -0.5,
    radius: 0.0625,
    height: 0.114,
    inertia_ratio: 0.5 * (0.145 / 0.0625) * (0.145 / 0.0625),
    pressure: PowerPressure::RING,
    gradient: Gradient::AllRound,
};
/// Launch of the rock, m/s for the slide and for the rim.
const THROWN: [f64; 2] = [0.5, 0.65];
/// Speeds at which its ratio is compared, as shares of the launch: 8 cm/s, 8 mm/s and 2 mm/s.
const SHARES: [f64; 3] = [0.1, 0.01, 0.0025];

/// α < 0: the lean grows while the body slows down, and ε has no equation of its own.
fn rock() -> Result<Vec<Claim>> {
    let flat = TallCylinder {
        height: 0.0,
        ..ROCK
    };
    let (tall_ratios, tips) = slowing(&ROCK)?;
    let (flat_ratios, _) = slowing(&flat)?;
    let points = Points::ring(360);
    // λ for speeds in m/s: 2 γ h/R on a ring.
    let lean = ROCK.coefficient * ROCK.height / ROCK.radius;
    let [slide, rim] = THROWN;
    let mut deviation = 0.0_f64;
    for (share, ours) in SHARES.into_iter().zip(tall_ratios) {
        let friction = |velocity| points.leaning(velocity, ROCK.alpha, lean);
        let laws = [ROCK.alpha, ROCK.inertia_ratio];
        let theirs = slowed(friction, laws, [slide, 0.0, rim], share);
        deviation = deviation.max((ours / theirs.ratio - 1.0).abs());
    }
    let [lx, ly] = points.gradient(tips, ROCK.alpha, lean);
    let tipping = lx.hypot(ly);
    let changes = std::array::from_fn(|i| 100.0 * (tall_ratios[i] / flat_ratios[i] - 1.0));
    let [fast, slow, slowest]: [f64; 3] = changes;
    let [.., last] = flat_ratios;
    Ok(vec![
        Claim::own_statement(
            TEXT.said("rock"),
            format!(
                "by {fast:.4} % at 8 cm/s, {slow:.3} % at 8 mm/s, {slowest:.2} % at 2 mm/s, where \
                 the level rock has {}",
                short((1e4 * last).round() / 1e4)
            ),
            deviation < DIRECT && fast.abs() < 0.1 && slowest.abs() > slow.abs(),
        ),
        Claim::own_statement(
            TEXT.said("tips"),
            format!(
                "at {:.3} mm/s of slide and {:.3} mm/s of the rim",
                1e3 * tips[0].hypot(tips[1]),
                1e3 * tips[2]
            ),
            (tipping - 1.0).abs() < 1e-2,
        ),
    ])
}

/// The rock's ratios at the compared speeds, and its velocity and rim speed when it would begin to
/// tip, in m/s.
fn slowing(rock: &TallCylinder) -> Result<([f64; 3], [f64; 3])> {
    let body = rock.body(GRAVITY)?;
    let [slide, rim] = THROWN;
    let launch = Launch {
        velocity: [slide, 0.0],
        spin: rim / rock.radius,
    };
    let size = |point: &PlanarState| {
        let [x, y] = point.velocity;
        x.hypot(y).hypot(point.spin * rock.radius)
    };
    let arrival = PlanarSimulation::new(&body, &launch, 1e-9)?.to_end()?;
    // Under |v|^α alone the speeds fade like (1 − t/T)^(1/(1−α)).
    let end = arrival.point.time;
    let shares: Vec<f64> = geometric(1.0, 1e-4, 2000);
    let mut times: Vec<f64> = shares
        .iter()
        .map(|share| end * (1.0 - share.powf(1.0 - rock.alpha)))
        .collect();
    times.extend(arrival.tips_at);
    times.sort_by(f64::total_cmp);
    let (mut ratios, mut tips) = ([f64::NAN; 3], [f64::NAN; 3]);
    let start = slide.hypot(rim);
    PlanarSimulation::new(&body, &launch, 1e-9)?.follow(&times, |point| {
        for (ratio, share) in ratios.iter_mut().zip(SHARES) {
            if ratio.is_nan() && size(point) <= share * start {
                *ratio = point.ratio;
            }
        }
        if Some(point.time) == arrival.tips_at {
            let [x, y] = point.velocity;
            tips = [x, y, point.spin * rock.radius];
        }
    })?;
    Ok((ratios, tips))
}
