//! Langevin dynamics: friction and the corresponding noise.

use super::{ThermostatError, check};
use nalgebra::Vector3;
use tribos_base::random::Random;

/// v' = … − γv + noise, exact over a step (Ornstein & Uhlenbeck 1930) in the middle of the drift
/// (the splitting "BAOAB" of Leimkuhler & Matthews 2013, whose positions have the right
/// distribution to fourth order in the step for a harmonic force).
///
/// ```
/// use tribos::md::thermostat::Langevin;
/// let bath = Langevin::new(0.7, 1.5)?; // T and γ
/// let [kept, noise] = bath.factors(0.2);
/// assert!((kept - (-1.5_f64 * 0.2).exp()).abs() < 1e-15);
/// // Friction takes as much as noise gives: a mean square velocity of T stays.
/// assert!((kept * kept * bath.temperature() + noise * noise - 0.7).abs() < 1e-15);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Langevin {
    temperature: f64,
    friction: f64,
}

impl Langevin {
    /// *Domain*: temperature ≥ 0, an energy; friction γ > 0, in 1/time.
    pub fn new(temperature: f64, friction: f64) -> Result<Self, ThermostatError> {
        check(temperature, "friction", friction)?;
        Ok(Self {
            temperature,
            friction,
        })
    }

    /// Target temperature.
    pub fn temperature(&self) -> f64 {
        self.temperature
    }

    /// Factors of the velocities, and of unit noise for an atom of mass 1, for a step `time`.
    pub fn factors(&self, time: f64) -> [f64; 2] {
        let kept = libm::exp(-self.friction * time);
        let lost = -libm::expm1(-2.0 * self.friction * time);
        [kept, (self.temperature * lost).sqrt()]
    }
}

/// Normally distributed numbers of one group in one step. They have no other state, so a run can
/// resume at any step.
///
/// ```
/// use tribos::md::thermostat::Noise;
/// let (seed, step, group) = (1, 40, 0);
/// let mut noise = Noise::new(seed, step, group);
/// let [_, _, third] = [(); 3].map(|()| noise.vector());
/// assert_eq!(third, Noise::new(seed, step, group).skip(2).vector());
/// // The squares of three normal numbers add up to 3 on average, with a variance of 6.
/// let n = 10_000;
/// let mean = (0..n).map(|_| noise.vector().norm_squared()).sum::<f64>() / f64::from(n);
/// assert!((mean - 3.0).abs() < 5.0 * (6.0 / f64::from(n)).sqrt());
/// ```
#[derive(Clone, Debug)]
pub struct Noise(Random);

impl Noise {
    /// The stream for a seed, a step and a group.
    pub fn new(seed: u64, step: u64, group: usize) -> Self {
        Self(Random::new(Random::new(seed, step).bits(), group as u64))
    }

    /// Three independent normal numbers (Box & Muller 1958), from four uniform ones.
    pub fn vector(&mut self) -> Vector3<f64> {
        let [x, y] = self.pair();
        let [z, _] = self.pair();
        Vector3::new(x, y, z)
    }

    /// This stream after some vectors.
    pub fn skip(mut self, vectors: usize) -> Self {
        self.0.skip(4 * vectors as u64);
        self
    }

    fn pair(&mut self) -> [f64; 2] {
        // 1 − u is never 0.
        let radius = (-2.0 * libm::log(1.0 - self.0.unit())).sqrt();
        let (sin, cos) = libm::sincos(std::f64::consts::TAU * self.0.unit());
        [radius * cos, radius * sin]
    }
}
