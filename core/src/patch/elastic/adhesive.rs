//! Spheres that stick together: Johnson, Kendall and Roberts.

use super::{LoadedRadius, THREE_QUARTERS, cube_root, hertz_growth, hertz_slope};
use crate::law::{LawError, validated_positive};
use crate::real::Real;

/// Contact of soft spheres with a work of adhesion w: a³ = (3 R/(4 E*)) (N + P + √(P (P + 2N))), P = 3π w R.
///
/// A pull, N < 0, is held down to the [`AdhesiveSphere::pull_off`] −3/2 π w R, where the radius is still 4^(−⅓) of that without
/// load. Friction of such a contact is not μN: a load that pulls has friction too ([`crate::law::Savkoor`]).
/// *Units*: any consistent set; w is an energy per area. *Domain*: soft, large or sticky spheres, w² R/(E*² z³) ≫ 1 with
/// the range z of the attraction. *Accuracy*: 4 ulp of the radius and of N + P, times √(P/(P + 2N)) where that is more than 1.
/// *Special values*: zero beyond the pull-off; there the slope is infinite. *Source*: Johnson, Kendall and Roberts, Proc. R.
/// Soc. A 324 (1971) 301, eq. 14.
///
/// ```
/// use tribos_core::patch::elastic::{AdhesiveSphere, LoadedRadius};
/// let gel = AdhesiveSphere::new(1e4_f64, 0.01, 0.05)?; // E* in Pa, radius in m, w in J/m²
/// let [free, last] = [0.0, gel.pull_off()].map(|load| gel.radius(load));
/// assert!((gel.pull_off() + 1.5 * core::f64::consts::PI * 0.05 * 0.01).abs() < 1e-17); // N
/// assert!((last / free - 0.25_f64.cbrt()).abs() < 1e-15);
/// assert_eq!(gel.radius(1.001 * gel.pull_off()), 0.0); // it has let go
/// # Ok::<(), tribos_core::law::LawError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct AdhesiveSphere<R> {
    /// 3 R/(4 E*)
    softness: R,
    /// P = 3π w R
    adhesion: R,
}

/// 3π of P = 3π w R.
const PULLS: f64 = 3.0 * core::f64::consts::PI;

impl<R: Real> AdhesiveSphere<R> {
    /// *Domain*: all positive and finite. `radius` as in [`super::HertzSphere::new`], `work` the work of adhesion.
    pub fn new(modulus: R, radius: R, work: R) -> Result<Self, LawError> {
        validated_positive("effective modulus", modulus)?;
        validated_positive("radius of the sphere", radius)?;
        validated_positive("work of adhesion", work)?;
        let softness = R::from_f64(THREE_QUARTERS) * (radius / modulus);
        Ok(Self {
            softness: validated_positive("radius over modulus", softness)?,
            adhesion: validated_positive("work times radius", R::from_f64(PULLS) * work * radius)?,
        })
    }

    /// The load −3/2 π w R, a pull, under which the spheres let go. *Units*: force.
    pub fn pull_off(&self) -> R {
        -(R::HALF * self.adhesion)
    }

    /// Load without adhesion that has the same radius, and its slope by the load; zero beyond the pull-off.
    #[inline]
    fn apparent(&self, load: R) -> [R; 2] {
        let pull = self.adhesion;
        let left = pull + R::TWO * load;
        if left < R::ZERO {
            return [R::ZERO; 2];
        }
        let (whole, root) = (pull.sqrt(), left.sqrt());
        [load + pull + whole * root, R::ONE + whole / root]
    }
}

impl<R: Real> LoadedRadius<R> for AdhesiveSphere<R> {
    #[inline]
    fn radius(&self, load: R) -> R {
        let [apparent, _] = self.apparent(load);
        cube_root(self.softness * apparent)
    }
    #[inline]
    fn slope(&self, load: R) -> R {
        let [apparent, rate] = self.apparent(load);
        if apparent == R::ZERO {
            return R::ZERO;
        }
        hertz_slope(apparent, cube_root(self.softness * apparent)) * rate
    }
    #[inline]
    fn growth(&self, load: R) -> R {
        let [apparent, rate] = self.apparent(load);
        if apparent == R::ZERO {
            return R::ZERO;
        }
        let share = if load == R::INFINITY {
            R::ONE
        } else {
            load / apparent
        };
        hertz_growth(apparent) * share * rate
    }
}
