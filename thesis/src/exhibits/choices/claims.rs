//! What the choices tell.

use super::{CORNERS, Choice, FLUCTUATION, JUDGED, LIMITS, Line, PRINTED_PRESSURE, TEXT, Table};
use crate::runs::{Case, Runs, System};
use anyhow::Result;
use tribos::scene::WallLaw;
use tribos_report::claim::Claim;

/// "54.8 63.9 73.3 82.2 %".
fn corners(table: &Table, choice: &Choice) -> String {
    let shown = CORNERS.map(|(pair, _)| {
        table
            .porosity(choice, pair)
            .map_or(f64::NAN, |found| found.0)
    });
    format!(
        "{} %",
        shown.map(|porosity| format!("{porosity:.1}")).join(", ")
    )
}

pub(super) fn claims(runs: &Runs, table: &Table, judged: &[(Choice, f64)]) -> Result<Vec<Claim>> {
    let [four, six, eight] = LIMITS;
    let compatible: Vec<&Choice> = judged
        .iter()
        .filter(|(_, misfit)| *misfit < four)
        .map(|(choice, _)| choice)
        .collect();
    let ends = |of: fn(&Choice) -> f64| {
        let values = compatible.iter().map(|choice| of(choice));
        values.fold([f64::INFINITY, 0.0_f64], |[least, most], x| {
            [least.min(x), most.max(x)]
        })
    };
    let [loosest, tightest] = ends(Choice::group);
    let [weakest, strongest] = ends(|choice| choice.mu);
    let [light, heavy] = ends(|choice| choice.pressure / PRINTED_PRESSURE);
    let is_printed = |choice: &Choice| choice.mu == 0.3 && choice.pressure == PRINTED_PRESSURE;
    let printed = judged.iter().find(|(choice, _)| is_printed(choice));
    let (nearest, misfit) = printed.map_or((JUDGED[0], f64::NAN), |found| *found);
    let mut claims = vec![
        Claim::own_statement(
            TEXT.said("printed"),
            format!(
                "χ² = {misfit:.0} at best, {}: {}",
                nearest.words(),
                corners(table, &nearest)
            ),
            misfit > four,
        ),
        Claim::own_statement(
            TEXT.said("compatible").with("limit", four),
            format!("{} of {}", compatible.len(), judged.len()),
            !compatible.is_empty() && compatible.iter().all(|choice| !is_printed(choice)),
        ),
        Claim::own_statement(
            TEXT.said("group"),
            format!("{loosest:.0} to {tightest:.0}"),
            tightest < 0.3 / PRINTED_PRESSURE && loosest > 0.2 * tightest,
        ),
        Claim::own_statement(
            TEXT.said("not-apart"),
            format!(
                "μ from {weakest} to {strongest}, pressures from {light} to {heavy} times the printed one"
            ),
            weakest < strongest && light < heavy,
        ),
    ];
    let [apart, span] = table.collapse(judged);
    claims.push(Claim::own_statement(
        TEXT.said("curve"),
        format!("{apart:.1} of {span:.0} points"),
        apart < 1.5 * FLUCTUATION && span > 10.0 * apart,
    ));
    for choice in &JUDGED[1..] {
        let misfit = table.whole_misfit(choice).unwrap_or(f64::NAN);
        let rises = table.rises(choice).unwrap_or([f64::NAN; 2]);
        claims.push(
            Claim::own_statement(
                TEXT.said("whole")
                    .with("choice", choice.words())
                    .with("limit", six),
                format!(
                    "χ² = {misfit:.1}: {}; from 0.4 to 1 {:+.1} and {:+.1} points",
                    corners(table, choice),
                    rises[0],
                    rises[1]
                ),
                misfit < six,
            )
            .uncertain("five deposits"),
        );
    }
    let stresses = JUDGED[1..]
        .iter()
        .filter_map(|choice| table.stress_misfit(choice));
    let stresses: Vec<f64> = stresses.collect();
    let shown: Vec<String> = stresses
        .iter()
        .map(|misfit| format!("{misfit:.0}"))
        .collect();
    claims.push(
        Claim::own_statement(
            TEXT.said("stress").with("limit", eight),
            format!("χ² = {}", shown.join(", ")),
            !shown.is_empty() && stresses.iter().all(|misfit| *misfit > eight),
        )
        .uncertain("five deposits"),
    );
    let blocked = table.0.iter().filter(|line| line.is_blocked).count();
    claims.push(Claim::own_statement(
        TEXT.said("blocked"),
        format!("{blocked} of {}", table.0.len()),
        table.0.len() - blocked <= table.0.len() / 50,
    ));
    claims.extend(repeated(runs, table)?);
    Ok(claims)
}

/// A line of the table, run again.
fn repeated(runs: &Runs, table: &Table) -> Result<Option<Claim>> {
    let Choice {
        mu,
        pressure,
        range,
        ..
    } = JUDGED[3];
    let keys = format!("mu={mu},pressure={pressure},cohesion_range={range},wall=smooth");
    let case = Case::new(System::Small, [0.0; 2], 1).with(&keys, |scene| {
        (scene.mu, scene.pressure, scene.cohesion_range) = (mu, pressure, range);
        scene.wall_contact = WallLaw::Smooth;
    });
    let ours = 100.0 * runs.one(&case)?.outcome.porosity_final;
    let is_it =
        |line: &&Line| line.choice == JUDGED[3] && line.pair == [0.0; 2] && line.seed == 1.0;
    Ok(table
        .0
        .iter()
        .find(is_it)
        .map(|line| Claim::own(TEXT.said("repeated"), ours, line.porosity, 0.5)))
}
