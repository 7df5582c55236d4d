//! The LuGre bristle model: presliding, break-away, Stribeck effect and memory in one state.

use super::error::{not_negative, ordered, positive};
use super::limits::scaled;
use super::{LawError, LocalLaw};
use crate::real::Real;

/// Parameters of [`LuGre`], in units of force.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct LuGreParameters<R> {
    /// Coulomb force F_c.
    pub coulomb_force: R,
    /// Static force Fₛ, the most that the bristles carry.
    pub static_force: R,
    /// Stribeck speed vₛ.
    pub stribeck_speed: R,
    /// Stiffness σ₀ of the bristles.
    pub stiffness: R,
    /// Damping σ₁ of the bristles.
    pub bristle_damping: R,
    /// Viscous damping σ₂.
    pub viscous_damping: R,
}

/// The LuGre model.
///
/// ```text
/// z' = v − σ₀ |v| z/g(v),     g(v) = F_c + (Fₛ − F_c) exp(−(v/vₛ)²)
/// F  = σ₀ z + σ₁ z' + σ₂ v
/// ```
///
/// F has the sign of v: it resists a body that moves with v, which feels −F.
///
/// While v is constant z approaches ±g/σ₀ exponentially. [`LuGre::step`] uses that solution: it is
/// exact for any step, never leaves |z| ≤ Fₛ/σ₀, and needs no step below g/(σ₀|v|), which explicit
/// rules do.
///
/// *Passivity*: from v to z always. From v to F at constant σ₁ only up to
/// [`LuGre::passive_up_to`].
///
/// *Units*: SI or consistent: forces, speed, force/length, force × time/length.
/// *Domain*: σ₀v²/g in the range of the type; v of either sign.
/// *Source*: Canudas de Wit, Olsson, Åström and Lischinsky 1995.
///
/// ```
/// use tribos_core::law::{Bristle, LuGre, LuGreParameters};
/// let joint = LuGre::new(LuGreParameters {
///     coulomb_force: 1.0_f64, static_force: 1.5, stribeck_speed: 1e-3, // N, N, m/s
///     stiffness: 1e5, bristle_damping: 316.0, viscous_damping: 0.4, // N/m, N s/m
/// })?;
/// let (bristle, force) = joint.step(Bristle::RELAXED, 0.1, 1.0); // m/s, s
/// assert!((joint.steady_force(0.1) - 1.04).abs() < 1e-12);
/// assert!((force - 1.04).abs() < 0.01); // mean over the step, with the start
/// assert!((bristle.deflection - 1e-5).abs() < 1e-18); // F_c/sigma_0
///
/// // The bristles carry g(v) now and bend no further; at most they could carry F_s.
/// assert_eq!(joint.steady_bristle_force(0.1), 1.0);
/// assert!(joint.rate(bristle, 0.1).abs() < 1e-15);
/// assert!((joint.largest_deflection() - 1.5 * bristle.deflection).abs() < 1e-18);
/// # Ok::<(), tribos_core::law::LawError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct LuGre<R> {
    parameters: LuGreParameters<R>,
}

/// State of a LuGre contact: the mean deflection of its bristles.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Bristle<R> {
    /// Mean deflection z of the bristles. *Units*: length.
    pub deflection: R,
}

impl<R: Real> Bristle<R> {
    /// Not deflected.
    pub const RELAXED: Self = Self {
        deflection: R::ZERO,
    };
}

impl<R: Real> LuGre<R> {
    /// *Domain*: 0 < F_c ≤ Fₛ < ∞; 0 < vₛ, σ₀ < ∞; 0 ≤ σ₁, σ₂ < ∞.
    pub fn new(parameters: LuGreParameters<R>) -> Result<Self, LawError> {
        let p = &parameters;
        positive("Coulomb force", p.coulomb_force)?;
        positive("static force", p.static_force)?;
        ordered(
            ("Coulomb force", p.coulomb_force),
            ("static force", p.static_force),
        )?;
        positive("Stribeck speed", p.stribeck_speed)?;
        positive("bristle stiffness", p.stiffness)?;
        not_negative("bristle damping", p.bristle_damping)?;
        not_negative("viscous damping", p.viscous_damping)?;
        Ok(Self { parameters })
    }

    /// The parameters.
    pub fn parameters(&self) -> &LuGreParameters<R> {
        &self.parameters
    }

    /// Largest deflection Fₛ/σ₀ of a bristle that starts within it.
    pub fn largest_deflection(&self) -> R {
        self.parameters.static_force / self.parameters.stiffness
    }

    /// g(v) = F_c + (Fₛ − F_c) exp(−(v/vₛ)²), what the bristles carry in steady sliding.
    #[inline]
    pub fn steady_bristle_force(&self, velocity: R) -> R {
        let p = &self.parameters;
        p.coulomb_force + (p.static_force - p.coulomb_force) * self.faded(velocity)
    }

    /// Force of steady sliding, sgn(v) g(v) + σ₂ v; at rest the limit for the sign of the zero.
    #[inline]
    pub fn steady_force(&self, velocity: R) -> R {
        self.steady_bristle_force(velocity).copysign(velocity)
            + scaled(self.parameters.viscous_damping, velocity)
    }

    /// z' at this moment.
    #[inline]
    pub fn rate(&self, bristle: Bristle<R>, velocity: R) -> R {
        let load =
            self.parameters.stiffness * bristle.deflection / self.steady_bristle_force(velocity);
        velocity - velocity.abs() * load
    }

    /// Force at this moment, σ₀ z + σ₁ z' + σ₂ v.
    #[inline]
    pub fn force(&self, bristle: Bristle<R>, velocity: R) -> R {
        self.total(bristle.deflection, self.rate(bristle, velocity), velocity)
    }

    /// The state after `dt` ≥ 0 at constant velocity, and the *mean* force over that time, so that
    /// force × dt is the impulse. Both are exact.
    ///
    /// *Accuracy*: state and force within some ulp of Fₛ/σ₀ and of the largest term of the force.
    /// *Special values*: dt = 0 gives the force at this moment; NaN gives NaN.
    #[inline]
    pub fn step(&self, bristle: Bristle<R>, velocity: R, dt: R) -> (Bristle<R>, R) {
        let (stiffness, start) = (self.parameters.stiffness, bristle.deflection);
        let limit = self.steady_bristle_force(velocity) / stiffness;
        let steady = limit.copysign(velocity);
        // The distance slid, in units of the limit, is the exponent of the decay.
        let slid = velocity.abs() * dt / limit;
        let renewed = -(-slid).exp_m1();
        let end = start * (-slid).exp() + steady * renewed;
        // Means over the step: (1 − e^−slid)/slid is the mean of the decaying exponential.
        let decay = if slid == R::ZERO {
            R::ONE
        } else {
            renewed / slid
        };
        let mean = start * decay + steady * (R::ONE - decay);
        let mean_rate = self.rate(bristle, velocity) * decay;
        let end = Bristle { deflection: end };
        (end, self.total(mean, mean_rate, velocity))
    }

    /// Speed up to which friction dissipates whatever the deflection |z| ≤ Fₛ/σ₀.
    ///
    /// With w = σ₀|v|z/g and the stored energy σ₀z²/2, the dissipated power is
    /// F v − σ₀zz' = σ₁z'² + σ₁z'w + (g/|v|)w² + σ₂(z' + w)². Its discriminant is not positive for
    /// |v| ≤ 4(σ₁ + σ₂)g/σ₁². If σ₂F_c ≥ σ₁(Fₛ − F_c), every speed dissipates: w ≤ vFₛ/F_c leaves
    /// v²(σ₁(1 − Fₛ/F_c) + σ₂) ≥ 0. Infinite then, else the first bound with g = F_c.
    ///
    /// *Source*: the second condition is that of Barabanov and Ortega 2000.
    ///
    /// ```
    /// use tribos_core::law::{Bristle, LuGre, LuGreParameters};
    /// # let joint = LuGre::new(LuGreParameters {
    /// #     coulomb_force: 1.0_f64, static_force: 1.5, stribeck_speed: 1e-3,
    /// #     stiffness: 1e5, bristle_damping: 316.0, viscous_damping: 0.4,
    /// # })?; // as above
    /// // What the motion gives beyond what the bristles store, at their largest deflection.
    /// let bristle = Bristle { deflection: joint.largest_deflection() };
    /// let dissipated = |speed| {
    ///     let stretch = joint.parameters().stiffness * bristle.deflection; // N
    ///     joint.force(bristle, speed) * speed - stretch * joint.rate(bristle, speed) // W
    /// };
    /// let border = joint.passive_up_to(); // m/s
    /// assert!(dissipated(0.9 * border) > 0.0 && dissipated(2.0 * border) < 0.0);
    /// // Viscous damping sigma_1 (F_s - F_c)/F_c makes every speed passive.
    /// let damped = LuGreParameters { viscous_damping: 158.0, ..*joint.parameters() };
    /// assert_eq!(LuGre::new(damped)?.passive_up_to(), f64::INFINITY);
    /// # Ok::<(), tribos_core::law::LawError>(())
    /// ```
    pub fn passive_up_to(&self) -> R {
        let p = &self.parameters;
        let rise = p.static_force - p.coulomb_force;
        if p.viscous_damping * p.coulomb_force >= p.bristle_damping * rise {
            return R::INFINITY;
        }
        let four = R::TWO + R::TWO;
        let share = p.viscous_damping / p.bristle_damping;
        four * (R::ONE + share) * p.coulomb_force / p.bristle_damping
    }

    /// Steady sliding as a local law: force over `load`.
    ///
    /// *Units*: dimensionless, with the forces of the law and the load in one unit. *Domain*: 0 < `load` < ∞,
    /// the load at which the forces were measured.
    ///
    /// ```
    /// use tribos_core::law::{LocalLaw, LuGre, LuGreParameters};
    /// let joint = LuGre::new(LuGreParameters {
    ///     coulomb_force: 1.0_f64, static_force: 1.5, stribeck_speed: 1e-3, // N, N, m/s
    ///     stiffness: 1e5, bristle_damping: 316.0, viscous_damping: 0.4, // N/m, N s/m
    /// })?;
    /// let steady = joint.steady_per_load(10.0)?; // N
    /// // Far above the Stribeck speed (F_c + sigma_2 v)/load is left.
    /// assert!((steady.friction(0.1) - (1.0 + 0.4 * 0.1) / 10.0).abs() < 1e-15);
    /// assert!((steady.slope(0.1) - 0.4 / 10.0).abs() < 1e-15);
    /// # Ok::<(), tribos_core::law::LawError>(())
    /// ```
    pub fn steady_per_load(&self, load: R) -> Result<SteadyLuGre<R>, LawError> {
        Ok(SteadyLuGre {
            law: *self,
            load: positive("load", load)?,
        })
    }

    /// exp(−(v/vₛ)²)
    #[inline]
    fn faded(&self, velocity: R) -> R {
        let x = velocity / self.parameters.stribeck_speed;
        (-(x * x)).exp()
    }

    /// σ₀ z + σ₁ z' + σ₂ v
    #[inline]
    fn total(&self, deflection: R, rate: R, velocity: R) -> R {
        let p = &self.parameters;
        p.stiffness * deflection
            + scaled(p.bristle_damping, rate)
            + scaled(p.viscous_damping, velocity)
    }
}

/// Steady friction of a [`LuGre`] contact per load.
#[doc(hidden)]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct SteadyLuGre<R> {
    law: LuGre<R>,
    load: R,
}

impl<R: Real> LocalLaw<R> for SteadyLuGre<R> {
    #[inline]
    fn friction(&self, speed: R) -> R {
        self.law.steady_force(speed) / self.load
    }
    #[inline]
    fn slope(&self, speed: R) -> R {
        let p = &self.law.parameters;
        let faded = self.law.faded(speed);
        // The Stribeck term is gone before v/vₛ can grow without bound.
        let fall = if faded == R::ZERO {
            R::ZERO
        } else {
            let x = speed / p.stribeck_speed;
            (p.static_force - p.coulomb_force) / p.stribeck_speed * R::TWO * x * faded
        };
        (p.viscous_damping - fall) / self.load
    }
}
