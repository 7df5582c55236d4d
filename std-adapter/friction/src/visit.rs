//! The kernel's own type of a patch, an exponent and a tier: decided here and nowhere else.

use super::{FrictionError, Law, Patch, Precision, Tier};
use tribos_core::coupling::{
    Annulus, DryProfile, DryReducedFriction, LateralFriction, PowerLawFriction, compact, coulomb,
    table,
};
use tribos_core::internals::{LeanProfile, SmoothProfile};
use tribos_core::patch::PowerPressure;
use tribos_core::real::Real;

/// Work to be done with the kernel's own type of a power of the speed on a round patch.
///
/// A loop inside of [`Visitor::visit`] is compiled for that type, so that an evaluation costs what it
/// costs where the type is written down.
///
/// ```
/// use tribos::friction::{Patch, RoundPower, Tier, Visitor, visit};
/// /// Mean torque of a rim that slows down.
/// struct Mean;
/// impl Visitor<f64> for Mean {
///     type Output = f64;
///     fn visit<P: RoundPower<f64> + 'static>(self, friction: P) -> f64 {
///         (1..=100).map(|k| friction.reduced_wrench(0.0, 0.01 * f64::from(k)).torque).sum::<f64>() / 100.0
///     }
/// }
/// let dry = visit(&Patch::Ring, 0.0, Tier::Exact, Mean)?;
/// assert!((dry - 1.0).abs() < 1e-14); // Coulomb friction does not depend on the speed
/// # Ok::<(), tribos::friction::FrictionError>(())
/// ```
pub trait Visitor<R: Real> {
    /// What the work gives.
    type Output;
    /// Does the work.
    fn visit<P: RoundPower<R> + 'static>(self, friction: P) -> Self::Output;
}

/// A power of the speed on a round patch, whatever its type: wrench, Jacobian, lateral force, and the
/// profile that final motion and sliders are computed from.
///
/// ```
/// use tribos::friction::{AnyFriction, Law, Patch, RoundPower};
/// use tribos::kernel::modes::{TerminalMode, TerminalMotion};
/// let disk = AnyFriction::<f64>::new(&Patch::Disk, &Law::coulomb(0.3)?, None)?;
/// let profile: &dyn RoundPower<f64> = disk.power().ok_or("a power of the speed")?;
/// let mode = TerminalMotion::new(profile, 0.5)?.terminal_mode(1.0);
/// assert!(matches!(mode, TerminalMode::Together { ratio } if (ratio - 0.653).abs() < 1e-3));
/// let lateral = profile.as_lateral().lateral(1.0, 1.0);
/// assert!((lateral - 32.0 / (45.0 * std::f64::consts::PI)).abs() < 1e-14);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub trait RoundPower<R: Real>: PowerLawFriction<R> + LateralFriction<R> + Send + Sync {
    /// The same as a lateral coupling.
    fn as_lateral(&self) -> &dyn LateralFriction<R>;
}

impl<R: Real, P: PowerLawFriction<R> + LateralFriction<R> + Send + Sync> RoundPower<R> for P {
    fn as_lateral(&self) -> &dyn LateralFriction<R> {
        self
    }
}

/// Hands the kernel's type for |v|^`alpha` on `patch` in `tier` to `visitor`.
///
/// *Domain*: what [`Tier::choose`] admits; otherwise the kernel's refusal. Quadrature has no such
/// type.
pub fn visit<R: Precision, V: Visitor<R>>(
    patch: &Patch,
    alpha: f64,
    tier: Tier,
    visitor: V,
) -> Result<V::Output, FrictionError> {
    match patch {
        Patch::Annulus(inner) => {
            let inner = R::from_f64(*inner);
            disk(alpha, tier, InAnnulus { inner, visitor })
        }
        _ => smooth(patch, alpha, tier, Plain(visitor)),
    }
}

/// [`visit`] on the uniform disk, for work that is long to compile.
#[doc(hidden)]
pub fn visit_disk<R: Precision, V: Visitor<R>>(
    alpha: f64,
    tier: Tier,
    visitor: V,
) -> Result<V::Output, FrictionError> {
    disk(alpha, tier, Plain(visitor))
}

/// Dry friction on the foot of a body that leans by `lean`, from 0 to 1: what the final motion of a
/// tall body is computed from.
///
/// ```
/// use tribos::friction::{Patch, leaning};
/// use tribos::kernel::modes::{TerminalMode, TerminalMotion};
/// let ratio = |lean: f64| -> Result<f64, Box<dyn std::error::Error>> {
///     let tall = leaning(&Patch::Disk, lean)?;
///     match TerminalMotion::new(&*tall, 0.5)?.terminal_mode(1.0) {
///         TerminalMode::Together { ratio } => Ok(ratio),
///         other => Err(format!("{other:?}").into()),
///     }
/// };
/// assert!(ratio(0.8)? > ratio(0.0)?); // it settles at a larger ratio of sliding to spinning
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn leaning(patch: &Patch, lean: f64) -> Result<Box<dyn PowerLawFriction<f64>>, FrictionError> {
    match patch {
        Patch::Annulus(inner) => TiltVisitor(lean).dry(Annulus::new(coulomb::CoulombDisk, *inner)?),
        _ => smooth(patch, 0.0, Tier::Exact, TiltVisitor(lean)),
    }
}

/// |v|^`alpha` on an upright `patch`, for final motion and launches.
///
/// ```
/// use tribos::friction::{Patch, upright};
/// use tribos::kernel::modes::{TerminalMotion, inertia_interval};
/// let ring = upright(&Patch::Ring, 0.0)?;
/// assert_eq!(TerminalMotion::new(&*ring, 1.0)?.inertia_interval(), inertia_interval(0.0, -1.0));
/// assert!(upright(&Patch::Polynomial(vec![1.0]), 20.0).is_err()); // tables end at 10
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn upright(patch: &Patch, alpha: f64) -> Result<Box<dyn RoundPower<f64>>, FrictionError> {
    let tier = Tier::choose::<f64>(patch, &Law::power(1.0, alpha)?, None)?;
    visit(patch, alpha, tier, BoxingVisitor)
}

/// [`visit`] for every patch but the annulus.
fn smooth<R: Precision, V: Smooth<R>>(
    patch: &Patch,
    alpha: f64,
    tier: Tier,
    visitor: V,
) -> Result<V::Output, FrictionError> {
    let narrow = R::from_f64(alpha);
    let is_dry = alpha == 0.0;
    let pressure = patch.pressure().unwrap_or(PowerPressure::UNIFORM);
    match (patch, tier) {
        (Patch::Points(_) | Patch::Flat(_), _) => Err(FrictionError::NoAxis),
        (Patch::WornAnnulus(_), _) => Err(FrictionError::NoProfile),
        (Patch::Disk, _) => disk(alpha, tier, visitor),
        (_, Tier::Quadrature) => Err(FrictionError::NoProfile),
        (Patch::Polynomial(a), Tier::Exact) => R::polynomial(narrow, a, visitor),
        (Patch::Ring, Tier::Exact) if is_dry => visitor.smooth(coulomb::CoulombRing),
        (Patch::Hertz, Tier::Exact) if is_dry => visitor.smooth(coulomb::CoulombHertz),
        (Patch::Punch, Tier::Exact) if is_dry => visitor.smooth(coulomb::CoulombPunch),
        (Patch::Paraboloid, Tier::Exact) if is_dry => visitor.smooth(coulomb::CoulombParaboloid),
        (_, Tier::Exact) if alpha <= table::DiskTable64::MAX_EXPONENT => {
            visitor.smooth(R::round(narrow, pressure)?)
        }
        (_, Tier::Exact) => visitor.smooth(compact::CompactPower::with_pressure(narrow, pressure)?),
    }
}

/// [`smooth`] for the uniform disk.
fn disk<R: Precision, V: Smooth<R>>(
    alpha: f64,
    tier: Tier,
    visitor: V,
) -> Result<V::Output, FrictionError> {
    let narrow = R::from_f64(alpha);
    match tier {
        Tier::Exact if alpha == 0.0 => visitor.smooth(coulomb::CoulombDisk),
        Tier::Exact if alpha <= table::DiskTable64::MAX_EXPONENT => {
            visitor.smooth(R::disk(narrow)?)
        }
        Tier::Exact => visitor.smooth(compact::CompactPower::new(narrow)?),
        Tier::Quadrature => Err(FrictionError::NoProfile),
    }
}

/// Work with a profile that knows its slope: what an annulus and a lean are made of.
pub trait Smooth<R: Real> {
    /// What the work gives.
    type Output;
    /// Does the work.
    fn smooth<P>(self, friction: P) -> Result<Self::Output, FrictionError>
    where
        P: SmoothProfile<R> + LateralFriction<R> + Send + Sync + 'static;
}

/// A visitor of patches that are no annulus.
struct Plain<V>(V);

impl<R: Real, V: Visitor<R>> Smooth<R> for Plain<V> {
    type Output = V::Output;
    fn smooth<P>(self, friction: P) -> Result<V::Output, FrictionError>
    where
        P: SmoothProfile<R> + LateralFriction<R> + Send + Sync + 'static,
    {
        Ok(self.0.visit(friction))
    }
}

/// A visitor of an annulus, given its disk.
struct InAnnulus<R, V> {
    inner: R,
    visitor: V,
}

impl<R: Real + 'static, V: Visitor<R>> Smooth<R> for InAnnulus<R, V> {
    type Output = V::Output;
    fn smooth<P>(self, disk: P) -> Result<V::Output, FrictionError>
    where
        P: SmoothProfile<R> + LateralFriction<R> + Send + Sync + 'static,
    {
        Ok(self.visitor.visit(Annulus::new(disk, self.inner)?))
    }
}

/// Leans dry friction by a fraction of the largest pressure gradient.
struct TiltVisitor(f64);

impl TiltVisitor {
    fn dry<P>(&self, foot: P) -> Result<Box<dyn PowerLawFriction<f64>>, FrictionError>
    where
        P: PowerLawFriction<f64> + DryReducedFriction<f64> + LateralFriction<f64> + 'static,
    {
        Ok(Box::new(LeanProfile::new(foot, self.0)?))
    }
}

impl Smooth<f64> for TiltVisitor {
    type Output = Box<dyn PowerLawFriction<f64>>;
    fn smooth<P>(self, foot: P) -> Result<Self::Output, FrictionError>
    where
        P: SmoothProfile<f64> + LateralFriction<f64> + Send + Sync + 'static,
    {
        self.dry(DryProfile::new(foot)?)
    }
}

/// Puts the type behind a pointer.
pub(super) struct BoxingVisitor;

impl<R: Real> Visitor<R> for BoxingVisitor {
    type Output = Box<dyn RoundPower<R>>;
    fn visit<P: RoundPower<R> + 'static>(self, friction: P) -> Self::Output {
        Box::new(friction)
    }
}
