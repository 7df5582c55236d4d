//! The fuzzer of the kernel, and targets that read files.

mod texts;

pub use tribos_fuzz::*;

/// Readers of files.
pub const READERS: [Target; 4] = [
    target("scenes", 20, texts::scenes),
    target("overrides", 20, texts::overrides),
    target("checkpoints", 2, texts::checkpoints),
    target("golden files", 5, texts::golden_files),
];

/// All targets.
pub fn targets() -> impl Iterator<Item = Target> {
    READERS.into_iter().chain(KERNEL)
}
