//! A finished run of a packing.

use super::number;
use crate::command::explain::packing::{MODES, SWITCHES, coefficients};
use crate::command::explain::{duration, line};
use serde_json::Value;
use tribos::powder::Material;

/// Share of all dissipation below which a mode counts as idle.
const LITTLE: f64 = 0.01;
/// Entries of the summary.
const PARTS: [&str; 5] = ["normal", "sliding", "rolling", "torsion", "cohesion"];

/// The account of a run: steps, energies, thresholds, and what did next to nothing; `command` runs the scene anew,
/// with one more override.
pub fn text(summary: &Value, material: &Material, command: &str) -> String {
    let number = |place: &str| number(summary, place);
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
    // Nothing exchanged has no shares.
    let shares = parts.map(|energy| if total > 0.0 { energy / total } else { 0.0 });
    for (part, share) in PARTS.iter().zip(shares) {
        let gave = if share < 0.0 { "  (gave energy)" } else { "" };
        let percent = 100.0 * share;
        text += &line("", format!("{part:<10} {percent:6.1} %{gave}"));
    }
    text += &at_thresholds(summary);
    let coefficients = coefficients(material);
    for (mode, (mu, share)) in coefficients.iter().zip(&shares[1..]).enumerate() {
        if *mu > 0.0 && share.abs() < LITTLE {
            text += &advice(material, mode, share.abs(), command);
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
