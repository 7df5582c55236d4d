//! A periodic cell that deforms: its lengths follow speeds or stresses, and it is sheared along x over z.
//!
//! A uniform strain moves a place x with the speed x L'/L of its share of the length L. A change of L' changes the
//! velocity of every sphere by its share, as in the cell of Parrinello and Rahman (J. Appl. Phys. 52 (1981) 7182). An
//! axis under a stress P, positive in compression, follows
//!
//! ```text
//! M L'' = (σ − P) V/L,     σ V = Σ f l + Σ m (v − v_flow)²
//! ```
//!
//! with the force f and the distance l of each contact along the axis, and the mass M of a piston (the cell of
//! Agnolin and Roux, Phys. Rev. E 76 (2007) 061302, on each axis). Velocities are those in the room: a sphere
//! that leaves the cell goes on as its image inside, with the velocity of the image.

use super::world::SoftWorld;
use crate::cd::cell::{carry_on, flow, image, stretched};
use crate::cd::{AxisControl, WorldError, keeps_motion};
use nalgebra::Vector3;
use tribos_core::contact::ContactFriction;

/// Loads of the contacts on a cell.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct CellLoads {
    /// Σ f l along each axis.
    pub virial: Vector3<f64>,
    /// Σ f · (velocity of the second body's image against itself).
    pub crossing: f64,
}

impl<F: ContactFriction<f64>> SoftWorld<F> {
    /// Sets what the axes of the cell follow from the next step on. *Domain*: controls of periodic axes, finite; otherwise
    /// the next step fails.
    pub fn set_axes(&mut self, axes: [AxisControl; 3]) {
        if let Some(cell) = &mut self.setup.cell {
            cell.axes = axes;
        }
    }

    /// Brings the speeds of the axes to what they follow.
    pub(super) fn impose_speeds(&mut self) -> Result<(), WorldError> {
        let Some(cell) = self.setup.cell else {
            return Ok(());
        };
        cell.check(&self.state.space)?;
        for (axis, control) in cell.axes.into_iter().enumerate() {
            match control {
                AxisControl::Fixed => self.change_speed(axis, 0.0),
                AxisControl::Speed(speed) => self.change_speed(axis, speed),
                AxisControl::Stress(_) => {}
            }
        }
        Ok(())
    }

    /// A new speed of an axis, which every sphere shares.
    fn change_speed(&mut self, axis: usize, speed: f64) {
        let state = &mut self.state;
        let (Some(length), change) = (state.space.lengths()[axis], speed - state.speeds[axis])
        else {
            return;
        };
        if change == 0.0 {
            return;
        }
        state.speeds[axis] = speed;
        let spheres = state.spheres.iter_mut().zip(&state.positions);
        for (sphere, x) in spheres.filter(|(sphere, _)| !keeps_motion(sphere)) {
            let share = x[axis] / length * change;
            let old = sphere.velocity[axis];
            sphere.velocity[axis] = old + share;
            state.energy.work += share * (old + 0.5 * share) / sphere.inv_mass;
        }
    }

    /// What the loads of half a step do to the axes under a stress: forces times `time`, motion and stress times `half`.
    pub(super) fn kick_cell(&mut self, time: f64, half: f64) {
        let Some(cell) = self.setup.cell else {
            return;
        };
        self.state.energy.work -= self.cell_loads.crossing * time;
        if !cell.deforms() {
            return;
        }
        let state = &self.state;
        let mut moving = Vector3::zeros();
        let spheres = state.spheres.iter().zip(&state.positions);
        for (sphere, x) in spheres.filter(|(sphere, _)| !keeps_motion(sphere)) {
            let own = sphere.velocity - flow(&state.space, &state.speeds, cell.shear_rate, x);
            moving += own.component_mul(&own) / sphere.inv_mass;
        }
        let lengths = state.space.lengths().map(|length| length.unwrap_or(1.0));
        let volume = lengths.iter().product::<f64>();
        for (axis, control) in cell.axes.into_iter().enumerate() {
            if let AxisControl::Stress(stress) = control {
                let inside = self.cell_loads.virial[axis] * time + moving[axis] * half;
                let push = (inside - stress * volume * half) / lengths[axis];
                self.change_speed(axis, self.state.speeds[axis] + push / cell.mass);
            }
        }
    }

    /// Moves the images, and lets spheres that left the cell go on as their images.
    pub(super) fn drift_cell(&mut self, dt: f64) -> Result<(), WorldError> {
        let Some(cell) = self.setup.cell else {
            return Ok(());
        };
        let state = &mut self.state;
        let faster = cell.shear_rate * state.space.lengths()[2].unwrap_or(0.0);
        let images = faster.abs() + state.speeds.iter().map(|speed| speed.abs()).sum::<f64>();
        self.image_drift += images * dt;
        let step = state.steps;
        state.space = stretched(&state.space, &state.speeds, faster * dt, dt)
            .map_err(|cause| WorldError::Neighbours { step, cause })?;
        let bodies = (&mut state.spheres[..], &mut state.positions[..]);
        let images = (&state.space, &state.speeds, faster);
        state.energy.work += carry_on(images, bodies, &mut self.listed_at);
        Ok(())
    }

    /// Loads of the pairs on the cell.
    pub(super) fn load_cell(
        &self,
        loads: &mut CellLoads,
        bodies: [usize; 2],
        force: &Vector3<f64>,
        branch: &Vector3<f64>,
    ) {
        if let Some(cell) = &self.setup.cell {
            let [a, b] = bodies.map(|body| &self.state.positions[body]);
            let (_, border) = image(
                &self.state.space,
                &self.state.speeds,
                cell.shear_rate,
                [a, b],
            );
            loads.virial += force.component_mul(branch);
            loads.crossing += force.dot(&border);
        }
    }

    /// Adds the flow of the cell to the velocities of the spheres.
    pub(super) fn add_flow(&mut self) {
        let Some(cell) = self.setup.cell else {
            return;
        };
        let state = &mut self.state;
        for (control, speed) in cell.axes.iter().zip(&mut state.speeds) {
            if let AxisControl::Speed(given) = control {
                *speed = *given;
            }
        }
        for (sphere, x) in state.spheres.iter_mut().zip(&state.positions) {
            sphere.velocity += flow(&state.space, &state.speeds, cell.shear_rate, x);
        }
    }
}
