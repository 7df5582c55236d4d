//! Elastic bonds of patches, points and bodies.

use super::patches::node;
use super::planes::{parts, rates, twist, wrench};
use crate::{Input, Verdict};
use tribos_core::contact::TimeStep;
use tribos_core::holding::{Stiction, StictionBounds};
use tribos_core::law::StickSlip;
use tribos_core::limit_surface::{FrictionSet, LimitEllipsoid, Projection, Region, ScaledSet};
use tribos_core::patch::nodes::{NodePatch, Nodes};
use tribos_core::planar::{ElasticState, PlanarBody};
use tribos_core::presliding::{
    Anchor, MicroslipPresliding, PointPresliding, Pose, Presliding, Settled,
};
use tribos_core::real::Real;
use tribos_core::twist::{Displacement, Wrench};

/// Points of a foot.
const POINTS: usize = 3;
/// Steps that follow each other.
const STEPS: usize = 3;

/// A patch or points on bonds.
pub fn presliding<R: Real>(input: &mut Input<'_>) -> Verdict {
    let springs = [patch::<R>, points::<R>];
    input.one_of(&springs)(input)
}

fn pose<R: Real>(input: &mut Input<'_>) -> Pose<R> {
    Pose::new(input.number(), input.number(), input.number())
}

fn displacement<R: Real>(input: &mut Input<'_>) -> Displacement<R> {
    Displacement::along(&twist(input), input.positive())
}

fn moves<R: Real>(by: &Displacement<R>) -> [R; 3] {
    [by.shift.x, by.shift.y, by.turn]
}

/// A set of some strength, and bonds.
fn patch<R: Real>(input: &mut Input<'_>) -> Verdict {
    let (force, radius, torque) = (input.size::<R>(), input.positive(), input.positive());
    let base = input.taken(LimitEllipsoid::new(force, radius, torque))?;
    let set = ScaledSet::new(&base, input.positive::<R>());
    let set = input.taken(set)?;
    let bonds = Presliding::new(input.positive::<R>(), input.positive());
    let bonds = input.taken(bonds)?;
    let (anchor, from, to) = (Anchor::at(pose(input)), pose::<R>(input), pose(input));
    let step = bonds.step(&set, &anchor, &to);
    input.finite("friction on bonds", parts(&step.friction))?;
    let mut together = [Projection {
        wrench: step.friction,
        region: Region::Inside,
    }];
    set.project_each(&[step.friction], radius, &mut together);
    let alone = set.project_with_length(&step.friction, radius);
    for (a, b) in parts(&together[0].wrench)
        .into_iter()
        .zip(parts(&alone.wrench))
    {
        input.holds(
            a == b || a.is_nan() && b.is_nan(),
            "projections together",
            &[a, b],
        )?;
    }
    let is_kept = step.anchor == anchor || step.grip != StickSlip::Stick;
    input.holds(
        is_kept,
        "bonds that hold keep their anchor",
        &[step.dissipated],
    )?;
    input.give(moves(&step.anchor.pose.since(&from)));
    input.give(moves(&step.slip));
    if to.angle.is_nan() {
        input.all_nan("friction on bonds", parts(&step.friction))?;
    }
    let stored = bonds.stored_energy(&anchor, &to);
    input.holds(
        stored >= R::ZERO || stored.is_nan(),
        "bonds store energy",
        &[stored],
    )?;
    let strain = displacement(input);
    let moved = displacement(input);
    let strained = Anchor::with_deflection(&to, &strain);
    input.give(moves(&strained.deflection(&from.moved(&moved))));
    input.give([moved.work(&step.friction)]);
    judged(input, &bonds.advance(&set, &strain, &moved))?;
    let (breakaway, exponent) = (input.unit::<R>(), input.positive());
    let gradual = MicroslipPresliding::new(bonds, breakaway, exponent);
    if let Ok(gradual) = input.taken(gradual) {
        judged(input, &gradual.advance(&set, &strain, &moved))?;
        let kept = [gradual.breakaway(), gradual.exponent()];
        let is_kept = kept == [breakaway, exponent] && *gradual.bonds() == bonds;
        input.holds(is_kept, "parameters are kept", &kept)?;
        let step = gradual.step(&set, &anchor, [&from, &to]);
        input.finite("friction on soft bonds", parts(&step.friction))?;
    }
    let push = wrench::<R>(input);
    let under = bonds.strain_under(&push);
    let stiffness = [bonds.stiffness(), bonds.torsional_stiffness()];
    input.finite("strain under a push", [under.shift.x, under.turn])?;
    input.holds(
        stiffness.iter().all(|k| *k > R::ZERO),
        "stiffness is positive",
        &stiffness,
    )?;
    input.holds(
        set.strength() > R::ZERO,
        "strength is positive",
        &[set.strength()],
    )?;
    let answer = StictionBounds::of(&set, &base, &push);
    input.give_bits(answer.stiction as u64);
    let is_nan = parts(&push).iter().any(|x| x.is_nan());
    let is_fine = !is_nan || answer.stiction == Stiction::Undecided;
    input.holds(is_fine, "NaN is undecided", &parts(&push))?;
    let (held, slips) = (answer.certain_scale(), answer.possible_scale());
    input.holds(
        held >= R::ZERO || held.is_nan(),
        "scales are not negative",
        &[held, slips],
    )?;
    asked(input, &set, &push)?;
    on_bonds(input, &bonds, &set, &push)
}

/// A set of some strength: the surface above a push, and the push that moves back.
fn asked<R: Real>(input: &mut Input<'_>, set: &impl FrictionSet<R>, push: &Wrench<R>) -> Verdict {
    let motion = twist(input);
    input.finite("friction of a set", parts(&set.wrench(&motion)))?;
    input.give([set.support(&motion), set.gauge(push), set.radius()]);
    let normal = set.twist_normal_to(push);
    let resisted = set.twist_resisted_by(push);
    let is_opposite = resisted == -normal || normal.spin.is_nan();
    input.holds(
        is_opposite,
        "friction opposes",
        &[normal.spin, resisted.spin],
    )?;
    let on = set.scale_to_surface(push);
    input.finite("normal of a set", rates(&normal))?;
    if input.is_mild() && set.force_limit() > R::ZERO {
        input.finite("surface of a set", parts(&on))?;
    }
    let kept = set.gauge(&set.project(push).wrench);
    let most = R::ONE + R::from_f64(1e-3);
    let is_fair = input.is_mild() && set.force_limit() > R::ZERO;
    input.holds(
        !is_fair || kept <= most,
        "what is projected is inside",
        &[kept],
    )
}

fn judged<R: Real>(input: &mut Input<'_>, end: &Settled<R>) -> Verdict {
    input.finite("settled friction", parts(&end.friction))?;
    input.give(moves(&end.strain).into_iter().chain(moves(&end.slip)));
    input.give_bits(u64::from(end.grip == StickSlip::Stick));
    let heat = end.dissipated;
    input.holds(heat >= R::ZERO || heat.is_nan(), "slip dissipates", &[heat])
}

/// A body on the bonds, over several steps: finite, and no loss is negative.
fn on_bonds<R: Real>(
    input: &mut Input<'_>,
    bonds: &Presliding<R>,
    set: &impl FrictionSet<R>,
    push: &Wrench<R>,
) -> Verdict {
    let (mass, inertia, dt) = (input.positive::<R>(), input.positive(), input.positive());
    let body = input.taken(PlanarBody::new(mass, inertia))?;
    let dt = input.taken(TimeStep::new(dt))?;
    let bonds = bonds.with_damping(input.size(), input.size());
    let bonds = input.taken(bonds)?;
    input.give(bonds.damping());
    let mut state = ElasticState {
        twist: twist(input),
        ..ElasticState::at_rest(pose(input))
    };
    for _ in 0..STEPS {
        let step = body.step_elastic(&bonds, set, &state, push, dt);
        input.finite("a step on bonds", parts(&step.friction))?;
        let next = step.state;
        input.give(rates(&next.twist).into_iter().chain(moves(&step.slip)));
        input.give(moves(&next.pose.since(&state.pose)));
        input.give(moves(&next.anchor.pose.since(&state.pose)));
        let lost = [step.slip_heat, step.damping_heat, step.rule_loss];
        let all = [lost[0], lost[1], lost[2], step.lost_energy()];
        let none_below_zero = all.iter().all(|x| *x >= R::ZERO || x.is_nan());
        input.holds(none_below_zero, "no loss is negative", &all)?;
        state = next;
    }
    Ok(())
}

/// Points that let go one after the other.
fn points<R: Real>(input: &mut Input<'_>) -> Verdict {
    let nodes = Nodes::new([(); POINTS].map(|()| node::<R>(input)));
    let nodes = input.taken(nodes)?;
    let (stiffness, limit) = (input.positive(), input.size());
    let start = pose(input);
    let mut bound = input.taken(PointPresliding::<R, _, POINTS>::new(
        nodes, stiffness, limit, &start,
    ))?;
    for _ in 0..STEPS {
        let step = bound.step(&pose(input));
        input.finite("friction of points", parts(&step.friction))?;
        let (heat, stored) = (step.dissipated, bound.stored_energy(&start));
        let are_valid = [heat, stored].iter().all(|x| *x >= R::ZERO || x.is_nan());
        input.holds(are_valid, "points dissipate", &[heat, stored])?;
        let (reach, weight) = (bound.reach(), bound.patch().total_weight());
        let is_kept = bound.force_limit() / bound.stiffness() == reach;
        input.holds(
            is_kept && reach >= R::ZERO && weight > R::ZERO,
            "points reach",
            &[reach, weight],
        )?;
        input.give_bits(step.slipping as u64);
        let limit = input.size();
        if input.taken(bound.set_force_limit(limit)).is_err() {
            bound.anchor_at(&start);
        }
    }
    Ok(())
}
