//! A finished run of a gas.

use super::number;
use crate::command::digits::shown;
use crate::command::explain::{duration, line};
use serde_json::Value;

/// The account of the run with this summary.
pub fn text(summary: &Value) -> String {
    let number = |place: &str| number(summary, place);
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
    text
}
