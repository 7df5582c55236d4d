//! What the report is written as: its page, the claims as a table, lines for the terminal.

use super::runs::Effort;
use tribos_report::claim::Claim;
use tribos_report::page::{Page, Section};
use tribos_report::verdict::{Counts, Verdict};

/// The verdicts of some claims.
pub fn counts<'a>(claims: impl IntoIterator<Item = &'a Claim>) -> Counts {
    Counts::of(claims.into_iter().map(|claim| &claim.verdict))
}

/// All claims as CSV text.
pub fn claims_csv(sections: &[Section]) -> String {
    let quoted = |text: &str| format!("\"{}\"", text.replace('"', "\"\"").replace('`', ""));
    let mut text =
        String::from("exhibit,place,claim,thesis,ours,uncertainty,difference,verdict,evidence\n");
    for section in sections {
        for claim in &section.claims {
            let fields = [
                &section.id,
                &claim.place,
                &claim.statement,
                &claim.thesis,
                &claim.ours,
                &claim.uncertainty,
                &claim.difference,
                claim.verdict.name(),
                &claim.verdict.evidence(),
            ];
            text += &fields.map(quoted).join(",");
            text.push('\n');
        }
    }
    text
}

/// The sentence that a reader takes away.
fn lead(sections: &[Section]) -> String {
    let claims = || sections.iter().flat_map(|section| &section.claims);
    let all = counts(claims());
    let [
        reproduced,
        trend,
        ours,
        definition,
        known,
        differs,
        error,
        unchecked,
        failed,
    ] = all.0;
    let random = |claim: &&Claim| match &claim.verdict {
        Verdict::Reproduced(agreement) => !agreement.allowance().is_exact(),
        _ => false,
    };
    let measured = claims().filter(random).count();
    let failures = match failed {
        0 => String::new(),
        n => format!(" {n} comparisons failed."),
    };
    format!(
        "Of {} rows, {reproduced} reproduce a number that the thesis states within the thesis' own error \
         ({} of them exact values and closed forms, {measured} with an error), {trend} a \
         trend; {differs} differ for reasons that are open, {known} for a reason that is shown, and in \
         {error} the thesis is in error.{failures} The other {} compare nothing with a number of the thesis: \
         {ours} are results or formulas checked against something else, {definition} are inputs that cannot \
         fail, {unchecked} cannot be checked.",
        all.total(),
        reproduced - measured,
        ours + definition + unchecked
    )
}

/// The whole page.
pub fn page(sections: Vec<Section>, effort: Effort) -> Page {
    Page {
        title: "Mesoscopic aspects of solid friction: the thesis checked".into(),
        lead: lead(&sections),
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
            "Chapter 4 compacts cohesive powders of spheres with rolling and torsion friction. Its \
             trends come out and its levels do not: under the law as it is read here rigid spheres end 7 to 13 \
             points above the porosities of the thesis, and what makes those lower is known in part only \
             (figure 4.7). Section 5.3 turns a \
             tip of atoms on a substrate until it slips; here, too, the trend comes out and the threshold \
             does not."
                .into(),
            "The column thesis holds numbers that the thesis prints or that a formula it prints has; a dash means \
             that it states none. A row is reproduced if ours lies within the error of the thesis' number: \
             half a unit of its last digit, an error that the thesis states, or what our arithmetic leaves where \
             it gives an exact value or a closed form; the row says which. No number was read off a \
             figure. Trend reproduced: sign, order, monotony, scaling or size, whatever the number. Ours, checked: the thesis has no number; the statement is ours and holds beside what \
             the row names, which may be a formula of the thesis. Definition: an input, a convention or a \
             property put in by hand. Thesis in error: the row says what is right."
                .into(),
            "F and T come from one hypergeometric formula for every real α > −1 and every pressure \
             (1−r²)^q. An uncertainty, with ±, is that of ours: a standard deviation over seeds. Where there is \
             none, ours is computed to the digits shown, or comes from the one run that the row names."
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

#[cfg(test)]
mod tests {
    use super::*;
    use tribos_report::verdict::Allowance;

    #[test]
    fn the_first_sentence_counts_every_row_once() {
        let stated = |allowance| Claim::stated("1", "a", ("0.5", 0.5), 0.5, allowance);
        let claims = vec![
            stated(Allowance::Exact(0.0)),
            stated(Allowance::Digits(0.05)),
            Claim::trend("1", "a", String::new(), true, "order"),
            Claim::own_statement("a", String::new(), true, "b"),
            Claim::not_checkable("1", "a", "no numbers"),
        ];
        let section = Section {
            claims,
            ..Section::default()
        };
        let text = lead(&[section]);
        assert!(
            text.starts_with("Of 5 rows, 2 reproduce a number"),
            "{text}"
        );
        assert!(text.contains("(1 of them exact values and closed forms, 1 with an error)"));
        assert!(text.contains("The other 2 compare nothing") && !text.contains("failed"));
    }

    #[test]
    fn claims_are_a_table_without_backticks() {
        let section = Section {
            id: "figure-1".into(),
            claims: vec![Claim::not_checkable("1", "run `tribos`", "a \"b\"")],
            ..Section::default()
        };
        let text = claims_csv(&[section]);
        let line = text.lines().nth(1);
        let expected = "\"figure-1\",\"1\",\"run tribos\",\"\",\"\",\"\",\"\",\"not checkable\",\"a \"\"b\"\"\"";
        assert_eq!(line, Some(expected));
    }
}
