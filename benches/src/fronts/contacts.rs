//! Contact dynamics: cost of an update, residual against work, work against size.

use super::{Finding, Front, Setting};
use crate::packing::ladder::Contest;
use crate::packing::scaling::Extent;
use crate::packing::updates::Cost;
use crate::packing::work::METHODS;
use crate::packing::{drawn, ladder, scaling, updates};
use crate::written::{Sheet, short};

/// Rounds of all updates, and of a quick look.
const ROUNDS: usize = 101;
const QUICK_ROUNDS: usize = 15;
/// Most sweeps of a method on the jammed box, and in a quick look.
const MOST_SWEEPS: usize = 10_000;
const QUICK_SWEEPS: usize = 1000;

/// Published figures for a contact update or a step of contacts.
const PEERS: [[&str; 3]; 4] = [
    [
        "single-file C++ program, Gauss-Seidel",
        "sliding",
        "about 50 million updates/s",
    ],
    [
        "YADE",
        "sliding, rolling, torsion (springs)",
        "2 to 3.3 million/s",
    ],
    [
        "LIGGGHTS",
        "sliding, rolling, torsion (springs)",
        "18 million/s",
    ],
    ["Chrono NSC", "470 spheres, 100 sweeps", "6 to 9 ms a step"],
];

/// Makes the front.
pub fn run(setting: &Setting<'_>) -> Result<Finding, String> {
    let (updates, costs) = time_updates(setting)?;
    let (residual, contests) = climb_ladders(setting)?;
    let sizes = grow(setting)?;
    setting.page(Front::Contacts, &[updates, residual, sizes].join("\n"))?;
    Ok(Finding {
        line: line(&costs, &contests),
        picture: "contacts_residual.svg",
    })
}

/// Summary of the front: speed of all modes, and savings by acceleration.
fn line(costs: &[Cost], contests: &[Contest]) -> String {
    let speed = |modes: &str| {
        let cost = costs.iter().find(|cost| cost.modes == modes);
        short(cost.map_or(f64::NAN, |cost| 1e-6 / cost.seconds))
    };
    let sweeps = |method: &str| {
        let of_box = |contest: &&Contest| {
            contest.problem == "jammed box, all modes" && contest.target == 1e-6
        };
        let place = METHODS.iter().position(|known| known.name() == method)?;
        contests.iter().find(of_box)?.works[place]
    };
    let told = |method| sweeps(method).map_or("too many".into(), |work| work.sweeps.to_string());
    format!(
        "One core updates {} million contacts a second with all six modes, {} million that slide \
         only (equal spheres, cold); a jammed box of 1,000 spheres with all modes comes to a \
         residual of 1e-6 in {} accelerated sweeps, in {} plain ones.",
        speed("all six"),
        speed("sliding"),
        told("accelerated"),
        told("GS fixed order"),
    )
}

/// Updates a second for every set of modes, beside the figures of others.
fn time_updates(setting: &Setting<'_>) -> Result<(String, Vec<Cost>), String> {
    let rounds = if setting.quick { QUICK_ROUNDS } else { ROUNDS };
    let costs = updates::measure(rounds).map_err(|error| error.to_string())?;
    let sheet = updates::sheet(&costs, rounds);
    setting.table("contacts_updates", &sheet)?;
    let peers = Sheet {
        about: "Figures of another machine of the same kind:".into(),
        header: vec!["program", "contact", "speed"],
        rows: PEERS.map(|row| row.map(String::from).to_vec()).to_vec(),
    };
    let text = format!("## Updates\n\n{}\n{}", sheet.markdown(), peers.markdown());
    Ok((text, costs))
}

/// Residual against work for all methods and rules.
fn climb_ladders(setting: &Setting<'_>) -> Result<(String, Vec<Contest>), String> {
    let most = if setting.quick {
        QUICK_SWEEPS
    } else {
        MOST_SWEEPS
    };
    let (rungs, contests) = ladder::measure(most).map_err(|error| error.to_string())?;
    let all = ladder::rungs_sheet(&rungs);
    setting.table("contacts_residual", &all)?;
    let sheet = ladder::contest_sheet(&contests);
    setting.table("contacts_contest", &sheet)?;
    drawn::residuals(setting.out, &rungs)?;
    let text = format!(
        "## Residual against work\n\n{}\n![Residual against sweeps and time](contacts_residual.svg)\
         \n\nAll rules and levels: [contacts_residual.csv](contacts_residual.csv).\n",
        sheet.markdown()
    );
    Ok((text, contests))
}

/// Sweeps against size.
fn grow(setting: &Setting<'_>) -> Result<String, String> {
    let extent = if setting.quick {
        Extent {
            chains: vec![12, 25, 50, 100],
            towers: vec![250, 500, 1000],
            cubes: vec![500, 1000, 2000],
            updates: 1e8,
        }
    } else {
        Extent {
            chains: vec![12, 25, 50, 100, 200, 400, 800, 1600, 3200],
            towers: vec![125, 250, 500, 1000, 2000],
            cubes: vec![500, 1000, 2000, 5000],
            updates: 2e8,
        }
    };
    let points = scaling::measure(&extent).map_err(|error| error.to_string())?;
    let all = scaling::points_sheet(&points);
    setting.table("contacts_scaling", &all)?;
    let laws = scaling::laws_sheet(&scaling::laws(&points));
    drawn::sizes(setting.out, &points)?;
    Ok(format!(
        "## Work against size\n\n{}\n{}\n![Sweeps against size](contacts_scaling.svg)\n",
        laws.markdown(),
        all.markdown()
    ))
}
