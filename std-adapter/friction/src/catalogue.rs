//! All friction laws of the kernel: formula, parameters, units, source, and how local ones are made.

use std::fmt;
use tribos_core::law::{
    CoulombLaw, DryFriction, LawError, LocalLaw, LuGre, LuGreParameters, PlateauPowerLaw,
    PlateauPowerLawParameters, PowerLaw, RateState, RateStateParameters, RisingLaw,
    RisingLawParameters, Savkoor, SavkoorParameters, Stribeck, StribeckParameters, TanhLaw,
};
use tribos_core::real::Real;

/// One law of the kernel.
///
/// ```
/// use tribos::friction::{LawEntry, LAWS, Law, LawConstructor, LawParameter, find};
/// let stribeck: &LawEntry = find("stribeck").ok_or("no such law")?;
/// let exponent: &LawParameter = &stribeck.parameters[3];
/// assert_eq!((exponent.name, exponent.default), ("delta", Some(2.0)));
/// // Local laws can be made by name; the others depend on more than the speed.
/// for entry in LAWS {
///     let made: Option<LawConstructor> = entry.local;
///     let list: Vec<String> = entry.parameters.iter().map(|p| format!("{}=0.5", p.name)).collect();
///     let law = format!("{}:{}", entry.name, list.join(",")).parse::<Law>();
///     assert_eq!(law.is_ok(), made.is_some());
/// }
/// # Ok::<(), &str>(())
/// ```
#[derive(Debug)]
pub struct LawEntry {
    /// Name of the law.
    pub name: &'static str,
    /// What kind of friction it describes.
    pub summary: &'static str,
    /// Formula in ASCII.
    pub formula: &'static str,
    /// Parameters, in the order in which they are written.
    pub parameters: &'static [LawParameter],
    /// Publication that the law is from.
    pub source: &'static str,
    /// How it is made, if it is a law of the local sliding speed, which couples with any patch.
    pub local: Option<LawConstructor>,
}

/// One parameter of a law.
#[derive(Debug)]
pub struct LawParameter {
    /// Name of the parameter.
    pub name: &'static str,
    /// Unit in SI, or "-" for a pure number.
    pub unit: &'static str,
    /// What the parameter means.
    pub meaning: &'static str,
    /// Value used where it is left out; `None` if it must be given.
    pub default: Option<f64>,
}

/// Most parameters of a law.
pub(super) const MOST_PARAMETERS: usize = 6;
/// Values of a law's parameters in their order, followed by zeros.
pub(super) type Values<R> = [R; MOST_PARAMETERS];
/// A law, or why its values make none.
pub(super) type LawResult<R> = Result<Box<dyn LocalLaw<R> + Send + Sync>, LawError>;

/// How a local law is made from the values of its parameters.
#[derive(Clone, Copy)]
pub struct LawConstructor {
    pub(super) double: fn(Values<f64>) -> LawResult<f64>,
    pub(super) single: fn(Values<f32>) -> LawResult<f32>,
    /// Coefficient and exponent of a law that is a power of the speed.
    pub(super) power: Option<fn(Values<f64>) -> [f64; 2]>,
}

impl fmt::Debug for LawConstructor {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Maker").finish_non_exhaustive()
    }
}

const fn local(
    double: fn(Values<f64>) -> LawResult<f64>,
    single: fn(Values<f32>) -> LawResult<f32>,
) -> Option<LawConstructor> {
    Some(LawConstructor {
        double,
        single,
        power: None,
    })
}

const fn power_of_speed(
    double: fn(Values<f64>) -> LawResult<f64>,
    single: fn(Values<f32>) -> LawResult<f32>,
    power: fn(Values<f64>) -> [f64; 2],
) -> Option<LawConstructor> {
    Some(LawConstructor {
        double,
        single,
        power: Some(power),
    })
}

fn coulomb<R: Real + 'static>([mu, ..]: Values<R>) -> LawResult<R> {
    Ok(Box::new(CoulombLaw::new(mu)?))
}

fn dry<R: Real + 'static>([mu_s, mu_d, ..]: Values<R>) -> LawResult<R> {
    Ok(Box::new(DryFriction::new(mu_s, mu_d)?))
}

fn power<R: Real + 'static>([gamma, alpha, ..]: Values<R>) -> LawResult<R> {
    Ok(Box::new(PowerLaw::new(alpha, gamma)?))
}

fn plateau<R: Real + 'static>([gamma, alpha, vp, vd, r, _]: Values<R>) -> LawResult<R> {
    Ok(Box::new(PlateauPowerLaw::new(PlateauPowerLawParameters {
        alpha,
        coefficient: gamma,
        plateau_speed: vp,
        drop_speed: vd,
        rest_share: r,
    })?))
}

fn stribeck<R: Real + 'static>([mu_s, mu_d, vs, delta, k, _]: Values<R>) -> LawResult<R> {
    Ok(Box::new(Stribeck::new(StribeckParameters {
        dry: DryFriction::new(mu_s, mu_d)?,
        speed: vs,
        exponent: delta,
        viscous: k,
    })?))
}

fn savkoor<R: Real + 'static>([mu0, mu_m, vm, h, ..]: Values<R>) -> LawResult<R> {
    Ok(Box::new(Savkoor::new(SavkoorParameters {
        mu_base: mu0,
        mu_max: mu_m,
        speed: vm,
        narrowness: h,
    })?))
}

fn rising<R: Real + 'static>([mu_s, mu_f, vr, ..]: Values<R>) -> LawResult<R> {
    Ok(Box::new(RisingLaw::new(RisingLawParameters {
        mu_rest: mu_s,
        mu_fast: mu_f,
        speed: vr,
    })?))
}

fn tanh<R: Real + 'static>([mu, vt, ..]: Values<R>) -> LawResult<R> {
    Ok(Box::new(TanhLaw::new(mu, vt)?))
}

fn rate_state<R: Real + 'static>(
    [mu, a, b, reference_speed, slip_distance, viscous]: Values<R>,
) -> LawResult<R> {
    let parameters = RateStateParameters {
        mu,
        a,
        b,
        reference_speed,
        slip_distance,
        viscous,
    };
    Ok(Box::new(RateState::<R>::new(parameters)?.steady()))
}

fn lugre<R: Real + 'static>(
    [
        coulomb_force,
        static_force,
        stribeck_speed,
        viscous_damping,
        load,
        _,
    ]: Values<R>,
) -> LawResult<R> {
    let parameters = LuGreParameters {
        coulomb_force,
        static_force,
        stribeck_speed,
        viscous_damping,
        // Steady sliding does not depend on the bristles.
        stiffness: R::ONE,
        bristle_damping: R::ONE,
    };
    Ok(Box::new(LuGre::new(parameters)?.steady_per_load(load)?))
}

pub(super) const fn needed(
    name: &'static str,
    unit: &'static str,
    meaning: &'static str,
) -> LawParameter {
    LawParameter {
        name,
        unit,
        meaning,
        default: None,
    }
}

pub(super) const fn optional(
    name: &'static str,
    unit: &'static str,
    meaning: &'static str,
    default: f64,
) -> LawParameter {
    LawParameter {
        name,
        unit,
        meaning,
        default: Some(default),
    }
}

/// The parameters that rate-and-state friction and its steady state share.
const RATE_STATE: &[LawParameter] = &[
    needed("mu0", "-", "coefficient of steady sliding with v0"),
    needed("a", "-", "direct effect of the speed"),
    needed("b", "-", "effect of the age; b > a weakens"),
    needed("v0", "m/s", "reference speed"),
    needed("dc", "m", "memory length"),
    optional("eta", "s/m", "viscous term of the inertial branch", 0.0),
];

/// All laws, local ones first.
pub const LAWS: &[LawEntry] = &[
    LawEntry {
        name: "coulomb",
        summary: "dry friction, independent of speed",
        formula: "mu",
        parameters: &[needed("mu", "-", "friction coefficient")],
        source: "Coulomb 1785; thesis section 2.1, fig. 2.5",
        local: power_of_speed(coulomb, coulomb, |[mu, ..]| [mu, 0.0]),
    },
    LawEntry {
        name: "dry",
        summary: "dry friction with a static and a dynamic coefficient",
        formula: "mu_d sliding, at most mu_s at rest",
        parameters: &[
            needed("mu_s", "-", "static coefficient"),
            needed("mu_d", "-", "dynamic coefficient, <= mu_s"),
        ],
        source: "Euler 1750; thesis section 2.1, fig. 2.5",
        local: local(dry, dry),
    },
    LawEntry {
        name: "power",
        summary: "a power of the speed",
        formula: "gamma v^alpha",
        parameters: &[
            needed("gamma", "(s/m)^alpha", "coefficient"),
            needed("alpha", "-", "exponent, > -1 and <= 128"),
        ],
        source: "thesis eq. 3.6",
        local: power_of_speed(power, power, |[gamma, alpha, ..]| [gamma, alpha]),
    },
    LawEntry {
        name: "plateau",
        summary: "falling power law made finite at rest, as on ice",
        formula: "gamma (v^2 + vp^2)^(alpha/2) (r + (1-r) v/(v + vd))",
        parameters: &[
            needed("gamma", "(s/m)^alpha", "coefficient of fast sliding"),
            needed("alpha", "-", "exponent, -1 < alpha <= 0"),
            optional("vp", "m/s", "speed below which friction is constant", 1e-4),
            optional("vd", "m/s", "speed below which it drops, <= vp", 1e-7),
            optional(
                "r",
                "-",
                "share of the plateau left at rest, from 0 to 1",
                0.5,
            ),
        ],
        source: "thesis eq. 3.39 and fig. 3.19; closed form by this project",
        local: local(plateau, plateau),
    },
    LawEntry {
        name: "stribeck",
        summary: "boundary lubrication, then hydrodynamic",
        formula: "mu_d + (mu_s - mu_d) exp(-(v/vs)^delta) + k v",
        parameters: &[
            needed("mu_s", "-", "coefficient at rest"),
            needed("mu_d", "-", "coefficient of the boundary branch, <= mu_s"),
            needed("vs", "m/s", "Stribeck speed, > 0"),
            optional("delta", "-", "exponent, > 0", 2.0),
            optional("k", "s/m", "viscous coefficient", 0.0),
        ],
        source: "Stribeck 1902, form of Bo and Pavelescu 1982; thesis fig. 2.8",
        local: local(stribeck, stribeck),
    },
    LawEntry {
        name: "savkoor",
        summary: "rubber: a maximum over decades of speed",
        formula: "mu0 + (mu_m - mu0) exp(-h^2 ln(v/vm)^2)",
        parameters: &[
            needed("mu0", "-", "coefficient far from the maximum, <= mu_m"),
            needed("mu_m", "-", "largest coefficient"),
            needed("vm", "m/s", "speed of the maximum"),
            optional("h", "-", "narrowness of the maximum, > 0", 0.4),
        ],
        source: "Savkoor 1966",
        local: local(savkoor, savkoor),
    },
    LawEntry {
        name: "rising",
        summary: "rises from rest and levels off, as of PTFE",
        formula: "mu_f - (mu_f - mu_s) exp(-v/vr)",
        parameters: &[
            needed("mu_s", "-", "coefficient at rest, <= mu_f"),
            needed("mu_f", "-", "coefficient of fast sliding"),
            needed("vr", "m/s", "speed over which it rises, > 0"),
        ],
        source: "Constantinou, Mokha, Reinhorn 1990",
        local: local(rising, rising),
    },
    LawEntry {
        name: "tanh",
        summary: "Coulomb friction made smooth at rest, as in games and multibody codes",
        formula: "mu tanh(v/vt)",
        parameters: &[
            needed("mu", "-", "coefficient of fast sliding"),
            needed("vt", "m/s", "speed below which it is viscous, > 0"),
        ],
        source: "Dupont 1990; Andersson, Soderberg, Bjorklund 2007",
        local: local(tanh, tanh),
    },
    LawEntry {
        name: "rate-state",
        summary: "steady rate-and-state friction: creep weakens, inertia strengthens",
        formula: "a asinh(v/q) + eta v,  q = 2 v0 exp(-(mu0 + b ln(v0/v))/a)",
        parameters: RATE_STATE,
        source: "Dieterich 1979, Ruina 1983; branches of Heslot et al. 1994, thesis fig. 2.7",
        local: local(rate_state, rate_state),
    },
    LawEntry {
        name: "lugre",
        summary: "steady LuGre friction per load (the kernel has its bristles too)",
        formula: "(fc + (fs - fc) exp(-(v/vs)^2) + s2 v)/load",
        parameters: &[
            needed("fc", "N", "Coulomb force"),
            needed("fs", "N", "static force, >= fc"),
            needed("vs", "m/s", "Stribeck speed"),
            optional("s2", "N s/m", "viscous damping", 0.0),
            optional("load", "N", "load at which the forces were measured", 1.0),
        ],
        source: "Canudas de Wit, Olsson, Astrom, Lischinsky 1995",
        local: local(lugre, lugre),
    },
    LawEntry {
        name: "incline",
        summary: "a body at rest on a slope holds up to Euler's critical angle",
        formula: "theta_c = atan(mu_s);  beyond, it starts with g (sin theta - mu_d cos theta)",
        parameters: &[
            needed("mu_s", "-", "static coefficient"),
            needed("mu_d", "-", "dynamic coefficient, <= mu_s"),
        ],
        source: "Euler 1750; thesis section 2.1, fig. 2.2",
        local: None,
    },
    LawEntry {
        name: "ageing",
        summary: "static friction grows with the time of rest",
        formula: "mu_s(t) = A + B ln(t/t0), A for t < t0",
        parameters: &[
            needed("A", "-", "coefficient at the age t0"),
            needed("B", "-", "growth per e-fold of the age"),
            needed("t0", "s", "reference and cut-off age"),
        ],
        source: "thesis section 2.1, fig. 2.5",
        local: None,
    },
    LawEntry {
        name: "rate-state-ageing",
        summary: "rate and state, age by Dieterich: theta' = 1 - v theta/dc",
        formula: "mu0 + a ln(v/v0) + b ln(v0 theta/dc) + eta v (regularised)",
        parameters: RATE_STATE,
        source: "Dieterich 1979; regularised after Rice, Lapusta, Ranjith 2001",
        local: None,
    },
    LawEntry {
        name: "rate-state-slip",
        summary: "rate and state, age by Ruina: theta' = -(v theta/dc) ln(v theta/dc)",
        formula: "mu0 + a ln(v/v0) + b ln(v0 theta/dc) + eta v (regularised)",
        parameters: RATE_STATE,
        source: "Ruina 1983; regularised after Rice, Lapusta, Ranjith 2001",
        local: None,
    },
    LawEntry {
        name: "lugre-bristles",
        summary: "LuGre with bristle state z",
        formula: "F = s0 z + s1 z' + s2 v,  z' = v - s0 |v| z/(fc + (fs - fc) exp(-(v/vs)^2))",
        parameters: &[
            needed("fc", "N", "Coulomb force"),
            needed("fs", "N", "static force, >= fc"),
            needed("vs", "m/s", "Stribeck speed"),
            needed("s0", "N/m", "stiffness of the bristles"),
            needed("s1", "N s/m", "damping of the bristles"),
            optional("s2", "N s/m", "viscous damping", 0.0),
        ],
        source: "Canudas de Wit, Olsson, Astrom, Lischinsky 1995",
        local: None,
    },
    LawEntry {
        name: "bowden-tabor",
        summary: "shear of the real area of contact",
        formula: "F = tau_c A(L);  plastic A = L/sigma_c, mu = tau_c/sigma_c",
        parameters: &[
            needed("tau_c", "Pa", "shear strength of junctions"),
            needed("sigma_c", "Pa", "penetration hardness"),
        ],
        source: "Bowden and Tabor 1950; thesis eqs. 2.1, 2.2",
        local: None,
    },
    LawEntry {
        name: "bowden-tabor-hertz",
        summary: "shear of one elastic sphere's contact: F ~ L^(2/3)",
        formula: "F = tau_c pi (3 L R/(4 E))^(2/3)",
        parameters: &[
            needed("tau_c", "Pa", "shear strength"),
            needed("R", "m", "radius of the sphere"),
            needed("E", "Pa", "contact modulus"),
        ],
        source: "Hertz 1882; thesis section 2.2",
        local: None,
    },
    LawEntry {
        name: "bowden-tabor-greenwood",
        summary: "shear of many elastic asperities: F ~ L",
        formula: "F = tau_c L sqrt(pi R/s)/E",
        parameters: &[
            needed("tau_c", "Pa", "shear strength"),
            needed("s", "m", "decay length of asperity heights"),
            needed("R", "m", "radius of the tips"),
            needed("E", "Pa", "contact modulus"),
        ],
        source: "Greenwood and Williamson 1966; thesis section 2.2",
        local: None,
    },
    LawEntry {
        name: "stokes",
        summary: "viscous drag of a sphere, low Reynolds number",
        formula: "F = 6 pi eta r v",
        parameters: &[
            needed("eta", "Pa s", "viscosity"),
            needed("r", "m", "radius"),
        ],
        source: "Stokes 1851; thesis eq. 2.4",
        local: None,
    },
    LawEntry {
        name: "inertial-drag",
        summary: "drag of a sphere, high Reynolds number rho v r/eta",
        formula: "F = C2 rho v^2 r^2",
        parameters: &[
            needed("C2", "-", "constant, about 0.7 for a sphere"),
            needed("rho", "kg/m^3", "density of the fluid"),
            needed("r", "m", "radius"),
        ],
        source: "thesis section 2.3.2",
        local: None,
    },
];

/// The law of this name.
pub fn find(name: &str) -> Option<&'static LawEntry> {
    LAWS.iter().find(|law| law.name == name)
}
