//! Summary of a run of grains.

use crate::packing::{ContactStatistics, Dissipation, PackingEnergy, PackingStopReason};
use tribos_base::results::{Reporting::*, summary};

summary! {
    /// Results of a run of grains, in the units of its scene.
    ///
    /// [`GrainsScene`](crate::grains::scene::GrainsScene) has an example.
    pub struct GrainsSummary;

    /// Why the run ended; none if it has not.
    ending: Option<PackingStopReason>, "-";
    /// Number of grains.
    grains: usize, "-";
    /// Mass of all grains.
    mass: f64, "kg";
    /// Time at the end.
    time: f64, "s", Swept;
    /// Number of steps taken.
    steps: u64, "-", Swept;
    /// Total number of sweeps.
    iterations_total: u64, "-", Swept;
    /// Steps in which any tolerance or rule was not met.
    steps_unmet: u64, "-";
    /// Steps that sweeps handed over to a solver with factorisations; left out where there are none.
    steps_handed_over: Option<u64> = optional, "-";
    /// Number of contacts between grains at the end.
    contacts: usize, "-";
    /// Length along x of the volume that the grains fill at the end.
    width: f64, "m";
    /// Length along y of this volume.
    depth: f64, "m";
    /// Length along z of this volume; below an open top, that of a level bed.
    height: f64, "m", Swept;
    /// Share of the volume, or of the area in two dimensions, that is solid.
    solid_fraction: f64, "-", Shown("solid fraction");
    /// Root mean square speed of the grains.
    speed: f64, "m/s";
    /// Mean number of contacts of a grain, walls included.
    coordination: f64, "-";
    /// Force of the grains on the floor, downwards.
    floor_force: f64, "N", Shown("floor force");
    /// Force of the grains on the plate above, upwards.
    plate_force: f64, "N";
    /// Force of the grains on the wall at the far end of x, outwards.
    side_force_x: f64, "N";
    /// Force of the grains on the wall at the far end of y, outwards.
    side_force_y: f64, "N";
    /// Stress of the contacts along x; pressure is positive.
    stress_xx: f64, "Pa", Swept;
    /// Stress of the contacts along y.
    stress_yy: f64, "Pa";
    /// Stress of the contacts along z.
    stress_zz: f64, "Pa", Swept;
    /// Shear stress of the contacts in the plane of x and z.
    stress_xz: f64, "Pa", Swept;
    /// Normal stress on the plate above.
    plate_stress: f64, "Pa", Swept;
    /// Shear stress on the plate; of the contacts in a sheared box without walls.
    shear_stress: f64, "Pa", Shown("shear stress");
    /// Speed of the plate along x.
    plate_speed: f64, "m/s";
    /// Rate of the shear: that of the scene, or speed of the plate over height.
    shear_rate: f64, "1/s";
    /// Gravity along x.
    gravity_x: f64, "m/s^2";
    /// Gravity along z.
    gravity_z: f64, "m/s^2";
    /// Slope of the free surface along x, positive where it falls towards +x; 0 without a free surface.
    surface_angle: f64, "deg", Shown("angle");
    /// Mass of the grains below the slot of a hopper; 0 without one.
    discharged: f64, "kg";
    /// Sweeps of the last step.
    sweeps: f64, "-";
    /// Relative residual of the contact laws in the last step.
    residual: f64, "-";
    /// Slopes of the lower and the upper half of the free surface along x: a heap has one of each sign, and its
    /// `surface_angle` says nothing. Left out without a free surface.
    surface_angles: Option<[f64; 2]> = optional, "deg";
    /// Deepest overlap in all steps.
    max_overlap: f64, "m";
    /// Numbers and forces of the contacts at the end.
    statistics: ContactStatistics, "-";
    /// Energy that the contacts took.
    dissipation: Dissipation, "-";
    /// Energy balance.
    energy: PackingEnergy, "-";
    /// Wall-clock time.
    wall_seconds: f64, "s";
}
