//! The scene of a block on an incline.

use std::f64::consts::FRAC_PI_2;
use tribos_base::scene::key::{Domain::*, MOST_SAMPLES, Need::*};
use tribos_base::scene::reader::SceneDiagnostics;
use tribos_base::scene::table::{as_written, scene};
use tribos_friction::{PATCH, Patch};

scene! {
    /// A block at rest on an incline that is raised: it holds, lets go and slides down.
    ///
    /// It is raised so slowly that the raising itself accelerates nothing.
    ///
    /// ```
    /// use tribos::scene::InclineScene;
    /// let end = InclineScene { mu_static: 0.5, ..InclineScene::default() }.run()?.outcome;
    /// let angle: f64 = end.release_angle.ok_or("holds")?;
    /// assert!((angle.tan() - 0.5).abs() < 1e-14);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub struct InclineScene = "incline", "A block on an incline",
        rules, as_written;

    /// Contact of the block with the incline: box:AxB, polygon:FILE, bar:L, or a round patch such as disk.
    patch: Patch = Patch::Disk, "-", PATCH;
    /// Radius of a round patch.
    radius: f64 = 0.05, "m", Positive;
    /// Mass of the block.
    mass: f64 = 1.0, "kg", Positive, Required;
    /// Acceleration by gravity.
    gravity: f64 = 9.81, "m/s^2", Positive, Required;
    /// Static coefficient of a contact not older than `ageing_cutoff_time`.
    mu_static: f64 = 0.5, "-", NotNegative, Required;
    /// Dynamic coefficient.
    mu_dynamic: f64 = 0.3, "-", NotNegative, Required;
    /// Growth of the static coefficient for each e-fold of the time of rest.
    ageing_rate was growth: f64 = 0.0, "-", NotNegative;
    /// Time of rest from which it grows.
    ageing_cutoff_time was cut_off: f64 = 1.0, "s", Positive;
    /// Angle of the incline at the start.
    start_angle: f64 = 0.0, "rad", NotNegative;
    /// Rate at which it is raised, 0 for a fixed one.
    tilt_rate was raise_rate: f64 = 0.05, "rad/s", NotNegative;
    /// Angle at which the raising ends.
    end_angle: f64 = 1.0, "rad", Between { above: 0.0, up_to: FRAC_PI_2 };
    /// End of the run.
    duration: f64 = 12.0, "s", Positive, Required;
    /// Number of intervals of time in the series.
    samples: u32 = 400, "-", Count { from: 1.0, up_to: MOST_SAMPLES };
}

fn rules(scene: &InclineScene, judge: &mut SceneDiagnostics<'_>) {
    if scene.mu_dynamic > scene.mu_static {
        let message = format!(
            "`mu_dynamic` must not exceed `mu_static`, {}",
            scene.mu_static
        );
        judge.refuse(&["mu_dynamic", "mu_static"], message);
    }
    if scene.end_angle < scene.start_angle {
        let message = format!(
            "`end_angle` must not be below `start_angle`, {}",
            scene.start_angle
        );
        judge.refuse(&["end_angle", "start_angle"], message);
    }
    if let Patch::Points(_) = scene.patch {
        let message =
            "points have no smooth limit surface: name a box, a polygon, a bar or a round patch";
        judge.refuse(&["patch"], message);
    }
}
