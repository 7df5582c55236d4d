//! `tribos eval` gives the forces of LAMMPS for LAMMPS' files, and refuses what it cannot serve.

use crate::program::{Error, Outcome, succeed, summary};
use std::path::{Path, PathBuf};

/// A file of the tables.
fn table(name: &str) -> String {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../tests/tables/md");
    root.join(name).display().to_string()
}

/// Evaluates the atoms of a file into a folder.
fn eval(out: &Path, config: &str, more: &[&str]) -> Outcome {
    let line = ["eval", config, "--out", &out.display().to_string()];
    succeed(".", [&line[..], more].concat())?;
    Ok(())
}

/// Id of an atom and the force on it.
type Row = (u64, [f64; 3]);

/// The rows of a CSV table.
fn forces(path: &Path) -> Result<Vec<Row>, Error> {
    let text = std::fs::read_to_string(path)?;
    let mut lines = text.lines().skip_while(|line| line.starts_with('#'));
    assert_eq!(lines.next(), Some("id,fx,fy,fz"));
    let row = |line: &str| -> Result<Row, Error> {
        let cells: Vec<&str> = line.split(',').collect();
        Ok((
            cells[0].parse()?,
            [cells[1].parse()?, cells[2].parse()?, cells[3].parse()?],
        ))
    };
    lines.map(row).collect()
}

/// Compares a folder of results with the table of a case.
fn compare(out: &Path, case: &str) -> Outcome {
    let ours = forces(&out.join("forces.csv"))?;
    let theirs = forces(&PathBuf::from(table(&format!("{case}.csv"))))?;
    let ids = |rows: &[Row]| rows.iter().map(|row| row.0).collect::<Vec<_>>();
    assert_eq!(ids(&ours), ids(&theirs));
    let largest = theirs
        .iter()
        .flat_map(|row| row.1)
        .fold(0.0, |most: f64, f| most.max(f.abs()));
    for ((id, a), (_, b)) in ours.iter().zip(&theirs) {
        for axis in 0..3 {
            let off = (a[axis] - b[axis]).abs() / largest;
            assert!(off < 1e-12, "{case}: atom {id}: {a:?} {b:?}");
        }
    }
    let totals = std::fs::read_to_string(table("totals.csv"))?;
    let row = totals
        .lines()
        .find(|line| line.starts_with(&format!("{case},")));
    let row: Vec<f64> = row
        .ok_or("no totals")?
        .split(',')
        .skip(1)
        .map(str::parse)
        .collect::<Result<_, _>>()?;
    let summary = summary(out)?;
    for (name, expected) in [
        ("energy", row[0]),
        ("kinetic_energy", row[1]),
        ("pressure", row[2]),
        ("volume", row[9]),
    ] {
        let value = summary[name].as_f64().ok_or("no number")?;
        assert!(
            (value - expected).abs() <= 1e-12 * expected.abs(),
            "{case}: {name} {value} {expected}"
        );
    }
    for (part, expected) in row[3..9].iter().enumerate() {
        let value = summary["pressure_tensor"][part]
            .as_f64()
            .ok_or("no number")?;
        assert!(
            (value - expected).abs() <= 1e-12 * row[2].abs().max(row[3].abs()),
            "{case}: {part}"
        );
    }
    Ok(())
}

#[test]
fn the_forces_are_those_of_lammps() -> Outcome {
    let folder = tempfile::tempdir()?;
    let kob_andersen = "lj:cutoff=2.5,shift=energy,epsilon12=1.5,sigma21=0.8,cutoff12=2,\
                        epsilon22=0.5,sigma22=0.88,cutoff22=2.2";
    let setfl = table("synthetic.eam.alloy");
    for (case, data, law) in [
        ("fcc500_none", "fcc500", ["--pair", "lj:cutoff=2.5"]),
        (
            "fcc500_force",
            "fcc500",
            ["--pair", "lj:cutoff=2.5,shift=force"],
        ),
        (
            "slab576_none",
            "slab576",
            ["--pair", "lj:cutoff=2.5,shift=none"],
        ),
        (
            "binary500_arithmetic",
            "binary500",
            [
                "--pair",
                "lj:cutoff=2.5,shift=energy,mixing=arithmetic,epsilon22=.5,sigma22=.88",
            ],
        ),
        (
            "binary500_kobandersen",
            "binary500",
            ["--pair", kob_andersen],
        ),
        ("alloy500_setfl", "alloy500", ["--eam", &setfl]),
    ] {
        let out = folder.path().join(case);
        let boundary = if data == "slab576" { "p,p,f" } else { "p,p,p" };
        let data = table(&format!("{data}.data"));
        eval(&out, &data, &["--boundary", boundary, law[0], law[1]])?;
        compare(&out, case)?;
    }
    Ok(())
}

/// The atoms of the alloy as extended XYZ, backwards and with the second element first.
#[test]
fn names_and_ids_find_their_elements() -> Outcome {
    let folder = tempfile::tempdir()?;
    let data = std::fs::read_to_string(table("alloy500.data"))?;
    let (head, atoms) = data.split_once("Atoms # atomic").ok_or("no atoms")?;
    let length = head
        .lines()
        .find_map(|line| line.strip_suffix(" xlo xhi"))
        .ok_or("no box")?;
    let length = length.split_whitespace().last().ok_or("no length")?;
    let mut rows: Vec<String> = Vec::new();
    for line in atoms.lines().filter(|line| !line.trim().is_empty()) {
        let words: Vec<&str> = line.split_whitespace().collect();
        let name = if words[1] == "1" { "Aa" } else { "Bb" };
        rows.push(format!("{name} {} {}", words[2..5].join(" "), words[0]));
    }
    rows.reverse();
    rows.sort_by_key(|row| row.starts_with("Aa"));
    let header = format!(
        "Lattice=\"{length} 0 0 0 {length} 0 0 0 {length}\" Properties=species:S:1:pos:R:3:id:I:1"
    );
    let text = format!("{}\n{header}\n{}\n", rows.len(), rows.join("\n"));
    let config = folder.path().join("alloy.xyz");
    std::fs::write(&config, text)?;
    let out = folder.path().join("out");
    let config = config.display().to_string();
    eval(&out, &config, &["--eam", &table("synthetic.eam.alloy")])?;
    compare(&out, "alloy500_setfl")
}

#[test]
fn open_atoms_need_no_box() -> Outcome {
    let folder = tempfile::tempdir()?;
    let config = folder.path().join("pair.xyz");
    std::fs::write(
        &config,
        "2\nProperties=species:S:1:pos:R:3\nX 0 0 0\nX 0 2 0\n",
    )?;
    let out = folder.path().join("out");
    let config = config.display().to_string();
    eval(&out, &config, &["--pair", "lj:cutoff=3,epsilon11=2"])?;
    // 24 ε (2/2¹² − 1/2⁶)/2, towards each other.
    let pull = 24.0 * 2.0 * (1.0 / 64.0 - 2.0 / 4096.0) / 2.0;
    assert_eq!(
        forces(&out.join("forces.csv"))?,
        [(1, [0.0, pull, 0.0]), (2, [0.0, -pull, 0.0])]
    );
    Ok(())
}
