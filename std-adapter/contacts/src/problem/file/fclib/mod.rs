//! HDF5 of FCLib, through a library in Rust alone.
//!
//! ```text
//! fclib_local/   spacedim, W/{m, n, nz, nzmax, i, p, x}, vectors/{q, mu, mu_r}
//! fclib_global/  spacedim, M/…, H/…, vectors/{f, w, mu, mu_r}
//! ```
//!
//! nz ≥ 0: triplets, rows i and columns p; nz = −1: compressed columns, starts p and rows i; nz = −2: compressed rows,
//! starts p and columns i.

mod matrix;
mod names;
mod read;
mod store;
mod write;

pub(super) use read::read;
pub(super) use write::write;

/// Whether bytes begin with HDF5's signature, or hold it at one of the other places where it may be.
pub(super) fn is_hdf5(bytes: &[u8]) -> bool {
    hdf5_pure::is_hdf5_bytes(bytes)
}
