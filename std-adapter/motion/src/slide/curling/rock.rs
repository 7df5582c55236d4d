//! The rock, and the friction law of ice.

use crate::slide::MotionError;
use crate::slide::planar::{Gradient, TallBody};
use tribos_friction::{AnyFriction, Law, Patch};

/// A curling rock on its running band.
///
/// *Units*: SI.
///
/// ```
/// use tribos::slide::curling::CurlingRock;
/// let rock = CurlingRock::STANDARD;
/// // A solid cylinder of 14.5 cm, measured by a band of 6.25 cm.
/// let ratio = 0.5 * 0.145_f64.powi(2) / rock.band_radius.powi(2);
/// assert!((rock.inertia_ratio - ratio).abs() < 1e-14);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CurlingRock {
    /// Outer radius of the running band in m; the radius of the thin ring if the band has no width.
    pub band_radius: f64,
    /// Width of the band, in m.
    pub band_width: f64,
    /// Height of the centre of mass, in m.
    pub height: f64,
    /// C = I/(M R²) with R the radius of the band.
    pub inertia_ratio: f64,
    /// Gravitational acceleration, in m/s².
    pub gravity: f64,
}

impl CurlingRock {
    /// A rock according to the rules: height 11.4 cm, hence its middle at 5.7 cm; diameter 29 cm, hence
    /// C = (14.5/6.25)²/2 = 2.69 for a solid cylinder of that size; a ring of diameter
    /// 12.5 cm as the band (thesis, section 3.5.2). A real rock is rounded and hollow underneath, which makes
    /// its C somewhat smaller.
    pub const STANDARD: Self = Self {
        band_radius: 0.0625,
        band_width: 0.0,
        height: 0.057,
        inertia_ratio: 0.5 * (0.145 / 0.0625) * (0.145 / 0.0625),
        gravity: 9.81,
    };

    /// Contact patch of the running band.
    pub(crate) fn patch(&self) -> Patch {
        Patch::band(1.0 - self.band_width / self.band_radius)
    }

    /// Friction of ice on the running band.
    pub(super) fn friction(&self, ice: IceLaw) -> Result<AnyFriction, MotionError> {
        let law = Law::power(ice.coefficient, ice.alpha)?;
        Ok(AnyFriction::new(&self.patch(), &law, None)?)
    }

    /// The rock under a law of ice, with its centre of mass at `height`.
    pub(super) fn body(&self, ice: IceLaw, height: f64) -> Result<TallBody, MotionError> {
        let foot = self.friction(ice)?.with_radius(self.band_radius)?;
        let rest = [self.gravity, self.inertia_ratio];
        TallBody::new(foot, height, Gradient::AllRound, rest)
    }
}

/// Friction of ice per load, γ v^α.
///
/// ```
/// use tribos::slide::curling::IceLaw;
/// let friction = |ice: IceLaw, v: f64| ice.coefficient * v.powf(ice.alpha);
/// for ice in [IceLaw::PENNER, IceLaw::DRAW, IceLaw::FAST_SPIN] {
///     assert!((0.005..0.008).contains(&friction(ice, 2.0))); // of the load, at 2 m/s
///     assert!(friction(ice, 0.5) > friction(ice, 2.0)); // ice holds a slow rock faster
/// }
/// assert_eq!(friction(IceLaw::DRY, 0.5), friction(IceLaw::DRY, 2.0));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct IceLaw {
    /// Coefficient γ, in (s/m)^α.
    pub coefficient: f64,
    /// Exponent α.
    pub alpha: f64,
}

impl IceLaw {
    /// Penner's law, from frictional heat that flows into the ice (Am. J. Phys. 69 (2001) 332).
    pub const PENNER: Self = Self {
        coefficient: 0.008,
        alpha: -0.5,
    };
    /// Law measured in draw shots (Jensen & Shegelski, Can. J. Phys. 82 (2004) 791).
    pub const DRAW: Self = Self {
        coefficient: 0.0076,
        alpha: -0.19,
    };
    /// Law measured in slow shots with fast spin (same source).
    pub const FAST_SPIN: Self = Self {
        coefficient: 0.0103,
        alpha: -0.75,
    };
    /// Coulomb friction on which a draw of 1.9866 m/s stops after 28.35 m: v²/(2 g x).
    pub const DRY: Self = Self {
        coefficient: 0.007_095,
        alpha: 0.0,
    };
}
