//! Friction of a contact of bodies, chosen at run time.

use super::surface::DryRound;
use super::{Area, FrictionError};
use tribos_core::contact::{
    AllModes, ContactFriction, CoupledFriction, Frictionless, IndependentFriction, SlidingOnly,
    SlidingRolling, SlidingTorsion,
};
use tribos_core::limit_surface::RoundLimitSurface;

/// The exact set of a round patch.
type RoundSet = RoundLimitSurface<f64, DryRound<f64>>;

/// Friction of a contact, by the modes that it resists.
///
/// ```
/// use tribos::friction::{AnyContactFriction, Area, Patch};
/// let billiard = AnyContactFriction::thresholds([0.2, 0.01, 0.0])?; // sliding, rolling, torsion
/// assert_eq!(billiard.mu_torsion(), 0.0);
/// // The exact set of sliding and torsion of any round patch, here of R_c/r_eff = 0.3.
/// let soft = Area::round(Patch::Paraboloid, 0.3)?;
/// let coupled = AnyContactFriction::coupled(&soft, 0.2, 0.0)?;
/// assert!((coupled.mu_torsion() - 0.2 * 0.3 * 8.0 / 15.0).abs() < 1e-15);
/// # Ok::<(), tribos::friction::FrictionError>(())
/// ```
#[derive(Clone, Debug)]
pub struct AnyContactFriction(Kind);

#[derive(Clone, Debug)]
enum Kind {
    None(IndependentFriction<f64, Frictionless>),
    Sliding(IndependentFriction<f64, SlidingOnly>),
    SlidingRolling(IndependentFriction<f64, SlidingRolling>),
    SlidingTorsion(IndependentFriction<f64, SlidingTorsion>),
    All(IndependentFriction<f64, AllModes>),
    Coupled(Box<CoupledFriction<f64, RoundSet, SlidingTorsion>>),
    CoupledRolling(Box<CoupledFriction<f64, RoundSet, AllModes>>),
}

/// Work with the contact friction of one type.
pub trait ContactVisitor {
    /// What the work gives.
    type Output;
    /// Does the work.
    fn visit<F: ContactFriction<f64> + 'static>(self, friction: &F) -> Self::Output;
}

impl AnyContactFriction {
    /// Thresholds of their own with the coefficients of sliding, rolling and torsion; modes without a
    /// threshold cost nothing.
    pub fn thresholds([mu, rolling, torsion]: [f64; 3]) -> Result<Self, FrictionError> {
        // Negative and missing numbers are refused by the full form.
        let full = IndependentFriction::all(mu, rolling, torsion)?;
        Ok(Self(match [mu == 0.0, rolling == 0.0, torsion == 0.0] {
            [true, true, true] => Kind::None(IndependentFriction::none()),
            [_, true, true] => Kind::Sliding(IndependentFriction::sliding(mu)?),
            [_, false, true] => {
                Kind::SlidingRolling(IndependentFriction::sliding_rolling(mu, rolling)?)
            }
            [_, true, false] => {
                Kind::SlidingTorsion(IndependentFriction::sliding_torsion(mu, torsion)?)
            }
            [_, false, false] => Kind::All(full),
        }))
    }

    /// Sliding and torsion in the exact set of a round area whose radius is R_c/r_eff, and rolling.
    pub fn coupled(area: &Area, mu: f64, rolling: f64) -> Result<Self, FrictionError> {
        let Area::Round(patch, radius) = area else {
            return Err(FrictionError::Unserved(
                "the set of a contact must be symmetric about the normal: patch must be round"
                    .into(),
            ));
        };
        let set = RoundLimitSurface::new(DryRound::new(patch)?, mu, *radius)?;
        Ok(Self(if rolling == 0.0 {
            Kind::Coupled(Box::new(CoupledFriction::sliding_torsion(set)))
        } else {
            Kind::CoupledRolling(Box::new(CoupledFriction::all(set, rolling)?))
        }))
    }

    /// Largest torsion torque without sliding, over force and lever.
    pub fn mu_torsion(&self) -> f64 {
        match &self.0 {
            Kind::None(_) | Kind::Sliding(_) | Kind::SlidingRolling(_) => 0.0,
            Kind::SlidingTorsion(friction) => friction.mu_torsion(),
            Kind::All(friction) => friction.mu_torsion(),
            Kind::Coupled(friction) => friction.mu_torsion(),
            Kind::CoupledRolling(friction) => friction.mu_torsion(),
        }
    }

    /// Hands the kernel's own type to `visitor`.
    pub fn visit<V: ContactVisitor>(&self, visitor: V) -> V::Output {
        match &self.0 {
            Kind::None(friction) => visitor.visit(friction),
            Kind::Sliding(friction) => visitor.visit(friction),
            Kind::SlidingRolling(friction) => visitor.visit(friction),
            Kind::SlidingTorsion(friction) => visitor.visit(friction),
            Kind::All(friction) => visitor.visit(friction),
            Kind::Coupled(friction) => visitor.visit(&**friction),
            Kind::CoupledRolling(friction) => visitor.visit(&**friction),
        }
    }
}
