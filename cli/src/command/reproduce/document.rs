//! What the report is written as: its page, the claims as a table, lines for the terminal.

use super::runs::Effort;
use crate::report::page::{Claim, Page, Section, Verdict};

/// "5 reproduced, 1 erratum of the thesis".
pub fn tally(claims: &[Claim]) -> String {
    let count = |test: fn(&Verdict) -> bool| claims.iter().filter(|c| test(&c.verdict)).count();
    let mut text = format!("{:>2} reproduced", count(|v| *v == Verdict::Agrees));
    for (n, what) in [
        (
            count(|v| matches!(v, Verdict::Erratum(_))),
            "errata of the thesis",
        ),
        (
            count(|v| matches!(v, Verdict::Unstated(_))),
            "differ, with cause",
        ),
        (count(|v| *v == Verdict::NotChecked), "not checked"),
        (count(|v| *v == Verdict::Differs), "DIFFER"),
    ] {
        if n > 0 {
            let what = if n == 1 {
                what.replace("errata", "erratum")
            } else {
                what.into()
            };
            text += &format!(", {n} {what}");
        }
    }
    text
}

/// All claims as CSV text.
pub fn claims_csv(sections: &[Section]) -> String {
    let quoted = |text: &str| format!("\"{}\"", text.replace('"', "\"\""));
    let mut text = String::from("exhibit,claim,thesis,ours,uncertainty,difference,verdict\n");
    for section in sections {
        for claim in &section.claims {
            let verdict = match &claim.verdict {
                Verdict::Agrees => "reproduced".into(),
                Verdict::Erratum(reason) => format!("thesis in error: {reason}"),
                Verdict::Unstated(reason) => format!("differs, with cause: {reason}"),
                Verdict::Differs => "differs".into(),
                Verdict::NotChecked => "not checked".into(),
            };
            let fields = [
                &section.id,
                &claim.statement,
                &claim.thesis,
                &claim.ours,
                &claim.uncertainty,
                &claim.difference,
                &verdict,
            ];
            text += &fields.map(|field| quoted(field)).join(",");
            text.push('\n');
        }
    }
    text
}

pub fn page(sections: Vec<Section>, effort: Effort) -> Page {
    Page {
        title: "Mesoscopic aspects of solid friction: the thesis reproduced".into(),
        intro: vec![
            "Chapter 2 of the thesis presents the laws of solid friction: Coulomb's, the ageing of \
             contacts, the real area that they touch with, and how friction depends on the speed, \
             dry and lubricated. Chapter 3 couples sliding and spinning. A rigid body with a flat \
             circular contact slides with speed v and spins with ω on a plane. Every surface \
             element resists with γ|u|^α per unit load along its own velocity u. The net force is \
             γN·F and the torque γNR·T, functions of the velocity ratio ε = v/(ωR)."
                .into(),
            "The thesis gives F and T for α = 0, 1, 3, follows the motion to its end, and names \
             the final modes; then it goes on to tall cylinders, which drift to the side, and to \
             curling stones. Section 5.1 asks about other pressures and negative exponents, and \
             appendix A treats odd exponents."
                .into(),
            "Chapter 4 compacts cohesive powders of spheres with rolling and torsion friction. What \
             it does not state about its simulations decides some of its numbers; where ours differ \
             for that reason, the row says so and names what decides. Section 5.3 turns a tip of \
             atoms on a substrate until it slips."
                .into(),
            "Here F and T come from one hypergeometric formula for every real α > −1 and every \
             pressure (1−r²)^q. Each section shows the thesis' figure computed anew, with the \
             claims made there, our numbers and the difference. Where the thesis is wrong, the row \
             says how; where it gives no numbers to compare with, such as measured points, the row \
             is not checked. Rows marked \"not in the thesis\" are ours and checked against \
             closed forms or 30 digits. The uncertainty is that of ours, a standard deviation over \
             seeds; where there is none, ours is computed to the digits shown."
                .into(),
        ],
        environment: environment(effort),
        sections,
    }
}

/// Program, effort and how to get more.
fn environment(effort: Effort) -> String {
    let version = env!("CARGO_PKG_VERSION");
    let made = match effort {
        Effort::Quick => {
            "A quick reproduction: what takes long (figures 4.6, 4.7, table 4.1, figure 5.2) is a \
             sample, with fewer seeds, coefficients, spheres and times than the thesis has; \
             `tribos reproduce --full` takes all of them."
        }
        Effort::Full => "A full reproduction, by `tribos reproduce --full`.",
    };
    format!("tribos {version}, table tier in f64. {made}")
}
