//! Contact dynamics: rigid spheres and plates with constraint forces (thesis, section 4.4).

mod anderson;
mod book;
mod island;
mod memory;
mod momentum;
mod nsgs;
mod operator;
mod residual;
mod solver;
mod spheres;
mod world;

pub use book::Book;
pub use nsgs::{Effort, Order, Stop, Sweeper, solve};
pub use operator::{Blind, Change, Impulse, Operator, Restless, Visit, Watch};
pub use residual::{Coefficients, Residual, residual};
pub use solver::{Method, Solver};
pub use spheres::{Link, Spheres};
pub use world::{Laws, Pace, StepReport, Wall, World, WorldError, solid};
pub use momentum::Momentum;
pub use anderson::Anderson;
