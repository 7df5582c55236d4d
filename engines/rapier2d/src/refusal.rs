//! Floors that make no sense.

use core::fmt;

/// Why a value was refused.
///
/// ```
/// use rapier2d::prelude::*;
/// use tribos_rapier2d::{Floor, FloorError};
/// assert_eq!(Floor::new(-0.1, 9.81).err(), Some(FloorError::Coefficient { given: -0.1 }));
/// assert_eq!(Floor::new(0.1, -9.81).err(), Some(FloorError::Gravity { given: -9.81 }));
/// let mut floor = Floor::new(0.1, 9.81)?;
/// let puck = RigidBodyHandle::from_raw_parts(0, 0);
/// assert_eq!(floor.set_feet(puck, vec![]), Err(FloorError::NoFeet));
/// # Ok::<(), FloorError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum FloorError {
    /// The coefficient of friction is negative, infinite or NaN.
    Coefficient {
        /// The rejected value.
        given: f32,
    },
    /// The gravity towards the floor is negative, infinite or NaN.
    Gravity {
        /// The rejected value, in m/s².
        given: f32,
    },
    /// A load is negative, infinite or NaN.
    Load {
        /// The rejected value, in newtons.
        given: f32,
    },
    /// No foot was given. To free a body from friction, set its coefficient to 0.
    NoFeet,
    /// A foot's share of the load is not positive and finite, or its place is not finite.
    Foot {
        /// Which one, from 0 on.
        number: usize,
    },
}

/// Refuses what is negative or not a number.
pub(crate) fn not_negative(given: f32, error: FloorError) -> Result<f32, FloorError> {
    match given >= 0.0 && given.is_finite() {
        true => Ok(given),
        false => Err(error),
    }
}

impl fmt::Display for FloorError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Coefficient { given } => write!(
                f,
                "the coefficient of friction must be finite and not negative, not {given}"
            ),
            Self::Gravity { given } => write!(
                f,
                "the gravity towards the floor must be finite and not negative, not {given} m/s²"
            ),
            Self::Load { given } => {
                write!(f, "the load must be finite and not negative, not {given} N")
            }
            Self::NoFeet => f.write_str(
                "a body needs at least one foot; without friction it has the coefficient 0",
            ),
            Self::Foot { number } => write!(
                f,
                "foot {number} must have a positive share of the load and a finite place"
            ),
        }
    }
}

impl core::error::Error for FloorError {}
