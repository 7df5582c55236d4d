//! Figure 2.8 and section 2.3.2: friction in and with a fluid.

use crate::exhibit::{Exhibit, geometric, points};
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
    Ok(Exhibit {
        heading: "Figure 2.8: boundary and hydrodynamic lubrication".into(),
        text: vec![
            "The thesis draws this curve without numbers. Here boundary friction is 0.1 and the \
             film's own friction is chosen so that the least friction is a hundred times smaller, \
             as the thesis calls typical."
                .into(),
        ],
        film: None,
        caption: "Friction of a lubricated body against viscosity × velocity / load.".into(),
        drawing: Box::new(figure),
        columns: vec!["parameter", "friction", "boundary", "hydrodynamic"],
        rows,
        claims,
    })
}

/// d ln f/d ln x between `x` and `2x`.
fn exponent(f: impl Fn(f64) -> f64, x: f64) -> f64 {
    (f(2.0 * x) / f(x)).log2()
}

fn stribeck_claims(law: &Stribeck<f64>) -> Result<Vec<Claim>> {
    let minimum = law
        .minimum()
        .ok_or_else(|| anyhow!("the lubricated body has no least friction"))?;
    let least = law.friction(minimum);
    let friction = |x: f64| law.friction(x);
    let (slow, fast) = (exponent(friction, 1e-3), exponent(friction, 1e2));
    Ok(vec![
        Claim::definition(
            "2.3.2",
            "Boundary lubrication: independent of the velocity",
            format!("∝ v^{slow:.1e} at 1e-3"),
            slow.abs() < 1e-4,
            "the law without a film",
        ),
        Claim::definition(
            "2.3.2",
            "Hydrodynamic lubrication: proportional to the velocity, ∝ v^x, x at 100",
            short(fast),
            (fast - 1.0).abs() <= 1e-12,
            "the law of the full film",
        ),
        Claim::trend(
            "fig. 2.8",
            "Boundary lubrication is much higher than hydrodynamic; one minimum between them",
            format!("least friction {least:.2e} at {minimum:.2}, boundary {BOUNDARY}"),
            law.slope(0.99 * minimum) < 0.0 && law.slope(1.01 * minimum) > 0.0,
            "one minimum, with parameters of our choice",
        ),
        Claim::definition(
            "2.3.2",
            "Boundary friction over hydrodynamic friction, \"typically by a factor of 100\"",
            format!("{:.0}", BOUNDARY / least),
            (BOUNDARY / least / 100.0 - 1.0).abs() < 0.05,
            "the film's friction, chosen for it",
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
    let law = |place: &str, what: &str, ours: f64, value: f64, of: &str| {
        let holds = (ours - value).abs() <= 1e-13 * value;
        Claim::definition(place, what, short(ours), holds, of)
    };
    Ok(vec![
        Claim::stated(
            "2.3.2",
            "C₁, from pressure and shear of Stokes' flow over the sphere",
            ("6π", 6.0 * PI),
            stokes_constant(),
            Allowance::Exact(1e-12),
        ),
        law(
            "eq. 2.4",
            "F/(ηvr)",
            viscous.force(slow) / (VISCOSITY * slow * RADIUS),
            6.0 * PI,
            "Stokes' law, with C₁ put in",
        )
        .printed("6π"),
        law(
            "eq. 2.3",
            "F/(ρv²r²) over C₁/Re, at Re = 1e-3",
            viscous.force(slow) / scale(slow) / (6.0 * PI / re),
            1.0,
            "the Reynolds number",
        ),
        law(
            "2.3.2",
            "Laminar flow: linear in v, F ∝ v^x, x",
            exponent(|v| viscous.force(v), slow),
            1.0,
            "Stokes' law",
        ),
        law(
            "2.3.2",
            "Turbulent flow: square of v, F ∝ v^x, x",
            exponent(|v| inertial.force(v), fast),
            2.0,
            "inertial drag",
        ),
        Claim::trend(
            "2.3.2",
            "The viscous force dominates at low Reynolds numbers, inertia at high ones",
            format!(
                "equal at Re = C₁/C₂ = {:.1} for C₂ = {CONSTANT}, which is ours",
                crossover_reynolds(CONSTANT)
            ),
            viscous.force(0.5 * crossover) > inertial.force(0.5 * crossover)
                && viscous.force(2.0 * crossover) < inertial.force(2.0 * crossover),
            "order below and above one number",
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
