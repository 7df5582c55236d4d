//! Round trips, texts of every storage, samples, and files that are damaged.

use super::super::{
    ContactComponents, ContactThresholds, Friction, GlobalProblem, ProblemError, ReducedProblem,
    SparseMatrix,
};
use super::super::{residual, solve};
use super::{ContactProblem, Fault, FilePosition, ProblemFormat};
use std::path::Path;
use tribos_base::random::Random;

/// Any sign, and about sixty powers of ten.
fn value(random: &mut Random) -> f64 {
    let size = libm::exp(140.0 * (random.unit() - 0.5));
    if random.unit() < 0.5 { -size } else { size }
}

fn values(random: &mut Random, count: usize) -> Vec<f64> {
    (0..count).map(|_| value(random)).collect()
}

/// A matrix with a third of its entries.
fn matrix(random: &mut Random, shape: [usize; 2]) -> SparseMatrix {
    let [rows, columns] = shape;
    let mut triplets = Vec::new();
    for row in 0..rows {
        for column in 0..columns {
            if random.unit() < 0.3 {
                triplets.push((row, column, value(random)));
            }
        }
    }
    SparseMatrix::from_triplets(shape, &triplets).unwrap()
}

/// Laws that both formats hold.
fn plain_laws(
    random: &mut Random,
    layout: ContactComponents,
    contacts: usize,
) -> Vec<ContactThresholds> {
    let law = |_| ContactThresholds {
        sliding: random.unit(),
        rolling: if layout.rolling().is_empty() {
            0.0
        } else {
            random.unit()
        },
        ..ContactThresholds::default()
    };
    (0..contacts).map(law).collect()
}

fn local(seed: u64, layout: ContactComponents, contacts: usize) -> ContactProblem {
    let random = &mut Random::new(seed, 0);
    let size = layout.size() * contacts;
    let (w, q) = (matrix(random, [size, size]), values(random, size));
    let laws = plain_laws(random, layout, contacts);
    ReducedProblem::new(layout, w, q, laws).unwrap().into()
}

fn global(
    seed: u64,
    layout: ContactComponents,
    contacts: usize,
    freedoms: usize,
) -> ContactProblem {
    let random = &mut Random::new(seed, 1);
    let size = layout.size() * contacts;
    let m = matrix(random, [freedoms, freedoms]);
    let h = matrix(random, [freedoms, size]);
    let (f, w) = (values(random, freedoms), values(random, size));
    let laws = plain_laws(random, layout, contacts);
    GlobalProblem::new(layout, m, h, f, w, laws).unwrap().into()
}

/// Small problems of both kinds, the empty ones among them.
fn problems() -> Vec<ContactProblem> {
    let layouts = [
        ContactComponents::Plane,
        ContactComponents::Space,
        ContactComponents::Rolling,
    ];
    let mut problems = Vec::new();
    for (seed, layout) in (0..).zip(layouts) {
        for contacts in [0, 1, 4] {
            problems.push(local(seed, layout, contacts));
            problems.push(global(seed, layout, contacts, 7));
        }
        problems.push(global(seed, layout, 0, 0));
    }
    problems
}

fn written(problem: &ContactProblem, format: ProblemFormat) -> Vec<u8> {
    let home = tempfile::tempdir().unwrap();
    // The name says the other format.
    let path = home.path().join(match format {
        ProblemFormat::FclibHdf5 => "problem.dat",
        ProblemFormat::SiconosText => "problem.hdf5",
    });
    problem.write(&path, format).unwrap();
    std::fs::read(path).unwrap()
}

fn parsed(bytes: &[u8]) -> Result<ContactProblem, ProblemError> {
    ContactProblem::parse(bytes).map_err(|(place, fault)| ProblemError::File {
        path: "problem".into(),
        place,
        fault: fault.into(),
    })
}

/// Where a file is refused, and why.
fn fault(error: ProblemError) -> (FilePosition, Fault) {
    match error {
        ProblemError::File { place, fault, .. } => (place, *fault),
        other => unreachable!("{other}"),
    }
}

fn refused(text: &str) -> String {
    parsed(text.as_bytes()).unwrap_err().to_string()
}

#[test]
fn both_formats_keep_every_bit() {
    for problem in problems() {
        for format in [ProblemFormat::FclibHdf5, ProblemFormat::SiconosText] {
            let again = parsed(&written(&problem, format)).unwrap();
            // Equality of numbers is one of bits: none is zero or not a number.
            assert_eq!(again, problem, "{format:?}");
        }
    }
}

#[test]
fn extensions_are_kept_in_hdf5_and_refused_in_text() {
    let random = &mut Random::new(1, 2);
    for layout in [
        ContactComponents::Torsion,
        ContactComponents::All,
        ContactComponents::Space,
    ] {
        let size = 2 * layout.size();
        let (w, q) = (matrix(random, [size, size]), values(random, size));
        let law = ContactThresholds {
            sliding: 0.5,
            rolling: 0.1,
            torsion: 0.2,
            cohesion: 3.0,
            friction: Friction::Ellipsoid,
        };
        let laws = vec![ContactThresholds::coulomb(0.3), law];
        let problem = ContactProblem::from(ReducedProblem::new(layout, w, q, laws).unwrap());
        assert_eq!(
            parsed(&written(&problem, ProblemFormat::FclibHdf5)).unwrap(),
            problem
        );
        let home = tempfile::tempdir().unwrap();
        let path = home.path().join("problem.dat");
        let error = problem
            .write(&path, ProblemFormat::SiconosText)
            .unwrap_err();
        match fault(error).1 {
            Fault::Layout(size) => assert_eq!(size, layout.size()),
            Fault::NoPlace { contact, .. } => {
                assert!(layout == ContactComponents::Space && contact == 1)
            }
            fault => panic!("{fault}"),
        }
        assert!(!path.exists());
    }
}

/// Two contacts in a plane, W = [1 2 0 0; 3 4 0 0; 0 0 5 6; 0 0 7 8].
fn two_in_a_plane() -> ContactProblem {
    let entries = [
        (0, 0, 1.0),
        (0, 1, 2.0),
        (1, 0, 3.0),
        (1, 1, 4.0),
        (2, 2, 5.0),
        (2, 3, 6.0),
        (3, 2, 7.0),
        (3, 3, 8.0),
    ];
    let w = SparseMatrix::from_triplets([4, 4], &entries).unwrap();
    let laws = vec![
        ContactThresholds::coulomb(0.25),
        ContactThresholds::coulomb(0.75),
    ];
    ReducedProblem::new(
        ContactComponents::Plane,
        w,
        vec![-1.0, 0.5, -2.0, 0.0],
        laws,
    )
    .unwrap()
    .into()
}

const VECTORS: &str = "-1 .5 -2e0 0.0\n0.25 7.5e-1\n";

#[test]
fn every_storage_of_siconos_is_read() {
    let title =
        "CSparse Version 3.2.0, Sept 12, 2017.  Copyright (c) Timothy A. Davis, 2006-2016\n";
    let matrices = [
        // By columns, although the lines look like rows.
        "0\n4\n4\n4\t4\n 1 3 0 0\n 2 4 0 0\n 0 0 5 7\n 0 0 6 8\n".to_string(),
        "1\n4\n4\n2\n2\n2\n2\t4\t\n2\t4\t\n3\n2\n0\t1\t2\t\n0\t1\t\n0\n1\n3\n2\n4\n1\n5\n7\n6\n8\n"
            .to_string(),
        format!(
            "2\n4\n4\n1\n{title}triplet: 4-by-4, nzmax: 20 nnz: 9\n 0 0 : 1\n 0 1 : 2\n 1 0 : 3\n 1 1 : 3\n \
            1 1 : 1\n 2 2 : 5\n 2 3 : 6\n 3 2 : 7\n 3 3 : 8\n"
        ),
        format!(
            "2\n4\n4\n2\n{title}4-by-4, nzmax: 8 nnz: 8, 1-norm: 14\n col 0 : locations 0 to 1\n 0 : 1\n 1 : 3\n \
            col 1 : locations 2 to 3\n 0 : 2\n 1 : 4\n col 2 : locations 4 to 5\n 2 : 5\n 3 : 7\n \
            col 3 : locations 6 to 7\n 2 : 6\n 3 : 8\n"
        ),
        format!(
            "2\n4\n4\n3\n{title}csr: 4-by-4, nzmax: 8 nnz: 8, 1-norm: 14\n row 0 : locations 0 to 1\n 0 : 1\n \
            1 : 2\n row 1 : locations 2 to 3\n 0 : 3\n 1 : 4\n row 2 : locations 4 to 5\n 2 : 5\n 3 : 6\n \
            row 3 : locations 6 to 7\n 2 : 7\n 3 : 8\n"
        ),
    ];
    for matrix in matrices {
        // Old versions of Siconos end with a flag.
        for end in ["", "1\n"] {
            let text = format!("2\n2\n{matrix}{VECTORS}{end}");
            assert_eq!(parsed(text.as_bytes()).unwrap(), two_in_a_plane(), "{text}");
        }
    }
}

#[test]
fn a_second_matrix_means_bodies() {
    // M of the size that W would have.
    let text = "2 1  0 2 2 2 2  4 0 0 5  0 2 2 2 2  1 2 3 4  6 7  8 9  0.5";
    let m = SparseMatrix::from_triplets([2, 2], &[(0, 0, 4.0), (1, 1, 5.0)]).unwrap();
    let h = SparseMatrix::from_triplets(
        [2, 2],
        &[(0, 0, 1.0), (1, 0, 2.0), (0, 1, 3.0), (1, 1, 4.0)],
    );
    let laws = vec![ContactThresholds::coulomb(0.5)];
    let made = GlobalProblem::new(
        ContactComponents::Plane,
        m,
        h.unwrap(),
        vec![6.0, 7.0],
        vec![8.0, 9.0],
        laws,
    );
    assert_eq!(parsed(text.as_bytes()).unwrap(), made.unwrap().into());
}

#[test]
fn samples_of_siconos_are_read_and_solved() {
    let samples: [(&str, usize); 2] = [
        (include_str!("samples/NESpheres_10_1.dat"), 9),
        (include_str!("samples/Rover1041.dat"), 5),
    ];
    for (text, contacts) in samples {
        let problem = parsed(text.as_bytes()).unwrap();
        assert_eq!(problem.laws().len(), contacts);
        let reduced = problem.reduced().unwrap();
        let end = solve(&reduced, &Default::default(), |_| ());
        assert!(residual(&reduced, &end.impulses).meets(1e-8));
        for format in [ProblemFormat::FclibHdf5, ProblemFormat::SiconosText] {
            assert_eq!(parsed(&written(&problem, format)).unwrap(), problem);
        }
    }
}

#[test]
fn refusals_say_where_and_what_would_be_valid() {
    let cases = [
        (
            "",
            "problem, line 1: the file ends where the number of components of a contact should follow",
        ),
        (
            "7\n1",
            "problem, line 1: the number of components of a contact is 7, not 2, 3 or 5",
        ),
        (
            "4\n1",
            "problem, line 1: the number of components of a contact is 4, not 2, 3 or 5",
        ),
        (
            "2\n-3",
            "problem, line 2: the number of contacts is -3, not 0 or more",
        ),
        (
            "2\nnan",
            "problem, line 2: found nan instead of the number of contacts",
        ),
        (
            "2\n1\n9\n2 2",
            "problem, line 3: the storage of a matrix (0 dense, 1 blocks, 2 CSparse) is 9, not between 0 and 2",
        ),
        (
            "2\n1\n0\n999999999999 2",
            "problem, line 4: the number of rows is 999999999999, not at most 8, for which the file has room",
        ),
        (
            "2\n1\n0\n2 2\n2 2\n1 0 inf 1",
            "problem, line 6: found inf instead of an element of a matrix, a finite number",
        ),
        (
            "2\n1\n0 2 2 2 2\n1 0 0 1\n0 0",
            "problem, line 5: the file ends where a friction coefficient should follow",
        ),
        (
            "2\n1\n0 2 2 2 2\n1 0 0 1\n0 0\n-1",
            "problem: not a contact problem: the friction coefficient of contact 0 is -1; \
            it must be finite and not negative",
        ),
        (
            "2\n1\n0 2 2 2 2\n1 0 0 1\n0 0\n0.5\n7.5",
            "problem, line 7: found 7.5 where the file should end",
        ),
        (
            "2\n1\n0 1 1 1 1\n1\n.5 0\n0.5",
            "problem, line 4: not a contact problem: W has 1 rows, not 2",
        ),
        // Whole numbers after W could begin a second matrix.
        (
            "2\n1\n0 2 2 2 2\n1 0 0 1\n0 2\n",
            "problem, line 6: the file ends where a friction coefficient should follow",
        ),
        (
            "3\n1\n0 3 3 3 3\n1 0 0 0 1 0 0 0 1\n0 0 0\n-1",
            "problem: not a contact problem: the friction coefficient of contact 0 is -1; \
            it must be finite and not negative",
        ),
        (
            "3\n1\n0 1 1 1 1\n1\n0 1 3 1\n3 1 2 3\n0.5",
            "problem, line 7: the file ends where an element of w should follow",
        ),
    ];
    for (text, message) in cases {
        assert_eq!(refused(text), message);
    }
    let binary = parsed(&[0xff, 0xfe, 0]).unwrap_err();
    assert!(matches!(fault(binary), (_, Fault::NeitherFormat)));
    let absent = ContactProblem::read(Path::new("/no/such/file")).unwrap_err();
    assert!(matches!(
        fault(absent),
        (FilePosition::File, Fault::Read(_))
    ));
}

#[test]
fn refusals_of_hdf5_name_the_dataset() {
    let write = |size: i32, mu: &[f64], nz: i32, i: &[i32]| {
        let mut file = hdf5_pure::FileBuilder::new();
        let mut group = file.create_group("fclib_local");
        group.create_dataset("spacedim").with_i32_data(&[size]);
        let mut w = group.create_group("W");
        for (name, number) in [("m", 2), ("n", 2), ("nz", nz)] {
            w.create_dataset(name).with_i32_data(&[number]);
        }
        w.create_dataset("i").with_i32_data(i);
        w.create_dataset("p").with_i32_data(&[0, 1]);
        w.create_dataset("x").with_f64_data(&[1.0, 1.0]);
        group.add_group(w.finish());
        let mut vectors = group.create_group("vectors");
        vectors.create_dataset("q").with_f64_data(&[0.0, 0.0]);
        vectors.create_dataset("mu").with_f64_data(mu);
        group.add_group(vectors.finish());
        file.add_group(group.finish());
        parsed(&file.finish().unwrap()).map_err(|error| error.to_string())
    };
    assert!(write(2, &[0.5], 2, &[0, 1]).is_ok());
    let cases = [
        (
            write(9, &[0.5], 2, &[0, 1]),
            "spacedim: the number of components of a contact is 9, not from 2 to 6",
        ),
        (
            write(2, &[0.5; 2], 2, &[0, 1]),
            "vectors/q: the number of elements is 2, not 4",
        ),
        (
            write(2, &[f64::NAN], 2, &[0, 1]),
            "vectors/mu: not a contact problem: the friction coefficient of contact 0 \
            is NaN; it must be finite and not negative",
        ),
        (
            write(2, &[0.5], 3, &[0, 1]),
            "W/i: the number of elements is 2, not at least nz = 3",
        ),
        (
            write(2, &[0.5], -3, &[0, 1]),
            "W/nz: nz is -3, not a number of triplets, −1 (columns) or −2 (rows)",
        ),
        (
            write(2, &[0.5], -1, &[0, 1]),
            "W/p: the number of elements is 2, not 3",
        ),
        (
            write(2, &[0.5], 2, &[0, -1]),
            "W/i: an index is -1, not from 0 to below 2",
        ),
        (
            write(2, &[0.5], 2, &[0, 2]),
            "W/i: an index is 2, not from 0 to below 2",
        ),
    ];
    for (found, message) in cases {
        assert_eq!(
            found.unwrap_err(),
            format!("problem, fclib_local/{message}")
        );
    }
    let empty = hdf5_pure::FileBuilder::new().finish().unwrap();
    assert!(
        parsed(&empty)
            .unwrap_err()
            .to_string()
            .starts_with("problem: missing; ")
    );
}

#[test]
fn rolling_is_never_dropped() {
    let write = |group: &str, size: i32, rolling: &[f64]| {
        let count = size as usize;
        let mut file = hdf5_pure::FileBuilder::new();
        let mut group = file.create_group(group);
        group.create_dataset("spacedim").with_i32_data(&[size]);
        for name in ["M", "H"] {
            let mut matrix = group.create_group(name);
            for part in ["m", "n", "nz"] {
                matrix.create_dataset(part).with_i32_data(&[size]);
            }
            let diagonal: Vec<i32> = (0..size).collect();
            matrix.create_dataset("i").with_i32_data(&diagonal);
            matrix.create_dataset("p").with_i32_data(&diagonal);
            matrix.create_dataset("x").with_f64_data(&vec![1.0; count]);
            group.add_group(matrix.finish());
        }
        let mut vectors = group.create_group("vectors");
        for name in ["f", "w"] {
            vectors
                .create_dataset(name)
                .with_f64_data(&vec![0.0; count]);
        }
        vectors.create_dataset("mu").with_f64_data(&[0.5]);
        if !rolling.is_empty() {
            vectors.create_dataset("mu_r").with_f64_data(rolling);
        }
        group.add_group(vectors.finish());
        file.add_group(group.finish());
        parsed(&file.finish().unwrap()).map_err(|error| error.to_string())
    };
    assert!(write("fclib_global_rolling", 5, &[0.1]).is_ok());
    assert!(write("fclib_global", 5, &[0.1]).is_ok());
    assert!(write("fclib_global", 3, &[]).is_ok());
    // Three components with rolling are those of a plane, not two of sliding.
    assert_eq!(
        write("fclib_global_rolling", 3, &[0.1]).unwrap_err(),
        "problem, fclib_global_rolling/spacedim: the number of components of a contact is 3, \
        not 5 or 6, as rolling in space has"
    );
    assert_eq!(
        write("fclib_global", 5, &[]).unwrap_err(),
        "problem, fclib_global/vectors/mu_r: missing; a problem needs this dataset"
    );
}

#[test]
fn columns_and_rows_of_hdf5_are_told_apart() {
    let read = |nz: i32| {
        let mut file = hdf5_pure::FileBuilder::new();
        let mut group = file.create_group("fclib_local");
        group.create_dataset("spacedim").with_i32_data(&[2]);
        let mut w = group.create_group("W");
        for (name, number) in [("m", 2), ("n", 2), ("nz", nz)] {
            w.create_dataset(name).with_i32_data(&[number]);
        }
        w.create_dataset("p").with_i32_data(&[0, 2, 3]);
        w.create_dataset("i").with_i32_data(&[0, 1, 1]);
        w.create_dataset("x").with_f64_data(&[1.0, 2.0, 3.0]);
        group.add_group(w.finish());
        let mut vectors = group.create_group("vectors");
        vectors.create_dataset("q").with_f64_data(&[0.0, 0.0]);
        vectors.create_dataset("mu").with_f64_data(&[0.5]);
        group.add_group(vectors.finish());
        file.add_group(group.finish());
        let problem = parsed(&file.finish().unwrap()).unwrap();
        problem
            .reduced()
            .unwrap()
            .w()
            .triplets()
            .collect::<Vec<_>>()
    };
    assert_eq!(read(-1), [(0, 0, 1.0), (1, 0, 2.0), (1, 1, 3.0)]);
    assert_eq!(read(-2), [(0, 0, 1.0), (0, 1, 2.0), (1, 1, 3.0)]);
}

#[test]
fn sums_beyond_the_largest_number_are_refused() {
    let huge = SparseMatrix::from_triplets([1, 1], &[(0, 0, f64::MAX), (0, 0, f64::MAX)]);
    assert!(matches!(huge, Err(ProblemError::NotFinite { .. })));
}

/// What may stand in a damaged text.
const WORDS: [&str; 12] = [
    "-1",
    "0",
    "1",
    "2",
    "3",
    "18446744073709551616",
    "4294967295",
    "1e400",
    "nan",
    "x",
    "",
    "\u{fc}\n\n",
];

fn damaged_text(random: &mut Random, text: &str) -> Vec<u8> {
    let mut words: Vec<&str> = text.split_inclusive(char::is_whitespace).collect();
    let mut pick = |below: usize| (random.unit() * below as f64) as usize;
    for _ in 0..=pick(2) {
        // The head more often than the numbers.
        let at = if pick(2) == 0 {
            pick(words.len().min(30))
        } else {
            pick(words.len())
        };
        match pick(4) {
            0 => words.truncate(at.max(1)),
            1 => drop(words.remove(at)),
            2 => words.insert(at, "7 "),
            _ => words[at] = WORDS[pick(WORDS.len())],
        }
        if words.is_empty() {
            break;
        }
    }
    words.concat().into_bytes()
}

fn damaged_bytes(random: &mut Random, bytes: &[u8]) -> Vec<u8> {
    let mut bytes = bytes.to_vec();
    let mut pick = |below: usize| (random.unit() * below as f64) as usize;
    if pick(4) == 0 {
        bytes.truncate(pick(bytes.len()));
        return bytes;
    }
    for _ in 0..=pick(6) {
        let at = pick(bytes.len());
        bytes[at] = [0, 0xff, pick(256) as u8][pick(3)];
    }
    bytes
}

#[test]
fn damaged_files_are_read_or_refused_but_never_panic() {
    let problems = [
        local(3, ContactComponents::Rolling, 2),
        global(3, ContactComponents::Space, 2, 6),
    ];
    let mut refused = [0, 0];
    for (seed, problem) in (0..).zip(&problems) {
        let (text, bytes) = (
            String::from_utf8(written(problem, ProblemFormat::SiconosText)).unwrap(),
            written(problem, ProblemFormat::FclibHdf5),
        );
        let random = &mut Random::new(seed, 3);
        for _ in 0..300 {
            let damaged = [damaged_text(random, &text), damaged_bytes(random, &bytes)];
            for (kind, damaged) in damaged.iter().enumerate() {
                if let Err(error) = parsed(damaged) {
                    assert!(error.to_string().len() > 20);
                    refused[kind] += 1;
                }
            }
        }
    }
    // Most words of a text count; most bytes of HDF5 are numbers or room.
    assert!(refused[0] > 400 && refused[1] > 150, "{refused:?}");
}

#[test]
fn a_file_cut_short_is_refused() {
    let bytes = written(
        &local(3, ContactComponents::Space, 2),
        ProblemFormat::FclibHdf5,
    );
    for left in (0..bytes.len()).rev().step_by(7) {
        assert!(parsed(&bytes[..left]).is_err(), "{left} of {}", bytes.len());
    }
}
