//! A finished run of a packing.

use super::number;
use crate::command::explain::packing::{MODES, SWITCHES, coefficients};
use crate::command::explain::{duration, line};
use serde_json::Value;
use tribos::powder::{Dissipation, Material};
use tribos::results::Summary;

/// Share of all dissipation below which a mode counts as idle.
const LITTLE: f64 = 0.01;

/// The account of a run: steps, energies, thresholds, and what did next to nothing; `command` runs the scene anew,
/// with one more override.
pub fn text(summary: &Value, material: &Material, command: &str) -> String {
    let number = |place: &str| number(summary, place);
    let parts = Dissipation::QUANTITIES.iter().map(|part| part.name);
    let energies = parts.map(|part| (part, number(&format!("/dissipation/{part}"))));
    let energies: Vec<(&str, f64)> = energies.collect();
    let total: f64 = energies.iter().map(|(_, energy)| energy.abs()).sum();
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
    // Nothing exchanged has no shares.
    let share = |energy: f64| if total > 0.0 { energy / total } else { 0.0 };
    for (part, energy) in &energies {
        let share = share(*energy);
        let gave = if share < 0.0 { "  (gave energy)" } else { "" };
        let percent = 100.0 * share;
        text += &line("", format!("{part:<10} {percent:6.1} %{gave}"));
    }
    text += &at_thresholds(summary);
    for (mode, mu) in coefficients(material).into_iter().enumerate() {
        let idle = energies.iter().find(|(part, energy)| {
            *part == MODES[mode] && mu > 0.0 && share(*energy).abs() < LITTLE
        });
        if let Some((_, energy)) = idle {
            text += &advice(material, mode, share(*energy).abs(), command);
        }
    }
    text
}

/// A mode that did next to nothing.
fn advice(material: &Material, mode: usize, share: f64, command: &str) -> String {
    let mut less = *material;
    let coefficients = [&mut less.sliding, &mut less.rolling, &mut less.torsion];
    *coefficients[mode] = 0.0;
    let [before, after] = [material, &less].map(|material| material.carried().modes.unknowns());
    let saved = if after < before {
        format!("{before} unknowns a contact become {after}")
    } else {
        format!("though contacts keep {before} unknowns")
    };
    let (name, percent) = (MODES[mode], 100.0 * share);
    line(
        "could go",
        format!(
            "{name} dissipated {percent:.2} %: could be left out, {saved}; a threshold that is never reached still holds, so check with"
        ),
    ) + &line("", format!("  {command} --set {}=0", SWITCHES[mode]))
}

/// Shares of contacts at their thresholds at the end.
fn at_thresholds(summary: &Value) -> String {
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
