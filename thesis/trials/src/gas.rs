//! A gas that cools by its collisions.

use super::{Method, PreparedTrial, Trial, TrialResult};
use anyhow::Result;
use tribos::gas::GasSimulation;
use tribos::run::run_to_end;
use tribos::scene::{GasMethod, GasScene};

/// A cooling gas: the mean temperature over some starts after so many collisions a sphere. The unit of stiffness is
/// T₀/R².
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cooling {
    /// Number of spheres.
    pub count: usize,
    /// Packing fraction.
    pub fraction: f64,
    /// Coefficient of restitution.
    pub restitution: f64,
    /// Collisions a sphere.
    pub collisions: f64,
    /// Seeds of the starts, from and number.
    pub seeds: [u64; 2],
    /// The temperature with which it is compared.
    pub reference: f64,
}

impl Cooling {
    /// Mean temperature of events from other starts.
    pub fn referred(self, seeds: [u64; 2]) -> Result<Self> {
        let found = Self { seeds, ..self }.measured(Method::Events)?();
        Ok(Self {
            reference: found?.errors[0],
            ..self
        })
    }

    fn scene(&self, method: Method, seed: u64) -> GasScene {
        let scene = GasScene {
            count: self.count,
            packing_fraction: self.fraction,
            restitution: self.restitution,
            collisions: self.collisions,
            sample_every: self.collisions,
            seed,
            ..GasScene::default()
        };
        match method {
            Method::Events => scene,
            Method::ContactDynamics { step, .. } => GasScene {
                method: GasMethod::ContactDynamics,
                max_displacement: step,
                ..scene
            },
            Method::Soft { stiffness, .. } => GasScene {
                method: GasMethod::Soft,
                stiffness,
                ..scene
            },
        }
    }

    /// The mean temperature and its standard error in place of errors.
    fn measured(&self, method: Method) -> Result<PreparedTrial> {
        let [from, number] = self.seeds;
        let gases = (from..from + number).map(|seed| GasSimulation::new(&self.scene(method, seed)));
        let mut gases = gases.collect::<Result<Vec<_>, _>>()?;
        let spheres = self.count as f64;
        Ok(Box::new(move || {
            let (mut temperatures, mut updates) = (Vec::new(), 0.0);
            for gas in &mut gases {
                run_to_end(gas, |_, _| ())?;
                temperatures.push(gas.outcome().temperature);
                updates += match method {
                    Method::Events => 0.5 * spheres * gas.collisions(),
                    _ => spheres * gas.steps() as f64,
                };
            }
            let number = temperatures.len() as f64;
            let mean = temperatures.iter().sum::<f64>() / number;
            let square = temperatures.iter().map(|t| (t - mean) * (t - mean));
            let scatter = (square.sum::<f64>() / (number * (number - 1.0).max(1.0))).sqrt();
            let errors = vec![mean, scatter];
            Ok(TrialResult { errors, updates })
        }))
    }
}

impl Trial for Cooling {
    fn quantities(&self) -> &'static [&'static str] {
        &["temperature [reference]", "its standard error [reference]"]
    }

    fn ready(&self, method: Method) -> Result<PreparedTrial> {
        let (measured, reference) = (self.measured(method)?, self.reference);
        Ok(Box::new(move || {
            let TrialResult { errors, updates } = measured()?;
            let errors = vec![(errors[0] / reference - 1.0).abs(), errors[1] / reference];
            Ok(TrialResult { errors, updates })
        }))
    }
}
