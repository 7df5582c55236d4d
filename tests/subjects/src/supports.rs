//! Supports of unknown pressure: sound bounds, whatever corners, centre and force.

use super::planes::{dissipates, twist, wrench};
use crate::{Input, Verdict};
use tribos_core::limit_surface::UnknownPressureSet;
use tribos_core::real::Real;

/// Up to five corners, at times on a line, with the centre among them or anywhere.
pub fn supports<R: Real>(input: &mut Input<'_>) -> Verdict {
    let size = input.ordinary::<R>();
    let is_flat = input.one_in(4);
    let corner = |input: &mut Input| {
        let x = size * R::from_f64(2.0 * input.unit::<f64>() - 1.0);
        let y = size * R::from_f64(2.0 * input.unit::<f64>() - 1.0);
        if is_flat { [x, R::TWO * x] } else { [x, y] }
    };
    let all = [(); 5].map(|()| corner(input));
    let corners = &all[..input.below(6)];
    let centre = match input.below(4) {
        0 => [input.number(), input.number()],
        1 => all[input.below(5)],
        _ => {
            let part = R::from_f64(1.0 / corners.len().max(1) as f64);
            let sum = |axis: usize| {
                let sum = corners.iter().fold(R::ZERO, |sum, at| sum + at[axis]);
                sum * part
            };
            [sum(0), sum(1)]
        }
    };
    let limit = input.size::<R>();
    let foot = input.taken(UnknownPressureSet::new(corners, centre, limit))?;
    let at = foot.centre();
    input.holds(
        foot.force_limit() == limit.abs(),
        "the force limit",
        &[limit],
    )?;
    input.holds(
        at.x == centre[0] && at.y == centre[1],
        "the centre of pressure",
        &centre,
    )?;
    let motion = twist::<R>(input);
    let power = foot.support(&motion);
    input.holds(
        power >= R::ZERO || !input.is_mild(),
        "support ≥ 0",
        &[power],
    )?;
    input.finite("support", [power, foot.radius()])?;
    dissipates(input, &foot.wrench(&motion), &motion)?;
    let push = wrench::<R>(input);
    let [least, most] = foot.gauge_bounds(&push);
    let parts = [push.force.x, push.force.y, push.torque];
    if parts.iter().any(|x| x.is_nan()) {
        return input.holds(least.is_nan(), "NaN has no gauge", &[least, most]);
    }
    let is_finite = parts.iter().all(|x| x.is_finite());
    let slack = R::ONE + R::from_f64(1024.0) * R::EPSILON;
    input.holds(
        least <= most * slack || !(is_finite && input.is_mild()),
        "a lower and an upper gauge",
        &[least, most],
    )?;
    // A part of the largest force, or any.
    let force = if input.one_in(2) {
        [(); 2].map(|()| limit * R::from_f64(1.4 * input.unit::<f64>() - 0.7))
    } else {
        [push.force.x, push.force.y]
    };
    let yaw = input.taken(foot.torque_limits(force).ok_or(()))?;
    let ([low, high], [lower, higher]) = (yaw.certain, yaw.possible);
    let unit = limit * (foot.radius() + at.x.abs() + at.y.abs());
    let rounding = R::from_f64(1024.0) * R::EPSILON * unit;
    let is_ordered = lower <= low + rounding && low <= high && high <= higher + rounding;
    input.holds(
        is_ordered || !input.is_mild(),
        "torques in their order",
        &[lower, low, high, higher],
    )
}
