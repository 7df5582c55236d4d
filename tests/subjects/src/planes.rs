//! Wrenches in the plane, implicit steps, feet of many points.

use super::couplings::EXPONENTS;
use super::patches::node;
use crate::input::accuracy;
use crate::{Input, Verdict};
use nalgebra::Vector3;
use tribos_core::contact::TimeStep;
use tribos_core::coupling::compact::CompactPower;
use tribos_core::coupling::coulomb::CoulombDisk;
use tribos_core::coupling::coulomb::CoulombHertz;
use tribos_core::coupling::load_transfer::{
    FullGradient, LoadTransferFriction, LongitudinalGradient, PressureGradient,
};
use tribos_core::coupling::nodes::NodeFriction;
use tribos_core::coupling::{LateralFriction, RoundFriction};
use tribos_core::internals::leaning_wrench;
use tribos_core::law::{PowerLaw, RestTime};
use tribos_core::limit_surface::{LimitEllipsoid, RoundLimitSurface};
use tribos_core::patch::nodes::{NodePatch, Nodes};
use tribos_core::planar::{PlanarBody, PlanarStep, PointContacts};
use tribos_core::real::Real;
use tribos_core::twist::{Twist, Wrench};

/// Points of a foot.
const POINTS: usize = 5;
/// Steps on a foot, which keeps its forces.
const STEPS: usize = 3;

pub fn twist<R: Real>(input: &mut Input<'_>) -> Twist<R> {
    Twist::new(input.number(), input.number(), input.number())
}

pub fn wrench<R: Real>(input: &mut Input<'_>) -> Wrench<R> {
    Wrench::new(input.number(), input.number(), input.number())
}

/// The components of a wrench.
pub fn parts<R: Real>(of: &Wrench<R>) -> [R; 3] {
    [of.force.x, of.force.y, of.torque]
}

/// The components of a twist.
pub fn rates<R: Real>(of: &Twist<R>) -> [R; 3] {
    [of.velocity.x, of.velocity.y, of.spin]
}

/// Friction dissipates: its power on a mild motion is not positive.
pub fn dissipates<R: Real>(
    input: &mut Input<'_>,
    friction: &Wrench<R>,
    motion: &Twist<R>,
) -> Verdict {
    input.finite("friction", parts(friction))?;
    if !input.is_mild() {
        return Ok(());
    }
    let powers = [
        friction.force.x * motion.velocity.x,
        friction.force.y * motion.velocity.y,
        friction.torque * motion.spin,
    ];
    let scale = powers.iter().fold(R::ZERO, |sum, part| sum + part.abs());
    input.at_most(
        "friction's power ≤ 0",
        powers[0] + powers[1] + powers[2],
        R::ZERO,
        scale,
    )
}

/// Moving patches, upright and tall, and points.
pub fn planes<R: Real>(input: &mut Input<'_>) -> Verdict {
    match input.below(6) {
        0 | 1 => upright::<R>(input),
        2 => tall::<R, _, FullGradient>(input, CoulombDisk),
        3 => tall::<R, _, LongitudinalGradient>(input, CoulombHertz),
        4 => {
            let alpha = R::from_f64(input.one_of(&EXPONENTS));
            let power = input.taken(CompactPower::new(alpha))?;
            tall::<R, _, FullGradient>(input, power)
        }
        _ => points::<R>(input),
    }
}

fn upright<R: Real>(input: &mut Input<'_>) -> Verdict {
    let puck = RoundFriction::<R, _>::new(CoulombDisk, input.size(), input.positive());
    let puck = input.taken(puck)?;
    let (load, motion) = (input.size(), twist::<R>(input));
    let friction = puck.wrench(load, &motion);
    let jacobian = puck.wrench_jacobian(load, &motion);
    if rates(&motion).iter().any(|x| x.is_nan()) {
        input.all_nan("wrench", parts(&friction))?;
    }
    let (speed, spin) = (motion.speed(), motion.spin);
    let sizes = puck.magnitudes(load, speed, spin);
    let slopes = puck.magnitudes_jacobian(load, speed, spin);
    input.give([sizes.force, sizes.torque, slopes.force_speed]);
    input.give([slopes.force_spin, slopes.torque_speed, slopes.torque_spin]);
    input.give([puck.coefficient(), puck.coupling().mean_square_radius()]);
    let again = Twist::from(Vector3::from(motion));
    let is_same = again == motion || rates(&again).iter().any(|x| x.is_nan());
    input.holds(is_same, "a vector is the same twist", &rates(&again))?;
    input.give(jacobian.iter().copied());
    if motion.speed() > R::ZERO
        && motion.spin.abs() > R::ZERO
        && motion.speed() != motion.spin.abs() * puck.radius()
    {
        input.finite("Jacobian of a wrench", jacobian.iter().copied())?;
        let slopes = puck.magnitudes_jacobian(load, speed, spin.abs());
        let ahead = puck.wrench_jacobian(load, &Twist::new(speed, R::ZERO, spin.abs()));
        for (entry, slope) in [
            (ahead[(0, 0)], slopes.force_speed),
            (ahead[(0, 2)], slopes.force_spin),
            (ahead[(2, 0)], slopes.torque_speed),
            (ahead[(2, 2)], slopes.torque_spin),
        ] {
            if input.is_mild() {
                let (apart, scale) = ((entry + slope).abs(), entry.abs() + slope.abs());
                input.accurate("slopes of magnitudes", apart, R::ZERO, scale)?;
            }
        }
    }
    dissipates(input, &friction, &motion)
}

fn tall<R: Real, C: LateralFriction<R>, L: PressureGradient>(
    input: &mut Input<'_>,
    coupling: C,
) -> Verdict {
    let foot = RoundFriction::new(coupling, input.size::<R>(), input.positive());
    let foot = input.taken(foot)?;
    let body = LoadTransferFriction::<R, C, L>::new(foot, input.size());
    let body = input.taken(body)?;
    let (load, motion) = (input.size(), twist::<R>(input));
    let got = body.wrench(load, &motion);
    let whole = got.whole();
    input.give_bits(u64::from(got.is_lifting));
    input.give([body.lean(), body.foot().radius()]);
    let speeds = [motion.speed(), motion.spin];
    let leaning = leaning_wrench(body.foot().coupling(), speeds, [got.lean.x, got.lean.y]);
    input.give([leaning.force, leaning.lateral, leaning.torque]);
    let (balance, leans) = L::balance(body.foot().coupling(), speeds, body.lean());
    input.give([balance.force, balance.lateral, balance.torque]);
    input.give(leans);
    if motion.velocity.x.is_nan() || motion.spin.is_nan() {
        return input.holds(whole.is_err(), "NaN lifts", &[got.lean.x]);
    }
    input.give(whole.iter().flat_map(parts));
    input.finite("lean", [got.lean.x, got.lean.y])?;
    dissipates(input, &got.wrench, &motion)
}

fn points<R: Real>(input: &mut Input<'_>) -> Verdict {
    let nodes = Nodes::new([(); POINTS].map(|()| node::<R>(input)));
    let nodes = input.taken(nodes)?;
    let alpha = R::from_f64(input.one_of(&[-0.5, 0.0, 0.5, 1.0, 2.0]));
    let law = PowerLaw::new(alpha, input.size());
    let law = input.taken(law)?;
    let friction = NodeFriction::new(law, nodes);
    let (load, motion) = (input.size(), twist(input));
    let wrench = friction.wrench(load, &motion);
    let jacobian = friction.wrench_jacobian(load, &motion);
    if friction.law().alpha() >= R::ZERO && input.is_mild() {
        input.numbers("Jacobian of points", jacobian.iter().copied())?;
    }
    input.give(jacobian.iter().copied());
    input.give([friction.patch().total_weight()]);
    dissipates(input, &wrench, &motion)
}

/// Steps of a batch: as many as go side by side.
const TOGETHER: usize = 8;

/// All of a step; NaN counts as one value.
fn bits<R: Real>(step: &PlanarStep<R>) -> ([u64; 6], bool) {
    let ([x, y, spin], [fx, fy, torque]) = (rates(&step.twist), parts(&step.friction));
    let numbers = [x, y, spin, fx, fy, torque].map(|x| if x.is_nan() { R::NAN } else { x });
    (numbers.map(|x| x.to_f64().to_bits()), step.is_at_rest)
}

/// Implicit steps on sets.
pub fn steps<R: Real>(input: &mut Input<'_>) -> Verdict {
    let (force, radius) = (input.size::<R>(), input.positive());
    if input.one_in(2) {
        let set = input.taken(RoundLimitSurface::new(CoulombDisk, force, radius))?;
        let mut apart = None;
        stepped(input, |body, twist, push, dt| {
            let alone = body.step(&set, twist, push, dt);
            let blank = PlanarStep {
                is_at_rest: !alone.is_at_rest,
                ..alone
            };
            let differs = |step: &&PlanarStep<R>| bits(step) != bits(&alone);
            // Side by side with others alike.
            let (twists, pushes) = ([*twist; TOGETHER], [*push; TOGETHER]);
            let mut steps = [blank; TOGETHER];
            body.step_batch(&set, &twists, &pushes, dt, &mut steps);
            apart = steps.iter().find(differs).copied();
            // Under a load of 1 the surface is the same.
            let loads = [R::ONE; TOGETHER];
            steps = [blank; TOGETHER];
            body.step_batch_under_loads(&set, &loads, &twists, &pushes, dt, &mut steps);
            apart = apart.or(steps.iter().find(differs).copied());
            alone
        })?;
        // Nothing is given if it holds.
        apart.map_or(Ok(()), |step| {
            let same = "a batch has the bits of single steps";
            input.holds(false, same, &rates(&step.twist))
        })
    } else {
        let set = LimitEllipsoid::new(force, radius, input.positive());
        let set = input.taken(set)?;
        if input.one_in(2) {
            return stepped(input, |body, twist, push, dt| {
                body.step(&set, twist, push, dt)
            });
        }
        let strength = input.size::<R>();
        let mut rest = RestTime {
            time: input.size::<R>(),
        };
        stepped(input, |body, twist, push, dt| {
            body.step_ageing(&set, |_| strength, &mut rest, twist, push, dt)
        })?;
        input.give([rest.time]);
        Ok(())
    }
}

/// A step is finite, and without a push it does not raise the kinetic energy.
pub fn stepped<R: Real>(
    input: &mut Input<'_>,
    mut step: impl FnMut(&PlanarBody<R>, &Twist<R>, &Wrench<R>, TimeStep<R>) -> PlanarStep<R>,
) -> Verdict {
    let (mass, inertia, dt) = (input.positive::<R>(), input.positive(), input.positive());
    let body = input.taken(PlanarBody::new(mass, inertia))?;
    let dt = input.taken(TimeStep::new(dt))?;
    input.give([body.mass(), body.inertia(), body.gyration(), dt.dt()]);
    let before = twist::<R>(input);
    let is_free = input.one_in(2);
    let push = if is_free { Wrench::ZERO } else { wrench(input) };
    let after = step(&body, &before, &push, dt);
    let all = rates(&after.twist);
    input.finite("a step", all)?;
    input.give(parts(&after.friction));
    input.give_bits(u64::from(after.is_at_rest));
    if after.is_at_rest {
        input.holds(after.twist == Twist::ZERO, "rest is exact", &all)?;
    }
    if is_free && input.is_mild() {
        let energy = |u: &Twist<R>| {
            mass * (u.velocity.x * u.velocity.x + u.velocity.y * u.velocity.y)
                + inertia * u.spin * u.spin
        };
        let (was, is) = (energy(&before), energy(&after.twist));
        input.holds(
            is <= was + accuracy::<R>() * was,
            "energy falls",
            &[was, is],
        )?;
    }
    Ok(())
}

/// Feet of many points: several steps on them, or the forces that they carry before and after a release.
pub fn feet<R: Real>(input: &mut Input<'_>) -> Verdict {
    let nodes = Nodes::new([(); POINTS].map(|()| node::<R>(input)));
    let nodes = input.taken(nodes)?;
    let foot = PointContacts::<R, _, POINTS>::new(nodes, input.size());
    let mut foot = input.taken(foot)?;
    if input.one_in(2) {
        return (0..STEPS).try_for_each(|_| {
            let strength = input.size::<R>();
            stepped(input, |body, twist, push, dt| {
                if strength > R::ONE {
                    body.step_sticking_on_points(&mut foot, strength, twist, push, dt)
                } else {
                    body.step_on_points(&mut foot, twist, push, dt)
                }
            })
        });
    }
    let length = input.positive::<R>();
    carried(input, &mut foot, length)?;
    let limit = input.size();
    if input.taken(foot.set_force_limit(limit)).is_ok() {
        input.holds(foot.force_limit() == limit, "a limit is kept", &[limit])?;
    }
    carried(input, &mut foot, length)?;
    foot.release();
    carried(input, &mut foot, length)?;
    input.give([foot.patch().total_weight()]);
    Ok(())
}

/// The nearest wrench that a foot carries, with what it keeps of the last one.
fn carried<R: Real>(
    input: &mut Input<'_>,
    foot: &mut PointContacts<R, impl NodePatch<R>, POINTS>,
    length: R,
) -> Verdict {
    let wanted = Wrench::from(Vector3::from(wrench::<R>(input)));
    let near = parts(&foot.nearest(&wanted, length));
    if wanted.force.x.is_nan() || wanted.torque.is_nan() {
        input.all_nan("nearest wrench", near)?;
    }
    input.finite("nearest wrench", near)
}
