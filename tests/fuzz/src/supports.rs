//! Supports of unknown pressure: sound bounds, whatever corners, centre and force.

use super::check::{finite, holds};
use super::planes::{dissipates, twist, wrench};
use super::{Broken, Source};
use tribos_core::limit_surface::UnknownPressureSet;
use tribos_core::real::Real;

/// Up to five corners, at times on a line, with the centre among them or anywhere.
pub fn supports<R: Real>(source: &mut Source) -> Result<(), Broken> {
    let size = source.ordinary::<R>();
    let is_flat = source.one_in(4);
    let corner = |source: &mut Source| {
        let x = size * R::from_f64(2.0 * source.unit::<f64>() - 1.0);
        let y = size * R::from_f64(2.0 * source.unit::<f64>() - 1.0);
        if is_flat { [x, R::TWO * x] } else { [x, y] }
    };
    let all = [(); 5].map(|()| corner(source));
    let corners = &all[..source.below(6)];
    let centre = match source.below(4) {
        0 => [source.number(), source.number()],
        1 => all[source.below(5)],
        _ => {
            let part = R::from_f64(1.0 / corners.len().max(1) as f64);
            let sum = |axis: usize| {
                let sum = corners.iter().fold(R::ZERO, |sum, at| sum + at[axis]);
                sum * part
            };
            [sum(0), sum(1)]
        }
    };
    let limit = source.size::<R>();
    let Ok(foot) = UnknownPressureSet::new(corners, centre, limit) else {
        return Ok(());
    };
    let at = foot.centre();
    holds(
        foot.force_limit() == limit.abs(),
        "the force limit",
        &[limit],
    )?;
    holds(
        at.x == centre[0] && at.y == centre[1],
        "the centre of pressure",
        &centre,
    )?;
    let motion = twist::<R>(source);
    let power = foot.support(&motion);
    holds(
        power >= R::ZERO || !source.is_mild(),
        "support ≥ 0",
        &[power],
    )?;
    finite(source, "support", [power])?;
    dissipates(source, &foot.wrench(&motion), &motion)?;
    let push = wrench::<R>(source);
    let [least, most] = foot.gauge_bounds(&push);
    let parts = [push.force.x, push.force.y, push.torque];
    if parts.iter().any(|x| x.is_nan()) {
        return holds(least.is_nan(), "NaN has no gauge", &[least, most]);
    }
    let is_finite = parts.iter().all(|x| x.is_finite());
    let slack = R::ONE + R::from_f64(1024.0) * R::EPSILON;
    holds(
        least <= most * slack || !(is_finite && source.is_mild()),
        "a lower and an upper gauge",
        &[least, most],
    )?;
    // A part of the largest force, or any.
    let force = if source.one_in(2) {
        [(); 2].map(|()| limit * R::from_f64(1.4 * source.unit::<f64>() - 0.7))
    } else {
        [push.force.x, push.force.y]
    };
    let Some(yaw) = foot.torque_limits(force) else {
        return Ok(());
    };
    let ([low, high], [lower, higher]) = (yaw.certain, yaw.possible);
    let unit = limit * (foot.radius() + at.x.abs() + at.y.abs());
    let rounding = R::from_f64(1024.0) * R::EPSILON * unit;
    let is_ordered = lower <= low + rounding && low <= high && high <= higher + rounding;
    holds(
        is_ordered || !source.is_mild(),
        "torques in their order",
        &[lower, low, high, higher],
    )
}
