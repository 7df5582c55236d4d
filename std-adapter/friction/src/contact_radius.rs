//! The radius of a contact: a number, or what makes it of the load.

use super::catalogue::{LawParameter, needed, optional};
use super::law::read;
use super::{FrictionError, finite_number};
use std::str::FromStr;
use tribos_core::patch::elastic::{AdhesiveSphere, HertzSphere, LoadedRadius, SoftFinger};

/// The radius of a round patch in m, as it is written: `0.006`, or from the load, such as `hertz:modulus=1e6,radius=0.01`.
///
/// ```
/// use tribos::friction::ContactRadius;
/// use tribos::kernel::patch::elastic::LoadedRadius;
/// let ball: ContactRadius = "hertz:modulus=1e6,radius=0.01".parse()?; // E* in Pa, m
/// assert!((ball.radius(4.0 / 3.0) - 1e-8_f64.cbrt()).abs() < 1e-17); // N; m
/// let finger: ContactRadius = "finger:scale=4e-3,exponent=0.25".parse()?;
/// assert_eq!(finger.at(16.0)?, 8e-3);
/// assert!(finger.at(-1.0).is_err() && finger.growth(16.0) == 0.25);
/// assert_eq!("0.006".parse(), Ok(ContactRadius::Given(0.006)));
/// # Ok::<(), tribos::friction::FrictionError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ContactRadius {
    /// The same under every load.
    Given(f64),
    /// Of elastic spheres.
    Hertz(HertzSphere<f64>),
    /// Of elastic spheres that stick (Johnson, Kendall, Roberts).
    Adhesive(AdhesiveSphere<f64>),
    /// A power of the load.
    Finger(SoftFinger<f64>),
}

const MODULUS: LawParameter = needed(
    "modulus",
    "Pa",
    "effective modulus E*, 1/E* = (1-nu1^2)/E1 + (1-nu2^2)/E2",
);
const RADIUS: LawParameter = needed(
    "radius",
    "m",
    "radius of the sphere, of two R1 R2/(R1 + R2)",
);
const WORK: LawParameter = needed("work", "J/m^2", "work of adhesion");
const SCALE: LawParameter = needed("scale", "m/N^exponent", "radius under 1 N");
const EXPONENT: LawParameter = optional("exponent", "-", "from 0 to 1/3", 1.0 / 3.0);

impl ContactRadius {
    /// How a radius is written, and what it is.
    pub const SYNTAX: [(&str, &str); 4] = [
        ("R", "the radius in m"),
        (
            "hertz:modulus=E,radius=R",
            "an elastic sphere of radius R [m], E the effective modulus [Pa]",
        ),
        (
            "jkr:modulus=E,radius=R,work=W",
            "the same with the work of adhesion W [J/m^2]",
        ),
        (
            "finger:scale=C,exponent=G",
            "a soft finger, C N^G [m] with G from 0 to 1/3",
        ),
    ];

    /// The radius in m under a load in N. *Errors*: there is no contact.
    pub fn at(&self, load: f64) -> Result<f64, FrictionError> {
        let radius = self.radius(load);
        if radius > 0.0 && radius.is_finite() {
            return Ok(radius);
        }
        Err(FrictionError::Unserved(format!(
            "under a load of {load} N there is no contact: its radius would be {radius} m"
        )))
    }

    /// The elastic ones; a plain number is the same under every load.
    fn loaded(&self) -> Option<&dyn LoadedRadius<f64>> {
        match self {
            Self::Given(_) => None,
            Self::Hertz(sphere) => Some(sphere),
            Self::Adhesive(sphere) => Some(sphere),
            Self::Finger(finger) => Some(finger),
        }
    }
}

impl LoadedRadius<f64> for ContactRadius {
    fn radius(&self, load: f64) -> f64 {
        match self {
            Self::Given(radius) => *radius,
            _ => self.loaded().map_or(0.0, |area| area.radius(load)),
        }
    }

    fn slope(&self, load: f64) -> f64 {
        self.loaded().map_or(0.0, |area| area.slope(load))
    }

    fn growth(&self, load: f64) -> f64 {
        self.loaded().map_or(0.0, |area| area.growth(load))
    }
}

impl FromStr for ContactRadius {
    type Err = FrictionError;

    fn from_str(text: &str) -> Result<Self, FrictionError> {
        let known = ["hertz", "jkr", "finger"];
        let alone = known.contains(&text.trim()).then_some((text, ""));
        let Some((name, list)) = text.split_once(':').or(alone) else {
            let radius = finite_number(text).map_err(FrictionError::Syntax)?;
            return match radius > 0.0 {
                true => Ok(Self::Given(radius)),
                false => Err(FrictionError::Syntax("give a number > 0".into())),
            };
        };
        match name.trim() {
            "hertz" => {
                let [modulus, radius] = read("hertz", &[MODULUS, RADIUS], list)?;
                Ok(Self::Hertz(HertzSphere::new(modulus, radius)?))
            }
            "jkr" => {
                let [modulus, radius, work] = read("jkr", &[MODULUS, RADIUS, WORK], list)?;
                Ok(Self::Adhesive(AdhesiveSphere::new(modulus, radius, work)?))
            }
            "finger" => {
                let [scale, exponent] = read("finger", &[SCALE, EXPONENT], list)?;
                Ok(Self::Finger(SoftFinger::new(scale, exponent)?))
            }
            _ => {
                let list = Self::SYNTAX.map(|(syntax, _)| syntax).join(", ");
                Err(FrictionError::unknown("radius", text, known, list))
            }
        }
    }
}
