//! Speed against error of each method, and what leaving modes out saves, as the benchmarks measured them.

use super::document::TEXT;
use tribos_report::page::Table;

/// Copies of docs/fronts: a package holds its own files.
pub const KEPT: [(&str, &str); 2] = [
    ("places.csv", include_str!("fronts/places.csv")),
    ("modes.csv", include_str!("fronts/modes.csv")),
];

/// Both tables, from the lines after the heads of their files.
pub fn tables() -> [Table; 2] {
    let [places, modes] = KEPT.map(|(_, text)| {
        let lines = text.lines().filter(|line| !line.starts_with('#')).skip(1);
        let rows = lines.map(|line| line.split(',').map(String::from).collect());
        rows.collect::<Vec<Vec<String>>>()
    });
    let place = |row: &Vec<String>| {
        let [
            method,
            thesis,
            front,
            setting,
            time,
            error,
            other,
            its_time,
            its_error,
            unit,
            meaning,
        ] = std::array::from_fn(|column| row.get(column).map_or("", String::as_str));
        [
            format!("{method} ({thesis})"),
            format!("{setting}: **{time}** {unit}, error **{error}**"),
            format!("{other}: **{its_time}** {unit}, error **{its_error}**"),
            meaning.into(),
            format!("`docs/fronts/{front}.md`"),
        ]
        .into()
    };
    let mode = |row: &Vec<String>| {
        let [
            body,
            without,
            _,
            unknowns,
            bytes,
            seconds,
            time,
            result,
            difference,
            scatter,
        ] = std::array::from_fn(|column| row.get(column).map_or("", String::as_str));
        [
            format!("{body}: {without}"),
            format!("**{time}** ({seconds} s)"),
            unknowns.into(),
            bytes.into(),
            format!("{difference} ({})", result.replace('_', " ")),
            scatter.into(),
        ]
        .into()
    };
    [
        table("speed", places.iter().map(place)),
        table("modes", modes.iter().map(mode)),
    ]
}

/// With heading, paragraph and heads of columns from the page's text.
fn table(id: &str, rows: impl Iterator<Item = Vec<String>>) -> Table {
    let mut text = TEXT.part(id).into_iter();
    let (_, kept) = KEPT[1];
    let made = kept.lines().next().unwrap_or_default();
    let made = made.trim_start_matches("# ");
    let mut next = || text.next().unwrap_or_default().replace("{made}", made);
    Table {
        id: id.into(),
        heading: next(),
        text: vec![next()],
        head: next().split(" | ").map(String::from).collect(),
        rows: rows.collect(),
    }
}
