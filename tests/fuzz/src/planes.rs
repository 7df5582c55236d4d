//! Wrenches in the plane, implicit steps, feet of many points.

use super::check::{all_nan, at_most, finite, holds};
use super::patches::node;
use super::{Broken, Source};
use tribos_core::contact::TimeStep;
use tribos_core::coupling::closed::CoulombHertz;
use tribos_core::coupling::load_transfer::{
    FullGradient, LoadTransferFriction, LongitudinalGradient, PressureGradient,
};
use tribos_core::coupling::nodes::NodeFriction;
use tribos_core::coupling::table::CoulombDisk;
use tribos_core::coupling::{LateralFriction, RoundFriction};
use tribos_core::law::PowerLaw;
use tribos_core::limit_surface::{LimitEllipsoid, RoundLimitSurface};
use tribos_core::patch::nodes::Nodes;
use tribos_core::planar::{PlanarBody, PointContacts};
use tribos_core::real::Real;
use tribos_core::twist::{Twist, Wrench};

/// Points of a foot.
const POINTS: usize = 5;

pub fn twist<R: Real>(source: &mut Source) -> Twist<R> {
    Twist::new(source.number(), source.number(), source.number())
}

pub fn wrench<R: Real>(source: &mut Source) -> Wrench<R> {
    Wrench::new(source.number(), source.number(), source.number())
}

/// Friction dissipates: its power on a mild motion is not positive.
pub fn dissipates<R: Real>(
    source: &Source,
    friction: &Wrench<R>,
    motion: &Twist<R>,
) -> Result<(), Broken> {
    finite(
        source,
        "friction",
        [friction.force.x, friction.force.y, friction.torque],
    )?;
    if !source.is_mild() {
        return Ok(());
    }
    let parts = [
        friction.force.x * motion.velocity.x,
        friction.force.y * motion.velocity.y,
        friction.torque * motion.spin,
    ];
    let scale = parts.iter().fold(R::ZERO, |sum, part| sum + part.abs());
    at_most(
        "friction's power ≤ 0",
        parts[0] + parts[1] + parts[2],
        R::ZERO,
        scale,
    )
}

/// Moving patches, upright and tall, and points.
pub fn planes(source: &mut Source) -> Result<(), Broken> {
    match source.below(5) {
        0 => upright::<f64>(source),
        1 => upright::<f32>(source),
        2 => tall::<f64, _, FullGradient>(source, CoulombDisk),
        3 => tall::<f32, _, LongitudinalGradient>(source, CoulombHertz),
        _ => points(source),
    }
}

fn upright<R: Real>(source: &mut Source) -> Result<(), Broken> {
    let Ok(puck) = RoundFriction::<R, _>::new(CoulombDisk, source.size(), source.positive()) else {
        return Ok(());
    };
    let (load, motion) = (source.size(), twist::<R>(source));
    let friction = puck.wrench(load, &motion);
    let jacobian = puck.wrench_jacobian(load, &motion);
    let all = [motion.velocity.x, motion.velocity.y, motion.spin];
    if all.iter().any(|x| x.is_nan()) {
        all_nan(
            "wrench",
            [friction.force.x, friction.force.y, friction.torque],
        )?;
    }
    if motion.speed() > R::ZERO
        && motion.spin.abs() > R::ZERO
        && motion.speed() != motion.spin.abs() * puck.radius()
    {
        finite(source, "Jacobian of a wrench", jacobian.iter().copied())?;
    }
    dissipates(source, &friction, &motion)
}

fn tall<R: Real, C: LateralFriction<R>, L: PressureGradient>(
    source: &mut Source,
    coupling: C,
) -> Result<(), Broken> {
    let Ok(foot) = RoundFriction::new(coupling, source.size::<R>(), source.positive()) else {
        return Ok(());
    };
    let Ok(body) = LoadTransferFriction::<R, C, L>::new(foot, source.size()) else {
        return Ok(());
    };
    let (load, motion) = (source.size(), twist::<R>(source));
    let got = body.wrench(load, &motion);
    let whole = got.whole().is_ok();
    if motion.velocity.x.is_nan() || motion.spin.is_nan() {
        return holds(!whole, "NaN lifts", &[got.lean.x]);
    }
    finite(source, "lean", [got.lean.x, got.lean.y])?;
    dissipates(source, &got.wrench, &motion)
}

fn points(source: &mut Source) -> Result<(), Broken> {
    let Ok(nodes) = Nodes::new([(); POINTS].map(|()| node::<f64>(source))) else {
        return Ok(());
    };
    let Ok(law) = PowerLaw::new(source.one_of(&[-0.5, 0.0, 0.5, 1.0, 2.0]), source.size()) else {
        return Ok(());
    };
    let friction = NodeFriction::new(law, nodes);
    let (load, motion) = (source.size(), twist(source));
    let wrench = friction.wrench(load, &motion);
    let jacobian = friction.wrench_jacobian(load, &motion);
    if law.alpha() >= 0.0 && source.is_mild() {
        holds(
            jacobian.iter().all(|x| !x.is_nan()),
            "a Jacobian of numbers",
            &[motion.spin],
        )?;
    }
    dissipates(source, &wrench, &motion)
}

/// Implicit steps on sets.
pub fn steps(source: &mut Source) -> Result<(), Broken> {
    match source.below(4) {
        0 => step_on_surface::<f64>(source),
        1 => step_on_surface::<f32>(source),
        _ => step_on_ellipsoid(source),
    }
}

fn step_on_surface<R: Real>(source: &mut Source) -> Result<(), Broken> {
    let Ok(set) = RoundLimitSurface::new(CoulombDisk, source.size::<R>(), source.positive()) else {
        return Ok(());
    };
    stepped(source, |body, twist, push, dt| {
        body.step(&set, twist, push, dt)
    })
}

fn step_on_ellipsoid(source: &mut Source) -> Result<(), Broken> {
    let (force, radius, torque) = (source.size::<f64>(), source.positive(), source.positive());
    let Ok(set) = LimitEllipsoid::new(force, radius, torque) else {
        return Ok(());
    };
    stepped(source, |body, twist, push, dt| {
        body.step(&set, twist, push, dt)
    })
}

/// A step is finite, and without a push it does not raise the kinetic energy.
pub fn stepped<R: Real>(
    source: &mut Source,
    mut step: impl FnMut(
        &PlanarBody<R>,
        &Twist<R>,
        &Wrench<R>,
        TimeStep<R>,
    ) -> tribos_core::planar::PlanarStep<R>,
) -> Result<(), Broken> {
    let (mass, inertia, dt) = (source.positive::<R>(), source.positive(), source.positive());
    let (Ok(body), Ok(dt)) = (PlanarBody::new(mass, inertia), TimeStep::new(dt)) else {
        return Ok(());
    };
    let before = twist::<R>(source);
    let is_free = source.one_in(2);
    let push = if is_free {
        Wrench::ZERO
    } else {
        wrench(source)
    };
    let after = step(&body, &before, &push, dt);
    let all = [
        after.twist.velocity.x,
        after.twist.velocity.y,
        after.twist.spin,
    ];
    finite(source, "a step", all)?;
    if after.is_at_rest {
        holds(after.twist == Twist::ZERO, "rest is exact", &all)?;
    }
    if is_free && source.is_mild() {
        let energy = |u: &Twist<R>| {
            mass * (u.velocity.x * u.velocity.x + u.velocity.y * u.velocity.y)
                + inertia * u.spin * u.spin
        };
        // A projection is accurate to 1e-8 of the wrench (f32: 1e-5).
        let slack = R::from_f64(if size_of::<R>() == 4 { 1e-4 } else { 1e-7 });
        let (was, is) = (energy(&before), energy(&after.twist));
        holds(is <= was + slack * was, "energy falls", &[was, is])?;
    }
    Ok(())
}

/// Feet of many points: the forces that they carry, and steps on them.
pub fn feet(source: &mut Source) -> Result<(), Broken> {
    if source.one_in(2) {
        foot::<f64>(source)
    } else {
        foot::<f32>(source)
    }
}

fn foot<R: Real>(source: &mut Source) -> Result<(), Broken> {
    let Ok(nodes) = Nodes::new([(); POINTS].map(|()| node::<R>(source))) else {
        return Ok(());
    };
    let Ok(mut foot) = PointContacts::<R, _, POINTS>::new(nodes, source.size()) else {
        return Ok(());
    };
    if source.one_in(2) {
        return stepped(source, |body, twist, push, dt| {
            body.step_on_points(&mut foot, twist, push, dt)
        });
    }
    let (wanted, length) = (wrench::<R>(source), source.positive::<R>());
    let near = foot.nearest(&wanted, length);
    let all = [near.force.x, near.force.y, near.torque];
    if wanted.force.x.is_nan() || wanted.torque.is_nan() {
        all_nan("nearest wrench", all)?;
    }
    finite(source, "nearest wrench", all)
}
