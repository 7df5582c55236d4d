//! The scene of a clamped body under a cyclic load.

use tribos_base::scene::key::{Domain::*, MOST_SAMPLES, Need::*};
use tribos_base::scene::reader::SceneDiagnostics;
use tribos_base::scene::table::{as_written, scene};
use tribos_friction::{PATCH, Patch};

scene! {
    /// A body pinched between two elastic pads, under a force and a torque that swing.
    ///
    /// Both pads press with the same load; the body moves as far as their bonds give way.
    ///
    /// ```
    /// use tribos::scene::ClampScene;
    /// // Below what the weaker pad holds nothing slips: the loop has no area.
    /// let gentle = ClampScene { force_amplitude: 1.0, ..ClampScene::default() };
    /// assert_eq!(gentle.run()?.outcome.loss_per_cycle, 0.0);
    /// # Ok::<(), tribos::stick::MotionError>(())
    /// ```
    pub struct ClampScene = "clamp", "A clamped body under a load that swings",
        rules, as_written;

    /// Contact of each pad: box:AxB, polygon:FILE, bar:L, or a round patch such as disk.
    patch: Patch = Patch::Disk, "-", PATCH;
    /// Radius of a round patch.
    radius: f64 = 0.01, "m", Positive;
    /// Load of both pads.
    load: f64 = 20.0, "N", Positive, Required;
    /// Friction coefficient of the first pad.
    mu_first: f64 = 0.3, "-", Positive, Required;
    /// Friction coefficient of the second pad.
    mu_second: f64 = 0.5, "-", Positive, Required;
    /// Stiffness of the first pad along the contact.
    stiffness_first: f64 = 2e4, "N/m", Positive, Required;
    /// Stiffness of the second pad along the contact.
    stiffness_second: f64 = 1e4, "N/m", Positive, Required;
    /// Torsional stiffness of a pad over its stiffness; half the squared radius of a disk if left out.
    torsion_lever_squared: Option<f64> = None, "m^2", Positive;
    /// Mean of the force.
    force_mean: f64 = 0.0, "N", Finite;
    /// Amplitude of the force.
    force_amplitude: f64 = 11.0, "N", Finite, Required;
    /// Mean of the torque.
    torque_mean: f64 = 0.0, "N m", Finite;
    /// Amplitude of the torque, in phase with the force.
    torque_amplitude: f64 = 0.0, "N m", Finite;
    /// Growth of both amplitudes from cycle to cycle, as a share of the first.
    amplitude_growth was growth: f64 = 0.0, "-", NotNegative;
    /// Duration of a cycle.
    period: f64 = 1.0, "s", Positive;
    /// Number of cycles.
    cycles: u32 = 5, "-", Count { from: 1.0, up_to: 10_000.0 };
    /// Number of intervals of time in the series, for each cycle.
    samples: u32 = 200, "-", Count { from: 1.0, up_to: MOST_SAMPLES };
}

fn rules(scene: &ClampScene, judge: &mut SceneDiagnostics<'_>) {
    let still = [
        scene.force_mean,
        scene.force_amplitude,
        scene.torque_mean,
        scene.torque_amplitude,
    ];
    if still == [0.0; 4] {
        let message = "nothing pulls: give `force_amplitude` a value other than 0";
        judge.refuse(&["force_amplitude"], message);
    }
    if f64::from(scene.cycles) * f64::from(scene.samples) > MOST_SAMPLES {
        let message = format!("`cycles` times `samples` must not exceed {MOST_SAMPLES}");
        judge.refuse(&["cycles", "samples"], message);
    }
    if let Patch::Points(_) = scene.patch {
        let message =
            "points have no smooth limit surface: name a box, a polygon, a bar or a round patch";
        judge.refuse(&["patch"], message);
    }
}
