//! Sliding bodies.

mod any_law;
mod cost;
#[doc(hidden)]
pub mod curling;
mod friction_work;
pub mod inverse;
mod outcome;
mod path;
pub mod planar;
pub(crate) mod scene;
mod simulation;

use any_law::run_law;
#[doc(hidden)]
pub use cost::EvaluationCost;
pub(crate) use cost::of_law;
#[doc(hidden)]
pub use friction_work::FrictionWork;
use outcome::COLUMNS;
pub use outcome::{SlideStopReason, SlideSummary};
pub use path::PlanarSummary;
#[doc(hidden)]
pub use path::{PlanarCourse, PlanarScene, follow_path};
#[doc(hidden)]
pub use simulation::SlideSimulation;

pub use crate::error::MotionError;
use crate::motion_run::SceneRun;
use crate::slide::scene::DiskScene;
use tribos_base::run::run_to_end;
use tribos_friction::{FrictionError, Law, Patch, RoundPower, Tier, Visitor, visit_disk};

/// Initial velocity of the centre and initial spin, in m/s and rad/s.
///
/// ```
/// use tribos::slide::inverse::{Launch, RestMap};
/// use tribos::kernel::coupling::coulomb::CoulombDisk;
/// let disk = RestMap::new(CoulombDisk, 0.3 * 9.81, 0.08, 0.5)?; // mu g, R, C = I/(M R^2)
/// let throw = Launch { velocity: [1.0, 0.0], spin: 12.5 };
/// let mirrored = Launch { spin: -12.5, ..throw };
/// let [left, right] = [throw, mirrored].map(|launch| disk.rest(&launch).pose);
/// assert_eq!([left.x, left.y, left.angle], [right.x, right.y, -right.angle]);
/// # Ok::<(), tribos::slide::inverse::MotionError>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Launch {
    /// Components of the velocity.
    pub velocity: [f64; 2],
    /// Spin; positive turns the first axis towards the second.
    pub spin: f64,
}

/// The kinetic energy of a launch, if both of its shares are positive numbers.
fn energy_at_launch(energy: f64) -> Result<f64, MotionError> {
    if energy.is_finite() && energy >= f64::MIN_POSITIVE {
        Ok(energy)
    } else {
        Err(MotionError::Energy { energy })
    }
}

/// The run of a scene, with these [`COLUMNS`].
type SlideRun = SceneRun<SlideSummary, { COLUMNS.len() }>;

/// Runs a scene; `progress` receives the completed fraction after every step.
pub(crate) fn follow(
    scene: &DiskScene,
    progress: impl FnMut(f64),
) -> Result<SlideRun, MotionError> {
    if let Some(law) = &scene.law {
        return run_law(scene, law, progress);
    }
    let tier = Tier::choose::<f64>(&Patch::Disk, &scene.law()?, None)?;
    visit_disk(scene.alpha, tier, Run { scene, progress })?
}

/// Runs a scene with the kernel's type for its friction.
struct Run<'a, F> {
    scene: &'a DiskScene,
    progress: F,
}

impl<F: FnMut(f64)> Visitor<f64> for Run<'_, F> {
    type Output = Result<SlideRun, MotionError>;

    fn visit<P: RoundPower<f64> + 'static>(mut self, profile: P) -> Self::Output {
        let mut simulation = SlideSimulation::new(profile, self.scene)?;
        let mut rows = Vec::new();
        run_to_end(&mut simulation, |row, done| {
            rows.push(row);
            (self.progress)(done);
        })?;
        Ok(SceneRun {
            columns: &COLUMNS,
            rows,
            outcome: simulation.outcome()?,
        })
    }
}

impl DiskScene {
    /// Runs the scene to its end.
    ///
    /// *Columns* of the series: SI units in SI scenes (s, m/s, rad/s, m, rad, -, J, J).
    ///
    /// *Accuracy* under a law that is no power of the speed: 1e-8, that of the law's quadrature. A law with a state
    /// (bristles, ages) acts in its steady form, because on a patch that slides and spins the state differs from
    /// point to point.
    ///
    /// ```
    /// use tribos::{run::SceneRun, scene::DiskScene};
    /// let scene = DiskScene { speed: 1.0, spin: 0.0, gamma: 0.3, ..DiskScene::default() };
    /// let SceneRun { rows, outcome, .. } = scene.run()?;
    /// assert!((outcome.distance - 1.0 / (2.0 * 0.3 * 9.81)).abs() < 1e-13);
    /// // On oil: dv/dt = -g (mu + k v), which ends after ln(1 + k v0/mu)/(g k).
    /// let law = Some("stribeck:mu_s=0.2,mu_d=0.2,vs=0.01,k=0.1".parse()?); // s/m
    /// let oiled = DiskScene { gravity: 10.0, law, ..scene };
    /// assert!((oiled.run()?.outcome.end_time - 1.5_f64.ln()).abs() < 1e-8);
    /// for [.., kinetic, dissipated] in rows {
    ///     let sum = kinetic + dissipated; // stays what it was at the launch
    ///     assert!((sum - outcome.initial_energy).abs() < 1e-9 * outcome.initial_energy);
    /// }
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn run(&self) -> Result<SlideRun, MotionError> {
        follow(self, |_| ())
    }

    /// Friction law of the scene.
    pub(crate) fn law(&self) -> Result<Law, FrictionError> {
        self.law
            .map_or_else(|| Law::power(self.gamma, self.alpha), Ok)
    }
}
