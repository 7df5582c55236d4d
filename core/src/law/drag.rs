//! Drag on a sphere in a fluid: forces, not friction per load.
//!
//! Dimensional analysis leaves F = ρv²r² f(Re) (thesis eq. 2.3). Slow flow is viscous, f = C₁/Re;
//! fast flow is inertial, f = C₂. All arguments are magnitudes.

use super::LawError;
use super::error::positive;
use super::limits::scaled;
use crate::real::Real;

/// C₁ = 6π of Stokes' drag.
const STOKES_CONSTANT: f64 = 6.0 * core::f64::consts::PI;

/// Viscous drag F = 6π η r v.
///
/// *Units*: SI or consistent: η in pressure × time. *Domain*: Re ≪ 1; the first correction
/// (Oseen) is 3/8 of Re. *Source*: Stokes; thesis eq. 2.4.
///
/// ```
/// use tribos_core::law::{Stokes, reynolds};
/// let bead = Stokes::new(1e-3_f64, 1e-6)?; // water, 1 um
/// assert!((bead.force(1e-4) - 1.885e-12).abs() < 1e-15); // N
/// assert!((bead.slope(0.0) - 6.0 * core::f64::consts::PI * 1e-3 * 1e-6).abs() < 1e-23); // N s/m
/// assert!((reynolds(1e3, 1e-4, 1e-6, 1e-3) - 1e-4_f64).abs() < 1e-18);
/// # Ok::<(), tribos_core::law::LawError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Stokes<R> {
    /// 6π η r
    damping: R,
}

impl<R: Real> Stokes<R> {
    /// Viscosity η and sphere radius r. *Domain*: both positive and finite, and their product.
    pub fn new(viscosity: R, radius: R) -> Result<Self, LawError> {
        positive("viscosity", viscosity)?;
        positive("sphere radius", radius)?;
        let damping = R::from_f64(STOKES_CONSTANT) * viscosity * radius;
        Ok(Self {
            damping: positive("viscosity times radius", damping)?,
        })
    }

    /// Drag at a speed.
    #[inline]
    pub fn force(&self, speed: R) -> R {
        self.damping * speed
    }

    /// d(force)/d(speed) = 6π η r; NaN for NaN.
    #[inline]
    pub fn slope(&self, speed: R) -> R {
        if speed.is_nan() { speed } else { self.damping }
    }
}

/// Inertial drag F = C₂ ρ v² r².
///
/// *Units*: SI or consistent. *Domain*: Re ≫ 1. A drag coefficient C_D that counts the cross
/// section is C₂ = π C_D/2: 0.7 for a smooth sphere at 10³ < Re < 10⁵, where C_D is 0.44.
/// *Source*: thesis section 2.3.2.
///
/// ```
/// use core::f64::consts::PI;
/// use tribos_core::law::InertialDrag;
/// let (air, radius, weight) = (1.2, 0.02, 2.7e-3 * 9.81); // kg/m^3, m, N: table tennis
/// let ball = InertialDrag::new(PI * 0.44 / 2.0, air, radius)?;
/// // It falls at last with the speed at which C_D A rho v^2/2 carries its weight.
/// let section = PI * radius * radius;
/// let terminal = f64::sqrt(2.0 * weight / (0.44 * section * air)); // 9 m/s
/// assert!((ball.force(terminal) - weight).abs() < 1e-15);
/// assert!((ball.slope(terminal) * terminal - 2.0 * weight).abs() < 1e-15);
/// # Ok::<(), tribos_core::law::LawError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct InertialDrag<R> {
    /// C₂ ρ r²
    factor: R,
}

impl<R: Real> InertialDrag<R> {
    /// Constant C₂, density ρ of the fluid and sphere radius r. *Domain*: all positive and finite,
    /// and their product.
    pub fn new(constant: R, density: R, radius: R) -> Result<Self, LawError> {
        positive("drag constant", constant)?;
        positive("density", density)?;
        positive("sphere radius", radius)?;
        let factor = constant * density * radius * radius;
        Ok(Self {
            factor: positive("density times radius squared", factor)?,
        })
    }

    /// Drag at a speed.
    #[inline]
    pub fn force(&self, speed: R) -> R {
        self.factor * speed * speed
    }

    /// d(force)/d(speed) = 2 C₂ ρ r² v.
    #[inline]
    pub fn slope(&self, speed: R) -> R {
        R::TWO * self.factor * speed
    }
}

/// Reynolds number Re = ρ v r/η, with the radius, not the diameter.
///
/// *Special values*: a fluid without viscosity has infinite Re, at rest zero.
#[inline]
pub fn reynolds<R: Real>(density: R, speed: R, radius: R, viscosity: R) -> R {
    scaled(speed, density * radius / viscosity)
}

/// Re at which the two forces are equal: C₁/C₂ = 6π/C₂.
///
/// *Domain*: `inertial_constant` C₂ > 0.
#[inline]
pub fn crossover_reynolds<R: Real>(inertial_constant: R) -> R {
    R::from_f64(STOKES_CONSTANT) / inertial_constant
}

/// Which of two forces on the sphere is the larger.
///
/// ```
/// use tribos_core::law::{DragRegime, InertialDrag, Stokes, crossover_reynolds};
/// let (water, viscosity, radius) = (1e3, 1e-3, 1e-3); // kg/m^3, Pa s, m
/// let crossover = crossover_reynolds(0.7_f64);
/// let speed = crossover * viscosity / (water * radius); // 3 cm/s
/// let viscous = Stokes::new(viscosity, radius)?.force(speed);
/// let inertial = InertialDrag::new(0.7, water, radius)?.force(speed);
/// assert!((viscous / inertial - 1.0).abs() < 1e-14);
/// assert_eq!(DragRegime::at(crossover / 10.0, 0.7), Some(DragRegime::Viscous));
/// assert_eq!(DragRegime::at(crossover * 10.0, 0.7), Some(DragRegime::Inertial));
/// # Ok::<(), tribos_core::law::LawError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum DragRegime {
    /// Stokes' drag, Re ≤ C₁/C₂: laminar flow.
    Viscous,
    /// Inertial drag: turbulent flow.
    Inertial,
}

impl DragRegime {
    /// The regime at a Reynolds number, for the constant C₂; `None` for NaN.
    pub fn at<R: Real>(reynolds: R, inertial_constant: R) -> Option<Self> {
        let crossover = crossover_reynolds(inertial_constant);
        if reynolds <= crossover {
            Some(Self::Viscous)
        } else if reynolds > crossover {
            Some(Self::Inertial)
        } else {
            None
        }
    }
}
