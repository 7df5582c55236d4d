//! Figure 2.8 and section 2.3.2: friction in and with a fluid.

use crate::exhibit::{Exhibit, geometric, points};
use crate::text::Text;
use anyhow::{Result, anyhow};
use std::f64::consts::PI;
use tribos_core::law::{DryFriction, LocalLaw, Stribeck, StribeckParameters};
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
    claims.extend(drag_claims());
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

/// C₁ = 6π of Stokes' drag.
const STOKES_CONSTANT: f64 = 6.0 * PI;

/// A sphere in a fluid, which drags it with F = ρv²r² f(Re) (eq. 2.3), in SI.
struct Bead {
    radius: f64,
    viscosity: f64,
    density: f64,
    /// C₂ = π C_D/2, where C_D counts the cross section.
    constant: f64,
}

impl Bead {
    /// Viscous drag of slow flow, 6π η r v: f = C₁/Re.
    fn viscous(&self, speed: f64) -> f64 {
        STOKES_CONSTANT * self.viscosity * self.radius * speed
    }

    /// Inertial drag of fast flow, C₂ ρ v² r²: f = C₂.
    fn inertial(&self, speed: f64) -> f64 {
        self.constant * self.density * self.radius * self.radius * speed * speed
    }

    /// Speed at a Reynolds number ρ v r/η, with the radius, not the diameter.
    fn speed_at(&self, reynolds: f64) -> f64 {
        reynolds * self.viscosity / (self.density * self.radius)
    }

    /// Reynolds number C₁/C₂ at which the two forces are equal.
    fn crossover(&self) -> f64 {
        STOKES_CONSTANT / self.constant
    }
}

/// A sphere in a fluid: 2.3 and 2.4.
fn drag_claims() -> Vec<Claim> {
    // A bead in water, SI; C₂ of a smooth sphere at 10³ < Re < 10⁵, where C_D is 0.44.
    let bead = Bead {
        radius: 1e-3,
        viscosity: 1e-3,
        density: 1e3,
        constant: 0.7,
    };
    let scale = |v: f64| bead.density * v * v * bead.radius * bead.radius;
    let crossover = bead.speed_at(bead.crossover());
    let re = 1e-3;
    let (slow, fast) = (bead.speed_at(re), bead.speed_at(1e4));
    let law = |id, ours: f64, value: f64| {
        let holds = (ours - value).abs() <= 1e-13 * value;
        Claim::definition(TEXT.said(id), short(ours), holds)
    };
    vec![
        Claim::stated(
            TEXT.said("stokes-constant"),
            ("6π", 6.0 * PI),
            stokes_constant(),
            Allowance::Exact(1e-12),
        ),
        law(
            "stokes",
            bead.viscous(slow) / (bead.viscosity * slow * bead.radius),
            6.0 * PI,
        )
        .printed("6π"),
        law(
            "reynolds",
            bead.viscous(slow) / scale(slow) / (6.0 * PI / re),
            1.0,
        ),
        law("laminar", exponent(|v| bead.viscous(v), slow), 1.0),
        law("turbulent", exponent(|v| bead.inertial(v), fast), 2.0),
        Claim::trend(
            TEXT.said("dominance"),
            format!(
                "equal at Re = C₁/C₂ = {:.1} for C₂ = {}, which is ours",
                bead.crossover(),
                bead.constant
            ),
            bead.viscous(0.5 * crossover) > bead.inertial(0.5 * crossover)
                && bead.viscous(2.0 * crossover) < bead.inertial(2.0 * crossover),
        ),
    ]
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
