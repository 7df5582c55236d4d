//! Simple shear of a periodic cell: velocity along x in proportion to height along z.
//!
//! Images one period higher move faster by rate × height (Lees and Edwards, J. Phys. C 5 (1972) 1921). The
//! profile has speed 0 at half the height of the cell. A sphere that leaves the cell through its top
//! or bottom goes on as its image inside; the change of its velocity is work of the shear.

use super::cell;
use super::energy::kinetic_energy;
use super::residual::Coefficients;
use super::world::World;
use nalgebra::Vector3;
use tribos_base::space::PeriodicBox;
use tribos_core::contact::{ContactFriction, SphereBody};

/// Velocity of the flow at a height in a cell.
pub(super) fn flow(rate: f64, space: &PeriodicBox, z: f64) -> Vector3<f64> {
    let middle = 0.5 * space.lengths()[2].unwrap_or(0.0);
    Vector3::x() * (rate * (z - middle))
}

impl<F: ContactFriction<f64> + Coefficients> World<F> {
    /// The periodic box with its images at their current places.
    pub fn space(&self) -> PeriodicBox {
        match &self.state.cell {
            Some(cell) => cell.space,
            None => self.setup.space.sheared(self.state.shear_offset),
        }
    }

    /// Velocity of the images one period higher, relative to the spheres.
    pub(super) fn level_velocity(&self) -> Vector3<f64> {
        let height = self.space().lengths()[2].unwrap_or(0.0);
        Vector3::x() * (self.setup.shear_rate * height)
    }

    /// Speed of a sphere; in a shear, relative to the flow at its height.
    pub(super) fn own_speed(&self, body: usize, sphere: &SphereBody<f64>) -> f64 {
        let rate = self.setup.shear_rate;
        if let Some(cell) = &self.state.cell {
            let x = &self.state.positions[body];
            return (sphere.velocity - cell::flow(&cell.space, &cell.speeds, rate, x)).norm();
        }
        if rate == 0.0 {
            return sphere.velocity.norm();
        }
        let z = self.state.positions[body].z;
        (sphere.velocity - flow(rate, &self.setup.space, z)).norm()
    }

    /// Half of the largest speed at which a shear moves two spheres that may touch past each other, and the speed of the
    /// images of a cell that deforms.
    pub(super) fn shear_speed(&self) -> f64 {
        let rate = self.setup.shear_rate.abs();
        let [images, _] = self.cell_motion();
        if rate == 0.0 {
            return images;
        }
        let widest = self.setup.radii.iter().fold(0.0, |most, &r| r.max(most));
        images + 0.5 * rate * (2.0 * widest + self.reach())
    }

    /// Moves the images, and lets spheres that left the cell through its top or bottom go on as their images.
    pub(super) fn shear(&mut self, dt: f64) {
        let [Some(length), _, Some(height)] = self.setup.space.lengths() else {
            return;
        };
        if self.setup.shear_rate == 0.0 || self.state.cell.is_some() {
            return;
        }
        let faster = self.level_velocity();
        self.drift += faster.norm() * dt;
        let offset = self.state.shear_offset + faster.x * dt;
        self.state.shear_offset = offset.rem_euclid(length);

        let space = self.space();
        let state = &mut self.state;
        for (body, sphere) in state.spheres.iter_mut().enumerate() {
            let x = &mut state.positions[body];
            let levels = space.level(x.z);
            if levels == 0.0 {
                continue;
            }
            let jump = Vector3::new(space.offset(), 0.0, height) * levels;
            *x -= jump;
            if let Some(listed) = self.listed_at.get_mut(body) {
                *listed -= jump;
            }
            let old = sphere.velocity;
            sphere.velocity -= faster * levels;
            let energy = |v| kinetic_energy(sphere, v, &sphere.spin);
            state.energy.cross(energy(&old), energy(&sphere.velocity));
        }
    }
}
