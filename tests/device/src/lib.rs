//! Functions of the kernel over rows of numbers, in both precisions: as programs of a GPU where the target is nvptx64, as
//! loops of a library where it is the host.
//!
//! Both are made of one list, so that a row means the same to both. `disk_f32(inputs, outputs, rows)` reads six numbers
//! a row and writes three; `inputs(function)` and `outputs(function)` say how many. Numbers outside of a constructor's domain give NaN.
#![cfg_attr(target_arch = "nvptx64", no_std, feature(abi_ptx, stdarch_nvptx))]

mod functions;
#[cfg(not(target_arch = "nvptx64"))]
mod rows;

#[cfg(target_arch = "nvptx64")]
#[panic_handler]
fn panic(_: &core::panic::PanicInfo) -> ! {
    // SAFETY: ends the program.
    unsafe { core::arch::nvptx::trap() }
}

/// Calls `of` with this thread's row, on the host with one row after the other.
#[inline(always)]
fn each_row(rows: u64, of: impl Fn(usize)) {
    #[cfg(target_arch = "nvptx64")]
    {
        use core::arch::nvptx::{_block_dim_x, _block_idx_x, _thread_idx_x};
        // SAFETY: they read registers.
        let [block, width, thread] =
            unsafe { [_block_idx_x(), _block_dim_x(), _thread_idx_x()] }.map(|index| index as u64);
        let row = block * width + thread;
        if row < rows {
            of(row as usize);
        }
    }
    #[cfg(not(target_arch = "nvptx64"))]
    (0..rows as usize).for_each(of);
}

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
    each_row(rows, |row| unsafe { *outputs.add(row) = function(*inputs.add(row)) });
}

macro_rules! entries {
    ($real:ident, $ending:literal, $abi:literal: $($name:ident)*) => {
        /// The functions in this precision.
        pub mod $real {
            $(
                #[doc = concat!("`", stringify!($name), "` of each row.\n\n# Safety\n`inputs` and `outputs` have as many `rows`.")]
                #[unsafe(export_name = concat!(stringify!($name), $ending))]
                pub unsafe extern $abi fn $name(inputs: *mut $real, outputs: *mut $real, rows: u64) {
                    // SAFETY: as promised.
                    unsafe { super::answer(crate::functions::$name::<$real>, [inputs, outputs], rows) }
                }
            )*
        }
    };
}

macro_rules! list {
    ($($name:ident: $rows:ident;)*) => {
        #[cfg(target_arch = "nvptx64")]
        entries!(f32, "_f32", "ptx-kernel": $($name)*);
        #[cfg(target_arch = "nvptx64")]
        entries!(f64, "_f64", "ptx-kernel": $($name)*);
        #[cfg(not(target_arch = "nvptx64"))]
        entries!(f32, "_f32", "C": $($name)*);
        #[cfg(not(target_arch = "nvptx64"))]
        entries!(f64, "_f64", "C": $($name)*);

        #[cfg(not(target_arch = "nvptx64"))]
        mod listed {
            use crate::{functions, rows};
            use std::ffi::c_char;

            /// Names of the functions, each followed by a blank.
            #[unsafe(no_mangle)]
            pub extern "C" fn names() -> *const c_char {
                concat!($(stringify!($name), " ",)* "\0").as_ptr().cast()
            }

            /// How many numbers the function with this place in the list reads a row.
            #[unsafe(no_mangle)]
            pub extern "C" fn inputs(function: u64) -> u64 {
                let widths = [$(rows::widths(functions::$name::<f32>),)*];
                widths[function as usize][0]
            }

            /// How many it writes.
            #[unsafe(no_mangle)]
            pub extern "C" fn outputs(function: u64) -> u64 {
                let widths = [$(rows::widths(functions::$name::<f32>),)*];
                widths[function as usize][1]
            }

            pub(super) fn draw<R: rows::Drawn>(function: usize, seed: u64, inputs: &mut [R]) {
                let fills: &[fn(u64, &mut [R])] = &[$(|seed, inputs| rows::fill(seed, inputs, rows::$rows),)*];
                fills[function](seed, inputs);
            }
        }
    };
}

// Each function with the rows that it is compared on.
list! {
    disk: round;
    ring: round;
    punch: round;
    hertz: round;
    paraboloid: round;
    polygon: polygon;
    project: projection;
    step: step;
    manifold: manifold;
    plank: plank;
}

#[cfg(not(target_arch = "nvptx64"))]
macro_rules! judges {
    ($real:ident, $draw:literal, $differing:literal) => {
        /// Fills `count` numbers with rows of the function that has this place in the list.
        ///
        /// # Safety
        /// `inputs` has `count` numbers.
        #[unsafe(export_name = $draw)]
        pub unsafe extern "C" fn draw(function: u64, seed: u64, inputs: *mut $real, count: u64) {
            // SAFETY: as promised.
            let inputs = unsafe { core::slice::from_raw_parts_mut(inputs, count as usize) };
            crate::listed::draw(function as usize, seed, inputs);
        }

        /// The number of rows of `width` numbers that are not the same, among `count` numbers.
        ///
        /// # Safety
        /// Both have `count` numbers.
        #[unsafe(export_name = $differing)]
        pub unsafe extern "C" fn differing(one: *const $real, other: *const $real, count: u64, width: u64) -> u64 {
            // SAFETY: as promised.
            let [one, other] = [one, other].map(|start| unsafe { core::slice::from_raw_parts(start, count as usize) });
            crate::rows::differing(one, other, width as usize)
        }
    };
}

/// What compares, in `f32`.
#[cfg(not(target_arch = "nvptx64"))]
pub mod judge_f32 {
    judges!(f32, "draw_f32", "differing_f32");
}

/// What compares, in `f64`.
#[cfg(not(target_arch = "nvptx64"))]
pub mod judge_f64 {
    judges!(f64, "draw_f64", "differing_f64");
}
