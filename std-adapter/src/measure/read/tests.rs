use crate::measure::{Assembly, Forces};
use crate::random::Random;
use crate::record::{Snapshot, extended_xyz, particles_vtp};
use crate::space::PeriodicBox;
use nalgebra::Vector3;

/// Places, velocities, spins and radii with all their bits in use.
fn cloud(count: usize) -> ([Vec<Vector3<f64>>; 3], Vec<f64>) {
    let mut random = Random::new(5, 0);
    let mut some = |scale: f64, shift: f64| -> Vec<Vector3<f64>> {
        (0..count)
            .map(|_| Vector3::from_fn(|_, _| scale * (random.unit() - shift)))
            .collect()
    };
    let vectors = [some(9.0, 0.0), some(1e-3, 0.5), some(7.0, 0.5)];
    (
        vectors,
        (0..count).map(|_| 0.1 + 0.2 * random.unit()).collect(),
    )
}

fn refusal(name: &str, text: &str) -> String {
    Assembly::parse(name, text).map_or_else(|error| error.to_string(), |_| "read".into())
}

#[test]
fn exports_of_our_own_come_back_to_the_bit() {
    let ([places, velocities, spins], radii) = cloud(50);
    let space = PeriodicBox::new([Some(9.0), Some(9.5), None]).unwrap();
    let state = Snapshot {
        time: 0.3,
        space,
        extents: [[0.0, 9.0], [0.0, 9.5], [-1.0, 12.0]],
        positions: &places,
        radii: &radii,
        velocities: Some(&velocities),
        spins: Some(&spins),
        species: None,
        contacts: &[],
    };
    for (name, text) in [
        ("a.xyz", extended_xyz(&state).unwrap()),
        ("a.vtp", particles_vtp(&state).unwrap()),
    ] {
        let read = Assembly::parse(name, &text).unwrap();
        assert_eq!(read.positions, places, "{name}");
        assert_eq!(read.radii, radii, "{name}");
        assert_eq!(read.velocities.as_ref(), Some(&velocities), "{name}");
        assert_eq!(read.spins.as_ref(), Some(&spins), "{name}");
        assert_eq!(read.forces, Forces::Unknown);
        let is_xyz = name.ends_with("xyz");
        assert_eq!(read.space, if is_xyz { space } else { PeriodicBox::OPEN });
        if is_xyz {
            assert_eq!(read.bounds, state.extents);
        }
        let periodic = read
            .with_periods(name, [Some(9.0), Some(9.5), None])
            .unwrap();
        assert_eq!(periodic.space, space);
        let other = periodic.with_periods(name, [Some(8.0), None, None]);
        let other = other.map(|_| ()).map_err(|error| error.to_string());
        let told = if is_xyz { "a.xyz" } else { "a.vtp" };
        assert_eq!(
            other,
            Err(format!("{told}: its period along x is 9, not 8"))
        );
    }
}

#[test]
fn files_of_lammps_give_radii_from_diameters_in_a_box_from_zero() {
    let data = "grains\n\n2 atoms\n1 atom types\n-1 9 xlo xhi\n0 10 ylo yhi\n0 10 zlo zhi\n\n\
                Atoms # sphere\n\n1 1 0.5 2600 0 1 2\n2 1 1.5 2600 9 1 2 0 0 1\n\n\
                Velocities\n\n2 0 0 -1 7 8 9\n1 1 2 3 4 5 6\n";
    let read = Assembly::parse("g.data", data).unwrap();
    assert_eq!(read.radii, [0.25, 0.75]);
    assert_eq!(
        read.positions,
        [Vector3::new(1.0, 1.0, 2.0), Vector3::new(10.0, 1.0, 12.0)]
    );
    assert_eq!(read.velocities.unwrap()[0], Vector3::new(1.0, 2.0, 3.0));
    assert_eq!(read.spins.unwrap()[1], Vector3::new(7.0, 8.0, 9.0));
    assert_eq!(read.space.lengths(), [Some(10.0); 3]);

    let frame = |x: f64| {
        format!(
            "ITEM: TIMESTEP\n7\nITEM: NUMBER OF ATOMS\n1\nITEM: BOX BOUNDS pp ff ff\n0 4\n0 4\n-2 9\n\
             ITEM: ATOMS id type diameter x y z omegax omegay omegaz\n3 1 0.5 {x} 1 1 4 5 6\n"
        )
    };
    let read = Assembly::parse("g.dump", &(frame(1.0) + &frame(2.0))).unwrap();
    assert_eq!((read.radii[0], read.positions[0].x), (0.25, 2.0)); // the last frame
    assert_eq!(read.spins.unwrap()[0], Vector3::new(4.0, 5.0, 6.0));
    assert_eq!(read.space.lengths(), [Some(4.0), None, None]);
    assert_eq!(read.bounds, [[0.0, 4.0], [0.0, 4.0], [-2.0, 9.0]]);
}

#[test]
fn arrays_as_text_and_in_single_precision_are_read() {
    let file = |format: &str, points: &str, radii: &str| {
        format!(
            "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" byte_order=\"LittleEndian\">\n<PolyData>\n\
             <Piece NumberOfPoints=\"2\">\n<PointData Scalars=\"radius\">\n\
             <DataArray type=\"Float32\" Name=\"radius\" {format}>\n{radii}\n</DataArray>\n</PointData>\n\
             <Points>\n<DataArray type=\"Float64\" Name=\"Points\" NumberOfComponents=\"3\" format=\"ascii\">\n\
             {points}\n</DataArray>\n</Points>\n</Piece>\n</PolyData>\n</VTKFile>\n"
        )
    };
    let points = "0 0 0\n 2 0.5 0";
    let read = Assembly::parse("a.vtp", &file("format=\"ascii\"", points, "1 0.5")).unwrap();
    assert_eq!(read.positions[1], Vector3::new(2.0, 0.5, 0.0));
    assert_eq!(read.radii, [1.0, 0.5]);
    // 8, 0, 0, 0 as the length in 32 bits; then 1.0 and 0.5 as f32.
    let read = Assembly::parse(
        "a.vtp",
        &file("format=\"binary\"", points, "CAAAAAAAgD8AAAA/"),
    )
    .unwrap();
    assert_eq!(read.radii, [1.0, 0.5]);
    for (text, reason) in [
        (
            file("format=\"ascii\"", points, "1"),
            "a.vtp: 2 points need as many values of radius, not 1",
        ),
        (
            file("format=\"ascii\"", points, "1 -1"),
            "a.vtp: point 1: the radius must be a finite number > 0, not -1",
        ),
        (
            file("format=\"binary\"", points, "CAAAAAAAgD8="),
            "a.vtp: the array radius is damaged",
        ),
        (
            file("format=\"appended\" offset=\"0\"", points, ""),
            "a.vtp: the array radius is appended to the file; in ParaView save it with Data Mode Ascii or \
             Binary and Compressor Type None",
        ),
        ("<html></html>".into(), "a.vtp: it is no VTK file"),
    ] {
        assert_eq!(refusal("a.vtp", &text), reason);
    }
}

#[test]
fn files_without_radii_tilted_or_cut_are_refused_by_line() {
    let head = "1\nLattice=\"4 0 0 0 4 0 0 0 4\" Properties=species:S:1:pos:R:3";
    for (text, reason) in [
        (format!("{head}\nX 1 1 1\n"), "f: line 2: there are no radii; give a column radius:R:1"),
        (format!("{head}:radius:R:1\nX 1 1 1 0\n"), "f: line 3: the size of a sphere must be a number > 0, not `0`"),
        (
            "1\nLattice=\"4 0 0 1 4 0 0 0 4\" Properties=species:S:1:pos:R:3:radius:R:1\nX 1 1 1 1\n".into(),
            "f: line 2: Lattice must be of an orthogonal cell, `LX 0 0 0 LY 0 0 0 LZ` with lengths > 0, \
             not `4 0 0 1 4 0 0 0 4`",
        ),
        (
            "t\n\n1 atoms\n1 atom types\n0 4 xlo xhi\n0 4 ylo yhi\n0 4 zlo zhi\n\nAtoms # atomic\n\n1 1 1 1 1\n".into(),
            "f: line 9: the atom style `atomic` cannot be read; write the file with atom_style sphere",
        ),
        (
            "t\n\n1 atoms\n1 atom types\n0 4 xlo xhi\n0 4 ylo yhi\n0 4 zlo zhi\n\nAtoms\n\n1 1 1 1 1\n".into(),
            "f: line 11: a line of Atoms must be ID TYPE DIAMETER DENSITY X Y Z, and three image flags or none \
             (atom_style sphere), not `1 1 1 1 1`",
        ),
        (
            "ITEM: TIMESTEP\n7\nITEM: NUMBER OF ATOMS\n1\nITEM: BOX BOUNDS pp ff ff\n0 4\n0 4\n0 9\n\
             ITEM: ATOMS id type x y z\n3 1 1 1 1\n".into(),
            "f: line 9: there are no radii; dump the column radius or diameter",
        ),
        ("{\"tribos_state\":1}".into(), "f: it is damaged (its digest is not that of its bytes); give a state or a checkpoint that a run of spheres \
             wrote"),
    ] {
        assert_eq!(refusal("f", &text), reason);
    }
}
