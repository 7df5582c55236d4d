//! The scene of one sliding, spinning body on a straight path.

use super::planar::{EXPONENT, STOP_FRACTION, is_of_power_law, moves};
use tribos_base::scene::entries::Written;
use tribos_base::scene::key::{Domain::*, MOST_SAMPLES, Need::*};
use tribos_base::scene::table::scene;
use tribos_base::scene::words::{Word, words};
use tribos_friction::{LAW, Law};

/// Which units a scene is written in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Units {
    /// Metres, seconds, kilograms.
    Si,
    /// Speeds in √(gR), times in √(R/g), lengths in R: gravity, radius and mass are 1.
    Dimensionless,
}
words!(Units { Si = "si", Dimensionless = "dimensionless" });

/// Which stepper follows the motion.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SliderIntegrator {
    /// Adaptive, stops exactly.
    Exact,
    /// The thesis' fixed-step Verlet method.
    Verlet,
}
words!(SliderIntegrator { Exact = "exact", Verlet = "verlet" });

scene! {
    /// A flat disk that slides and spins: its path is straight.
    ///
    /// The default is a disk of 8 cm and 100 g, thrown over a table at 1 m/s and 5 rad/s.
    ///
    /// ```
    /// use tribos::scene::{DiskScene, Units};
    /// let scene = DiskScene {
    ///     units: Units::Dimensionless,
    ///     spin: 0.0,
    ///     gamma: 0.25,
    ///     gravity: 1.0,
    ///     radius: 1.0,
    ///     mass: 1.0,
    ///     ..DiskScene::default()
    /// };
    /// let distance = scene.run()?.outcome.distance; // in radii
    /// assert!((distance - 2.0).abs() < 1e-13); // v²/(2 mu g)
    /// # Ok::<(), tribos::slide::MotionError>(())
    /// ```
    #[derive(Copy)]
    pub struct DiskScene = "disk", "A disk that slides and spins to rest",
        check_initial_motion, in_force;

    /// Initial sliding speed.
    speed: f64 = 1.0, "m/s", NotNegative, Required;
    /// Initial spin, of either sign.
    spin: f64 = 5.0, "rad/s", Finite, Required;
    /// Friction coefficient of the local law: mu for alpha = 0.
    gamma was coefficient: f64 = 0.3, "(s/m)^alpha", Positive, UnlessGiven("law");
    /// Exponent of the local law |v|^alpha, 0 for Coulomb.
    alpha: f64 = 0.0, "-", EXPONENT, UnlessGiven("law");
    /// Local law in place of `gamma` and `alpha`.
    law: Option<Law> = None, "-", LAW;
    /// Acceleration that presses the body down.
    gravity: f64 = 9.81, "m/s^2", Positive, UnitWith("units", "dimensionless");
    /// Radius of the contact.
    radius: f64 = 0.08, "m", Positive, UnitWith("units", "dimensionless");
    /// Mass of the body.
    mass: f64 = 0.1, "kg", Positive, UnitWith("units", "dimensionless");
    /// Inertia ratio C = I/(M R^2), 0.5 for a disk.
    inertia_ratio: f64 = 0.5, "-", Positive, Required;
    /// Fraction of their start below which both speeds count as rest, for alpha >= 1.
    stop_fraction: f64 = STOP_FRACTION, "-", Between { above: 0.0, up_to: 0.5 };
    /// Length of a step; if left out it is chosen from the motion.
    time_step: Option<f64> = None, "s", Positive;
    /// End of the run; if left out it is rest.
    duration: Option<f64> = None, "s", Positive;
    /// Number of recorded steps, where `time_step` is left out.
    samples: u32 = 200, "-", Count { from: 1.0, up_to: MOST_SAMPLES };
    /// Unit system.
    units: Units = Units::Si, "-", OneOf(Units::WORDS);
    /// Method that follows the motion.
    integrator was stepper: SliderIntegrator = SliderIntegrator::Exact, "-", OneOf(SliderIntegrator::WORDS);
}

fn check_initial_motion(
    scene: &DiskScene,
    judge: &mut tribos_base::scene::reader::SceneDiagnostics<'_>,
) {
    moves(scene.speed, scene.spin, judge);
}

/// A law of its own takes the place of the power law.
fn in_force(scene: &DiskScene, key: &str, written: Option<Written>) -> Option<Written> {
    written.filter(|_| scene.law.is_none() || !is_of_power_law(key))
}
