//! Residual against work: every method with every stopping rule, from zero impulses.

use super::jammed::NotJammed;
use super::powder::compacting;
use super::problems::{chain, pressed};
use super::work::{METHODS, Method, Work, work_to};
use crate::clock::Clock;
use crate::written::{Sheet, short};
use tribos::cd::internals::{Coefficients, Operator, Spheres, Sweeper, residual};
use tribos::cd::{self, IterationOrder, StopRule, WorldMaterials};
use tribos_core::contact::{ContactFriction, IndependentFriction};
use tribos_tests::packings::{dry, first_problem, jammed_box, rough};

/// Spheres of the jammed box, its seed; spheres of the chain.
const COUNT: usize = 1000;
const SEED: u64 = 1;
const CHAIN: usize = 100;
/// Steps of the powder before its problem is taken: about half of the compaction.
const STEPS: usize = 1000;
/// Sliding, rolling and torsion coefficients.
const MU: [f64; 3] = [0.3, 0.1, 0.1];
/// Strong rolling and torsion friction, as in the thesis (section 4.6).
const STRONG: [f64; 3] = [0.3, 1.0, 1.0];
/// Tolerances are 10⁻ᵏ.
const TOLERANCES: std::ops::RangeInclusive<i32> = 1..=9;
/// Times as many sweeps where contacts are frictionless.
const CHEAP: usize = 20;
/// Residuals at which methods are compared.
const TARGETS: [f64; 3] = [1e-4, 1e-6, 1e-8];

/// One solution of one problem.
#[derive(Clone, Debug)]
pub struct Rung {
    /// Name of the problem.
    pub problem: &'static str,
    /// Which method.
    pub method: Method,
    /// Stopping rule, with its number.
    pub rule: String,
    /// Work of the solution, whether or not the rule was met.
    pub work: Work,
    /// Whether the rule was met.
    pub met: bool,
}

/// Work to the same residuals: methods in the order of [`METHODS`], `None` where not reached.
#[derive(Clone, Debug)]
pub struct Contest {
    /// Name of the problem.
    pub problem: &'static str,
    /// Number of contacts of the problem.
    pub contacts: usize,
    /// Residual to reach.
    pub target: f64,
    /// Work of each method.
    pub works: Vec<Option<Work>>,
}

/// All rungs and contests of all problems, with at most `most` sweeps each, 20 times as many without
/// friction.
pub fn measure(most: usize) -> Result<(Vec<Rung>, Vec<Contest>), NotJammed> {
    let refused = |error: cd::WorldError| NotJammed(error.to_string());
    let smooth = IndependentFriction::none();
    let (weak, strong) = (
        rough(MU[0], MU[1], MU[2]),
        rough(STRONG[0], STRONG[1], STRONG[2]),
    );
    let smooth_box = first_problem(&jammed_box(
        COUNT,
        SEED,
        WorldMaterials::uniform(dry(), smooth),
    ));
    let rough_box = first_problem(&jammed_box(
        COUNT,
        SEED,
        WorldMaterials::uniform(dry(), weak),
    ));

    let mut found = (Vec::new(), Vec::new());
    climb(
        "jammed box, frictionless",
        &smooth_box.map_err(refused)?,
        CHEAP * most,
        &mut found,
    );
    climb(
        "jammed box, all modes",
        &rough_box.map_err(refused)?,
        most,
        &mut found,
    );
    climb(
        "powder, weak friction",
        &compacting(weak, STEPS)?,
        most,
        &mut found,
    );
    climb(
        "powder, strong friction",
        &compacting(strong, STEPS)?,
        most,
        &mut found,
    );
    climb(
        "chain",
        &pressed(&chain(CHAIN), smooth)?,
        CHEAP * most,
        &mut found,
    );
    Ok(found)
}

/// All methods and rules on one problem.
fn climb<F>(
    name: &'static str,
    start: &Spheres<F>,
    most: usize,
    (rungs, contests): &mut (Vec<Rung>, Vec<Contest>),
) where
    F: ContactFriction<f64> + Coefficients,
{
    for method in METHODS {
        match method {
            Method::GaussSeidel(order) => rungs.extend(plain(name, start, order, most)),
            _ => rungs.extend(ladder(|tolerance| {
                rung(
                    name,
                    method,
                    format!("change {tolerance:.0e}"),
                    start,
                    |problem| method.iterate(problem, tolerance, most),
                )
            })),
        }
    }
    contests.extend(TARGETS.map(|target| {
        Contest {
            problem: name,
            contacts: start.contacts(),
            target,
            works: METHODS
                .iter()
                .map(|&method| work_to(start, method, target, most))
                .collect(),
        }
    }));
}

/// Plain sweeps: a fixed number, and the local and the global rule.
fn plain<F>(name: &'static str, start: &Spheres<F>, order: IterationOrder, most: usize) -> Vec<Rung>
where
    F: ContactFriction<f64> + Coefficients,
{
    let method = Method::GaussSeidel(order);
    let solve = |stop, rule, most| {
        rung(name, method, rule, start, |problem| {
            cd::internals::solve(problem, &mut Sweeper::new(order, 0), stop, most)
        })
    };
    let mut rungs = Vec::new();
    let mut sweeps = 10;
    while sweeps <= most {
        rungs.push(solve(StopRule::Fixed, format!("N = {sweeps}"), sweeps));
        sweeps *= 2;
    }
    rungs.extend(ladder(|tolerance| {
        solve(
            StopRule::Local(tolerance),
            format!("local {tolerance:.0e}"),
            most,
        )
    }));
    rungs.extend(ladder(|tolerance| {
        solve(
            StopRule::Global(tolerance),
            format!("global {tolerance:.0e}"),
            most,
        )
    }));
    rungs
}

/// Finer and finer tolerances, until one is not met.
fn ladder(mut solve: impl FnMut(f64) -> Rung) -> Vec<Rung> {
    let mut rungs = Vec::new();
    for decades in TOLERANCES {
        let rung = solve(0.1_f64.powi(decades));
        let met = rung.met;
        rungs.push(rung);
        if !met {
            break;
        }
    }
    rungs
}

fn rung<F>(
    problem: &'static str,
    method: Method,
    rule: String,
    start: &Spheres<F>,
    solve: impl FnOnce(&mut Spheres<F>) -> cd::Iterations,
) -> Rung
where
    F: ContactFriction<f64> + Coefficients,
{
    let mut solved = start.clone();
    let clock = Clock::start();
    let effort = solve(&mut solved);
    let seconds = clock.seconds();
    Rung {
        problem,
        method,
        rule,
        work: Work {
            sweeps: effort.sweeps,
            seconds,
            residual: residual(&solved).relative,
        },
        met: effort.met,
    }
}

/// Every rung.
pub fn rungs_sheet(rungs: &[Rung]) -> Sheet {
    Sheet::of(
        "Cold starts: residual sqrt(sum |p - proj(p - m U)|^2 / sum P^2) against work, an \
         extrapolation counted as a sweep",
        rungs,
        &[
            ("problem", &|rung| rung.problem.replace(',', "")),
            ("method", &|rung| rung.method.name().into()),
            ("rule", &|rung| rung.rule.clone()),
            ("met", &|rung| rung.met.to_string()),
            ("sweeps", &|rung| rung.work.sweeps.to_string()),
            ("ms", &|rung| short(1e3 * rung.work.seconds)),
            ("residual", &|rung| short(rung.work.residual)),
        ],
    )
}

/// Sweeps and time to the same residual, and how much less the accelerated method takes than plain
/// sweeps in a fixed order.
pub fn contest_sheet(contests: &[Contest]) -> Sheet {
    let cells = |contest: &Contest| {
        let of = |wanted| METHODS.iter().position(|&method| method == wanted);
        let work = |wanted| of(wanted).and_then(|index| contest.works[index]);
        let (plain, best) = (
            work(Method::GaussSeidel(IterationOrder::Fixed)),
            work(Method::Accelerated),
        );
        let gain = |size: fn(&Work) -> f64| match (plain, best) {
            (Some(plain), Some(best)) => short(size(&plain) / size(&best)),
            _ => "-".into(),
        };
        let mut row = vec![
            contest.problem.replace(',', ""),
            contest.contacts.to_string(),
            format!("{:.0e}", contest.target),
        ];
        row.extend(contest.works.iter().map(|work| {
            work.map_or("-".into(), |work| {
                format!("{} ({} ms)", work.sweeps, short(1e3 * work.seconds))
            })
        }));
        row.push(gain(|work| work.sweeps as f64));
        row.push(gain(|work| work.seconds));
        row
    };
    let names = METHODS.map(Method::name);
    let mut header = vec!["problem", "contacts", "residual"];
    header.extend(names);
    header.extend(["fewer sweeps", "less time"]);
    Sheet {
        about: "Sweeps (and time) from a cold start to a residual, - where the most sweeps do not \
                reach it; the last columns compare the accelerated method with plain sweeps in a \
                fixed order"
            .into(),
        header,
        rows: contests.iter().map(cells).collect(),
    }
}
