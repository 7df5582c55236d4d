//! Choices that a structure holds as a number.

/// What cohesion does within its range.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u32)]
pub enum tribos_attraction {
    /// A constant pull: a pair that is let go closes again.
    Pull = 0,
    /// A resistance against opening: a pair that is let go stays where it is.
    Resistance = 1,
}
