//! Friction of a contact at one motion, and at rows of them.

use tribos_core::coupling::{ReducedFriction, RoundFriction};
use tribos_core::twist::{Twist, Wrench, WrenchJacobian};

/// Friction of a contact at one motion.
pub trait Contact {
    /// The wrench on the patch.
    fn wrench(&self, load: f64, twist: &Twist<f64>) -> Wrench<f64>;
    /// Its derivative.
    fn jacobian(&self, load: f64, twist: &Twist<f64>) -> WrenchJacobian<f64>;

    /// The wrenches of some twists under one load, to the same bits.
    fn wrench_batch(&self, load: f64, twists: &[Twist<f64>], wrenches: &mut [Wrench<f64>]) {
        for (wrench, twist) in wrenches.iter_mut().zip(twists) {
            *wrench = self.wrench(load, twist);
        }
    }

    /// Their derivatives.
    fn jacobian_batch(
        &self,
        load: f64,
        twists: &[Twist<f64>],
        jacobians: &mut [WrenchJacobian<f64>],
    ) {
        for (jacobian, twist) in jacobians.iter_mut().zip(twists) {
            *jacobian = self.jacobian(load, twist);
        }
    }
}

impl<C: ReducedFriction<f64>> Contact for RoundFriction<f64, C> {
    #[inline]
    fn wrench(&self, load: f64, twist: &Twist<f64>) -> Wrench<f64> {
        RoundFriction::wrench(self, load, twist)
    }
    #[inline]
    fn jacobian(&self, load: f64, twist: &Twist<f64>) -> WrenchJacobian<f64> {
        self.wrench_jacobian(load, twist)
    }
    #[inline]
    fn wrench_batch(&self, load: f64, twists: &[Twist<f64>], wrenches: &mut [Wrench<f64>]) {
        RoundFriction::wrench_batch(self, load, twists, wrenches);
    }
    #[inline]
    fn jacobian_batch(
        &self,
        load: f64,
        twists: &[Twist<f64>],
        jacobians: &mut [WrenchJacobian<f64>],
    ) {
        RoundFriction::jacobian_batch(self, load, twists, jacobians);
    }
}

/// Number of elements that are computed together: in the cache, and enough for tables that go side by
/// side.
const TOGETHER: usize = 64;

/// Twists in rows, zero after the last.
fn together(rows: &[[f64; 3]]) -> [Twist<f64>; TOGETHER] {
    let mut twists = [Twist::ZERO; TOGETHER];
    for (twist, row) in twists.iter_mut().zip(rows) {
        *twist = twist_of(*row);
    }
    twists
}

/// The first `count`, or all.
fn first<T>(of: &[T], count: usize) -> &[T] {
    of.get(..count).unwrap_or(of)
}

/// The first `count`, or all, to be written.
fn first_mut<T>(of: &mut [T], count: usize) -> &mut [T] {
    let count = count.min(of.len());
    of.split_at_mut_checked(count)
        .map_or(&mut [], |(first, _)| first)
}

/// A row as a twist.
#[inline]
pub fn twist_of([x, y, spin]: [f64; 3]) -> Twist<f64> {
    Twist::new(x, y, spin)
}

/// A row as a wrench.
#[inline]
pub fn wrench_of([x, y, torque]: [f64; 3]) -> Wrench<f64> {
    Wrench::new(x, y, torque)
}

/// A wrench as a row.
#[inline]
pub fn row_of(wrench: &Wrench<f64>) -> [f64; 3] {
    [wrench.force.x, wrench.force.y, wrench.torque]
}

/// A twist as a row.
#[inline]
pub fn row_of_twist(twist: &Twist<f64>) -> [f64; 3] {
    [twist.velocity.x, twist.velocity.y, twist.spin]
}

/// Twists become wrenches under one load, in place.
pub fn wrenches(contact: &dyn Contact, load: f64, rows: &mut [[f64; 3]]) {
    let mut wrenches = [Wrench::ZERO; TOGETHER];
    for rows in rows.chunks_mut(TOGETHER) {
        let twists = together(rows);
        let twists = first(&twists, rows.len());
        contact.wrench_batch(load, twists, first_mut(&mut wrenches, twists.len()));
        for (row, wrench) in rows.iter_mut().zip(&wrenches) {
            *row = row_of(wrench);
        }
    }
}

/// Jacobians of twists under one load, row by row.
pub fn jacobians(contact: &dyn Contact, load: f64, twists: &[[f64; 3]], out: &mut [[f64; 9]]) {
    let mut jacobians = [WrenchJacobian::zeros(); TOGETHER];
    for (rows, out) in twists.chunks(TOGETHER).zip(out.chunks_mut(TOGETHER)) {
        let twists = together(rows);
        let twists = first(&twists, rows.len());
        contact.jacobian_batch(load, twists, first_mut(&mut jacobians, twists.len()));
        for (row, jacobian) in out.iter_mut().zip(&jacobians) {
            *row = nine(jacobian);
        }
    }
}

/// A Jacobian row by row; it is symmetric, so that columns are rows.
pub fn nine(jacobian: &WrenchJacobian<f64>) -> [f64; 9] {
    let mut row = [0.0; 9];
    for (slot, entry) in row.iter_mut().zip(jacobian.iter()) {
        *slot = *entry;
    }
    row
}
