//! Formats of files of spheres: how they are recognised, and what each can hold.

use super::{mercury, programs};
use std::path::Path;
use tribos_base::exchange::configuration::is_lammps_data;

/// A format of a file or folder of spheres.
///
/// ```
/// use tribos::measure::PackingFormat;
/// assert_eq!(PackingFormat::of(b"ITEM: TIMESTEP\n0\n"), PackingFormat::LammpsDump);
/// assert_eq!(PackingFormat::of(b"#format x_y_z_r\n0 0 0 1\n"), PackingFormat::Table);
/// assert_eq!(PackingFormat::written_as("out/a.vtp".as_ref()), Some(PackingFormat::VtkXml));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PackingFormat {
    /// A state or a checkpoint of a run of Tribos.
    State,
    /// Extended XYZ, as OVITO and ASE write it.
    ExtendedXyz,
    /// Plain XYZ: a number, a line of text, an element and numbers in each row.
    PlainXyz,
    /// A table between blanks.
    Table,
    /// A table between commas or semicolons.
    Csv,
    /// Data of LAMMPS and LIGGGHTS, `atom_style sphere`.
    LammpsData,
    /// Text dump of LAMMPS and LIGGGHTS.
    LammpsDump,
    /// VTK PolyData (.vtp) or UnstructuredGrid (.vtu).
    VtkXml,
    /// Legacy file of VTK (.vtk).
    VtkLegacy,
    /// States of MercuryDPM (.data).
    MercuryData,
    /// A restart of MercuryDPM (.restart).
    MercuryRestart,
    /// A geometry of ESyS-Particle (.geo).
    LsmGeometry,
    /// A model part of Kratos (.mdpa).
    KratosModelPart,
    /// An export of MUSEN as text.
    MusenText,
}

/// Formats that are written, by the endings of files.
const WRITTEN: [(&str, PackingFormat); 9] = [
    ("xyz", PackingFormat::ExtendedXyz),
    ("extxyz", PackingFormat::ExtendedXyz),
    ("vtp", PackingFormat::VtkXml),
    ("data", PackingFormat::LammpsData),
    ("lmp", PackingFormat::LammpsData),
    ("csv", PackingFormat::Csv),
    ("txt", PackingFormat::Table),
    ("dat", PackingFormat::Table),
    ("spheres", PackingFormat::Table),
];

impl PackingFormat {
    /// Its name for people.
    pub fn name(self) -> &'static str {
        match self {
            Self::State => "state of a run",
            Self::ExtendedXyz => "extended XYZ",
            Self::PlainXyz => "plain XYZ",
            Self::Table => "table between blanks",
            Self::Csv => "CSV",
            Self::LammpsData => "LAMMPS data",
            Self::LammpsDump => "LAMMPS dump",
            Self::VtkXml => "VTK XML",
            Self::VtkLegacy => "VTK legacy",
            Self::MercuryData => "MercuryDPM data",
            Self::MercuryRestart => "MercuryDPM restart",
            Self::LsmGeometry => "ESyS-Particle geometry",
            Self::KratosModelPart => "Kratos model part",
            Self::MusenText => "MUSEN text",
        }
    }

    /// Whether names of columns or arrays, or their order, may be given.
    pub(super) fn takes_columns(self) -> bool {
        matches!(
            self,
            Self::PlainXyz | Self::Table | Self::Csv | Self::VtkXml | Self::VtkLegacy
        )
    }

    /// The format in which a file of this name is written.
    pub fn written_as(path: &Path) -> Option<Self> {
        let ending = path.extension()?.to_str()?;
        let mut known = WRITTEN
            .iter()
            .filter(|(name, _)| name.eq_ignore_ascii_case(ending));
        known.next().map(|(_, format)| *format)
    }

    /// The format of a file with these bytes; what is none of the others is taken for a table.
    pub fn of(bytes: &[u8]) -> Self {
        match bytes.iter().find(|byte| !byte.is_ascii_whitespace()) {
            Some(b'{') => return Self::State,
            Some(b'<') => return Self::VtkXml,
            _ => {}
        }
        if bytes.starts_with(b"# vtk DataFile") {
            return Self::VtkLegacy;
        }
        // A text up to its first byte that is none.
        let valid = bytes.utf8_chunks().next().map_or("", |chunk| chunk.valid());
        let text = valid.trim_start();
        let mut lines = text.lines().skip_while(|line| line.starts_with("//"));
        let (first, second) = (
            lines.next().unwrap_or_default().trim(),
            lines.next().unwrap_or_default(),
        );
        let begins = |words: &[&str]| words.iter().any(|word| first.starts_with(word));
        let is_counted = first.parse::<u64>().is_ok();
        if begins(&["ITEM:"]) {
            Self::LammpsDump
        } else if begins(&["LSMGeometry"]) {
            Self::LsmGeometry
        } else if begins(&["MercuryDPM", "restart_version"]) {
            Self::MercuryRestart
        } else if begins(&["Begin ModelPartData", "Begin Properties", "Begin Nodes"]) {
            Self::KratosModelPart
        } else if is_lammps_data(text) {
            Self::LammpsData
        } else if is_counted && second.to_ascii_lowercase().contains("properties=") {
            Self::ExtendedXyz
        } else if is_counted {
            Self::PlainXyz
        } else if mercury::is_data(text) {
            Self::MercuryData
        } else if programs::is_export(text) {
            Self::MusenText
        } else {
            let is_content = |line: &&str| !line.trim().is_empty() && !line.starts_with('#');
            let row = text.lines().find(is_content).unwrap_or_default();
            if row.contains([',', ';']) {
                Self::Csv
            } else {
                Self::Table
            }
        }
    }
}
