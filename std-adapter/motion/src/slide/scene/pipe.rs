//! The scene of a pipe.

use super::planar::{EXPONENT, STOP_FRACTION, Tipping, is_of_power_law, moves};
use crate::slide::planar::{Gradient, Pipe, Resistance};
use crate::slide::{MotionError, PlanarCourse, PlanarScene, of_law};
use tribos_base::scene::entries::Written;
use tribos_base::scene::key::{Domain::*, MOST_SAMPLES, Need::*};
use tribos_base::scene::table::scene;
use tribos_base::scene::words::Word;
use tribos_friction::{Evaluation, FrictionError, LAW, Law, Patch};

scene! {
    /// A pipe that slides on its end along a path in the plane.
    ///
    /// The default is Penner's pipe of 10 cm at 1.74 m/s and 10.2 rad/s.
    ///
    /// ```
    /// use tribos::scene::PipeScene;
    /// let run = PipeScene { spin: 0.0, ..PipeScene::default() }.run()?;
    /// // Without spin the pipe leans, but friction stays mu N.
    /// let forward = run.outcome.x;
    /// assert!((forward - 1.74 * 1.74 / (2.0 * 0.2 * 9.81)).abs() < 1e-12);
    /// # Ok::<(), tribos::slide::MotionError>(())
    /// ```
    #[derive(Copy)]
    pub struct PipeScene = "pipe", "An upright pipe that slides and spins to rest",
        rules, in_force;

    /// Initial speed, along x.
    speed: f64 = 1.74, "m/s", NotNegative, Required;
    /// Initial spin, > 0 counterclockwise.
    spin: f64 = 10.2, "rad/s", Finite, Required;
    /// Friction coefficient of the local law: mu for alpha = 0.
    gamma was coefficient: f64 = 0.2, "(s/m)^alpha", Positive, UnlessGiven("law");
    /// Exponent of the local law |v|^alpha, 0 for Coulomb.
    alpha: f64 = 0.0, "-", EXPONENT;
    /// Local law in place of `gamma` and `alpha`.
    law: Option<Law> = None, "-", LAW;
    /// Outer radius.
    radius: f64 = 0.05, "m", Positive, Required;
    /// Height of the body; its centre of mass is half way up.
    height: f64 = 0.15, "m", NotNegative, Required;
    /// Directions in which the pressure may lean.
    pressure_gradient was gradient: Gradient = Gradient::AllRound, "-", OneOf(Gradient::WORDS);
    /// Inner radius of the pipe; the outer one for a thin ring.
    inner_radius: f64 = 0.046, "m", NotNegative, Required;
    /// What to do where the body would tip.
    on_tipping was tipping: Tipping = Tipping::Refuse, "-", OneOf(Tipping::WORDS);
    /// Acceleration that presses the body down.
    gravity: f64 = 9.81, "m/s^2", Positive, Required;
    /// Mass of the body.
    mass: f64 = 0.5, "kg", Positive, Required;
    /// Fraction of their start below which both speeds count as rest, for alpha >= 1.
    stop_fraction: f64 = STOP_FRACTION, "-", Between { above: 0.0, up_to: 0.5 };
    /// Number of intervals of time in the series.
    samples: u32 = 200, "-", Count { from: 1.0, up_to: MOST_SAMPLES };
}

fn rules(scene: &PipeScene, judge: &mut tribos_base::scene::reader::SceneDiagnostics<'_>) {
    moves(scene.speed, scene.spin, judge);
    if scene.inner_radius > scene.radius {
        let message = format!("`inner_radius` must not exceed `radius`, {}", scene.radius);
        judge.refuse(&["inner_radius", "radius"], message);
    }
}

/// A law of its own takes the place of the power law.
fn in_force(scene: &PipeScene, key: &str, written: Option<Written>) -> Option<Written> {
    written.filter(|_| scene.law.is_none() || !is_of_power_law(key))
}

impl PipeScene {
    /// The law of the scene.
    fn local_law(&self) -> Result<Law, FrictionError> {
        self.law
            .map_or_else(|| Law::power(self.gamma, self.alpha), Ok)
    }

    /// The pipe.
    pub fn pipe(&self) -> Pipe {
        Pipe {
            coefficient: self.gamma,
            alpha: self.alpha,
            radius: self.radius,
            inner_ratio: self.inner_radius / self.radius,
            height: self.height,
            gradient: self.pressure_gradient,
        }
    }
}

impl PlanarScene for PipeScene {
    fn course(&self) -> PlanarCourse {
        PlanarCourse {
            speed: self.speed,
            spin: self.spin,
            mass: self.mass,
            tipping: self.on_tipping,
            stop_fraction: self.stop_fraction,
            samples: self.samples,
        }
    }

    fn resistance(&self) -> Result<Box<dyn Resistance>, MotionError> {
        Ok(Box::new(
            self.pipe().body_under(&self.local_law()?, self.gravity)?,
        ))
    }

    fn evaluation(&self) -> Result<Evaluation, MotionError> {
        of_law(
            &Patch::band(self.inner_radius / self.radius),
            &self.local_law()?,
        )
    }
}
