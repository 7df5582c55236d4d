//! Friction laws of one surface element, body or joint.
//!
//! Each call validates the parameters again, with a few comparisons and no division.

use crate::memory::{answer, read};
use crate::status::tribos_status;
use tribos_core::law::{
    AgeingLaw, Bristle, CoulombLaw, DryFriction, LawError, LocalLaw, LuGre, LuGreParameters,
    PowerLaw, RateState, RateStateParameters, SlipLaw, StateVariable, SteadyRateState, StickSlip,
    Stribeck, StribeckParameters,
};

/// Coulomb's law: friction = mu x load.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct tribos_coulomb_f64 {
    /// Friction coefficient, 0 <= mu < inf.
    pub mu: f64,
}

/// Dry friction with different coefficients at rest and in motion,
/// 0 <= mu_dynamic <= mu_static < inf.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct tribos_dry_f64 {
    /// Coefficient at rest.
    pub mu_static: f64,
    /// Coefficient in motion.
    pub mu_dynamic: f64,
}

/// The power law: friction per load = coefficient x |speed|^alpha.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct tribos_power_f64 {
    /// Exponent, -1 < alpha <= 128. Below 0 friction falls with speed, and motions need not be unique.
    pub alpha: f64,
    /// Coefficient, 0 <= coefficient < inf, in (time/length)^alpha.
    pub coefficient: f64,
}

/// The Stribeck curve: mu(v) = mu_d + (mu_s - mu_d) exp(-(v/v_s)^exponent) + viscous v.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct tribos_stribeck_f64 {
    /// Coefficients mu_s and mu_d.
    pub dry: tribos_dry_f64,
    /// Stribeck speed v_s, positive and finite.
    pub stribeck_speed: f64,
    /// Exponent of the decay, positive and finite; 1 and 2 are usual.
    pub exponent: f64,
    /// Viscous coefficient in 1/speed, finite and not negative.
    pub viscous: f64,
}

/// The LuGre model in units of force:
/// z' = v - stiffness |v| z/g(v), g(v) = F_c + (F_s - F_c) exp(-(v/v_s)^2),
/// force = stiffness z + bristle_damping z' + viscous_damping v.
/// The force has the sign of v: the friction on a body that moves with v is minus this force.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct tribos_lugre_f64 {
    /// Coulomb force F_c, 0 < F_c <= F_s.
    pub coulomb_force: f64,
    /// Static force F_s, the largest force of the bristles.
    pub static_force: f64,
    /// Stribeck speed v_s, positive.
    pub stribeck_speed: f64,
    /// Stiffness of the bristles, positive, force/length.
    pub stiffness: f64,
    /// Damping of the bristles, not negative, force x time/length.
    pub bristle_damping: f64,
    /// Viscous damping, not negative, force x time/length.
    pub viscous_damping: f64,
}

/// Rate-and-state friction, regularised at rest:
/// mu(V, theta) = a asinh(V/q) + viscous V, q = 2 V_0 exp(-(mu + b ln(V_0 theta/D_c))/a).
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct tribos_rate_state_f64 {
    /// Coefficient of steady sliding at V_0, not negative.
    pub mu: f64,
    /// Direct effect of the speed, positive.
    pub a: f64,
    /// Effect of the age, not negative.
    pub b: f64,
    /// Reference speed V_0, positive.
    pub reference_speed: f64,
    /// Memory length D_c, positive.
    pub slip_distance: f64,
    /// Viscous coefficient in 1/speed, not negative.
    pub viscous: f64,
}

fn dry(law: tribos_dry_f64) -> Result<DryFriction<f64>, LawError> {
    DryFriction::new(law.mu_static, law.mu_dynamic)
}

fn lugre(law: tribos_lugre_f64) -> Result<LuGre<f64>, LawError> {
    LuGre::new(LuGreParameters {
        coulomb_force: law.coulomb_force,
        static_force: law.static_force,
        stribeck_speed: law.stribeck_speed,
        stiffness: law.stiffness,
        bristle_damping: law.bristle_damping,
        viscous_damping: law.viscous_damping,
    })
}

fn rate_state<E: tribos_core::law::StateEvolution>(
    law: tribos_rate_state_f64,
) -> Result<RateState<f64, E>, LawError> {
    RateState::new(RateStateParameters {
        mu: law.mu,
        a: law.a,
        b: law.b,
        reference_speed: law.reference_speed,
        slip_distance: law.slip_distance,
        viscous: law.viscous,
    })
}

fn steady(law: tribos_rate_state_f64) -> Result<SteadyRateState<f64>, LawError> {
    // The age of steady sliding is the same for both evolution laws.
    Ok(rate_state::<AgeingLaw>(law)?.steady())
}

/// Parameters of a law of the local sliding speed.
pub(super) trait Local {
    /// The kernel's law.
    type Law: LocalLaw<f64>;
    /// Validates the parameters.
    fn law(self) -> Result<Self::Law, LawError>;
}

impl Local for tribos_coulomb_f64 {
    type Law = CoulombLaw<f64>;
    #[inline(always)]
    fn law(self) -> Result<Self::Law, LawError> {
        CoulombLaw::new(self.mu)
    }
}

impl Local for tribos_power_f64 {
    type Law = PowerLaw<f64>;
    #[inline(always)]
    fn law(self) -> Result<Self::Law, LawError> {
        PowerLaw::new(self.alpha, self.coefficient)
    }
}

impl Local for tribos_stribeck_f64 {
    type Law = Stribeck<f64>;
    #[inline(always)]
    fn law(self) -> Result<Self::Law, LawError> {
        Stribeck::new(StribeckParameters {
            dry: dry(self.dry)?,
            speed: self.stribeck_speed,
            exponent: self.exponent,
            viscous: self.viscous,
        })
    }
}

/// Friction per load of Coulomb's law: mu at every speed.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tribos_coulomb_friction_f64(
    law: *const tribos_coulomb_f64,
    speed: f64,
    friction: *mut f64,
) -> tribos_status {
    answer(friction, || Ok(read(law)?.law()?.friction(speed)))
}

/// Friction per load in motion: mu_dynamic. Special values: NaN gives NaN.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tribos_dry_friction_f64(
    law: *const tribos_dry_f64,
    speed: f64,
    friction: *mut f64,
) -> tribos_status {
    answer(friction, || Ok(dry(read(law)?)?.friction(speed)))
}

/// Whether a body at rest remains at rest under a tangential load per normal load, of either sign: 1 if
/// it sticks, 0 if it slips. Special values: |drive| = mu_static sticks, NaN slips.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tribos_dry_sticks_f64(
    law: *const tribos_dry_f64,
    drive_per_load: f64,
    sticks: *mut u32,
) -> tribos_status {
    answer(sticks, || {
        Ok((dry(read(law)?)?.at_rest(drive_per_load) == StickSlip::Stick).into())
    })
}

/// Net tangential load on a body at rest, per normal load: zero if the body sticks, else the drive minus
/// dynamic friction, with the sign of the drive. Special values: NaN gives NaN.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tribos_dry_net_drive_f64(
    law: *const tribos_dry_f64,
    drive_per_load: f64,
    net: *mut f64,
) -> tribos_status {
    answer(net, || Ok(dry(read(law)?)?.net_drive(drive_per_load)))
}

/// Friction per load of the power law at speed > 0.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tribos_power_friction_f64(
    law: *const tribos_power_f64,
    speed: f64,
    friction: *mut f64,
) -> tribos_status {
    answer(friction, || Ok(read(law)?.law()?.friction(speed)))
}

/// Derivative of the power law's friction with respect to speed, at speed > 0.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tribos_power_slope_f64(
    law: *const tribos_power_f64,
    speed: f64,
    slope: *mut f64,
) -> tribos_status {
    answer(slope, || Ok(read(law)?.law()?.slope(speed)))
}

/// Friction per load of the Stribeck curve at speed >= 0.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tribos_stribeck_friction_f64(
    law: *const tribos_stribeck_f64,
    speed: f64,
    friction: *mut f64,
) -> tribos_status {
    answer(friction, || Ok(read(law)?.law()?.friction(speed)))
}

/// Derivative of the Stribeck curve with respect to speed. At rest: -inf for an exponent below 1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tribos_stribeck_slope_f64(
    law: *const tribos_stribeck_f64,
    speed: f64,
    slope: *mut f64,
) -> tribos_status {
    answer(slope, || Ok(read(law)?.law()?.slope(speed)))
}

/// Speed of minimum friction between boundary and hydrodynamic lubrication;
/// TRIBOS_STATUS_NO_MINIMUM if there is none. Cost: at most 512 slopes.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tribos_stribeck_minimum_f64(
    law: *const tribos_stribeck_f64,
    speed: *mut f64,
) -> tribos_status {
    answer(speed, || {
        let least = read(law)?.law()?.minimum();
        least.ok_or(tribos_status::NoMinimum)
    })
}

/// One step of dt >= 0 at constant velocity: advances the deflection (initially 0) and returns the
/// mean force over the step, so that force x dt is the impulse. Both are exact for any dt. The
/// force has the sign of the velocity. Special values: NaN gives NaN.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tribos_lugre_step_f64(
    law: *const tribos_lugre_f64,
    deflection: *mut f64,
    velocity: f64,
    dt: f64,
    force: *mut f64,
) -> tribos_status {
    answer(force, || {
        let start = Bristle {
            deflection: read(deflection)?,
        };
        let (end, mean) = lugre(read(law)?)?.step(start, velocity, dt);
        deflection.write(end.deflection);
        Ok(mean)
    })
}

/// Instantaneous force, stiffness z + bristle_damping z' + viscous_damping v.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tribos_lugre_force_f64(
    law: *const tribos_lugre_f64,
    deflection: f64,
    velocity: f64,
    force: *mut f64,
) -> tribos_status {
    answer(force, || {
        Ok(lugre(read(law)?)?.force(Bristle { deflection }, velocity))
    })
}

/// Force of steady sliding, sgn(v) g(v) + viscous_damping v; at rest the limit for the sign of the zero.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tribos_lugre_steady_force_f64(
    law: *const tribos_lugre_f64,
    velocity: f64,
    force: *mut f64,
) -> tribos_status {
    answer(force, || Ok(lugre(read(law)?)?.steady_force(velocity)))
}

/// Speed up to which the model dissipates energy for any deflection; infinite if it always does.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tribos_lugre_passive_up_to_f64(
    law: *const tribos_lugre_f64,
    speed: *mut f64,
) -> tribos_status {
    answer(speed, || Ok(lugre(read(law)?)?.passive_up_to()))
}

/// Friction per load at speed >= 0 for a contact of age theta (a time); 0 at rest.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tribos_rate_state_friction_f64(
    law: *const tribos_rate_state_f64,
    speed: f64,
    theta: f64,
    friction: *mut f64,
) -> tribos_status {
    answer(friction, || {
        Ok(rate_state::<AgeingLaw>(read(law)?)?.coefficient(speed, StateVariable { theta }))
    })
}

/// Derivative of this friction with respect to speed at constant age.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tribos_rate_state_slope_f64(
    law: *const tribos_rate_state_f64,
    speed: f64,
    theta: f64,
    slope: *mut f64,
) -> tribos_status {
    answer(slope, || {
        Ok(rate_state::<AgeingLaw>(read(law)?)?.slope(speed, StateVariable { theta }))
    })
}

/// Advances the age theta by dt >= 0 at constant speed, exactly, by the ageing law
/// theta' = 1 - V theta/D_c.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tribos_rate_state_advance_dieterich_f64(
    law: *const tribos_rate_state_f64,
    theta: *mut f64,
    speed: f64,
    dt: f64,
) -> tribos_status {
    answer(theta, || {
        let (law, age) = (rate_state::<AgeingLaw>(read(law)?)?, read(theta)?);
        Ok(law.advance(StateVariable { theta: age }, speed, dt).theta)
    })
}

/// Advances the age theta like the function above, by the slip law theta' = -(V theta/D_c) ln(V theta/D_c).
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tribos_rate_state_advance_ruina_f64(
    law: *const tribos_rate_state_f64,
    theta: *mut f64,
    speed: f64,
    dt: f64,
) -> tribos_status {
    answer(theta, || {
        let (law, age) = (rate_state::<SlipLaw>(read(law)?)?, read(theta)?);
        Ok(law.advance(StateVariable { theta: age }, speed, dt).theta)
    })
}

/// Friction per load of steady sliding, where theta = D_c/V.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tribos_rate_state_steady_friction_f64(
    law: *const tribos_rate_state_f64,
    speed: f64,
    friction: *mut f64,
) -> tribos_status {
    answer(friction, || Ok(steady(read(law)?)?.friction(speed)))
}

/// Derivative of the steady friction with respect to speed.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tribos_rate_state_steady_slope_f64(
    law: *const tribos_rate_state_f64,
    speed: f64,
    slope: *mut f64,
) -> tribos_status {
    answer(slope, || Ok(steady(read(law)?)?.slope(speed)))
}
