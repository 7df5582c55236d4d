//! Appendix B: the ten films of the thesis' disc.

use super::tip;
use crate::exhibit::Exhibit;
use crate::runs::{Case, Effort, FILMED, Run, Runs, System};
use crate::text::Text;
use anyhow::Result;
use std::sync::Arc;
use tribos_report::claim::Claim;
use tribos_report::player::Film;
use tribos_report::runs::powder::packing;

const TEXT: Text = Text(include_str!("appendix-b.md"));

/// Endings of the names of a compaction's two films, and the player's look for each.
const LOOKS: [(&str, &str); 2] = [("spheres", "Spheres"), ("spheres_ctctF", "Forces")];

/// All ten, a page each.
pub fn appendix_b(runs: &Runs) -> Result<Exhibit> {
    let system = match runs.effort() {
        Effort::Quick => System::Small,
        Effort::Full => System::Large,
    };
    let cases = FILMED.map(|friction| Case::new(system, friction, 1));
    let compactions = runs.of(&cases)?;
    let mut pages = Vec::new();
    for (case, friction) in cases.iter().zip(FILMED) {
        pages.extend(both_looks(&case.film(runs)?, friction));
    }
    let tips = tip::films(runs, &tip::LISTED)?;
    let mut rows: Vec<Vec<f64>> = FILMED.into_iter().zip(&compactions).map(row).collect();
    for ((lambda, _), (film, angle)) in tip::LISTED.into_iter().zip(tips) {
        let title = format!("Tip on a substrate, λ = {lambda:.3}");
        pages.push((
            format!("Tip_substrate_{lambda:.3}.html"),
            film.titled(&title),
        ));
        rows.push(vec![f64::NAN, f64::NAN, lambda, f64::NAN, f64::NAN, angle]);
    }
    let claims = vec![
        Claim::definition(
            TEXT.said("films"),
            format!("{} pages", pages.len()),
            pages.len() == 10,
        )
        .printed("10"),
    ];
    let last = &compactions[0];
    let drawing = packing(&last.scene, &last.states, &last.outcome)?;
    Ok(Exhibit {
        pages,
        seeds: vec![1],
        ..Exhibit::new(
            TEXT.prose_of(runs.effort()).with("system", system.name()),
            drawing,
            &[
                "rolling",
                "torsion",
                "lambda",
                "porosity_initial",
                "porosity_final",
                "final_angle_degrees",
            ],
            rows,
            claims,
        )
    })
}

/// Spheres, and forces between spheres of glass.
fn both_looks(film: &Film, [rolling, torsion]: [f64; 2]) -> [(String, Film); 2] {
    LOOKS.map(|(ending, look)| {
        let name = format!("mt_{rolling}_mn_{torsion}_{ending}.html");
        let title = format!("Compaction with μ_t = {rolling}, μ_n = {torsion}");
        (name, film.clone().titled(&title).beginning_as(look))
    })
}

fn row(([rolling, torsion], run): ([f64; 2], &Arc<Run>)) -> Vec<f64> {
    let [before, after] = [run.outcome.porosity_initial, run.outcome.porosity_final];
    vec![rolling, torsion, f64::NAN, before, after, f64::NAN]
}
