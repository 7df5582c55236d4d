//! Contacts of spheres four to a record, number by number, as sweeps read them.

use std::ops::Range;
use tribos_core::internals::{Block, PreparedContact};
use tribos_core::nalgebra::Vector3;

/// Number of contacts in a record.
pub(super) const LANES: usize = 4;

/// Highest bit of a sphere's number.
const OPEN: u32 = 1 << 31;

/// Up to four contacts without their impulses. What a record does not hold is 0.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[repr(C, align(32))]
pub(super) struct Quad {
    /// The first and the second spheres; [`OPEN`] marks a second one where cohesion lets an open gap stay.
    bodies: [[u32; LANES]; 2],
    pub normal: [[f64; LANES]; 3],
    /// Distances of the first and of the second centres from the contacts.
    pub arms: [[f64; LANES]; 2],
    /// r_eff
    pub lever: [f64; LANES],
    pub mass_normal: [f64; LANES],
    pub mass_sliding: [f64; LANES],
    /// Effective moment of inertia, of rolling and of torsion.
    pub inertia: [f64; LANES],
    /// Coupling k of sliding and rolling.
    pub coupling: [f64; LANES],
    pub cohesion: [f64; LANES],
    pub allowance: [f64; LANES],
}

impl Quad {
    /// Puts a contact into a lane. *Domain*: numbers of spheres below 2³¹.
    pub fn set(&mut self, lane: usize, [a, b]: [u32; 2], contact: &PreparedContact<f64>) {
        let open = if contact.rests_open { OPEN } else { 0 };
        (self.bodies[0][lane], self.bodies[1][lane]) = (a, b | open);
        for (axis, normal) in self.normal.iter_mut().zip(contact.normal.iter()) {
            axis[lane] = *normal;
        }
        let (block, [first, second]) = (&contact.block, &mut self.arms);
        for (list, number) in [
            (first, contact.arms[0]),
            (second, contact.arms[1]),
            (&mut self.lever, contact.lever),
            (&mut self.mass_normal, block.mass_normal),
            (&mut self.mass_sliding, block.mass_sliding),
            (&mut self.inertia, block.inertia),
            (&mut self.coupling, block.coupling),
            (&mut self.cohesion, contact.cohesion),
            (&mut self.allowance, contact.allowance),
        ] {
            list[lane] = number;
        }
    }

    /// The contact in a lane.
    #[inline(always)]
    pub fn prepared(&self, lane: usize) -> PreparedContact<f64> {
        let [x, y, z] = &self.normal;
        PreparedContact {
            normal: Vector3::new(x[lane], y[lane], z[lane]),
            arms: [self.arms[0][lane], self.arms[1][lane]],
            lever: self.lever[lane],
            block: Block {
                mass_normal: self.mass_normal[lane],
                mass_sliding: self.mass_sliding[lane],
                inertia: self.inertia[lane],
                coupling: self.coupling[lane],
            },
            cohesion: self.cohesion[lane],
            allowance: self.allowance[lane],
            rests_open: self.bodies[1][lane] & OPEN != 0,
        }
    }

    /// The numbers of the spheres in a lane.
    #[inline(always)]
    pub fn bodies(&self, lane: usize) -> [u32; 2] {
        [self.bodies[0][lane], self.bodies[1][lane] & !OPEN]
    }

    /// Whether the four contacts can be solved side by side: no two share a sphere, no gap rests open.
    pub fn are_apart(&self) -> bool {
        (0..LANES).all(|lane| {
            let own = self.bodies(lane);
            let mut others = (0..lane).flat_map(|other| self.bodies(other));
            !self.prepared(lane).rests_open && others.all(|body| !own.contains(&body))
        })
    }
}

/// The contacts of one record.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Group {
    /// Number of the first of them; the others follow it.
    pub first: u32,
    /// Number of contacts, 1 to 4.
    pub count: u32,
    /// Whether the four are solved side by side.
    pub together: bool,
}

impl Group {
    /// Numbers of the contacts.
    pub fn contacts(self) -> Range<usize> {
        let first = self.first as usize;
        first..first + self.count as usize
    }
}
