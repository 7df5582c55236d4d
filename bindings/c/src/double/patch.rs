//! Round contact patches: the coupled friction of sliding and spinning.
//!
//! The wrench acts on the patch, against its twist; the Jacobian is symmetric. At rest the wrench is
//! zero and the Jacobian is the limit of damping, infinite for Coulomb friction. NaN in gives NaN out.
//! The load is not validated: the caller must exclude a negative load (a contact that pulls).

use super::vectors::{tribos_jacobian_f64, tribos_twist_f64, tribos_wrench_f64};
use crate::memory::{answer, read};
use crate::status::tribos_status;
use crate::table::{build, held, tribos_power_compact_f64, tribos_power_table_f64};
use tribos_core::coupling::coulomb::{CoulombDisk, CoulombHertz, CoulombPunch, CoulombRing};
use tribos_core::coupling::table::DiskTable64;
use tribos_core::coupling::{Annulus, ReducedFriction, RoundFriction, compact};
use tribos_core::patch::PowerPressure;

/// A round contact patch.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct tribos_round_f64 {
    /// Friction coefficient mu, or coefficient of the power law, 0 <= coefficient < inf.
    pub coefficient: f64,
    /// Radius of the patch, positive and finite.
    pub radius: f64,
}

/// Wrench of one coupling.
#[inline(always)]
unsafe fn wrench_of<C: ReducedFriction<f64>>(
    coupling: C,
    patch: *const tribos_round_f64,
    load: f64,
    twist: *const tribos_twist_f64,
) -> Result<tribos_wrench_f64, tribos_status> {
    let (patch, twist) = (read(patch)?, read(twist)?);
    let friction = RoundFriction::new(coupling, patch.coefficient, patch.radius)?;
    Ok(friction.wrench(load, &twist.into()).into())
}

/// Jacobian of one coupling.
#[inline(always)]
unsafe fn jacobian_of<C: ReducedFriction<f64>>(
    coupling: C,
    patch: *const tribos_round_f64,
    load: f64,
    twist: *const tribos_twist_f64,
) -> Result<tribos_jacobian_f64, tribos_status> {
    let (patch, twist) = (read(patch)?, read(twist)?);
    let friction = RoundFriction::new(coupling, patch.coefficient, patch.radius)?;
    Ok(friction.wrench_jacobian(load, &twist.into()).into())
}

/// Uniform disk under Coulomb friction. Flash: 0.4 KiB of numbers (f32: 0.1).
/// Accuracy at speeds right to 2 ulp: 7 ulp in force, 8 in torque (f32: 8).
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tribos_disk_wrench_f64(
    patch: *const tribos_round_f64,
    load: f64,
    twist: *const tribos_twist_f64,
    wrench: *mut tribos_wrench_f64,
) -> tribos_status {
    answer(wrench, || wrench_of(CoulombDisk, patch, load, twist))
}

/// Jacobian of the uniform disk.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tribos_disk_jacobian_f64(
    patch: *const tribos_round_f64,
    load: f64,
    twist: *const tribos_twist_f64,
    jacobian: *mut tribos_jacobian_f64,
) -> tribos_status {
    answer(jacobian, || jacobian_of(CoulombDisk, patch, load, twist))
}

/// Annulus between inner_ratio and 1 radii under uniform pressure and Coulomb friction, from the disk.
/// Domain: 0 <= inner_ratio <= 0.999999. Accuracy: that of the disk times 2/(1 - inner_ratio), at most 32.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tribos_annulus_wrench_f64(
    patch: *const tribos_round_f64,
    inner_ratio: f64,
    load: f64,
    twist: *const tribos_twist_f64,
    wrench: *mut tribos_wrench_f64,
) -> tribos_status {
    answer(wrench, || {
        wrench_of(Annulus::new(CoulombDisk, inner_ratio)?, patch, load, twist)
    })
}

/// Jacobian of the annulus.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tribos_annulus_jacobian_f64(
    patch: *const tribos_round_f64,
    inner_ratio: f64,
    load: f64,
    twist: *const tribos_twist_f64,
    jacobian: *mut tribos_jacobian_f64,
) -> tribos_status {
    answer(jacobian, || {
        jacobian_of(Annulus::new(CoulombDisk, inner_ratio)?, patch, load, twist)
    })
}

/// Hertz' pressure (a ball on a plane) under Coulomb friction.
/// Accuracy at speeds right to 2 ulp: 7 ulp in force, 8 in torque (f32: 8).
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tribos_hertz_wrench_f64(
    patch: *const tribos_round_f64,
    load: f64,
    twist: *const tribos_twist_f64,
    wrench: *mut tribos_wrench_f64,
) -> tribos_status {
    answer(wrench, || wrench_of(CoulombHertz, patch, load, twist))
}

/// Jacobian under Hertz' pressure.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tribos_hertz_jacobian_f64(
    patch: *const tribos_round_f64,
    load: f64,
    twist: *const tribos_twist_f64,
    jacobian: *mut tribos_jacobian_f64,
) -> tribos_status {
    answer(jacobian, || jacobian_of(CoulombHertz, patch, load, twist))
}

/// A thin ring under Coulomb friction.
/// Accuracy at speeds right to 2 ulp: 12 ulp in force, 10 in torque (f32: 8).
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tribos_ring_wrench_f64(
    patch: *const tribos_round_f64,
    load: f64,
    twist: *const tribos_twist_f64,
    wrench: *mut tribos_wrench_f64,
) -> tribos_status {
    answer(wrench, || wrench_of(CoulombRing, patch, load, twist))
}

/// Jacobian of the ring. Special values: infinite where sliding and rim speed are equal.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tribos_ring_jacobian_f64(
    patch: *const tribos_round_f64,
    load: f64,
    twist: *const tribos_twist_f64,
    jacobian: *mut tribos_jacobian_f64,
) -> tribos_status {
    answer(jacobian, || jacobian_of(CoulombRing, patch, load, twist))
}

/// A rigid flat punch on an elastic half space under Coulomb friction.
/// Accuracy at speeds right to 2 ulp: 7 ulp in force, 8 in torque (f32: 8).
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tribos_punch_wrench_f64(
    patch: *const tribos_round_f64,
    load: f64,
    twist: *const tribos_twist_f64,
    wrench: *mut tribos_wrench_f64,
) -> tribos_status {
    answer(wrench, || wrench_of(CoulombPunch, patch, load, twist))
}

/// Jacobian of the flat punch.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tribos_punch_jacobian_f64(
    patch: *const tribos_round_f64,
    load: f64,
    twist: *const tribos_twist_f64,
    jacobian: *mut tribos_jacobian_f64,
) -> tribos_status {
    answer(jacobian, || jacobian_of(CoulombPunch, patch, load, twist))
}

/// Prepares one exponent, -1 < alpha <= 128, under the pressure (1-r^2)^q of order q, -1 <= q <= 8:
/// -1 ring, -1/2 flat punch, 0 uniform, 1/2 Hertz, 1 paraboloid. Cost: about 200 wrenches unless q = 0.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tribos_power_compact_build_f64(
    alpha: f64,
    pressure_order: f64,
    power: *mut tribos_power_compact_f64,
) -> tribos_status {
    build(power, || {
        #[allow(clippy::useless_conversion)] // Not in single precision.
        let pressure = PowerPressure::new(pressure_order.into())?;
        Ok::<_, tribos_status>(compact::CompactPower::with_pressure(alpha, pressure)?)
    })
}

/// Any exponent under any pressure (1-r^2)^q, without a table. Computes in double precision, for _f32
/// too, and is slow on a processor without it. Accuracy: 1e-14 relative for alpha >= -0.9 (f32: 10 ulp).
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tribos_power_compact_wrench_f64(
    power: *const tribos_power_compact_f64,
    patch: *const tribos_round_f64,
    load: f64,
    twist: *const tribos_twist_f64,
    wrench: *mut tribos_wrench_f64,
) -> tribos_status {
    answer(wrench, || wrench_of(held(power)?, patch, load, twist))
}

/// Jacobian of any exponent under any pressure (1-r^2)^q, without a table.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tribos_power_compact_jacobian_f64(
    power: *const tribos_power_compact_f64,
    patch: *const tribos_round_f64,
    load: f64,
    twist: *const tribos_twist_f64,
    jacobian: *mut tribos_jacobian_f64,
) -> tribos_status {
    answer(jacobian, || jacobian_of(held(power)?, patch, load, twist))
}

/// Builds the table of one exponent for the uniform disk, -1 < alpha <= 10, in the caller's memory:
/// 14 KiB (f32: 3). Cost: about 300,000 operations in double precision (f32: half as many, also in
/// double precision), and 49 KiB of stack on a Cortex-M4 (f32: 13).
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tribos_power_table_build_f64(
    alpha: f64,
    table: *mut tribos_power_table_f64,
) -> tribos_status {
    build(table, || DiskTable64::new(alpha))
}

/// Uniform disk under the power law, by a table built before; as fast as Coulomb friction except for
/// one power. Accuracy: 1.5e-15 relative for alpha >= -0.75 (f32: 5 ulp).
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tribos_power_table_wrench_f64(
    table: *const tribos_power_table_f64,
    patch: *const tribos_round_f64,
    load: f64,
    twist: *const tribos_twist_f64,
    wrench: *mut tribos_wrench_f64,
) -> tribos_status {
    answer(wrench, || wrench_of(held(table)?, patch, load, twist))
}

/// Jacobian of the uniform disk under the power law, by a table built before.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tribos_power_table_jacobian_f64(
    table: *const tribos_power_table_f64,
    patch: *const tribos_round_f64,
    load: f64,
    twist: *const tribos_twist_f64,
    jacobian: *mut tribos_jacobian_f64,
) -> tribos_status {
    answer(jacobian, || jacobian_of(held(table)?, patch, load, twist))
}
