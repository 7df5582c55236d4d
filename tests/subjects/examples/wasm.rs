//! Digests for a host without output of its own: `digest(index)` of a wasm module.

/// The digest of a subject, 0 beyond the last.
// SAFETY: the one symbol of this name in the module.
#[allow(unsafe_code)]
#[unsafe(no_mangle)]
pub extern "C" fn digest(index: u32) -> u64 {
    tribos_subjects::SUBJECTS
        .get(index as usize)
        .map_or(0, tribos_subjects::Subject::digest)
}
