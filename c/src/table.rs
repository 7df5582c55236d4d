//! Memory for tables of the power law.

use tribos_core::coupling::table::{Table32, Table64};

/// A table of one exponent, built by `tribos_power_table_build_f64` and opaque otherwise. It may be
/// copied and moved, but not to a program with another version of the library.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct tribos_power_table_f64 {
    /// Not to be looked at.
    pub opaque: [f64; 2969],
}

/// A table of one exponent, built by `tribos_power_table_build_f32` and opaque otherwise. It may be
/// copied and moved, but not to a program with another version of the library.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct tribos_power_table_f32 {
    /// Not to be looked at.
    pub opaque: [f32; 673],
}

// A table consists of numbers alone: any content of the memory is one, sense or no sense.
const _: () = {
    assert!(size_of::<Table64>() == size_of::<tribos_power_table_f64>());
    assert!(align_of::<Table64>() == align_of::<tribos_power_table_f64>());
    assert!(size_of::<Table32>() == size_of::<tribos_power_table_f32>());
    assert!(align_of::<Table32>() == align_of::<tribos_power_table_f32>());
};
