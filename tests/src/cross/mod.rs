//! The digests of `tribos-subjects` on every platform that this machine can build for and emulate.

pub mod options;
pub mod platforms;
mod process;
pub mod report;
pub mod work;
