//! What a sliding body carries.

use super::line;
use crate::failure::Failure;
use tribos::scene::{PlanarBody, PlanarScene, SliderScene, Stepper, Tipping};
use tribos::slide::EvaluationCost;
use tribos::slide::planar::Gradient;
use tribos_core::patch::PowerPressure;

/// A disk.
pub fn disk(scene: &SliderScene) -> Result<String, Failure> {
    let cost = scene.evaluation_cost()?;
    let mut text = line(
        "unknowns",
        "2: sliding speed and spin; the path is straight",
    );
    text += &line("law", law(scene.alpha, scene.coefficient));
    text += &line("patch", "disk under uniform pressure");
    text += &line("friction", scene.evaluation()?.to_string());
    text += &line(
        "stepper",
        match scene.stepper {
            Stepper::Exact => "exact: adaptive, stops at the instant of rest",
            Stepper::Verlet => "verlet: fixed steps, as the thesis has it",
        },
    );
    Ok(text + &price(&cost, ""))
}

/// A body that follows a path in the plane.
pub fn planar(scene: &PlanarScene) -> Result<String, Failure> {
    let cost = scene.evaluation_cost()?;
    let mut text = line("unknowns", "3: two of the velocity, and the spin");
    text += &body(scene);
    text += &line("friction", scene.evaluation()?.to_string());
    text += &line(
        "stepper",
        "in the logarithm of the speed, adaptive, stops at the instant of rest",
    );
    Ok(text + &price(&cost, ", with the lateral force and the lean"))
}

fn body(scene: &PlanarScene) -> String {
    let (alpha, coefficient, patch, gradient) = match &scene.body {
        PlanarBody::Cylinder(c) => (
            c.alpha,
            c.coefficient,
            pressure(c.pressure).to_owned(),
            c.gradient,
        ),
        PlanarBody::Pipe(p) => (
            p.alpha,
            p.coefficient,
            format!(
                "annulus from {:.4} to 1 radii under uniform pressure",
                p.inner_ratio
            ),
            p.gradient,
        ),
        PlanarBody::Curling(rock, model) => return curling(rock, model.name()),
    };
    let lean = match gradient {
        Gradient::AllRound => "leans all round, as far as the body's height asks",
        Gradient::FrontBack => "leans forward and backward only",
    };
    let tips = match scene.tipping {
        Tipping::Refuse => "a body that would tip is refused",
        Tipping::Clamp => "the lean is held where the body would tip",
    };
    line("law", law(alpha, coefficient))
        + &line("patch", patch)
        + &line("pressure", format!("{lean}; {tips}"))
}

fn curling(rock: &tribos::slide::curling::CurlingRock, model: &str) -> String {
    let patch = if rock.band_width > 0.0 {
        format!(
            "band {} m wide, {} m in radius",
            rock.band_width, rock.band_radius
        )
    } else {
        format!("thin ring, {} m in radius", rock.band_radius)
    };
    line(
        "law",
        format!("model {model}, one of several (docs/curling.md)"),
    ) + &line("patch", patch)
}

fn law(alpha: f64, coefficient: f64) -> String {
    if alpha == 0.0 {
        format!("Coulomb, mu = {coefficient}")
    } else {
        format!("{coefficient} |v|^{alpha}")
    }
}

fn pressure(pressure: PowerPressure) -> &'static str {
    if pressure == PowerPressure::UNIFORM {
        "disk under uniform pressure"
    } else if pressure == PowerPressure::RING {
        "thin ring"
    } else if pressure == PowerPressure::FLAT_PUNCH {
        "disk under the pressure of a flat punch"
    } else if pressure == PowerPressure::HERTZ {
        "disk under Hertz' pressure"
    } else {
        "disk under a paraboloid of pressure"
    }
}

fn price(cost: &EvaluationCost, with: &str) -> String {
    const NANO: f64 = 1e9;
    line(
        "cost",
        format!(
            "{:.0} ns an evaluation here{with}: {:.1} times the table of a disk under Coulomb's law",
            NANO * cost.seconds,
            cost.seconds / cost.table_seconds
        ),
    ) + &line("", "the whole run takes a moment")
}
