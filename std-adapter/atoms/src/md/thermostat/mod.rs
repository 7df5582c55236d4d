//! Thermostats of groups of atoms.

mod langevin;
mod nose_hoover;

pub use langevin::{Langevin, Noise};
pub use nose_hoover::{NoseHoover, RotationBias};

/// The thermostat of a group. Temperatures are energies: k_B = 1.
///
/// ```
/// use tribos::md::thermostat::{Langevin, Thermostat, ThermostatError};
/// use tribos::md::group::Group;
/// assert_eq!(Group::default().thermostat, Thermostat::None);
/// let bath = Thermostat::Langevin(Langevin::new(0.1, 1.0)?);
/// let group = Group { thermostat: bath, ..Group::default() };
/// let refused = ThermostatError::Rate { what: "friction", given: -1.0 };
/// assert_eq!(Langevin::new(0.1, -1.0), Err(refused));
/// # Ok::<(), ThermostatError>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Thermostat {
    /// None.
    #[default]
    None,
    /// Nosé–Hoover: deterministic, with a conserved quantity.
    NoseHoover(NoseHoover),
    /// Langevin: friction and noise.
    Langevin(Langevin),
}

/// Invalid parameters of a thermostat.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum ThermostatError {
    /// The temperature is negative or not a number.
    #[error("the temperature of a thermostat must be finite and not negative, not {given}")]
    Temperature {
        /// The rejected value.
        given: f64,
    },
    /// The time or the rate is not positive.
    #[error("the {what} of a thermostat must be finite and positive, not {given}")]
    Rate {
        /// Name of the parameter: "relaxation time" or "friction".
        what: &'static str,
        /// The rejected value.
        given: f64,
    },
}

/// Refuses an invalid temperature and a `what` that is not positive.
fn check(temperature: f64, what: &'static str, given: f64) -> Result<(), ThermostatError> {
    if !temperature.is_finite() || temperature < 0.0 {
        let given = temperature;
        return Err(ThermostatError::Temperature { given });
    }
    if !given.is_finite() || given <= 0.0 {
        return Err(ThermostatError::Rate { what, given });
    }
    Ok(())
}
