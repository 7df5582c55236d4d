//! Caller-provided memory for objects that take long to build.

use crate::status::tribos_status;
use tribos_core::coupling::compact::CompactPower;
use tribos_core::coupling::table::{DiskTable32, DiskTable64};

/// A table of one exponent, built by `tribos_power_table_build_f64`. Its content is opaque. It may be
/// copied and moved, but not to a program with another version of the library.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct tribos_power_table_f64 {
    /// Internal data.
    pub opaque: [f64; 1694],
    /// Marker of a completed build.
    pub built: u32,
}

/// A table of one exponent, built by `tribos_power_table_build_f32`. Its content is opaque. It may be
/// copied and moved, but not to a program with another version of the library.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct tribos_power_table_f32 {
    /// Internal data.
    pub opaque: [f32; 714],
    /// Marker of a completed build.
    pub built: u32,
}

/// One exponent under one pressure, built by `tribos_power_compact_build_f64`. Its content is opaque.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct tribos_power_compact_f64 {
    /// Internal data.
    pub opaque: [u64; 24],
    /// Marker of a completed build.
    pub built: u32,
}

/// One exponent under one pressure, built by `tribos_power_compact_build_f32`. Its content is opaque.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct tribos_power_compact_f32 {
    /// Internal data.
    pub opaque: [u64; 24],
    /// Marker of a completed build.
    pub built: u32,
}

/// Value of `built` after a build, unlikely to occur in other memory.
const BUILT: u32 = 0x7472_6962;

/// Caller-provided memory whose first field has room for `Object`.
pub(crate) trait CallerMemory {
    /// The object built there.
    type Object;
    /// Address of the marker, which only [`build`] writes.
    unsafe fn built(lent: *const Self) -> *const u32;
}

/// Says what object memory of the caller holds.
macro_rules! lent {
    ($($lent:ident for $held:ty;)*) => {$(
        impl $crate::table::CallerMemory for $lent {
            type Object = $held;
            #[inline(always)]
            unsafe fn built(lent: *const Self) -> *const u32 {
                core::ptr::addr_of!((*lent).built)
            }
        }
        const _: () = {
            assert!(size_of::<$held>() <= core::mem::offset_of!($lent, built));
            assert!(align_of::<$held>() <= align_of::<$lent>());
        };
    )*};
}

pub(crate) use lent;

lent! {
    tribos_power_table_f64 for DiskTable64;
    tribos_power_table_f32 for DiskTable32;
    tribos_power_compact_f64 for CompactPower<f64>;
    tribos_power_compact_f32 for CompactPower<f32>;
}

/// Builds the object in the caller's memory, or leaves the memory unchanged.
#[inline(always)]
pub(crate) unsafe fn build<L: CallerMemory, E: Into<tribos_status>>(
    lent: *mut L,
    held: impl FnOnce() -> Result<L::Object, E>,
) -> tribos_status {
    if lent.is_null() {
        return tribos_status::NullPointer;
    }
    match held() {
        Ok(held) => {
            lent.cast::<L::Object>().write(held);
            L::built(lent).cast_mut().write(BUILT);
            tribos_status::Ok
        }
        Err(refusal) => refusal.into(),
    }
}

/// The object in the caller's memory, by reference.
#[inline(always)]
pub(crate) unsafe fn held<'a, L: CallerMemory>(
    lent: *const L,
) -> Result<&'a L::Object, tribos_status> {
    if lent.is_null() {
        Err(tribos_status::NullPointer)
    } else if L::built(lent).read() != BUILT {
        Err(tribos_status::NotBuilt)
    } else {
        Ok(&*lent.cast::<L::Object>())
    }
}
