//! All friction laws.

use tribos_core::Real;
use tribos_core::coupling::Coupling;
use tribos_core::coupling::quadrature::DiskQuadrature;
use tribos_core::law::{
    Age, Ageing, BowdenTabor, Bristle, Dieterich, DragRegime, DryFriction, GreenwoodWilliamson,
    HertzSphere, Incline, InertialDrag, LocalLaw, LuGre, LuGreParameters, Plastic, PlateauPower,
    RateState, RateStateParameters, Ruina, Stokes, Stribeck, critical_angle, reynolds,
};

/// Every law once.
pub fn all<R: Real>(a: R, b: R) -> Option<R> {
    let dry = DryFriction::new(a, b).ok()?;
    let mut s = disk(dry, a, b) + dry.net_drive(b);
    let st = Stribeck::new(dry, a, b, a).ok()?;
    s += disk(st, a, b) + st.minimum()?;
    s += disk(PlateauPower::new(a, b, a, b, a).ok()?, a, b);
    let ag = Ageing::new(a, b, a).ok()?;
    s += ag.mu_static(Age::ZERO.advance(a, ag.at_rest(Age { time: a }, b)))
        + ag.rate(Age { time: b });
    let i = Incline::new(a, b).ok()?;
    s += i.angle()
        + i.acceleration_at_rest(&dry, a)
        + i.acceleration_downhill(&st, a, b)
        + critical_angle(a);
    s += BowdenTabor::new(a, HertzSphere::new(a, b).ok()?)
        .ok()?
        .effective_coefficient(b);
    s += BowdenTabor::new(a, GreenwoodWilliamson::new(a, b, a).ok()?)
        .ok()?
        .force(b);
    let p = BowdenTabor::new(a, Plastic::new(b).ok()?).ok()?;
    s += p.slope(b) + p.coulomb().ok()?.mu();
    s += Stokes::new(a, b).ok()?.force(a)
        + InertialDrag::new(a, b, a).ok()?.slope(b)
        + reynolds(a, b, a, b);
    if DragRegime::at(a, b)? == DragRegime::Viscous {
        s += a;
    }
    let q = RateStateParameters {
        mu: a,
        a: b,
        b: a,
        reference_speed: b,
        slip_distance: a,
        viscous: b,
    };
    let r = RateState::<R, Ruina>::new(q).ok()?;
    let d = RateState::<R, Dieterich>::new(q).ok()?;
    let t = r.advance(d.advance(r.steady_age(a), a, b), b, a);
    s += r.coefficient(a, t)
        + r.slope(b, t)
        + d.logarithmic(a, t)
        + disk(r.steady(), a, b)
        + r.steady().minimum()?
        + r.steady().critical_stiffness_at(a, b);
    let l = LuGre::new(LuGreParameters {
        coulomb_force: a,
        static_force: b,
        stribeck_speed: a,
        stiffness: b,
        bristle_damping: a,
        viscous_damping: b,
    })
    .ok()?;
    let (z, f) = l.step(Bristle { deflection: a }, b, a);
    s += z.deflection
        + f
        + l.force(z, a)
        + l.passive_up_to()
        + disk(l.steady_per_load(a).ok()?, a, b);
    Some(s)
}

/// Force and torque of a law on the uniform disk.
fn disk<R: Real>(law: impl LocalLaw<R>, v: R, w: R) -> R {
    let wrench = DiskQuadrature::new(law).reduced_wrench(v, w);
    wrench.force + wrench.torque
}
