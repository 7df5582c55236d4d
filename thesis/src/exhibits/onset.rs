//! Section 3.1: the coupling of static force and torque, by a model of bonds.

use crate::exhibit::Exhibit;
use crate::text::Text;
use anyhow::{Result, anyhow};
use tribos::friction::{FlatPatch, Patch};
use tribos::onset::{Bond, OnsetContact, OnsetPoint, OnsetSurface};
use tribos_core::bond::{Bonds, FailureMode};
use tribos_core::patch::nodes::Nodes;
use tribos_core::twist::Twist;
use tribos_report::claim::Claim;
use tribos_report::digits::short;
use tribos_report::figure::{Axis, Figure, Legend, Panels, Series};

const TEXT: Text = Text(include_str!("section-3.1.md"));

/// Laws of bonds by the spread of their strengths, the broadest first.
const BONDS: [(&str, Bond); 5] = [
    ("plastic", Bond::Plastic),
    ("exponential", Bond::Exponential),
    ("Weibull, m = 2", Bond::Weibull(2.0)),
    ("Weibull, m = 8", Bond::Weibull(8.0)),
    ("one strength", Bond::OneStrength),
];

/// Laws of bonds that re-form, the broadest first.
const RE_FORMING: [(&str, Bond); 5] = [
    ("n = 1", Bond::ReForming(1)),
    ("n = 16", Bond::ReForming(16)),
    ("n = 64", Bond::ReForming(64)),
    ("n = 256", Bond::ReForming(256)),
    ("one strength", Bond::ReFormingOneStrength),
];
/// Place of the relative spread 1/8 in [`RE_FORMING`].
const AN_EIGHTH: usize = 2;

/// Points of a curve.
const POINTS: usize = 31;

fn curve(patch: &Patch, bond: Bond) -> Result<OnsetSurface> {
    Ok(OnsetSurface::new(
        patch,
        bond,
        &OnsetContact::default(),
        POINTS,
    )?)
}

/// |F| and T of a push.
fn force_and_torque(point: &OnsetPoint) -> (f64, f64) {
    let push = &point.onset.push;
    (push.force.norm(), push.torque)
}

/// |F| and T at the onset of a tripod with its feet on the unit circle, pushed between two of them.
fn tripod_curve(bond: Bond) -> Result<Vec<(f64, f64)>> {
    let (x, y) = (0.75_f64.sqrt(), -0.5);
    let feet = Nodes::tripod([[0.0, 1.0], [-x, y], [x, y]], [0.0, 0.0])?;
    let bonds = Bonds::new(bond.with(1.0, 1.0)?, feet)?;
    (0..POINTS)
        .map(|i| {
            let share = 0.5 * std::f64::consts::PI * i as f64 / (POINTS - 1) as f64;
            let direction = Twist::new(0.0, -share.cos(), share.sin());
            let onset = bonds.onset(1.0, &direction);
            let push = onset
                .filter(|onset| onset.release != FailureMode::Holds)
                .ok_or_else(|| anyhow!("the tripod does not let go"))?
                .push;
            Ok((push.force.norm(), push.torque))
        })
        .collect()
}

/// Onset curves of the disk, and the gap of static and dynamic friction.
pub fn section_3_1() -> Result<Exhibit> {
    let disk = curves(&Patch::Disk, &BONDS)?;
    let gaps = curves(&Patch::Disk, &RE_FORMING)?;
    let panels = Panels::new("", 2)
        .figure(onset_figure(&disk))
        .figure(gap_figure(&gaps))
        .cell(520, 420);
    let mut claims = coupled(&disk)?;
    claims.extend(ratios(&disk));
    claims.extend(re_forming(&gaps)?);
    let prose = TEXT.prose();
    Ok(Exhibit::new(
        prose,
        panels,
        &COLUMNS,
        rows(&disk, &gaps),
        claims,
    ))
}

fn curves(patch: &Patch, bonds: &[(&str, Bond)]) -> Result<Vec<OnsetSurface>> {
    bonds.iter().map(|(_, bond)| curve(patch, *bond)).collect()
}

fn onset_figure(disk: &[OnsetSurface]) -> Figure {
    let empty = Figure::new(
        "Onset of sliding of a disk (a model)",
        Axis::linear("F/F_s").range(0.0, 1.05),
        Axis::linear("T/(F_s R)").range(0.0, 0.75),
    )
    .legend(Legend::Below);
    BONDS
        .iter()
        .zip(disk)
        .fold(empty, |figure, ((name, _), surface)| {
            let points = surface.points().iter().map(force_and_torque).collect();
            figure.series(Series::line(*name, points))
        })
}

fn gap_figure(gaps: &[OnsetSurface]) -> Figure {
    let empty = Figure::new(
        "Static over dynamic friction (a model)",
        Axis::linear("T/T_s").range(0.0, 1.0),
        Axis::linear("").range(0.95, 2.05),
    )
    .legend(Legend::Below);
    RE_FORMING
        .iter()
        .zip(gaps)
        .fold(empty, |figure, ((name, _), surface)| {
            let most = surface.summary().torque;
            let place = |point: &OnsetPoint| {
                let torque = point.onset.push.torque / most;
                point.static_over_dynamic.map(|gap| (torque, gap))
            };
            let points = surface.points().iter().filter_map(place).collect();
            figure.series(Series::line(*name, points))
        })
}

/// The angle of the ray, then force and torque of each law, then each gap.
const COLUMNS: [&str; 16] = [
    "share",
    "force_plastic",
    "torque_plastic",
    "force_exponential",
    "torque_exponential",
    "force_weibull_2",
    "torque_weibull_2",
    "force_weibull_8",
    "torque_weibull_8",
    "force_one_strength",
    "torque_one_strength",
    "gap_1",
    "gap_16",
    "gap_64",
    "gap_256",
    "gap_one_strength",
];

fn rows(disk: &[OnsetSurface], gaps: &[OnsetSurface]) -> Vec<Vec<f64>> {
    let row = |i: usize| {
        let share = disk.iter().take(1).map(|surface| surface.points()[i].share);
        let pushes = disk.iter().flat_map(|surface| {
            let (force, torque) = force_and_torque(&surface.points()[i]);
            [force, torque]
        });
        let gaps = gaps
            .iter()
            .filter_map(|surface| surface.points()[i].static_over_dynamic);
        share.chain(pushes).chain(gaps).collect()
    };
    (0..POINTS).map(row).collect()
}

/// Whether the force falls from each point to the next, as the torque rises.
fn falls(curve: &[(f64, f64)]) -> bool {
    let rounding = 1e-9;
    curve
        .windows(2)
        .all(|pair| pair[1].0 < pair[0].0 + rounding && pair[1].1 > pair[0].1 - rounding)
}

/// What the thesis says of refs. 32 and 33.
fn coupled(disk: &[OnsetSurface]) -> Result<Vec<Claim>> {
    let square = Patch::Flat(FlatPatch::Box([2.0, 2.0]));
    let mut reduced = 0;
    for (_, bond) in BONDS {
        for patch in [Patch::Disk, Patch::Ring, square.clone()] {
            let surface = curve(&patch, bond)?;
            let points: Vec<_> = surface.points().iter().map(force_and_torque).collect();
            reduced += usize::from(falls(&points));
        }
        reduced += usize::from(falls(&tripod_curve(bond)?));
    }
    let all = 4 * BONDS.len();
    let arms: Vec<f64> = disk.iter().map(|one| one.summary().arm_ratio()).collect();
    let ordered = arms.windows(2).all(|pair| pair[1] < pair[0]);
    let list: Vec<String> = arms.iter().map(|arm| format!("{arm:.4}")).collect();
    let broad = Bond::Exponential;
    let arm = |patch: &Patch| Ok::<_, anyhow::Error>(curve(patch, broad)?.summary().arm_ratio());
    let (of_square, of_disk, of_ring) = (arm(&square)?, arm(&Patch::Disk)?, arm(&Patch::Ring)?);
    let feet = tripod_curve(broad)?;
    let of_feet = feet.last().map_or(f64::NAN, |last| last.1) / feet[0].0;
    let is_ordered = of_square < of_disk && of_disk < of_ring && (of_ring - of_feet).abs() < 1e-9;
    Ok(vec![
        Claim::trend(
            TEXT.said("reduced"),
            format!("on {reduced} of {all} curves"),
            reduced == all,
        ),
        Claim::trend(TEXT.said("details"), list.join(" > "), ordered),
        Claim::not_checkable(
            TEXT.said("collective")
                .with("weakest", short(arms[4]))
                .with("plastic", short(arms[0])),
        ),
        Claim::trend(
            TEXT.said("geometry"),
            format!("{of_square:.4} < {of_disk:.4} < {of_ring:.4} = {of_feet:.4}"),
            is_ordered,
        ),
    ])
}

/// Numbers of the disk beside independent ones.
fn ratios(disk: &[OnsetSurface]) -> Vec<Claim> {
    let [plastic, exponential, _, sharp, weakest] = [0, 1, 2, 3, 4].map(|i| {
        let summary = disk[i].summary();
        summary.arm_ratio()
    });
    let straight = disk[4].points().iter().map(|point| {
        let (force, torque) = force_and_torque(point);
        (force + torque / 0.5 - 1.0).abs()
    });
    let deviation = straight.fold(0.0, f64::max);
    vec![
        Claim::own(TEXT.said("plastic"), plastic, 2.0 / 3.0, 1e-9),
        Claim::own(TEXT.said("exponential"), exponential, EXPONENTIAL_ARM, 2e-5),
        Claim::own(TEXT.said("sharp"), sharp, SHARP_ARM, 2e-5),
        Claim::own(TEXT.said("weakest"), weakest, 0.5, 1e-9),
        Claim::own_statement(
            TEXT.said("straight"),
            format!("{deviation:.0e}"),
            deviation < 1e-9,
        ),
    ]
}

/// The largest 2 e ∫r³ s e^(−rs) dr over s.
const EXPONENTIAL_ARM: f64 = 0.639_885;
/// See its statement.
const SHARP_ARM: f64 = 0.577_509;
/// Static over dynamic friction of 64 stages.
const RENEWAL_RATIO: f64 = 1.511_930;

/// The gap of static and dynamic friction.
fn re_forming(gaps: &[OnsetSurface]) -> Result<Vec<Claim>> {
    let pushed = |surface: &OnsetSurface| surface.summary().static_over_dynamic;
    let ratios: Option<Vec<f64>> = gaps.iter().map(pushed).collect();
    let ratios = ratios.ok_or_else(|| anyhow!("bonds that re-form have dynamic friction"))?;
    let rises = ratios.windows(2).all(|pair| pair[0] < pair[1]);
    let (broad, one) = (ratios[0], ratios[ratios.len() - 1]);
    let holds = rises && (broad - 1.0).abs() < 1e-9 && (one - 2.0).abs() < 1e-9;
    let list: Vec<String> = ratios.iter().map(|ratio| format!("{ratio:.4}")).collect();
    Ok(vec![
        Claim::own_statement(TEXT.said("between"), list.join(" < "), holds),
        Claim::own(TEXT.said("renewal"), ratios[AN_EIGHTH], RENEWAL_RATIO, 1e-5),
        suppressed(&gaps[AN_EIGHTH]),
    ])
}

/// Where along the onset curve the gap is least.
fn suppressed(surface: &OnsetSurface) -> Claim {
    let most = surface.summary().torque;
    let all = surface.points().iter().filter_map(|point| {
        let torque = point.onset.push.torque / most;
        point.static_over_dynamic.map(|gap| (torque, gap))
    });
    let all: Vec<(f64, f64)> = all.collect();
    let (first, last) = (all[0].1, all[all.len() - 1].1);
    let start = (f64::NAN, f64::INFINITY);
    let least = all
        .into_iter()
        .fold(start, |best, one| if one.1 < best.1 { one } else { best });
    let (torque, gap) = least;
    Claim::own_statement(
        TEXT.said("suppressed"),
        format!(
            "from {first:.3} to {gap:.3} at T/T_s = {torque:.2}, then {last:.3} for pure torque"
        ),
        gap < first && gap < last && gap >= 1.0,
    )
}
