//! What only the whole grid of figure 4.7 shows.

use super::claims::{ADDITIVITY, FLUCTUATION, RATIO_TOLERANCE, all_blocked, percent};
use super::{Porosities, TEXT};
use tribos_report::claim::Claim;
use tribos_report::verdict::Verdict;

/// From here on the thesis calls the porosity saturated.
const SATURATED: f64 = 0.4;
/// From here on ours is.
const LATER: f64 = 0.7;
/// How much ours rises from 0.4 on, as found before.
const RISE: std::ops::RangeInclusive<f64> = 0.025..=0.045;

/// All claims.
pub fn all(small: &Porosities, large: &Porosities) -> Vec<Claim> {
    let systems = [small, large].into_iter();
    let mut claims: Vec<Claim> = systems.flat_map(of_one).collect();
    claims.push(sizes(small, large));
    claims.push(all_blocked(large));
    claims
}

/// Saturation, sum and ratio of the contributions in one system.
fn of_one(system: &Porosities) -> Vec<Claim> {
    let name = system.system.name();
    let said = |id| TEXT.said(id).with("system", name);
    let count = system.mus.len();
    let mean = |i: usize, j: usize| system.at(i, j).0;
    let added = |i, j| mean(i, j) - mean(0, 0);
    let mut worst = 0.0_f64;
    let mut ratios = (f64::INFINITY, f64::NEG_INFINITY);
    for i in 1..count {
        for j in 1..count {
            worst = worst.max((added(i, j) - added(i, 0) - added(0, j)).abs());
        }
        let ratio = added(i, 0) / added(0, i);
        ratios = (ratios.0.min(ratio), ratios.1.max(ratio));
    }
    let [early, late] = [SATURATED, LATER].map(|from| spread(system, from));
    let shown = |spread: f64| format!("at most {} from E(1,1)", percent(spread));
    vec![
        saturation(name, shown(early), early),
        Claim::own_statement(said("later-saturation"), shown(late), late < FLUCTUATION),
        Claim::trend(
            said("sum-of-all"),
            format!("at most {}", percent(worst)),
            worst < ADDITIVITY,
        )
        .printed("3 %"),
        Claim::trend(
            said("twice-for-all"),
            format!("between {:.1} and {:.1}", ratios.0, ratios.1),
            ratios.0 > 2.0 - RATIO_TOLERANCE && ratios.1 < 2.0 + RATIO_TOLERANCE,
        )
        .printed("≈ 2"),
    ]
}

/// The thesis' saturation, or what ours does instead as it did before.
fn saturation(name: &str, shown: String, rise: f64) -> Claim {
    let holds = rise < FLUCTUATION;
    let claim = Claim::trend(
        TEXT.said("saturation").with("system", name),
        shown,
        holds || RISE.contains(&rise),
    );
    let verdict = match claim.verdict {
        Verdict::Trend(_) if !holds => Verdict::Differs(TEXT.said("saturation-differs").basis),
        verdict => verdict,
    };
    Claim { verdict, ..claim }.printed("0.4")
}

/// Largest distance of a porosity from that of the last corner, where both coefficients are at least
/// `from`.
fn spread(system: &Porosities, from: f64) -> f64 {
    let count = system.mus.len();
    let end = system.at(count - 1, count - 1).0;
    let high = || (0..count).filter(|i| system.mus[*i] >= from);
    let cells = high().flat_map(|i| high().map(move |j| (i, j)));
    cells
        .map(|(i, j)| (system.at(i, j).0 - end).abs())
        .fold(0.0, f64::max)
}

/// Both systems agree.
fn sizes(small: &Porosities, large: &Porosities) -> Claim {
    let (mut sum, mut worst, mut count) = (0.0, 0.0_f64, 0.0);
    for i in 0..small.mus.len() {
        for j in 0..small.mus.len() {
            let apart = (small.at(i, j).0 - large.at(i, j).0).abs();
            sum += apart;
            count += 1.0;
            worst = worst.max(apart);
        }
    }
    let mean = sum / count;
    Claim::trend(
        TEXT.said("sizes"),
        format!(
            "{:.1} % apart on average, {:.1} % at most",
            100.0 * mean,
            100.0 * worst
        ),
        mean < FLUCTUATION,
    )
}
