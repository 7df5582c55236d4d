//! What the choices tell.

use super::shares::Shares;
use super::{
    CORNERS, Choice, FLUCTUATION, JUDGED, KeptTables, LIMITS, Line, PRINTED_PRESSURE, TEXT, Table,
};
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

pub(super) fn claims(
    runs: &Runs,
    kept: &KeptTables,
    judged: &[(Choice, f64)],
) -> Result<Vec<Claim>> {
    let table = &kept.small;
    let [four, six, _, eight] = LIMITS;
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
    claims.extend(held_out(table));
    claims.extend(sizes(kept));
    claims.extend(shares(&kept.shares));
    let lines = || table.0.iter().chain(&kept.large.0);
    let (blocked, all) = (
        lines().filter(|line| line.is_blocked).count(),
        lines().count(),
    );
    claims.push(Claim::own_statement(
        TEXT.said("blocked"),
        format!("{blocked} of {all}"),
        all - blocked <= all / 50,
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

/// Choices found with the first deposit, judged by the others alone.
fn held_out(table: &Table) -> Option<Claim> {
    let [limit, ..] = LIMITS;
    let first = table.deposits(|seed| seed == 1.0);
    let others = table.deposits(|seed| seed != 1.0);
    let found = |choice: &Choice| first.misfit(choice).is_some_and(|misfit| misfit < limit);
    let choices = others.choices();
    let tested = choices
        .iter()
        .filter(|choice| found(choice) && others.deposits_of(choice) >= 4.0);
    let tested: Vec<(&Choice, f64)> = tested
        .filter_map(|choice| Some((choice, others.misfit(choice)?)))
        .collect();
    let failed = tested.iter().filter(|(_, misfit)| *misfit >= limit);
    let failed: Vec<String> = failed
        .map(|(choice, misfit)| format!("{} (χ² = {misfit:.1})", choice.words()))
        .collect();
    let dropped = if failed.is_empty() {
        String::new()
    } else {
        format!("; not {}", failed.join("; "))
    };
    let held = tested.len() - failed.len();
    let claim = Claim::own_statement(
        TEXT.said("held-out").with("limit", limit),
        format!("{held} of {}{dropped}", tested.len()),
        2 * held > tested.len(),
    );
    (!tested.is_empty()).then_some(claim)
}

/// The large system under the judged choices.
fn sizes(kept: &KeptTables) -> Vec<Claim> {
    let [limit, ..] = LIMITS;
    let each = JUDGED.iter().filter_map(|choice| {
        let misfit = kept.large.misfit(choice)?;
        let apart = CORNERS.map(|(pair, _)| {
            let of = |table: &Table| {
                table
                    .porosity(choice, pair)
                    .map_or(f64::NAN, |found| found.0)
            };
            of(&kept.large) - of(&kept.small)
        });
        let shown = apart.map(|points| format!("{points:+.1}")).join(", ");
        let largest = apart
            .iter()
            .fold(0.0_f64, |most, points| most.max(points.abs()));
        Some(
            Claim::own_statement(
                TEXT.said("size").with("choice", choice.words()),
                format!(
                    "{shown} points; χ² = {misfit:.1}, {}",
                    corners(&kept.large, choice)
                ),
                largest < 2.0 * FLUCTUATION && (misfit < limit) == (*choice != JUDGED[0]),
            )
            .uncertain(format!(
                "deposits of it: {}",
                kept.large.deposits_of(choice)
            )),
        )
    });
    each.collect()
}

/// The split of a blocked packing's stress by the share of its forces that it is solved anew from.
fn shares(shares: &Shares) -> Vec<Claim> {
    // One number is fitted.
    let [_, _, limit, _] = LIMITS;
    let [error, motion] = shares.unrest();
    let ends = |pair| {
        let at = |share| shares.plus(share, pair).map_or(f64::NAN, |found| found.0);
        [at(0.0), at(1.0)]
    };
    let ([low, high], [few, many]) = (ends([0.0; 2]), ends([1.0; 2]));
    let (share, misfit) = shares.best().unwrap_or((f64::NAN, f64::NAN));
    let [none, all] = [0.0, 1.0].map(|share| shares.misfit(share).unwrap_or(f64::NAN));
    let needed = shares
        .all_needed()
        .map(|share| share.map_or("none".into(), |share| format!("{share:.2}")));
    let claims = [
        Claim::own_statement(
            TEXT.said("anew").with("choice", JUDGED[1].words()),
            format!("total stress within {error:.1e}, porosity within {motion:.0e} points"),
            error < 0.01 && motion < 0.001,
        ),
        Claim::own_statement(
            TEXT.said("not-unique"),
            format!("{low:.1} to {high:.1} at (0,0), {few:.2} to {many:.2} at (1,1)"),
            high > 2.0 * low,
        ),
        Claim::own_statement(
            TEXT.said("one-share").with("limit", limit),
            format!(
                "χ² = {misfit:.1} with {share}, {none:.0} with nothing, {all:.0} with all; line by line {}",
                needed.join(", ")
            ),
            misfit < limit && none.min(all) > limit,
        ),
    ];
    let deposits = format!("{} deposits", shares.deposits());
    claims
        .into_iter()
        .map(|claim| claim.uncertain(&deposits))
        .collect()
}
