//! Figure 2.5 and sections 2.1 and 2.2: rest, motion, age, and the real area of contact.

use crate::asperities::{HertzSphere, RoughSurface, plastic_area};
use crate::exhibit::{Exhibit, geometric, linear, points};
use crate::text::Text;
use anyhow::{Result, anyhow};
use tribos::scene::InclineScene;
use tribos_core::law::{CoulombLaw, DryFriction, LocalLaw, RestTime, StaticAgeing};
use tribos_report::claim::Claim;
use tribos_report::digits::short;
use tribos_report::figure::{Axis, Color, Figure, Legend, Panels, Series};
use tribos_report::verdict::Allowance;

const TEXT: Text = Text(include_str!("figure-2.5.md"));

/// Coefficients at rest and in motion, and growth of the first per e-fold of the age: ours, of the
/// size of wood on wood.
const MU_STATIC: f64 = 0.5;
const MU_DYNAMIC: f64 = 0.3;
const GROWTH: f64 = 0.02;
/// Youngest and oldest contact shown, seconds: four days.
const AGES: (f64, f64) = (1.0, 345_600.0);
/// Hardness of steel, Pa, and the load on the steel cube, N (footnote 2).
const HARDNESS: f64 = 1e9;
const LOAD: f64 = 100.0;
/// Edge of the steel cube, m; density of steel, kg/m³; gravity, m/s².
const EDGE: f64 = 0.1;
const STEEL: f64 = 7850.0;
const GRAVITY: f64 = 9.81;

fn wood() -> Result<DryFriction<f64>> {
    Ok(DryFriction::new(MU_STATIC, MU_DYNAMIC)?)
}

fn ageing() -> Result<StaticAgeing<f64>> {
    Ok(StaticAgeing::new(MU_STATIC, GROWTH, AGES.0)?)
}

/// Coulomb's graph, and static friction over the logarithm of the age.
pub fn figure_2_5() -> Result<Exhibit> {
    let (wood, ageing) = (wood()?, ageing()?);
    let rows: Vec<Vec<f64>> = linear(-1.0, 1.0, 201)
        .into_iter()
        .zip(geometric(AGES.0, AGES.1, 201))
        .map(|(v, time)| {
            let friction = -wood.friction(v.abs()).copysign(v);
            vec![v, friction, time, ageing.mu_static(RestTime { time })]
        })
        .collect();
    let moving = points(&rows, 0, 1);
    let (left, right) = moving.split_at(rows.len() / 2);
    let graph = Figure::new(
        "Coulomb graph",
        Axis::linear("velocity v").range(-1.0, 1.0),
        Axis::linear("friction per load").range(-0.6, 0.6),
    )
    .series(Series::line("in motion, μ_d", left.to_vec()))
    .series(Series::line("", right.to_vec()).color(Color::palette(0)))
    .series(Series::line(
        "at rest, up to μ_s",
        vec![(0.0, -wood.mu_static()), (0.0, wood.mu_static())],
    ))
    .legend(Legend::Below);
    let age = Figure::new(
        "Static friction",
        Axis::log10("time of rest [s]"),
        Axis::linear("μ_s").range(0.4, 0.8),
    )
    .series(Series::line("A + B ln t", points(&rows, 2, 3)))
    .legend(Legend::Below);
    let mut claims = rest_and_motion()?;
    claims.extend(real_area()?);
    claims.extend(elastic_area()?);
    Ok(Exhibit::new(
        TEXT.prose()
            .with("static", MU_STATIC)
            .with("dynamic", MU_DYNAMIC)
            .with("growth", GROWTH),
        Panels::new("", 2).figure(graph).figure(age).cell(520, 380),
        &["velocity", "friction", "rest_time", "mu_static"],
        rows,
        claims,
    ))
}

/// Section 2.1.
fn rest_and_motion() -> Result<Vec<Claim>> {
    let (wood, ageing) = (wood()?, ageing()?);
    let rounding = 4.0 * f64::EPSILON;
    let speeds = geometric(1e-9, 1e9, 100);
    let constant = speeds.iter().all(|&v| wood.friction(v) == MU_DYNAMIC);
    let mut tangent: f64 = 0.0;
    for mu in linear(0.05, 2.0, 39) {
        let deviation = CoulombLaw::new(mu)?.friction_angle().tan() / mu - 1.0;
        tangent = tangent.max(deviation.abs());
    }
    let decade = |time: f64| {
        let [young, old] = [time, 10.0 * time].map(|time| ageing.mu_static(RestTime { time }));
        old - young
    };
    let uneven = geometric(AGES.0, AGES.1 / 10.0, 50)
        .into_iter()
        .map(|time| (decade(time) / decade(AGES.0) - 1.0).abs())
        .fold(0.0, f64::max);
    Ok(vec![
        Claim::definition(
            TEXT.said("critical-angle"),
            format!("deviation {tangent:.1e} at most, 0.05 ≤ μ ≤ 2"),
            tangent <= rounding,
        ),
        starts_with_a_jump()?,
        Claim::definition(
            TEXT.said("static-exceeds-dynamic"),
            "the law refuses μ_s = 0.3 with μ_d = 0.5",
            DryFriction::new(0.3, 0.5).is_err(),
        ),
        Claim::definition(
            TEXT.said("constant"),
            format!("{MU_DYNAMIC} at {} speeds from 1e-9 to 1e9", speeds.len()),
            constant,
        ),
        Claim::definition(
            TEXT.said("ageing"),
            format!("deviation {uneven:.1e} at most"),
            uneven <= 1e-12,
        ),
        Claim::stated(
            TEXT.said("belidor"),
            ("≈ 0.35", 0.35),
            belidor(),
            Allowance::Digits(5e-3),
        ),
        Claim::not_checkable(TEXT.said("coulombs-data")),
    ])
}

/// On an incline just steeper than the critical one.
fn starts_with_a_jump() -> Result<Claim> {
    let critical = CoulombLaw::new(MU_STATIC)?.friction_angle();
    let just_steeper = |mu_dynamic: f64| -> Result<f64> {
        let scene = InclineScene {
            mu_static: MU_STATIC,
            mu_dynamic,
            start_angle: critical + 1e-9,
            tilt_rate: 0.0,
            ..InclineScene::default()
        };
        let acceleration = scene.run()?.outcome.release_acceleration;
        let acceleration = acceleration.ok_or_else(|| anyhow!("the block holds"))?;
        Ok(acceleration / scene.gravity)
    };
    let (jump, none) = (just_steeper(MU_DYNAMIC)?, just_steeper(MU_STATIC)?);
    let expected = (MU_STATIC - MU_DYNAMIC) * critical.cos();
    Ok(Claim::trend(
        TEXT.said("jump"),
        format!("acceleration/g {jump:.3}, with one coefficient {none:.1e}"),
        (jump - expected).abs() < 1e-8 && none < 1e-8,
    ))
}

/// Spherical asperities, closely packed: the upper sphere is pulled out of its hollow over the
/// line between two lower ones.
fn belidor() -> f64 {
    // Diameter 1: distance of the hollow from that line, and height of the sphere over the layer.
    let (distance, height) = (1.0 / (2.0 * 3f64.sqrt()), (2.0 / 3.0f64).sqrt());
    distance / height
}

/// Section 2.2, plastic junctions.
fn real_area() -> Result<Vec<Claim>> {
    let shear = 0.4 * HARDNESS;
    let area = plastic_area(LOAD, HARDNESS);
    // Eq. 2.2: the stress that shears the junctions times their area.
    let force = |load: f64| shear * plastic_area(load, HARDNESS);
    let square_millimetres = area * 1e6;
    let double = force(2.0 * LOAD) / force(LOAD);
    let share = area / (EDGE * EDGE);
    let ratio = force(LOAD) / LOAD;
    let weight = STEEL * EDGE.powi(3) * GRAVITY;
    Ok(vec![
        Claim::definition(
            TEXT.said("steel-area"),
            short(square_millimetres),
            (square_millimetres - 0.1).abs() <= f64::EPSILON,
        )
        .printed("0.1"),
        Claim::definition(
            TEXT.said("steel-fraction"),
            short(share),
            (share - 1e-5).abs() <= 1e-20,
        )
        .printed("1e-5"),
        Claim::trend(
            TEXT.said("cube"),
            format!(
                "{weight:.0} N, {:.3} mm²",
                1e6 * plastic_area(weight, HARDNESS)
            ),
            (LOAD / 1.5..LOAD * 1.5).contains(&weight),
        )
        .printed("100"),
        Claim::definition(
            TEXT.said("plastic-coefficient"),
            short(ratio),
            (ratio - 0.4).abs() <= f64::EPSILON,
        ),
        Claim::definition(
            TEXT.said("double-load"),
            short(double),
            (double - 2.0).abs() <= f64::EPSILON,
        ),
    ])
}

/// d ln f/d ln L over a factor of 1000 in the load.
fn exponent(f: impl Fn(f64) -> f64) -> f64 {
    let ratio: f64 = 1e3;
    (f(ratio * LOAD) / f(LOAD)).ln() / ratio.ln()
}

/// Section 2.2, elastic asperities.
fn elastic_area() -> Result<Vec<Claim>> {
    /// Steel: contact modulus in Pa. Tip radius and decay length of a ground surface in m.
    const MODULUS: f64 = 1.1e11;
    const TIP: f64 = 1e-5;
    const DECAY: f64 = 1e-6;
    let tip = HertzSphere {
        radius: TIP,
        contact_modulus: MODULUS,
    };
    let surface = RoughSurface {
        decay_length: DECAY,
        tip,
    };
    let pressures = [0.0, 3.0, 6.0].map(|gap| mean_pressure(&surface, gap));
    let deviation = pressures
        .iter()
        .map(|p| (p / surface.mean_pressure() - 1.0).abs())
        .fold(0.0, f64::max);
    let law = |id, printed: (&str, f64), ours: f64| {
        let holds = (ours - printed.1).abs() <= 1e-14;
        Claim::definition(TEXT.said(id), short(ours), holds).printed(printed.0)
    };
    Ok(vec![
        law(
            "hertz-radius",
            ("1/3", 1.0 / 3.0),
            exponent(|load| tip.contact_radius(load)),
        ),
        law(
            "hertz-area",
            ("2/3", 2.0 / 3.0),
            exponent(|load| tip.area(load)),
        ),
        Claim::trend(
            TEXT.said("greenwood"),
            format!(
                "L/A summed over Hertz contacts at three separations differs by {deviation:.1e} \
                 at most from the law's constant"
            ),
            deviation <= 1e-6,
        ),
    ])
}

/// L/A of asperities `gap` decay lengths above the mean plane, by the midpoint rule over the heights.
fn mean_pressure(surface: &RoughSurface, gap: f64) -> f64 {
    let RoughSurface { decay_length, tip } = surface;
    let (highest, steps) = (40.0, 40_000);
    let step = highest / f64::from(steps);
    let (mut area, mut load) = (0.0, 0.0);
    for i in 0..steps {
        let indentation = (f64::from(i) + 0.5) * step;
        let number = (-(gap + indentation)).exp();
        // Hertz: L = (4/3) E* √R_a δ^(3/2).
        let stiffness = 4.0 / 3.0 * tip.contact_modulus * tip.radius.sqrt();
        let one = stiffness * (indentation * decay_length).powf(1.5);
        load += number * one;
        area += number * tip.area(one);
    }
    load / area
}
