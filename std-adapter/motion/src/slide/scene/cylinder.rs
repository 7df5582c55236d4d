//! The scene of a tall cylinder.

use super::planar::{EXPONENT, FootPressure, STOP_FRACTION, Tipping, is_of_power_law, moves};
use crate::slide::planar::{Gradient, Resistance, TallCylinder};
use crate::slide::{MotionError, PlanarCourse, PlanarScene, of_law};
use tribos_base::scene::entries::Written;
use tribos_base::scene::key::{Domain::*, MOST_SAMPLES, Need::*};
use tribos_base::scene::table::scene;
use tribos_base::scene::words::Word;
use tribos_friction::{Evaluation, FrictionError, LAW, Law};

scene! {
    /// A tall cylinder that slides on its flat side along a path in the plane.
    ///
    /// The default is a cylinder as high as wide, 16 cm, at 1 m/s and 5 rad/s.
    ///
    /// ```
    /// use tribos::scene::{CylinderScene, Tipping};
    /// let tower = CylinderScene { height: 0.4, ..CylinderScene::default() };
    /// assert!(tower.run().is_err()); // it tips
    /// let held = CylinderScene { on_tipping: Tipping::Clamp, ..tower }.run()?;
    /// assert!(held.outcome.max_lean > 1.0);
    /// # Ok::<(), tribos::slide::MotionError>(())
    /// ```
    #[derive(Copy)]
    pub struct CylinderScene = "cylinder", "A tall cylinder that slides and spins to rest",
        moves_at_all, in_force;

    /// Initial speed, along x.
    speed: f64 = 1.0, "m/s", NotNegative, Required;
    /// Initial spin, > 0 counterclockwise.
    spin: f64 = 5.0, "rad/s", Finite, Required;
    /// Friction coefficient of the local law: mu for alpha = 0.
    gamma was coefficient: f64 = 0.2, "(s/m)^alpha", Positive, UnlessGiven("law");
    /// Exponent of the local law |v|^alpha, 0 for Coulomb.
    alpha: f64 = 0.0, "-", EXPONENT;
    /// Local law in place of `gamma` and `alpha`.
    law: Option<Law> = None, "-", LAW;
    /// Outer radius.
    radius: f64 = 0.08, "m", Positive, Required;
    /// Height of the body; its centre of mass is half way up.
    height: f64 = 0.16, "m", NotNegative, Required;
    /// Directions in which the pressure may lean.
    pressure_gradient was gradient: Gradient = Gradient::AllRound, "-", OneOf(Gradient::WORDS);
    /// Pressure at rest.
    pressure: FootPressure = FootPressure::Uniform, "-", OneOf(FootPressure::WORDS);
    /// Inertia ratio C = I/(M R^2), 0.5 for a solid, uniform cylinder.
    inertia_ratio: f64 = 0.5, "-", Positive;
    /// What to do where the body would tip.
    on_tipping was tipping: Tipping = Tipping::Refuse, "-", OneOf(Tipping::WORDS);
    /// Acceleration that presses the body down.
    gravity: f64 = 9.81, "m/s^2", Positive, Required;
    /// Mass of the body.
    mass: f64 = 1.0, "kg", Positive, Required;
    /// Fraction of their start below which both speeds count as rest, for alpha >= 1.
    stop_fraction: f64 = STOP_FRACTION, "-", Between { above: 0.0, up_to: 0.5 };
    /// Number of intervals of time in the series.
    samples: u32 = 200, "-", Count { from: 1.0, up_to: MOST_SAMPLES };
}

fn moves_at_all(
    scene: &CylinderScene,
    judge: &mut tribos_base::scene::reader::SceneDiagnostics<'_>,
) {
    moves(scene.speed, scene.spin, judge);
}

/// A law of its own takes the place of the power law.
fn in_force(scene: &CylinderScene, key: &str, written: Option<Written>) -> Option<Written> {
    written.filter(|_| scene.law.is_none() || !is_of_power_law(key))
}

impl CylinderScene {
    /// The law of the scene.
    fn local_law(&self) -> Result<Law, FrictionError> {
        self.law
            .map_or_else(|| Law::power(self.gamma, self.alpha), Ok)
    }

    /// The cylinder.
    pub fn cylinder(&self) -> TallCylinder {
        TallCylinder {
            coefficient: self.gamma,
            alpha: self.alpha,
            radius: self.radius,
            height: self.height,
            inertia_ratio: self.inertia_ratio,
            pressure: self.pressure.pressure(),
            gradient: self.pressure_gradient,
        }
    }
}

impl PlanarScene for CylinderScene {
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
            self.cylinder()
                .body_under(&self.local_law()?, self.gravity)?,
        ))
    }

    fn evaluation(&self) -> Result<Evaluation, MotionError> {
        of_law(&self.pressure.pressure().into(), &self.local_law()?)
    }
}
