//! A finished run of grains.

use super::powder::{LITTLE, PARTS, at_thresholds};
use super::{number, summary};
use crate::command::explain::powder::MODES;
use crate::command::explain::{duration, line};
use crate::failure::Failure;
use std::path::Path;
use tribos::scene::GrainsScene;

/// The account of the run in `out`.
pub fn text(scene: &GrainsScene, out: &Path) -> Result<String, Failure> {
    let summary = summary(out, GrainsScene::KEYS, &scene.json())?;
    let number = |place: &str| number(&summary, place);
    let parts = PARTS.map(|part| number(&format!("/dissipation/{part}")));
    let total: f64 = parts.iter().map(|part| part.abs()).sum();
    let mut text = line(
        "run",
        format!(
            "{} steps, {} sweeps, {}",
            number("/steps"),
            number("/iterations_total"),
            duration(number("/wall_seconds"))
        ),
    );
    text += &line(
        "energy",
        "energy balance, as shares of all energy exchanged at contacts:",
    );
    for (part, energy) in PARTS.iter().zip(parts) {
        let share = 100.0 * energy / total;
        // Nothing exchanged has no shares.
        let share = if share.is_finite() { share } else { 0.0 };
        text += &line("", format!("{part:<10} {share:6.1} %"));
    }
    text += &at_thresholds(&summary);
    let coefficients = [scene.sliding, scene.rolling, scene.torsion];
    for ((name, mu), energy) in MODES.iter().zip(coefficients).zip(&parts[1..]) {
        let share = (energy / total).abs();
        if mu > 0.0 && (share < LITTLE || total == 0.0) {
            text += &line(
                "could go",
                format!("{name} dissipated less than 1 %; check with --set {name}=0"),
            );
        }
    }
    Ok(text)
}
