//! Whether an area holds a push at rest.

use super::{Area, Coefficients, FrictionError};
use tribos_core::holding::StictionBounds;
use tribos_core::limit_surface::FrictionSet;
use tribos_core::twist::{Twist, Wrench};

/// A patch at rest under a load: what it holds for certain, and what it may hold at most.
///
/// The two sets are limit surfaces of the kinetic and of the static coefficient; what lies between
/// depends on how the bonds of the contact share the push (see [`tribos_core::holding`]).
///
/// *Units*: `load` in N; pushes act on the body at the origin of the
/// patch, in N and N m. *Accuracy*: that of [`Area::limit_surface`].
///
/// ```
/// use tribos::friction::{Area, StictionTest};
/// use tribos::kernel::holding::Stiction;
/// use tribos::prelude::*;
/// let book = Area::named(&"box:0.2x0.1".parse()?, 1.0, None)?; // m
/// let book = StictionTest::new(&book, ["0.5".parse()?, "0.3".parse()?], 10.0)?; // static, kinetic; N
/// let ask = |push: f64| book.holding(&Wrench::new(push, 0.0, 0.0)).stiction; // N
/// assert_eq!([2.0, 4.0, 6.0].map(ask), [Stiction::Holds, Stiction::Undecided, Stiction::Slips]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub struct StictionTest {
    certain: Box<dyn FrictionSet<f64>>,
    possible: Box<dyn FrictionSet<f64>>,
}

impl StictionTest {
    /// *Domain*: kinetic coefficients that are nowhere above the static ones; 0 ≤ `load` < ∞.
    pub fn new(
        area: &Area,
        [mu_s, mu_d]: [Coefficients; 2],
        load: f64,
    ) -> Result<Self, FrictionError> {
        if !mu_d.is_within(&mu_s) {
            return Err(FrictionError::Syntax(format!(
                "the kinetic coefficient {mu_d} is above the static one {mu_s}: give 0 <= kinetic <= static, along the \
                 same axis"
            )));
        }
        let set = |mu: Coefficients| mu.on(area.clone())?.limit_surface(mu.largest() * load);
        Ok(Self {
            certain: set(mu_d)?,
            possible: set(mu_s)?,
        })
    }

    /// The answer to a push, with its gauges.
    pub fn holding(&self, push: &Wrench<f64>) -> StictionBounds<f64> {
        StictionBounds::of(&*self.certain, &*self.possible, push)
    }

    /// The motion that a growing push of this direction starts: |velocity|² + (spin R)² = 1 for the
    /// farthest distance R of the patch from its origin; zero without push.
    pub fn first_motion(&self, push: &Wrench<f64>) -> Twist<f64> {
        self.possible.twist_normal_to(push)
    }
}

impl std::fmt::Debug for StictionTest {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let [certain, possible] = [&self.certain, &self.possible].map(|set| set.force_limit());
        f.debug_struct("AtRest")
            .field("certain_force_limit", &certain)
            .field("possible_force_limit", &possible)
            .finish()
    }
}
