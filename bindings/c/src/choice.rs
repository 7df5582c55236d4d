//! Enumerations that a structure or an argument gives as a number.

use crate::status::tribos_status;
use tribos_core::patch::ellipse::EllipsePressure;

/// Effect of cohesion within its range.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u32)]
pub enum tribos_attraction {
    /// A constant pull, which closes the gap of a released pair.
    Pull = 0,
    /// A resistance against opening, which does not close the gap of a released pair.
    Resistance = 1,
}

/// How pressure is spread over a disk or an ellipse, with rho from 0 at its centre to 1 on its edge.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u32)]
pub enum tribos_pressure {
    /// 1/sqrt(1 - rho^2): a rigid flat punch on an elastic body.
    FlatPunch = 0,
    /// The same everywhere.
    Uniform = 1,
    /// sqrt(1 - rho^2): curved elastic bodies.
    Hertz = 2,
    /// 1 - rho^2
    Paraboloid = 3,
}

/// The kernel's pressure of this number.
#[inline(always)]
pub(crate) fn pressure_of(number: u32) -> Result<EllipsePressure, tribos_status> {
    Ok(match number {
        0 => EllipsePressure::FlatPunch,
        1 => EllipsePressure::Uniform,
        2 => EllipsePressure::Hertz,
        3 => EllipsePressure::Paraboloid,
        _ => return Err(tribos_status::Choice),
    })
}
