//! Bodies of revolution with a raised centre of mass.

use super::Resistance;
use crate::slide::MotionError;
use tribos_core::coupling::RoundFriction;
use tribos_core::coupling::load_transfer::{
    FullGradient, LoadTransferFriction, LongitudinalGradient,
};
use tribos_core::law::LawError;
use tribos_core::real::Real;
use tribos_core::twist::{Twist, Wrench};
use tribos_friction::AnyFriction as Foot;

/// Components of the pressure gradient that are included.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Gradient {
    /// Gradient along and across the velocity.
    #[default]
    AllRound,
    /// Gradient along the velocity only, eq. 3.37 of the thesis.
    FrontBack,
}

/// A tall body on its foot; beyond |l| = 1 the effect of the gradient on the friction no longer grows.
///
/// *Units*: SI. *Source*: [`tribos_core::coupling::load_transfer`].
///
/// ```
/// use tribos::friction::{AnyFriction, Law, Patch};
/// use tribos::slide::MotionError;
/// use tribos::slide::planar::{Gradient, Resistance, TallBody};
/// let body = |height: f64, gravity: f64| {
///     let foot = AnyFriction::new(&Patch::Disk, &Law::coulomb(0.3)?, None)?.with_radius(0.08)?;
///     TallBody::new(foot, height, Gradient::AllRound, [gravity, 0.5])
/// };
/// // The pressure p (1 + l x/R) has the moment N R l/4, which bears that of friction, mu N h.
/// let lean = body(0.05, 9.81)?.lean([1.0, 0.0, 0.0]);
/// assert!((lean - 4.0 * 0.3 * 0.05 / 0.08).abs() < 1e-14);
/// assert!(body(0.10, 9.81)?.lean([1.0, 0.0, 0.0]) > 1.0); // it begins to tip
/// assert!(matches!(body(0.05, 0.0), Err(MotionError::Law(_))));
/// # Ok::<(), MotionError>(())
/// ```
#[derive(Debug)]
pub struct TallBody {
    friction: Friction,
    gravity: f64,
    inertia_ratio: f64,
}

#[derive(Debug)]
enum Friction {
    AllRound(LoadTransferFriction<f64, Foot, FullGradient>),
    FrontBack(LoadTransferFriction<f64, Foot, LongitudinalGradient>),
    /// A body of zero height, under a law whose lateral force would cost a quadrature.
    Flat(RoundFriction<f64, Foot>),
}

impl TallBody {
    /// A body on `foot`, with its centre of mass at `height`.
    ///
    /// *Domain*: gravity and inertia ratio positive and finite; otherwise as [`LoadTransferFriction::new`].
    pub fn new(
        foot: RoundFriction<f64, Foot>,
        height: f64,
        gradient: Gradient,
        [gravity, inertia_ratio]: [f64; 2],
    ) -> Result<Self, MotionError> {
        for (parameter, given) in [("gravity", gravity), ("inertia ratio", inertia_ratio)] {
            let is_valid = given > 0.0 && given.is_finite();
            if !is_valid {
                return Err(MotionError::Law(LawError::NotPositive { parameter, given }));
            }
        }
        let friction = match gradient {
            _ if height == 0.0 && foot.coupling().power().is_none() => Friction::Flat(foot),
            Gradient::AllRound => Friction::AllRound(LoadTransferFriction::new(foot, height)?),
            Gradient::FrontBack => Friction::FrontBack(LoadTransferFriction::new(foot, height)?),
        };
        Ok(Self {
            friction,
            gravity,
            inertia_ratio,
        })
    }

    fn foot(&self) -> &RoundFriction<f64, Foot> {
        match &self.friction {
            Friction::AllRound(friction) => friction.foot(),
            Friction::FrontBack(friction) => friction.foot(),
            Friction::Flat(foot) => foot,
        }
    }

    /// The wrench per mass, and the magnitude of the pressure gradient.
    fn wrench(&self, [x, y, rim]: [f64; 3]) -> (Wrench<f64>, f64) {
        let twist = Twist::new(x, y, rim / self.radius());
        let tall = match &self.friction {
            Friction::AllRound(friction) => friction.wrench(self.gravity, &twist),
            Friction::FrontBack(friction) => friction.wrench(self.gravity, &twist),
            Friction::Flat(foot) => return (foot.wrench(self.gravity, &twist), 0.0),
        };
        (tall.wrench, Real::hypot(tall.lean.x, tall.lean.y))
    }
}

impl Resistance for TallBody {
    fn deceleration(&self, velocity: [f64; 3]) -> [f64; 3] {
        let (wrench, _) = self.wrench(velocity);
        [
            -wrench.force.x,
            -wrench.force.y,
            -wrench.torque / (self.inertia_ratio * self.radius()),
        ]
    }

    fn exponent(&self) -> f64 {
        self.foot().coupling().exponent_at_rest()
    }

    fn inertia_ratio(&self) -> f64 {
        self.inertia_ratio
    }

    fn radius(&self) -> f64 {
        self.foot().radius()
    }

    fn accuracy(&self) -> f64 {
        self.foot().coupling().accuracy()
    }

    fn lean(&self, velocity: [f64; 3]) -> f64 {
        self.wrench(velocity).1
    }
}
