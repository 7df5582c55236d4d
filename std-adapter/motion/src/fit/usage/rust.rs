//! A fitted law as a program in Rust: with the kernel's law, or with a few lines where it has none.

use super::shape::Shape;
use super::spec::{dahl, joint_fields, rock_fields};
use super::{FittedLaw, SHOWN_SPEEDS, SHOWN_STEP, SHOWN_VELOCITIES, number};
use tribos_core::law::LuGreParameters;

/// A whole program.
pub(super) fn program(law: &FittedLaw<'_>, shape: &Shape) -> String {
    let unit = law.unit();
    match shape {
        Shape::Coulomb { mu } => local(
            "CoulombLaw<f64>",
            "CoulombLaw, LawError, LocalLaw",
            &format!("CoulombLaw::new({mu:?})"),
            unit,
        ),
        Shape::Viscous { mu, k } => stribeck([*mu, *mu, 1.0, 1.0, *k], unit),
        Shape::Stribeck {
            mu_s,
            mu_d,
            vs,
            delta,
            k,
        } => stribeck([*mu_s, *mu_d, *vs, *delta, *k], unit),
        Shape::Tanh { mu, vt } => local(
            "TanhLaw<f64>",
            "LawError, LocalLaw, TanhLaw",
            &format!("TanhLaw::new({mu:?}, {vt:?})"),
            unit,
        ),
        Shape::Arctan { mu, vt } => arctan(*mu, *vt, unit),
        Shape::Rising { mu_s, mu_f, vr } => local(
            "RisingLaw<f64>",
            "LawError, LocalLaw, RisingLaw, RisingLawParameters",
            &format!(
                "RisingLaw::new(RisingLawParameters {{ mu_rest: {mu_s:?}, mu_fast: {mu_f:?}, speed: {vr:?} }})"
            ),
            unit,
        ),
        Shape::Power { gamma, alpha } => local(
            "PowerLaw<f64>",
            "LawError, LocalLaw, PowerLaw",
            &format!("PowerLaw::new({alpha:?}, {gamma:?})"),
            unit,
        ),
        Shape::Amontons { mu, adhesion } => amontons(*mu, *adhesion),
        Shape::Sliders(elements) => sliders(elements),
        Shape::Dahl { fc, s0 } => bristles(&dahl(*fc, *s0)),
        Shape::ElastoPlastic { joint, zba } => elasto_plastic(joint, *zba),
        Shape::LuGre(joint) => bristles(joint),
        Shape::SteadyLuGre(joint) => local(
            "impl LocalLaw<f64>",
            "LawError, LocalLaw, LuGre, LuGreParameters",
            // The bristles do not matter in steady sliding.
            &format!(
                "LuGre::new(LuGreParameters {{\n{}    }})?.steady_per_load(1.0)",
                fields(joint)
            ),
            unit,
        ),
        Shape::RateState { rock, by_slip } => {
            let evolution = if *by_slip { "SlipLaw" } else { "AgeingLaw" };
            rate_state(&rock_fields(rock, field), evolution, rock.reference_speed)
        }
        Shape::SteadyRateState(rock) => local(
            "SteadyRateState<f64>",
            "LawError, LocalLaw, RateState, RateStateParameters, SteadyRateState",
            &format!(
                "Ok(RateState::<f64>::new(RateStateParameters {{\n{}    }})?.steady())",
                rock_fields(rock, field)
            ),
            unit,
        ),
    }
}

/// A line of a structure.
fn field(name: &str, value: String) -> String {
    format!("        {name}: {value},\n")
}

fn fields(joint: &LuGreParameters<f64>) -> String {
    joint_fields(joint, field)
}

/// A law of the kernel that depends on the speed alone.
fn local(law: &str, uses: &str, made: &str, unit: &str) -> String {
    let shown = shown_speeds(unit, "law.friction(speed)");
    format!(
        "use tribos_core::law::{{{uses}}};\n\n\
         /// The fitted law. It couples sliding and spinning of a patch by `DiskQuadrature::new(law)`.\n\
         fn law() -> Result<{law}, LawError> {{\n    {made}\n}}\n\n\
         fn main() -> Result<(), LawError> {{\n    let law = law()?;\n{shown}    Ok(())\n}}\n"
    )
}

/// Prints friction at some speeds.
fn shown_speeds(unit: &str, call: &str) -> String {
    format!(
        "    for speed in {SHOWN_SPEEDS:?} {{\n        \
         println!(\"{{speed}} m/s: {{:.9}}\", {call}); // {unit}\n    }}\n"
    )
}

/// Prints friction of some steps of 1 ms.
fn shown_steps(unit: &str, step: &str) -> String {
    format!(
        "    for velocity in {SHOWN_VELOCITIES:?} {{\n{step}        \
         println!(\"{{velocity}} m/s: {{force:.9}}\"); // {unit}, with the sign of the velocity\n    }}\n"
    )
}

fn stribeck([mu_s, mu_d, vs, delta, k]: [f64; 5], unit: &str) -> String {
    let made = format!(
        "Stribeck::new(StribeckParameters {{\n        dry: DryFriction::new({mu_s:?}, {mu_d:?})?,\n{}    }})",
        [("speed", vs), ("exponent", delta), ("viscous", k)]
            .map(|(name, x)| field(name, number(x)))
            .concat()
    );
    let uses = "DryFriction, LawError, LocalLaw, Stribeck, StribeckParameters";
    local("Stribeck<f64>", uses, &made, unit)
}

fn arctan(mu: f64, vt: f64, unit: &str) -> String {
    let shown = shown_speeds(unit, "Arctan.friction(speed)");
    format!(
        "use std::f64::consts::FRAC_2_PI;\n\
         use tribos_core::law::LocalLaw;\n\n\
         /// The fitted law. It couples sliding and spinning of a patch by `DiskQuadrature::new(Arctan)`.\n\
         struct Arctan;\n\n\
         impl Arctan {{\n    const MU: f64 = {mu:?};\n    const SPEED: f64 = {vt:?}; // m/s\n}}\n\n\
         impl LocalLaw<f64> for Arctan {{\n    \
         fn friction(&self, speed: f64) -> f64 {{\n        \
         Self::MU * FRAC_2_PI * (speed / Self::SPEED).atan()\n    }}\n    \
         fn slope(&self, speed: f64) -> f64 {{\n        \
         let x = speed / Self::SPEED;\n        \
         Self::MU * FRAC_2_PI / (Self::SPEED * (1.0 + x * x))\n    }}\n}}\n\n\
         fn main() {{\n{shown}}}\n"
    )
}

fn amontons(mu: f64, adhesion: f64) -> String {
    let shown = shown_speeds("friction in N", "load * law.friction(speed)");
    format!(
        "use tribos_core::law::{{CoulombLaw, LawError, LocalLaw}};\n\n\
         /// The fitted law at a load in N: adhesion is there without a load, so that the coefficient falls with it.\n\
         fn law(load: f64) -> Result<CoulombLaw<f64>, LawError> {{\n    \
         CoulombLaw::new({mu:?} + {adhesion:?} / load)\n}}\n\n\
         fn main() -> Result<(), LawError> {{\n    let load = 10.0; // N\n    let law = law(load)?;\n{shown}    Ok(())\n}}\n"
    )
}

fn bristles(joint: &LuGreParameters<f64>) -> String {
    let step = format!(
        "        let (next, force) = law.step(bristle, velocity, {SHOWN_STEP:?}); // s\n        bristle = next;\n"
    );
    let shown = shown_steps("mean friction of the step", &step);
    format!(
        "use tribos_core::law::{{Bristle, LawError, LuGre, LuGreParameters}};\n\n\
         /// The fitted law, in N, m and s.\n\
         fn law() -> Result<LuGre<f64>, LawError> {{\n    LuGre::new(LuGreParameters {{\n{}    }})\n}}\n\n\
         fn main() -> Result<(), LawError> {{\n    let law = law()?;\n    \
         let mut bristle = Bristle::RELAXED; // the state, one for each contact\n{shown}    Ok(())\n}}\n",
        fields(joint)
    )
}

fn rate_state(rock: &str, evolution: &str, start: f64) -> String {
    let step = format!(
        "        let speed = f64::abs(velocity);\n        \
         age = law.advance(age, speed, {SHOWN_STEP:?}); // s\n        \
         let force = law.coefficient(speed, age).copysign(velocity);\n"
    );
    let shown = shown_steps("friction per load", &step);
    format!(
        "use tribos_core::law::{{{evolution}, LawError, RateState, RateStateParameters}};\n\n\
         /// The fitted law.\n\
         fn law() -> Result<RateState<f64, {evolution}>, LawError> {{\n    \
         RateState::new(RateStateParameters {{\n{rock}    }})\n}}\n\n\
         fn main() -> Result<(), LawError> {{\n    let law = law()?;\n    \
         let mut age = law.steady_age({start:?}); // the state, one for each contact\n{shown}    Ok(())\n}}\n"
    )
}

fn sliders(elements: &[[f64; 2]]) -> String {
    let count = elements.len();
    let column = |at: usize| {
        let values = elements.iter().filter_map(|pair| pair.get(at));
        values.map(|&x| number(x)).collect::<Vec<_>>().join(", ")
    };
    let step = format!("        let force = law.step(velocity, {SHOWN_STEP:?}); // s\n");
    let shown = shown_steps("friction", &step);
    format!(
        "/// The fitted law: springs side by side, each of which slips at its own force.\n\
         #[derive(Default)]\nstruct Sliders {{\n    force: [f64; {count}], // of each spring, in N; the state\n}}\n\n\
         impl Sliders {{\n    const STIFFNESS: [f64; {count}] = [{}]; // N/m\n    \
         const SLIP_FORCE: [f64; {count}] = [{}]; // N\n\n    \
         /// Friction in N after a time at a velocity.\n    \
         fn step(&mut self, velocity: f64, dt: f64) -> f64 {{\n        \
         for (i, force) in self.force.iter_mut().enumerate() {{\n            \
         let pulled = *force + Self::STIFFNESS[i] * velocity * dt;\n            \
         *force = pulled.clamp(-Self::SLIP_FORCE[i], Self::SLIP_FORCE[i]);\n        }}\n        \
         self.force.iter().sum()\n    }}\n}}\n\n\
         fn main() {{\n    let mut law = Sliders::default();\n{shown}}}\n",
        column(0),
        column(1),
    )
}

fn elasto_plastic(joint: &LuGreParameters<f64>, zba: f64) -> String {
    let constants = joint_fields(joint, |name, value| {
        format!("    const {}: f64 = {value};\n", name.to_uppercase())
    });
    let step = format!("        let force = law.step(velocity, {SHOWN_STEP:?}); // s\n");
    let shown = shown_steps("friction", &step);
    format!(
        "use std::f64::consts::PI;\n\n\
         /// The fitted law, in N, m and s: bristles that do not creep while they are bent little.\n\
         #[derive(Default)]\nstruct ElastoPlastic {{\n    deflection: f64, // of the bristles; the state\n}}\n\n\
         impl ElastoPlastic {{\n{constants}    \
         /// Deflection up to which nothing slips, over that of steady sliding.\n    \
         const ELASTIC_SHARE: f64 = {zba:?};\n\n    \
         /// Friction after a time at a velocity; |velocity| dt has to be well below COULOMB_FORCE/STIFFNESS.\n    \
         fn step(&mut self, velocity: f64, dt: f64) -> f64 {{\n        \
         let (z, x) = (self.deflection.abs(), velocity / Self::STRIBECK_SPEED);\n        \
         let steady = Self::COULOMB_FORCE + (Self::STATIC_FORCE - Self::COULOMB_FORCE) * (-x * x).exp();\n        \
         let most = steady / Self::STIFFNESS;\n        \
         let elastic = Self::ELASTIC_SHARE * most;\n        \
         // Share of the motion that slips.\n        \
         let slipping = if self.deflection * velocity <= 0.0 || z <= elastic {{\n            0.0\n        \
         }} else if z >= most {{\n            1.0\n        }} else {{\n            \
         0.5 + 0.5 * (PI * (z - 0.5 * (most + elastic)) / (most - elastic)).sin()\n        }};\n        \
         // Exact for this share.\n        \
         let rate = slipping * velocity.abs() / most;\n        \
         let time = if rate > 0.0 {{ -(-rate * dt).exp_m1() / rate }} else {{ dt }};\n        \
         let bent = (velocity - rate * self.deflection) * time;\n        \
         self.deflection += bent;\n        \
         Self::STIFFNESS * self.deflection + Self::BRISTLE_DAMPING * bent / dt + Self::VISCOUS_DAMPING * velocity\n    \
         }}\n}}\n\n\
         fn main() {{\n    let mut law = ElastoPlastic::default();\n{shown}}}\n"
    )
}
