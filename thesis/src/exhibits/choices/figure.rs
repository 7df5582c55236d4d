//! Misfits over the group, and the judged choices beside the thesis.

use super::super::stress::TABLE;
use super::{CORNERS, Choice, JUDGED, KeptTables, LIMITS, RANGES, Table};
use tribos_report::figure::{Axis, Color, Figure, Legend, Panels, ReferenceLine, Series};

/// Shares of the last forces with a curve.
const SHOWN: [f64; 5] = [0.0, 0.25, 0.35, 0.5, 1.0];

/// Misfit and E(1,1) over the group; porosities and stresses of the judged choices beside the thesis'; both systems, and
/// stresses from a share of the last forces.
pub(super) fn figure(kept: &KeptTables, judged: &[(Choice, f64)]) -> Panels {
    let table = &kept.small;
    let over = over_group(
        "Four porosities",
        Axis::log10("χ²"),
        judged,
        |(_, misfit)| Some(*misfit),
    );
    let over = over.guide(ReferenceLine::horizontal(LIMITS[0], "95 %"));
    let [.., (both, printed)] = CORNERS;
    let top = Axis::linear("E(1,1) [%]");
    let top = over_group("Rolling and torsion blocked", top, judged, |(choice, _)| {
        table.porosity(choice, both).map(|found| found.0)
    });
    let top = top.guide(ReferenceLine::horizontal(printed, "thesis"));
    let porosities = beside(
        "Porosities",
        "final porosity [%]",
        &CORNERS,
        |choice, pair| table.porosity(choice, pair).map(|found| found.0),
    );
    let lines = TABLE.map(|[rolling, torsion, plus, _]| ([rolling, torsion], plus));
    let stresses = beside(
        "Stress of pushing contacts",
        "σ_zz⁺/P",
        &lines,
        |choice, pair| {
            table
                .of(choice, pair, |line| line.plus)
                .map(|found| found.0)
        },
    );
    let panels = [
        over,
        top,
        porosities,
        stresses,
        sizes(kept),
        shares(kept, &lines),
    ];
    panels
        .into_iter()
        .fold(Panels::new("", 2).cell(540, 420), Panels::figure)
}

/// Points over the group, a series for each range and kind of wall.
fn over_group(
    title: &str,
    y: Axis,
    judged: &[(Choice, f64)],
    of: impl Fn(&(Choice, f64)) -> Option<f64>,
) -> Figure {
    let mut figure = Figure::new(title, Axis::log10("μ F_coh/(P R²)"), y);
    for is_smooth in [true, false] {
        for range in RANGES {
            let is_it = |(choice, _): &&(Choice, f64)| {
                choice.is_smooth == is_smooth && choice.range == range
            };
            let points = judged
                .iter()
                .filter(is_it)
                .filter_map(|one| Some((one.0.group(), of(one)?)));
            let walls = if is_smooth { "smooth" } else { "rough" };
            figure = figure.series(Series::points(
                format!("{range:e} R, {walls}"),
                points.collect(),
            ));
        }
    }
    figure
}

fn names(lines: &[([f64; 2], f64)]) -> Axis {
    let names = lines
        .iter()
        .map(|([rolling, torsion], _)| format!("({rolling}, {torsion})"));
    Axis::named("(μ_t, μ_n)", names.collect())
}

fn thesis(lines: &[([f64; 2], f64)]) -> Series {
    let points = lines
        .iter()
        .enumerate()
        .map(|(at, (_, value))| (1.0 + at as f64, *value));
    Series::line_points("thesis", points.collect())
}

fn placed(lines: &[([f64; 2], f64)], of: impl Fn([f64; 2]) -> Option<f64>) -> Vec<(f64, f64)> {
    let places = lines.iter().enumerate();
    places
        .filter_map(|(at, (pair, _))| Some((1.0 + at as f64, of(*pair)?)))
        .collect()
}

/// The thesis' numbers, and those of each judged choice.
fn beside(
    title: &str,
    label: &str,
    lines: &[([f64; 2], f64)],
    of: impl Fn(&Choice, [f64; 2]) -> Option<f64>,
) -> Figure {
    let figure = Figure::new(title, names(lines), Axis::linear(label)).legend(Legend::Below);
    JUDGED
        .iter()
        .fold(figure.series(thesis(lines)), |figure, choice| {
            figure.series(Series::line_points(
                choice.words(),
                placed(lines, |pair| of(choice, pair)),
            ))
        })
}

/// Porosities of the large system, and lines for those of the small one.
fn sizes(kept: &KeptTables) -> Figure {
    let mut figure = Figure::new(
        "Small system (lines) and large system",
        names(&CORNERS),
        Axis::linear("final porosity [%]"),
    )
    .legend(Legend::Below);
    for (at, choice) in JUDGED.iter().enumerate() {
        let of = |table: &Table| {
            placed(&CORNERS, |pair| {
                table.porosity(choice, pair).map(|found| found.0)
            })
        };
        // As in the panels that begin with the thesis.
        let color = Color::palette(at + 1);
        figure = figure
            .series(Series::line(choice.words(), of(&kept.small)).color(color))
            .series(Series::points("", of(&kept.large)).color(color));
    }
    figure
}

/// σ_zz⁺ of packings solved anew, a series a share.
fn shares(kept: &KeptTables, lines: &[([f64; 2], f64)]) -> Figure {
    let title = format!("Solved anew, {}", JUDGED[1].words());
    let figure = Figure::new(title, names(lines), Axis::linear("σ_zz⁺/P")).legend(Legend::Below);
    SHOWN
        .into_iter()
        .fold(figure.series(thesis(lines)), |figure, share| {
            let points = placed(lines, |pair| {
                kept.shares.plus(share, pair).map(|found| found.0)
            });
            figure.series(Series::line_points(
                format!("{share} of the forces"),
                points,
            ))
        })
}
