//! A disk by its numbers, or a prepared patch by its handle.

use crate::exchange::Refused;
use crate::modes::FinalMotion;
use crate::slide::{End, Free};
use tribos_core::coupling::table::CoulombDisk;
use tribos_core::coupling::{ReducedFriction, RoundFriction};
use tribos_core::limit_surface::{FrictionSet, RoundLimitSurface};
use tribos_core::slider::{SliderParameters, SliderState};
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

/// Work with a limit surface.
pub type Work<'a> = &'a mut dyn FnMut(&dyn FrictionSet<f64>);

/// Free motion on a round patch under a power of the speed.
pub trait Glides {
    /// See [`End::to_rest`].
    fn to_rest(&self, parameters: SliderParameters<f64>, from: &SliderState<f64>) -> Free;
    /// See [`End::advance`].
    fn advance(
        &self,
        parameters: SliderParameters<f64>,
        from: &SliderState<f64>,
        time: f64,
    ) -> Free;
    /// Fixed points and last motion.
    fn modes(&self, inertia_ratio: f64, initial_ratio: f64) -> Result<FinalMotion, Refused>;
}

impl<P> Glides for P
where
    P: tribos_core::coupling::PowerLawFriction<f64> + ReducedFriction<f64>,
{
    fn to_rest(&self, parameters: SliderParameters<f64>, from: &SliderState<f64>) -> Free {
        End::to_rest(self, parameters, from)
    }
    fn advance(
        &self,
        parameters: SliderParameters<f64>,
        from: &SliderState<f64>,
        time: f64,
    ) -> Free {
        End::advance(self, parameters, from, time)
    }
    fn modes(&self, inertia_ratio: f64, initial_ratio: f64) -> Result<FinalMotion, Refused> {
        FinalMotion::new(self, inertia_ratio, initial_ratio)
    }
}

/// A patch as JavaScript names it.
#[derive(Clone, Copy, Debug)]
pub struct Patch {
    /// A prepared patch, or 0 for a disk under Coulomb friction.
    pub handle: u32,
    /// Radius of the disk, in m.
    pub radius: f64,
    /// Coefficient of friction of the disk.
    pub mu: f64,
}

impl Patch {
    /// Works with its friction.
    #[inline]
    pub fn contact<T>(&self, work: impl FnOnce(&dyn Contact) -> T) -> Result<T, Refused> {
        #[cfg(feature = "all")]
        if self.handle != 0 {
            return crate::all::store::with(self.handle, |patch| Ok(work(&patch.contact)));
        }
        Ok(work(&RoundFriction::new(
            CoulombDisk,
            self.mu,
            self.radius,
        )?))
    }

    /// Works with its limit surface for the force limit μN.
    #[inline(never)]
    pub fn set(&self, force_limit: f64, work: Work<'_>) -> Result<(), Refused> {
        #[cfg(feature = "all")]
        if self.handle != 0 {
            return crate::all::store::with(self.handle, |patch| {
                Ok(patch.sets()?.under(force_limit, work)?)
            });
        }
        work(&RoundLimitSurface::new(
            CoulombDisk,
            force_limit,
            self.radius,
        )?);
        Ok(())
    }

    /// Works with its free motions.
    #[inline]
    pub fn glides<T>(
        &self,
        work: impl FnOnce(&dyn Glides) -> Result<T, Refused>,
    ) -> Result<T, Refused> {
        #[cfg(feature = "all")]
        if self.handle != 0 {
            return crate::all::store::with(self.handle, |patch| work(patch.glides()?));
        }
        work(&CoulombDisk)
    }

    /// Whether it turns with the body.
    pub fn turns(&self) -> bool {
        #[cfg(feature = "all")]
        if self.handle != 0 {
            return crate::all::store::with(self.handle, |patch| Ok(!patch.area.is_round()))
                .unwrap_or(false);
        }
        false
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
pub fn first<T>(of: &[T], count: usize) -> &[T] {
    of.get(..count).unwrap_or(of)
}

/// The first `count`, or all, to be written.
pub fn first_mut<T>(of: &mut [T], count: usize) -> &mut [T] {
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
