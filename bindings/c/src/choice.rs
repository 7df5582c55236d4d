//! Enumerations that a structure stores as a number.

/// Effect of cohesion within its range.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u32)]
pub enum tribos_attraction {
    /// A constant pull, which closes the gap of a released pair.
    Pull = 0,
    /// A resistance against opening, which does not close the gap of a released pair.
    Resistance = 1,
}
