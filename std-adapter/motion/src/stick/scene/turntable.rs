//! The scene of a body on a turntable.

use tribos_base::record::brief;
use tribos_base::scene::key::{Domain::*, MOST_SAMPLES, Need::*};
use tribos_base::scene::reader::SceneDiagnostics;
use tribos_base::scene::table::{as_written, scene};
use tribos_friction::{PATCH, Patch};

scene! {
    /// A body that lies on a turntable which is spun up from rest: it holds, lets go and slides outward.
    ///
    /// ```
    /// use tribos::scene::TurntableScene;
    /// // A slow spin-up lets go where the centrifugal force meets friction.
    /// let table = TurntableScene { table_angular_acceleration: 1e-4, duration: 1e5, time_step: 1e-2, ..TurntableScene::default() };
    /// let rate = table.run()?.outcome.release_rate.ok_or("holds")?;
    /// let pull = rate * rate * table.distance; // omega² r
    /// assert!((pull / (table.mu_static * table.gravity) - 1.0).abs() < 1e-6);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub struct TurntableScene = "turntable", "A body on a turntable",
        rules, as_written;

    /// Contact of the body with the table, its x axis outward: box:AxB, polygon:FILE, bar:L, or a round patch such as disk.
    patch: Patch = Patch::Disk, "-", PATCH;
    /// Radius of a round patch.
    radius: f64 = 0.03, "m", Positive;
    /// Mass of the body.
    mass: f64 = 0.2, "kg", Positive, Required;
    /// Radius of gyration of the body about its upright axis.
    gyration_radius: f64 = 0.02, "m", Positive;
    /// Acceleration by gravity.
    gravity: f64 = 9.81, "m/s^2", Positive, Required;
    /// Static coefficient.
    mu_static: f64 = 0.4, "-", Positive, Required;
    /// Dynamic coefficient.
    mu_dynamic: f64 = 0.3, "-", NotNegative, Required;
    /// Distance of the body from the axis of the table.
    distance: f64 = 0.2, "m", Positive, Required;
    /// Angular acceleration of the table.
    table_angular_acceleration was spin_up: f64 = 1.0, "rad/s^2", Positive, Required;
    /// Radius of the table, where the run ends.
    table_radius: f64 = 0.5, "m", Positive;
    /// End of the run, if the body stays on the table.
    duration: f64 = 10.0, "s", Positive, Required;
    /// Longest step of the sliding body; its error makes it shorter.
    time_step: f64 = 5e-4, "s", Positive;
    /// Number of intervals of time in the series.
    samples: u32 = 400, "-", Count { from: 1.0, up_to: MOST_SAMPLES };
}

fn rules(scene: &TurntableScene, judge: &mut SceneDiagnostics<'_>) {
    if scene.mu_dynamic > scene.mu_static {
        let message = format!(
            "`mu_dynamic` must not exceed `mu_static`, {}",
            scene.mu_static
        );
        judge.refuse(&["mu_dynamic", "mu_static"], message);
    }
    if scene.distance >= scene.table_radius {
        let message = format!(
            "`distance` must be below `table_radius`, {}",
            scene.table_radius
        );
        judge.refuse(&["distance", "table_radius"], message);
    }
    if let Patch::Points(_) = scene.patch {
        let message =
            "points have no smooth limit surface: name a box, a polygon, a bar or a round patch";
        judge.refuse(&["patch"], message);
    }
    if scene.time_step * MOST_STEPS < scene.duration {
        let least = brief(&(scene.duration / MOST_STEPS));
        let message = format!("`time_step` must be at least `duration`/1e7, {least}");
        judge.refuse(&["time_step", "duration"], message);
    }
}

/// Most steps of a run.
const MOST_STEPS: f64 = 1e7;
