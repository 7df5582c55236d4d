//! Laws of a surface element.

use super::check::{all_nan, finite, holds, numbers};
use super::{Broken, Source};
use tribos_core::law::{
    AgeingLaw, Bristle, CoulombLaw, DryFriction, LocalLaw, LuGre, LuGreParameters, PlateauPowerLaw,
    PlateauPowerLawParameters, PowerLaw, RateState, RateStateParameters, RestTime, Savkoor,
    SavkoorParameters, SlipLaw, StateEvolution, StateVariable, StaticAgeing, StickSlip, Stribeck,
    StribeckParameters,
};
use tribos_core::real::Real;

/// Laws without memory, in either precision.
pub fn memoryless(source: &mut Source) -> Result<(), Broken> {
    if source.one_in(2) {
        memoryless_of::<f64>(source)
    } else {
        memoryless_of::<f32>(source)
    }
}

fn memoryless_of<R: Real>(source: &mut Source) -> Result<(), Broken> {
    let laws = [
        dry::<R>,
        coulomb::<R>,
        power::<R>,
        stribeck::<R>,
        plateau::<R>,
        savkoor::<R>,
    ];
    source.one_of(&laws)(source)
}

/// −1 < α ≤ 4, or anything.
fn exponent<R: Real>(source: &mut Source) -> R {
    if source.is_mild() || source.one_in(2) {
        source.unit::<R>() * R::from_f64(5.0) - R::from_f64(0.99)
    } else {
        source.number()
    }
}

/// Friction is not NaN and not negative, and finite for mild speeds.
fn local<R: Real>(source: &mut Source, name: &str, law: &impl LocalLaw<R>) -> Result<(), Broken> {
    let v = source.positive::<R>();
    let (friction, slope) = (law.friction(v), law.slope(v));
    if v.is_nan() {
        return all_nan(name, [friction, slope]);
    }
    finite(source, name, [friction, slope])?;
    if v > R::ZERO && v.is_finite() {
        holds(
            friction >= R::ZERO,
            &format!("{name}: friction ≥ 0"),
            &[v, friction],
        )?;
    }
    Ok(())
}

fn coulomb<R: Real>(source: &mut Source) -> Result<(), Broken> {
    let law = CoulombLaw::<R>::new(source.size());
    let Ok(law) = law else { return Ok(()) };
    finite(source, "angle of friction", [law.friction_angle()])?;
    local(source, "Coulomb", &law)
}

fn power<R: Real>(source: &mut Source) -> Result<(), Broken> {
    let alpha = exponent::<R>(source);
    let law = PowerLaw::new(alpha, source.size());
    law.map_or(Ok(()), |law| local(source, "power law", &law))
}

fn dry<R: Real>(source: &mut Source) -> Result<(), Broken> {
    let [a, b] = [source.size::<R>(), source.size()];
    let (most, least) = if a > b { (a, b) } else { (b, a) };
    let Ok(law) = DryFriction::new(most, least) else {
        return Ok(());
    };
    local(source, "dry friction", &law)?;
    let drive = source.number::<R>();
    let net = law.net_drive(drive);
    finite(source, "net drive", [net])?;
    if drive.is_nan() {
        all_nan("net drive", [net])?;
        return holds(law.at_rest(drive) == StickSlip::Slip, "NaN slips", &[drive]);
    }
    Ok(())
}

fn stribeck<R: Real>(source: &mut Source) -> Result<(), Broken> {
    let dynamic = source.size::<R>();
    let Ok(dry) = DryFriction::new(dynamic + source.size(), dynamic) else {
        return Ok(());
    };
    let power = if source.is_mild() {
        source.unit::<R>() + R::ONE
    } else {
        source.size()
    };
    let Ok(law) = Stribeck::new(StribeckParameters {
        dry,
        speed: source.positive(),
        exponent: power,
        viscous: source.size(),
    }) else {
        return Ok(());
    };
    let v = source.positive::<R>();
    finite(
        source,
        "Stribeck's parts",
        [law.boundary(v), law.hydrodynamic(v)],
    )?;
    finite(source, "Stribeck's minimum", law.minimum())?;
    local(source, "Stribeck", &law)
}

fn plateau<R: Real>(source: &mut Source) -> Result<(), Broken> {
    let alpha = -source.unit::<R>();
    let (drop, more) = (source.positive::<R>(), source.size::<R>());
    let share = source.unit();
    let law = PlateauPowerLaw::new(PlateauPowerLawParameters {
        alpha,
        coefficient: source.size(),
        plateau_speed: drop + more,
        drop_speed: drop,
        rest_share: share,
    });
    law.map_or(Ok(()), |law| local(source, "plateau", &law))
}

fn savkoor<R: Real>(source: &mut Source) -> Result<(), Broken> {
    let mu_base = source.size::<R>();
    let law = Savkoor::new(SavkoorParameters {
        mu_base,
        mu_max: mu_base + source.size(),
        speed: source.positive(),
        narrowness: source.positive(),
    });
    law.map_or(Ok(()), |law| local(source, "Savkoor", &law))
}

/// Ageing, rate and state, bristles, in either precision.
pub fn with_memory(source: &mut Source) -> Result<(), Broken> {
    let laws = [
        ageing::<f64>,
        ageing::<f32>,
        rocks::<f64, AgeingLaw>,
        rocks::<f64, SlipLaw>,
        bristles::<f64>,
        bristles::<f32>,
    ];
    source.one_of(&laws)(source)
}

fn ageing<R: Real>(source: &mut Source) -> Result<(), Broken> {
    let Ok(law) = StaticAgeing::<R>::new(source.size(), source.size(), source.positive()) else {
        return Ok(());
    };
    let age = RestTime {
        time: source.size(),
    };
    finite(source, "ageing", [law.mu_static(age), law.rate(age)])?;
    let drive = source.number();
    let later = age.advance(source.size(), law.at_rest(age, drive));
    finite(source, "age", [later.time])
}

fn rocks<R: Real, E: StateEvolution>(source: &mut Source) -> Result<(), Broken> {
    let [mu, b, viscous] = [(); 3].map(|()| source.size::<R>());
    let [a, reference_speed, slip_distance] = [(); 3].map(|()| source.positive());
    let law = RateState::<R, E>::new(RateStateParameters {
        mu,
        a,
        b,
        reference_speed,
        slip_distance,
        viscous,
    });
    let Ok(law) = law else {
        return Ok(());
    };
    let (theta, v, dt) = (source.positive::<R>(), source.size(), source.size());
    let age = law.advance(StateVariable { theta }, v, dt);
    let coefficient = law.coefficient(v, age);
    let finite_in = [theta, v, dt]
        .iter()
        .all(|x| x.is_finite() && *x >= R::ZERO);
    if finite_in {
        numbers("age of contacts", [age.theta])?;
        holds(age.theta >= R::ZERO, "age ≥ 0", &[theta, v, dt, age.theta])?;
    }
    // Near the ends of the range b/a may carry the state beyond it.
    let steep = (b / a) > R::from_f64(8.0) || (mu / a) > R::from_f64(8.0);
    if !steep {
        finite(
            source,
            "rate and state",
            [coefficient, law.steady_age(v + R::ONE).theta],
        )?;
        holds(
            coefficient >= R::ZERO || !source.is_mild(),
            "friction ≥ 0",
            &[v, coefficient],
        )?;
    }
    let steady = law.steady();
    let _ = (law.slope(v, age), law.logarithmic(v, age), steady.minimum());
    let _ = (
        steady.critical_stiffness(theta),
        steady.critical_stiffness_at(theta, v),
    );
    let _ = (steady.friction(v), steady.slope(v));
    Ok(())
}

fn bristles<R: Real>(source: &mut Source) -> Result<(), Broken> {
    let coulomb_force = source.positive::<R>();
    let law = LuGre::new(LuGreParameters {
        coulomb_force,
        static_force: coulomb_force + source.size(),
        stribeck_speed: source.positive(),
        stiffness: source.positive(),
        bristle_damping: source.size(),
        viscous_damping: source.size(),
    });
    let Ok(law) = law else {
        return Ok(());
    };
    let most = law.largest_deflection();
    let deflection = if source.is_mild() {
        (source.unit::<R>() - R::HALF) * most
    } else {
        source.number()
    };
    let (v, dt) = (source.number::<R>(), source.size());
    let (next, force) = law.step(Bristle { deflection }, v, dt);
    if deflection.is_nan() || v.is_nan() {
        all_nan("bristle", [next.deflection, force])?;
    }
    finite(source, "bristle", [next.deflection, force])?;
    let steady = law.steady_force(v);
    finite(
        source,
        "steady force",
        [steady, law.steady_bristle_force(v), law.rate(next, v)],
    )?;
    holds(
        steady * v >= R::ZERO || !source.is_mild(),
        "steady force resists",
        &[v, steady],
    )?;
    if source.is_mild() {
        let bound = most * (R::ONE + R::from_f64(64.0) * R::EPSILON);
        holds(
            next.deflection.abs() <= bound,
            "bristle within its bound",
            &[next.deflection, most],
        )?;
    }
    let _ = (law.passive_up_to(), law.force(next, v));
    match law.steady_per_load(source.positive()) {
        Ok(law) => local(source, "steady bristles", &law),
        Err(_) => Ok(()),
    }
}
