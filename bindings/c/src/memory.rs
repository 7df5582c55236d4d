//! Access to the memory behind a caller's pointers.

use crate::status::tribos_status;

/// Elements of a batch that are converted at once, on the stack: two groups of the kernel's lanes.
pub(crate) const CHUNK: usize = 16;

/// A copy of the argument.
#[inline(always)]
pub(crate) unsafe fn read<T: Copy>(from: *const T) -> Result<T, tribos_status> {
    if from.is_null() {
        return Err(tribos_status::NullPointer);
    }
    Ok(from.read())
}

/// The `count` elements of an argument, in place.
#[inline(always)]
pub(crate) unsafe fn slice<'a, T>(from: *const T, count: usize) -> Result<&'a [T], tribos_status> {
    fits::<T>(from.is_null(), count)?;
    Ok(core::slice::from_raw_parts(from, count))
}

/// Memory for `count` results.
#[inline(always)]
pub(crate) unsafe fn slice_mut<'a, T>(
    to: *mut T,
    count: usize,
) -> Result<&'a mut [T], tribos_status> {
    fits::<T>(to.is_null(), count)?;
    Ok(core::slice::from_raw_parts_mut(to, count))
}

/// Pieces of N elements, the last one shorter. Unlike `chunks`, without a division that could panic.
#[inline(always)]
pub(crate) fn pieces<const N: usize, T>(of: &[T]) -> impl Iterator<Item = &[T]> {
    let (whole, rest) = of.as_chunks::<N>();
    let rest = (!rest.is_empty()).then_some(rest);
    whole.iter().map(<[T; N]>::as_slice).chain(rest)
}

/// [`pieces`] to write to.
#[inline(always)]
pub(crate) fn pieces_mut<const N: usize, T>(of: &mut [T]) -> impl Iterator<Item = &mut [T]> {
    let (whole, rest) = of.as_chunks_mut::<N>();
    let rest = (!rest.is_empty()).then_some(rest);
    whole.iter_mut().map(<[T; N]>::as_mut_slice).chain(rest)
}

/// Refuses null and arrays larger than half of the address space.
#[inline(always)]
fn fits<T>(is_null: bool, count: usize) -> Result<(), tribos_status> {
    if is_null {
        Err(tribos_status::NullPointer)
    } else if count > isize::MAX as usize / size_of::<T>() {
        Err(tribos_status::Count)
    } else {
        Ok(())
    }
}

/// Writes the result, or leaves the caller's memory unchanged.
#[inline(always)]
pub(crate) unsafe fn answer<T>(
    to: *mut T,
    result: impl FnOnce() -> Result<T, tribos_status>,
) -> tribos_status {
    if to.is_null() {
        return tribos_status::NullPointer;
    }
    match result() {
        Ok(value) => {
            to.write(value);
            tribos_status::Ok
        }
        Err(refusal) => refusal,
    }
}

/// The status of a call that writes its results in place.
#[inline(always)]
pub(crate) fn status(result: impl FnOnce() -> Result<(), tribos_status>) -> tribos_status {
    match result() {
        Ok(()) => tribos_status::Ok,
        Err(refusal) => refusal,
    }
}
