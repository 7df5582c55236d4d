//! Files of atoms: what is written reads back to the same bits, what is wrong is refused by its line.

use nalgebra::Vector3;
use tribos::md::configuration::{Configuration, Format, read};
use tribos::md::lammps::{data_file, dump_frame, frames, last_frame, read_data};
use tribos_tests::atoms::text;
use tribos_tests::sweep::Lcg;

/// Atoms out of order and out of the box, numbers that decimal fractions do not meet.
fn sample() -> Configuration {
    let mut rng = Lcg::new(3);
    let mut all = read_data(&text("fcc500.data")).unwrap();
    all.bounds = [[-0.1, 7.8], [1.0 / 3.0, 9.9], [-25.0, 1e-3]];
    all.atoms.masses = vec![1.0 / 7.0, 2.0];
    for atom in 0..500 {
        all.ids[atom] = 3 * (500 - atom as u64);
        all.atoms.species[atom] = (atom % 2) as u8;
        all.atoms.positions[atom] += Vector3::from_fn(|_, _| rng.between(-30.0, 30.0));
    }
    all.atoms.positions[5].x = 5e-324;
    all.atoms.velocities[5].y = -f64::MAX;
    all
}

#[test]
fn a_data_file_reads_back_to_the_same_bits() {
    let all = sample();
    assert_eq!(read_data(&data_file(&all)).unwrap(), all);
    let mut still = all.clone();
    still.atoms.velocities.fill(Vector3::zeros());
    let text = data_file(&still);
    assert!(!text.contains("Velocities"));
    assert_eq!(read(&text).unwrap(), still);
}

#[test]
fn dump_frames_read_back_to_the_same_bits() {
    let mut first = sample();
    // A dump has no masses.
    first.atoms.masses = vec![1.0; 2];
    first.is_periodic = [true, false, true];
    first.step = 7;
    let mut second = first.clone();
    second.step = 1_000_000_007;
    second.forces = Some(first.atoms.positions.iter().map(|x| x / 3.0).collect());
    let text = dump_frame(&first) + &dump_frame(&second);
    let read: Vec<Configuration> = frames(&text).map(Result::unwrap).collect();
    assert_eq!(read, [first, second.clone()]);
    assert_eq!(last_frame(&text).unwrap(), second);
}

#[test]
fn data_may_have_comments_flags_and_coefficients() {
    let text = "title # 3 atoms\n\n 2 atoms # two\n\n1 atom types\n0 bonds\n-1 3 xlo xhi\n0 5 ylo yhi\n0 6 zlo zhi\n\
                0 0 0 xy xz yz\n\nMasses\n\n1 63.5 # Cu\n\nPair Coeffs # lj/cut\n\n1 1 1\n\nAtoms # atomic\n\n\
                9 1 0.5 1 2 0 -1 2 # tail\n4 1 1 1 1 0 0 0\n\nVelocities\n\n4 1 2 3\n9 4 5 6\n";
    let all = read(text).unwrap();
    assert_eq!(all.ids, [9, 4]);
    assert_eq!(all.atoms.positions[0], Vector3::new(0.5, -4.0, 14.0));
    assert_eq!(all.atoms.velocities[1], Vector3::new(1.0, 2.0, 3.0));
    assert_eq!(
        (all.atoms.masses[0], all.lengths()),
        (63.5, [4.0, 5.0, 6.0])
    );
    assert_eq!(all.volume(), 120.0);
    assert_eq!(
        all.space().unwrap().lengths(),
        [Some(4.0), Some(5.0), Some(6.0)]
    );
}

const DATA: [&str; 16] = [
    "title",
    "2 atoms",
    "1 atom types",
    "0 4 xlo xhi",
    "0 4 ylo yhi",
    "0 4 zlo zhi",
    "",
    "Masses",
    "",
    "1 1.0",
    "",
    "Atoms # atomic",
    "",
    "1 1 0 0 0",
    "2 1 1 0 0",
    "",
];

/// The message when one line, from 1, is replaced.
fn refused(lines: &[&str], number: usize, by: &str) -> String {
    let mut lines = lines.to_vec();
    lines[number - 1] = by;
    read(&lines.join("\n")).unwrap_err().to_string()
}

#[test]
fn wrong_data_is_refused_by_its_line() {
    assert!(read(&DATA.join("\n")).is_ok());
    let says = |number, by, parts: &[&str]| {
        let message = refused(&DATA, number, by);
        assert!(
            parts.iter().all(|part| message.contains(part)),
            "{by}: {message}"
        );
    };
    says(
        2,
        "3 atoms",
        &["line 16", "an atom is missing", "Atoms needs 3 lines"],
    );
    says(
        2,
        "-2 atoms",
        &[
            "line 2",
            "the number of atoms must be a whole number from 0",
        ],
    );
    says(2, "", &["the number of atoms is missing", "N atoms"]);
    says(3, "0 atom types", &["line 3", "from 1 to 64"]);
    says(4, "4 0 xlo xhi", &["line 4", "more than the low end 4"]);
    says(4, "0 inf xlo xhi", &["line 4", "a finite number", "inf"]);
    says(5, "", &["LOW HIGH ylo yhi"]);
    says(
        7,
        "1 0 0 xy xz yz",
        &["line 7", "a tilted box", "orthogonal"],
    );
    says(7, "5 bonds", &["line 7", "5 bonds", "atomic only"]);
    says(8, "Bodies", &["line 8", "section `Bodies`"]);
    says(
        10,
        "1 -1.0",
        &["line 10", "the mass must be a number > 0, not `-1.0`"],
    );
    says(
        10,
        "2 1.0",
        &["line 10", "the type must be a whole number from 1 to 1"],
    );
    says(10, "1", &["line 10", "TYPE MASS"]);
    says(
        12,
        "Atoms # full",
        &["line 12", "atom style `full`", "atom_style atomic"],
    );
    says(14, "1 1 0 0", &["line 14", "ID TYPE X Y Z"]);
    says(14, "1 1 0 0 0 1", &["line 14", "image flags or none"]);
    says(14, "1 1 0 0 0 1 x 0", &["line 14", "an image flag", "`x`"]);
    says(
        14,
        "1 1 0 nan 0",
        &["line 14", "a coordinate must be a finite number, not `nan`"],
    );
    says(14, "1 2 0 0 0", &["line 14", "the type"]);
    says(15, "1 1 1 0 0", &["line 15", "atom 1", "second time"]);
    says(
        16,
        "Velocities\n1 0 0 0\n3 0 0 0",
        &["line 18", "atom in the section Atoms"],
    );
    says(
        16,
        "Velocities\n1 0 0 0\n1 0 0 0",
        &["line 18", "second time"],
    );
    says(
        16,
        "Velocities\n1 0 0 0",
        &["line 18", "a velocity is missing"],
    );
    says(16, "3 1 1 1 1", &["line 16", "the name of a section"]);
    let none = DATA[..11].join("\n");
    assert!(
        read(&none)
            .unwrap_err()
            .to_string()
            .contains("the section Atoms is missing")
    );
    assert!(read("").unwrap_err().to_string().contains("line 1"));
}

const DUMP: [&str; 11] = [
    "ITEM: TIMESTEP",
    "10",
    "ITEM: NUMBER OF ATOMS",
    "2",
    "ITEM: BOX BOUNDS pp ff pp",
    "-1 3",
    "0 5",
    "0 6",
    "ITEM: ATOMS type xs ys zs id ix iy iz mass",
    "1 0.25 0.5 1.0 8 0 0 -1 2.0",
    "2 0 0 0 4 1 0 0 2.0",
];

#[test]
fn dumps_may_have_other_columns_and_scaled_places() {
    let all = read(&DUMP.join("\n")).unwrap();
    assert_eq!((all.step, all.ids.as_slice()), (10, [8, 4].as_slice()));
    assert_eq!(
        all.atoms.positions,
        [Vector3::new(0.0, 2.5, 0.0), Vector3::new(3.0, 0.0, 0.0)]
    );
    assert_eq!(all.is_periodic, [true, false, true]);
    assert_eq!(
        (all.atoms.masses.as_slice(), all.forces),
        ([1.0; 2].as_slice(), None)
    );
}

#[test]
fn wrong_dumps_are_refused_by_their_line() {
    let says = |number, by, parts: &[&str]| {
        let message = refused(&DUMP, number, by);
        assert!(
            parts.iter().all(|part| message.contains(part)),
            "{by}: {message}"
        );
    };
    says(2, "ten", &["line 2", "the step"]);
    says(4, "3", &["line 12", "an atom is missing", "cut short"]);
    says(
        5,
        "ITEM: BOX BOUNDS xy xz yz pp ff pp",
        &["line 6", "an axis of the box", "LOW HIGH TILT"],
    );
    says(6, "-1 3 0.5", &["line 6", "a tilted box"]);
    says(6, "3 -1", &["line 6", "the high end of the box"]);
    says(
        9,
        "ITEM: ATOMS type x y id",
        &["line 9", "a place is missing", "xu yu zu"],
    );
    says(9, "ITEM: ATOMS id x y z", &["line 9", "type is missing"]);
    says(10, "1 0.25 0.5 1.0 8", &["line 10", "9 columns"]);
    says(
        10,
        "65 0.25 0.5 1.0 8 0 0 0 2",
        &["line 10", "from 1 to 64"],
    );
    says(
        11,
        "2 0 0 0 8 1 0 0 2.0",
        &["line 11", "atom 8", "second time"],
    );
    says(3, "ITEM: NUMBER OF BONDS", &["line 3", "cannot be read"]);
    let cut = DUMP[..8].join("\n");
    assert!(
        read(&cut)
            .unwrap_err()
            .to_string()
            .contains("line 9: ITEM: ATOMS is missing")
    );
}

const XYZ: [&str; 4] = [
    "2",
    "Lattice=\"4 0 0 0 5 0 0 0 6\" Properties=id:I:1:species:S:1:pos:R:3:velo:R:3:tag:I:1 pbc=\"T F T\" x=1",
    "7 Ni 1 2 3 0.5 0 0 9",
    "3 Cu -1 0 0 0 0 1 9",
];

#[test]
fn extended_xyz_has_cell_species_and_velocities() {
    let text = XYZ.join("\n");
    assert_eq!(Format::of(&text), Format::ExtendedXyz);
    let all = read(&text).unwrap();
    assert_eq!(all.ids, [7, 3]);
    assert_eq!(all.names, Some(vec!["Ni".into(), "Cu".into()]));
    assert_eq!(all.atoms.species, [0, 1]);
    assert_eq!(all.atoms.positions[1], Vector3::new(-1.0, 0.0, 0.0));
    assert_eq!(all.atoms.velocities[0].x, 0.5);
    assert_eq!(
        (all.is_periodic, all.lengths()),
        ([true, false, true], [4.0, 5.0, 6.0])
    );
    // The last of two frames; numbers stay numbers; no lattice is an open box.
    let more = text + "\n1\nProperties=species:S:1:pos:R:3\n3 0.5 0.5 0.5\n";
    let last = read(&more).unwrap();
    assert_eq!(
        (last.names, last.atoms.species.as_slice()),
        (None, [2].as_slice())
    );
    assert_eq!((last.has_box, last.is_periodic), (false, [false; 3]));
}

#[test]
fn wrong_extended_xyz_is_refused_by_its_line() {
    let says = |number, by, parts: &[&str]| {
        let message = refused(&XYZ, number, by);
        assert!(
            parts.iter().all(|part| message.contains(part)),
            "{by}: {message}"
        );
    };
    says(1, "3", &["line 5", "an atom is missing"]);
    says(
        2,
        "Lattice=\"4 1 0 0 5 0 0 0 6\"",
        &["line 2", "orthogonal"],
    );
    says(2, "Lattice=\"4 0 0 0 5 0 0\"", &["line 2", "9 numbers"]);
    says(
        2,
        "Lattice=\"4 0 0",
        &["line 2", "a quotation mark is missing"],
    );
    says(
        2,
        "Properties=species:S:1 pbc=\"F F F\"",
        &["line 2", "pos:R:3 is missing"],
    );
    says(
        2,
        "Properties=species:S:1:pos:R",
        &["line 2", "NAME:KIND:COLUMNS"],
    );
    says(2, "pbc=\"T T\"", &["line 2", "three of T and F"]);
    says(2, "pbc=\"T T F\"", &["line 2", "Lattice is missing"]);
    says(3, "7 Ni 1 2 3 0.5 0 0", &["line 3", "9 columns"]);
    says(3, "7 Ni 1 2 inf 0.5 0 0 9", &["line 3", "finite"]);
    says(
        4,
        "7 Cu -1 0 0 0 0 1 9",
        &["line 4", "atom 7", "second time"],
    );
}
