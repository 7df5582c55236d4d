//! Contact patches by name.

use crate::failure::Failure;
use std::str::FromStr;
use tribos_core::coupling::closed::{FlatPunch, Hertz, Ring};
use tribos_core::coupling::round::RoundTable64;
use tribos_core::coupling::table::{Coulomb, Table64};
use tribos_core::coupling::{Annulus, Coupling, Profile};
use tribos_core::law::LawError;
use tribos_core::patch::{PatchError, PowerPressure};

/// A law on a patch, whatever its type.
pub trait Law: Profile<f64> + Coupling<f64> {}

impl<P: Profile<f64> + Coupling<f64>> Law for P {}

/// How the contact carries the load.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum PatchName {
    /// The same pressure everywhere.
    Disk,
    /// All load on the rim.
    Ring,
    /// The same pressure from `inner` radii to the rim.
    Annulus {
        /// Inner over outer radius.
        inner: f64,
    },
    /// Elastic spheres.
    Hertz,
    /// A rigid flat punch on an elastic ground.
    Punch,
    /// Pressure 1 - r^2.
    Paraboloid,
}

/// What `--patch` accepts.
pub const PATCHES: &str = "disk, ring, annulus:INNER (inner over outer radius), hertz, punch or \
                           paraboloid";

impl FromStr for PatchName {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let (name, number) = match text.split_once(':') {
            Some((name, number)) => (name, Some(number)),
            None => (text, None),
        };
        let plain = |patch| match number {
            None => Ok(patch),
            Some(_) => Err(format!("`{name}` takes no number; give {name}")),
        };
        match name.trim() {
            "disk" => plain(Self::Disk),
            "ring" => plain(Self::Ring),
            "hertz" => plain(Self::Hertz),
            "punch" => plain(Self::Punch),
            "paraboloid" => plain(Self::Paraboloid),
            "annulus" => annulus(number),
            _ => Err(format!("give {PATCHES}")),
        }
    }
}

/// An annulus with its inner radius.
fn annulus(number: Option<&str>) -> Result<PatchName, String> {
    let most = Annulus::<f64, Coulomb>::MAX_INNER_RATIO;
    let inner = number.and_then(|text| text.trim().parse::<f64>().ok());
    match inner {
        Some(inner) if (0.0..=most).contains(&inner) => Ok(PatchName::Annulus { inner }),
        _ => Err(format!(
            "give annulus:INNER with the inner over the outer radius from 0 to {most}, such as \
             annulus:0.5; a thinner one is a ring"
        )),
    }
}

impl PatchName {
    /// The law |v|^`alpha` on this patch: closed forms where there are, else tables.
    pub fn law(self, alpha: f64) -> Result<Box<dyn Law>, Failure> {
        let round = |pressure| -> Result<Box<dyn Law>, Failure> {
            Ok(Box::new(table(alpha, RoundTable64::new(alpha, pressure))?))
        };
        let dry = alpha == 0.0;
        Ok(match self {
            Self::Disk if dry => Box::new(Coulomb),
            Self::Disk => Box::new(table(alpha, Table64::new(alpha))?),
            Self::Annulus { inner } if dry => Box::new(band(Annulus::new(Coulomb, inner))?),
            Self::Annulus { inner } => {
                let disk = table(alpha, Table64::new(alpha))?;
                Box::new(band(Annulus::new(disk, inner))?)
            }
            Self::Ring if dry => Box::new(Ring),
            Self::Hertz if dry => Box::new(Hertz),
            Self::Punch if dry => Box::new(FlatPunch),
            Self::Ring => round(PowerPressure::RING)?,
            Self::Hertz => round(PowerPressure::HERTZ)?,
            Self::Punch => round(PowerPressure::FLAT_PUNCH)?,
            Self::Paraboloid => round(PowerPressure::PARABOLOID)?,
        })
    }
}

fn table<T>(alpha: f64, built: Result<T, LawError>) -> Result<T, Failure> {
    built.map_err(|error| Failure::input(format!("--alpha {alpha}: {error}")))
}

fn band<T>(built: Result<T, PatchError>) -> Result<T, Failure> {
    built.map_err(|error| Failure::input(format!("--patch annulus: {error}")))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_read_and_mistakes_named() {
        assert_eq!("disk".parse(), Ok(PatchName::Disk));
        assert_eq!("annulus:0.5".parse(), Ok(PatchName::Annulus { inner: 0.5 }));
        for bad in [
            "annulus",
            "annulus:",
            "annulus:1",
            "annulus:-0.1",
            "annulus:nan",
        ] {
            let error = bad.parse::<PatchName>().unwrap_err();
            assert!(error.contains("annulus:INNER"), "{bad}: {error}");
        }
        assert!(
            "ring:2"
                .parse::<PatchName>()
                .unwrap_err()
                .contains("no number")
        );
        assert!(
            "square"
                .parse::<PatchName>()
                .unwrap_err()
                .contains("paraboloid")
        );
    }

    #[test]
    fn every_patch_serves_every_law() {
        let patches = [
            PatchName::Disk,
            PatchName::Ring,
            PatchName::Annulus { inner: 0.5 },
            PatchName::Hertz,
            PatchName::Punch,
            PatchName::Paraboloid,
        ];
        for patch in patches {
            for alpha in [0.0, 0.5] {
                let law = patch.law(alpha).expect("a valid law");
                // A pure slide feels the speed's power on every patch.
                let force = law.reduced_wrench(4.0, 0.0).force;
                assert!((force - 4.0_f64.powf(alpha)).abs() < 1e-13, "{patch:?}");
            }
        }
        assert!(PatchName::Hertz.law(20.0).is_err());
    }
}
