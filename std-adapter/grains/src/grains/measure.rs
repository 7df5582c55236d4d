//! What is measured of the grains after a step.

use super::bound::Holder;
use super::from_scene::volume;
use super::layout::Layout;
use super::loads::Loads;
use super::wall::{AxisEnd, PLATE, WallId, inward};
use crate::grains::scene::{Axis, Container, EndBoundary, GrainsScene};
use crate::packing::{Packing, Stress, branch, is_at};
use nalgebra::Vector3;
use std::f64::consts::PI;
use tribos_base::record::{ContactRow, Partner};
use tribos_base::results::{Reporting::*, summary};
use tribos_contacts::cd::{MovingMesh, StepReport};
use tribos_core::contact::SphereBody;

summary! {
    /// A line of the series, in the units of the scene.
    #[derive(Copy)]
    pub struct GrainsLine = series;

    /// Time.
    time: f64, "s", InSeries;
    /// Number of steps taken.
    step: f64, "-", InSeries;
    /// Length along x of the volume that the grains fill.
    width: f64, "m";
    /// Length along y of this volume.
    depth: f64, "m";
    /// Length along z of this volume; below an open top, that of a level bed.
    height: f64, "m", Swept;
    /// Share of the volume, or of the area in two dimensions, that is solid.
    solid_fraction: f64, "-", Shown("solid fraction");
    /// Kinetic energy of the grains.
    kinetic: f64, "J", InSeries;
    /// Root mean square speed of the grains that move freely.
    speed: f64, "m/s";
    /// Number of contacts, those with walls included.
    contacts: f64, "-", InSeries;
    /// Mean number of contacts of a grain that moves freely, walls included.
    coordination: f64, "-";
    /// Force of the grains on the floor and on fixed grains, downwards.
    floor_force: f64, "N", Shown("floor force");
    /// Force of the grains on the plate above and on what is glued to it, upwards.
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
    /// Work of the loads on walls, of prescribed wall motions, of gravity, and of a shear.
    work: f64, "J", InSeries;
    /// Energy lost in collisions and in closing gaps.
    dissipated_normal: f64, "J", InSeries;
    /// Energy lost in sliding.
    dissipated_sliding: f64, "J", InSeries;
    /// Energy lost in rolling.
    dissipated_rolling: f64, "J", InSeries;
    /// Energy lost in torsion.
    dissipated_torsion: f64, "J", InSeries;
    /// Work against cohesion.
    dissipated_cohesion: f64, "J", InSeries;
    /// Shear stress of the contacts over the rate of a sheared box; 0 without a rate.
    viscosity: f64, "Pa s", InSeries;
    /// Shear stress over normal stress, that of the plate or along z: mu of mu(I); 0 without a shear or a normal stress.
    stress_ratio: f64, "-", Shown("stress ratio");
    /// Inertial number I = |shear rate| d sqrt(density/normal stress), with the mean diameter; 0 without a normal stress.
    inertial_number: f64, "-", Swept;
    /// Force of the others on the driven grains along x.
    driven_force_x: f64, "N";
    /// Force of the others on the driven grains along y.
    driven_force_y: f64, "N";
    /// Force of the others on the driven grains along z.
    driven_force_z: f64, "N";
    /// Torque of the others on the driven grains along x, about the mean of their centres.
    driven_torque_x: f64, "N m";
    /// Torque on the driven grains along y.
    driven_torque_y: f64, "N m";
    /// Torque on the driven grains along z.
    driven_torque_z: f64, "N m";
    /// Force of the grains on the mesh along x.
    mesh_force_x: f64, "N";
    /// Force of the grains on the mesh along y.
    mesh_force_y: f64, "N";
    /// Force of the grains on the mesh along z.
    mesh_force_z: f64, "N";
    /// Torque of the grains on the mesh along x, about `mesh_centre`.
    mesh_torque_x: f64, "N m";
    /// Torque of the grains on the mesh along y.
    mesh_torque_y: f64, "N m";
    /// Torque of the grains on the mesh along z.
    mesh_torque_z: f64, "N m";
}

/// Columns of the series, in the units of the scene.
pub const COLUMNS: [&str; GrainsLine::COLUMNS.len()] = GrainsLine::COLUMNS;

/// State of the packing after a step, for measurements.
#[derive(Clone, Copy, Debug)]
pub(super) struct PackingState<'a> {
    pub scene: &'a GrainsScene,
    pub layout: &'a Layout,
    pub loads: &'a Loads,
    pub packing: &'a dyn Packing,
    pub contacts: &'a [ContactRow],
    pub report: &'a StepReport,
    pub mesh: Option<&'a MovingMesh>,
}

impl PackingState<'_> {
    /// Low and high coordinates of the volume that the grains fill. Below an open top it ends at twice the
    /// mean height of the centres, weighted with mass: the surface of a level bed.
    pub fn extents(&self) -> [[f64; 2]; 3] {
        let mut extents = self.layout.extents(self.packing);
        if self.scene.boundary_z == EndBoundary::Floor && self.scene.container != Container::Drum {
            let low = extents[2][0];
            let (mut sum, mut mass) = (0.0, 0.0);
            for (x, radius, _) in self.free() {
                let cube = radius * radius * radius;
                sum += cube * (x.z - low);
                mass += cube;
            }
            extents[2][1] = low + 2.0 * sum / mass;
        }
        extents
    }

    /// Places, radii and bodies of the grains that forces move.
    pub fn free(&self) -> impl Iterator<Item = (&Vector3<f64>, f64, &SphereBody<f64>)> {
        let grains = self.packing.positions().iter().zip(self.packing.radii());
        let grains = grains.zip(self.packing.spheres());
        let free = grains.filter(|(_, sphere)| sphere.inv_mass > 0.0);
        free.map(|((x, radius), sphere)| (x, *radius, sphere))
    }

    /// Force of the others on grains that something holds, and the torque about the mean of their centres.
    pub fn load_on(&self, holder: Holder) -> [Vector3<f64>; 2] {
        let held: Vec<u32> = {
            let held = self
                .loads
                .bound()
                .iter()
                .filter(|held| held.holder == holder);
            held.map(|held| held.grain as u32).collect()
        };
        let (positions, radii) = (self.packing.positions(), self.packing.radii());
        let places = held.iter().map(|grain| positions[*grain as usize]);
        let centre = places.sum::<Vector3<f64>>() / held.len().max(1) as f64;
        let mut load = [Vector3::zeros(); 2];
        // Of a row the second body feels the force, and the first its opposite.
        let mut add = |grain: u32, row: &ContactRow, side: f64| {
            if held.binary_search(&grain).is_ok() {
                let at = positions[grain as usize] - row.normal * (side * radii[grain as usize]);
                let force = row.force * side;
                load[0] += force;
                load[1] += (at - centre).cross(&force) + row.torque * side;
            }
        };
        for row in self.contacts.iter().filter(|_| !held.is_empty()) {
            add(row.a, row, -1.0);
            if let Some(b) = row.b.particle() {
                add(b, row, 1.0);
            }
        }
        load
    }

    /// Force of the grains on the mesh, and the torque about its centre.
    fn load_on_mesh(&self) -> [Vector3<f64>; 2] {
        let mut load = [Vector3::zeros(); 2];
        let Some(mesh) = self.mesh else {
            return load;
        };
        let (centre, walls) = (
            mesh.at(self.packing.clock().0).centre(),
            self.layout.parts.len(),
        );
        for row in self.contacts {
            if !matches!(row.b, Partner::Wall(wall) if wall as usize >= walls) {
                continue;
            }
            let a = row.a as usize;
            let at = self.packing.positions()[a] + row.normal * (self.packing.radii()[a] + row.gap);
            load[0] += row.force;
            load[1] += self
                .layout
                .space
                .displacement(&centre, &at)
                .cross(&row.force)
                + row.torque;
        }
        load
    }

    /// Share of the volume, or of the area in two dimensions, that is solid.
    pub fn solid_fraction(&self, [width, depth, height]: [f64; 3]) -> f64 {
        let radii = self.free().map(|(_, radius, _)| radius);
        if self.scene.is_flat() {
            let area: f64 = radii.map(|radius| PI * radius * radius).sum();
            area / (width * height)
        } else {
            let solid: f64 = radii.map(volume).sum();
            solid / (width * depth * height)
        }
    }

    /// Force of the grains on a wall; zero if there is none.
    pub fn force(&self, face: WallId) -> Vector3<f64> {
        let Some(wall) = self.layout.wall(face) else {
            return Vector3::zeros();
        };
        let at_wall = self.contacts.iter().filter(|row| is_at(row, wall));
        at_wall.map(|row| row.force).sum()
    }

    /// Force of the grains that pushes a wall outwards.
    pub fn push(&self, axis: Axis, end: AxisEnd) -> f64 {
        -self.force(WallId::Side(axis, end)).dot(&inward(axis, end))
    }

    /// Stress of the contacts in a volume.
    pub fn stress(&self, volume: f64) -> Stress {
        let radii = self.packing.radii();
        Stress::of(self.contacts, |contact| branch(contact, radii), volume)
    }

    /// Root mean square speed of the grains.
    pub fn speed(&self) -> f64 {
        let squares = self
            .free()
            .map(|(_, _, sphere)| sphere.velocity.norm_squared());
        (squares.sum::<f64>() / self.free().count().max(1) as f64).sqrt()
    }

    /// Mean number of contacts of a grain, walls included.
    fn coordination(&self) -> f64 {
        let spheres = self.packing.spheres();
        let is_free = |grain: u32| spheres[grain as usize].inv_mass > 0.0;
        let ends = |row: &ContactRow| {
            usize::from(is_free(row.a)) + usize::from(row.b.particle().is_some_and(is_free))
        };
        let ends: usize = self.contacts.iter().map(ends).sum();
        ends as f64 / self.free().count().max(1) as f64
    }

    /// The current line of the series.
    pub fn line(&self) -> GrainsLine {
        let (time, step) = self.packing.clock();
        let extents = self.extents();
        let [width, depth, height] = extents.map(|[low, high]| high - low);
        let stress = self.stress(width * depth * height).total();
        let energy = self.packing.energy();
        let gravity = self.loads.gravity(time);
        let plate_area = Layout::area(&extents, Axis::Z);
        let [glued, _] = self.load_on(Holder::Lid);
        let glued_pull = if self.loads.bound().is_empty() {
            0.0
        } else {
            -glued.z
        };
        let plate = self.force(PLATE) + glued;
        let [fixed, _] = self.load_on(Holder::Box);
        let [driven, driven_torque] = self.load_on(Holder::Drive);
        let [mesh, mesh_torque] = self.load_on_mesh();
        let plate_speed = self.loads.plate_speed(time);
        let shear_rate = self.scene.sheared().unwrap_or(plate_speed / height);
        let shear_stress = self.shear_stress(-plate.x / plate_area, stress.m13);
        let normal_stress = match self.scene.sheared() {
            Some(_) => stress.m33,
            None => plate.z / plate_area,
        };
        GrainsLine {
            time,
            step: step as f64,
            width,
            depth,
            height,
            solid_fraction: self.solid_fraction([width, depth, height]),
            kinetic: energy.kinetic,
            speed: self.speed(),
            contacts: self.contacts.len() as f64,
            coordination: self.coordination(),
            floor_force: self.push(Axis::Z, AxisEnd::Low) - fixed.z,
            plate_force: self.push(Axis::Z, AxisEnd::High) - glued_pull,
            side_force_x: self.push(Axis::X, AxisEnd::High),
            side_force_y: self.push(Axis::Y, AxisEnd::High),
            stress_xx: stress.m11,
            stress_yy: stress.m22,
            stress_zz: stress.m33,
            stress_xz: stress.m13,
            plate_stress: plate.z / plate_area,
            shear_stress,
            plate_speed,
            shear_rate,
            gravity_x: gravity.x,
            gravity_z: gravity.z,
            surface_angle: self.surface_angle(),
            discharged: self.discharged(),
            sweeps: self.report.iterations.sweeps as f64,
            residual: self.report.residual.relative,
            work: energy.work,
            dissipated_normal: energy.normal,
            dissipated_sliding: energy.sliding,
            dissipated_rolling: energy.rolling,
            dissipated_torsion: energy.torsion,
            dissipated_cohesion: energy.cohesion,
            viscosity: self.viscosity(stress.m13),
            stress_ratio: finite(shear_stress / normal_stress)
                .filter(|_| shear_rate != 0.0)
                .unwrap_or(0.0),
            inertial_number: finite(
                shear_rate.abs() * self.diameter() * (self.density() / normal_stress).sqrt(),
            )
            .unwrap_or(0.0),
            driven_force_x: driven.x,
            driven_force_y: driven.y,
            driven_force_z: driven.z,
            driven_torque_x: driven_torque.x,
            driven_torque_y: driven_torque.y,
            driven_torque_z: driven_torque.z,
            mesh_force_x: mesh.x,
            mesh_force_y: mesh.y,
            mesh_force_z: mesh.z,
            mesh_torque_x: mesh_torque.x,
            mesh_torque_y: mesh_torque.y,
            mesh_torque_z: mesh_torque.z,
        }
    }

    /// Mean diameter of the grains.
    fn diameter(&self) -> f64 {
        let radii = self.packing.radii();
        2.0 * radii.iter().sum::<f64>() / radii.len().max(1) as f64
    }

    /// Density of the grains: their mass over their volume.
    fn density(&self) -> f64 {
        let volumes = self.packing.radii().iter().map(|radius| volume(*radius));
        self.mass() / volumes.sum::<f64>()
    }

    /// Mass of all grains.
    pub fn mass(&self) -> f64 {
        let spheres = self.packing.spheres().iter();
        spheres.map(|grain| 1.0 / grain.inv_mass).sum()
    }

    /// Shear stress on the plate; of the contacts in a sheared box without walls.
    fn shear_stress(&self, plate: f64, stress_xz: f64) -> f64 {
        if self.scene.sheared().is_none() {
            plate
        } else {
            -stress_xz
        }
    }

    /// Shear stress of the contacts over the rate of a sheared box; 0 without a rate.
    fn viscosity(&self, stress_xz: f64) -> f64 {
        match self.scene.sheared() {
            Some(rate) if rate != 0.0 => -stress_xz / rate,
            _ => 0.0,
        }
    }

    /// Mass of the grains below the slot of a hopper; 0 without one.
    fn discharged(&self) -> f64 {
        if self.scene.container != Container::Hopper {
            return 0.0;
        }
        self.free()
            .filter(|(x, ..)| x.z < self.scene.orifice_height)
            .map(|(_, _, grain)| 1.0 / grain.inv_mass)
            .sum()
    }

    /// Slope of the free surface along x, in degrees, positive where it falls towards +x: the line of
    /// least squares through the highest grain of each strip of two diameters. 0 without a free surface.
    fn surface_angle(&self) -> f64 {
        fall(&self.tops())[0]
    }

    /// Standard error of this angle, from the scatter of the strips about the line.
    pub fn surface_angle_error(&self) -> f64 {
        fall(&self.tops())[1]
    }

    /// The same of the lower and the upper half of the width: of a heap they have opposite signs.
    pub fn surface_angles(&self) -> [f64; 2] {
        let tops = self.tops();
        let middle = tops.partition_point(|[x, _]| *x < 0.5 * self.scene.width);
        let (low, high) = tops.split_at(middle);
        [low, high].map(|half| fall(half)[0])
    }

    /// The highest grain of each strip along x, above the slot of a hopper.
    fn tops(&self) -> Vec<[f64; 2]> {
        if self.scene.boundary_z != EndBoundary::Floor {
            return Vec::new();
        }
        let above = match self.scene.container {
            Container::Hopper => self.scene.orifice_height,
            _ => f64::NEG_INFINITY,
        };
        let strip = 4.0 * self.scene.radius;
        let strips = (self.scene.width / strip).floor().max(1.0);
        let length = self.scene.width / strips;
        let mut tops = vec![None; strips as usize];
        for (x, radius, _) in self.free() {
            let place = self.packing.space().wrap(x);
            if place.z < above {
                continue;
            }
            let top = place.z + radius;
            // The cast saturates: grains beyond an open end belong to the last strip.
            let index = ((place.x / length) as usize).min(tops.len() - 1);
            let highest: &mut Option<[f64; 2]> = &mut tops[index];
            if highest.is_none_or(|[_, z]| top > z) {
                *highest = Some([place.x, top]);
            }
        }
        tops.into_iter().flatten().collect()
    }
}

/// A number that is finite.
fn finite(number: f64) -> Option<f64> {
    Some(number).filter(|number| number.is_finite())
}

/// Fall of the line of least squares through points of x and z, in degrees, and its standard error; 0 through less than
/// two, with an error of NaN through less than three.
fn fall(tops: &[[f64; 2]]) -> [f64; 2] {
    let count = tops.len() as f64;
    let mean = |axis: usize| tops.iter().map(|at| at[axis]).sum::<f64>() / count;
    let [x, z] = [0, 1].map(mean);
    let sum = |of: &dyn Fn([f64; 2]) -> f64| {
        let about = tops.iter().map(|at| [at[0] - x, at[1] - z]);
        about.map(of).sum::<f64>()
    };
    let square = sum(&|[x, _]| x * x);
    if square > 0.0 {
        let slope = sum(&|[x, z]| x * z) / square;
        let left = sum(&|[x, z]| (z - slope * x) * (z - slope * x));
        let error = if count > 2.0 {
            (left / (count - 2.0) / square).sqrt()
        } else {
            f64::NAN
        };
        // The angle is the arc tangent of the slope.
        let error = error / (1.0 + slope * slope);
        [libm::atan(-slope), error].map(f64::to_degrees)
    } else {
        [0.0, f64::NAN]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_slope_has_the_error_of_least_squares() {
        // By hand: slope -0.95, squares of what is left 0.175, of the places 5: the error is √(0.175/2/5).
        let [angle, error] = fall(&[[0.0, 0.0], [1.0, -1.0], [2.0, -1.5], [3.0, -3.0]]);
        let slope = libm::tan(angle.to_radians());
        assert!((slope - 0.95).abs() < 1e-12, "{slope}");
        let of_slope = error.to_radians() * (1.0 + slope * slope);
        assert!((of_slope - 0.0175_f64.sqrt()).abs() < 1e-12, "{of_slope}");
        assert!(fall(&[[0.0, 0.0], [1.0, 0.0]])[1].is_nan());
    }
}
