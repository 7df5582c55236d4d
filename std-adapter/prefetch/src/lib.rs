//! A hint that a value will be used soon.
//!
//! A loop over contacts reads two bodies at a time from places that no processor can guess. Where they do not
//! fit into the caches, most of its time is waiting; asked some turns ahead, the bodies are there. This crate
//! is that one instruction, apart from a library that denies unsafe code. It changes no results.
#![no_std]

/// Bytes of a cache line.
const LINE: usize = 64;

/// Asks for the cache lines of the first and last byte of a value, if there is one at this place; nothing on other
/// processors than x86-64 and AArch64.
///
/// ```
/// use tribos_prefetch::prefetch;
/// let (places, order) = ([1.0, 2.0, 3.0], [2, 0, 1]);
/// let mut sum = 0.0;
/// for (turn, at) in order.into_iter().enumerate() {
///     if let Some(next) = order.get(turn + 1) {
///         prefetch(&raw const places[*next]);
///     }
///     sum += places[at];
/// }
/// assert_eq!(sum, 6.0);
/// ```
#[inline(always)]
pub fn prefetch<T>(place: *const T) {
    let first = place.cast::<u8>();
    line(first);
    let size = size_of::<T>();
    // A value may begin in one line and end in the next.
    if size > 1 && align_of::<T>() < LINE {
        line(first.wrapping_add(size - 1));
    }
}

#[cfg(target_arch = "x86_64")]
#[inline(always)]
#[allow(unsafe_code)] // One instruction.
fn line(place: *const u8) {
    // SAFETY: a prefetch reads nothing that a program sees and cannot fault, wherever it points.
    unsafe {
        core::arch::x86_64::_mm_prefetch::<{ core::arch::x86_64::_MM_HINT_T0 }>(place.cast());
    }
}

#[cfg(target_arch = "aarch64")]
#[inline(always)]
#[allow(unsafe_code)] // One instruction.
fn line(place: *const u8) {
    // SAFETY: a prefetch reads nothing that a program sees and cannot fault, wherever it points.
    unsafe {
        core::arch::asm!(
            "prfm pldl1keep, [{place}]",
            place = in(reg) place,
            options(readonly, nostack, preserves_flags),
        );
    }
}

#[cfg(not(any(target_arch = "x86_64", target_arch = "aarch64")))]
#[inline(always)]
fn line(_: *const u8) {}
