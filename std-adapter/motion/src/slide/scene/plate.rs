//! The scene of a flat plate.

use super::planar::{STOP_FRACTION, Tipping, moves};
use crate::slide::planar::{Plate, Resistance};
use crate::slide::{MotionError, PlanarCourse, PlanarScene};
use tribos_base::scene::key::{Domain::*, MOST_SAMPLES, Need::*, reads};
use tribos_base::scene::table::{as_written, scene};
use tribos_base::scene::{Domain, Form};
use tribos_friction::{Coefficients, Evaluation, Flat, FlatPatch, FrictionError, Patch};

/// A patch with an outline that uniform thickness can fill.
const OUTLINE: Domain = Domain::Form(&Form {
    name: "patch",
    valid: "a patch such as \"box:0.3x0.2\", \"polygon:FILE\" or \"bar:0.2\"",
    read: reads::<Patch>,
    numbers: None,
    names_absence: true,
});

scene! {
    /// A flat plate of any outline, such as a box or a tile, that slides and spins to rest.
    ///
    /// Its centre of mass lies above the centre of the outline, so low that the pressure stays uniform.
    ///
    /// ```
    /// use tribos::scene::PlateScene;
    /// let run = PlateScene { speed: 1.0, spin: 0.0, ..PlateScene::default() }.run()?;
    /// // Without spin every plate stops like a point.
    /// let forward = run.outcome.x;
    /// assert!((forward - 1.0 / (2.0 * 0.3 * 9.81)).abs() < 1e-12);
    /// # Ok::<(), tribos::slide::MotionError>(())
    /// ```
    pub struct PlateScene = "plate", "A flat plate that slides and spins to rest",
        rules, as_written;

    /// Outline of the plate.
    patch: Patch = Patch::Flat(FlatPatch::Box([0.3, 0.2])), "-", OUTLINE, Required;
    /// Initial speed, along x.
    speed: f64 = 1.0, "m/s", NotNegative, Required;
    /// Initial spin, > 0 counterclockwise.
    spin: f64 = 5.0, "rad/s", Finite, Required;
    /// Angle from the direction of the launch to the outline's x axis, > 0 counterclockwise.
    orientation: f64 = 0.0, "rad", Finite;
    /// Coulomb's friction coefficient.
    mu was coefficient: f64 = 0.3, "-", Positive, Required;
    /// Friction coefficient across an axis of the outline, `mu` being that along it; the same if it is left out.
    mu_across: Option<f64> = None, "-", Positive;
    /// Angle from the x axis of the outline to that axis.
    axis: f64 = 0.0, "rad", Finite;
    /// Radius of gyration about the upright axis; that of a plate of uniform thickness if it is left out.
    gyration_radius: Option<f64> = None, "m", Positive;
    /// Acceleration that presses the plate down.
    gravity: f64 = 9.81, "m/s^2", Positive, Required;
    /// Mass of the plate.
    mass: f64 = 0.5, "kg", Positive, Required;
    /// Number of intervals of time in the series.
    samples: u32 = 200, "-", Count { from: 1.0, up_to: MOST_SAMPLES };
}

fn rules(scene: &PlateScene, judge: &mut tribos_base::scene::reader::SceneDiagnostics<'_>) {
    moves(scene.speed, scene.spin, judge);
    if let Err(refusal) = scene.outline().and_then(|patch| patch.radius_of_gyration()) {
        judge.refuse(&["patch"], format!("`patch`: {refusal}"));
    }
}

impl PlateScene {
    fn outline(&self) -> Result<Flat<f64>, FrictionError> {
        match &self.patch {
            Patch::Flat(flat) => flat.loaded(None),
            other => Err(FrictionError::Syntax(format!(
                "a plate is a box, a polygon or a bar, not {other}"
            ))),
        }
    }

    /// The plate.
    pub fn plate(&self) -> Result<Plate, MotionError> {
        let mut plate = Plate::new(self.outline()?, self.mu, self.gravity)?;
        if let Some(across) = self.mu_across {
            let mu = Coefficients::along_and_across([self.mu, across], self.axis)?;
            plate = plate.with_coefficients(&mu)?;
        }
        let plate = plate.with_orientation(self.orientation);
        match self.gyration_radius {
            Some(radius) => plate.with_radius_of_gyration(radius),
            None => Ok(plate),
        }
    }
}

impl PlanarScene for PlateScene {
    fn course(&self) -> PlanarCourse {
        PlanarCourse {
            speed: self.speed,
            spin: self.spin,
            mass: self.mass,
            // A plate has no height.
            tipping: Tipping::Clamp,
            stop_fraction: STOP_FRACTION,
            samples: self.samples,
        }
    }

    fn resistance(&self) -> Result<Box<dyn Resistance>, MotionError> {
        Ok(Box::new(self.plate()?))
    }

    fn evaluation(&self) -> Result<Evaluation, MotionError> {
        Ok(Evaluation::Edges)
    }
}
