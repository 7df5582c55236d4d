//! Exports say what the snapshot says, bit for bit, to a reader of their formats.

use nalgebra::Vector3;
use tribos::powder::deposit::{Ballistic, DepositTarget, SUBSTRATE};
use tribos::record::{
    ContactRow, Partner, Snapshot, SnapshotError, contacts_vtp, extended_xyz, particles_vtp,
};
use tribos::space::PeriodicBox;
use tribos_tests::sweep::Lcg;

/// Three particles, one outside the cell, that touch across a border, openly and the floor.
struct Sample {
    positions: Vec<Vector3<f64>>,
    radii: Vec<f64>,
    velocities: Vec<Vector3<f64>>,
    spins: Vec<Vector3<f64>>,
    contacts: Vec<ContactRow>,
}

fn sample() -> Sample {
    let mut rng = Lcg::new(5);
    let mut vectors = || {
        (0..3)
            .map(|_| Vector3::from_fn(|_, _| rng.between(-1.0, 1.0) / 3.0))
            .collect()
    };
    let row = |a, b, normal: [f64; 3], gap, force: [f64; 3]| ContactRow {
        a,
        b,
        normal: normal.into(),
        gap,
        force: force.into(),
        torque: Vector3::new(0.1, f64::MIN_POSITIVE, -0.3),
    };
    Sample {
        positions: vec![
            Vector3::new(0.5, 2.0, 1.0),
            Vector3::new(9.0, 2.0, 1.0),
            Vector3::new(-7.5, 2.0, 1.0 / 3.0),
        ],
        radii: vec![0.75, 0.7, 1.0 / 3.0],
        velocities: vectors(),
        spins: vectors(),
        contacts: vec![
            row(
                0,
                Partner::Particle(1),
                [-1.0, 0.0, 0.0],
                0.05,
                [2.0, 3.0, -4.0],
            ),
            row(
                2,
                Partner::Wall(0),
                [0.0, 0.0, -1.0],
                0.0,
                [0.3, 0.4, -1.25],
            ),
            row(0, Partner::Wall(1), [0.0, 0.0, 1.0], 0.25, [0.0, 0.0, 0.0]),
        ],
    }
}

impl Sample {
    fn snapshot(&self) -> Snapshot<'_> {
        Snapshot {
            time: 0.1,
            space: PeriodicBox::new([Some(10.0), Some(4.0), None]).unwrap(),
            extents: [[0.0, 0.0], [0.0, 0.0], [-1.0, 2.0]],
            positions: &self.positions,
            radii: &self.radii,
            velocities: Some(&self.velocities),
            spins: Some(&self.spins),
            species: Some(&["Cu", "Cu", "Ni"]),
            materials: Some(&[1, 1, 2]),
            densities: Some(&[2.5, 2.5, 7.8]),
            contacts: &self.contacts,
        }
    }

    fn placed(&self) -> [[f64; 3]; 3] {
        [[0.5, 2.0, 1.0], [9.0, 2.0, 1.0], [2.5, 2.0, 1.0 / 3.0]]
    }
}

fn numbers(text: &str) -> Vec<f64> {
    text.split_whitespace()
        .map(|word| word.parse().unwrap())
        .collect()
}

/// The quoted value of a key.
fn value<'a>(line: &'a str, key: &str) -> &'a str {
    let (_, rest) = line.split_once(&format!("{key}=\"")).unwrap();
    rest.split_once('"').unwrap().0
}

#[test]
fn extended_xyz_reads_back() {
    let sample = sample();
    let text = extended_xyz(&sample.snapshot()).unwrap();
    let lines: Vec<&str> = text.lines().collect();
    assert_eq!((lines[0], lines.len()), ("3", 5));
    let header = lines[1];
    let cell = [10.0, 0.0, 0.0, 0.0, 4.0, 0.0, 0.0, 0.0, 3.0];
    assert_eq!(numbers(value(header, "Lattice")), cell);
    assert_eq!(numbers(value(header, "Origin")), [0.0, 0.0, -1.0]);
    assert_eq!(value(header, "pbc"), "T T F");
    assert!(header.contains(
        "species:S:1:id:I:1:pos:R:3:radius:R:1:n_neighb:I:1:material:I:1:density:R:1:velo:R:3:omega:R:3 "
    ));
    let (_, time) = header.split_once("Time=").unwrap();
    assert_eq!(time.parse(), Ok(0.1));
    for (index, line) in lines[2..].iter().enumerate() {
        let (species, rest) = line.split_once(' ').unwrap();
        assert_eq!(species, ["Cu", "Cu", "Ni"][index]);
        let mut wanted = vec![index as f64];
        wanted.extend(sample.placed()[index]);
        wanted.extend([sample.radii[index], [2.0, 1.0, 1.0][index]]);
        wanted.extend([[1.0, 1.0, 2.0][index], [2.5, 2.5, 7.8][index]]);
        wanted.extend(sample.velocities[index].iter());
        wanted.extend(sample.spins[index].iter());
        assert_eq!(numbers(rest), wanted);
    }
    // What is left out leaves no column.
    let bare = Snapshot {
        velocities: None,
        spins: None,
        species: None,
        materials: None,
        densities: None,
        contacts: &[],
        ..sample.snapshot()
    };
    let text = extended_xyz(&bare).unwrap();
    assert!(text.contains("n_neighb:I:1 Time"));
    for line in text.lines().skip(2) {
        assert!(line.starts_with("X ") && line.ends_with(" 0"));
        assert_eq!(line.split(' ').count(), 7);
    }
}

/// The bytes of base64, by the alphabet of RFC 4648.
fn decode(text: &str) -> Vec<u8> {
    let digit = |c: u8| match c {
        b'A'..=b'Z' => c - b'A',
        b'a'..=b'z' => c - b'a' + 26,
        b'0'..=b'9' => c - b'0' + 52,
        b'+' => 62,
        b'/' => 63,
        other => panic!("{other} in base64"),
    };
    assert_eq!(text.len() % 4, 0);
    let (mut out, mut bits, mut count) = (Vec::new(), 0_u32, 0);
    for c in text.bytes().filter(|&c| c != b'=') {
        bits = bits << 6 | u32::from(digit(c));
        count += 6;
        if count >= 8 {
            count -= 8;
            out.push((bits >> count) as u8);
        }
    }
    out
}

/// The words of 8 bytes of one array, with its type and number of components.
fn array(text: &str, name: &str) -> (Vec<[u8; 8]>, String) {
    let (before, rest) = text.split_once(&format!("Name=\"{name}\"")).unwrap();
    let kind = before.rsplit_once("type=\"").unwrap().1;
    let (attributes, rest) = rest.split_once('>').unwrap();
    assert!(attributes.ends_with("format=\"binary\""));
    let bytes = decode(rest.split_once('<').unwrap().0);
    let mut words = bytes.chunks_exact(8).map(|word| word.try_into().unwrap());
    let length: [u8; 8] = words.next().unwrap();
    assert_eq!(u64::from_le_bytes(length) as usize, bytes.len() - 8);
    let components = if attributes.contains("NumberOfComponents=\"3\"") {
        3
    } else {
        1
    };
    let kind = kind.split_once('"').unwrap().0;
    (words.collect(), format!("{kind}x{components}"))
}

fn floats(text: &str, name: &str) -> Vec<f64> {
    let (words, kind) = array(text, name);
    assert_eq!(kind, "Float64x1");
    words.into_iter().map(f64::from_le_bytes).collect()
}

fn triples(text: &str, name: &str) -> Vec<[f64; 3]> {
    let (words, kind) = array(text, name);
    assert_eq!(kind, "Float64x3");
    let words: Vec<f64> = words.into_iter().map(f64::from_le_bytes).collect();
    words
        .chunks_exact(3)
        .map(|three| three.try_into().unwrap())
        .collect()
}

fn integers(text: &str, name: &str) -> Vec<i64> {
    let (words, kind) = array(text, name);
    assert_eq!(kind, "Int64x1");
    words.into_iter().map(i64::from_le_bytes).collect()
}

fn rows(vectors: &[Vector3<f64>]) -> Vec<[f64; 3]> {
    vectors.iter().map(|vector| (*vector).into()).collect()
}

#[test]
fn particles_of_vtk_read_back() {
    let sample = sample();
    let text = particles_vtp(&sample.snapshot()).unwrap();
    assert!(text.contains("<Piece NumberOfPoints=\"3\" NumberOfVerts=\"3\">"));
    assert!(text.contains("byte_order=\"LittleEndian\" header_type=\"UInt64\""));
    assert_eq!(floats(&text, "TimeValue"), [0.1]);
    assert_eq!(triples(&text, "Points"), sample.placed());
    assert_eq!(floats(&text, "radius"), sample.radii);
    assert_eq!(integers(&text, "id"), [0, 1, 2]);
    assert_eq!(integers(&text, "coordination"), [2, 1, 1]);
    assert_eq!(triples(&text, "velocity"), rows(&sample.velocities));
    assert_eq!(triples(&text, "angular_velocity"), rows(&sample.spins));
    assert_eq!(integers(&text, "connectivity"), [0, 1, 2]);
    assert_eq!(integers(&text, "offsets"), [1, 2, 3]);
}

#[test]
fn contacts_of_vtk_read_back() {
    let sample = sample();
    let text = contacts_vtp(&sample.snapshot()).unwrap();
    assert!(text.contains("<Piece NumberOfPoints=\"6\" NumberOfLines=\"3\">"));
    // Across the border and not across the box; to the floor; to the lid.
    let lines = [
        [0.5, 2.0, 1.0],
        [-1.0, 2.0, 1.0],
        [2.5, 2.0, 1.0 / 3.0],
        [2.5, 2.0, 0.0],
        [0.5, 2.0, 1.0],
        [0.5, 2.0, 2.0],
    ];
    assert_eq!(triples(&text, "Points"), lines);
    assert_eq!(integers(&text, "connectivity"), [0, 1, 2, 3, 4, 5]);
    assert_eq!(integers(&text, "offsets"), [2, 4, 6]);
    assert_eq!(integers(&text, "a"), [0, 2, 0]);
    assert_eq!(integers(&text, "b"), [1, -1, -2]);
    // A pull, a push, nothing.
    assert_eq!(floats(&text, "normal_force"), [-2.0, 1.25, 0.0]);
    assert_eq!(floats(&text, "tangential_force"), [5.0, 0.5, 0.0]);
    assert_eq!(floats(&text, "gap"), [0.05, 0.0, 0.25]);
    assert_eq!(triples(&text, "force")[1], [0.3, 0.4, -1.25]);
    assert_eq!(
        triples(&text, "torque"),
        [[0.1, f64::MIN_POSITIVE, -0.3]; 3]
    );
}

#[test]
fn contradictions_are_refused() {
    let sample = sample();
    let all = |snapshot: &Snapshot| {
        let made = [extended_xyz, particles_vtp, contacts_vtp].map(|make| make(snapshot));
        assert!(made[0] == made[1] && made[1] == made[2]);
        made[0].clone().unwrap_err()
    };
    let short = Snapshot {
        spins: Some(&sample.spins[..2]),
        ..sample.snapshot()
    };
    assert_eq!(
        all(&short),
        SnapshotError::Lengths {
            name: "spins",
            positions: 3,
            given: 2
        }
    );
    let stranger = [ContactRow {
        b: Partner::Particle(3),
        ..sample.contacts[0]
    }];
    let unknown = Snapshot {
        contacts: &stranger,
        ..sample.snapshot()
    };
    assert_eq!(
        all(&unknown),
        SnapshotError::Contact {
            contact: 0,
            particle: 3,
            positions: 3
        }
    );
    for name in ["", "a b", " a", "a\n"] {
        let species = ["Cu", name, "Cu"];
        let two_words = Snapshot {
            species: Some(&species),
            ..sample.snapshot()
        };
        assert!(matches!(
            all(&two_words),
            SnapshotError::Species { particle: 1, .. }
        ));
    }
}

#[test]
fn a_deposit_exports_its_tree() {
    let deposit = Ballistic::new(20.0, 1.0, 3.0).unwrap();
    let deposit = deposit.grow(DepositTarget::Count(200), 3).unwrap();
    let contacts = deposit.contacts();
    let text = contacts_vtp(&deposit.snapshot(&contacts)).unwrap();
    let ends = triples(&text, "Points");
    for (index, (ends, parent)) in ends.chunks_exact(2).zip(&deposit.parents).enumerate() {
        let [from, to] = [ends[0], ends[1]].map(Vector3::from);
        assert_eq!(from, deposit.positions[index]);
        let length = if parent.is_some() { 2.0 } else { 1.0 };
        assert!(((to - from).norm() - length).abs() < 1e-12);
        let label = parent.map_or(-1 - i64::from(SUBSTRATE), i64::from);
        assert_eq!(integers(&text, "b")[index], label);
    }
    assert!(floats(&text, "gap").iter().all(|gap| gap.abs() < 1e-12));
    assert_eq!(integers(&text, "a").len(), 200);
}

#[test]
fn nothing_is_exported_too() {
    let nothing = Snapshot {
        time: 0.0,
        space: PeriodicBox::OPEN,
        extents: [[0.0, 1.0]; 3],
        positions: &[],
        radii: &[],
        velocities: None,
        spins: None,
        species: None,
        materials: None,
        densities: None,
        contacts: &[],
    };
    assert_eq!(extended_xyz(&nothing).unwrap().lines().count(), 2);
    assert!(triples(&particles_vtp(&nothing).unwrap(), "Points").is_empty());
    assert!(triples(&contacts_vtp(&nothing).unwrap(), "Points").is_empty());
}
