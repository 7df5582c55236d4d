//! What a gas carries.

use super::line;
use crate::command::digits::shown;
use crate::failure::Failure;
use tribos::event::{Tangential, collision_rate, contact_value};
use tribos::gas::soft_collision;
use tribos::run::PackingRunError;
use tribos::scene::{GasMethod, GasScene, NormalForce};

/// The whole account.
pub fn text(scene: &GasScene) -> Result<String, Failure> {
    let law = scene.impact().map_err(PackingRunError::from)?;
    let e = scene.restitution;
    let mut text = line(
        "collision",
        format!("normal restitution {e}, {}", tangent(law.tangential())),
    );
    text += &line("method", method(scene));
    let (g, rate) = (
        contact_value(scene.packing_fraction),
        collision_rate(scene.packing_fraction, 1.0),
    );
    text += &line(
        "Enskog",
        format!(
            "g = {} at contact (Carnahan-Starling), {} collisions a sphere and unit of time at T0",
            shown(g),
            shown(rate)
        ),
    );
    if law.tangential() == Tangential::Smooth && e < 1.0 {
        let share = (1.0 - e * e) / 3.0;
        text += &line(
            "Haff",
            format!(
                "T = T0 exp(-{} C) after C collisions a sphere, T = T0/(1 + t/{})^2 while homogeneous",
                shown(share),
                shown(2.0 / (share * rate))
            ),
        );
    }
    Ok(text)
}

fn tangent(tangential: Tangential) -> String {
    match tangential {
        Tangential::Smooth => "smooth: spins do not change".into(),
        Tangential::Rough { restitution } => format!("tangential restitution {restitution}"),
        Tangential::Coulomb { mu, restitution } => {
            format!("tangential restitution {restitution} within friction {mu}")
        }
    }
}

fn method(scene: &GasScene) -> String {
    match scene.method {
        GasMethod::Events if scene.contact_time > 0.0 => format!(
            "events: free flight from collision to collision; no loss within {} of the last one",
            scene.contact_time
        ),
        GasMethod::Events => {
            "events: free flight from collision to collision; a collapse ends the run".into()
        }
        GasMethod::ContactDynamics => format!(
            "contact dynamics: steps in which no sphere moves farther than {} R, impacts first",
            scene.max_displacement
        ),
        GasMethod::Soft => soft(scene),
    }
}

/// Springs, a usual collision and the step.
fn soft(scene: &GasScene) -> String {
    let law = match scene.normal_law {
        NormalForce::Linear => format!("linear springs of {} T0/R^2", scene.stiffness),
        NormalForce::Hertz => format!(
            "Hertz contacts with a modulus of {} T0/R^3",
            scene.stiffness
        ),
    };
    let Some(usual) = soft_collision(scene) else {
        return law;
    };
    format!(
        "soft particles: {law}; a usual collision at T0 overlaps by {} R and lasts {}, {:.0} steps of {}",
        shown(usual.overlap),
        shown(usual.duration),
        (usual.duration / usual.step).ceil(),
        shown(usual.step)
    )
}
