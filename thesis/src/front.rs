//! The first screen of the report: what holds and what differs, in words and pictures.

use super::EXHIBITS;
use super::document::{TEXT, file, of_the_thesis, statements};
use super::effort::Effort;
use std::fmt::Display;
use tribos_report::claim::Claim;
use tribos_report::figure::{Axis, Color, Figure, FigureError, Legend, Series};
use tribos_report::page::{Picture, Section, Table};
use tribos_report::verdict::{Counts, Verdict};

/// Size of a picture in pixels.
const PICTURE: (u32, u32) = (370, 240);
/// Smaller relative numbers are drawn here.
const LEAST: f64 = 1e-17;
/// Rows of figure 4.7 with what they are called.
const POROSITIES: [(&str, &str); 5] = [
    ("base", "E(0,0)"),
    ("torsion-alone", "E₁(0,1)"),
    ("rolling-alone", "E₁(1,0)"),
    ("both", "E₁(1,1)"),
    ("top", "E(1,1)"),
];

/// What a reader takes away: in a part of the report its counts alone.
pub fn lead(sections: &[Section], effort: Effort) -> Vec<String> {
    let statements = statements(sections);
    let distinct = Counts::of(statements.iter().copied());
    let rows = sections.iter().flat_map(of_the_thesis).count();
    let exact = |verdict: &&&Verdict| match verdict {
        Verdict::Reproduced(agreement) => agreement.allowance().is_exact(),
        _ => false,
    };
    let [
        reproduced,
        trend,
        ours,
        definition,
        known,
        undecided,
        differs,
        error,
        unchecked,
        failed,
    ] = distinct.0;
    let failures = match failed {
        0 => String::new(),
        _ => format!(" **{failed} comparisons failed.**"),
    };
    let sampled = TEXT.part(match effort {
        Effort::Quick => "Quick",
        Effort::Full => "Full",
    });
    let values: [(&str, &dyn Display); 14] = [
        ("statements", &distinct.total()),
        ("rows", &rows),
        ("reproduced", &reproduced),
        ("exact", &statements.iter().filter(exact).count()),
        ("trend", &trend),
        ("ours", &ours),
        ("definition", &definition),
        ("known", &known),
        ("undecided", &undecided),
        ("differs", &differs),
        ("error", &error),
        ("unchecked", &unchecked),
        ("failures", &failures),
        ("effort", &sampled.concat()),
    ];
    let part = if sections.len() == EXHIBITS.len() {
        "Lead"
    } else {
        "Part"
    };
    let items = TEXT.items(part).into_iter();
    items
        .map(|item| {
            let item = values.iter().fold(item, |item, (name, value)| {
                item.replace(&format!("{{{name}}}"), &value.to_string())
            });
            with_cells(item, sections)
        })
        .collect()
}

/// With what a row shows in place of `{section.claim.ours}` and `{section.claim.thesis}`.
fn with_cells(text: String, sections: &[Section]) -> String {
    let rows = sections.iter().flat_map(Section::rows);
    rows.fold(text, |text, (id, claim)| {
        text.replace(&format!("{{{id}.ours}}"), &claim.ours)
            .replace(&format!("{{{id}.thesis}}"), &claim.thesis)
    })
}

/// The row of that name.
fn row<'a>(sections: &'a [Section], name: &str) -> Option<&'a Claim> {
    let mut rows = sections.iter().flat_map(Section::rows);
    rows.find(|(id, _)| id == name).map(|(_, claim)| claim)
}

/// The thesis beside ours, of what there is.
pub fn pictures(sections: &[Section]) -> Result<Vec<Picture>, FigureError> {
    let captions: Vec<(String, String)> = TEXT
        .items("Pictures")
        .into_iter()
        .filter_map(|item| {
            let (name, words) = item.split_once(": ")?;
            Some((name.to_owned(), words.to_owned()))
        })
        .collect();
    let drawn = [numbers(sections), porosities(sections), stresses(sections)];
    let mut pictures = Vec::new();
    for ((_, caption), (figure, counts)) in captions.into_iter().zip(drawn) {
        let Some([count, errors]) = counts else {
            continue;
        };
        pictures.push(Picture {
            svg: figure
                .size(PICTURE.0, PICTURE.1)
                .legend(Legend::Below)
                .svg()?,
            caption: caption
                .replace("{count}", &count.to_string())
                .replace("{errors}", &errors.to_string()),
        });
    }
    Ok(pictures)
}

/// A figure, and how many points its series have; none without points.
type CountedFigure = (Figure, Option<[usize; 2]>);

/// How far our numbers are from the printed ones over how far they may be, both relative.
fn numbers(sections: &[Section]) -> CountedFigure {
    let claims = || sections.iter().flat_map(|section| &section.claims);
    let points = |is_reproduced: bool| -> Vec<(f64, f64)> {
        let rows = claims()
            .filter(|claim| matches!(claim.verdict, Verdict::Reproduced(_)) == is_reproduced)
            .filter(|claim| !claim.thesis.is_empty());
        let places = rows.filter_map(|Claim { numbers, .. }| {
            let size = numbers.thesis?.abs();
            let [x, y] = [numbers.allowance? / size, numbers.difference? / size];
            Some((x.max(LEAST), y.max(LEAST)))
        });
        places
            .filter(|(x, y)| x.is_finite() && y.is_finite())
            .collect()
    };
    let [same, other] = [points(true), points(false)];
    let counts = (!same.is_empty()).then_some([same.len(), other.len()]);
    let axis = |label| Axis::log10(label).range(LEAST / 3.0, 1.0);
    let figure = Figure::new(
        "",
        axis("tolerance, relative"),
        axis("difference, relative"),
    )
    .series(Series::line("", vec![(LEAST, LEAST), (1.0, 1.0)]).color(Color(190, 190, 190)))
    .series(Series::points("reproduced", same).color(Color::palette(0)))
    .series(Series::points("not", other).color(Color::palette(1)));
    (figure, counts)
}

fn porosities(sections: &[Section]) -> CountedFigure {
    let rows =
        POROSITIES.map(|(id, name)| (name.to_owned(), row(sections, &format!("figure-4.7.{id}"))));
    beside("E, E₁ [%]", rows)
}

fn stresses(sections: &[Section]) -> CountedFigure {
    let lines = sections.iter().flat_map(Section::rows);
    let lines = lines.filter(|(id, _)| id.starts_with("table-4.1.split"));
    beside(
        "σ_zz⁺ over the pressure",
        lines.map(|(_, claim)| (pair(claim), Some(claim))),
    )
}

/// "(0,1)" of a statement on μ_t = 0, μ_n = 1; nothing of another.
fn pair(claim: &Claim) -> String {
    let numbers = claim.statement.split("= ").skip(1);
    let numbers = numbers.map(|rest| rest.split([',', ';', ' ']).next().unwrap_or_default());
    let numbers = numbers.filter(|number| number.parse::<f64>().is_ok());
    match numbers.collect::<Vec<&str>>()[..] {
        [rolling, torsion, ..] => format!("({rolling},{torsion})"),
        _ => String::new(),
    }
}

/// Named rows: the thesis' number and ours.
fn beside<'a>(
    label: &str,
    rows: impl IntoIterator<Item = (String, Option<&'a Claim>)>,
) -> CountedFigure {
    let rows: Vec<(String, [f64; 4])> = rows
        .into_iter()
        .filter_map(|(name, claim)| {
            let numbers = claim?.numbers;
            let [ours, thesis] = numbers.sigma.unwrap_or_default();
            Some((name, [numbers.thesis?, numbers.ours?, thesis, ours]))
        })
        .collect();
    // Beside each other: 0 is the thesis, 1 ours.
    let series = |whose: usize, name: &str| {
        let places = (1..)
            .map(|x| f64::from(x) + [-0.06, 0.06][whose])
            .zip(&rows);
        let points = places.map(|(x, (_, values))| (x, values[whose])).collect();
        let errors = rows.iter().map(|(_, values)| values[2 + whose]).collect();
        Series::points(name, points).errors(errors)
    };
    let figure = Figure::new(
        "",
        Axis::named("", rows.iter().map(|(name, _)| name.clone()).collect()),
        Axis::linear(label),
    )
    .series(series(0, "thesis"))
    .series(series(1, "ours"));
    (figure, (!rows.is_empty()).then_some([rows.len(), 0]))
}

/// What differs for reasons that are open: which rows, hypothesis, experiment, result.
pub fn open(sections: &[Section]) -> Table {
    let rows = TEXT.items("Open").into_iter().filter_map(|item| {
        let (names, words) = item.split_once(": ")?;
        let shown: Vec<(String, &Claim)> = sections
            .iter()
            .flat_map(|section| section.rows().zip(std::iter::repeat(section)))
            .filter(|((_, claim), section)| {
                matches!(claim.verdict, Verdict::Differs(_) | Verdict::Undecided(_))
                    && names
                        .split(", ")
                        .any(|name| name == format!("{}.{}", section.id, claim.id))
            })
            .map(|((id, claim), _)| (id, claim))
            .collect();
        let file = file(&shown.first()?.0);
        let lines = shown.iter().map(|(id, claim)| {
            let (name, thesis, ours) = (&claim.id, &claim.thesis, &claim.ours);
            let pair = pair(claim);
            format!("[{name}{pair}]({file}#{id}): thesis {thesis}, ours {ours}")
        });
        let lines = lines.collect::<Vec<String>>().join("\n");
        Some(
            [lines]
                .into_iter()
                .chain(words.split(" — ").map(String::from))
                .collect(),
        )
    });
    Table {
        id: "open".into(),
        heading: "What differs, and what was tried".into(),
        text: Vec::new(),
        head: ["rows", "hypothesis", "experiment", "result"]
            .map(String::from)
            .into(),
        rows: rows.collect(),
    }
}
