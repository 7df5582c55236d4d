//! Bonds: forces, stiffness and the onset of sliding.

use super::check::{all_nan, finite, holds};
use super::patches::node;
use super::{Broken, Source};
use tribos_core::bond::{
    BondLaw, Bonds, BrittleBond, ExponentialBond, FailureMode, PlasticBond, ReformingBond,
    WeibullBond,
};
use tribos_core::patch::nodes::{NodePatch, Nodes};
use tribos_core::real::Real;
use tribos_core::twist::Twist;

/// One law on three points, in either precision.
pub fn bonds(source: &mut Source) -> Result<(), Broken> {
    if source.one_in(2) {
        of::<f64>(source)
    } else {
        of::<f32>(source)
    }
}

fn of<R: Real>(source: &mut Source) -> Result<(), Broken> {
    let (stiffness, strain) = (source.positive::<R>(), source.positive::<R>());
    match source.below(6) {
        0 => ExponentialBond::new(stiffness, strain).map_or(Ok(()), |law| {
            energy(source, |d| law.energy(d))?;
            judged(source, "exponential bonds", law)
        }),
        1 => BrittleBond::new(stiffness, strain).map_or(Ok(()), |law| {
            energy(source, |d| law.energy(d))?;
            judged(source, "bonds of one strength", law)
        }),
        2 => PlasticBond::new(stiffness, strain).map_or(Ok(()), |law| {
            energy(source, |d| law.energy(d))?;
            judged(source, "yielding bonds", law)
        }),
        3 => WeibullBond::new(stiffness, strain, source.positive())
            .map_or(Ok(()), |law| judged(source, "Weibull's bonds", law)),
        4 => ReformingBond::one_strength(stiffness, strain)
            .map_or(Ok(()), |law| judged(source, "sawtooth", law)),
        _ => ReformingBond::new(stiffness, strain, source.below(70) as u32)
            .map_or(Ok(()), |law| judged(source, "re-forming bonds", law)),
    }
}

fn energy<R: Real>(source: &mut Source, energy: impl Fn(R) -> R) -> Result<(), Broken> {
    let strain = source.positive::<R>();
    finite(source, "energy of bonds", [energy(strain)])
}

/// The law, and the onset on three points.
fn judged<R: Real, L: BondLaw<R>>(source: &mut Source, name: &str, law: L) -> Result<(), Broken> {
    let strain = source.positive::<R>();
    let answers = [
        law.friction(strain),
        law.slope(strain),
        law.transverse_stiffness(strain),
    ];
    if strain.is_nan() {
        all_nan(name, answers)?;
    } else {
        finite(source, name, answers)?;
    }
    holds(law.peak() > R::ZERO, "a peak > 0", &[law.peak()])?;
    finite(source, name, [law.stiffness(), law.plateau()])?;
    let nodes = [(); 3].map(|()| node::<R>(source));
    let Ok(patch) = Nodes::new(nodes) else {
        return Ok(());
    };
    let Ok(bonds) = Bonds::new(&law, patch) else {
        return Ok(());
    };
    let bonds = bonds.with_rim(source.positive()).unwrap_or(bonds);
    let (load, at) = (source.size::<R>(), [(); 3].map(|()| source.number::<R>()));
    let direction = Twist::new(at[0], at[1], at[2]);
    let stiffness = bonds.stiffness(load, &direction);
    let wrench = bonds.wrench(load, &direction);
    holds(
        bonds.patch().nodes().len() == 3 && bonds.law().stiffness() == law.stiffness(),
        "what was given is kept",
        &[law.stiffness()],
    )?;
    finite(
        source,
        "wrench of bonds",
        [wrench.force.x, wrench.force.y, wrench.torque],
    )?;
    finite(source, "stiffness of bonds", stiffness.iter().copied())?;
    let Some(onset) = bonds.onset(load, &direction) else {
        return Ok(());
    };
    let push = onset.push;
    finite(
        source,
        "push at the onset",
        [push.force.x, push.force.y, push.torque],
    )?;
    // Where they may hold on there is a displacement at which they do.
    let Twist { velocity, spin } = onset.displacement;
    let is_reached = [velocity.x, velocity.y, spin]
        .iter()
        .all(|part| part.is_finite());
    let is_endless = onset.release == FailureMode::Yields;
    holds(
        is_endless || is_reached,
        "a finite displacement",
        &[velocity.x, velocity.y, spin],
    )?;
    holds(
        !is_endless || !law.peak().is_finite(),
        "only what never weakens yields",
        &[law.peak()],
    )
}
