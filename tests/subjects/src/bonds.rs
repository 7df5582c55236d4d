//! Bonds: forces, stiffness and the onset of sliding.

use super::patches::node;
use crate::{Input, Verdict};
use tribos_core::bond::{
    BondLaw, Bonds, BrittleBond, ExponentialBond, FailureMode, PlasticBond, ReformingBond,
    WeibullBond,
};
use tribos_core::patch::nodes::{NodePatch, Nodes};
use tribos_core::real::Real;
use tribos_core::twist::Twist;

/// One law on three points.
pub fn bonds<R: Real>(input: &mut Input<'_>) -> Verdict {
    let (stiffness, strain) = (input.positive::<R>(), input.positive::<R>());
    let at = input.positive::<R>();
    match input.below(6) {
        0 => {
            let law = input.taken(ExponentialBond::new(stiffness, strain))?;
            input.finite("energy of bonds", [law.energy(at)])?;
            judged(input, "exponential bonds", law)
        }
        1 => {
            let law = input.taken(BrittleBond::new(stiffness, strain))?;
            input.finite("energy of bonds", [law.energy(at)])?;
            judged(input, "bonds of one strength", law)
        }
        2 => {
            let law = input.taken(PlasticBond::new(stiffness, strain))?;
            input.finite("energy of bonds", [law.energy(at)])?;
            judged(input, "yielding bonds", law)
        }
        3 => {
            let law = input.taken(WeibullBond::new(stiffness, strain, at))?;
            judged(input, "Weibull's bonds", law)
        }
        4 => {
            let law = input.taken(ReformingBond::one_strength(stiffness, strain))?;
            judged(input, "sawtooth", law)
        }
        _ => {
            let stages = input.below(70) as u32;
            let law = input.taken(ReformingBond::new(stiffness, strain, stages))?;
            judged(input, "re-forming bonds", law)
        }
    }
}

/// The law, and the onset on three points.
fn judged<R: Real, L: BondLaw<R>>(input: &mut Input<'_>, name: &'static str, law: L) -> Verdict {
    let strain = input.positive::<R>();
    let answers = [
        law.friction(strain),
        law.slope(strain),
        law.transverse_stiffness(strain),
    ];
    if strain.is_nan() {
        input.all_nan(name, answers)?;
    } else {
        input.finite(name, answers)?;
    }
    input.holds(law.peak() > R::ZERO, "a peak > 0", &[law.peak()])?;
    input.give_bits(u64::from(law.is_brittle()));
    input.finite(name, [law.stiffness(), law.plateau()])?;
    let nodes = [(); 3].map(|()| node::<R>(input));
    let patch = input.taken(Nodes::new(nodes))?;
    let bonds = input.taken(Bonds::new(&law, patch))?;
    let rim = input.positive();
    let bonds = input.taken(bonds.with_rim(rim)).unwrap_or(bonds);
    let (load, at) = (input.size::<R>(), [(); 3].map(|()| input.number::<R>()));
    let direction = Twist::new(at[0], at[1], at[2]);
    let stiffness = bonds.stiffness(load, &direction);
    let wrench = bonds.wrench(load, &direction);
    input.holds(
        bonds.patch().nodes().len() == 3 && bonds.law().stiffness() == law.stiffness(),
        "what was given is kept",
        &[law.stiffness()],
    )?;
    input.finite(
        "wrench of bonds",
        [wrench.force.x, wrench.force.y, wrench.torque],
    )?;
    input.finite("stiffness of bonds", stiffness.iter().copied())?;
    let onset = bonds.onset(load, &direction);
    let onset = input.taken(onset.ok_or(()))?;
    let push = onset.push;
    input.finite(
        "push at the onset",
        [push.force.x, push.force.y, push.torque],
    )?;
    // Where they may hold on there is a displacement at which they do.
    let Twist { velocity, spin } = onset.displacement;
    let is_reached = [velocity.x, velocity.y, spin]
        .iter()
        .all(|part| part.is_finite());
    input.give_bits(onset.release as u64);
    let is_endless = onset.release == FailureMode::Yields;
    input.holds(
        is_endless || is_reached,
        "a finite displacement",
        &[velocity.x, velocity.y, spin],
    )?;
    input.holds(
        !is_endless || !law.peak().is_finite(),
        "only what never weakens yields",
        &[law.peak()],
    )
}
