//! A finished run of a gas.

use super::{number, summary};
use crate::command::digits::shown;
use crate::command::explain::{duration, line};
use crate::failure::Failure;
use std::path::Path;
use tribos::scene::GasScene;

/// The account of the run in `out`.
pub fn text(scene: &GasScene, out: &Path) -> Result<String, Failure> {
    let summary = summary(out, GasScene::KEYS, &scene.json())?;
    let number = |place: &str| number(&summary, place);
    let mut text = line(
        "run",
        format!(
            "{} collisions a sphere, {}",
            shown(number("/collisions")),
            duration(number("/wall_seconds"))
        ),
    );
    text += &line(
        "energy",
        format!(
            "{} T0 a sphere at the start, {} at the end, {} lost in collisions",
            shown(number("/energy_initial")),
            shown(number("/energy_final")),
            shown(number("/energy_lost"))
        ),
    );
    Ok(text)
}
