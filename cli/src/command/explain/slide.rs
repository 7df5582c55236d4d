//! What a body in motion carries.

use super::{line, lines};
use crate::failure::Failure;
use tribos::friction::Law;
use tribos::motion::MotionScene;
use tribos::scene::{
    CurlingScene, CylinderScene, DiskScene, FootPressure, PipeScene, PlateScene, Scene,
    SliderIntegrator, Tipping,
};
use tribos::slide::planar::Gradient;
use tribos::slide::{EvaluationCost, PlanarScene};

/// What a body in motion carries.
pub fn text(any: &Scene, scene: &dyn MotionScene) -> Result<String, Failure> {
    match any {
        Scene::Disk(scene) => disk(scene),
        Scene::Cylinder(scene) => planar(scene, &cylinder(scene)),
        Scene::Pipe(scene) => planar(scene, &pipe(scene)),
        Scene::Plate(scene) => planar(scene, &plate(scene)),
        Scene::Curling(scene) => planar(scene, &curling(scene)),
        _ => Ok(lines(&scene.carried())),
    }
}

/// A disk.
fn disk(scene: &DiskScene) -> Result<String, Failure> {
    let cost = scene.evaluation_cost()?;
    let mut text = line(
        "unknowns",
        "2: sliding speed and spin; the path is straight",
    );
    text += &line("law", law(scene.law, scene.alpha, scene.gamma));
    text += &line("patch", "disk under uniform pressure");
    text += &line("friction", scene.evaluation()?.to_string());
    text += &line(
        "integrator",
        match scene.integrator {
            SliderIntegrator::Exact => "exact: adaptive, stops at the instant of rest",
            SliderIntegrator::Verlet => "verlet: fixed steps, as the thesis has it",
        },
    );
    Ok(text + &cost_text(&cost, ""))
}

/// A body that follows a path in the plane under these laws.
fn planar(scene: &dyn PlanarScene, laws: &str) -> Result<String, Failure> {
    let cost = scene.evaluation_cost()?;
    let mut text = line("unknowns", "3: two of the velocity, and the spin");
    text += laws;
    text += &line("friction", scene.evaluation()?.to_string());
    text += &line(
        "integrator",
        "in the logarithm of the speed, adaptive, stops at the instant of rest",
    );
    Ok(text + &cost_text(&cost, ", with the lateral force and the lean"))
}

/// Laws of a cylinder.
fn cylinder(scene: &CylinderScene) -> String {
    line("law", law(scene.law, scene.alpha, scene.gamma))
        + &line("patch", pressure(scene.pressure))
        + &leaning(scene.pressure_gradient, scene.on_tipping)
}

/// Laws of a pipe.
fn pipe(scene: &PipeScene) -> String {
    let inner = scene.pipe().inner_ratio;
    let patch = format!("annulus from {inner:.4} to 1 radii under uniform pressure");
    line("law", law(scene.law, scene.alpha, scene.gamma))
        + &line("patch", patch)
        + &leaning(scene.pressure_gradient, scene.on_tipping)
}

fn leaning(gradient: Gradient, tipping: Tipping) -> String {
    let lean = match gradient {
        Gradient::AllRound => "leans all round, as far as the body's height asks",
        Gradient::FrontBack => "leans forward and backward only",
    };
    let tips = match tipping {
        Tipping::Refuse => "a body that would tip is refused",
        Tipping::Clamp => "the lean is held where the body would tip",
    };
    line("pressure", format!("{lean}; {tips}"))
}

/// Laws of a plate.
fn plate(scene: &PlateScene) -> String {
    let patch = format!("{} under uniform pressure", scene.patch);
    line("law", law(None, 0.0, scene.mu)) + &line("patch", patch)
}

/// Laws of a curling rock.
fn curling(scene: &CurlingScene) -> String {
    let (width, radius, model) = (scene.band_width, scene.radius, scene.model);
    let patch = if width > 0.0 {
        format!("band {width} m wide, {radius} m in radius")
    } else {
        format!("thin ring, {radius} m in radius")
    };
    line(
        "law",
        format!("model {model}, one of several (docs/curling.md)"),
    ) + &line("patch", patch)
}

fn law(law: Option<Law>, alpha: f64, coefficient: f64) -> String {
    if let Some(law) = law {
        law.to_string()
    } else if alpha == 0.0 {
        format!("Coulomb, mu = {coefficient}")
    } else {
        format!("{coefficient} |v|^{alpha}")
    }
}

fn pressure(pressure: FootPressure) -> &'static str {
    match pressure {
        FootPressure::Uniform => "disk under uniform pressure",
        FootPressure::Ring => "thin ring",
        FootPressure::FlatPunch => "disk under the pressure of a flat punch",
        FootPressure::Hertz => "disk under Hertz' pressure",
        FootPressure::Paraboloid => "disk under a paraboloid of pressure",
    }
}

fn cost_text(cost: &EvaluationCost, with: &str) -> String {
    const NANO: f64 = 1e9;
    line(
        "cost",
        format!(
            "{:.0} ns an evaluation here{with}: {:.1} times the disk under Coulomb's law",
            NANO * cost.seconds,
            cost.seconds / cost.table_seconds
        ),
    )
}
