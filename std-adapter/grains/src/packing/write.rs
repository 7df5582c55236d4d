//! Spheres as files of other programs, with all that each format can hold.

use super::{Assembly, PackingFormat};
use std::fmt::Write as _;
use tribos_base::exchange::lammps::{SphereRows, sphere_data_file};
use tribos_base::exchange::sphere_columns::SphereColumn;
use tribos_base::record::{
    Snapshot, SnapshotError, cell_keys, extended_xyz, number, particles_vtp,
};

/// Density in a file that must have one, where none is known.
const UNKNOWN_DENSITY: f64 = 1.0;

/// The text of a file, and what it lost.
///
/// ```
/// use tribos::measure::{Assembly, PackingFormat, WrittenPacking};
/// let text = "# Lattice=\"4 0 0 0 4 0 0 0 4\" pbc=\"T T F\"\n# x y z radius\n1 1 1 0.5\n";
/// let one = Assembly::parse("one.txt", text)?;
/// let WrittenPacking { text, lost } = one.written(PackingFormat::Csv)?.unwrap_or_default();
/// assert_eq!(text, "x,y,z,radius\n1.0,1.0,1.0,0.5\n");
/// assert_eq!(lost, ["the box with its periods"]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
pub struct WrittenPacking {
    /// The text.
    pub text: String,
    /// What the format cannot hold, or had to invent.
    pub lost: Vec<&'static str>,
}

impl Assembly {
    /// The spheres in a format, to the bit: positions in the cell, radii, materials, densities, velocities, angular velocities,
    /// box, periods and tilt. None for formats that are only read.
    pub fn written(&self, format: PackingFormat) -> Result<Option<WrittenPacking>, SnapshotError> {
        let snapshot = self.snapshot();
        let (has_cell, mut lost) = (self.has_cell(), Vec::new());
        let text = match format {
            PackingFormat::ExtendedXyz => {
                let text = extended_xyz(&snapshot)?;
                if has_cell {
                    text
                } else {
                    text.replacen(&cell_keys(&self.space, &self.bounds), "pbc=\"F F F\"", 1)
                }
            }
            PackingFormat::VtkXml => {
                let text = particles_vtp(&snapshot)?;
                let is_kept = |line: &&str| {
                    has_cell
                        || !["\"box\"", "\"periodic\"", "\"tilt\""]
                            .iter()
                            .any(|name| line.contains(name))
                };
                text.split_inclusive('\n').filter(is_kept).collect()
            }
            PackingFormat::LammpsData => {
                snapshot.check()?;
                self.lammps_data(&mut lost)
            }
            PackingFormat::Csv => {
                snapshot.check()?;
                if has_cell {
                    lost.push("the box with its periods");
                }
                self.table(",", "", "")
            }
            PackingFormat::Table => {
                snapshot.check()?;
                let cell = if has_cell {
                    format!("# {}\n", cell_keys(&self.space, &self.bounds))
                } else {
                    String::new()
                };
                self.table(" ", &cell, "# ")
            }
            _ => return Ok(None),
        };
        if self.frozen.is_some() {
            lost.push(
                "contacts with their forces, and walls, which only the folder of the run has",
            );
        }
        Ok(Some(WrittenPacking { text, lost }))
    }

    /// Whether the file or the run says a box.
    fn has_cell(&self) -> bool {
        self.has_box || self.space.lengths().iter().any(Option::is_some)
    }

    fn snapshot(&self) -> Snapshot<'_> {
        Snapshot {
            time: 0.0,
            space: self.space,
            extents: self.bounds,
            positions: &self.positions,
            radii: &self.radii,
            velocities: self.velocities.as_deref(),
            spins: self.spins.as_deref(),
            species: None,
            materials: self.materials.as_deref(),
            densities: self.densities.as_deref(),
            contacts: &self.contacts,
        }
    }

    fn lammps_data(&self, lost: &mut Vec<&'static str>) -> String {
        if self.densities.is_none() {
            lost.push("that the densities are not known: 1 is written for all");
        }
        if self.space.lengths().contains(&None) {
            lost.push("which axes repeat");
        }
        // Along open axes the box has to hold all spheres.
        let mut bounds = self.bounds;
        for (axis, ends) in bounds.iter_mut().enumerate() {
            if self.space.lengths()[axis].is_none() {
                let [low, high] = self.extent(axis);
                *ends = [ends[0].min(low), ends[1].max(high)];
            }
        }
        if self.has_box && bounds != self.bounds {
            lost.push("the ends of the box, which reaches around all spheres here");
        }
        let places: Vec<_> = self
            .positions
            .iter()
            .map(|place| self.space.wrap(place))
            .collect();
        let unknown = vec![UNKNOWN_DENSITY; self.radii.len()];
        sphere_data_file(&SphereRows {
            bounds,
            tilt: self.space.offset(),
            positions: &places,
            radii: &self.radii,
            materials: self.materials.as_deref(),
            densities: self.densities.as_deref().unwrap_or(&unknown),
            velocities: self.velocities.as_deref(),
            spins: self.spins.as_deref(),
        })
    }

    /// Rows of numbers under their names.
    fn table(&self, mark: &str, before: &str, comment: &str) -> String {
        let vectors = [self.velocities.as_ref(), self.spins.as_ref()];
        let names = SphereColumn::ALL.map(SphereColumn::name);
        let mut columns: Vec<&str> = names[..3].to_vec();
        columns.push(SphereColumn::Radius.name());
        let optional = [
            (self.densities.is_some(), SphereColumn::Density),
            (self.materials.is_some(), SphereColumn::Material),
        ];
        columns.extend(
            optional
                .iter()
                .filter(|(is, _)| *is)
                .map(|(_, column)| column.name()),
        );
        for (at, _) in vectors
            .iter()
            .enumerate()
            .filter(|(_, vectors)| vectors.is_some())
        {
            columns.extend(&names[3 * (at + 1)..3 * (at + 2)]);
        }
        let mut text = format!("{before}{comment}{}\n", columns.join(mark));
        for (sphere, (place, radius)) in self.positions.iter().zip(&self.radii).enumerate() {
            let place = self.space.wrap(place);
            let _ = write!(
                text,
                "{}{mark}{}{mark}{}{mark}{}",
                number(place.x),
                number(place.y),
                number(place.z),
                number(*radius)
            );
            if let Some(density) = self.densities.as_ref().and_then(|all| all.get(sphere)) {
                let _ = write!(text, "{mark}{}", number(*density));
            }
            if let Some(material) = self.materials.as_ref().and_then(|all| all.get(sphere)) {
                let _ = write!(text, "{mark}{material}");
            }
            for vector in vectors.iter().flatten().filter_map(|all| all.get(sphere)) {
                let _ = write!(
                    text,
                    "{mark}{}{mark}{}{mark}{}",
                    number(vector.x),
                    number(vector.y),
                    number(vector.z)
                );
            }
            text.push('\n');
        }
        text
    }
}
