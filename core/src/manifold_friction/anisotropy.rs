//! Coefficients that differ along two axes: grooved, brushed or woven surfaces, wheels and skates.

use super::{FrictionImpulse, Lanes};

/// Friction with coefficients of its own along both tangents.
///
/// The tangential impulse is stretched so that its limit is a circle again;
/// [`manifold_friction`](super::project_friction) then sees the isotropic problem with the larger coefficient.
/// The step towards the candidate has to be stretched twice, which makes friction follow the rule of largest
/// dissipation: slip normal to the ellipse.
///
/// ```
/// use tribos_core::manifold_friction::{
///     AnisotropicFriction, IsotropicLimitCurve, FrictionLimits, FrictionImpulse, InverseEffectiveMasses, project_friction,
/// };
/// let blade = AnisotropicFriction::new([0.05_f32, 0.5]); // along and across
/// let inverse = InverseEffectiveMasses { tangential: 2.0, angular: 500.0 };
/// let budget = FrictionLimits { impulse: blade.largest() * 1.0, torsion_radius: 0.01, dynamic_over_static: 1.0 }; // load impulse 1 N s
/// let mut impulse = FrictionImpulse { tangential: [0.0, 0.0], angular: 0.0 };
/// for _ in 0..100 { // slides across its axis and along it at 1 m/s, as if driven
///     let candidate = blade.candidate(&impulse, [1.0, 1.0], 0.0, &inverse);
///     let carried = project_friction(&candidate, &budget, &inverse, &IsotropicLimitCurve::area());
///     impulse = blade.unstretched(&carried);
/// }
/// // Slip (1, 1) is normal to the ellipse where p is in proportion to the squares of the coefficients.
/// assert!((impulse.tangential[0] / impulse.tangential[1] - 0.01).abs() < 1e-4);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct AnisotropicFriction<T> {
    /// Coefficients over the larger one.
    shares: [T; 2],
    largest: T,
}

impl<T: Lanes> AnisotropicFriction<T> {
    /// From the coefficients along both tangents. *Domain*: > 0; a smaller one counts as 1e-3 of the larger one.
    #[inline]
    pub fn new([first, second]: [T; 2]) -> Self {
        let largest = first.larger(second);
        let share = |mu: T| (mu / largest).larger(T::splat(1e-3));
        Self {
            shares: [share(first), share(second)],
            largest,
        }
    }

    /// The larger coefficient, that of the budget.
    #[inline]
    pub fn largest(&self) -> T {
        self.largest
    }

    /// The stretched candidate from the last impulses and the relative motion of the two bodies, in m/s and rad/s.
    #[inline]
    pub fn candidate(
        &self,
        last: &FrictionImpulse<T>,
        velocity: [T; 2],
        spin: T,
        inverse: &super::InverseEffectiveMasses<T>,
    ) -> FrictionImpulse<T> {
        let stretched =
            |last: T, velocity: T, share: T| last / share - share * velocity / inverse.tangential;
        let ([p1, p2], [v1, v2], [s1, s2]) = (last.tangential, velocity, self.shares);
        FrictionImpulse {
            tangential: [stretched(p1, v1, s1), stretched(p2, v2, s2)],
            angular: last.angular - spin / inverse.angular.larger(T::splat(super::TINY)),
        }
    }

    /// The impulses whose stretched ones these are.
    #[inline]
    pub fn unstretched(&self, stretched: &FrictionImpulse<T>) -> FrictionImpulse<T> {
        let ([p1, p2], [s1, s2]) = (stretched.tangential, self.shares);
        FrictionImpulse {
            tangential: [p1 * s1, p2 * s2],
            angular: stretched.angular,
        }
    }
}
