//! What a solved problem leaves behind, and its line in the table.

use super::solved::{LoadedProblem, SolvedProblem};
use crate::failure::Failure;
use serde_json::{Value, json};
use std::path::Path;
use tribos::problem::{ContactComponents, SolverStatus};
use tribos::record::{json_number, number, write_atomically};

/// A problem, and what came of it.
pub struct Row<'a> {
    pub posed: &'a LoadedProblem<'a>,
    pub solved: &'a SolvedProblem,
}

/// Names of the columns on the terminal.
pub fn heading() -> String {
    format!(
        "{:>8} {:>10} {:>10} {:>10} {:>8} {:>8} {:>9} {:<10} {:<11} file\n",
        "contacts",
        "residual",
        "scaled",
        "speed",
        "sweeps",
        "factors",
        "seconds",
        "method",
        "ending"
    )
}

impl Row<'_> {
    fn contacts(&self) -> usize {
        self.solved.solution.impulses.len() / self.posed.layout.size()
    }

    /// For the person at the terminal.
    pub fn line(&self) -> String {
        let solution = &self.solved.solution;
        format!(
            "{:>8} {:>10.3e} {:>10.3e} {:>10.3e} {:>8} {:>8} {:>9.4} {:<10} {:<11} {}\n",
            self.contacts(),
            solution.residual.relative,
            solution.residual.scaled,
            solution.residual.speed,
            solution.sweeps,
            solution.factorisations,
            self.solved.seconds,
            solution.method.name(),
            solution.ending.name(),
            self.posed.file.display()
        )
    }

    /// What keeps the problem from being solved.
    pub fn failure_reason(&self, tolerance: f64) -> String {
        if let Some(certificate) = self.certificate() {
            return certificate;
        }
        let residual = &self.solved.solution.residual;
        let largest = residual.largest();
        if largest <= tolerance {
            return format!("normal speeds wrong by {:.1e}", residual.speed);
        }
        format!("largest residual {largest:.1e}")
    }

    /// Why nothing solves the problem, where that is proven.
    fn certificate(&self) -> Option<String> {
        let squeeze = self.solved.solution.squeeze.as_ref()?;
        Some(format!(
            "insoluble: {} contacts close at {:.3e} in the weighted mean, whatever the impulses",
            squeeze.contacts(),
            squeeze.closing
        ))
    }

    /// summary.json and reactions.csv.
    pub fn write(&self, folder: &Path) -> Result<(), Failure> {
        let summary = format!("{:#}\n", self.summary());
        write_atomically(&folder.join("summary.json"), summary.as_bytes())?;
        write_atomically(&folder.join("reactions.csv"), self.reactions().as_bytes())?;
        Ok(())
    }

    fn summary(&self) -> Value {
        let solution = &self.solved.solution;
        json!({
            "file": self.posed.file.display().to_string(),
            "contacts": self.contacts(),
            "converged": solution.ending == SolverStatus::Converged,
            "ending": solution.ending.name(),
            "certificate": self.certificate(),
            "method": solution.method.name(),
            "residual": json_number(solution.residual.relative),
            "residual_scaled": json_number(solution.residual.scaled),
            "residual_speed": json_number(solution.residual.speed),
            "penetration": json_number(solution.residual.penetration),
            // Sweeps, and steps of Newton's methods, which take a factorisation each.
            "iterations": solution.sweeps + solution.factorisations,
            "factorisations": solution.factorisations,
            "seconds": json_number(self.solved.seconds),
        })
    }

    /// A row a contact, components in the file's order.
    fn reactions(&self) -> String {
        let mut text = format!("contact,{}\n", components(self.posed.layout).join(","));
        let contacts = self
            .solved
            .solution
            .impulses
            .chunks(self.posed.layout.size());
        for (contact, impulse) in contacts.enumerate() {
            let numbers: Vec<String> = impulse.iter().map(|&r| number(r)).collect();
            text += &format!("{contact},{}\n", numbers.join(","));
        }
        text
    }
}

/// Names of the components of an impulse.
fn components(layout: ContactComponents) -> Vec<&'static str> {
    let mut names = vec!["normal"];
    match layout {
        ContactComponents::Plane => names.push("sliding"),
        _ => names.extend(["sliding_1", "sliding_2"]),
    }
    if !layout.rolling().is_empty() {
        names.extend(["rolling_1", "rolling_2"]);
    }
    if !layout.torsion().is_empty() {
        names.push("torsion");
    }
    names
}
