//! What columns and arrays of files say of spheres, by the names that programs give them: the one table of them.

/// A quantity of a sphere, one number.
///
/// ```
/// use tribos::measure::SphereColumn;
/// // A column of Lethe, one of a LAMMPS dump, one that ParaView wrote.
/// assert_eq!(SphereColumn::of("w_x"), Some(SphereColumn::SpinX));
/// assert_eq!(SphereColumn::of("diameters"), Some(SphereColumn::Diameter));
/// assert_eq!(SphereColumn::of("Velocity:2"), Some(SphereColumn::VelocityZ));
/// assert_eq!(SphereColumn::of("temperature"), None);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SphereColumn {
    /// Centre along x.
    X,
    /// Centre along y.
    Y,
    /// Centre along z.
    Z,
    /// Velocity along x.
    VelocityX,
    /// Velocity along y.
    VelocityY,
    /// Velocity along z.
    VelocityZ,
    /// Angular velocity about x.
    SpinX,
    /// Angular velocity about y.
    SpinY,
    /// Angular velocity about z.
    SpinZ,
    /// Radius.
    Radius,
    /// Diameter.
    Diameter,
    /// Density.
    Density,
    /// Mass.
    Mass,
    /// Number of the material.
    Material,
}

/// Names of the vectors that begin at a column, in small letters and digits alone, one text a vector; a component adds
/// x, y, z, or its number.
const VECTORS: [(usize, &str); 3] = [
    (
        0,
        "pos position positions points point coordinates centre center p",
    ),
    (
        3,
        "velocity vel velo velocities v linvelvec translationalvelocity linearvelocity",
    ),
    (
        6,
        "omega w angularvelocity angvel angvelvec angularvel rotationalvelocity spin angvelocity",
    ),
];

/// Names of the scalars, likewise.
const SCALARS: [(SphereColumn, &str); 8] = [
    (SphereColumn::X, "x"),
    (SphereColumn::Y, "y"),
    (SphereColumn::Z, "z"),
    (SphereColumn::Radius, "radius radii rad r particleradius"),
    (
        SphereColumn::Diameter,
        "diameter diameters diam d dp particlediameter",
    ),
    (
        SphereColumn::Density,
        "density densities rho particledensity",
    ),
    (SphereColumn::Mass, "mass masses m particlemass"),
    (
        SphereColumn::Material,
        "type types material materials mat matid materialid speciestype indspecies particletype",
    ),
];

/// Ends of the names of components: by letter, by number from 0 behind a colon, by number from 1 in brackets.
const COMPONENTS: [[&str; 3]; 5] = [
    ["x", "y", "z"],
    ["X", "Y", "Z"],
    [":0", ":1", ":2"],
    ["_0", "_1", "_2"],
    ["[1]", "[2]", "[3]"],
];

impl SphereColumn {
    /// All of them, in the order of their numbers: three places, velocities, spins, and the scalars.
    pub const ALL: [Self; 14] = [
        Self::X,
        Self::Y,
        Self::Z,
        Self::VelocityX,
        Self::VelocityY,
        Self::VelocityZ,
        Self::SpinX,
        Self::SpinY,
        Self::SpinZ,
        Self::Radius,
        Self::Diameter,
        Self::Density,
        Self::Mass,
        Self::Material,
    ];

    /// Its name in our own tables and messages.
    pub fn name(self) -> &'static str {
        match self {
            Self::X => "x",
            Self::Y => "y",
            Self::Z => "z",
            Self::VelocityX => "vx",
            Self::VelocityY => "vy",
            Self::VelocityZ => "vz",
            Self::SpinX => "wx",
            Self::SpinY => "wy",
            Self::SpinZ => "wz",
            Self::Radius => "radius",
            Self::Diameter => "diameter",
            Self::Density => "density",
            Self::Mass => "mass",
            Self::Material => "type",
        }
    }

    /// The quantity that a column of this name holds.
    pub fn of(name: &str) -> Option<Self> {
        if let Some(scalar) = Self::scalar(name) {
            return Some(scalar);
        }
        let name = name.trim();
        COMPONENTS.iter().find_map(|ends| {
            let (axis, stem) = ends
                .iter()
                .enumerate()
                .find_map(|(axis, end)| Some((axis, name.strip_suffix(end)?)))?;
            Self::ALL.get(Self::vector(stem)? + axis).copied()
        })
    }

    /// The scalar of this name.
    pub fn scalar(name: &str) -> Option<Self> {
        let plain = plain(name);
        let known = SCALARS.iter();
        let mut known = known.filter(|(_, names)| has(names, &plain));
        known.next().map(|(column, _)| *column)
    }

    /// Number of the first component of the vector of this name: 0 for places, 3 for velocities, 6 for angular velocities.
    pub fn vector(name: &str) -> Option<usize> {
        let plain = plain(name);
        let mut known = VECTORS.iter().filter(|(_, names)| has(names, &plain));
        known.next().map(|(first, _)| *first)
    }
}

/// Whether a name is among those of a text.
fn has(names: &str, wanted: &str) -> bool {
    names.split(' ').any(|name| name == wanted)
}

/// Small letters and digits of a name.
fn plain(name: &str) -> String {
    let letters = name.chars().filter(|letter| letter.is_alphanumeric());
    letters.collect::<String>().to_lowercase()
}
