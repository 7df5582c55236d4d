//! The thermostat of Nosé (1984) and Hoover (1985).

use super::{ThermostatError, check};

/// Whether the common rotation of a group about the vertical counts as heat.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum RotationBias {
    /// All motion is heat.
    #[default]
    Counts,
    /// The mean rotation about this vertical axis is not thermostatted: only deviations from it are heat.
    Spared {
        /// x and y of the axis.
        axis: [f64; 2],
    },
}

/// A friction ξ that follows the kinetic energy: Q ξ' = 2K − gT, v' = … − ξv.
///
/// Half steps by Suzuki–Trotter splitting (Martyna, Tuckerman, Tobias & Klein 1996), reversible in
/// time. E + Qξ²/2 + gTη with η' = ξ is conserved as accurately as the energy without thermostat.
///
/// ```
/// use tribos::md::thermostat::{NoseHoover, RotationBias};
/// let mut bath = NoseHoover::new(0.1, 0.5, RotationBias::Counts)?;
/// assert_eq!(bath.spin(), RotationBias::Counts);
/// let (freedoms, kinetic) = (300.0, 30.0);
/// assert!(2.0 * kinetic > freedoms * bath.temperature()); // too hot
/// let start = bath.state();
/// let factor = bath.scale(kinetic, freedoms, 0.005);
/// // What motion loses, here 0.003, the thermostat keeps.
/// let rest = kinetic * factor * factor;
/// assert!(rest < 29.998 && (rest + bath.energy(freedoms) - kinetic).abs() < 1e-6);
/// // Time runs back: velocities, ξ and η as at the start.
/// let back = bath.scale(rest, freedoms, -0.005);
/// assert!((factor * back - 1.0).abs() < 1e-15);
/// assert!(bath.state().iter().all(|number| number.abs() < 1e-15));
/// bath.restore(start); // to the bit
/// assert_eq!(bath.state(), [0.0; 2]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NoseHoover {
    temperature: f64,
    relaxation: f64,
    spin: RotationBias,
    friction: f64,
    position: f64,
}

impl NoseHoover {
    /// A thermostat at `temperature` with the time constant `relaxation`: Q = gT·relaxation². At T
    /// = 0 it does nothing.
    pub fn new(
        temperature: f64,
        relaxation: f64,
        spin: RotationBias,
    ) -> Result<Self, ThermostatError> {
        check(temperature, "relaxation time", relaxation)?;
        Ok(Self {
            temperature,
            relaxation,
            spin,
            friction: 0.0,
            position: 0.0,
        })
    }

    /// Target temperature.
    pub fn temperature(&self) -> f64 {
        self.temperature
    }

    /// Whether the rotation counts as heat.
    pub fn spin(&self) -> RotationBias {
        self.spin
    }

    /// ξ and η, the state that a checkpoint stores.
    pub fn state(&self) -> [f64; 2] {
        [self.friction, self.position]
    }

    /// Restores ξ and η.
    pub fn restore(&mut self, [friction, position]: [f64; 2]) {
        (self.friction, self.position) = (friction, position);
    }

    /// Advances ξ and η by `time`; returns the factor for all velocities of a group with this
    /// kinetic energy and number of freedoms.
    pub fn scale(&mut self, kinetic: f64, freedoms: f64, time: f64) -> f64 {
        let inertia = freedoms * self.temperature * self.relaxation * self.relaxation;
        if inertia <= 0.0 {
            return 1.0;
        }
        let excess = |kinetic: f64| (2.0 * kinetic - freedoms * self.temperature) / inertia;
        let middle = self.friction + 0.5 * time * excess(kinetic);
        let factor = libm::exp(-middle * time);
        self.position += middle * time;
        self.friction = middle + 0.5 * time * excess(kinetic * factor * factor);
        factor
    }

    /// Energy of the thermostat, Qξ²/2 + gTη.
    pub fn energy(&self, freedoms: f64) -> f64 {
        let heat = freedoms * self.temperature;
        let speed = self.friction * self.relaxation;
        heat * (0.5 * speed * speed + self.position)
    }
}
