//! A deposit under a piston.

use super::{Method, PreparedTrial, Trial, TrialResult};
use anyhow::{Result, bail};
use tribos::powder::PowderSimulation;
use tribos::run::run_to_end;
use tribos::scene::{ContactMethod, PowderScene};

/// A cohesive deposit that is compacted until it is blocked. The unit of stiffness is `F_coh`/R.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Compacted {
    /// Width and height of the deposit, in R.
    pub size: [f64; 2],
    /// Pressure of the piston, in `F_coh`/R².
    pub pressure: f64,
}

impl Trial for Compacted {
    fn quantities(&self) -> &'static [&'static str] {
        &["deepest overlap [R]", "porosity (no error)"]
    }

    fn ready(&self, method: Method) -> Result<PreparedTrial> {
        let [width, height] = self.size;
        let scene = PowderScene {
            width,
            height,
            pressure: self.pressure,
            ..PowderScene::default()
        };
        let scene = match method {
            Method::Events => bail!("events know no lasting contacts"),
            Method::ContactDynamics {
                tolerance, sweeps, ..
            } => PowderScene {
                tolerance,
                max_iterations: sweeps,
                ..scene
            },
            Method::Soft { stiffness, .. } => PowderScene {
                method: ContactMethod::Soft,
                stiffness,
                ..scene
            },
        };
        let mut compaction = PowderSimulation::new(&scene)?;
        Ok(Box::new(move || {
            run_to_end(&mut compaction, |_, _| ())?;
            let outcome = compaction.outcome();
            Ok(TrialResult {
                errors: vec![outcome.max_overlap, outcome.porosity_final],
                updates: outcome.steps as f64,
            })
        }))
    }
}
