//! Elastic bonds of patches, points and bodies.

use super::check::{all_nan, finite, holds};
use super::patches::node;
use super::planes::{twist, wrench};
use super::{Broken, Source};
use tribos_core::contact::TimeStep;
use tribos_core::holding::{Stiction, StictionBounds};
use tribos_core::law::StickSlip;
use tribos_core::limit_surface::{FrictionSet, LimitEllipsoid, ScaledSet};
use tribos_core::patch::nodes::{NodePatch, Nodes};
use tribos_core::planar::{ElasticState, PlanarBody};
use tribos_core::presliding::{
    Anchor, MicroslipPresliding, PointPresliding, Pose, Presliding, Settled,
};
use tribos_core::real::Real;
use tribos_core::twist::{Displacement, Wrench};

/// Points of a foot.
const POINTS: usize = 3;

pub fn presliding(source: &mut Source) -> Result<(), Broken> {
    let springs = [patch::<f64>, patch::<f32>, points::<f64>, points::<f32>];
    source.one_of(&springs)(source)
}

fn pose<R: Real>(source: &mut Source) -> Pose<R> {
    Pose::new(source.number(), source.number(), source.number())
}

fn displacement<R: Real>(source: &mut Source) -> Displacement<R> {
    Displacement::along(&twist(source), source.positive())
}

fn parts<R: Real>(w: &Wrench<R>) -> [R; 3] {
    [w.force.x, w.force.y, w.torque]
}

/// A set of some strength, and bonds.
fn patch<R: Real>(source: &mut Source) -> Result<(), Broken> {
    let (force, radius, torque) = (source.size::<R>(), source.positive(), source.positive());
    let Ok(base) = LimitEllipsoid::new(force, radius, torque) else {
        return Ok(());
    };
    let Ok(set) = ScaledSet::new(&base, source.positive::<R>()) else {
        return Ok(());
    };
    let Ok(bonds) = Presliding::new(source.positive::<R>(), source.positive()) else {
        return Ok(());
    };
    let (anchor, from, to) = (Anchor::at(pose(source)), pose::<R>(source), pose(source));
    let step = bonds.step(&set, &anchor, &to);
    finite(source, "friction on bonds", parts(&step.friction))?;
    if step.grip == StickSlip::Stick {
        holds(
            step.anchor == anchor,
            "bonds that hold keep their anchor",
            &[step.dissipated],
        )?;
    }
    if to.angle.is_nan() {
        all_nan("friction on bonds", parts(&step.friction))?;
    }
    let stored = bonds.stored_energy(&anchor, &to);
    holds(
        stored >= R::ZERO || stored.is_nan(),
        "bonds store energy",
        &[stored],
    )?;
    let strain = displacement(source);
    let moved = displacement(source);
    judged(source, &bonds.advance(&set, &strain, &moved))?;
    let (breakaway, exponent) = (source.unit::<R>(), source.positive());
    if let Ok(gradual) = MicroslipPresliding::new(bonds, breakaway, exponent) {
        judged(source, &gradual.advance(&set, &strain, &moved))?;
        let kept = [gradual.breakaway(), gradual.exponent()];
        let is_kept = kept == [breakaway, exponent] && *gradual.bonds() == bonds;
        holds(is_kept, "parameters are kept", &kept)?;
        let step = gradual.step(&set, &anchor, [&from, &to]);
        finite(source, "friction on soft bonds", parts(&step.friction))?;
    }
    let push = wrench::<R>(source);
    let under = bonds.strain_under(&push);
    let stiffness = [bonds.stiffness(), bonds.torsional_stiffness()];
    finite(source, "strain under a push", [under.shift.x, under.turn])?;
    holds(
        stiffness.iter().all(|k| *k > R::ZERO),
        "stiffness is positive",
        &stiffness,
    )?;
    holds(
        set.strength() > R::ZERO,
        "strength is positive",
        &[set.strength()],
    )?;
    let answer = StictionBounds::of(&set, &base, &push);
    let is_nan = parts(&push).iter().any(|x| x.is_nan());
    if is_nan {
        holds(
            answer.stiction == Stiction::Undecided,
            "NaN is undecided",
            &parts(&push),
        )?;
    }
    let (held, slips) = (answer.certain_scale(), answer.possible_scale());
    holds(
        held >= R::ZERO || held.is_nan(),
        "scales are not negative",
        &[held, slips],
    )?;
    asked(source, &set, &push)?;
    on_bonds(source, &bonds, &set, &push)
}

/// A set of some strength: the surface above a push, and the push that moves back.
fn asked<R: Real>(
    source: &mut Source,
    set: &impl FrictionSet<R>,
    push: &Wrench<R>,
) -> Result<(), Broken> {
    let motion = twist(source);
    finite(source, "friction of a set", parts(&set.wrench(&motion)))?;
    let normal = set.twist_normal_to(push);
    let resisted = set.twist_resisted_by(push);
    let is_opposite = resisted == -normal || normal.spin.is_nan();
    holds(
        is_opposite,
        "friction opposes",
        &[normal.spin, resisted.spin],
    )?;
    let on = set.scale_to_surface(push);
    let all = [normal.velocity.x, normal.velocity.y, normal.spin];
    finite(source, "normal of a set", all)?;
    if source.is_mild() && set.force_limit() > R::ZERO {
        finite(source, "surface of a set", parts(&on))?;
    }
    let kept = set.gauge(&set.project(push).wrench);
    let most = R::ONE + R::from_f64(1e-3);
    let is_fair = source.is_mild() && set.force_limit() > R::ZERO;
    holds(
        !is_fair || kept <= most,
        "what is projected is inside",
        &[kept],
    )
}

fn judged<R: Real>(source: &Source, end: &Settled<R>) -> Result<(), Broken> {
    finite(source, "settled friction", parts(&end.friction))?;
    let heat = end.dissipated;
    holds(heat >= R::ZERO || heat.is_nan(), "slip dissipates", &[heat])
}

/// A body on the bonds: finite, and without push it gains no energy.
fn on_bonds<R: Real>(
    source: &mut Source,
    bonds: &Presliding<R>,
    set: &impl FrictionSet<R>,
    push: &Wrench<R>,
) -> Result<(), Broken> {
    let (mass, inertia, dt) = (source.positive::<R>(), source.positive(), source.positive());
    let (Ok(body), Ok(dt)) = (PlanarBody::new(mass, inertia), TimeStep::new(dt)) else {
        return Ok(());
    };
    let Ok(bonds) = bonds.with_damping(source.size(), source.size()) else {
        return Ok(());
    };
    let state = ElasticState {
        twist: twist(source),
        ..ElasticState::at_rest(pose(source))
    };
    let step = body.step_elastic(&bonds, set, &state, push, dt);
    finite(source, "a step on bonds", parts(&step.friction))?;
    let lost = [step.slip_heat, step.damping_heat, step.rule_loss];
    let all = [lost[0], lost[1], lost[2], step.lost_energy()];
    let none_below_zero = all.iter().all(|x| *x >= R::ZERO || x.is_nan());
    holds(none_below_zero, "no loss is negative", &all)
}

/// Points that let go one after the other.
fn points<R: Real>(source: &mut Source) -> Result<(), Broken> {
    let Ok(nodes) = Nodes::new([(); POINTS].map(|()| node::<R>(source))) else {
        return Ok(());
    };
    let (stiffness, limit) = (source.positive(), source.size());
    let start = pose(source);
    let Ok(mut bound) = PointPresliding::<R, _, POINTS>::new(nodes, stiffness, limit, &start)
    else {
        return Ok(());
    };
    for _ in 0..3 {
        let step = bound.step(&pose(source));
        finite(source, "friction of points", parts(&step.friction))?;
        let (heat, stored) = (step.dissipated, bound.stored_energy(&start));
        let are_valid = [heat, stored].iter().all(|x| *x >= R::ZERO || x.is_nan());
        holds(are_valid, "points dissipate", &[heat, stored])?;
        let (reach, weight) = (bound.reach(), bound.patch().total_weight());
        let is_kept = bound.force_limit() / bound.stiffness() == reach;
        holds(
            is_kept && reach >= R::ZERO && weight > R::ZERO,
            "points reach",
            &[reach, weight],
        )?;
        if bound.set_force_limit(source.size()).is_err() {
            bound.anchor_at(&start);
        }
    }
    Ok(())
}
