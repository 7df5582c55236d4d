//! The `tribos` command: arguments in, reports out. The physics is in `tribos` and `tribos-core`.

pub mod command;
pub mod failure;
