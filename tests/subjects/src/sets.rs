//! Limit surfaces and ellipsoids: gauge, support, projection.

use super::couplings::inner_ratio;
use super::planes::{dissipates, parts, rates, twist, wrench};
use crate::input::{accuracy, rounding};
use crate::{Input, Verdict};
use tribos_core::coupling::coulomb::{
    CoulombDisk, CoulombHertz, CoulombParaboloid, CoulombPunch, CoulombRing,
};
use tribos_core::coupling::{Annulus, DryProfile, DryReducedFriction, WornAnnulus};
use tribos_core::limit_surface::{
    FrictionSet, LimitEllipsoid, Projection, Region, RoundLimitSurface,
};
use tribos_core::real::Real;
use tribos_core::twist::{Twist, Wrench};

/// Wrenches of a batch: more than go side by side.
const BATCH: usize = 11;

/// One set and one query.
pub fn sets<R: Real>(input: &mut Input<'_>) -> Verdict {
    let (force, radius) = (input.size::<R>(), input.positive::<R>());
    match input.below(8) {
        0 => {
            let set = input.taken(RoundLimitSurface::new(CoulombHertz, force, radius))?;
            round(input, &set)
        }
        1 => {
            let set = input.taken(RoundLimitSurface::new(CoulombRing, force, radius))?;
            round(input, &set)
        }
        2 => {
            let set = input.taken(RoundLimitSurface::new(CoulombPunch, force, radius))?;
            round(input, &set)
        }
        3 => {
            let set = LimitEllipsoid::new(force, radius, input.positive());
            let set = input.taken(set)?;
            input.finite("torque limit", [set.torque_limit()])?;
            asked(input, &set)
        }
        4 => rare(input, force, radius),
        _ => {
            let set = input.taken(RoundLimitSurface::new(CoulombDisk, force, radius))?;
            round(input, &set)
        }
    }
}

/// Surfaces of tiers that other sets stand for.
fn rare<R: Real>(input: &mut Input<'_>, force: R, radius: R) -> Verdict {
    match input.below(4) {
        3 => {
            let ratio = inner_ratio(input);
            let worn = input.taken(WornAnnulus::new(ratio))?;
            let set = input.taken(RoundLimitSurface::new(worn, force, radius))?;
            round(input, &set)
        }
        0 => {
            let set = input.taken(RoundLimitSurface::new(CoulombParaboloid, force, radius))?;
            round(input, &set)
        }
        1 => {
            let dry = input.taken(DryProfile::new::<R>(CoulombHertz))?;
            let set = input.taken(RoundLimitSurface::new(dry, force, radius))?;
            round(input, &set)
        }
        _ => {
            let ratio = inner_ratio(input);
            let band = input.taken(Annulus::new(CoulombDisk, ratio))?;
            let set = input.taken(RoundLimitSurface::new(band, force, radius))?;
            round(input, &set)
        }
    }
}

/// A round patch: one query, and a batch of them.
fn round<R: Real, C: DryReducedFriction<R>>(
    input: &mut Input<'_>,
    set: &RoundLimitSurface<R, C>,
) -> Verdict {
    asked(input, set)?;
    let inner = input.taken(set.ellipsoid());
    input.give(
        inner
            .map(|inner| inner.torque_limit())
            .into_iter()
            .chain([set.torque_limit()]),
    );
    input.give(set.curve_numbers().powers.into_iter().flatten());
    let (pushes, length) = ([(); BATCH].map(|()| wrench(input)), input.positive());
    let loads = [(); BATCH].map(|()| input.size::<R>());
    let mut gauges = [R::NAN; BATCH];
    let mut motions = [Twist::ZERO; BATCH];
    let mut nearest = pushes.map(|wrench| Projection {
        wrench,
        region: Region::Inside,
    });
    set.gauge_batch(&loads, &pushes, &mut gauges);
    set.twist_normal_to_batch(&pushes, &mut motions);
    set.project_batch(length, &loads, &pushes, &mut nearest);
    for at in 0..BATCH {
        let (push, limit) = (&pushes[at], set.force_limit() * loads[at]);
        let Ok(alone) = RoundLimitSurface::new(set.coupling(), limit, set.radius()) else {
            continue;
        };
        is_same_projection(
            input,
            &nearest[at],
            &alone.project_with_length(push, length),
        )?;
        let [together, singly] =
            [motions[at], set.twist_normal_to(push)].map(|motion| rates(&motion));
        let gauge = (gauges[at], alone.gauge(push));
        for (a, b) in together.into_iter().zip(singly).chain([gauge]) {
            is_same(input, [a, b])?;
        }
    }
    Ok(())
}

fn is_same<R: Real>(input: &mut Input<'_>, [a, b]: [R; 2]) -> Verdict {
    let is_same = a == b || a.is_nan() && b.is_nan();
    input.holds(is_same, "a batch answers as one call", &[a, b])
}

/// Wrench, region and normal.
fn is_same_projection<R: Real>(
    input: &mut Input<'_>,
    together: &Projection<R>,
    alone: &Projection<R>,
) -> Verdict {
    let normal = |projection: &Projection<R>| match projection.region {
        Region::Inside => [R::ZERO; 3],
        Region::OnSurface { normal } => rates(&normal),
    };
    for (a, b) in parts(&together.wrench)
        .into_iter()
        .zip(parts(&alone.wrench))
    {
        is_same(input, [a, b])?;
    }
    for (a, b) in normal(together).into_iter().zip(normal(alone)) {
        is_same(input, [a, b])?;
    }
    Ok(())
}

pub fn asked<R: Real, S: FrictionSet<R>>(input: &mut Input<'_>, set: &S) -> Verdict {
    let motion = twist::<R>(input);
    let (power, met) = (set.support(&motion), set.wrench(&motion));
    input.finite("support", [power])?;
    input.holds(
        power >= R::ZERO || !input.is_mild(),
        "support ≥ 0",
        &[power],
    )?;
    dissipates(input, &met, &motion)?;

    let push = if input.one_in(3) { met } else { wrench(input) };
    let all = parts(&push);
    let [x, y, torque] = all;
    let gauge = set.gauge(&push);
    input.give_bits(u64::from(set.contains(&push)));
    if all.iter().any(|x| x.is_nan()) {
        return input.holds(gauge.is_nan(), "NaN has no gauge", &[x, y, torque, gauge]);
    }
    let is_fine = gauge >= R::ZERO || !all.iter().all(|x| x.is_finite());
    input.holds(is_fine, "gauge ≥ 0", &[x, y, torque, gauge])?;
    input.give(rates(&set.twist_normal_to(&push)));
    let resisted = set.twist_resisted_by(&push);
    let surface = set.scale_to_surface(&push);
    let length = if input.one_in(2) {
        set.radius()
    } else {
        input.positive()
    };
    input.give(parts(&set.project(&push).wrench));
    let near = set.project_with_length(&push, length);
    // Whole groups, and what remains of the slices.
    let mut together = [near; BATCH];
    set.project_each(&[push; BATCH], length, &mut together);
    for one in &together {
        is_same_projection(input, one, &near)?;
    }
    if set.force_limit() > R::ZERO {
        input.finite("gauge", [gauge])?;
        input.finite("normal", rates(&resisted))?;
        input.finite("radial wrench", parts(&surface))?;
    }
    input.finite("projection", parts(&near.wrench))?;
    if let Region::OnSurface { normal } = near.region {
        input.give(rates(&normal));
    }
    if near.region == Region::Inside {
        input.holds(near.wrench == push, "inside nothing changes", &all)?;
    } else if input.is_mild() && set.force_limit() > R::ZERO {
        let gauge = set.gauge(&near.wrench);
        // The surface of a slender shape is wider.
        let is_in = gauge <= R::ONE + rounding::<R>() || set.contains(&near.wrench);
        let what = "a projection lies in the set";
        input.holds(is_in, what, &[gauge, R::ONE, R::ONE])?;
    }
    if input.is_mild() && set.force_limit() > R::ZERO {
        balanced(input, &motion, &met, power)?;
        tangent(input, &-resisted, &surface, &met)?;
        let (arm, widest) = (length / set.radius(), widest::<R>());
        if arm * widest >= R::ONE && arm <= widest {
            nearest(input, [&push, &near.wrench, &met], length)?;
        }
    }
    Ok(())
}

/// Radii up to which, as a length, the nearest wrench is promised of shapes; down to its reciprocal.
fn widest<R: Real>() -> R {
    R::from_f64(if size_of::<R>() == 4 { 10.0 } else { 1e6 })
}

/// Power of a wrench on a motion, and the sum of its parts' magnitudes.
fn powers<R: Real>(motion: &Twist<R>, wrench: &Wrench<R>) -> [R; 2] {
    let ([vx, vy, spin], [fx, fy, torque]) = (rates(motion), parts(wrench));
    let all = [vx * fx, vy * fy, spin * torque];
    [
        all[0] + all[1] + all[2],
        all[0].abs() + all[1].abs() + all[2].abs(),
    ]
}

/// Friction dissipates the support.
fn balanced<R: Real>(
    input: &mut Input<'_>,
    motion: &Twist<R>,
    met: &Wrench<R>,
    power: R,
) -> Verdict {
    let [gained, scale] = powers(motion, met);
    let apart = (power + gained).abs();
    input.accurate("friction dissipates the support", apart, R::ZERO, scale)
}

/// No wrench of the set, whose mirror image is in it as well, is beyond the tangent plane where a ray meets the
/// surface.
fn tangent<R: Real>(
    input: &mut Input<'_>,
    normal: &Twist<R>,
    surface: &Wrench<R>,
    met: &Wrench<R>,
) -> Verdict {
    let ([whole, scale], [part, more]) = (powers(normal, surface), powers(normal, met));
    let what = "the set is on one side of a tangent plane";
    input.accurate(what, part.abs(), whole, scale + more)
}

/// Seen from the nearest wrench, every wrench of the set is on the other side than the wanted one.
fn nearest<R: Real>(
    input: &mut Input<'_>,
    [push, near, met]: [&Wrench<R>; 3],
    length: R,
) -> Verdict {
    let scaled = |wrench: &Wrench<R>| {
        let [fx, fy, torque] = parts(wrench);
        [fx, fy, torque / length]
    };
    let ([a, b, c], p, z) = (scaled(push), scaled(near), scaled(met));
    let away = [a - p[0], b - p[1], c - p[2]];
    let dot = |u: [R; 3], w: [R; 3]| u[0] * w[0] + u[1] * w[1] + u[2] * w[2];
    let size = |u: [R; 3]| u[0].abs() + u[1].abs() + u[2].abs();
    // What is left of rounding has no direction.
    if size(away) <= accuracy::<R>() * size([a, b, c]) {
        return Ok(());
    }
    let scale = size(away) * (size(p) + size(z));
    input.accurate(
        "a projection is the nearest",
        dot(away, z).abs(),
        dot(away, p),
        scale,
    )
}
