//! Grains under their loads, step by step: their measures and when they end.

use super::from_scene::volume;
use super::initial_grains::start;
use super::layout::Layout;
use super::loads::Loads;
use super::measure::{COLUMNS, GrainsLine, PackingState};
use super::mesh;
use super::outcome::{GrainsSummary, HopperFlow, averages};
use super::wall::InitialWall;
use crate::grains::scene::{Container, EndBoundary, GrainsScene};
use crate::packing::PackingRunError;
use crate::packing::{
    Bodies, ContactKeys, Dissipation, InitialSpheres, MeasuredState, MeasurementSchedule,
    OptionalFeatures, Packing, PackingBody, PackingEnergy, PackingRun, PackingStopReason,
    RunLimits,
};
use nalgebra::Vector3;
use serde_json::{Map, Value};
use std::ops::ControlFlow;
use tribos_base::golden::{Measure, Measurement};
use tribos_base::record::CheckpointError;
use tribos_base::record::checkpoint::damaged;
use tribos_base::record::frames::Kind;
use tribos_contacts::cd::{AxisControl, CellControl};
use tribos_contacts::cd::{MovingMesh, Wall};

/// Slow steps after which the grains count as at rest.
const SLOW_STEPS: u64 = 100;

/// Grains in a box, a run in progress; its columns are [`COLUMNS`].
///
/// [`GrainsScene`] has an example.
pub type GrainsSimulation = PackingRun<GrainsBody, { COLUMNS.len() }>;

/// Grains in their box under its loads.
#[derive(Debug)]
pub struct GrainsBody {
    scene: GrainsScene,
    pub(super) layout: Layout,
    loads: Loads,
    mesh: Option<MovingMesh>,
}

/// Number of steps for which the grains have been slow.
#[derive(Debug)]
pub struct SlowStepCount(u64);

impl GrainsBody {
    /// Mass of a piston, and of an axis of the box under a stress.
    fn piston_mass(&self, start: &InitialSpheres) -> f64 {
        self.scene.piston_mass.unwrap_or_else(|| {
            let is_bound = |grain: usize| self.loads.bound().iter().any(|held| held.grain == grain);
            let grains = start.radii.iter().zip(&start.kinds.densities).enumerate();
            let free = grains.filter(|(grain, _)| !is_bound(*grain));
            free.map(|(_, (radius, density))| density * volume(*radius))
                .sum()
        })
    }

    /// The state after a step, for measurements.
    fn now<'a>(&'a self, seen: &'a MeasuredState) -> PackingState<'a> {
        PackingState {
            scene: &self.scene,
            layout: &self.layout,
            loads: &self.loads,
            packing: &*seen.packing,
            contacts: &seen.contacts,
            report: &seen.report,
            mesh: self.mesh.as_ref(),
        }
    }
}

impl PackingBody<{ COLUMNS.len() }> for GrainsBody {
    type Scene = GrainsScene;
    type Monitor = SlowStepCount;

    const COLUMNS: [&'static str; COLUMNS.len()] = COLUMNS;
    const FORMER_COLUMNS: usize = 35;
    const FORMAT: (&'static str, u64) = ("tribos_grains", 3);
    const KIND: Kind = Kind::Grains;
    const CADENCE: MeasurementSchedule = MeasurementSchedule::Lines;
    const OVER: PackingStopReason = PackingStopReason::Rest;

    fn place(
        scene: &GrainsScene,
        watch: &mut dyn FnMut(usize) -> ControlFlow<()>,
    ) -> Result<(Self, InitialSpheres), PackingRunError> {
        let mesh = mesh::of(scene)?;
        let start = start((scene, mesh.as_ref()), watch)?;
        let layout = Layout::of(scene, &start)?;
        let body = Self {
            scene: scene.clone(),
            loads: Loads::of(scene, &layout, &start),
            layout,
            mesh,
        };
        Ok((body, start))
    }

    fn scene(&self) -> &GrainsScene {
        &self.scene
    }

    fn contact_keys(&self) -> ContactKeys {
        self.scene.contact_keys()
    }

    fn bounds(&self) -> RunLimits {
        RunLimits {
            duration: self.scene.duration,
            steps: self.scene.max_steps,
            samples: self.scene.sample_every,
        }
    }

    fn walls(&self) -> usize {
        self.layout.parts.len()
    }

    fn corners(&self) -> Vec<Vector3<f64>> {
        let corners = self.mesh.iter().flat_map(|mesh| mesh.mesh.corners());
        corners.flatten().copied().collect()
    }

    fn bodies(&self, start: &InitialSpheres, _: &OptionalFeatures) -> Bodies {
        let mass = self.piston_mass(start);
        let wall = |(wall, part): (usize, &InitialWall)| {
            let mass = if self.loads.is_piston(wall) {
                mass
            } else {
                f64::INFINITY
            };
            Wall {
                edges: part.edges,
                ..Wall::piston(part.inward, part.place, mass, 0.0)
            }
        };
        Bodies {
            space: self.layout.space,
            positions: start.positions.clone(),
            radii: start.radii.clone(),
            walls: self.layout.parts.iter().enumerate().map(wall).collect(),
            gravity: self.loads.gravity(0.0),
        }
    }

    fn features(&self, start: &InitialSpheres) -> OptionalFeatures {
        let axes = self.loads.axes(0.0);
        let is_driven = axes != [AxisControl::Fixed; 3] || self.scene.sheared().is_some();
        OptionalFeatures {
            cell: is_driven.then(|| CellControl {
                axes,
                shear_rate: self.scene.sheared().unwrap_or(0.0),
                mass: self.piston_mass(start),
            }),
            shear_rate: self.scene.sheared().unwrap_or(0.0),
            velocities: self.scene.agitation(start.radii.len()),
            bound: self.loads.bound().iter().map(|held| held.grain).collect(),
            mesh: self.mesh.clone(),
            ..OptionalFeatures::default()
        }
    }

    fn monitor(&self) -> SlowStepCount {
        SlowStepCount(0)
    }

    fn prepare(&self, _: &mut SlowStepCount, packing: &mut dyn Packing) {
        self.loads.apply(&self.layout, packing);
    }

    fn porosity(&self, seen: &MeasuredState) -> f64 {
        let now = self.now(seen);
        1.0 - now.solid_fraction(now.extents().map(|[low, high]| high - low))
    }

    fn line(&self, _: &SlowStepCount, seen: &MeasuredState) -> [f64; COLUMNS.len()] {
        self.now(seen).line().values()
    }

    /// Counts slow steps.
    fn is_over(&self, SlowStepCount(slow): &mut SlowStepCount, seen: &MeasuredState) -> bool {
        let rest = self.scene.rest_speed;
        let is_slow = rest.is_some_and(|rest| self.now(seen).speed() < rest);
        *slow = if is_slow { *slow + 1 } else { 0 };
        *slow >= SLOW_STEPS
    }

    /// Its walls, and the highest grain below an open top. All centres are inside.
    fn extents(&self, seen: &MeasuredState) -> [[f64; 2]; 3] {
        let (scene, layout, packing) = (&self.scene, &self.layout, &seen.packing);
        let mut corners = layout.extents(&**packing);
        if scene.is_flat() {
            let most = packing.radii().iter().copied().fold(0.0, f64::max);
            corners[1] = [-most, most];
        }
        // Grains that press a wall reach beyond it by their overlap, and the box ends at the wall.
        let is_open = scene.boundary_z == EndBoundary::Floor && scene.container != Container::Drum;
        for (x, radius) in packing.positions().iter().zip(packing.radii()) {
            let x = packing.space().wrap(x);
            for (axis, [low, high]) in corners.iter_mut().enumerate() {
                if layout.space.lengths()[axis].is_none() {
                    let above = if is_open && axis == 2 { *radius } else { 0.0 };
                    *low = low.min(x[axis]);
                    *high = high.max(x[axis] + above);
                }
            }
        }
        corners
    }

    fn sides(&self) -> [f64; 2] {
        [self.scene.width, self.scene.box_depth()]
    }

    fn height(&self, seen: &MeasuredState) -> f64 {
        let [_, _, [low, high]] = self.now(seen).extents();
        high - low
    }

    fn write_checkpoint(SlowStepCount(slow): &SlowStepCount, map: &mut Map<String, Value>) {
        map.insert("slow".into(), (*slow).into());
    }

    fn read(value: &Value) -> Result<SlowStepCount, CheckpointError> {
        let slow = value["slow"].as_u64();
        Ok(SlowStepCount(slow.ok_or_else(|| damaged("slow"))?))
    }
}

impl GrainsSimulation {
    /// Summary of the run so far.
    pub fn outcome(&self) -> GrainsSummary {
        let now = self.body.now(&self.seen);
        let totals = self.totals();
        let has_surface = now.scene.boundary_z == EndBoundary::Floor;
        let energy = now.packing.energy();
        let mass = now.free().map(|(_, _, grain)| 1.0 / grain.inv_mass).sum();
        GrainsSummary {
            ending: self.ending(),
            grains: now.free().count(),
            mass,
            time: self.time(),
            steps: self.steps(),
            iterations_total: totals.iterations,
            steps_unmet: totals.unmet,
            steps_handed_over: Some(totals.handed_over).filter(|steps| *steps > 0),
            contacts: self.pairs(),
            end: now.line(),
            surface_angles: has_surface.then(|| now.surface_angles()),
            surface_angle_error: has_surface.then(|| now.surface_angle_error()),
            flow: (now.scene.container == Container::Hopper).then(|| self.flow(mass)),
            averages: averages(self.series(), now.scene.average_from),
            max_overlap: self.max_overlap(),
            statistics: self.statistics(),
            dissipation: Dissipation::of(energy),
            energy: PackingEnergy::of(energy, &now.scene.contact_method()),
            wall_seconds: totals.wall_seconds,
        }
    }

    /// Flow through the slot of a hopper.
    fn flow(&self, mass: f64) -> HopperFlow {
        let lines = self.series().iter().map(|row| GrainsLine::from(*row));
        let (times, below): (Vec<f64>, Vec<f64>) =
            lines.map(|line| (line.time, line.discharged)).unzip();
        HopperFlow::of(&times, &below, mass)
    }
}

impl Measure for GrainsScene {
    type Error = PackingRunError;

    fn measured(&self, watch: &mut dyn FnMut()) -> Result<Measurement, PackingRunError> {
        GrainsSimulation::measured(self, watch, |run| run.outcome().json(self))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    #[test]
    fn every_grain_is_as_heavy_as_its_material_makes_it() {
        let scene = GrainsScene {
            width: 0.05,
            count: 50,
            second_fraction: 0.3,
            second_radius: 0.5,
            second_density: Some(1000.0),
            ..GrainsScene::default()
        };
        let packing = GrainsSimulation::new(&scene).unwrap().seen.packing;
        assert_eq!(packing.radii().iter().filter(|r| **r == 0.0025).count(), 15);
        for (radius, sphere) in packing.radii().iter().zip(packing.spheres()) {
            let density = if *radius == 0.005 { 2500.0 } else { 1000.0 };
            let mass = density * 4.0 / 3.0 * PI * radius * radius * radius;
            assert!((sphere.inv_mass * mass - 1.0).abs() < 1e-12);
        }
    }
}
