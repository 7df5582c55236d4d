//! Functions of the kernel over rows of numbers, in both precisions: as programs of a GPU where the target is nvptx64, as
//! loops of a library where it is the host.
//!
//! Both are made of one list, so that a row means the same to both. `disk_f32(inputs, outputs, rows)` reads six numbers
//! a row and writes three; [`functions`] says what they are. Numbers outside of a constructor's domain give NaN.
#![cfg_attr(target_arch = "nvptx64", no_std, feature(abi_ptx, stdarch_nvptx))]

#[cfg(target_arch = "nvptx64")]
mod device;
mod functions;
#[cfg(not(target_arch = "nvptx64"))]
mod host;
#[cfg(not(target_arch = "nvptx64"))]
mod random;
#[cfg(not(target_arch = "nvptx64"))]
mod rows;

#[cfg(target_arch = "nvptx64")]
use device::each_row;
#[cfg(not(target_arch = "nvptx64"))]
use host::each_row;

/// Writes a function's answers.
///
/// # Safety
/// `inputs` and `outputs` have as many `rows`.
#[inline(always)]
unsafe fn answer<R: Copy, const IN: usize, const OUT: usize>(
    function: impl Fn([R; IN]) -> [R; OUT],
    [inputs, outputs]: [*mut R; 2],
    rows: u64,
) {
    let (inputs, outputs) = (inputs.cast::<[R; IN]>(), outputs.cast::<[R; OUT]>());
    // SAFETY: the row is below `rows`, and no other thread has it.
    each_row(rows, |row| unsafe {
        *outputs.add(row) = function(*inputs.add(row));
    });
}

/// Functions in one precision, under names that end with it.
macro_rules! programs {
    ($real:ident, $ending:literal, $abi:literal, $($name:ident)*) => {
        #[doc = concat!("The functions in `", stringify!($real), "`.")]
        pub mod $real {
            $(
                /// The function of each row.
                ///
                /// # Safety
                /// `inputs` and `outputs` have as many `rows`.
                #[unsafe(export_name = concat!(stringify!($name), $ending))]
                pub unsafe extern $abi fn $name(inputs: *mut $real, outputs: *mut $real, rows: u64) {
                    // SAFETY: as promised.
                    unsafe { crate::answer(crate::functions::$name::<$real>, [inputs, outputs], rows) }
                }
            )*
        }
    };
}

macro_rules! list {
    ($($name:ident: $rows:ident;)*) => {
        #[cfg(target_arch = "nvptx64")]
        programs!(f32, "_f32", "ptx-kernel", $($name)*);
        #[cfg(target_arch = "nvptx64")]
        programs!(f64, "_f64", "ptx-kernel", $($name)*);
        #[cfg(not(target_arch = "nvptx64"))]
        programs!(f32, "_f32", "C", $($name)*);
        #[cfg(not(target_arch = "nvptx64"))]
        programs!(f64, "_f64", "C", $($name)*);
        #[cfg(not(target_arch = "nvptx64"))]
        host::listed!($($name: $rows;)*);
    };
}

// Each function, and the rows that it is compared on.
list! {
    disk: round;
    ring: round;
    punch: round;
    hertz: round;
    paraboloid: round;
    polygon: polygon;
    project: projection;
    polygon_project: polygon_projection;
    step: step;
    manifold: manifold;
    plank: plank;
}
