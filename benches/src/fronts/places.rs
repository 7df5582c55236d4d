//! Where the speed of each method of the thesis is shown against its error: one row a method, read from the tables of
//! the fronts.

use super::Setting;
use crate::front::Front;
use crate::written::{Sheet, short};
use std::path::Path;

const STEM: &str = "places";

const ABOUT: &str = "Methods of the thesis: time and error at the usual setting and at another one, that of the \
                     thesis or a coarser one, as the tables of the fronts have them";

/// A row of a front's table: what it is called here, and the cells by which it is found.
type CitedRow = (&'static str, &'static [(&'static str, &'static str)]);

/// A method and the two rows that are shown of it.
struct ThesisMethod {
    name: &'static str,
    /// Where the thesis has it.
    thesis: &'static str,
    front: Front,
    /// Table of the front.
    table: &'static str,
    usual: CitedRow,
    other: CitedRow,
    /// Columns of time and error.
    columns: [&'static str; 2],
    unit: &'static str,
    /// What the error means.
    meaning: &'static str,
}

const METHODS: [ThesisMethod; 8] = [
    ThesisMethod {
        name: "force and torque",
        thesis: "3.2 and 3.4.3",
        front: Front::Kernel,
        table: "kernel",
        usual: ("closed form", &[("method", "form")]),
        other: ("trapezoid 512 x 512", &[("method", "trapezoid 512")]),
        columns: ["ns", "rel F"],
        unit: "ns a call",
        meaning: "relative; of the force",
    },
    ThesisMethod {
        name: "sliding disk by Verlet",
        thesis: "3.4.5",
        front: Front::Integrators,
        table: "integrators",
        usual: (
            "steps of 1 ms",
            &[
                ("method", "verlet"),
                ("dt s", "1e-3"),
                ("spin rad/s", "12.5"),
            ],
        ),
        other: (
            "steps of 10 ms",
            &[
                ("method", "verlet"),
                ("dt s", "1e-2"),
                ("spin rad/s", "12.5"),
            ],
        ),
        columns: ["us per stop", "distance error"],
        unit: "us a stop",
        meaning: "relative; of the distance to rest",
    },
    ThesisMethod {
        name: "contact dynamics: tolerance",
        thesis: "4.4.2",
        front: Front::Methods,
        table: "methods",
        usual: (
            "tolerance 1e-4",
            &[
                ("trial", "deposit"),
                ("parameters", "tolerance 1e-4; step 0.1"),
                ("quantity", "deepest overlap [R]"),
            ],
        ),
        other: (
            "tolerance 1e-2",
            &[
                ("trial", "deposit"),
                ("parameters", "tolerance 1e-2; step 0.1"),
                ("quantity", "deepest overlap [R]"),
            ],
        ),
        columns: ["cpu_s", "error"],
        unit: "s a compaction",
        meaning: "deepest overlap in radii",
    },
    ThesisMethod {
        name: "contact dynamics: sweeps",
        thesis: "4.4.2",
        front: Front::Contacts,
        table: "contacts_residual",
        usual: (
            "accelerated to 1e-6",
            &[
                ("problem", "jammed box all modes"),
                ("method", "accelerated"),
                ("rule", "change 1e-6"),
            ],
        ),
        other: (
            "80 plain sweeps",
            &[
                ("problem", "jammed box all modes"),
                ("method", "GS random order"),
                ("rule", "N = 80"),
            ],
        ),
        columns: ["ms", "residual"],
        unit: "ms a solution",
        meaning: "residual of the contact laws",
    },
    ThesisMethod {
        name: "soft particles: stiffness",
        thesis: "4.4.1",
        front: Front::Methods,
        table: "methods",
        usual: (
            "k = 1e4 F_coh/R",
            &[
                ("trial", "deposit"),
                ("parameters", "k 1e4"),
                ("quantity", "deepest overlap [R]"),
            ],
        ),
        other: (
            "k = 1e3 F_coh/R",
            &[
                ("trial", "deposit"),
                ("parameters", "k 1e3"),
                ("quantity", "deepest overlap [R]"),
            ],
        ),
        columns: ["cpu_s", "error"],
        unit: "s a compaction",
        meaning: "deepest overlap in radii",
    },
    ThesisMethod {
        name: "event driven",
        thesis: "4.4.1",
        front: Front::Methods,
        table: "methods",
        usual: (
            "events",
            &[
                ("trial", "gas 0.05"),
                ("method", "events"),
                ("quantity", "temperature [reference]"),
            ],
        ),
        other: (
            "contact dynamics in steps of 0.2 R",
            &[
                ("trial", "gas 0.05"),
                ("parameters", "tolerance 1e-4; step 0.2"),
                ("quantity", "temperature [reference]"),
            ],
        ),
        columns: ["cpu_s", "error"],
        unit: "s for 6 gases",
        meaning: "relative; of the temperature of a gas that cools",
    },
    ThesisMethod {
        name: "molecular dynamics: step",
        thesis: "5.3",
        front: Front::Atoms,
        table: "atoms_drift",
        usual: (
            "steps of 0.005",
            &[("cut-off", "force shifted"), ("dt", "0.005")],
        ),
        other: (
            "steps of 0.01",
            &[("cut-off", "force shifted"), ("dt", "0.01")],
        ),
        columns: ["atom-steps per time", "rms fluctuation"],
        unit: "atom-steps in a unit of time",
        meaning: "fluctuation of the energy of an atom",
    },
    ThesisMethod {
        name: "molecular dynamics: thermostat",
        thesis: "5.3",
        front: Front::Atoms,
        table: "atoms_drift",
        usual: (
            "steps of 0.005",
            &[("cut-off", "force shifted; Nose-Hoover"), ("dt", "0.005")],
        ),
        other: (
            "steps of 0.01",
            &[("cut-off", "force shifted; Nose-Hoover"), ("dt", "0.01")],
        ),
        columns: ["atom-steps per time", "rms fluctuation"],
        unit: "atom-steps in a unit of time",
        meaning: "fluctuation of the conserved energy of an atom",
    },
];

/// Writes the table, and returns it with links, for the index.
pub fn write(setting: &Setting<'_>) -> Result<String, String> {
    let sheet = sheet(setting.out);
    crate::written::write(setting.out, &format!("{STEM}.csv"), &sheet.csv())?;
    Ok(linked(sheet))
}

/// The table from the fronts that are in the folder; a hyphen where a front lacks a row.
fn sheet(folder: &Path) -> Sheet {
    let cells = |method: &ThesisMethod, cited: CitedRow| {
        let path = folder.join(format!("{}.csv", method.table));
        let text = std::fs::read_to_string(path).unwrap_or_default();
        let cell = |column| {
            let value = found(&text, cited.1, column).and_then(|cell| cell.parse::<f64>().ok());
            value.map_or("-".into(), |value| short(value.abs()))
        };
        method.columns.map(cell)
    };
    let rows = METHODS.iter().map(|method| {
        (
            method,
            cells(method, method.usual),
            cells(method, method.other),
        )
    });
    Sheet::of(
        ABOUT,
        rows,
        &[
            ("method", &|(method, ..)| method.name.into()),
            ("thesis", &|(method, ..)| method.thesis.into()),
            ("front", &|(method, ..)| method.front.name().into()),
            ("setting", &|(method, ..)| method.usual.0.into()),
            ("time", &|(_, [time, _], _)| time.clone()),
            ("error", &|(_, [_, error], _)| error.clone()),
            ("other setting", &|(method, ..)| method.other.0.into()),
            ("its time", &|(.., [time, _])| time.clone()),
            ("its error", &|(.., [_, error])| error.clone()),
            ("unit of time", &|(method, ..)| method.unit.into()),
            ("error is", &|(method, ..)| method.meaning.into()),
        ],
    )
}

/// Cell of a column in the row of a table with these cells.
fn found<'a>(csv: &'a str, cells: &[(&str, &str)], column: &str) -> Option<&'a str> {
    let mut lines = csv.lines().filter(|line| !line.starts_with('#'));
    let header: Vec<&str> = lines.next()?.split(',').collect();
    let place = |name: &str| header.iter().position(|column| *column == name);
    let cited = lines.map(|line| line.split(',').collect::<Vec<_>>());
    let mut cited = cited.filter(|row| {
        let has = |(name, cell): &(&str, &str)| Some(*cell) == place(name).map(|at| row[at]);
        cells.iter().all(has)
    });
    Some(cited.next()?[place(column)?])
}

/// The table as Markdown, fronts as links.
fn linked(mut sheet: Sheet) -> String {
    for row in &mut sheet.rows {
        row[2] = format!("[{0}]({0}.md)", row[2]);
    }
    sheet.markdown()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_published_table_is_that_of_the_published_fronts() {
        let folder = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../docs/fronts"));
        let sheet = sheet(folder);
        let published = std::fs::read_to_string(folder.join(format!("{STEM}.csv")));
        assert_eq!(published.unwrap(), sheet.csv());
        let is_bare = |row: &&Vec<String>| row.contains(&"-".into());
        assert_eq!(sheet.rows.iter().find(is_bare), None);
        let index = std::fs::read_to_string(folder.join("index.md")).unwrap();
        assert!(index.contains(&linked(sheet)));
    }

    #[test]
    fn a_cell_is_found_by_others() {
        let csv = "# made\nname,dt,error\na,1,2\na,2,3\n";
        assert_eq!(
            found(csv, &[("name", "a"), ("dt", "2")], "error"),
            Some("3")
        );
        assert_eq!(found(csv, &[("name", "b")], "error"), None);
        assert_eq!(found(csv, &[("nam", "a")], "error"), None);
    }
}
