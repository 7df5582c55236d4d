//! Particles and contacts as VTK PolyData (.vtp), which ParaView reads.
//!
//! Numbers are little-endian in base64: exact, and half as long as digits.

use super::{ContactRow, Partner, Snapshot, SnapshotError};
use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use nalgebra::Vector3;

/// Particles as points in the cell with their id from 0, radius and coordination, then material,
/// density, velocity and angular velocity where there are any. In ParaView: Glyph, Sphere, scaled by `radius` × 2.
///
/// ```
/// # use nalgebra::Vector3;
/// # use tribos::record::{Snapshot, particles_vtp};
/// # use tribos::space::PeriodicBox;
/// # let pair = Snapshot {
/// #     time: 0.0,
/// #     space: PeriodicBox::new([Some(10.0), None, None])?,
/// #     extents: [[0.0, 10.0], [0.0, 4.0], [0.0, 4.0]],
/// #     positions: &[Vector3::new(-0.5, 2.0, 2.0), Vector3::new(1.5, 2.0, 2.0)],
/// #     radii: &[1.0; 2],
/// #     velocities: None,
/// #     spins: None,
/// #     species: None,
/// #     materials: None,
/// #     densities: None,
/// #     contacts: &[],
/// # };
/// // A snapshot of two spheres.
/// let file = particles_vtp(&pair)?;
/// assert!(file.contains("NumberOfPoints=\"2\"") && !file.contains("\"velocity\""));
/// let moving = Snapshot { velocities: Some(&[Vector3::x(); 2]), ..pair };
/// assert!(particles_vtp(&moving)?.contains("\"velocity\""));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn particles_vtp(snapshot: &Snapshot) -> Result<String, SnapshotError> {
    snapshot.check()?;
    let count = snapshot.positions.len();
    let ids = || 0..count as i64;
    let mut data = integers("id", ids());
    data += &scalars("radius", snapshot.radii.iter().copied());
    let coordination = snapshot.coordination();
    data += &integers("coordination", coordination.into_iter().map(i64::from));
    if let Some(materials) = snapshot.materials {
        data += &integers("material", materials.iter().copied().map(i64::from));
    }
    if let Some(densities) = snapshot.densities {
        data += &scalars("density", densities.iter().copied());
    }
    for (name, values) in [
        ("velocity", snapshot.velocities),
        ("angular_velocity", snapshot.spins),
    ] {
        if let Some(values) = values {
            data += &vectors(name, values.iter().copied());
        }
    }
    let places = snapshot.positions.iter().map(|x| snapshot.space.wrap(x));
    let points = vectors("Points", places);
    let cells = integers("connectivity", ids()) + &integers("offsets", (1..).take(count));
    Ok(document(
        snapshot.time,
        &cell_of(snapshot),
        &format!("NumberOfPoints=\"{count}\" NumberOfVerts=\"{count}\""),
        &format!(
            "<PointData>\n{data}</PointData>\n<Points>\n{points}</Points>\n\
             <Verts>\n{cells}</Verts>\n"
        ),
    ))
}

/// Contacts as lines from centre to centre, or from a centre to the wall, with the particles `a`
/// and `b` (−1, −2, … for walls 0, 1, …), normal and tangential force, gap, force and torque on b.
///
/// A line begins in the cell and takes the shortest path, leaving the cell if the other particle
/// is across a border.
///
/// ```
/// # use nalgebra::Vector3;
/// # use tribos::record::{ContactRow, Partner, Snapshot, SnapshotError, contacts_vtp};
/// # use tribos::space::PeriodicBox;
/// # let rest = Vector3::zeros();
/// # let contacts = [ContactRow {
/// #     a: 0,
/// #     b: Partner::Particle(1),
/// #     normal: Vector3::x(),
/// #     gap: 0.0,
/// #     force: rest,
/// #     torque: rest,
/// # }];
/// # let pair = Snapshot {
/// #     time: 0.0,
/// #     space: PeriodicBox::new([Some(10.0), None, None])?,
/// #     extents: [[0.0, 10.0], [0.0, 4.0], [0.0, 4.0]],
/// #     positions: &[Vector3::new(-0.5, 2.0, 2.0), Vector3::new(1.5, 2.0, 2.0)],
/// #     radii: &[1.0; 2],
/// #     velocities: None,
/// #     spins: None,
/// #     species: None,
/// #     materials: None,
/// #     densities: None,
/// #     contacts: &contacts,
/// # };
/// // Two spheres that touch.
/// assert!(contacts_vtp(&pair)?.contains("NumberOfLines=\"1\""));
/// let stranger = [ContactRow { a: 2, ..contacts[0] }];
/// assert_eq!(
///     contacts_vtp(&Snapshot { contacts: &stranger, ..pair }),
///     Err(SnapshotError::Contact { contact: 0, particle: 2, positions: 2 })
/// );
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn contacts_vtp(snapshot: &Snapshot) -> Result<String, SnapshotError> {
    snapshot.check()?;
    let rows = snapshot.contacts;
    let count = rows.len();
    let mut data = integers("a", rows.iter().map(|row| row.a.into()));
    data += &integers("b", rows.iter().map(|row| label(row.b)));
    for (name, value) in [
        (
            "normal_force",
            ContactRow::normal_force as fn(&ContactRow) -> f64,
        ),
        ("tangential_force", ContactRow::tangential_force),
        ("gap", |row| row.gap),
    ] {
        data += &scalars(name, rows.iter().map(value));
    }
    data += &vectors("force", rows.iter().map(|row| row.force));
    data += &vectors("torque", rows.iter().map(|row| row.torque));
    let points = vectors("Points", rows.iter().flat_map(|row| line(snapshot, row)));
    let ends = integers("connectivity", 0..2 * count as i64);
    let offsets = integers("offsets", (1..=count as i64).map(|n| 2 * n));
    Ok(document(
        snapshot.time,
        &cell_of(snapshot),
        &format!("NumberOfPoints=\"{}\" NumberOfLines=\"{count}\"", 2 * count),
        &format!(
            "<CellData>\n{data}</CellData>\n<Points>\n{points}</Points>\n\
             <Lines>\n{ends}{offsets}</Lines>\n"
        ),
    ))
}

/// End points of a contact's line.
fn line(snapshot: &Snapshot, row: &ContactRow) -> [Vector3<f64>; 2] {
    let a = row.a as usize;
    let from = snapshot.space.wrap(&snapshot.positions[a]);
    let way = match row.b {
        Partner::Particle(b) => snapshot
            .space
            .displacement(&snapshot.positions[a], &snapshot.positions[b as usize]),
        Partner::Wall(_) => row.normal * (snapshot.radii[a] + row.gap),
    };
    [from, from + way]
}

/// Particles count up from 0, walls down from −1.
fn label(partner: Partner) -> i64 {
    match partner {
        Partner::Particle(index) => index.into(),
        Partner::Wall(number) => -1 - i64::from(number),
    }
}

/// The cell of a snapshot.
fn cell_of(snapshot: &Snapshot) -> String {
    let lengths = snapshot.space.lengths();
    let ends = [0, 1, 2].map(|axis| match lengths[axis] {
        Some(length) => [0.0, length],
        None => snapshot.extents[axis],
    });
    let is_periodic = lengths.map(|length| length.is_some());
    cell(ends, is_periodic, snapshot.space.offset())
}

/// The box as field data: its ends along x, y and z, 1 for an axis that repeats and 0 for an open one, and the
/// displacement along x of the images one period higher along z.
pub(super) fn cell(ends: [[f64; 2]; 3], is_periodic: [bool; 3], tilt: f64) -> String {
    let repeats = is_periodic.map(|is| f64::from(u8::from(is)));
    field("box", ends.as_flattened()) + &field("periodic", &repeats) + &field("tilt", &[tilt])
}

/// Numbers of the whole file.
fn field(name: &str, values: &[f64]) -> String {
    let bytes: Vec<u8> = values.iter().flat_map(|x| x.to_le_bytes()).collect();
    let shape = format!("NumberOfTuples=\"{}\"", values.len());
    array("Float64", name, &shape, &bytes)
}

pub(super) fn document(time: f64, cell: &str, counts: &str, inside: &str) -> String {
    let time = field("TimeValue", &[time]);
    format!(
        "<?xml version=\"1.0\"?>\n\
         <VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" \
         header_type=\"UInt64\">\n<PolyData>\n<FieldData>\n{time}{cell}</FieldData>\n\
         <Piece {counts}>\n{inside}</Piece>\n</PolyData>\n</VTKFile>\n"
    )
}

pub(super) fn integers(name: &str, values: impl Iterator<Item = i64>) -> String {
    let bytes: Vec<u8> = values.flat_map(i64::to_le_bytes).collect();
    array("Int64", name, "", &bytes)
}

pub(super) fn scalars(name: &str, values: impl Iterator<Item = f64>) -> String {
    let bytes: Vec<u8> = values.flat_map(f64::to_le_bytes).collect();
    array("Float64", name, "", &bytes)
}

pub(super) fn vectors(name: &str, values: impl Iterator<Item = Vector3<f64>>) -> String {
    let numbers = values.flat_map(|vector| [vector.x, vector.y, vector.z]);
    let bytes: Vec<u8> = numbers.flat_map(f64::to_le_bytes).collect();
    array("Float64", name, "NumberOfComponents=\"3\"", &bytes)
}

/// One array: its length in bytes, then the bytes.
fn array(kind: &str, name: &str, shape: &str, bytes: &[u8]) -> String {
    let mut block = (bytes.len() as u64).to_le_bytes().to_vec();
    block.extend(bytes);
    let text = STANDARD.encode(block);
    format!(
        "<DataArray type=\"{kind}\" Name=\"{name}\" {shape} format=\"binary\">{text}</DataArray>\n"
    )
}
