//! Sliding bodies.

mod any_law;
mod cost;
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
pub use outcome::{COLUMNS, SlideStopReason, SlideSummary};
#[doc(hidden)]
pub use path::{PATH_COLUMNS, PlanarCourse, PlanarScene, follow_path};
pub use path::{PathRun, PlanarSummary, run_planar};
#[doc(hidden)]
pub use simulation::SlideSimulation;

use crate::slide::scene::DiskScene;
use tribos_base::record::brief;
use tribos_base::run::run_to_end;
use tribos_base::scene::InvalidScene;
use tribos_core::law::LawError;
use tribos_core::patch::PatchError;
use tribos_friction::{FrictionError, Law, Patch, RoundPower, Tier, Visitor, visit_disk};

/// Why a validated scene could not be run to its end.
///
/// ```
/// use tribos::scene::DiskScene;
/// use tribos::slide::{SlideError, run};
/// // A disk that is at rest after 0.4 s.
/// let scene = DiskScene { time_step: Some(1e-12), ..DiskScene::default() };
/// assert!(matches!(run(&scene, |_| ()), Err(SlideError::TooManySteps { .. })));
/// ```
#[derive(Debug, thiserror::Error)]
pub enum SlideError {
    /// A field of the scene is wrong.
    #[error(transparent)]
    Scene(#[from] InvalidScene),
    /// The time step is so short that the run would need too many steps.
    #[error(
        "a time_step of {time_step} s needs {steps:.3e} steps, more than {most:.0e}; \
         use at least {at_least:.1e} s"
    )]
    TooManySteps {
        /// Requested time step.
        time_step: f64,
        /// Number of steps it would need.
        steps: f64,
        /// Largest number of steps allowed.
        most: f64,
        /// Shortest time step allowed.
        at_least: f64,
    },
    /// Whoever asked for the run ended it.
    #[error("interrupted after {steps} steps")]
    Interrupted {
        /// Number of steps taken.
        steps: u64,
    },
    /// A number left the range of f64, or the time no longer advances.
    #[error("the motion is no longer finite after step {step}; its scales are too far apart")]
    NotFinite {
        /// Number of the step.
        step: u64,
    },
    /// The kinetic energy of the launch, or one of its two shares, is not a positive f64.
    #[error(
        "the launch has a kinetic energy of {} J, outside the range of numbers; bring \
         `speed`, `spin`, `radius` and `mass` nearer to 1",
        brief(.energy)
    )]
    Energy {
        /// Kinetic energy at the launch, in J.
        energy: f64,
    },
    /// One motion keeps the steps so short that the other does not reach its end.
    #[error(
        "after {steps} steps the speeds have fallen by {folds:.3} e-folds only; sliding and \
         spinning change on scales that are too far apart"
    )]
    TooStiff {
        /// Number of steps taken.
        steps: u64,
        /// e-folds by which the common scale of both speeds has fallen.
        folds: f64,
    },
    /// A tall body would tip, and the scene forbids it.
    #[error(
        "the body tips: from {time:.6} s on its foot cannot bear the pressure gradient, which \
         reaches {lean:.4} times the limit; lower `height` or `gamma`, or set \
         on_tipping = \"clamp\""
    )]
    Tips {
        /// Time at which tipping begins, in s.
        time: f64,
        /// Largest |l| during the motion.
        lean: f64,
    },
    /// The law, or the tier chosen for it, was refused.
    #[error(transparent)]
    Choice(#[from] FrictionError),
    /// The method supports only powers of the speed.
    #[error(
        "integrator = \"verlet\" follows powers of the speed; the law {law} needs integrator = \"exact\""
    )]
    OnlyPowers {
        /// Name of the law.
        law: &'static str,
    },
    /// The kernel refused the contact patch.
    #[error(transparent)]
    Patch(#[from] PatchError),
    /// The kernel refused the law or the inertia.
    #[error(transparent)]
    Law(#[from] LawError),
    /// The kernel refused the body on its patch.
    #[error(transparent)]
    Body(#[from] tribos_core::Error),
}

/// The kinetic energy of a launch, if both of its shares are positive numbers.
fn energy_at_launch(energy: f64) -> Result<f64, SlideError> {
    if energy.is_finite() && energy >= f64::MIN_POSITIVE {
        Ok(energy)
    } else {
        Err(SlideError::Energy { energy })
    }
}

/// Series and summary of the run of one slider.
///
/// ```
/// use tribos::scene::DiskScene;
/// use tribos::slide::{SlideRun, run};
/// let SlideRun { series, outcome } = run(&DiskScene::default(), |_| ())?;
/// assert_eq!(series.len() as u64, outcome.steps + 1);
/// for [.., kinetic, dissipated] in series {
///     let sum = kinetic + dissipated; // stays what it was at the launch
///     assert!((sum - outcome.initial_energy).abs() < 1e-9 * outcome.initial_energy);
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct SlideRun {
    /// Rows of the series, with the columns of [`COLUMNS`].
    pub series: Vec<[f64; COLUMNS.len()]>,
    /// The summary.
    pub outcome: SlideSummary,
}

/// Runs a scene to its end; `progress` receives the completed fraction after every step.
///
/// *Accuracy* under a law that is no power of the speed: 1e-8, that of the law's quadrature. A law with a state
/// (bristles, ages) acts in its steady form, because on a patch that slides and spins the state differs from
/// point to point.
///
/// ```
/// use tribos::{scene::DiskScene, slide::run};
/// let scene = DiskScene { speed: 1.0, spin: 0.0, gamma: 0.3, ..DiskScene::default() };
/// let result = run(&scene, |_| ())?;
/// assert!((result.outcome.distance - 1.0 / (2.0 * 0.3 * 9.81)).abs() < 1e-13);
/// // On oil: dv/dt = -g (mu + k v), which ends after ln(1 + k v0/mu)/(g k).
/// let law = Some("stribeck:mu_s=0.2,mu_d=0.2,vs=0.01,k=0.1".parse()?); // s/m
/// let oiled = DiskScene { gravity: 10.0, law, ..scene };
/// assert!((run(&oiled, |_| ())?.outcome.end_time - 1.5_f64.ln()).abs() < 1e-8);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn run(scene: &DiskScene, progress: impl FnMut(f64)) -> Result<SlideRun, SlideError> {
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
    type Output = Result<SlideRun, SlideError>;

    fn visit<P: RoundPower<f64> + 'static>(mut self, profile: P) -> Self::Output {
        let mut simulation = SlideSimulation::new(profile, self.scene)?;
        let mut series = Vec::new();
        run_to_end(&mut simulation, |row, done| {
            series.push(row);
            (self.progress)(done);
        })?;
        Ok(SlideRun {
            series,
            outcome: simulation.outcome()?,
        })
    }
}

impl DiskScene {
    /// Friction law of the scene.
    pub(crate) fn law(&self) -> Result<Law, FrictionError> {
        self.law
            .map_or_else(|| Law::power(self.gamma, self.alpha), Ok)
    }
}
