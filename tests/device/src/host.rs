//! What the host's library has beside the functions: the list, rows and the comparison.

/// Calls `of` with one row after the other.
#[inline(always)]
pub(crate) fn each_row(rows: u64, of: impl Fn(usize)) {
    (0..rows as usize).for_each(of);
}

/// The list, by the places of its functions.
macro_rules! listed {
    ($($name:ident: $rows:ident;)*) => {
        mod listed {
            use crate::{functions, random, rows};

            /// Names, each followed by a blank.
            #[unsafe(no_mangle)]
            pub extern "C" fn names() -> *const std::ffi::c_char {
                concat!($(stringify!($name), " ",)* "\0").as_ptr().cast()
            }

            /// How many numbers a function reads a row.
            #[unsafe(no_mangle)]
            pub extern "C" fn inputs(function: u64) -> u64 {
                [$(rows::widths(functions::$name::<f32>),)*][function as usize][0]
            }

            /// How many it writes.
            #[unsafe(no_mangle)]
            pub extern "C" fn outputs(function: u64) -> u64 {
                [$(rows::widths(functions::$name::<f32>),)*][function as usize][1]
            }

            pub(crate) fn draw<R: random::RandomReal>(function: u64, seed: u64, inputs: &mut [R]) {
                let fills: &[fn(u64, &mut [R])] =
                    &[$(|seed, inputs| rows::fill(seed, inputs, rows::$rows),)*];
                fills[function as usize](seed, inputs);
            }
        }
    };
}
pub(crate) use listed;

macro_rules! judge {
    ($real:ident, $draw:literal, $differing:literal) => {
        mod $real {
            use core::slice;

            /// Fills `count` numbers with rows of a function.
            #[unsafe(export_name = $draw)]
            unsafe extern "C" fn draw(function: u64, seed: u64, inputs: *mut $real, count: u64) {
                // SAFETY: `inputs` has `count` numbers.
                let inputs = unsafe { slice::from_raw_parts_mut(inputs, count as usize) };
                crate::listed::draw(function, seed, inputs);
            }

            /// The number of rows of `width` numbers that are not the same, among `count` numbers.
            #[unsafe(export_name = $differing)]
            unsafe extern "C" fn differing(
                one: *const $real,
                other: *const $real,
                count: u64,
                width: u64,
            ) -> u64 {
                // SAFETY: both have `count` numbers.
                let [one, other] = [one, other]
                    .map(|start| unsafe { slice::from_raw_parts(start, count as usize) });
                crate::rows::differing(one, other, width as usize)
            }
        }
    };
}
judge!(f32, "draw_f32", "differing_f32");
judge!(f64, "draw_f64", "differing_f64");
