//! `tribos eval` gives the forces of LAMMPS for LAMMPS' files, and refuses what it cannot serve.

use crate::program::{Error, Outcome, tribos};
use serde_json::Value;
use std::path::{Path, PathBuf};

/// A file of the tables.
fn table(name: &str) -> String {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../tests/tables/md");
    root.join(name).display().to_string()
}

/// Exit code and what was said on standard error.
fn eval(out: &Path, arguments: &[&str]) -> Result<(i32, String), Error> {
    let out = out.display().to_string();
    let all = [&["eval", "--out", &out][..], arguments].concat();
    let (code, _, said) = tribos(".", all)?;
    Ok((code.ok_or("killed")?, said))
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
    let summary: Value = serde_json::from_str(&std::fs::read_to_string(out.join("summary.json"))?)?;
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
        let (code, said) = eval(
            &out,
            &[&[data.as_str(), "--boundary", boundary][..], &law].concat(),
        )?;
        assert_eq!(code, 0, "{said}");
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
    let (code, said) = eval(
        &out,
        &[
            &config.display().to_string(),
            "--eam",
            &table("synthetic.eam.alloy"),
        ],
    )?;
    assert_eq!(code, 0, "{said}");
    compare(&out, "alloy500_setfl")
}

const PAIR: [&str; 2] = ["--pair", "lj:cutoff=2.5"];

/// What is said about a file of three atoms; nothing may be written.
fn refused(text: &str, law: &[&str]) -> Result<String, Error> {
    let folder = tempfile::tempdir()?;
    let config = folder.path().join("atoms");
    std::fs::write(&config, text)?;
    let out = folder.path().join("out");
    let (code, said) = eval(
        &out,
        &[&[config.display().to_string().as_str()][..], law].concat(),
    )?;
    assert_eq!(code, 2, "{said}");
    assert!(!out.exists());
    Ok(said)
}

fn xyz(lattice: &str, last: &str) -> String {
    format!(
        "3\n{lattice} Properties=species:S:1:pos:R:3:id:I:1\nAa 1 1 1 70\nAa 1 2.5 1 20\n{last}\n"
    )
}

const CUBE: &str = "Lattice=\"9 0 0 0 9 0 0 0 9\"";

#[test]
fn atoms_in_one_place_are_named() -> Outcome {
    let setfl = table("synthetic.eam.alloy");
    // The image behind the end of the period counts too.
    for place in ["1 1 1", "1 10 1"] {
        let text = xyz(CUBE, &format!("Aa {place} 35"));
        for law in [&PAIR[..], &["--eam", &setfl]] {
            let said = refused(&text, law)?;
            assert!(said.contains("atoms 35 and 70 are 0.0 apart"), "{said}");
        }
    }
    let near = xyz(CUBE, "Aa 1 1 1e-30 35").replace("1 1 1 70", "1 1 0 70");
    let said = refused(&near, &PAIR)?;
    assert!(said.contains("atoms 35 and 70 are 1e-30 apart"), "{said}");
    Ok(())
}

#[test]
fn coordinates_that_tell_no_distances_are_named() -> Outcome {
    for place in ["1e300 1 1", "5 -1e17 5"] {
        let said = refused(&xyz(CUBE, &format!("Aa {place} 35")), &PAIR)?;
        assert!(said.contains("atom 35 has the coordinate"), "{said}");
        assert!(said.contains("cut-off of 2.5"), "{said}");
    }
    Ok(())
}

#[test]
fn what_cannot_be_served_is_refused() -> Outcome {
    let (setfl, funcfl) = (table("synthetic.eam.alloy"), table("synthetic.eam"));
    let text = xyz(CUBE, "Aa 5 5 5 35");
    let says = |law: &[&str], parts: &[&str]| -> Outcome {
        let said = refused(&text, law)?;
        assert!(
            parts.iter().all(|part| said.contains(part)),
            "{law:?}: {said}"
        );
        Ok(())
    };
    says(
        &["--pair", "lj:cutoff=4.6"],
        &["4.6", "half the period along x, 9"],
    )?;
    says(
        &["--pair", "lj:cutoff=2,sigma12=1"],
        &["no pair 12 among 1 species"],
    )?;
    says(
        &["--pair", "lj:cutoff=2,depth=1"],
        &["no `depth`", "epsilon"],
    )?;
    says(
        &["--pair", "lj:cutoff=2", "--boundary", "p,p,s"],
        &["p (periodic) or f (open)"],
    )?;
    says(
        &["--pair", "lj:cutoff=2", "--eam", &setfl],
        &["cannot be used with"],
    )?;
    says(&[], &["--pair <LAW>|--eam <FILE>"])?;
    says(&["--eam", "missing.eam"], &["cannot read missing.eam"])?;
    says(&["--eam", &table("fcc500.data")], &["fcc500.data: line 4"])?;
    let strange = text.replace("Aa 5", "Cu 5");
    let said = refused(&strange, &["--eam", &setfl])?;
    assert!(
        said.contains("no element `Cu`") && said.contains("Aa, Bb"),
        "{said}"
    );
    let said = refused(&strange, &["--eam", &funcfl])?;
    assert!(said.contains("no element number 2"), "{said}");
    let said = refused(
        &xyz("", "Aa 5 5 5 35"),
        &["--pair", "lj:cutoff=1", "--boundary", "p,f,f"],
    )?;
    assert!(said.contains("give Lattice"), "{said}");
    let said = refused(&text.replace("2.5", "two"), &PAIR)?;
    assert!(
        said.contains("line 4: a coordinate must be a finite number, not `two`"),
        "{said}"
    );
    Ok(())
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
    let (code, said) = eval(
        &out,
        &[
            &config.display().to_string(),
            "--pair",
            "lj:cutoff=3,epsilon11=2",
        ],
    )?;
    assert_eq!(code, 0, "{said}");
    // 24 ε (2/2¹² − 1/2⁶)/2, towards each other.
    let pull = 24.0 * 2.0 * (1.0 / 64.0 - 2.0 / 4096.0) / 2.0;
    assert_eq!(
        forces(&out.join("forces.csv"))?,
        [(1, [0.0, pull, 0.0]), (2, [0.0, -pull, 0.0])]
    );
    Ok(())
}
