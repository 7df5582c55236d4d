//! Laws of one surface element.

use super::stream::{Precision, Range, Stream};
use tribos_core::law::{
    AgeingLaw, Bristle, CoulombLaw, DryFriction, LocalLaw, LuGre, LuGreParameters, PowerLaw,
    RateState, RateStateParameters, SlipLaw, StateVariable, StickSlip, Stribeck,
    StribeckParameters,
};

pub fn simple<R: Precision>(s: &mut Stream) {
    let p: [R; 6] = s.draws(Range::Fit);
    let x = s.draw(Range::Wide);
    let coulomb = CoulombLaw::new(p[0]);
    let dry = DryFriction::new(p[0] + p[1], p[1]);
    let power = PowerLaw::new(p[2] - R::ONE, p[3]);
    let stribeck = dry.and_then(|dry| {
        Stribeck::new(StribeckParameters {
            dry,
            speed: p[2],
            exponent: p[3],
            viscous: p[4],
        })
    });
    s.result(coulomb.map(|law| law.friction(x)));
    s.result(dry.map(|law| law.friction(x)));
    if let Some(grip) = s.ok(dry.map(|law| law.at_rest(x))) {
        s.feed_bits((grip == StickSlip::Stick).into());
    }
    s.result(dry.map(|law| law.net_drive(x)));
    s.result(power.map(|law| law.friction(x)));
    s.result(power.map(|law| law.slope(x)));
    s.result(stribeck.map(|law| law.friction(x)));
    s.result(stribeck.map(|law| law.slope(x)));
    s.result(stribeck.ok().and_then(|law| law.minimum()).ok_or(()));
}

pub fn with_state<R: Precision>(s: &mut Stream) {
    let p: [R; 6] = s.draws(Range::Fit);
    let x: [R; 3] = s.draws(Range::Wide);
    let lugre = LuGre::new(LuGreParameters {
        coulomb_force: p[0],
        static_force: p[0] + p[1],
        stribeck_speed: p[2],
        stiffness: p[3],
        bristle_damping: p[4],
        viscous_damping: p[5],
    });
    let rock = RateStateParameters {
        mu: p[0],
        a: p[1],
        b: p[2],
        reference_speed: p[3],
        slip_distance: p[4],
        viscous: p[5],
    };
    let [ageing, slip] = [
        RateState::<R, AgeingLaw>::new(rock).map(|law| {
            let age = StateVariable { theta: x[1] };
            law.advance(age, x[0], x[2]).theta
        }),
        RateState::<R, SlipLaw>::new(rock).map(|law| {
            let age = StateVariable { theta: x[1] };
            law.advance(age, x[0], x[2]).theta
        }),
    ];
    let law = RateState::<R, AgeingLaw>::new(rock);

    let start = Bristle { deflection: x[0] };
    let stepped = lugre.map(|law| law.step(start, x[1], x[2]));
    s.result(stepped.map(|(_, force)| force));
    s.number(stepped.map_or(x[0], |(end, _)| end.deflection));
    s.result(lugre.map(|law| law.force(start, x[1])));
    s.result(lugre.map(|law| law.steady_force(x[1])));
    s.result(lugre.map(|law| law.passive_up_to()));

    let age = StateVariable { theta: x[1] };
    s.result(law.map(|law| law.coefficient(x[0], age)));
    s.result(law.map(|law| law.slope(x[0], age)));
    for advanced in [ageing, slip] {
        s.result(advanced.map(|_| R::ZERO));
        s.number(advanced.unwrap_or(x[1]));
    }
    s.result(law.map(|law| law.steady().friction(x[0])));
    s.result(law.map(|law| law.steady().slope(x[0])));
}
