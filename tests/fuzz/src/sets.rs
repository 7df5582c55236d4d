//! Limit surfaces and ellipsoids: gauge, support, projection.

use super::check::{at_most, finite, holds};
use super::planes::{dissipates, twist, wrench};
use super::{Broken, Source};
use tribos_core::coupling::DryReducedFriction;
use tribos_core::coupling::closed::{CoulombHertz, CoulombPunch, CoulombRing};
use tribos_core::coupling::table::CoulombDisk;
use tribos_core::limit_surface::{
    FrictionSet, LimitEllipsoid, Projection, Region, RoundLimitSurface,
};
use tribos_core::real::Real;
use tribos_core::twist::Twist;

/// Wrenches of a batch: more than go side by side.
const BATCH: usize = 11;

/// One set and one query.
pub fn sets(source: &mut Source) -> Result<(), Broken> {
    if source.one_in(2) {
        of::<f64>(source)
    } else {
        of::<f32>(source)
    }
}

fn of<R: Real>(source: &mut Source) -> Result<(), Broken> {
    let (force, radius) = (source.size::<R>(), source.positive::<R>());
    match source.below(6) {
        0 => RoundLimitSurface::new(CoulombHertz, force, radius)
            .map_or(Ok(()), |set| round(source, &set)),
        1 => RoundLimitSurface::new(CoulombRing, force, radius)
            .map_or(Ok(()), |set| asked(source, &set)),
        2 => RoundLimitSurface::new(CoulombPunch, force, radius)
            .map_or(Ok(()), |set| asked(source, &set)),
        3 => {
            let set = LimitEllipsoid::new(force, radius, source.positive());
            set.map_or(Ok(()), |set| asked(source, &set))
        }
        _ => RoundLimitSurface::new(CoulombDisk, force, radius)
            .map_or(Ok(()), |set| round(source, &set)),
    }
}

/// A round patch: one query, and a batch of them.
fn round<R: Real, C: DryReducedFriction<R>>(
    source: &mut Source,
    set: &RoundLimitSurface<R, C>,
) -> Result<(), Broken> {
    asked(source, set)?;
    let (pushes, length) = ([(); BATCH].map(|()| wrench(source)), source.positive());
    let loads = [(); BATCH].map(|()| source.size::<R>());
    let mut gauges = [R::NAN; BATCH];
    let mut motions = [Twist::ZERO; BATCH];
    let mut nearest = pushes.map(|wrench| Projection {
        wrench,
        region: Region::Inside,
    });
    set.gauge_batch(&loads, &pushes, &mut gauges);
    set.twist_normal_to_batch(&pushes, &mut motions);
    set.project_batch(length, &loads, &pushes, &mut nearest);
    for (load, (push, (gauge, near))) in loads
        .iter()
        .zip(pushes.iter().zip(gauges.iter().zip(nearest)))
    {
        let Ok(alone) =
            RoundLimitSurface::new(set.coupling(), set.force_limit() * *load, set.radius())
        else {
            continue;
        };
        let one = alone.project_with_length(push, length).wrench;
        let answers = [
            [near.wrench.force.x, one.force.x],
            [near.wrench.force.y, one.force.y],
            [near.wrench.torque, one.torque],
            [*gauge, alone.gauge(push)],
        ];
        for [a, b] in answers {
            let is_same = a == b || a.is_nan() && b.is_nan();
            holds(is_same, "a batch answers as one call", &[a, b])?;
        }
    }
    Ok(())
}

pub fn asked<R: Real, S: FrictionSet<R>>(source: &mut Source, set: &S) -> Result<(), Broken> {
    let motion = twist::<R>(source);
    let (power, met) = (set.support(&motion), set.wrench(&motion));
    finite(source, "support", [power])?;
    holds(
        power >= R::ZERO || !source.is_mild(),
        "support ≥ 0",
        &[power],
    )?;
    dissipates(source, &met, &motion)?;

    let push = if source.one_in(3) {
        met
    } else {
        wrench(source)
    };
    let parts = [push.force.x, push.force.y, push.torque];
    let gauge = set.gauge(&push);
    if parts.iter().any(|x| x.is_nan()) {
        return holds(
            gauge.is_nan(),
            "NaN has no gauge",
            &[parts[0], parts[1], parts[2], gauge],
        );
    }
    let is_finite = parts.iter().all(|x| x.is_finite());
    holds(
        gauge >= R::ZERO || !is_finite,
        "gauge ≥ 0",
        &[parts[0], parts[1], parts[2], gauge],
    )?;
    let resisted = set.twist_resisted_by(&push);
    let surface = set.scale_to_surface(&push);
    let length = if source.one_in(2) {
        set.radius()
    } else {
        source.positive()
    };
    let near = set.project_with_length(&push, length);
    if set.force_limit() > R::ZERO {
        finite(source, "gauge", [gauge])?;
        finite(
            source,
            "normal",
            [resisted.velocity.x, resisted.velocity.y, resisted.spin],
        )?;
        finite(
            source,
            "radial wrench",
            [surface.force.x, surface.force.y, surface.torque],
        )?;
    }
    finite(
        source,
        "projection",
        [near.wrench.force.x, near.wrench.force.y, near.wrench.torque],
    )?;
    if near.region == Region::Inside {
        holds(near.wrench == push, "inside nothing changes", &parts)?;
    } else if source.is_mild() && set.force_limit() > R::ZERO {
        at_most(
            "a projection lies in the set",
            set.gauge(&near.wrench),
            R::ONE,
            R::ONE,
        )?;
    }
    Ok(())
}
