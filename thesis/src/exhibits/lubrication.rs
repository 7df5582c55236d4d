//! Figure 2.8 and section 2.3.2: friction in and with a fluid.

use crate::exhibit::{Exhibit, geometric, points};
use crate::text::Text;
use anyhow::{Result, anyhow};
use std::f64::consts::PI;
use tribos_core::law::{
    DryFriction, InertialDrag, LocalLaw, Stokes, Stribeck, StribeckParameters, crossover_reynolds,
    reynolds,
};
use tribos_report::claim::Claim;
use tribos_report::digits::short;
use tribos_report::figure::{Axis, Figure, Legend, Series};
use tribos_report::verdict::Allowance;

const TEXT: Text = Text(include_str!("figure-2.8.md"));

/// Boundary friction without a film, and the rise of the film's own friction. Speeds are in units
/// of the one at which the film begins to lift the body. Ours.
const BOUNDARY: f64 = 0.1;
const FILM: f64 = 3.4e-4;

/// Boundary to hydrodynamic lubrication.
fn bearing() -> Result<Stribeck<f64>> {
    // A full film leaves no dry contact: no friction but the film's.
    let contact = DryFriction::new(BOUNDARY, 0.0)?;
    Ok(Stribeck::new(StribeckParameters {
        dry: contact,
        speed: 1.0,
        exponent: 2.0,
        viscous: FILM,
    })?)
}

/// Friction over ηv/L.
pub fn figure_2_8() -> Result<Exhibit> {
    let law = bearing()?;
    let rows: Vec<Vec<f64>> = geometric(1e-2, 1e2, 300)
        .into_iter()
        .map(|x| vec![x, law.friction(x), law.boundary(x), law.hydrodynamic(x)])
        .collect();
    let figure = Figure::new(
        "A lubricated body",
        Axis::log10("ηv/L, in units of its value where the film forms"),
        Axis::log10("friction per load").range(1e-4, 0.3),
    )
    .series(Series::line("friction", points(&rows, 0, 1)))
    .series(Series::dashed("boundary", points(&rows, 0, 2)))
    .series(Series::dashed("hydrodynamic", points(&rows, 0, 3)))
    .legend(Legend::Below);
    let mut claims = stribeck_claims(&law)?;
    claims.extend(drag_claims()?);
    Ok(Exhibit::new(
        TEXT.prose(),
        figure,
        &["parameter", "friction", "boundary", "hydrodynamic"],
        rows,
        claims,
    ))
}

/// d ln f/d ln x between `x` and `2x`.
fn exponent(f: impl Fn(f64) -> f64, x: f64) -> f64 {
    (f(2.0 * x) / f(x)).log2()
}

fn stribeck_claims(law: &Stribeck<f64>) -> Result<Vec<Claim>> {
    let minimum = law
        .minimum()
        .ok_or_else(|| anyhow!("the friction of the lubricated body has no minimum"))?;
    let least = law.friction(minimum);
    let friction = |x: f64| law.friction(x);
    let (slow, fast) = (exponent(friction, 1e-3), exponent(friction, 1e2));
    Ok(vec![
        Claim::definition(
            TEXT.said("boundary"),
            format!("∝ v^{slow:.1e} at 1e-3"),
            slow.abs() < 1e-4,
        ),
        Claim::definition(
            TEXT.said("hydrodynamic"),
            short(fast),
            (fast - 1.0).abs() <= 1e-12,
        ),
        Claim::trend(
            TEXT.said("minimum"),
            format!("least friction {least:.2e} at {minimum:.2}, boundary {BOUNDARY}"),
            law.slope(0.99 * minimum) < 0.0 && law.slope(1.01 * minimum) > 0.0,
        ),
        Claim::definition(
            TEXT.said("factor"),
            format!("{:.0}", BOUNDARY / least),
            (BOUNDARY / least / 100.0 - 1.0).abs() < 0.05,
        )
        .printed("100"),
    ])
}

/// A sphere in a fluid: 2.3 and 2.4.
fn drag_claims() -> Result<Vec<Claim>> {
    /// A bead in water, SI; C₂ of a smooth sphere.
    const RADIUS: f64 = 1e-3;
    const VISCOSITY: f64 = 1e-3;
    const DENSITY: f64 = 1e3;
    const CONSTANT: f64 = 0.7;
    let viscous = Stokes::new(VISCOSITY, RADIUS)?;
    let inertial = InertialDrag::new(CONSTANT, DENSITY, RADIUS)?;
    let speed_at = |re: f64| re * VISCOSITY / (DENSITY * RADIUS);
    let scale = |v: f64| DENSITY * v * v * RADIUS * RADIUS;
    let crossover = speed_at(crossover_reynolds(CONSTANT));
    let (slow, fast) = (speed_at(1e-3), speed_at(1e4));
    let re = reynolds(DENSITY, slow, RADIUS, VISCOSITY);
    let law = |id, ours: f64, value: f64| {
        let holds = (ours - value).abs() <= 1e-13 * value;
        Claim::definition(TEXT.said(id), short(ours), holds)
    };
    Ok(vec![
        Claim::stated(
            TEXT.said("stokes-constant"),
            ("6π", 6.0 * PI),
            stokes_constant(),
            Allowance::Exact(1e-12),
        ),
        law(
            "stokes",
            viscous.force(slow) / (VISCOSITY * slow * RADIUS),
            6.0 * PI,
        )
        .printed("6π"),
        law(
            "reynolds",
            viscous.force(slow) / scale(slow) / (6.0 * PI / re),
            1.0,
        ),
        law("laminar", exponent(|v| viscous.force(v), slow), 1.0),
        law("turbulent", exponent(|v| inertial.force(v), fast), 2.0),
        Claim::trend(
            TEXT.said("dominance"),
            format!(
                "equal at Re = C₁/C₂ = {:.1} for C₂ = {CONSTANT}, which is ours",
                crossover_reynolds(CONSTANT)
            ),
            viscous.force(0.5 * crossover) > inertial.force(0.5 * crossover)
                && viscous.force(2.0 * crossover) < inertial.force(2.0 * crossover),
        ),
    ])
}

/// Pressure (3/2) η v cos θ/r and shear (3/2) η v sin θ/r on the sphere, along the flow, by the
/// midpoint rule over cos θ.
fn stokes_constant() -> f64 {
    let steps = 1000;
    let step = 2.0 / f64::from(steps);
    let ring = |i: i32| {
        let cos = -1.0 + (f64::from(i) + 0.5) * step;
        let sin_sq = 1.0 - cos * cos;
        // Stress along the flow times the ring's area 2π d(cos θ).
        1.5 * (cos * cos + sin_sq) * 2.0 * PI * step
    };
    (0..steps).map(ring).sum()
}
