//! Friction laws: one list of them with what is known of each, and some that have tests of their own.

use std::sync::LazyLock;
use tribos_core::law::{
    AgeingLaw, DryFriction, LuGre, LuGreParameters, PlateauPowerLaw, PlateauPowerLawParameters,
    RateState, RateStateParameters, Stribeck, StribeckParameters,
};
use tribos_core::real::Real;
use tribos_friction::{LAWS as CATALOGUE, Law};
use tribos_subjects::MEMORYLESS;

/// A law of the local speed, as it is written in scenes, and what is known of it from elsewhere.
#[derive(Clone, Copy, Debug)]
pub struct LawInstance {
    /// Name and parameters.
    pub text: &'static str,
    /// Speed, coefficient and its slope with 16 digits of 40.
    pub exact: &'static [[f64; 3]],
    /// Speeds between which friction of a disk under it is compared with the mean over the rim.
    pub disk: Option<[f64; 2]>,
}

const fn of(text: &'static str) -> LawInstance {
    LawInstance {
        text,
        exact: &[],
        disk: None,
    }
}

const fn on_disk(text: &'static str, speeds: [f64; 2]) -> LawInstance {
    LawInstance {
        disk: Some(speeds),
        ..of(text)
    }
}

/// Steady states of laws with memory, with usual values; the laws without memory are among the subjects.
const STEADY: [&str; 2] = [
    "rate-state:mu0=0.4,a=0.01,b=0.015,v0=1e-3,dc=1e-5",
    "lugre:fc=0.3,fs=0.4,vs=0.01,s2=0.1",
];

/// Every law of the catalogue that depends on the speed alone: first with usual values, then others.
pub static LAWS: LazyLock<Vec<LawInstance>> =
    LazyLock::new(|| usual().into_iter().map(of).chain(OTHERS).collect());

/// Other values.
const OTHERS: [LawInstance; 18] = [
    of("power:gamma=0.7,alpha=-0.5"),
    of("power:gamma=0.7,alpha=2.5"),
    of("stribeck:mu_s=0.15,mu_d=0.1,vs=0.01,delta=0.5,k=0.5"),
    of("stribeck:mu_s=0.15,mu_d=0.1,vs=0.01,delta=1,k=0.5"),
    of("stribeck:mu_s=0.15,mu_d=0.1,vs=0.01,delta=2,k=0"),
    on_disk(
        "stribeck:mu_s=0.15,mu_d=0.1,vs=0.01,delta=2,k=0.5",
        [1e-3, 0.1],
    ),
    on_disk(
        "plateau:gamma=0.008,alpha=-0.5,vp=1e-4,vd=1e-7,r=0.5",
        [1e-5, 1.0],
    ),
    of("plateau:gamma=0.008,alpha=-0.19,vp=1e-4,vd=1e-7,r=0"),
    of("plateau:gamma=0.008,alpha=0,vp=1e-4,vd=1e-7,r=1"),
    LawInstance {
        exact: &WIDE_BELL,
        ..on_disk("savkoor:mu0=0.6,mu_m=1.2,vm=0.5,h=0.4", [1e-3, 10.0])
    },
    LawInstance {
        exact: &NARROW_BELL,
        ..of("savkoor:mu0=0.6,mu_m=1.2,vm=0.5,h=2")
    },
    LawInstance {
        exact: &RISE,
        ..on_disk("rising:mu_s=0.04,mu_f=0.12,vr=0.04", [1e-4, 10.0])
    },
    LawInstance {
        exact: &SMOOTH_STEP,
        ..on_disk("tanh:mu=0.8,vt=0.01", [1e-4, 1.0])
    },
    on_disk(
        "rate-state:mu0=0.6,a=0.01,b=0.015,v0=1e-6,dc=1e-5,eta=2",
        [1e-6, 1.0],
    ),
    of("rate-state:mu0=0.6,a=0.015,b=0.01,v0=1e-6,dc=1e-5"),
    of("rate-state:mu0=0.6,a=0.01,b=0.01,v0=1e-6,dc=1e-5"),
    of("rate-state:mu0=0.6,a=0.02,b=0,v0=1e-6,dc=1e-5"),
    on_disk("lugre:fc=1,fs=1.5,vs=1e-3,s2=0.4,load=4", [1e-4, 1e-2]),
];

/// Savkoor's bell for μ₀ = 0.6, μ_m = 1.2, v_m = 0.5, h = 0.4: mpmath in 40 digits.
const WIDE_BELL: [[f64; 3]; 10] = [
    [0.0, 0.6, 0.0],
    [1e-9, 0.6, 5.085814675869668e-19],
    [1e-6, 0.6000000000006497, 2.7282266363130422e-6],
    [1e-3, 0.6012429816434762, 2.4718860120760833],
    [0.1, 0.9964235427854786, 2.041661053249251],
    [0.5, 1.2, 0.0],
    [0.7, 1.1892293429289142, -0.09063282966772089],
    [3.0, 0.9589795187141159, -0.06860852820426101],
    [1e3, 0.6000580259324764, -1.4113582492049572e-7],
    [f64::INFINITY, 0.6, 0.0],
];
/// The same for h = 2.
const NARROW_BELL: [[f64; 3]; 6] = [
    [0.0, 0.6, 0.0],
    [1e-6, 0.6, 4.607148404837301e-292],
    [0.1, 0.6000189826111652, 0.0024441067268901186],
    [0.7, 0.9814864724116401, -1.466966932720928],
    [3.0, 0.600001588955611, -7.59207003205463e-6],
    [f64::INFINITY, 0.6, 0.0],
];

/// The rise for μₛ = 0.04, μ_f = 0.12, v_r = 0.04: mpmath in 40 digits.
const RISE: [[f64; 3]; 8] = [
    [0.0, 0.04, 2.0],
    [1e-9, 0.04000000199999997, 1.9999999500000006],
    [1e-3, 0.04197520703773339, 1.9506198240566653],
    [0.04, 0.0905696447062846, 0.7357588823428846],
    [0.1, 0.1134332001100881, 0.164169997247798],
    [1.0, 0.11999999999888896, 2.777588772992804e-11],
    [20.0, 0.12, 1.424915281348257e-217],
    [f64::INFINITY, 0.12, 0.0],
];
/// The hyperbolic tangent for μ = 0.8, v_t = 0.01: mpmath in 40 digits.
const SMOOTH_STEP: [[f64; 3]; 7] = [
    [1e-9, 7.999999999999974e-8, 79.9999999999992],
    [1e-3, 0.07973439569996466, 79.20530326779518],
    [0.01, 0.6092753247646119, 33.59794732912208],
    [0.03, 0.7960438029493844, 0.7892829732352155],
    [0.2, 0.8, 1.3594733616933054e-15],
    [3.5, 0.8, 3.155096494003127e-302],
    [f64::INFINITY, 0.8, 0.0],
];

/// The law of this text, in either precision.
///
/// # Panics
/// If it is refused.
pub fn made(text: &str) -> Law {
    text.parse()
        .unwrap_or_else(|error| panic!("{text}: {error}"))
}

/// One law for each name, with usual values, in the order of the catalogue.
pub fn usual() -> Vec<&'static str> {
    let memoryless = MEMORYLESS.iter().map(|law| law.usual);
    let mut texts: Vec<&str> = memoryless.chain(STEADY).collect();
    let place = |text: &&str| {
        CATALOGUE
            .iter()
            .position(|entry| entry.name == made(text).name())
    };
    texts.sort_by_key(place);
    texts
}

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
