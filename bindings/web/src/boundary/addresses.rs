//! Where results and reasons stand.

use crate::exchange;

/// Address of results of fixed size, numbers of 8 bytes.
#[unsafe(no_mangle)]
pub extern "C" fn result() -> usize {
    exchange::result_address()
}

/// Address of the pieces of a reason, each an address and a length in bytes.
#[unsafe(no_mangle)]
pub extern "C" fn reason() -> usize {
    exchange::reason_address()
}
