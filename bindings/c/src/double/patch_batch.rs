//! Many twists of one round patch under one load.
//!
//! The results have the bits of single calls. Tables compute eight twists side by side where the processor has
//! vectors. The two arrays must not overlap.

use super::patch::tribos_round_f64;
use super::vectors::{tribos_jacobian_f64, tribos_twist_f64, tribos_wrench_f64};
use crate::memory::{CHUNK, pieces, pieces_mut, read, slice, slice_mut, status};
use crate::status::tribos_status;
use crate::table::{held, tribos_power_table_f64};
use tribos_core::coupling::coulomb::CoulombDisk;
use tribos_core::coupling::{ReducedFriction, RoundFriction};
use tribos_core::real::Real;
use tribos_core::twist::{Twist, Wrench, WrenchJacobian};

/// The arguments of a batch behind its coupling.
struct Batch<T> {
    patch: *const tribos_round_f64,
    load: f64,
    twists: *const tribos_twist_f64,
    count: usize,
    results: *mut T,
}

impl<T> Batch<T> {
    /// Calls `all` with the kernel's structures of up to `CHUNK` twists at a time.
    #[inline(always)]
    unsafe fn each<C: ReducedFriction<f64>, K: Copy + Into<T>>(
        self,
        coupling: C,
        blank: K,
        all: impl Fn(&RoundFriction<f64, C>, &[Twist<f64>], &mut [K]),
    ) -> Result<(), tribos_status> {
        let patch = read(self.patch)?;
        let friction = RoundFriction::new(coupling, patch.coefficient, patch.radius)?;
        let twists = pieces::<CHUNK, _>(slice(self.twists, self.count)?);
        let results = pieces_mut::<CHUNK, _>(slice_mut(self.results, self.count)?);
        let mut motions = [Twist::ZERO; CHUNK];
        let mut answers = [blank; CHUNK];
        for (twists, results) in twists.zip(results) {
            for (to, from) in motions.iter_mut().zip(twists) {
                *to = (*from).into();
            }
            let asked = motions.get(..twists.len()).unwrap_or(&motions);
            all(&friction, asked, &mut answers);
            for (to, from) in results.iter_mut().zip(answers) {
                *to = from.into();
            }
        }
        Ok(())
    }
}

impl Batch<tribos_wrench_f64> {
    #[inline(always)]
    unsafe fn wrenches<C: ReducedFriction<f64>>(self, coupling: C) -> Result<(), tribos_status> {
        let load = self.load;
        self.each(coupling, Wrench::ZERO, |friction, twists, wrenches| {
            friction.wrench_batch(load, twists, wrenches);
        })
    }
}

impl Batch<tribos_jacobian_f64> {
    #[inline(always)]
    unsafe fn jacobians<C: ReducedFriction<f64>>(self, coupling: C) -> Result<(), tribos_status> {
        let load = self.load;
        let blank = WrenchJacobian::from_element(f64::ZERO);
        self.each(coupling, blank, |friction, twists, jacobians| {
            friction.jacobian_batch(load, twists, jacobians);
        })
    }
}

/// Wrenches of `count` twists under one load, to the bits of tribos_disk_wrench_f64.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tribos_disk_wrench_batch_f64(
    patch: *const tribos_round_f64,
    load: f64,
    twists: *const tribos_twist_f64,
    count: usize,
    wrenches: *mut tribos_wrench_f64,
) -> tribos_status {
    let batch = Batch {
        patch,
        load,
        twists,
        count,
        results: wrenches,
    };
    status(|| batch.wrenches(CoulombDisk))
}

/// Jacobians of `count` twists under one load, to the bits of tribos_disk_jacobian_f64.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tribos_disk_jacobian_batch_f64(
    patch: *const tribos_round_f64,
    load: f64,
    twists: *const tribos_twist_f64,
    count: usize,
    jacobians: *mut tribos_jacobian_f64,
) -> tribos_status {
    let batch = Batch {
        patch,
        load,
        twists,
        count,
        results: jacobians,
    };
    status(|| batch.jacobians(CoulombDisk))
}

/// Wrenches of `count` twists under one load, to the bits of tribos_power_table_wrench_f64.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tribos_power_table_wrench_batch_f64(
    table: *const tribos_power_table_f64,
    patch: *const tribos_round_f64,
    load: f64,
    twists: *const tribos_twist_f64,
    count: usize,
    wrenches: *mut tribos_wrench_f64,
) -> tribos_status {
    let batch = Batch {
        patch,
        load,
        twists,
        count,
        results: wrenches,
    };
    status(|| batch.wrenches(held(table)?))
}

/// Jacobians of `count` twists under one load, to the bits of tribos_power_table_jacobian_f64.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tribos_power_table_jacobian_batch_f64(
    table: *const tribos_power_table_f64,
    patch: *const tribos_round_f64,
    load: f64,
    twists: *const tribos_twist_f64,
    count: usize,
    jacobians: *mut tribos_jacobian_f64,
) -> tribos_status {
    let batch = Batch {
        patch,
        load,
        twists,
        count,
        results: jacobians,
    };
    status(|| batch.jacobians(held(table)?))
}
