//! The energy balance of soft spheres.

use super::contact::Energies;
use super::world::{SoftState, SoftWorld};
use crate::cd::{Wall, WorldError, keeps_motion};
use tribos_core::contact::{ContactFriction, SphereBody};

impl<F: ContactFriction<f64>> SoftWorld<F> {
    /// Energies of all contacts, added in their order.
    pub(super) fn sum(&self) -> Result<Energies, WorldError> {
        let [pairs, walls] = &self.state.contacts;
        let mut sum = Energies::default();
        for (index, energies) in self.energies.iter().enumerate() {
            match energies {
                Ok(energies) => sum.add(energies),
                Err(cause) => {
                    let pair = pairs.get(index).map(|c| (c.bodies, "sphere"));
                    let wall = walls.get(index.wrapping_sub(pairs.len()));
                    let other = pair.or(wall.map(|c| (c.bodies, "wall")));
                    let ([body, other], kind) = other.unwrap_or(([0; 2], "body"));
                    return Err(WorldError::Touch {
                        step: self.state.steps,
                        body: body as usize,
                        other: format!("{kind} {other}"),
                        cause: *cause,
                    });
                }
            }
        }
        Ok(sum)
    }

    /// Kinetic energy of spheres and pistons.
    pub(super) fn kinetic(&self) -> f64 {
        let sphere = |sphere: &SphereBody<f64>| {
            if keeps_motion(sphere) {
                return 0.0;
            }
            sphere.velocity.norm_squared() / sphere.inv_mass
                + sphere.spin.norm_squared() / sphere.inv_inertia
        };
        let pistons = self
            .state
            .walls
            .iter()
            .filter(|wall| wall.plate.inv_mass > 0.0);
        let piston = |wall: &Wall| wall.plate.velocity.norm_squared() / wall.plate.inv_mass;
        let spheres: f64 = self.state.spheres.iter().map(sphere).sum();
        0.5 * (spheres + pistons.map(piston).sum::<f64>())
    }

    /// Enters the energies of a step into the balance.
    pub(super) fn enter(&mut self, taken: &Energies) {
        let kinetic = self.kinetic();
        let SoftState { energy, origin, .. } = &mut self.state;
        let [elastic, cohesion] = origin.unwrap_or_default();
        energy.elastic = taken.elastic - elastic;
        energy.cohesion = taken.cohesion - cohesion;
        energy.normal += taken.normal;
        energy.sliding += taken.sliding;
        energy.rolling += taken.rolling;
        energy.torsion += taken.torsion;
        energy.kinetic = kinetic;
    }
}
