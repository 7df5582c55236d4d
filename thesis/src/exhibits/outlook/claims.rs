//! What the outlook states and asks, and what the map answers.

use super::map::{Estimate, Map};
use super::table::{
    CORNERS, COUPLINGS, CompactionParameters, Line, PRESSURES, SPREADS, cells, name,
};
use super::{COUPLED, TEXT};
use crate::exhibits::porosity::{ADDITIVITY, FLUCTUATION};
use crate::runs::{Effort, Runs};
use anyhow::Result;
use tribos::scene::FrictionCoupling;
use tribos::statistics::mean;
use tribos_report::claim::Claim;

/// The ratio of pressure to cohesion of the thesis.
const STATED: f64 = 0.0025;
/// The run that a quick report repeats: few sweeps.
const REPEATED: CompactionParameters = CompactionParameters {
    seed: 1,
    spread: 0.0,
    pressure: 0.64,
    corner: [0.0, 0.0],
    coupling: FrictionCoupling::Independent,
};
/// Bits of another program: what a porosity of the kept table may be off.
const REPEATABLE: f64 = 5e-3;

/// All claims.
pub fn all(runs: &Runs, map: &Map) -> Result<Vec<Claim>> {
    let mut claims = stated(map);
    claims.extend(of_pressure(map));
    claims.extend(of_sizes(map));
    claims.extend(of_coupling(map));
    claims.push(all_blocked(map));
    if runs.effort() == Effort::Quick {
        claims.push(repeated(runs, map)?);
    }
    Ok(claims)
}

/// "−2.1 ± 0.4": mean and standard error in points, or the mean of one deposit.
fn points(estimate: &Estimate) -> String {
    let (mean, error) = (100.0 * estimate.mean(), 100.0 * estimate.error());
    if error.is_finite() {
        format!("{mean:+.1} ± {error:.1}")
    } else {
        format!("{mean:+.1} (one deposit)")
    }
}

/// What the first paragraph says, at the thesis' pressure and with equal spheres.
fn stated(map: &Map) -> Vec<Claim> {
    let cell = (0.0, STATED);
    let excess = map.excess(cell, FrictionCoupling::Independent);
    let pull = |pressure, corner: [f64; 2]| {
        let term = [(corner, FrictionCoupling::Independent, -1.0)];
        map.sums((0.0, pressure), &term, |line| line.pull).mean()
    };
    let pulls = CORNERS.map(|corner| pull(STATED, corner));
    let more = PRESSURES
        .into_iter()
        .filter(|&at| pull(at, [1.0; 2]) >= pull(at, [0.0; 2]));
    let more: Vec<String> = more.map(|at| at.to_string()).collect();
    let until = match more.as_slice() {
        [] => "at every pressure".to_owned(),
        some => format!("at every pressure but P R²/F_coh = {}", some.join(", ")),
    };
    vec![
        Claim::trend(
            TEXT.said("sum"),
            format!("ΔE = {} points", points(&excess)),
            excess.mean().abs() < ADDITIVITY,
        )
        .printed("3 %"),
        Claim::trend(
            TEXT.said("tension"),
            format!(
                "σ_zz⁻ = −{:.1}P at (0,0), −{:.1}P at (0,1), −{:.1}P at (1,0), −{:.1}P at (1,1)",
                pulls[0], pulls[1], pulls[2], pulls[3]
            ),
            pulls[3] < 0.5 * pulls[0] && pulls[2] < 0.5 * pulls[0] && pulls[1] < pulls[0],
        ),
        Claim::own_statement(
            TEXT.said("tension-by-pressure"),
            until,
            pull(PRESSURES[0], [1.0; 2]) < pull(PRESSURES[0], [0.0; 2]),
        ),
    ]
}

/// The same analysis for other ratios of pressure to cohesion.
fn of_pressure(map: &Map) -> Vec<Claim> {
    let mean = |cell, corner| {
        map.porosity(cell, corner, FrictionCoupling::Independent)
            .mean()
    };
    let falls = CORNERS.iter().flat_map(|&corner| {
        SPREADS.map(move |spread| PRESSURES.map(|pressure| mean((spread, pressure), corner)))
    });
    let falling: Vec<bool> = falls
        .map(|curve| curve.windows(2).all(|pair| pair[1] < pair[0]))
        .collect();
    let down = falling.iter().filter(|falls| **falls).count();
    let in_order = |&cell: &(f64, f64)| {
        let values = CORNERS.map(|corner| mean(cell, corner));
        values.windows(2).all(|pair| pair[0] < pair[1])
    };
    let ordered = cells().filter(in_order).count();
    let excess = |cell| map.excess(cell, FrictionCoupling::Independent);
    let differ = cells()
        .filter(|&cell| excess(cell).differs_from_zero())
        .count();
    let below = cells().filter(|&cell| excess(cell).mean() < 0.0).count();
    let largest = cells()
        .map(|cell| excess(cell).mean())
        .fold(0.0, |a: f64, b| a.max(b.abs()));
    // Over all widths and deposits of a pressure.
    let pooled = PRESSURES.map(|pressure| {
        let values = SPREADS
            .iter()
            .flat_map(|&spread| excess((spread, pressure)).values);
        Estimate {
            values: values.collect(),
        }
    });
    let shown: Vec<String> = pooled.iter().map(points).collect();
    let count = cells().count();
    vec![
        Claim::trend(
            TEXT.said("pressure"),
            format!(
                "{down} of {} curves fall from each pressure to the next",
                falling.len()
            ),
            down == falling.len(),
        ),
        Claim::own_statement(
            TEXT.said("order"),
            format!("in {} of {count} cells", ordered),
            ordered as f64 > 0.9 * count as f64,
        ),
        Claim::own_statement(
            TEXT.said("additive").with("deposits", super::deposits(map)),
            format!(
                "ΔE < 0 in {below} of {count} cells, from 0 by more than the 95 % interval of its mean in {differ}; \
                 all widths together, by pressure: {} points",
                shown.join(", ")
            ),
            pooled
                .iter()
                .filter(|estimate| estimate.differs_from_zero())
                .count()
                > 3
                && pooled.iter().all(|estimate| estimate.mean() < 0.0),
        ),
        Claim::own_statement(
            TEXT.said("additive-size"),
            format!(
                "|ΔE| ≤ {:.1} points, mean {:.1}",
                100.0 * largest,
                100.0 * mean_of(&pooled)
            ),
            largest < 2.0 * ADDITIVITY && mean_of(&pooled).abs() < ADDITIVITY,
        ),
    ]
}

fn mean_of(estimates: &[Estimate]) -> f64 {
    mean(&estimates.iter().map(Estimate::mean).collect::<Vec<_>>())
}

/// Spheres of different size.
fn of_sizes(map: &Map) -> Vec<Claim> {
    // Each pressure counts alike, however many deposits it has.
    let by_width = |of: &dyn Fn((f64, f64)) -> Estimate| {
        SPREADS.map(|spread| mean_of(&PRESSURES.map(|pressure| of((spread, pressure)))))
    };
    let excess = by_width(&|cell| map.excess(cell, FrictionCoupling::Independent));
    let torques = [
        ([1.0; 2], FrictionCoupling::Independent, 1.0),
        ([0.0; 2], FrictionCoupling::Independent, -1.0),
    ];
    let added = by_width(&|cell| map.sums(cell, &torques, |line| line.porosity));
    let base = by_width(&|cell| map.porosity(cell, [0.0; 2], FrictionCoupling::Independent));
    let list = |means: &[f64]| {
        let each = means.iter().map(|mean| format!("{:+.1}", 100.0 * mean));
        each.collect::<Vec<_>>().join(", ")
    };
    let range = |means: &[f64]| {
        let means = means.iter().copied();
        means.clone().fold(f64::MIN, f64::max) - means.fold(f64::MAX, f64::min)
    };
    vec![
        Claim::own_statement(
            TEXT.said("sizes-additive"),
            format!("{} points, mean over the pressures", list(&excess)),
            range(&excess) < FLUCTUATION,
        ),
        Claim::own_statement(
            TEXT.said("sizes-torques"),
            format!("{} points, mean over the pressures", list(&added)),
            range(&added) < 1.5 * FLUCTUATION,
        ),
        Claim::own_statement(
            TEXT.said("sizes-base"),
            format!(
                "{} %, mean over the pressures",
                list(&base).replace('+', "")
            ),
            range(&base) < 1.5 * FLUCTUATION,
        ),
    ]
}

/// Sliding and torsion coupled.
fn of_coupling(map: &Map) -> Vec<Claim> {
    let pooled = |coupling| {
        let values = cells().flat_map(|cell| {
            COUPLED
                .into_iter()
                .flat_map(move |corner| map.coupled(cell, corner, coupling).values)
        });
        Estimate {
            values: values.collect(),
        }
    };
    let coupled = [COUPLINGS[1], COUPLINGS[2]];
    let differences = coupled.map(pooled);
    let words = |of: &dyn Fn(FrictionCoupling) -> String| {
        let each = coupled
            .iter()
            .map(|&coupling| format!("{} {}", name(coupling), of(coupling)));
        each.collect::<Vec<_>>().join(", ")
    };
    let per_sweep = |line: &Line| line.seconds / (line.sweeps * line.contacts);
    let [sweeps, time] = [
        coupled.map(|coupling| map.cost(coupling, |line| line.sweeps)),
        coupled.map(|coupling| map.cost(coupling, per_sweep)),
    ];
    vec![
        Claim::own_statement(
            TEXT.said("coupling-porosity"),
            words(&|coupling| format!("{} points", points(&pooled(coupling)))),
            differences
                .iter()
                .all(|estimate| estimate.mean().abs() < FLUCTUATION),
        ),
        coupling_by_pressure(map),
        Claim::own_statement(
            TEXT.said("coupling-sweeps"),
            format!(
                "ellipsoid {:.2}, exact {:.2} times as many",
                sweeps[0], sweeps[1]
            ),
            sweeps.iter().all(|ratio| *ratio < 1.2),
        ),
        Claim::own_statement(
            TEXT.said("coupling-time"),
            format!(
                "ellipsoid {:.1}, exact {:.1} times as long a contact",
                time[0], time[1]
            ),
            time.iter().all(|ratio| *ratio > 1.0),
        ),
    ]
}

/// What a coupling does where rolling is blocked as well, pressure by pressure.
fn coupling_by_pressure(map: &Map) -> Claim {
    let at = |coupling, pressure| {
        let widths = SPREADS.iter();
        let values =
            widths.flat_map(|&spread| map.coupled((spread, pressure), [1.0; 2], coupling).values);
        Estimate {
            values: values.collect(),
        }
    };
    let coupled = [COUPLINGS[1], COUPLINGS[2]];
    let shown = |coupling| {
        let each = PRESSURES.map(|pressure| match at(coupling, pressure) {
            none if none.values.is_empty() => "no run".to_owned(),
            some => format!("{:+.1}", 100.0 * some.mean()),
        });
        format!("{} {}", name(coupling), each.join(", "))
    };
    let all = coupled
        .iter()
        .flat_map(|&coupling| PRESSURES.map(|pressure| at(coupling, pressure)));
    let mut known = all.filter(|estimate| !estimate.values.is_empty());
    Claim::own_statement(
        TEXT.said("coupling-by-pressure"),
        format!("{} points", coupled.map(shown).join("; ")),
        known.all(|estimate| estimate.mean().abs() < 3.0 * FLUCTUATION),
    )
}

/// Stable and reliable.
fn all_blocked(map: &Map) -> Claim {
    let lines = map.lines();
    let blocked = lines.iter().filter(|line| line.blocked).count();
    let sum = |of: fn(&Line) -> f64| lines.iter().map(of).sum::<f64>();
    let unmet = sum(|line| line.unmet) / sum(|line| line.steps);
    Claim::own_statement(
        TEXT.said("blocked"),
        format!(
            "{blocked} of {} runs; {:.2} % of their steps end at the bound of 1000 sweeps",
            lines.len(),
            100.0 * unmet
        ),
        blocked == lines.len() && unmet < 0.05,
    )
}

/// One line of the kept table, run now.
fn repeated(runs: &Runs, map: &Map) -> Result<Claim> {
    let run = runs.one(&REPEATED.case())?;
    let ours = run.outcome.porosity_final;
    let kept = map.line(REPEATED).map_or(f64::NAN, |line| line.porosity);
    Ok(Claim::own_statement(
        TEXT.said("repeated"),
        format!("{:.3} %, in the table {:.3} %", 100.0 * ours, 100.0 * kept),
        (ours - kept).abs() < REPEATABLE,
    ))
}
