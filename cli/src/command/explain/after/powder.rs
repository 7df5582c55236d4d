//! A finished run of a powder.

use super::{number, summary};
use crate::command::explain::powder::{MODES, coefficients};
use crate::command::explain::{duration, line};
use crate::failure::Failure;
use serde_json::Value;
use std::path::Path;
use tribos::powder::PowderCost;
use tribos::scene::PowderScene;

/// Share of all dissipation below which a mode counts as idle.
pub(super) const LITTLE: f64 = 0.01;
/// Entries of the summary.
pub(super) const PARTS: [&str; 5] = ["normal", "sliding", "rolling", "torsion", "cohesion"];

/// The account of the run in `out`; `command` runs the scene anew, with one more override.
pub fn text(scene: &PowderScene, out: &Path, command: &str) -> Result<String, Failure> {
    let summary = summary(out, PowderScene::KEYS, &scene.json())?;
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
        let gave = if energy < 0.0 { "  (gave energy)" } else { "" };
        let share = 100.0 * energy / total;
        // Nothing exchanged has no shares.
        let share = if share.is_finite() { share } else { 0.0 };
        text += &line("", format!("{part:<10} {share:6.1} %{gave}"));
    }
    text += &at_thresholds(&summary);
    for (mode, name) in MODES.iter().enumerate() {
        let share = (parts[mode + 1] / total).abs();
        if coefficients(scene)[mode] > 0.0 && (share < LITTLE || total == 0.0) {
            text += &advice(scene, mode, name, share, command);
        }
    }
    Ok(text)
}

/// A mode that did next to nothing.
fn advice(scene: &PowderScene, mode: usize, name: &str, share: f64, command: &str) -> String {
    let before = scene.material().carried().modes.unknowns();
    let after = PowderCost::unknowns_without(scene, mode);
    let saved = if after < before {
        format!("{before} unknowns a contact become {after}")
    } else {
        format!("though contacts keep {before} unknowns")
    };
    let percent = if share.is_finite() {
        100.0 * share
    } else {
        0.0
    };
    line(
        "could go",
        format!(
            "{name} dissipated {percent:.2} %: could be left out, {saved}; a threshold that is never reached still holds, so check with"
        ),
    ) + &line("", format!("  {command} --set {name}=0"))
}

/// Shares of contacts at their thresholds at the end.
pub(super) fn at_thresholds(summary: &Value) -> String {
    let shares = MODES.iter().filter_map(|mode| {
        let place = format!("/statistics/at_threshold/{mode}");
        let share = summary.pointer(&place)?.as_f64()?;
        Some(format!("{mode} {:.1} %", 100.0 * share))
    });
    let shares: Vec<String> = shares.collect();
    if shares.is_empty() {
        return String::new();
    }
    line(
        "at threshold",
        format!("{} of the contacts at the end", shares.join(", ")),
    )
}
