//! Friction laws shared by several tests, and their derivative by differences.

use tribos_core::law::{
    AgeingLaw, DryFriction, LuGre, LuGreParameters, PlateauPowerLaw, PlateauPowerLawParameters,
    RateState, RateStateParameters, Savkoor, SavkoorParameters, Stribeck, StribeckParameters,
};
use tribos_core::real::Real;

/// Rock with direct effect a, age effect b and viscosity.
pub fn rate_state<R: Real>(a: f64, b: f64, viscous: f64) -> RateState<R, AgeingLaw> {
    RateState::new(RateStateParameters {
        mu: R::from_f64(0.6),
        a: R::from_f64(a),
        b: R::from_f64(b),
        reference_speed: R::from_f64(1e-6),
        slip_distance: R::from_f64(1e-5),
        viscous: R::from_f64(viscous),
    })
    .expect("a law in its domain")
}

/// A bearing with Stribeck speed 1 cm/s.
pub fn stribeck<R: Real>(exponent: f64, viscous: f64) -> Stribeck<R> {
    let dry = DryFriction::new(R::from_f64(0.15), R::from_f64(0.1)).expect("a law in its domain");
    Stribeck::new(StribeckParameters {
        dry,
        speed: R::from_f64(0.01),
        exponent: R::from_f64(exponent),
        viscous: R::from_f64(viscous),
    })
    .expect("a law in its domain")
}

/// Ice with plateau speed 1e-4 m/s.
pub fn plateau<R: Real>(alpha: f64, rest: f64) -> PlateauPowerLaw<R> {
    let [alpha, gamma, plateau, drop, rest] = [alpha, 0.008, 1e-4, 1e-7, rest].map(R::from_f64);
    PlateauPowerLaw::new(PlateauPowerLawParameters {
        alpha,
        coefficient: gamma,
        plateau_speed: plateau,
        drop_speed: drop,
        rest_share: rest,
    })
    .expect("a law in its domain")
}

/// A tread with its largest friction at 0.5 m/s.
pub fn savkoor<R: Real>(narrowness: f64) -> Savkoor<R> {
    let [base, max, speed, narrowness] = [0.6, 1.2, 0.5, narrowness].map(R::from_f64);
    Savkoor::new(SavkoorParameters {
        mu_base: base,
        mu_max: max,
        speed,
        narrowness,
    })
    .expect("a law in its domain")
}

/// A joint with the canonical parameters.
pub fn lugre<R: Real>() -> LuGre<R> {
    LuGre::new(LuGreParameters {
        coulomb_force: R::from_f64(1.0),
        static_force: R::from_f64(1.5),
        stribeck_speed: R::from_f64(1e-3),
        stiffness: R::from_f64(1e5),
        bristle_damping: R::from_f64(316.0),
        viscous_damping: R::from_f64(0.4),
    })
    .expect("a law in its domain")
}

/// f' from central differences, extrapolated to sixth order.
pub fn differentiated(f: impl Fn(f64) -> f64, x: f64) -> f64 {
    let central = |h: f64| (f(x + h) - f(x - h)) / (2.0 * h);
    let h = x / 128.0;
    let (coarse, middle, fine) = (central(h), central(h / 2.0), central(h / 4.0));
    let (better, best) = ((4.0 * middle - coarse) / 3.0, (4.0 * fine - middle) / 3.0);
    (16.0 * best - better) / 15.0
}
