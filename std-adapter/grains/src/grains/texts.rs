//! Texts of a scene: types of grains, and points.

use crate::packing::SettingError;
use nalgebra::Vector3;
use std::fmt;
use std::str::FromStr;
use tribos_base::scene::entries::Written;
use tribos_base::scene::key::{Domain, Form, reads};
use tribos_base::scene::table::Setting;

/// Types of grains, from 1 to 9, as `initial_state` numbers them.
///
/// ```
/// use tribos::grains::GrainTypes;
/// let types: GrainTypes = "2, 3".parse()?;
/// assert_eq!([1, 2, 3].map(|kind| types.has(kind)), [false, true, true]);
/// assert!("0".parse::<GrainTypes>().is_err());
/// # Ok::<(), tribos::scene::SettingError>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct GrainTypes(u16);

/// Largest number of a type.
const LARGEST: u8 = 9;

impl GrainTypes {
    /// One type. *Domain*: 1 to 9.
    pub(super) const fn one(kind: u8) -> Self {
        Self(1 << kind)
    }

    /// These types and others.
    pub(super) const fn and(self, others: Self) -> Self {
        Self(self.0 | others.0)
    }

    /// Whether a type is among them.
    pub fn has(&self, kind: u8) -> bool {
        kind <= LARGEST && self.0 & (1 << kind) != 0
    }
}

impl fmt::Display for GrainTypes {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let all = (1..=LARGEST).filter(|kind| self.has(*kind));
        let all: Vec<_> = all.map(|kind| kind.to_string()).collect();
        f.write_str(&all.join(", "))
    }
}

impl FromStr for GrainTypes {
    type Err = SettingError;

    fn from_str(text: &str) -> Result<Self, SettingError> {
        let kind = |word: &str| {
            word.trim()
                .parse()
                .ok()
                .filter(|kind| (1..=LARGEST).contains(kind))
        };
        let add = |all: u16, word: &str| Some(all | (1 << kind(word)?));
        let all = text.split(',').try_fold(0, add);
        all.map(Self)
            .ok_or_else(|| SettingError::Types(text.into()))
    }
}

/// Types of grains, or the number of one.
pub(super) const TYPES: Domain = Domain::Form(&Form {
    name: "types",
    valid: "types such as \"2, 3\"",
    read: reads::<GrainTypes>,
    numbers: Some(&Domain::Count {
        from: 1.0,
        up_to: LARGEST as f64,
    }),
    names_absence: true,
});

impl Setting for GrainTypes {
    fn written(&self) -> Written {
        Written::Text(self.to_string())
    }

    fn read(written: &Written) -> Option<Self> {
        match written {
            Written::Number(kind) => kind.to_string().parse().ok(),
            _ => written.text()?.parse().ok(),
        }
    }
}

/// A point or a vector, as the text of its three coordinates.
///
/// ```
/// use tribos::grains::Coordinates;
/// let up: Coordinates = "0, 0, 1.5".parse()?;
/// assert_eq!(up, Coordinates([0.0, 0.0, 1.5]));
/// assert_eq!(up.to_string(), "0, 0, 1.5");
/// assert!("0, 1".parse::<Coordinates>().is_err());
/// # Ok::<(), tribos::scene::SettingError>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Coordinates(pub [f64; 3]);

impl Coordinates {
    /// The unit vector along them; zero if they are.
    pub(super) fn direction(self) -> Vector3<f64> {
        let along = Vector3::from(self.0);
        let scaled = along / along.amax().max(f64::MIN_POSITIVE);
        scaled.try_normalize(0.0).unwrap_or_default()
    }
}

impl fmt::Display for Coordinates {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [x, y, z] = self.0;
        write!(f, "{x}, {y}, {z}")
    }
}

impl FromStr for Coordinates {
    type Err = SettingError;

    fn from_str(text: &str) -> Result<Self, SettingError> {
        let number = |word: &str| word.trim().parse().ok().filter(|x: &f64| x.is_finite());
        let numbers: Option<Vec<f64>> = text.split(',').map(number).collect();
        let three = numbers.and_then(|numbers| <[f64; 3]>::try_from(numbers).ok());
        three
            .map(Self)
            .ok_or_else(|| SettingError::Coordinates(text.into()))
    }
}

/// Three coordinates.
pub(super) const COORDINATES: Domain = Domain::Form(&Form {
    name: "coordinates",
    valid: "three numbers such as \"0, 0, 0.1\"",
    read: reads::<Coordinates>,
    numbers: None,
    names_absence: true,
});

impl Setting for Coordinates {
    fn written(&self) -> Written {
        Written::Text(self.to_string())
    }

    fn read(written: &Written) -> Option<Self> {
        written.text()?.parse().ok()
    }
}
