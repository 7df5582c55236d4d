//! Bits of laws with memory: rate and state, bristles.

use crate::hash::{Fnv, in_both};
use crate::inputs::{Lcg, ends, pairs_of_ends, signed, speed};
use crate::laws::local;
use tribos_core::law::{
    AgeingLaw, Bristle, LuGre, LuGreParameters, RateState, RateStateParameters, SlipLaw,
    StateEvolution, StateVariable,
};
use tribos_core::real::Real;

/// Digest of rate-and-state friction, f64 and f32.
pub fn rate_and_state() -> u64 {
    let mut hash = Fnv::new();
    rocks::<f64, AgeingLaw>(&mut hash);
    rocks::<f32, AgeingLaw>(&mut hash);
    rocks::<f64, SlipLaw>(&mut hash);
    rocks::<f32, SlipLaw>(&mut hash);
    hash.0
}

fn rocks<R: Real, E: StateEvolution>(hash: &mut Fnv) {
    let real = R::from_f64;
    let rock = RateStateParameters {
        mu: real(0.6),
        a: real(0.01),
        b: real(0.015),
        reference_speed: real(1e-6),
        slip_distance: real(1e-5),
        viscous: real(0.1),
    };
    let law = RateState::<R, E>::new(rock).expect("in range");
    let steady = law.steady();
    hash.numbers([law.parameters().mu, steady.parameters().viscous]);
    hash.maybe(steady.minimum());
    hash.number(steady.critical_stiffness(real(3.0)));
    local(hash, &steady);
    let mut rng = Lcg::new(97);
    let mut age = StateVariable { theta: R::ONE };
    for _ in 0..300 {
        let v: R = speed::<R>(&mut rng) * real(1e-6);
        age = law.advance(age, v, real(0.125));
        hash.numbers([age.theta, law.coefficient(v, age), law.slope(v, age)]);
        hash.numbers([law.logarithmic(v, age), law.steady_age(v).theta]);
        hash.number(steady.critical_stiffness_at(real(3.0), v));
    }
    for (v, theta) in pairs_of_ends::<R>().step_by(3) {
        let age = StateVariable { theta };
        hash.numbers([law.coefficient(v, age), law.slope(v, age)]);
        hash.numbers([law.logarithmic(v, age), law.advance(age, v, R::ONE).theta]);
        hash.number(E::evolved(theta, v, R::ONE, v));
        hash.verdict(&RateState::<R, E>::new(RateStateParameters {
            a: v,
            slip_distance: theta,
            ..rock
        }));
    }
    for v in ends() {
        hash.numbers([law.steady_age(v).theta, steady.critical_stiffness_at(v, v)]);
    }
}

/// Digest of the LuGre model, f64 and f32.
pub fn bristles() -> u64 {
    in_both(bristles_of::<f64>, bristles_of::<f32>)
}

fn bristles_of<R: Real>(hash: &mut Fnv) {
    let real = R::from_f64;
    let parameters = LuGreParameters {
        coulomb_force: real(1.0),
        static_force: real(1.5),
        stribeck_speed: real(1e-3),
        stiffness: real(1e5),
        bristle_damping: real(316.0),
        viscous_damping: real(0.4),
    };
    let joint = LuGre::new(parameters).expect("in range");
    hash.numbers([joint.largest_deflection(), joint.passive_up_to()]);
    hash.number(joint.parameters().stiffness);
    local(hash, &joint.steady_per_load(real(2.0)).expect("in range"));
    let mut rng = Lcg::new(101);
    let mut bristle = Bristle::RELAXED;
    for _ in 0..1000 {
        let v = signed::<R>(&mut rng) * real(1e-3);
        let force;
        (bristle, force) = joint.step(bristle, v, real(1e-4));
        hash.numbers([bristle.deflection, force]);
        hash.numbers([joint.rate(bristle, v), joint.force(bristle, v)]);
        hash.numbers([joint.steady_force(v), joint.steady_bristle_force(v)]);
    }
    for (v, deflection) in pairs_of_ends::<R>().step_by(3) {
        let bristle = Bristle { deflection };
        let (next, force) = joint.step(bristle, v, R::ONE);
        hash.numbers([next.deflection, force]);
        hash.numbers([joint.rate(bristle, v), joint.force(bristle, v)]);
        let (stiffness, bristle_damping) = (v, deflection);
        hash.verdict(&LuGre::new(LuGreParameters {
            stiffness,
            bristle_damping,
            ..parameters
        }));
    }
    for v in ends() {
        hash.numbers([joint.steady_force(v), joint.steady_bristle_force(v)]);
        hash.verdict(&joint.steady_per_load(v));
    }
}
