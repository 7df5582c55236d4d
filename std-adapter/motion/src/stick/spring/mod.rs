//! A body on a spring whose other end is pulled: steady sliding, creep and stick–slip.
//!
//! ```text
//! m x'' = F − f,    F = k (X − x),    X' = V while it is pulled, 0 while it is held
//! ```
//!
//! | friction f | followed by |
//! |---|---|
//! | dry: μ_s at rest, growing with its time or not, μ_d in motion | the closed form of rest and of harmonic arcs |
//! | a law of the speed | an L-stable integrator of fourth order; rest is exact, its instant a root |
//! | rate and state | the same in the logarithms of speed and age, with mass or without |
//! | LuGre's bristles | the same in speed, deflection and force |

mod bristles;
mod dry;
mod motion;
mod outcome;
mod rate_state;
mod rosenbrock;
mod run;
mod speed;
mod stability;
mod tally;
#[cfg(test)]
#[allow(clippy::disallowed_methods, reason = "tests compare with the platform")]
mod tests;

pub use outcome::{HoldPeak, SpringSummary, StickSlipRegime};
pub(crate) use rate_state::LoadedContact;
pub use rate_state::StateEvolutionKind;
#[doc(hidden)]
pub use stability::critical_stiffness;

/// Share of the pull's speed above which a body slips under laws that never hold exactly.
const SLOW: f64 = 0.1;
