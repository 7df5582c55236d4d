//! Friction of a tall body: the moment of friction about the centre of mass shifts the pressure forwards.
//!
//! Friction F pulls at the foot, inertia at the centre of mass a height h above. While the body
//! does not tip, the pressure balances that moment with a gradient, p (1 + l·r) with r in radii,
//!
//! ```text
//! l = −λ F/(γN),      λ = 2 γ h/(R ⟨r²⟩)       (for a cylinder of height H, h = H/2: γ H/R · 2)
//! ```
//!
//! and a pressure that leans makes spinning friction lateral ([`super::LateralFriction`]). Both ways of the
//! circle close at once: with F₀, G, E = ∂(vG)/∂v of the upright body,
//!
//! ```text
//! along: F = F₀/(1 + λ²GE),      lateral: λ G F,      torque: T₀ − λ²G F ∂(vG)/∂w
//! ```
//!
//! *Source*: eqs. 3.37 and 3.38 of the thesis, which keep only the gradient along the velocity
//! ([`LongitudinalGradient`]). The lateral force tips the body sideways as well, an effect of order λ² that
//! [`FullGradient`] includes.

use super::{LateralFriction, LateralJacobian, ReducedWrench, RoundFriction};
use crate::patch::PatchError;
use crate::real::Real;
use crate::twist::{Twist, Wrench};
use core::marker::PhantomData;
use nalgebra::Vector2;

/// Reduced wrench under a pressure with gradient.
#[doc(hidden)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct LeaningWrench<R> {
    /// F against the velocity.
    pub force: R,
    /// Force to the right of the velocity for counterclockwise spin, to the left for clockwise.
    pub lateral: R,
    /// T against the spin.
    pub torque: R,
}

/// The reduced wrench under the pressure p (1 + l·r), with `along` the component of l along the
/// velocity and `across` that to the left of it for counterclockwise spin (to the right for
/// clockwise).
///
/// *Domain*: |l| ≤ 1 keeps the pressure positive; beyond, the result is the formula's, not a
/// body's. *Units*: those of F.
#[doc(hidden)]
pub fn leaning_wrench<R: Real, C: LateralFriction<R>>(
    coupling: &C,
    [slide, rim]: [R; 2],
    [along, across]: [R; 2],
) -> LeaningWrench<R> {
    let ReducedWrench { force, torque } = coupling.reduced_wrench(slide, rim);
    let lateral = along * coupling.lateral(slide, rim);
    if across == R::ZERO {
        return LeaningWrench {
            force,
            lateral,
            torque,
        };
    }
    let change = coupling.lateral_jacobian(slide, rim);
    LeaningWrench {
        force: force - across * change.slide,
        lateral,
        torque: torque - across * change.rim,
    }
}

/// Which components of the pressure gradient are computed.
///
/// ```
/// use tribos_core::coupling::{coulomb::CoulombDisk, load_transfer::{FullGradient, LongitudinalGradient, PressureGradient}};
/// let (speeds, lean) = ([1.0_f64, 1.0], 0.1);
/// let (simple, _) = LongitudinalGradient::balance(&CoulombDisk, speeds, lean);
/// let (both, [along, across]) = FullGradient::balance(&CoulombDisk, speeds, lean);
/// // The gradient balances the very forces that it causes.
/// assert!((along - lean * both.force).abs() < 1e-15);
/// assert!((across - lean * both.lateral).abs() < 1e-15);
/// // The sideways lean is an effect of second order.
/// assert!((both.force - simple.force).abs() < lean * lean);
/// ```
pub trait PressureGradient: sealed::Sealed {
    /// The wrench and the gradient (along, across) for λ = `lean`.
    fn balance<R: Real, C: LateralFriction<R>>(
        coupling: &C,
        speeds: [R; 2],
        lean: R,
    ) -> (LeaningWrench<R>, [R; 2]);
}

mod sealed {
    pub trait Sealed {}
    impl Sealed for super::LongitudinalGradient {}
    impl Sealed for super::FullGradient {}
}

/// Only the gradient along the velocity, from the upright body's force (eq. 3.37).
///
/// ```
/// use tribos_core::coupling::{ReducedFriction, coulomb::CoulombDisk, load_transfer::{LongitudinalGradient, PressureGradient}};
/// let (wrench, gradient) = LongitudinalGradient::balance(&CoulombDisk, [0.3_f64, 0.4], 0.5);
/// let upright = CoulombDisk.reduced_wrench(0.3, 0.4);
/// assert_eq!([wrench.force, wrench.torque], [upright.force, upright.torque]);
/// assert_eq!(gradient, [0.5 * upright.force, 0.0]);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct LongitudinalGradient;

/// Both gradients, in balance with the forces that they cause.
///
/// *Cost*: a Jacobian more than [`LongitudinalGradient`].
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct FullGradient;

impl PressureGradient for LongitudinalGradient {
    #[inline]
    fn balance<R: Real, C: LateralFriction<R>>(
        coupling: &C,
        [slide, rim]: [R; 2],
        lean: R,
    ) -> (LeaningWrench<R>, [R; 2]) {
        let ReducedWrench { force, torque } = coupling.reduced_wrench(slide, rim);
        let along = lean * force;
        let wrench = LeaningWrench {
            force,
            lateral: along * coupling.lateral(slide, rim),
            torque,
        };
        (wrench, [along, R::ZERO])
    }
}

impl PressureGradient for FullGradient {
    fn balance<R: Real, C: LateralFriction<R>>(
        coupling: &C,
        [slide, rim]: [R; 2],
        lean: R,
    ) -> (LeaningWrench<R>, [R; 2]) {
        let ReducedWrench { force, torque } = coupling.reduced_wrench(slide, rim);
        let lateral = lean * coupling.lateral(slide, rim);
        let LateralJacobian { slide, rim } = coupling.lateral_jacobian(slide, rim);
        let force = force / (R::ONE + lean * lateral * slide);
        let lateral = lateral * force;
        let across = lean * lateral;
        let wrench = LeaningWrench {
            force,
            lateral,
            torque: torque - across * rim,
        };
        (wrench, [lean * force, across])
    }
}

/// Wrench and pressure gradient of a tall body, and whether it begins to tip.
///
/// ```
/// use tribos_core::coupling::load_transfer::{FullGradient, LoadTransferFriction, LoadTransferWrench};
/// use tribos_core::coupling::{RoundFriction, coulomb::CoulombDisk};
/// use tribos_core::twist::Twist;
/// let foot = RoundFriction::new(CoulombDisk, 0.2_f64, 0.08)?; // mu, m
/// let (height, load) = (0.05, 9.81); // m, N
/// let puck = LoadTransferFriction::<_, _, FullGradient>::new(foot, height)?;
/// let LoadTransferWrench { wrench, lean, .. } = puck.wrench(load, &Twist::new(1.0, 0.0, 10.0));
/// // Friction's moment about the centre of mass is the pressure's: N R l/4 in the uniform disk.
/// let pressure = lean * (load * 0.08 / 4.0);
/// assert!((wrench.force * height + pressure).amax() < 1e-14);
/// // A bottle tips when it slides, but not while it spins fast, where sliding meets little friction.
/// let foot = RoundFriction::new(CoulombDisk, 0.5_f64, 0.05)?; // mu, m
/// let bottle = LoadTransferFriction::<_, _, FullGradient>::new(foot, 0.1)?; // m
/// let [slides, spins] = [0.0, 1000.0].map(|spin| bottle.wrench(5.0, &Twist::new(1.0, 0.0, spin)));
/// assert!(slides.is_lifting && !spins.is_lifting);
/// # Ok::<(), tribos_core::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LoadTransferWrench<R: Real> {
    /// Force at the foot and torque about the normal.
    pub wrench: Wrench<R>,
    /// Pressure gradient l, per radius, that balances the force.
    pub lean: Vector2<R>,
    /// The pressure would be negative at the trailing edge: the body begins to tip. The gradient's share in
    /// the wrench has been held at |l| = 1.
    pub is_lifting: bool,
}

impl<R: Real> LoadTransferWrench<R> {
    /// The wrench, unless the body tips.
    ///
    /// ```
    /// use tribos_core::coupling::load_transfer::{FullGradient, LoadTransferFriction};
    /// use tribos_core::coupling::{RoundFriction, coulomb::CoulombDisk};
    /// use tribos_core::patch::PatchError;
    /// use tribos_core::twist::Twist;
    /// let foot = RoundFriction::new(CoulombDisk, 0.5_f64, 0.05)?; // mu, m
    /// let bottle = LoadTransferFriction::<_, _, FullGradient>::new(foot, 0.1)?; // centre of mass, m
    /// // Sliding without spin, force μN: the gradient is 4 μ h/R.
    /// let slides = bottle.wrench(5.0, &Twist::new(1.0, 0.0, 0.0)).whole();
    /// let Err(PatchError::Tips { lean }) = slides else { panic!("it tips") };
    /// assert!((lean - 4.0 * 0.5 * 0.1 / 0.05).abs() < 1e-14);
    /// # Ok::<(), tribos_core::Error>(())
    /// ```
    pub fn whole(&self) -> Result<Wrench<R>, PatchError> {
        if self.is_lifting {
            return Err(PatchError::Tips {
                lean: self.lean.x.hypot(self.lean.y).to_f64(),
            });
        }
        Ok(self.wrench)
    }
}

/// Friction of a body whose centre of mass lies above its foot.
///
/// *Units*: as [`RoundFriction`]. The wrench acts at the foot's centre.
///
/// ```
/// use tribos_core::coupling::{RoundFriction, load_transfer::{FullGradient, LoadTransferFriction}, coulomb::CoulombDisk};
/// use tribos_core::twist::Twist;
/// // A cylinder of radius 8 cm and height 16 cm: it drifts to the right when it spins left.
/// let foot = RoundFriction::new(CoulombDisk, 0.2_f64, 0.08)?;
/// let cylinder = LoadTransferFriction::<_, _, FullGradient>::new(foot, 0.08)?; // centre of mass, m
/// let wrench = cylinder.wrench(9.81, &Twist::new(1.0, 0.0, 10.0)).whole()?;
/// assert!(wrench.force.x < 0.0 && wrench.force.y < 0.0);
/// assert_eq!(cylinder.foot().radius(), 0.08);
/// # Ok::<(), tribos_core::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct LoadTransferFriction<R, C, L> {
    foot: RoundFriction<R, C>,
    /// λ
    lean: R,
    ways: PhantomData<L>,
}

impl<R: Real, C: LateralFriction<R>, L: PressureGradient> LoadTransferFriction<R, C, L> {
    /// *Domain*: 0 ≤ `height` < ∞, of the centre of mass above the foot.
    pub fn new(foot: RoundFriction<R, C>, height: R) -> Result<Self, PatchError> {
        let is_valid = height >= R::ZERO && height.is_finite();
        if !is_valid {
            let given = height.to_f64();
            return Err(PatchError::Height { given });
        }
        let arm = foot.radius() * foot.coupling().mean_square_radius();
        Ok(Self {
            lean: R::TWO * foot.coefficient() * height / arm,
            foot,
            ways: PhantomData,
        })
    }

    /// Wrench and pressure gradient at a twist, and whether the foot lifts.
    ///
    /// *Special values*: zero at rest; NaN in gives NaN out, and a foot that lifts.
    pub fn wrench(&self, load: R, twist: &Twist<R>) -> LoadTransferWrench<R> {
        let speed = twist.speed();
        let speeds = [speed, (twist.spin * self.foot.radius()).abs()];
        let coupling = self.foot.coupling();
        let (mut reduced, [along, across]) = L::balance(coupling, speeds, self.lean);
        let lean = along.hypot(across);
        let is_whole = lean <= R::ONE;
        if !is_whole {
            reduced = leaning_wrench(coupling, speeds, [along / lean, across / lean]);
        }
        let strength = self.foot.coefficient() * load;
        let (cos, sin) = if speed == R::ZERO {
            (R::ONE, R::ZERO)
        } else {
            (twist.velocity.x / speed, twist.velocity.y / speed)
        };
        let sense = R::ONE.copysign(twist.spin);
        let (back, side) = (strength * reduced.force, strength * reduced.lateral * sense);
        let across = across * sense;
        LoadTransferWrench {
            wrench: Wrench::new(
                side * sin - back * cos,
                -(side * cos) - back * sin,
                -(strength * self.foot.radius() * reduced.torque * sense),
            ),
            lean: Vector2::new(along * cos - across * sin, along * sin + across * cos),
            is_lifting: !is_whole,
        }
    }

    /// The foot.
    pub fn foot(&self) -> &RoundFriction<R, C> {
        &self.foot
    }

    /// λ: the pressure gradient per unit of reduced force.
    ///
    /// ```
    /// use tribos_core::coupling::{RoundFriction, coulomb::CoulombDisk, load_transfer::{FullGradient, LoadTransferFriction}};
    /// let (mu, radius) = (0.5_f64, 0.05); // m
    /// let foot = RoundFriction::new(CoulombDisk, mu, radius)?;
    /// // Friction's resultant leaves the kern of the disk, a quarter of its radius: λ = 1.
    /// let puck = LoadTransferFriction::<_, _, FullGradient>::new(foot, radius / 4.0 / mu)?;
    /// assert!((puck.lean() - 1.0).abs() < 1e-15);
    /// # Ok::<(), tribos_core::Error>(())
    /// ```
    pub fn lean(&self) -> R {
        self.lean
    }
}
