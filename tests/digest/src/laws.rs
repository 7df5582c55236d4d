//! Bits of the laws of a surface element, in motion and at rest.

use crate::hash::{Fnv, in_both};
use crate::inputs::{Lcg, ends, pairs_of_ends, speed, unit};
use tribos_core::law::{
    CoulombLaw, DryFriction, LocalLaw, PlateauPowerLaw, PlateauPowerLawParameters, PowerLaw,
    RestTime, Savkoor, SavkoorParameters, StaticAgeing, StickSlip, Stribeck, StribeckParameters,
};
use tribos_core::real::Real;

/// Digest of friction against speed, f64 and f32.
pub fn moving() -> u64 {
    in_both(moving_of::<f64>, moving_of::<f32>)
}

fn moving_of<R: Real>(hash: &mut Fnv) {
    let real = R::from_f64;
    let dry = DryFriction::new(real(0.5), real(0.25)).expect("in range");
    let coulomb = CoulombLaw::new(real(0.375)).expect("in range");
    hash.numbers([dry.mu_static(), dry.mu_dynamic(), coulomb.mu()]);
    local(hash, &dry);
    local(hash, &coulomb);
    for alpha in [-0.5, 0.0, 1.0, 1.75] {
        let power = PowerLaw::new(real(alpha), real(0.3)).expect("in range");
        hash.numbers([power.alpha(), power.coefficient()]);
        hash.feed(u64::from(power.is_convex()));
        local(hash, &power);
    }
    for exponent in [0.5, 1.0, 2.0] {
        let law = Stribeck::new(StribeckParameters {
            dry,
            speed: real(0.125),
            exponent: real(exponent),
            viscous: real(0.0625),
        })
        .expect("in range");
        hash.maybe(law.minimum());
        local(hash, &law);
        for v in ends() {
            hash.numbers([law.boundary(v), law.hydrodynamic(v)]);
        }
    }
    let ice = PlateauPowerLaw::new(PlateauPowerLawParameters {
        alpha: real(-0.5),
        coefficient: real(0.008),
        plateau_speed: real(1e-4),
        drop_speed: real(1e-7),
        rest_share: R::HALF,
    });
    local(hash, &ice.expect("in range"));
    for (x, y) in pairs_of_ends::<R>() {
        hash.verdict(&DryFriction::new(x, y));
        hash.verdict(&PowerLaw::new(x, y));
        hash.verdict(&Stribeck::new(StribeckParameters {
            dry,
            speed: x,
            exponent: R::ONE,
            viscous: y,
        }));
    }
}

/// Digest of rubber, f64 and f32.
pub fn rubber() -> u64 {
    in_both(rubber_of::<f64>, rubber_of::<f32>)
}

fn rubber_of<R: Real>(hash: &mut Fnv) {
    let tread = |speed, narrowness| {
        Savkoor::new(SavkoorParameters {
            mu_base: R::from_f64(0.625),
            mu_max: R::from_f64(1.25),
            speed,
            narrowness,
        })
    };
    for narrowness in [0.375, 2.0] {
        let law = tread(R::HALF, R::from_f64(narrowness));
        local(hash, &law.expect("in range"));
    }
    for (x, y) in pairs_of_ends::<R>() {
        hash.verdict(&tread(x, y));
    }
}

/// Friction and slope at speeds of all sizes.
pub(crate) fn local<R: Real, L: LocalLaw<R>>(hash: &mut Fnv, law: &L) {
    let mut rng = Lcg::new(73);
    let mut at = |v| hash.numbers([law.friction(v), law.slope(v)]);
    for _ in 0..200 {
        at(speed(&mut rng));
    }
    ends().into_iter().for_each(&mut at);
}

/// Digest of starting, ageing and angles of friction, f64 and f32.
pub fn resting() -> u64 {
    in_both(resting_of::<f64>, resting_of::<f32>)
}

fn resting_of<R: Real>(hash: &mut Fnv) {
    let real = R::from_f64;
    let dry = DryFriction::new(real(0.5), real(0.25)).expect("in range");
    let ageing = StaticAgeing::new(real(0.4), real(0.02), real(0.125)).expect("in range");
    let mut rng = Lcg::new(79);
    let mut age = RestTime { time: R::ZERO };
    for _ in 0..400 {
        let drive = unit::<R>(&mut rng) - R::HALF;
        let grip = ageing.at_rest(age, drive);
        age = age.advance(speed(&mut rng), grip);
        hash.feed(u64::from(grip == StickSlip::Slip));
        hash.feed(u64::from(dry.at_rest(drive) == StickSlip::Stick));
        hash.numbers([age.time, ageing.mu_static(age), ageing.rate(age)]);
        hash.number(dry.net_drive(drive));
        let law = CoulombLaw::new(unit::<R>(&mut rng)).expect("in range");
        hash.number(law.friction_angle());
    }
    for x in ends::<R>() {
        let age = RestTime { time: x };
        hash.numbers([ageing.mu_static(age), ageing.rate(age)]);
        let law = CoulombLaw::new(x);
        hash.maybe(law.ok().map(|law| law.friction_angle()));
        hash.feed(u64::from(ageing.at_rest(age, x) == StickSlip::Slip));
        hash.number(dry.net_drive(x));
        hash.number(age.advance(x, StickSlip::Stick).time);
    }
    for (x, y) in pairs_of_ends::<R>() {
        hash.verdict(&StaticAgeing::new(x, y, R::ONE));
    }
}
