//! Contacts of spheres of one mass and radius, without what they have in common.

use nalgebra::Vector3;
use tribos_core::contact::{Contact, ContactModes, SphereBody};
use tribos_core::internals::{Block, PreparedContact};

/// What the contacts of alike spheres have in common.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Alike {
    /// Inverse mass and inertia of the spheres.
    pub inv_mass: f64,
    pub inv_inertia: f64,
    /// r_eff
    pub lever: f64,
    /// Effective masses along the normal, and of rolling and torsion.
    pub mass_normal: f64,
    pub inertia: f64,
}

impl Alike {
    /// What a contact of these spheres would have in common with others; `None` if the two differ, or do not move.
    pub fn of<M: ContactModes<f64>>(
        contact: &Contact<f64, M>,
        [a, b]: [&SphereBody<f64>; 2],
    ) -> Option<Self> {
        let block = contact.block();
        let alike = Self {
            inv_mass: a.inv_mass,
            inv_inertia: a.inv_inertia,
            lever: contact.effective_radius(),
            mass_normal: block.mass_normal,
            inertia: block.inertia,
        };
        let [arm, other] = contact.centre_distances();
        let same = (b.inv_mass, b.inv_inertia, other) == (a.inv_mass, a.inv_inertia, arm);
        // The second arm and the effective mass of sliding follow to the bit.
        let follows = block.coupling == 0.0 && block.mass_sliding == alike.mass_sliding(arm);
        (same && follows).then_some(alike)
    }

    /// Effective mass of sliding where both centres are so far from the contact.
    #[inline(always)]
    fn mass_sliding(&self, arm: f64) -> f64 {
        let turning = arm * arm * self.inv_inertia;
        1.0 / (self.inv_mass + self.inv_mass + turning + turning)
    }
}

/// A contact of alike spheres.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct AlikePair {
    /// The spheres; [`OPEN`] marks the second where cohesion lets an open gap stay.
    bodies: [u32; 2],
    pub normal: Vector3<f64>,
    /// Distance of both centres from the contact.
    pub arm: f64,
    pub cohesion: f64,
    pub allowance: f64,
}

/// Highest bit of a sphere's number.
const OPEN: u32 = 1 << 31;

impl AlikePair {
    /// *Domain*: numbers below 2³¹.
    pub fn new<M: ContactModes<f64>>([a, b]: [u32; 2], contact: &Contact<f64, M>) -> Self {
        let open = if contact.holds_gap_open() { OPEN } else { 0 };
        Self {
            bodies: [a, b | open],
            normal: *contact.normal(),
            arm: contact.centre_distances()[0],
            cohesion: contact.cohesion(),
            allowance: contact.approach_limit(),
        }
    }

    /// The numbers of the spheres.
    #[inline(always)]
    pub fn bodies(&self) -> [u32; 2] {
        [self.bodies[0], self.bodies[1] & !OPEN]
    }

    /// Whether cohesion lets the gap, now open, stay.
    #[inline(always)]
    pub fn rests_open(&self) -> bool {
        self.bodies[1] & OPEN != 0
    }

    /// The contact in full.
    #[inline(always)]
    pub fn prepared(&self, common: &Alike) -> PreparedContact<f64> {
        PreparedContact {
            normal: self.normal,
            arms: [self.arm; 2],
            lever: common.lever,
            block: Block {
                mass_normal: common.mass_normal,
                mass_sliding: common.mass_sliding(self.arm),
                inertia: common.inertia,
                coupling: 0.0,
            },
            cohesion: self.cohesion,
            allowance: self.allowance,
            rests_open: self.rests_open(),
        }
    }
}
