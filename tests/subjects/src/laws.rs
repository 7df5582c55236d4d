//! Laws of a surface element.

use crate::{Input, Verdict};
use tribos_core::law::{
    AgeingLaw, Bristle, CoulombLaw, DryFriction, LocalLaw, LuGre, LuGreParameters, PlateauPowerLaw,
    PlateauPowerLawParameters, PowerLaw, RateState, RateStateParameters, RestTime, RisingLaw,
    RisingLawParameters, Savkoor, SavkoorParameters, SlipLaw, StateEvolution, StateVariable,
    StaticAgeing, StickSlip, Stribeck, StribeckParameters, TanhLaw,
};
use tribos_core::real::Real;

/// A law of the local speed alone, and what walks over such laws need of it.
#[derive(Clone, Copy, Debug)]
pub struct MemorylessLaw {
    /// Its name among prices.
    pub name: &'static str,
    /// As scenes write it, with usual values.
    pub usual: &'static str,
    /// Modules of the kernel that a program with no other law contains.
    pub modules: &'static str,
    /// How such a program makes it from a number `b`; `?` refuses.
    pub made: &'static str,
    /// How it calls the `object` with a number `a`.
    pub call: &'static str,
}

/// Declares them: the function that draws one from an input, then the fields; most are called alike.
macro_rules! memoryless {
    ($($draw:ident: $name:literal, $usual:literal, $modules:literal, $made:literal $(, $call:literal)?;)+) => {
        /// All of them.
        pub const MEMORYLESS: [MemorylessLaw; [$($name),+].len()] = [$(MemorylessLaw {
            name: $name,
            usual: $usual,
            modules: $modules,
            made: concat!($made, ".ok()?"),
            call: [$($call,)? "object.friction(a)"][0],
        }),+];

        /// One law without memory.
        pub fn memoryless<R: Real>(input: &mut Input<'_>) -> Verdict {
            input.one_of(&[$($draw::<R>),+])(input)
        }
    };
}

memoryless! {
    dry: "dry friction", "dry:mu_s=0.4,mu_d=0.3", "law::dry law::grip",
        "DryFriction::new(0.5 as R, 0.25)", "object.net_drive(a)";
    coulomb: "Coulomb", "coulomb:mu=0.3", "law::coulomb", "CoulombLaw::new(b)";
    power: "power", "power:gamma=0.3,alpha=0.5", "law::power", "PowerLaw::new(0.5, b)";
    stribeck: "Stribeck", "stribeck:mu_s=0.4,mu_d=0.2,vs=0.05,k=0.02", "law::stribeck law::dry",
        "Stribeck::new(StribeckParameters { dry: DryFriction::new(0.5, 0.25).ok()?, speed: b, exponent: 2.0, viscous: 0.125 })";
    plateau: "plateau", "plateau:gamma=0.1,alpha=-0.4,vp=1e-3,vd=1e-4", "law::plateau",
        "PlateauPowerLaw::new(PlateauPowerLawParameters { alpha: -0.5, coefficient: b, plateau_speed: 1e-2, drop_speed: 1e-4, rest_share: 0.5 })";
    savkoor: "Savkoor", "savkoor:mu0=0.6,mu_m=1.2,vm=0.5", "law::savkoor",
        "Savkoor::new(SavkoorParameters { mu_base: 0.625, mu_max: 1.25, speed: b, narrowness: 0.5 })";
    rising: "rising", "rising:mu_s=0.04,mu_f=0.12,vr=0.04", "law::rising",
        "RisingLaw::new(RisingLawParameters { mu_rest: 0.0625, mu_fast: 0.125, speed: b })";
    tanh: "tanh", "tanh:mu=0.8,vt=0.01", "law::tanh", "TanhLaw::new(0.75, b)";
}

/// −1 < α ≤ 4, or anything.
pub fn exponent<R: Real>(input: &mut Input<'_>) -> R {
    if input.is_mild() || input.one_in(2) {
        input.unit::<R>() * R::from_f64(5.0) - R::from_f64(0.99)
    } else {
        input.number()
    }
}

/// Friction is NaN for NaN, not negative, and finite for mild speeds.
fn local<R: Real>(input: &mut Input<'_>, name: &'static str, law: &impl LocalLaw<R>) -> Verdict {
    let v = input.positive::<R>();
    let (friction, slope) = (law.friction(v), law.slope(v));
    if v.is_nan() {
        return input.all_nan(name, [friction, slope]);
    }
    input.finite(name, [friction, slope])?;
    let is_fine = friction >= R::ZERO || !(v > R::ZERO && v.is_finite());
    input.holds(is_fine, name, &[v, friction])
}

fn coulomb<R: Real>(input: &mut Input<'_>) -> Verdict {
    let law = CoulombLaw::<R>::new(input.size());
    let law = input.taken(law)?;
    input.finite("angle of friction", [law.friction_angle(), law.mu()])?;
    local(input, "Coulomb", &law)
}

fn power<R: Real>(input: &mut Input<'_>) -> Verdict {
    let law = PowerLaw::new(exponent::<R>(input), input.size());
    let law = input.taken(law)?;
    let own = [law.alpha(), law.coefficient()];
    let is_told = law.is_convex() == (own[0] >= R::ZERO);
    input.holds(is_told, "convex for α ≥ 0", &own)?;
    local(input, "power law", &law)
}

fn dry<R: Real>(input: &mut Input<'_>) -> Verdict {
    let [a, b] = [input.size::<R>(), input.size()];
    let (most, least) = if a > b { (a, b) } else { (b, a) };
    let law = input.taken(DryFriction::new(most, least))?;
    let is_kept = [law.mu_static(), law.mu_dynamic()] == [most, least];
    input.holds(is_kept, "coefficients are kept", &[most, least])?;
    local(input, "dry friction", &law)?;
    let drive = input.number::<R>();
    let (net, grip) = (law.net_drive(drive), law.at_rest(drive));
    input.finite("net drive", [net])?;
    input.give_bits(u64::from(grip == StickSlip::Slip));
    if drive.is_nan() {
        input.all_nan("net drive", [net])?;
        return input.holds(grip == StickSlip::Slip, "NaN slips", &[drive]);
    }
    Ok(())
}

fn stribeck<R: Real>(input: &mut Input<'_>) -> Verdict {
    let dynamic = input.size::<R>();
    let dry = DryFriction::new(dynamic + input.size(), dynamic);
    let dry = input.taken(dry)?;
    let power = if input.is_mild() {
        input.unit::<R>() + R::ONE
    } else {
        input.size()
    };
    let law = Stribeck::new(StribeckParameters {
        dry,
        speed: input.positive(),
        exponent: power,
        viscous: input.size(),
    });
    let law = input.taken(law)?;
    let v = input.positive::<R>();
    let parts = [law.boundary(v), law.hydrodynamic(v)];
    input.finite("Stribeck's parts", parts)?;
    input.finite("Stribeck's minimum", law.minimum())?;
    local(input, "Stribeck", &law)
}

fn plateau<R: Real>(input: &mut Input<'_>) -> Verdict {
    let alpha = -input.unit::<R>();
    let (drop, more) = (input.positive::<R>(), input.size::<R>());
    let share = input.unit();
    let law = PlateauPowerLaw::new(PlateauPowerLawParameters {
        alpha,
        coefficient: input.size(),
        plateau_speed: drop + more,
        drop_speed: drop,
        rest_share: share,
    });
    let law = input.taken(law)?;
    local(input, "plateau", &law)
}

fn savkoor<R: Real>(input: &mut Input<'_>) -> Verdict {
    let mu_base = input.size::<R>();
    let law = Savkoor::new(SavkoorParameters {
        mu_base,
        mu_max: mu_base + input.size(),
        speed: input.positive(),
        narrowness: input.positive(),
    });
    let law = input.taken(law)?;
    local(input, "Savkoor", &law)
}

fn rising<R: Real>(input: &mut Input<'_>) -> Verdict {
    let mu_rest = input.size::<R>();
    let law = RisingLaw::new(RisingLawParameters {
        mu_rest,
        mu_fast: mu_rest + input.size(),
        speed: input.positive(),
    });
    let law = input.taken(law)?;
    local(input, "rising", &law)
}

fn tanh<R: Real>(input: &mut Input<'_>) -> Verdict {
    let law = TanhLaw::new(input.size::<R>(), input.positive());
    let law = input.taken(law)?;
    local(input, "tanh", &law)
}

/// Ageing, rate and state, bristles.
pub fn with_memory<R: Real>(input: &mut Input<'_>) -> Verdict {
    let laws = [
        ageing::<R>,
        rocks::<R, AgeingLaw>,
        rocks::<R, SlipLaw>,
        bristles::<R>,
    ];
    input.one_of(&laws)(input)
}

fn ageing<R: Real>(input: &mut Input<'_>) -> Verdict {
    let law = StaticAgeing::<R>::new(input.size(), input.size(), input.positive());
    let law = input.taken(law)?;
    let age = RestTime { time: input.size() };
    input.finite("ageing", [law.mu_static(age), law.rate(age)])?;
    let grip = law.at_rest(age, input.number());
    input.give_bits(u64::from(grip == StickSlip::Slip));
    let later = age.advance(input.size(), grip);
    input.finite("age", [later.time])
}

fn rocks<R: Real, E: StateEvolution>(input: &mut Input<'_>) -> Verdict {
    let [mu, b, viscous] = [(); 3].map(|()| input.size::<R>());
    let [a, reference_speed, slip_distance] = [(); 3].map(|()| input.positive());
    let rock = RateStateParameters {
        mu,
        a,
        b,
        reference_speed,
        slip_distance,
        viscous,
    };
    let law = input.taken(RateState::<R, E>::new(rock))?;
    let is_kept = *law.parameters() == rock && *law.steady().parameters() == rock;
    input.holds(is_kept, "parameters are kept", &[mu, a, b])?;
    let (theta, v, dt) = (input.positive::<R>(), input.size(), input.size());
    let age = law.advance(StateVariable { theta }, v, dt);
    let coefficient = law.coefficient(v, age);
    let finite_in = [theta, v, dt]
        .iter()
        .all(|x| x.is_finite() && *x >= R::ZERO);
    if finite_in {
        input.numbers("age of contacts", [age.theta])?;
        input.holds(age.theta >= R::ZERO, "age ≥ 0", &[theta, v, dt, age.theta])?;
    }
    // Near the ends of the range b/a may carry the state beyond it.
    let steep = (b / a) > R::from_f64(8.0) || (mu / a) > R::from_f64(8.0);
    if !steep {
        input.finite(
            "rate and state",
            [coefficient, law.steady_age(v + R::ONE).theta],
        )?;
        input.holds(
            coefficient >= R::ZERO || !input.is_mild(),
            "friction ≥ 0",
            &[v, coefficient],
        )?;
    }
    let steady = law.steady();
    input.give([law.slope(v, age), law.logarithmic(v, age)]);
    input.give([E::evolved(theta, v, dt, slip_distance)]);
    input.give(steady.minimum());
    input.give([
        steady.critical_stiffness(theta),
        steady.critical_stiffness_at(theta, v),
        steady.friction(v),
        steady.slope(v),
    ]);
    Ok(())
}

fn bristles<R: Real>(input: &mut Input<'_>) -> Verdict {
    let coulomb_force = input.positive::<R>();
    let joint = LuGreParameters {
        coulomb_force,
        static_force: coulomb_force + input.size(),
        stribeck_speed: input.positive(),
        stiffness: input.positive(),
        bristle_damping: input.size(),
        viscous_damping: input.size(),
    };
    let law = input.taken(LuGre::new(joint))?;
    let is_kept = *law.parameters() == joint;
    input.holds(is_kept, "parameters are kept", &[coulomb_force])?;
    let most = law.largest_deflection();
    let deflection = if input.is_mild() {
        (input.unit::<R>() - R::HALF) * most
    } else {
        input.number()
    };
    let (v, dt) = (input.number::<R>(), input.size());
    let (next, force) = law.step(Bristle { deflection }, v, dt);
    if deflection.is_nan() || v.is_nan() {
        input.all_nan("bristle", [next.deflection, force])?;
    }
    input.finite("bristle", [next.deflection, force])?;
    let steady = law.steady_force(v);
    input.finite(
        "steady force",
        [steady, law.steady_bristle_force(v), law.rate(next, v)],
    )?;
    input.holds(
        steady * v >= R::ZERO || !input.is_mild(),
        "steady force resists",
        &[v, steady],
    )?;
    if input.is_mild() {
        let bound = most * (R::ONE + R::from_f64(64.0) * R::EPSILON);
        input.holds(
            next.deflection.abs() <= bound,
            "bristle within its bound",
            &[next.deflection, most],
        )?;
    }
    input.give([law.passive_up_to(), law.force(next, v)]);
    let per_load = law.steady_per_load(input.positive());
    let per_load = input.taken(per_load)?;
    local(input, "steady bristles", &per_load)
}
