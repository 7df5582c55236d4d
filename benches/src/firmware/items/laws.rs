//! Local laws: one friction, or one step of a state.

use super::{Code, Item, NARROW, item};
use tribos_subjects::MEMORYLESS;

const fn law(
    name: &'static str,
    modules: &'static str,
    prepare: &'static str,
    call: &'static str,
) -> Item {
    item(["law", name], NARROW, modules, Code::new(prepare, call))
}

const RATE_AND_STATE: &str = "RateState::<R, AgeingLaw>::new(RateStateParameters { mu: 0.5, a: 0.01, b: 0.02, reference_speed: b, slip_distance: 1e-5, viscous: 0.0 }).ok()?";
const RATE_AND_STATE_STEADY: &str = "RateState::<R, AgeingLaw>::new(RateStateParameters { mu: 0.5, a: 0.01, b: 0.02, reference_speed: b, slip_distance: 1e-5, viscous: 0.0 }).ok()?.steady()";
const LUGRE: &str = "LuGre::new(LuGreParameters { coulomb_force: 1.0, static_force: 1.5, stribeck_speed: b, stiffness: 1e5, bristle_damping: 300.0, viscous_damping: 0.5 }).ok()?";

/// Laws with a state, and their steady states.
const WITH_MEMORY: [Item; 5] = [
    law(
        "ageing",
        "law::ageing law::grip",
        "StaticAgeing::new(0.25, 0.125, b).ok()?",
        "object.mu_static(RestTime::default().advance(a, object.at_rest(RestTime::default(), b)))",
    ),
    law(
        "rate and state",
        "law::rate_state law::contact_age",
        RATE_AND_STATE,
        "let age = object.advance(StateVariable { theta: b }, a, b);
        object.coefficient(a, age)",
    ),
    law(
        "rate and state: steady",
        "law::rate_state law::steady_rate_state law::contact_age",
        RATE_AND_STATE_STEADY,
        "object.friction(a)",
    ),
    law(
        "LuGre",
        "law::lugre",
        LUGRE,
        "object.step(Bristle { deflection: b }, a, b).1",
    ),
    law(
        "LuGre: steady",
        "law::lugre",
        LUGRE,
        "object.steady_force(a)",
    ),
];

/// One speed in, one coefficient or force out.
pub fn laws() -> impl Iterator<Item = Item> {
    let memoryless = MEMORYLESS.iter();
    let memoryless = memoryless.map(|one| law(one.name, one.modules, one.made, one.call));
    memoryless.chain(WITH_MEMORY)
}
