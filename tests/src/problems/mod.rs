//! Contact problems as data: random ones of five kinds, and changes that no solver should notice or that make other
//! problems of given ones.

mod builder;
mod changes;
mod random;

pub use changes::{CHANGES, changed};
pub use random::{KINDS, random};
