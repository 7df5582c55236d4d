//! Contact dynamics: rigid spheres and plates with constraint forces (thesis, section 4.4).

mod accelerated;
mod assemble;
mod book;
mod island;
mod memory;
mod nsgs;
mod operator;
mod residual;
mod schedule;
mod setup;
mod solver;
mod spheres;
mod world;

pub use accelerated::{Accelerated, Goal};
pub use book::Book;
pub use island::Rest;
pub use memory::{Kept, Memory};
pub use nsgs::{Effort, Order, Stop, Sweeper, solve};
pub use operator::{Blind, Change, Impulse, Operator, Restless, Visit, Watch};
pub use residual::{Coefficients, Residual, residual};
pub use setup::{Laws, Pace, Setup, Wall, WorldError, solid};
pub use solver::{Method, Solver};
pub use spheres::{Link, Spheres};
pub use world::{State, StepReport, World};
